// SPDX-License-Identifier: BSD-3-Clause
// Ranks and levels of the heights of a map, against sorting all of them and against counting levels one by one.
#include <fstiff/topography/islands.hpp>

#include "support/catch.hpp"

#include <array>
#include <limits>
#include <random>

namespace island_levels_test {

using namespace fstiff;

namespace {

enum class HeightKind { gaussian, counts, outlier, offset, tiny };

template <class T>
HeightMap<T> map_of(HeightKind kind, Eigen::Index rows, Eigen::Index columns, unsigned seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    HeightMap<T> map{typename HeightMap<T>::Array(rows, columns), T(1), T(1)};
    for (Eigen::Index k = 0; k < map.size(); ++k) {
        const double z = normal(random);
        double height = z;
        if (kind == HeightKind::counts) height = std::round(2 * z);
        if (kind == HeightKind::offset) height = 1e4 + z;
        map.heights.data()[k] = static_cast<T>(height);
        if (kind == HeightKind::tiny) map.heights.data()[k] *= std::numeric_limits<T>::denorm_min() * T(1000);
        if (k % 11 == 3) map.heights.data()[k] = std::numeric_limits<T>::quiet_NaN();
    }
    if (kind == HeightKind::outlier) map.heights(1, 1) = T(1e9);  // all others crowd in one bin
    return map;
}

template <class T>
std::vector<T> from_the_highest(const HeightMap<T>& map) {
    std::vector<T> heights;
    for (Eigen::Index k = 0; k < map.size(); ++k)
        if (!std::isnan(map.heights.data()[k])) heights.push_back(map.heights.data()[k]);
    std::sort(heights.begin(), heights.end(), std::greater<>());
    return heights;
}

constexpr std::array kinds{HeightKind::gaussian, HeightKind::counts, HeightKind::outlier, HeightKind::offset,
                           HeightKind::tiny};

}  // namespace

TEMPLATE_TEST_CASE("The height of a rank is that of the sorted heights", "", FSTIFF_SCALARS) {
    using T = TestType;
    for (const HeightKind kind : kinds) {
        CAPTURE(static_cast<int>(kind));
        const auto map = map_of<T>(kind, 37, 41, 5);
        const auto sorted = from_the_highest(map);
        const auto range = detail::height_range(map);
        std::vector<std::size_t> all(sorted.size()), some{0, 0, 7, 8, 500, sorted.size() - 1};
        for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
        CHECK(detail::heights_of_ranks(map, range, all) == sorted);
        std::vector<T> wanted;
        for (const std::size_t rank : some) wanted.push_back(sorted[rank]);
        CHECK(detail::heights_of_ranks(map, range, some) == wanted);
        CHECK(detail::heights_of_ranks(map, range, {}).empty());
    }
}

TEMPLATE_TEST_CASE("The band of a point is the number of levels not below it", "", FSTIFF_SCALARS) {
    using T = TestType;
    for (const HeightKind kind : kinds) {
        CAPTURE(static_cast<int>(kind));
        const auto map = map_of<T>(kind, 29, 43, 6);
        const auto sorted = from_the_highest(map);
        // heights of the map, the middle between two, and levels beyond all
        std::vector<T> levels{sorted.front() * T(2) + T(1), sorted.front(), sorted.back(), sorted.back() - T(1)};
        for (std::size_t i = 3; i < sorted.size() && levels.size() < detail::LevelBands::most_levels - 2; i += 9) {
            levels.push_back(sorted[i]);
            levels.push_back(sorted[i] / 2 + sorted[i - 1] / 2);
        }
        std::sort(levels.begin(), levels.end(), std::greater<>());
        levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
        const auto bands = detail::level_bands(map, detail::height_range(map), levels);
        REQUIRE(bands.size() == static_cast<std::size_t>(map.size()));
        for (std::size_t k = 0; k < bands.size(); ++k) {
            const T z = map.heights.data()[k];
            const auto direct = std::count_if(levels.begin(), levels.end(), [&](T level) { return level >= z; });
            REQUIRE(bands[k] == (std::isnan(z) ? detail::LevelBands::absent : direct));
        }
    }
}

TEMPLATE_TEST_CASE("The range of heights leaves missing points out", "", FSTIFF_SCALARS) {
    using T = TestType;
    for (const Eigen::Index columns : {3, 16, 41}) {  // shorter than the lanes of the pass, as long, and with a rest
        for (const HeightKind kind : kinds) {
            const auto map = map_of<T>(kind, 3, columns, 7);
            const auto sorted = from_the_highest(map);
            const auto range = detail::height_range(map);
            CHECK(range.high == sorted.front());
            CHECK(range.low == sorted.back());
            CHECK(range.present == static_cast<Eigen::Index>(sorted.size()));
        }
    }
    HeightMap<T> none{HeightMap<T>::Array::Constant(4, 9, std::numeric_limits<T>::quiet_NaN()), T(1), T(1)};
    CHECK(detail::height_range(none).present == 0);
    none.heights(2, 2) = -std::numeric_limits<T>::infinity();
    CHECK(detail::height_range(none).low == -std::numeric_limits<T>::infinity());
}

}  // namespace island_levels_test
