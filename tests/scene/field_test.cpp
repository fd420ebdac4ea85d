// SPDX-License-Identifier: BSD-3-Clause
// One rule puts a value into a field, whether a scene, a program or a line of options gives it, and every field of a
// request is an option of its command.
#include "request/toml.hpp"
#include "request/values.hpp"

#include "cli/command.hpp"

#include "actions/export.hpp"
#include "actions/fractal.hpp"
#include "actions/generate.hpp"
#include "actions/identify.hpp"
#include "actions/islands.hpp"
#include "actions/spectrum.hpp"
#include "actions/truth.hpp"
#include "actions/ultrasound.hpp"
#include "surface/surface_option_table.hpp"

#include "support/accuracy.hpp"

#include <cctype>
#include <cmath>

namespace field_test {

using namespace fstiff;
using fstiff::request::Amount;
using fstiff::request::Field;
using fstiff::request::Value;
using fstiff::request::Values;
using test::contains;
using Dimension = fstiff::io::Dimension;

namespace {

/// A field of each kind.
struct Owner {
    bool fills = false;
    int points = 256;
    std::uint64_t seed = 1;
    double share = 0.5;
    std::optional<double> height{};
    std::string name{};
    std::vector<std::string> parts{};
    Amount length{};
    fstiff::Edges edges = fstiff::Edges::mirrored;

