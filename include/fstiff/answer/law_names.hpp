// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The laws of contact by their names, as scenes, commands and documents have them.
///
///     name_of(fstiff::LawKind::hybrid)          "hybrid"

#include <fstiff/core/names.hpp>

namespace fstiff { inline namespace v0_1 {

/// The laws of contact.
enum class LawKind {
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
inline constexpr auto enum_names<LawKind> =
    detail::name_list<LawKind>({{LawKind::fractal, "fractal"},
                                {LawKind::fractal_consistent, "fractal_consistent"},
                                {LawKind::hertz, "hertz"},
                                {LawKind::greenwood_williamson, "greenwood_williamson"},
                                {LawKind::hybrid, "hybrid"},
                                {LawKind::persson, "persson"},
                                {LawKind::summits, "summits"},
                                {LawKind::plastic, "plastic"},
                                {LawKind::plastic_peaks, "plastic_peaks"},
                                {LawKind::jackson_green, "jackson_green"},
                                {LawKind::kogut_etsion, "kogut_etsion"},
                                {LawKind::boundary_elements, "boundary_elements"},
                                {LawKind::proportional, "proportional"}});

}}  // namespace fstiff
