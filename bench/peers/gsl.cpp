// SPDX-License-Identifier: BSD-3-Clause
// Peers from the GNU Scientific Library: its adaptive Gauss-Kronrod rule in one dimension, with the inner integral
// through its confluent hypergeometric function, and its doubly-adaptive rule within itself.
#include "../methods.hpp"
#include "../row.hpp"
#include "window.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_sf_hyperg.h>

#include <numbers>

namespace {

using namespace bench;

/// F_a(x) = int_0^inf v^a exp(-(v+x)^2/2) dv, times exp(x^2/2) for x > 0.
double moment(double a, double x) {
    constexpr double root_2pi = 2.506628274631000502;
    const double z = x * x / 2;
    const double gamma = a == 0.5 ? 0.886226925452758014 : a == 1.5 ? 1.32934038817913702 : 1;  // Gamma(a+1)
    if (x > 0) return gamma * std::exp2(-(a + 1) / 2) * gsl_sf_hyperg_U((a + 1) / 2, 0.5, z);
    if (a == 0) return root_2pi / 2 * std::erfc(x / std::numbers::sqrt2);
    if (a == 1) return std::exp(-z) - x * root_2pi / 2 * std::erfc(x / std::numbers::sqrt2);
    if (x < -9) {  // sqrt(2 pi) |x|^a (1 + a(a-1)/(2 x^2) + ...): the odd half is beyond the last digit
        double term = 1, sum = 1;
        for (int n = 1; n < 40 && std::abs(term) > 1e-17 * sum; ++n) {
            term *= (a - 2 * n + 2) * (a - 2 * n + 1) / (2 * n * x * x);
            sum += term;
        }
        return root_2pi * (a == 0.5 ? std::sqrt(-x) : -x * std::sqrt(-x)) * sum;
    }
    const double half_gamma =
        a == 0.5 ? 1.22541670246517765 : 0.906402477055477078;  // Gamma((a+1)/2): Gamma(3/4), Gamma(5/4)
    const double next_gamma =
        a == 0.5 ? 0.906402477055477078 : 0.919062526848883234;  // Gamma((a+2)/2): Gamma(5/4), Gamma(7/4)
    return gamma * std::exp2(-(a + 1) / 2) * std::exp(-z) * std::sqrt(std::numbers::pi) *
           (gsl_sf_hyperg_1F1((a + 1) / 2, 0.5, z) / next_gamma -
            std::numbers::sqrt2 * x / half_gamma * gsl_sf_hyperg_1F1((a + 2) / 2, 1.5, z));
}

/// Frees what GSL allocates.
template <class T, void (*release)(T*)>
struct Owned {
    T* pointer;
    ~Owned() { release(pointer); }
};

struct Call {
    Window window;
    double a, b;
    long evaluations;
    double t;              ///< of the row
    double row_tolerance;  ///< relative
};

double power_of_s(double s, double b) { return b == 0 ? s : b == -0.5 ? 1 : 1 / s; }

double in_one(double s, void* data) {
    auto& call = *static_cast<Call*>(data);
    ++call.evaluations;
    const Window& w = call.window;
    const double t = s * s, x = w.x(t);
    const double ahead = std::max(x, 0.0);
    return power_of_s(s, call.b) * std::erf(w.k * t) * std::exp((w.floor * w.floor - t * t - ahead * ahead) / 2) *
           moment(call.a, x);
}

double in_two(double u, void* data) {
    auto& call = *static_cast<Call*>(data);
    ++call.evaluations;
    const double v = u * u;
    const double power = call.a == 0 ? u : call.a == 0.5 ? v : call.a == 1 ? v * u : v * v;
    return power * std::exp(call.window.exponent(call.t, call.window.x(call.t), v));
}

/// GSL's adaptive rule of 21 points.
struct Qag {
    Owned<gsl_integration_workspace, gsl_integration_workspace_free> workspace{gsl_integration_workspace_alloc(400)};
    double operator()(gsl_function f, double from, double to, double tolerance) const {
        double value = 0, error = 0;
        gsl_integration_qag(&f, from, to, 0, tolerance, 400, GSL_INTEG_GAUSS21, workspace.pointer, &value, &error);
        return value;
    }
};

/// GSL's doubly-adaptive rule.
struct Cquad {
    Owned<gsl_integration_cquad_workspace, gsl_integration_cquad_workspace_free> workspace{
        gsl_integration_cquad_workspace_alloc(200)};
    double operator()(gsl_function f, double from, double to, double tolerance) const {
        double value = 0;
        gsl_integration_cquad(&f, from, to, 0, tolerance, workspace.pointer, &value, nullptr, nullptr);
        return value;
    }
};

/// One workspace an integral and a level, kept from call to call.
template <class Rule, int level>
const Rule& rule() {
    static const Rule kept;
    return kept;
}

template <class Rule>
double row_of(double s, void* data) {
    auto& call = *static_cast<Call*>(data);
    call.t = s * s;
    if (s == 0 && call.b == -1) return 0;  // erf(k s^2)/s
    const auto row = call.window.row(call.window.x(call.t));
    return power_of_s(s, call.b) * std::erf(call.window.k * call.t) *
           rule<Rule, 1>()({in_two, data}, row.from, row.to, call.row_tolerance);
}

/// int \p integrand ds for each of \p which; \p half is the factor that in_one leaves out and the sum over w does not.
template <class Rule>
Values integrate(const Problem& p, const Which& which, const Setting& with, double (*integrand)(double, void*),
                 double half) {
    gsl_set_error_handler_off();  // an error estimate above the tolerance is no reason to stop: the truth decides
    Values out{{}, no_estimate, 0};
    for (const std::size_t q : which) {
        Call call{Window(p, with.depth, with.depth), powers[q][0], powers[q][1], 0, 0, with.inner};
        const double value = rule<Rule, 0>()({integrand, &call}, call.window.s_from, call.window.s_to, with.outer);
        out.value[q] = value * call.window.factor(call.a) * half;
        out.evaluations += call.evaluations;
    }
    return out;
}
Values one_dimension(const Problem& p, const Which& which, const Setting& with) {
    return integrate<Qag>(p, which, with, in_one, 0.5);
}
template <class Rule>
Values nested(const Problem& p, const Which& which, const Setting& with) {
    return integrate<Rule>(p, which, with, row_of<Rule>, 1);
}

const Rows rows_of_gsl([] {
    for (const Setting& with :
         {Setting{1e-3, 10, 1e-1, 0}, {1e-6, 18, 1e-1, 0}, {1e-9, 30, 1e-4, 0}, {1e-12, 32, 1e-5, 0}}) {
        const auto add = [&](const char* what, const Which& which) {
            row("gsl-1d", what, plain, text_of(with.tolerance), which, with.tolerance,
                [=](const Problem& p) { return one_dimension(p, which, with); });
        };
        add("four", four);
        add("stiffness", one);
    }
    for (const Setting& with :
         {Setting{1e-3, 10, 1e-2, 1e-2}, {1e-6, 17, 1e-5, 1e-5}, {1e-9, 26, 3e-9, 3e-9}, {1e-12, 32, 2e-11, 2e-11}})
        row("gsl-nested_cquad", "four", plain, text_of(with.tolerance), four, with.tolerance,
            [=](const Problem& p) { return nested<Cquad>(p, four, with); });
    for (const Setting& with :
         {Setting{1e-3, 10, 1e-1, 1e-1}, {1e-6, 18, 1e-1, 1e-1}, {1e-9, 30, 1e-4, 1e-4}, {1e-12, 32, 1e-6, 1e-7}})
        row("gsl-nested_qag", "four", plain, text_of(with.tolerance), four, with.tolerance,
            [=](const Problem& p) { return nested<Qag>(p, four, with); });
    row("gsl-1d", "four", hard, text_of(1e-12), four, 1e-12, [](const Problem& p) {
        return one_dimension(p, four, {1e-12, 36, 1e-12, 0});
    });
});

}  // namespace
