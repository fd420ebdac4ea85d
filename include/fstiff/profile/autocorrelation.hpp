// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Autocorrelation function of a profile, and the length within which it falls to a fifth.
///
///     A(n h) = <z_i z_(i+n)>/<z^2>   z about the mean of all points; <z_i z_(i+n)> over the pairs of points that exist
///     Ral    = the shortest lag at which A has fallen to s = 0.2, on straight lines between the lags
///
/// Means by pairs are not biased towards 0 at long lags, but scatter there: lags above half the length are left out.
///
/// Reference   ISO 21920-2:2021 (autocorrelation function, Ral), ISO 21920-3:2021 (s = 0.2)
/// Units       lag, Ral [m], A dimensionless
/// Valid       16 to 2^29 points, not all of one height; remove the form first
/// Accuracy    1e-13 of A(0) = 1 (tests/profile/autocorrelation_test.cpp)

#include <fstiff/profile/roughness_parameters.hpp>

#include <optional>

namespace fstiff { inline namespace v0_1 {

/// Autocorrelation of a profile at every lag.
template <Real T = double>
struct Autocorrelation {
    std::vector<T> lag;              ///< 0, h, 2h ... to half the length [m]
    std::vector<T> value;            ///< A; NaN at a lag without a pair
    std::vector<std::size_t> pairs;  ///< of points that exist

    [[nodiscard]] std::size_t size() const { return value.size(); }
};

/// Autocorrelation of \p profile. \throws domain_error for a profile out of range.
template <Real T>
[[nodiscard]] Autocorrelation<T> autocorrelation(const Profile<T>& profile) {
    profile.validate(16);
    const std::size_t size = profile.size(), lags = size / 2;
    if (size > std::size_t{1} << 29)
        throw domain_error("profile has " + std::to_string(size) + " points: must be at most 2^29");
    const T mean = detail::mean_height(profile), unit = math::power_of_two_below(rms_height(profile));
    std::vector<double> z(size), mask(size, 1.0);
    for (std::size_t i = 0; i < size; ++i) {
        if (std::isnan(profile.heights[i])) mask[i] = 0;
        z[i] = mask[i] > 0 ? static_cast<double>((profile.heights[i] - mean) / unit) : 0.0;
    }
    math::RealFft<double> fft(math::fast_fft_size(size + lags));
    const auto correlate = [&](std::vector<double>& data) {
        std::vector<std::complex<double>> spectrum;
        fft.forward(data, spectrum);
        for (auto& wave : spectrum) wave = std::norm(wave);
        fft.inverse(spectrum, data);
    };
    const bool complete = profile.present() == size;
    correlate(z);
    if (!complete) correlate(mask);
    Autocorrelation<T> result;
    const double variance = z[0] / static_cast<double>(profile.present());
    for (std::size_t n = 0; n <= lags; ++n) {
        const double pairs = complete ? static_cast<double>(size - n) : std::round(mask[n]);
        result.lag.push_back(static_cast<T>(n) * profile.spacing);
        result.value.push_back(pairs > 0 ? static_cast<T>(z[n] / pairs / variance)
                                         : std::numeric_limits<T>::quiet_NaN());
        result.pairs.push_back(static_cast<std::size_t>(pairs));
    }
    return result;
}

namespace detail {

/// Ral: lag at which \p correlation first falls to \p threshold [m]; none where it stays above it, or where a lag
/// before has no pair. \throws domain_error unless 0 < threshold < 1.
template <Real T>
[[nodiscard]] std::optional<T> autocorrelation_length(const Autocorrelation<T>& correlation,
                                                      std::type_identity_t<T> threshold = T(0.2)) {
    require(threshold > 0 && threshold < 1, "threshold of an autocorrelation", threshold, "between 0 and 1");
    for (std::size_t n = 1; n < correlation.size(); ++n) {
        const T before = correlation.value[n - 1], current = correlation.value[n];
        if (std::isnan(current)) return {};
        if (current <= threshold)
            return correlation.lag[n - 1] +
                   (correlation.lag[n] - correlation.lag[n - 1]) * ((before - threshold) / (before - current));
    }
    return {};
}

}  // namespace detail

}}  // namespace fstiff
