// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Laws to choose from: AnswerOptions::laws and contact_of() take fstiff::laws::hybrid, for example. A header-only
/// program compiles those that it names.

#include <fstiff/answer/law_names.hpp>

namespace fstiff { inline namespace v0_1 {

namespace detail {

struct Law;

namespace law_rows {

[[nodiscard]] const Law& fractal();
[[nodiscard]] const Law& fractal_consistent();
[[nodiscard]] const Law& hertz();
[[nodiscard]] const Law& greenwood_williamson();
[[nodiscard]] const Law& hybrid();
[[nodiscard]] const Law& persson();
[[nodiscard]] const Law& summits();
[[nodiscard]] const Law& plastic();
[[nodiscard]] const Law& plastic_peaks();
[[nodiscard]] const Law& jackson_green();
[[nodiscard]] const Law& kogut_etsion();
[[nodiscard]] const Law& boundary_elements();
[[nodiscard]] const Law& proportional();

}  // namespace law_rows
}  // namespace detail

/// A law of namespace laws: its name, and what computes it.
struct ChosenLaw {
    LawKind which = LawKind::none;
    const detail::Law& (*row)() = nullptr;  ///< null: no law
};

/// Every law that can be chosen.
namespace laws {

inline constexpr ChosenLaw fractal{LawKind::fractal, detail::law_rows::fractal},
    fractal_consistent{LawKind::fractal_consistent, detail::law_rows::fractal_consistent},
    hertz{LawKind::hertz, detail::law_rows::hertz},
    greenwood_williamson{LawKind::greenwood_williamson, detail::law_rows::greenwood_williamson},
    hybrid{LawKind::hybrid, detail::law_rows::hybrid}, persson{LawKind::persson, detail::law_rows::persson},
    summits{LawKind::summits, detail::law_rows::summits}, plastic{LawKind::plastic, detail::law_rows::plastic},
    plastic_peaks{LawKind::plastic_peaks, detail::law_rows::plastic_peaks},
    jackson_green{LawKind::jackson_green, detail::law_rows::jackson_green},
    kogut_etsion{LawKind::kogut_etsion, detail::law_rows::kogut_etsion},
    boundary_elements{LawKind::boundary_elements, detail::law_rows::boundary_elements},
    proportional{LawKind::proportional, detail::law_rows::proportional};

}  // namespace laws
}}  // namespace fstiff
