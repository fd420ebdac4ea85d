// SPDX-License-Identifier: BSD-3-Clause
#include "scene/result_rows.hpp"

#include <fstiff/validity/checks.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace fstiff::scene {
namespace {

/// p over the real area; absent without contact.
std::vector<Cell> mean_pressures(const Curve& curve) {
    std::vector<Cell> cells;
    for (const auto& state : curve.states) {
        const double area = state.real_area_fraction.value;
        cells.push_back(area > 0 ? Cell(state.pressure.value / area) : Cell());
    }
    return cells;
}

/// Whether the points were written one by one, not as a range.
bool are_listed(const Scene& scene) {
    return std::none_of(scene.inputs.begin(), scene.inputs.end(), [](const Input& input) {
        return input.key == "contact.pressures.count" || input.key == "contact.separations.count";
    });
}

}  // namespace

Json scene_json(const Scene& scene) { return {{"name", scene.name}, {"file", scene.file}, {"sha256", scene.sha256}}; }

Units units_of(const Scene& scene, const Results& results) {
    double least = 0, most = 0;
    for (const Curve& curve : results.curves)
        for (const auto& state : curve.states) {
            const double p = state.pressure.value;
            most = std::max(most, p);
            if (p > 0) least = least > 0 ? std::min(least, p) : p;
        }
    return {unit_of_pressure(std::sqrt(least * most)), unit_of_length(scene.face.parameters.rms_height.value),
            unit_of_density(scene.face.parameters.peak_density.value)};
}

Heading heading_of(const Column& column, const Units& units) {
    const auto& [quantity, name, suffix, si, symbol, of_law, asked, has_band] = column.row();
    const ShownUnit unit = si == "Pa"      ? units.pressure
                           : si == "m"     ? units.height
                           : si == "1/m^2" ? units.density
                           : si == "Pa/m"  ? units.stiffness
                                           : ShownUnit{};
    switch (column.statistic) {
        case Statistic::value: return {column.key(), unit.heading(symbol), unit.factor};
        case Statistic::error:  // the others have that of K
            if (quantity != CurveQuantity::stiffness) return {column.key()};
            return {column.key(), "numerical error [Pa/m]", 1, 2};
        case Statistic::p05: return {column.key(), unit.heading("5 %"), unit.factor};
        case Statistic::p95: return {column.key(), unit.heading("95 %"), unit.factor};
    }
    return {};
}

Rows rows_of(const Results& results, const Curve& curve, const Units& units) {
    Rows rows;
    const std::size_t size = curve.states.size();
    rows.repeat({"law"}, curve.law->name, size);
    rows.repeat({"theta"}, curve.theta, size);
    rows.repeat({"r"}, curve.r, size);
    for (const Column& column : curve.columns) {
        rows.add(heading_of(column, units), column.values);
        if (column.quantity == CurveQuantity::pressure && curve.rms_gradient) {
            std::vector<double> relative;
            for (const double p : column.values)
                relative.push_back(parts::dimensionless_pressure(p, results.modulus, *curve.rms_gradient));
            rows.add({"", "p*", 1, 3}, relative);
        } else if (column.quantity == CurveQuantity::stiffness && column.statistic == Statistic::value) {
            rows.add({"", "K/A0 [Pa/m]", 1, 6}, column.values);
        } else if (column.quantity == CurveQuantity::real_area) {
            rows.add({"", "mean pressure [GPa]", 1e-9}, mean_pressures(curve));
        }
    }
    std::vector<std::size_t> failed;
    for (const auto& band : curve.band) failed.push_back(band.failed);
    if (!failed.empty()) rows.add({.key = "samples_out_of_reach", .csv = false}, failed);
    return rows;
}

std::vector<std::size_t> summary_points(const Scene& scene) {
    constexpr std::size_t most = 12, few = 4;
    const std::vector<double>& points = scene.points;
    std::vector<std::size_t> chosen;
    const auto [least, greatest] = std::minmax_element(points.begin(), points.end());
    const bool all = points.size() <= few || (points.size() <= most && are_listed(scene));
    bool decades = false;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double decade = points[i] > 0 ? std::log10(points[i]) : 0.5;
        const bool is_decade = !scene.at_separations && std::abs(decade - std::round(decade)) < 1e-6;
        const bool is_end = points[i] == *least || points[i] == *greatest;
        if (is_decade || is_end || all) chosen.push_back(i);
        decades = decades || is_decade;
    }
    if (all || decades) return chosen;
    chosen.clear();
    for (std::size_t k = 0; k < few; ++k) chosen.push_back((k * (points.size() - 1) + 1) / (few - 1));
    return chosen;
}

}  // namespace fstiff::scene
