// SPDX-License-Identifier: BSD-3-Clause
// The units that people read, at both sides of every limit; and that measure and run show the same.
#include "document/shown_unit.hpp"
#include "document/file.hpp"

#include "cli/command.hpp"

#include <nlohmann/json.hpp>

#include <vector>

namespace shown_unit_test {

using namespace fstiff;

namespace {

std::string length(double x) { return document::unit_of_length(x)(x); }
std::string density(double x) { return document::unit_of_density(x)(x); }
std::string pressure(double x) { return document::unit_of_pressure(x)(x); }

}  // namespace

TEST_CASE("A value is shown in the unit of its size") {
    CHECK(length(0) == "0 µm");
    CHECK(length(1.2e-14) == "1.2e-14 m");
    CHECK(length(1.1e-11) == "0.011 nm");
    CHECK(length(-0.99e-7) == "-99 nm");
    CHECK(length(1.01e-7) == "0.101 µm");
    CHECK(length(0.999e-3) == "999 µm");
    CHECK(length(1.001e-3) == "1.001 mm");
    CHECK(length(1.5) == "1.5 m");
    CHECK(density(500e6) == "500 /mm²");
    CHECK(density(0.99e11) == "99000 /mm²");
    CHECK(density(1.34e12) == "1.34 /µm²");
    CHECK(pressure(99) == "99 Pa");
    CHECK(pressure(101) == "0.101 kPa");
    CHECK(pressure(0.99e5) == "99 kPa");
    CHECK(pressure(1e5) == "0.1 MPa");
    CHECK(pressure(0.99e9) == "990 MPa");
    CHECK(pressure(205e9) == "205 GPa");
    CHECK(document::with_unit(2.5e15, "Pa/m") == "2.5 GPa/µm");
    CHECK(document::with_unit(7.39e13, "Pa/m") == "73.9 MPa/µm");
    CHECK(document::shown_unit(3e-8, "m").name == "nm");
    CHECK(document::shown_unit(3e12, "/m^2").name == "/µm²");
    CHECK(document::shown_unit(0.5, "")(0.5) == "0.5");
    CHECK(document::with_unit(0.832e-6, "m", 5, 0.08e-6) == "0.832 ± 0.08 µm");
    CHECK(document::with_unit(123456, "") == "123460");
    CHECK(document::with_unit(5e9, "1/m^2") == "5000 /mm²");
    CHECK(document::with_unit(0.5e-12, "m^2") == "0.5 µm²");
    CHECK(document::with_unit(7e6, "Hz") == "7 MHz");
    CHECK(document::shown_unit(2e-4, "m along").name == "mm");
    CHECK(document::shown_unit(0.99e13, "Pa/m").name == "MPa/µm");
    CHECK(document::shown_unit(std::vector<double>{2e12, 3e13, 2e15}, "Pa/m").name == "MPa/µm");
    CHECK(document::shown_unit(std::vector<double>{2e15, 3e16, 2e12}, "Pa/m").name == "GPa/µm");
    CHECK(document::unit_of_density(1).heading("contacts") == "contacts [1/m²]");
    CHECK(document::ShownUnit{}.heading("eta") == "eta");
}

TEST_CASE("A rounded number has no exponent below 1e5") {
    CHECK(document::rounded(112, 2) == "110");
    CHECK(document::rounded(99.9, 2) == "100");
    CHECK(document::rounded(-1234, 2) == "-1200");
    CHECK(document::rounded(99999, 1) == "1e+05");
    CHECK(document::rounded(56789, 3) == "56800");
    CHECK(document::rounded(123456, 5) == "1.2346e+05");
    CHECK(document::rounded(0.00001, 2) == "1e-05");
    CHECK(document::rounded(1.8e38, 2) == "1.8e+38");
    CHECK(document::rounded(0.5, 2) == "0.5");
}

TEST_CASE("measure and run show a fine map in the same units") {
    const test::Folder folder;
    const std::string map = folder.write(
        "fine.txt",
        test::run_fstiff("generate map --points 256 --spacing '5 nm' --hurst 0.8 --rms '3 nm' --shortest '40 nm' "
                         "--longest '160 nm' --seed 4")
            .out);
    const auto measured = test::run_fstiff("measure '" + map + "' -o '" + folder / "fine.json" + "'");
    const auto table = test::run_fstiff("measure '" + map + "' --format table");
    const auto run =
        test::run_fstiff("run '" FSTIFF_SCENES "/sand_blasted_fine.toml' --surface '" + folder / "fine.json" + "'");
    const auto parameters = nlohmann::json::parse(test::read(folder / "fine.json"))["surface"];
    const double sigma = parameters["rms_height"]["value"], density = parameters["peak_density"]["value"];
    CHECK(document::unit_of_length(sigma).name == "nm");
    CHECK(test::contains(run.out, "sigma " + length(sigma) + ", "));
    CHECK(test::contains(table.out, document::unit_of_length(sigma)(sigma).substr(0, 6)));
    CHECK(test::contains(table.out, " nm "));
    CHECK(test::contains(run.out, "D_p " + document::unit_of_density(density)(density).substr(0, 2)));
    CHECK(test::contains(table.out, std::string(document::unit_of_density(density).name)));
    CHECK(measured.status == run.status);
}

}  // namespace shown_unit_test
