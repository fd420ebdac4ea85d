// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The roughness spectrum of a map in shells of |q|, which Persson's theory takes as it is.
///
///     h_q = 1/N sum over the points of (z - mean) w/sqrt(mean w^2) exp(-i q x),    sum of |h_q|^2 = sigma^2
///     shell i: |q| within half a wave number of i 2 pi/L,  L the longer side
///
/// w is Hann's window, or 1 for a map that repeats itself. Without a window the steps between opposite edges of a measured map
/// are taken for roughness: its gradient grows with the number of points.
///
/// Reference   Jacobs, Junge, Pastewka, Surf. Topogr.: Metrol. Prop. 5 (2017) 013001.
/// Units       heights [m], q [rad/m]
/// Valid       maps of 4 x 4 points at least, without missing points; remove the form first
/// Accuracy    1e-13 relative of each shell of a sum of waves (tests/topography/map_spectrum_test.cpp)

#include <fstiff/core/numbers.hpp>
#include <fstiff/math/fft.hpp>
#include <fstiff/surface/roughness_spectrum.hpp>
#include <fstiff/surface/spectrum_window.hpp>
#include <fstiff/topography/height_map.hpp>

#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

namespace fstiff {

namespace detail {

/// Calls \p use(i, j, pairs, |h_q|^2) for the waves of q = (2 pi/L_x i, 2 pi/L_y j), j beyond half the rows counted back from
/// them, of \p map about its mean; \p pairs is 2 where the conjugate wave at -q is not visited, else 1.
template <Real T, class Use>
void visit_waves(const HeightMap<T>& map, SpectrumWindow window, const Use& use) {
    using Complex = std::complex<T>;
    using Index = Eigen::Index;
    const Index rows = map.rows(), columns = map.columns(), half = columns / 2;
    const auto weights = [&](Index points) {  // of mean square 1
        std::vector<T> all(static_cast<std::size_t>(points), T(1));
        for (std::size_t i = 0; i < all.size() && window == SpectrumWindow::hann; ++i)
            all[i] = window_weight<T>(window, i, all.size()) * std::sqrt(T(8) / 3);
        return all;
    };
    const std::vector<T> across = weights(columns), up = weights(rows);
    const T mean = map.heights.mean(), scale = (map.heights - mean).abs().maxCoeff();
    RealFft<T> along_x(static_cast<std::size_t>(columns));
    ComplexFft<T> along_y(static_cast<std::size_t>(rows));
    Eigen::Array<Complex, Eigen::Dynamic, Eigen::Dynamic> waves(rows, half + 1);
    std::vector<T> line(static_cast<std::size_t>(columns));
    std::vector<Complex> in, out;
    for (Index j = 0; j < rows; ++j) {
        for (Index i = 0; i < columns; ++i)
            line[static_cast<std::size_t>(i)] = (map.heights(j, i) - mean) / scale *
                                                across[static_cast<std::size_t>(i)] * up[static_cast<std::size_t>(j)];
        along_x.forward(line, out);
        for (Index i = 0; i <= half; ++i) waves(j, i) = out[static_cast<std::size_t>(i)];
    }
    const T size = T(map.size());
    in.resize(static_cast<std::size_t>(rows));
    for (Index i = 0; i <= half; ++i) {
        std::copy(waves.col(i).begin(), waves.col(i).end(), in.begin());
        along_y.forward(in, out);
        const T pairs = i == 0 || 2 * i == columns ? T(1) : T(2);
        for (Index j = 0; j < rows; ++j)
            if (i != 0 || j != 0)
                use(i, j, pairs, std::norm(out[static_cast<std::size_t>(j)] / size) * (scale * scale));
    }
}

/// Shells of |q| about whole multiples of a width, for a map that has a spectrum.
template <Real T>
struct ShellGrid {
    T unit_x{}, unit_y{}, width{};  ///< 2 pi over the sides, and over the longer one [rad/m]

    /// \throws domain_error for missing points and what HeightMap::validate says.
    explicit ShellGrid(const HeightMap<T>& map) {
        map.validate(4);
        map.require_whole("before its spectrum is taken");
        unit_x = 2 * numbers::pi_v<T> / (T(map.columns()) * map.dx);
        unit_y = 2 * numbers::pi_v<T> / (T(map.rows()) * map.dy);
        width = (std::min)(unit_x, unit_y);
    }
    [[nodiscard]] std::size_t shell_of(T q) const { return static_cast<std::size_t>(std::lround(q / width)); }
};

}  // namespace detail

/// The spectrum of \p map about its mean. Shells without any wave are left out.
/// \throws domain_error for missing points and what HeightMap::validate says.
template <Real T>
[[nodiscard]] SpectrumShells<T> map_spectrum(const HeightMap<T>& map, SpectrumWindow window = SpectrumWindow::hann) {
    using Index = Eigen::Index;
    const Index rows = map.rows(), half = map.columns() / 2, half_rows = rows / 2;
    const detail::ShellGrid<T> grid(map);
    const auto count =
        static_cast<std::size_t>(std::hypot(grid.unit_x * T(half), grid.unit_y * T(half_rows)) / grid.width) + 2;
    std::vector<T> q2_h2(count), q_h2(count), h2(count);
    detail::visit_waves(map, window, [&](Index i, Index j, T pairs, T square) {
        const T q = std::hypot(grid.unit_x * T(i), grid.unit_y * T((std::min)(j, rows - j))), power = pairs * square;
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

}  // namespace fstiff
