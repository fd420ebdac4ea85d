// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Power spectral densities of a map: averaged over the directions, and of its sections along x and y.
///
///     C(q)   = L_x L_y/(2 pi)^2 <|h_q|^2>                 over the waves of a shell;  sigma^2 = 2 pi int q C dq
///     C_x(q) = L_x/pi sum over q_y of |h_(q, q_y)|^2      one-sided, as that of a profile; C_y likewise
///     C_x(q) = 4 int_q^inf C(q') q'/sqrt(q'^2 - q^2) dq'  of an isotropic surface
///
/// h_q are the waves of the heights about their mean times the window over its rms: a picture, since the window weighs
/// sigma. Shells (topography/map_spectrum) end at the shortest wave of the coarser side. Jacobs et al.: (2 pi)^2 C, pi
/// C_x.
///
/// Reference   Nayak, J. Lubr. Technol. 93 (1971) 398; Persson et al., J. Phys. Condens. Matter 17 (2005) R1; Jacobs,
///             Junge, Pastewka, Surf. Topogr.: Metrol. Prop. 5 (2017) 013001
/// Units       q [rad/m], C [m^4], C_x and C_y [m^3]
/// Valid       maps of 4 x 4 points at least, without missing points; remove the form first
/// Accuracy    1e-12 relative of each shell of a sum of waves (tests/topography/radial_spectrum_test.cpp)

#include <fstiff/surface/spectrum_window.hpp>
#include <fstiff/topography/map_spectrum.hpp>

#include <limits>

namespace fstiff {

/// One-sided spectrum of the sections of a map along one axis.
template <Real T = double>
struct SectionSpectrum {
    std::vector<T> wavenumber;  ///< 1, 2, ... times the step, to the shortest wave [rad/m]
    std::vector<T> value;       ///< [m^3]
    T step{};                   ///< [rad/m]
    bool halved{};              ///< whether the last value counts half in an integral: the number of points is even

    /// int C dq [m^2].
    [[nodiscard]] T integral() const {
        T sum = 0;
        for (std::size_t k = 0; k < value.size(); ++k) sum += halved && k + 1 == value.size() ? value[k] / 2 : value[k];
        return sum * step;
    }
};

/// The power spectrum of a map over all directions, and of its sections.
template <Real T = double>
struct RadialSpectrum {
    std::vector<T> wavenumber;       ///< mean |q| of a shell [rad/m]
    std::vector<T> value;            ///< C [m^4]
    std::vector<std::size_t> waves;  ///< in the shell
    SectionSpectrum<T> along_x, along_y;
};

namespace detail {

/// \p map about its mean, times \p window over its rms.
template <Real T>
[[nodiscard]] GridField<T> windowed(const HeightMap<T>& map, SpectrumWindow window) {
    GridField<T> heights = map.heights - map.heights.mean();
    if (window == SpectrumWindow::none) return heights;
    const auto weights = [window](Eigen::Index points) {  // of mean square 1
        Eigen::Array<T, Eigen::Dynamic, 1> all(points);
        for (Eigen::Index i = 0; i < points; ++i)
            all[i] = window_weight<T>(window, static_cast<std::size_t>(i), static_cast<std::size_t>(points)) *
                     std::sqrt(T(8) / 3);
        return all;
    };
    heights.colwise() *= weights(map.rows());
    heights.rowwise() *= weights(map.columns()).transpose();
    return heights;
}

}  // namespace detail

/// The spectra of \p map about its mean. \throws domain_error for missing points and what HeightMap::validate says.
template <Real T>
[[nodiscard]] RadialSpectrum<T> radial_spectrum(const HeightMap<T>& map, SpectrumWindow window = SpectrumWindow::hann) {
    using Index = Eigen::Index;
    const detail::ShellGrid<T> grid(map);
    const Index rows = map.rows(), columns = map.columns();
    const T end = (std::min)(grid.unit_x * T(columns), grid.unit_y * T(rows)) / 2;
    const std::size_t shells = grid.shell_of(end);  // those behind hold no more than a part of their waves
    std::vector<T> power(shells + 1), lengths(shells + 1);
    std::vector<std::size_t> waves(shells + 1);
    const auto section = [](Index points, T unit) {
        SectionSpectrum<T> one;
        one.step = unit;
        one.halved = points % 2 == 0;
        one.value.resize(static_cast<std::size_t>(points / 2));
        for (std::size_t k = 1; k <= one.value.size(); ++k) one.wavenumber.push_back(static_cast<T>(k) * unit);
        return one;
    };
    RadialSpectrum<T> result{.wavenumber = {},
                             .value = {},
                             .waves = {},
                             .along_x = section(columns, grid.unit_x),
                             .along_y = section(rows, grid.unit_y)};
    const auto put = [](SectionSpectrum<T>& one, Index k, T square) {
        if (k > 0) one.value[static_cast<std::size_t>(k) - 1] += square;
    };
    detail::visit_waves(detail::windowed(map, window), Edges::periodic, [&](T k, T l, T square) {
        put(result.along_x, static_cast<Index>(k), square);
        put(result.along_y, static_cast<Index>(l), square);
        const T q = grid.wave_number(k, l);
        const std::size_t shell = grid.shell_of(q);
        if (q > end * (1 + 4 * std::numeric_limits<T>::epsilon()) || shell > shells) return;
        power[shell] += square;
        lengths[shell] += q;
        ++waves[shell];
    });
    for (auto* one : {&result.along_x, &result.along_y}) {
        for (T& value : one->value) value /= one->step;
        if (one->halved) one->value.back() *= 2;
    }
    for (std::size_t k = 1; k <= shells; ++k) {
        if (waves[k] == 0) continue;
        const T count = static_cast<T>(waves[k]);
        result.wavenumber.push_back(lengths[k] / count);
        result.value.push_back(power[k] / count / grid.unit_x / grid.unit_y);
        result.waves.push_back(waves[k]);
    }
    return result;
}

}  // namespace fstiff
