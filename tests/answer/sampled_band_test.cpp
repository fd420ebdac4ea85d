// SPDX-License-Identifier: BSD-3-Clause
// Truth: the quantiles of the lognormal and the normal distribution that the parameters have.
#include <fstiff/answer/band.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

namespace sampled_band_test {

using namespace fstiff;

namespace {

SurfaceParameters<double> surface() {
    SurfaceParameters<double> s;
    s.set(Parameter::rms_height, {1e-6, 2e-7});
    s.set(Parameter::peak_radius, {2e-5, 0});
    s.set(Parameter::peak_density, {3e9, 0});
    s.set(Parameter::fractal_dimension, {1.4, 0.01});
    return s;
}

const auto both = [](const auto& x, std::size_t) { return std::vector<double>{x[0], x[3]}; };

}  // namespace

TEST_CASE("The band of a parameter is that of its distribution within the error of so many surfaces") {
    const double s = std::sqrt(std::log1p(0.04));
    int outside = 0;
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
        const auto band = detail::sampled_band(surface(), both, {.samples = 400, .seed = seed});
        REQUIRE(band.size() == 2);
        for (const auto& [z, sigma, d] :
             {std::tuple(-1.6448536, band[0].low, band[1].low), std::tuple(1.6448536, band[0].high, band[1].high)}) {
            outside += std::abs(std::log(sigma / 1e-6) / s - z) > 2 * 0.106;
            outside += std::abs((d - 1.4) / 0.01 - z) > 2 * 0.106;
        }
        CHECK(std::abs((band[1].median - 1.4) / 0.01) < 5 * 1.2533 / 20);
    }
    // 5 % of 200 are expected beyond two standard errors, 3 more standard deviations of the binomial
    CHECK(outside <= 10 + 9);
    CHECK(outside >= 1);
}

TEST_CASE("The same seed gives the same band and values that are no numbers are counted separately") {
    std::vector<std::size_t> done;
    const auto hook = [&](std::string_view what, std::size_t i, std::size_t all) {
        CHECK((what == "surfaces" && all == 30));
        done.push_back(i);
    };
    int calls = 0;
    const auto some = [&](const auto& x, std::size_t) {
        ++calls;
        const double missing = calls % 3 == 0   ? std::numeric_limits<double>::quiet_NaN()
                               : calls % 3 == 1 ? std::numeric_limits<double>::infinity()
                                                : x[0];
        return std::vector<double>{x[0], missing, std::numeric_limits<double>::quiet_NaN()};
    };
    const auto first = detail::sampled_band(surface(), some, {.samples = 30, .seed = 5, .progress = hook});
    const auto second = detail::sampled_band(surface(), some, {.samples = 30, .seed = 5});
    CHECK((done.size() == 30 && done.front() == 0 && done.back() == 29));
    CHECK((first[0].low == second[0].low && first[0].high == second[0].high && first[0].failed == 0));
    CHECK((first[0].low < first[0].median && first[0].median < first[0].high));
    CHECK(first[1].failed == 20);
    CHECK((first[2].failed == 30 && first[2].low == 0 && first[2].high == 0));
}

TEST_CASE("Surfaces in pieces, whichever comes first, give the same band without progress") {
    std::vector<std::size_t> order;
    const auto numbered = [&](const auto& x, std::size_t i) {
        order.push_back(i);
        return std::vector<double>{x[0], x[3] * static_cast<double>(i)};
    };
    const auto backwards = [](std::size_t count, const auto& run) {
        for (std::size_t i = count; i-- > 0;) run(i);
    };
    const auto never = [](std::string_view, std::size_t, std::size_t) { FAIL(); };
    const auto first = detail::sampled_band(surface(), numbered, {.samples = 50, .seed = 7});
    CHECK((order.front() == 0 && order.back() == 49));
    const auto second =
        detail::sampled_band(surface(), numbered, {.samples = 50, .seed = 7, .progress = never, .parallel = backwards});
    CHECK((order[50] == 49 && order.back() == 0));
    for (std::size_t k = 0; k < 2; ++k)
        CHECK(
            (first[k].low == second[k].low && first[k].median == second[k].median && first[k].high == second[k].high));
}

TEST_CASE("No surfaces, surfaces out of range and values that change their number are refused") {
    CHECK(test::refusal([] { (void)detail::sampled_band(surface(), both, {.samples = 0}); }) ==
          "samples = 0: must be at least 1");
    SurfaceParameters<double> bad = surface();
    bad.rms_height.value = -1;
    CHECK(test::refusal([&] { (void)detail::sampled_band(bad, both); }).starts_with("rms_height = -1: must be"));
    std::size_t size = 0;
    CHECK(test::refusal([&] {
              (void)detail::sampled_band(
                  surface(), [&](const auto&, std::size_t) { return std::vector<double>(++size); }, {.samples = 3});
          }) == "values of a drawn surface = 2: must be 1, as of the first");
}

}  // namespace sampled_band_test
