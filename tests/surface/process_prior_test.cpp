// SPDX-License-Identifier: BSD-3-Clause
// Values for numbers that a drawing does not give: against the formulae, and against generated surfaces.
#include <fstiff/measure/measure.hpp>
#include <fstiff/surface/process_prior.hpp>
#include <fstiff/synthetic/self_affine.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace process_prior_test {

using namespace fstiff;
using test::relative_error;

/// RSm of heights about their mean: elements between rising crossings of the mean line, none lower than a tenth of the
/// mean height of five sampling lengths or shorter than a hundredth of one.
double mean_spacing(const Profile<double>& profile) {
    const Eigen::Map<const Eigen::ArrayXd> z(profile.heights.data(), static_cast<Eigen::Index>(profile.heights.size()));
    const Eigen::Index count = z.size(), length = count / 5;
    const double mean = z.mean();
    double height = 0;
    for (Eigen::Index k = 0; k < 5; ++k) {
        const auto part = z.segment(k * length, length);
        height += (part.maxCoeff() - part.minCoeff()) / 5;
    }
    Eigen::Index from = -1, first = -1, last = -1;
    int rises = 0, side = 0;
    double most = 0;
    for (Eigen::Index i = 1; i < count; ++i) {
        const bool above = z[i] >= mean;
        if (above == (z[i - 1] >= mean)) {
            most = std::max(most, std::abs(z[i] - mean));
            continue;
        }
        if (from >= 0 && most >= height / 10 && static_cast<double>(i - from) >= static_cast<double>(length) / 100) {
            const int this_side = above ? -1 : 1;  // of the part that ends here
            if (this_side != side && this_side > 0) {
                if (first < 0) first = from;
                last = from, ++rises;
            }
            side = this_side;
        }
        from = i, most = std::abs(z[i] - mean);
    }
    return static_cast<double>(last - first) / (rises - 1) * profile.spacing;
}

TEST_CASE("The gradient of a height alone is that of the process, less certain beyond the heights of the sources") {
    const detail::ProcessPrior& any = detail::prior_of(Process::unknown);
    const auto at = [&](double height) { return detail::gradient_of_height(any, height); };
    CHECK(relative_error(at(1e-6).middle, 0.2) < 1e-14);
    CHECK(relative_error(at(4e-6).high, 1.2) < 1e-14);
    CHECK(relative_error(at(1e-8).middle, 0.02) < 1e-14);
    CHECK(relative_error(at(1e-8).high / at(1e-8).middle, 3 * std::pow(10, 0.25)) < 1e-14);
    CHECK(relative_error(at(1e-4).low / at(1e-4).middle, 0.335 / std::pow(10, 0.25)) < 1e-14);
    // the sources lie within: mean slopes of profiles of 0.1 to 10 um, times sqrt(pi)
    for (const double height : {0.2, 1.0, 5.0})
        for (const double slope : {0.152 * std::pow(height, 0.4), 0.124 * std::pow(height, 0.743),
                                   0.076 * std::pow(height, 0.52), 0.125 * std::pow(height, 0.402)}) {
            const double gradient = std::sqrt(std::numbers::pi_v<double>) * slope;
            CHECK(gradient > at(height * 1e-6).low);
            CHECK(gradient < at(height * 1e-6).high);
        }
    CHECK_THROWS_AS(at(0), domain_error);
    CHECK_THROWS_AS(detail::slope_of_spacing(1e-6, -1e-6), domain_error);
    CHECK_THROWS_AS(detail::gradient_of_islands(1e-6, 0, 1e9), domain_error);
}

TEST_CASE("The slope that the mean spacing gives holds that of Gaussian profiles") {
    for (const auto& [longest, shortest] : {std::pair(50e-6, 25e-6), std::pair(100e-6, 10e-6), std::pair(200e-6, 5e-6)})
        for (const double hurst : {0.3, 0.8}) {
            const Profile<double> profile = self_affine_profile<double>({.hurst = hurst,
                                                                         .rms = 1e-6,
                                                                         .longest_wavelength = longest,
                                                                         .shortest_wavelength = shortest,
                                                                         .seed = 5},
                                                                        16000, 0.25e-6);
            const Eigen::Map<const Eigen::ArrayXd> z(profile.heights.data(),
                                                     static_cast<Eigen::Index>(profile.heights.size()));
            const Eigen::Index inner = z.size() - 1;
            const double slope = std::sqrt((z.tail(inner) - z.head(inner)).square().mean()) / profile.spacing;
            const PriorRange range = detail::slope_of_spacing(1e-6, mean_spacing(profile));
            INFO(longest << " " << shortest << " " << hurst << ": " << slope << " of " << range.low << " to "
                         << range.high);
            CHECK(slope > range.low);
            CHECK(slope < range.high);
        }
}

TEST_CASE("The gradient that islands give is that of Gaussian maps") {
    for (const auto& [hurst, longest, shortest] : {std::array{0.8, 32e-6, 8e-6}, std::array{0.38, 16e-6, 8e-6}}) {
        const HeightMap<double> map = self_affine_map<double>(
            {.hurst = hurst, .rms = 1e-6, .longest_wavelength = longest, .shortest_wavelength = shortest, .seed = 2},
            256, 256, 1e-6, 1e-6);
        const Surface<double> surface = measure(map);
        const PriorRange range = detail::gradient_of_islands(surface.rms_height.value, surface.peak_radius.value,
                                                             surface.peak_density.value);
        INFO(hurst << ": " << surface.rms_gradient.value << " of " << range.low << " to " << range.high);
        CHECK(relative_error(range.middle, surface.rms_gradient.value) < 0.15);
        CHECK(surface.rms_gradient.value > range.low);
        CHECK(surface.rms_gradient.value < range.high);
    }
}

TEST_CASE("A profile across a lay gives the gradient to the root of two") {
    const PriorRange isotropic = detail::gradient_of_slope(detail::prior_of(Process::blasted)),
                     lay = detail::gradient_of_slope(detail::prior_of(Process::turned));
    CHECK((isotropic.low == isotropic.high && relative_error(isotropic.middle, std::sqrt(2.0)) < 1e-15));
    CHECK((lay.low == 1 && lay.high == isotropic.high));
    CHECK(relative_error(lay.middle * lay.middle, lay.high) < 1e-15);
}

TEST_CASE("Every other word for a process has one meaning, whatever its capitals and separators") {
    std::vector<std::string_view> words;
    for (const detail::ProcessWords& row : detail::process_words)
        for (std::string_view rest = row.words; !rest.empty();) {
            const std::size_t end = std::min(rest.find(','), rest.size());
            const std::string_view word = rest.substr(0, end);
            INFO(word);
            CHECK(detail::find_process(word) == row.process);
            for (const std::string_view other : words) CHECK_FALSE(detail::is_same_name(word, other));
            words.push_back(word);
            rest.remove_prefix(std::min(end + 1, rest.size()));
        }
    for (const auto& known : enum_names<Process>) CHECK(detail::find_process(known.name) == known.value);
    CHECK(detail::find_process("Sand_Blasted") == Process::blasted);
    CHECK(detail::find_process("edm") == Process::eroded);
    for (const char* none : {"", "gruond", "milledd", "ground,turned"})
        CHECK_FALSE(detail::find_process(none).has_value());
    CHECK(detail::process_of("grinding", "process") == Process::ground);
    try {
        (void)detail::process_of("gruond", "process");
        FAIL("a word that names no process is not refused");
    } catch (const domain_error& error) {
        CHECK(std::string(error.what()).find("process = \"gruond\": must be one of unknown, ground") == 0);
    }
}

}  // namespace process_prior_test
