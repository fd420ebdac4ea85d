// SPDX-License-Identifier: BSD-3-Clause
// Truth: tests/data/plastic_curves.csv (9 digits, two quadratures).
#include <fstiff/asperity/plastic_laws.hpp>
#include <fstiff/contact/rough_contact.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/paper.hpp"
#include "support/table.hpp"

namespace plastic_contact_test {

using namespace fstiff;

TEST_CASE("plastic peaks of the paper's surfaces: the table to 1e-8") {
    const test::Table table("plastic_curves.csv");
    const double E = 205e9 / (2 * (1 - 0.09));
    const PlasticMaterial<double> steel{E, 400e6, 0.3, 1.12e9};
    int checked = 0;
    for (std::size_t row = 0; row < table.size(); ++row) {
        const std::string law = table.text(row, "law"), name = table.text(row, "surface");
        const auto surface =
            test::paper_surface(name == "electrical_discharge_machined" ? "electrical_discharge" : name);
        const PeakDistribution<double> peaks(table.input(row, "r"), table.input(row, "theta"));
        const double p = table.input(row, "pressure_Pa");
        const auto check = [&](const auto& of) {
            const auto state = RoughContact(surface.roughness(), peaks, of, E).at_pressure(p);
            CAPTURE(name, law, p);
            CHECK(test::relative_error(state.stiffness.value, table.input(row, "unloading_stiffness_Pa_per_m")) < 1e-8);
            CHECK(test::relative_error(state.real_area_fraction.value, table.input(row, "real_area_fraction")) < 1e-8);
            CHECK(test::relative_error(state.contact_density.value, table.input(row, "contacts_per_m2")) < 1e-8);
            // to 9 digits of the table
            CHECK(state.stiffness.error < 1e-8 * state.stiffness.value);
            ++checked;
        };
        if (law == "hertz") check(HertzLaw<double>{});
        if (law == "plastic") check(PlasticLaw<double>(1.12e9, E));
        if (law == "jackson_green" && row % 2 == 0) check(JacksonGreenLaw<double>(steel));
        if (law == "kogut_etsion" && row % 2 == 0) check(KogutEtsionLaw<double>(steel));
    }
    CHECK(checked >= 120);
}

TEST_CASE("unloading and loading: K is not the slope of a plastic load, and p over the area is H") {
    const double E = 112.6e9, H = 1.12e9;
    const RoughContact contact(test::sand_blasted_fine.roughness(), PeakDistribution<double>::exponential(0.8),
                               PlasticLaw<double>(H, E), E);
    for (const double p : {1e5, 1e7, 3e8}) {
        const auto state = contact.at_pressure(p);
        CHECK(test::relative_error(p / state.real_area_fraction.value, H) < 1e-12);
        const double d = state.separation.value, h = 1e-5 * 0.832e-6;
        const double slope =
            (contact.at_separation(d - h).pressure.value - contact.at_separation(d + h).pressure.value) / (2 * h);
        CHECK(test::relative_error(state.loading_stiffness.value, slope) < 1e-8);
        CHECK(state.stiffness.value > state.loading_stiffness.value);
    }
    CHECK(test::refusal([&] { (void)contact.at_pressure(H); }).find("less than the hardness") != std::string::npos);
}

}  // namespace plastic_contact_test
