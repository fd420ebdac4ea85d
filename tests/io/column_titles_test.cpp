// SPDX-License-Identifier: BSD-3-Clause
// Columns that number the points, by eye; and profiles with and without such a column, which must be the same.
#include "io/column_titles.hpp"
#include "support/samples.hpp"

namespace column_titles_test {

using namespace fstiff;
using namespace fstiff::io::detail;

namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::vector<bool> index_of(const std::string& text) {
    NumberTable table = open_table(text, "file", {.holds = "numbers"});
    read_rows(table, "file", {.holds = "numbers"});
    return index_columns(table);
}

/// \p head above 40 rows that begin with \p number(i), then position i/2 and a height, with decimal commas.
template <class Number>
std::string rows(const std::string& head, const Number& number, const std::string& separator = ";") {
    std::string text = head;
    for (int i = 0; i < 40; ++i)
        text += number(i) + std::to_string(i / 2) + (i % 2 ? ",5" : ",0") + separator + std::to_string(i * i % 11) +
                "," + std::to_string(i % 10) + "\n";
    return text;
}
std::string counted(const std::string& head, int first = 1) {
    return rows(head, [first](int i) { return std::to_string(i + first) + ";"; });
}
constexpr test::FileReader read{};
const test::RefusalOf refusal(read);

}  // namespace

TEST_CASE("A column that numbers the points is neither positions nor heights", "[index]") {
    const Profile<double> truth = read(rows("X [um];Z [um]\n", [](int) { return std::string(); })).profile();
    REQUIRE(truth.size() == 40);
    for (const char* head :
         {"Nr.;X [um];Z [um]\n", "No.;X [um];Z [um]\n", "N\xC2\xB0;X [um];Z [um]\n", "#;X [um];Z [um]\n",
          "Index;X [um];Z [um]\n", "Point;X [um];Z [um]\n", "Punkt;X [um];Z [um]\n", "\"Nr.\";\"X [um]\";\"Z [um]\"\n",
          ";X [um];Z [um]\n", "Data;X [um];Z [um]\n", "# Nr.;X [um];Z [um]\n", "Nr.;X;Z\n;um;um\n",
          "Nr.;X;Z\n[-];[um];[um]\n", "Lfd. Nr.;Horizontal [\xC2\xB5m];Vertikal [Mikrometer]\n",
          "Nr. [-];X [um];Z [um]\n"}) {
        CAPTURE(head);
        for (const int first : {0, 1}) {
            const io::Surface found = read(counted(head, first));
            REQUIRE(found.is_profile());
            CHECK(found.profile().heights == truth.heights);
            CHECK(found.profile().spacing == truth.spacing);
            CHECK(has(found.record.sentences()[3], "positions in column 2, column 1 numbers the points"));
        }
    }
    for (const char* head : {"Nr. X [um] Z [um]\n", "No X(um) Z(um)\n", "# Index X_um Z_um\n"}) {
        CAPTURE(head);
        const io::Surface found = read(rows(
            head, [](int i) { return std::to_string(i + 1) + " "; }, " "));
        CHECK((found.is_profile() && found.profile().heights == truth.heights &&
               found.profile().spacing == truth.spacing));
    }
    // a title alone may number points in steps, and from anywhere
    const io::Surface third =
        read(rows("Nr.;X [um];Z [um]\n", [](int i) { return std::to_string(3 * i + 101) + ";"; }));
    CHECK(third.profile().spacing == truth.spacing);
    // units of the options, and a column that is chosen
    for (const io::SurfaceOptions& options :
         {io::SurfaceOptions{.units = "um"}, io::SurfaceOptions{.units = "um", .column = 3},
          io::SurfaceOptions{.column = 3}, io::SurfaceOptions{.column = 3, .x_column = 2},
          io::SurfaceOptions{.x_column = 2}})
        CHECK(read(counted("Nr.;X [um];Z [um]\n"), options).profile().spacing == truth.spacing);
}

