// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/profile/power_spectrum.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/fractional_brownian.hpp"
#include "support/roughness_reference.hpp"

#include <numbers>

namespace power_spectrum_test {

using namespace fstiff;

namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();
constexpr double pi = std::numbers::pi;

double hann(std::size_t i, std::size_t points) {
    return (1 - std::cos(2 * pi * (static_cast<double>(i) + 0.5) / static_cast<double>(points))) / 2;
}

}  // namespace

TEST_CASE("The integral of the spectrum is the mean square of the windowed heights") {
    const std::size_t points = GENERATE(16u, 100u, 1009u, 4096u);  // 1009 is prime: padded
    auto z = test::fractional_brownian(4096, 0.5, 1);
    z.resize(points);
    double weight = 0, square = 0, mean = 0, power = 0;
    for (std::size_t i = 0; i < points; ++i) {
        weight += hann(i, points);
        mean += hann(i, points) * z[i];
        square += hann(i, points) * hann(i, points);
    }
    mean /= weight;
    for (std::size_t i = 0; i < points; ++i) power += std::pow(hann(i, points) * (z[i] - mean), 2);
    const auto spectrum = power_spectrum(Profile<double>{z, 1e-6});
    // padding with zeros moves the power left at k = 0 into its neighbours: none of it is lost
    CHECK(test::relative_error(spectrum.moment(0), power / square) < 1e-13);
    CHECK(test::relative_error(spectrum.wavenumber.back(), pi / 1e-6) < 1e-14);
    CHECK(spectrum.value[0] == 0);
}

TEST_CASE("A sine has half its squared amplitude at its wavenumber, whatever the offset") {
    Profile<double> profile{std::vector<double>(4000), 1e-7};
    for (std::size_t i = 0; i < 4000; ++i)
        profile.heights[i] = 1e-3 + 3e-9 * std::sin(2 * pi * static_cast<double>(i) / 50 + 0.4);
    const auto spectrum = power_spectrum(profile);
    const auto peak = static_cast<std::size_t>(std::max_element(spectrum.value.begin(), spectrum.value.end()) -
                                               spectrum.value.begin());
    CHECK(test::relative_error(spectrum.wavenumber[peak], 2 * pi / 50e-7) < 1e-12);
    double power = 0;  // a Hann line is three values wide
    for (std::size_t k = peak - 1; k <= peak + 1; ++k) power += spectrum.value[k] * spectrum.step;
    // the offset rounds heights of 3e-9 to 1e-19
    CHECK(test::relative_error(power, 9e-18 / 2) < 1e-9);
}

TEST_CASE("D of fractional Brownian profiles is right in the mean and scatters by its error", "[more]") {
    const double hurst = GENERATE(0.3, 0.5, 0.8);
    const int profiles = 100;
    double mean = 0, square = 0, error = 0;
    for (int seed = 1; seed <= profiles; ++seed) {
        const Profile<double> profile{test::fractional_brownian(4096, hurst, static_cast<std::uint64_t>(seed)), 1e-6};
        const auto fit = detail::fit_spectrum(power_spectrum(profile));
        const double off = fit.dimension - (2 - hurst);
        mean += off / profiles;
        square += off * off / profiles;
        error += fit.dimension_error / profiles;
    }
    const double scatter = std::sqrt(square - mean * mean);
    CAPTURE(hurst, mean, scatter, error);
    CHECK(std::abs(mean) < 0.02);  // 0.01 of aliases from below the sampling, 0.003 of scatter
    CHECK(scatter / error > 0.8);  // the scatter of 100 is itself known to 7 %
    CHECK(scatter / error < 1.25);
}

TEST_CASE("A spectrum that is a power law gives its D to the rounding, in any unit and over any window") {
    for (const double unit : {1.0, 1e-9, 1e9}) {
        PowerSpectrum<double> spectrum;
        spectrum.step = 1e3 / unit;
        spectrum.independent = 1.5;
        for (std::size_t k = 0; k < 5000; ++k) {
            spectrum.wavenumber.push_back(static_cast<double>(k) * spectrum.step);
            spectrum.value.push_back(k == 0 ? 0 : std::pow(static_cast<double>(k), -2.2) * unit * unit * unit);
        }
        const double longest = 2 * pi / spectrum.step;
        const auto fit = detail::fit_spectrum(spectrum, LengthRange<double>{longest / 4000, longest / 100});
        // -2.2 = -(5-2D). The logarithm of a mean over an eighth of an octave is a curve of 2e-3 above the mean
        // logarithm, the same in every bin, but that bins hold whole numbers of values; the correction for their
        // number is what is left, 1/(2 v) with v from 6 to 230
        CHECK(std::abs(fit.dimension - 1.4) < 0.01);
        CHECK(fit.bins > 30);
        CHECK(test::relative_error(fit.window.to, longest / 100) < 1e-15);
    }
}

