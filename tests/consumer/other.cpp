// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/fstiff.hpp>

double elsewhere(double omega, double radius) { return fstiff::FractalLaw{1.62}.stiffness(omega, radius); }
