// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Computations for a profile or a map in double, compiled once, in the library fstiff::double. Files that include this
/// are quick to compile and need no optimisation.

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

#ifndef FSTIFF_DOUBLE
#define FSTIFF_DOUBLE extern template
#endif

namespace fstiff::inline v0_1 {

FSTIFF_DOUBLE FractalFit<double> parts::fit_measured(const parts::MeasuredStructureFunction<double>&,
                                                     const parts::FractalFitOptions<double>&, double);
FSTIFF_DOUBLE FractalFit<double> parts::fit_profile(const Profile<double>&, const parts::FractalFitOptions<double>&);
FSTIFF_DOUBLE parts::DirectionalFit<double> parts::fit_directions(const HeightMap<double>&,
                                                                  const parts::FractalFitOptions<double>&);
FSTIFF_DOUBLE StructureFunction<double> parts::structure_function_at_all_lags(const Profile<double>&, std::size_t,
                                                                              parts::Divisor);
FSTIFF_DOUBLE PowerSpectrum<double> power_spectrum(const Profile<double>&, SpectrumWindow);
FSTIFF_DOUBLE Autocorrelation<double> autocorrelation(const Profile<double>&);
FSTIFF_DOUBLE RoughnessParameters<double> roughness_parameters(const Profile<double>&, std::optional<double>);
FSTIFF_DOUBLE parts::MaterialRatio<double> parts::material_ratio(std::span<const double>);
FSTIFF_DOUBLE PeakStatistics<double> peak_statistics(const Profile<double>&);
FSTIFF_DOUBLE Profile<double> parts::gaussian_low_pass(const Profile<double>&, double);
FSTIFF_DOUBLE Profile<double> parts::gaussian_roughness(const Profile<double>&, double);
FSTIFF_DOUBLE HeightMap<double> parts::gaussian_low_pass(const HeightMap<double>&, double);
FSTIFF_DOUBLE HeightMap<double> parts::gaussian_high_pass(const HeightMap<double>&, double);
FSTIFF_DOUBLE math::RobustWaviness<Profile<double>> parts::robust_waviness(const Profile<double>&, double, int);
FSTIFF_DOUBLE math::RobustWaviness<HeightMap<double>> parts::robust_waviness(const HeightMap<double>&, double);
FSTIFF_DOUBLE HeightMap<double> parts::remove_form(const HeightMap<double>&, MapForm);
FSTIFF_DOUBLE parts::ArealStatistics<double> parts::areal_statistics(const HeightMap<double>&);
FSTIFF_DOUBLE ArealParameters<double> areal_parameters(const HeightMap<double>&, const parts::ArealStatistics<double>&);
FSTIFF_DOUBLE parts::ArealAutocorrelation<double> parts::areal_autocorrelation(const HeightMap<double>&,
                                                                               parts::LagPairs);
FSTIFF_DOUBLE parts::RadialAutocorrelation<double> parts::radial_autocorrelation(
    const parts::ArealAutocorrelation<double>&);
FSTIFF_DOUBLE parts::TextureParameters<double> parts::texture_parameters(const parts::ArealAutocorrelation<double>&,
                                                                         double);
FSTIFF_DOUBLE RadialSpectrum<double> radial_spectrum(const HeightMap<double>&, SpectrumWindow);
FSTIFF_DOUBLE IslandCurve<double> island_curve(const HeightMap<double>&, const IslandOptions<double>&);
FSTIFF_DOUBLE RepresentativeIslands<double> representative_islands(const HeightMap<double>&,
                                                                   const IslandOptions<double>&,
                                                                   const parts::IslandSpread&);
FSTIFF_DOUBLE parts::SurfaceParameters<double> parts::surface_parameters(const parts::LevelledProfile<double>&,
                                                                         const parts::SurfaceParameterOptions<double>&);
FSTIFF_DOUBLE parts::SurfaceParameters<double> parts::surface_parameters(const parts::LevelledMap<double>&,
                                                                         const parts::SurfaceParameterOptions<double>&);

FSTIFF_DOUBLE SpectrumShells<double> map_spectrum(const HeightMap<double>&, Edges);
FSTIFF_DOUBLE Summits<double> summits_of(const HeightMap<double>&);
FSTIFF_DOUBLE HeightStatistics<double> height_statistics(const Profile<double>&);
FSTIFF_DOUBLE HeightStatistics<double> height_statistics(const HeightMap<double>&);
FSTIFF_DOUBLE class parts::ShapeOfHeights<double>;
FSTIFF_DOUBLE parts::CleaningReport parts::clean(Profile<double>&, const Cleaning<double>&);
FSTIFF_DOUBLE parts::CleaningReport parts::clean(HeightMap<double>&, const Cleaning<double>&);
FSTIFF_DOUBLE parts::PreparedProfile<double> parts::prepare(const Profile<double>&, const MeasureOptions<double>&);
FSTIFF_DOUBLE parts::PreparedMap<double> parts::prepare(const HeightMap<double>&, const MeasureOptions<double>&);
FSTIFF_DOUBLE parts::PreparedMap<double> parts::prepare(HeightMap<double>&&, const MeasureOptions<double>&);
FSTIFF_DOUBLE Surface<double> measure(const Profile<double>&, const MeasureOptions<double>&);
FSTIFF_DOUBLE Surface<double> measure(const HeightMap<double>&, const MeasureOptions<double>&);
FSTIFF_DOUBLE Surface<double> measure(HeightMap<double>&&, const MeasureOptions<double>&);
FSTIFF_DOUBLE class BoundaryElements<double>;
FSTIFF_DOUBLE std::vector<TruthPoint<double>> truth(const HeightMap<double>&, double, const std::vector<double>&,
                                                    const parts::TruthOptions<double>&);

FSTIFF_DOUBLE Profile<double> self_affine_profile(const SelfAffineOptions<double>&, std::size_t, double);
FSTIFF_DOUBLE HeightMap<double> self_affine_map(const SelfAffineOptions<double>&, std::size_t, std::size_t, double,
                                                double);
FSTIFF_DOUBLE class WeierstrassMandelbrot<double>;

}  // namespace fstiff::inline v0_1
