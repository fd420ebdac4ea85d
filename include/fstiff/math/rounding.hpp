// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Test whether the residual of a form is only the rounding of the heights.
///
///     rest <= 16 eps max |z|                      rounding of the scalar, and of the removal itself
///     rest <= 0.6 q, rms of the rest <= 0.3 q     rounding to steps of q, whose rms is q / sqrt(12) = 0.29 q
///
/// q is the resolution where it is known, or the largest step of which all differences of neighbours are multiples.
///
/// Units       all arguments in one unit of length
/// Valid       heights finite or NaN (missing), as many rests
/// Accuracy    a surface rougher than 0.6 q, or than 1e-14 of its largest height, is never taken for rounding
///             (tests/math/rounding_test.cpp)

#include <fstiff/core/error.hpp>
#include <fstiff/core/numbers.hpp>

#include <algorithm>
#include <cmath>

// Sums that lose little to rounding, and the power of two by which data are scaled.
//
// Reference   Neumaier, Z. Angew. Math. Mech. 54 (1974) 39; Knuth, The Art of Computer Programming 2, 4.2.2 (two-sum)
// Valid       finite terms whose sums stay in the range of numbers
// Accuracy    a compensated sum of n terms: 2 epsilon of it and n^2 epsilon^2 of the sum of the magnitudes
//             (tests/math/accumulate_test.cpp)

namespace fstiff { inline namespace v0_1 { namespace math {

/// A sum as rounded, and its rounding error.
template <Real T = double>
struct RoundedSum {
    T sum{}, error{};
};

/// a + b exactly, as the sum of two numbers.
template <Real T>
[[nodiscard]] constexpr RoundedSum<T> two_sum(T a, T b) {
    const T sum = a + b, added = sum - a;
    return {sum, (a - (sum - added)) + (b - added)};
}

/// A sum that carries its rounding error along. The error is that of Neumaier's sum, found without a branch.
template <Real T = double>
class CompensatedSum {
public:
    void add(T term) {
        const RoundedSum<T> next = two_sum(sum_, term);
        error_ += next.error;
        sum_ = next.sum;
    }
    [[nodiscard]] T value() const { return sum_ + error_; }

private:
    T sum_{}, error_{};
};

/// The greatest power of two that is not above \p size > 0; 1 for 0. Division by it is exact.
template <Real T>
[[nodiscard]] T power_of_two_below(T size) {
    int exponent = 1;
    if (size > T(0)) (void)std::frexp(size, &exponent);
    return std::ldexp(T(1), exponent - 1);
}

/// The largest step, not below \p least, of which all differences of neighbours are multiples to within \p tolerance; 0
/// when there is none. Stops at the first difference that shows it.
template <Real T>
T common_step(const T* heights, std::size_t count, T least, T tolerance) {
    T step = 0, before = std::numeric_limits<T>::quiet_NaN();
    for (std::size_t i = 0; i < count; ++i) {
        if (std::isnan(heights[i])) continue;
        T greater = std::abs(heights[i] - before);  // NaN at the first point
        before = heights[i];
        if (!(greater > tolerance)) continue;
        if (step == T(0)) step = greater;
        while (true) {  // Euclid's algorithm, on numbers that are rounded
            const T over = std::abs(greater - step * std::round(greater / step));
            if (over <= tolerance) break;
            greater = step;
            step = over;
            if (step < least) return 0;
        }
    }
    return step;
}

/// True if \p rest, the residual of a form of \p heights, is only their rounding. \p resolution is the step in which
/// the heights were printed or counted, 0 where it is not known.
template <Real T>
bool is_rounding(const T* heights, const T* rest, std::size_t count, T resolution = 0) {
    T largest = 0, most = 0;
    for (std::size_t i = 0; i < count; ++i) {
        if (std::isnan(heights[i])) continue;
        largest = (std::max)(largest, std::abs(heights[i]));
        most = (std::max)(most, std::abs(rest[i]));
    }
    const T rounding = 16 * std::numeric_limits<T>::epsilon() * largest;
    if (most <= rounding) return true;
    T squares = 0;
    std::size_t present = 0;
    for (std::size_t i = 0; i < count; ++i)
        if (!std::isnan(heights[i])) {
            squares += (rest[i] / most) * (rest[i] / most);
            ++present;
        }
    const T rms = most * std::sqrt(squares / static_cast<T>(present));
    const T least = (std::max)(most / T(0.6), rms / T(0.3));
    return resolution >= least || common_step(heights, count, least, (std::max)(rounding, T(0.01) * most)) >= least;
}

/// \throws domain_error where is_rounding() of the \p surface, "profile" or "map", without its \p form.
template <Real T>
void require_more_than_rounding(const std::string& surface, std::string_view form, const T* heights, const T* rest,
                                std::size_t count, T resolution) {
    if (is_rounding(heights, rest, count, resolution))
        throw domain_error(surface + " of constant height once its form (" + std::string(form) +
                           ") is removed, or of one step: the rest cannot be distinguished from rounding of its "
                           "heights; must be of varying height");
}

}}}  // namespace fstiff::math
