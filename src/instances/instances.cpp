// SPDX-License-Identifier: BSD-3-Clause
#define FSTIFF_DOUBLE template
#include <fstiff/double/integrals.hpp>
#include <fstiff/double/surfaces.hpp>
