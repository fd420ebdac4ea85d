// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Heights of peaks that are not Gaussian: those that were measured, or of a skewness and a kurtosis.
///
///     phi(s) = sum w_i N(s; s_i, b_i^2)         G_n(h) = sum w_i b_i^n F_n((h - s_i)/b_i)/sqrt(2 pi)
///
/// s is the height over sigma. Measured heights have one w, and b = 0.1: the highest of some peaks is known no better.
/// A skewness and a kurtosis are Johnson's curve at steps of 1/64 of its normal number, of which b spans 3/4.
///
/// Reference   surface/bearing_of_core.hpp (Johnson); F_n: math/gaussian_moment.hpp
/// Units       dimensionless
/// Valid       n in {0, 1/2, 1, 3/2}, any h
/// Accuracy    of a skewness and a kurtosis 2e-3 up to the height that one peak of 1000 exceeds, 5e-3 there of bounded
///             heights; 3e-3 of Gaussian ones at h = 4. Of 2000 measured heights the mean of (s - h)^n over them within
///             2 % at h = 1 and 5 % at h = 2
///             (tests/peaks/peak_heights_test.cpp)

#include <fstiff/core/error.hpp>
#include <fstiff/math/gaussian_moment.hpp>
#include <fstiff/math/normal_distribution.hpp>
#include <fstiff/surface/bearing_of_core.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

namespace fstiff { inline namespace v0_1 {

/// Heights of peaks as a sum of narrow Gaussians. Threads may share one.
template <Real T = double>
class PeakHeights {
public:
    /// \p heights [m] over the mean plane, of any sign, two at least, of a surface of \p rms_height [m].
    /// \throws domain_error for fewer, for one that is not finite, and where all are the same.
    [[nodiscard]] static PeakHeights measured(std::span<const T> heights, std::type_identity_t<T> rms_height) {
        detail::require_positive("rms_height", rms_height);
        detail::require(heights.size() >= 2, "peak_heights", heights.size(), "2 heights at least");
        PeakHeights made;
        for (const T height : heights) {
            detail::require(std::isfinite(height), "peak_heights", height, "finite");
            made.parts_.push_back({height / rms_height, T(0.1), 1 / static_cast<T>(heights.size())});
        }
        made.sort();
        return made;
    }
    /// Mean 0 and rms 1. \throws domain_error as bearing_of_moments.
    [[nodiscard]] static PeakHeights of_moments(T skewness, T kurtosis) {
        const MaterialRatioSlope<T> curve = detail::bearing_of_moments<T>(skewness, kurtosis);
        constexpr T step = T(1) / 64;
        PeakHeights made;
        T variance = 0, total = 0;
        for (int i = -512; i <= 512; ++i) {
            const T z = step * T(i), b = (std::max)(T(0.75) * step * curve.slope(z, step), T(1e-4));
            const T share = math::normal_density(z) * step;
            made.parts_.push_back({curve.height(z), b, share});
            variance += share * b * b, total += share;
        }
        const T scale = 1 / std::sqrt(1 + variance);  // of the Gaussians themselves
        for (Part& part : made.parts_) part.height *= scale, part.width *= scale, part.share /= total;
        made.sort();
        return made;
    }

    /// G_n(h) = first * exp(second), n = TwiceN/2; second is one for all n.
    template <int TwiceN>
    [[nodiscard]] std::pair<T, T> scaled_moment(T h) const {
        const T reach = 12;  // beyond it a Gaussian adds less than rounding
        T log_scale = -std::numeric_limits<T>::infinity();
        for (const Part& part : parts_) {
            const T x = (h - part.height) / part.width;
            log_scale = (std::max)(log_scale, x > 0 ? -x * x / 2 : T(0));
            if (log_scale == 0) break;
        }
        T sum = 0;
        for (const Part& part : parts_) {
            const T x = (h - part.height) / part.width, log_of = x > 0 ? -x * x / 2 : T(0);
            if (log_of - log_scale < -reach * reach / 2) continue;
            sum += part.share * std::pow(part.width, T(TwiceN) / 2) * math::scaled_moment<TwiceN>(x) *
                   std::exp(log_of - log_scale);
        }
        return {sum * std::numbers::inv_sqrtpi_v<T> / std::numbers::sqrt2_v<T>, log_scale};
    }
    [[nodiscard]] T density(T s) const {
        T sum = 0;
        for (const Part& part : parts_)
            sum += part.share / part.width * math::normal_density((s - part.height) / part.width);
        return sum;
    }
    /// Beyond which G_n underflows.
    [[nodiscard]] T most() const { return parts_.front().height + 37 * parts_.front().width; }

private:
    struct Part {
        T height, width, share;
    };
    void sort() {
        std::sort(parts_.begin(), parts_.end(), [](const Part& a, const Part& b) { return a.height > b.height; });
        detail::require(parts_.front().height > parts_.back().height, "peak_heights", parts_.front().height,
                        "of more than one height");
    }
    std::vector<Part> parts_;  ///< from the highest on
};

}}  // namespace fstiff
