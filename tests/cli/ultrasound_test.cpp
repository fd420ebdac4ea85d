// SPDX-License-Identifier: BSD-3-Clause
#include "command.hpp"

#include "support/accuracy.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <complex>
#include <numbers>

namespace ultrasound_test {

namespace {

const std::string steel = " --frequency '7 MHz' --impedance '46 MRayl'";

nlohmann::json json(const std::string& arguments) {
    const auto outcome = test::run_fstiff("ultrasound --format json " + arguments);
    INFO(arguments << "\n" << outcome.err);
    REQUIRE(outcome.status == 0);
    return nlohmann::json::parse(outcome.out);
}

}  // namespace

TEST_CASE("The reflection of a stiffness is eq. (5.1), in JSON, CSV and the table") {
    const std::string call = "--stiffness '1.764 GPa/um'" + steel;
    const auto document = json(call);
    const double ratio = 2 * 1.764e15 / (2 * std::numbers::pi * 7e6 * 46e6);
    CHECK(test::relative_error(document["reflection"].get<double>(), 1 / std::sqrt(1 + ratio * ratio)) < 1e-15);
    CHECK(test::relative_error(document["transmitted_energy"].get<double>(), ratio * ratio / (1 + ratio * ratio)) <
          2e-15);
    const test::Csv csv(test::run_fstiff("ultrasound --format csv " + call).out);
    CHECK(csv.size() == 1);
    for (const std::string& name : csv.header()) CHECK(document[name].get<double>() == csv.number(0, name));
    CHECK(test::contains(test::run_fstiff("ultrasound " + call).out, "1.764 GPa/µm = 1.764e+15 Pa/m"));
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
    // density and velocity give the impedance, of both media where there is no other
    const auto a = json("--stiffness '1 GPa/um' --frequency '7 MHz' --density '7850 kg/m^3' --velocity '5900 m/s'");
    CHECK(a["impedance_Rayl"].get<double>() == 7850.0 * 5900.0);
    CHECK(a["impedance2_Rayl"] == a["impedance_Rayl"]);
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
                  {"--frequency = \"0 Hz\": must be greater than 0"});
    check_refused("ultrasound --stiffness '1 GPa/um' --frequency '7 MHz' --impedance '-1 MRayl'", 3,
                  {"impedance", "greater than 0"});
    check_refused("ultrasound --stiffness '1 GPa/um' --reflection 0.5" + steel, 2,
                  {"one of --stiffness and --reflection"});
    check_refused("ultrasound" + steel, 2, {"one of --stiffness and --reflection"});
    check_refused("ultrasound --stiffness '1 GPa/um' --frequency '7 MHz'", 2, {"--impedance", "--density"});
    check_refused("ultrasound --stiffness '1 GPa/um' --density '1 g/cm^3'" + steel, 2, {"--impedance", "--density"});
    check_refused("ultrasound --stiffness '1 GPa/um' --impedance '46 MRayl'", 2, {"--frequency"});
    check_refused("ultrasound --reflection half" + steel, 3, {"--reflection", "half", "existing file"});
}

TEST_CASE("A file of measured reflections gives K of every row with its error") {
    const std::string file =
        "# a comment\npressure [MPa]; temperature; |R|; R_error\n1; 20; 0,99; 0,001\n10; 20; 0,9; 0,002\n"
        "60; 20; 0,5; 0,002\n";
    const auto outcome = test::run_fstiff("ultrasound --reflection - --format json" + steel, file);
    REQUIRE(outcome.status == 0);
    const auto rows = nlohmann::json::parse(outcome.out)["rows"];
    REQUIRE(rows.size() == 3);
    const double pressures[3] = {1e6, 10e6, 60e6}, reflections[3] = {0.99, 0.9, 0.5}, errors[3] = {0.001, 0.002, 0.002};
    for (std::size_t i = 0; i < 3; ++i) {
        const double r = reflections[i];
        const double k = std::numbers::pi * 7e6 * 46e6 * std::sqrt(1 - r * r) / r;
        CHECK(test::relative_error(rows[i]["pressure_Pa"].get<double>(), pressures[i]) < 1e-15);
        CHECK(test::relative_error(rows[i]["stiffness_Pa_per_m"].get<double>(), k) < 4e-15);
        CHECK(test::relative_error(rows[i]["stiffness_error_Pa_per_m"].get<double>(),
                                   k * errors[i] / (r * (1 - r * r))) < 2e-14);
    }
    // the CSV reads back as measured stiffnesses
    const test::Folder folder;
    const auto csv = test::run_fstiff("ultrasound --reflection - --format csv" + steel, file);
    CHECK(test::lines(csv.out).front() == "pressure_Pa,stiffness_Pa_per_m,stiffness_error_Pa_per_m");
    // taken as such, though the surface of the built-in scene has no such K
    CHECK(test::run_fstiff("identify --measured - --law hertz --fit sigma", csv.out).status == 4);
    const auto table = test::run_fstiff("ultrasound --reflection -" + steel, file);
    for (const char* part : {"error of K [%]", "0.99", "46 MRayl"}) CHECK(test::contains(table.out, part));
}

TEST_CASE("Reflections without a column of errors take --reflection-error, or have none") {
    const std::string file = "p [MPa],R\n1,0.9\n";
    const auto with = test::run_fstiff("ultrasound --reflection - --reflection-error 0.002 --format csv" + steel, file);
    const auto without = test::run_fstiff("ultrasound --reflection - --format csv" + steel, file);
    CHECK(test::relative_error(test::Csv(with.out).number(0, "stiffness_error_Pa_per_m"),
                               test::Csv(with.out).number(0, "stiffness_Pa_per_m") * 0.002 / (0.9 * 0.19)) < 2e-14);
    CHECK(test::lines(without.out).front() == "pressure_Pa,stiffness_Pa_per_m");
}

