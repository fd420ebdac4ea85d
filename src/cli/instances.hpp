// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// What several subcommands compute of a profile or a map is compiled once, in instances.cpp.

#include <fstiff/measured/sections.hpp>
#include <fstiff/profile/fractal_fit.hpp>
#include <fstiff/topography/areal_statistics.hpp>
#include <fstiff/topography/form.hpp>
#include <fstiff/topography/islands.hpp>

#ifdef FSTIFF_CLI_INSTANCES
#define FSTIFF_CLI_INSTANCE template
#else
#define FSTIFF_CLI_INSTANCE extern template
#endif

namespace fstiff {

FSTIFF_CLI_INSTANCE FractalFit<double> detail::fit_measured(const MeasuredStructureFunction<double>&,
                                                            const FractalFitOptions<double>&, double);
FSTIFF_CLI_INSTANCE FractalFit<double> fit_fractal(const Profile<double>&, const FractalFitOptions<double>&);
FSTIFF_CLI_INSTANCE DirectionalFit<double> fit_directions(const HeightMap<double>&, const FractalFitOptions<double>&);
FSTIFF_CLI_INSTANCE HeightMap<double> remove_form(const HeightMap<double>&, MapForm);
FSTIFF_CLI_INSTANCE ArealStatistics<double> areal_statistics(const HeightMap<double>&);
FSTIFF_CLI_INSTANCE IslandCurve<double> island_curve(const HeightMap<double>&, const IslandOptions<double>&);
FSTIFF_CLI_INSTANCE RepresentativeIslands<double> representative_islands(const HeightMap<double>&,
                                                                         const IslandOptions<double>&,
                                                                         const IslandSpread&);

}  // namespace fstiff

#undef FSTIFF_CLI_INSTANCE
