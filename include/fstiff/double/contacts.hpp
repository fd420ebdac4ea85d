// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Contacts and their tabulated law in double, with all else that the library fstiff::double has compiled once. A file
/// that includes this, and is linked with fstiff::double, compiles in a quarter to an eighth of the time
/// (docs/linking-cpp.md).

#include <fstiff/contact/greenwood_williamson.hpp>
#include <fstiff/contact/hybrid_of_band.hpp>
#include <fstiff/contact/hybrid_of_map.hpp>
#include <fstiff/contact/rough_contact.hpp>
#include <fstiff/double/integrals.hpp>
#include <fstiff/double/models.hpp>
#include <fstiff/double/surfaces.hpp>
#include <fstiff/identify/identify.hpp>
#include <fstiff/surface/band_spectrum.hpp>
#include <fstiff/surface/material_ratio_slope.hpp>
#include <fstiff/tabulated/contact_law.hpp>
#include <fstiff/tabulated/law_after.hpp>
#include <fstiff/tabulated/slip_motion.hpp>

namespace fstiff { inline namespace v0_1 {

FSTIFF_DOUBLE class RoughContact<double, FractalLaw<double>>;
FSTIFF_DOUBLE class RoughContact<double, FractalConsistentLaw<double>>;
FSTIFF_DOUBLE class ContactLaw<double>;
FSTIFF_DOUBLE ContactLaw<double> ContactLaw<double>::tabulate(const RoughContact<double, HertzLaw<double>>&,
                                                              const LawRange<double>&);

FSTIFF_DOUBLE HybridContact<double, SummitContact<double>, Crossover<double>> hybrid_of_map(const HeightMap<double>&,
                                                                                            double, Edges);
FSTIFF_DOUBLE ContactLaw<double> ContactLaw<double>::tabulate(
    const HybridContact<double, SummitContact<double>, Crossover<double>>&, const LawRange<double>&);
FSTIFF_DOUBLE ContactLaw<double> ContactLaw<double>::tabulate(const HybridContact<double, detail::BandHills<double>>&,
                                                              const LawRange<double>&);
FSTIFF_DOUBLE ContactLaw<double> ContactLaw<double>::tabulate(
    const ScaledContact<double, HybridContact<double, detail::BandHills<double>>>&, const LawRange<double>&);

FSTIFF_DOUBLE class TangentialLaw<double>;
FSTIFF_DOUBLE TangentialLaw<double>::Response<1> TangentialLaw<double>::step(const SlipState<double, 1>&, double,
                                                                             const TangentialLaw<double>::Vector<1>&,
                                                                             SlipState<double, 1>&) const;
FSTIFF_DOUBLE TangentialLaw<double>::Response<2> TangentialLaw<double>::step(const SlipState<double, 2>&, double,
                                                                             const TangentialLaw<double>::Vector<2>&,
                                                                             SlipState<double, 2>&) const;
FSTIFF_DOUBLE void slip_responses(std::span<const TangentialLaw<double>* const>, const SlipMotion<double>&,
                                  SlipResponses<double>&, const ParallelHook&);
FSTIFF_DOUBLE ContactLaw<double> law_after(const ContactLaw<double>&, double, double);

}}  // namespace fstiff
