// SPDX-License-Identifier: BSD-3-Clause
// Truth: tests/data/bem_maps.csv, by another code, on three maps (tests/data/bem_map_*.f32); the wave of Westergaard,
// closed.
#include <fstiff/halfspace/boundary_elements.hpp>
#include <fstiff/synthetic/self_affine.hpp>
#include <fstiff/topography/coarser_map.hpp>
#include <fstiff/topography/height_map.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/half_space_maps.hpp"
#include "support/table.hpp"

#include <cmath>
#include <numbers>
#include <random>

namespace boundary_elements_test {

using namespace fstiff;

namespace {

/// \p cells of one period 1 along x of the amplitude 1e-3, the same all along y.
HeightMap<double> wave(Eigen::Index cells) {
    HeightMap<double> map;
    map.dx = map.dy = 1.0 / static_cast<double>(cells);
    map.heights.resize(4, cells);
    for (Eigen::Index i = 0; i < cells; ++i)
        map.heights.col(i) = 1e-3 * std::cos(2 * std::numbers::pi * (static_cast<double>(i) + 0.5) * map.dx);
    return map;
}

}  // namespace

TEST_CASE("boundary elements of three maps are those of another code") {
    const test::Table table("bem_maps.csv");
    for (std::size_t row = 0; row < table.size(); row += 2) {
        const HeightMap<double> map = test::half_space_map(table.text(row, "map"));
        BoundaryElements<double> solver(map, 1.0, {.edges = Edges::periodic});
        const auto state = solver.at_pressure(table.input(row, "p_over_E"));
        CAPTURE(table.text(row, "map"), table.input(row, "p_star"), state.iterations);
        CHECK(state.converged);
        // both solved to 1e-8 or better
        CHECK(test::relative_error(state.stiffness, table.input(row, "stiffness_times_L_over_E")) < 1e-6);
        CHECK(test::relative_error(state.contact_fraction, table.input(row, "contact_fraction")) < 1e-8);
        CHECK(test::relative_error(state.mean_gap, table.input(row, "mean_gap_over_L")) < 1e-6);
        CHECK(test::relative_error(state.max_pressure, table.input(row, "largest_pressure_over_E")) < 1e-6);
        CHECK(test::relative_error(solver.pressures().mean(), state.pressure) < 1e-12);
    }
}

TEST_CASE("a wave is Westergaard's, the better the finer the grid") {
    // p = p1 sin^2(pi a), p1 = pi E amplitude; held together 1/K = 2/(pi E) ln(1/sin(pi a)), that of collinear cracks
    const double p1 = std::numbers::pi * 1e-3;
    for (const double share : {0.1, 0.5, 0.9}) {
        const double a = std::asin(std::sqrt(share)) / std::numbers::pi;
        const double K = std::numbers::pi / 2 / -std::log(std::sin(std::numbers::pi * a));
        double last = 1;
        for (const Eigen::Index cells : {64, 256, 1024}) {
            BoundaryElements<double> solver(wave(cells), 1.0, {.edges = Edges::periodic});
            const auto state = solver.at_pressure(share * p1);
            const double off = test::relative_error(state.stiffness, K);
            CAPTURE(share, cells, off, state.contact_fraction, 2 * a);
            CHECK(state.converged);
            CHECK(std::abs(state.contact_fraction - 2 * a) <=
                  2.01 / static_cast<double>(cells));  // a point at each edge
            CHECK(off < 6.0 / static_cast<double>(cells) / std::min(1 - share, share));
            last = off;
        }
        CHECK(last < 0.02);
    }
}

TEST_CASE("a map mirrored by the solver is the map mirrored by hand") {
    const HeightMap<double> map = test::half_space_map("skewed");
    HeightMap<double> part, whole;
    part.dx = part.dy = whole.dx = whole.dy = map.dx;
    part.heights = map.heights.block(0, 0, 40, 60);
    whole.heights.resize(80, 120);
    whole.heights << part.heights, part.heights.rowwise().reverse(), part.heights.colwise().reverse(),
        part.heights.reverse();
    BoundaryElements<double> mirrored(part, 1.0), repeated(whole, 1.0, {.edges = Edges::periodic});
    const auto a = mirrored.at_pressure(1e-3), b = repeated.at_pressure(1e-3);
    CHECK(a.contact_fraction == b.contact_fraction);
    CHECK(test::relative_error(a.stiffness, b.stiffness) < 1e-6);
    CHECK(test::relative_error(a.mean_gap, b.mean_gap) < 1e-6);
}

TEST_CASE("the stiffness held together is the slope of the pressure, of elastic contacts") {
    const HeightMap<double> map = test::half_space_map("gaussian");
    BoundaryElements<double> solver(map, 1.0, {.edges = Edges::periodic, .tolerance = 1e-10});
    const double p = 1e-3;
    const auto low = solver.at_pressure(0.99 * p), high = solver.at_pressure(1.01 * p), middle = solver.at_pressure(p);
    const double slope = 0.02 * p / (low.mean_gap - high.mean_gap);
    CHECK(test::relative_error(middle.stiffness, slope) < 5e-3);  // points join the contact one at a time
}

TEST_CASE("the stiffness of hills on a plain that has come into contact is the slope of the pressure, too") {
    // the contact, most of it plain, is lower than the mean then: where the search for K begins
    HeightMap<double> map;
    map.dx = map.dy = 1.0 / 64;
    map.heights = HeightMap<double>::Array::NullaryExpr(64, 64, [](Eigen::Index j, Eigen::Index i) {
        const auto hill = [&](double x, double y) {
            const double r = std::hypot(static_cast<double>(i) - x, static_cast<double>(j) - y);
            return 6e-3 * std::exp(-r * r / 8);
        };
        return hill(20, 24) + hill(50, 44) + 2e-4 * std::cos(0.1 * std::numbers::pi * static_cast<double>(i + 2 * j));
    });
    BoundaryElements<double> solver(map, 1.0, {.edges = Edges::periodic});
    for (const double p : {2e-4, 1e-3, 4e-3, 6e-3, 1e-2}) {
        const auto low = solver.at_pressure(p * 0.99), state = solver.at_pressure(p),
                   high = solver.at_pressure(p * 1.01);
        CAPTURE(p, state.contact_fraction);
        CHECK(test::relative_error(state.stiffness, 0.02 * p / (low.mean_gap - high.mean_gap)) < 0.05);
    }
}

TEST_CASE("pressures cut at the hardness: area p/H in the limit, and a stiffer contact") {
    const HeightMap<double> map = test::half_space_map("gaussian");  // gradient 0.1
    BoundaryElements<double> elastic(map, 1.0, {.edges = Edges::periodic});
    const double H = 0.0015;  // H/(E g) = 0.015
    BoundaryElements<double> plastic(map, 1.0, {.edges = Edges::periodic, .hardness = H});
    const auto hard = elastic.at_pressure(0.03 * H), soft = plastic.at_pressure(0.03 * H);
    CHECK(soft.converged);
    CHECK(soft.max_pressure <= H * (1 + 1e-12));
    // theory: 1.01 to 1.02 of p/H at this hardness; a point is 1.5e-5 of the area
    CHECK(soft.contact_fraction / 0.03 > 1.0);
    CHECK(soft.contact_fraction / 0.03 < 1.03);
    CHECK(soft.stiffness / hard.stiffness > 10);
    CHECK(hard.loading_stiffness == hard.stiffness);
    CHECK(soft.below_hardness < soft.contact_fraction * static_cast<double>(map.size()) / 4);
    CHECK(soft.loading_stiffness < soft.stiffness / 4);
    CHECK(test::refusal([&] { (void)plastic.at_pressure(H); }).find("less than the hardness") != std::string::npos);
}

TEST_CASE("a few points at the hardness carry the load that is asked for") {
    // 10 to 100 points in contact: the search ends in a step or two, where the next direction is rounding alone
    for (const unsigned seed : {1u, 2u, 3u, 4u, 5u}) {
        const auto map =
            self_affine_map<double>({.hurst = 0.7, .rms = 1, .longest_wavelength = 20, .seed = seed}, 32, 32, 1, 1);
        for (const double hardness : {0.003, 0.01, 0.03}) {
            BoundaryElements<double> solver(map, 1.0, {.hardness = hardness});
            for (const double share : {0.002, 0.01, 0.02, 0.1}) {
                const auto state = solver.at_pressure(share * hardness);
                CAPTURE(seed, hardness, share);
                CHECK(state.converged);
                CHECK(state.contact_fraction >= share * (1 - 1e-12));
                CHECK(test::relative_error(solver.pressures().mean(), share * hardness) < 1e-12);
            }
        }
    }
}

TEST_CASE("previous solutions do not matter to the last digit") {
    const HeightMap<double> map = detail::coarsened(test::half_space_map("gaussian"), 64);
    for (const double hardness : {0.0, 0.003}) {
        BoundaryElements<double> twice(map, 1.0, {.hardness = hardness}), once(map, 1.0, {.hardness = hardness});
        (void)twice.at_pressure(2e-3);
        (void)twice.on_coarser_grid();
        const auto after = twice.at_pressure(1e-4), alone = once.at_pressure(1e-4);
        CHECK(after.stiffness == alone.stiffness);
        CHECK(after.mean_gap == alone.mean_gap);
        CHECK((twice.pressures() == once.pressures()).all());
    }
}

TEST_CASE("what is not asked for is not solved, and changes nothing else") {
    const HeightMap<double> map = detail::coarsened(test::half_space_map("gaussian"), 64);
    for (const double pressure : {1e-3, 1e-2}) {  // with few points below H, and with many
        BoundaryElements<double> all(map, 1.0, {.hardness = 0.02}),
            unloading(map, 1.0, {.hardness = 0.02, .loading = false});
        const auto a = all.at_pressure(pressure), b = unloading.at_pressure(pressure);
        CAPTURE(pressure, a.below_hardness);
        CHECK(a.loading_stiffness < 0.9 * a.stiffness);
        CHECK(b.loading_stiffness == a.stiffness);
        CHECK(b.stiffness == a.stiffness);
        CHECK(b.mean_gap == a.mean_gap);
        CHECK(b.below_hardness == a.below_hardness);
        CHECK((all.pressures() == unloading.pressures()).all());
    }
}

TEST_CASE("the loading stiffness of few points below the hardness is the slope of the gap, from two contacts alone") {
    const HeightMap<double> map = detail::coarsened(test::half_space_map("gaussian"), 64);
    const double p = 1e-3;
    BoundaryElements<double> one(map, 1.0, {.hardness = 0.02}), below = one, above = one,
                                                                alone(map, 1.0, {.hardness = 0.02, .loading = false});
    const auto state = one.at_pressure(p);
    (void)alone.at_pressure(p);
    REQUIRE(state.below_hardness < 200);
    const double points = state.contact_fraction * static_cast<double>(map.size());
    const double apart = std::exp(std::clamp(40 / points, 0.03, 0.5));
    const double fall = below.at_pressure(p / apart).mean_gap - above.at_pressure(p * apart).mean_gap;
    CHECK(test::relative_error(state.loading_stiffness, 2 * p * std::log(apart) / fall) < 1e-12);
    CHECK(one.on_coarser_grid().stiffness == alone.on_coarser_grid().stiffness);
}

TEST_CASE("the loading stiffness of few points is that of a grid of sixteen times as many", "[more]") {
    double squares = 0;  // rms 0.08; 0.15 for the slope over 3 % of p to either side
    int compared = 0;
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
        const HeightMap<double> fine = self_affine_map<double>(
            {.hurst = 0.8, .rms = 0.5, .longest_wavelength = 64, .shortest_wavelength = 4, .seed = seed}, 256, 256, 0.5,
            0.5);
        HeightMap<double> coarse{
            .heights = fine.heights(Eigen::seq(0, 255, 4), Eigen::seq(0, 255, 4)), .dx = 2, .dy = 2};
        BoundaryElements<double> many(fine, 1.0, {.hardness = 0.02}), few(coarse, 1.0, {.hardness = 0.02});
        for (double p = 1e-4; p < 2e-3; p *= 1.5) {
            const auto a = many.at_pressure(p), b = few.at_pressure(p);
            const double departure = std::log(b.loading_stiffness / a.loading_stiffness);
            squares += departure * departure, ++compared;
        }
    }
    CHECK(squares / compared < 0.1 * 0.1);
}

