// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// What the subcommands compute of a profile or a map is compiled once, in instances.cpp: files that include this
// are quick to compile, and need no optimisation of their own.

#include <fstiff/halfspace/truth.hpp>
#include <fstiff/measured/height_shape.hpp>
#include <fstiff/measured/measure.hpp>
#include <fstiff/measured/sections.hpp>
#include <fstiff/measured/surface_parameters.hpp>
#include <fstiff/profile/all_lags.hpp>
#include <fstiff/profile/autocorrelation.hpp>
#include <fstiff/profile/fractal_fit.hpp>
#include <fstiff/profile/gaussian_filter.hpp>
#include <fstiff/profile/peak_statistics.hpp>
#include <fstiff/profile/power_spectrum.hpp>
#include <fstiff/profile/roughness_parameters.hpp>
#include <fstiff/surface/material_ratio.hpp>
#include <fstiff/synthetic/self_affine.hpp>
#include <fstiff/synthetic/weierstrass_mandelbrot.hpp>
#include <fstiff/topography/areal_autocorrelation.hpp>
#include <fstiff/topography/areal_statistics.hpp>
#include <fstiff/topography/form.hpp>
#include <fstiff/topography/gaussian_map_filter.hpp>
#include <fstiff/topography/islands.hpp>
#include <fstiff/topography/map_spectrum.hpp>
#include <fstiff/topography/summits.hpp>

#ifndef FSTIFF_SCENE_INSTANCE
#define FSTIFF_SCENE_INSTANCE extern template
#endif

namespace fstiff {

FSTIFF_SCENE_INSTANCE FractalFit<double> detail::fit_measured(const MeasuredStructureFunction<double>&,
                                                              const FractalFitOptions<double>&, double);
FSTIFF_SCENE_INSTANCE FractalFit<double> detail::fit_profile(const Profile<double>&, const FractalFitOptions<double>&);
FSTIFF_SCENE_INSTANCE DirectionalFit<double> fit_directions(const HeightMap<double>&, const FractalFitOptions<double>&);
FSTIFF_SCENE_INSTANCE StructureFunction<double> structure_function_at_all_lags(const Profile<double>&, std::size_t,
                                                                               Divisor);
FSTIFF_SCENE_INSTANCE PowerSpectrum<double> power_spectrum(const Profile<double>&, SpectrumWindow);
FSTIFF_SCENE_INSTANCE Autocorrelation<double> autocorrelation(const Profile<double>&);
FSTIFF_SCENE_INSTANCE RoughnessParameters<double> roughness_parameters(const Profile<double>&, std::optional<double>);
FSTIFF_SCENE_INSTANCE MaterialRatio<double> material_ratio(std::span<const double>);
FSTIFF_SCENE_INSTANCE PeakStatistics<double> peak_statistics(const Profile<double>&);
FSTIFF_SCENE_INSTANCE Profile<double> gaussian_low_pass(const Profile<double>&, double);
FSTIFF_SCENE_INSTANCE Profile<double> gaussian_roughness(const Profile<double>&, double);
FSTIFF_SCENE_INSTANCE HeightMap<double> gaussian_low_pass(const HeightMap<double>&, double);
FSTIFF_SCENE_INSTANCE HeightMap<double> gaussian_high_pass(const HeightMap<double>&, double);
FSTIFF_SCENE_INSTANCE RobustWaviness<Profile<double>> robust_waviness(const Profile<double>&, double, int);
FSTIFF_SCENE_INSTANCE RobustWaviness<HeightMap<double>> robust_waviness(const HeightMap<double>&, double);
FSTIFF_SCENE_INSTANCE HeightMap<double> remove_form(const HeightMap<double>&, MapForm);
FSTIFF_SCENE_INSTANCE ArealStatistics<double> areal_statistics(const HeightMap<double>&);
FSTIFF_SCENE_INSTANCE ArealParameters<double> areal_parameters(const HeightMap<double>&,
                                                               const ArealStatistics<double>&);
FSTIFF_SCENE_INSTANCE ArealAutocorrelation<double> areal_autocorrelation(const HeightMap<double>&, LagPairs);
FSTIFF_SCENE_INSTANCE RadialAutocorrelation<double> radial_autocorrelation(const ArealAutocorrelation<double>&);
FSTIFF_SCENE_INSTANCE TextureParameters<double> texture_parameters(const ArealAutocorrelation<double>&, double);
FSTIFF_SCENE_INSTANCE RadialSpectrum<double> radial_spectrum(const HeightMap<double>&, SpectrumWindow);
FSTIFF_SCENE_INSTANCE IslandCurve<double> island_curve(const HeightMap<double>&, const IslandOptions<double>&);
FSTIFF_SCENE_INSTANCE RepresentativeIslands<double> representative_islands(const HeightMap<double>&,
                                                                           const IslandOptions<double>&,
                                                                           const IslandSpread&);
FSTIFF_SCENE_INSTANCE SurfaceParameters<double> surface_parameters(const LevelledProfile<double>&,
                                                                   const SurfaceParameterOptions<double>&);
FSTIFF_SCENE_INSTANCE SurfaceParameters<double> surface_parameters(const LevelledMap<double>&,
                                                                   const SurfaceParameterOptions<double>&);

FSTIFF_SCENE_INSTANCE SpectrumShells<double> map_spectrum(const HeightMap<double>&, Edges);
FSTIFF_SCENE_INSTANCE Summits<double> summits_of(const HeightMap<double>&);
FSTIFF_SCENE_INSTANCE HeightStatistics<double> height_statistics(const Profile<double>&);
FSTIFF_SCENE_INSTANCE HeightStatistics<double> height_statistics(const HeightMap<double>&);
FSTIFF_SCENE_INSTANCE class ShapeOfHeights<double>;
FSTIFF_SCENE_INSTANCE CleaningReport clean(Profile<double>&, const Cleaning<double>&);
FSTIFF_SCENE_INSTANCE CleaningReport clean(HeightMap<double>&, const Cleaning<double>&);
FSTIFF_SCENE_INSTANCE PreparedProfile<double> prepare(const Profile<double>&, const MeasureOptions<double>&);
FSTIFF_SCENE_INSTANCE PreparedMap<double> prepare(const HeightMap<double>&, const MeasureOptions<double>&);
FSTIFF_SCENE_INSTANCE PreparedMap<double> prepare(HeightMap<double>&&, const MeasureOptions<double>&);
FSTIFF_SCENE_INSTANCE Surface<double> measure(const Profile<double>&, const MeasureOptions<double>&);
FSTIFF_SCENE_INSTANCE Surface<double> measure(const HeightMap<double>&, const MeasureOptions<double>&);
FSTIFF_SCENE_INSTANCE Surface<double> measure(HeightMap<double>&&, const MeasureOptions<double>&);
FSTIFF_SCENE_INSTANCE class BoundaryElements<double>;
FSTIFF_SCENE_INSTANCE std::vector<TruthPoint<double>> truth(const HeightMap<double>&, double,
                                                            const std::vector<double>&, const TruthOptions<double>&);

FSTIFF_SCENE_INSTANCE Profile<double> self_affine_profile(const SelfAffineOptions<double>&, std::size_t, double);
FSTIFF_SCENE_INSTANCE HeightMap<double> self_affine_map(const SelfAffineOptions<double>&, std::size_t, std::size_t,
                                                        double, double);
FSTIFF_SCENE_INSTANCE class WeierstrassMandelbrot<double>;

}  // namespace fstiff
