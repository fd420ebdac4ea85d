// SPDX-License-Identifier: BSD-3-Clause
// Truth: the same surfaces on a grid twice as fine.
#include <fstiff/halfspace/solve_half_space.hpp>
#include <fstiff/synthetic/self_affine.hpp>

#include "support/catch.hpp"

#include <cmath>
#include <vector>

namespace truth_test {

using namespace fstiff;

TEST_CASE("the change from one grid to the next covers the change to the one after", "[long]") {
    int covered = 0, all = 0;
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
        SelfAffineOptions<double> of;
        of.hurst = 0.8;
        of.rms = 1e-3;
        of.longest_wavelength = 0.25;
        of.shortest_wavelength = 1.0 / 16;
        of.seed = seed;
        HeightMap<double> map;
        map.dx = map.dy = 1.0 / 512;
        map = self_affine_map(of, 512, 512, map.dx, map.dy);
        const std::vector<double> pressures{1e-5, 3e-5, 1e-4, 3e-4, 1e-3};
        const auto coarse = solve_half_space(map, 1.0, pressures, {.points = 128, .edges = Edges::periodic});
        const auto fine =
            solve_half_space(map, 1.0, pressures, {.points = 512, .edges = Edges::periodic, .grid_error = false});
        for (std::size_t i = 0; i < pressures.size(); ++i) {
            ++all;
            covered += std::abs(fine[i].state.stiffness - coarse[i].state.stiffness) <= coarse[i].stiffness_error;
            CHECK(fine[i].state.converged);
            CHECK(std::abs(fine[i].state.stiffness - coarse[i].state.stiffness) < 0.2 * fine[i].state.stiffness);
        }
    }
    CAPTURE(covered, all);
    CHECK(covered >= all * 3 / 4);
}

TEST_CASE("K of a map whose points all touch is infinite on both grids, without an error that is not a number") {
    SelfAffineOptions<double> of;
    of.hurst = 0.8;
    of.rms = 1e-3;
    const HeightMap<double> map = self_affine_map(of, 32, 32, 1.0 / 32, 1.0 / 32);
    const auto points =
        solve_half_space(map, 1.0, std::vector<double>{1e-4, 1.0}, {.points = 32, .edges = Edges::periodic});
    CHECK(std::isfinite(points[0].state.stiffness));
    CHECK(std::isfinite(points[0].stiffness_error));
    CHECK(std::isinf(points[1].state.stiffness));
    CHECK(points[1].state.contact_fraction == 1);
    CHECK(points[1].stiffness_error == 0);
}

}  // namespace truth_test
