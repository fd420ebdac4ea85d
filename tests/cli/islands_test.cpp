// SPDX-License-Identifier: BSD-3-Clause
#include "command.hpp"

#include "support/accuracy.hpp"

#include <fstiff/io/surface_file.hpp>
#include <fstiff/topography/form.hpp>
#include <fstiff/topography/island_spread.hpp>

#include <nlohmann/json.hpp>

namespace islands_test {

namespace {

std::string map_text() {
    const auto made =
        test::run_fstiff("generate map --points 96 --spacing '1 um' --hurst 0.8 --rms '1 um' --shortest '8 um'");
    REQUIRE(made.status == 0);
    return made.out;
}

nlohmann::json json_of(const std::string& arguments, const std::string& input, int status = 4) {
    const auto outcome = test::run_fstiff("islands - --format json " + arguments, input);
    INFO(arguments << "\n" << outcome.err);
    REQUIRE(outcome.status == status);  // 4: R of ten islands is known to 58 %
    return nlohmann::json::parse(outcome.out);
}

}  // namespace

TEST_CASE("The command sweeps the islands as the library does, to the last digit") {
    const std::string text = map_text();
    const auto read = fstiff::io::read_surface(text, "map");
    const auto check = [&](const std::string& arguments, const fstiff::IslandOptions<double>& how,
                           fstiff::MapForm form) {
        const auto expected = fstiff::representative_islands(fstiff::remove_form(read.map(), form), how);
        const auto document =
            json_of("--lambda-s none " + arguments, text, expected.radius_error > expected.radius / 2 ? 4 : 0);
        const auto& pair = document["representative"];
        INFO(arguments);
        CHECK(pair["peak_density_per_m2"] == expected.density);
        CHECK(pair["peak_radius_m"] == expected.radius);
        CHECK(pair["peak_density_error_per_m2"] == expected.density_error);
        CHECK(pair["peak_radius_error_m"] == expected.radius_error);
        CHECK(pair["islands"] == expected.islands);
        CHECK(document["curve"]["islands"].get<std::vector<std::size_t>>() == expected.curve.islands);
        CHECK(document["curve"]["mean_height_m"].get<std::vector<double>>() == expected.curve.mean_height);

        const test::Csv csv(test::run_fstiff("islands - --lambda-s none --format csv " + arguments, text).out);
        REQUIRE(csv.size() == expected.curve.size());
        std::size_t representative = 0;
        for (std::size_t i = 0; i < csv.size(); ++i) {
            CHECK(csv.number(i, "bearing_area") == expected.curve.bearing_area[i]);
            CHECK(csv.number(i, "density_per_m2") == expected.curve.density[i]);
            representative += csv.text(i, "representative") == "1" ? i : 0;
        }
        CHECK(representative == expected.index);
    };
    check("", {}, fstiff::MapForm::plane);
    fstiff::IslandOptions<double> other;
    other.connectivity = fstiff::Connectivity::four;
    other.border = fstiff::BorderIslands::dropped;
    other.min_points = 3;
    other.height = fstiff::IslandHeight::twice_mean;
    other.quantiles = 50;
    check("--neighbours 4 --border drop --least-points 3 --island-height twice-mean --levels 50 --detrend quadratic",
          other, fstiff::MapForm::quadratic);
}

TEST_CASE("The unit of length does not matter to the islands") {
    const std::string text = map_text();
    const auto metres = json_of("--units m", text)["representative"];
    const auto millimetres =
        json_of("--units mm --dx '1 nm' --dy '1 nm'", text)["representative"];  // 1e-3 of all lengths
    // the heights are multiplied by 1e-3, rounded once, and the form is removed after
    CHECK(test::relative_error(millimetres["peak_radius_m"].get<double>() * 1e3,
                               metres["peak_radius_m"].get<double>()) < 1e-10);
    CHECK(test::relative_error(millimetres["peak_density_per_m2"].get<double>() * 1e-6,
                               metres["peak_density_per_m2"].get<double>()) < 1e-12);
}

TEST_CASE("The readable islands say what was decided, and warn of a pair that means little") {
    const auto outcome = test::run_fstiff("islands -", map_text());
    REQUIRE(outcome.status == 4);
    for (const std::string part : {"format: matrix", "96 x 96 points", "8 neighbours", "D_p = ", "R = ", "seed 2014",
                                   "bearing area", "peaks only; their errors are rough"}) {
        INFO(outcome.out << "\nexpected: " << part);
        CHECK(test::contains(outcome.out, part));
    }
}

TEST_CASE("What holds no islands is refused") {
    const std::string text = map_text();
    test::check_refused("islands -", 3, {"standard input", "empty"});
    test::check_refused("islands - --spacing '1 um'", 2, {"--spacing"}, text);
    test::check_refused("islands - --neighbours 6", 2, {"--neighbours"}, text);
    test::check_refused("islands - --detrend line", 2, {"--detrend", "line"}, text);
    test::check_refused("islands -", 3, {"standard input", "profile"},
                        test::run_fstiff("generate profile --spacing '1 um' --hurst 0.5 --rms '1 um' --points 64").out);
    test::check_refused("islands - --tiles 99", 3, {"99"}, text);
    test::check_refused("islands nowhere.csv", 3, {"nowhere.csv", "no such file"});
    test::check_refused("islands - --input-format matrix --units um --dx '1 um' --dy '1 um'", 3, {"standard input"},
                        "1 1 1 1\n1 1 1 1\n1 1 1 1\n1 1 1 1\n");
}

}  // namespace islands_test
