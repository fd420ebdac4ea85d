// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Waviness and roughness of a profile by the Gaussian filter and by the robust one, which ignores grooves and spikes.
///
///     w_i = sum_k s((i-k) h) z_k / sum_k s((i-k) h),   s(x) = exp(-pi (x/(g c))^2),  g = 0.4697              cut-off c
///     a sine of wavelength l passes into the waviness by exp(-pi (g c/l)^2): 50 % at l = c
///     robust: w_i = b_0 of minimum over b of sum_k s(x) delta_k (z_k - b_0 - b_1 x - b_2 x^2)^2,  x = x_k - x_i
///
/// Sums over the existing points keep a constant at the ends and at gaps, but not a tilt: remove the line first. delta
/// are Tukey's weights (math/tukey). Order 0 has b_0 alone; order 2 (g = 0.7309) follows a parabola. A point keeps its
/// first waviness where less than 1 % (order 2: 5 %) of the Gaussian weight is left. A missing point stays missing.
/// Reference   ISO 16610-21:2011, 4.2-4.3; ISO 16610-28:2016 (ends); ISO 16610-31:2016 (robust)
/// Units       heights, cut-off [m]
/// Valid       5 spacings (low pass 2) <= cut-off <= length of the profile; more than half of the points are surface
/// Accuracy    transmission 1e-6 for a cut-off of 5 spacings, 1e-13 from 10 on; robust 1e-10 of the rms height
///             (tests/profile/gaussian_filter_test.cpp, tests/profile/robust_gaussian_filter_test.cpp)

#include <fstiff/math/fft.hpp>
#include <fstiff/math/gaussian_smoother.hpp>
#include <fstiff/math/rounding.hpp>
#include <fstiff/math/tukey.hpp>
#include <fstiff/profile/profile.hpp>
#include <fstiff/profile/structure_function.hpp>

#include <numbers>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// Weighted means of the head of this file, for a cut-off of at least \p least spacings.
template <Real T>
Profile<T> gaussian_means(const Profile<T>& profile, T cutoff, int least) {
    require_positive("spacing", profile.spacing);
    // a cut-off of exactly so many spacings is valid, whatever its rounding
    if (!(cutoff >= static_cast<T>(least) * profile.spacing * (1 - 4 * std::numeric_limits<T>::epsilon()) &&
          cutoff <= profile.length()))
        refuse("cut-off", cutoff,
               "at least " + std::to_string(least) + " spacings and at most the length of the profile");
    const T scale = height_scale(profile);
    const T mean = mean_height(profile);
    const std::size_t size = profile.size();
    math::GaussianSmoother<double> smooth(size, static_cast<double>(cutoff) / static_cast<double>(profile.spacing));
    std::vector<double> heights(size), mask(size);
    for (std::size_t i = 0; i < size; ++i) {
        const bool exists = !std::isnan(profile.heights[i]);
        heights[i] = exists ? static_cast<double>((profile.heights[i] - mean) / scale) : 0.0;
        mask[i] = exists ? 1.0 : 0.0;
    }
    smooth(heights);
    smooth(mask);
    Profile<T> means = profile;
    for (std::size_t i = 0; i < size; ++i)  // the weight of the point itself keeps the divisor from 0
        if (!std::isnan(profile.heights[i])) means.heights[i] = static_cast<T>(heights[i] / mask[i]) * scale + mean;
    return means;
}

/// Long waves of \p profile. \throws domain_error for a cut-off or a profile out of range.
template <Real T>
[[nodiscard]] Profile<T> gaussian_waviness(const Profile<T>& profile, T cutoff) {
    return gaussian_means(profile, cutoff, 5);
}

/// \p profile without its long waves. \throws domain_error as above.
template <Real T>
[[nodiscard]] Profile<T> gaussian_roughness(const Profile<T>& profile, T cutoff) {
    Profile<T> roughness = gaussian_waviness(profile, cutoff);
    for (std::size_t i = 0; i < profile.size(); ++i) roughness.heights[i] = profile.heights[i] - roughness.heights[i];
    return roughness;
}

/// \p profile without its short waves: the same sums, for a cut-off of at least two spacings. Below five spacings there
/// are few weights, and waves shorter than twice the cut-off pass better than in the closed form.
/// \throws domain_error as above.
template <Real T>
[[nodiscard]] Profile<T> gaussian_low_pass(const Profile<T>& profile, T cutoff) {
    return gaussian_means(profile, cutoff, 2);
}

/// g of the file's head: exp(-t) = 1/2 and (1 + t) exp(-t) = 1/2 for t = pi g^2.
template <Real T>
inline constexpr T robust_width[2] = {T(0.469718639349825667L), T(0.730913428094675868L)};
/// Minimum share of the Gaussian weight.
inline constexpr double robust_share[2] = {0.01, 0.05};

