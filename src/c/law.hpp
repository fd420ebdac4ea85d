// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Content of the handle of a tabulated law.

#include "c/guard.hpp"

#include <fstiff/tabulated/contact_law.hpp>

struct fstiff_law {
    fstiff::ContactLaw<double> law;
};
