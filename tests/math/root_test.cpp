// SPDX-License-Identifier: BSD-3-Clause
// Newton in a bracket: functions with known roots that defeat plain Newton, and the proof that it claims to deliver.
#include <fstiff/math/root.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace root_test {

using fstiff::math::newton_bracketed;
using fstiff::math::RootStatus;

namespace {

template <class T>
struct Problem {
    std::string name;
    std::function<std::pair<T, T>(T)> f;
    T lower, upper, guess, root;
};

template <class T>
std::vector<Problem<T>> hard_problems() {
    const T third = T(1) / 3, inf = std::numeric_limits<T>::infinity();
    return {
        {"exponential from the steep side",
         [](T x) {
             return std::pair{std::exp(x) - 2, std::exp(x)};
         },
         -50, 60, 50, std::log(T(2))},
        {"exponential from the flat side",
         [](T x) {
             return std::pair{std::exp(x) - 2, std::exp(x)};
         },
         -50, 60, -40, std::log(T(2))},
        {"falling exponential",
         [](T x) {
             return std::pair{std::exp(-x) - 2, -std::exp(-x)};
         },
         -60, 50, 40, -std::log(T(2))},
        {"steep arc tangent",
         [=](T x) {
             const T u = 1000 * (x - third);
             return std::pair{std::atan(u), 1000 / (1 + u * u)};
         },
         -10, 10, 7, third},
        {"multiple root of order 5",
         [=](T x) {
             const T u = x - third;
             return std::pair{T(std::pow(u, 5)), T(5 * std::pow(u, 4))};
         },
         -1, 2, 1, third},
        {"kink, steep to flat",
         [=](T x) {
             const T u = x - third - T(1e-3L);
             return u > T(-5e-4L) ? std::pair{u * 1000 + T(0.499L), T(1000)} : std::pair{u + T(1e-3L) - T(5e-4L), T(1)};
         },
         -5, 5, 4, third + T(5e-4L) + T(1e-6L)},
        {"cube root: Newton runs away",
         [=](T x) {
             const T u = x - third;
             return std::pair{std::cbrt(u), 1 / (3 * std::cbrt(u) * std::cbrt(u))};
         },
         -3, 2, 1, third},
        {"square root of either sign: Newton cycles",
         [=](T x) {
             const T u = x - third, s = std::sqrt(std::abs(u));
             return std::pair{std::copysign(s, u), 1 / (2 * s)};
         },
         -3, 2, 1, third},
        {"jump across 0",
         [=](T x) {
             return std::pair{x < third ? T(-1) : T(1), T(0)};
         },
         -3, 2, 1, third},
        {"no slope known",
         [=](T x) {
             return std::pair{x - third, T(0)};
         },
         -3, 2, 1, third},
        {"slope not a number",
         [=](T x) {
             return std::pair{third - x, std::numeric_limits<T>::quiet_NaN()};
         },
         -3, 2, 1, third},
        {"slope a million times too large",
         [=](T x) {
             return std::pair{x - third, T(1e6)};
         },
         -3, 2, 1, third},
        {"slope a million times too small",
         [=](T x) {
             return std::pair{x - third, T(1e-6)};
         },
         -3, 2, 1, third},
        {"infinite values",
         [=](T x) {
             return x > 1 ? std::pair{inf, inf} : std::pair{x - third, T(1)};
         },
         -3, 1000, 900, third},
        {"pole at the end",
         [=](T x) {
             return std::pair{1 / x - 3, -1 / (x * x)};
         },
         0, 100, 99, third},
        {"root at the lower end",
         [=](T x) {
             return std::pair{(x - third) * (x + 2), 2 * x + 2 - third};
         },
         third, 2, 2, third},
        {"root at the upper end",
         [=](T x) {
             return std::pair{std::exp(x) - std::exp(third), std::exp(x)};
         },
         -9, third, -9, third},
        {"root a billion times smaller than the bracket",
         [](T x) {
             return std::pair{std::expm1(x) - T(1e-9), std::exp(x)};
         },
         -1, 1, 1, std::log1p(T(1e-9))},
    };
}

}  // namespace

TEMPLATE_TEST_CASE("a bracketed root of a hard function is where it is known to be", "[root]", FSTIFF_SCALARS) {
    using T = TestType;
    const T eps = std::numeric_limits<T>::epsilon();
    for (const auto& p : hard_problems<T>()) {
        for (const T tolerance : {T(1e-2), T(1e-5), 64 * eps}) {
            CAPTURE(p.name, tolerance);
            const auto found = newton_bracketed<T>(p.f, p.lower, p.upper, p.guess, tolerance);
            REQUIRE(found.converged());
            CHECK(found.root >= p.lower);
            CHECK(found.root <= p.upper);
            CHECK(found.error <= std::max(tolerance, 8 * eps * std::abs(p.root)));
            // The known root is rounded, and so is f near it: the kink's offsets and 1/3 - 1/x leave a few eps of 1.
            CHECK(std::abs(found.root - p.root) <= found.error + 4 * eps);
            CHECK(found.iterations <= fstiff::math::root_iterations);
        }
    }
}

TEMPLATE_TEST_CASE("converged means that f changes sign within the error", "[root]", FSTIFF_SCALARS) {
    using T = TestType;
    for (const auto& p : hard_problems<T>()) {
        const auto found = newton_bracketed<T>(p.f, p.lower, p.upper, p.guess, T(1e-4));
        CAPTURE(p.name, found.root, found.error);
        REQUIRE(found.converged());
        if (found.error == 0) {
            CHECK(p.f(found.root).first == 0);
        } else {
            const T left = std::max(found.root - found.error, p.lower),
                    right = std::min(found.root + found.error, p.upper);
            CHECK((p.f(left).first <= 0) != (p.f(right).first < 0));
        }
    }
}

