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
            math::GaussianSmoother<double> smooth(size, width);
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

TEST_CASE("Lines that are smoothed together have the sums of one after the other") {
    for (const std::size_t size : {std::size_t{1}, std::size_t{7}, std::size_t{400}}) {
        math::GaussianSmoother<double> smooth(size, 13.0);
        const std::size_t lines = math::GaussianSmoother<double>::lines;
        for (const std::size_t count : {lines, lines / 2 + 1, std::size_t{1}}) {
            std::vector<double> z(size * count);
            for (std::size_t i = 0; i < z.size(); ++i) z[i] = std::fmod(static_cast<double>(i * i) * 0.618, 2.0) - 0.9;
            std::vector<double> rows = z, columns = z;
            smooth.of_lines(rows.data(), 1, size, count);
            smooth.of_lines(columns.data(), count, 1, count);
            for (std::size_t l = 0; l < count; ++l) {
                std::vector<double> row(size), column(size);
                for (std::size_t i = 0; i < size; ++i) row[i] = z[l * size + i], column[i] = z[i * count + l];
                smooth(row);
                smooth(column);
                CAPTURE(size, count, l);
                for (std::size_t i = 0; i < size; ++i) {
                    REQUIRE(std::abs(rows[l * size + i] - row[i]) < 1e-13);
                    REQUIRE(std::abs(columns[i * count + l] - column[i]) < 1e-13);
                }
            }
        }
    }
}

TEST_CASE("No numbers, no width and a wrong count of numbers are refused") {
    CHECK_FALSE(test::refusal([] { math::GaussianSmoother<double>(0, 1.0); }).empty());
    CHECK_FALSE(test::refusal([] { math::GaussianSmoother<double>(5, 0.0); }).empty());
    math::GaussianSmoother<double> smooth(5, 2.0);
    std::vector<double> four(4, 1.0);
    CHECK_FALSE(test::refusal([&] { smooth(four); }).empty());
}

}  // namespace gaussian_smoother_test
