// SPDX-License-Identifier: BSD-3-Clause
// fstiff measure as a process: pipes, exit codes and forms of output. tests/scene/measure_test.cpp has its numbers and
// sentences.
#include "json.hpp"

#include <fstiff/core/text.hpp>

#include <algorithm>
#include <cmath>
#include <random>
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
    for (const char* command : {"measure -", "measure --show fit -", "measure --show spectrum -"}) {
        CAPTURE(command);
        const auto steep = test::run_fstiff(std::string(command) + " --format csv --units m,km", made);
        CHECK(steep.status == 4);
        CHECK(test::contains(steep.err, "a unit of its lengths is likely wrong"));
    }
}

TEST_CASE("Columns and tables of one file are traces of one face, pooled as files of them are") {
    const test::Folder folder;
    std::vector<std::string> rows(600);
    std::string tables, files;
    for (const int seed : {1, 2, 3}) {
        const std::string made =
            test::run_fstiff("generate profile --points 600 --spacing '1 um' --hurst 0.5 --rms '1 um' --seed " +
                             std::to_string(seed))
                .out;
        const std::string name = "trace" + std::to_string(seed) + ".csv";
        files += " '" + folder.write(name, made) + "'";
        const std::string table = made.substr(made.find("x [m]"));
        tables += table + "\n";
        const std::vector<std::string> lines = test::lines(table);
        for (std::size_t i = 0; i < 600; ++i)
            rows[i] += rows[i].empty() ? lines[i + 1] : lines[i + 1].substr(lines[i + 1].find(','));
    }
    std::string columns = "x [m],a [m],b [m],c [m]\n";
    for (const std::string& row : rows) columns += row + "\n";
    const std::string one = folder.write("columns.csv", columns), blocks = folder.write("tables.txt", tables);
    const auto found = [](const std::string& arguments) {
        const test::Outcome outcome = test::run_fstiff("measure " + arguments + " --format csv");
        INFO(arguments << "\n" << outcome.err);
        CHECK(outcome.status == 0);
        std::vector<double> values;
        const test::Csv csv(outcome.out);
        for (std::size_t i = 0; i < csv.size(); ++i)
            if (csv.text(i, "file") == "pooled") values.push_back(csv.number(i, "value"));
        return values;
    };
    const std::vector<double> of_files = found(files);
    REQUIRE(of_files.size() > 5);
    for (const std::string& call :
         {"'" + one + "' --input-format profile --columns 2-4", "'" + one + "' --input-format profile --columns 2,3,4",
          "'" + blocks + "' --channels 1-3"}) {
        const std::vector<double> of_parts = found(call);
        REQUIRE(of_parts.size() == of_files.size());
        for (std::size_t i = 0; i < of_files.size(); ++i) CHECK(of_parts[i] == of_files[i]);
    }
    const std::string profile = "measure '" + one + "' --input-format profile ";
    test::check_refused(profile + "--columns 4-2", 2, {"--columns = \"4-2\"", "must rise"});
    test::check_refused(profile + "--columns 2-x", 2, {"--columns = \"2-x\"", "whole numbers from 1 to 4096"});
    test::check_refused(profile + "--columns 0-2", 2, {"--columns = \"0-2\"", "whole numbers from 1 to 4096"});
    folder.write("columns.toml", "[surface]\nfrom = \"columns.csv\"\nformat = \"profile\"\ncolumns = \"2-4\"\n" + rest);
    folder.write("files.toml", "[surface]\nfrom = [\"trace1.csv\", \"trace2.csv\", \"trace3.csv\"]\n" + rest);
    const std::string scene = "run '" + folder / "columns.toml" + "' --format csv";
    CHECK(test::run_fstiff(scene).out == test::run_fstiff("run '" + folder / "files.toml" + "' --format csv").out);
    test::check_refused(profile + "--columns 2-5", 3, {"columns.csv", "column = 5", "between 1 and 4"});
    test::check_refused(profile + "--columns 2 --channels 1", 2, {"--columns and --channels are both given"});
    test::check_refused(profile + "--columns 2-3 --scales", 2,
                        {"--columns", "must not be given where one surface is read"});
}

