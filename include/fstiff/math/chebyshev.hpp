// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// A smooth function on an interval as a Chebyshev series or several, and short pieces of it as plain polynomials.
///
///     f(x) = c_0/2 + c_1 T_1(u) + ... ,   u = (2x - a - b)/(b - a)
///
/// Reference   Clenshaw, Math. Tables Aids Comput. 9 (1955) 118-120 (evaluation); Trefethen, Approximation Theory and
///             Approximation Practice (SIAM, 2013), chapter 3.
/// Valid       a < b, at most `capacity` coefficients
/// Accuracy    that of the samples times log(degree), and the coefficients left out; a derivative costs degree^2

#include <fstiff/core/numbers.hpp>
#include <fstiff/math/lanes.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

namespace fstiff { inline namespace v0_1 { namespace math {

/// Does not allocate.
template <Real T = double>
class ChebyshevSeries {
public:
    static constexpr std::size_t capacity = 64;

    ChebyshevSeries() = default;

    /// Interpolates \p f, called at \p points abscissae in [a, b] (at most capacity).
    template <class F>
    ChebyshevSeries(T a, T b, std::size_t points, const F& f)
        : middle_((a + b) / 2), half_((b - a) / 2), size_(points) {
        std::array<T, capacity> value;
        std::array<T, 4 * capacity> cosine;  // cos(pi m / (2 points))
        for (std::size_t m = 0; m <= points; ++m) {
            const T node = m == points ? T(0) : std::cos(std::numbers::pi_v<T> * T(m) / (2 * T(points)));
            cosine[m] = cosine[(4 * points - m) % (4 * points)] = node;
            cosine[2 * points - m] = cosine[2 * points + m] = -node;
        }
        for (std::size_t k = 0; k < points; ++k) value[k] = f(middle_ + half_ * cosine[2 * k + 1]);
        for (std::size_t j = 0; j < points; ++j) {
            T sum = 0;
            std::size_t m = j;  // j (2k + 1), less whole turns
            for (std::size_t k = 0; k < points; ++k) {
                sum += value[k] * cosine[m];
                m += 2 * j;
                if (m >= 4 * points) m -= 4 * points;
            }
            c_[j] = 2 * sum / T(points);
        }
    }

    template <int N>
    [[nodiscard]] Lanes<T, N> operator()(const Lanes<T, N>& x) const noexcept {
        using V = Lanes<T, N>;
        const V u = (x - V::all(middle_)) / V::all(half_), twice = u + u;
        V next = V::all(0), after = next;
        for (std::size_t j = size_; j-- > 1;) {
            const V now = multiply_add(twice, next, V::all(c_[j]) - after);
            after = next;
            next = now;
        }
        return multiply_add(u, next, V::all(c_[0] / 2) - after);
    }
    [[nodiscard]] T operator()(T x) const noexcept { return (*this)(Lanes<T, 1>::all(x)).p; }

    /// The series of the derivative.
    [[nodiscard]] ChebyshevSeries derivative() const {
        ChebyshevSeries out = *this;
        out.c_.fill(0);
        for (std::size_t j = size_ - 1; j > 0; --j)
            out.c_[j - 1] = (j + 1 < size_ ? out.c_[j + 1] : T(0)) + 2 * T(j) * c_[j] / half_;
        out.size_ = size_ - 1;
        return out;
    }

    [[nodiscard]] T middle() const { return middle_; }
    [[nodiscard]] T end() const { return middle_ + half_; }
    /// Size of the last two coefficients: of the order of the error of the series.
    [[nodiscard]] T tail() const { return std::abs(c_[size_ - 1]) + std::abs(c_[size_ - 2]); }

private:
    T middle_{}, half_{1};
    std::size_t size_ = 0;
    std::array<T, capacity> c_{};
};

/// A function that needs more than one series: one for each section of the interval.
template <Real T = double>
class ChebyshevSections {
public:
    ChebyshevSections() = default;

    /// \p count equal sections of [a, b] of \p points coefficients each. A section is halved, three times at most,
    /// where its last coefficients are above \p error, the error of the values, which \p f may raise.
    template <class F>
    ChebyshevSections(T a, T b, std::size_t count, std::size_t points, const F& f, const T& error) {
        sections_.reserve(count);
        for (std::size_t i = 0; i < count; ++i)
            add(a + (b - a) * (T(i) / T(count)), a + (b - a) * (T(i + 1) / T(count)), points, f, error, 3);
    }

    [[nodiscard]] std::size_t size() const { return sections_.size(); }

