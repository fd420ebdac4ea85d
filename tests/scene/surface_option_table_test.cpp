// SPDX-License-Identifier: BSD-3-Clause
// Every option of a measured surface is a row of one table, and every row is a key of a scene, an option of the command
// line, an input of JSON documents and a line of docs/measurement.md.
#include "surface/surface_option_table.hpp"

#include "cli/command.hpp"

#include "actions/measure.hpp"
#include "scene/scene.hpp"

#include "support/accuracy.hpp"
#include "support/library.hpp"

#include <fstiff/profile/profile_form.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <set>

namespace surface_option_table_test {

using namespace fstiff;
using fstiff::detail::NamedEnum;
using request::Amount;
using surface::SurfaceOptionRow;
using test::contains;

namespace {

/// Puts a value that is not the default into an option.
struct PutOther {
    void operator()(std::string& to) const { to = "other"; }
    void operator()(Amount& to) const { to = 2.5e-6; }
    void operator()(int& to) const { to = 7; }
    void operator()(double& to) const { to = 7.5; }
    void operator()(bool& to) const { to = !to; }
    template <NamedEnum Enum>
    void operator()(Enum& to) const {
        to = fstiff::enum_names<Enum>.back().value;
    }
    template <NamedEnum Enum>
    void operator()(std::optional<Enum>& to) const {
        to = fstiff::enum_names<Enum>.back().value;
    }
};

template <NamedEnum Enum>
std::string words() {
    std::string all;
    for (const std::string_view word : fstiff::detail::choices<Enum>())
        all += (all.empty() ? "`\"" : ", `\"") + std::string(word) + "\"`";
    return all;
}

/// What docs/measurement.md calls the value of an option.
struct Kind {
    const SurfaceOptionRow& row;

