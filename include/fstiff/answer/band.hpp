// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Quantiles of a computed quantity over the errors of a surface, from surfaces drawn at random.
///
///     x_1 ... x_n  surfaces drawn about the measured one (measure/uncertain_surface)
///     y_k(x_i)     quantity computed for each, for example at the points k of a curve
///     band at k    5, 50 and 95 % quantiles of y_k(x_1) ... y_k(x_n)
///
/// All points use the same surfaces, so that bands of several curves are comparable. A NaN or infinite y_k is left out
/// at point k alone, and counted.
/// Reference   Hyndman, Fan, Am. Stat. 50 (1996) 361, definition 7 (quantile); JCGM 101:2008 (sampling of errors)
/// Units       those of the computed quantity
/// Valid       at least 1 surface
/// Accuracy    5 and 95 % quantiles: 0.11 standard deviations for n = 400 normal values, sqrt(0.05 0.95/n)/0.103
///             (tests/answer/sampled_band_test.cpp); the same seed gives the same band

#include <fstiff/core/parallel.hpp>
#include <fstiff/math/random.hpp>
#include <fstiff/math/statistics.hpp>
#include <fstiff/measure/uncertain_surface.hpp>
#include <fstiff/surface/process_prior.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// Quantiles of one value over the errors of a surface.
template <Real T = double>
struct SampledBand {
    T low = 0, median = 0, high = 0;  ///< 5, 50 and 95 %; 0 when no surface gives a value
    std::size_t failed = 0;           ///< surfaces that give no value
};

/// Number of surfaces of a band, and their seed.
struct BandOptions {
    std::size_t samples = 400;
    std::uint64_t seed = 2014;
    ProgressHook progress{};  ///< called once a surface, without threads
    ParallelHook parallel{};  ///< of which each surface is a piece
};

/// Computes the bands of the values of \p compute, one for each. \p compute takes a surface as drawn by SurfaceSampler,
/// an array in the order of Parameter, and its number, and returns a vector of values of constant size.
/// \throws domain_error as SurfaceSampler, for 0 samples, and any exception of \p compute.
template <Real T, class Compute>
[[nodiscard]] std::vector<SampledBand<T>> sampled_band(const SurfaceParameters<T>& surface, const Compute& compute,
                                                       const BandOptions& options = {}) {
    require(options.samples >= 1, "samples", options.samples, "at least 1");
    SurfaceSampler<T> draw(surface, options.seed);
    std::vector<std::array<T, surface_parameter_count>> drawn;
    for (std::size_t i = 0; i < options.samples; ++i) drawn.push_back(draw());
    std::vector<std::vector<T>> outcomes(options.samples);  // by surface, value
    run_pieces(options.parallel, options.samples, [&](std::size_t i) {
        if (options.progress && !options.parallel) options.progress("surfaces", i, options.samples);
        outcomes[i] = compute(drawn[i], i);
    });
    const std::size_t count = outcomes.front().size();
    for (const std::vector<T>& values : outcomes)
        if (values.size() != count)
            refuse("values of a drawn surface", values.size(), std::to_string(count) + ", as of the first");
    std::vector<SampledBand<T>> bands;
    for (std::size_t k = 0; k < count; ++k) {
        std::vector<T> values;
        for (const std::vector<T>& of_surface : outcomes)
            if (std::isfinite(of_surface[k])) values.push_back(of_surface[k]);
        SampledBand<T> band;
        band.failed = options.samples - values.size();
        if (!values.empty()) {
            std::sort(values.begin(), values.end());
            const std::span<const T> sorted(values);
            band.low = math::sorted_quantile(sorted, T(0.05));
            band.median = math::sorted_quantile(sorted, T(0.5));
            band.high = math::sorted_quantile(sorted, T(0.95));
        }
        bands.push_back(band);
    }
    return bands;
}

}}}  // namespace fstiff::detail
