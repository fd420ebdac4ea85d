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

TEST_CASE("The only number without decimals is suspected where instruments use it and it repeats", "[missing]") {
    const auto lone = [](const std::vector<std::pair<const char*, double>>& cells) {
        LoneWhole whole;
        std::vector<double> heights;
        for (const auto& [cell, value] : cells) whole.add(cell, value), heights.push_back(value);
        const auto found = suspected_missing(heights.data(), heights.size(), whole);
        return found ? std::optional(found->value) : std::nullopt;
    };
    CHECK(lone({{"-12000.5", -12000.5}, {"-9999", -9999}, {"13000.0", 13000}, {"-9999", -9999}}) == -9999);
    CHECK(lone({{"-12000,5", -12000.5}, {"32767", 32767}, {"45000,0", 45000}, {"32767", 32767}}) == 32767);
    CHECK(lone({{"-12000.5", -12000.5}, {"-9999", -9999}, {"13000.0", 13000}}) == std::nullopt);  // once
    CHECK(lone({{"-12000.5", -12000.5}, {"-9999", -9999}, {"13000", 13000}, {"-9999", -9999}}) == std::nullopt);
    CHECK(lone({{"-12000", -12000}, {"-9999", -9999}, {"13000", 13000}, {"-9999", -9999}}) == std::nullopt);
    CHECK(lone({{"-0.5", -0.5}, {"0", 0}, {"0.7", 0.7}, {"0", 0}}) == std::nullopt);  // as %g prints 0
    for (const bool zeros : {true, false}) {                                          // at the end, or left out
        std::vector<std::pair<std::string, double>> cells{{"0", 0}, {"0", 0}};
        for (int i = -60; i < 60; ++i) {
            const double value = i == 0 ? 0.5 : i / 8.0;
            const std::string cell = std::to_string(value).substr(0, i < 0 ? 6 : 5);
            cells.emplace_back(zeros ? cell : cell.substr(0, cell.find_last_not_of('0') + 1), value);
        }
        LoneWhole whole;
        std::vector<double> heights;
        for (const auto& [cell, value] : cells) whole.add(cell, value), heights.push_back(value);
        const auto found = suspected_missing(heights.data(), heights.size(), whole);
        CHECK(found.has_value() == zeros);
    }
    LoneWhole both, other;
    both.add("-9999", -9999), other.add("1.5", 1.5);
    both.add(other);
    CHECK(both.value() == -9999);
    other.add("7", 7), both.add(other);
    CHECK(std::isnan(both.value()));
}

}  // namespace missing_values_test
