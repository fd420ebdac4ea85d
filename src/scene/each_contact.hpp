// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The contacts of a scene one after the other, and their points. Private to the files that compute.

#include <fstiff/double/integrals.hpp>
#include "scene/results.hpp"

#include <fstiff/contact/rough_contact.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

namespace fstiff::scene {

/// Every point is independent, so that they may be computed in parts, one by one where \p law takes seconds for each,
/// with
/// \p progress called between them.
inline std::vector<ContactPoint<double>> points_of(const Scene& scene, const Law& law, const AnyContact& contact,
                                                   Quantity quantities, const ProgressHook& progress = {}) {
    const std::size_t part = law.varies ? 64 : 1;
    std::vector<ContactPoint<double>> points;
    for (std::span<const double> rest = scene.points; !rest.empty();) {
        if (progress) progress("points", scene.points.size() - rest.size(), scene.points.size());
        const auto some = rest.first(std::min(part, rest.size()));
        const auto more =
            scene.at_separations ? contact.at_separations(some, quantities) : contact.at_pressures(some, quantities);
        points.insert(points.end(), more.begin(), more.end());
        rest = rest.subspan(some.size());
    }
    return points;
}

/// Where the approach of \p curve, which has its states, begins. \returns why \p contact has no separation there; empty
/// where it has, or where no approach is asked for.
inline std::string seat(const Scene& scene, const AnyContact& contact, Curve& curve) {
    if (!scene.approach) return "";
    const auto point = contact.at_pressures(std::span(&scene.seating, 1), Quantity::separation).front();
    if (point.ok()) curve.seated.assign(curve.states.size(), point.state.separation.value);
    return point.ok() ? "" : point.reason;
}

/// d log K/d log p of \p curve, which has its states, over the pressures below each: what the loss factor takes of the
/// law. None where \p contact has no K there.
inline void grow(const Scene& scene, const AnyContact& contact, Curve& curve) {
    if (!scene.loss_factor) return;
    constexpr double share = 0.6;
    std::vector<double> pressures;
    for (const ContactState<double>& state : curve.states) pressures.push_back(share * state.pressure.value);
    const auto points = contact.at_pressures(pressures, Quantity::stiffness);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double ratio = curve.states[i].stiffness.value / points[i].state.stiffness.value;
        if (!points[i].ok() || !(ratio > 0)) return curve.growth.clear();
        curve.growth.push_back(std::clamp(std::log(ratio) / -std::log(share), 0.0, 1.9));
    }
}

/// The joint distributions of peaks of which \p law has a curve each; none for a law that has none. Where the scene
/// names none, those of an isotropic surface of its alpha; the laws of the paper keep the paper's pair.
inline std::vector<Peaks> peaks_of(const Law& law, const Scene& scene) {
    if (!law.has_peaks) return {};
    if (!scene.default_peaks || law.needs_dimension || !has_isotropic_peaks(scene.face)) return scene.peaks;
    const auto peaks = PeakDistribution<double>::isotropic(spectral_moments(scene.face).bandwidth());
    return {{.theta = peaks.theta(), .r = peaks.r(), .key = "contact.peaks."}};
}

/// The rms gradient of the surface for p*, the same for every law: known or assumed; of the surface's own r and theta;
/// of R and D_p, by their spectrum or as islands; else of the last entry of contact.peaks that gives one (r = 0 gives
/// none).
inline std::optional<double> gradient(const Scene& scene) {
    if (scene.face.has_own_gradient()) return scene.face.rms_gradient;
    const parts::SurfaceParameters<double>& own = scene.face.parameters;
    if (scene.face.has_peaks())
        if (const auto of_own =
                parts::rms_gradient(scene.face.roughness(), PeakDistribution(own.r->value, own.theta->value)))
            return of_own;
    if (scene.face.rms_gradient) return scene.face.rms_gradient;
    if (no_spectrum(scene.face).empty()) return std::sqrt(2 * spectral_moments(scene.face).m2);
    std::optional<double> of_peaks;
    for (const Peaks& peaks : scene.peaks)
        if (const auto one = parts::rms_gradient(scene.face.roughness(), peak_density(peaks))) of_peaks = one;
    return of_peaks;
}

/// Calls \p visit with the curve of every law and distribution of peaks, still without states, and with what makes its
/// contact.
template <class Visit>
void for_each_contact(const Scene& scene, double modulus, const ProgressHook& progress, const Visit& visit) {
    ContactInputs inputs{.surface = scene.face.roughness(),
                         .effective_modulus = modulus,
                         .fractal_dimension = scene.face.dimension().value_or(0),
                         .interaction = interaction(scene),
                         .options = scene.law_options,
                         .moments = spectral_moments(scene.face),
                         .hurst = hurst_exponent(scene.face),
                         .map = scene.face.map.get(),
                         .spectrum_of_map = scene.face.spectrum_of_map,
                         .bearing = scene.face.bearing.get(),
                         .similar = scene.similar.get(),
                         .material = {.effective_modulus = modulus,
                                      .yield_strength = scene.yield_strength.value_or(0),
                                      .poisson_ratio = scene.softer_poisson,
                                      .hardness = scene.hardness.value_or(0)},
                         .progress = progress};
    const std::optional<double> slope = gradient(scene);
    for (const Law* law : scene.laws) {
        const auto make = [&] { return law->contact(inputs); };
        if (!law->has_peaks) visit(Curve{.law = law, .rms_gradient = slope}, make);
        for (const Peaks& of : peaks_of(*law, scene)) {
            const PeakDistribution<double> peaks = peak_density(of);
            inputs.peaks = &peaks;
            visit(Curve{.law = law, .theta = peaks.theta(), .r = peaks.r(), .rms_gradient = slope}, make);
        }
    }
}

}  // namespace fstiff::scene