/// Sums sum_k s(k-i) (k-i)^n v_k for n = 0 ... 2 order, with lengths in units of g c, by transforms.
template <Real F>
class RegressionSums {
public:
    RegressionSums(std::size_t size, F width, int order)
        : size_(size),
          order_(order),
          reach_(reach(size, width * robust_width<F>[order / 2])),
          fft_(math::fast_fft_size(size + reach_)) {
        const F unit = width * robust_width<F>[order / 2];
        shapes_.resize(2 * static_cast<std::size_t>(order) + 1);
        std::vector<F> kernel(fft_.size());
        for (std::size_t n = 0; n < shapes_.size(); ++n) {
            for (std::size_t k = 0; k <= reach_; ++k) {
                const F x = static_cast<F>(k) / unit;
                const F value = std::exp(-std::numbers::pi_v<F> * x * x) * std::pow(x, static_cast<F>(n));
                kernel[k] = n % 2 == 0 ? value : -value;  // the sum runs over i + x: the kernel is turned round
                if (k > 0) kernel[fft_.size() - k] = value;
            }
            fft_.forward(kernel, shapes_[n]);
        }
    }

    /// First \p count sums of \p values.
    void operator()(const std::vector<F>& values, std::size_t count, std::vector<std::vector<F>>& sums) {
        fft_.forward(values, spectrum_);
        sums.resize(count);
        for (std::size_t n = 0; n < count; ++n) {
            product_ = spectrum_;
            for (std::size_t k = 0; k < product_.size(); ++k) product_[k] *= shapes_[n][k];
            fft_.inverse(product_, sums[n]);
            sums[n].resize(size_);
        }
    }
    [[nodiscard]] int order() const { return order_; }

private:
    static std::size_t reach(std::size_t size, F unit) {  // to 1e-17
        const F last = F(3.54) * unit;
        return last >= static_cast<F>(size - 1) ? size - 1 : (std::min)(size - 1, static_cast<std::size_t>(last) + 1);
    }

    std::size_t size_;
    int order_;
    std::size_t reach_;
    math::RealFft<F> fft_;
    std::vector<std::vector<std::complex<F>>> shapes_;
    std::vector<std::complex<F>> spectrum_, product_;
};

/// Solution b_0 of the normal equations with the sums s of the weights and t of the weighted heights.
template <Real F>
F regression_value(const std::vector<std::vector<F>>& s, const std::vector<std::vector<F>>& t, std::size_t i) {
    if (t.size() == 1) return t[0][i] / s[0][i];
    const F a = s[2][i] * s[4][i] - s[3][i] * s[3][i], b = s[2][i] * s[3][i] - s[1][i] * s[4][i],
            c = s[1][i] * s[3][i] - s[2][i] * s[2][i];
    return (a * t[0][i] + b * t[1][i] + c * t[2][i]) / (a * s[0][i] + b * s[1][i] + c * s[2][i]);
}

/// Long waves of \p profile. \throws domain_error for a cut-off, an order or a profile out of range.
template <Real T>
[[nodiscard]] math::RobustWaviness<Profile<T>> robust_waviness(const Profile<T>& profile, T cutoff, int order = 2) {
    require_positive("spacing", profile.spacing);
    require(order == 0 || order == 2, "order", order, "0 or 2");
    require(cutoff >= 5 * profile.spacing * (1 - 4 * std::numeric_limits<T>::epsilon()) && cutoff <= profile.length(),
            "cut-off", cutoff, "at least 5 spacings and at most the length of the profile");
    const T scale = height_scale(profile), mean = mean_height(profile);
    const std::size_t size = profile.size(), terms = static_cast<std::size_t>(order) + 1;
    RegressionSums<double> regression(size, static_cast<double>(cutoff) / static_cast<double>(profile.spacing), order);
    std::vector<std::vector<double>> s, t;
    const auto exists = [&](std::size_t i) { return !std::isnan(profile.heights[i]); };
    std::vector<double> heights(size);
    for (std::size_t i = 0; i < size; ++i)
        if (exists(i)) heights[i] = static_cast<double>((profile.heights[i] - mean) / scale);
    const auto sum = [&](const std::vector<double>& weights, const std::vector<double>& weighted) {
        regression(weights, 2 * terms - 1, s);
        regression(weighted, terms, t);
    };
    const auto means = math::robust_means(
        heights, static_cast<double>(robust_share[order / 2]), exists, sum, [&](std::size_t i) { return s[0][i]; },
        [&](std::size_t i) { return regression_value(s, t, i); });
    math::RobustWaviness<Profile<T>> result{profile, means.left_out, means.iterations, means.converged};
    for (std::size_t i = 0; i < size; ++i)
        if (exists(i)) result.waviness.heights[i] = static_cast<T>(means.waviness[i]) * scale + mean;
    return result;
}

}}}  // namespace fstiff::detail
