// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// A ball on the face of a joint, by the law of the answer, with the band of its stiffness.
///
///     p(d), K(p)   of the states of the answer: ln K and ln(-dp/dd) as cubics over ln p
///     ends         of the ball whose law has K, and as much -dp/dd, at one end of its band at all pressures
///
/// Of two ends and the middle the greatest and the least are the band: a stiffer law spreads the load less.
///
/// Reference   tabulated/ball_contact.hpp
/// Units       SI
/// Valid       states from where the pressure carries nothing to the greatest of the ball, or to where the faces close
/// Accuracy    of the law 5e-4; of the ball tabulated/ball_contact.hpp (tests/scene/joint_test.cpp)

#include <fstiff/answer/answer.hpp>
#include <fstiff/answer/curves.hpp>
#include <fstiff/answer/derived.hpp>
#include <fstiff/answer/rising_curve.hpp>
#include <fstiff/tabulated/ball_contact.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// A ball under one load.
struct BallOnFace {
    std::string reason{};             ///< why there is no contact; empty where there is one
    ContactOfBall<double> contact{};  ///< of the middle
    double low = 0, high = 0;         ///< ends of the band of its stiffness [N/m]
};

/// The law of \p curve with K at the end \p end of its band.
[[nodiscard]] inline ContactLaw<double> law_at(BandEnd end, const LawCurve& curve, const AnswerFacts& facts,
                                               double rms_height) {
    constexpr double most = 1e6;  // times K: an infinite end, next to which the bodies are soft all the same
    std::vector<std::pair<double, double>> stiffnesses, slopes;  // ln over ln p
    for (std::size_t i = 0; i < curve.states.size(); ++i) {
        const double K = curve.states[i].stiffness.value, x = std::log(curve.states[i].pressure.value);
        const double factor = end == BandEnd::value ? 1
                              : end == BandEnd::low ? curve.band[i].low / K
                                                    : (std::min)(curve.band[i].high / K, most);
        stiffnesses.emplace_back(x, std::log(factor * K));
        slopes.emplace_back(x, std::log(factor * facts.reasons[i].loading_stiffness.value_or(K)));
    }
    const RisingCurve stiffness(stiffnesses), slope(slopes);
    const double last = slopes.back().first, closest = curve.states.back().separation.value;
    return ContactLaw<double>::tabulate_points(
        [&](double p) {
            const double x = std::log(p);
            return LawPoint<double>{closest + slope.fall(x, last), std::exp(stiffness.at(x))};
        },
        rms_height,
        {curve.states.front().pressure.value, curve.states.back().pressure.value, OutsideRange::extrapolate},
        facts.flows ? 0.0 : 1.0);
}

/// The ball of the radius \p radius [m] on the face of \p problem under each of \p loads [N], by the answer \p curve,
/// whose pressures rise. \throws domain_error for less than two states.
[[nodiscard]] inline std::vector<BallOnFace> balls_on_answer(const ResolvedJoint& problem, const LawCurve& curve,
                                                             const AnswerFacts& facts, double radius,
                                                             const std::vector<double>& loads) {
    const auto law = [&](BandEnd end) { return law_at(end, curve, facts, problem.face.parameters.rms_height.value); };
    const ContactLaw<double> middle = law(BandEnd::value), soft = law(BandEnd::low), stiff = law(BandEnd::high);
    // faces that are closed are smooth, which a law is too where it goes on beyond its last state
    const bool ends = std::any_of(curve.missed.begin(), curve.missed.end(),
                                  [](const MissedPoint& missed) { return missed.why != Miss::closed; });
    std::vector<BallOnFace> balls;
    for (const double load : loads) try {
            const auto on = [&](const ContactLaw<double>& face) {
                return ball_on_rough_face(face, radius, problem.effective_modulus, load);
            };
            const ContactOfBall<double> contact = on(middle);
            if (ends && contact.pressure > middle.pressures()[1])
                refuse("pressure of the ball", contact.pressure, 3,
                       "at most " + rounded_text(middle.pressures()[1], 3) + " Pa, where the law of the face ends");
            const auto [low, high] = std::minmax({contact.stiffness, on(soft).stiffness, on(stiff).stiffness});
            balls.push_back({{}, contact, low, high});
        } catch (const domain_error& error) {
            balls.push_back({.reason = error.what()});
        }
    return balls;
}

}}}  // namespace fstiff::detail
