// SPDX-License-Identifier: BSD-3-Clause
// The comparison of the models with boundary elements in docs/validation.md. Its numbers are those of
// bench/validation.csv, which another test compares with the output of bench/validation.cpp. Here they are compared
// with other computations.
#include <fstiff/asperity/material.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/half_space.hpp"
#include "support/paper.hpp"

#include <limits>
#include <numbers>

namespace validation_test {

using namespace fstiff;

namespace {

struct Range {
    double least = std::numeric_limits<double>::infinity(), largest = 0;
};

/// Of the ratios of \p law over all families, for \p low <= p* <= \p high.
Range range_of(const std::string& law, double low, double high) {
    static const auto rows = test::half_space_ratios();
    Range range;
    for (const auto& row : rows)
        if (row.law == law && row.dimensionless_pressure > 0.999 * low && row.dimensionless_pressure < 1.001 * high)
            range = {std::min(range.least, row.ratio), std::max(range.largest, row.ratio)};
    return range;
}

}  // namespace

TEST_CASE("the models over boundary elements are those of an independent computation") {
    // Made by other code, over seven families. The table holds five of them, and its ranges lie within those here. They
    // are printed to two digits, and K of the table is right to 2 % (grids of 512 and 1024 points a side).
    const struct {
        const char* law;
        double low, high, least, largest;
    } rows[] = {{"hertz", 0, 0.004, 0.87, 1.00},     {"hertz", 0.03, 0.03, 0.62, 0.89},
                {"hertz", 0.25, 0.25, 0.18, 0.31},   {"fractal", 0, 0.004, 1.30, 2.69},
                {"fractal", 0.03, 0.03, 0.93, 2.30}, {"fractal", 0.25, 0.25, 0.27, 0.67},
                {"linear", 0, 0.002, 0.62, 0.79},    {"linear", 0.01, 0.12, 0.86, 1.01}};
    for (const auto& row : rows) {
        const Range found = range_of(row.law, row.low, row.high);
        INFO(row.law << " from p* = " << row.low << " to " << row.high << ": " << found.least << " to "
                     << found.largest);
        CHECK(found.least > 0.98 * row.least - 0.005);
        CHECK(found.largest < 1.02 * row.largest + 0.005);
        // and they reach the ends, but for the linear law, whose least is that of a family not in the table
        if (std::string(row.law) != "linear") CHECK(found.least < 1.02 * row.least + 0.005);
        CHECK(found.largest > 0.98 * row.largest - 0.005);
    }
}

TEST_CASE("the stiffness of boundary elements is the slope of their pressure") {
    // p is convex in the gap, so that a chord lies between the stiffnesses at its ends; K of the table is a difference
    // of second order, right to 2 % or so
    const test::Table truth("bem.csv");
    std::size_t chords = 0;
    for (std::size_t i = 1; i < truth.size(); ++i) {
        if (truth.text(i, "family") != truth.text(i - 1, "family") ||
            truth.text(i, "seed") != truth.text(i - 1, "seed"))
            continue;
        const double chord = (truth.input(i, "p_over_E") - truth.input(i - 1, "p_over_E")) /
                             (truth.input(i - 1, "mean_gap_over_L") - truth.input(i, "mean_gap_over_L"));
        INFO("row " << i << ": " << truth.text(i, "family"));
        CHECK(chord > 0.98 * truth.input(i - 1, "stiffness_times_L_over_E"));
        CHECK(chord < 1.02 * truth.input(i, "stiffness_times_L_over_E"));
        ++chords;
    }
    CHECK(chords == 105);
}

TEST_CASE("every elastic stiffness exceeds the chord from the first touch, p/(R_p - gap)") {
    // p(d) is convex and vanishes at d = R_p where heights are bounded; where the model's Gaussian heights go beyond
    // R_p, its p there is more than nothing and the chord is counted from that
    const double modulus = effective_modulus<double>({205e9, 0.3}, {205e9, 0.3});
    std::size_t compared = 0;
    for (const test::PaperSurface& paper : test::paper_surfaces)
        for (const PeakDistribution<double>& peaks : {PeakDistribution<double>(0, std::numbers::pi / 4),
                                                      PeakDistribution<double>::exponential(std::numbers::pi / 3)}) {
            const Roughness<double> surface = paper.roughness();
            const double dimension = paper.fractal_dimension;
            const auto check = [&](const auto& contact) {
                for (const double pressure : {1e5, 1e6, 1e7, 1e8}) {
                    const auto state = contact.at_pressure(pressure);
                    const double room = surface.max_peak_height - state.separation.value;
                    if (!(room > 0)) continue;
                    const double beyond = contact.at_separation(surface.max_peak_height).pressure.value;
                    CHECK(state.stiffness.value >= (pressure - beyond) / room);
                    if (beyond < 1e-3 * pressure) CHECK(state.stiffness.value >= pressure / room);
                    ++compared;
                }
            };
            check(RoughContact(surface, peaks, HertzLaw<double>{}, modulus));
            check(RoughContact(surface, peaks, FractalLaw<double>(dimension), modulus));
            check(RoughContact(surface, peaks, FractalConsistentLaw<double>(dimension), modulus));
            check(RoughContact(surface, peaks, HertzLaw<double>{}, modulus,
                               {.interaction = {InteractionReading::effective_separation, 45e-6}}));
            check(GreenwoodWilliamson<double>(surface, modulus));
        }
    CHECK(compared > 100);
}

}  // namespace validation_test
