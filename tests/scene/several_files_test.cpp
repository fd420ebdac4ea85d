// SPDX-License-Identifier: BSD-3-Clause
// Several files of one surface, pooled, and from = ["a", "b"] of a scene.
#include "support/library.hpp"

#include <cmath>

namespace several_files_test {

namespace {

const std::string rest =
    "[material.upper]\nyoungs_modulus = \"210 GPa\"\npoisson_ratio = 0.3\n"
    "[contact]\npressures = [\"1 MPa\", \"10 MPa\"]\nlaws = [\"hertz\", \"fractal\"]\n";

std::vector<double> trace(std::size_t points, std::uint64_t seed) {
    return fstiff::self_affine_profile<double>(
               {.hurst = 0.7, .rms = 1e-6, .longest_wavelength = 80e-6, .shortest_wavelength = 6e-6, .seed = seed},
               points, 1e-6)
        .heights;
}

/// The heights from \p from to \p to as a column of metres.
std::string text_of(const std::vector<double>& heights, std::size_t from, std::size_t to) {
    std::string text;
    for (std::size_t i = from; i < to; ++i) text += fstiff::document::exact(heights[i]) + "\n";
    return text;
}
/// Every \p step th of the heights with its position.
std::string positions(const std::vector<double>& heights, std::size_t step) {
    std::string text;
    for (std::size_t i = 0; i < heights.size(); i += step)
        text +=
            fstiff::document::exact(static_cast<double>(i) * 1e-6) + "," + fstiff::document::exact(heights[i]) + "\n";
    return text;
}
const std::string metres = "--units m --spacing '1 um'";

}  // namespace

TEST_CASE("Parts of one trace, pooled, are the trace within the errors") {
    const test::Folder folder;
    const auto all = trace(8192, 5);
    std::vector<std::string> names;
    for (std::size_t i = 0; i < 4; ++i)
        names.push_back(folder.write("part" + std::to_string(i), text_of(all, 2048 * i, 2048 * (i + 1))));
    const std::string how = metres + " --lambda-s none --lambda-c none --detrend mean";
    const auto pooled = test::measured_files(how, names), whole = test::measured(how, text_of(all, 0, 8192));
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
    // each part determines R worse than all of them, unless they scatter by chance
    CHECK(pooled["surface"]["peak_radius"]["error"] < pooled["files"][0]["surface"]["peak_radius"]["error"]);
}

TEST_CASE("Unlike files have the error of their scatter") {
    const test::Folder folder;
    std::vector<double> smooth = trace(4096, 1);
    const std::string same = folder.write("a", text_of(smooth, 0, 4096));
    for (double& height : smooth) height *= 3;
    const auto document = test::measured_files(metres, {same, folder.write("b", text_of(smooth, 0, 4096))});
    const auto& sigma = document["surface"]["rms_height"];
    CHECK(sigma["error"] > 0.5 * sigma["value"].get<double>());  // a factor of 3 between two: no precision
    CHECK(std::abs(sigma["value"].get<double>() /
                       (document["files"][0]["surface"]["rms_height"]["value"].get<double>() * std::sqrt(5.0)) -
                   1) < 1e-6);
}

TEST_CASE("A folder, a list of files and the JSON of both are one surface to a scene") {
    const test::Folder folder;
    const auto all = trace(4096, 2);
    std::filesystem::create_directory(folder / "traces");
    folder.write("traces/a", text_of(all, 0, 2048));
    folder.write("traces/b", text_of(all, 2048, 4096));
    folder.write("traces/.hidden", "no surface");
    folder.write("traces.json", test::measured_files(metres, {folder / "traces"}).dump());
    const auto csv = [&](const std::string& surface) {
        return test::csv_of(test::results_of("[surface]\nfrom = " + surface + rest, folder / "scene.toml"));
    };
    const std::string keys = "units = \"m\"\nspacing = \"1 um\"\n",
                      first = csv("[\"traces/a\", \"traces/b\"]\n" + keys);
    CHECK(csv("\"traces\"\n" + keys) == first);
    CHECK(csv("\"traces.json\"\n") == first);
    // a file that is listed twice counts once
    const auto twice = test::measured_files(metres, {folder / "traces/a", folder / "traces/a", folder / "traces/b"});
    CHECK(twice["files"].size() == 2);
    CHECK(test::contains(twice["warnings"].dump(), "traces/a"));
}

TEST_CASE("Files that are not of one surface are refused in one sentence") {
    const test::Folder folder;
    const auto all = trace(4096, 3);
    const auto a = folder.write("a", text_of(all, 0, 2048));
    const auto map = folder.write("map", test::map_text(32, 1e-6, {.hurst = 0.8, .rms = 1e-6}));
    std::filesystem::create_directory(folder / "empty");
    const auto refused = [&](const std::string& options, const std::vector<std::string>& files) {
        return test::refusal([&] { (void)test::measured_files(options, files); });
    };
    CHECK(test::contains(refused("--units m --lambda-s none",
                                 {folder.write("c", positions(all, 1)), folder.write("d", positions(all, 2))}),
                         "files of unlike steps must have one --lambda-s"));
    CHECK(refused("--units m --lambda-s '12 um'", {folder / "c", folder / "d"}).empty());
    CHECK(test::contains(refused("--units m", {folder / "c", map}), "files of one surface must be of one kind"));
    CHECK(test::contains(refused(metres, {folder / "empty"}), "is a folder without files"));
    CHECK(test::contains(refused(metres, {a, folder / "none"}), "none"));
}

TEST_CASE("Maps are pooled with their neighbours, each by its area") {
    const test::Folder folder;
    std::vector<std::string> files;
    std::vector<double> squares;
    for (const std::uint64_t seed : {1u, 2u}) {
        const std::string text =
            test::map_text(96, 0.5e-6, {.hurst = 0.7, .rms = 0.3e-6, .longest_wavelength = 20e-6, .seed = seed});
        files.push_back(folder.write("map" + std::to_string(seed) + ".txt", text));
        const auto one = test::measured("", text);
        squares.push_back(std::pow(one["neighbours"][0]["surface"]["rms_height"]["value"].get<double>(), 2));
    }
    const auto pooled = test::measured_files("", files);
    REQUIRE(pooled["neighbours"].size() == 2);
    const double rms = pooled["neighbours"][0]["surface"]["rms_height"]["value"];
    CHECK(std::abs(rms * rms / ((squares[0] + squares[1]) / 2) - 1) < 1e-12);
}

}  // namespace several_files_test
