// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The kernel of the contact integrals is compiled once, in instances.cpp, as the build type says.

#include <fstiff/contact/contact_integrals.hpp>
#include <fstiff/contact/tensor_integrals.hpp>

#ifndef FSTIFF_SCENE_INSTANCE
#define FSTIFF_SCENE_INSTANCE extern template
#endif

namespace fstiff {

FSTIFF_SCENE_INSTANCE double detail::visit_nodes(const detail::PeakProblem<double>&, double,
                                                 detail::PeakAccumulator<double>&);
FSTIFF_SCENE_INSTANCE Estimate<double> contact_integral(double, double, const PeakDistribution<double>&, double,
                                                        const parts::IntegralOptions<double>&);
FSTIFF_SCENE_INSTANCE Estimate<double> parts::tensor_integral(double, double, const PeakDistribution<double>&, double,
                                                       const parts::TensorOptions<double>&);
FSTIFF_SCENE_INSTANCE Estimate<double> parts::paper_integral(double, double, const PeakDistribution<double>&, double);

}  // namespace fstiff
