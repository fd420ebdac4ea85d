// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Roughness spectrum of a map in shells of |q|, the input of Persson's theory, and its power spectral densities.
///
///     z - mean = sum of h_q times the waves of the map continued beyond its edges,    sum of |h_q|^2 = sigma^2
///     mirrored   waves cos pi k x/L_x cos pi l y/L_y at cell centres;    periodic   waves exp(i q x)
///     shell i: |q| within half a wave number of i pi/L (mirrored), i 2 pi/L (periodic),  L the longer side
///     C(q)   = L_x L_y/(2 pi)^2 <|h_q|^2>                 over the waves of a shell;  sigma^2 = 2 pi int q C dq
///     C_x(q) = L_x/pi sum over q_y of |h_(q, q_y)|^2      one-sided, as that of a profile; C_y likewise
///
/// radial_spectrum() is for plots: its window changes the weights, and its shells end at the shortest wave of the
/// coarser side. Derivation: docs/theory-surface.md.
/// Reference   Nayak (1971); Jacobs et al., Surf. Topogr. 5 (2017) 013001, with (2 pi)^2 C, pi C_x; Makhoul (1980)
/// Units       heights [m], q [rad/m], C [m^4], C_x and C_y [m^3]
/// Valid       maps of at least 4 x 4 points, none missing; remove the form first
/// Accuracy    1e-13 of the sum, 1e-11 of a shell, 1e-12 of C (tests/topography/map_spectrum_test.cpp)

#include <fstiff/surface/band_spectrum.hpp>
#include <fstiff/surface/spectrum.hpp>
#include <fstiff/topography/height_map.hpp>
#include <fstiff/topography/line_transform.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fstiff { inline namespace v0_1 {

namespace detail {

/// Calls \p use(k, l, |h_q|^2) for the waves of \p heights [m] except their mean: k along x, l along y, in units of
/// 2 pi over the side. A cosine and a sine are separate waves.
template <Real T, class Use>
void visit_waves(GridField<T> heights, Edges edges, const Use& use) {
    const auto columns = static_cast<std::size_t>(heights.cols()), rows = static_cast<std::size_t>(heights.rows());
    const T scale = heights.abs().maxCoeff();
    heights /= scale;
    constexpr std::size_t lines = LinesTransform<T>::lines;
    LinesTransform<T> along_x(columns, edges), along_y(rows, edges);
    GridField<T> turned(heights.cols(), heights.rows());
    for (std::size_t j = 0; j < rows; j += lines) {
        const std::size_t count = (std::min)(lines, rows - j);
        along_x.load(heights.data() + j * columns, 1, columns, count);
        along_x.forward();
        along_x.store(turned.data() + j, rows, 1, count);
    }
    const T unit = scale / T(heights.size());
    std::vector<T> number_y(rows), weight_y(rows);
    for (std::size_t j = 0; j < rows; ++j)
        number_y[j] = detail::wave_number<T>(j, edges), weight_y[j] = detail::wave_weight<T>(j, rows, edges);
    for (std::size_t i = 0; i < columns; ++i) {
        T* const line = turned.data() + i * rows;
        if (i % lines == 0) {
            const std::size_t count = (std::min)(lines, columns - i);
            along_y.load(line, 1, rows, count);
            along_y.forward();
            along_y.store(line, 1, rows, count);
        }
        const T k = detail::wave_number<T>(i, edges), weight = detail::wave_weight<T>(i, columns, edges);
        for (std::size_t j = 0; j < rows; ++j) {
            const T h = line[j] * unit;
            if (i + j > 0) use(k, number_y[j], weight * weight_y[j] * h * h);
        }
    }
}

/// Grid of shells of |q| about whole multiples of a width, for a map that has a spectrum.
template <Real T>
struct ShellGrid {
    T unit_x{}, unit_y{};  ///< 2 pi over the sides [rad/m]
    T width{};             ///< least wave number [rad/m]

    /// \throws domain_error for missing points, and as HeightMap::validate.
    explicit ShellGrid(const HeightMap<T>& map, Edges edges = Edges::periodic) {
        map.validate(4);
        map.require_whole("before its spectrum is taken");
        unit_x = 2 * std::numbers::pi_v<T> / (T(map.columns()) * map.dx);
        unit_y = 2 * std::numbers::pi_v<T> / (T(map.rows()) * map.dy);
        width = (std::min)(unit_x, unit_y) / (edges == Edges::mirrored ? 2 : 1);
    }
    /// |q| of the wave k along x, l along y, in units of 2 pi over the sides.
    [[nodiscard]] T wave_number(T k, T l) const {
        const T x = unit_x / width * k, y = unit_y / width * l;  // squares stay within the range of numbers
        return width * std::sqrt(x * x + y * y);
    }
    /// Shell of a wave: halfway between two shells the outer one, despite rounding; sides of 3:2 have such waves.
    [[nodiscard]] std::size_t shell_of(T q) const {
        return static_cast<std::size_t>(q / width * (1 + 16 * std::numeric_limits<T>::epsilon()) + T(0.5));
    }
};

}  // namespace detail

