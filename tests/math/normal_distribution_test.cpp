// SPDX-License-Identifier: BSD-3-Clause
// Truth: the distribution in long double, which std::erfc has.
#include <fstiff/math/normal_distribution.hpp>

#include "support/catch.hpp"

#include <cmath>

namespace normal_distribution_test {

using namespace fstiff;

TEST_CASE("The inverse of the normal distribution is right to 1e-15 of the quantile") {
    // Newton's correction by the distribution in long double is the error
    const auto error = [](double p) {
        const long double z = math::normal_quantile(p);
        const long double upper = p > 0.5 ? 1 - static_cast<long double>(p) : static_cast<long double>(p);
        const long double tail = std::erfc(std::abs(z) / std::sqrt(2.0L)) / 2;
        const long double density = std::exp(-z * z / 2) / std::sqrt(2 * 3.14159265358979323846264338327950288L);
        return static_cast<double>((upper - tail) / density / std::abs(z));
    };
    double worst = 0;
    for (double p = 1e-300; p < 0.49; p *= 1.37) worst = std::max(worst, std::abs(error(p)));
    for (int i = 1; i < 1000; ++i)
        if (i != 500) worst = std::max(worst, std::abs(error(i / 1000.0)));
    CHECK(worst < 1e-15);
    CHECK(math::normal_quantile(0.5) == 0);
    CHECK(math::normal_quantile(0.25) == -math::normal_quantile(0.75));
}

TEST_CASE("The inverse of the normal distribution is that of the distribution") {
    for (const double z : {-7.0, -1.0, -1e-3, 0.3, 2.0, 5.0})
        CHECK(std::abs(math::normal_quantile(math::normal_share(z)) - z) < 1e-15 * (1 + std::exp(z * z / 2)));
    CHECK(std::abs(math::normal_density(1.0) - 0.24197072451914337) < 1e-16);
}

}  // namespace normal_distribution_test
