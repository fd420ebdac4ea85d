// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Contacts and their tabulated law in double, with all else that the library fstiff::double has compiled once. A file
/// that includes this, and is linked with fstiff::double, compiles in a quarter to an eighth of the time
/// (docs/linking-cpp.md).

#include <fstiff/asperity/laws.hpp>
#include <fstiff/asperity/plastic_laws.hpp>
#include <fstiff/contact/contact_law.hpp>
#include <fstiff/contact/greenwood_williamson.hpp>
#include <fstiff/contact/hybrid_contact.hpp>
#include <fstiff/contact/persson_contact.hpp>
#include <fstiff/contact/rough_contact.hpp>
#include <fstiff/contact/summit_contact.hpp>
#include <fstiff/double/integrals.hpp>
#include <fstiff/double/surfaces.hpp>

namespace fstiff::inline v0_1 {

FSTIFF_DOUBLE class RoughContact<double, HertzLaw<double>>;
FSTIFF_DOUBLE class RoughContact<double, FractalLaw<double>>;
FSTIFF_DOUBLE class RoughContact<double, FractalConsistentLaw<double>>;
FSTIFF_DOUBLE class RoughContact<double, PlasticLaw<double>>;
FSTIFF_DOUBLE class RoughContact<double, JacksonGreenLaw<double>>;
FSTIFF_DOUBLE class RoughContact<double, KogutEtsionLaw<double>>;
FSTIFF_DOUBLE class PerssonContact<double>;
FSTIFF_DOUBLE class SummitContact<double>;
FSTIFF_DOUBLE class ContactLaw<double>;
FSTIFF_DOUBLE ContactLaw<double> ContactLaw<double>::tabulate(const RoughContact<double, HertzLaw<double>>&,
                                                              const LawRange<double>&);

}  // namespace fstiff::inline v0_1
