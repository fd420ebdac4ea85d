// SPDX-License-Identifier: BSD-3-Clause
// The parts of a band by their definition; tests/scene/one_measurement_test.cpp holds the band of K to its parts.
#include <fstiff/answer/band.hpp>
#include <fstiff/answer/band_parts.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <cmath>
#include <limits>
#include <span>
#include <vector>

namespace band_parts_test {

using namespace fstiff;
using test::relative_error;

TEST_CASE("Unknowns widen a band by squares as do those of one kind and the greatest is reported") {
    const double k = 2e14;
    const auto curves = [](Unknown which, double low, double high) {
        return detail::UnknownCurves<double>{which, {std::exp(low)}, {std::exp(high)}};
    };
    const std::vector<detail::UnknownCurves<double>> unknowns{
        curves(Unknown::gradient, -0.3, 0.4), curves(Unknown::gradient, 0.3, -0.4),  // of the other face
        curves(Unknown::alpha, 0.1, std::numeric_limits<double>::quiet_NaN()), curves(Unknown::skewness, 0.05, -0.2),
        curves(Unknown::kurtosis, -0.1, 0)};
    const auto wide =
        detail::widened<double>(k, {k * std::exp(-0.2), k, k * std::exp(0.1), 0}, {}, {}, 0, false, 1, unknowns);
    const auto& parts = wide.parts;
    CHECK(relative_error(-parts.prior_low, std::hypot(0.3, 0.4)) < 1e-14);
    CHECK(relative_error(parts.prior_high, std::hypot(0.4, 0.3, 0.1)) < 1e-14);
    CHECK(relative_error(-parts.shape_low, std::hypot(0.2, 0.1)) < 1e-14);
    CHECK(relative_error(parts.shape_high, 0.05) < 1e-14);
    CHECK(relative_error(std::log(wide.band.low / k), -std::hypot(0.2, 0.5, std::hypot(0.2, 0.1))) < 1e-13);
    CHECK(relative_error(std::log(wide.band.high / k), std::hypot(0.1, std::sqrt(0.26), 0.05)) < 1e-13);
    // no unknown leaves the band as it is, to the last bit
    const auto same = detail::widened<double>(k, {k / 2, k, k * 2, 0}, {{k * 0.9}}, {}, 0, false, 1, {});
    detail::SampledBand<double> direct{k / 2, k, k * 2, 0};
    (void)detail::widen(direct, k, std::span<const double>(std::vector<double>{k * 0.9}));
    CHECK((same.band.low == direct.low && same.band.high == direct.high));
}

TEST_CASE("A band is widened by squares, and its parts are logarithms over K") {
    const double k = 2e14;
    const auto at = [&](double factor) { return k * factor; };
    detail::SampledBand<double> band{at(0.8), at(1.01), at(1.25), 0};
    const std::vector<double> others{at(0.7), at(1.1), -1, 0, std::nan(""), std::numeric_limits<double>::infinity()};
    const auto parts = detail::widen(band, k, std::span<const double>(others));
    CHECK(relative_error(parts.errors_low, std::log(0.8)) < 1e-13);
    CHECK(relative_error(parts.errors_high, std::log(1.25)) < 1e-13);
    CHECK(relative_error(parts.scale_low, std::log(0.7)) < 1e-13);
    CHECK(relative_error(parts.scale_high, std::log(1.1)) < 1e-13);
    CHECK(relative_error(band.low, k * std::exp(-std::sqrt(std::pow(std::log(0.8), 2) + std::pow(std::log(0.7), 2)))) <
          1e-13);
    CHECK(relative_error(band.high, k * std::exp(std::sqrt(std::pow(std::log(1.25), 2) + std::pow(std::log(1.1), 2)))) <
          1e-13);
    CHECK(band.median == at(1.01));
    CHECK(parts.window_low == 0);
}

TEST_CASE("Neighbours on one side widen that side and a band of 0 surfaces stays empty") {
    detail::SampledBand<double> band{0.9, 1, 1.1, 0};
    const std::vector<double> above{1.2, 1.3};
    const auto parts = detail::widen(band, 1.0, std::span<const double>(above));
    CHECK(relative_error(band.low, 0.9) < 1e-15);
    CHECK(parts.scale_low == 0);
    CHECK(relative_error(parts.scale_high, std::log(1.3)) < 1e-15);
    detail::SampledBand<double> none;
    CHECK(detail::widen(none, 1.0, std::span<const double>(above)).scale_high == 0);
    CHECK(none.high == 0);
    detail::SampledBand<double> higher{1.05, 1.1, 1.2, 0};  // K is below the band: its low end stays
    (void)detail::widen(higher, 1.0, std::span<const double>(above));
    CHECK(relative_error(higher.low, 1.05) < 1e-15);
    detail::SampledBand<double> huge{1, 1, 1e308, 0};
    const std::vector<double> far_above{1e300};
    (void)detail::widen(huge, 1.0, std::span<const double>(far_above));
    CHECK(huge.high == std::numeric_limits<double>::max() / 2);
}

TEST_CASE("The window of D moves it by 5 % and 95 % of its error, within its range") {
    const auto [low, high] = detail::dimensions_of_other_windows(1.5, 0.1);
    CHECK(relative_error(low, 1.5 - 0.16448536269514722) < 1e-14);
    CHECK(relative_error(high, 1.5 + 0.16448536269514722) < 1e-14);
    CHECK(detail::dimensions_of_other_windows(1.99, 0.1)[1] == 1.999);
    CHECK(detail::dimensions_of_other_windows(1.01, 0.1)[0] == 1.001);
}

}  // namespace band_parts_test
