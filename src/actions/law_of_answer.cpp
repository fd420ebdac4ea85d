// SPDX-License-Identifier: BSD-3-Clause
#include "actions/law_of_answer.hpp"

#include <fstiff/answer/answer_of.hpp>
#include <fstiff/answer/rising_curve.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
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
        for (const std::size_t place : scene.points_of_answer()) logs.push_back(std::log(scene.points[place]));
    std::erase_if(logs, [&](double x) { return x < std::log(from) || x > std::log(to); });
    std::sort(logs.begin(), logs.end());
    logs.erase(std::unique(logs.begin(), logs.end(), [](double a, double b) { return b - a < close; }), logs.end());
    const double step = std::log(10.0) / (scene.joint.face.map ? 4 : 10);
    std::vector<double> nodes{from};
    for (std::size_t i = 1; i < logs.size(); ++i) {
        const int parts = std::max(1, static_cast<int>(std::ceil((logs[i] - logs[i - 1]) / step - close)));
        for (int k = 1; k <= parts; ++k) nodes.push_back(std::exp(std::lerp(logs[i - 1], logs[i], double(k) / parts)));
    }
    nodes.back() = to;
    return nodes;
}

}  // namespace

LawOfAnswer law_of_answer(const Scene& scene, double quantile, double from, double to,
                          const std::optional<double>& after, const ProgressHook& progress) {
    Scene answered = scene;
    answered.best = true, answered.at_separations = false, answered.listed = true;
    answered.points = nodes_between(scene, from, to);
    if (after && scene.joint.face.map && *after > from && *after < to) {  // boundary elements flatten it
        answered.joint.greatest_pressure = *after;
        const auto next = std::lower_bound(answered.points.begin(), answered.points.end(), *after);
        if (*next != *after) answered.points.insert(next, *after);
    }
    LawOfAnswer found{.answered = compute(std::move(answered), progress), .law = {}};
    double least = 0, greatest = 0;
    for (const AnswerPoint& point : found.answered.answer.points) {
        if (!point.ok()) continue;
        if (least == 0) least = point.pressure;
        greatest = point.pressure;
    }
    const LawRange<double> range{.min_pressure = least, .max_pressure = greatest, .outside = OutsideRange::extrapolate};
    const Answer& answer = found.answered.answer;
    found.law = after ? answer.law_after(*after, quantile, range) : answer.law_at(quantile, range);
    return found;
}

AnswerCurve curve_at(const LawOfAnswer& found, const Scene& scene, const std::vector<double>& pressures) {
    const Answer& answer = found.answered.answer;
    std::vector<std::pair<double, double>> areas;  // ln of the real area over ln p
    double closest = 0;
    for (const AnswerPoint& point : answer.points) {
        if (!point.ok()) continue;
        closest = point.state.separation.value;
        if (const double area = point.state.real_area_fraction.value; area > 0)
            areas.emplace_back(std::log(point.pressure), std::log(area));
    }
    const bool has_area = areas.size() == count_of(answer);
    const auto area = has_area ? std::optional<detail::RisingCurve>(std::move(areas)) : std::nullopt;
    const AnswerOptions options = scene.options();
    const detail::Law& law = detail::find_law(answer.law);
    AnswerCurve curve;
    curve.law = answer.law;
    const auto [least, greatest] = found.law.pressures();
    constexpr double rounding = 1e-12;
    for (const double pressure : pressures) {
        const double p = std::clamp(pressure, least, greatest);
        if (std::abs(p / pressure - 1) > rounding) continue;
        ContactState<double> state;
        state.pressure.value = p;
        state.separation.value = closest + found.law.separation(p);
        state.stiffness.value = state.loading_stiffness.value = found.law.stiffness(p);
        if (area) state.real_area_fraction.value = std::exp(area->at(std::log(p)));
        curve.points.push_back(point_of(scene.joint, law, state, options));
        curve.points.back().place = curve.points.size() - 1;
    }
    return curve;
}

}  // namespace fstiff::actions
