// SPDX-License-Identifier: BSD-3-Clause
#include "scene/column.hpp"

#include "scene/results.hpp"

#include <fstiff/ultrasound/propagation.hpp>

#include <algorithm>
#include <array>

namespace fstiff::scene {
namespace {

Estimate<double> estimate_of(CurveQuantity quantity, const Scene& scene, double tangential_ratio,
                          const ContactState<double>& s) {
    const auto reflected = [&](const Impedances<double>& media, double factor) {
        return fstiff::reflection(s.stiffness * factor, media, scene.ultrasound->angular());
    };
    using enum CurveQuantity;
    switch (quantity) {
        case pressure: return s.pressure;
        case eta: return {s.eta, 0};
        case separation: return s.separation;
        case stiffness: return s.stiffness;
        case loading_stiffness: return s.loading_stiffness;
        case tangential_stiffness:
            return {tangential_ratio * s.stiffness.value, tangential_ratio * s.stiffness.error};
        case reflection: return reflected(scene.ultrasound->longitudinal, 1);
        case shear_reflection: return reflected(*scene.ultrasound->shear, tangential_ratio);
        case real_area: return s.real_area_fraction;
        case contacts: return s.contact_density;
    }
    return {};
}

}  // namespace

std::span<const CurveQuantityRow> curve_quantities() {
    using enum CurveQuantity;
    static constexpr std::array<CurveQuantityRow, 10> table{
        {{pressure, "pressure", "_Pa", "Pa", "p", Quantity::none, nullptr},
         {eta, "eta", "", "", "eta", Quantity::none, nullptr},
         {separation, "separation", "_m", "m", "separation", Quantity::none, &Scene::separation},
         {stiffness, "stiffness", "_Pa_per_m", "Pa/m", "K/A0", Quantity::stiffness, &Scene::stiffness, true},
         {loading_stiffness, "loading_stiffness", "_Pa_per_m", "Pa/m", "-dp/dd", Quantity::loading_stiffness,
          &Scene::loading_stiffness},
         {tangential_stiffness, "tangential_stiffness", "_Pa_per_m", "Pa/m", "Kt/A0", Quantity::stiffness,
          &Scene::tangential_stiffness, true},
         {reflection, "reflection", "", "", "|R|", Quantity::stiffness, &Scene::reflection, true},
         {shear_reflection, "shear_reflection", "", "", "shear |R|", Quantity::stiffness, &Scene::shear_reflection,
          true},
         {real_area, "real_area_fraction", "", "", "real area", Quantity::real_area_fraction, &Scene::real_area},
         {contacts, "contacts", "_per_m2", "1/m^2", "contacts", Quantity::contact_density, &Scene::contacts}}};
    return table;
}

const std::string& Column::key() const {
    static const auto keys = [] {
        std::vector<std::array<std::string, 4>> all;  // by quantity and statistic
        for (const CurveQuantityRow& row : curve_quantities()) {
            const std::string name(row.name), suffix(row.suffix);
            all.push_back({name + suffix, name + "_error" + suffix, name + "_p05" + suffix, name + "_p95" + suffix});
        }
        return all;
    }();
    return keys[static_cast<std::size_t>(quantity)][static_cast<std::size_t>(statistic)];
}

std::vector<Column> columns_of(const Scene& scene, const Curve& curve, double tangential_ratio, bool bands) {
    std::vector<Column> columns;
    const auto add = [&](const CurveQuantityRow& row, Statistic statistic) {
        Column& column = columns.emplace_back(Column{row.quantity, statistic});
        const bool of_band = statistic == Statistic::p05 || statistic == Statistic::p95;
        const bool given = row.of_law == Quantity::none || parts::has(curve.law->quantities, row.of_law);
        if (!given || (of_band && curve.band.empty())) return;
        const bool falls = row.unit.empty();  // a reflection, while K rises
        using Band = parts::SampledBand<double>;
        const auto end = (statistic == Statistic::p05) != falls ? &Band::low : &Band::high;
        for (std::size_t i = 0; i < curve.states.size(); ++i) {
            ContactState<double> state = curve.states[i];
            if (of_band) state.stiffness = {curve.band[i].*end, 0};
            const Estimate<double> found = estimate_of(row.quantity, scene, tangential_ratio, state);
            column.values.push_back(statistic == Statistic::error ? found.error : found.value);
        }
        if (row.quantity == CurveQuantity::loading_stiffness &&  // plastic boundary elements know unloading alone
            std::all_of(column.values.begin(), column.values.end(), [](double value) { return value == 0; }))
            column.values.clear();
    };
    for (const CurveQuantityRow& row : curve_quantities()) {
        if (row.asked && !(scene.*row.asked)) continue;
        add(row, Statistic::value);
        if (row.has_band) add(row, Statistic::error);
        if (row.has_band && bands)
            for (const Statistic end : {Statistic::p05, Statistic::p95}) add(row, end);
    }
    return columns;
}

}  // namespace fstiff::scene
