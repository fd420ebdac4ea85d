// SPDX-License-Identifier: BSD-3-Clause
// Files of other programs through the command: the channel of a Gwyddion file as option and as key, and bad files.
#include "command.hpp"

#include <nlohmann/json.hpp>

namespace file_forms_test {

namespace {

const std::string files = FSTIFF_TEST_DATA "/formats/";

std::string decisions(const std::string& arguments) {
    const auto outcome = test::run_fstiff("measure " + arguments);
    INFO("fstiff measure " << arguments << "\n" << outcome.err);
    REQUIRE(outcome.status % 4 == 0);  // a doubtful parameter is accepted here
    return nlohmann::json::parse(outcome.out)["source"]["decisions"].dump();
}

}  // namespace

TEST_CASE("The channel of a Gwyddion file is an option, and a key of a scene") {
    const std::string file = files + "two-channels.gwy";
    CHECK(test::contains(decisions(file), "channel 1 \\\"Height\\\", the lowest whose units are lengths"));
    CHECK(test::contains(decisions(file), "other channels: 0 \\\"Phase\\\" in \\\"deg\\\", not read"));
    CHECK(test::contains(decisions(file + " --channel height"), "channel 1 \\\"Height\\\", from options"));
    const auto phase = test::run_fstiff("measure " + file + " --channel Phase");
    CHECK(phase.status == 3);
    CHECK(test::contains(phase.err, "si_unit_z of channel 0 \"Phase\" = \"deg\": must be a unit of length"));
    const auto useless = test::run_fstiff("measure " + files + "plain.sur --channel 0");
    CHECK(useless.status == 3);
    CHECK(test::contains(useless.err, "no use for channel"));

    const test::Folder folder;
    std::string scene = test::read(FSTIFF_SCENES "/sand_blasted_fine.toml");
    scene.erase(scene.find("[surface]"), scene.find("\n[", scene.find("[surface]")) + 1 - scene.find("[surface]"));
    const auto run = [&](const std::string& keys) {
        return test::run_fstiff("run " +
                                folder.write("scene.toml", scene + "\n[surface]\nfrom = \"" + file + "\"\n" + keys));
    };
    CHECK(test::contains(run("channel = \"Phase\"\n").err, "channel 0 \"Phase\" = \"deg\""));
    CHECK_FALSE(test::contains(run("channel = \"Height\"\n").err, "= \"deg\""));
    CHECK(run("chanel = \"Height\"\n").status == 3);
}

TEST_CASE("Masks, check sums and compression are reported where a file is measured") {
    CHECK(test::contains(decisions(files + "mask.gwy"), "of which 3 missing (3 of them under the mask)"));
    CHECK(test::contains(test::run_fstiff("measure " + files + "mask.gwy").err, "has a mask over 3 points"));
    CHECK(test::contains(decisions(files + "trace.smd"), "check sum: agrees"));
    CHECK(test::contains(decisions(files + "trace.prf"), "stylus radius: 2.000000e-003 mm in the file, not used"));
}

TEST_CASE("A file cut short ends with one sentence and exit code 3, and leaves no output") {
    const test::Folder folder;
    for (const char* name : {"two-channels.gwy", "compressed.sur", "plain.sur", "trace.smd", "trace.prf"}) {
        CAPTURE(name);
        const std::string whole = test::read(files + name);
        const std::string half = folder.write(name, whole.substr(0, whole.size() / 2));
        const auto outcome = test::run_fstiff("measure " + half + " --format csv > " + (folder / "out.csv"));
        CHECK(outcome.status == 3);
        CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
        CHECK(test::read(folder / "out.csv").empty());
        std::filesystem::remove(half);
    }
    CHECK(folder.files() == 1);
}

}  // namespace file_forms_test
