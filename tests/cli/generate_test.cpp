// SPDX-License-Identifier: BSD-3-Clause
#include "command.hpp"

#include <fstiff/io/surface_file.hpp>
#include <fstiff/synthetic/self_affine.hpp>
#include <fstiff/synthetic/weierstrass_mandelbrot.hpp>

#include <nlohmann/json.hpp>

#include <cmath>

namespace generate_test {

namespace {

fstiff::io::Surface surface_of(const std::string& arguments) {
    const auto outcome = test::run_fstiff("generate " + arguments);
    INFO("fstiff generate " << arguments << "\n" << outcome.err);
    REQUIRE(outcome.status == 0);
    return fstiff::io::read_surface(outcome.out, "generated");
}

}  // namespace

TEST_CASE("A generated file holds the heights of the library, bit for bit") {
    SECTION("Weierstrass-Mandelbrot profile") {
        const fstiff::WeierstrassMandelbrot<double> wm(
            {1.4, 2e-9}, {.longest_wavelength = 300 * 0.5e-6, .shortest_wavelength = 1e-6, .gamma = 1.7, .seed = 9});
        const auto read =
            surface_of("wm --points 300 --spacing '0.5 um' --dimension 1.4 --roughness '2 nm' --gamma 1.7 --seed 9");
        REQUIRE(read.is_profile());
        CHECK(read.profile().heights == wm.sample(300, 0.5e-6).heights);
        CHECK(read.profile().spacing == 0.5e-6);
    }
    fstiff::SelfAffineOptions<double> how;
    how.hurst = 0.7;
    how.rms = 1e-6;
    how.seed = 5;
    SECTION("self-affine profile, and without plateau") {
        how.longest_wavelength = 50e-6;
        how.shortest_wavelength = 4e-6;
        how.long_waves = fstiff::LongWaves::none;
        const auto read = surface_of(
            "profile --points 512 --spacing '1 um' --hurst 0.7 --rms '1 um' --seed 5 --longest '50 um' "
            "--shortest '4 um' --long-waves none");
        REQUIRE(read.is_profile());
        CHECK(read.profile().heights == fstiff::self_affine_profile(how, 512, 1e-6).heights);
    }
    SECTION("self-affine map, of three forms") {
        how.longest_wavelength = 64e-6;
        how.shortest_wavelength = 2e-6;
        const auto heights = fstiff::self_affine_map(how, 64, 32, 1e-6, 1e-6).heights;
        for (const std::string form : {"csv", "sdf", "sdf-text"}) {
            INFO(form);
            const auto read = surface_of(
                "map --points 64 --rows 32 --spacing '1 um' --hurst 0.7 --rms '1 um' --seed 5 --format " + form);
            REQUIRE(!read.is_profile());
            CHECK(read.map().columns() == 64);
            CHECK(read.map().rows() == 32);
            CHECK(read.map().dx == 1e-6);
            CHECK(read.map().dy == 1e-6);
            CHECK((read.map().heights == heights).all());
        }
    }
}

TEST_CASE("The fit finds the parameters that were generated") {
    const auto fit_of = [](const std::string& arguments) {
        const auto outcome =
            test::shell("fstiff generate " + arguments +
                        " | fstiff measure --show fit - --lambda-s none --lambda-c none --format json");
        INFO(arguments << "\n" << outcome.err);
        REQUIRE(outcome.status == 0);
        return nlohmann::json::parse(outcome.out);
    };
    const auto check = [&](const nlohmann::json& fit, double dimension) {
        const double error = fit["fractal_dimension_error"];
        CHECK(error < 0.05);
        CHECK(std::abs(fit["fractal_dimension"].get<double>() - dimension) < 3 * error);
    };
    check(fit_of("profile --points 16384 --spacing '0.5 um' --hurst 0.5 --rms '1 um' --seed 3"), 1.5);
    check(fit_of("profile --points 16384 --spacing '0.5 um' --hurst 0.2 --rms '1 um' --seed 3"), 1.8);
    const auto wm =
        fit_of("wm --points 16384 --spacing '0.5 um' --dimension 1.5 --roughness '10 nm' --seed 4 --longest '80 mm'");
    check(wm, 1.5);
    // G within a factor of two: its error is that of D times a long lever
    CHECK(std::abs(std::log(wm["fractal_roughness_m"].get<double>() / 10e-9)) < std::log(2.0));
    const auto map = fit_of("map --points 512 --spacing '0.5 um' --hurst 0.5 --rms '1 um' --seed 6");
    check(map["x"], 1.5);
    check(map["y"], 1.5);
    CHECK(map["anisotropic"] == false);
}

TEST_CASE("The same seed makes the same file, another seed another") {
    const std::string profile = "generate profile --points 64 --spacing '1 um' --hurst 0.5 --rms '1 um' --seed ";
    CHECK(test::run_fstiff(profile + "1").out == test::run_fstiff(profile + "1").out);
    CHECK(test::run_fstiff(profile + "1").out != test::run_fstiff(profile + "2").out);
    CHECK(test::contains(test::lines(test::run_fstiff(profile + "1").out).front(), "seed 1"));
    CHECK(test::contains(test::run_fstiff(profile + "1 --format sdf").err, "seed 1"));
}

TEST_CASE("Surfaces that cannot be generated are refused") {
    test::check_refused("generate waves", 2, {"waves", "wm"});
    test::check_refused("generate wm --points 64 --spacing '1 um' --dimension 1.5", 2, {"--roughness"});
    test::check_refused("generate profile --spacing '1 um' --rms '1 um'", 2, {"--hurst"});
    test::check_refused("generate profile --hurst 0.5 --rms '1 um'", 2, {"--spacing"});
    test::check_refused("generate profile --spacing '1 um' --hurst 0.5 --rms '1 um' --gamma 2", 2, {"--gamma"});
    test::check_refused("generate profile --spacing '1 um' --hurst 0.5 --rms '1 um' --rows 32", 2, {"--rows"});
    test::check_refused("generate profile --spacing '1 um' --hurst 0.5 --rms '1 um' --points 5", 2, {"--points", "16"});
    test::check_refused("generate profile --spacing '1 um' --hurst 1.5 --rms '1 um'", 3, {"hurst", "1.5"});
    test::check_refused("generate profile --spacing 1 --hurst 0.5 --rms '1 um'", 3, {"--spacing", "without a unit"});
    test::check_refused("generate profile --spacing '1 Pa' --hurst 0.5 --rms '1 um'", 3, {"--spacing", "Pa"});
    test::check_refused("generate map --points 4096 --spacing '1 um' --hurst 0.5 --rms '1 um'", 3,
                        {"4096 x 4096", "2^22"});
    test::check_refused("generate wm --spacing '1 um' --dimension 2.5 --roughness '1 nm'", 3, {"2.5"});
}

}  // namespace generate_test
