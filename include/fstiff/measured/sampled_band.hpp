// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// How far whatever is computed of a surface varies within the errors of that surface: quantiles over surfaces drawn at
/// random.
///
///     x_1 ... x_n  surfaces drawn about the measured one (measured/uncertain_surface)
///     y_k(x_i)     what is computed of each, at the points k of a curve, say
///     band at k    the values below which 5, 50 and 95 % of y_k(x_1) ... y_k(x_n) lie
///
/// All points see the same surfaces, so that the bands of several curves may be compared. A surface of which a point
/// cannot be computed (NaN or infinite) is left out at that point alone, and counted.
///
/// Reference   Hyndman, Fan, Am. Stat. 50 (1996) 361, definition 7 (the quantile); JCGM 101:2008 (errors carried on by
///             sampling)
/// Units       those of what is computed
/// Valid       1 surface at least
/// Accuracy    the 5 and 95 % quantiles of n surfaces are themselves uncertain: by 0.11 standard deviations for n = 400
///             where the values are normal, sqrt(0.05 0.95/n)/0.103 (tests/measured/sampled_band_test.cpp). The same
///             seed gives the same band.

#include <fstiff/core/progress.hpp>
#include <fstiff/math/statistics.hpp>
#include <fstiff/measured/uncertain_surface.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace fstiff::inline v0_1::parts {

/// Quantiles of one value over the errors of a surface.
template <Real T = double>
struct SampledBand {
    T low = 0, median = 0, high = 0;  ///< 5, 50 and 95 %; 0 when no surface gives a value
    std::size_t failed = 0;           ///< surfaces that give no value
};

/// How many surfaces a band is drawn of.
struct BandOptions {
    std::size_t samples = 400;
    std::uint64_t seed = 2014;
    ProgressHook progress{};  ///< called once a surface
};

/// The bands of what \p compute gives, one for each of its values. \p compute takes a surface as SurfaceSampler draws
/// it, an array in the order of Parameter, and returns the values, a container of as many each time.
/// \throws domain_error as SurfaceSampler, for no samples, and whatever \p compute throws.
template <Real T, class Compute>
[[nodiscard]] std::vector<SampledBand<T>> sampled_band(const SurfaceParameters<T>& surface, const Compute& compute,
                                                       const BandOptions& options = {}) {
    require(options.samples >= 1, "samples", options.samples, "at least 1");
    SurfaceSampler<T> draw(surface, options.seed);
    std::vector<std::vector<T>> found;  // by value, surface
    for (std::size_t i = 0; i < options.samples; ++i) {
        if (options.progress) options.progress("surfaces", i, options.samples);
        const auto values = compute(draw());
        if (i == 0) found.resize(values.size());
        if (values.size() != found.size())
            refuse("values of a drawn surface", values.size(), std::to_string(found.size()) + ", as of the first");
        for (std::size_t k = 0; k < found.size(); ++k)
            if (std::isfinite(values[k])) found[k].push_back(values[k]);
    }
    std::vector<SampledBand<T>> bands;
    for (std::vector<T>& values : found) {
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

}  // namespace fstiff::inline v0_1::parts
