// SPDX-License-Identifier: BSD-3-Clause
// Truth: counting the heights above each height of the curve.
#include <fstiff/surface/material_ratio_curve.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <limits>
#include <random>

namespace bearing_curve_test {

using namespace fstiff;

TEST_CASE("As many heights are above the curve as its share gives") {
    std::mt19937_64 random(1);
    for (const std::size_t count : {std::size_t(1), std::size_t(7), std::size_t(200), std::size_t(1003)}) {
        std::vector<double> heights(count);
        for (double& z : heights) z = static_cast<double>(random() >> 11);
        std::vector<double> holed = heights;
        holed.insert(holed.begin() + 1, std::numeric_limits<double>::quiet_NaN());
        for (const std::size_t steps : {std::size_t(1), std::size_t(4), std::size_t(200)}) {
            const auto curve = bearing_curve<double>(holed, steps);
            REQUIRE(curve.size() == steps + 1);
            CHECK((curve.share.front() == 0 && curve.share.back() == 1));
            CHECK(curve.height.front() == *std::max_element(heights.begin(), heights.end()));
            CHECK(curve.height.back() == *std::min_element(heights.begin(), heights.end()));
            for (std::size_t k = 0; k < steps; ++k) {
                const auto above =
                    std::count_if(heights.begin(), heights.end(), [&](double z) { return z > curve.height[k]; });
                CHECK(static_cast<std::size_t>(above) == k * count / steps);
                CHECK(curve.height[k] >= curve.height[k + 1]);
            }
        }
    }
}

TEST_CASE("A bearing curve needs a height and a step") {
    const std::vector<double> none{std::numeric_limits<double>::quiet_NaN()}, one{1.0};
    CHECK(test::refusal([&] { (void)bearing_curve<double>(none); }) ==
          "heights of a bearing curve = 0: must be at least 1");
    CHECK(test::refusal([&] { (void)bearing_curve<double>(one, 0); }) ==
          "steps of a bearing curve = 0: must be at least 1");
}

}  // namespace bearing_curve_test
