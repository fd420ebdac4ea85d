// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The functions of answer/unknowns.hpp: inline, or compiled once (docs/linking-cpp.md).

#include <fstiff/answer/face.hpp>
#include <fstiff/answer/unknowns.hpp>
#include <fstiff/math/random.hpp>
#include <fstiff/surface/band_spectrum.hpp>
#include <fstiff/surface/bearing_of_core.hpp>
#include <fstiff/surface/sum_of_faces.hpp>

#include <algorithm>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// Gradient and alpha, as far as they are not known.
FSTIFF_INLINE void fill_spectrum(Face& face) {
    const ProcessPrior prior = detail::prior_of(face.process, face.worn);
    const bool has_radius = !face.radius_follows, has_density = !face.density_follows;
    const Roughness<double> peaks = face.roughness();
    const auto set_gradient = [&](const PriorRange& range, Origin origin) {
        face.rms_gradient = range.middle;
        face.gradient_growth = origin == Origin::islands ? growth_of_islands : growth_of_height;
        face.priors.push_back({Unknown::gradient, range.low, range.high, origin, range});
    };
    if (!face.rms_gradient && !face.alpha && has_radius && has_density) {
        if (spectral_moments(face).bandwidth() > 1.5) return;
        face.gradient_of_islands = true;
        set_gradient(gradient_of_islands(peaks.rms_height, peaks.peak_radius, peaks.peak_density), Origin::islands);
    } else if (!face.rms_gradient && !has_radius && !has_density) {
        set_gradient(detail::gradient_of_height(prior, peaks.rms_height), Origin::process);
    } else if (face.rms_gradient && !face.alpha && (has_radius || has_density)) {
        face.follow();
        if (spectral_moments(face).bandwidth() > 1.5) return;
    }
    if (face.alpha) return;
    face.alpha = prior.alpha.middle;
    face.priors.push_back({Unknown::alpha, prior.alpha.low, prior.alpha.high, Origin::process, prior.alpha});
}

FSTIFF_INLINE void fill_hurst(Face& face) {
    if (face.hurst || face.dimension()) return;
    const PriorRange prior = detail::prior_of(face.process).hurst;
    const double middle = hurst_exponent(face);  // no less than the width of what was measured allows
    const double least = detail::least_hurst(spectral_moments(face), face.widest_band);
    const PriorRange range{(std::min)(middle, (std::max)(prior.low, least)), middle, (std::max)(middle, prior.high)};
    face.priors.push_back({Unknown::hurst, range.low, range.high, Origin::process, range});
}

/// Skewness and kurtosis: of a trace what their errors leave open, of numbers those of the process.
FSTIFF_INLINE void fill_shape(Face& face) {
    const double away = math::normal_95<double>.value;
    if (face.measured) {
        if (!face.heights || face.heights->kurtosis.value == 0) return;  // 0: a document without it
        const double skewness = away * face.heights->skewness.error, kurtosis = away * face.heights->kurtosis.error;
        face.priors.push_back({Unknown::skewness, face.shape.skewness - skewness, face.shape.skewness + skewness});
        face.priors.push_back({Unknown::kurtosis, face.shape.kurtosis - kurtosis, face.shape.kurtosis + kurtosis});
        return;
    }
    const ProcessPrior prior = detail::prior_of(face.process, face.worn);
    const double s = prior.skewness.middle, tail = 3 + 1.5 * s * s;
    const PriorRange kurtosis{tail + prior.tail.low, tail + prior.tail.middle, tail + prior.tail.high};
    face.set_shape({s, kurtosis.middle});
    face.priors.push_back(
        {Unknown::skewness, prior.skewness.low, prior.skewness.high, Origin::process, prior.skewness});
    face.priors.push_back({Unknown::kurtosis, kurtosis.low, kurtosis.high, Origin::process, kurtosis});
}

FSTIFF_INLINE void fill_unknown(Face& face, bool shape_known) {
    if (face.measured && !face.has_radius_and_density() && !(face.rms_gradient && face.alpha)) return;
    fill_spectrum(face);
    face.follow();
    fill_hurst(face);
    if (!shape_known) fill_shape(face);
}

