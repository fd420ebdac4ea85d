// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/double/integrals.hpp>
#include <fstiff/double/surfaces.hpp>

#include <fstiff/implementation.hpp>

#include <fstiff/answer/law_fits_inline.hpp>
