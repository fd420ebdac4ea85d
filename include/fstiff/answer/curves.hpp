// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The curves of a joint: of laws that are named, each with its band, and of the answer, with the causes of its band.

#include <fstiff/answer/answer.hpp>
#include <fstiff/answer/band.hpp>
#include <fstiff/answer/band_parts.hpp>
#include <fstiff/answer/causes.hpp>
#include <fstiff/answer/checks.hpp>
#include <fstiff/answer/law_choice.hpp>
#include <fstiff/answer/laws.hpp>
#include <fstiff/answer/request.hpp>
#include <fstiff/answer/resolved_joint.hpp>
#include <fstiff/contact/contact_state.hpp>
#include <fstiff/contact/rough_contact.hpp>
#include <fstiff/core/error.hpp>
#include <fstiff/math/quadrature.hpp>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace fstiff { inline namespace v0_1 { namespace detail {

using Miss = AnswerPoint::Miss;
/// A point that a law does not reach.
struct MissedPoint {
    std::size_t place = 0;  ///< among Request::points
    Miss why = Miss::law;
    std::string reason{};  ///< of the law
    double limit = 0;      ///< the pressure of Miss::hardness and Miss::closed [Pa]
};
/// Why \p missed, at \p pressure [Pa], has no state; \p text is a pressure with its unit.
[[nodiscard]] std::string reason_of(const ResolvedJoint& problem, const MissedPoint& missed, double pressure,
                                    std::string (*text)(double pressure));

/// What the form of a joint makes of one state.
struct FormOfState {
    double touching_share = 1;           ///< of the nominal area
    double greatest_local_pressure = 0;  ///< [Pa]
};

/// One law on one joint distribution of peaks, at every point that the law reaches.
struct LawCurve {
    const Law* law = nullptr;
    std::optional<double> theta{}, r{};    ///< none: a law without a joint distribution
    std::optional<double> rms_gradient{};  ///< of the surface, for p*; the same in every curve
    std::vector<ContactState<double>> states{};
    std::vector<std::size_t> places{};            ///< of the states among Request::points
    std::vector<MissedPoint> missed{};            ///< the other points
    std::vector<double> separation_at_seating{};  ///< separation at Request::seating [m], one a state; empty: not known
    std::string no_separation_at_seating{};       ///< why not, where it was asked for
    std::vector<double> log_slopes{};         ///< d log K/d log p below each state; empty: not asked for, or not known
    std::vector<Check<double>> checks{};      ///< of the states as the law gives them
    std::vector<LoadMeans<double>> means{};   ///< of a plastic law, one a state
    std::vector<SampledBand<double>> band{};  ///< of the stiffness, one a state; empty: it has none
    std::vector<BandParts<double>> band_parts{};  ///< of the band, where the surface has neighbours
    std::vector<FormOfState> form{};              ///< of each state, where the joint has a form
    std::shared_ptr<const LawCurve> faces{};      ///< the same curve of the faces, under the nominal pressures
    std::vector<const Law*> by{};                 ///< of an answer, the law of each state; empty: `law` gave all

    [[nodiscard]] const Law& law_at(std::size_t state) const { return by.empty() ? *law : *by[state]; }
    /// Index of the state of the point \p place; none where the law does not reach it.
    [[nodiscard]] std::optional<std::size_t> state_at(std::size_t place) const;
};

/// Why K of the answer at one state is what it is.
struct AnswerReason {
    Causes<double> causes{};         ///< of the band
    std::optional<double> p_star;    ///< p/(E g)
    std::optional<double> contacts;  ///< expected on the area of the contact
    std::optional<double>
        loading_stiffness;  ///< [Pa/m] where the peaks yield: for a load that rises for the first time
};
/// What is known of an answer beyond its curve.
struct AnswerFacts {
    std::vector<AnswerReason> reasons;  ///< one a state
    bool of_map_itself = false;         ///< the contact is the measured map, and no other piece of the surface
    bool flows = false;                 ///< K is that of unloading
    double long_waves = 1;              ///< factor by which waves longer than the measurement are taken to lower K
    bool waves_at_least = false;  ///< waves longer than the measurement have no law: the band holds the least of them
    std::optional<double> relative_hardness;  ///< H/(E g)
};

/// All curves of a request.
struct Curves {
    std::vector<LawCurve> named;  ///< of Request::laws, one for each distribution of peaks
    std::optional<LawCurve>
        answer;               ///< one K for each point, by the law that holds there; without states: no law has one
    AnswerFacts facts{};      ///< of the answer
    std::string no_answer{};  ///< why there is none
    std::size_t failed = 0;   ///< greatest number of drawn surfaces without a K at some point
};

/// A contact, and its curve still without states.
struct MadeContact {
    LawCurve curve;
    std::shared_ptr<const AnyContact> contact;
};
/// The contacts of \p laws; \p problem must live as long.
[[nodiscard]] std::vector<MadeContact> contacts_of(const ResolvedJoint& problem, const std::vector<const Law*>& laws,
                                                   const ProgressHook& progress = {});

/// The answer of \p request, which names no law, into \p result.
void add_answer(ResolvedJoint problem, Request request, const ProgressHook& progress,
                const std::vector<MadeContact>* contacts, Curves& result);
/// Gives the answer of \p result, which is that of the faces, the form of \p problem. \throws domain_error at
/// separations.
void add_form(const ResolvedJoint& problem, const Request& request, const std::vector<MadeContact>* contacts,
              Curves& result);

/// Where the approach of \p curve, which has its states, begins, or why \p contact has no separation there.
void add_seating(const Request& request, const AnyContact& contact, LawCurve& curve);

/// The law that answers where no boundary elements do: plastic where the peaks yield, hybrid where they do not. A map
/// with missing points answers by its numbers: \p problem takes no spectrum of it then.
/// \throws domain_error where no law answers.
[[nodiscard]] const Law& law_of_answer(ResolvedJoint& problem, bool at_separations);

/// What \p request asks of \p problem, by \p contacts where they are those of its laws. Next to more than 100
/// points of named laws the answer is at Request::answered alone. No band and no answer where no named law has a state.
/// \throws domain_error where the model cannot give it.
[[nodiscard]] Curves curves_of(const ResolvedJoint& problem, const Request& request, const ProgressHook& progress = {},
                               const std::vector<MadeContact>* contacts = nullptr);

}}}  // namespace fstiff::detail
