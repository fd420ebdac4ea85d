// SPDX-License-Identifier: BSD-3-Clause
// Lines through data made of the terms that are fitted; how they move with the data against differences of fits.
#include <fstiff/profile/structure_fit.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

namespace structure_fit_test {

using namespace fstiff;

namespace {

constexpr double log_gamma = 0.405465108108164;  // of 1.5

/// ln S2 = level + power ln n + the term, at 12 lags an octave.
template <class Term>
detail::LogStructure<double> made(double level, double power, std::size_t longest, const Term& term) {
    detail::LogStructure<double> log;
    log.step = detail::logarithmic_lags(longest);
    log.points = 10 * longest;
    log.lag.resize(static_cast<Eigen::Index>(log.step.size()));
    log.value = log.slope = log.lag;
    for (Eigen::Index k = 0; k < log.lag.size(); ++k) {
        log.lag[k] = std::log(static_cast<double>(log.step[static_cast<std::size_t>(k)]));
        log.value[k] = level + power * log.lag[k] + term(log.lag[k]);
    }
    return log;
}

/// Prior share of the waves below the first lag, without a fit.
double expected(double x) { return -0.45 * detail::share_of_short_waves(0.8) * std::exp(-0.8 * x); }

detail::IndexRange all(const detail::LogStructure<double>& log) { return {0, log.lag.size() - 1}; }

/// With independent errors of 1e-3.
detail::LineFitter<double> fitter(const detail::LogStructure<double>& log, double power) {
    return {log, 1e-6 * detail::Matrix<double>::Identity(log.lag.size(), log.lag.size()), power, log_gamma, false};
}

}  // namespace

TEST_CASE("A power law gives its slope and its level, without further terms") {
    const auto log = made(-3.0, 0.8, 50, expected);
    const auto line = fitter(log, 0.8).fit(all(log), all(log));
    CHECK_FALSE(line.finite_band);
    CHECK_FALSE(line.log_periodic);
    // half of the variance of a logarithm is put back into its mean, here 0.5e-6
    CHECK(test::relative_error(line.slope, 0.8) < 1e-5);
    CHECK(std::abs(line.level - 0.8 * line.reference + 3.0 - 0.5e-6) < 1e-4);
}

TEST_CASE("Waves in ln S2 are taken for waves, and leave the slope") {
    const auto log = made(-3.0, 0.8, 50,
                          [](double x) { return expected(x) + 0.1 * std::sin(2 * 3.141592653589793 * x / log_gamma); });
    const auto line = fitter(log, 0.8).fit(all(log), all(log));
    CHECK(line.log_periodic);
    CHECK(test::relative_error(line.slope, 0.8) < 1e-4);
}

TEST_CASE("The waves beyond the ends of the band are found where the window is long enough") {
    const double power = 0.8, last = std::log(static_cast<double>(detail::logarithmic_lags(1000).back()));
    const double short_waves = -0.5 * detail::share_of_short_waves(power), long_waves = -0.6;
    const auto log = made(-3.0, power, 1000, [&](double x) {
        return short_waves * std::exp(-power * x) + long_waves * std::exp((4 - power) * (x - last));
    });
    const auto line = fitter(log, power).fit(all(log), all(log));
    CHECK(line.finite_band);
    // the prior draws them towards 0, by their error over the prior deviation
    CHECK(std::abs(line.slope - power) < 5e-3);
    CHECK(std::abs(line.long_waves - long_waves) < 0.02);
    CHECK(std::abs(line.short_waves - short_waves) < 0.05);
}

TEST_CASE("S2 of waves no shorter than the first lag lacks the integral over the others") {
    const double power = GENERATE(0.4, 1.0, 1.6);
    double with = 0, without = 0;
    const double step = 1e-4, pi = 3.14159265358979;
    for (double u = std::log(1e-4); u < std::log(1e4); u += step) {
        const double x = std::exp(u);
        (x > 2 * pi ? without : with) += std::pow(x, -power) * step * (x > 2 * pi ? 1.5 : std::pow(1 - std::cos(x), 2));
        if (x > 2 * pi) with += std::pow(1 - std::cos(x), 2) * std::pow(x, -power) * step;
    }
    const double rest = 1.5 * std::pow(1e4, -power) / power;
    CHECK(test::relative_error(detail::share_of_short_waves(power), (without + rest) / (with + rest)) < 1e-3);
}

TEST_CASE("The rows give the change of slope and level with each value of ln S2") {
    auto log = made(-3.0, 0.8, 400, [](double x) { return 0.01 * std::sin(9 * x); });
    const auto line = fitter(log, 0.8).fit(all(log), all(log));
    const double small = 1e-3;  // the line is linear in the values
    for (Eigen::Index k = 0; k < log.lag.size(); k += 7) {
        log.value[k] += small;
        const auto moved = fitter(log, 0.8).fit(all(log), all(log));
        log.value[k] -= small;
        CHECK(std::abs((moved.slope - line.slope) / small - line.slope_row[k]) < 1e-9);
        CHECK(std::abs((moved.level - line.level) / small - line.level_row[k]) < 1e-9);
    }
}

TEST_CASE("The root of a matrix gives the matrix, and its inverse the identity") {
    detail::Matrix<double> a(3, 3);
    a << 4, 2, 1, 2, 5, 3, 1, 3, 6;
    const auto root = detail::cholesky(a);
    CHECK((root * root.transpose() - a).cwiseAbs().maxCoeff() < 1e-14);
    CHECK((detail::forward_substituted<double>(root, root) - detail::Matrix<double>::Identity(3, 3))
              .cwiseAbs()
              .maxCoeff() < 1e-14);
}

}  // namespace structure_fit_test
