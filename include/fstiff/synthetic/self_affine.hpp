// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Self-affine Gaussian profiles and maps: sums of waves with random amplitudes, periodic.
///
///     z(x) = Re sum_k A_k (xi_k + i eta_k) exp(2 pi i q_k . x),   xi, eta standard normal, independent
///     A_k^2 = rms^2 w(|q_k|) / sum w                              one wave of each pair (q, -q), q in waves per length
///     w(q)  = max(q, 1/longest)^-(2H+1) of a profile, ^-(2H+2) of a map; 0 for q > 1/shortest
///
/// A section of the map is a profile of the same H, D = 2 - H. The random numbers of a wave depend on the seed and its
/// waves per period alone: a finer grid over the same period has the same long waves.
///
/// Reference   Box, Muller, Ann. Math. Stat. 29 (1958); Jacobs, Junge, Pastewka, Surf. Topogr. 5 (2017) 013001
/// Units       lengths, heights [m]
/// Valid       0 < H < 1, rms > 0, longest > shortest >= two spacings, 4 points a side at least, 2^28 at most
/// Accuracy    sum of waves 1e-14 of rms in double (tests/synthetic/self_affine_test.cpp)

#include <fstiff/core/error.hpp>
#include <fstiff/core/names.hpp>
#include <fstiff/math/fft.hpp>
#include <fstiff/math/random.hpp>
#include <fstiff/math/rounding.hpp>
#include <fstiff/math/statistics.hpp>
#include <fstiff/profile/profile.hpp>
#include <fstiff/topography/height_map.hpp>

