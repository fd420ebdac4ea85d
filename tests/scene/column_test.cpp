// SPDX-License-Identifier: BSD-3-Clause
// Columns: names, units and headings of every quantity; CSV and JSON of any bytes. Truth: lists by hand, nlohmann.
#include "actions/run.hpp"

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/library.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>

namespace column_test {

using namespace fstiff;

TEST_CASE("Every quantity of a curve has its key, its unit and its heading") {
    struct Expected {
        std::string word, key, band_key, unit, heading;
    };
    const std::vector<Expected> all{
        {"force", "force_N", "force_p05_N", "N", "F [kN]"},
        {"pressure", "pressure_Pa", "pressure_p05_Pa", "Pa", "p [MPa]"},
        {"eta", "eta", "eta_p05", "", "eta"},
        {"separation", "separation_m", "separation_p05_m", "m", "separation [µm]"},
        {"approach", "approach_m", "approach_p05_m", "m", "approach [µm]"},
        {"stiffness", "stiffness_Pa_per_m", "stiffness_p05_Pa_per_m", "Pa/m", "K/A0 [MPa/µm]"},
        {"stiffness_of_faces", "stiffness_of_faces_Pa_per_m", "stiffness_of_faces_p05_Pa_per_m", "Pa/m",
         "K/A0 of faces [MPa/µm]"},
        {"touching_share", "touching_share", "touching_share_p05", "", "touching"},
        {"local_pressure", "greatest_local_pressure_Pa", "greatest_local_pressure_p05_Pa", "Pa", "greatest p [MPa]"},
        {"joint_stiffness", "stiffness_N_per_m", "stiffness_p05_N_per_m", "N/m", "K [kN/µm]"},
        {"loading_stiffness", "loading_stiffness_Pa_per_m", "loading_stiffness_p05_Pa_per_m", "Pa/m",
         "-dp/dd [MPa/µm]"},
        {"tangential_stiffness", "tangential_stiffness_Pa_per_m", "tangential_stiffness_p05_Pa_per_m", "Pa/m",
         "Kt/A0 [MPa/µm]"},
        {"loss_factor", "loss_factor", "loss_factor_p05", "", "loss factor"},
        {"reflection", "reflection", "reflection_p05", "", "|R|"},
        {"shear_reflection", "shear_reflection", "shear_reflection_p05", "", "shear |R|"},
        {"thermal_conductance", "thermal_conductance_W_per_m2K", "thermal_conductance_p05_W_per_m2K", "W/(m^2 K)",
         "h [W/(m² K)]"},
        {"thermal_conductance_gap", "thermal_conductance_gap_W_per_m2K", "thermal_conductance_gap_p05_W_per_m2K",
         "W/(m^2 K)", "h of the gap [W/(m² K)]"},
        {"electrical_conductance", "electrical_conductance_S_per_m2", "electrical_conductance_p05_S_per_m2", "S/m^2",
         "electrical h [S/m²]"},
        {"thermal_resistance", "thermal_resistance_K_per_W", "thermal_resistance_p05_K_per_W", "K/W",
         "thermal resistance [K/W]"},
        {"resistance", "resistance_ohm", "resistance_p05_ohm", "ohm", "resistance [ohm]"},
        {"real_area", "real_area_fraction", "real_area_fraction_p05", "", "real area"},
        {"spot_pressure", "spot_pressure_Pa", "spot_pressure_p05_Pa", "Pa", "p of the contacts [MPa]"},
        {"contacts", "contacts_per_m2", "contacts_p05_per_m2", "1/m^2", "contacts [1/mm²]"}};
    REQUIRE(answer_quantities().size() == all.size());
    const actions::Units units{
        {"Pa", fstiff::document::unit_of_pressure(3e6)},   {"m", fstiff::document::unit_of_length(1e-6)},
        {"1/m^2", fstiff::document::unit_of_density(5e8)}, {"Pa/m", fstiff::document::shown_unit(5e14, "Pa/m")},
        {"N", fstiff::document::shown_unit(2e4, "N")},     {"N/m", fstiff::document::shown_unit(5e10, "N/m")}};
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Expected& one = all[i];
        INFO(one.key);
        const AnswerQuantity& quantity = answer_quantities()[i];
        CHECK(quantity.word == one.word);
        CHECK(quantity.key() == one.key);
        CHECK(quantity.key("_p05") == one.band_key);
        CHECK(quantity.unit == one.unit);
        CHECK(actions::heading_of({&quantity}, units).shown == one.heading);
        CHECK(actions::heading_of({&quantity}, units).key == one.key);
        const std::size_t bracket = one.heading.find(" [");
        const std::string unit = bracket == std::string::npos ? "" : one.heading.substr(bracket);
        CHECK(actions::heading_of({&quantity, "_p05"}, units).shown == "5 %" + unit);
    }
    const auto heading = [&](const char* word, std::string_view part = "") {
        return actions::heading_of({&detail::quantity_called(word), part}, units);
    };
    CHECK(heading("separation").factor == 1e6);
    CHECK(heading("stiffness", "_error").shown == "numerical error [Pa/m]");
    CHECK(heading("reflection", "_error").shown.empty());
}

