// SPDX-License-Identifier: BSD-3-Clause
#include "cli/command.hpp"
#include "support/skip.hpp"

#include <fstiff/core/version.hpp>

TEST_CASE("The example at the end of every --help works as pasted") {
    for (const std::string subcommand : {"", "run ", "measure ", "fit ", "islands ", "peaks ", "integral ", "generate ",
                                         "ultrasound ", "identify ", "reproduce ", "report "}) {
        const auto help = test::fstiff(subcommand + "--help");
        INFO("fstiff " << subcommand << "--help\n" << help.out);
        CHECK(help.status == 0);
        CHECK(help.err.empty());
        const auto start = help.out.rfind("Example:\n");
        REQUIRE(start != std::string::npos);
        const std::string example = help.out.substr(start + 9);
        CHECK(test::contains(example, "fstiff " + subcommand));
        const test::Folder folder;  // for what an example writes
        const auto outcome = test::shell("cd '" + folder / "" + "' || exit 1\n" + example);
        INFO(example << outcome.err);
        CHECK(outcome.status == 0);
        CHECK(test::lines(outcome.out).size() >= 2);
    }
}

TEST_CASE("The version is that of the library") {
    CHECK(test::fstiff("--version").out == "fstiff " FSTIFF_VERSION "\n");
}

TEST_CASE("Wrong use ends with exit code 2 and one sentence") {
    test::check_refused("nonsense", 2, {"nonsense", "--help"});
    test::check_refused("run --speed 3", 2, {"--speed", "fstiff run --help"});
    test::check_refused("run --format xml", 2, {"--format", "xml"});
    test::check_refused("run a.toml b.toml", 2, {"b.toml"});
    const auto bare = test::fstiff("");
    CHECK(bare.status == 2);
    CHECK(bare.out.empty());
}

TEST_CASE("A full disk is reported, not taken for success") {
    if (!std::filesystem::exists("/dev/full")) SKIP_CASE("there is no /dev/full");
    const auto outcome = test::shell("fstiff run > /dev/full");
    CHECK(outcome.status == 3);
    CHECK(test::contains(outcome.err, "standard output"));
}
