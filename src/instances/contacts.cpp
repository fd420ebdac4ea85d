// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/double/integrals.hpp>  // extern: compiled in instances.cpp
#include <fstiff/double/surfaces.hpp>

#undef FSTIFF_DOUBLE
#define FSTIFF_DOUBLE template
#include <fstiff/double/contacts.hpp>
