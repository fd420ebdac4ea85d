// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Texture direction Std of a map: the direction in which its angular power spectrum is greatest.
///
///     f(s) = int r |F(-r sin s, r cos s)|^2 dr       F(p, q), p along x, q along y: the waves with ridges along s
///     Std  = direction of the greatest f(s), from x towards y
///
/// |F|^2 is the transform of the autocorrelation, which takes missing points and edges into account, times Hann's
/// window over its lags. f is the sum over 720 directions of half a turn, smoothed by a cosine squared of half-width 20
/// degrees: the directions of few waves are far apart. A parabola through the greatest of them gives Std.
///
/// Reference   ISO 25178-2:2021 (fAPS, Std)
/// Units       radians, 0 <= Std < pi
/// Valid       as areal_autocorrelation()
/// Accuracy    0.2 degrees for ridges of 6 waves and more across the map, 5 for 3 waves; lays that cross at less than
///             20 degrees are one (tests/topography/texture_direction_test.cpp)

#include <fstiff/topography/areal_autocorrelation.hpp>

#include <array>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// Power over the directions of half a turn.
template <Real T>
class AngularSpectrum {
public:
    /// Adds \p power of the waves of x, y, whose ridges are perpendicular, to the two directions next to theirs.
    void add(T x, T y, T power) {
        const T place = std::atan2(x, -y) / std::numbers::pi_v<T> * directions, whole = std::floor(place);
        at(static_cast<int>(whole)) += power * (whole + 1 - place);
        at(static_cast<int>(whole) + 1) += power * (place - whole);
    }
    /// Direction of the greatest power, in [0, pi); none where there is no power.
    [[nodiscard]] std::optional<T> greatest() {
        std::array<T, directions> smooth{};
        for (int k = 0; k < directions; ++k)
            for (int i = -reach; i <= reach; ++i) {
                const T weight = std::cos(std::numbers::pi_v<T> / 2 * static_cast<T>(i) / (reach + 1));
                smooth[static_cast<std::size_t>(k)] += weight * weight * at(k + i);
            }
        std::swap(power_, smooth);
        const auto peak = static_cast<int>(std::max_element(power_.begin(), power_.end()) - power_.begin());
        const T before = at(peak - 1), most = at(peak), after = at(peak + 1);
        std::swap(power_, smooth);
        if (!(most > 0)) return {};
        const T bend = before - 2 * most + after, turn = bend < 0 ? (before - after) / bend / 2 : T(0);
        const T place = std::fmod(static_cast<T>(peak) + turn + directions, static_cast<T>(directions));
        return place / directions * std::numbers::pi_v<T>;
    }

private:
    static constexpr int directions = 720, reach = 80;  // a direction is a quarter of a degree
    T& at(int k) { return power_[static_cast<std::size_t>((k % directions + directions) % directions)]; }

    std::array<T, directions> power_{};
};

/// Std of the map with this \p correlation [rad]; none where it has no power.
template <Real T>
[[nodiscard]] std::optional<T> texture_direction(const ArealAutocorrelation<T>& correlation) {
    using Index = Eigen::Index;
    using Complex = std::complex<T>;
    const auto size = [](Index reach) { return math::fast_fft_size(static_cast<std::size_t>(2 * reach + 1)); };
    const std::size_t width = size(correlation.reach_x), height = size(correlation.reach_y), half = width / 2;
    const auto hann = [](Index lag, Index reach) {
        const T c = std::cos(std::numbers::pi_v<T> / 2 * static_cast<T>(lag) / static_cast<T>(reach + 1));
        return c * c;
    };
    math::RealFft<T> along_x(width);
    math::ComplexFft<T> along_y(height);
    std::vector<Complex> waves((half + 1) * height), in(height), out;  // one column after the other
    std::vector<T> line(width);
    for (Index j = -correlation.reach_y; j <= correlation.reach_y; ++j) {
        for (Index i = -correlation.reach_x; i <= correlation.reach_x; ++i) {
            const T value = correlation.at(i, j) * hann(i, correlation.reach_x) * hann(j, correlation.reach_y);
            line[static_cast<std::size_t>(i < 0 ? i + static_cast<Index>(width) : i)] =
                std::isnan(value) ? T(0) : value;
        }
        along_x.forward(line, out);
        const auto row = static_cast<std::size_t>(j < 0 ? j + static_cast<Index>(height) : j);
        for (std::size_t i = 0; i <= half; ++i) waves[i * height + row] = out[i];
    }
    // wave numbers over those of the longer step, so that squares stay within the range of numbers
    const T step = (std::max)(correlation.dx, correlation.dy);
    const T unit_x = step / correlation.dx / static_cast<T>(width),
            unit_y = step / correlation.dy / static_cast<T>(height);
    AngularSpectrum<T> spectrum;
    for (std::size_t i = 0; i <= half; ++i) {
        std::copy_n(waves.begin() + static_cast<std::ptrdiff_t>(i * height), height, in.begin());
        along_y.forward(in, out);
        for (std::size_t j = 0; j < height; ++j) {
            const T up = j <= height / 2 ? static_cast<T>(j) : static_cast<T>(j) - static_cast<T>(height);
            if (i == 0 && !(up > 0)) continue;  // the mean, and the other half of the turn
            if (const T power = out[j].real(); power > 0) spectrum.add(static_cast<T>(i) * unit_x, up * unit_y, power);
        }
    }
    return spectrum.greatest();
}

}}}  // namespace fstiff::detail
