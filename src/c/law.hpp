// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Content of the handle of a tabulated law.

#include "c/guard.hpp"

#include <fstiff/tabulated/contact_law.hpp>

struct fstiff_law {
    fstiff::ContactLaw<double> law;
};

namespace fstiff::c {

/// The policy of FSTIFF_OUTSIDE_... \throws argument_error for another number.
inline OutsideRange outside_of(int outside) {
    if (outside < FSTIFF_OUTSIDE_REFUSE || outside > FSTIFF_OUTSIDE_EXTRAPOLATE)
        refuse_argument("outside", outside, "one of FSTIFF_OUTSIDE_REFUSE, CLAMP, EXACT, EXTRAPOLATE");
    return static_cast<OutsideRange>(outside);
}

}  // namespace fstiff::c
