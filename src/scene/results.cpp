// SPDX-License-Identifier: BSD-3-Clause
#include "scene/results.hpp"

#include "document/file.hpp"
#include "document/shown_unit.hpp"
#include "scene/answer.hpp"
#include "scene/bands.hpp"
#include "scene/each_contact.hpp"
#include "scene/explanation.hpp"
#include "scene/warnings.hpp"

#include <fstiff/asperity/mindlin.hpp>
#include <fstiff/contact/rough_contact.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string_view>
#include <utility>

namespace fstiff::scene {
namespace {

/// Quantities that \p scene requests of \p law, and \p more, as far as the law gives them.
Quantity wanted(const Scene& scene, const Law& law, Quantity more = Quantity::none) {
    Quantity set = Quantity::pressure | Quantity::separation | more;
    if (scene.needs_stiffness() || scene.best) set = set | Quantity::stiffness;
    if (scene.real_area || scene.conduction.thermal_film > 0 || scene.conduction.electrical_film > 0)
        set = set | Quantity::real_area_fraction;
    if (scene.contacts || scene.best) set = set | Quantity::contact_density | Quantity::real_area_fraction;
    if (scene.loading_stiffness || scene.best) set = set | Quantity::loading_stiffness;
    return static_cast<Quantity>(static_cast<unsigned>(set) & static_cast<unsigned>(law.quantities));
}

/// The greatest pressure [Pa] below \p pressure at which \p contact has a state, to 1e-6; 0 where it has none.
double reach_of(const AnyContact& contact, double pressure) {
    const auto has_state = [&](double p) {
        return contact.at_pressures(std::span(&p, 1), Quantity::stiffness).front().ok();
    };
    double low = pressure, high = pressure;
    for (double step = 2; !has_state(low); step *= step)
        if (high = low, low /= step; !(low > 0)) return 0;
    while (high > (1 + 1e-6) * low)
        if (const double middle = std::sqrt(low) * std::sqrt(high); has_state(middle))
            low = middle;
        else
            high = middle;
    return low;
}

/// Replaces the reason of a law that has no state at a pressure above its states by the limit, where this is known.
void name_limit(const Scene& scene, const AnyContact& contact, Curve& curve) {
    double greatest = 0;
    for (const auto& state : curve.states) greatest = std::max(greatest, state.pressure.value);
    for (MissedPoint& missed : curve.missed) {
        const double pressure = scene.points[missed.place];
        const bool above = !missed.unrepresentable && pressure > greatest;
        if (!above || scene.at_separations || !curve.law->varies || !curve.law->holds_when_crowded) continue;
        const double reach = reach_of(contact, pressure), hardness = hardness_of(scene);
        if (!(reach > 0)) return;
        missed.reason =
            curve.law->needs_hardness && reach > 0.999 * hardness
                ? "at the hardness, " + with_unit(hardness, "Pa", 3) + ", and above it everything has flowed"
                : "above " + with_unit(reach, "Pa", 3) + " the contact is closed and the bulk carries the load";
    }
}

/// Puts \p points of \p contact into \p curve, as states or as what the law does not reach. A gradient so small that p*
/// is beyond the range of double precision is as good as unknown.
void take_points(const Scene& scene, double modulus, Curve& curve, const AnyContact& contact,
                 const std::vector<ContactPoint<double>>& points) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (points[i].ok()) {
            ContactState<double> state = points[i].state;
            if (flows(scene, *curve.law) && state.stiffness.value > 0)  // which no loading stiffness exceeds
                state.loading_stiffness.value = std::min(state.loading_stiffness.value, state.stiffness.value);
            curve.states.push_back(state);
            curve.places.push_back(i);
        } else if (points[i].status == PointStatus::out_of_reach) {
            curve.missed.push_back({i, points[i].reason});
        } else {
            curve.missed.push_back({i,
                                    "a result for " + shortest(scene.points[i]) +
                                        " is beyond the range of double precision; the values of the scene must be "
                                        "less extreme",
                                    true});
        }
    }
    name_limit(scene, contact, curve);
    const auto has_p_star = [&](const ContactState<double>& state) {
        return std::isfinite(parts::dimensionless_pressure(state.pressure.value, modulus, *curve.rms_gradient));
    };
    if (curve.rms_gradient && !std::all_of(curve.states.begin(), curve.states.end(), has_p_star))
        curve.rms_gradient.reset();
}

/// \throws domain_error where no curve has a state, with the reason of the first law at its first point.
void require_states(const Scene& scene, const std::vector<Curve>& curves) {
    if (std::any_of(curves.begin(), curves.end(), [](const Curve& curve) { return !curve.states.empty(); })) return;
    for (const Curve& curve : curves)
        if (!curve.missed.empty())
            throw domain_error(scene.points_where + "law " + std::string(curve.law->name) + ": " +
                               curve.missed.front().reason);
}

