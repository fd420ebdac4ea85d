// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/measure/sections.hpp>
#include <fstiff/synthetic/self_affine.hpp>
#include <fstiff/topography/form.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

namespace sections_test {

using namespace fstiff;

namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// Self-affine, waves up to the side; D = 2 - hurst in every direction.
HeightMap<double> self_affine(double hurst, std::size_t columns, std::size_t rows, std::uint64_t seed, double dx = 1e-6,
                              double dy = 1e-6) {
    return self_affine_map<double>({.hurst = hurst, .rms = 1e-6, .seed = seed}, columns, rows, dx, dy);
}

}  // namespace

TEST_CASE("Sections are the rows and the columns of the map") {
    auto map = self_affine(0.5, 20, 16, 1, 1e-6, 2e-6);
    map.heights(3, 4) = missing;
    const auto x = detail::section(map, detail::Direction::x, 3), y = detail::section(map, detail::Direction::y, 4);
    REQUIRE(x.size() == 20);
    REQUIRE(y.size() == 16);
    CHECK(x.spacing == 1e-6);
    CHECK(y.spacing == 2e-6);
    CHECK(x.heights[5] == map.heights(3, 5));
    CHECK(y.heights[5] == map.heights(5, 4));
    CHECK(std::isnan(x.heights[4]));
    CHECK(std::isnan(y.heights[3]));
    CHECK(test::refusal([&] { (void)detail::section(map, detail::Direction::x, 16); }) ==
          "row = 16: must be between 0 and 15");
    CHECK(test::refusal([&] { (void)detail::section(map, detail::Direction::y, -1); }) ==
          "column = -1: must be between 0 and 19");
}

TEST_CASE("The mean structure function is that of all sections, whatever is missing and however high the map") {
    const bool holes = GENERATE(false, true);
    const double offset = GENERATE(0.0, 1.0);
    auto map = self_affine(0.6, 64, 48, 2, 1e-6, 3e-6);
    map.heights += offset;
    if (holes)
        for (Eigen::Index k = 0; k < map.size(); k += 5 + k % 7) map.heights.data()[k] = missing;
    for (const detail::Direction direction : {detail::Direction::x, detail::Direction::y}) {
        const bool x = direction == detail::Direction::x;
        const auto measured = detail::section_structure(map, direction);
        const auto& s = measured.structure_function;
        CHECK(measured.points == (x ? 64 : 48));
        CHECK(measured.spacing == (x ? 1e-6 : 3e-6));
        REQUIRE(s.step == detail::logarithmic_lags(x ? 16 : 12));
        double worst = 0;
        for (std::size_t k = 0; k < s.size(); ++k) {
            // section by section with the structure function of profiles: the independent code
            long double sum = 0, pairs = 0;
            for (Eigen::Index j = 0; j < (x ? map.rows() : map.columns()); ++j) {
                const auto f = structure_function(
                    x ? detail::section(map, detail::Direction::x, j) : detail::section(map, detail::Direction::y, j),
                    std::span<const std::size_t>(&s.step[k], 1));
                sum += static_cast<long double>(f.value[0]) * static_cast<long double>(f.pairs[0]);
                pairs += static_cast<long double>(f.pairs[0]);
            }
            worst = std::max(worst, test::relative_error(s.value[k], static_cast<double>(sum / pairs)));
        }
        CHECK(worst <= 1e-13);
    }
}

TEST_CASE("D along x and along y is 2 - H, and isotropic maps are not called anisotropic") {
    int warned = 0, maps = 0;
    double claimed = 0, scatter = 0;  // squares
    for (const double hurst : {0.3, 0.5, 0.8}) {
        double worst = 0, mean = 0, square = 0;
        for (std::uint64_t seed = 1; seed <= 13; ++seed) {
            const auto map = detail::remove_form(self_affine(hurst, 256, 256, seed), MapForm::plane);
            const auto fit = detail::fit_directions(map);
            INFO(hurst << ", seed " << seed << ": " << fit.why_no_fit_x << fit.why_no_fit_y);
            REQUIRE(fit.x);
            REQUIRE(fit.y);
            for (const auto* one : {&*fit.x, &*fit.y}) {
                const double error = one->fractal.dimension - (2 - hurst);
                worst = std::max(worst, std::abs(error));
                mean += error / 26;
                square += error * error / 26;
                claimed += one->dimension_error * one->dimension_error / 78;
            }
            warned += fit.anisotropic() ? 1 : 0;
            ++maps;
        }
        scatter += (square - mean * mean) / 3;
        CAPTURE(hurst, worst, mean);
        CHECK(worst <= 0.15);
        CHECK(std::abs(mean) <= 0.06);
    }
    CAPTURE(warned, maps, std::sqrt(claimed), std::sqrt(scatter));
    CHECK(warned <= 2);  // of 39: three standard errors, twice a map
    // 78 values; the two of a map are not independent: the ratio is known to some 12 %
    CHECK(std::sqrt(claimed / scatter) > 0.6);
    CHECK(std::sqrt(claimed / scatter) < 1.8);  // it holds what waves beyond the band may add as well
}

