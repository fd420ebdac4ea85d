// SPDX-License-Identifier: BSD-3-Clause
#ifdef CONSUMER_TAKES_ALL
#include <fstiff/fstiff.hpp>
#else
#include <fstiff/asperity/laws.hpp>
#include <fstiff/asperity/material.hpp>

#include <cmath>
#endif

double elsewhere(double omega, double radius);  // the same law, seen by another translation unit

int main() {
    const double modulus = fstiff::effective_modulus<double>({205e9, 0.3}, {205e9, 0.3});
    const double stiffness = modulus * fstiff::FractalLaw{1.62}.stiffness(1e-8, 40e-6);       // N/m
    const double expected = 205e9 / 1.82 * (4.0 / 3) * (1.38 / 0.38) * 6.324555320336759e-7;  // (3.14) by hand
    const bool right = std::abs(stiffness / expected - 1) < 1e-14;                            // a few roundings
#ifdef CONSUMER_HAS_OTHER
    return right && stiffness == modulus * elsewhere(1e-8, 40e-6) ? 0 : 1;
#else
    return right ? 0 : 1;
#endif
}