/// Bands, where the surface has errors, and the columns of every curve, which has its states.
void finish(const Scene& scene, Results& results, const ProgressHook& progress) {
    if ((scene.needs_stiffness() || scene.best) && scene.samples > 0 && scene.face.has_errors())
        add_bands(scene, results, progress);
    const bool bands = has_band(results);
    for (Curve& curve : results.curves) curve.columns = columns_of(scene, curve, results.tangential_ratio, bands);
}

/// Finds the answer: of a scene that names no law its curve takes the place of that law's.
void take_answer(const Scene& scene, Results& results, const ProgressHook& progress) {
    if (scene.best) {
        results.answer = answer_of(scene, results, std::move(results.curves.front()), progress);
        results.curves = {results.answer->curve};
        return;
    }
    Scene of = scene;
    of.stiffness = of.real_area = of.contacts = of.loading_stiffness = true;
    constexpr std::size_t many = 100;  // a band costs more than a curve
    std::vector<std::size_t> places;
    if (scene.points.size() > many) {
        places = points_of_answer(scene);
        const auto take = [&](std::vector<double>& from) {
            std::vector<double> chosen;
            for (const std::size_t place : places) chosen.push_back(from[place]);
            from = std::move(chosen);
        };
        take(of.points);
        if (!of.forces.empty()) take(of.forces);
    }
    try {
        set_law_of_answer(of);
        results.answer = answer_of(of, results, curves_of(of, contacts_of(of)).front(), progress);
        Curve& curve = results.answer->curve;
        if (!places.empty()) {
            for (std::size_t& place : curve.places) place = places[place];
            for (MissedPoint& missed : curve.missed) missed.place = places[missed.place];
        }
        curve.columns = columns_of(scene, curve, results.tangential_ratio, true);
    } catch (const domain_error& error) {
        results.warnings.push_back("the answer has no K: " + std::string(error.what()));
        results.doubtful = true;
    }
}

}  // namespace

std::string laws_of(const Curve& curve) {
    std::vector<const Law*> laws;
    for (const Law* law : curve.by)
        if (std::find(laws.begin(), laws.end(), law) == laws.end()) laws.push_back(law);
    if (laws.empty()) laws.push_back(curve.law);
    std::string text;
    for (const Law* law : laws) text += (text.empty() ? "" : " and ") + std::string(law->name);
    return text;
}

std::string title(const Curve& curve) {
    std::string text = laws_of(curve);
    if (curve.theta) text += ", theta = " + rounded(*curve.theta) + ", r = " + rounded(*curve.r);
    return text;
}

std::optional<std::size_t> Curve::state_at(std::size_t place) const {
    const auto found = std::lower_bound(places.begin(), places.end(), place);
    if (found == places.end() || *found != place) return std::nullopt;
    return static_cast<std::size_t>(found - places.begin());
}

std::optional<double> Curve::value_at(std::size_t place, CurveQuantity quantity, Statistic statistic) const {
    const auto at = state_at(place);
    for (const Column& column : columns)
        if (at && column.quantity == quantity && column.statistic == statistic && !column.values.empty() &&
            !std::isnan(column.values[*at]))
            return column.values[*at];
    return std::nullopt;
}

std::vector<Parameter> unknown_parameters(const Scene& scene) {
    std::vector<Parameter> all;
    if (scene.face.measured)
        all = unknown_parameters(*scene.face.measured, scene.face.parameters);
    else if (!measured_faces(scene).empty())  // of a sum: what is unknown of one face may not matter next to the other
        all = parts::unknown_parameters(scene.face.parameters);
    if (all.empty() && scene.faces.size() == 2)
        for (const auto& [name, face] : measured_faces(scene)) {
            const double share = face->parameters.rms_height.value / scene.face.parameters.rms_height.value;
            const auto own = unknown_parameters(*face->measured, face->parameters);
            if (2 * share * share > 1 && std::count(own.begin(), own.end(), Parameter::rms_height) > 0)
                all = {Parameter::rms_height};
        }
    if (scene.best) std::erase_if(all, [](Parameter one) { return one != Parameter::rms_height; });
    return all;
}

std::vector<const Curve*> shown_curves(const Results& results) {
    std::vector<const Curve*> shown;
    const bool named = results.curves.front().by.empty();  // else it is the answer's
    if (results.answer && named) shown.push_back(&results.answer->curve);
    for (const Curve& curve : results.curves) shown.push_back(&curve);
    return shown;
}

