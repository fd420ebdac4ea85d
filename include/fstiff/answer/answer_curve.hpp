// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The answer: one K for each point, by the law that holds there, with the causes of its band.

#include <fstiff/answer/curves.hpp>
#include <fstiff/answer/face.hpp>
#include <fstiff/answer/request.hpp>

#include <optional>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// In which form the laws have the surface.
[[nodiscard]] KnownAs known_as(const ResolvedJoint& problem);

/// The error of \p law at the p* of \p reason, with that of the grid \p relative to K.
[[nodiscard]] CauseSpread<double> law_error(const ResolvedJoint& problem, LawKind law, const AnswerReason& reason,
                                            double relative = 0);
/// Noise over the rms height, above which it is a concern.
inline constexpr double most_noise = 0.05;
/// Rms height [m] of the noise in the map of \p face; 0 of none, and where lambda_s was given.
[[nodiscard]] double noise_of(const Face& face, Edges edges);

/// Whether the laws take the spectrum of a map of \p face.
[[nodiscard]] bool is_map(const Face& face);
/// Boundary elements at one point of a request.
struct Solved {
    double weight = 0;  ///< next to the law of the summits; 0: not solved
    ContactState<double> state{};
    CauseSpread<double> cut_offs{};
    double noise = 0;                      ///< change of ln K once the noise of the map is gone
    std::optional<double> earlier_load{};  ///< change of ln K by the greater load that the map has carried
    std::optional<double> separation_at_seating{};
};

/// The side [m] of what was measured: of a profile its length, of a map the root of its area; 0 for numbers.
[[nodiscard]] double measured_side(const ResolvedJoint& problem);
/// What the form of \p problem, which is not known, may lower K at a state with \p K [Pa/m] under \p pressure [Pa].
/// None without a nominal area, and where a face was measured over all of it.
[[nodiscard]] CauseSpread<double> spread_of_form(const ResolvedJoint& problem, double K, double pressure);
/// The band of a state with \p K [Pa/m], by \p causes.
[[nodiscard]] SampledBand<double> band_about(double K, const Causes<double>& causes);
/// Widens \p bands where an end falls as the pressure of \p states rises: parts that shrink with p, such as the error
/// of the grid, are known to their own size alone.
void make_ends_rise(const std::vector<ContactState<double>>& states, std::vector<SampledBand<double>>& bands);

/// Makes \p curve, of law_of_answer() with its states and its band, the answer: at points where boundary elements of
/// the map know more they take its place, and the band takes in every cause. \p contact is that of its law, null of a
/// map. \p progress is called while boundary elements are solved.
[[nodiscard]] AnswerFacts make_answer(const ResolvedJoint& problem, const Request& request, LawCurve& curve,
                                      const AnyContact* contact, const ProgressHook& progress);

}}}  // namespace fstiff::detail
