// SPDX-License-Identifier: BSD-3-Clause
// A surface with other cut-offs: each row is the measurement, and the K, with these cut-offs.
#include "support/library.hpp"

#include "actions/scales.hpp"

#include <cmath>

namespace scales_test {

using namespace fstiff;

TEST_CASE("Each row of the scales is the measurement and the K with its cut-offs") {
    const test::Folder folder;
    const std::string trace = test::profile_text(
        4096, 1e-6, {.hurst = 0.7, .rms = 1e-6, .longest_wavelength = 400e-6, .shortest_wavelength = 4e-6});
    surface::MeasureOptions how;
    how.input = test::surface_options("--lambda-s '10 um' --lambda-c '800 um'");
    const surface::SurfaceInput input = surface::read_surface_input(how.input, trace);
    const actions::Scales scales =
        actions::scales_of(surface::measure_surface(how, input), input, {.pressure = 20e6, .modulus = 100e9});
    int checked = 0, chosen = 0;
    for (const auto* list : {&scales.short_waves, &scales.long_waves})
        for (const actions::Scale& row : *list) {
            const auto text = [](const std::optional<double>& of) {
                return of ? "'" + document::exact(*of) + " m'" : std::string("none");
            };
            chosen += row.chosen;
            CHECK(row.chosen == (row.cut_offs.lambda_s == 10e-6 && row.cut_offs.lambda_c == 800e-6));
            if (!row.stiffness) {
                CHECK_FALSE(row.refusal.empty());
                continue;
            }
            const auto measured = test::measured(
                "--lambda-s " + text(row.cut_offs.lambda_s) + " --lambda-c " + text(row.cut_offs.lambda_c), trace);
            REQUIRE(row.surface);
            const auto surface = test::parsed(actions::measured_document(*row.surface))["surface"];
            for (const char* key : {"rms_height", "peak_radius", "peak_density", "rms_gradient"})
                CHECK(std::abs(surface[key]["value"].get<double>() / measured["surface"][key]["value"].get<double>() -
                               1) < 1e-12);
            folder.write("surface.json", measured.dump());
            const auto results = test::results_of(
                "[surface]\nfrom = \"surface.json\"\n[material.upper]\nyoungs_modulus = \"200 GPa\"\n"
                "poisson_ratio = 0.0\n[contact]\npressures = [\"20 MPa\"]\nlaws = [\"" +
                    scales.law + "\"]\n[uncertainty]\nsamples = 0\n",
                folder / "scene.toml");
            CHECK(std::abs(*row.stiffness / results.curves()[0].points[0].state.stiffness.value - 1) < 1e-9);
            ++checked;
        }
    CHECK(checked > 8);
    CHECK(chosen == 2);  // among both lists
    CHECK(actions::convergence_sentences(scales).size() == 2);
}

}  // namespace scales_test
