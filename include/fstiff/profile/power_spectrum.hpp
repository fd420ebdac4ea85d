// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Power spectrum of a profile, and the fractal dimension from it, independent of the structure function.
///
///     C(q_k) = h |Z_k|^2 / (pi sum w_i^2),  Z transform of w_i (z_i - mean),  q_k = 2 pi k/(M h), one-sided
///     ln C = -(5-2D) ln q + const,  D = 2 - H                    for a self-affine profile
///
/// The mean is weighted by the window w; straight lines bridge gaps. Jacobs et al. use pi C. D is the slope of a
/// weighted line through means of C over eighths of an octave.
///
/// Reference   Jacobs, Junge, Pastewka, Surf. Topogr. Metrol. Prop. 5 (2017) 013001; Welch, IEEE Trans. Audio 15 (1967)
///             70; Harris, Proc. IEEE 66 (1978) 51 (windows)
/// Units       q [rad/m], C [m^3], wavelengths [m]
/// Valid       at least 16 points, heights that vary; wavelengths from 2 spacings to the length of the profile
/// Accuracy    Parseval 1e-13; D of fractional Brownian profiles of 4096 points 0.02 in the mean
///             (tests/profile/power_spectrum_test.cpp)

#include <fstiff/math/fft.hpp>
#include <fstiff/profile/structure_function.hpp>
#include <fstiff/surface/spectrum.hpp>

#include <numbers>

namespace fstiff { inline namespace v0_1 {

/// One-sided power spectrum; k = 0 ... M/2.
template <Real T = double>
struct PowerSpectrum {
    std::vector<T> wavenumber;  ///< q [rad/m], from 0 in steps of `step`
    std::vector<T> value;       ///< C [m^3]
    T step{};                   ///< dq [rad/m]
    T independent{};            ///< number of neighbouring values that count as one

    [[nodiscard]] std::size_t size() const { return value.size(); }

