// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/double/models.hpp>  // extern: compiled in instances.cpp

#undef FSTIFF_DOUBLE
#define FSTIFF_DOUBLE template
#include <fstiff/double/contacts.hpp>
