// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The waves of a map that goes on beyond its edges, by repeating itself or mirrored: real transforms along one side.
///
///     repeating   1, cos 2 pi k x/L, sin 2 pi k x/L          by a transform of real data
///     mirrored    cos pi k x/L at cell centres               by the same transform of re-ordered data (Makhoul)
///
/// Mirrored lines are even about both ends, half a step outside of the last points: a line of N points has the period 2N, and
/// its transform is the cosine transform of type II.
///
/// Reference   Makhoul, IEEE Trans. Acoust. Speech Signal Process. 28 (1980) 27 (cosine transform).
/// Units       those of the data
/// Valid       2 points at least; lengths that are products of 2, 3 and 5 are fast, others take a transform of 2N or more
/// Accuracy    that of math/fft (tests/halfspace/surface_compliance_test.cpp, tests/topography/map_spectrum_test.cpp)

#include <fstiff/core/names.hpp>
#include <fstiff/core/numbers.hpp>
#include <fstiff/math/fft.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace fstiff {

/// How a map goes on beyond its edges.
enum class Edges {
    mirrored,  ///< reflected at each edge, so that no step arises: for measured maps
    periodic   ///< repeated: for generated maps that repeat themselves
};
template <>
inline constexpr auto names<Edges> = name_list<Edges>({{Edges::mirrored, "mirrored"}, {Edges::periodic, "periodic"}});

/// Numbers on a grid: rows along y, columns along x.
template <Real T>
using GridField = Eigen::Array<T, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

namespace detail {

/// N real numbers into N coefficients c_k of an orthogonal basis and back.
template <Real T>
class LineTransform {
public:
    LineTransform(std::size_t points, Edges edges) : points_(points), edges_(edges), fft_(points) {
        line_.resize(points);
        if (edges == Edges::mirrored)
            for (std::size_t k = 0; k <= points / 2; ++k)
                turn_.push_back(std::polar(T(1), -numbers::pi_v<T> * T(k) / (2 * T(points))));
    }

    /// Wave number of coefficient \p k, in units of 2 pi/L.
    [[nodiscard]] T wave_number(std::size_t k) const {
        if (edges_ == Edges::mirrored) return T(k) / 2;
        const std::size_t wave = (k + 1) / 2;  // a cosine and a sine of each
        return T(wave);
    }

    /// What coefficient \p k adds to the mean square of the line, over (c_k/N)^2: 1 of the mean and of the zigzag, else 2.
    [[nodiscard]] T weight(std::size_t k) const {
        return k == 0 || (edges_ == Edges::periodic && k + 1 == points_ && points_ % 2 == 0) ? T(1) : T(2);
    }

    void forward(T* line) {
        if (edges_ == Edges::periodic) {
            fft_.forward(std::span<const T>(line, points_), spectrum_);
            for (std::size_t k = 0; k < points_; ++k)
                line[k] = k % 2 == 1 || k == 0 ? spectrum_[(k + 1) / 2].real() : spectrum_[k / 2].imag();
            return;
        }
        for (std::size_t i = 0; i < points_; ++i) line_[i % 2 == 0 ? i / 2 : points_ - 1 - i / 2] = line[i];
        fft_.forward(line_, spectrum_);
        for (std::size_t k = 0; k <= points_ / 2; ++k) {
            const std::complex<T> c = spectrum_[k] * turn_[k];
            if (k > 0) line[points_ - k] = -c.imag();
            line[k] = c.real();
        }
    }

    void inverse(T* line) {
        spectrum_.resize(points_ / 2 + 1);
        if (edges_ == Edges::periodic) {
            spectrum_[0] = line[0];
            for (std::size_t k = 1; k <= points_ / 2; ++k)
                spectrum_[k] = {line[2 * k - 1], 2 * k < points_ ? line[2 * k] : T(0)};
            fft_.inverse(spectrum_, line_);
            std::copy(line_.begin(), line_.end(), line);
            return;
        }
        for (std::size_t k = 0; k <= points_ / 2; ++k)
            spectrum_[k] = std::conj(turn_[k]) * std::complex<T>(line[k], k > 0 ? -line[points_ - k] : T(0));
        fft_.inverse(spectrum_, line_);
        for (std::size_t i = 0; i < points_; ++i) line[i] = line_[i % 2 == 0 ? i / 2 : points_ - 1 - i / 2];
    }

private:
    std::size_t points_;
    Edges edges_;
    RealFft<T> fft_;
    std::vector<T> line_;
    std::vector<std::complex<T>> spectrum_, turn_;
};

}  // namespace detail

}  // namespace fstiff
