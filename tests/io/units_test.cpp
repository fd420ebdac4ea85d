// SPDX-License-Identifier: BSD-3-Clause
// Units in every spelling; the compiler's own conversion of a literal is the second source.
#include <fstiff/io/quantities.hpp>
#include <fstiff/io/units.hpp>
#include "io/unit_table.hpp"

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <numbers>
#include <string>

namespace units_test {

using namespace fstiff;
using io::Dimension;

TEST_CASE("The micro sign, powers and products may be spelt in every usual way") {
    for (const std::string unit : {"um", "\xC2\xB5m", "\xCE\xBCm", "\xB5m", "micron", "Micrometer", "micrometres"}) {
        CAPTURE(unit);
        CHECK(io::unit_factor(unit, Dimension::length) == 1e-6);
    }
    for (const std::string unit :
         {"/mm^2", "1/mm^2", "1 / mm^2", "mm^-2", "/mm2", "1/mm\xC2\xB2", "mm\xE2\x81\xBB\xC2\xB2"}) {
        CAPTURE(unit);
        CHECK(io::unit_factor(unit, Dimension::inverse_area) == 1e6);
    }
    for (const std::string unit : {"mm^2", "mm2", "mm\xC2\xB2", "mm\xB2"}) {
        CAPTURE(unit);
        CHECK(io::unit_factor(unit, Dimension::area) == 1e-6);
    }
    for (const std::string unit :
         {"kg/(m^2 s)", "kg/(m\xC2\xB2\xC2\xB7s)", "kg/(m2*s)", "kg/m^2/s", "Rayl", "Pa s/m"}) {
        CAPTURE(unit);
        CHECK(io::unit_factor(unit, Dimension::impedance) == 1.0);
    }
    CHECK(io::is_unit("GPa/\xC2\xB5m", Dimension::stiffness_per_area));
    CHECK_FALSE(io::is_unit("Pa", Dimension::stiffness_per_area));
    CHECK_FALSE(io::is_unit("m m", Dimension::length));
    CHECK_FALSE(io::is_unit("", Dimension::length));
    CHECK_FALSE(io::is_unit("mpa", Dimension::pressure));
}

TEST_CASE("Every unit of the table is accepted and means its factor") {
    for (const auto& unit : io::detail::units) {
        CAPTURE(std::string(unit.name));
        const double factor = io::unit_factor(unit.name, unit.dimension);
        // an independent power of ten
        CHECK(test::ulps(factor, unit.factor * std::pow(10.0, unit.exponent)) <= 2);
        if (unit.dimension == Dimension::angle) continue;
        CHECK(test::ulps(io::parse_quantity("2.5 " + std::string(unit.name), unit.dimension, "x"), 2.5 * factor) <= 2);
    }
}

TEST_CASE("Inches in thousands and millionths, and words in other languages, are units") {
    for (const char* unit : {"mil", "mils", "thou"})
        CHECK(test::ulps(io::unit_factor(unit, Dimension::length), 25.4e-6) <= 1);
    for (const char* unit : {"uin", "\xC2\xB5in", "microinch", "Microinches"})
        CHECK(test::ulps(io::unit_factor(unit, Dimension::length), 25.4e-9) <= 1);
    CHECK(test::ulps(io::unit_factor("inches", Dimension::length), 25.4e-3) <= 1);
    for (const char* unit : {"Mikrometer", "mikrometer", "microm\xC3\xA8tre", "Microm\xC3\xA8tres"})
        CHECK(io::unit_factor(unit, Dimension::length) == 1e-6);
    // the message lists every unit that is read
    const std::string why = test::refusal([] { (void)io::unit_factor("parsec", Dimension::length); });
    CHECK(why.find("allowed are m, km, cm, mm, um, nm, angstrom, pm, in, mil, uin") != std::string::npos);
}

TEST_CASE("Any blank may separate a number and its unit") {
    for (const std::string blank : {" ", "\t", "\xC2\xA0", "\xE2\x80\x89", "\xE2\x80\xAF", "\xE2\x80\x87",
                                    "\xE3\x80\x80", "\xA0", " \xC2\xA0 "}) {
        CAPTURE(blank);
        CHECK(io::parse_quantity("0.8" + blank + "\xC2\xB5m", Dimension::length, "x") == 0.8e-6);
        CHECK(io::is_unit(blank + "mm" + blank, Dimension::length));
    }
    CHECK_THROWS_AS(io::parse_quantity("0.8 \xE2\x80\xA6 um", Dimension::length, "x"), domain_error);
    CHECK_THROWS_AS(io::parse_quantity("0.8\xC2\xA0", Dimension::length, "x"), domain_error);
}

}  // namespace units_test
