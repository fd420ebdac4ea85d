// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// How a pressure on a grid deflects an elastic half space that goes on beyond the grid: by repeating it, or mirrored at its edges.
///
///     u_k = 2/(E |q_k|) p_k      for every wave but the mean, which moves the whole body: u_0 = 0
///
/// The kernel is even in x and in y, so that products of cosines and sines are its eigenfunctions: a real transform along x and
/// one along y, of N numbers into N, replace complex ones.
///
///     repeating   1, cos 2 pi k x/L, sin 2 pi k x/L          by a transform of real data
///     mirrored    cos pi k x/L at cell centres               by the same transform of re-ordered data (Makhoul)
///
/// Reference   Stanley, Kato, J. Tribol. 119 (1997) 481 (repeating half space by transforms); Makhoul, IEEE Trans. Acoust. Speech
///             Signal Process. 28 (1980) 27 (cosine transform).
/// Units       lengths [m], pressure in units of E: u [m] = deflect(p/E)
/// Valid       2 points a side at least; sides that are products of 2, 3 and 5 are fast, others take a transform of 2N or more
/// Accuracy    1e-14 relative to the largest deflection in double (tests/halfspace/surface_compliance_test.cpp)

#include <fstiff/core/names.hpp>
#include <fstiff/core/numbers.hpp>
#include <fstiff/math/fft.hpp>

#include <Eigen/Core>

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

namespace detail {

/// N real numbers into N coefficients of an orthogonal basis and back.
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

/// Numbers on a grid: rows along y, columns along x.
template <Real T>
using GridField = Eigen::Array<T, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Displacement of the surface of an elastic half space under pressures on a grid.
template <Real T = double>
class SurfaceCompliance {
public:
    /// For \p rows by \p columns cells of the size \p dy by \p dx [m]. \throws domain_error for less than 2 a side and sizes
    /// that are not finite and positive.
    SurfaceCompliance(Eigen::Index rows, Eigen::Index columns, T dx, T dy, Edges edges)
        : along_x_(static_cast<std::size_t>(columns), edges), along_y_(static_cast<std::size_t>(rows), edges) {
        require_positive("dx", dx);
        require_positive("dy", dy);
        const T unit_x = 2 * numbers::pi_v<T> / (dx * T(columns)), unit_y = 2 * numbers::pi_v<T> / (dy * T(rows));
        compliance_.resize(columns, rows);  // a line along y side by side: NOLINT(readability-suspicious-call-argument)
        for (Eigen::Index i = 0; i < columns; ++i)
            for (Eigen::Index j = 0; j < rows; ++j)
                compliance_(i, j) = 2 / std::hypot(unit_x * along_x_.wave_number(static_cast<std::size_t>(i)),
                                                   unit_y * along_y_.wave_number(static_cast<std::size_t>(j)));
        stiffness_ = 1 / compliance_;
        compliance_(0, 0) = stiffness_(0, 0) = 0;
    }

    /// \p field becomes the deflection [m] under it, taken as pressure over E. Its mean becomes 0.
    void deflect(GridField<T>& field) { multiply(field, compliance_); }
    /// \p field becomes the pressure over E that deflects all points by it [m], its mean left out: the inverse of deflect().
    void press(GridField<T>& field) { multiply(field, stiffness_); }

private:
    void multiply(GridField<T>& field, const GridField<T>& factors) {
        for (Eigen::Index j = 0; j < field.rows(); ++j) along_x_.forward(&field(j, 0));
        turned_ = field.transpose();
        for (Eigen::Index i = 0; i < turned_.rows(); ++i) {
            along_y_.forward(&turned_(i, 0));
            turned_.row(i) *= factors.row(i);
            along_y_.inverse(&turned_(i, 0));
        }
        field = turned_.transpose();
        for (Eigen::Index j = 0; j < field.rows(); ++j) along_x_.inverse(&field(j, 0));
    }

    detail::LineTransform<T> along_x_, along_y_;
    GridField<T> compliance_, stiffness_, turned_;  ///< columns by rows
};

}  // namespace fstiff
