// SPDX-License-Identifier: BSD-3-Clause
// Energy that a contact of yielded peaks loses in a tangential cycle, from its unloading in boundary elements.
#include <fstiff/halfspace/flattened_map.hpp>
#include <fstiff/synthetic/self_affine.hpp>
#include <fstiff/tabulated/tangential_law.hpp>
#include <fstiff/topography/map_spectrum.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/half_space_maps.hpp"
#include "support/table.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace unloading_test {

using namespace fstiff;

TEST_CASE("flowed peaks lose more than equal spots under the hardness, and less than elastic ones") {
    HeightMap<double> map;
    const HeightMap<double> fine = test::half_space_map("gaussian");
    map.dx = map.dy = 2 * fine.dx;
    map.heights = fine.heights(Eigen::seq(0, 255, 2), Eigen::seq(0, 255, 2));
    for (const auto& [hardness, pressure] : {std::pair(0.005, 1e-4), {0.01, 5e-4}, {0.03, 1e-3}}) {
        CAPTURE(hardness, pressure);
        const BoundaryElementOptions<double> yields{.edges = Edges::periodic, .hardness = hardness};
        BoundaryElements<double> solver(detail::flattened(map, 1.0, pressure, yields), 1.0, {.edges = Edges::periodic});
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

TEST_CASE(
    "a flattened map has K, area and gap of its unloading where it was pressed to, and more K below than at first") {
    const HeightMap<double> map = detail::coarsened(test::half_space_map("skewed"), 128);
    for (const Edges edges : {Edges::periodic, Edges::mirrored}) {
        const BoundaryElementOptions<double> yields{.edges = edges, .hardness = 0.01};
        BoundaryElements<double> first(map, 1.0, yields);
        BoundaryElements<double> after(detail::flattened(map, 1.0, 5e-4, yields), 1.0, {.edges = edges});
        const auto loaded = first.at_pressure(5e-4), again = after.at_pressure(5e-4 * (1 - 1e-9));
        CHECK(test::relative_error(again.stiffness, loaded.stiffness) < 1e-3);  // points that only touch come and go
        CHECK(test::relative_error(again.contact_fraction, loaded.contact_fraction) < 0.01);
        CHECK(again.max_pressure < 0.0101);
        for (const double share : {0.5, 0.1, 0.02}) {
            const double K = after.at_pressure(share * 5e-4).stiffness;
            CHECK(K > first.at_pressure(share * 5e-4).stiffness);
            CHECK(K < loaded.stiffness);
        }
    }
}

TEST_CASE("flattened maps unload as those of another program with the same spectrum") {
    const test::Table table("earlier_load.csv");
    for (const double h : {0.05, 0.5}) {
        std::vector<double> mean(3);
        const std::vector<double> shares{0.5, 0.3, 0.1};
        for (const std::uint64_t seed : {1, 2, 3}) {
            const HeightMap<double> map = self_affine_map<double>({.hurst = 0.8,
                                                                   .rms = 1e-3,
                                                                   .longest_wavelength = 1.0 / 8,
                                                                   .shortest_wavelength = 1.0 / 32,
                                                                   .seed = seed},
                                                                  256, 256, 1.0 / 256, 1.0 / 256);
            const double hardness = h * map_spectrum(map, Edges::periodic).rms_gradient(), greatest = 0.3 * hardness;
            const BoundaryElementOptions<double> yields{
                .edges = Edges::periodic, .hardness = hardness, .loading = false};
            const double K = BoundaryElements<double>(map, 1.0, yields).at_pressure(greatest).stiffness;
            BoundaryElements<double> after(detail::flattened(map, 1.0, greatest, yields), 1.0,
                                           {.edges = Edges::periodic});
            for (std::size_t i = 0; i < shares.size(); ++i)
                mean[i] += after.at_pressure(shares[i] * greatest).stiffness / K / 3;
        }
        int found = 0;
        for (std::size_t k = 0; k < table.size(); ++k)
            for (std::size_t i = 0; i < shares.size(); ++i)
                if (table.text(k, "seed") == "11" && table.input(k, "hardness_over_Eg") == h &&
                    table.input(k, "greatest_p_over_H") == 0.3 && table.input(k, "p_over_greatest") == shares[i]) {
                    CAPTURE(h, shares[i], mean[i]);
                    ++found;  // other waves of one spectrum: maps differ by 5 % of their mean
                    CHECK(test::relative_error(mean[i], table.input(k, "stiffness_over_stiffness_at_greatest")) < 0.1);
                }
        CHECK(found == 3);
    }
}

}  // namespace unloading_test
