// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// What the handle of a tabulated law holds.

#include "c/guard.hpp"

#include <fstiff/contact/contact_law.hpp>

struct fstiff_law {
    fstiff::ContactLaw<double> law;
};
