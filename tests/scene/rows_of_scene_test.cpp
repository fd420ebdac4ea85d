// SPDX-License-Identifier: BSD-3-Clause
// The rows of a scene: the curves of Table 1, the columns that were asked for, ranges, separations, interaction.
#include "support/library.hpp"
#include "support/table.hpp"

#include <cmath>
#include <map>

namespace rows_of_scene_test {

namespace {

const std::string four_peaks =
    "peaks = [ { theta = 0.7853981633974483, r = 0.0 }, { theta = 1.0471975511965976, r = 0.2 },"
    " { theta = 1.0471975511965976, r = 0.5 }, { theta = 1.0471975511965976, r = 0.816496580927726 } ]";
const std::string seven_pressures =
    "pressures = [\"0.1 MPa\", \"0.3 MPa\", \"1 MPa\", \"3 MPa\", \"10 MPa\", \"0.03 GPa\", \"100 N/mm^2\"]";

}  // namespace

// The table has 11 digits or better; the conversion "0.1 MPa" -> Pa is correctly rounded.
TEST_CASE("The three surfaces of Table 1 give the curves of the reference table") {
    const test::Table table("table1_curves.csv");
    const std::map<std::string, std::string> files{{"sand_blasted_fine", "sand_blasted_fine"},
                                                   {"sand_blasted_coarse", "sand_blasted_coarse"},
                                                   {"electrical_discharge", "electrical_discharge_machined"}};
    std::size_t compared = 0;
    for (const auto& entry : files) {
        const std::string surface = entry.first, file = entry.second;  // clang 14 captures no structured bindings
        const test::Csv rows = test::rows_of_scene(test::scene_with(
            file,
            {{"pressures", seven_pressures}, {"peaks", four_peaks}, {"laws", "laws = [\"fractal\", \"hertz\"]"}}));
        REQUIRE(rows.size() == 2 * 4 * 7);
        for (std::size_t i = 0; i < table.size(); ++i) {
            if (table.text(i, "surface") != surface) continue;
            const auto agrees = [&](const std::string& column, std::size_t row, const std::string& truth) {
                INFO(surface << ", row " << row << ", " << column);
                CHECK(test::relative_error<double>(rows.number(row, column),
                                                   static_cast<double>(table.number(i, truth))) < 1e-10);
            };
            for (std::size_t row = 0; row < rows.size(); ++row) {
                if (rows.number(row, "theta") != static_cast<double>(table.number(i, "theta")) ||
                    rows.number(row, "r") != static_cast<double>(table.number(i, "r")) ||
                    rows.number(row, "pressure_Pa") != static_cast<double>(table.number(i, "pressure_Pa")))
                    continue;
                agrees("stiffness_Pa_per_m", row, "stiffness_" + rows.text(row, "law") + "_Pa_per_m");
                agrees("eta", row, "eta");
                agrees("real_area_fraction", row, "real_area_fraction");
                agrees("contacts_per_m2", row, "contacts_per_m2");
                CHECK(rows.number(row, "stiffness_error_Pa_per_m") < 1e-10 * rows.number(row, "stiffness_Pa_per_m"));
                ++compared;
            }
        }
    }
    CHECK(compared == 3 * 2 * 4 * 7);
}

TEST_CASE("Only the columns that were asked for are printed") {
    const std::string always = "law,theta,r,pressure_Pa,eta";
    const std::map<std::string, std::string> columns{
        {"\"stiffness\"", ",stiffness_Pa_per_m,stiffness_error_Pa_per_m"},
        {"\"separation\"", ",separation_m"},
        {"\"real_area\"", ",real_area_fraction"},
        {"\"contacts\"", ",contacts_per_m2"},
        {"\"contacts\", \"real_area\", \"separation\", \"stiffness\"",
         ",separation_m,stiffness_Pa_per_m,stiffness_error_Pa_per_m,real_area_fraction,contacts_per_m2"}};
    for (const auto& [quantities, expected] : columns) {
        const std::string text =
            test::scene_with("sand_blasted_fine", {{"quantities", "quantities = [" + quantities + "]"}});
        const auto results = test::results_of(text);
        CHECK(test::lines(test::csv_of(results)).front() == always + expected);
        fstiff::document::Json rows;
        fstiff::actions::point_rows(*results.scene, results.curves().front(), results.has_band()).append_to(rows);
        CHECK(test::parsed(rows)[0].contains("stiffness_Pa_per_m") == test::contains(quantities, "stiffness"));
    }
}

TEST_CASE("Greenwood-Williamson leaves theta and r empty and is computed once") {
    const test::Csv rows = test::rows_of_scene(test::scene_with("sand_blasted_fine", {}));
    REQUIRE(rows.size() == 5 * 31);
    std::map<std::string, int> count;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        ++count[rows.text(i, "law")];
        CHECK(rows.text(i, "theta").empty() == (rows.text(i, "law") == "greenwood_williamson"));
        CHECK(rows.text(i, "r").empty() == (rows.text(i, "law") == "greenwood_williamson"));
    }
    CHECK(count == std::map<std::string, int>{{"fractal", 62}, {"hertz", 62}, {"greenwood_williamson", 31}});
}

