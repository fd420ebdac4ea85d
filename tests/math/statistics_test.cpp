// SPDX-License-Identifier: BSD-3-Clause
// Order against std::stable_sort; quantiles by hand; resamples against the variance of a mean of blocks.
#include <fstiff/math/random.hpp>
#include <fstiff/math/statistics.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace statistics_test {

using namespace fstiff;

TEMPLATE_TEST_CASE("Heights fall, with equal ones in their order", "[math]", float, double) {
    using T = TestType;
    using Limits = std::numeric_limits<T>;
    std::mt19937_64 random(5);
    std::normal_distribution<T> height;
    std::vector<std::pair<T, int>> items;
    const auto add = [&](T z) { items.emplace_back(z, static_cast<int>(items.size())); };
    for (int k = 0; k < 5000; ++k) add(std::ldexp(height(random), k % 60 - 40)), add(std::round(height(random)));
    for (const T z : {T(0), -T(0), Limits::denorm_min(), -Limits::denorm_min(), (Limits::max)(), Limits::lowest(),
                      Limits::infinity(), -Limits::infinity(), T(0), -T(0)})
        add(z);
    auto expected = items;
    std::stable_sort(expected.begin(), expected.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    math::sort_falling<T>(items, [](const auto& item) { return item.first; });
    CHECK(items == expected);
    std::vector<T> none;
    math::sort_falling<T>(none, [](T z) { return z; });
    CHECK(none.empty());
}

TEST_CASE("The quantile of sorted values is linear between neighbours") {
    const std::vector<double> values{1, 2, 4, 8, 16};
    const std::span<const double> sorted(values);
    CHECK(math::sorted_quantile(sorted, 0.0) == 1);
    CHECK(math::sorted_quantile(sorted, 1.0) == 16);
    CHECK(math::sorted_quantile(sorted, 0.8125) == 10);
}

TEST_CASE("A block draw has as many blocks as make the whole, and reaches every one alike") {
    math::BlockDraw draw(10, 3, 1);
    CHECK(draw.blocks() == 4);
    std::vector<int> count(8, 0);
    for (int i = 0; i < 8000; ++i) ++count.at(draw());
    for (const int c : count) CHECK(std::abs(c - 1000) < 4 * std::sqrt(1000 * 7.0 / 8));
}

TEST_CASE("Resampled means have the mean of the whole and the variance of independent blocks") {
    // blocks of one part: the variance of a mean of as many independent draws
    const std::size_t parts = 64, resamples = 20000;
    std::vector<double> sum(parts), weight(parts, 2);
    for (std::size_t i = 0; i < parts; ++i) sum[i] = std::sin(0.7 * static_cast<double>(i)) + 3;
    math::BlockBootstrap<double> bootstrap(parts, 1, resamples, 5);
    const std::vector<double>& means = bootstrap.means([&](std::size_t i) { return std::pair{sum[i], weight[i]}; });
    const double whole = std::accumulate(sum.begin(), sum.end(), 0.0) / parts / 2;
    double mean = 0, square = 0, variance = 0;
    for (const double m : means) mean += m / resamples;
    for (const double m : means) square += (m - mean) * (m - mean) / (resamples - 1);
    for (const double s : sum) variance += (s / 2 - whole) * (s / 2 - whole) / parts / parts;
    CHECK(std::abs(mean - whole) < 4 * std::sqrt(variance / resamples));
    CHECK(std::abs(square / variance - 1) < 4 * std::sqrt(2.0 / resamples));
}

TEST_CASE("A resample that holds nothing has the mean of the whole") {
    math::BlockBootstrap<double> bootstrap(4, 1, 200, 3);
    const std::vector<double>& means = bootstrap.means([](std::size_t i) {
        return i == 0 ? std::pair{6.0, 2.0} : std::pair{0.0, 0.0};
    });
    for (const double m : means) CHECK(m == 3);
}

TEST_CASE("quantiles of Student's t are those of GSL") {
    const auto error = [](const math::NormalQuantile<double>& normal, int degrees) {
        return test::relative_error(math::student_quantile(normal, degrees),
                                    gsl_cdf_tdist_Pinv(normal.probability, static_cast<double>(degrees)));
    };
    for (const auto& normal : {math::normal_95<double>, math::normal_975<double>}) {
        CHECK(test::relative_error(math::student_quantile(normal, 0), gsl_cdf_ugaussian_Pinv(normal.probability)) <
              1e-12);
        for (const int degrees : {1, 2}) CHECK(error(normal, degrees) < 1e-12);
        for (const int degrees : {3, 4}) CHECK(error(normal, degrees) < 1e-2);
        for (const int degrees : {5, 6, 8, 10, 20, 30, 100}) CHECK(error(normal, degrees) < 1e-3);
    }
}

}  // namespace statistics_test
