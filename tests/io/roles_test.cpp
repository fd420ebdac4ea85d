// SPDX-License-Identifier: BSD-3-Clause
// Columns that number the points, by eye; and texts with such a column, which must be the same as without.
#include "io/roles.hpp"
#include "io/row_layout.hpp"
#include "support/texts.hpp"

namespace roles_test {

using namespace fstiff;
using namespace fstiff::io::detail;
using namespace test;
using io::SurfaceOptions;

namespace {

std::vector<bool> index_of(const std::string& text) {
    NumberTable table = open_table(text, "file");
    read_rows(table, "file");
    std::vector<bool> index;
    for (const Role role : first_roles(table, titles_above(table))) index.push_back(role == Role::index);
    return index;
}
/// Rows that are numbered from \p first, with decimal commas.
std::string counted(int first, const std::string& separator = ";") {
    return with_commas(lines(20, [&](int i) {
        return std::to_string(i + first) + separator + std::to_string(i / 2) + (i % 2 ? ".5" : ".0") + separator +
               height_text(i) + "\n";
    }));
}
const std::string titles = "Nr.;X [um];Z [um]\n", table = titles + counted(1);
const Decision found = profile(0.5e-6, 1e-6);

}  // namespace

TEST_CASE("A column that numbers the points is neither positions nor heights", "[index]") {
    const Decision second = profile(0.5e-6, 1e-6, {"in column 2; column 1 numbers the points"});
    for (const std::string head :
         {"Nr.;X [um];Z [um]\n", "No.;X [um];Z [um]\n", "N\xC2\xB0;X [um];Z [um]\n", "#;X [um];Z [um]\n",
          "Index;X [um];Z [um]\n", "Point;X [um];Z [um]\n", "Punkt;X [um];Z [um]\n", "\"Nr.\";\"X [um]\";\"Z [um]\"\n",
          ";X [um];Z [um]\n", "Data;X [um];Z [um]\n", "# Nr.;X [um];Z [um]\n", "Nr.;X;Z\n;um;um\n",
          "Nr.;X;Z\n[-];[um];[um]\n", "Lfd. Nr.;Horizontal [\xC2\xB5m];Vertikal [Mikrometer]\n",
          "Nr. [-];X [um];Z [um]\n"})
        check_texts({{head, head + counted(0), second}, {head, head + counted(1), second}});
    for (const std::string head : {"Nr. X [um] Z [um]\n", "No X(um) Z(um)\n", "# Index X_um Z_um\n"})
        check_text({head, head + counted(1, " "), found});
    const std::string thirds = lines(20, [](int i) {
        return std::to_string(3 * i + 101) + ";" + std::to_string(i / 2) + (i % 2 ? ",5;" : ",0;") +
               with_commas(height_text(i)) + "\n";
    });
    check_texts({
        {"no such column", "X [um];Z [um]\n" + with_commas(rows("{x};{z}\n")), found},
        {"a title alone may number points in steps, and from anywhere", titles + thirds, found},
        {"units", table, found, {.units = "um"}},
        {"units and a column", table, found, {.units = "um", .column = 3}},
        {"a column", table, found, {.column = 3}},
        {"both columns", table, found, {.column = 3, .x_column = 2}},
        {"the positions", table, found, {.x_column = 2}},
    });
}

TEST_CASE("Numbers of points are positions where they are chosen or named so", "[index]") {
    const auto pairs = [](int first) {
        return with_commas(lines(20, [&](int i) { return std::to_string(i + first) + ";" + height_text(i) + "\n"; }));
    };
    const std::string nr = "Nr.;z [um]\n" + pairs(1), bare = counted(1);
    check_texts({
        {"chosen",
         table,
         profile(1e-3, 1e-6, {}, {"contradicts line 1, which states um for the positions"}),
         {.units = "mm,um", .column = 3, .x_column = 1}},
        {"named", "x [um];z [um]\n" + pairs(1), profile(1e-6, 1e-6)},
        {"no titles", pairs(1), profile(1e-6, 1e-6), {.units = "um"}},
        {"no positions",
         nr,
         refused("has no column of positions (column 1 numbers the points; to use it as positions, give x_column = 1)",
                 "spacing = \"0.5 um\""),
         {.units = "um"}},
        {"spacing", nr, profile(2e-6, 1e-6), {.spacing = 2e-6}},
        {"column", nr, profile(1e-6, 1e-6), {.units = "um", .x_column = 1}},
        {"counts next to equal steps",
         bare,
         refused("counts the points in column 1, and column 2 rises in equal steps: either may hold the positions; "
                 "give x_column"),
         {.units = "um", .column = 3}},
        {"the second", bare, found, {.units = "um", .column = 3, .x_column = 2}},
        {"the first", bare, profile(1e-6, 1e-6), {.units = "um", .column = 3, .x_column = 1}},
    });
}

TEST_CASE("The column of the positions is refused where it cannot be", "[index]") {
    check_texts({
        {"beyond", table, refused("x_column = 4: must be between 1 and 3"), {.x_column = 4}},
        {"that of the heights",
         table,
         refused("x_column = 2: must be another column than that of the heights"),
         {.column = 2, .x_column = 2}},
        {"a spacing", table, refused("spacing and x_column are both given"), {.spacing = 1e-6, .x_column = 2}},
        {"as an option of the command",
         table,
         refused("--x-column = 9"),
         {.units = "um", .x_column = 9, .names = {.prefix = "--", .equals = " "}}},
        {"binary", "aISO-1.0\n", refused("no use for x-column"), {.x_column = 1}},
    });
}

TEST_CASE("Which columns number the points follows from titles and numbers", "[index]") {
    const auto text = [](const std::string& head, int step, double share) {
        std::string all = head + "\n";
        for (int i = 0; i < 9; ++i)
            all += std::to_string(1 + step * i) + (share > 0 ? ".5" : "") + ",0." + std::to_string(i) + "\n";
        return all;
    };
    const std::vector<bool> first{true, false}, none{false, false};
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
    check_text({"numbered",
                "Nr.,x [um],y [um],z [nm]\n" + lines(20,
                                                     [](int i) {
                                                         return std::to_string(i + 1) + "," + std::to_string(i % 5) +
                                                                "," + std::to_string(i / 5) + "," + height_text(i) +
                                                                "\n";
                                                     }),
                map(1e-6, 1e-6, 1e-9, {"\ncolumns: x, y and heights in 2, 3, 4; left out: 1\n"})});
}

}  // namespace roles_test
