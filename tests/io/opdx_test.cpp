// SPDX-License-Identifier: BSD-3-Clause
#include "support/samples.hpp"

namespace opdx_test {

using namespace fstiff;
using test::contains;
using test::little;
using test::put;
using test::replaced;

namespace {

const test::FormReader read{io::SurfaceFormat::opdx};
const test::RefusalOf refusal(read);
std::string whole() { return test::sample("opdx/map.opdx"); }
/// The sample with \p field \p after bytes after the first \p name.
std::string with(const std::string& name, std::size_t after, const std::string& field) {
    return put(whole(), whole().find(name) + name.size() + after, field);
}

}  // namespace

TEST_CASE("A map of Dektak is its matrix times DataScale, its steps from extents") {
    CHECK(read(whole()).record.said("other channels") == "\"Other\", not read");
    CHECK(contains(read(whole()).record.said("form"), "map \"Raw\""));
    // of the kinds that are not named, a map is read, and of the channels without a first one, the first
    test::check_sample(read(replaced(replaced(whole(), "Surface Height", "Something else"), "Primary", "Second_")),
                       0.5e-6, 0.25e-6, 2e-9, 1);
}

TEST_CASE("Files of Dektak that cannot be meant are refused with item, value and range") {
    CHECK(contains(refusal("VCA DATA"), "does not begin as a file of Dektak"));
    CHECK(contains(refusal(put(whole(), 12, little(2000, 4))), "has a name of 2000 bytes; must be at most 1024"));
    CHECK(contains(refusal(with("2D_Data", 0, "\x33")), "of the type 51; must be a known one"));
    CHECK(contains(refusal(with("2D_Data", 1, "\3")), "has a length of 3 bytes in \"2D_Data\"; must be 1, 2 or 4"));
    CHECK(contains(refusal(with("2D_Data", 2, little(65535, 2))), "ends within 2D_Data"));
    CHECK(contains(refusal(with("Raw", 2, little(700, 2))), "that ends after its folder"));
    CHECK(contains(refusal(with("Dimension1Points", 1, little(4, 4))), "declares 4 x 4 heights, but has 56 bytes"));
    CHECK(contains(refusal(with("Dimension1Points", 1, little(2, 4))), "declares 4 x 2 points over a matrix of 4 x 3"));
    const std::string profile = test::sample("opdx/profile.opdx");
    CHECK(contains(refusal(put(profile, profile.find("NumPoints") + 10, little(21, 4))),
                   "declares 21 x 1 heights, but has 165 bytes"));
    CHECK(contains(refusal(with("Dimension1Points", 1, little(0, 4))), "Dimension1Points = 0: must be a whole number"));
    CHECK(contains(refusal(with("Dimension1Points", 1, little(-1, 4))), "Dimension1Points = -1"));
    CHECK(contains(refusal(with("Dimension1Extent", 4, std::string(8, '\0'))), "Dimension1Extent = 0: must be finite"));
    CHECK(contains(refusal(with("DataScale", 11, "\xFF")), "DataScale = -"));
    CHECK(contains(refusal(replaced(whole(), "nm", "kg")), "unit of DataScale = \"kg\": must be a unit of length"));
    CHECK(contains(refusal(replaced(whole(), "DataScale", "Datascale")), "has no 2D_Data/Raw/DataScale"));
    CHECK(refusal(replaced(whole(), "2D_Channels", "3D_Channels")).empty());  // the primary one is named
    CHECK(contains(refusal(replaced(whole(), "2D_Data", "3D_Data")), "holds no channel of heights"));
    const std::string matrix = "Matrix<float>";
    CHECK(contains(refusal(with(matrix, 3, little(-1, 4))), "over a matrix of 4 x 4294967295; must be as many"));
    CHECK(contains(refusal(put(with(matrix, 3, little(-1, 4)), whole().find("Dimension1Points") + 17, little(-1, 4))),
                   "Dimension1Points = -1"));
    std::string deep = whole().substr(0, 12);
    for (int i = 0; i < 40; ++i) deep += little(1, 4) + "a\x7D\4" + little(11 * (39 - i) + 400, 4);
    CHECK(contains(refusal(deep + std::string(400, ' ')), "more than 32 items within one another"));
    std::string many = whole().substr(0, 12);
    for (int i = 0; i < 100001; ++i) many += little(0, 4) + "\1\1";
    CHECK(contains(refusal(many), "more than 100000 items and names"));
}

}  // namespace opdx_test