TEST_CASE("A film in parallel is added to K before a reflection, and subtracted after it") {
    const auto wet = json("--stiffness '1.764 GPa/um' --film-stiffness '0.75 GPa/um'" + steel);
    CHECK(wet["reflection"] == json("--stiffness '2.514 GPa/um'" + steel)["reflection"]);
    CHECK(wet["stiffness_Pa_per_m"] == 1.764e15);
    CHECK(wet["film_stiffness_Pa_per_m"] == 0.75e15);
    const std::string film = " --film-stiffness '0.75 GPa/um'" + steel;
    for (const std::string reflection : {"0.7", "0.4"}) {
        const auto one = json("--reflection " + reflection + " --reflection-error 0.01" + film),
                   dry = json("--reflection " + reflection + " --reflection-error 0.01" + steel);
        CHECK(one["stiffness_Pa_per_m"] == dry["stiffness_Pa_per_m"].get<double>() - 0.75e15);
        CHECK(one["stiffness_error_Pa_per_m"] == dry["stiffness_error_Pa_per_m"]);
    }
    // 1/sqrt(1 + (2 K/(omega z))^2) of the film: 0.803
    test::check_refused("ultrasound --reflection 0.81" + film, 3, {"reflection = 0.81", "0.803", "film alone"});
    const std::string file = "p [MPa],R,error\n1,0.81,0.002\n2,0.8,0.002\n10,0.7,0.002\n";
    const auto curve = test::run_fstiff("ultrasound --reflection - --format json" + film, file);
    CHECK(curve.status == 4);
    const auto rows = nlohmann::json::parse(curve.out)["rows"];
    CHECK(rows[0]["stiffness_Pa_per_m"].is_null());
    CHECK(rows[2]["stiffness_Pa_per_m"] == json("--reflection 0.7" + film)["stiffness_Pa_per_m"]);
    CHECK(test::contains(curve.err, "within two errors of 0.8"));
    CHECK(test::contains(curve.err, "1 of 3 rows, the first at line 3"));
}

TEST_CASE("Rows whose R belongs to no stiffness have none, and the exit code is 4") {
    const std::string file = "p [MPa],R,error\n1,1.002,0.002\n2,0.999,0.002\n10,0.9,0.002\n60,0.4,0.002\n";
    const std::string call = "ultrasound --reflection - --impedance2 '17 MRayl'" + steel;
    const auto json = test::run_fstiff(call + " --format json", file);
    CHECK(json.status == 4);
    const auto document = nlohmann::json::parse(json.out);
    CHECK(document["rows"][0]["stiffness_Pa_per_m"].is_null());
    CHECK(document["rows"][2]["stiffness_Pa_per_m"].is_number());
    CHECK(document["rows"][3]["stiffness_Pa_per_m"].is_null());  // the welded joint has 29/63
    CHECK(test::contains(json.err, "no stiffness there"));
    CHECK(test::contains(json.err, "2 of 4 rows, the first at line 2"));
    CHECK(test::contains(json.err, "within two errors of 1"));
    CHECK(test::Csv(test::run_fstiff(call + " --format csv", file).out).size() == 2);
    CHECK(test::contains(test::run_fstiff(call, file).out, "warning: R is not between"));
}

TEST_CASE("A file of reflections that is none is refused by line") {
    const std::string call = "ultrasound --reflection -" + steel;
    test::check_refused(call, 3, {"standard input:2", "reflection = 1.5", "less than 1"}, "p [MPa],R\n1,1.5\n");
    test::check_refused(call, 3, {"standard input:3", "reflection", "half"}, "p [MPa],R\n1,0.5\n2,half\n");
    test::check_refused(call, 3, {"standard input:1", "\"p\"", "no unit"}, "p,R\n1,0.5\n");
    test::check_refused(call, 3, {"standard input:1", "row of numbers"}, "1,0.5\n");
    test::check_refused(call, 3, {"standard input:1", "reflection"}, "p [MPa],b\n1,0.5\n");
    test::check_refused(call, 3, {"stiffnesses", "reflection"}, "p [MPa],K [GPa/um]\n1,0.5\n");
    test::check_refused(call, 3, {"header but no row"}, "p [MPa],R\n");
    test::check_refused(call, 3, {"standard input:1", "reflection [V]", "plain number, or in % or dB"},
                        "p [MPa],reflection [V]\n1,0.5\n");
}

TEST_CASE("Reflections in per cent are read, and a column that is not is named") {
    const std::string call = "ultrasound --reflection - --format json" + steel;
    const auto plain = test::run_fstiff(call, "p [MPa],R,std\n1,0.9,0.005\n");
    const auto percent = test::run_fstiff(call, "p [MPa],R [%],T [K],R_error [%]\n1,90,293,0.5\n");
    const auto row = [](const test::Outcome& found) { return nlohmann::json::parse(found.out)["rows"][0]; };
    for (const char* key : {"stiffness_Pa_per_m", "stiffness_error_Pa_per_m"})
        CHECK(test::relative_error(row(percent)[key].get<double>(), row(plain)[key].get<double>()) < 1e-14);
    CHECK(plain.err.empty());
    CHECK(test::contains(percent.err, "column \"T [K]\" is not read"));
    const std::string near = " --reflection 0.99 --reflection-error 0.006" + steel;
    CHECK(test::contains(test::run_fstiff("ultrasound" + near).out, "within two errors of 1"));
    CHECK(test::contains(test::run_fstiff(call + " --reflection-error 0.1", "p [MPa],R,error\n1,0.9,0.005\n").err,
                         "not the one that is given"));
}

}  // namespace ultrasound_test