TEST_CASE("Numbers of points are positions where they are chosen or named so", "[index]") {
    const std::string text = counted("Nr.;X [um];Z [um]\n");
    CHECK(test::relative_error(read(text, {.units = "mm,um", .column = 3, .x_column = 1}).profile().spacing, 1e-3) <
          1e-12);
    std::string two = "x [um];z [um]\n", bare = "1;2,5\n", nr = "Nr.;z [um]\n";
    for (int i = 0; i < 30; ++i) {
        const std::string row = std::to_string(i + 1) + ";" + std::to_string(i * i % 7) + ",5\n";
        two += row, nr += row;
        if (i > 0) bare += row;
    }
    CHECK(test::relative_error(read(two).profile().spacing, 1e-6) < 1e-12);
    CHECK(test::relative_error(read(bare, {.units = "um"}).profile().spacing, 1e-6) < 1e-12);
    const std::string why = refusal(nr, {.units = "um"});
    CHECK(has(why,
              "has no column of positions (column 1 numbers the points; to use it as positions, give x_column = 1)"));
    CHECK(has(why, "spacing = \"0.5 um\""));
    CHECK(read(nr, {.spacing = 2e-6}).profile().spacing == 2e-6);
    CHECK(test::relative_error(read(nr, {.units = "um", .x_column = 1}).profile().spacing, 1e-6) < 1e-12);
}

TEST_CASE("A first column that counts next to equal steps is refused without titles", "[index]") {
    const std::string text = counted("");
    CHECK(has(refusal(text, {.units = "um", .column = 3}),
              "counts the points in column 1, and column 2 rises in equal steps: either may hold the positions; give "
              "x_column"));
    CHECK(test::relative_error(read(text, {.units = "um", .column = 3, .x_column = 2}).profile().spacing, 5e-7) <
          1e-12);
    CHECK(test::relative_error(read(text, {.units = "um", .column = 3, .x_column = 1}).profile().spacing, 1e-6) <
          1e-12);
}

TEST_CASE("The column of the positions is refused where it cannot be", "[index]") {
    const std::string text = counted("Nr.;X [um];Z [um]\n");
    CHECK(has(refusal(text, {.x_column = 4}), "x_column = 4: must be between 1 and 3"));
    CHECK(has(refusal(text, {.column = 2, .x_column = 2}),
              "x_column = 2: must be another column than that of the heights"));
    CHECK(has(refusal(text, {.spacing = 1e-6, .x_column = 2}), "spacing and x_column are both given"));
    CHECK(
        has(refusal(text, {.units = "um", .x_column = 9, .names = {.prefix = "--", .equals = " "}}), "--x-column = 9"));
    CHECK(has(refusal("aISO-1.0\n", {.x_column = 1}), "no use for x-column"));
}

TEST_CASE("Which columns number the points follows from titles and numbers", "[index]") {
    const auto text = [](const std::string& head, int step, double share) {
        std::string all = head + "\n";
        for (int i = 0; i < 9; ++i)
            all += std::to_string(1 + step * i) + (share > 0 ? ".5" : "") + ",0." + std::to_string(i) + "\n";
        return all;
    };
    const std::vector<bool> first{true, false}, none;
    CHECK(index_of(text("No.,z [um]", 1, 0)) == first);
    CHECK(index_of(text("No.,z [um]", 2, 0)) == first);
    CHECK(index_of(text("No.,z [um]", -1, 0)) == none);   // falls
    CHECK(index_of(text("No.,z [um]", 1, 0.5)) == none);  // no whole numbers
    CHECK(index_of(text("No. [um],z [um]", 1, 0)) == none);
    CHECK(index_of(text("Data,z [um]", 1, 0)) == first);
    CHECK(index_of(text("Data,z [um]", 2, 0)) == none);
    CHECK(index_of(text("Data,Value", 1, 0)) == none);  // nothing names a length
    CHECK(index_of(text("Data,Height", 1, 0)) == first);
    CHECK(index_of(text("Position,z [um]", 1, 0)) == none);
    CHECK(index_of(text("x,z [um]", 1, 0)) == none);
    CHECK(index_of(text("", 1, 0)) == none);
}

TEST_CASE("Triples may be next to a column that numbers them", "[index]") {
    std::string plain = "x [um],y [um],z [nm]\n", numbered = "Nr.,x [um],y [um],z [nm]\n";
    for (int i = 0; i < 60; ++i) {
        const std::string row =
            std::to_string(i % 10) + "," + std::to_string(i / 10) + "," + std::to_string(i * i % 13) + "\n";
        plain += row;
        numbered += std::to_string(i + 1) + "," + row;
    }
    const io::Surface found = read(numbered);
    CHECK((found.map().heights == read(plain).map().heights).all());
    CHECK(found.map().dx == read(plain).map().dx);
    CHECK(found.record.sentences().back() == "columns: x, y and heights in 2, 3, 4; left out: 1");
}

}  // namespace column_titles_test
