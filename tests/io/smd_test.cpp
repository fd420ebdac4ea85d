// SPDX-License-Identifier: BSD-3-Clause
#include "support/samples.hpp"

namespace smd_test {

using namespace fstiff;
using test::contains;
using namespace std::string_literals;

namespace {

const test::FormReader read{io::SurfaceFormat::smd};
const test::RefusalOf refusal(read);

std::string lines(const char* end = "\r\n", int count = 20) {
    std::string text;
    for (int i = 0; i < count; ++i) text += std::to_string(7 * i % 10 - 3) + ".5" + end;
    return text;
}
double height(int i) { return 7 * i % 10 - 3 < 0 ? 7 * i % 10 - 3 - 0.5 : 7 * i % 10 - 3 + 0.5; }

struct Smd {
    std::string first = "ISO 5436-2:2012\0a.smd\0"s, form = "PRF\0 1 ISO5436\0"s;
    std::string x = "CX\0 I\0 20 mm\0 1.0e0 D\0 5.0e-4 "s, z = "CZ\0 A\0 20 um\0 2.0e0 D\0"s;
    std::string remarks = "DATE: today\0\r\n"s, data = lines(), sum{};

    std::string bytes() const {
        const std::string end = "\3\r\n";
        std::string all = first + "\r\n" + form + "\r\n" + x + "\r\n" + z + "\r\n" + end + remarks + end + data + end;
        unsigned total = 0;
        for (const char c : all) total += static_cast<unsigned char>(c);
        return all + (sum.empty() ? std::to_string(total % 65535) : sum) + "\r\n" + end + "\x1A";
    }
};

struct Prf {
    std::string x = "CX M 2.000000e+001 MM 1.000000e+000 D", z = "CZ M 2.000000e+001 UM 1.000000e-006 L";
    std::string remarks =
        "STYLUS_RADIUS 2.000000e-003 MM\nSPACING CX 5.000000e-004\n"
        "MAP 1.000000e+000 CZ CZ 1.000000e+000 1.000000e+000\n"
        "MAP 2.000000e+000 CZ CX 1.000000e+000 0.000000e+000\n";
    std::string bytes() const {
        std::string all = "1 2\nSG2004 0.000000e+000 PRF\n" + x + "\n" + z + "\nEOR\n" + remarks + "EOR\n";
        for (int i = 0; i < 20; ++i) all += std::to_string(7 * i % 10 - 3) + "00000\n";
        return all + "EOR\nEOF\n";
    }
};

}  // namespace

TEST_CASE("A profile of ISO 5436-2 is number times scale times unit, its spacing the increment of x") {
    const io::Reading found = read(Smd{}.bytes());
    REQUIRE(found.map.columns == 20);
    CHECK(found.map.dx == 5e-4 * 1e-3);
    for (int i = 0; i < 20; ++i) CHECK(found.map.heights[static_cast<std::size_t>(i)] == height(i) * (2 * 1e-6));
    CHECK(found.record.resolution == 0.1 * (2 * 1e-6));
    CHECK(found.record.sentences().front() == "form: profile of ISO 5436-2 (.smd), \"ISO 5436-2:2012\"");
    CHECK(found.record.sentences().back() == "check sum: agrees");
    CHECK(found.record.warnings.empty());
}

TEST_CASE("The elder form has the spacing among its remarks, and counts its heights") {
    const io::Reading found = read(Prf{}.bytes());
    REQUIRE(found.map.columns == 20);
    CHECK(found.map.dx == 5e-4 * 1e-3);
    for (int i = 0; i < 20; ++i)
        CHECK(test::ulps(found.map.heights[static_cast<std::size_t>(i)], (7 * i % 10 - 3) * 1e-7) <= 2);
    CHECK(test::ulps(found.record.resolution, 1e-12) <= 1);
    CHECK(found.record.said("stylus radius") == "2.000000e-003 mm in the file, not used");
    CHECK(found.record.warnings.empty());
    Prf gauge;
    gauge.remarks += "MAP 2 CZ CX 1 1e-3\n";
    REQUIRE(read(gauge.bytes()).record.warnings.size() == 1);
    CHECK(contains(read(gauge.bytes()).record.warnings[0], "correction of its gauge"));
}

TEST_CASE("NUL bytes or blanks part the fields, and lines end in either way") {
    Smd plain{.first = "ISO 5436 - 2000 a.smd",
              .form = "PRF 1 ISO5436",
              .x = "CX I 20 MM 1 D 5.0e-4",
              .z = "CZ A 20 UM 2 D",
              .remarks = "DATE 1",
              .data = lines("\n")};
    CHECK(read(plain.bytes()).map.heights == read(Smd{}.bytes()).map.heights);
    CHECK(read(plain.bytes()).map.dx == read(Smd{}.bytes()).map.dx);
}

TEST_CASE("A check sum is compared modulo 65535 and 65536, and one that fits neither is warned of") {
    CHECK(read(Smd{.sum = "17"}.bytes()).record.warnings.size() == 1);
    CHECK(contains(read(Smd{.sum = "17"}.bytes()).record.sentences().back(), "does not agree"));
    CHECK(read(Smd{.sum = "none"}.bytes()).record.said("check sum").empty());
    const Smd longer{.remarks = std::string(2000, 'x') + "\r\n"};  // its sum is above 65536
    CHECK(read(longer.bytes()).record.said("check sum") == "agrees");
    const std::string whole = longer.bytes();
    const std::string before = whole.substr(0, whole.rfind('\3', whole.rfind('\3') - 1) + 3);
    unsigned total = 0;
    for (const char c : before) total += static_cast<unsigned char>(c);
    REQUIRE(total > 65536);
    Smd other = longer;
    other.sum = std::to_string(total % 65536);
    CHECK(read(other.bytes()).record.said("check sum") == "agrees");
}

TEST_CASE("Words denote missing points of a profile in records") {
    Smd gap;
    gap.data.replace(0, 4, "BAD");
    const io::Reading found = read(gap.bytes());
    CHECK(found.record.missing == 1);
    CHECK(std::isnan(found.map.heights[0]));
}

TEST_CASE("Profiles in records that cannot be meant are refused with line, value and range") {
    CHECK(contains(refusal("nothing"), "does not begin as a profile of ISO 5436-2"));
    CHECK(contains(refusal("ISO 5436\n"), "holds 0 whole records"));
    CHECK(contains(refusal(Smd{.form = "SUR"}.bytes()), "the form \"SUR\""));
    CHECK(contains(refusal(Smd{.x = "CX A 20 mm 1 D"}.bytes()), "line 3: states an axis of the kind \"A\"; must be I"));
    CHECK(contains(refusal(Smd{.z = "CZ R 20 um 1 D"}.bytes()), "line 4: states an axis of the kind \"R\"; must be A"));
    CHECK(contains(refusal(Smd{.z = "CY A 20 um 1 D"}.bytes()), "line 4: states an axis CY"));
    CHECK(contains(refusal(Smd{.z = "C A 20 um 1 D"}.bytes()), "states no axis CZ"));
    CHECK(contains(refusal(Smd{.z = "CX I 20 mm 1 D 1"}.bytes()), "states CX again"));
    CHECK(contains(refusal(Smd{.z = "CZ A 20 um"}.bytes()), "has 4 fields"));
    CHECK(contains(refusal(Smd{.z = "CZ A 2.5 um 1 D"}.bytes()), "\"2.5\" points; must be a whole number"));
    CHECK(contains(refusal(Smd{.z = "CZ A 4294967295 um 1 D"}.bytes()), "states 4294967295 points where CX has 20"));
    CHECK(contains(refusal(Smd{.z = "CZ A 20 V 1 D"}.bytes()), "\"V\" is not a unit of length"));
    CHECK(contains(refusal(Smd{.z = "CZ A 20 um 0 D"}.bytes()), "scale \"0\""));
    CHECK(contains(refusal(Smd{.z = "CZ A 20 um 1 X"}.bytes()), "type \"X\""));
    CHECK(contains(refusal(Smd{.x = "CX I 20 mm 1 D"}.bytes()), "states no increment"));
    CHECK(contains(refusal(Smd{.x = "CX I 20 mm 1 D -1"}.bytes()), "increment \"-1\""));
    CHECK(contains(refusal(Smd{.data = lines("\n", 19)}.bytes()), "states 20 points, but holds 19"));
    CHECK(contains(refusal(Smd{.data = "1 2\n" + lines("\n", 19)}.bytes()), "holds 2 numbers"));
    CHECK(contains(refusal(Smd{.data = "1e999\n" + lines("\n", 19)}.bytes()), "line 8: height \"1e999\""));
    CHECK(contains(refusal(Prf{.remarks = ""}.bytes()), "must have a line SPACING CX"));
    CHECK(contains(refusal(Prf{.remarks = "SPACING CX 1\nSPACING CX 2\n"}.bytes()),
                   "line 7: states the spacing of CX again"));
}

TEST_CASE("Numbers and the word PRF alone are no profile in records") {
    CHECK_FALSE(read.begins("1 2\n3 4\n5 6\n"));
    CHECK_FALSE(read.begins("1 2\nPRF"));
}

}  // namespace smd_test
