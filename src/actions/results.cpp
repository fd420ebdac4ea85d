// SPDX-License-Identifier: BSD-3-Clause
#include "actions/results.hpp"

#include "document/file.hpp"
#include "document/shown_unit.hpp"

#include <fstiff/asperity/material.hpp>
#include <fstiff/contact/rough_contact.hpp>

#include <algorithm>
#include <cmath>

namespace fstiff::actions {

using detail::LawCurve, scene::Scene;

std::string reason_of(const Scene& scene, const detail::MissedPoint& missed) {
    if (missed.why == detail::Miss::range)
        return "a result for " + document::shortest(scene.points[missed.place]) +
               " is beyond the range of double precision; the values of the scene must be less extreme";
    return detail::reason_of(scene, missed, scene.points[missed.place],
                             [](double pressure) { return document::with_unit(pressure, "Pa", 3); });
}

std::string laws_of(const Curve& curve) {
    std::vector<const detail::Law*> laws;
    for (const detail::Law* law : curve.by)
        if (std::find(laws.begin(), laws.end(), law) == laws.end()) laws.push_back(law);
    if (laws.empty()) laws.push_back(curve.law);
    std::string text;
    for (const detail::Law* law : laws) text += (text.empty() ? "" : " and ") + std::string(law->name);
    return text;
}

std::string title(const Curve& curve) {
    std::string text = laws_of(curve);
    if (curve.theta) text += ", theta = " + document::rounded(*curve.theta) + ", r = " + document::rounded(*curve.r);
    return text;
}

std::optional<double> Curve::value_at(std::size_t place, scene::CurveQuantity quantity,
                                      scene::Statistic statistic) const {
    const auto state = state_at(place);
    for (const scene::Column& column : columns)
        if (state && column.quantity == quantity && column.statistic == statistic && !column.values.empty() &&
            !std::isnan(column.values[*state]))
            return column.values[*state];
    return std::nullopt;
}

Scene with_finer_points(Scene scene, bool between) {
    const std::size_t enough = scene.face.map ? 9 : 41;  // boundary elements are solved at each of a map
    std::vector<double> points = scene.points;
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (between) scene.points.clear();
    if (points.size() < 2 || points.size() >= enough) return scene;
    const std::size_t steps = (enough - 1 + points.size() - 2) / (points.size() - 1);
    scene.points.clear();
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
        for (std::size_t k = between ? 1 : 0; k < steps; ++k) {
            const double t = static_cast<double>(k) / static_cast<double>(steps);
            const double low = points[i], high = points[i + 1];
            scene.points.push_back(k == 0                 ? low
                                   : scene.at_separations ? low + t * (high - low)
                                                          : low * std::pow(high / low, t));
        }
    if (!between) scene.points.push_back(points.back());
    scene.listed = true;
    if (!scene.forces.empty()) scene.forces = scene.points;
    for (double& force : scene.forces) force *= *scene.nominal_area;
    return scene;
}

std::vector<const Curve*> shown_curves(const Results& results) {
    std::vector<const Curve*> shown;
    const bool named = results.curves.front().by.empty();  // else it is the answer's
    if (results.answer && named) shown.push_back(&results.answer->curve);
    for (const Curve& curve : results.curves) shown.push_back(&curve);
    return shown;
}

std::vector<std::string> assumptions_of(const Scene& scene, const Results& results) {
    std::vector<std::string> assumptions = scene.assumptions;
    if (results.answer)
        assumptions.insert(assumptions.end(), scene.assumptions_of_answer.begin(), scene.assumptions_of_answer.end());
    return assumptions;
}

bool has_band(const Results& results) {
    return std::any_of(results.curves.begin(), results.curves.end(),
                       [](const Curve& curve) { return !curve.band.empty(); });
}

}  // namespace fstiff::actions
