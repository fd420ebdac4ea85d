// SPDX-License-Identifier: BSD-3-Clause
#include "sweep/draws.hpp"

#include "support/catch.hpp"

#include <cmath>
#include <set>

namespace draws_test {

using namespace fstiff::sweep;

TEST_CASE("Philox gives the known answers of its authors") {
    // kat_vectors of Random123 1.14, philox4x32 10
    using Words = std::array<std::uint32_t, 4>;
    CHECK(philox({0, 0, 0, 0}, {0, 0}) == Words{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8});
    constexpr std::uint32_t all = 0xffffffff;
    CHECK(philox({all, all, all, all}, {all, all}) == Words{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd});
    CHECK(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}) ==
          Words{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1});
}

TEST_CASE("A draw depends on seed, scene and input alone, and none is 0 or 1") {
    CHECK(uniform_draw(1, 2, 3) == uniform_draw(1, 2, 3));
    std::set<double> all;
    for (std::uint64_t seed : {0ULL, 1ULL, 1ULL << 40})
        for (std::uint64_t index : {0ULL, 1ULL, 1ULL << 32, (1ULL << 32) + 1})
            for (std::uint32_t input : {0U, 1U}) all.insert(uniform_draw(seed, index, input));
    CHECK(all.size() == 24);
    double least = 1, most = 0, sum = 0, square = 0;
    constexpr int n = 200000;
    for (int i = 0; i < n; ++i) {
        const double u = uniform_draw(7, static_cast<std::uint64_t>(i), 0);
        least = std::min(least, u), most = std::max(most, u), sum += u, square += u * u;
    }
    CHECK(least > 0);
    CHECK(most < 1);
    CHECK(std::abs(sum / n - 0.5) < 4 * std::sqrt(1.0 / 12 / n));  // four standard errors
    CHECK(std::abs(square / n - 1.0 / 3) < 4 * std::sqrt(4.0 / 45 / n));
}

TEST_CASE("The distributions have the quantiles that their names promise") {
    constexpr double one = 0.84134474606854292578;  // P(Z <= 1)
    const Distribution normal{Distribution::Kind::normal, 5, 0.2}, log{Distribution::Kind::lognormal, 40, 0.1},
        uniform{Distribution::Kind::uniform, 4, 6};
    CHECK(normal.quantile(0.5) == 5);
    CHECK(std::abs(normal.quantile(one) - 5.2) < 1e-14);
    CHECK(log.quantile(0.5) == 40);
    CHECK(std::abs(log.quantile(one) / (40 * std::exp(0.1)) - 1) < 1e-14);
    CHECK(uniform.quantile(0.25) == 4.5);
}

}  // namespace draws_test
