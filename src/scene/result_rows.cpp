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

Heading heading_of(const std::string& key, const Units& units) {
    const auto in = [&](const char* name, const ShownUnit& unit, int digits = 5) {
        return Heading{key, name + (" [" + std::string(unit.name) + "]"), unit.factor, digits};
    };
    if (key == "pressure_Pa") return in("p", units.pressure);
    if (key == "separation_m") return in("separation", units.height);
    if (key == "stiffness_Pa_per_m") return in("K/A0", unit_of_stiffness);
    if (key == "stiffness_error_Pa_per_m") return in("numerical error", {"Pa/m", 1}, 2);
    if (key == "stiffness_p05_Pa_per_m") return in("5 %", unit_of_stiffness);
    if (key == "stiffness_p95_Pa_per_m") return in("95 %", unit_of_stiffness);
    if (key == "loading_stiffness_Pa_per_m") return in("-dp/dd", unit_of_stiffness);
    if (key == "tangential_stiffness_Pa_per_m") return in("Kt/A0", unit_of_stiffness);
    if (key == "contacts_per_m2") {
        const ShownUnit& unit = units.density;
        return {key, "contacts [1" + std::string(unit.name) + "]", unit.factor};
    }
    static const std::vector<Heading> plain{{"eta", "eta"},
                                            {"reflection", "|R|"},
                                            {"reflection_p05", "5 %"},
                                            {"reflection_p95", "95 %"},
                                            {"shear_reflection", "shear |R|"},
                                            {"shear_reflection_p05", "5 %"},
                                            {"shear_reflection_p95", "95 %"},
                                            {"real_area_fraction", "real area"}};
    const auto found = std::find_if(plain.begin(), plain.end(), [&](const auto& one) { return one.key == key; });
    return found == plain.end() ? Heading{key} : *found;
}

Rows rows_of(const Results& results, const Curve& curve, const Units& units) {
    Rows rows;
    const std::size_t size = curve.states.size();
    const auto put = [&](Heading heading, const std::vector<double>& values) {
        if (values.empty())
            rows.repeat(std::move(heading), Cell(), size);
        else
            rows.add(std::move(heading), values);
    };
    rows.repeat({"law"}, curve.law->name, size);
    rows.repeat({"theta"}, curve.theta, size);
    rows.repeat({"r"}, curve.r, size);
    for (const Column& column : curve.columns) {
        put(heading_of(column.key, units), column.values);
        if (column.key == "pressure_Pa" && curve.rms_gradient) {
            std::vector<double> relative;
            for (const double p : column.values)
                relative.push_back(dimensionless_pressure(p, results.modulus, *curve.rms_gradient));
            put({"", "p*", 1, 3}, relative);
        } else if (column.key == "stiffness_Pa_per_m") {
            put({"", "K/A0 [Pa/m]", 1, 6}, column.values);
        } else if (column.key == "real_area_fraction") {
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