TEST_CASE("Isotropic maps whose windows fall apart are not called anisotropic") {
    // small maps of waves no longer than half their side: the windows of some directions are at the short end, of
    // others at the long one, and D of each by itself differed by up to 0.3
    int apart = 0, warned = 0;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        const auto map = self_affine_map<double>({.hurst = 0.5, .rms = 1e-6, .longest_wavelength = 32e-6, .seed = seed},
                                                 128, 128, 0.5e-6, 0.5e-6);
        const auto fit = detail::fit_directions(detail::remove_form(map, MapForm::plane));
        REQUIRE(fit.x);
        REQUIRE(fit.y);
        apart += std::abs(fit.x->fractal.dimension - fit.y->fractal.dimension) > 0.12 ? 1 : 0;
        warned += fit.anisotropic() ? 1 : 0;
    }
    CHECK(apart >= 5);
    CHECK(warned <= 1);  // three standard errors of some 40 differences
}

TEST_CASE("A map that is stretched, or rougher along one side, is called anisotropic") {
    // stretched: the same heights on another grid: S_x(t) = S_y(t/4), a level apart by 4^(2H)
    auto map = self_affine(0.6, 256, 256, 3);
    map.dx *= 4;
    const auto stretched = detail::fit_directions(detail::remove_form(map, MapForm::plane));
    CHECK(stretched.level_differs);
    CHECK(stretched.anisotropic());
    CHECK(std::abs(stretched.log_level_difference + 1.2 * std::log(4.0)) <= 4 * stretched.log_level_difference_error);
    // rough along x, smooth along y: profiles along x and y added
    const auto rough = self_affine_profile<double>({.hurst = 0.2, .rms = 1e-6, .seed = 5}, 256, 1e-6);
    const auto smooth = self_affine_profile<double>({.hurst = 0.8, .rms = 1e-6, .seed = 6}, 256, 1e-6);
    for (Eigen::Index j = 0; j < 256; ++j)
        for (Eigen::Index i = 0; i < 256; ++i)
            map.heights(j, i) =
                rough.heights[static_cast<std::size_t>(i)] + smooth.heights[static_cast<std::size_t>(j)];
    map.dx = map.dy;
    const auto ridged = detail::fit_directions(map);
    REQUIRE(ridged.x);
    REQUIRE(ridged.y);
    CHECK(ridged.dimension_differs);
    CHECK(ridged.dimension_difference > 0.3);
}

TEST_CASE("A map turned by a right angle has its directions exchanged, another unit changes nothing") {
    const auto map = self_affine(0.5, 200, 160, 4, 1e-6, 1.5e-6);
    const auto here = detail::fit_directions(map);
    REQUIRE(here.x);
    REQUIRE(here.y);
    const auto turned = detail::fit_directions(HeightMap<double>{map.heights.transpose(), map.dy, map.dx});
    CHECK(test::relative_error(turned.x->fractal.dimension, here.y->fractal.dimension) <= 1e-12);
    CHECK(test::relative_error(turned.y->dimension_error, here.x->dimension_error) <= 1e-9);
    CHECK(test::relative_error(turned.log_level_difference, -here.log_level_difference) <= 1e-9);
    for (const double unit : {1e9, 1e-9}) {
        const auto there = detail::fit_directions(HeightMap<double>{map.heights * unit, map.dx * unit, map.dy * unit});
        CHECK(test::relative_error(there.x->fractal.dimension, here.x->fractal.dimension) <= 1e-10);
        CHECK(test::relative_error(there.y->fractal.roughness / unit, here.y->fractal.roughness) <= 1e-9);
        CHECK(test::relative_error(there.x->dimension_error, here.x->dimension_error) <= 1e-6);
        CHECK(std::abs(there.log_level_difference - here.log_level_difference) <= 1e-9);
        CHECK(test::relative_error(there.log_level_difference_error, here.log_level_difference_error) <= 1e-6);
    }
}

