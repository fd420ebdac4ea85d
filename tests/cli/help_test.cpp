// SPDX-License-Identifier: BSD-3-Clause
#include "cli/command.hpp"
#include "support/skip.hpp"

#include <fstiff/asperity/named_materials.hpp>
#include <fstiff/core/version.hpp>
#include <fstiff/surface/process_prior.hpp>

#include <nlohmann/json.hpp>

#include <map>
#include <regex>

namespace help_test {

const std::vector<std::string> commands{"",
                                        "run",
                                        "measure",
                                        "measure --show fit",
                                        "measure --show islands",
                                        "measure --show spectrum",
                                        "generate",
                                        "ultrasound",
                                        "identify",
                                        "truth",
                                        "formats",
                                        "export",
                                        "sweep",
                                        "help"};

TEST_CASE(
    "The example at the end of every --help works as pasted, and no help points at a file that is not installed") {
    for (const std::string& command : commands) {
        const auto help = test::run_fstiff(command + " --help");
        INFO("fstiff " << command << " --help\n" << help.out);
        CHECK(help.status == 0);
        CHECK(help.err.empty());
        for (const char* folder : {"docs/", "data/", "README"})  // which are not installed
            CHECK_FALSE(test::contains(help.out, folder));
        const auto start = help.out.rfind("Example:\n");
        REQUIRE(start != std::string::npos);
        const std::string example = help.out.substr(start + 9);
        CHECK(test::contains(example, "fstiff " + command));
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

TEST_CASE("A flag takes no value") {
    for (const std::string flag : {"fill", "resample", "scales"})
        for (const std::string value : {"2-1", "3.7", "'1 MPa'", "false"})
            test::check_refused("measure x --" + flag + "=" + value, 2, {"--" + flag + " takes no value"});
    test::check_refused("run --full=1", 2, {"--full takes no value"});
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
    test::check_refused("run --formt csv", 2, {"--formt", "did you mean --format?"});
    test::check_refused("measure --show fit x --widnow=1", 2, {"did you mean --window?"});
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
    for (const std::string command : {"run", "generate", "formats", "measure --show fit"}) {
        const auto help = test::run_fstiff("help " + command);
        CHECK(help.status == 0);
        CHECK(help.out == test::run_fstiff(command + " --help").out);
        CHECK(help.out == test::run_fstiff("--help " + command).out);
        CHECK(help.out == test::run_fstiff("-h " + command).out);
    }
    CHECK(test::contains(test::run_fstiff("--help").out, "with a 90 % band"));
}

TEST_CASE("The list of --help has the commands under what they are for") {
    const std::string help = test::run_fstiff("--help").out;
    std::size_t last = 0;
    for (const char* part : {"\nCompute:\n  run ", "\n  ultrasound ", "\nSurfaces:\n  measure ", "\n  generate ",
                             "\nMeasured K:\n  identify ", "\nChecks:\n  truth ", "\nHelp:\n  formats ", "\n  help "}) {
        INFO(part << "\n" << help);
        const auto at = help.find(part, last);
        REQUIRE(at != std::string::npos);
        last = at;
    }
    CHECK_FALSE(test::contains(help, "--show"));
    CHECK(test::contains(test::run_fstiff("measure --show islands --help").out, "--neighbours"));
    test::check_refused("measure x --show all", 2, {"--show", "\"fit\", \"islands\", \"spectrum\""});
    test::check_refused("measure x --show fit --nieghbours 8", 2, {"--nieghbours", "fstiff measure --show fit --help"});
    test::check_refused("measure x --show", 2, {"--show"});
}

TEST_CASE("A name of former times ends with the call that took its place") {
    for (const auto& [name, call] : std::map<std::string, std::string>{{"fit", "fstiff measure --show fit,"},
                                                                       {"islands", "fstiff measure --show islands,"},
                                                                       {"peaks", "PeakDistribution of the C++ library"},
                                                                       {"spectrum", "fstiff measure --show spectrum,"},
                                                                       {"merge", "cat part-*.jsonl > all.jsonl,"},
                                                                       {"reproduce", "examples/paper/reproduce.py"},
                                                                       {"integral", "example_integral"}})
        for (const std::string& words : {name, name + " x"}) test::check_refused(words, 2, {name + ": ", call});
}

TEST_CASE("The option that makes another command may be anywhere in the line") {
    const test::Folder folder;
    const std::string trace = folder.write(
        "trace.txt", test::run_fstiff("generate profile --points 1024 --spacing '1 um' --hurst 0.5 --rms '1 um'").out);
    const auto first = test::run_fstiff("measure --show fit '" + trace + "' --format json --seed 3");
    CHECK(first.status == 0);
    CHECK(test::contains(first.out, "\"command\": \"fit\""));
    for (const std::string words : {"measure '" + trace + "' --format json --seed 3 --show fit",
                                    "measure '" + trace + "' --show=fit --seed 3 --format json"})
        CHECK(test::run_fstiff(words).out == first.out);
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

TEST_CASE("help prints the tables of materials, processes and units, which are those of the library") {
    const std::string materials = test::run_fstiff("help materials").out;
    for (const auto& material : fstiff::detail::named_materials) {
        INFO(material.name);
        CHECK(test::contains(materials, " " + std::string(material.name) + "  "));
        CHECK(test::contains(materials, "\n  " + std::string(material.name) + ": "));
        const std::string names(material.other_names), first = names.substr(0, names.find(' ', 1));
        CHECK(test::contains(test::as_one_line(materials), first));
    }
    // 205 HB of 1.05 HV of 1.0785 * 9.80665 MPa, 1.25 times as hard where it is machined
    CHECK(std::regex_search(materials, std::regex(" C45 +205 +0.3 +2.8[45]")));
    CHECK(test::contains(materials, "[K] Kaye"));
    const std::string processes = test::run_fstiff("help processes").out;
    for (const auto& process : fstiff::enum_names<fstiff::Process>)
        CHECK(test::contains(processes, " " + std::string(process.name) + " "));
    CHECK(test::contains(processes, "0.79 (0.74 to 0.82)"));
    for (const char* word : {"reamed", "EDM", "shot peened", "scraped", "rolled", "geschliffen"})
        CHECK(test::contains(processes, word));
    CHECK(test::contains(test::run_fstiff("help units").out, "kg/(m^2 s), Rayl, MRayl"));
    CHECK(test::run_fstiff("--help materials").out == materials);
    for (const std::string topic : {"materials", "processes", "units"}) {
        for (const std::string& line : test::lines(test::run_fstiff("help " + topic).out)) CHECK(line.size() <= 124);
        test::check_refused(topic, 2, {topic + ": is fstiff help " + topic});
        const auto manual = test::run_fstiff("help " + topic + " --man");
        CHECK(manual.status == 2);
        CHECK(test::contains(manual.err, "no manual page; fstiff help " + topic));
    }
}

TEST_CASE("The options of measure are in groups") {
    const std::string help = test::run_fstiff("measure --help").out;
    std::size_t last = 0;
    for (const char* part :
         {"\nReading:\n", "\n  --units", "\nCleaning:\n", "\n  --fill", "\nForm, cut-offs:\n", "\n  --detrend",
          "\n  --lambda-c", "\nEstimates:\n", "\nAnalyses:\n", "\n  --scales", "\nOutput:\n", "\n  --format"}) {
        INFO(part << "\n" << help);
        const auto place = help.find(part, last);
        REQUIRE(place != std::string::npos);
        last = place;
    }
}

TEST_CASE("run --example prints a scene that runs, also with all that is commented out in it") {
    // "#: key = value" goes to the section above it, "#: [section]" begins one
    const auto with_all = [](const std::string& scene, std::size_t count) {
        std::string all;
        std::size_t taken = 0;
        for (const std::string& line : test::lines(scene)) {
            const bool optional = line.starts_with("#: ");
            all += (optional ? line.substr(3) : line) + "\n", taken += optional;
        }
        CHECK(taken == count);
        return all;
    };
    const auto run = [](const std::string& scene, const std::string& format) {
        const auto outcome = test::run_fstiff("run - --format " + format, scene);
        INFO(outcome.err);
        CHECK(outcome.status == 0);
        return outcome.out;
    };
    const std::string joint = test::run_fstiff("run --example").out,
                      paper = test::run_fstiff("run --example paper").out;
    CHECK(test::run_fstiff("run --example joint").out == joint);
    // the joint is that of the first page
    const auto answer = [&](const std::string& scene) { return nlohmann::json::parse(run(scene, "json"))["answer"]; };
    CHECK(answer(joint) == answer(test::read(FSTIFF_SCENES "/flanged_joint.toml")));
    CHECK(test::contains(run(with_all(joint, 10), "csv"), "reflection_p05"));
    CHECK(test::lines(run(paper, "csv")).size() == 1 + 13);
    CHECK(test::contains(
        run(test::replaced(with_all(paper, 12), "\"contacts\"]", "\"contacts\", \"reflection\"]"), "csv"),
        "reflection_p05"));
    test::check_refused("run scene.toml --example", 2, {"--example", "computes nothing"});
    test::check_refused("run --example papr", 2,
                        {"--example = \"papr\"", "\"joint\", \"paper\"", "did you mean paper?"});
}

TEST_CASE("formats lists every form that --input-format takes") {
    const auto text = test::run_fstiff("formats"), list = test::run_fstiff("formats --format csv"),
               json = test::run_fstiff("formats --format json");
    CHECK(list.status == 0);
    CHECK(test::contains(text.out, "The first eighteen are") ==
          (fstiff::enum_names<fstiff::io::SurfaceFormat>.size() == 19));
    for (const std::string_view name : fstiff::detail::choices<fstiff::io::SurfaceFormat>()) {
        if (name == "auto") continue;
        INFO(name);
        CHECK(test::contains(list.out, "\n" + std::string(name) + ","));
        CHECK(test::contains(text.out, "\n" + std::string(name) + "  ("));
        CHECK(test::contains(json.out, "\"" + std::string(name) + "\""));
    }
}

}  // namespace help_test
