// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Explanation of the answer: kind of stiffness, its law and the causes of its band; and warnings about results.

#include "actions/answered.hpp"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fstiff::actions {

/// Answered::explanation and Answered::short_explanation of \p answered; empty where nothing answers.
[[nodiscard]] std::pair<std::vector<std::string>, std::vector<std::string>> explanation_of(const Answered& answered);

/// What a plasticity index above 1 means.
inline constexpr std::string_view yielding_peaks =
    "the highest peaks yield at first loading; where more of them do, elastic laws give too small a K for vibration";
/// The \p most greatest of \p causes of a band that are a tenth of it or more: "law 62 %, cut-offs 30 %".
[[nodiscard]] std::string shown_causes(const Causes<double>& causes, std::size_t most = 2);
/// Effects outside the band of \p answered, in one line.
[[nodiscard]] std::string outside_band(const Answered& answered);
/// The measurement that narrows the band of the middle point most, and the factor that comes out when it finds the
/// assumed value; empty where none narrows it by a twentieth.
[[nodiscard]] std::string measure_next(const Answered& answered);
/// Origin of the bands of \p answered.
[[nodiscard]] std::string origin_of_band(const Answered& answered);
/// Why the laws that are named have no band.
[[nodiscard]] std::string why_no_band(const Answered& answered);

/// Adds to \p answered, which is complete without them, its warnings and whether it is doubtful.
void add_warnings(Answered& answered);

}  // namespace fstiff::actions