    std::string operator()(const std::string&) const {
        return row.more.form == fstiff::request::Form::or_number ? "text or number" : "text";
    }
    std::string operator()(const Amount&) const { return "length"; }
    std::string operator()(int) const { return row.field_for(surface::SurfaceKind::any).allowed(true).substr(2); }
    std::string operator()(double) const { return row.field_for(surface::SurfaceKind::any).allowed().substr(2); }
    std::string operator()(bool) const { return "true or false"; }
    template <NamedEnum Enum>
    std::string operator()(Enum) const {
        return words<Enum>();
    }
    template <NamedEnum Enum>
    std::string operator()(const std::optional<Enum>&) const {
        return words<Enum>();
    }
};

/// \p help with the keys of a scene in place of the options of the command line.
std::string with_keys(std::string help) {
    for (const SurfaceOptionRow& row : surface::surface_option_table()) {
        const std::string flag = row.flag_name();
        if (const auto at = help.find(flag); at != std::string::npos)
            help.replace(at, flag.size(), "`" + std::string(row.key) + "`");
    }
    return help;
}

std::string table_of_docs() {
    const surface::SurfaceOptions options;
    std::string table = "| key | value | what it is |\n|---|---|---|\n";
    for (const SurfaceOptionRow& row : surface::surface_option_table())
        table += "| `" + std::string(row.key) + "` | " + row.visit(options, Kind{row}) + " | " +
                 with_keys(row.field_for(surface::SurfaceKind::any).help) + " |\n";
    return table;
}

}  // namespace

TEST_CASE("A scene reads every option of a surface as a key, and refuses a value of another kind by its name") {
    for (const SurfaceOptionRow& row : surface::surface_option_table()) {
        const std::string key(row.key);
        const std::string text = "[surface]\nfrom = \"trace.txt\"\n" + key + " = [1]\n";
        CHECK(contains(test::refusal([&] { (void)scene::read_scene(text, {.name = "s.toml"}); }),
                       "s.toml:3: surface." + key + " = [...]: must be "));
    }
}

TEST_CASE("The command line has every option of a surface, each with the help of its row") {
    const std::string help = test::run_fstiff("measure --help").out;
    std::string words;  // the help is broken into lines
    std::unique_copy(help.begin(), help.end(), std::back_inserter(words), [](char a, char b) {
        return std::isspace(static_cast<unsigned char>(a)) && std::isspace(static_cast<unsigned char>(b));
    });
    std::replace(words.begin(), words.end(), '\n', ' ');
    for (const SurfaceOptionRow& row : surface::surface_option_table()) {
        INFO(row.key);
        CHECK(contains(words, " " + row.flag_name() + " "));
        CHECK(contains(words, row.field_for(surface::SurfaceKind::any).help));
    }
}

TEST_CASE("The JSON of a measurement has every option of a surface that is not the default") {
    std::vector<double> heights;
    for (int i = 0; i < 400; ++i) heights.push_back(1e-6 * std::sin(0.9 * i) + 3e-7 * std::sin(2.3 * i + 1));
    surface::MeasureOptions options;
    options.resamples = 2, options.neighbours = false;
    const auto input =
        surface::surface_of_heights(options.input, fstiff::Profile<double>{heights, 1e-6}, "from a test");
    const auto surface = surface::measure_surface(options, input);
    const auto inputs = [&] {
        const std::string text = test::values_of(options, surface).str();
        const auto from = text.find("\"inputs\"");
        return text.substr(from, text.find("\"roughness\"", from) - from);  // which has cut-offs of its own
    };
    for (const SurfaceOptionRow& row : surface::surface_option_table()) {
        const std::string before = inputs(), name = "\"" + std::string(row.json_name()) + "\": ";
        CHECK(contains(before, name) == (row.echo == surface::Echo::always));
        row.visit(options.input, PutOther{});
        CHECK_FALSE(row.has_same(options.input, {}));
        CHECK(contains(inputs(), name));
        CHECK(inputs() != before);
    }
}

TEST_CASE("No two options of a surface have one key, one name on the command line, or one field") {
    std::set<std::string> keys, flags;
    for (const SurfaceOptionRow& row : surface::surface_option_table()) {
        CHECK(keys.insert(std::string(row.key)).second);
        CHECK(flags.insert(row.flag_name()).second);
        CHECK(&surface::surface_option(row.key) == &row);
        surface::SurfaceOptions options;
        row.visit(options, PutOther{});
        for (const SurfaceOptionRow& other : surface::surface_option_table())
            CHECK(other.has_same(options, {}) == (&other != &row));
    }
}

TEST_CASE("docs/measurement.md has the table of the options of a surface") {
    std::ifstream file(FSTIFF_SCENES "/../docs/measurement.md");
    REQUIRE(file);
    const std::string text{std::istreambuf_iterator<char>(file), {}}, table = table_of_docs();
    INFO("the table must be\n" << table);
    CHECK(contains(text, table));
}

TEST_CASE("Lengths are read from a text or taken as numbers, to the same bit") {
    for (const double metres : {1e-6, 0.1 * 3e-6, 1.0 / 3, 2.5e-9, 8e-4}) {
        const Amount number(metres), text(number.text("m"));
        CHECK(number.numbers().front() == metres);
        CHECK(surface::parse_length(number, "x") == metres);
        CHECK(surface::parse_length(text, "x") == metres);
        CHECK(surface::parse_cut_off(text, "x").length() == metres);
        const Amount two(std::vector<double>{metres, 10 * metres});
        CHECK(surface::parse_lengths(Amount(two.text("m")), "x") == two.numbers());
        const auto window = surface::parse_window(two, "x");
        CHECK(window.from == metres);
        CHECK(window.to == 10 * metres);
    }
    CHECK(surface::parse_cut_off("none", "x").length() == std::nullopt);
    CHECK_FALSE(surface::parse_cut_off("none", "x").automatic());
    CHECK(surface::parse_cut_off("auto", "x").automatic());
    CHECK(surface::parse_cut_off({}, "x").automatic());
    CHECK(surface::parse_lengths("0,1 um", "x") == std::vector<double>{0, 1e-6});
}

TEST_CASE("Lengths that are numbers are refused as their text is") {
    for (const double metres : {0.0, -1e-6}) {
        const Amount number(metres), text(number.text("m"));
        CHECK(test::refusal([&] { (void)surface::parse_length(number, "--spacing"); }) ==
              test::refusal([&] { (void)surface::parse_length(text, "--spacing"); }));
    }
    const double infinity = std::numeric_limits<double>::infinity();
    CHECK(contains(test::refusal([&] { (void)surface::parse_length(infinity, "x"); }), "x = \"inf m\": "));
    const Amount falling(std::vector<double>{2e-6, 1e-6}), three(std::vector<double>{1e-6, 2e-6, 3e-6});
    for (const Amount& wrong : {falling, three, Amount(1e-6)})
        CHECK(test::refusal([&] { (void)surface::parse_window(wrong, "x"); }) ==
              test::refusal([&] { (void)surface::parse_window(Amount(wrong.text("m")), "x"); }));
    CHECK(test::refusal([&] { (void)surface::parse_length(falling, "x"); }) ==
          "x = \"2e-06 m,1e-06 m\": must be one length");
}

}  // namespace surface_option_table_test
