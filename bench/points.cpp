// SPDX-License-Identifier: BSD-3-Clause
// Files of 10^6 points: a cloud from memory to a grid of 1024 x 1024, and the numbers of a text.
#include "row.hpp"

#include "io/gridded.hpp"

#include <fstiff/io/surface_file.hpp>

#include <charconv>
#include <cstdio>
#include <ctime>
#include <numbers>
#include <random>
#include <string>

namespace {

using namespace bench;

constexpr std::size_t point_count = 1000000;
constexpr double grid_step = 1e-6, cloud_side = 1023 * grid_step;
/// Of the heights of the cloud [m], which are a wave of 64 steps along x and y: their rms is half the amplitude.
constexpr double cloud_amplitude = 1e-6, cloud_wavenumber = 2 * std::numbers::pi / (64 * grid_step);

double cloud_height(double x, double y) {
    return cloud_amplitude * std::sin(cloud_wavenumber * x) * std::cos(cloud_wavenumber * y);
}

const fstiff::io::detail::PointCloud& random_points() {
    static const auto cloud = [] {
        std::mt19937_64 random(1);
        const auto place = [&] { return cloud_side * std::ldexp(static_cast<double>(random() >> 11), -53); };
        fstiff::io::detail::PointCloud made;
        for (std::size_t i = 0; i < point_count; ++i) {
            const double x = place(), y = place();
            made.points.push_back({x, y, cloud_height(x, y)});
        }
        return made;
    }();
    return cloud;
}

fstiff::io::detail::RawMap map_of_cloud(fstiff::io::Record& record) {
    fstiff::io::SurfaceOptions options;
    options.grid = grid_step;
    options.grid_origin = {0, 0};
    return fstiff::io::detail::gridded(random_points(), "cloud", options, record);
}

/// Errors of the nodes over the rms height; \p rms_error receives their root of the mean square.
Accuracy accuracy_of_cloud(double& rms_error) {
    fstiff::io::Record record;
    const auto map = map_of_cloud(record);
    AccuracyCollector collector;
    double squares = 0, nodes = 0;
    for (std::size_t j = 0; j < map.rows; ++j)
        for (std::size_t i = 0; i < map.columns; ++i) {
            if (std::isnan(map.at(j, i))) continue;
            const double truth = cloud_height((*record.origin)[0] + static_cast<double>(i) * grid_step,
                                              (*record.origin)[1] + static_cast<double>(j) * grid_step);
            const double error = (map.at(j, i) - truth) / (cloud_amplitude / 2);
            collector.add(1 + error, 1);
            squares += error * error, ++nodes;
        }
    collector.add_cost(nodes);
    rms_error = std::sqrt(squares / nodes);
    if (nodes < 0.99 * 1022 * 1022) return {.largest = std::numeric_limits<double>::infinity()};  // some are missing
    return collector.accuracy();
}

/// x and y on a raster of 1000 x 1000 points, with six decimals each.
const std::string& text_of_triples() {
    static const std::string text = [] {
        std::string made = "x [mm],y [mm],z [um]\n";
        std::mt19937_64 random(1);
        char line[64];
        for (std::size_t i = 0; i < point_count; ++i) {
            const double z = std::ldexp(static_cast<double>(random() >> 11), -53) - 0.5;
            const int length =
                std::snprintf(line, sizeof line, "%.6f,%.6f,%.6f\n", 1e-3 * static_cast<double>(i % 1000),
                              1e-3 * static_cast<double>(i / 1000), z);
            made.append(line, static_cast<std::size_t>(length));
        }
        return made;
    }();
    return text;
}

/// The peer: the numbers alone, by std::from_chars; where the columns and the rows end is not looked at.
std::vector<double> numbers_by_from_chars() {
    const std::string& text = text_of_triples();
    std::vector<double> numbers;
    numbers.reserve(3 * point_count);
    const char* const end = text.data() + text.size();
    for (const char* next = text.data() + text.find('\n') + 1; next < end; ++next) {
        double number = 0;
        next = std::from_chars(next, end, number).ptr;
        numbers.push_back(number);
    }
    return numbers;
}

fstiff::io::detail::RawMap map_of_text() { return fstiff::io::detail::read(text_of_triples(), "triples", {}).map; }

/// Least processor time of three calls [s].
double least_seconds(const auto& call) {
    double least = std::numeric_limits<double>::infinity();
    for (int repetition = 0; repetition < 3; ++repetition) {
        const std::clock_t begin = std::clock();
        auto result = call();
        benchmark::DoNotOptimize(result);
        least = std::min(least, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    }
    return least;
}

const Rows rows_of_points([] {
    // Over a triangle |error| <= R^2/2 |z''|, R: of the circle around it, at most 1/sqrt(3) of its longest edge, which
    // is 5 median edges of 1.1 steps; |z''| <= amplitude wavenumber^2: 0.097 rms heights.
    static double rms_error = 0;
    verified_row(
        "io/points_on_grid/1000000", 0.1, [] { return accuracy_of_cloud(rms_error); },
        [](benchmark::State& state) {
            for (auto _ : state) {
                fstiff::io::Record record;
                const auto map = map_of_cloud(record);
                benchmark::DoNotOptimize(map.heights.data());
            }
            state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(point_count));
            state.counters["rms_err"] = rms_error;
        });
    verified_row(
        "io/triples/1000000", 1e-15,
        [] {
            const auto map = map_of_text();
            const auto numbers = numbers_by_from_chars();
            AccuracyCollector collector;
            for (std::size_t i = 0; i < point_count; ++i) collector.add(map.heights[i], numbers[3 * i + 2] * 1e-6);
            collector.add_cost(static_cast<double>(numbers.size()));
            return collector.accuracy();
        },
        [](benchmark::State& state) {
            for (auto _ : state) {
                const auto map = map_of_text();
                benchmark::DoNotOptimize(map.heights.data());
            }
            state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(point_count));
            state.counters["over_from_chars"] = least_seconds(map_of_text) / least_seconds(numbers_by_from_chars);
        });
});

}  // namespace
