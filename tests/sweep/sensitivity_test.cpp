// SPDX-License-Identifier: BSD-3-Clause
#include "sweep/sensitivity.hpp"

#include "support/catch.hpp"

#include <cmath>

namespace sensitivity_test {

using namespace fstiff::sweep;

TEST_CASE("Sobol' indices and rank correlations of a product of powers are those of the closed form") {
    // K = x^a y^b z^c of lognormal inputs: ln K is normal, S_x = (exp(a^2 s^2) - 1)/(exp(sum) - 1), and the correlation
    // of ranks is 6/pi arcsin(rho/2) with rho = a s/sqrt(sum)
    const double power[]{1.5, -1, 0.3}, spread[]{0.2, 0.25, 0.1};
    constexpr std::uint64_t n = 40000;
    std::vector<std::vector<double>> inputs(3);
    std::vector<double> output;
    double sum = 0;
    for (int i = 0; i < 3; ++i) sum += power[i] * power[i] * spread[i] * spread[i];
    for (std::uint64_t k = 0; k < n; ++k) {
        double product = 1;
        for (std::uint32_t i = 0; i < 3; ++i) {
            const Distribution drawn{Distribution::Kind::lognormal, 2, spread[i]};
            inputs[i].push_back(drawn.quantile(uniform_draw(5, k, i)));
            product *= std::pow(inputs[i].back(), power[i]);
        }
        output.push_back(product);
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const auto found = sensitivity(inputs[i], output);
        REQUIRE(found);
        const double own = power[i] * power[i] * spread[i] * spread[i];
        const double index = (std::exp(own) - 1) / (std::exp(sum) - 1);
        const double rho = (power[i] > 0 ? 1 : -1) * std::sqrt(own / sum);
        INFO(i << ": " << found->first_order << " for " << index);
        CHECK(std::abs(found->first_order - index) < 3 / std::sqrt(double(n)));  // three times the scatter promised
        CHECK(std::abs(found->rank_correlation - 6 / 3.14159265358979 * std::asin(rho / 2)) < 3 / std::sqrt(double(n)));
    }
}

TEST_CASE("An input alone has the index 1, another one 0, and a constant none") {
    std::vector<double> x, y, falling;
    for (std::uint64_t k = 0; k < 5000; ++k) {
        x.push_back(uniform_draw(1, k, 0));
        y.push_back(uniform_draw(1, k, 1));
        falling.push_back(-std::exp(x.back()));
    }
    CHECK(std::abs(sensitivity(x, falling)->first_order - 1) < 0.01);  // the ends, which follow one another, cost 3/n
    CHECK(std::abs(sensitivity(x, falling)->rank_correlation + 1) < 1e-12);
    CHECK(std::abs(sensitivity(y, falling)->first_order) < 3 / std::sqrt(5000.0));
    CHECK(std::abs(sensitivity(y, falling)->rank_correlation) < 3 / std::sqrt(5000.0));
    CHECK(!sensitivity(x, std::vector<double>(5000, 2.5)));
}

}  // namespace sensitivity_test