    /// Integral of q^\p order C dq: m0, m2, m4 by 0, 2, 4 [m^(2-order)].
    [[nodiscard]] T moment(int order) const {
        math::CompensatedSum<double> sum;
        for (std::size_t k = 0; k < size(); ++k) {
            const T share = k == 0 || k + 1 == size() ? T(0.5) : T(1);
            sum.add(share * value[k] * step * std::pow(wavenumber[k], static_cast<T>(order)));
        }
        return static_cast<T>(sum.value());
    }
};

namespace detail {

/// D of a power spectrum.
template <Real T = double>
struct SpectralFit {
    T dimension{};          ///< D; outside (1, 2) the window holds no self-affine profile
    T dimension_error{};    ///< standard deviation of D for a Gaussian profile
    LengthRange<T> window;  ///< used [m]
    std::size_t bins{};     ///< means of C that the line goes through
};

/// Heights from the first to the last existing point, gaps bridged.
template <Real T>
std::vector<double> bridged(const Profile<T>& profile, T mean, T scale) {
    std::vector<double> heights;
    std::size_t gap = 0;
    for (const T z : profile.heights) {
        if (std::isnan(z)) {
            gap += heights.empty() ? 0 : 1;
            continue;
        }
        const double next = static_cast<double>((z - mean) / scale);
        const double last = heights.empty() ? next : heights.back();
        for (std::size_t k = 1; k <= gap; ++k)
            heights.push_back(last + (next - last) * static_cast<double>(k) / static_cast<double>(gap + 1));
        gap = 0;
        heights.push_back(next);
    }
    return heights;
}

/// Mean of C over an eighth of an octave: mean ln q, ln C without the bias of its logarithm, and its weight.
template <Real F>
struct SpectralBin {
    F x, y, weight;
};

/// Mean of the values \p first to \p end - 1.
template <Real T, Real F = double>
std::vector<SpectralBin<F>> spectral_bins(const PowerSpectrum<T>& spectrum, std::size_t first, std::size_t end) {
    std::vector<SpectralBin<F>> bins;
    for (std::size_t k = first; k < end;) {
        const std::size_t next =
            (std::min)(end, (std::max)(k + 1, static_cast<std::size_t>(static_cast<F>(k) * std::exp2(F(0.125)))));
        F sum = 0, log_q = 0;
        for (std::size_t i = k; i < next; ++i) {
            sum += static_cast<F>(spectrum.value[i]);
            log_q += std::log(static_cast<F>(i));
        }
        const F count = static_cast<F>(next - k);
        if (sum > 0) {
            const F independent = count / static_cast<F>(spectrum.independent), degrees = (std::max)(F(1), independent);
            // mean and variance of the logarithm of a mean of v exponentials: psi(v) - ln v and psi'(v)
            const F low = degrees > F(1) ? 1 / (2 * degrees) + 1 / (12 * degrees * degrees) : F(0.5772156649);
            const F variance = 1 / degrees + 1 / (2 * degrees * degrees) + 1 / (6 * degrees * degrees * degrees);
            bins.push_back({log_q / count, std::log(sum / count) + low, independent / degrees / variance});
        }
        k = next;
    }
    return bins;
}

}  // namespace detail

/// Spectrum of \p profile as it is: remove its form first, with detrend().
/// \throws domain_error for a profile out of range.
template <Real T>
[[nodiscard]] PowerSpectrum<T> power_spectrum(const Profile<T>& profile, SpectrumWindow shape = SpectrumWindow::hann) {
    profile.validate(16);
    const T scale = detail::height_scale(profile);
    std::vector<double> z = detail::bridged(profile, detail::mean_height(profile), scale);
    const std::size_t points = z.size();
    std::vector<double> window(points);
    math::CompensatedSum<double> weight, squares, weighted;
    for (std::size_t i = 0; i < points; ++i) {
        window[i] = detail::window_weight<double>(shape, i, points);
        weight.add(window[i]);
        squares.add(window[i] * window[i]);
        weighted.add(window[i] * z[i]);
    }
    const double mean = weighted.value() / weight.value();
    for (std::size_t i = 0; i < points; ++i) z[i] = window[i] * (z[i] - mean);
    math::RealFft<double> fft(math::fast_fft_size(points));
    std::vector<std::complex<double>> transform;
    fft.forward(z, transform);

    PowerSpectrum<T> spectrum;
    const double h = static_cast<double>(profile.spacing), size = static_cast<double>(fft.size());
    const double factor = h / (std::numbers::pi * squares.value());
    spectrum.step = static_cast<T>(2 * std::numbers::pi / (size * h));
    const double neighbours = shape == SpectrumWindow::hann ? 35.0 / 18 : 1.0;
    spectrum.independent = static_cast<T>(neighbours * size / static_cast<double>(points));
    for (std::size_t k = 0; k < transform.size(); ++k) {
        spectrum.wavenumber.push_back(static_cast<T>(k) * spectrum.step);
        const double relative = k == 0 ? 0.0 : std::norm(transform[k]) * factor;
        const T value = static_cast<T>(relative * static_cast<double>(scale) * static_cast<double>(scale));
        detail::require(value <= (std::numeric_limits<T>::max)(), "power spectrum", value,
                        "finite: these heights are too large");
        spectrum.value.push_back(value);
    }
    return spectrum;
}

namespace detail {

/// D from the slope of \p spectrum over \p window, by default from 16 spacings to an eighth of the length.
/// \throws domain_error for a window that holds fewer than four bins or less than half a decade.
template <Real T>
[[nodiscard]] SpectralFit<T> fit_spectrum(const PowerSpectrum<T>& spectrum,
                                          const std::optional<LengthRange<std::type_identity_t<T>>>& window = {}) {
    if (spectrum.size() < 2) throw domain_error("power spectrum has fewer than 2 values: must have at least 2");
    require_positive("step of the wavenumber", spectrum.step);
    const double turn = 2 * std::numbers::pi, last = static_cast<double>(spectrum.size() - 1);
    const double longest = turn / static_cast<double>(spectrum.step), shortest = longest / last;  // two spacings
    SpectralFit<T> fit;
    fit.window = window ? *window : LengthRange<T>{static_cast<T>(8 * shortest), static_cast<T>(longest / 8)};
    require_positive("window from", fit.window.from);
    require(fit.window.to > fit.window.from && fit.window.to <= (std::numeric_limits<T>::max)(), "window to",
            fit.window.to, "finite and greater than the beginning of the window");

    // bins of an eighth of an octave from the longest wavelength on; the index gives the wavelength longest/k
    const auto first = static_cast<std::size_t>(
        std::clamp(std::ceil(longest / static_cast<double>(fit.window.to) * double(1 - 1e-6)), 1.0, last + 1));
    const auto end = static_cast<std::size_t>(
        std::clamp(std::floor(longest / static_cast<double>(fit.window.from) * double(1 + 1e-6)), 0.0, last) + 1);
    const auto bins = spectral_bins(spectrum, first, end);
    fit.bins = bins.size();
    if (bins.size() < 4 || bins.back().x - bins.front().x < std::log(3.1))
        throw domain_error("window of the power spectrum: holds " + std::to_string(bins.size()) +
                           " bins; must hold at least 4 and half a decade");
    double weights = 0, mean_x = 0, mean_y = 0;
    for (const auto& bin : bins) {
        weights += bin.weight;
        mean_x += bin.weight * bin.x;
        mean_y += bin.weight * bin.y;
    }
    mean_x /= weights;
    mean_y /= weights;
    double moment = 0, product = 0;
    for (const auto& bin : bins) {
        moment += bin.weight * (bin.x - mean_x) * (bin.x - mean_x);
        product += bin.weight * (bin.x - mean_x) * (bin.y - mean_y);
    }
    fit.dimension = static_cast<T>((5 + product / moment) / 2);
    fit.dimension_error = static_cast<T>(1 / std::sqrt(moment) / 2);
    return fit;
}

}  // namespace detail

}}  // namespace fstiff
