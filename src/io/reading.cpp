// SPDX-License-Identifier: BSD-3-Clause
#include "io/reading.hpp"

#include <fstiff/core/error.hpp>

#include <algorithm>
#include <cmath>

namespace fstiff::inline v0_1::io {

void Record::note_points(const RawMap& map, const std::string& more) {
    say_points_of_profile(map, more);
    entries.back().second.insert(std::to_string(map.columns).size(), " x " + std::to_string(map.rows));
}

void Record::say_points_of_profile(const RawMap& map, const std::string& more) {
    missing = map.heights.size() - detail::present(map);
    note("points", std::to_string(map.columns) + ", of which " + std::to_string(missing) + " missing" + more);
}

void Record::say_trailer(std::size_t bytes) {
    if (bytes != 0) note("trailer", std::to_string(bytes) + " bytes, not read");
}

std::string Record::said(std::string_view key) const {
    const auto found =
        std::find_if(entries.begin(), entries.end(), [&](const auto& entry) { return entry.first == key; });
    return found == entries.end() ? std::string() : found->second;
}

std::vector<std::string> Record::sentences() const {
    std::vector<std::string> all;
    for (const auto& [key, text] : entries) all.push_back(key + ": " + text);
    return all;
}

namespace detail {

void allocate(RawMap& map, std::size_t rows, std::size_t columns) {
    map.rows = rows;
    map.columns = columns;
    map.heights.resize(rows * columns);
}

void set_height(RawMap& map, std::size_t index, double z) {
    map.heights[index] = std::isinf(z) ? std::numeric_limits<double>::quiet_NaN() : z;
}

std::size_t present(const RawMap& map) {
    const auto exists = [](double z) { return !std::isnan(z); };
    return static_cast<std::size_t>(std::count_if(map.heights.begin(), map.heights.end(), exists));
}

void validate_map(const RawMap& map, std::size_t points) {
    if (map.rows > 1)
        fstiff::detail::validate_map(map.heights.data(), static_cast<Eigen::Index>(map.rows),
                                     static_cast<Eigen::Index>(map.columns), map.dx, map.dy,
                                     static_cast<Eigen::Index>(points));
    else
        Profile<double>{map.heights, map.dx}.validate(points);
}

void set_spacings(RawMap& map, double dx, double dy, const std::string& name) {
    map.dx = dx;
    map.dy = map.rows == 1 && dy == 0 ? dx : dy;
    fstiff::detail::located({.file = name}, [&] { validate_map(map, 2); });
}

}  // namespace detail

}  // namespace fstiff::inline v0_1::io