TEST_CASE("the grid half as fine is that map solved by itself") {
    const HeightMap<double> map = test::half_space_map("skewed");
    BoundaryElements<double> fine(map, 1.0), half(detail::coarsened(map, 128), 1.0);
    CHECK(test::refusal([&] { (void)fine.on_coarser_grid(); }).find("pressures solved") != std::string::npos);
    (void)fine.at_pressure(1e-3);
    const auto a = fine.on_coarser_grid(), b = half.at_pressure(1e-3);
    CHECK(a.converged);
    CHECK(a.contact_fraction == b.contact_fraction);
    CHECK(test::relative_error(a.stiffness, b.stiffness) < 1e-7);
    CHECK(test::relative_error(a.mean_gap, b.mean_gap) < 1e-7);
    HeightMap<double> zigzag;
    zigzag.dx = zigzag.dy = 1;
    zigzag.heights.resize(16, 16);
    for (int j = 0; j < 16; ++j)
        for (int i = 0; i < 16; ++i) zigzag.heights(j, i) = (i + j) % 2;
    BoundaryElements<double> cancels(zigzag, 1.0);
    CHECK(cancels.at_pressure(1e-3).contact_fraction == 0.5);
    CHECK(test::refusal([&] { (void)cancels.on_coarser_grid(); }).find("coarser grids") != std::string::npos);
}

