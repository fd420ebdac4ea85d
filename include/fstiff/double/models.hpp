// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Contacts in double that the answer is made of, what makes a table of them and what fits them: the command has them
/// too. For double/contacts.hpp.

#include <fstiff/asperity/laws.hpp>
#include <fstiff/asperity/plastic_laws.hpp>
#include <fstiff/contact/crossover.hpp>
#include <fstiff/contact/hybrid_contact.hpp>
#include <fstiff/contact/hybrid_of_band.hpp>
#include <fstiff/contact/mutual_summits.hpp>
#include <fstiff/contact/persson_contact.hpp>
#include <fstiff/contact/rough_contact.hpp>
#include <fstiff/contact/summit_contact.hpp>
#include <fstiff/double/integrals.hpp>
#include <fstiff/double/surfaces.hpp>
#include <fstiff/identify/identify.hpp>
#include <fstiff/surface/band_spectrum.hpp>
#include <fstiff/surface/material_ratio_slope.hpp>
#include <fstiff/tabulated/law_tabulator.hpp>
#include <fstiff/topography/gaussian_order.hpp>

namespace fstiff { inline namespace v0_1 {

FSTIFF_DOUBLE class RoughContact<double, HertzLaw<double>>;
FSTIFF_DOUBLE class RoughContact<double, PlasticLaw<double>>;
FSTIFF_DOUBLE class RoughContact<double, JacksonGreenLaw<double>>;
FSTIFF_DOUBLE class RoughContact<double, KogutEtsionLaw<double>>;
FSTIFF_DOUBLE class detail::PerssonSeparation<double>;
FSTIFF_DOUBLE class PerssonContact<double>;
FSTIFF_DOUBLE class detail::PointForces<double, detail::FineSplit>;
FSTIFF_DOUBLE class detail::PointForces<double, detail::QuickSplit>;
FSTIFF_DOUBLE class detail::MutualSummits<double>;
FSTIFF_DOUBLE class SummitContact<double>;
FSTIFF_DOUBLE class HybridContact<double, SummitContact<double>, Crossover<double>>;
FSTIFF_DOUBLE detail::GaussianOrder<double> detail::gaussian_order(const HeightMap<double>&);
FSTIFF_DOUBLE Crossover<double> detail::hand_over_of(const Summits<double>&, const MaterialRatioContact<double>&,
                                                     Edges);
FSTIFF_DOUBLE class HybridContact<double, detail::BandHills<double>>;
FSTIFF_DOUBLE HybridContact<double, detail::BandHills<double>> hybrid_of_band(const BandSpectrum<double>&, double,
                                                                              double);
FSTIFF_DOUBLE class ScaledContact<double, HybridContact<double, detail::BandHills<double>>>;
FSTIFF_DOUBLE ScaledContact<double, HybridContact<double, detail::BandHills<double>>> hybrid_of_band(
    const BandSpectrum<double>&, const MaterialRatioSlope<double>&, double, double);

FSTIFF_DOUBLE class detail::KinkedTables<double>;
FSTIFF_DOUBLE class detail::KinkedTabulator<double>;
FSTIFF_DOUBLE detail::LawTables<double> detail::tables_of(const detail::LawModel<double>&, double, double);

FSTIFF_DOUBLE math::SingularVectors<double> math::singular_vectors(Eigen::MatrixXd);
FSTIFF_DOUBLE class detail::CurveModel<double>;
FSTIFF_DOUBLE class detail::FitSummary<double>;
FSTIFF_DOUBLE Identification<double> detail::identify_curve(const std::vector<Observation<double>>&,
                                                            const std::vector<Parameter>&,
                                                            const ContactParameters<double>&,
                                                            const detail::CurveOfParameters<double>&,
                                                            IdentifyOptions<double>);
FSTIFF_DOUBLE math::LeastSquaresFit<double> math::least_squares(const Eigen::VectorXd&, Eigen::Index,
                                                                const detail::FitCurve<double>&,
                                                                const math::LeastSquaresOptions<double>&);

}}  // namespace fstiff
