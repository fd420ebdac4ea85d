// SPDX-License-Identifier: BSD-3-Clause
// Spikes are alone: rims, walls, ridges and bumps of clean kinds are none, and added spikes are found.
#include <fstiff/profile/profile.hpp>
#include <fstiff/profile/profile_repair.hpp>
#include <fstiff/topography/form.hpp>
#include <fstiff/topography/map_repair.hpp>

#include "support/catch.hpp"
#include "support/fractional_brownian.hpp"
#include "support/map_kinds.hpp"

#include <random>

namespace alone_test {

using namespace fstiff;

namespace {

struct Named {
    std::string name;
    HeightMap<double> map;
};

/// Parts with rims, walls, grooves, cusps and tips, in points, with noise of \p noise.
std::vector<Named> shapes() {
    std::mt19937 random(1);
    std::normal_distribution<double> normal;
    std::vector<Named> all;
    const auto add = [&](const char* name, double noise, auto z) {
        HeightMap<double> map{HeightMap<double>::Array(128, 128), 1, 1};
        for (Eigen::Index j = 0; j < 128; ++j)
            for (Eigen::Index i = 0; i < 128; ++i)
                map.heights(j, i) = z(static_cast<double>(i), static_cast<double>(j)) + noise * normal(random);
        all.push_back({name, std::move(map)});
    };
    const auto from = [](double x, double y) { return std::hypot(x - 63.3, y - 62.7); };
    const auto cell = [](double x) { return std::fmod(x, 32) - 15.4; };
    add("cap of a ball", 0, [&](double x, double y) { return std::sqrt(100 * 100 - from(x, y) * from(x, y)); });
    add("ball beside a plane", 0.01,
        [&](double x, double y) { return std::sqrt(std::max(0.0, 45 * 45 - from(x, y) * from(x, y))); });
    add("step", 0.05, [](double x, double) { return x > 60 ? 10.0 : 0.0; });
    add("step at an angle", 0.05, [](double x, double y) { return x + 0.37 * y > 80 ? 10.0 : 0.0; });
    add("disc", 0.05, [&](double x, double y) { return from(x, y) < 30 ? 10.0 : 0.0; });
    add("dimples", 0.05, [&](double x, double y) { return std::hypot(cell(x), cell(y)) < 8 ? -10.0 : 0.0; });
    add("small pits", 0.05, [&](double x, double y) { return std::hypot(cell(x), cell(y)) < 2.5 ? -10.0 : 0.0; });
    add("grooves", 0.02, [](double x, double) { return std::fmod(x, 24) < 6 ? -5.0 : 0.0; });
    add("turned", 0.01, [&](double x, double) { return cell(x) * cell(x) / 25; });
    add("pyramids", 0.01, [&](double x, double y) { return std::max(std::abs(cell(x)), std::abs(cell(y))); });
    add("cones", 0.01, [&](double x, double y) { return std::max(0.0, 12 - std::hypot(cell(x), cell(y))); });
    add("wedge with a step", 0.03, [](double x, double y) { return 0.1 * x + 0.05 * y + (x > 60 ? 10 : 0); });
    add("noise", 1, [](double, double) { return 0.0; });
    return all;
}

std::vector<Named> clean_kinds() {
    std::vector<Named> all = shapes();
    for (const auto& kinds : {test::map_kinds(), test::more_map_kinds()})
        for (const test::MapKind& kind : kinds) all.push_back({kind.name, kind.map(3)});
    return all;
}

std::size_t spikes(HeightMap<double> map, double limit) { return detail::find_spikes(map, limit, false).removed; }

}  // namespace

TEST_CASE("No point of 55 clean kinds of map is a spike of 30 standard deviations") {
    for (const Named& one : clean_kinds()) {
        INFO(one.name);
        CHECK(spikes(one.map, 30) == 0);
    }
}

TEST_CASE("Spikes that were added to maps of many kinds are found, alone and four together") {
    std::mt19937 random(9);
    std::uniform_real_distribution<double> uniform;
    for (const Named& one : clean_kinds()) {
        const double rms = rms_height(one.map);
        const std::size_t own = spikes(one.map, 20);
        CHECK(own <= 3);
        for (const double rate : {1e-3, 1e-2, 5e-2})
            for (const double high : {30.0, 100.0}) {
                HeightMap<double> map = one.map;
                std::size_t added = 0;
                for (Eigen::Index k = 0; k < map.size(); ++k)
                    if (uniform(random) < rate) {
                        map.heights.data()[k] += high * rms * (uniform(random) < 0.5 ? 1 : -1);
                        ++added;
                    }
                std::size_t before = 0;
                const HeightMap<double> spiked = map;
                const std::size_t found = detail::find_spikes(map, 20).removed;
                for (Eigen::Index k = 0; k < map.size(); ++k)
                    before +=
                        std::isnan(map.heights.data()[k]) && spiked.heights.data()[k] != one.map.heights.data()[k];
                INFO(one.name << ", rate " << rate << ", " << high << " rms");
                CHECK(static_cast<double>(before) >= 0.9 * static_cast<double>(added));
                CHECK(static_cast<double>(found - before) <=
                      static_cast<double>(own + 1) + 0.01 * static_cast<double>(added));
            }
        HeightMap<double> map = one.map;
        map.heights.block(40, 50, 2, 2) += 100 * rms;
        INFO(one.name);
        CHECK(spikes(map, 20) == own + 4);
    }
}

TEST_CASE("A wall, a cusp and a bump of a profile are no spikes, and a point or two beyond both sides are") {
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    const auto made = [&](double noise, auto z) {
        Profile<double> profile{std::vector<double>(2000), 1e-6};
        for (std::size_t i = 0; i < 2000; ++i) profile.heights[i] = z(static_cast<double>(i)) + noise * normal(random);
        return profile;
    };
    std::vector<Profile<double>> clean{
        made(0.01, [](double x) { return x < 700 ? 0.0 : 10.0; }),                               // a step
        made(0.01, [](double x) { return std::fmod(x, 100) < 30 ? -5.0 : 0.0; }),                // grooves
        made(0.002, [](double x) { return std::pow(std::fmod(x, 100) - 49.6, 2) / 500; }),       // turned
        made(0.01, [](double x) { return 5 * std::exp(-std::pow((x - 901.4) / 1.6, 2) / 2); }),  // a bump
        made(0.01, [](double x) { return -std::abs(x - 1000.3); }),                              // a roof
        made(0.01, [](double x) { return std::sqrt(std::max(0.0, 900.0 * 900 - (x - 1000) * (x - 1000))); })};
    for (const double hurst : {0.2, 0.5, 0.8}) clean.push_back({test::fractional_brownian(2000, hurst, 5), 1e-6});
    for (Profile<double>& profile : clean) {
        CHECK(detail::find_spikes(profile, 30, false).removed == 0);
        const double high = 20 * rms_height(profile);
        for (const std::size_t at : {300u, 650u, 1550u, 1551u}) profile.heights[at] += at == 650 ? -high : high;
        CHECK(detail::find_spikes(profile, 20).removed == 4);
        CHECK(std::isnan(profile.heights[300]));
        CHECK(std::isnan(profile.heights[1551]));
    }
}

}  // namespace alone_test
