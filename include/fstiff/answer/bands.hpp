// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The band of K: what the errors of the surface, the choice of lambda_s, and what is not known leave open.

#include <fstiff/answer/curves.hpp>
#include <fstiff/answer/request.hpp>

#include <cstddef>
#include <vector>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// Makes what the laws of \p request keep of the maps of \p problem and of its neighbours, in pieces.
void make_contacts(const ResolvedJoint& problem, const Request& request);
/// Gives each of \p curves, of the laws of \p request, whose law varies, its band: 5 % to 95 % over surfaces drawn
/// about this one by its errors, and, where the surface was measured, the spread of K over the neighbours at half and
/// twice the root of two of lambda_s, and the spread over the ends of what is not known. All widths, in logarithms, add
/// by squares. \returns the greatest number of drawn surfaces that have no K at some point.
std::size_t add_bands(const ResolvedJoint& problem, Request request, std::vector<LawCurve>& curves,
                      const ProgressHook& progress);

}}}  // namespace fstiff::detail
