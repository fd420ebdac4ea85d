// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The laws of contact by their names, as scenes, commands and documents have them.
///
///     name_of(fstiff::LawName::hybrid)          "hybrid"

#include <fstiff/core/names.hpp>

namespace fstiff { inline namespace v0_1 {

/// The laws of contact.
enum class LawName {
    none = -1,  ///< of a point without a result; it has no word
    fractal,
    fractal_consistent,
    hertz,
    greenwood_williamson,
    hybrid,
    persson,
    summits,
    plastic,
    plastic_peaks,
    jackson_green,
    kogut_etsion,
    boundary_elements,
    proportional
};

template <>
inline constexpr auto names<LawName> = detail::name_list<LawName>({{LawName::fractal, "fractal"},
                                                                   {LawName::fractal_consistent, "fractal_consistent"},
                                                                   {LawName::hertz, "hertz"},
                                                                   {LawName::greenwood_williamson,
                                                                    "greenwood_williamson"},
                                                                   {LawName::hybrid, "hybrid"},
                                                                   {LawName::persson, "persson"},
                                                                   {LawName::summits, "summits"},
                                                                   {LawName::plastic, "plastic"},
                                                                   {LawName::plastic_peaks, "plastic_peaks"},
                                                                   {LawName::jackson_green, "jackson_green"},
                                                                   {LawName::kogut_etsion, "kogut_etsion"},
                                                                   {LawName::boundary_elements, "boundary_elements"},
                                                                   {LawName::proportional, "proportional"}});

}}  // namespace fstiff
