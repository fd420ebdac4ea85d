// SPDX-License-Identifier: BSD-3-Clause
#include "scene/bands.hpp"

#include "scene/each_contact.hpp"
#include "scene/file.hpp"
#include "scene/shown_unit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fstiff::scene {
namespace {

/// The scene with the surface \p drawn about its own. Of a map the tiles are drawn anew, with the random \p tiles.
Scene with_surface(Scene scene, const std::array<double, surface_parameter_count>& drawn, std::uint64_t& tiles) {
    const double rms_height = scene.surface.rms_height;
    const auto value = [&](Parameter which) { return drawn[index_of(which)]; };
    scene.surface.rms_height = value(Parameter::rms_height);
    scene.surface.peak_radius = value(Parameter::peak_radius);
    scene.surface.peak_density = value(Parameter::peak_density);
    if (scene.fractal_dimension) scene.fractal_dimension = value(Parameter::fractal_dimension);
    const double taller = scene.surface.rms_height / rms_height;
    if (scene.rms_gradient) *scene.rms_gradient *= taller;
    if (scene.map) {
        const auto& of_shifts = scene.map->summits;
        const Summits<double>& one =
            of_shifts.size() == 1 ? of_shifts.front() : of_shifts[splitmix64(tiles) % of_shifts.size()];
        MapOfSurface map{{}, {resampled(one, 4, tiles)}, scene.map->spectrum};
        map.spectrum.rms_height *= taller;
        for (auto& shell : map.spectrum.shells) shell.q2_h2 *= taller * taller, shell.q_h2 *= taller * taller;
        scene.map = std::make_shared<const MapOfSurface>(std::move(map));
    }
    for (Peaks& peaks : scene.peaks)
        if (peaks.of_surface) peaks.r = value(Parameter::r), peaks.theta = value(Parameter::theta);
    return scene;
}

/// The scene with a neighbour of its surface.
Scene with_face(Scene scene, const Face& face) {
    static_cast<Face&>(scene) = face;
    for (Peaks& peaks : scene.peaks)
        if (peaks.of_surface && face.r) peaks.r = *face.r, peaks.theta = *face.theta;
    return scene;
}

/// K of every curve and point of \p scene, one after the other; NaN for a surface that the law does not take, such as a D next
/// to 2.
std::vector<double> stiffnesses(const Scene& scene, double modulus) {
    std::vector<double> all;
    for_each_contact(scene, modulus, {}, [&](const Curve&, const auto& contact) {
        try {
            for (const auto& point : points_of(scene, *contact(), Quantity::pressure | Quantity::stiffness))
                all.push_back(point.state.stiffness.value);
        } catch (const domain_error&) {
            all.insert(all.end(), scene.points.size(), std::numeric_limits<double>::quiet_NaN());
        }
    });
    return all;
}

/// \p scene as it is copied with every surface: with the laws that vary, in their quick form, and what they take.
Scene lean_scene(const Scene& scene) {
    Scene lean = scene;
    lean.inputs.clear();
    lean.measured.reset();
    lean.heights.reset();
    lean.faces.clear();
    lean.neighbours.clear();
    std::erase_if(lean.laws, [](const ChosenLaw& chosen) { return !chosen.law->varies; });
    for (ChosenLaw& chosen : lean.laws)
        if (!chosen.law->quick_options.empty())
            chosen.options.assign(chosen.law->quick_options.begin(), chosen.law->quick_options.end());
    if (std::none_of(lean.laws.begin(), lean.laws.end(),
                     [](const ChosenLaw& chosen) { return chosen.law->needs_map || chosen.law->needs_spectrum; }))
        lean.map.reset();  // nothing takes its tiles
    return lean;
}

/// Widens \p band, of K = \p value, by the spread to \p others.
void widen(SampledBand<double>& band, BandParts& parts, double value, const std::vector<double>& others) {
    parts.errors_low = std::min(0.0, std::log(band.low / value)),
    parts.errors_high = std::max(0.0, std::log(band.high / value));
    for (const double other : others) {
        if (!(other > 0)) continue;
        parts.scale_low = std::min(parts.scale_low, std::log(other / value));
        parts.scale_high = std::max(parts.scale_high, std::log(other / value));
    }
    band.low *= std::exp(-(std::hypot(parts.errors_low, parts.scale_low) + parts.errors_low));
    band.high *= std::exp(std::hypot(parts.errors_high, parts.scale_high) - parts.errors_high);
}

/// Which part of the band of the first law is the wider one, at the middle point.
std::string dominating(const Scene& scene, const Curve& curve) {
    const std::size_t i = curve.band_parts.size() / 2;
    const BandParts& parts = curve.band_parts[i];
    const auto percent = [](double low, double high) {
        return shown_change(std::exp(low)) + " to " + shown_change(std::exp(high));
    };
    std::string of = "the scale of the measurement";
    std::vector<double> scales;
    for (const Face& face : scene.neighbours)
        if (face.measured && face.measured->cut_offs.lambda_s) scales.push_back(*face.measured->cut_offs.lambda_s);
    const auto [low, high] = std::minmax_element(scales.begin(), scales.end());
    if (scales.size() > 1) of = "lambda_s between " + shown_length(*low, 2) + " and " + shown_length(*high, 2);
    if (scales.size() == 1) of = "lambda_s up to " + shown_length(*high, 2);
    const bool scale = parts.scale_high - parts.scale_low > parts.errors_high - parts.errors_low;
    return "of the band of " + std::string(curve.law->name) +
           " at p = " + rounded(curve.states[i].pressure.value / 1e6, 3) + " MPa " +
           percent(parts.errors_low, parts.errors_high) + " are the errors of the measurement, " +
           percent(parts.scale_low, parts.scale_high) + " " + of + ": " +
           (scale ? "the choice of lambda_s dominates" : "the errors dominate");
}

}  // namespace

