// SPDX-License-Identifier: BSD-3-Clause
// One description of an answer, in three forms. Truth: what the description gives to each.
#include "document/document.hpp"

#include "support/catch.hpp"
#include "support/csv.hpp"
#include "support/library.hpp"

#include <string>
#include <vector>

namespace document_test {

using fstiff::document::Document;
using fstiff::document::Format;
using fstiff::document::Rows;

TEST_CASE("A fact that is added to a document is in its text, its CSV and its JSON") {
    Document document("ultrasound", 11);
    document.facts("frequency", {{"frequency_Hz", 7e6, "", 1e-6, " MHz"}});
    document.facts("gap", {{"gap_m", 2.5e-7, "", 1e9, " nm"}, {"gap_error_m", 1e-8}});
    CHECK(document.str(Format::table) == "  frequency  7 MHz\n  gap        250 nm\n");
    const test::Csv csv(document.str(Format::csv));
    CHECK(csv.header() == std::vector<std::string>{"frequency_Hz", "gap_m", "gap_error_m"});
    CHECK(csv.number(0, "gap_m") == 2.5e-7);
    const auto json = nlohmann::json::parse(document.str(Format::json));
    CHECK(json.at("command") == "ultrasound");
    CHECK(json.at("gap_m") == 2.5e-7);
    CHECK(json.at("gap_error_m") == 1e-8);
    CHECK(json.at("warnings").empty());
}

TEST_CASE("No character of JSON moves a cursor, ends a line or turns the direction of writing") {
    const std::string kept = " \u00B5\u2027\u00A0\U0001F600", name =
                                                                  "a\u202E"
                                                                  "b\u2028"
                                                                  "c\x1b\x7f\xC2\x85\u2066\u200E" +
                                                                  kept;
    const std::string text = fstiff::document::Json({{"name", name}}).str();
    CHECK(text == R"({
  "name": "a\u202eb\u2028c\u001b\u007f\u0085\u2066\u200e)" +
                      kept + "\"\n}\n");
    CHECK(nlohmann::json::parse(text).at("name") == name);
}

TEST_CASE(
    "A column that is added to the table of a document is in all of its forms, and its facts are not in the CSV") {
    Document document("truth");
    document.facts("map", {{"points", 2, "", 1, " points"}});
    const std::vector<double> pressures{1e6, 2e6}, gaps{3e-7, 2e-7};
    Rows rows;
    rows.add({"pressure_Pa", "p [MPa]", 1e-6}, pressures);
    rows.add({"gap_m", "gap [nm]", 1e9}, gaps);
    document.table(std::move(rows), {.key = "rows", .as_list = true});
    document.warnings = {"the gap is small"};
    CHECK(document.str(Format::table) ==
          "  map      2 points\n  p [MPa]  gap [nm]\n        1       300\n        2       200\n"
          "warning: the gap is small\n");
    CHECK(document.str(Format::csv).starts_with("pressure_Pa,gap_m\n"));
    CHECK(test::Csv(document.str(Format::csv)).number(1, "gap_m") == 2e-7);
    const auto json = nlohmann::json::parse(document.str(Format::json));
    CHECK(json.at("points") == 2);
    CHECK(json.at("rows").at(1).at("gap_m") == 2e-7);
    CHECK(json.at("warnings").at(0) == "the gap is small");
}

TEST_CASE("A part that is a function is called for its own form alone") {
    Document document("run");
    int text = 0, values = 0, rows = 0;
    document.text([&] { return ++text, "K\n"; });
    document.values([&](fstiff::document::Json& to) { to["K"] = ++values; });
    document.csv([&] {
        Rows all;
        all.repeat({"K"}, ++rows, 1);
        return all;
    });
    CHECK(nlohmann::json::parse(document.str(Format::json)).at("K") == 1);
    CHECK((text == 0 && values == 1 && rows == 0));
    CHECK(document.str(Format::csv) == "K\n1\n");
    CHECK(document.str(Format::table) == "K\n");
    CHECK((text == 1 && values == 1 && rows == 1));
}

TEST_CASE("People read some 24 rows of a long table, and how many there are") {
    Document document("fit");
    const std::vector<int> lags(100, 7);
    Rows rows;
    rows.add({"lag", "lag"}, lags);
    document.table(std::move(rows), {.thinned = "lags"});
    const std::string text = document.str(Format::table);
    CHECK(std::count(text.begin(), text.end(), '7') == 20);  // every fifth
    CHECK(text.ends_with("  every 5. of 100 lags; all with --format csv\n"));
    CHECK(test::Csv(document.str(Format::csv)).size() == 100);
}

}  // namespace document_test
