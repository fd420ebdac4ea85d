// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The laws of an answer, functions of answer/answer.hpp. For answer/answer_inline.hpp.

#include <fstiff/answer/answer.hpp>
#include <fstiff/answer/nodes_of_answer.hpp>
#include <fstiff/answer/rising_curve.hpp>
#include <fstiff/tabulated/contact_law.hpp>
#include <fstiff/tabulated/law_after.hpp>

#include <cmath>
#include <span>
#include <utility>
#include <vector>

namespace fstiff { inline namespace v0_1 {

namespace detail {

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
    if (!greatest_pressure) return law_after(std::span(&greatest, 1), quantile, range).front();
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

FSTIFF_INLINE std::vector<ContactLaw<double>> Answer::law_after(std::span<const double> greatest, double quantile,
                                                                const LawRange<double>& range) const {
    std::vector<ContactLaw<double>> after;
    const bool shared = flows && !greatest_pressure;
    const ContactLaw<double> loading = shared ? loading_law(quantile, range) : ContactLaw<double>();
    for (const double pressure : greatest)
        after.push_back(shared ? fstiff::law_after(loading, pressure, relative_hardness.value_or(0))
                               : law_after(pressure, quantile, range));
    return after;
}

}}  // namespace fstiff