bool has_band(const Results& results) {
    return std::any_of(results.curves.begin(), results.curves.end(),
                       [](const Curve& curve) { return !curve.band.empty(); });
}

Interaction<double> interaction(const Scene& scene) {
    Interaction<double> result;
    result.reading = scene.reading;
    if (result.reading != InteractionReading::none)
        result.length = scene.length == InteractionLength::nominal
                            ? parts::interaction_length_of_area(*scene.nominal_area)
                        : scene.length == InteractionLength::peak_spacing
                            ? parts::interaction_length_of_peaks(scene.face.parameters.peak_density.value)
                            : scene.given_length;
    return result;
}

std::vector<MadeContact> contacts_of(const Scene& scene) {
    std::vector<MadeContact> contacts;
    for_each_contact(scene, effective_modulus(scene.upper, scene.lower), {}, [&](Curve curve, const auto& contact) {
        contacts.push_back({std::move(curve), contact()});
    });
    return contacts;
}

std::vector<Curve> curves_of(const Scene& scene, const std::vector<MadeContact>& contacts) {
    Results results;
    results.modulus = effective_modulus(scene.upper, scene.lower);
    results.tangential_ratio = tangential_ratio(scene.upper, scene.lower);
    for (const MadeContact& made : contacts) {
        Curve& curve = results.curves.emplace_back(made.curve);
        take_points(scene, results.modulus, curve, *made.contact,
                    points_of(scene, *curve.law, *made.contact, wanted(scene, *curve.law)));
        static_cast<void>(seat(scene, *made.contact, curve));
        grow(scene, *made.contact, curve);
    }
    require_states(scene, results.curves);
    finish(scene, results, {});
    if (scene.best) take_answer(scene, results, {});
    return std::move(results.curves);
}

Results compute(const Scene& scene, const ProgressHook& progress) {
    Results results;
    results.modulus = effective_modulus(scene.upper, scene.lower);
    results.warnings = scene.warnings;
    const bool has_peaks = scene.face.has_radius_and_density();
    if (scene.yield_strength && has_peaks)
        results.plasticity_index =
            parts::plasticity_index(scene.face.roughness(), results.modulus, *scene.yield_strength);
    results.tangential_ratio = tangential_ratio(scene.upper, scene.lower);
    if (has_peaks)
        results.surface_checks = parts::check_surface(scene.face.roughness(), results.modulus, scene.yield_strength);
    std::size_t curves = 0;
    for (const Law* law : scene.laws) curves += law->has_peaks ? peaks_of(*law, scene).size() : 1;
    ProgressHook of_all;  // one bar for the points of all curves
    if (progress)
        of_all = [&](std::string_view what, std::size_t done, std::size_t all) {
            progress(what, results.curves.size() * all + done, curves * all);
        };
    for_each_contact(scene, results.modulus, {}, [&](Curve curve, const auto& contact) {
        // warnings and the explanation need the contacts and the area, whichever columns are shown
        const Quantity quantities = wanted(scene, *curve.law, Quantity::contact_density | Quantity::real_area_fraction);
        const auto made = contact();
        take_points(scene, results.modulus, curve, *made, points_of(scene, *curve.law, *made, quantities, of_all));
        if (const std::string why = seat(scene, *made, curve); !why.empty())
            results.warnings.push_back("law " + std::string(curve.law->name) + " has no approach: " + why);
        grow(scene, *made, curve);
        curve.checks = parts::check_curve<double>(curve.states,
                                                  {.effective_modulus = results.modulus,
                                                   .rms_gradient = curve.rms_gradient,
                                                   .max_peak_height = scene.face.parameters.max_peak_height.value,
                                                   .nominal_area = scene.nominal_area,
                                                   .yield_strength = scene.yield_strength},
                                                  quantities);
        std::erase_if(curve.checks, [&](const parts::Check<double>& check) {
            return (check.concern == parts::Concern::interacting_asperities && curve.law->holds_when_crowded) ||
                   (check.concern ==
                        parts::Concern::not_converged &&  // the error is that of the grid, or of the shifts or files
                    (!curve.law->varies || (scene.face.map && scene.face.map->maps.size() > 1)));
        });
        std::vector<double> etas;
        for (const auto& state : curve.states) etas.push_back(state.eta);
        curve.means = made->means_at(etas);
        results.curves.push_back(std::move(curve));
    });
    require_states(scene, results.curves);
    finish(scene, results, progress);
    take_answer(scene, results, progress);
    add_warnings(scene, results);
    Explanation found = explanation(scene, results);
    results.explanation = std::move(found.sentences);
    results.short_explanation = std::move(found.shorter);
    return results;
}

}  // namespace fstiff::scene
