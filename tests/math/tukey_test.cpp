// SPDX-License-Identifier: BSD-3-Clause
// Tukey's weights by hand, and the factor by the error function.
#include <fstiff/math/tukey.hpp>

#include "support/catch.hpp"

namespace tukey_test {

using namespace fstiff;

TEST_CASE("The factor is three standard deviations over the median of Gaussian absolute values") {
    const double median = 3 / math::tukey_factor<double>;
    CHECK(std::abs(std::erf(median / std::sqrt(2.)) - 0.5) < 2e-16);
}

TEST_CASE("Tukey's weights are 1 at 0, 9/16 at half of c, and 0 from c on") {
    CHECK(math::tukey_weight(0., 2.) == 1);
    CHECK(math::tukey_weight(1., 2.) == 0.5625);
    CHECK(math::tukey_weight(-1., 2.) == 0.5625);
    CHECK(math::tukey_weight(2., 2.) == 0);
    CHECK(math::tukey_weight(-1e9, 2.) == 0);
}

TEST_CASE("The median of few numbers") {
    std::vector<double> odd{5, 1, 4, 2, 3}, even{4, 1, 3, 2}, one{7}, none;
    CHECK(math::median(odd) == 3);
    CHECK(math::median(even) == 2.5);
    CHECK(math::median(one) == 7);
    CHECK_THROWS_AS(math::median(none), domain_error);
}

TEST_CASE("The network of eight has the median of every order of zeros and ones, and so of all numbers") {
    for (unsigned bits = 0; bits < 256; ++bits) {
        std::array<double, 8> values{};
        for (std::size_t i = 0; i < 8; ++i) values[i] = (bits >> i) & 1U;
        std::vector<double> copy(values.begin(), values.end());
        CHECK(math::median_of_eight(values) == math::median(copy));
    }
    CHECK(math::median_of_eight(std::array<double, 8>{8, -1, 5, 2, 7, 3, 100, 4}) == 4.5);
}

TEST_CASE("Spikes are far from the median by its robust deviation, and nothing is where most are equal") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    // median 3.5, deviations 2.5 1.5 0.5 0.5 1.5 96.5: their median is 1.5, a standard deviation 1.4826 times that
    const std::vector<double> some{1, 2, 3, nan, 4, 5, 100};
    const auto always = [](std::size_t, double) { return true; };
    const auto spikes = [&](std::vector<double> z, double limit, bool remove = false) {
        const auto repair = math::spikes_among(z.data(), std::vector<double>(z), limit, remove, always);
        CHECK(std::isnan(z.back()) == (remove && repair.removed > 0));
        return repair.removed;
    };
    CHECK(spikes(some, 5., true) == 1);
    CHECK(spikes(some, 5.) == 1);
    const double limit = 96.5 / (1.5 * math::tukey_factor<double> / 3);
    CHECK(spikes(some, 0.999 * limit) == 1);
    CHECK(spikes(some, 1.001 * limit) == 0);
    CHECK(spikes({0, 0, 0, 0, 9}, 5.) == 0);
    CHECK(math::spikes_among(std::vector<double>{nan}.data(), {nan}, 5., true, always).removed == 0);
    std::vector<double> two{1, 2, 3, 100, 4, 5, 200};
    const auto last = [&](std::size_t i, double) { return i == 6; };
    CHECK(math::spikes_among(two.data(), std::vector<double>(two), 5., true, last).removed == 1);
    CHECK(std::isnan(two[6]));
    CHECK(two[3] == 100);
}

}  // namespace tukey_test