TEST_CASE("The numbers of a point are its state, and the band of a reflection is that of K turned round") {
    scene::Scene scene = test::scene_of(
        "[surface]\nrms_height = \"1 um\"\npeak_radius = \"60 um\"\npeak_density = \"500 /mm^2\"\n"
        "errors = { rms_height = \"0.1 um\" }\n"
        "[material.upper]\nyoungs_modulus = \"200 GPa\"\npoisson_ratio = 0.25\n"
        "[contact]\npressures = [\"1 MPa\"]\nnominal_area = \"2 cm^2\"\nlaws = [\"hertz\", \"proportional\"]\n"
        "[ultrasound]\nfrequency = \"5 MHz\"\nupper = { impedance = \"46 MRayl\" }\n"
        "[output]\nquantities = [\"stiffness\", \"reflection\", \"tangential_stiffness\", \"joint_stiffness\", "
        "\"approach\"]\n");
    constexpr double ratio = 2 * (1 - 0.25) / (2 - 0.25);  // of two equal bodies, by Mindlin
    const actions::Answered found = actions::compute(scene);
    const AnswerCurve& curve = found.curves().front();
    const AnswerPoint& point = curve.points.front();
    const double K = point.state.stiffness.value, error = point.state.stiffness.error, low = point.stiffness.low,
                 high = point.stiffness.high;
    REQUIRE(low < 0.95 * K);
    REQUIRE(high > 1.05 * K);
    const auto at = [&](const char* word, std::string_view part = "") {
        return test::value_at(curve, 0, word, part).value();
    };
    CHECK(test::relative_error(at("pressure"), 1e6) < 1e-12);
    CHECK(at("stiffness") == K);
    CHECK(at("stiffness", "_p05") == low);
    CHECK(at("joint_stiffness") == K * 2e-4);
    CHECK(at("joint_stiffness", "_p95") == high * 2e-4);
    CHECK(at("joint_stiffness", "_error") == error * 2e-4);
    CHECK(at("approach") > 0);
    CHECK(!test::value_at(curve, 0, "approach", "_p05"));
    CHECK(!test::value_at(curve, 0, "force"));
    CHECK(test::relative_error(at("tangential_stiffness", "_p95"), ratio * high) < 1e-15);
    CHECK(test::relative_error(at("tangential_stiffness", "_error"), ratio * error) < 1e-15);
    const auto reflected = [](double k) { return 1 / std::hypot(1, 2 * k / (2 * std::acos(-1.0) * 5e6 * 46e6)); };
    CHECK(test::relative_error(at("reflection"), reflected(K)) < 1e-14);
    CHECK(test::relative_error(at("reflection", "_p05"), reflected(high)) < 1e-14);
    CHECK(test::relative_error(at("reflection", "_p95"), reflected(low)) < 1e-14);
    CHECK(!test::value_at(curve, 1, "pressure"));
    CHECK(!test::value_at(curve, 0, "separation"));
    CHECK(scene.columns(false).size() == scene.columns(true).size() - 8);
    // both laws have the same columns
    const auto rows = actions::point_rows(scene, found.curves()[1], true);
    CHECK(rows.columns().size() == actions::point_rows(scene, curve, true).columns().size());
}

