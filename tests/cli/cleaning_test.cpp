// SPDX-License-Identifier: BSD-3-Clause
// --crop, --mask, --spikes and --fill of the commands that measure, and the same keys of a scene.
#include "command.hpp"

#include <nlohmann/json.hpp>

namespace cleaning_test {

namespace {

std::string map_text() {
    return test::run_fstiff("generate map --points 64 --spacing '1 um' --hurst 0.7 --rms '1 um' --shortest '4 um'").out;
}

nlohmann::json measured(const std::string& options, const std::string& input) {
    const auto outcome = test::run_fstiff("measure - --lambda-s none --lambda-c none " + options, input);
    INFO(options << "\n" << outcome.err);
    REQUIRE(outcome.status % 4 == 0);
    return nlohmann::json::parse(outcome.out);
}

bool decided(const nlohmann::json& document, const std::string& words) {
    for (const std::string line : document["source"]["decisions"])
        if (test::contains(line, words)) return true;
    return false;
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
    CHECK(decided(part, "crop: 32 x 40 of 64 x 64 points kept"));
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
    CHECK(decided(profile, "crop: 250 of 400 points kept"));
    test::check_refused("measure - " + how + " --crop '1 um'", 3, {"--crop", "two lengths"}, wave(false));
    test::check_refused("measure - " + how + " --crop '1 um,9 mm'", 3, {"--crop", "length"}, wave(false));
    test::check_refused("measure - --crop '0,1 um'", 3, {"--crop", "four lengths"}, text);
}

TEST_CASE("A mask, spikes and filling are done in this order, and told with their counts") {
    const test::Folder folder;
    const std::string how = "--units um --spacing '1 um'";
    const auto struck = measured(how, wave(true));
    CHECK(test::contains(struck.dump(), "--spikes 20 takes such points out"));
    const auto clean = measured(how + " --spikes 5 --fill", wave(true));
    CHECK(decided(clean, "spikes: 1 of 400 points became missing"));
    CHECK(decided(clean, "fill: 1 of 400 points filled by straight lines, the largest hole 1"));
    CHECK_FALSE(test::contains(clean.dump(), "takes such points out"));
    CHECK(decided(measured(how + " --spikes 5.5", wave(true)), "beyond 5.5 standard deviations"));
    test::check_refused("measure - " + how + " --spikes 2.5", 2, {"--spikes: Value 2.5 not in range 3 to 1000;"},
                        wave(true));
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
    CHECK(decided(masked, "mask: 20 of 4096 points became missing"));
    const auto filled = measured("--fill --mask '" + mask + "'", map_text());
    CHECK(decided(filled, "fill: 20 of 4096 points filled by Laplace's equation, the largest hole 20"));
    test::check_refused("measure - --mask '" + folder.write("short.txt", "1 1\n0 1\n") + "'", 3,
                        {"mask has 2 x 2", "64 x 64"}, map_text());
    test::check_refused("measure - --mask '" + folder.write("bad.txt", "1 2\n") + "'", 3, {"0 and 1 alone"},
                        map_text());
    const auto over = test::run_fstiff("measure - --mask '" + mask + "' -o '" + mask + "'", map_text());
    CHECK(over.status == 3);
    CHECK(test::contains(over.err, "would be written over"));
    CHECK(test::read(mask) == marks);
}

TEST_CASE("A scene cleans as the command does") {
    const test::Folder folder;
    folder.write("wave.txt", wave(true));
    folder.write("mask.txt", [] {
        std::string marks;
        for (int i = 0; i < 250; ++i) marks += i < 3 ? "0\n" : "1\n";
        return marks;
    }());
    const std::string scene =
        folder.write("scene.toml",
                     "[surface]\nfrom = \"wave.txt\"\nunits = \"um\"\nspacing = \"1 um\"\nspikes = 5\nfill = "
                     "true\ncrop = \"50 um,299 "
                     "um\"\nmask = \"mask.txt\"\n[material.upper]\nyoungs_modulus = \"205 GPa\"\npoisson_ratio = "
                     "0.3\n[contact]\npressures = [\"10 MPa\"]\nlaws = [\"hertz\"]\n");
    const auto outcome = test::run_fstiff("run '" + scene + "' --format json");
    INFO(outcome.err);
    REQUIRE(outcome.status % 4 == 0);
    for (const char* words : {"crop: 250 of 400", "mask: 3 of 250", "spikes: 1 of 250", "fill: 4 of 250"})
        CHECK(test::contains(outcome.out, words));
}

}  // namespace cleaning_test