TEST_CASE("Seed and resamples of the rows are those asked for") {
    const auto map = self_affine(0.5, 128, 128, 7);
    const auto measured = detail::section_structure(map, detail::Direction::x, {.resamples = 50, .seed = 3});
    const std::vector<std::size_t> steps{1, 2, 4, 8};
    const auto a = measured.resample(steps);
    CHECK(a.rows() == 4);
    CHECK(a.cols() == 50);
    CHECK((a.array() == measured.resample(steps).array()).all());
    CHECK(!detail::section_structure(map, detail::Direction::x, {.resamples = 0}).resample);
    CHECK(measured.profiles == 128);
    CHECK(measured.apart == 1);
    // rows that are all alike have no spread
    HeightMap<double> ridges = map;
    for (Eigen::Index j = 0; j < 128; ++j) ridges.heights.row(j) = map.heights.row(0);
    const auto same = detail::section_structure(ridges, detail::Direction::x).resample(steps);
    CHECK((same.colwise() - same.col(0)).cwiseAbs().maxCoeff() <= 1e-12);
}

TEST_CASE("Maps without sections to fit give the reason") {
    const auto map = self_affine(0.5, 64, 64, 1);
    CHECK(test::refusal([&] { (void)detail::fit_directions(map, {.tip_radius = 1e-6}); }).find("tip radius = ") == 0);
    CHECK(test::refusal([&] { (void)detail::fit_directions(map, {.resamples = -1}); }).find("resamples = -1") == 0);
    CHECK(test::refusal([&] { (void)detail::fit_directions(self_affine(0.5, 12, 64, 1)); }).find("map of 12 x 64") ==
          0);
    // a plane sheet with ridges along y: nothing differs along them
    HeightMap<double> ridges = map;
    for (Eigen::Index j = 0; j < 64; ++j) ridges.heights.row(j) = map.heights.row(0);
    const auto fit = detail::fit_directions(ridges);
    CHECK(!fit.y);
    CHECK(!fit.why_no_fit_y.empty());
    CHECK(fit.dimension_difference == 0);
}

TEST_CASE("The interval of 95 % covers D along x and along y at every decimation of 40 maps of a kind", "[long]") {
    struct Kind {
        std::size_t side;  // of the map that the part is cut from
        double longest;    // where the spectrum turns flat [m]; 0: nowhere
    };
    const double hurst = GENERATE(0.2, 0.5, 0.8);
    const auto [side, longest] = GENERATE(Kind{256, 0}, Kind{512, 0}, Kind{512, 64e-6});
    for (const Eigen::Index step : {1, 2, 4}) {
        int inside = 0, fitted = 0;
        double error = 0;
        for (std::uint64_t seed = 1; seed <= 40; ++seed) {
            const auto whole = self_affine_map<double>(
                {.hurst = hurst, .rms = 1e-6, .longest_wavelength = longest, .exact_rms = false, .seed = seed}, side,
                side, 1e-6, 1e-6);
            HeightMap<double> part;
            part.dx = part.dy = 1e-6 * static_cast<double>(step);
            part.heights.resize(256 / step, 256 / step);
            for (Eigen::Index j = 0; j < part.rows(); ++j)
                for (Eigen::Index i = 0; i < part.columns(); ++i)
                    part.heights(j, i) = whole.heights(j * step, i * step);
            const auto fit = detail::fit_directions(detail::remove_form(part, MapForm::plane), {.resamples = 60});
            for (const auto& one : {fit.x, fit.y}) {
                if (!one) continue;
                ++fitted;
                inside += std::abs(one->fractal.dimension - (2 - hurst)) < 1.96 * one->dimension_error ? 1 : 0;
                error += one->dimension_error;
            }
        }
        WARN("H = " << hurst << ", cut from " << side << " points, flat from " << longest << " m, every " << step
                    << ". point: covered " << 100.0 * inside / fitted << " % of " << fitted << ", error "
                    << error / fitted);
        CHECK(inside >= 0.9 * fitted);
        CHECK(error < 0.13 * fitted);
    }
}

}  // namespace sections_test
