// SPDX-License-Identifier: BSD-3-Clause
#include "scene/answer.hpp"

#include <fstiff/double/surfaces.hpp>
#include "document/file.hpp"
#include "scene/each_contact.hpp"

#include <fstiff/asperity/plastic_laws.hpp>
#include <fstiff/measured/widened_band.hpp>

#include <algorithm>
#include <cmath>

namespace fstiff::scene {
namespace {

/// Whether \p law can be computed of \p scene.
bool has(const Scene& scene, LawName law) { return refusal_of(find_law(law), scene).empty(); }

bool is_map(const Face& face) { return face.map && face.spectrum_of_map; }

/// Whether the share \p area can carry \p pressure at \p hardness (0: elastic): of few points the solver may find too
/// few.
bool is_carried(double pressure, double area, double hardness) {
    return area * hardness * (1 + 1e-6) >= pressure || hardness == 0;
}

parts::KnownAs known_as(const Scene& scene) {
    if (is_map(scene.face)) return parts::KnownAs::map;
    if (!measured_faces(scene).empty()) return parts::KnownAs::trace;
    constexpr double spread_of_height = 4;  // of a gradient by the height alone, 95 % over 5 %; all else gives less
    for (const Prior& prior : scene.face.priors)
        if (prior.which == parts::Unknown::gradient && prior.high > spread_of_height * prior.low)
            return parts::KnownAs::height;
    return parts::KnownAs::numbers;
}

/// The side [m] of what was measured: of a profile its length, of a map the root of its area; 0 for numbers.
double measured_side(const Scene& scene) {
    double least = 0;
    for (const auto& [name, face] : measured_faces(scene)) {
        const double size = face->measured->found.size;
        const double side = face->measured->is_profile() ? size : std::sqrt(size);
        if (side > 0) least = least > 0 ? std::min(least, side) : side;
    }
    return least;
}

bool is_map_itself(const Scene& scene) {
    return is_map(scene.face) &&
           (!scene.nominal_area || *scene.nominal_area <= (1 + 1e-6) * scene.face.map->maps.front()->area());
}

/// The area [m^2] on which contacts are counted: the nominal one, else a square as long as what was measured; 0: not
/// known.
double counted_area(const Scene& scene) {
    return scene.nominal_area ? *scene.nominal_area : std::pow(measured_side(scene), 2);
}

/// Uncertainty of \p value by \p band, with its \p parts where they are known.
void take_band(parts::Causes<double>& causes, double value, const parts::SampledBand<double>& band,
               const parts::BandParts<double>* parts, bool sampled) {
    const auto put = [&](parts::Cause cause, double low, double high) {
        causes[static_cast<std::size_t>(cause)] = {low, high};
    };
    if (parts) {
        if (sampled)
            put(parts::Cause::measurement, -std::hypot(parts->errors_low, parts->window_low),
                std::hypot(parts->errors_high, parts->window_high));
        put(parts::Cause::cut_offs, parts->scale_low, parts->scale_high);
        put(parts::Cause::shape, parts->shape_low, parts->shape_high);
        put(parts::Cause::prior, parts->prior_low, parts->prior_high);
    } else if (sampled && band.low > 0) {
        put(parts::Cause::measurement, std::min(0.0, std::log(band.low / value)),
            std::max(0.0, std::log(band.high / value)));
    }
}

/// K of boundary elements, on 256 points a side, which take seconds, unless the scene gives another number, at the
/// points of the answer where they resolve more than a pixel.
Curve solved(const Scene& scene, const Results& results, const Curve& base, const StiffnessAnswer& answer,
             const ProgressHook& progress) {
    Curve none;
    if (!scene.solves_map) return none;
    if (!is_map(scene.face) || scene.face.map->maps.size() > 1 || !has(scene, LawName::boundary_elements)) return none;
    const HeightMap<double>& map = *scene.face.map->maps.front();
    const double coarser =
        std::min(1.0, scene.law_options.points / static_cast<double>(std::max(map.rows(), map.columns())));
    const double size = coarser * coarser * static_cast<double>(map.size());
    Scene of = scene;
    of.laws = {&find_law(LawName::boundary_elements)};
    of.points.clear();
    of.stiffness = of.real_area = true;
    std::vector<std::size_t> places;
    for (const std::size_t place : points_of_answer(scene)) {
        const auto state = base.state_at(place);
        if (!state || answer.reasons[*state].p_star.value_or(0) > parts::max_compared_pressure) continue;
        const double touching = base.states[*state].real_area_fraction.value * size;
        if (touching > 0 && touching < parts::min_points_in_contact / 4) continue;
        of.points.push_back(scene.points[place]);
        places.push_back(place);
    }
    if (places.empty()) return none;
    const double hardness = of.law_options.hardness = answer.flows ? hardness_of(scene) : 0;
    for_each_contact(of, results.modulus, {}, [&](Curve curve, const auto& contact) {
        const auto made = contact();
        const auto points = points_of(of, *curve.law, *made, Quantity::all, progress);
        for (std::size_t i = 0; i < points.size(); ++i)
            if (const double area = points[i].state.real_area_fraction.value;
                points[i].ok() && area * size >= parts::min_points_in_contact &&
                is_carried(points[i].state.pressure.value, area, hardness))
                curve.states.push_back(points[i].state), curve.places.push_back(places[i]);
        static_cast<void>(seat(of, *made, curve));
        none = std::move(curve);
    });
    return none;
}

/// ln K of boundary elements of \p map over K of \p solved at each of its states: solved at a few of them, the others
/// lie on lines over ln p.
std::vector<double> changes(const Scene& scene, const HeightMap<double>& map, const Curve& solved, double modulus,
                            double hardness, const ProgressHook& progress) {
    const std::size_t count = solved.states.size(),
                      most = hardness > 0 ? 2 : 6;  // with a hardness one takes as long as four
    std::vector<double> pressures;
    std::vector<std::size_t> places;
    for (std::size_t k = 0; k < std::min(most, count); ++k) {
        places.push_back(count <= most ? k : k * (count - 1) / (most - 1));
        pressures.push_back(solved.states[places.back()].pressure.value);
    }
    const LawOptions& of = scene.law_options;
    const auto found = truth(map, modulus, pressures, {of.points, of.edges, hardness, false, progress});
    std::vector<double> all(count);
    for (std::size_t k = 0; k < places.size(); ++k) {
        const double change = std::log(found[k].state.stiffness / solved.states[places[k]].stiffness.value);
        const bool carried = is_carried(pressures[k], found[k].state.contact_fraction, hardness);
        all[places[k]] = carried && std::isfinite(change) ? change : 0;
        for (std::size_t i = k > 0 ? places[k - 1] + 1 : places[k]; i < places[k]; ++i) {
            const double p = solved.states[i].pressure.value, from = pressures[k - 1];
            all[i] = std::lerp(all[places[k - 1]], all[places[k]], std::log(p / from) / std::log(pressures[k] / from));
        }
    }
    return all;
}

/// Changes of K of \p solved that the filter of lambda_s and the removed plane may have caused: the filter by the
/// neighbour with the next shorter lambda_s, as its change goes as lambda_s^2; the plane where it may be the surface's
/// own.
std::vector<parts::CauseSpread<double>> of_cut_offs(const Scene& scene, const Curve& solved, double modulus,
                                                    double hardness, const ProgressHook& progress) {
    std::vector<parts::CauseSpread<double>> all(solved.states.size());
    const auto widen = [&](const HeightMap<double>& map, double factor, bool both_ways) {
        const std::vector<double> of_map = changes(scene, map, solved, modulus, hardness, progress);
        for (std::size_t i = 0; i < all.size(); ++i) {
            const double change = factor * of_map[i];
            all[i].low = -std::hypot(all[i].low, both_ways ? change : std::min(0.0, change));
            all[i].high = std::hypot(all[i].high, both_ways ? change : std::max(0.0, change));
        }
    };
    if (all.empty() || !scene.face.measured || !scene.face.measured->found.map) return all;
    for (const Face& other : scene.face.neighbours)
        if (const double ratio = other.lambda_s.value_or(0) / scene.face.lambda_s.value_or(0); ratio < 1 && other.map)
            widen(*other.map->maps.front(), 1 / (1 - ratio * ratio), false);
    const parts::PreparedMap<double>& flat = *scene.face.measured->found.map;
    const auto [x, y] = flat.tilt;
    const double tilted = std::hypot(x, y) / std::sqrt(12.0) / scene.face.parameters.rms_height.value;
    if (flat.removed != MapForm::plane || !(tilted > 0)) return all;
    const double share = std::min(1.0, scene.face.parameters.long_end.form_share / tilted);
    HeightMap<double> map = flat.map;
    map.heights.rowwise() += share * Eigen::ArrayXd::LinSpaced(map.columns(), -x / 2, x / 2).transpose();
    map.heights.colwise() += share * Eigen::ArrayXd::LinSpaced(map.rows(), -y / 2, y / 2);
    widen(map, 1, share < 0.99);
    return all;
}

/// Uncertainty of a profile of a face with a lay: the length of the ridges if it is across the lay, else the profile
/// across.
parts::CauseSpread<double> of_lay(const Scene& scene) {
    constexpr double softer = 4, stiffer = 2, heavy = 1.5;  // along and across turned, milled, planed and ground maps
    if (scene.has_lay) return {-std::log(heavy), std::log(parts::lay_factor)};
    for (const auto& [name, face] : measured_faces(scene))
        if (face->measured->is_profile() && parts::prior_of(face->process).has_lay)
            return {-std::log(softer), std::log(stiffer)};
    return {};
}

/// The law's own error, with that of the grid \p relative to K.
parts::CauseSpread<double> law_error(const Scene& scene, LawName law, const AnswerReason& reason, double grid) {
    parts::LawErrorQuestion<double> question{.law = law, .known = known_as(scene)};
    if (reason.p_star) question.p_star = *reason.p_star, question.hardness = relative_hardness(scene).value_or(0);
    if (const auto& heights = scene.face.heights; heights && heights->kurtosis.value != 0)
        question.skewness = heights->skewness, question.kurtosis = heights->kurtosis;
    else if (question.known == parts::KnownAs::numbers || question.known == parts::KnownAs::height)
        question.skewness = {scene.face.shape.skewness, 0}, question.kurtosis = {scene.face.shape.kurtosis, 0};
    if (const Measurement<double>& height = scene.face.parameters.rms_height; height.value > 0)
        question.long_waves = height.error / height.value;
    const parts::LawError<double> error = parts::law_error(question);
    return {-std::hypot(error.low, grid), std::hypot(error.high, grid)};
}

}  // namespace

double hardness_of(const Scene& scene) {
    return scene.hardness.value_or(parts::hardness_over_yield_strength<double> * scene.yield_strength.value_or(0));
}

std::optional<double> relative_hardness(const Scene& scene) {
    const std::optional<double> g = gradient(scene);
    if (!g || (!scene.hardness && !scene.yield_strength)) return std::nullopt;
    const double relative = hardness_of(scene) / (effective_modulus(scene.upper, scene.lower) * *g);
    const bool known = scene.open_body.empty() || relative < parts::flowing_hardness;  // the other one may be softer
    return known && std::isfinite(relative) ? std::optional(relative) : std::nullopt;
}

void set_law_of_answer(Scene& scene) {
    if (scene.face.map && !missing_points(*scene.face.map).empty())
        scene.face.write([](Face& face) { face.spectrum_of_map = false; });
    parts::AnswerQuestion<double> question{.known = known_as(scene)};
    for (const Law& law : laws())
        if (!law.needs_whole_map && has(scene, law.which)) question.available.push_back(law.which);
    question.hardness = relative_hardness(scene).value_or(std::numeric_limits<double>::quiet_NaN());
    scene.laws = {&find_law(parts::answering_law(question))};
}

std::vector<std::size_t> points_of_answer(const Scene& scene) {
    constexpr std::size_t most = 12;
    const std::vector<double>& points = scene.points;
    const bool listed = std::none_of(scene.inputs.begin(), scene.inputs.end(), [](const Input& input) {
        return input.key.starts_with("contact.") && input.key.ends_with(".count");
    });
    const auto [least, greatest] = std::minmax_element(points.begin(), points.end());
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double decade = points[i] > 0 ? std::log10(points[i]) : 0.5;
        const bool is_decade = !scene.at_separations && std::abs(decade - std::round(decade)) < 1e-6;
        if (listed || points.size() <= most || is_decade || points[i] == *least || points[i] == *greatest)
            chosen.push_back(i);
    }
    if (chosen.size() > 2 || points.size() <= most) return chosen;
    constexpr std::size_t few = 4;  // of separations, or of a range without a decade
    chosen.clear();
    for (std::size_t k = 0; k < few; ++k) chosen.push_back((k * (points.size() - 1) + 1) / (few - 1));
    return chosen;
}

