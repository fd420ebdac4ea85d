// SPDX-License-Identifier: BSD-3-Clause
#include "support/samples.hpp"

namespace gwy_test {

using namespace fstiff;
using namespace std::string_literals;
using test::bytes_of;
using test::contains;
using test::little;

namespace {

const test::FormReader read{io::SurfaceFormat::gwy};
const test::RefusalOf refusal(read);

// the parts of a file, as its description lays them out
std::string part(const std::string& name, char type, const std::string& value) { return name + '\0' + type + value; }
std::string object(const std::string& name, const std::string& content) {
    return name + '\0' + little(static_cast<std::int64_t>(content.size()), 4) + content;
}
std::string unit(const std::string& text) { return object("GwySIUnit", part("unitstr", 's', text + '\0')); }
std::string array(const std::vector<double>& values) {
    std::string bytes = little(static_cast<std::int64_t>(values.size()), 4);
    for (const double value : values) bytes += bytes_of(value);
    return bytes;
}

const std::vector<double> heights{-5, 2, 3, 4, 1000, 6};

struct Field {
    int columns = 3, rows = 2;
    double width = 6e-6, height = 5e-6;
    std::string lateral = "m", vertical = "nm";
    std::vector<double> values = heights;

    std::string bytes() const {
        return object("GwyDataField", part("xres", 'i', little(columns, 4)) + part("yres", 'i', little(rows, 4)) +
                                          part("xoff", 'd', bytes_of(1.0)) + part("xreal", 'd', bytes_of(width)) +
                                          part("yreal", 'd', bytes_of(height)) +
                                          part("si_unit_xy", 'o', unit(lateral)) +
                                          part("si_unit_z", 'o', unit(vertical)) + part("data", 'D', array(values)));
    }
};
std::string channel(int number, const Field& field = {}, const std::string& title = "") {
    const std::string called = "/" + std::to_string(number) + "/data";
    return part(called, 'o', field.bytes()) + (title.empty() ? "" : part(called + "/title", 's', title + '\0'));
}
std::string file(const std::string& content) { return "GWYP" + object("GwyContainer", content); }

}  // namespace

TEST_CASE("A channel of Gwyddion is read among components of every type, which are left out") {
    const std::string others = part("/flag", 'b', "\1") + part("/letter", 'c', "x") + part("/n", 'i', little(7, 4)) +
                               part("/long", 'q', little(7, 8)) + part("/x", 'd', bytes_of(7.0)) +
                               part("/t", 's', "text\0"s) + part("/letters", 'C', little(3, 4) + "abc") +
                               part("/ns", 'I', little(1, 4) + little(7, 4)) +
                               part("/longs", 'Q', little(1, 4) + little(7, 8)) + part("/xs", 'D', array({1, 2})) +
                               part("/texts", 'S', little(2, 4) + "a\0b\0"s) +
                               part("/list", 'O', little(2, 4) + object("A", "") + object("B", part("z", 'b', "\1")));
    const io::Reading found = read(file(others + channel(0, {}, "Height") + others));
    REQUIRE(found.map.rows == 2);
    REQUIRE(found.map.columns == 3);
    CHECK(found.map.dx == 6e-6 / 3);
    CHECK(found.map.dy == 5e-6 / 2);
    for (int i = 0; i < 6; ++i) CHECK(found.map.heights[i] == heights[static_cast<std::size_t>(i)] * 1e-9);
    CHECK(found.record.sentences().front() == "form: Gwyddion file, channel 0 \"Height\", the only one");
    CHECK(found.record.warnings.empty());
    CHECK(read(file(channel(0)) + "more").record.said("trailer") == "4 bytes, not read");
}

TEST_CASE("The lowest or the named channel in lengths is read and the others are reported") {
    Field tilted;
    tilted.values = {1, 2, 3, 4, 5, 7};
    const std::string bytes =
        file(channel(12, tilted, "Topography") + channel(0, {.vertical = "V"}, "Current") + channel(2, {}, "Height"));
    CHECK(contains(read(bytes).record.said("form"), "channel 2 \"Height\""));
    CHECK(contains(read(bytes).record.sentences()[1], "0 \"Current\" in \"V\", 12 \"Topography\" in \"nm\", not read"));
    CHECK(read(bytes, {.channel = "12"}).map.at(0, 0) == 1e-9);
    CHECK(read(bytes, {.channel = "topography"}).map.at(0, 0) == 1e-9);
    CHECK(contains(refusal(bytes, {.channel = "3"}), "no channel \"3\"; must be one of 0 \"Current\" in \"V\", 2 "));
    CHECK(contains(refusal(bytes, {.channel = "Current"}),
                   "si_unit_z of channel 0 \"Current\" = \"V\": must be a unit of length"));
    CHECK(contains(refusal(file(channel(0, {}, "a") + channel(1, {}, "a")), {.channel = "a"}), "two channels \"a\""));
    CHECK(contains(refusal(file(channel(0, {.vertical = ""}))), "no channel in units of length (it has 0 in no unit)"));
}

TEST_CASE("Masked points and NaN are missing, and a mask is warned of") {
    const std::string mask = part("/0/mask", 'o', Field{.vertical = "", .values = {0, 1, 0, 0, 0, 0.2}}.bytes());
    Field gap;
    gap.values[4] = std::numeric_limits<double>::quiet_NaN();
    const io::Reading found = read(file(mask + channel(0, gap)));
    CHECK(contains(found.record.said("points"), "(1 of them under the mask)"));
    CHECK(found.record.missing == 2);
    CHECK(std::isnan(found.map.at(0, 1)));
    CHECK(std::isnan(found.map.at(1, 1)));
    REQUIRE(found.record.warnings.size() == 1);
    CHECK(contains(found.record.warnings[0], "a mask over 1 points"));
    const std::string wrong = part("/0/mask", 'o', Field{.columns = 2, .values = {0, 1, 0, 1}}.bytes());
    CHECK(contains(refusal(file(wrong + channel(0))), "a mask of 2 x 2 points over heights of 3 x 2"));
}

TEST_CASE("Files of Gwyddion that cannot be meant are refused with component, value and range") {
    const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
    CHECK(contains(refusal("GWYO"), "must begin with GWYP"));
    CHECK(contains(refusal("GWYP" + object("Other", "")), "holds an object \"Other\" as \"the tree\""));
    CHECK(contains(refusal(file("")), "holds no image"));
    CHECK(contains(refusal(file(part("/0/mask", 'o', Field{}.bytes()))), "holds no image"));
    CHECK(contains(refusal(file(channel(0) + channel(0))), "\"/0/data\" twice"));
    CHECK(contains(refusal(file(channel(0) + part("x", '?', ""))), "of the type \"?\""));
    CHECK(contains(refusal(file(channel(0, {.columns = 0}))), "xres = 0: must be at least 1"));
    CHECK(contains(refusal(file(channel(0, {.rows = -1}))), "yres = -1"));
    CHECK(contains(refusal(file(channel(0, {.columns = 2147483647, .rows = 2147483647}))),
                   "declares 2147483647 x 2147483647 numbers in /0/data, but holds 6"));
    CHECK(contains(refusal(file(channel(0, {.width = 0}))), "xreal = 0"));
    CHECK(contains(refusal(file(channel(0, {.height = nan}))), "yreal = nan"));
    CHECK(contains(refusal(file(channel(0, {.lateral = "s"}))), "no channel in units of length"));
    CHECK(std::isnan(read(file(channel(0, {.values = {1, infinity, 3, 4, 5, 6}}))).map.at(0, 1)));
    CHECK(contains(refusal(file(channel(0, {.values = {1, 1, 1, 1, 1, 1}}))), "constant height"));
    std::string typed = file(channel(0));
    typed.replace(typed.find("xres\0i"s) + 5, 1, "d");
    CHECK(contains(refusal(typed), "holds xres of /0/data as type \"d\"; must be \"i\""));
    CHECK(contains(refusal(file(part("/x", 'D', little(0xFFFFFFFF, 4)))), "has 34359738360 bytes where 0 are left"));
    CHECK(contains(refusal(file(part("/x", 'S', little(0xFFFFFFFF, 4)))), "ends within the text of \"/x\""));
}

TEST_CASE("One row of Gwyddion is a profile, and the option channel names one") {
    Field row{.columns = 20, .rows = 1, .values = {}};
    for (int i = 0; i < 20; ++i) row.values.push_back(i * i % 7);
    const io::Surface profile = io::read_surface(file(channel(0, row)), "file");
    REQUIRE(profile.is_profile());
    CHECK(profile.profile().spacing == 6e-6 / 20);
    const std::string two = file(channel(0) + channel(1, {.values = {1, 2, 3, 4, 5, 7}}));
    CHECK(io::read_surface(two, "file", {.channel = "1"}).map().heights(0, 0) == 1e-9);
    CHECK(contains(test::refusal([] { (void)io::read_surface("1 2\n3 4\n"s, "file", {.channel = "2"}); }),
                   "has no channel \"2\""));
}

}  // namespace gwy_test