void add_bands(const Scene& scene, Results& results, const ProgressHook& progress) {
    const Scene lean = lean_scene(scene);
    std::uint64_t tiles = scene.seed;
    const auto bands =
        sampled_band(scene.uncertain,
                     [&](const auto& drawn) { return stiffnesses(with_surface(lean, drawn, tiles), results.modulus); },
                     {static_cast<std::size_t>(scene.samples), scene.seed, progress});
    const std::vector<double> quick = stiffnesses(lean, results.modulus);
    std::vector<std::vector<double>> of_neighbours;
    for (const Face& face : scene.neighbours) {
        of_neighbours.push_back(stiffnesses(with_face(lean, face), results.modulus));
        if (of_neighbours.back().size() != quick.size()) of_neighbours.pop_back();  // no map, or no D: other curves
    }
    std::size_t failed = 0, next = 0;
    for (Curve& curve : results.curves) {
        if (!curve.law->varies) continue;
        for (std::size_t i = 0; i < curve.states.size(); ++i) {
            SampledBand<double> band = bands[next + i];
            failed = std::max(failed, band.failed);
            const double value = curve.states[i].stiffness.value, factor = value / quick[next + i];
            if (!curve.law->quick_options.empty()) band.low *= factor, band.median *= factor, band.high *= factor;
            if (!of_neighbours.empty()) {
                std::vector<double> others;
                for (const auto& of : of_neighbours) others.push_back(of[next + i] * factor);
                widen(band, curve.band_parts.emplace_back(), value, others);
            }
            curve.band.push_back(band);
        }
        next += scene.points.size();
    }
    const auto first = std::find_if(results.curves.begin(), results.curves.end(),
                                    [](const Curve& curve) { return !curve.band_parts.empty(); });
    if (first != results.curves.end()) results.about_band = dominating(scene, *first);
    if (failed > 0)
        results.warnings.push_back("up to " + std::to_string(failed) + " of " + std::to_string(scene.samples) +
                                   " sampled surfaces are beyond the reach of the model at a point: the band there is "
                                   "that of the others");
}

}  // namespace fstiff::scene
