// SPDX-License-Identifier: BSD-3-Clause
#include "actions/law_of_answer.hpp"

#include "actions/compute.hpp"

#include <fstiff/answer/answer.hpp>
#include <fstiff/answer/rising_curve.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace fstiff::actions {

using scene::Scene;

namespace {

/// The points of the answer of \p scene between two pressures [Pa], and more between them: ten a decade, of a map four,
/// since boundary elements take seconds for each.
std::vector<double> nodes_between(const Scene& scene, double from, double to) {
    constexpr double close = 1e-6;  // of ln p: the chord between two such nodes would be rounding alone
    std::vector<double> logs{std::log(from), std::log(to)};
    if (!scene.at_separations)
        for (const std::size_t place : points_of_answer(scene)) logs.push_back(std::log(scene.points[place]));
    std::erase_if(logs, [&](double x) { return x < std::log(from) || x > std::log(to); });
    std::sort(logs.begin(), logs.end());
    logs.erase(std::unique(logs.begin(), logs.end(), [](double a, double b) { return b - a < close; }), logs.end());
    const double step = std::log(10.0) / (scene.face.map ? 4 : 10);
    std::vector<double> nodes{from};
    for (std::size_t i = 1; i < logs.size(); ++i) {
        const int parts = std::max(1, static_cast<int>(std::ceil((logs[i] - logs[i - 1]) / step - close)));
        for (int k = 1; k <= parts; ++k) nodes.push_back(std::exp(std::lerp(logs[i - 1], logs[i], double(k) / parts)));
    }
    nodes.back() = to;
    return nodes;
}

/// The answer of \p curve, as far as its law needs it.
Answer answer_of(const Curve& curve, double rms_height) {
    Answer answer;
    answer.rms_height = rms_height;
    for (std::size_t i = 0; i < curve.states.size(); ++i)
        answer.points.push_back(
            {.pressure = curve.states[i].pressure.value,
             .stiffness = {curve.band[i].low, curve.states[i].stiffness.value, curve.band[i].high}});
    return answer;
}

}  // namespace

LawOfAnswer law_of_answer(const Scene& scene, double quantile, double from, double to, const ProgressHook& progress) {
    Scene answered = scene;
    answered.best = true, answered.at_separations = false, answered.listed = true;
    answered.points = nodes_between(scene, from, to);
    LawOfAnswer found{.results = compute(answered, progress), .law = {}};
    const Curve& curve = found.results.answer->curve;
    const double rms_height = scene.face.parameters.rms_height.value;
    found.law = answer_of(curve, rms_height)
                    .law_at(quantile, {.min_pressure = curve.states.front().pressure.value,
                                       .max_pressure = curve.states.back().pressure.value,
                                       .outside = OutsideRange::extrapolate});
    return found;
}

Curve curve_at(const LawOfAnswer& found, const Scene& scene, const std::vector<double>& pressures) {
    const Curve& answer = found.results.answer->curve;
    std::vector<std::pair<double, double>> areas;  // ln of the real area over ln p
    for (const auto& state : answer.states)
        if (state.real_area_fraction.value > 0)
            areas.emplace_back(std::log(state.pressure.value), std::log(state.real_area_fraction.value));
    const bool has_area = areas.size() == answer.states.size();
    const auto area = has_area ? std::optional<detail::RisingCurve>(std::move(areas)) : std::nullopt;
    Curve curve;
    curve.law = answer.law;
    const auto [least, greatest] = found.law.pressures();
    constexpr double rounding = 1e-12;
    for (const double pressure : pressures) {
        const double p = std::clamp(pressure, least, greatest);
        if (std::abs(p / pressure - 1) > rounding) continue;
        ContactState<double>& state = curve.states.emplace_back();
        state.pressure.value = p;
        state.separation.value = answer.states.back().separation.value + found.law.separation(p);
        state.stiffness.value = state.loading_stiffness.value = found.law.stiffness(p);
        if (area) state.real_area_fraction.value = std::exp(area->at(std::log(p)));
    }
    curve.columns = columns_of(scene, curve, false);
    return curve;
}

}  // namespace fstiff::actions
