// SPDX-License-Identifier: BSD-3-Clause
// Truth: the sum of squares in long double, searched by thirds, and simulated noise.
#include <fstiff/wave/common_stiffness.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/springs.hpp"

#include <numbers>
#include <random>

namespace common_stiffness_test {

using namespace fstiff;
using Observed = std::vector<detail::ReflectionAt<double>>;

namespace {

const Impedances<double> steel{46e6, 46e6}, unlike{46e6, 17e6};
const double megahertz = 2e6 * std::numbers::pi;

/// |R| of the stiffness \p K(f) at \p frequencies [MHz], with \p noise standard normal deviates of \p error.
template <class Stiffness>
Observed spectrum(const std::vector<double>& frequencies, const Stiffness& K, const Impedances<double>& media,
                  double error, std::mt19937_64* noise = nullptr) {
    std::normal_distribution<double> normal;
    Observed observed;
    for (const double f : frequencies) {
        const double R =
            static_cast<double>(std::abs(test::wide_reflection(K(f), media.incident, media.beyond, f * megahertz)));
        observed.push_back({f * megahertz, R + (noise ? error * normal(*noise) : 0), error});
    }
    return observed;
}

test::Wide squares(const Observed& observed, const Impedances<double>& media, test::Wide K) {
    test::Wide sum = 0;
    for (const auto& [omega, R, error] : observed) {
        const test::Wide rest =
            (R - std::abs(test::wide_reflection(K, media.incident, media.beyond, omega))) / (error > 0 ? error : 1);
        sum += rest * rest;
    }
    return sum;
}

/// The logarithm of the K of the least sum of squares within a factor of two of \p K.
test::Wide least(const Observed& observed, const Impedances<double>& media, test::Wide K) {
    test::Wide low = std::log(K / 2), high = std::log(K * 2);
    for (int i = 0; i < 90; ++i) {
        const test::Wide a = low + (high - low) / 3, b = high - (high - low) / 3;
        (squares(observed, media, std::exp(a)) < squares(observed, media, std::exp(b)) ? high : low) =
            squares(observed, media, std::exp(a)) < squares(observed, media, std::exp(b)) ? b : a;
    }
    return (low + high) / 2;
}

const std::vector<double> band{2, 3, 4, 5, 6, 7, 8, 9, 10};

}  // namespace

TEST_CASE("K of several frequencies has the least sum of squares in R, and its error the curvature of that") {
    std::mt19937_64 noise(7);
    for (const auto& media : {steel, unlike})
        for (const double K : {3e14, 4e14, 6e14})
            for (const bool known : {true, false}) {
                Observed observed = spectrum(
                    band, [&](double) { return K; }, media, 0.004, &noise);
                if (!known)
                    for (auto& each : observed) each.error = 0;
                const auto common = detail::common_stiffness<double>(observed, media);
                const test::Wide x = least(observed, media, K), h = 1e-3L;
                INFO("K " << K << " z2 " << media.beyond << " known " << known);
                // thirds find the place of a minimum to the root of the rounding of its value
                CHECK(std::abs(std::log(common.value) - x) < 1e-8);
                const auto at = [&](test::Wide u) { return squares(observed, media, std::exp(u)); };
                const test::Wide curvature = (at(x + h) - 2 * at(x) + at(x - h)) / (h * h) / 2;
                const test::Wide scatter = std::sqrt(at(x) / (band.size() - 1));
                const test::Wide error =
                    common.value / std::sqrt(curvature) * (known ? std::max<test::Wide>(1, scatter) : scatter);
                // the second derivative of R, which the covariance leaves out, has a share of the residuals
                CHECK(test::relative_error(common.error, static_cast<double>(error)) < 0.03);
                CHECK(common.scatter > 0);
            }
}

TEST_CASE("One reflection has the K of the inverse, and its error if that is known") {
    const Observed one{{5 * megahertz, 0.8, 0.002}};
    const auto common = detail::common_stiffness<double>(one, steel);
    CHECK(common.value == stiffness_from_reflection(0.8, steel, 5 * megahertz));
    CHECK(common.error == detail::measured_stiffness(0.8, 0.002, steel, 5 * megahertz).error);
    CHECK(common.scatter == 0);
    CHECK(detail::common_stiffness<double>(Observed{{5 * megahertz, 0.8, 0}}, steel).error == 0);
    CHECK_THROWS_AS(detail::common_stiffness<double>(Observed{}, steel), domain_error);
}

TEST_CASE("K is within its standard error in 68 % of simulated measurements, and depends on no frequency in 99 %") {
    std::mt19937_64 noise(11);
    int inside = 0, alarms = 0;
    constexpr int draws = 4000;
    for (int i = 0; i < draws; ++i) {
        detail::LoadSpectrum<double> load{spectrum(
            band, [](double) { return 4e14; }, steel, 0.004, &noise)};
        for (auto& each : load.observed) each.error = i % 2 == 0 ? 0.004 : 0;
        load.common = detail::common_stiffness<double>(load.observed, steel);
        inside += std::abs(load.common.value - 4e14) < load.common.error;
        const auto trend = detail::frequency_trend<double>(std::vector{load}, steel, 0.0);
        REQUIRE(trend);
        alarms += trend->depends() || trend->scatters;
    }
    // of 4000 draws 0.74 % are one standard deviation; the wider of two errors is taken, and t of 8 degrees is 66 %
    CHECK(inside > 0.655 * draws);
    CHECK(inside < 0.735 * draws);
    CHECK(alarms < 0.03 * draws);  // 1 % of the trend, and the tail of chi^2 beyond n + 3 sqrt(2 n)
}

TEST_CASE("A stiffness that grows with a power of the frequency has that exponent, and is named") {
    for (const double film : {0.0, 1e14})
        for (const double b : {-0.2, -0.05, 0.05, 0.2}) {
            std::vector<detail::LoadSpectrum<double>> loads;
            for (const double K : {1e14, 3e14, 1e15}) {
                const auto stiffness = [&](double f) { return K * std::pow(f / 5, b) + film; };
                loads.push_back({spectrum(band, stiffness, steel, 0.001)});
                loads.back().common = detail::common_stiffness<double>(loads.back().observed, steel);
            }
            const auto trend = detail::frequency_trend<double>(loads, steel, film);
            REQUIRE(trend);
            INFO("b " << b << " film " << film << " found " << trend->exponent);
            // to first order in ln K, of which 0.2 ln 2.5 is 0.18
            CHECK(std::abs(trend->exponent - b) < 0.6 * b * b + 1e-3);
            CHECK(trend->depends());
            CHECK(test::relative_error(trend->low, 2 * megahertz) < 1e-15);
            CHECK(test::relative_error(trend->change(), std::pow(5, trend->exponent)) < 1e-13);
        }
}

TEST_CASE("Without two frequencies, or without a scatter that tells, there is no trend") {
    const auto trend_of = [](const Observed& observed) {
        detail::LoadSpectrum<double> load{observed, detail::common_stiffness<double>(observed, steel)};
        return detail::frequency_trend<double>(std::vector{load}, steel, 0.0);
    };
    const auto K = [](double) { return 4e14; };
    CHECK_FALSE(trend_of(spectrum({5}, K, steel, 0.002)));
    CHECK_FALSE(trend_of(spectrum({5, 5, 5}, K, steel, 0.002)));
    CHECK_FALSE(trend_of(spectrum({2, 5}, K, steel, 0)));
    CHECK(trend_of(spectrum({2, 5}, K, steel, 0.002)));
    CHECK(trend_of(spectrum({2, 5, 10}, K, steel, 0)));
    CHECK_FALSE(trend_of(spectrum({2, 5, 10}, K, steel, 0))->depends());
}

}  // namespace common_stiffness_test
