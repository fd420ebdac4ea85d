// SPDX-License-Identifier: BSD-3-Clause
// Text that Zygo MetroPro and Mx export, of tools/make_surface_samples.py, and as prysm writes it.
#include "support/samples.hpp"

namespace zygo_test {

using namespace fstiff;
using test::contains;
using test::replaced;

namespace {

const test::FormReader read{io::SurfaceFormat::zygo};
const test::RefusalOf refusal(read);
std::string whole() { return test::sample("zygo/map.asc"); }
std::string with(const std::string& from, const std::string& to) { return replaced(whole(), from, to); }

/// The resolution and the sign, in line 11.
const std::string processing = "1 0 7 2 100 0 0 0 0";

}  // namespace

TEST_CASE("Heights of Zygo ASCII are those of the binary form with the same counts") {
    const io::Reading text = read(whole()),
                      binary = test::FormReader{io::SurfaceFormat::metropro}(test::sample("metropro/map.dat"));
    for (std::size_t i = 0; i < text.map.heights.size(); ++i) {
        const double z = text.map.heights[i], other = binary.map.heights[i];  // of single precision
        CHECK((std::isnan(z) ? std::isnan(other) : std::abs(z - other) <= 1e-7 * std::abs(other)));
    }
    CHECK(contains(text.record.said("form"), "part \"a plate\""));
    CHECK(test::ulps(text.record.resolution, 5e-7 / 32768) <= 1);
    for (const auto& [code, levels] : {std::pair{"0", 4096.0}, {"2", 131072.0}})
        CHECK(test::ulps(read(with(processing, code + processing.substr(1))).map.at(1, 0), 10 * (5e-7 / levels)) <= 2);
    CHECK(read(whole() + "more").record.said("trailer") == "4 bytes, not read");
    CHECK(contains(read(with("\"a plate   \"", "\"")).record.said("form"), "Zygo ASCII"));
}

TEST_CASE("A file as prysm writes it is count times half a wavelength over 32768") {
    // no intensities, ten counts a line, a last line without its blank
    const std::string file =
        "Zygo ASCII Data File - Format 2\n0 0 0 0 \"Sun Nov 29 07:31:50 2026\"\n0 0 0 0 0 0\n0 0 3 4\n\" \"\n\" \"\n\" "
        "\"\n"
        "0 0.5 6.328e-07 0 1 0 1.5e-06 1796000000\n3 4 0 0 0 0 \" \"\n0 0 0 0 0 0 0 0 0 0\n1 1 20 2 0 0 0 0 0\n0 \" "
        "\"\n"
        "1 0\n\" \"\n#\n#\n1 2 -3 4 5 6 7 2147483640 9 10 \n11 12\n#\n";
    const io::Surface found = test::FileReader()(file);
    REQUIRE((found.map().rows() == 4 && found.map().columns() == 3));
    CHECK(test::ulps(found.map().dx, 1.5e-6) == 0);
    CHECK(test::relative_error(found.map().heights(0, 2), -3 * 0.5 * 632.8e-9 / 32768) < 1e-15);
    CHECK(std::isnan(found.map().heights(2, 1)));
    CHECK(found.record.format_from == "the first bytes");
}

TEST_CASE("An inverted sign of Zygo ASCII turns the heights over with a warning") {
    const io::Reading found = read(with(processing, "1 0 7 2 100 0 0 1 0"));
    CHECK(found.map.at(1, 0) < 0);
    CHECK(found.record.warnings.size() == 1);
}

TEST_CASE("Headers of Zygo ASCII that cannot be meant are refused with line, value and range") {
    CHECK(contains(refusal("nothing"), "does not begin as Zygo ASCII"));
    CHECK(contains(refusal("Zygo ASCII Data File\n#\n"), "line 2: is the end of the header"));
    std::string lines = "Zygo ASCII Data File\n";
    for (int i = 0; i < 30; ++i) lines += "0\n";
    CHECK(contains(refusal(lines), "has no line # after its header"));
    CHECK(contains(refusal(with("0 0 4 3", "0 0 4")), "line 4: rows \"\" is no number"));
    CHECK(contains(refusal(with("0 0 4 3", "0 0 4 2.5")), "rows = 2.5: must be a whole number"));
    CHECK(contains(refusal(with("0 0 4 3", "0 0 4294967295 4294967295")), "declares 4294967295 x 4294967295 heights"));
    CHECK(contains(refusal(with("0 0 4 3", "0 0 4 2")), "declares 4 x 2 heights, but holds 12"));
    CHECK(contains(refusal(with("0 0 4 3", "0 0 1 12")), "2 a row at least"));
    CHECK(contains(refusal(with("0.5 5e-07", "0 5e-07")), "scale factor of the interferometer = 0"));
    CHECK(contains(refusal(with("0.5 5e-07", "0.5 0.5")), "wavelength = 0.5: must be in m, from 1e-7 to 1e-4"));
    CHECK(contains(refusal(with("5e-07 1787", "0 1787")), "step of x and y = 0: must be finite and greater than 0"));
    CHECK(contains(refusal(with(processing, "3" + processing.substr(1))), "phase resolution = 3: must be 0, 1 or 2"));
    CHECK(contains(refusal(with(processing, "1e300" + processing.substr(1))), "phase resolution = 1e+300"));
    CHECK(contains(refusal(with("10 11", "10 word")), "is \"word\"; must be a number"));
    const std::string cut = whole().substr(0, whole().size() - 3);
    CHECK(contains(refusal(cut), "has no line # after the heights; must be whole"));
}

}  // namespace zygo_test
