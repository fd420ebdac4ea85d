// SPDX-License-Identifier: BSD-3-Clause
// Several files of one surface: fstiff measure a b, and from = ["a", "b"] of a scene.
#include "json.hpp"

#include <cctype>
#include <cmath>

namespace several_files_test {

namespace {

const std::string rest =
    "[material.upper]\nyoungs_modulus = \"210 GPa\"\npoisson_ratio = 0.3\n"
    "[contact]\npressures = [\"1 MPa\", \"10 MPa\"]\nlaws = [\"hertz\", \"fractal\"]\n";

/// A profile of \p points heights [um].
std::vector<std::string> trace(int points, int seed) {
    const auto all =
        test::lines(test::run_fstiff("generate profile --points " + std::to_string(points) +
                                 " --spacing '1 um' --hurst 0.7 --rms '1 um' --shortest '6 um' --longest '80 "
                                 "um' --seed " +
                                 std::to_string(seed))
                        .out);
    std::vector<std::string> heights;
    for (const std::string& line : all)
        if (!line.empty() && (std::isdigit(static_cast<unsigned char>(line.front())) || line.front() == '-'))
            heights.push_back(line);
    return heights;
}

std::string text_of(const std::vector<std::string>& heights, std::size_t from, std::size_t to, std::size_t step = 1) {
    std::string text;
    for (std::size_t i = from; i < to; i += step) text += heights[i] + "\n";
    return text;
}

}  // namespace

TEST_CASE("parts of one trace, pooled, are the trace within the errors") {
    const test::Folder folder;
    const auto all = trace(8192, 5);
    REQUIRE(all.size() >= 8192);
    std::string names;
    for (std::size_t i = 0; i < 4; ++i)
        names += " " + folder.write("part" + std::to_string(i), text_of(all, 2048 * i, 2048 * (i + 1)));
    const std::string how = " --units m --lambda-s none --lambda-c none --detrend mean";
    const auto pooled = test::json_of("measure" + names + how),
               whole = test::json_of("measure " + folder.write("whole", text_of(all, 0, 8192)) + how);
    for (const char* key : {"rms_height", "peak_radius", "peak_density", "fractal_dimension", "r", "theta",
                            "rms_gradient", "skewness", "kurtosis"}) {
        const auto &one = pooled["surface"][key], &truth = whole["surface"][key];
        INFO(key << ": " << one["value"] << " +- " << one["error"] << " pooled, " << truth["value"] << " of the whole");
        CHECK(std::abs(one["value"].get<double>() - truth["value"].get<double>()) <
              2 * std::hypot(one["error"].get<double>(), truth["error"].get<double>()));
    }
    // sums over the same heights: only the means of the parts, and the triples across their ends, differ
    const double R = pooled["surface"]["peak_radius"]["value"], of_whole = whole["surface"]["peak_radius"]["value"];
    CHECK(std::abs(R / of_whole - 1) < 0.01);
    REQUIRE(pooled["files"].size() == 4);
    double square = 0, curvature = 0;
    for (const auto& part : pooled["files"]) {
        square += std::pow(part["surface"]["rms_height"]["value"].get<double>(), 2) / 4;
        curvature += std::pow(part["surface"]["peak_radius"]["value"].get<double>(), -2) / 4;
    }
    CHECK(std::abs(pooled["surface"]["rms_height"]["value"].get<double>() / std::sqrt(square) - 1) < 1e-12);
    CHECK(std::abs(R * std::sqrt(curvature) - 1) < 1e-12);
    // each part knows R worse than all of them do, unless they scatter by chance
    CHECK(pooled["surface"]["peak_radius"]["error"] < pooled["files"][0]["surface"]["peak_radius"]["error"]);
}

TEST_CASE("unlike files have the error of their scatter") {
    const test::Folder folder;
    const auto smooth = trace(4096, 1);
    std::string rough;
    for (const std::string& line : smooth)
        rough += std::to_string(3e6 * std::stod(line.substr(line.find_last_of(" \t,") + 1))) + "\n";
    std::string same;
    for (const std::string& line : smooth)
        same += std::to_string(1e6 * std::stod(line.substr(line.find_last_of(" \t,") + 1))) + "\n";
    const auto document = test::json_of("measure " + folder.write("a", same) + " " + folder.write("b", rough) +
                                        " --units um --spacing '1 um'");
    const auto& sigma = document["surface"]["rms_height"];
    CHECK(sigma["error"] > 0.5 * sigma["value"].get<double>());  // a factor of 3 between two: nothing is known
    CHECK(std::abs(sigma["value"].get<double>() /
                       (document["files"][0]["surface"]["rms_height"]["value"].get<double>() * std::sqrt(5.0)) -
                   1) < 1e-6);
}

TEST_CASE("a folder, a list of files and the JSON of both are one surface to a scene") {
    const test::Folder folder;
    const auto all = trace(4096, 2);
    std::filesystem::create_directory(folder / "traces");
    folder.write("traces/a", text_of(all, 0, 2048));
    folder.write("traces/b", text_of(all, 2048, 4096));
    folder.write("traces/.hidden", "no surface");
    const auto list =
        folder.write("list.toml", "[surface]\nfrom = [\"traces/a\", \"traces/b\"]\nunits = \"m\"\n" + rest);
    const auto whole = folder.write("whole.toml", "[surface]\nfrom = \"traces\"\nunits = \"m\"\n" + rest);
    const auto document = test::run_fstiff("measure " + folder / "traces --units m");
    REQUIRE(document.status == 0);
    const auto numbers = folder.write("numbers.toml", "[surface]\nfrom = \"traces.json\"\n" + rest);
    folder.write("traces.json", document.out);
    const auto first = test::run_fstiff("run " + list + " --format csv");
    REQUIRE(first.status == 0);
    CHECK(test::run_fstiff("run " + whole + " --format csv").out == first.out);
    CHECK(test::run_fstiff("run " + numbers + " --format csv").out == first.out);
    const auto rows = test::lines(test::run_fstiff("measure " + folder / "traces --units m --format csv").out);
    CHECK(rows.front() == "file,parameter,value,error,unit");
    CHECK(rows[1].find("pooled,rms_height,") == 0);
    CHECK(test::contains(test::run_fstiff("measure " + folder / "traces --units m --format table").out, "2 files pooled"));
}

TEST_CASE("files that are not of one surface are refused in one sentence") {
    const test::Folder folder;
    const auto all = trace(4096, 3);
    const auto a = folder.write("a", text_of(all, 0, 2048)), b = folder.write("b", text_of(all, 0, 4096, 2));
    const auto map =
        folder.write("map", test::run_fstiff("generate map --points 32 --spacing '1 um' --hurst 0.8 --rms '1 um'").out);
    const auto refused = [&](const std::string& arguments, const std::string& sentence, int status = 3) {
        const auto outcome = test::run_fstiff("measure " + arguments);
        INFO(outcome.err);
        CHECK(outcome.status == status);
        CHECK(test::contains(outcome.err, sentence));
        CHECK(outcome.out.empty());
    };
    refused(a + " " + b + " --units m --lambda-s none", "files of unlike steps must have one --lambda-s");
    CHECK(test::run_fstiff("measure " + a + " " + b + " --units m --lambda-s '12 um'").status % 4 == 0);
    refused(a + " " + map + " --units m", "files of one surface must be of one kind");
    std::filesystem::create_directory(folder / "empty");
    refused(folder / "empty", "is a folder without files");
    refused(a + " " + folder / "none --units m", "none");
}

TEST_CASE("maps are pooled with their neighbours, each by its area") {
    const test::Folder folder;
    std::string files;
    std::vector<double> squares;
    for (const char* seed : {"1", "2"}) {
        const auto made = test::run_fstiff(
            "generate map --points 96 --spacing '0.5 um' --hurst 0.7 --rms '0.3 um' --longest '20 um' --seed " +
            std::string(seed));
        const std::string file = folder.write(std::string("map") + seed + ".txt", made.out);
        files += " " + file;
        const auto one = test::json_of("measure " + file);
        squares.push_back(std::pow(one["neighbours"][0]["surface"]["rms_height"]["value"].get<double>(), 2));
    }
    const auto pooled = test::json_of("measure" + files);
    REQUIRE(pooled["neighbours"].size() == 2);
    const double rms = pooled["neighbours"][0]["surface"]["rms_height"]["value"];
    CHECK(std::abs(rms * rms / ((squares[0] + squares[1]) / 2) - 1) < 1e-12);
}

}  // namespace several_files_test