TEST_CASE("The spectrum scales with the unit of length, and gaps are bridged") {
    auto z = test::fractional_brownian(2048, 0.5, 3);
    const auto plain = power_spectrum(Profile<double>{z, 1.0});
    auto scaled = z;
    for (double& v : scaled) v *= 1e-9;
    const auto small = power_spectrum(Profile<double>{scaled, 1e-9});
    REQUIRE(small.size() == plain.size());
    for (std::size_t k = 1; k < plain.size(); ++k)
        REQUIRE(test::relative_error(small.value[k] * 1e27, plain.value[k]) < 1e-8);  // far below the peak
    // a straight ramp with a gap is the ramp; missing ends are cut off
    Profile<double> ramp{std::vector<double>(120), 1.0}, holed{std::vector<double>(124, missing), 1.0};
    for (std::size_t i = 0; i < 120; ++i) {
        ramp.heights[i] = static_cast<double>(i);
        if (i < 40 || i > 50) holed.heights[i + 2] = static_cast<double>(i);
    }
    const auto a = power_spectrum(ramp), b = power_spectrum(holed);
    REQUIRE(a.size() == b.size());
    for (std::size_t k = 0; k < a.size(); ++k) REQUIRE(std::abs(a.value[k] - b.value[k]) < 1e-10 * a.value[1]);
}

TEST_CASE("Windows that hold too little are refused") {
    const auto spectrum = power_spectrum(Profile<double>{test::fractional_brownian(1024, 0.5, 4), 1.0});
    const auto refusal = [&](double from, double to) {
        return test::refusal([&] { (void)detail::fit_spectrum(spectrum, LengthRange<double>{from, to}); });
    };
    CHECK(refusal(16, 128).empty());
    CHECK(refusal(16, 32).find("half a decade") != std::string::npos);
    CHECK(refusal(1e5, 1e6).find("holds 0 bins") != std::string::npos);
    CHECK(refusal(1e-9, 1e-8).find("holds 0 bins") != std::string::npos);
    CHECK(refusal(0, 10).find("window from = 0") == 0);
    CHECK(refusal(10, 5).find("window to = 5") == 0);
    CHECK_FALSE(test::refusal([] { (void)detail::fit_spectrum(PowerSpectrum<double>{}); }).empty());
    CHECK_FALSE(test::refusal([] {
                    (void)power_spectrum(Profile<double>{std::vector<double>(50, 1.0), 1.0});
                }).empty());
}

TEST_CASE("Spectra of profiles are those that scipy finds, with the window and without") {
    for (const auto window : {SpectrumWindow::hann, SpectrumWindow::none}) {
        const auto found = power_spectrum(test::reference_profile("profile_row"), window);
        std::size_t compared = 0;
        const std::string start = "psd_" + std::string(name_of(window)) + "_";
        for (const auto& [parameter, value] : test::roughness_reference("profile_row")) {
            if (!parameter.starts_with(start)) continue;
            CAPTURE(parameter);
            CHECK(test::relative_error(found.value[std::stoul(parameter.substr(start.size()))], value) < 1e-9);
            ++compared;
        }
        CHECK(compared >= 2);
    }
}

TEST_CASE("Without a window the integral of the spectrum is the variance") {
    auto z = test::fractional_brownian(1024, 0.5, 2);
    z.resize(1009);
    const Profile<double> profile{z, 1e-6};
    const auto spectrum = power_spectrum(profile, SpectrumWindow::none);
    CHECK(test::relative_error(spectrum.moment(0), std::pow(rms_height(profile), 2)) < 1e-13);
    CHECK(spectrum.value[0] == 0);
}

}  // namespace power_spectrum_test
