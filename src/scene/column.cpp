// SPDX-License-Identifier: BSD-3-Clause
#include "scene/column.hpp"

#include <fstiff/answer/curves.hpp>
#include <fstiff/answer/derived.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace fstiff::scene {

using detail::Derived;

namespace {

/// The quantity that the library derives from K; none for what a state has itself.
std::optional<Derived> derived_of(CurveQuantity quantity) {
    using enum CurveQuantity;
    switch (quantity) {
        case tangential_stiffness: return Derived::tangential_stiffness;
        case loss_factor: return Derived::loss_factor;
        case reflection: return Derived::reflection;
        case shear_reflection: return Derived::shear_reflection;
        case thermal_conductance: return Derived::thermal_conductance;
        case electrical_conductance: return Derived::electrical_conductance;
        default: return std::nullopt;
    }
}

/// 1/((h + \p gap) \p area), of the conductance \p h of the spots.
Estimate<double> resistance_of(const Estimate<double>& h, double gap, double area) {
    const double resistance = 1 / ((h.value + gap) * area);
    return {resistance, resistance * h.error / (h.value + gap)};
}

/// Value of \p column for the state \p i of \p curve, whose K may be that of an end of its band: \p s.
Estimate<double> estimate_of(const Column& column, const detail::ResolvedJoint& problem, const detail::LawCurve& curve,
                             std::size_t i, const ContactState<double>& s) {
    if (const auto which = derived_of(column.quantity))
        return derived(*which, problem, curve, i, s,
                       column.statistic == Statistic::p05   ? detail::BandEnd::low
                       : column.statistic == Statistic::p95 ? detail::BandEnd::high
                                                            : detail::BandEnd::value);
    const double area = problem.nominal_area.value_or(0);
    using enum CurveQuantity;
    switch (column.quantity) {
        case force: return {s.pressure.value * area, s.pressure.error * area};
        case pressure: return s.pressure;
        case eta: return {s.eta, 0};
        case separation: return s.separation;
        case approach: return {curve.separation_at_seating[i] - s.separation.value, 0};
        case stiffness: return s.stiffness;
        case joint_stiffness: return {s.stiffness.value * area, s.stiffness.error * area};
        case loading_stiffness: return s.loading_stiffness;
        case thermal_resistance: {
            const double gap =
                problem.conduction.gap ? detail::conductance_of_gap(problem.conduction, s.separation.value) : 0;
            return resistance_of(derived(Derived::thermal_conductance, problem, curve, i, s, detail::BandEnd::value),
                                 gap, area);
        }
        case electrical_resistance:
            return resistance_of(derived(Derived::electrical_conductance, problem, curve, i, s, detail::BandEnd::value),
                                 0, area);
        case thermal_conductance_gap: return {detail::conductance_of_gap(problem.conduction, s.separation.value), 0};
        case real_area: return s.real_area_fraction;
        case contacts: return s.contact_density;
        default: return {};
    }
}

bool always(const Scene&) { return true; }
bool never(const Scene&) { return false; }
bool has_waves(const Scene& scene) { return scene.ultrasound.has_value(); }
bool has_shear(const Scene& scene) { return scene.ultrasound && scene.ultrasound->shear; }
bool slides(const Scene& scene) { return scene.friction && scene.friction->amplitude; }
bool is_joint(const Scene& scene) { return scene.is_joint; }
/// Whether a body has \p key of its own, not that of its name.
bool is_given(const Scene& scene, std::string_view key) {
    return std::any_of(scene.inputs.begin(), scene.inputs.end(), [&](const Input& input) {
        return input.given && input.key.starts_with("material.") && input.key.ends_with(key);
    });
}
bool conducts_heat(const Scene& scene) {
    return scene.conduction.thermal && (scene.conduction.gap || is_given(scene, ".thermal_conductivity"));
}
bool conducts_current(const Scene& scene) {
    return scene.conduction.electrical && is_given(scene, ".electrical_conductivity");
}
std::string_view unless(bool there, std::string_view what) { return there ? std::string_view() : what; }
bool resists_heat(const Scene& scene) { return scene.nominal_area && conducts_heat(scene); }
bool resists_current(const Scene& scene) { return scene.nominal_area && conducts_current(scene); }
constexpr std::string_view nominal_area = "contact.nominal_area or contact.washer";
std::string_view lack_of_thermal_resistance(const Scene& scene) {
    return scene.nominal_area ? unless(scene.conduction.thermal.has_value(), "material.upper.thermal_conductivity")
                              : nominal_area;
}
std::string_view lack_of_electrical_resistance(const Scene& scene) {
    return scene.nominal_area
               ? unless(scene.conduction.electrical.has_value(), "material.upper.electrical_conductivity")
               : nominal_area;
}

}  // namespace

