// SPDX-License-Identifier: BSD-3-Clause
// Tables of reflections as testers have them: what is read of each, and what is refused. Truth: eq. (5.1), by hand.
#include "command.hpp"

#include "support/accuracy.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <complex>
#include <numbers>

namespace reflection_tables_test {

namespace {

constexpr double impedance = 46e6;
const std::string steel = " --impedance '46 MRayl'";

double stiffness_of(double R, double frequency) {
    return std::numbers::pi * frequency * impedance * std::sqrt(1 - R * R) / R;
}

double reflection_of(double K, double frequency) {
    return 1 / std::sqrt(1 + std::pow(K / (std::numbers::pi * frequency * impedance), 2));
}

nlohmann::json document_of(const std::string& table, const std::string& options, int status = 0) {
    const auto outcome = test::run_fstiff("ultrasound --reflection - --format json" + steel + " " + options, table);
    INFO(table << outcome.err);
    REQUIRE(outcome.status == status);
    return nlohmann::json::parse(outcome.out);
}

std::string number(double value, const char* format = "%.17g") {
    char text[64];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

struct Table {
    const char *kind, *text;
};

// All hold R = 0.9 at 10 MPa and R = 0.8 at 20 MPa, of 5 MHz.
const Table tables[] = {
    {"plain", "pressure [MPa],reflection\n10,0.9\n20,0.8\n"},
    {"words of an article", "Contact pressure (MPa),Reflection coefficient (-)\n10,0.9\n20,0.8\n"},
    {"German workbook", "Druck [MPa];Reflexion [%]\n10;90,0\n20;80,0\n"},
    {"sep=;", "sep=;\nPressure [MPa];R\n10;0,9\n20;0,8\n"},
    {"sep=, and quotes", "sep=,\n\"p [MPa]\",\"|R|\"\n\"10\",\"0.9\"\n\"20\",\"0.8\"\n"},
    {"decimal commas in quotes", "\"p [MPa]\",\"R\"\n\"10,0\",\"0,9\"\n\"20,0\",\"0,8\"\n"},
    {"French",
     "Pression (MPa)\tCoefficient de r\xC3\xA9"
     "flexion\n10\t0,9\n20\t0,8\n"},
    {"Italian in Latin-1, and a stress", "sigma_n [MPa];coefficiente di riflessione\n10;0.9\n20;0.8\n"},
    {"blanks", "p [MPa]  R\n10   0.9\n20   0.8\n"},
    {"numpy.savetxt", "# p_MPa R\n1.0e+01 9.0e-01\n2.0e+01 8.0e-01\n"},
    {"lines after the rows", "pressure [MPa],reflection\n10,0.9\n20,0.8\nMean,0.85\nEOF\n"},
    {"a row without load", "pressure [MPa],reflection\n0,1\n10,0.9\n20,0.8\n"},
    {"rows of units", "Pressure;Reflection\nMPa;-\n10;0,9\n20;0,8\n"},
    {"an instrument's head", "Instrument;X 5\nOperator;me\nDate;2024-05-01\n\nPressure [MPa];R\n10;0,9\n20;0,8\n"},
    {"words beside numbers", "Time,p [MPa],R,state\n10:00:01,10,0.9,ok\n10:00:02,20,0.8,ok\n"},
    {"decibels", "Load (MPa),R (dB)\n10,-0.91514981121350\n20,-1.93820026016113\n"},
    {"a loss", "Load (MPa),Reflection loss (dB)\n10,0.91514981121350\n20,1.93820026016113\n"},
    {"energies", "p [MPa],|R|^2\n10,0.81\n20,0.64\n"},
    {"a column of frequencies", "p [MPa],f [MHz],R\n10,5,0.9\n20,5,0.8\n"},
    {"a frequency in the title", "p [bar];R (5 MHz)\n100;0,9\n200;0,8\n"},
    {"loads as columns", "Frequenz [kHz];R 10 MPa;R 20 MPa\n5000;0,9;0,8\n"},
};

}  // namespace

TEST_CASE("Twenty kinds of tables of reflections have the stiffnesses of their plain form") {
    for (const Table& table : tables) {
        INFO(table.kind << "\n" << table.text);
        const bool has_frequency = test::contains(table.text, "Hz");
        const auto document = document_of(table.text, has_frequency ? "" : "--frequency '5 MHz'");
        const auto& rows = document["rows"];
        REQUIRE(rows.size() == 2);
        const double R[2] = {0.9, 0.8};
        for (std::size_t i = 0; i < 2; ++i) {
            CHECK(test::relative_error(rows[i]["pressure_Pa"].get<double>(), 1e7 * (i + 1.0)) < 1e-15);
            // of 15 digits of a decibel
            CHECK(test::relative_error(rows[i]["stiffness_Pa_per_m"].get<double>(), stiffness_of(R[i], 5e6)) < 1e-12);
        }
        CHECK(document.contains("left_out") == (std::string(table.kind) == "a row without load"));
    }
}

TEST_CASE("A table that may mean two things is refused with the way to write the one that is meant") {
    const std::string call = "ultrasound --reflection - --frequency '5 MHz'" + steel;
    using test::check_refused;
    check_refused(call, 3, {"standard input:1", "Load [kN]", "is a force", "over the nominal area"},
                  "Load [kN],R\n1,0.9\n");
    check_refused(call, 3, {"Reflexionsgrad", "amplitudes or of energies", "R^2"}, "p [MPa],Reflexionsgrad\n1,0.9\n");
    check_refused(call, 3, {"standard input:2", "3", "dB is negative", "reflection loss"},
                  "p [MPa],R [dB]\n1,3\n2,2\n");
    check_refused(call, 3, {"above 1", "reflection loss"}, "p [MPa],R [dB]\n1,0.5\n2,0.2\n");
    check_refused(call, 3, {"standard input:2", "99.9", "R [%]"}, "p [MPa],R\n1,99.9\n2,98\n");
    check_refused(call, 3, {"no reflection is above 1 %", "without %"}, "p [MPa],R [%]\n1,0.99\n2,0.98\n");
    check_refused(call, 3, {"error column", "unit of the reflection", "%"}, "p [MPa],R [%],error\n1,90,0.5\n");
    check_refused(call, 3, {"error column", "dB"}, "p [MPa],R [dB],error\n1,-1,0.01\n");
    check_refused(call, 3, {"\"phase\"", "no unit", "rad, deg"}, "p [MPa],R,phase\n1,0.9,30\n");
    check_refused(call, 3, {"standard input:2", "phase", "full turn", "phase [deg]"},
                  "p [MPa],R,phase [rad]\n1,0.9,30\n");
    check_refused(call, 3, {"\"f\"", "no unit", "MHz"}, "p [MPa],f,R\n1,5,0.9\n");
    check_refused(call, 3, {"--frequency = 5 MHz", "line 2 has 2 MHz"}, "p [MPa],f [MHz],R\n1,2,0.9\n");
    check_refused(call, 3, {"columns of values", "a row for each value"},
                  "p [MPa],R 2 MHz,R 5 MHz,error\n1,0.9,0.8,0.1\n");
    check_refused(call, 3, {"listed twice"}, "p [MPa],R,|R|\n1,0.9,0.8\n");
    check_refused(call, 3, {"no row with load"}, "p [MPa],R\n0,1\n");
    check_refused("ultrasound --reflection -" + steel, 2, {"--frequency is missing", "column frequency"},
                  "p [MPa],R\n1,0.9\n");
}

TEST_CASE("A reference that is not 1 without load is named, and the exit code is 4") {
    const auto outcome = test::run_fstiff("ultrasound --reflection - --frequency '5 MHz'" + steel,
                                          "p [MPa],R,error\n0,0.9,0.001\n10,0.8,0.001\n");
    CHECK(outcome.status == 4);
    CHECK(test::contains(test::as_one_line(outcome.out), "|R| without load is not 1"));
    const auto noise = test::run_fstiff("ultrasound --reflection - --frequency '5 MHz'" + steel,
                                        "p [MPa],R,error\n0,1.003,0.002\n10,0.8,0.001\n");
    CHECK(noise.status == 0);
    CHECK(test::contains(noise.out, "left out           line 2, without load, |R| = 1.003"));
}

TEST_CASE("A spectrum at one load has one K with its error and scatter, and its phases agree") {
    std::string table = "f [MHz],|R|,error,phase [deg]\n";
    const double K = 4e14, pattern[4] = {1, -0.6, -1.2, 0.8};
    std::vector<double> inverse;
    for (int i = 0; i < 9; ++i) {
        const double f = (2 + i) * 1e6, R = reflection_of(K, f) + 0.001 * pattern[i % 4];
        inverse.push_back(stiffness_of(R, f));
        const double phase = std::atan(K / (std::numbers::pi * f * impedance)) * 180 / std::numbers::pi;
        table += number(f / 1e6) + "," + number(R) + ",0.001," + number(i % 2 == 0 ? phase : -phase) + "\n";
    }
    const auto document = document_of(table, "");
    for (std::size_t i = 0; i < inverse.size(); ++i) {
        const auto& row = document["rows"][i];
        CHECK(test::relative_error(row["stiffness_Pa_per_m"].get<double>(), inverse[i]) < 1e-12);
        CHECK(test::relative_error(row["stiffness_of_phase_Pa_per_m"].get<double>(), K) < 1e-12);
        CHECK_FALSE(row.contains("pressure_Pa"));
    }
    REQUIRE(document["loads"].size() == 1);
    const auto& load = document["loads"][0];
    CHECK(load["frequencies"] == 9);
    CHECK(std::abs(load["stiffness_Pa_per_m"].get<double>() - K) < 2 * load["stiffness_error_Pa_per_m"].get<double>());
    CHECK(document["frequency_check"]["depends"] == false);
    CHECK(document["phase_check"]["deviation_rad"].get<double>() < 0.02);
    CHECK(document["phase_check"]["of_stress"] == false);
    const auto shown = test::run_fstiff("ultrasound --reflection -" + steel, table);
    CHECK(test::contains(shown.out, "K does not depend on the frequency"));
    CHECK(test::lines(test::run_fstiff("ultrasound --reflection - --format csv" + steel, table).out).front() ==
          "frequency_Hz,stiffness_Pa_per_m,stiffness_error_Pa_per_m");
}

TEST_CASE("Phases of the stress are 180 degrees off, and a wrong one is named") {
    const auto table = [](double shift) {
        std::string text = "p [MPa],R,phase [rad]\n";
        for (const double K : {2e14, 4e14, 8e14})
            text += number(K / 1e13) + "," + number(reflection_of(K, 5e6)) + "," +
                    number(shift + std::atan(K / (std::numbers::pi * 5e6 * impedance))) + "\n";
        return text;
    };
    const auto stress = document_of(table(-std::numbers::pi), "--frequency '5 MHz'");
    CHECK(stress["phase_check"]["of_stress"] == true);
    CHECK(test::relative_error(stress["rows"][0]["stiffness_of_phase_Pa_per_m"].get<double>(), 2e14) < 1e-12);
    const auto wrong = test::run_fstiff("ultrasound --reflection - --frequency '5 MHz'" + steel, table(0.2));
    CHECK(wrong.status == 4);
    CHECK(test::contains(test::as_one_line(wrong.out), "the phase is 11 degrees rms off"));
    // between unlike bodies the phase is compared, and gives no K
    std::string unlike = "p [MPa],R,phase [deg]\n";
    for (const double K : {2e14, 8e14}) {
        const double x = 2 * std::numbers::pi * 5e6 * 46e6 * 17e6 / K;
        const std::complex<double> R = std::complex(46e6 - 17e6, x) / std::complex(46e6 + 17e6, x);
        unlike +=
            number(K / 1e13) + "," + number(std::abs(R)) + "," + number(std::arg(R) * 180 / std::numbers::pi) + "\n";
    }
    const auto document = document_of(unlike, "--impedance2 '17 MRayl' --frequency '5 MHz'");
    CHECK(document["phase_check"]["deviation_rad"].get<double>() < 1e-10);
    CHECK_FALSE(document["rows"][0].contains("stiffness_of_phase_Pa_per_m"));
}

TEST_CASE("Several frequencies and loads give one K(p) that identify reads, and a K that depends is named") {
    const auto table = [](double exponent) {
        std::string text = "pressure [MPa],frequency [MHz],reflection,error\n0,2,1,0.001\n0,5,1,0.001\n";
        for (const auto& [p, K] : {std::pair{5., 6e13}, {20., 2e14}, {80., 7e14}})
            for (const double f : {2e6, 4e6, 5e6})
                text += number(p) + "," + number(f / 1e6) + "," +
                        number(reflection_of(K * std::pow(f / 2e6, exponent), f)) + ",0.001\n";
        return text;
    };
    const test::Csv csv(test::run_fstiff("ultrasound --reflection - --format csv" + steel, table(0)).out);
    REQUIRE(csv.size() == 3);
    CHECK(csv.header() == std::vector<std::string>{"pressure_Pa", "stiffness_Pa_per_m", "stiffness_error_Pa_per_m"});
    CHECK(test::relative_error(csv.number(0, "stiffness_Pa_per_m"), 6e13) < 1e-9);
    CHECK(test::relative_error(csv.number(2, "stiffness_Pa_per_m"), 7e14) < 1e-9);
    const auto fit = test::run_fstiff("identify --measured - --law hertz --fit sigma",
                                      test::run_fstiff("ultrasound --reflection - --format csv" + steel, table(0)).out);
    CHECK(fit.status != 3);
    // the same as columns of frequencies
    std::string wide = "Druck [MPa];R 2 MHz;R 4 MHz;R @ 5 MHz\n";
    for (const auto& [p, K] : {std::pair{5., 6e13}, {20., 2e14}, {80., 7e14}})
        wide += number(p) + ";" + number(reflection_of(K, 2e6)) + ";" + number(reflection_of(K, 4e6)) + ";" +
                (p == 5 ? "" : number(reflection_of(K, 5e6))) + "\n";
    const auto of_wide = document_of(wide, "");
    CHECK(of_wide["loads"][0]["frequencies"] == 2);
    CHECK(test::relative_error(of_wide["loads"][1]["stiffness_Pa_per_m"].get<double>(), 2e14) < 1e-9);

    const auto depends = test::run_fstiff("ultrasound --reflection -" + steel, table(-0.2));
    CHECK(depends.status == 4);
    CHECK(test::contains(test::as_one_line(depends.out), "K depends on the frequency: -1"));
    test::check_refused("identify --measured - --law hertz --fit sigma", 3, {"ultrasound: is missing"}, table(0));
    const test::Folder folder;
    const std::string scene =
        folder.write("scene.toml", test::read(FSTIFF_SCENES "/built_in.toml") +
                                       "\n[ultrasound]\nfrequency = \"5 MHz\"\nupper = { impedance = \"46 MRayl\" }\n");
    test::check_refused("identify '" + scene + "' --measured - --law hertz --fit sigma", 3,
                        {"frequency = 2 MHz", "ultrasound.frequency", "fstiff ultrasound joins"}, table(0));
    test::check_refused("identify '" + scene + "' --measured - --law hertz --fit sigma", 3,
                        {"no column pressure", "several loads"}, "f [MHz],R\n5,0.9\n");
}

TEST_CASE("Bodies are given by the names of their materials") {
    const std::string K = "ultrasound --stiffness '1 GPa/um' --frequency '7 MHz' --format json ";
    const auto of = [&](const std::string& options) {
        const auto outcome = test::run_fstiff(K + options);
        INFO(options << outcome.err);
        REQUIRE(outcome.status == 0);
        return nlohmann::json::parse(outcome.out);
    };
    const auto steel_alone = of("--material steel");
    CHECK(steel_alone["impedance_Rayl"] == 7850.0 * 5960.0);
    CHECK(steel_alone["impedance2_Rayl"] == steel_alone["impedance_Rayl"]);
    CHECK(of("--material steel --wave shear")["impedance_Rayl"] == 7850.0 * 3235.0);
    CHECK(of("--material steel --material2 aluminium")["impedance2_Rayl"] == 2700.0 * 6420.0);
    CHECK(of("--material steel --impedance2 '17 MRayl'")["impedance2_Rayl"] == 17e6);
    using test::check_refused;
    const std::string call = "ultrasound --stiffness '1 GPa/um' --frequency '7 MHz' ";
    check_refused(call + "--material PEEK", 3, {"--material = \"PEEK\"", "no known speed of sound", "--impedance"});
    check_refused(call + "--material Stahl", 3, {"--material = \"Stahl\"", "did you mean \"steel\"?", "--impedance"});
    check_refused(call + "--material steel --impedance '46 MRayl'", 2, {"--material", "--impedance", "one of the two"});
    check_refused(call + "--impedance '46 MRayl' --wave shear", 2, {"--wave", "--material"});
    check_refused(call + "--impedance '46 MRayl' --lower-impedance '17 MRayl'", 2, {"did you mean --impedance2?"});
    check_refused(call + "--impedance '46 MRayl' --lower-material steel", 2, {"did you mean --material2?"});
    check_refused(call + "--upper-impedance '46 MRayl'", 2, {"did you mean --impedance?"});
}

TEST_CASE("The option --plot of ultrasound draws K of a file with its numbers, and of nothing else") {
    const test::Folder folder;
    const std::string table = "f [MHz],R,error\n2,0.5,0.01\n5,0.82,0.01\n10,0.943,0.01\n", picture = folder / "k.svg";
    const auto outcome = test::run_fstiff("ultrasound --reflection - --plot '" + picture + "'" + steel, table);
    CHECK(outcome.status == 0);
    CHECK(test::contains(test::read(picture), "K of a spring does not depend on the frequency"));
    const test::Csv numbers(test::read(folder / "k.plot.csv"));
    CHECK(test::contains(test::read(folder / "k.plot.csv"), "frequency f [MHz]"));
    test::check_refused("ultrasound --reflection 0.5 --frequency '5 MHz' --plot '" + picture + "'" + steel, 2,
                        {"--plot", "--reflection FILE"});
}

}  // namespace reflection_tables_test
