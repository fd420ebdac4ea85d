// SPDX-License-Identifier: BSD-3-Clause
// Rows of numbers, with whole rows and with short ones. The tables are read by eye.
#include "io/row_layout.hpp"

#include "support/accuracy.hpp"
#include "support/catch.hpp"

namespace number_table_test {

using namespace fstiff::io::detail;

namespace {

NumberTable table_of(std::string_view text, RowEnds ends) {
    NumberTable table = open_table(text, "file");
    if (ends == RowEnds::may_be_short) take_rows_above(table);
    read_rows(table, "file", ends);
    return table;
}

constexpr RowEnds padded = RowEnds::may_be_short, whole = RowEnds::whole;

}  // namespace

TEST_CASE("the header ends at the first row of numbers, whose signs hold for all", "[number_table]") {
    const NumberTable table = table_of("title\n# 1 2\n1;2\n3,5;4\n", whole);
    CHECK(table.lines[table.first].number == 3);
    CHECK(table.dialect.separator == ';');
    CHECK(table.dialect.decimal_comma);
    CHECK(table.values == std::vector<double>{1, 2, 3.5, 4});
    CHECK(table.row_lines == std::vector<std::size_t>{3, 4});
    fstiff::io::Record record;
    table.say_layout(record, "numbers");
    CHECK(record.sentences() ==
          std::vector<std::string>{"read as: numbers; separator: semicolon, decimal comma", "header: 2 lines"});
}

TEST_CASE("cells at the end of a row may be left out where the rules allow it", "[number_table]") {
    const NumberTable table = table_of("1,\n2,3,\n4\n", padded);
    CHECK(table.columns == 2);
    CHECK(table.at(1, 1) == 3);
    CHECK((std::isnan(table.at(0, 1)) && std::isnan(table.at(2, 1))));
    CHECK(test::refusal([] { (void)table_of("1,2\n3\n", whole); }) ==
          "file, line 2: has 1 columns; must be 2 as in line 1");
}

TEST_CASE("a separator at the end of every row makes no column, an empty last cell does", "[number_table]") {
    const NumberTable dropped = table_of("1;2;\n3;4;\n", whole);
    CHECK(dropped.columns == 2);
    CHECK(dropped.values == std::vector<double>{1, 2, 3, 4});
    const NumberTable kept = table_of("1;2;\n3;4;5\n", whole);
    CHECK(kept.columns == 3);
    CHECK(std::isnan(kept.at(0, 2)));
}

TEST_CASE("words are missing points", "[number_table]") {
    CHECK(std::isnan(table_of("1 BAD\n3 4\n", whole).at(0, 1)));
    CHECK(std::isnan(table_of("1 2\n3 BAD\n", padded).at(1, 1)));
}

TEST_CASE("a first row with both decimal signs is refused once the others have one", "[number_table]") {
    for (const RowEnds ends : {padded, whole})
        CHECK(test::refusal([&] { (void)table_of("0.5;1,5\n1,5;2,5\n", ends); }).find("file, line 1: \"1,5\"") == 0);
}

TEST_CASE("Words next to rows are no header where the rows have nothing", "[number_table]") {
    for (const char* separator : {",", ";", "\t"}) {
        const std::string s(separator);
        const std::string rows = s + "3" + s + "0.3\n" + s + "4" + s + "0.4\n";
        const NumberTable table =
            table_of("Ra 0.16" + s + "1" + s + "0.1\nRz 0.9  um" + s + "2" + s + "0.2\n" + rows, padded);
        CHECK(table.rows() == 4);
        CHECK((table.at(0, 1) == 1 && table.at(1, 2) == 0.2 && std::isnan(table.at(0, 0))));
        // between the rows as well; a word where others hold numbers is a header
        CHECK(table_of(rows + "Rq" + s + "5" + s + "0.5\n", padded).rows() == 3);
        CHECK(table_of("Pitch" + s + "0.5" + s + "um\n1" + s + "0.1" + s + "2\n", padded).rows() == 1);
    }
}

}  // namespace number_table_test
