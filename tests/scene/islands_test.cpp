// SPDX-License-Identifier: BSD-3-Clause
// The islands of a file against those of the headers.
#include "support/library.hpp"

#include <fstiff/io/surface_file.hpp>
#include <fstiff/topography/form.hpp>
#include <fstiff/topography/island_spread.hpp>

namespace islands_test {

using fstiff::actions::IslandsRequest;

namespace {

std::string map_text() { return test::map_text(96, 1e-6, {.hurst = 0.8, .rms = 1e-6, .shortest_wavelength = 8e-6}); }

}  // namespace

TEST_CASE("The islands of a file are swept as the headers do, to the last digit") {
    const std::string text = map_text();
    const auto read = fstiff::io::read_surface(text, "map");
    const auto check = [&](const std::string& line, const IslandsRequest& request,
                           const fstiff::IslandOptions<double>& how, fstiff::MapForm form) {
        const auto expected = fstiff::representative_islands(fstiff::detail::remove_form(read.map(), form), how);
        const auto document = test::islands_of("--lambda-s none " + line, text, request);
        const auto& pair = document["representative"];
        INFO(line);
        CHECK(document["doubtful"] == (expected.radius_error > expected.radius / 2));
        CHECK(pair["peak_density_per_m2"] == expected.density);
        CHECK(pair["peak_radius_m"] == expected.radius);
        CHECK(pair["peak_density_error_per_m2"] == expected.density_error);
        CHECK(pair["peak_radius_error_m"] == expected.radius_error);
        CHECK(pair["islands"] == expected.islands);
        CHECK(document["curve"]["islands"].get<std::vector<std::size_t>>() == expected.curve.islands);
        CHECK(document["curve"]["mean_height_m"].get<std::vector<double>>() == expected.curve.mean_height);
        CHECK(document["curve"]["bearing_area"].get<std::vector<double>>() == expected.curve.bearing_area);
        CHECK(document["curve"]["density_per_m2"].get<std::vector<double>>() == expected.curve.density);
    };
    check("", {}, {}, fstiff::MapForm::plane);
    fstiff::IslandOptions<double> other;
    other.connectivity = fstiff::Connectivity::four;
    other.border = fstiff::BorderIslands::dropped;
    other.min_points = 3;
    other.height = fstiff::IslandHeight::twice_mean;
    other.quantiles = 50;
    check("--detrend quadratic",
          {.surface = {},
           .neighbours = 4,
           .border = other.border,
           .height = other.height,
           .min_points = 3,
           .levels = 50,
           .spread = {},
           .progress = {}},
          other, fstiff::MapForm::quadratic);
}

TEST_CASE("The unit of length does not matter to the islands") {
    const std::string text = map_text();
    const auto metres = test::islands_of("--units m", text)["representative"];
    const auto millimetres =
        test::islands_of("--units mm --dx '1 nm' --dy '1 nm'", text)["representative"];  // 1e-3 of all lengths
    // the heights are multiplied by 1e-3, rounded once, and the form is removed after
    CHECK(test::relative_error(millimetres["peak_radius_m"].get<double>() * 1e3,
                               metres["peak_radius_m"].get<double>()) < 1e-10);
    CHECK(test::relative_error(millimetres["peak_density_per_m2"].get<double>() * 1e-6,
                               metres["peak_density_per_m2"].get<double>()) < 1e-12);
}

TEST_CASE("A map without islands is refused, and a pair from few islands is doubted") {
    const std::string text = map_text();
    CHECK(test::contains(test::islands_of("", text)["warnings"].dump(), "peaks only; their errors are rough"));
    const auto refused = [](const std::string& line, const std::string& bytes, const IslandsRequest& how = {}) {
        return test::refusal([&] { (void)test::islands_of(line, bytes, how); });
    };
    IslandsRequest tiles;
    tiles.spread.tiles = 99;
    test::check_sentence(refused("", text, tiles), {"99"});
    test::check_sentence(refused("", test::profile_text(64, 1e-6, {.hurst = 0.5, .rms = 1e-6})),
                         {"standard input", "profile"});
    test::check_sentence(
        refused("--input-format matrix --units um --dx '1 um' --dy '1 um'", "1 1 1 1\n1 1 1 1\n1 1 1 1\n1 1 1 1\n"),
        {"standard input"});
}

}  // namespace islands_test
