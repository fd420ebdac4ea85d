// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Real transforms along one side of a map that repeats itself or is mirrored beyond its edges.
///
///     repeating   1, cos 2 pi k x/L, sin 2 pi k x/L          by a transform of real data
///     mirrored    cos pi k x/L at cell centres               by the same transform of re-ordered data (Makhoul)
///
/// LinesTransform transforms several lines at once, in the lanes of the vector unit (math/fft.hpp).
///
/// Reference   Makhoul, IEEE Trans. Acoust. Speech Signal Process. 28 (1980) 27 (cosine transform of type II)
/// Units       those of the data
/// Valid       at least 2 points; lengths that are products of 2, 3 and 5 are fast, others need one of 2N or more
/// Accuracy    that of math/fft (tests/topography/line_transform_test.cpp, tests/topography/map_spectrum_test.cpp)

#include <fstiff/math/fft.hpp>
#include <fstiff/math/fft_of_lines.hpp>
#include <fstiff/topography/edges.hpp>

#include <numbers>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// Numbers on a grid: rows along y, columns along x.
template <Real T>
using GridField = Eigen::Array<T, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Wave number of coefficient \p k of a line, in units of 2 pi/L.
template <Real T>
[[nodiscard]] T wave_number(std::size_t k, Edges edges) {
    if (edges == Edges::mirrored) return T(k) / 2;
    const std::size_t wave = (k + 1) / 2;  // a cosine and a sine of each
    return T(wave);
}

/// Share of coefficient \p k in the mean square of a line of \p points, over (c_k/N)^2: 1 for mean and zigzag, else 2.
template <Real T>
[[nodiscard]] T wave_weight(std::size_t k, std::size_t points, Edges edges) {
    return k == 0 || (edges == Edges::periodic && k + 1 == points && points % 2 == 0) ? T(1) : T(2);
}

/// Transform of N real numbers into N coefficients c_k of an orthogonal basis, and its inverse.
template <Real T>
class LineTransform {
public:
    LineTransform(std::size_t points, Edges edges) : points_(points), edges_(edges), fft_(points) {
        line_.resize(points);
        if (edges == Edges::mirrored)
            for (std::size_t k = 0; k <= points / 2; ++k)
                turn_.push_back(std::polar(T(1), -std::numbers::pi_v<T> * T(k) / (2 * T(points))));
    }

    /// Wave number of coefficient \p k, in units of 2 pi/L.
    [[nodiscard]] T wave_number(std::size_t k) const { return detail::wave_number<T>(k, edges_); }

    /// wave_weight() of coefficient \p k.
    [[nodiscard]] T weight(std::size_t k) const { return wave_weight<T>(k, points_, edges_); }

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
    math::RealFft<T> fft_;
    std::vector<T> line_;
    std::vector<std::complex<T>> spectrum_, turn_;
};

/// Same transform for `lines` lines at once, several times as fast.
template <Real T>
class LinesTransform {
    static constexpr std::size_t width = math::FftOfLines<T>::width;

public:
    /// Two lines per lane: one is the real part of the transformed data, one the imaginary part.
    static constexpr std::size_t lines = 2 * width;

    LinesTransform(std::size_t points, Edges edges) : points_(points), edges_(edges), values_(points * lines, T(0)) {
        if (!math::is_smooth_size(points)) {
            single_.emplace(points, edges);
            line_.resize(points);
            return;
        }
        fft_.emplace(points);
        re_.resize(points * width);
        im_.resize(points * width);
        if (edges == Edges::mirrored)
            for (std::size_t k = 0; k <= points / 2; ++k)
                turn_.push_back(std::polar(T(1), -std::numbers::pi_v<T> * T(k) / (2 * T(points))));
    }

    /// Reads \p count lines; number i of line l is \p from[i step + l jump].
    void load(const T* from, std::size_t step, std::size_t jump, std::size_t count) {
        if (count < lines) std::fill(values_.begin(), values_.end(), T(0));  // lines of one lane round together
        for (std::size_t i = 0; i < points_; ++i)
            for (std::size_t l = 0; l < count; ++l) values_[i * lines + l] = from[i * step + l * jump];
    }
    /// Multiplies each number by that of \p factors, in the same order.
    void multiply(const T* factors, std::size_t step, std::size_t jump, std::size_t count) {
        for (std::size_t i = 0; i < points_; ++i)
            for (std::size_t l = 0; l < count; ++l) values_[i * lines + l] *= factors[i * step + l * jump];
    }
    /// Writes the lines back.
    void store(T* to, std::size_t step, std::size_t jump, std::size_t count) const {
        for (std::size_t i = 0; i < points_; ++i)
            for (std::size_t l = 0; l < count; ++l) to[i * step + l * jump] = values_[i * lines + l];
    }

