// SPDX-License-Identifier: BSD-3-Clause
#include "command.hpp"

#include "support/accuracy.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <complex>
#include <numbers>

namespace {

const std::string steel = " --frequency '7 MHz' --impedance '46 MRayl'";

nlohmann::json json(const std::string& arguments) {
    const auto outcome = test::fstiff("ultrasound --format json " + arguments);
    INFO(arguments << "\n" << outcome.err);
    REQUIRE(outcome.status == 0);
    return nlohmann::json::parse(outcome.out);
}

}  // namespace

TEST_CASE("The reflection of a stiffness is eq. (5.1)") {
    const auto document = json("--stiffness '1.764 GPa/um'" + steel);
    const double ratio = 2 * 1.764e15 / (2 * std::numbers::pi * 7e6 * 46e6);
    CHECK(test::relative_error(document["reflection"].get<double>(), 1 / std::sqrt(1 + ratio * ratio)) < 1e-15);
    CHECK(test::relative_error(document["transmitted_energy"].get<double>(), ratio * ratio / (1 + ratio * ratio)) <
          2e-15);
}

TEST_CASE("The stiffness of a reflection gives that reflection back, like and unlike media") {
    for (const std::string media : {"", " --impedance2 '17 MRayl'", " --density2 '2700 kg/m^3' --velocity2 '6.3 km/s'"})
        for (const std::string reflection : {"0.99", "0.9", "0.5"}) {
            const auto inverse = json("--reflection " + reflection + steel + media);
            const double stiffness = inverse["stiffness_Pa_per_m"];
            char text[64];
            std::snprintf(text, sizeof text, "%.17g Pa/m", stiffness);
            const auto forward = json("--stiffness '" + std::string(text) + "'" + steel + media);
            // dR/R is at most dK/K for R >= 0.5 and these media, where R is well above that of the welded joint
            CHECK(test::relative_error(forward["reflection"].get<double>(), std::stod(reflection)) < 1e-14);
            CHECK(forward["impedance2_Rayl"] == inverse["impedance2_Rayl"]);
        }
}

TEST_CASE("Unlike media follow the boundary conditions of a spring") {
    const auto document = json("--stiffness '1 GPa/um' --impedance2 '17 MRayl'" + steel);
    const double z1 = 46e6, z2 = 17e6, x = 2 * std::numbers::pi * 7e6 * z1 * z2 / 1e15;
    const std::complex<double> r = std::complex(z1 - z2, x) / std::complex(z1 + z2, x);
    CHECK(test::relative_error(document["reflection"].get<double>(), std::abs(r)) < 2e-15);
    CHECK(test::relative_error(document["reflection_phase_rad"].get<double>(), std::arg(r)) < 2e-15);
    const double t = document["transmission"];
    CHECK(test::relative_error(std::norm(r) + z2 / z1 * t * t, 1.0) < 4e-15);
    CHECK(test::relative_error(document["welded_reflection"].get<double>(), 29.0 / 63.0) < 1e-15);
}

TEST_CASE("Density and velocity stand for the impedance") {
    const auto a = json("--stiffness '1 GPa/um' --frequency '7 MHz' --density '7850 kg/m^3' --velocity '5900 m/s'");
    CHECK(a["impedance_Rayl"].get<double>() == 7850.0 * 5900.0);
    CHECK(a["impedance2_Rayl"] == a["impedance_Rayl"]);
}

TEST_CASE("The table and the CSV of ultrasound hold the same") {
    const auto document = json("--stiffness '1.764 GPa/um'" + steel);
    const test::Csv csv(test::fstiff("ultrasound --format csv --stiffness '1.764 GPa/um'" + steel).out);
    CHECK(csv.size() == 1);
    for (const std::string& name : csv.header()) CHECK(document[name].get<double>() == csv.number(0, name));
    const auto table = test::fstiff("ultrasound --stiffness '1.764 GPa/um'" + steel);
    CHECK(test::contains(table.out, "1.764 GPa/µm = 1.764e+15 Pa/m"));
}

TEST_CASE("Ultrasound refuses what the spring model does not allow") {
    using test::check_refused;
    check_refused("ultrasound --reflection 1" + steel, 3, {"reflection = 1", "less than 1"});
    check_refused("ultrasound --reflection 0" + steel, 3, {"reflection = 0", "greater than 0"});
    check_refused("ultrasound --reflection nan" + steel, 3, {"reflection", "must be"});
    check_refused("ultrasound --reflection 0.3 --impedance2 '17 MRayl'" + steel, 3, {"reflection = 0.3", "welded"});
    check_refused("ultrasound --stiffness '-1 GPa/um'" + steel, 3, {"stiffness = -1", "not negative"});
    check_refused("ultrasound --stiffness 5" + steel, 3, {"--stiffness = \"5\"", "without a unit", "GPa/um"});
    check_refused("ultrasound --stiffness '5 GPa'" + steel, 3, {"--stiffness", "GPa", "allowed are"});
    check_refused("ultrasound --stiffness '1 GPa/um' --frequency '0 Hz' --impedance '46 MRayl'", 3,
                  {"frequency = 0", "greater than 0"});
    check_refused("ultrasound --stiffness '1 GPa/um' --frequency '7 MHz' --impedance '-1 MRayl'", 3,
                  {"impedance", "greater than 0"});
    check_refused("ultrasound --stiffness '1 GPa/um' --reflection 0.5" + steel, 2,
                  {"one of --stiffness and --reflection"});
    check_refused("ultrasound" + steel, 2, {"one of --stiffness and --reflection"});
    check_refused("ultrasound --stiffness '1 GPa/um' --frequency '7 MHz'", 2, {"--impedance", "--density"});
    check_refused("ultrasound --stiffness '1 GPa/um' --density '1 g/cm^3'" + steel, 2, {"--impedance", "--density"});
    check_refused("ultrasound --stiffness '1 GPa/um' --impedance '46 MRayl'", 2, {"--frequency"});
    check_refused("ultrasound --reflection half" + steel, 2, {"--reflection", "half"});
}
