// SPDX-License-Identifier: BSD-3-Clause
// The contact of maps: summits that push each other down, and the hybrid law from the heights on.
#include "row.hpp"

#include "support/half_space_maps.hpp"
#include "support/map_kinds.hpp"
#include "support/table.hpp"

#include <fstiff/contact/hybrid_contact.hpp>
#include <fstiff/contact/hybrid_of_map.hpp>
#include <fstiff/contact/mutual_summits.hpp>
#include <fstiff/topography/map_spectrum.hpp>
#include <fstiff/topography/summits.hpp>

namespace {

using namespace bench;

/// 8,500 summits over the unit square, rms gradient 0.1; at 0.003 E 4,800 of them carry.
const fstiff::detail::MutualSummits<double>& crowd() {
    static const auto contact = [] {
        fstiff::HeightMap<double> map{test::gaussian_map(1024, 42, 170, 0.8, 7), 1.0 / 1024, 1.0 / 1024};
        map.heights *= 0.1 / fstiff::map_spectrum(map, fstiff::Edges::periodic).rms_gradient();
        return fstiff::detail::MutualSummits<double>(fstiff::summits_of(map), 1.0);
    }();
    return contact;
}

const Rows rows_of_summits([] {
    constexpr double pressure = 0.003;
    verified_row(
        "contact/mutual_summits/4800", 1e-5,
        [] {  // K as the slope of the separation
            const auto state = crowd().at_pressure(pressure), low = crowd().at_pressure(pressure * (1 - 1e-4)),
                       high = crowd().at_pressure(pressure * (1 + 1e-4));
            AccuracyCollector collector;
            collector.add(state.stiffness.value, 2e-4 * pressure / (low.separation.value - high.separation.value));
            collector.add_cost(static_cast<double>(crowd().crowding(pressure).contacts));
            return collector.accuracy();
        },
        [](benchmark::State& state) {
            for (auto _ : state) benchmark::DoNotOptimize(crowd().at_pressure(pressure).stiffness.value);
        });
    verified_row(
        "contact/hybrid_of_map/256x256", 0.2,  // the law, not its arithmetic: over boundary elements
        [] {
            const test::Table table("bem_maps.csv");
            AccuracyCollector collector;
            for (std::size_t row = 0; row < table.size(); ++row) {
                if (table.text(row, "map") != "gaussian" || table.input(row, "p_star") < 0.0009) continue;
                collector.add(hybrid_of_map(test::half_space_map("gaussian"), 1.0, fstiff::Edges::periodic)
                                  .stiffness(table.input(row, "p_over_E")),
                              table.input(row, "stiffness_times_L_over_E"));
                collector.add_cost(256 * 256);
            }
            return collector.accuracy();
        },
        [](benchmark::State& state) {
            const auto map = test::half_space_map("gaussian");
            for (auto _ : state)
                benchmark::DoNotOptimize(hybrid_of_map(map, 1.0, fstiff::Edges::periodic).stiffness(1e-3));
        });
});

}  // namespace