TEST_CASE("A range of pressures has its ends exactly and even logarithmic steps") {
    const test::Csv rows = test::rows_of_scene(fstiff::scene::builtin_scene);
    CHECK(rows.number(0, "pressure_Pa") == 1e5);
    CHECK(rows.number(30, "pressure_Pa") == 1e8);
    // exp(log) at 1e8 costs some 20 ulp
    for (std::size_t i = 0; i <= 30; ++i)
        CHECK(test::relative_error(rows.number(i, "pressure_Pa"), 1e5 * std::pow(10.0, static_cast<double>(i) / 10)) <
              1e-14);
}

TEST_CASE("The separations of a scene give the pressures they came from") {
    const test::Csv forward =
        test::rows_of_scene(test::scene_with("sand_blasted_fine", {{"pressures", seven_pressures}}));
    // law by law the separations differ: each curve back by itself, here the first
    std::string list;
    for (std::size_t i = 0; i < 7; ++i) list += (i ? ", \"" : "\"") + forward.text(i, "separation_m") + " m\"";
    const test::Csv back =
        test::rows_of_scene(test::scene_with("sand_blasted_fine", {{"pressures", "separations = [" + list + "]"}}));
    // d ln p / d eta is 3.5 to 4.5 here: an ulp of eta is a few of p; the root is found to 1e-13
    for (std::size_t i = 0; i < 7; ++i) {
        CHECK(back.number(i, "separation_m") == forward.number(i, "separation_m"));
        CHECK(test::relative_error(back.number(i, "pressure_Pa"), forward.number(i, "pressure_Pa")) < 1e-11);
        CHECK(test::relative_error(back.number(i, "stiffness_Pa_per_m"), forward.number(i, "stiffness_Pa_per_m")) <
              1e-11);
    }
}

TEST_CASE("The law fractal_consistent is fractal at a pressure higher by the factor f") {
    // f = (2/3)(3-D)/(2-D); at equal separation K is the same and p is f times that of fractal
    const std::string separations = "separations = [\"1 um\", \"2 um\"]";
    const test::Csv rows = test::rows_of_scene(test::scene_with(
        "sand_blasted_fine", {{"pressures", separations}, {"laws", "laws = [\"fractal\", \"fractal_consistent\"]"}}));
    REQUIRE(rows.size() == 8);
    const double f = 2 * (3 - 1.62) / (3 * (2 - 1.62));
    for (std::size_t i = 0; i < 4; ++i) {
        CHECK(test::relative_error(rows.number(i + 4, "pressure_Pa"), f * rows.number(i, "pressure_Pa")) < 1e-13);
        CHECK(test::relative_error(rows.number(i + 4, "stiffness_Pa_per_m"), rows.number(i, "stiffness_Pa_per_m")) <
              1e-13);
    }
}

TEST_CASE("The length of the interaction may be named or given") {
    const auto stiffness = [](const std::string& interaction) {
        return test::rows_of_scene(
                   test::scene_with("sand_blasted_fine",
                                    {{"pressures", seven_pressures}, {"interaction", "interaction = " + interaction}}))
            .number(6, "stiffness_Pa_per_m");
    };
    const double none = stiffness("\"none\"");
    const double nominal = stiffness("{ reading = \"effective_separation\", length = \"nominal\" }");
    const double spacing = stiffness("{ reading = \"effective_separation\", length = \"peak_spacing\" }");
    CHECK(nominal < spacing);
    CHECK(spacing < none);
    CHECK(stiffness("{ reading = \"none\" }") == none);
    CHECK(stiffness("{ reading = \"effective_separation\" }") == nominal);
    // sqrt(195 mm^2) and 1/sqrt(500 /mm^2), to the 16 digits that are written here
    CHECK(test::relative_error(stiffness("{ reading = \"effective_separation\", length = \"13.96424004376894 mm\" }"),
                               nominal) < 1e-13);
    CHECK(test::relative_error(stiffness("{ reading = \"effective_separation\", length = \"44.72135954999579 um\" }"),
                               spacing) < 1e-13);
    test::check_sentence(test::refused_scene(test::scene_with(
                             "sand_blasted_fine",
                             {{"nominal_area", ""}, {"interaction", "interaction = { reading = \"as_printed\" }"}})),
                         {"contact.nominal_area", "missing"});
}

TEST_CASE("A real area above the nominal one is computed, and doubted") {
    const auto results = test::results_of(test::scene_with(
        "sand_blasted_fine", {{"pressures", "separations = [\"-30 um\"]"}, {"laws", "laws = [\"hertz\"]"}}));
    CHECK(results.doubtful);
    CHECK(results.curves()[0].points[0].state.real_area_fraction.value > 1);
    CHECK(test::contains(test::joined(results.warnings), "real area exceeds the nominal area"));
    CHECK(test::contains(test::joined(results.warnings), "separation is below 0"));
}

}  // namespace rows_of_scene_test
