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

#include <fstiff/core/names.hpp>
#include <fstiff/core/numbers.hpp>
#include <fstiff/math/fft.hpp>
#include <fstiff/surface/roughness_spectrum.hpp>
#include <fstiff/topography/height_map.hpp>

#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

namespace fstiff {

/// What a map is multiplied by before its transform.
enum class SpectrumWindow {
    hann,  ///< for measured maps
    none   ///< for maps that repeat themselves
};
template <>
inline constexpr auto names<SpectrumWindow> = name_list<SpectrumWindow>({{SpectrumWindow::hann, "hann"},
                                                                         {SpectrumWindow::none, "none"}});

/// The spectrum of \p map about its mean. Shells without any wave are left out.
/// \throws domain_error for missing points and what HeightMap::validate says.
template <Real T>
[[nodiscard]] SpectrumShells<T> map_spectrum(const HeightMap<T>& map, SpectrumWindow window = SpectrumWindow::hann) {
    map.validate(4);
    map.require_whole("before its spectrum is taken");
    using Complex = std::complex<T>;
    using Index = Eigen::Index;
    const Index rows = map.rows(), columns = map.columns(), half = columns / 2;
    const auto hann = [&](Index i, Index n) {
        if (window == SpectrumWindow::none) return T(1);
        const T s = std::sin(numbers::pi_v<T> * (T(i) + T(0.5)) / T(n));
        return s * s * std::sqrt(T(8) / 3);  // mean square 1
    };
    const T mean = map.heights.mean(), scale = (map.heights - mean).abs().maxCoeff();
    RealFft<T> along_x(static_cast<std::size_t>(columns));
    ComplexFft<T> along_y(static_cast<std::size_t>(rows));
    Eigen::Array<Complex, Eigen::Dynamic, Eigen::Dynamic> waves(rows, half + 1);
    std::vector<T> line(static_cast<std::size_t>(columns));
    std::vector<Complex> in, out;
    for (Index j = 0; j < rows; ++j) {
        for (Index i = 0; i < columns; ++i)
            line[static_cast<std::size_t>(i)] = (map.heights(j, i) - mean) / scale * hann(i, columns) * hann(j, rows);
        along_x.forward(line, out);
        for (Index i = 0; i <= half; ++i) waves(j, i) = out[static_cast<std::size_t>(i)];
    }
    const T unit_x = 2 * numbers::pi_v<T> / (T(columns) * map.dx), unit_y = 2 * numbers::pi_v<T> / (T(rows) * map.dy);
    const T width = std::min(unit_x, unit_y), size = T(map.size());
    const auto count = static_cast<std::size_t>(std::hypot(unit_x * T(half), unit_y * T(rows / 2)) / width) + 2;
    std::vector<T> q2_h2(count), q_h2(count), h2(count);
    in.resize(static_cast<std::size_t>(rows));
    for (Index i = 0; i <= half; ++i) {
        std::copy(waves.col(i).begin(), waves.col(i).end(), in.begin());
        along_y.forward(in, out);
        const T pairs = i == 0 || 2 * i == columns ? T(1) : T(2);  // and the conjugate waves, at -q
        for (Index j = 0; j < rows; ++j) {
            if (i == 0 && j == 0) continue;
            const T q = std::hypot(unit_x * T(i), unit_y * T(std::min(j, rows - j)));
            const T power = pairs * std::norm(out[static_cast<std::size_t>(j)] / size) * (scale * scale);
            const auto shell = static_cast<std::size_t>(std::lround(q / width));
            q2_h2[shell] += q * q * power;
            q_h2[shell] += q * power;
            h2[shell] += power;
        }
    }
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
