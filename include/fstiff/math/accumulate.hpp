// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Sums that lose little to rounding, and the power of two by which data are scaled.
///
/// Reference   Neumaier, Z. Angew. Math. Mech. 54 (1974) 39; Knuth, The Art of Computer Programming 2, 4.2.2 (two-sum)
/// Valid       finite terms whose sums stay in the range of numbers
/// Accuracy    a compensated sum of n terms: 2 epsilon of it and n^2 epsilon^2 of the sum of the magnitudes
///             (tests/math/accumulate_test.cpp)

#include <fstiff/core/concepts.hpp>

#include <cmath>

namespace fstiff::inline v0_1::math {

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

}  // namespace fstiff::inline v0_1::math
