// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Computations for a profile or a map in double, compiled once, in the library fstiff::double. Files that include this
/// are quick to compile and need no optimisation.

#include <fstiff/double/alignment.hpp>
#include <fstiff/halfspace/solve_half_space.hpp>
#include <fstiff/measure/height_shape.hpp>
#include <fstiff/measure/measure.hpp>
#include <fstiff/measure/parameters.hpp>
#include <fstiff/measure/sections.hpp>
#include <fstiff/profile/autocorrelation.hpp>
#include <fstiff/profile/fractal_fit.hpp>
#include <fstiff/profile/gaussian_filter.hpp>
#include <fstiff/profile/levelled_profile.hpp>
#include <fstiff/profile/peak_statistics.hpp>
#include <fstiff/profile/power_spectrum.hpp>
#include <fstiff/profile/roughness_parameters.hpp>
#include <fstiff/surface/band_spectrum.hpp>
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
#include <fstiff/topography/texture_direction.hpp>

#ifndef FSTIFF_DOUBLE
#define FSTIFF_DOUBLE extern template
#endif

namespace fstiff { inline namespace v0_1 {

FSTIFF_DOUBLE FractalFit<double> detail::fit_measured(const MeasuredStructureFunction<double>&,
                                                      const FractalFitOptions<double>&, double);
FSTIFF_DOUBLE FractalFit<double> detail::fit_profile(const Profile<double>&, const FractalFitOptions<double>&);
FSTIFF_DOUBLE DirectionalFit<double> detail::fit_directions(const HeightMap<double>&, const FractalFitOptions<double>&);
FSTIFF_DOUBLE PowerSpectrum<double> power_spectrum(const Profile<double>&, SpectrumWindow);
FSTIFF_DOUBLE Autocorrelation<double> autocorrelation(const Profile<double>&);
FSTIFF_DOUBLE RoughnessParameters<double> roughness_parameters(const Profile<double>&, std::optional<double>);
FSTIFF_DOUBLE detail::MaterialRatio<double> detail::material_ratio(std::span<const double>);
FSTIFF_DOUBLE PeakStatistics<double> peak_statistics(const Profile<double>&);
FSTIFF_DOUBLE Profile<double> detail::gaussian_low_pass(const Profile<double>&, double);
FSTIFF_DOUBLE Profile<double> detail::gaussian_roughness(const Profile<double>&, double);
FSTIFF_DOUBLE HeightMap<double> detail::gaussian_low_pass(const HeightMap<double>&, double);
FSTIFF_DOUBLE HeightMap<double> detail::gaussian_high_pass(const HeightMap<double>&, double);
FSTIFF_DOUBLE math::RobustWaviness<Profile<double>> detail::robust_waviness(const Profile<double>&, double, int);
FSTIFF_DOUBLE math::RobustWaviness<HeightMap<double>> detail::robust_waviness(const HeightMap<double>&, double);
FSTIFF_DOUBLE HeightMap<double> detail::remove_form(const HeightMap<double>&, MapForm);
FSTIFF_DOUBLE ArealStatistics<double> detail::areal_statistics(const HeightMap<double>&);
FSTIFF_DOUBLE ArealParameters<double> areal_parameters(const HeightMap<double>&, const ArealStatistics<double>&);
FSTIFF_DOUBLE detail::ArealAutocorrelation<double> detail::areal_autocorrelation(const HeightMap<double>&,
                                                                                 detail::LagPairs);
FSTIFF_DOUBLE detail::RadialAutocorrelation<double> detail::radial_autocorrelation(
    const detail::ArealAutocorrelation<double>&);
FSTIFF_DOUBLE detail::TextureParameters<double> detail::texture_parameters(const detail::ArealAutocorrelation<double>&,
                                                                           double);
FSTIFF_DOUBLE RadialSpectrum<double> radial_spectrum(const HeightMap<double>&, SpectrumWindow);
FSTIFF_DOUBLE IslandCurve<double> island_curve(const HeightMap<double>&, const IslandOptions<double>&);
FSTIFF_DOUBLE RepresentativeIslands<double> representative_islands(const HeightMap<double>&,
                                                                   const IslandOptions<double>&, const IslandSpread&);
FSTIFF_DOUBLE SurfaceParameters<double> detail::surface_parameters(const LevelledProfile<double>&,
                                                                   const detail::SurfaceParameterOptions<double>&);
FSTIFF_DOUBLE SurfaceParameters<double> detail::surface_parameters(const LevelledMap<double>&,
                                                                   const detail::SurfaceParameterOptions<double>&);

FSTIFF_DOUBLE SpectrumShells<double> map_spectrum(const HeightMap<double>&, Edges);
FSTIFF_DOUBLE Summits<double> summits_of(const HeightMap<double>&);
FSTIFF_DOUBLE HeightStatistics<double> height_statistics(const Profile<double>&);
FSTIFF_DOUBLE HeightStatistics<double> height_statistics(const HeightMap<double>&);
FSTIFF_DOUBLE class detail::ShapeOfHeights<double>;
FSTIFF_DOUBLE CleaningReport detail::clean(Profile<double>&, const Cleaning<double>&);
FSTIFF_DOUBLE CleaningReport detail::clean(HeightMap<double>&, const Cleaning<double>&);
FSTIFF_DOUBLE PreparedProfile<double> prepare(const Profile<double>&, const MeasureOptions<double>&);
FSTIFF_DOUBLE PreparedMap<double> prepare(const HeightMap<double>&, const MeasureOptions<double>&);
FSTIFF_DOUBLE PreparedMap<double> prepare(HeightMap<double>&&, const MeasureOptions<double>&);
FSTIFF_DOUBLE Surface<double> measure(const Profile<double>&, const MeasureOptions<double>&);
FSTIFF_DOUBLE Surface<double> measure(const HeightMap<double>&, const MeasureOptions<double>&);
FSTIFF_DOUBLE Surface<double> measure(HeightMap<double>&&, const MeasureOptions<double>&);
FSTIFF_DOUBLE class BoundaryElements<double>;
FSTIFF_DOUBLE std::vector<HalfSpacePoint<double>> solve_half_space(const HeightMap<double>&, double,
                                                                   const std::vector<double>&,
                                                                   const HalfSpaceOptions<double>&);

FSTIFF_DOUBLE Profile<double> self_affine_profile(const SelfAffineOptions<double>&, std::size_t, double);
FSTIFF_DOUBLE HeightMap<double> self_affine_map(const SelfAffineOptions<double>&, std::size_t, std::size_t, double,
                                                double);
FSTIFF_DOUBLE class WeierstrassMandelbrot<double>;

// What those are made of, and many other files with them.
FSTIFF_DOUBLE class math::ComplexFft<double>;
FSTIFF_DOUBLE class math::RealFft<double>;
FSTIFF_DOUBLE class math::FftOfLines<double>;
FSTIFF_DOUBLE class math::FftOfLines<float>;
FSTIFF_DOUBLE class detail::LinesTransform<double>;
FSTIFF_DOUBLE class detail::LinesTransform<float>;
FSTIFF_DOUBLE class math::PivotedQr<double>;
FSTIFF_DOUBLE math::SymmetricEigen<double> math::symmetric_eigen(Eigen::MatrixXd);
FSTIFF_DOUBLE class math::GaussianSmoother<double>;
FSTIFF_DOUBLE void detail::validate_map(const double*, Eigen::Index, Eigen::Index, double, double, Eigen::Index);
FSTIFF_DOUBLE Profile<double> detail::detrend(const Profile<double>&, Form);
FSTIFF_DOUBLE class detail::LineFitter<double>;
FSTIFF_DOUBLE class MaterialRatioSlope<double>;

}}  // namespace fstiff