TEST_CASE("pressures and gaps of maps of every roughness are those of a contact") {
    // p >= 0, g >= 0, p g = 0 at every point: one solution has them
    std::mt19937 random(1);
    std::normal_distribution<double> normal;
    for (int k = 0; k < 60; ++k) {
        const int rows = 3 + static_cast<int>(random() % 40), columns = 3 + static_cast<int>(random() % 40);
        const Edges edges = k % 2 == 0 ? Edges::periodic : Edges::mirrored;
        HeightMap<double> map;
        map.dx = map.dy = 1.0 / columns;
        map.heights = HeightMap<double>::Array::NullaryExpr(rows, columns, [&] {
            const double z = normal(random);  // white, terraces, single peaks
            return k % 3 == 0 ? z : k % 3 == 1 ? std::floor(z) : z * z * z * z;
        });
        const double p = std::pow(10.0, -4 + k % 6);
        BoundaryElements<double> solver(map, 1.0, {.edges = edges, .tolerance = 1e-10});
        const auto state = solver.at_pressure(p);
        const detail::GridField<double> pressures = solver.pressures();
        detail::GridField<double> u = pressures;
        detail::SurfaceCompliance<double>(rows, columns, map.dx, map.dy, edges).deflect(u);
        const detail::GridField<double> gap = u - (map.heights - map.heights.mean()) + state.mean_gap;
        const double size = u.abs().maxCoeff() + map.heights.abs().maxCoeff();
        CAPTURE(k, rows, columns, p, state.iterations);
        CHECK(state.converged);
        CHECK(pressures.minCoeff() >= 0);
        CHECK(test::relative_error(pressures.mean(), p) < 1e-12);
        CHECK(gap.minCoeff() > -1e-8 * size);
        CHECK((pressures > 0).select(gap.abs(), 0.0).maxCoeff() < 1e-8 * size);
    }
}

TEST_CASE("maps that boundary elements do not take") {
    HeightMap<double> map = wave(64);
    map.heights(1, 7) = std::nan("");
    CHECK(test::refusal([&] { BoundaryElements<double>(map, 1.0); }).find("1 missing points") != std::string::npos);
    CHECK(test::refusal([&] { BoundaryElements<double>(wave(64), 0.0); }).find("effective_modulus") == 0);
    BoundaryElements<double> solver(wave(64), 1.0);
    for (const double p : {0.0, -1.0, std::nan("")})
        CHECK(test::refusal([&] { (void)solver.at_pressure(p); }).find("pressure") == 0);
    CHECK(std::isinf(solver.at_pressure(1.0).stiffness));  // all in contact
    CHECK(std::isinf(solver.at_pressure(1e300).stiffness));
    BoundaryElements<double> hard(wave(64), 1e11);  // p/E is 0
    const auto none = hard.at_pressure(5e-324);
    CHECK_FALSE(none.converged);
    CHECK(std::isnan(none.stiffness));
}

}  // namespace boundary_elements_test
