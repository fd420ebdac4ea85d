// SPDX-License-Identifier: BSD-3-Clause
// Padding and a gauge at its stops: warnings of measured files. Truth: how the heights were made.
#include "support/library.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace equal_heights_test {

namespace {

std::vector<double> rough(std::size_t points) {
    std::mt19937 engine(3);
    std::normal_distribution<double> normal(0, 1);
    std::vector<double> z(points);
    double last = 0;
    for (double& height : z) height = last = 0.9 * last + 0.4 * normal(engine);
    return z;
}
/// A profile of \p z [um] with \p digits decimals.
std::string profile(const std::vector<double>& z, int digits = 4) {
    std::string text = "x [um];z [um]\n";
    char line[64];
    for (std::size_t i = 0; i < z.size(); ++i) {
        std::snprintf(line, sizeof line, "%.1f;%.*f\n", 0.5 * static_cast<double>(i), digits, z[i]);
        text += line;
    }
    return text;
}
std::string map(const std::vector<double>& z, std::size_t columns) {
    std::string text = "# Width: " + std::to_string(columns) + " um\n# Height: " + std::to_string(z.size() / columns) +
                       " um\n# Value units: um\n";
    char cell[32];
    for (std::size_t i = 0; i < z.size(); ++i) {
        std::snprintf(cell, sizeof cell, "%.4f%c", z[i], i % columns + 1 == columns ? '\n' : '\t');
        text += cell;
    }
    return text;
}
/// The warnings of \p text that name padding or a gauge.
std::string hints(const std::string& text, const std::string& options = "") {
    std::string found;
    const auto document = test::measured(options, text);
    for (const auto& warning : document["warnings"])
        if (const std::string line = warning; test::contains(line, "padding") || test::contains(line, "stops"))
            found += line + "\n";
    return found;
}

}  // namespace

TEST_CASE("Equal heights at an end of a file are reported as padding, and --crop removes them") {
    auto z = rough(1200);
    CHECK(hints(profile(z)).empty());
    std::fill(z.end() - 200, z.end(), 0.);
    CHECK(test::contains(hints(profile(z)), "the last 200 of 1200 heights are equal, 0 "));
    CHECK(test::contains(hints(profile(z)), "--crop removes them"));
    CHECK(hints(profile(z), "--crop '0,499 um'").empty());
    CHECK(test::contains(hints(profile(z, 2)), "the last 20"));  // heights of coarse steps have short runs
    std::fill(z.begin(), z.begin() + 100, -1.5);
    CHECK(test::contains(hints(profile(z)), "the first 100 of 1200 heights are equal, -1.5 "));
    auto rows = rough(64 * 48), columns = rows;
    CHECK(hints(map(rows, 64)).empty());
    std::fill(rows.end() - 5 * 64, rows.end(), 0.);
    CHECK(test::contains(hints(map(rows, 64)), "the last 320 of 3072 heights, row by row, are equal"));
    for (std::size_t i = 0; i < columns.size(); ++i)
        if (i % 64 < 3) columns[i] = 0;
    CHECK(test::contains(hints(map(columns, 64)), "the first 144 of 3072 heights, column by column, are equal"));
}

TEST_CASE("A third of the heights at both ends of their range is reported as a gauge at its stops") {
    auto z = rough(1200);
    for (double& height : z) height = std::clamp(height, -0.9, 0.9);
    CHECK(test::contains(hints(profile(z)), "the gauge was likely at its stops"));
    CHECK(test::contains(hints(profile(z)), "% of the heights are at the lowest, -0.9 "));
    auto heights = rough(64 * 48);
    for (double& height : heights) height = std::clamp(height, -0.9, 0.9);
    CHECK(test::contains(hints(map(heights, 64)), "the gauge was likely at its stops"));
}

TEST_CASE("Plateaus, two levels, steps and heights of coarse steps are surfaces") {
    auto plateau = rough(1200), two = plateau, groove = plateau;
    for (double& height : plateau) height = std::min(height, 0.3);
    for (double& height : two) height = height > 0 ? 1 : 0;
    for (std::size_t i = 0; i < groove.size(); ++i) groove[i] = i / 150 % 2 ? -1 : 0;
    std::vector<double> wave(1200), grating(1200);
    for (std::size_t i = 0; i < wave.size(); ++i) {
        wave[i] = std::sin(0.02 * static_cast<double>(i));
        grating[i] = std::clamp(3 * wave[i], -1., 1.);
    }
    for (const auto& z : {plateau, two, groove, grating}) CHECK(hints(profile(z)).empty());
    for (const int digits : {0, 1, 2}) {
        CHECK(hints(profile(rough(1200), digits)).empty());
        CHECK(hints(profile(wave, digits)).empty());
        CHECK(hints(profile(plateau, digits)).empty());
    }
    auto pits = rough(64 * 48);
    for (double& height : pits) height = height > 1 ? -1 : 0;
    CHECK(hints(map(pits, 64)).empty());
    for (std::size_t i = 0; i < pits.size(); ++i)
        if (i < 4 * 64 || i % 64 < 4) pits[i] = 0;  // a margin of the plateau
    CHECK(hints(map(pits, 64)).empty());
}

}  // namespace equal_heights_test
