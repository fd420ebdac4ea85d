// SPDX-License-Identifier: BSD-3-Clause
// fstiff measure as a process: pipes, exit codes and forms of output. tests/scene/measure_test.cpp has its numbers and
// sentences.
#include "json.hpp"

#include <algorithm>
#include <sstream>

namespace measure_test {

namespace {

const std::string rest =
    "[material.upper]\nyoungs_modulus = \"205 GPa\"\npoisson_ratio = 0.3\n"
    "[contact]\npressures = [\"1 MPa\", \"10 MPa\"]\nlaws = [\"hertz\"]\n";

}  // namespace

TEST_CASE("The JSON of measure goes through a pipe into run, and from a file into a scene") {
    const test::Folder folder;
    folder.write("from_json.toml", "[surface]\nfrom = \"measured.json\"\n" + rest);
    const auto outcome = test::shell(
        "cd '" + (folder / "") +
        "' && fstiff generate map --points 64 --spacing '1 um' --hurst 0.7 --rms '1 um' > map.txt"
        " && { fstiff measure map.txt -o measured.json; fstiff run from_json.toml --format csv -o file.csv; }"
        "; fstiff measure - < map.txt | fstiff run from_json.toml --surface - --format csv");
    INFO(outcome.err);
    CHECK(outcome.status % 4 == 0);
    CHECK(test::Csv(outcome.out).size() == 2 + 2);  // of the answer, and of the law that is named
    CHECK(test::read(folder / "file.csv") == outcome.out);
}

TEST_CASE("Endless input ends at once") { test::check_refused("measure /dev/zero", 3, {"/dev/zero", "is binary"}); }

TEST_CASE("A fault of the call ends measure, truth and run with exit code 2, one of the data with 3") {
    const test::Folder folder;
    test::check_refused("measure -", 3, {"standard input", "empty"});
    test::check_refused("run - --surface -", 2, {"standard input"}, "[surface]\n" + rest);
    const std::string made =
        test::run_fstiff("generate profile --points 600 --spacing '1 um' --hurst 0.5 --rms '1 um'").out;
    test::check_refused("measure - --resamples 1", 2, {"--resamples"}, made);
    test::check_refused("measure - --column 4097", 2, {"--column"}, made);
    test::check_refused("measure - --spikes 2.5", 2, {"--spikes = 2.5: must be a number from 3 to 1000;"}, made);
    test::check_refused("measure - --filter spline", 2, {"--filter", "spline"}, made);
    test::check_refused("measure - --window '10 um'", 2, {"--window = \"10 um\": must be two lengths"}, made);
    test::check_refused("measure - --spacing '-1 um'", 3, {"--spacing = \"-1 um\": must be greater than 0"}, made);
    test::check_refused("measure - --scales --pressure '-1 MPa'", 3,
                        {"--pressure = \"-1 MPa\": must be greater than 0"}, made);
    test::check_refused("truth - --pressures='-5 MPa'", 3, {"--pressures = \"-5 MPa\": must be greater than 0"}, made);
    test::check_refused("truth - --pressures '1,5 MPa'", 3,
                        {"--pressures = \"1,5 MPa\": every pressure needs its unit, and the point"}, made);
    const std::string mask = folder.write("mask.txt", "1 1\n0 1\n");
    const auto over = test::run_fstiff("measure - --mask '" + mask + "' -o '" + mask + "'", made);
    CHECK(over.status == 3);
    CHECK(test::contains(over.err, "would be written over"));
    CHECK(test::read(mask) == "1 1\n0 1\n");
}

TEST_CASE("That R and D_p of islands represent nothing ends measure, islands, run and identify with exit code 4") {
    const test::Folder folder;
    const std::string map = folder.write("hills.txt", test::two_hills()), file = folder / "hills.json";
    const std::string options = " --units um,nm --dx '1 um' --dy '1 um'";
    CHECK(test::run_fstiff("measure '" + map + "'" + options + " -o '" + file + "'").status == 4);
    // sigma, R and D_p, which are known to half their values at best, with two digits
    const auto shown = test::run_fstiff("measure '" + map + "'" + options + " --format table");
    CHECK(shown.status == 4);
    const auto digits = [&](const std::string& name) {
        std::istringstream row(shown.out.substr(shown.out.find(name) + name.size()));
        std::string value;
        row >> value;
        value = value.substr(0, value.find('e'));
        return std::count_if(value.begin(), value.end(), [](char c) { return c >= '0' && c <= '9'; });
    };
    CHECK(digits("rms_height") <= 3);
    CHECK(digits("peak_radius") <= 3);  // such as 0.12
    const auto repeats = [&](const std::string& call) {
        const auto outcome = test::run_fstiff(call);
        INFO(call << "\n" << outcome.out << outcome.err);
        CHECK(outcome.status == 4);
        CHECK(test::contains(test::as_one_line(outcome.out + outcome.err), "must not be used as a pair"));
    };
    repeats("measure --show islands '" + map + "'" + options);
    // the answer rests on neither R nor D_p, but on sigma, which two hills do not show; laws that are named rest on all
    const auto answer = test::run_fstiff("run --surface '" + file + "'");
    CHECK(answer.status == 4);
    CHECK_FALSE(test::contains(answer.out, "must not be used as a pair"));
    const std::string scene =
        folder.write("from.toml", "[surface]\nfrom = \"hills.json\"\n" +
                                      test::replaced(rest, "\"10 MPa\"", "\"3 MPa\", \"10 MPa\""));
    REQUIRE(test::run_fstiff("run '" + scene + "' --format csv -o '" + folder / "k.csv" + "'").status == 4);
    repeats("run '" + scene + "'");
    repeats("identify '" + scene + "' --measured '" + folder / "k.csv" + "' --fit sigma");
}

TEST_CASE("Heights in a wrong unit end every command that measures with exit code 4") {
    const std::string made =
        test::run_fstiff("generate profile --points 600 --spacing '1 um' --hurst 0.5 --rms '1 um'").out;
    for (const char* command :
         {"measure -", "measure --show fit -", "measure --show spectrum -", "measure --show peaks --profile -"}) {
        CAPTURE(command);
        const auto steep = test::run_fstiff(std::string(command) + " --format csv --units m,km", made);
        CHECK(steep.status == 4);
        CHECK(test::contains(steep.err, "a unit of its lengths is likely wrong"));
    }
}

}  // namespace measure_test