std::span<const CurveQuantityRow> curve_quantities() {
    using enum CurveQuantity;
    using enum OfStiffness;
    // clang-format off
    static constexpr std::array<CurveQuantityRow, curve_quantity_count> table{{
        {force, "force", "_N", "N", "F", Quantity::none},
        {pressure, "pressure", "_Pa", "Pa", "p", Quantity::none},
        {eta, "eta", "", "", "eta", Quantity::separation},
        {separation, "separation", "_m", "m", "separation", Quantity::separation, none,
         {2, "separation", always}},
        {approach, "approach", "_m", "m", "approach", Quantity::separation, none,
         {10, "approach", is_joint}},
        {stiffness, "stiffness", "_Pa_per_m", "Pa/m", "K/A0", Quantity::stiffness, rises,
         {1, "stiffness", always}},
        {joint_stiffness, "stiffness", "_N_per_m", "N/m", "K", Quantity::stiffness, rises,
         {9, "joint_stiffness", is_joint, [](const Scene& scene) {
              return unless(scene.nominal_area.has_value(), nominal_area);
          }}},
        {loading_stiffness, "loading_stiffness", "_Pa_per_m", "Pa/m", "-dp/dd", Quantity::loading_stiffness, none,
         {8, "loading_stiffness", never}},
        {tangential_stiffness, "tangential_stiffness", "_Pa_per_m", "Pa/m", "Kt/A0", Quantity::stiffness, rises,
         {5, "tangential_stiffness", [](const Scene& scene) { return has_waves(scene) || scene.friction; }}},
        {loss_factor, "loss_factor", "", "", "loss factor", Quantity::stiffness, rises,
         {13, "loss_factor", slides, [](const Scene& scene) { return unless(slides(scene), "friction.amplitude"); }}},
        {reflection, "reflection", "", "", "|R|", Quantity::stiffness, falls,
         {6, "reflection", has_waves,
          [](const Scene& scene) { return unless(has_waves(scene), "the section ultrasound"); }}},
        {shear_reflection, "shear_reflection", "", "", "shear |R|", Quantity::stiffness, falls,
         {7, "shear_reflection", has_shear, [](const Scene& scene) {
              return unless(has_shear(scene), has_waves(scene) ? "ultrasound.upper.shear_impedance or shear_velocity"
                                                               : "the section ultrasound");
          }}},
        {thermal_conductance, "thermal_conductance", "_W_per_m2K", "W/(m^2 K)", "h", Quantity::stiffness, rises,
         {11, "thermal_conductance", conducts_heat, [](const Scene& scene) {
              return unless(scene.conduction.thermal.has_value(), "material.upper.thermal_conductivity");
          }}},
        {thermal_conductance_gap, "thermal_conductance_gap", "_W_per_m2K", "W/(m^2 K)", "h of the gap",
         Quantity::separation},
        {electrical_conductance, "electrical_conductance", "_S_per_m2", "S/m^2", "electrical h", Quantity::stiffness,
         rises, {12, "electrical_conductance", conducts_current, [](const Scene& scene) {
              return unless(scene.conduction.electrical.has_value(), "material.upper.electrical_conductivity");
          }}},
        {thermal_resistance, "thermal_resistance", "_K_per_W", "K/W", "thermal resistance", Quantity::stiffness, falls,
         {14, "thermal_resistance", resists_heat, lack_of_thermal_resistance}},
        {electrical_resistance, "resistance", "_ohm", "ohm", "resistance", Quantity::stiffness, falls,
         {15, "resistance", resists_current, lack_of_electrical_resistance}},
        {real_area, "real_area_fraction", "", "", "real area", Quantity::real_area_fraction, none,
         {3, "real_area", always}},
        {contacts, "contacts", "_per_m2", "1/m^2", "contacts", Quantity::contact_density, none,
         {4, "contacts", always}},
    }};
    // clang-format on
    return table;
}

