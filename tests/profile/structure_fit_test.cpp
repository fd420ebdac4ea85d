// SPDX-License-Identifier: BSD-3-Clause
// Data made of the terms that are fitted; how the result moves with the data against differences of fits.
#include <fstiff/profile/structure_fit.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

using namespace fstiff;

namespace {

constexpr double log_gamma = 0.405465108108164;  // of 1.5

/// ln S = level + power ln n + the term, at 12 lags an octave.
template <class Term>
detail::LogStructure<double> made(double level, double power, std::size_t longest, const Term& term) {
    detail::LogStructure<double> log;
    log.step = logarithmic_lags(longest);
    log.points = 10 * longest;
    log.lag.resize(static_cast<Eigen::Index>(log.step.size()));
    log.value = log.slope = log.lag;
    for (Eigen::Index k = 0; k < log.lag.size(); ++k) {
        log.lag[k] = std::log(static_cast<double>(log.step[static_cast<std::size_t>(k)]));
        log.value[k] = level + power * log.lag[k] + term(log.lag[k]);
    }
    return log;
}

const auto no_form = [](double) { return 0.0; };

detail::IndexRange all(const detail::LogStructure<double>& log) { return {0, log.lag.size() - 1}; }

/// The loss by a form that is none.
struct Nothing {
    Eigen::Index size;
    detail::Vector<double> operator()(double) const { return detail::Vector<double>::Zero(size); }
};

}  // namespace

TEST_CASE("A power law gives its slope and its level, without further terms") {
    const auto log = made(-3.0, 0.8, 50, no_form);
    detail::WindowFit<double> window(log, all(log), log_gamma);
    const auto fit = window.fit(Nothing{log.lag.size()}, true);
    CHECK_FALSE(fit.finite_band);
    CHECK_FALSE(fit.log_periodic);
    CHECK(test::relative_error(fit.coefficients[1], 0.8) < 1e-13);
    CHECK(test::relative_error(fit.coefficients[0] - 0.8 * window.log_reference(), -3.0) < 1e-13);
}

TEST_CASE("Waves in ln S are taken for waves, and leave the slope") {
    const auto log =
        made(-3.0, 0.8, 50, [](double x) { return 0.1 * std::sin(2 * 3.141592653589793 * x / log_gamma); });
    detail::WindowFit<double> window(log, all(log), log_gamma);
    const auto fit = window.fit(Nothing{log.lag.size()}, true);
    CHECK(fit.log_periodic);
    CHECK(test::relative_error(fit.coefficients[1], 0.8) < 1e-12);
}

TEST_CASE("The terms of a finite band leave the slope of two decades") {
    const double power = 0.8, longest = std::log(static_cast<double>(logarithmic_lags(400).back()));
    const auto log = made(-3.0, power, 400, [&](double x) {
        return 0.2 * std::exp(-power * x) - 0.3 * std::exp((2 - power) * (x - longest));
    });
    detail::WindowFit<double> window(log, all(log), log_gamma);
    const auto fit = window.fit(Nothing{log.lag.size()}, true);
    CHECK(fit.finite_band);
    CHECK(test::relative_error(fit.coefficients[1], power) < 1e-9);
    CHECK(test::relative_error(fit.coefficients[2], 0.2) < 1e-8);
    CHECK(test::relative_error(fit.coefficients[3], -0.3) < 1e-8);
}

TEST_CASE("The rows tell how D and the level move with each value of ln S") {
    // S of one window, changed by a little at one lag after another and fitted anew; through the columns too
    const double power = 0.8, longest = std::log(static_cast<double>(logarithmic_lags(400).back()));
    auto log = made(-3.0, power, 400, [&](double x) {
        return 0.2 * std::exp(-power * x) - 0.3 * std::exp((2 - power) * (x - longest)) + 0.01 * std::sin(9 * x);
    });
    const auto fitted = [&] {
        detail::WindowFit<double> window(log, all(log), log_gamma);
        return window.fit(Nothing{log.lag.size()}, true);
    };
    detail::WindowFit<double> window(log, all(log), log_gamma);
    const auto fit = window.fit(Nothing{log.lag.size()}, true);
    REQUIRE(fit.finite_band);
    const auto rows = window.rows(fit, Nothing{log.lag.size()}, true);
    const double small = 1e-5, scale = rows.dimension.cwiseAbs().maxCoeff();
    for (Eigen::Index k = 0; k < log.lag.size(); k += 7) {
        const double before = log.value[k];
        log.value[k] = before + small;
        const auto up = fitted();
        log.value[k] = before - small;
        const auto down = fitted();
        log.value[k] = before;
        const double dimension = -(up.coefficients[1] - down.coefficients[1]) / 2 / (2 * small);
        const double level = (up.coefficients[0] - down.coefficients[0]) / (2 * small);
        CHECK(std::abs(rows.dimension[k] - dimension) < 1e-3 * scale);
        CHECK(std::abs(rows.level[k] - level) < 1e-3 * rows.level.cwiseAbs().maxCoeff());
    }
}