TEST_CASE("A line of CSV is as RFC 4180 has it") {
    CHECK(fstiff::document::csv_line({"plain", "", "b,c.csv", "5\" pipe", "\"all\"", " kept ", "a\"\"b", ","}) ==
          R"(plain,,"b,c.csv","5"" pipe","""all""", kept ,"a""""b",",")"
          "\n");
    CHECK(fstiff::document::csv_line({"one"}) == "one\n");
    CHECK(fstiff::document::csv_line({"two\nlines", ""}) == "\"two\nlines\",\n");

    document::Rows rows =
        document::Rows::under({{"name", "name"}, {"length_m", "length [mm]", 1e3, 2}, {.key = "count", .csv = false}});
    rows.add_row({"a,b", 0.0125, 3});
    rows.add_row({"c", document::Cell(), 4});
    CHECK(rows.csv() == "name,length_m\n\"a,b\",0.012500000000000001\nc,\n");
    CHECK(rows.table() == document::TextRows{{"name", "length [mm]"}, {"a,b", "12"}, {"c", "-"}});
    document::Json list;
    rows.append_to(list);
    const auto parsed = nlohmann::json::parse(list.str());
    CHECK(parsed[0] == nlohmann::json{{"name", "a,b"}, {"length_m", 0.0125}, {"count", 3}});
    CHECK(!parsed[1].contains("length_m"));
}

TEST_CASE("A JSON document is valid whatever its bytes are, and numbers are finite") {
    const auto read = [](const std::string& bytes) {
        return nlohmann::json::parse(fstiff::document::json_text(bytes)).get<std::string>();
    };
    const std::string plain = "a \"b\" \\ \n\t \x7f \xC2\x85 5 \xC2\xB5m \xE2\x80\x93 \xF0\x9F\x94\xA9";
    CHECK(read(plain) == plain);
    CHECK(fstiff::document::json_text("\x7f\xC2\x85\x01") == "\"\\u007f\\u0085\\u0001\"");
    const std::string unknown = "\xEF\xBF\xBD";
    CHECK(read("5 \xB5m") == "5 " + unknown + "m");  // Latin-1
    CHECK(read("\xE2\x80").find(unknown) == 0);
    const auto whole = std::numeric_limits<std::uint64_t>::max();
    document::Json document{
        {"\xB5", nullptr}, {"all", {true, -3, whole, 0.1, "x"}}, {"none", document::Json::array()}, {"of", {{"a", 1}}}};
    document["of"]["b"] = document::Json(std::vector<double>{1.5, 2});
    document.update({{"all", 7}});
    CHECK(document.str() == "{\n  \"" + unknown +
                                "\": null,\n  \"all\": 7,\n  \"none\": [],\n  \"of\": {\n    \"a\": 1,\n    \"b\": "
                                "[\n      1.5,\n      2.0\n    ]\n  }\n}\n");
    CHECK(document::Json{true, -3, whole, 0.1}.str() == "[\n  true,\n  -3,\n  18446744073709551615,\n  0.1\n]\n");
    CHECK_THROWS_AS(document::Json(std::nan("")), std::logic_error);
    CHECK_THROWS_AS(document::Json(std::numeric_limits<double>::infinity()), std::logic_error);
    CHECK_THROWS(document::Json(1)["a"]);
}

}  // namespace column_test
