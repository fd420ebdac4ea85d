// SPDX-License-Identifier: BSD-3-Clause
#include "io/unpack.hpp"

#include "support/samples.hpp"

namespace vk4_test {

using namespace fstiff;
using test::contains;
using test::little;
using test::put;

namespace {

const test::FormReader read{io::SurfaceFormat::vk4};
const test::RefusalOf refusal(read);
constexpr std::size_t settings = 84, image = 268;

}  // namespace

TEST_CASE("A map of Keyence is numbers times the step of its settings") {
    const std::string whole = test::sample("vk4/map.vk4");
    CHECK(test::ulps(read(whole).record.resolution, 1e-10) <= 1);
    test::check_sample(read(put(whole, 2, "3")), 0.5e-6, 0.25e-6, 1e-10, 0);
    std::string wide = whole.substr(0, image + 796), narrow = wide;
    for (int i = 0; i < 12; ++i) {
        wide += little(10 * (i / 4) + (i % 4) * (i % 4), 4);
        narrow += little(10 * (i / 4) + (i % 4) * (i % 4), 1);
    }
    test::check_sample(read(put(wide, image + 8, little(32, 4))), 0.5e-6, 0.25e-6, 1e-10, 0);
    test::check_sample(read(put(narrow, image + 8, little(8, 4))), 0.5e-6, 0.25e-6, 1e-10, 0);
}

TEST_CASE("The first of several images of heights is read and the others are reported") {
    const std::string whole = put(test::sample("vk4/map.vk4"), 40, little(300, 4));
    CHECK(read(whole).record.said("other images of heights") == "1, not read");
    test::check_sample(read(put(put(whole, 40, little(image, 4)), 36, little(0, 4))), 0.5e-6, 0.25e-6, 1e-10, 0);
}

TEST_CASE("A .vk6 holds a .vk4 in an archive at its end") {
    const std::string whole = test::sample("vk4/map.vk6");
    CHECK(contains(test::refusal([&] { (void)io::detail::read_vk4(whole, "file"); }),
                   "is Keyence VK6, which this program was built without"));
    const auto unzipped = [](std::string_view archive, std::string_view entry) {
        CHECK(archive.starts_with("PK\3\4"));
        CHECK(entry == "Vk4File");
        return test::sample("vk4/map.vk4");
    };
    test::check_sample(io::detail::read_vk4(whole, "file", unzipped), 0.5e-6, 0.25e-6, 1e-10, 0);
    const auto other = [](std::string_view, std::string_view) { return std::string("VK6 again"); };
    CHECK(
        contains(test::refusal([&] { (void)io::detail::read_vk4(whole, "file", other); }), "does not begin with VK4_"));
    const auto damaged = [&](const std::string& bytes) {
        return test::refusal([&] { (void)io::detail::read_vk4(bytes, "file", unzipped); });
    };
    CHECK(contains(damaged("VK7" + std::string(9, '\0')), "has no zip archive after its picture"));
    CHECK(contains(damaged(put(whole, whole.size() - 6, little(5000, 4))), "not where its end states"));
    if (io::reads_x3p()) CHECK(read("VK7" + std::string(7, ' ') + whole.substr(9)).map.rows == 3);
}

TEST_CASE("Files of Keyence that cannot be meant are refused with field, value and range") {
    const std::string whole = test::sample("vk4/map.vk4");
    CHECK(contains(refusal("VK5_"), "does not begin as a file of Keyence VK"));
    CHECK_FALSE(read.begins("VK6000 profile, um"));
    CHECK(contains(refusal(put(whole, 36, little(0, 4))), "holds no image of heights"));
    CHECK(contains(refusal(put(whole, 36, little(-1, 4))), "ends within bits of a height"));
    CHECK(contains(refusal(put(whole, 12, little(-1, 4))), "ends within step of the heights"));
    CHECK(contains(refusal(put(whole, image, little(-1, 4))), "declares 4294967295 x 3 heights of 2 bytes"));
    CHECK(contains(refusal(put(whole, image + 4, little(-1, 4))), "declares 4 x 4294967295"));
    CHECK(contains(refusal(put(whole, image, little(0, 4))), "0 x 3: must be at least 2 x 1"));
    CHECK(contains(refusal(put(whole, image + 8, little(24, 4))), "bits of a height = 24: must be 8, 16 or 32"));
    CHECK(contains(refusal(put(whole, image + 12, little(1, 4))), "compression = 1: must be 0"));
    CHECK(contains(refusal(put(whole, settings + 168, little(0, 4))), "step of x = 0: must be at least 1 pm"));
    CHECK(contains(refusal(put(whole, settings + 172, little(0, 4))), "step of y = 0"));
    CHECK(contains(refusal(put(whole, settings + 176, little(0, 4))), "step of the heights = 0"));
}

}  // namespace vk4_test