bool Scene::needs_stiffness() const {
    return std::any_of(curve_quantities().begin(), curve_quantities().end(), [&](const CurveQuantityRow& row) {
        return row.of_law == Quantity::stiffness && asks(row.quantity);
    });
}

std::vector<const CurveQuantityRow*> chosen_quantities() {
    std::vector<const CurveQuantityRow*> rows;
    for (const CurveQuantityRow& row : curve_quantities())
        if (row.choice.place > 0) rows.push_back(&row);
    std::sort(rows.begin(), rows.end(), [](auto* a, auto* b) { return a->choice.place < b->choice.place; });
    return rows;
}

const std::string& Column::key() const {
    static const auto keys = [] {
        std::vector<std::array<std::string, 4>> rows;  // by quantity and statistic
        for (const CurveQuantityRow& row : curve_quantities()) {
            const std::string name(row.name), suffix(row.suffix);
            rows.push_back({name + suffix, name + "_error" + suffix, name + "_p05" + suffix, name + "_p95" + suffix});
        }
        return rows;
    }();
    return keys[static_cast<std::size_t>(quantity)][static_cast<std::size_t>(statistic)];
}

std::vector<Column> columns_of(const Scene& scene, const detail::LawCurve& curve, bool bands) {
    std::vector<Column> columns;
    const auto add = [&](const CurveQuantityRow& row, Statistic statistic) {
        Column& column = columns.emplace_back(Column{row.quantity, statistic});
        const bool of_band = statistic == Statistic::p05 || statistic == Statistic::p95;
        const bool given = row.of_law == Quantity::none || detail::has(curve.law->quantities, row.of_law);
        if (!given || (of_band && curve.band.empty())) return;
        if (row.quantity == CurveQuantity::approach && curve.separation_at_seating.empty()) return;
        if (row.quantity == CurveQuantity::loss_factor && curve.log_slopes.empty()) return;
        using Band = detail::SampledBand<double>;
        const auto end =
            (statistic == Statistic::p05) != (row.of_stiffness == OfStiffness::falls) ? &Band::low : &Band::high;
        for (std::size_t i = 0; i < curve.states.size(); ++i) {
            ContactState<double> state = curve.states[i];
            if (of_band) state.stiffness = {curve.band[i].*end, 0};
            const Estimate<double> estimate = estimate_of(column, scene, curve, i, state);
            const bool lost = row.quantity == CurveQuantity::loading_stiffness && estimate.value == 0;
            column.values.push_back(lost                            ? std::numeric_limits<double>::quiet_NaN()
                                    : statistic == Statistic::error ? estimate.error
                                                                    : estimate.value);
        }
        if (std::all_of(column.values.begin(), column.values.end(), [](double value) { return std::isnan(value); }))
            column.values.clear();  // plastic boundary elements know unloading alone
    };
    for (const CurveQuantityRow& row : curve_quantities()) {
        if (!scene.asks(row.quantity)) continue;
        const bool follows = row.of_stiffness != OfStiffness::none;
        add(row, Statistic::value);
        if (follows) add(row, Statistic::error);
        if (follows && bands)
            for (const Statistic end : {Statistic::p05, Statistic::p95}) add(row, end);
    }
    return columns;
}

}  // namespace fstiff::scene
