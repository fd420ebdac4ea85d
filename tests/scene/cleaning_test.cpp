// SPDX-License-Identifier: BSD-3-Clause
// crop, mask, spikes and fill of what is measured, and the same keys of a scene.
#include "support/library.hpp"

#include <cmath>

namespace cleaning_test {

namespace {

std::string map_text() { return test::map_text(64, 1e-6, {.hurst = 0.7, .rms = 1e-6, .shortest_wavelength = 4e-6}); }

nlohmann::json measured(const std::string& options, const std::string& input) {
    return test::measured("--lambda-s none --lambda-c none " + options, input);
}
std::string refused(const std::string& options, const std::string& input) {
    return test::refusal([&] { (void)measured(options, input); });
}

/// A wave with one spike, one point a line.
std::string wave(bool spike) {
    std::string text;
    for (int i = 0; i < 400; ++i)
        text += (spike && i == 200 ? "90" : std::to_string(std::sin(0.3 * i) + 0.2 * std::sin(i * i))) + "\n";
    return text;
}

}  // namespace

TEST_CASE("A part of a surface is measured as a file of that part would be") {
    const std::string text = map_text();
    const auto part = measured("--crop '0,31 um,0,39 um'", text);
    CHECK(test::decided(part, "crop: 32 x 40 of 64 x 64 points kept"));
    std::string cut;
    for (const auto& line : test::lines(text)) {
        const bool number = !line.empty() && line[0] != '#';
        static int row;
        if (!number) row = 0;
        if (number && row++ >= 40) continue;
        std::size_t end = 0;
        for (int i = 0; number && i < 32; ++i) end = line.find_first_of(" \t", end + 1);
        cut += (number ? line.substr(0, end) : line) + "\n";
    }
    CHECK(measured("--dx '1 um' --dy '1 um'", cut)["surface"] == part["surface"]);
    const std::string how = "--units um --spacing '1 um'";
    const auto profile = measured(how + " --crop '50 um,299 um'", wave(false));
    CHECK(test::decided(profile, "crop: 250 of 400 points kept"));
    test::check_sentence(refused(how + " --crop '1 um'", wave(false)), {"--crop", "two lengths"});
    test::check_sentence(refused(how + " --crop '1 um,9 mm'", wave(false)), {"--crop", "length"});
    test::check_sentence(refused("--crop '0,1 um'", text), {"--crop", "four lengths"});
}

TEST_CASE("A mask, spikes and filling are done in this order, and reported with their counts") {
    const test::Folder folder;
    const std::string how = "--units um --spacing '1 um'";
    const auto struck = measured(how, wave(true));
    CHECK(test::contains(struck.dump(), "--spikes 20 removes "));
    const auto clean = measured(how + " --spikes 5 --fill", wave(true));
    CHECK(test::decided(clean, "spikes: 1 of 400 points became missing"));
    CHECK(test::decided(clean, "fill: 1 of 400 points filled by straight lines, the largest hole 1"));
    CHECK_FALSE(test::contains(clean.dump(), "--spikes 20 removes "));
    CHECK(test::decided(measured(how + " --spikes 5.5", wave(true)), "beyond 5.5 standard deviations"));
    const double rms = measured(how, wave(false))["surface"]["rms_height"]["value"];
    CHECK(std::abs(clean["surface"]["rms_height"]["value"].get<double>() / rms - 1) < 0.01);
    CHECK(struck["surface"]["rms_height"]["value"].get<double>() > 3 * rms);

    std::string marks;
    for (int j = 0; j < 64; ++j) {
        for (int i = 0; i < 64; ++i) marks += j >= 10 && j < 14 && i < 5 ? "0 " : "1 ";
        marks += "\n";
    }
    const std::string mask = folder.write("mask.txt", marks);
    const auto masked = measured("--mask '" + mask + "'", map_text());
    CHECK(test::decided(masked, "mask: 20 of 4096 points became missing"));
    const auto filled = measured("--fill --mask '" + mask + "'", map_text());
    CHECK(test::decided(filled, "fill: 20 of 4096 points filled by Laplace's equation, the largest hole 20"));
    test::check_sentence(refused("--mask '" + folder.write("short.txt", "1 1\n0 1\n") + "'", map_text()),
                         {"mask has 2 x 2", "64 x 64"});
    test::check_sentence(refused("--mask '" + folder.write("bad.txt", "1 2\n") + "'", map_text()), {"0 and 1 alone"});
}

TEST_CASE("A scene cleans as the command does") {
    const test::Folder folder;
    folder.write("wave.txt", wave(true));
    folder.write("mask.txt", [] {
        std::string marks;
        for (int i = 0; i < 250; ++i) marks += i < 3 ? "0\n" : "1\n";
        return marks;
    }());
    const auto scene = test::scene_of(
        "[surface]\nfrom = \"wave.txt\"\nunits = \"um\"\nspacing = \"1 um\"\nspikes = 5\nfill = true\n"
        "crop = \"50 um,299 um\"\nmask = \"mask.txt\"\n[material.upper]\nyoungs_modulus = \"205 GPa\"\n"
        "poisson_ratio = 0.3\n[contact]\npressures = [\"10 MPa\"]\nlaws = [\"hertz\"]\n",
        folder / "scene.toml");
    REQUIRE(test::face(scene).measured);
    const std::string decisions = test::joined(test::measured_of(scene).decisions);
    for (const char* words : {"crop: 250 of 400", "mask: 3 of 250", "spikes: 1 of 250", "fill: 4 of 250"})
        CHECK(test::contains(decisions, words));
}

}  // namespace cleaning_test
