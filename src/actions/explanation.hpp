// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Explanation of the answer: kind of stiffness, its law and the causes of its band; and warnings about results.

#include "actions/results.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace fstiff::actions {

struct Explanation {
    std::vector<std::string> sentences;  ///< three at most; none where nothing answers
    std::vector<std::string> shorter;    ///< for a picture: two at most
};
[[nodiscard]] Explanation explanation(const scene::Scene& scene, const Results& results);

/// What a plasticity index above 1 means.
inline constexpr std::string_view yielding_peaks =
    "the highest peaks yield at first loading; where more of them do, elastic laws give too small a K for vibration";
/// The \p most greatest causes of the band of \p reason that are a tenth of it or more: "law 62 %, cut-offs 30 %".
[[nodiscard]] std::string shown_causes(const detail::AnswerReason& reason, std::size_t most = 2);
/// Effects outside the band of \p results, in one line.
[[nodiscard]] std::string outside_band(const scene::Scene& scene, const Results& results);
/// The measurement that narrows the band of the middle point most, and the factor that comes out when it finds the
/// assumed value; empty where none narrows it by a twentieth.
[[nodiscard]] std::string measure_next(const scene::Scene& scene, const Results& results);
/// Origin of the bands of \p scene.
[[nodiscard]] std::string origin_of_band(const scene::Scene& scene);
/// Why the laws that \p scene names have no band.
[[nodiscard]] std::string why_no_band(const scene::Scene& scene, const Results& results);

/// Adds to \p results of \p scene, which are complete without them, their warnings and whether they are doubtful.
void add_warnings(const scene::Scene& scene, Results& results);

}  // namespace fstiff::actions
