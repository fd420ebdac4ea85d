// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/io/surface_file.hpp>
#include <fstiff/io/write.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <random>
#include <sstream>

namespace write_csv_test {

using namespace fstiff;

namespace {

/// Heights over \p decades powers of ten about 1 um, of both signs, one in nine missing.
double height(std::mt19937_64& random, double decades) {
    if (random() % 9 == 0) return std::numeric_limits<double>::quiet_NaN();
    const double power = std::uniform_real_distribution<double>(-decades, decades)(random);
    return (random() % 2 ? 1e-6 : -1e-6) * std::pow(10.0, power);
}

template <class A, class B>
void check_bits(const A& written, const B& read) {
    REQUIRE(written.size() == read.size());
    for (Eigen::Index k = 0; k < static_cast<Eigen::Index>(written.size()); ++k) {
        const double old = written.data()[k], now = read.data()[k];
        REQUIRE(((std::isnan(old) && std::isnan(now)) ||
                 std::bit_cast<std::uint64_t>(old) == std::bit_cast<std::uint64_t>(now)));
    }
}

}  // namespace

TEST_CASE("A profile that is written reads back bit for bit") {
    const int seed = GENERATE(range(1, 21));
    CAPTURE(seed);
    std::mt19937_64 random(static_cast<std::uint64_t>(seed));
    Profile<double> profile;
    profile.spacing = 1e-6 * std::uniform_real_distribution<double>(0.01, 3)(random);
    for (int i = 0; i < 300; ++i) profile.heights.push_back(height(random, seed % 2 ? 1 : 200));
    profile.heights.front() = profile.heights.back() = std::numeric_limits<double>::quiet_NaN();
    profile.heights[1] = -0.0;
    std::ostringstream output;
    io::write_csv(output, profile);
    const io::Surface back = io::read_surface(output.str(), "file");
    REQUIRE(back.is_profile());
    CHECK(back.profile().spacing == profile.spacing);
    check_bits(profile.heights, back.profile().heights);
}

TEST_CASE("A map that is written reads back bit for bit, as a matrix and as triples") {
    const int seed = GENERATE(range(1, 11));
    const io::MapForm form = GENERATE(io::MapForm::matrix, io::MapForm::triples);
    CAPTURE(seed);
    std::mt19937_64 random(static_cast<std::uint64_t>(seed));
    HeightMap<double> map;
    map.dx = 1e-6 * std::uniform_real_distribution<double>(0.01, 3)(random);
    map.dy = map.dx * std::uniform_real_distribution<double>(0.1, 9)(random);
    map.heights.resize(12 + seed, seed == 1 ? 3 : 2 + seed);
    for (Eigen::Index k = 0; k < map.size(); ++k) map.heights.data()[k] = height(random, seed % 2 ? 1 : 200);
    map.heights(0, 0) = std::numeric_limits<double>::quiet_NaN();
    std::ostringstream output;
    io::write_csv(output, map, form);
    const io::Surface back = io::read_surface(output.str(), "file");
    REQUIRE(!back.is_profile());
    CHECK(back.map().dx == map.dx);
    CHECK(back.map().dy == map.dy);
    REQUIRE(back.map().rows() == map.rows());
    check_bits(map.heights, back.map().heights);
}

TEST_CASE("What is not a profile or map is not written") {
    std::ostringstream output;
    CHECK(!test::refusal([&] { io::write_csv(output, Profile<double>{{1, 2}, 1e-6}); }).empty());
    HeightMap<double> map;
    map.heights.setZero(3, 3);
    map.dx = map.dy = 1e-6;
    CHECK(!test::refusal([&] { io::write_csv(output, map); }).empty());
    map.heights(1, 1) = 1;
    CHECK(!test::refusal([&] { io::write_csv(output, map, io::MapForm::automatic); }).empty());
    CHECK(output.str().empty());
    output.setstate(std::ios::badbit);
    CHECK(!test::refusal([&] { io::write_csv(output, map); }).empty());
}

}  // namespace write_csv_test
