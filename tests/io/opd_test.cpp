// SPDX-License-Identifier: BSD-3-Clause
#include "support/samples.hpp"

namespace opd_test {

using namespace fstiff;
using test::contains;
using test::little;
using test::put;

namespace {

const test::FormReader read{io::SurfaceFormat::opd};
const test::RefusalOf refusal(read);
/// Beginning of the entry of block \p index of the directory, and of the first array.
constexpr std::size_t entry(std::size_t index) { return 2 + 24 * index; }
constexpr std::size_t array = entry(8);

}  // namespace

TEST_CASE("A map of Wyko is numbers times wavelength over Mult, its columns from the bottom") {
    for (const char* name : {"opd/map.opd", "opd/real.opd"}) {
        CAPTURE(name);
        const std::string whole = test::sample(name);
        CHECK(read(whole).record.said("other arrays") == "\"Image\", not read");
        CHECK(contains(read(whole).record.said("form"), "\"a plate\""));
    }
    CHECK(test::ulps(read(test::sample("opd/map.opd")).record.resolution, 75e-9) <= 2);
    CHECK(read(test::sample("opd/real.opd")).record.resolution == 0);
    std::string plain = put(test::sample("opd/map.opd"), entry(4), "Nult");
    plain = put(plain, entry(6), "Bspect");
    test::check_sample(read(plain), double(0.5e-3F) * 1e-3, double(0.5e-3F) * 1e-3, 600e-9, 1);
}

TEST_CASE("Files of Wyko that cannot be meant are refused with block, value and range") {
    const std::string whole = test::sample("opd/map.opd");
    CHECK(contains(refusal("nothing"), "does not begin as a file of Wyko Vision"));
    CHECK(contains(refusal(put(whole, entry(0) + 18, little(25, 4))), "bytes of the directory = 25"));
    CHECK(contains(refusal(put(whole, entry(0) + 18, little(-1, 4))), "bytes of the directory = 0"));
    CHECK(contains(refusal(put(whole, entry(0) + 18, little(2147483640, 4))), "ends within the directory"));
    CHECK(contains(refusal(put(whole, entry(1), "ROW")), "has no array of heights"));
    CHECK(contains(refusal(put(whole, entry(1) + 16, little(5, 2))), "has no array of heights"));
    CHECK(contains(refusal(put(whole, entry(3), "X")), "has no block Wavelength"));
    CHECK(contains(refusal(put(whole, entry(5), "X")), "has no block Pixel_size"));
    CHECK(contains(refusal(put(whole, entry(4) + 16, little(5, 2))), "type of block Mult = 5: must be 6, 7, 8 or 12"));
    CHECK(
        contains(refusal(put(whole, array, little(-1, 2))), "declares 65535 x 3 heights of 2 bytes in a block of 30"));
    CHECK(contains(refusal(put(whole, array + 4, little(1, 2))), "bytes of a height = 1: must be 2 or 4"));
    constexpr std::size_t wavelength = array + 30 + 18;
    CHECK(contains(refusal(put(whole, wavelength, little(-600.0F))), "Wavelength = -600"));
    CHECK(contains(refusal(put(whole, wavelength + 4, little(0, 2))), "Mult = 0: must be finite and greater than 0"));
    CHECK(contains(refusal(put(whole, wavelength + 6, little(0.0F))), "Pixel_size = 0"));
    CHECK(contains(refusal(put(whole, wavelength + 10, little(std::nanf("")))), "Aspect = nan"));
}

}  // namespace opd_test