namespace fstiff { inline namespace v0_1 {

/// Waves beyond the longest wavelength: as strong as the longest one, or none.
enum class LongWaves { plateau, none };

template <>
inline constexpr auto enum_names<LongWaves> = detail::name_list<LongWaves>({{LongWaves::plateau, "plateau"},
                                                                            {LongWaves::none, "none"}});

/// Parameters of a self-affine surface.
template <Real T = double>
struct SelfAffineOptions {
    T hurst{};                ///< H
    T rms{};                  ///< [m]
    T longest_wavelength{};   ///< roll-off of the spectrum [m]; 0: the longest side
    T shortest_wavelength{};  ///< no wave is shorter [m]; 0: two samples, of the larger spacing
    LongWaves long_waves = LongWaves::plateau;
    bool exact_rms = true;  ///< rms of the realisation, not of the mean over all seeds
    std::uint64_t seed = 1;
};

namespace detail {

/// Two standard normal numbers of the wave with \p kx and \p ky periods.
template <Real T>
std::complex<T> normals_of_wave(std::uint64_t seed, std::int32_t kx, std::int32_t ky) {
    std::uint64_t state = seed;
    state = math::splitmix64(state) ^
            (static_cast<std::uint64_t>(static_cast<std::uint32_t>(ky)) << 32 | static_cast<std::uint32_t>(kx));
    return math::normal_pair<T>(state);
}

template <Real W>
using WaveField = Eigen::Array<std::complex<W>, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Real part of the sum of \p waves; rows from \p rows on are 0.
template <Real W>
Eigen::Array<W, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> heights_of_waves(WaveField<W> waves,
                                                                                  Eigen::Index rows) {
    std::vector<std::complex<W>> in, out;
    math::ComplexFft<W> along_x(static_cast<std::size_t>(waves.cols()));
    for (Eigen::Index j = 0; j < rows; ++j) {
        in.assign(waves.row(j).begin(), waves.row(j).end());
        along_x.backward(in, out);
        std::copy(out.begin(), out.end(), waves.row(j).begin());
    }
    if (waves.rows() == 1) return waves.real();
    Eigen::Array<W, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> heights(waves.rows(), waves.cols());
    math::ComplexFft<W> along_y(static_cast<std::size_t>(waves.rows()));
    for (Eigen::Index i = 0; i < waves.cols(); ++i) {
        in.assign(waves.col(i).begin(), waves.col(i).end());
        along_y.backward(in, out);
        for (Eigen::Index j = 0; j < waves.rows(); ++j) heights(j, i) = out[static_cast<std::size_t>(j)].real();
    }
    return heights;
}

/// One period of waves on rows x columns points; \p rows = 1 is a profile. Computed in double for float.
template <Real T>
HeightMap<T> self_affine(const SelfAffineOptions<T>& options, std::size_t columns, std::size_t rows, T dx, T dy) {
    using Index = Eigen::Index;
    require(options.hurst > T(0) && options.hurst < T(1), "hurst", options.hurst, "between 0 and 1, both excluded");
    require_positive("rms", options.rms);
    const bool map = rows > 1;
    constexpr std::size_t max_points = std::size_t(1) << 28;
    for (const std::size_t points : {columns, map ? rows : columns})
        require(points >= 4 && points <= max_points, "points of a side", points, "between 4 and 2^28");
    if (columns > max_points / rows)
        refuse("points", std::to_string(columns) + " x " + std::to_string(rows), "at most 2^28");
    const double period_x = static_cast<double>(columns) * dx, period_y = map ? static_cast<double>(rows) * dy : 0.0;
    const double side = (std::max)(period_x, period_y), step = map ? (std::max)(dx, dy) : dx;
    const double longest = options.longest_wavelength == T(0) ? side : static_cast<double>(options.longest_wavelength);
    const double shortest =
        options.shortest_wavelength == T(0) ? 2 * step : static_cast<double>(options.shortest_wavelength);
    const double slack =
        1 + 16 * static_cast<double>(std::numeric_limits<T>::epsilon());  // a cut-off that was computed
    require(shortest * slack >= 2 * step && shortest <= side, "shortest_wavelength", options.shortest_wavelength,
            "between two spacings and the side of the surface, or 0");
    require(longest > shortest && longest <= static_cast<double>((std::numeric_limits<T>::max)()), "longest_wavelength",
            options.longest_wavelength, "finite and greater than the shortest wavelength, or 0");

    // half of the waves: ky > 0, or ky = 0 and kx > 0; the wave at two samples itself has no phase, and is left out
    const auto half_x = static_cast<std::int32_t>((columns - 1) / 2);
    const auto half_y = static_cast<std::int32_t>(map ? (rows - 1) / 2 : 0);
    const double power = -(map ? 2 * options.hurst + 2 : 2 * options.hurst + 1);
    const auto weight = [&](std::int32_t kx, std::int32_t ky) -> double {  // q in units of 1/longest
        const double q = std::hypot(static_cast<double>(kx) * (longest / period_x),
                                    map ? static_cast<double>(ky) * (longest / period_y) : 0.0);
        if (q * shortest > longest * slack || (q * slack < 1 && options.long_waves == LongWaves::none)) return 0;
        return std::pow((std::max)(q, 1.0), power);
    };
    WaveField<double> waves = WaveField<double>::Zero(static_cast<Index>(rows), static_cast<Index>(columns));
    double total = 0;
    for (std::int32_t ky = half_y; ky >= 0; --ky) {
        double row_total = 0;
        for (std::int32_t kx = ky > 0 ? -half_x : 1; kx <= half_x; ++kx) {
            const double w = weight(kx, ky);
            if (w == 0.0) continue;
            row_total += w;
            waves(ky, kx < 0 ? static_cast<Index>(columns) + kx : kx) =
                std::sqrt(w) * normals_of_wave<double>(options.seed, kx, ky);
        }
        total += row_total;
    }
    require(total > 0.0, "longest_wavelength", options.longest_wavelength,
            "so far above the shortest that a whole wave of the period lies between them");

    const auto heights = heights_of_waves(std::move(waves), half_y + 1);
    double square = total;
    if (options.exact_rms) {
        square = 0;
        for (Index j = 0; j < heights.rows(); ++j) square += heights.row(j).square().mean();
        square /= static_cast<double>(rows);
    }
    return {(heights * (static_cast<double>(options.rms) / std::sqrt(square))).template cast<T>(), dx, dy};
}

}  // namespace detail

/// z at x = 0, spacing, ...: one period of points * spacing [m].
/// \throws domain_error naming the parameter that is out of range, or when no wave fits between the cut-offs.
template <Real T>
[[nodiscard]] Profile<T> self_affine_profile(const SelfAffineOptions<T>& options, std::size_t points, T spacing) {
    detail::require_positive("spacing", spacing);
    const HeightMap<T> row = detail::self_affine(options, points, 1, spacing, spacing);
    return {{row.heights.data(), row.heights.data() + row.size()}, spacing};
}

/// z(j, i) at x = i dx, y = j dy: one period of columns * dx by rows * dy [m]. \throws domain_error as above.
template <Real T>
[[nodiscard]] HeightMap<T> self_affine_map(const SelfAffineOptions<T>& options, std::size_t columns, std::size_t rows,
                                           T dx, T dy) {
    detail::require_positive("dx", dx);
    detail::require_positive("dy", dy);
    detail::require(rows >= 4, "points of a side", rows, "between 4 and 2^28");
    return detail::self_affine(options, columns, rows, dx, dy);
}

}}  // namespace fstiff