    void forward() {
        if (single_) return one_by_one(&LineTransform<double>::forward);
        for (std::size_t i = 0; i < points_; ++i) {
            V::load(&values_[i * lines]).store(&re_[place(i)]);
            V::load(&values_[i * lines + width]).store(&im_[place(i)]);
        }
        fft_->transform(re_.data(), im_.data());
        const V half = V::all(T(1) / 2);
        for (std::size_t k = 0; k <= points_ / 2; ++k) {
            const std::size_t i = k * width, j = (k == 0 ? 0 : points_ - k) * width;
            const V p = V::load(&re_[i]), q = V::load(&im_[i]), r = V::load(&re_[j]), s = V::load(&im_[j]);
            keep({(p + r) * half, (q - s) * half}, k, 0);
            keep({(q + s) * half, (r - p) * half}, k, width);
        }
    }

    void inverse() {
        if (single_) return one_by_one(&LineTransform<double>::inverse);
        const V share = V::all(1 / T(points_));
        for (std::size_t k = 0; k <= points_ / 2; ++k) {
            const std::size_t i = k * width, j = (k == 0 ? 0 : points_ - k) * width;
            const Pair a = kept(k, 0), b = kept(k, width);
            ((a.re + b.im) * share).store(&re_[j]);
            ((b.re - a.im) * share).store(&im_[j]);
            ((a.re - b.im) * share).store(&re_[i]);
            ((b.re + a.im) * share).store(&im_[i]);
        }
        fft_->transform(im_.data(), re_.data());
        for (std::size_t i = 0; i < points_; ++i) {
            V::load(&re_[place(i)]).store(&values_[i * lines]);
            V::load(&im_[place(i)]).store(&values_[i * lines + width]);
        }
    }

private:
    using V = math::Lanes<T, int(width)>;
    struct Pair {
        V re, im;
    };

    /// Position of number \p i of a line in the transformed data.
    [[nodiscard]] std::size_t place(std::size_t i) const {
        const bool mirrored = edges_ == Edges::mirrored;
        return width * (!mirrored ? i : i % 2 == 0 ? i / 2 : points_ - 1 - i / 2);
    }

    /// Converts wave \p k of the lines from \p l on into its coefficients, in the order of LineTransform.
    EIGEN_ALWAYS_INLINE void keep(const Pair& z, std::size_t k, std::size_t l) {
        T* const values = values_.data() + l;
        if (edges_ == Edges::mirrored) {
            const V c = V::all(turn_[k].real()), s = V::all(turn_[k].imag());
            if (k > 0) (V::all(0) - z.re * s - z.im * c).store(values + (points_ - k) * lines);
            (z.re * c - z.im * s).store(values + k * lines);
            return;
        }
        z.re.store(values + (k == 0 ? 0 : 2 * k - 1) * lines);
        if (k > 0 && 2 * k < points_) z.im.store(values + 2 * k * lines);
    }
    /// Inverse of keep().
    [[nodiscard]] EIGEN_ALWAYS_INLINE Pair kept(std::size_t k, std::size_t l) const {
        const T* const values = values_.data() + l;
        const V none = V::all(0);
        if (edges_ == Edges::mirrored) {
            const V c = V::all(turn_[k].real()), s = V::all(turn_[k].imag());
            const V re = V::load(values + k * lines), im = k > 0 ? V::load(values + (points_ - k) * lines) : none;
            return {re * c - im * s, none - im * c - re * s};  // conj(turn) (re - i im)
        }
        const bool pair = k > 0 && 2 * k < points_;
        return {V::load(values + (k == 0 ? 0 : 2 * k - 1) * lines), pair ? V::load(values + 2 * k * lines) : none};
    }

    void one_by_one(void (LineTransform<double>::*transform)(double*)) {
        for (std::size_t l = 0; l < lines; ++l) {
            for (std::size_t i = 0; i < points_; ++i) line_[i] = values_[i * lines + l];
            ((*single_).*transform)(line_.data());
            for (std::size_t i = 0; i < points_; ++i) values_[i * lines + l] = static_cast<T>(line_[i]);
        }
    }

    std::size_t points_;
    Edges edges_;
    std::optional<math::FftOfLines<T>> fft_;
    /// Of lengths that kissfft does not take at once; of double for every T, so that it is compiled once.
    std::optional<LineTransform<double>> single_;
    std::vector<double> line_;
    std::vector<T> values_, re_, im_;
    std::vector<std::complex<T>> turn_;
};

}  // namespace detail

}}  // namespace fstiff