StiffnessAnswer answer_of(const Scene& scene, const Results& results, Curve base, const ProgressHook& progress) {
    StiffnessAnswer answer;
    answer.relative_hardness = relative_hardness(scene);
    answer.flows = flows(scene, *base.law);
    answer.of_map_itself = is_map_itself(scene);
    const double area = counted_area(scene);
    parts::UnmeasuredWaves<double> longer;
    if (scene.nominal_area) longer = scene.face.unmeasured(std::sqrt(*scene.nominal_area));
    answer.waves_at_least = longer.at_least;
    for (const auto& state : base.states) {
        AnswerReason& reason = answer.reasons.emplace_back();
        if (base.rms_gradient)
            reason.p_star = parts::dimensionless_pressure(state.pressure.value, results.modulus, *base.rms_gradient);
        if (const double contacts = area * state.contact_density.value; contacts > 0) reason.contacts = contacts;
        if (answer.flows && state.loading_stiffness.value > 0) reason.loading_stiffness = state.loading_stiffness.value;
    }
    const Curve elements = solved(scene, results, base, answer, progress);
    const auto cut_offs =
        of_cut_offs(scene, elements, results.modulus, answer.flows ? hardness_of(scene) : 0, progress);
    std::vector<parts::SampledBand<double>> bands;
    for (std::size_t i = 0; i < base.states.size(); ++i) {
        AnswerReason& reason = answer.reasons[i];
        if (i < base.band.size())
            take_band(reason.causes, base.states[i].stiffness.value, base.band[i],
                      i < base.band_parts.size() ? &base.band_parts[i] : nullptr, !answer.of_map_itself);
        const auto put = [&](parts::Cause cause, const parts::CauseSpread<double>& spread) {
            reason.causes[static_cast<std::size_t>(cause)] = spread;
        };
        put(parts::Cause::lay, of_lay(scene));
        if (reason.contacts && !answer.of_map_itself)
            put(parts::Cause::contacts, parts::scatter_of_contacts(*reason.contacts));
        put(parts::Cause::long_waves, {-longer.growth, 0});
        const Law* law = base.law;
        double grid = 0;
        if (const auto at = elements.state_at(base.places[i])) {
            law = elements.law;
            put(parts::Cause::cut_offs, {cut_offs[*at].low, std::hypot(reason.causes[1].high, cut_offs[*at].high)});
            base.states[i].stiffness = elements.states[*at].stiffness;
            base.states[i].real_area_fraction = elements.states[*at].real_area_fraction;
            base.states[i].separation = elements.states[*at].separation;
            if (!base.seated.empty() && !elements.seated.empty()) base.seated[i] = elements.seated[*at];
            grid = base.states[i].stiffness.error / base.states[i].stiffness.value;
        }
        put(parts::Cause::law, law_error(scene, law->which, reason, std::isfinite(grid) ? grid : 0));
        const double K = base.states[i].stiffness.value;
        if (reason.loading_stiffness) {  // that of the law, next to K of boundary elements
            *reason.loading_stiffness = std::min(*reason.loading_stiffness, K);
            base.states[i].loading_stiffness.value = *reason.loading_stiffness;
        }
        const auto whole = parts::band_of(reason.causes);
        constexpr double most = std::numeric_limits<double>::max() / 2;  // as in_range() of a state
        bands.push_back({K * std::exp(whole.low), K, std::min(most, K * std::exp(whole.high))});
        base.by.push_back(law);
    }
    base.band = std::move(bands);
    base.columns = columns_of(scene, base, results.tangential_ratio, !base.band.empty());
    answer.curve = std::move(base);
    return answer;
}

}  // namespace fstiff::scene