FSTIFF_INLINE HeightShape<double> with_value(const HeightShape<double>& shape, Unknown unknown, double value) {
    auto [skewness, kurtosis] = shape;
    if (unknown == Unknown::skewness) {
        // the kurtosis goes along, as of heights with the density of a gamma distribution
        kurtosis += 1.5 * (value * value - skewness * skewness);
        skewness = value;
    } else {
        kurtosis = value;
    }
    skewness = std::clamp(skewness, -2.5, 2.5);
    return {skewness, std::clamp(kurtosis, detail::least_kurtosis(skewness), (std::max)(20.0, shape.kurtosis))};
}

FSTIFF_INLINE Face with_value(Face face, Unknown unknown, double value) {
    switch (unknown) {
        case Unknown::height: face.parameters.rms_height.value = value; break;
        case Unknown::gradient: face.rms_gradient = value; break;
        case Unknown::alpha: face.alpha = value; break;
        case Unknown::hurst: face.hurst = value; break;
        case Unknown::hardness: break;  // of a body
        case Unknown::skewness:
        case Unknown::kurtosis: face.set_shape(with_value(face.shape, unknown, value)); break;
    }
    face.follow();
    return face;
}

FSTIFF_INLINE Face with_measured(Face face, Unknown unknown) {
    std::erase_if(face.priors, [unknown](const Prior& prior) {
        return prior.which == unknown || (detail::is_of_shape(prior.which) && detail::is_of_shape(unknown));
    });
    if (unknown != Unknown::gradient || !face.gradient_of_islands) return face;
    face.gradient_of_islands = false;  // alpha follows from R then
    std::erase_if(face.priors, [](const Prior& prior) { return prior.which == Unknown::alpha; });
    face.alpha.reset();
    fill_spectrum(face);
    return face;
}

/// Whether one of \p laws depends on \p unknown of \p face, which is not known.
FSTIFF_INLINE bool depends_on(const ResolvedJoint& problem, const std::vector<const Law*>& laws, const Face& face,
                              Unknown unknown) {
    if (unknown == Unknown::height) return true;
    if (std::any_of(laws.begin(), laws.end(), [](const Law* law) { return law->needs_spectrum; })) return true;
    return !detail::is_of_shape(unknown) && unknown != Unknown::hurst &&
           (face.radius_follows || face.density_follows || (problem.default_peaks && has_isotropic_peaks(face)));
}

FSTIFF_INLINE bool depends_on_hardness(const ResolvedJoint& problem, const std::vector<const Law*>& laws) {
    return std::any_of(laws.begin(), laws.end(), [&](const Law* law) { return flows(problem, *law); });
}
FSTIFF_INLINE ResolvedJoint with_hardness(ResolvedJoint problem, double value) {
    problem.hardness = value, problem.hardness_range.reset();
    return problem;
}

FSTIFF_INLINE std::vector<RelevantPrior> relevant_priors(const ResolvedJoint& problem,
                                                         const std::vector<const Law*>& laws) {
    std::vector<RelevantPrior> priors;
    if (problem.face.map && problem.face.spectrum_of_map) return priors;
    const std::vector<const Face*> faces = rough_faces(problem);
    for (std::size_t i = 0; i < faces.size(); ++i)
        for (const Prior& prior : faces[i]->priors)
            if (depends_on(problem, laws, *faces[i], prior.which)) priors.push_back({i, &prior});
    return priors;
}

FSTIFF_INLINE std::vector<Alternative> alternatives(const ResolvedJoint& problem, const std::vector<const Law*>& laws) {
    std::vector<Alternative> alternatives;
    for (const auto& [place, prior] : relevant_priors(problem, laws)) {
        const auto variant = [&, i = place, which = prior->which](double value) {
            const Face changed = with_value(*rough_faces(problem)[i], which, value);
            if (problem.faces.empty()) return changed;
            return i == 0 ? sum_of_faces(changed, problem.faces[1]) : sum_of_faces(problem.faces[0], changed);
        };
        alternatives.push_back({prior->which, variant(prior->low), variant(prior->high)});
    }
    return alternatives;
}

}}}  // namespace fstiff::detail
