// SPDX-License-Identifier: BSD-3-Clause
// Heat and current through a contact: k K/E of every law, the gap in parallel, and refusals.
#include "actions/answered.hpp"
#include "actions/run.hpp"

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/files.hpp"
#include "support/library.hpp"

#include <fstiff/core/error.hpp>

#include <cmath>
#include <numbers>
#include <string>

namespace conductance_scene_test {

namespace {

using namespace fstiff;
using test::results_of;

const std::string surface = "[surface]\nrms_height = \"0.8 um\"\nrms_gradient = 0.1\nalpha = 5\n",
                  contact = "[contact]\npressures = [\"1 MPa\", \"10 MPa\"]\n";

double at(const actions::Answered& found, std::string_view quantity, std::string_view statistic = "") {
    const auto value = test::value_at(found.curves().front(), 1, quantity, statistic);
    REQUIRE(value);
    return *value;
}

std::string refusal(const std::string& text) { return test::refused_scene(text, "s.toml"); }

}  // namespace

TEST_CASE("The spots conduct k K/E of every law, with the band of K") {
    const std::string bodies =
        "[material.upper]\nname = \"steel\"\nthermal_conductivity = \"40 W/(m K)\"\n"
        "electrical_conductivity = \"7 MS/m\"\n[material.lower]\nname = \"aluminium\"\nthermal_conductivity = \"165 "
        "W/(m K)\"\n";
    for (const char* laws : {"", "laws = [\"hertz\"]\n", "laws = [\"persson\"]\n"}) {
        const auto found = results_of(surface + bodies + contact + laws);
        const double k = 2 * 40 * 165.0 / (40 + 165), s = 2 * 7e6 * 26.2e6 / (7e6 + 26.2e6);
        for (const std::string_view statistic : {"", "_p05", "_p95"}) {
            if (!found.curves().front().has_band && !statistic.empty()) continue;
            const double K = at(found, "stiffness", statistic) / found.answer.effective_modulus;
            CHECK(test::relative_error(at(found, "thermal_conductance", statistic), k * K) < 1e-14);
            CHECK(test::relative_error(at(found, "electrical_conductance", statistic), s * K) < 1e-14);
        }
    }
}

TEST_CASE("The gap and radiation are in parallel with the spots, and films in series") {
    const std::string steel = "material.upper = \"steel\"\n", laws = "laws = [\"hybrid\"]\n";
    const auto bare = results_of(steel + surface + contact + laws +
                                 "[output]\nquantities = [\"thermal_conductance\", \"separation\", \"real_area\"]\n");
    const auto air = results_of(steel + surface + contact + laws + "[gap]\nmedium = \"air\"\n");
    CHECK(at(air, "thermal_conductance") == at(bare, "thermal_conductance"));
    const double h = 0.0257 / at(air, "thermal_conductance_gap") - at(bare, "separation");
    CHECK(h > 0.25e-6);  // the jump of the temperature
    CHECK(h < 0.45e-6);
    const auto film = results_of(steel + surface + contact + laws +
                                 "[gap]\nconductivity = \"0.8 W/(m K)\"\nemissivity = 1\n"
                                 "temperature = \"300 K\"\nthermal_film = \"1 mm^2 K/W\"\n");
    CHECK(test::relative_error(at(film, "thermal_conductance_gap"), 0.8 / at(bare, "separation") + 6.1240) < 1e-5);
    CHECK(test::relative_error(1 / at(film, "thermal_conductance"),
                               1 / at(bare, "thermal_conductance") + 1e-6 / at(bare, "real_area")) < 1e-12);
}

TEST_CASE("A gap is filled by name: a gas jumps at its faces, a liquid does not, a vacuum leaves radiation") {
    const std::string steel = "material.upper = \"steel\"\n", laws = "laws = [\"hybrid\"]\n";
    const auto filled = [&](const std::string& gap) {
        return results_of(steel + surface + contact + laws + "[gap]\n" + gap);
    };
    const double d = at(filled("medium = \"air\"\n"), "separation");
    CHECK(test::relative_error(at(filled("medium = \"water\"\n"), "thermal_conductance_gap"), 0.598 / d) < 1e-14);
    CHECK(at(filled("medium = \"vacuum\"\n"), "thermal_conductance_gap") == 0);
    const auto bright = filled("medium = \"vacuum\"\nemissivity = 1\ntemperature = \"300 K\"\n");
    CHECK(test::relative_error(at(bright, "thermal_conductance_gap"), 6.1240) < 1e-5);
    // M of helium by hand: 2 (2 - a)/a 2 g/(g + 1)/Pr L, g = 5/3
    for (const auto& [written, a] : {std::pair{"", 0.4}, {"accommodation = 0.9\n", 0.9}}) {
        const double jump = 2 * (2 - a) / a * 1.25 / 0.67 * 194e-9;
        CHECK(
            test::relative_error(at(filled(std::string("medium = \"helium\"\n") + written), "thermal_conductance_gap"),
                                 0.154 / (d + jump)) < 1e-12);
    }
}

TEST_CASE("Plastic peaks conduct as by Cooper, Mikic and Yovanovich, less the interaction of their spots") {
    // h = 1.25 k m/sigma (p/H)^0.95 with the mean slope of a profile m = g/sqrt(pi), of spots that do not
    // interact;
    // 0.72 to 0.97 of it by boundary elements of three maps, which theory and K of unloading agree with
    for (const double share : {0.003, 0.01, 0.03, 0.1}) {
        const auto found = results_of("[material]\nupper = { name = \"steel\", hardness = \"0.5 GPa\" }\n" + surface +
                                      "[contact]\nlaws = [\"plastic\"]\npressures = [\"1 Pa\", \"" +
                                      std::to_string(share * 0.5e9) + " Pa\"]\n[gap]\nmedium = \"air\"\n");
        const double spots = 1.25 * 53.3 * 0.1 / std::sqrt(std::numbers::pi) / 0.8e-6 * std::pow(share, 0.95);
        const double ratio = at(found, "thermal_conductance") / spots;
        INFO(share << ": " << ratio);
        CHECK(ratio > 0.7);
        CHECK(ratio < 1.0);
    }
}

TEST_CASE("Heat without a conductivity, and a gap that contradicts itself, are refused") {
    const std::string plain = "[material.upper]\nyoungs_modulus = \"200 GPa\"\npoisson_ratio = 0.3\n";
    const std::string asked = "[output]\nquantities = [\"thermal_conductance\"]\n";
    CHECK(test::contains(refusal(plain + surface + contact + asked), "needs material.upper.thermal_conductivity"));
    CHECK(test::contains(refusal(plain + surface + contact + "[gap]\nmedium = \"xenon\"\n"),
                         "must be one of \"air\", \"helium\""));
    CHECK(test::contains(refusal(surface + contact + "[gap]\nmedium = \"air\"\nconductivity = \"1 W/(m K)\"\n"),
                         "gap.conductivity = \"1 W/(m K)\": must not be given with gap.medium"));
    CHECK(test::contains(refusal(surface + contact + "[gap]\nemissivity = 2\ntemperature = \"293 K\"\n"),
                         "gap.emissivity"));
    CHECK(test::contains(refusal(surface + contact + "[gap]\nconductivity = 1\n"),
                         "write it as a text such as \"40 W/(m K)\""));
    CHECK(test::contains(refusal(surface + contact + "[gap]\nconductivity = \"1 S/m\"\n"), "W/(m K)"));
}

TEST_CASE("Resistances are one over the conductance of the nominal area, with its band, and need both") {
    const std::string bodies =
        "[material.upper]\nname = \"steel\"\nthermal_conductivity = \"40 W/(m K)\"\n"
        "electrical_conductivity = \"7 MS/m\"\n[material.lower]\nname = \"aluminium\"\n";
    const auto joint = results_of(surface + bodies + contact + "nominal_area = \"2 cm^2\"\n[gap]\nmedium = \"air\"\n");
    const double area = 2e-4, gap = at(joint, "thermal_conductance_gap");
    for (const auto& [end, other] : {std::pair("", ""), std::pair("_p05", "_p95"), std::pair("_p95", "_p05")}) {
        CHECK(test::relative_error(at(joint, "resistance", end) * area,
                                   1 / at(joint, "electrical_conductance", other)) < 1e-14);
        CHECK(test::relative_error(at(joint, "thermal_resistance", end) * area,
                                   1 / (at(joint, "thermal_conductance", other) + gap)) < 1e-14);
    }
    CHECK(test::value_at(joint.curves().front(), 1, "resistance", "_error"));
    const auto asked = [&](const std::string& quantity, const std::string& more) {
        return refusal("material.upper = \"steel\"\n" + surface + contact + more + "[output]\nquantities = [\"" +
                       quantity + "\"]\n");
    };
    CHECK(test::contains(asked("resistance", ""), "contact.nominal_area or contact.washer"));
    CHECK(test::contains(asked("thermal_resistance", ""), "contact.nominal_area or contact.washer"));
}

TEST_CASE("An insulator conducts no current, and the cell of its resistance is empty") {
    const auto found = results_of("[material]\nupper = \"glass\"\nlower = \"steel\"\n" + surface + contact +
                                  "nominal_area = \"2 cm^2\"\n[output]\nquantities = [\"electrical_conductance\", "
                                  "\"resistance\", \"thermal_resistance\"]\n");
    CHECK(at(found, "electrical_conductance") == 0);
    CHECK(at(found, "thermal_resistance") > 0);
    CHECK_FALSE(test::value_at(found.curves().front(), 1, "resistance", ""));
    CHECK(test::contains(test::csv_of(found), "resistance_ohm"));
}

}  // namespace conductance_scene_test
