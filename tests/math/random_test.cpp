// SPDX-License-Identifier: BSD-3-Clause
// The bits against those published with the algorithm; normal numbers against their moments.
#include <fstiff/math/random.hpp>
#include <fstiff/math/statistics.hpp>

#include "support/catch.hpp"

namespace random_test {

using namespace fstiff;

TEST_CASE("splitmix64 gives the published numbers of seed 0") {
    std::uint64_t state = 0;
    CHECK(math::splitmix64(state) == 0xE220A8397B1DCDAFULL);
    CHECK(math::splitmix64(state) == 0x6E789E6AA1B965F4ULL);
}

TEST_CASE("Pairs of normal numbers have mean 0, variance 1, fourth moment 3, and are not correlated") {
    constexpr int pairs = 100000;
    std::uint64_t state = 7;
    double first = 0, square = 0, fourth = 0, product = 0;
    for (int i = 0; i < pairs; ++i) {
        const std::complex<double> z = math::normal_pair<double>(state);
        product += z.real() * z.imag() / pairs;
        for (const double x : {z.real(), z.imag()}) {
            first += x / (2 * pairs);
            square += x * x / (2 * pairs);
            fourth += x * x * x * x / (2 * pairs);
        }
    }
    // four standard deviations of the means: 1, sqrt 2 and sqrt 96 over the root of their number
    CHECK(std::abs(first) < 4 * std::sqrt(1 / (2.0 * pairs)));
    CHECK(std::abs(square - 1) < 4 * std::sqrt(2 / (2.0 * pairs)));
    CHECK(std::abs(fourth - 3) < 4 * std::sqrt(96 / (2.0 * pairs)));
    CHECK(std::abs(product) < 4 * std::sqrt(1.0 / pairs));
}

}  // namespace random_test
