// SPDX-License-Identifier: BSD-3-Clause
// Peer: Boost.Math's exp-sinh rule within itself, over the quarter plane of t and of the excess. It needs no box, and
// its nodes crowd at the branch points.
#include "../methods.hpp"
#include "../row.hpp"
#include "window.hpp"

#include <boost/math/quadrature/exp_sinh.hpp>

namespace {

using namespace bench;

Values nested(const Problem& p, const Which& which, const Setting& with) {
    static thread_local boost::math::quadrature::exp_sinh<double> outer, inner;
    const Window window(p, 0, 1);
    Values out{{}, no_estimate, 0};
    for (const std::size_t q : which) {
        const double a = powers[q][0], b = powers[q][1];
        const auto row = [&](double t) {
            const double x = window.x(t);
            const auto integrand = [&, a](double v) {
                ++out.evaluations;
                const double power = a == 0 ? 1 : a == 0.5 ? std::sqrt(v) : a == 1 ? v : v * std::sqrt(v);
                const double value = power * std::exp(window.exponent(t, x, v));
                return std::isfinite(value) ? value : 0;
            };
            const double power = b == 0 ? 1 : b == -0.5 ? 1 / std::sqrt(t) : 1 / t;
            const double weight = std::erf(window.k * t) * power;
            // far out the inner integral is 0, which its relative tolerance cannot meet
            return window.exponent(t, std::max(x, 0.0), 0) < -80 ? 0.0
                                                                 : weight * inner.integrate(integrand, with.inner);
        };
        try {
            out.value[q] = outer.integrate(row, with.outer) * window.factor(a) / 4;
        } catch (const std::exception&) {
            out.value[q] = std::numeric_limits<double>::quiet_NaN();
        }
    }
    return out;
}

const Rows rows_of_boost([] {
    for (const Setting& with :
         {Setting{1e-3, 0, 1e-3, 1e-4}, {1e-6, 0, 1e-4, 1e-5}, {1e-9, 0, 1e-7, 1e-8}, {1e-12, 0, 1e-9, 1e-10}})
        row("boost-exp_sinh", "four", plain, text_of(with.tolerance), four, with.tolerance,
            [=](const Problem& p) { return nested(p, four, with); });
});

}  // namespace