    [[nodiscard]] T operator()(T x) const { return section(x)(x); }
    /// Values at \p x, which rise or fall.
    template <int N>
    [[nodiscard]] Lanes<T, N> operator()(const Lanes<T, N>& x) const {
        std::array<T, std::size_t{N}> lanes;
        x.store(lanes.data());
        const auto [least, greatest] = std::minmax(lanes.front(), lanes.back());
        const ChebyshevSeries<T>*series = &section(least), *const last = &section(greatest);
        auto value = (*series)(x);
        while (series != last) {
            const auto end = Lanes<T, N>::all(series->end());
            value = select_less(end, x, (*++series)(x), value);
        }
        return value;
    }

    /// Largest difference of two sections where they meet, over the value: a derivative is worst at the ends.
    [[nodiscard]] T relative_jump() const {
        T largest = 0;
        for (std::size_t i = 1; i < sections_.size(); ++i) {
            const T x = sections_[i - 1].end(), right = sections_[i](x);
            largest = (std::max)(largest, std::abs((sections_[i - 1](x) - right) / right));
        }
        return largest;
    }

    [[nodiscard]] ChebyshevSections derivative() const {
        ChebyshevSections out = *this;
        for (auto& section : out.sections_) section = section.derivative();
        return out;
    }

private:
    template <class F>
    void add(T a, T b, std::size_t points, const F& f, const T& error, int halvings) {
        constexpr T epsilon = std::numeric_limits<T>::epsilon();
        const ChebyshevSeries<T> series(a, b, points, f);
        const T rounding = epsilon * (std::max)(T(600), 4 * std::abs(series(series.middle())));
        if (halvings == 0 || series.tail() <= (std::max)(rounding, error)) {
            sections_.push_back(series);
            return;
        }
        add(a, (a + b) / 2, points, f, error, halvings - 1);
        add((a + b) / 2, b, points, f, error, halvings - 1);
    }
    [[nodiscard]] const ChebyshevSeries<T>& section(T x) const {
        const auto match = std::partition_point(sections_.begin(), sections_.end() - 1,
                                                [x](const auto& section) { return section.end() < x; });
        return *match;
    }

    std::vector<ChebyshevSeries<T>> sections_;
};

/// The polynomial of degree N-1 in s in [-1, 1] through given values at the N Chebyshev-Lobatto points cos(pi k/(N-1)),
/// whose ends are the ends of the interval: neighbouring pieces agree there.
template <Real T, int N>
class LobattoPiece {
    static constexpr auto size = static_cast<std::size_t>(N);

public:
    static const LobattoPiece& get() {
        static const LobattoPiece piece;
        return piece;
    }
    std::array<T, size> node;  ///< ascending, -1 to 1

    /// Coefficients of s^0 ... s^(N-1).
    [[nodiscard]] Lanes<T, N> fit(const Lanes<T, N>& value) const {
        std::array<T, size> lanes;
        value.store(lanes.data());
        auto sum = Lanes<T, N>::all(0);
        for (std::size_t k = 0; k < size; ++k)
            sum = multiply_add(Lanes<T, N>::load(inverse_[k].data()), Lanes<T, N>::all(lanes[k]), sum);
        return sum;
    }

private:
    /// Inverse Vandermonde matrix by Lagrange's polynomials, multiplied out in long double: the condition is 2.4^N.
    LobattoPiece() {
        const long double pi = std::acos(-1.0L);  // libc++ has that of double only
        std::array<long double, size> x;
        for (std::size_t k = 0; k < size; ++k) x[k] = -std::cos(pi * static_cast<long double>(k) / (N - 1));
        if constexpr (N % 2 == 1) x[N / 2] = 0;
        for (std::size_t k = 0; k < size; ++k) {
            std::array<long double, size> product{1};
            std::size_t degree = 0;
            for (std::size_t m = 0; m < size; ++m) {
                if (m == k) continue;
                ++degree;
                for (std::size_t i = degree; i > 0; --i) product[i] = product[i - 1] - x[m] * product[i];
                product[0] *= -x[m];
                for (std::size_t i = 0; i <= degree; ++i) product[i] /= x[k] - x[m];
            }
            for (std::size_t i = 0; i < size; ++i) inverse_[k][i] = static_cast<T>(product[i]);
            node[k] = static_cast<T>(x[k]);
        }
    }

    std::array<std::array<T, size>, size> inverse_;  ///< by columns
};

}}}  // namespace fstiff::math
