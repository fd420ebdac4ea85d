// SPDX-License-Identifier: BSD-3-Clause
#include "support/samples.hpp"

namespace metropro_test {

using namespace fstiff;
using test::big;
using test::contains;
using test::put;

namespace {

constexpr double step = 2.0 * 0.5 / 32768;
const double wavelength = double(0.5e-6F);

const test::FormReader read{io::SurfaceFormat::metropro};
const test::RefusalOf refusal(read);

}  // namespace

TEST_CASE("A map of MetroPro is numbers times wavelength and factors after its intensities") {
    const std::string whole = test::sample("metropro/map.dat");
    CHECK(read(whole).record.resolution == step * wavelength);
    CHECK(contains(read(whole).record.said("form"), "\"a plate\""));
    for (const auto& [code, levels] : {std::pair{0, 4096}, {2, 131072}})
        CHECK(read(put(whole, 218, big(code, 2))).map.at(1, 0) == 10 * (wavelength / levels));
    std::string padded = whole;  // the elder magic numbers have the short header, the newest has a long one
    padded.insert(834, std::string(4096 - 834, '\0'));
    test::check_sample(read(put(put(padded, 3, "\x71"), 6, big(4096, 4))), double(0.5e-6F), double(0.5e-6F),
                       step * wavelength, 1);
    CHECK(read(whole + "more").record.said("trailer") == "4 bytes, not read");
}

TEST_CASE("An inverted sign of MetroPro turns the heights over with a warning") {
    const io::Reading found = read(put(test::sample("metropro/map.dat"), 232, big(1, 2)));
    CHECK(found.map.at(1, 0) == -10 * (step * wavelength));
    CHECK(found.record.warnings.size() == 1);
}

TEST_CASE("Headers of MetroPro that cannot be meant are refused with field, value and range") {
    const std::string whole = test::sample("metropro/map.dat");
    CHECK(contains(refusal("nothing"), "does not begin as a file of Zygo MetroPro"));
    CHECK(contains(refusal(put(whole, 6, big(835, 4))), "bytes of the header = 835: must be 834"));
    CHECK(contains(refusal(put(whole, 56, big(65535, 2))), "declares 4 x 3 heights of 4 bytes"));
    CHECK(contains(refusal(put(whole, 68, big(-1, 2))), "declares 65535 x 3"));
    CHECK(contains(refusal(put(whole, 68, big(1, 2))), "points of a row x rows = 1 x 3: must be at least 2 x 1"));
    CHECK(contains(refusal(put(whole, 68, big(0, 4))), "holds no heights"));
    CHECK(contains(refusal(put(whole, 164, big(0.0F))), "scale factor of the interferometer = 0"));
    CHECK(contains(refusal(put(whole, 168, big(-1.0F))), "wavelength = -1"));
    CHECK(contains(refusal(put(whole, 176, big(std::nanf("")))), "obliquity factor = nan"));
    CHECK(contains(refusal(put(whole, 184, big(0.0F))), "step of x and y = 0: must be finite and greater than 0"));
    CHECK(contains(refusal(put(whole, 218, big(3, 2))), "phase resolution = 3: must be 0, 1 or 2"));
}

}  // namespace metropro_test
