// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The curves of a joint: of laws that are named, each with its band, and of the answer, with the causes of its band.

#include <fstiff/answer/band.hpp>
#include <fstiff/answer/causes.hpp>
#include <fstiff/answer/checks.hpp>
#include <fstiff/answer/law_choice.hpp>
#include <fstiff/answer/laws.hpp>
#include <fstiff/answer/problem.hpp>
#include <fstiff/contact/contact_state.hpp>
#include <fstiff/contact/rough_contact.hpp>
#include <fstiff/core/error.hpp>
#include <fstiff/math/quadrature.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace fstiff::inline v0_1::detail {

/// Why a law has no state at a point.
enum class Miss {
    law,       ///< by the reason that it gives
    range,     ///< a number is beyond the range of double precision
    hardness,  ///< the pressure reaches the hardness
    closed     ///< the contact is closed above a pressure
};
/// A point that a law does not reach.
struct MissedPoint {
    std::size_t place = 0;  ///< among Request::points
    Miss why = Miss::law;
    std::string reason{};  ///< of the law
    double limit = 0;      ///< the pressure of Miss::hardness and Miss::closed [Pa]
};
/// Why \p missed, at \p pressure [Pa], has no state; \p text is a pressure with its unit.
[[nodiscard]] std::string reason_of(const Problem& problem, const MissedPoint& missed, double pressure,
                                    std::string (*text)(double pressure));

/// One law on one joint distribution of peaks, at every point that the law reaches.
struct LawCurve {
    const Law* law = nullptr;
    std::optional<double> theta{}, r{};    ///< none: a law without a joint distribution
    std::optional<double> rms_gradient{};  ///< of the surface, for p*; the same in every curve
    std::vector<ContactState<double>> states{};
    std::vector<std::size_t> places{};        ///< of the states among Request::points
    std::vector<MissedPoint> missed{};        ///< the other points
    std::vector<double> seated{};             ///< separation at Request::seating [m], one a state; empty: not known
    std::string not_seated{};                 ///< why not, where it was asked for
    std::vector<double> growth{};             ///< d log K/d log p below each state; empty: not asked for, or not known
    std::vector<Check<double>> checks{};      ///< of the states as the law gives them
    std::vector<LoadMeans<double>> means{};   ///< of a plastic law, one a state
    std::vector<SampledBand<double>> band{};  ///< of the stiffness, one a state; empty: it has none
    std::vector<BandParts<double>> band_parts{};  ///< of the band, where the surface has neighbours
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
[[nodiscard]] std::vector<MadeContact> contacts_of(const Problem& problem, const std::vector<const Law*>& laws,
                                                   const ProgressHook& progress = {});

/// The law that answers where no boundary elements do: plastic where the peaks yield, hybrid where they do not. A map
/// with missing points answers by its numbers: \p problem takes no spectrum of it then.
/// \throws domain_error where no law answers.
[[nodiscard]] const Law& law_of_answer(Problem& problem, bool at_separations);

/// What \p request asks of \p problem, by \p contacts where they are those of its laws. Next to more than 100
/// points of named laws the answer is at Request::answered alone. No band and no answer where no named law has a state.
/// \throws domain_error where the model cannot give it.
[[nodiscard]] Curves curves_of(const Problem& problem, const Request& request, const ProgressHook& progress = {},
                               const std::vector<MadeContact>* contacts = nullptr);

}  // namespace fstiff::inline v0_1::detail

// What follows from K of a contact: tangential stiffness and loss, reflection, conductance of heat and current.

namespace fstiff::inline v0_1::detail {

enum class Derived {
    tangential_stiffness,   ///< [Pa/m], by Mindlin's ratio
    loss_factor,            ///< [1] of a cycle of Friction::amplitude
    reflection,             ///< |R| [1] of longitudinal waves
    shear_reflection,       ///< of shear waves
    thermal_conductance,    ///< of the spots and their film [W/(m^2 K)]
    electrical_conductance  ///< [S/m^2]
};
/// The value, or an end of its band.
enum class BandEnd { low, value, high };

/// Whether \p quantity falls as K rises.
[[nodiscard]] constexpr bool falls(Derived quantity) {
    return quantity == Derived::reflection || quantity == Derived::shear_reflection;
}
/// Whether \p problem has what \p quantity needs in addition to K.
[[nodiscard]] bool can_derive(Derived quantity, const Problem& problem);
/// \p quantity at the state \p i of \p curve with the K of \p state, which differs at an end of the band. The loss of
/// yielded spots has two limits, the ends; its value is their mean in logarithms.
[[nodiscard]] Estimate<double> derived(Derived quantity, const Problem& problem, const LawCurve& curve, std::size_t i,
                                       const ContactState<double>& state, BandEnd end);
/// Conductance of the gap at \p separation [m], with the radiation [W/(m^2 K)].
[[nodiscard]] double conductance_of_gap(const Conduction& conduction, double separation);

}  // namespace fstiff::inline v0_1::detail

