// SPDX-License-Identifier: BSD-3-Clause
#include "scene/bands.hpp"

#include "scene/each_contact.hpp"
#include "scene/priors.hpp"
#include "scene/quick_hybrids.hpp"

#include <fstiff/math/random.hpp>
#include <fstiff/measured/widened_band.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

namespace fstiff::scene {
namespace {

/// The states of random numbers that a band draws in addition to those of the parameters.
struct RandomStates {
    std::uint64_t tiles, gradients;
};

/// The rms gradient of \p scene drawn by its own error, over what it was; lognormal as rms height.
double drawn_gradient(const Scene& scene, std::uint64_t& state) {
    if (!(scene.face.gradient_error > 0)) return 1;
    const double relative = scene.face.gradient_error / *scene.face.rms_gradient;
    return std::exp(std::sqrt(std::log1p(relative * relative)) * math::normal_pair<double>(state).real());
}

/// The scene with the surface \p drawn about its own. Of a map the tiles are drawn anew.
Scene with_surface(Scene scene, const std::array<double, parts::surface_parameter_count>& drawn, RandomStates& random) {
    const double rms_height = scene.face.parameters.rms_height.value;
    const auto value = [&](Parameter which) { return drawn[parts::index_of(which)]; };
    scene.face.draw(drawn);
    const double taller = scene.face.parameters.rms_height.value / rms_height;
    if (scene.face.rms_gradient) {
        const double steeper = drawn_gradient(scene, random.gradients);
        *scene.face.rms_gradient *= taller * steeper;
        if (scene.face.radius_follows) scene.face.parameters.peak_radius.value /= steeper * steeper;
        if (scene.face.density_follows) scene.face.parameters.peak_density.value *= steeper * steeper;
    }
    if (scene.face.map) {
        const auto& of_shifts = scene.face.map->summits;
        const std::size_t shift = of_shifts.size() == 1 ? 0 : math::splitmix64(random.tiles) % of_shifts.size();
        MapOfSurface map{{},
                         {parts::resampled(of_shifts[shift], 4, random.tiles)},
                         scene.face.map->spectra,
                         scene.face.map->bearings,
                         scene.face.map->mean_square_height,
                         scene.face.map->first_bearing + shift,
                         scene.face.map->taller * taller};
        scene.face.map = std::make_shared<const MapOfSurface>(std::move(map));
    }
    for (Peaks& peaks : scene.peaks)
        if (peaks.of_surface) peaks.r = value(Parameter::r), peaks.theta = value(Parameter::theta);
    return scene;
}

/// The scene with a neighbour of its surface.
Scene with_face(Scene scene, const Face& face) {
    scene.face = face;
    for (Peaks& peaks : scene.peaks)
        if (peaks.of_surface && face.has_peaks())
            peaks.r = face.value(Parameter::r), peaks.theta = *face.value(Parameter::theta);
    return scene;
}

/// K at the points of \p scene, of which there are many, by a polynomial through ln K at some over ln p or d: of a law
/// each of whose states is an integral in two dimensions. Empty where a state of those is missing.
std::vector<double> by_few(Scene scene, const Law& law, const AnyContact& contact) {
    const auto x_of = [&](double point) { return scene.at_separations ? point : std::log(point); };
    const std::vector<double> wanted = std::move(scene.points);
    const auto [least, greatest] = std::minmax_element(wanted.begin(), wanted.end());
    const double from = x_of(*least), half = (x_of(*greatest) - from) / 2,
                 unit = scene.at_separations ? scene.face.parameters.rms_height.value : 1;
    const int last = 12 + static_cast<int>(std::min(2 * half / unit, 30.0));  // of Chebyshev's points
    std::vector<double> nodes, logs, all;
    for (int k = 0; k <= last; ++k) nodes.push_back(from + half * (1 - std::cos(std::numbers::pi * k / last)));
    scene.points.clear();
    for (const double x : nodes) scene.points.push_back(scene.at_separations ? x : std::exp(x));
    for (const auto& point : points_of(scene, law, contact, Quantity::pressure | Quantity::stiffness)) {
        if (!point.ok() || !(point.state.stiffness.value > 0)) return {};
        logs.push_back(std::log(point.state.stiffness.value));
    }
    for (const double point : wanted) {
        double sum = 0, weights = 0;
        for (std::size_t k = 0; k < nodes.size(); ++k) {
            const double apart = x_of(point) - nodes[k], end = k == 0 || k + 1 == nodes.size() ? 0.5 : 1.0;
            const double weight = (k % 2 == 0 ? end : -end) / (apart == 0 ? 1e-300 : apart);
            sum += weight * logs[k], weights += weight;
        }
        all.push_back(std::exp(sum / weights));
    }
    return all;
}

/// K of every curve and point of \p scene, one after the other; NaN for a surface that the law does not take, such as a
/// D next to 2.
std::vector<double> stiffnesses(const Scene& scene, double modulus) {
    std::vector<double> all;
    for_each_contact(scene, modulus, {}, [&](const Curve& curve, const auto& contact) {
        try {
            constexpr std::size_t many = 48;
            const auto made = contact();
            if (scene.similar && curve.law->needs_yield && scene.points.size() > many)
                if (const auto few = by_few(scene, *curve.law, *made); !few.empty())
                    return void(all.insert(all.end(), few.begin(), few.end()));
            for (const auto& point : points_of(scene, *curve.law, *made, Quantity::pressure | Quantity::stiffness))
                all.push_back(point.ok() ? point.state.stiffness.value : std::numeric_limits<double>::quiet_NaN());
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
    lean.face.measured.reset();
    lean.face.heights.reset();
    lean.faces.clear();
    lean.face.neighbours.clear();
    std::erase_if(lean.laws, [](const Law* law) { return !law->varies; });
    lean.law_options.mutual = false;
    if (std::none_of(lean.laws.begin(), lean.laws.end(),
                     [](const Law* law) { return law->needs_map || law->needs_spectrum; }))
        lean.face.map.reset();  // nothing takes its tiles
    return lean;
}

/// K of every curve and point with D greater and smaller by what the windows of lags leave open: 5 % and 95 % of it.
std::vector<std::vector<double>> behind_other_windows(const Scene& lean, double modulus) {
    std::vector<std::vector<double>> both;
    const parts::SurfaceParameters<double>& surface = lean.face.parameters;
    if (!surface.fractal_dimension || !(surface.dimension_window_error > 0)) return both;
    for (const double dimension :
         parts::dimensions_of_other_windows(surface.fractal_dimension->value, surface.dimension_window_error)) {
        Scene other = lean;
        other.face.parameters.fractal_dimension->value = dimension;
        both.push_back(stiffnesses(other, modulus));
    }
    return both;
}

/// K of every curve and point of the surfaces that have one unknown at its ends, over that of \p lean.
std::vector<parts::UnknownCurves<double>> behind_unknowns(const Scene& scene, Scene lean, double modulus) {
    std::vector<parts::UnknownCurves<double>> all;
    const std::vector<Alternative> others = alternatives(scene);
    if (others.empty()) return all;
    lean.similar = hybrids_of_numbers(lean.law_options.gamma);
    const std::vector<double> own = stiffnesses(lean, modulus);
    const auto over_own = [&](const Face& face) {
        std::vector<double> other = stiffnesses(with_face(lean, face), modulus);
        other.resize(own.size(), std::numeric_limits<double>::quiet_NaN());
        std::transform(other.begin(), other.end(), own.begin(), other.begin(), std::divides<>());
        return other;
    };
    for (const Alternative& one : others) all.push_back({one.which, over_own(one.low), over_own(one.high)});
    return all;
}

/// Bands over the errors of the surface, one for each value of stiffnesses().
std::vector<parts::SampledBand<double>> drawn_bands(const Scene& scene, const Scene& lean, double modulus,
                                                    const ProgressHook& progress) {
    Scene to_draw_about = lean;
    to_draw_about.similar = hybrids_of_draws(lean.face.bearing.get(), lean.law_options.gamma);
    RandomStates random{scene.seed, ~scene.seed};
    return parts::sampled_band(
        scene.face.parameters,
        [&](const auto& drawn) { return stiffnesses(with_surface(to_draw_about, drawn, random), modulus); },
        {static_cast<std::size_t>(scene.samples), scene.seed, progress});
}

}  // namespace

void add_bands(const Scene& scene, Results& results, const ProgressHook& progress) {
    const Scene lean = lean_scene(scene);
    const bool has_errors = scene.face.has_measured_errors();
    const auto of_unknowns = behind_unknowns(scene, lean, results.modulus);
    if (!has_errors && of_unknowns.empty()) return;
    std::vector<parts::SampledBand<double>> bands;
    if (has_errors) bands = drawn_bands(scene, lean, results.modulus, progress);
    const std::vector<double> quick = has_errors ? stiffnesses(lean, results.modulus) : std::vector<double>();
    std::vector<std::vector<double>> of_neighbours;
    for (const Face& face : scene.face.neighbours) {
        of_neighbours.push_back(stiffnesses(with_face(lean, face), results.modulus));
        if (of_neighbours.back().size() != quick.size()) of_neighbours.pop_back();  // no map, or no D: other curves
    }
    const auto of_windows = behind_other_windows(lean, results.modulus);
    std::size_t failed = 0, next = 0;
    for (Curve& curve : results.curves) {
        if (!curve.law->varies) continue;
        bool wide_anywhere = has_errors;
        for (std::size_t i = 0; i < curve.states.size(); ++i) {
            const std::size_t at = next + curve.places[i];
            const double value = curve.states[i].stiffness.value;
            parts::SampledBand<double> band{value, value, value};
            double factor = 1;
            if (has_errors) {
                band = bands[at];
                failed = std::max(failed, band.failed);
                if (std::isfinite(quick[at])) factor = value / quick[at];
                if (curve.law->has_quick_form) band.low *= factor, band.median *= factor, band.high *= factor;
            }
            const parts::WidenedBand<double> wide =
                parts::widened(value, band, of_neighbours, of_windows, at, scene.has_lay, factor, of_unknowns);
            wide_anywhere = wide_anywhere || wide.band.high > wide.band.low;
            if (!of_neighbours.empty() || !of_unknowns.empty()) curve.band_parts.push_back(wide.parts);
            curve.band.push_back(wide.band);
        }
        if (!wide_anywhere) curve.band.clear(), curve.band_parts.clear();  // depends on no unknown
        next += scene.points.size();
    }
    if (failed > 0)
        results.warnings.push_back(
            "up to " + std::to_string(failed) + " of " + std::to_string(scene.samples) +
            " sampled surfaces are outside the range of the model at some point: the band there is from the others");
}

}  // namespace fstiff::scene
