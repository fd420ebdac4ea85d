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

FSTIFF_SCENE_INSTANCE FractalFit<double> parts::fit_measured(const parts::MeasuredStructureFunction<double>&,
                                                              const parts::FractalFitOptions<double>&, double);
FSTIFF_SCENE_INSTANCE FractalFit<double> parts::fit_profile(const Profile<double>&,
                                                            const parts::FractalFitOptions<double>&);
FSTIFF_SCENE_INSTANCE parts::DirectionalFit<double> parts::fit_directions(const HeightMap<double>&,
                                                                          const parts::FractalFitOptions<double>&);
FSTIFF_SCENE_INSTANCE StructureFunction<double> parts::structure_function_at_all_lags(const Profile<double>&,
                                                                                      std::size_t, parts::Divisor);
FSTIFF_SCENE_INSTANCE PowerSpectrum<double> power_spectrum(const Profile<double>&, SpectrumWindow);
FSTIFF_SCENE_INSTANCE Autocorrelation<double> autocorrelation(const Profile<double>&);
FSTIFF_SCENE_INSTANCE RoughnessParameters<double> roughness_parameters(const Profile<double>&, std::optional<double>);
FSTIFF_SCENE_INSTANCE parts::MaterialRatio<double> parts::material_ratio(std::span<const double>);
FSTIFF_SCENE_INSTANCE PeakStatistics<double> peak_statistics(const Profile<double>&);
FSTIFF_SCENE_INSTANCE Profile<double> parts::gaussian_low_pass(const Profile<double>&, double);
FSTIFF_SCENE_INSTANCE Profile<double> parts::gaussian_roughness(const Profile<double>&, double);
FSTIFF_SCENE_INSTANCE HeightMap<double> parts::gaussian_low_pass(const HeightMap<double>&, double);
FSTIFF_SCENE_INSTANCE HeightMap<double> parts::gaussian_high_pass(const HeightMap<double>&, double);
FSTIFF_SCENE_INSTANCE math::RobustWaviness<Profile<double>> parts::robust_waviness(const Profile<double>&, double, int);
FSTIFF_SCENE_INSTANCE math::RobustWaviness<HeightMap<double>> parts::robust_waviness(const HeightMap<double>&, double);
FSTIFF_SCENE_INSTANCE HeightMap<double> parts::remove_form(const HeightMap<double>&, MapForm);
FSTIFF_SCENE_INSTANCE parts::ArealStatistics<double> parts::areal_statistics(const HeightMap<double>&);
FSTIFF_SCENE_INSTANCE ArealParameters<double> areal_parameters(const HeightMap<double>&,
                                                               const parts::ArealStatistics<double>&);
FSTIFF_SCENE_INSTANCE parts::ArealAutocorrelation<double> parts::areal_autocorrelation(const HeightMap<double>&,
                                                                                       parts::LagPairs);
FSTIFF_SCENE_INSTANCE parts::RadialAutocorrelation<double> parts::radial_autocorrelation(
    const parts::ArealAutocorrelation<double>&);
FSTIFF_SCENE_INSTANCE parts::TextureParameters<double> parts::texture_parameters(
    const parts::ArealAutocorrelation<double>&, double);
FSTIFF_SCENE_INSTANCE RadialSpectrum<double> radial_spectrum(const HeightMap<double>&, SpectrumWindow);
FSTIFF_SCENE_INSTANCE IslandCurve<double> island_curve(const HeightMap<double>&, const IslandOptions<double>&);
FSTIFF_SCENE_INSTANCE RepresentativeIslands<double> representative_islands(const HeightMap<double>&,
                                                                           const IslandOptions<double>&,
                                                                           const parts::IslandSpread&);
FSTIFF_SCENE_INSTANCE parts::SurfaceParameters<double> parts::surface_parameters(const parts::LevelledProfile<double>&,
                                                                   const parts::SurfaceParameterOptions<double>&);
FSTIFF_SCENE_INSTANCE parts::SurfaceParameters<double> parts::surface_parameters(const parts::LevelledMap<double>&,
                                                                   const parts::SurfaceParameterOptions<double>&);

FSTIFF_SCENE_INSTANCE SpectrumShells<double> map_spectrum(const HeightMap<double>&, Edges);
FSTIFF_SCENE_INSTANCE Summits<double> summits_of(const HeightMap<double>&);
FSTIFF_SCENE_INSTANCE HeightStatistics<double> height_statistics(const Profile<double>&);
FSTIFF_SCENE_INSTANCE HeightStatistics<double> height_statistics(const HeightMap<double>&);
FSTIFF_SCENE_INSTANCE class parts::ShapeOfHeights<double>;
FSTIFF_SCENE_INSTANCE parts::CleaningReport parts::clean(Profile<double>&, const Cleaning<double>&);
FSTIFF_SCENE_INSTANCE parts::CleaningReport parts::clean(HeightMap<double>&, const Cleaning<double>&);
FSTIFF_SCENE_INSTANCE parts::PreparedProfile<double> parts::prepare(const Profile<double>&,
                                                                    const MeasureOptions<double>&);
FSTIFF_SCENE_INSTANCE parts::PreparedMap<double> parts::prepare(const HeightMap<double>&,
                                                                const MeasureOptions<double>&);
FSTIFF_SCENE_INSTANCE parts::PreparedMap<double> parts::prepare(HeightMap<double>&&, const MeasureOptions<double>&);
FSTIFF_SCENE_INSTANCE Surface<double> measure(const Profile<double>&, const MeasureOptions<double>&);
FSTIFF_SCENE_INSTANCE Surface<double> measure(const HeightMap<double>&, const MeasureOptions<double>&);
FSTIFF_SCENE_INSTANCE Surface<double> measure(HeightMap<double>&&, const MeasureOptions<double>&);
FSTIFF_SCENE_INSTANCE class BoundaryElements<double>;
FSTIFF_SCENE_INSTANCE std::vector<TruthPoint<double>> truth(const HeightMap<double>&, double,
                                                            const std::vector<double>&,
                                                            const parts::TruthOptions<double>&);

FSTIFF_SCENE_INSTANCE Profile<double> self_affine_profile(const SelfAffineOptions<double>&, std::size_t, double);
FSTIFF_SCENE_INSTANCE HeightMap<double> self_affine_map(const SelfAffineOptions<double>&, std::size_t, std::size_t,
                                                        double, double);
FSTIFF_SCENE_INSTANCE class WeierstrassMandelbrot<double>;

}  // namespace fstiff
