// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The laws of an answer, functions of answer/answer.hpp. For answer/answer_inline.hpp.

#include <fstiff/answer/answer.hpp>
#include <fstiff/answer/rising_curve.hpp>
#include <fstiff/tabulated/contact_law.hpp>
#include <fstiff/tabulated/law_after.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace fstiff { inline namespace v0_1 {

namespace detail {

using LogNodes = std::vector<std::pair<double, double>>;  ///< of a quantity over the pressure

/// ln K and ln(-dp/dd) of the faces over ln p at the points of an answer, at a value or an end of its band: -dp/dd is
/// as far from its value as K. Where it is not known, as of boundary elements of peaks that yield, it is that of the
/// separations on both sides.
class NodesOfAnswer {
public:
    /// \throws domain_error for another quantile.
    NodesOfAnswer(const Answer& answer, double quantile) {
        if (!(quantile == 0.05 || quantile == 0.5 || quantile == 0.95))
            detail::refuse("quantile", quantile, 3, "0.05, 0.5 or 0.95");
        std::vector<const AnswerPoint*> known;
        for (const AnswerPoint& point : answer.points)
            if (point.ok()) known.push_back(&point);
        for (std::size_t i = 0; i < known.size(); ++i) {
            const auto& [low, value, high] = known[i]->of_faces();
            const double K = quantile < 0.5 ? low : quantile > 0.5 ? high : value, x = std::log(known[i]->pressure);
            const auto& loading = known[i]->faces ? known[i]->loading_of_faces : known[i]->loading_stiffness;
            const double slope = !answer.flows ? value : loading ? *loading : slope_about(known, i, value);
            stiffnesses.emplace_back(x, std::log(K));
            slopes.emplace_back(x, std::log((std::min)(slope, value) * (K / value)));
        }
    }
    LogNodes stiffnesses{}, slopes{};

private:
    static double slope_about(const std::vector<const AnswerPoint*>& points, std::size_t i, double unknown) {
        const AnswerPoint &a = *points[i > 0 ? i - 1 : 0], &b = *points[(std::min)(i + 1, points.size() - 1)];
        const double fall = a.state.separation.value - b.state.separation.value,
                     log_rise = std::log(b.pressure / a.pressure);
        return fall / log_rise > 0 ? points[i]->pressure * log_rise / fall : unknown;
    }
};

/// The law with -dp/dd by \p slopes, and K by \p stiffnesses; null: -dp/dd.
inline ContactLaw<double> law_of(const LogNodes& slopes, const LogNodes* stiffnesses, const LawRange<double>& range) {
    const RisingCurve slope(slopes);
    slope.require_within(range.min_pressure, range.max_pressure);
    const auto of = [](const RisingCurve& curve) {
        return [&curve](double p) { return std::exp(curve.at(std::log(p))); };
    };
    if (!stiffnesses) return ContactLaw<double>::tabulate_slope(of(slope), range);
    const RisingCurve stiffness(*stiffnesses);
    return ContactLaw<double>::tabulate_slope(of(slope), range, of(stiffness));
}

/// Those of \p below up to \p pressure, and those of \p above from it on.
inline std::pair<LogNodes, LogNodes> parted(const LogNodes& below, const LogNodes& above, double pressure) {
    constexpr double close = 1e-9;
    const double x = std::log(pressure);
    std::pair<LogNodes, LogNodes> parts;
    for (const auto& node : below)
        if (node.first <= x + close) parts.first.push_back(node);
    for (const auto& node : above)
        if (node.first >= x - close) parts.second.push_back(node);
    return parts;
}

}  // namespace detail

FSTIFF_INLINE ContactLaw<double> Answer::law_at(double quantile, const LawRange<double>& range) const {
    const detail::RisingCurve curve(detail::NodesOfAnswer(*this, quantile).stiffnesses);
    curve.require_within(range.min_pressure, range.max_pressure);
    const double last = std::log(range.max_pressure);
    return ContactLaw<double>::tabulate_points(
        [&](double p) {
            const double x = std::log(p);
            return detail::LawPoint<double>{curve.fall(x, last), std::exp(curve.at(x))};
        },
        rms_height, range, 1.0);
}

FSTIFF_INLINE ContactLaw<double> Answer::loading_law(double quantile, const LawRange<double>& range) const {
    if (!flows) return law_at(quantile, range);
    if (greatest_pressure)
        detail::refuse("greatest_pressure", *greatest_pressure, 6,
                       "left out of the joint: after an earlier load it is law_after()");
    const detail::NodesOfAnswer nodes(*this, quantile);
    return detail::law_of(nodes.slopes, &nodes.stiffnesses, range);
}

FSTIFF_INLINE ContactLaw<double> Answer::law_after(double greatest, double quantile,
                                                   const LawRange<double>& range) const {
    if (!flows) return law_at(quantile, range);
    if (!greatest_pressure)
        return fstiff::law_after(loading_law(quantile, range), greatest, relative_hardness.value_or(0));
    if (!(std::abs(greatest / *greatest_pressure - 1) < 1e-9))
        detail::refuse("greatest_pressure", greatest, 6,
                       "that of the joint, " + detail::rounded_text(*greatest_pressure, 6) + " Pa");
    const detail::NodesOfAnswer nodes(*this, quantile);
    const auto [below, above] = detail::parted(nodes.stiffnesses, nodes.slopes, greatest);
    const bool reached = !above.empty() && std::abs(above.front().first - std::log(greatest)) < 1e-9;
    const auto part = [&](const detail::LogNodes& of, double from, double to) {
        return detail::law_of(of, nullptr, {from, to, range.outside});
    };
    if (!(greatest < range.max_pressure)) return part(below, range.min_pressure, range.max_pressure);
    detail::require(reached, "greatest_pressure", greatest, "one of the pressures of the answer (Pa)");
    const ContactLaw<double> opening = part(below, range.min_pressure, greatest),
                             closing = part(above, greatest, range.max_pressure);
    return ContactLaw<double>::joined(opening, closing, closing.separations()[1]);
}

}}  // namespace fstiff
