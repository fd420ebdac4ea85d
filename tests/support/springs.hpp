// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The massless spring between two media, in long double.
#include <cmath>
#include <complex>

namespace test {

using Wide = long double;

// The equation as theory writes it, in complex arithmetic: nothing in common with the header but the physics.
inline std::complex<Wide> wide_reflection(Wide k, Wide z1, Wide z2, Wide omega) {
    const std::complex<Wide> x(0, omega * z1 * z2 / k);
    return (z1 - z2 + x) / (z1 + z2 + x);
}

inline Wide wide_stiffness(Wide r, Wide z1, Wide z2, Wide omega) {
    const Wide above = r * (z1 + z2) - std::abs(z1 - z2), sum = r * (z1 + z2) + std::abs(z1 - z2);
    return omega * z1 * z2 * std::sqrt((1 - r) * (1 + r)) / std::sqrt(above * sum);
}

}  // namespace test
