// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/io/quantities.hpp>
#include <fstiff/io/units.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <clocale>
#include <cstdlib>
#include <numbers>
#include <string>
#include <vector>

namespace quantity_test {

using namespace fstiff;
using io::Dimension;

TEST_CASE("A quantity is the correctly rounded SI value of what is written") {
    // The compiler's own conversion of the literal is the second source; powers of ten must agree to the last bit.
    CHECK(io::parse_quantity("0.832 um", Dimension::length, "x") == 0.832e-6);
    CHECK(io::parse_quantity("5.3um", Dimension::length, "x") == 5.3e-6);
    CHECK(io::parse_quantity("  1.2e-8 m ", Dimension::length, "x") == 1.2e-8);
    CHECK(io::parse_quantity("1.7E+2 nm", Dimension::length, "x") == 170e-9);
    CHECK(io::parse_quantity("-3 mm", Dimension::length, "x") == -3e-3);
    CHECK(io::parse_quantity("+.5 mm", Dimension::length, "x") == 0.5e-3);
    CHECK(io::parse_quantity("500 /mm^2", Dimension::inverse_area, "x") == 500e6);
    CHECK(io::parse_quantity("195 mm^2", Dimension::area, "x") == 195e-6);
    CHECK(io::parse_quantity("205 GPa", Dimension::pressure, "x") == 205e9);
    CHECK(io::parse_quantity("0.1 N/mm^2", Dimension::pressure, "x") == 0.1e6);
    CHECK(io::parse_quantity("7 MHz", Dimension::frequency, "x") == 7e6);
    CHECK(io::parse_quantity("5.9 km/s", Dimension::velocity, "x") == 5.9e3);
    CHECK(io::parse_quantity("7.8 g/cm^3", Dimension::density, "x") == 7.8e3);
    CHECK(io::parse_quantity("46 MRayl", Dimension::impedance, "x") == 46e6);
    CHECK(io::parse_quantity("46e6 kg/(m^2 s)", Dimension::impedance, "x") == 46e6);
    CHECK(io::parse_quantity("1.764 GPa/um", Dimension::stiffness_per_area, "x") == 1.764e15);
    CHECK(io::parse_quantity("1 N/m^3", Dimension::stiffness_per_area, "x") == 1.0);
    CHECK(test::ulps(io::parse_quantity("3 in", Dimension::length, "x"), 0.0762) <= 2);
    CHECK(test::ulps(io::parse_quantity("1 psi", Dimension::pressure, "x"), 6894.757293168361) <= 2);
}

TEST_CASE("A comma in a number is named as what is wrong with it") {
    const std::string why = "has a comma; the decimal mark is the point, as in 0.8";
    CHECK(test::refusal([&] { (void)io::parse_quantity("0,8 um", Dimension::length, "x"); }) ==
          "x = \"0,8 um\": " + why);
    CHECK(test::refusal([&] { (void)io::parse_number("0,25", "x"); }) == "x = \"0,25\": " + why);
    CHECK(test::refusal([&] { (void)io::parse_angle("0,7 rad", "x"); }) == "x = \"0,7 rad\": " + why);
    CHECK(test::refusal([&] { (void)io::parse_quantity("1 um,2", Dimension::length, "x"); }).find("comma") ==
          std::string::npos);
}

TEST_CASE("An angle is read as a fraction of pi, with a unit, or in radians") {
    constexpr double pi = std::numbers::pi;
    CHECK(io::parse_angle("pi/4", "theta") == pi / 4);
    CHECK(io::parse_angle("pi / 3", "theta") == pi / 3);
    CHECK(io::parse_angle("2*pi/7", "theta") == 2 * pi / 7);
    CHECK(io::parse_angle("0.25 pi", "theta") == 0.25 * pi);
    CHECK(io::parse_angle("0.25pi", "theta") == 0.25 * pi);
    CHECK(io::parse_angle("-pi", "theta") == -pi);
    CHECK(io::parse_angle("\xCF\x80/3", "theta") == pi / 3);
    CHECK(io::parse_angle("0.7 rad", "theta") == 0.7);
    CHECK(io::parse_angle("0.7", "theta") == 0.7);
    CHECK(test::ulps(io::parse_angle("45 deg", "theta"), pi / 4) <= 2);
    CHECK(test::ulps(io::parse_angle("60\xC2\xB0", "theta"), pi / 3) <= 2);
    CHECK(io::parse_quantity("pi/4", Dimension::angle, "theta") == pi / 4);
    for (const std::string text : {"", "pie", "pi/", "pi/0", "pi/4 deg", "45 m", "inf", "nan", "pi pi", "1e400",
                                   "1e308 pi", "pi/1e-320", "2*", "/4", "pi*2"}) {
        CAPTURE(text);
        const std::string refusal = test::refusal([&] { (void)io::parse_angle(text, "theta"); });
        CHECK(refusal.find("theta = \"" + text + "\"") != std::string::npos);
    }
}

TEST_CASE("A number without a unit is refused with the units that it may have") {
    const std::string refusal =
        test::refusal([] { (void)io::parse_quantity("0.832", Dimension::length, "rms_height"); });
    CHECK(refusal.find("rms_height = \"0.832\"") != std::string::npos);
    CHECK(refusal.find("number without a unit") != std::string::npos);
    CHECK(refusal.find("m, mm, um, nm") != std::string::npos);
}

TEST_CASE("Text without a finite number and a unit of the dimension is refused by name and value and units") {
    for (const std::string text :
         {"", " ", "um", "inf um", "nan um", "-inf um", "0x10 um", "1,5 um", "1e400 um", "1e308 km", "1e-400 um",
          "1 um 2", "1 GPa", "- 1 um", "--1 um", "+-1 um", ". um", "1e um", "1..2 um"}) {
        CAPTURE(text);
        const std::string refusal =
            test::refusal([&] { (void)io::parse_quantity(text, Dimension::length, "rms_height"); });
        CHECK(refusal.find("rms_height = \"" + text + "\"") != std::string::npos);
    }
    const std::string unit = test::refusal([] { (void)io::unit_factor("parsec", Dimension::length); });
    CHECK(unit.find("parsec") != std::string::npos);
    CHECK(unit.find("um") != std::string::npos);
}

TEST_CASE("A plain number is read whole or refused") {
    CHECK(io::parse_number(" 1e-3 ", "x") == 1e-3);
    CHECK(io::parse_number("-0.5", "x") == -0.5);
    for (const std::string text : {"", "1 2", "1m", "inf", "nan", "1e999", "0x1", "1,5"}) {
        CAPTURE(text);
        CHECK_FALSE(test::refusal([&] { (void)io::parse_number(text, "x"); }).empty());
    }
}

TEST_CASE("The decimal sign is the point in every locale") {
    const std::string before = std::setlocale(LC_ALL, nullptr);
    for (const char* locale : {"de_DE.UTF-8", "fr_FR.UTF-8", "C"}) {
        if (!std::setlocale(LC_ALL, locale)) continue;
        CHECK(io::parse_quantity("0.832 um", Dimension::length, "x") == 0.832e-6);
    }
    std::setlocale(LC_ALL, before.c_str());
}

}  // namespace quantity_test