/// Spectrum of \p map about its mean. Shells without a wave are left out.
/// \throws domain_error for missing points, and as HeightMap::validate.
template <Real T>
[[nodiscard]] SpectrumShells<T> map_spectrum(const HeightMap<T>& map, Edges edges = Edges::mirrored) {
    const detail::ShellGrid<T> grid(map, edges);
    const T highest = grid.wave_number(T(map.columns()) / 2, T(map.rows()) / 2);
    const std::size_t count = grid.shell_of(highest) + 1;
    std::vector<T> q2_h2(count), q_h2(count), h2(count);
    detail::visit_waves<T>(map.heights - map.heights.mean(), edges, [&](T k, T l, T power) {
        const T q = grid.wave_number(k, l);
        const std::size_t shell = grid.shell_of(q);
        q2_h2[shell] += q * q * power;
        q_h2[shell] += q * power;
        h2[shell] += power;
    });
    SpectrumShells<T> spectrum;
    T square = 0;
    for (std::size_t k = 0; k < count; ++k) {
        square += h2[k];
        if (q2_h2[k] > 0 && q_h2[k] > 0) spectrum.shells.push_back({q2_h2[k], q_h2[k]});
    }
    spectrum.rms_height = std::sqrt(square);
    return spectrum;
}

namespace detail {

/// One-sided spectrum of the sections of a map along one axis.
template <Real T = double>
struct SectionSpectrum {
    std::vector<T> wavenumber;  ///< 1, 2, ... times the step, to the shortest wave [rad/m]
    std::vector<T> value;       ///< [m^3]
    T step{};                   ///< [rad/m]
    bool halved{};              ///< whether the last value counts half in an integral: the number of points is even

    /// Integral of C dq [m^2].
    [[nodiscard]] T integral() const {
        T sum = 0;
        for (std::size_t k = 0; k < value.size(); ++k) sum += halved && k + 1 == value.size() ? value[k] / 2 : value[k];
        return sum * step;
    }
};

}  // namespace detail

/// Power spectrum of a map over all directions, and of its sections.
template <Real T = double>
struct RadialSpectrum {
    std::vector<T> wavenumber;       ///< mean |q| of a shell [rad/m]
    std::vector<T> value;            ///< C [m^4]
    std::vector<std::size_t> waves;  ///< in the shell
    detail::SectionSpectrum<T> along_x, along_y;
};

namespace detail {

/// \p map about its mean, times \p window over its rms.
template <Real T>
[[nodiscard]] GridField<T> windowed(const HeightMap<T>& map, SpectrumWindow window) {
    GridField<T> heights = map.heights - map.heights.mean();
    if (window == SpectrumWindow::none) return heights;
    const auto weights = [window](Eigen::Index points) {  // of mean square 1
        Eigen::Array<T, Eigen::Dynamic, 1> out(points);
        for (Eigen::Index i = 0; i < points; ++i)
            out[i] = detail::window_weight<T>(window, static_cast<std::size_t>(i), static_cast<std::size_t>(points)) *
                     std::sqrt(T(8) / 3);
        return out;
    };
    heights.colwise() *= weights(map.rows());
    heights.rowwise() *= weights(map.columns()).transpose();
    return heights;
}

}  // namespace detail

/// Spectra of \p map about its mean. \throws domain_error for missing points, and as HeightMap::validate.
template <Real T>
[[nodiscard]] RadialSpectrum<T> radial_spectrum(const HeightMap<T>& map, SpectrumWindow window = SpectrumWindow::hann) {
    using Index = Eigen::Index;
    const detail::ShellGrid<T> grid(map);
    const Index rows = map.rows(), columns = map.columns();
    const T end = (std::min)(grid.unit_x * T(columns), grid.unit_y * T(rows)) / 2;
    const std::size_t shells = grid.shell_of(end);  // later ones contain only a part of their waves
    std::vector<T> power(shells + 1), lengths(shells + 1);
    std::vector<std::size_t> waves(shells + 1);
    const auto section = [](Index points, T unit) {
        detail::SectionSpectrum<T> out;
        out.step = unit;
        out.halved = points % 2 == 0;
        out.value.resize(static_cast<std::size_t>(points / 2));
        for (std::size_t k = 1; k <= out.value.size(); ++k) out.wavenumber.push_back(static_cast<T>(k) * unit);
        return out;
    };
    RadialSpectrum<T> result{.wavenumber = {},
                             .value = {},
                             .waves = {},
                             .along_x = section(columns, grid.unit_x),
                             .along_y = section(rows, grid.unit_y)};
    const auto put = [](detail::SectionSpectrum<T>& spectrum, Index k, T square) {
        if (k > 0) spectrum.value[static_cast<std::size_t>(k) - 1] += square;
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
    for (auto* spectrum : {&result.along_x, &result.along_y}) {
        for (T& value : spectrum->value) value /= spectrum->step;
        if (spectrum->halved) spectrum->value.back() *= 2;
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

}}  // namespace fstiff