TEMPLATE_TEST_CASE("a smooth function from a good guess costs few evaluations", "[root]", FSTIFF_SCALARS) {
    using T = TestType;
    // The shape that contact inversion has: the logarithm of a load that falls like a Gaussian tail; known root 2.
    const auto f = [](T x) { return std::pair{4 - x * std::abs(x), -2 * std::abs(x)}; };
    // Newton from 2.1 has errors 2e-3, 1e-6, 4e-13, 2e-26; one more evaluation closes the bracket.
    const int enough = std::is_same_v<T, float> ? 5 : std::is_same_v<T, double> ? 6 : 7;
    for (const T guess : {T(1.9), T(2.1)}) {
        const auto found = newton_bracketed<T>(f, T(-0.5), 1000, guess, 0);
        CAPTURE(guess, found.root, found.error, found.iterations);
        REQUIRE(found.converged());
        CHECK(test::ulps(found.root, T(2)) <= 1);
        CHECK(found.iterations <= enough);
    }
}

TEMPLATE_TEST_CASE("a bracket without a root is reported, not searched for ever", "[root]", FSTIFF_SCALARS) {
    using T = TestType;
    const T inf = std::numeric_limits<T>::infinity(), nan = std::numeric_limits<T>::quiet_NaN();
    const auto line = [](T x) { return std::pair{x, T(1)}; };
    const auto flat = [](T) { return std::pair{T(1), T(0)}; };
    const auto tail = [](T x) { return std::pair{std::exp(-x), -std::exp(-x)}; };
    for (const T guess : {T(1), T(1.5), T(2), T(-7), T(99), nan}) {
        CAPTURE(guess);
        CHECK(newton_bracketed<T>(line, 1, 2, guess, 0).status == RootStatus::no_bracket);
        CHECK(newton_bracketed<T>(line, -2, -1, guess, 0).status == RootStatus::no_bracket);
        CHECK(newton_bracketed<T>(flat, 1, 2, guess, 0).status == RootStatus::no_bracket);
        CHECK(newton_bracketed<T>(tail, 1, 30, guess, 0).status == RootStatus::no_bracket);
        CHECK(newton_bracketed<T>(line, -1, 2, guess, 0).converged());
    }
    CHECK(newton_bracketed<T>(line, 2, -1, 0, 0).status == RootStatus::no_bracket);
    CHECK(newton_bracketed<T>(line, -inf, 1, 0, 0).status == RootStatus::no_bracket);
    CHECK(newton_bracketed<T>(line, -1, nan, 0, 0).status == RootStatus::no_bracket);
    CHECK(newton_bracketed<T>(line, 1, 1, 1, 0).status == RootStatus::no_bracket);
    CHECK(newton_bracketed<T>(line, 0, 0, 0, 0).converged());
}

TEST_CASE("a function that returns NaN, or too few iterations, is not converged", "[root]") {
    int calls = 0;
    const auto hole = [&](double x) {
        ++calls;
        return std::pair{x > 0.5 ? std::nan("") : x - 0.7, 1.0};
    };
    const auto found = newton_bracketed(hole, 0.0, 1.0, 0.2, 0.0);
    CHECK(found.status == RootStatus::not_converged);
    CHECK(found.iterations == calls);
    const auto line = [](double x) { return std::pair{std::expm1(x), std::exp(x)}; };
    for (const int limit : {-1, 0, 1, 2}) {
        const auto stopped = newton_bracketed(line, -50.0, 60.0, 30.0, 0.0, limit);
        CHECK(stopped.status == RootStatus::not_converged);
        CHECK(stopped.iterations == std::max(limit, 0));
    }
}

TEST_CASE("the count of iterations is the count of evaluations", "[root]") {
    for (const auto& p : hard_problems<double>()) {
        int calls = 0;
        const auto counted = [&](double x) {
            ++calls;
            return p.f(x);
        };
        const auto found = newton_bracketed(counted, p.lower, p.upper, p.guess, 1e-12);
        CAPTURE(p.name);
        CHECK(found.iterations == calls);
    }
}

TEST_CASE("rescaling x and the tolerance rescales the root and nothing else", "[root]") {
    for (const double unit : {std::ldexp(1.0, 30), std::ldexp(1.0, -30)}) {
        const auto f = [](double x) { return std::pair{std::exp(x) - 3, std::exp(x)}; };
        const auto g = [=](double y) { return std::pair{std::exp(y / unit) - 3, std::exp(y / unit) / unit}; };
        const auto x = newton_bracketed(f, -5.0, 9.0, 6.0, 1e-10);
        const auto y = newton_bracketed(g, -5 * unit, 9 * unit, 6 * unit, 1e-10 * unit);
        CHECK(y.root == x.root * unit);
        CHECK(y.iterations == x.iterations);
    }
}

TEST_CASE("the search may throw only when the function may", "[root]") {
    const auto quiet = [](double x) noexcept { return std::pair{x, 1.0}; };
    const auto loud = [](double x) { return std::pair{x, 1.0}; };
    CHECK(noexcept(newton_bracketed(quiet, 0.0, 1.0, 0.5, 0.0)));
    CHECK(!(noexcept(newton_bracketed(loud, 0.0, 1.0, 0.5, 0.0))));
}

}  // namespace root_test