TEST_CASE("Offsets of scan lines are named, removed where that is asked for, and refused for a profile") {
    const test::Folder folder;
    const std::string map =
        test::run_fstiff("generate map --points 64 --spacing '20 nm' --hurst 0.8 --rms '1 nm' --longest '400 nm'").out;
    std::string shifted;
    std::mt19937 random(1);
    for (const std::string& row : test::lines(map)) {
        if (row.starts_with('#')) {
            shifted += row + "\n";
            continue;
        }
        const double offset = 3e-9 * (std::ldexp(random(), -31) - 1);
        std::istringstream numbers(row);
        for (double height; numbers >> height;) shifted += fstiff::detail::shortest_text(height + offset) + " ";
        shifted += "\n";
    }
    const std::string file = folder.write("map.txt", shifted);
    const auto seen = test::run_fstiff("measure '" + file + "'");
    CHECK(test::contains(seen.err, "the lines along x are offset from each other by"));
    CHECK(test::contains(seen.out, "\"scan_lines\""));
    for (const char* method : {"median", "median_of_differences"}) {
        const auto aligned = test::run_fstiff("measure '" + file + "' --align " + method);
        CHECK_FALSE(test::contains(aligned.err, "offset from each other"));
        CHECK(test::contains(aligned.out, "align: 64 lines along x aligned (" + std::string(method) + ")"));
    }
    test::check_refused(
        "measure - --align median", 2, {"--align = \"median\": must be none for a profile"},
        test::run_fstiff("generate profile --points 600 --spacing '1 um' --hurst 0.5 --rms '1 um'").out);
}

TEST_CASE("A round part is measured by its circle, whose radius is printed, with a word on the flat patch") {
    std::string ring = "x [um],z [um]\n";
    for (int i = 0; i < 2000; ++i) {
        const double x = i - 900,
                     z = std::sqrt(4000.0 * 4000 - x * x) - 4000 + 0.3 * std::sin(0.7 * i) * std::sin(0.31 * i);
        ring += std::to_string(i) + "," + fstiff::detail::shortest_text(z) + "\n";
    }
    const auto measured = test::run_fstiff("measure - --detrend circle", ring);
    CHECK(test::contains(measured.out, "without its form (circle of radius 4"));
    CHECK(test::contains(measured.out, "\"detrend\": \"circle\""));
    CHECK(test::contains(measured.err, "the contact of the circle itself is not in it"));
    CHECK(test::contains(test::run_fstiff("measure - --detrend circle --radius '4 mm'", ring).out, "of radius 4 mm"));
    test::check_refused("measure - --radius '4 mm'", 2, {"--radius belongs to --detrend circle, sphere or cylinder"},
                        ring);
    test::check_refused("measure - --detrend circle --radius '1 nm'", 3,
                        {"--radius = 1 nm: must be more than half of the side of the surface, 1.999 mm"}, ring);
    test::check_refused("measure - --detrend circle --radius '-4 mm'", 3,
                        {"--radius = \"-4 mm\": must be greater than 0"}, ring);
    test::check_refused("measure - --detrend sphere", 2,
                        {"--detrend = \"sphere\": of a profile must be one of none, mean, line, parabola, circle"},
                        ring);
}

namespace {

/// The warnings that fstiff measure prints of the profile \p z [um] with steps of 0.5 um.
std::string warnings_of(const std::vector<double>& z) {
    const test::Folder folder;
    std::string text = "x [um];z [um]\n";
    char line[64];
    for (std::size_t i = 0; i < z.size(); ++i) {
        std::snprintf(line, sizeof line, "%.1f;%.4f\n", 0.5 * static_cast<double>(i), z[i]);
        text += line;
    }
    return test::run_fstiff("measure '" + folder.write("trace.csv", text) + "' --format json").err;
}

}  // namespace

TEST_CASE("A lambda_c that takes most of the mean square height is reported, one that leaves it is not") {
    const auto is_warned = [](double memory) {  // the nearer to 1, the longer the waves
        std::mt19937 engine(3);
        std::normal_distribution<double> normal(0, 0.02);
        std::vector<double> z(2048);
        double last = 0;
        for (double& height : z) height = last = memory * last + normal(engine);
        return test::contains(warnings_of(z), "that of Ra, removes");
    };
    CHECK(is_warned(0.9995));
    CHECK_FALSE(is_warned(0.9));
}

TEST_CASE("D and G that were not found are one line among the warnings") {
    std::vector<double> sine(300);
    for (std::size_t i = 0; i < sine.size(); ++i) sine[i] = std::sin(0.1 * static_cast<double>(i));
    const std::string warnings = warnings_of(sine);
    CHECK(test::contains(warnings, "D and G not found (only fractal laws need them)"));
    CHECK_FALSE(test::contains(warnings, "half decade of lags"));
}

}  // namespace measure_test
