// SPDX-License-Identifier: BSD-3-Clause
// Numbers that are suspected to denote missing points: small lists, judged by eye.
#include "io/missing_values.hpp"

#include "support/catch.hpp"

namespace missing_values_test {

using namespace fstiff::io::detail;

namespace {

std::optional<double> suspect(const std::vector<double>& heights) {
    const auto found = suspected_missing(heights.data(), heights.size());
    return found ? std::optional(found->value) : std::nullopt;
}
constexpr double missing = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST_CASE("A number far outside the rest that repeats is suspected", "[missing]") {
    CHECK(suspect({1, 2, 3, -500, 2, -500}) == -500);
    CHECK(suspect({1, 2, 3, 500, missing, 500}) == 500);
    CHECK(suspect({1, 2, 3, -500, 2, -501}) == std::nullopt);  // differ
    CHECK(suspect({1, 2, 3, -500, 2, 2}) == std::nullopt);     // a spike
    CHECK(suspect({1, 2, 3, 20, 20}) == std::nullopt);         // no further than 10 ranges
    CHECK(suspect({-500, -500, 1, 2, 3, 700, 700}) == -500);   // one at either end
}

TEST_CASE("A customary number needs less", "[missing]") {
    CHECK(suspect({-2000, 2000, 1500, -9999, -9999}) == -9999);
    CHECK(suspect({1, 2, 3, -9999}) == -9999);  // once
    CHECK(suspect({5, 5, 5, -32768, -32768}) == -32768);
    CHECK(suspect({1e20, 1, 2, 1e20}) == 1e20);
    CHECK(suspect({-9998, -5000, 0, -9999, -9999}) == std::nullopt);  // adjoins the rest
}

TEST_CASE("Plateaus, steps and constants are heights", "[missing]") {
    CHECK(suspect({1, 2, 3, 3, 3, 3, 2}) == std::nullopt);
    CHECK(suspect({0, 0, 1, 1, 0, 1}) == std::nullopt);
    CHECK(suspect({7, 7, 7}) == std::nullopt);
    CHECK(suspect({missing, missing}) == std::nullopt);
    CHECK(suspect({}) == std::nullopt);
}

}  // namespace missing_values_test
