// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// What many tests use in double precision, compiled once: of the command in instances/instances.cpp, the rest in
// support/instances.cpp with the flags of the tests. It is part of the precompiled header, so that every test has it.

#include "instances/contact_instances.hpp"
#include "instances/surface_instances.hpp"

#include <fstiff/asperity/laws.hpp>
#include <fstiff/asperity/plastic_laws.hpp>
#include <fstiff/contact/contact_law.hpp>
#include <fstiff/contact/greenwood_williamson.hpp>
#include <fstiff/contact/hybrid_contact.hpp>
#include <fstiff/contact/persson_contact.hpp>
#include <fstiff/contact/rough_contact.hpp>
#include <fstiff/contact/summit_contact.hpp>

namespace fstiff {

FSTIFF_SCENE_INSTANCE class RoughContact<double, HertzLaw<double>>;
FSTIFF_SCENE_INSTANCE class RoughContact<double, FractalLaw<double>>;
FSTIFF_SCENE_INSTANCE class RoughContact<double, FractalConsistentLaw<double>>;
FSTIFF_SCENE_INSTANCE class RoughContact<double, PlasticLaw<double>>;
FSTIFF_SCENE_INSTANCE class RoughContact<double, JacksonGreenLaw<double>>;
FSTIFF_SCENE_INSTANCE class RoughContact<double, KogutEtsionLaw<double>>;
FSTIFF_SCENE_INSTANCE class PerssonContact<double>;
FSTIFF_SCENE_INSTANCE class SummitContact<double>;
FSTIFF_SCENE_INSTANCE class ContactLaw<double>;
FSTIFF_SCENE_INSTANCE ContactLaw<double> ContactLaw<double>::tabulate(const RoughContact<double, HertzLaw<double>>&,
                                                                      const LawRange<double>&);

}  // namespace fstiff
