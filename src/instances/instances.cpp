// SPDX-License-Identifier: BSD-3-Clause
#define FSTIFF_DOUBLE template
#include <fstiff/double/contacts.hpp>
#include <fstiff/double/surfaces.hpp>
