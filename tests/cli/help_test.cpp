// SPDX-License-Identifier: BSD-3-Clause
#include "cli/command.hpp"
#include "support/skip.hpp"

#include <fstiff/core/version.hpp>

namespace help_test {

TEST_CASE("The example at the end of every --help works as pasted") {
    for (const std::string subcommand :
         {"", "run ", "measure ", "fit ", "islands ", "spectrum ", "peaks ", "generate ", "ultrasound ", "identify ",
          "reproduce ", "report ", "formats ", "export ", "sweep ", "merge ", "help "}) {
        const auto help = test::run_fstiff(subcommand + "--help");
        INFO("fstiff " << subcommand << "--help\n" << help.out);
        CHECK(help.status == 0);
        CHECK(help.err.empty());
        const auto start = help.out.rfind("Example:\n");
        REQUIRE(start != std::string::npos);
        const std::string example = help.out.substr(start + 9);
        CHECK(test::contains(example, "fstiff " + subcommand.substr(0, subcommand.find(' '))));
        const test::Folder folder;  // for what an example writes
        const auto outcome = test::shell("cd '" + folder / "" + "' || exit 1\n" + example);
        INFO(example << outcome.err);
        CHECK(outcome.status == 0);
        CHECK(test::lines(outcome.out).size() >= 2);
    }
}

TEST_CASE("The version is that of the library") {
    for (const char* way : {"--version", "-V", "version"})
        CHECK(test::run_fstiff(way).out == "fstiff " FSTIFF_VERSION_TEXT "\n");
}

TEST_CASE("Wrong use ends with exit code 2 and one sentence") {
    test::check_refused("nonsense", 2, {"nonsense", "--help"});
    test::check_refused("run --speed 3", 2, {"--speed", "fstiff run --help"});
    test::check_refused("run --format xml", 2, {"--format", "xml"});
    test::check_refused("run a.toml b.toml", 2, {"b.toml"});
}

TEST_CASE("A file whose name begins with - is refused with the way to give it") {
    const test::Folder folder;
    folder.write("-dash.csv", "1\n2\n");
    for (const std::string command : {"measure", "run"}) {
        const auto outcome = test::shell("cd '" + folder / "" + "' && fstiff " + command + " -dash.csv");
        INFO(outcome.err);
        CHECK(outcome.status == 2);
        CHECK(test::contains(outcome.err, "is given as ./-dash.csv"));
    }
}

TEST_CASE("A wrong word is answered with the nearest right one") {
    test::check_refused("masure", 2, {"masure", "did you mean measure?"});
    test::check_refused("reprot", 2, {"did you mean report?"});
    test::check_refused("run --formt csv", 2, {"--formt", "did you mean --format?"});
    test::check_refused("fit x --widnow=1", 2, {"did you mean --window?"});
    test::check_refused("--vresion", 2, {"did you mean --version?"});
    const auto help = test::run_fstiff("help msure");
    CHECK(help.status == 2);
    CHECK(help.out.empty());
    CHECK(test::contains(help.err, "msure: is not a subcommand or option"));
    CHECK(test::contains(help.err, "did you mean measure?"));
    CHECK_FALSE(test::contains(test::run_fstiff("quaternion").err, "did you mean"));
    CHECK_FALSE(test::contains(test::run_fstiff("run --zzzzzz").err, "did you mean"));
}

TEST_CASE("help prints what --help prints") {
    const auto bare = test::run_fstiff("");
    CHECK(bare.status == 0);
    CHECK(bare.out == test::run_fstiff("--help").out);
    CHECK(test::run_fstiff("help").out == bare.out);
    for (const std::string command : {"run", "generate", "formats"}) {
        const auto help = test::run_fstiff("help " + command);
        CHECK(help.status == 0);
        CHECK(help.out == test::run_fstiff(command + " --help").out);
    }
    CHECK(test::contains(test::run_fstiff("--help").out, "kg/(m^2 s), Rayl, MRayl"));
}

TEST_CASE("--help lists the commands under what they are for, and the older names in a line") {
    const std::string help = test::run_fstiff("--help").out;
    std::size_t last = 0;
    for (const char* part :
         {"\nCompute:\n  run ", "\n  report ", "\n  ultrasound ", "\nSurfaces:\n  measure ", "\n  generate ",
          "\nMeasured K:\n  identify ", "\nChecks:\n  truth ", "\nHelp:\n  help ", "\nOlder names: fit, islands"}) {
        INFO(part << "\n" << help);
        const auto at = help.find(part, last);
        REQUIRE(at != std::string::npos);
        last = at;
    }
    for (const char* name : {"\n  fit ", "\n  islands ", "\n  peaks ", "\n  spectrum ", "\n  merge "})
        CHECK_FALSE(test::contains(help, name));
    CHECK(test::contains(test::run_fstiff("measure --show islands --help").out, "--neighbours"));
    test::check_refused("measure x --show all", 2, {"--show", "fit,islands,peaks,spectrum"});
    test::check_refused("measure x --show fit --nieghbours 8", 2, {"--nieghbours", "fstiff fit --help"});
    test::check_refused("measure x --show", 2, {"--show"});
}

TEST_CASE("measure --show and sweep --merge are the commands of older names") {
    const test::Folder folder;
    const std::string map = folder.write(
        "map.txt", test::run_fstiff("generate map --points 64 --spacing '1 um' --hurst 0.8 --rms '1 um' --shortest "
                                    "'6 um' --longest '20 um'")
                       .out);
    const std::string trace = folder.write(
        "trace.txt", test::run_fstiff("generate profile --points 1024 --spacing '1 um' --hurst 0.5 --rms '1 um'").out);
    const auto same = [&](const std::string& now, const std::string& before, int status = 0) {
        INFO(now);
        const auto a = test::run_fstiff(now), b = test::run_fstiff(before);
        CHECK(a.status == status);
        CHECK(a.out == b.out);
        CHECK(a.err == b.err);
        CHECK(a.out.size() > 200);
    };
    same("measure '" + trace + "' --show fit --format json --seed 3", "fit '" + trace + "' --format json --seed 3");
    same("measure --show=spectrum '" + map + "' --of acf", "spectrum '" + map + "' --of acf");
    same("measure --show islands '" + map + "' --border drop --levels 30",
         "islands '" + map + "' --border drop --levels 30");
    same("measure '" + trace + "' --heights=-4,4,9 --show peaks", "peaks --profile '" + trace + "' --heights=-4,4,9");
    const std::string sweep = "cd '" + (folder / "") +
                              "' && fstiff sweep --example > grid.toml && for i in 1 2; do fstiff "
                              "sweep grid.toml --shard $i/2 -o p$i.jsonl || exit 1; done >/dev/null 2>&1 && fstiff ";
    const auto merged = test::shell(sweep + "sweep -o a.jsonl --merge p1.jsonl p2.jsonl");
    INFO(merged.err);
    CHECK(merged.status == 0);
    CHECK(test::contains(merged.out, "of 2 shards in a.jsonl"));
    CHECK(test::shell("cd '" + (folder / "") + "' && fstiff merge p1.jsonl p2.jsonl -o b.jsonl && cmp a.jsonl b.jsonl")
              .status == 0);
}

TEST_CASE("measure prints a table on a terminal, JSON into a pipe and a file, and the form of --format otherwise") {
    if (test::shell("script -qec true /dev/null").status != 0) SKIP_CASE("`script` makes no terminal here");
    const test::Folder folder;
    const std::string trace = folder.write(
        "trace.txt", test::run_fstiff("generate profile --points 1024 --spacing '1 um' --hurst 0.5 --rms '1 um'").out);
    const auto on_terminal = [&](const std::string& options) {
        const std::string shown =
            test::shell("script -qec \"'" FSTIFF_COMMAND "' measure '" + trace + "' " + options + "\" /dev/null").out;
        return test::contains(shown, "\x1b[K") ? shown.substr(shown.rfind("\x1b[K") + 3) : shown;  // after the bar
    };
    const std::string piped = test::run_fstiff("measure '" + trace + "'").out;
    CHECK(piped.starts_with("{"));
    CHECK(test::contains(on_terminal(""), ": surface of "));
    CHECK(test::contains(on_terminal("--format json"), "\"command\""));
    CHECK(test::contains(on_terminal("--format csv"), "parameter,value,error"));
    (void)on_terminal("-o '" + folder / "out.json" + "'");
    CHECK(test::read(folder / "out.json") == piped);
}

TEST_CASE("No help points at a file that is not installed") {
    for (const std::string command :
         {"", "run ", "measure ", "fit ", "islands ", "spectrum ", "peaks ", "generate ", "ultrasound ", "identify ",
          "reproduce ", "report ", "formats ", "export ", "sweep ", "merge ", "help "})
        for (const char* folder : {"docs/", "data/", "README"}) {
            INFO(command << folder);
            CHECK_FALSE(test::contains(test::run_fstiff(command + "--help").out, folder));
        }
}

TEST_CASE("run --example prints a scene that runs, also with all that is commented out in it") {
    const auto example = test::run_fstiff("run --example");
    REQUIRE(example.status == 0);
    const auto run = test::run_fstiff("run - --format csv", example.out);
    INFO(run.err);
    CHECK(run.status == 0);
    CHECK(test::lines(run.out).size() == 1 + 13);

    // "#: key = value" goes to the section above it, "#: [section]" begins one
    std::string all;
    std::size_t taken = 0;
    for (const std::string& line : test::lines(example.out))
        if (line.starts_with("#: "))
            all += line.substr(3) + "\n", ++taken;
        else
            all += line + "\n";
    CHECK(taken == 12);
    const auto full =
        test::run_fstiff("run - --format csv", test::replaced(all, "\"contacts\"]", "\"contacts\", \"reflection\"]"));
    INFO(full.err);
    CHECK(full.status == 0);
    CHECK(test::contains(full.out, "reflection_p05"));
    test::check_refused("run scene.toml --example", 2, {"--example", "computes nothing"});
}

TEST_CASE("formats lists every form that --input-format takes") {
    const auto list = test::run_fstiff("formats --format csv");
    CHECK(list.status == 0);
    for (const char* name : {"profile", "triples", "matrix", "sdf", "x3p", "npy", "gsf", "sur", "scene"}) {
        INFO(name);
        CHECK(test::contains(list.out, "\n" + std::string(name) + ","));
        CHECK(test::contains(test::run_fstiff("formats").out, "\n" + std::string(name) + "  ("));
        CHECK(test::contains(test::run_fstiff("formats --format json").out, "\"" + std::string(name) + "\""));
    }
}

}  // namespace help_test
