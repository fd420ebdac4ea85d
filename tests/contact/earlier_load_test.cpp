// SPDX-License-Identifier: BSD-3-Clause
// Truth: tests/data/earlier_load.csv, boundary elements of three maps loaded, flowed and solved again.
#include <fstiff/contact/earlier_load.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/table.hpp"

#include <limits>
#include <map>

namespace earlier_load_test {

using fstiff::detail::stiffness_after_load;

TEST_CASE("stiffness after a greater load is within 15 % of boundary elements at most points down to a tenth of it") {
    const test::Table table("earlier_load.csv");
    std::map<std::string, int> within, all;
    for (std::size_t k = 0; k < table.size(); ++k) {
        const double share = table.input(k, "p_over_greatest");
        if (share == 1 || share < 0.09) continue;
        const double first = table.input(k, "stiffness_of_first_loading_over_at_greatest");
        const double truth = table.input(k, "stiffness_over_stiffness_at_greatest");
        const double error =
            test::relative_error(stiffness_after_load(first, table.input(k, "hardness_over_Eg")), truth);
        CHECK(error < 0.45);
        for (const auto& map : {table.text(k, "seed"), std::string("all")}) ++all[map], within[map] += error < 0.15;
    }
    for (const auto& [map, count] : all) {
        CAPTURE(map, count, within[map]);
        CHECK(within[map] >= (map == "all" ? 0.85 : 0.74) * count);
    }
}

TEST_CASE("stiffness after a greater load rises with the load from that of the first loading to that of the greatest") {
    for (const double h : {0.0, 0.05, 0.2, 1.0, 5.0}) {
        double last = 0;
        for (double r = 0.01; r < 1; r += 0.01) {
            const double now = stiffness_after_load(r, h);
            CHECK(now > last);
            CHECK(now >= r);
            last = now;
        }
        CHECK(test::relative_error(stiffness_after_load(1, h), 1.0) < 1e-15);
        CHECK(stiffness_after_load(0, h) == 0);
    }
    CHECK(test::relative_error(stiffness_after_load(0.3, std::numeric_limits<double>::infinity()), 0.3) < 1e-15);
    CHECK(test::relative_error(stiffness_after_load(0.3, 1e3), 0.3) < 1e-5);
    CHECK(test::refused_for("0 to 1", [] { (void)stiffness_after_load(1.2, 0.1); }));
    CHECK(test::refused_for("H/(E g) = nan", [] { (void)stiffness_after_load(0.2, std::nan("")); }));
}

}  // namespace earlier_load_test
