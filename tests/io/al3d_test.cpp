// SPDX-License-Identifier: BSD-3-Clause
#include "support/samples.hpp"

namespace al3d_test {

using namespace fstiff;
using test::contains;
using test::little;
using test::put;

namespace {

const test::FormReader read{io::SurfaceFormat::al3d};
const test::RefusalOf refusal(read);
std::string with(const std::string& key, const std::string& value) {
    const std::string whole = test::sample("al3d/map.al3d");
    return put(whole, whole.find(key) + 20, value + std::string(30 - value.size(), '\0'));
}

}  // namespace

TEST_CASE("A map of Alicona is float32 in metres at the place of its tag, in rows of whole 8 bytes") {
    const std::string whole = test::sample("al3d/map.al3d");
    // three columns, and four bytes more in each row
    const io::Reading narrow = read(with("Cols", "3"));
    CHECK(narrow.map.columns == 3);
    CHECK(narrow.map.at(1, 1) == read(whole).map.at(1, 1));
    CHECK(read(with("InvalidPixelValue", "NaN")).map.at(1, 2) == -1);
    CHECK(read(put(whole, 700, little(std::nanf("")))).record.missing == 2);
    CHECK(read(put(whole, 700, little(INFINITY))).record.missing == 2);
}

TEST_CASE("Files of Alicona that cannot be meant are refused with tag, value and range") {
    const std::string whole = test::sample("al3d/map.al3d");
    CHECK(contains(refusal("nothing"), "does not begin as a file of Alicona"));
    CHECK(contains(refusal(with("TagCount", "4294967295")), "has a tag 9 that does not end with CR LF"));
    CHECK(contains(refusal(with("TagCount", "-1")), "TagCount = -1: must be a whole number from 0 to 4294967295"));
    CHECK(contains(refusal(with("TagCount", "1e300")), "TagCount = 1e+300"));
    CHECK(contains(refusal(with("TagCount", "x")), "TagCount"));
    CHECK(contains(refusal(with("TagCount", "1")), "has no tag Rows; must have one"));
    CHECK(contains(refusal(with("Cols", "4294967295")), "declares 4294967295 x 3 heights of 4 bytes"));
    CHECK(contains(refusal(with("Rows", "0.5")), "Rows = 0.5"));
    CHECK(contains(refusal(with("Rows", "0")), "4 x 0: must be at least 2 x 1"));
    CHECK(contains(refusal(with("DepthImageOffset", "0")), "holds no depth image"));
    CHECK(contains(refusal(with("PixelSizeXMeter", "0")), "PixelSizeXMeter = 0: must be finite"));
    CHECK(contains(refusal(with("PixelSizeYMeter", "-1")), "PixelSizeYMeter = -1"));
}

}  // namespace al3d_test
