// SPDX-License-Identifier: BSD-3-Clause
// The theorem of tabulated/tangential_law on a rough map, point by point: mu times a difference of two normal states.
#include <fstiff/halfspace/boundary_elements.hpp>

#include "support/catch.hpp"
#include "support/half_space_maps.hpp"

#include <cmath>

namespace partial_slip_test {

using namespace fstiff;

TEST_CASE("mu times the difference of two normal states sticks where the lighter one touches and slips elsewhere") {
    const HeightMap<double> map = test::half_space_map("gaussian");
    BoundaryElements<double> solver(map, 1.0, {.edges = Edges::periodic, .tolerance = 1e-10});
    const double pressure = 2e-3;
    const auto loaded = solver.at_pressure(pressure);
    const auto p = solver.pressures();
    for (const double share : {0.9, 0.5, 0.1}) {
        CAPTURE(share);
        const auto lighter = solver.at_pressure(share * pressure);
        const auto stuck = solver.pressures();
        // over mu: the traction, and the displacement under it over K/K_t, both bodies of one tangential compliance
        detail::GridField<double> moved = (p - stuck).transpose();
        detail::SurfaceCompliance<double>(map.rows(), map.columns(), map.dx, map.dy, Edges::periodic).deflect(moved);
        const double slip = lighter.mean_gap - loaded.mean_gap;  // of the bodies; the mean of `moved` is 0
        const double scale = moved.abs().maxCoeff();
        double uneven = 0, forward = 0, above = 0;
        int slipped = 0;
        for (Eigen::Index j = 0; j < map.rows(); ++j)
            for (Eigen::Index i = 0; i < map.columns(); ++i) {
                above = std::max(above, std::max(-stuck(j, i), stuck(j, i) - p(j, i)));  // 0 <= q <= mu p
                const double behind = moved(i, j) - slip;  // of the body's far end: 0 where it sticks
                if (stuck(j, i) > 0)
                    uneven = std::max(uneven, std::abs(behind));
                else if (p(j, i) > 0)
                    forward = std::max(forward, behind), ++slipped;
            }
        CHECK(uneven < 1e-6 * scale);
        CHECK(forward < 1e-6 * scale);  // slipping points move less
        CHECK(above < 1e-6 * p.maxCoeff());
        CHECK(slipped > 50);
    }
}

}  // namespace partial_slip_test
