// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// long double as the truth of double: where it has more digits, and no more than the tables of fstiff.
#include <cfloat>

#if LDBL_MANT_DIG > DBL_MANT_DIG && LDBL_MANT_DIG <= 64
#include <fstiff/math/gaussian_moment_table_extended.hpp>
#define FSTIFF_TEST_LONG_DOUBLE
#define FSTIFF_TEST_SCALARS float, double, long double
#define FSTIFF_TEST_SCALARS_FROM_DOUBLE double, long double
#else
#define FSTIFF_TEST_SCALARS float, double
#define FSTIFF_TEST_SCALARS_FROM_DOUBLE double
#endif
