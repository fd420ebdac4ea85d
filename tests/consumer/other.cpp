// SPDX-License-Identifier: BSD-3-Clause
#ifdef FSTIFF_SINGLE_HEADER
#include "fstiff.hpp"
#else
#include <fstiff/fstiff.hpp>
#endif

double elsewhere(double omega, double radius) { return fstiff::FractalLaw{1.62}.stiffness(omega, radius); }
