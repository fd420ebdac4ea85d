// SPDX-License-Identifier: BSD-3-Clause
// Energy that a contact of yielded peaks loses in a tangential cycle, from its unloading in boundary elements.
#include <fstiff/halfspace/boundary_elements.hpp>
#include <fstiff/tabulated/tangential_law.hpp>

#include "support/catch.hpp"
#include "support/half_space_maps.hpp"

#include <cmath>
#include <numbers>
#include <vector>

namespace unloading_test {

using namespace fstiff;

namespace {

/// \p map with the heights that pressing it to \p pressure at the hardness \p hardness leaves, E = 1.
HeightMap<double> flattened(const HeightMap<double>& map, double hardness, double pressure) {
    BoundaryElements<double> solver(map, 1.0, {.edges = Edges::periodic, .hardness = hardness});
    REQUIRE(solver.at_pressure(pressure).converged);
    const auto p = solver.pressures();
    detail::GridField<double> deflected = p.transpose();
    detail::SurfaceCompliance<double>(map.rows(), map.columns(), map.dx, map.dy, Edges::periodic).deflect(deflected);
    const auto u = deflected.transpose();
    double separation = 0;
    int elastic = 0;
    for (Eigen::Index j = 0; j < map.rows(); ++j)
        for (Eigen::Index i = 0; i < map.columns(); ++i)
            if (p(j, i) > 0 && p(j, i) < hardness * (1 - 1e-6)) separation += map.heights(j, i) - u(j, i), ++elastic;
    separation /= elastic;  // where nothing flows the faces touch
    HeightMap<double> flat = map;
    for (Eigen::Index j = 0; j < map.rows(); ++j)
        for (Eigen::Index i = 0; i < map.columns(); ++i) {
            const double touching = u(j, i) + separation;
            flat.heights(j, i) = p(j, i) > 0 ? touching : std::min(map.heights(j, i), touching);
        }
    return flat;
}

}  // namespace

TEST_CASE("flowed peaks lose more than equal spots under the hardness, and less than elastic ones") {
    HeightMap<double> map;
    const HeightMap<double> fine = test::half_space_map("gaussian");
    map.dx = map.dy = 2 * fine.dx;
    map.heights = fine.heights(Eigen::seq(0, 255, 2), Eigen::seq(0, 255, 2));
    for (const auto& [hardness, pressure] : {std::pair(0.005, 1e-4), {0.01, 5e-4}, {0.03, 1e-3}}) {
        CAPTURE(hardness, pressure);
        BoundaryElements<double> solver(flattened(map, hardness, pressure), 1.0, {.edges = Edges::periodic});
        const auto loaded = solver.at_pressure(pressure);
        std::vector<double> x{0}, load{1};  // the unloading, x in p/K
        for (double share = 0.95; share > 0.03; share *= share > 0.3 ? 0.93 : 0.7) {
            const auto state = solver.at_pressure(share * pressure);
            x.push_back((state.mean_gap - loaded.mean_gap) * loaded.stiffness / pressure);
            load.push_back(share);
        }
        for (const double slip : {0.3, 0.6, 1.0}) {
            double work = 0, at_slip = 1;
            for (std::size_t i = 1; i < x.size() && x[i - 1] < slip; ++i) {
                const double end = std::min(x[i], slip);
                at_slip = load[i - 1] + (load[i] - load[i - 1]) * (end - x[i - 1]) / (x[i] - x[i - 1]);
                work += (load[i - 1] + at_slip) / 2 * (end - x[i - 1]);
            }
            const double truth = 4 / std::numbers::pi * ((1 + at_slip) * slip - 2 * work) / ((1 - at_slip) * slip);
            CAPTURE(slip, truth);
            const double flowed = detail::loss_factor(detail::FlowedUnloading<double>{}, slip);
            const double elastic = detail::loss_factor(detail::PowerUnloading<double>{1}, slip);
            CHECK(truth > flowed);
            CHECK(truth < elastic);
            CHECK(std::abs(std::log(truth / std::sqrt(flowed * elastic))) < std::log(2));
        }
    }
}

}  // namespace unloading_test
