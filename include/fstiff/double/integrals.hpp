// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The kernel of the contact integrals in double, compiled once, in the library fstiff::double.

#include <fstiff/double/alignment.hpp>
#include <fstiff/peaks/contact_integrals.hpp>

#ifndef FSTIFF_DOUBLE
#define FSTIFF_DOUBLE extern template
#endif

namespace fstiff { inline namespace v0_1 {

FSTIFF_DOUBLE double detail::visit_nodes(const detail::PeakProblem<double>&, double, detail::PeakAccumulator<double>&);
FSTIFF_DOUBLE Estimate<double> contact_integral(double, double, const PeakDistribution<double>&, double,
                                                const IntegralOptions<double>&);

}}  // namespace fstiff
