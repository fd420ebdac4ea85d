// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// erf on Lanes. std::erf costs ten times an exponential and Eigen has none in vectors of double.
///
///     erf(y) = y P(y^2)                        0 <= y <= 2
///     erf(y) = 1 - exp(-y^2) Q(y) / (y+2)      y >= 2
///
/// Reference   P and Q are interpolated by tools/make_gaussian_moment_table.py.
/// Units       dimensionless
/// Valid       y >= 0, infinity included
/// Accuracy    3 epsilon relative (tests/math/gaussian_moment_test.cpp)

#include <fstiff/math/gaussian_moment_table.hpp>
#include <fstiff/math/lanes.hpp>

namespace fstiff::detail {

inline constexpr int erf_split = 2;  ///< the series serves up to here, the tail beyond

template <Real T>
EIGEN_ALWAYS_INLINE Lanes<T> erf_series(const Lanes<T>& y) {
    return y * polynomial(ErfTable<T>::series, multiply_add(y * Lanes<T>(T(0.5)), y, Lanes<T>(T(-1))));
}

template <Real T>
EIGEN_ALWAYS_INLINE Lanes<T> erf_tail(const Lanes<T>& y) {
    using V = Lanes<T>;
    const V bounded = min(y, V(T(16)));  // erf is 1 to the last bit of every type from 7 on
    const V ratio = (bounded - V(T(4))) / (bounded + V(T(4)));
    const V q = polynomial(ErfTable<T>::tail, multiply_add(V(T(1.5)), ratio, V(T(-0.5))));
    return V(T(1)) - exp(V(T(0)) - bounded * bounded) * q / (bounded + V(T(2)));
}

/// erf of eight ascending numbers of which the first is \p first and the last \p last.
template <Real T>
EIGEN_ALWAYS_INLINE Lanes<T> erf_ascending(const Lanes<T>& y, T first, T last) {
    using V = Lanes<T>;
    if (first >= T(8)) return V(T(1));
    if (last <= T(erf_split)) return erf_series(y);
    if (first >= T(erf_split)) return erf_tail(y);
    const V split{T(erf_split)};
    return select_less(y, split, erf_series(min(y, split)), erf_tail(max(y, split)));
}

}  // namespace fstiff::detail
