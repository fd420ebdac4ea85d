// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// A ball on the face of a joint, by the law of the answer, with the band of its stiffness: Answer::balls().
///
///     p(d), K(p)   of the states of the answer: ln K and ln(-dp/dd) as cubics over ln p
///     ends         of the ball whose law has K, and as much -dp/dd, at one end of its band at all pressures
///
/// Of two ends and the middle the greatest and the least are the band of the law: a stiffer law spreads the load less.
/// The place of the ball, as scatter_of_contacts() of the contacts under it times the share that
/// roughness has of its compliance, and 5 % of the model add to it by squares.
///
/// Reference   tabulated/ball_contact.hpp
/// Units       SI
/// Valid       states from where the pressure carries nothing to the greatest of the ball, or to where the faces close
/// Accuracy    of the law 5e-4; of the ball tabulated/ball_contact.hpp (tests/scene/joint_test.cpp)

#include <fstiff/answer/answer.hpp>
#include <fstiff/answer/law_errors.hpp>
#include <fstiff/answer/nodes_of_answer.hpp>
#include <fstiff/answer/rising_curve.hpp>
#include <fstiff/core/text.hpp>
#include <fstiff/tabulated/ball_contact.hpp>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace fstiff { inline namespace v0_1 {

/// A ball under one load.
struct Answer::Ball {
    std::string reason{};             ///< why there is no contact; empty where there is one
    ContactOfBall<double> contact{};  ///< of the middle
    double low = 0, high = 0;         ///< ends of the band of its stiffness [N/m]
    ContactOfBall<double> hertz{};    ///< of smooth faces
    /// The body under the face yields, though it is computed as elastic: the greatest pressure is above 1.6 times the
    /// yield strength (Johnson, Contact Mechanics (1985), section 6.2).
    bool yields = false;
};

namespace detail {

/// Pressures [Pa] whose answer makes the law of a ball of \p radius [m] under \p forces [N], at least one: six a
/// decade, from 1e-4 of Hertz' under the least force, below which a pressure carries nothing, to that under the
/// greatest. \throws domain_error where one is beyond the range of double precision.
[[nodiscard]] inline std::vector<double> ball_pressures(double radius, double effective_modulus,
                                                        std::span<const double> forces) {
    const auto [least, greatest] = std::minmax_element(forces.begin(), forces.end());
    const double from = 1e-4 * hertz_ball(radius, effective_modulus, *least).pressure,
                 to = hertz_ball(radius, effective_modulus, *greatest).pressure;
    if (!(from > 0) || !std::isfinite(to))
        throw domain_error(
            Refusal{.parameter = "ball_radius", .allowed = "such that a pressure is in the range of double precision"});
    const auto last = static_cast<std::size_t>(std::ceil(6 * std::log10(to / from)));
    std::vector<double> pressures{from};
    for (std::size_t i = 1; i < last; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(last);
        pressures.push_back(std::exp((1 - share) * std::log(from) + share * std::log(to)));
    }
    pressures.push_back(to);
    return pressures;
}

/// The law of \p answer with K, and as much -dp/dd, at the value, 0.5, or at an end, 0.05 or 0.95, of its band.
[[nodiscard]] inline ContactLaw<double> law_of_ball(const Answer& answer, double quantile) {
    constexpr double most = 1e6;  // times K: an infinite end, next to which the bodies are soft all the same
    const NodesOfAnswer nodes(answer, quantile, most);
    const RisingCurve stiffness(nodes.stiffnesses), slope(nodes.slopes);
    const AnswerPoint &first = *nodes.known.front(), &last = *nodes.known.back();
    return ContactLaw<double>::tabulate_points(
        [&](double p) {
            const double x = std::log(p);
            return LawPoint<double>{last.state.separation.value + slope.fall(x, std::log(last.pressure)),
                                    std::exp(stiffness.at(x))};
        },
        answer.rms_height, {first.pressure, last.pressure, OutsideRange::extrapolate}, answer.flows ? 0.0 : 1.0);
}

/// Contacts per force [1/N] of \p answer where the pressure is \p pressure [Pa], or the greatest at which peaks are
/// contacts; 0: not known.
[[nodiscard]] inline double contacts_per_force(const Answer& answer, double pressure) {
    if (answer.rms_gradient)
        pressure = (std::min)(pressure, most_of_spots * answer.effective_modulus * *answer.rms_gradient);
    double least = 0, per_force = 0;
    for (const AnswerPoint& point : answer.points)
        if (const double away = std::abs(std::log(point.pressure / pressure));
            point.ok() && (per_force == 0 || away < least) && point.state.contact_density.value > 0)
            least = away, per_force = point.state.contact_density.value / point.pressure;
    return per_force;
}

}  // namespace detail

inline std::vector<Answer::Ball> Answer::balls(double radius, std::span<const double> forces) const {
    const ContactLaw<double> middle = detail::law_of_ball(*this, 0.5), soft = detail::law_of_ball(*this, 0.05),
                             stiff = detail::law_of_ball(*this, 0.95);
    // faces that are closed are smooth, which a law is too where it goes on beyond its last state
    const bool ends = std::any_of(points.begin(), points.end(), [](const AnswerPoint& point) {
        return !point.ok() && point.miss != AnswerPoint::Miss::closed;
    });
    std::vector<Ball> balls;
    for (const double force : forces) {
        Ball& ball = balls.emplace_back(Ball{.hertz = detail::hertz_ball(radius, effective_modulus, force)});
        try {
            const auto on = [&](const ContactLaw<double>& face) {
                return ball_on_rough_face(face, radius, effective_modulus, force);
            };
            ball.contact = on(middle);
            if (ends && ball.contact.pressure > middle.pressures()[1])
                detail::refuse("pressure of the ball", ball.contact.pressure, 3,
                               "at most " + detail::rounded_text(middle.pressures()[1], 3) +
                                   " Pa, where the law of the face ends");
            std::tie(ball.low, ball.high) =
                std::minmax({ball.contact.stiffness, on(soft).stiffness, on(stiff).stiffness});
            constexpr double of_model = 0.05;
            const double K = ball.contact.stiffness,
                         contacts = force * detail::contacts_per_force(*this, ball.contact.pressure),
                         share = (std::max)(0.0, 1 - K / ball.hertz.stiffness),
                         of_place = contacts > 0 ? share * detail::scatter_of_contacts(contacts).high : 0,
                         beside = std::hypot(of_model, of_place);
            std::tie(ball.low, ball.high) = detail::widened(K, ball.low, ball.high, {beside, beside});
            ball.yields = ball.contact.pressure > 1.6 * yield_strength;
        } catch (const domain_error& error) {
            ball.reason = error.what(), ball.contact = {};
        }
    }
    return balls;
}

}}  // namespace fstiff
