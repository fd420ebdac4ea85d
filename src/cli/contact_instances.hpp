// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The contact integrals are compiled once, in contact_instances.cpp.

#include <fstiff/contact/contact_integrals.hpp>

#ifndef FSTIFF_CLI_INSTANCE
#define FSTIFF_CLI_INSTANCE extern template
#endif

namespace fstiff {

FSTIFF_CLI_INSTANCE class ContactIntegrator<double>;
FSTIFF_CLI_INSTANCE ContactIntegrals<double> scaled_contact_integrals(const PeakDensity<double>&, double, Quantity,
                                                                      const IntegralOptions<double>&);
FSTIFF_CLI_INSTANCE Estimate<double> contact_integral(double, double, const PeakDensity<double>&, double,
                                                      const IntegralOptions<double>&);

}  // namespace fstiff