// What does not hold of an answer, and what to measure next.

namespace fstiff::inline v0_1::detail {

/// The parameters of \p problem on which no result can rest, because they are not known to a factor of two; an answer
/// rests on the rms height and the gradient alone.
[[nodiscard]] std::vector<Parameter> unknown_parameters(const Problem& problem, bool of_answer);
/// What of \p problem and of \p pressures [Pa] is likely in another unit: an rms height above 1 mm, a modulus below
/// 1 kPa, pressures below 1e-9 of the effective modulus.
[[nodiscard]] std::vector<Check<double>> unlikely_units(const Problem& problem, std::span<const double> pressures);
/// "rms height 0.8 m is above 1 mm: a unit is likely wrong", of a check of unlikely_units().
[[nodiscard]] std::string sentence_of_unit(const Check<double>& check);
/// Whether \p check, which does not hold of an answer at \p points, makes it doubtful.
[[nodiscard]] bool makes_doubtful(const Check<double>& check, std::size_t points);
/// How far the states of \p curve by law plastic are beyond all that it was compared with; none: not at all.
[[nodiscard]] std::optional<Check<double>> beyond_comparison(const Problem& problem, const LawCurve& curve);
/// The rms gradient of \p face, whose peaks have the correlation of the greatest entry of Problem::peaks, where no
/// surface has it.
[[nodiscard]] std::optional<ImplausibleGradient> implausible_gradient(const Problem& problem, const Face& face);
/// All checks that do not hold of \p curve, the answer to \p request; `first` is a place among Request::points, or 0 of
/// the surface.
[[nodiscard]] std::vector<Check<double>> concerns_of(const Problem& problem, const LawCurve& curve);

/// The measurement that narrows the band most.
struct NextMeasurement {
    std::optional<Unknown> which{};  ///< none: four times the length or the area; of a trace across a lay, a map
    double factor = 0;               ///< high over low of the band once it finds what is assumed now
};
/// Of the band of \p answer at its state \p i; none where nothing narrows that factor by a twentieth.
[[nodiscard]] std::optional<NextMeasurement> next_measurement(const Problem& problem, const Request& request,
                                                              const LawCurve& answer, const AnswerFacts& facts,
                                                              std::size_t i);

}  // namespace fstiff::inline v0_1::detail

// The answer: one K for each point, by the law that holds there, with the causes of its band.

namespace fstiff::inline v0_1::detail {

/// In which form the laws have the surface.
[[nodiscard]] KnownAs known_as(const Problem& problem);

/// The error of \p law at the p* of \p reason, with that of the grid \p relative to K.
[[nodiscard]] CauseSpread<double> law_error(const Problem& problem, LawName law, const AnswerReason& reason,
                                            double relative = 0);
/// Noise over the rms height, above which it is a concern.
inline constexpr double most_noise = 0.05;
/// Rms height [m] of the noise in the map of \p face; 0 of none, and where lambda_s was given.
[[nodiscard]] double noise_of(const Face& face, Edges edges);

/// Where the approach of \p curve, which has its states, begins, or why \p contact has no separation there.
void seat(const Request& request, const AnyContact& contact, LawCurve& curve);

/// Whether the laws take the spectrum of a map of \p face.
[[nodiscard]] bool is_map(const Face& face);
/// Boundary elements at one point of a request.
struct Solved {
    double weight = 0;  ///< next to the law of the summits; 0: not solved
    ContactState<double> state{};
    CauseSpread<double> cut_offs{};
    double noise = 0;  ///< change of ln K once the noise of the map is gone
    std::optional<double> seated{};
};

/// Makes \p curve, of law_of_answer() with its states and its band, the answer: at points where boundary elements of
/// the map know more they take its place, and the band takes in every cause. \p progress is called while they are
/// solved.
[[nodiscard]] AnswerFacts make_answer(const Problem& problem, const Request& request, LawCurve& curve,
                                      const ProgressHook& progress);

}  // namespace fstiff::inline v0_1::detail

// The band of K: what the errors of the surface, the choice of lambda_s, and what is not known leave open.

namespace fstiff::inline v0_1::detail {

/// Makes what the laws of \p request keep of the maps of \p problem and of its neighbours, in pieces.
void make_contacts(const Problem& problem, const Request& request);
/// Gives each of \p curves, of the laws of \p request, whose law varies, its band: 5 % to 95 % over surfaces drawn
/// about this one by its errors, and, where the surface was measured, the spread of K over the neighbours at half and
/// twice the root of two of lambda_s, and the spread over the ends of what is not known. All widths, in logarithms, add
/// by squares. \returns the greatest number of drawn surfaces that have no K at some point.
std::size_t add_bands(const Problem& problem, Request request, std::vector<LawCurve>& curves,
                      const ProgressHook& progress);

}  // namespace fstiff::inline v0_1::detail

