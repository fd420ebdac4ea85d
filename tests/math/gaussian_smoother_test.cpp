// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/math/gaussian_smoother.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <numbers>

namespace gaussian_smoother_test {

using namespace fstiff;

TEST_CASE("The sums with Gaussian weights are those of the double loop") {
    const double a = std::sqrt(std::numbers::ln2 / std::numbers::pi);
    for (const std::size_t size : {std::size_t{1}, std::size_t{7}, std::size_t{400}})
        for (const double width : {0.3, 2.0, 31.0, 1e30}) {
            std::vector<double> z(size);
            for (std::size_t i = 0; i < size; ++i) z[i] = std::fmod(static_cast<double>(i * i) * 0.618, 2.0) - 0.9;
            GaussianSmoother<double> smooth(size, width);
            auto sums = z;
            smooth(sums);
            REQUIRE(sums.size() == size);
            for (std::size_t i = 0; i < size; ++i) {
                long double sum = 0;
                for (std::size_t k = 0; k < size; ++k) {
                    const double x = (static_cast<double>(i) - static_cast<double>(k)) / (a * width);
                    sum += static_cast<long double>(std::exp(-std::numbers::pi * x * x)) * z[k];
                }
                CAPTURE(size, width, i);
                REQUIRE(std::abs(sums[i] - static_cast<double>(sum)) < 1e-13 * std::min(width + 1, 400.0));
            }
        }
}

TEST_CASE("No numbers, no width and a wrong count of numbers are refused") {
    CHECK_FALSE(test::refusal([] { GaussianSmoother<double>(0, 1.0); }).empty());
    CHECK_FALSE(test::refusal([] { GaussianSmoother<double>(5, 0.0); }).empty());
    GaussianSmoother<double> smooth(5, 2.0);
    std::vector<double> four(4, 1.0);
    CHECK_FALSE(test::refusal([&] { smooth(four); }).empty());
}

}  // namespace gaussian_smoother_test
