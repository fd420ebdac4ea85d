// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/double/integrals.hpp>
#include <fstiff/double/surfaces.hpp>

#include <fstiff/answer/answer_inline.hpp>