// K of hybrid of the many surfaces of numbers that a band is made of.

namespace fstiff::inline v0_1::detail {

/// Contacts of random surfaces with the bearing curve \p bearing, which must outlive it (none: Gaussian heights):
/// from a table over p/(E g), alpha and H, to 1.2e-3. For any threads.
[[nodiscard]] std::shared_ptr<const QuickHybrid> hybrids_of_draws(const BearingSlope<double>* bearing, double gamma);
/// Contacts of surfaces with few different alpha and H: one contact of each, with any bearing curves, which must
/// outlive it. For one thread.
[[nodiscard]] std::shared_ptr<const QuickHybrid> hybrids_of_numbers(double gamma);

}  // namespace fstiff::inline v0_1::detail

// K over the pressure between a few points, and the approach that it makes.
//
//     y(x) = ln K,  x = ln p       cubics through the points, with slopes that keep it monotone where the points are
//     fall(a, b) = integral of p/K over x from a to b                                                          [m]
//
// Reference   Fritsch, Butland, SIAM J. Sci. Stat. Comput. 5 (1984) 300-304, eq. (5) (slopes)
// Units       SI
// Valid       two points at least, with different pressures; between the first and the last
// Accuracy    K at the points; between them, of ten points a decade of a smooth law, 1e-3
//             (tests/scene/joint_test.cpp)

namespace fstiff::inline v0_1::detail {

class RisingCurve {
public:
    /// \p points are ln p and ln K in any order. \throws domain_error for fewer than two pressures.
    explicit RisingCurve(std::vector<std::pair<double, double>> points) : points_(std::move(points)) {
        std::sort(points_.begin(), points_.end());
        points_.erase(std::unique(points_.begin(), points_.end(),
                                  [](const auto& a, const auto& b) { return a.first == b.first; }),
                      points_.end());
        require(points_.size() >= 2, "points with a stiffness", points_.size(), "at least 2 for a law");
        const auto chord = [&](std::size_t i) {
            return (points_[i + 1].second - points_[i].second) / (points_[i + 1].first - points_[i].first);
        };
        slopes_.push_back(chord(0));
        for (std::size_t i = 1; i + 1 < points_.size(); ++i) {
            const double left = points_[i].first - points_[i - 1].first,
                         right = points_[i + 1].first - points_[i].first;
            const double a = chord(i - 1), b = chord(i), share = (left + 2 * right) / (3 * (left + right));
            slopes_.push_back(a * b > 0 ? a * b / (share * b + (1 - share) * a) : 0);
        }
        slopes_.push_back(chord(points_.size() - 2));
    }

    /// \throws domain_error unless \p from and \p to [Pa] are between the points.
    void require_within(double from, double to) const {
        constexpr double rounding = 1e-12;
        const double least = std::exp(points_.front().first), most = std::exp(points_.back().first);
        const std::string range = "from " + detail::rounded_text(least, 6) + " to " + detail::rounded_text(most, 6) +
                                  ", between the points (Pa)";
        require(from >= least * (1 - rounding), "min_pressure", from, range);
        require(to <= most * (1 + rounding), "max_pressure", to, range);
    }

    [[nodiscard]] double at(double x) const { return in_piece(piece_of(x), x); }

    [[nodiscard]] double fall(double from, double to) const {
        double sum = 0;
        for (std::size_t i = piece_of(from); i + 1 < points_.size(); ++i) {
            const double a = i == piece_of(from) ? from : points_[i].first;
            const double b = i + 2 == points_.size() ? to : (std::min)(to, points_[i + 1].first);
            const auto& rule = math::GaussLegendre<double, 12>::get();
            for (std::size_t k = 0; k < rule.node.size() && b > a; ++k) {
                const double x = std::lerp(a, b, (1 + rule.node[k]) / 2);
                sum += rule.weight[k] * (b - a) / 2 * std::exp(x - in_piece(i, x));
            }
        }
        return sum;
    }

private:
    [[nodiscard]] std::size_t piece_of(double x) const {
        std::size_t i = 0;
        while (i + 2 < points_.size() && points_[i + 1].first <= x) ++i;
        return i;
    }
    [[nodiscard]] double in_piece(std::size_t i, double x) const {
        const auto [x0, y0] = points_[i];
        const auto [x1, y1] = points_[i + 1];
        const double h = x1 - x0, t = (x - x0) / h, rise = y1 - y0, left = h * slopes_[i], right = h * slopes_[i + 1];
        return y0 + t * (left + t * (3 * rise - 2 * left - right + t * (left + right - 2 * rise)));
    }

    std::vector<std::pair<double, double>> points_;
    std::vector<double> slopes_;
};

}  // namespace fstiff::inline v0_1::detail