    template <class Take>
    void each_field(Take take) {
        take("fills", fills, Field{});
        take("points", points, Field{.low = 16, .high = 4096});
        take("seed", seed, Field{});
        take("share", share, Field{.high = 1, .above_low = true});
        take("height", height, fstiff::request::positive(Dimension::length));
        take("name", name, Field{});
        take("parts", parts, Field{});
        take("length", length, Field{});
        take("edges", edges, Field{});
    }
};

/// \p text of a scene's section, read.
Owner of_scene(const std::string& text, std::vector<request::Input>* inputs = nullptr) {
    Owner owner;
    fstiff::request::Source source{.file = "s.toml"};
    const toml::table root = fstiff::request::parse_toml(text, source.file);
    const auto fields = [&](auto take) { owner.each_field(take); };
    const fstiff::request::Section section(source, &root, "", fstiff::request::keys_of(fields));
    section.read(fields);
    if (inputs) *inputs = source.inputs;
    return owner;
}
Owner of_line(const std::string& key, const std::string& text) {
    Owner owner;
    Values values;
    values.add(key, Value::of_text(text, Value::Giver::line));
    values.fill(owner);
    values.require_known();
    return owner;
}
Owner of_program(const std::string& key, const Value& value) {
    Owner owner;
    Values values;
    values.add(key, value);
    values.fill(owner);
    return owner;
}
Value number(double value) {
    return {.kind = value == std::floor(value) ? Value::Kind::integer : Value::Kind::real,
            .written = fstiff::detail::shortest_text(value),
            .number = value};
}

/// \p text with one blank for each run of blanks and line ends.
std::string one_line(const std::string& text) {
    std::string line;
    for (const char c : text)
        if (!std::isspace(static_cast<unsigned char>(c)))
            line += c;
        else if (line.empty() || line.back() != ' ')
            line += ' ';
    return line;
}

/// Whether each field of \p Request is an option of the command \p name with its help, and a key of options in C.
template <class Request>
void check_options(const std::string& name) {
    const std::string help = one_line(test::run_fstiff(name + " --help").out);
    Request request;
    request.each_field([&](std::string_view key, const auto&, const Field& field) {
        INFO(name << " " << key);
        CHECK(contains(help, (field.positional ? " " : " --") + surface::with_dashes(key) + " "));
        CHECK(contains(help, one_line(field.help)));
    });
    Values values;
    values.add("no_such_key", Value::of_text("1", Value::Giver::line));
    values.fill(request);
    const std::string refused = test::refusal([&] { values.require_known(); });
    request.each_field(
        [&](std::string_view key, const auto&, const Field&) { CHECK(contains(refused, std::string(key))); });
}

}  // namespace

TEST_CASE("A field takes its value from a scene, a line of options and a program by one rule") {
    CHECK(of_scene("fills = true").fills);
    CHECK(of_line("fills", "true").fills);
    CHECK(of_program("fills", {.kind = Value::Kind::truth, .number = 1}).fills);
    CHECK(of_scene("points = 64").points == 64);
    CHECK(of_line("points", "64").points == 64);
    CHECK(of_program("points", number(64)).points == 64);
    CHECK(of_scene("seed = 9007199254740991").seed == 9007199254740991);
    CHECK(of_line("seed", "18446744073709551615").seed == 18446744073709551615u);
    CHECK(of_line("share", "0.25").share == 0.25);
    CHECK(of_scene("share = 1").share == 1);
    CHECK(of_scene("height = \"2 um\"").height == 2e-6);
    CHECK(of_line("height", "2 um").height == 2e-6);
    CHECK(of_line("height", "2e-6").height == 2e-6);
    CHECK(of_program("height", number(2e-6)).height == 2e-6);
    CHECK(of_scene("name = \"7\"").name == "7");
    CHECK(of_line("name", "7").name == "7");
    CHECK(of_line("parts", "a,b").parts == std::vector<std::string>{"a", "b"});
    CHECK(of_scene("parts = [\"a\", \"b\"]").parts == std::vector<std::string>{"a", "b"});
    CHECK(of_scene("length = \"1 um\"").length == Amount("1 um"));
    CHECK(of_line("length", "1e-6").length == Amount(1e-6));
    const Value pair{.kind = Value::Kind::list, .items = {number(1e-6), {.written = "2 um"}}};
    CHECK(of_program("length", pair).length == Amount("1e-06 m,2 um"));
    CHECK(of_line("edges", "periodic").edges == fstiff::Edges::periodic);
}

TEST_CASE("A field refuses by its key, its value and what it allows, whatever gives the value") {
    const auto refused = [](const std::string& key, const std::string& toml, const std::string& line,
                            const std::string& sentence) {
        CHECK(test::refusal([&] { (void)of_scene(key + " = " + toml); }) == "s.toml:1: " + sentence);
        if (!line.empty()) CHECK(test::refusal([&] { (void)of_line(key, line); }) == sentence);
    };
    refused("fills", "1", "1", "fills = 1: must be true or false");
    refused("points", "8", "8", "points = 8: must be a whole number from 16 to 4096");
    refused("points", "64.5", "64.5", "points = 64.5: must be a whole number from 16 to 4096");
    refused("points", "\"many\"", "many", "points = \"many\": must be a whole number from 16 to 4096");
    refused("seed", "-1", "", "seed = -1: must be a whole number from 0 to 9007199254740991");
    refused("seed", "9007199254740993", "",
            "seed = 9007199254740993: must be a whole number from 0 to 9007199254740991");
    refused("share", "0", "0", "share = 0: must be greater than 0 and at most 1");
    refused("share", "nan", "", "share = nan: must be a finite number");
    refused("height", "\"0 um\"", "0 um", "height = \"0 um\": must be finite and greater than 0");
    refused("height", "2e-6", "", "height = 2e-06: a number without a unit; write it as a text such as \"0.8 um\"");
    refused(
        "height", "[\"1 um\"]", "",
        "height = [...]: must be a text such as \"0.8 um\"; several values are for a grid, which fstiff sweep reads");
    refused("edges", "\"open\"", "open", "edges = \"open\": must be one of \"mirrored\", \"periodic\"");
    CHECK(contains(test::refusal([] { (void)of_scene("heigth = 1"); }),
                   "heigth: unknown key (did you mean height?); valid keys are \"fills\""));
    CHECK(
        contains(test::refusal([] { (void)of_line("heigth", "1"); }), "heigth is not an option; must be one of fills"));
}

TEST_CASE("A quantity that a person gives has its unit") {
    Amount length;
    fstiff::request::put(Value::of_text("5", Value::Giver::command), length, "--length", {});
    CHECK(length == Amount("5"));  // which is refused where it is read
    CHECK(contains(test::refusal([&] { (void)length.positive(Dimension::length, "--length"); }), "without a unit"));
    CHECK(of_line("length", "5").length == Amount(5.0));
}

TEST_CASE("What a section holds is on record with its number in SI and its unit") {
    std::vector<request::Input> inputs;
    (void)of_scene("height = \"2 um\"\npoints = 64\nname = \"x\"\n", &inputs);
    REQUIRE(inputs.size() == 3);
    CHECK(inputs[0].key == "points");  // in the order of the fields
    CHECK(inputs[0].value == 64.0);
    CHECK(inputs[1].written == "2 um");
    CHECK(inputs[1].value == 2e-6);
    CHECK(inputs[1].unit == "m");
    CHECK_FALSE(inputs[2].value);
}

TEST_CASE("Every field of a request is an option of its command and a key of its options in C") {
    check_options<surface::MeasureOptions>("measure");
    check_options<actions::FractalOptions>("measure --show fit");
    check_options<actions::IslandsRequest>("measure --show islands");
    check_options<actions::SpectrumRequest>("measure --show spectrum");
    check_options<actions::GenerateRequest>("generate");
    check_options<actions::TruthRequest>("truth");
    check_options<actions::ReflectionRequest>("ultrasound");
    check_options<actions::IdentifyRequest>("identify");
    check_options<actions::ExportRequest>("export");
}

}  // namespace field_test
