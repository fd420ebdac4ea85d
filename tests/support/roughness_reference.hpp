// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// tests/data/roughness_reference.csv, made by tools/make_roughness_reference.py with numpy and scipy, and the surfaces
// of it that are in tests/data.
#include "support/half_space_maps.hpp"
#include "support/table.hpp"

#include <fstiff/profile/profile.hpp>
#include <fstiff/topography/height_map.hpp>

#include <limits>
#include <map>
#include <stdexcept>
#include <string>

namespace test {

/// The numbers of one source by their parameters.
inline std::map<std::string, double> roughness_reference(const std::string& source) {
    const Table table("roughness_reference.csv");
    std::map<std::string, double> numbers;
    for (std::size_t row = 0; row < table.size(); ++row)
        if (table.text(row, "source") == source) numbers[table.text(row, "parameter")] = table.input(row, "value");
    if (numbers.empty()) throw std::runtime_error("no source " + source);
    return numbers;
}

/// The map called \p source in the table.
inline fstiff::HeightMap<double> reference_map(const std::string& source) {
    const bool oblong = source == "map_oblong", holes = source == "map_holes";
    fstiff::HeightMap<double> map = half_space_map(oblong ? "rougher" : holes ? "skewed" : source.substr(4));
    if (!oblong && !holes) return map;
    map.dy *= 1.5;
    map.heights = fstiff::HeightMap<double>::Array(map.heights.topLeftCorner(200, oblong ? 151 : 256));
    if (oblong) return map;
    for (Eigen::Index j = 0; j < map.rows(); ++j)
        for (Eigen::Index i = 0; i < map.columns(); ++i)
            if ((7 * j + 11 * i) % 23 == 0) map.heights(j, i) = std::numeric_limits<double>::quiet_NaN();
    return map;
}

/// The profile called \p source in the table.
inline fstiff::Profile<double> reference_profile(const std::string& source) {
    const bool holes = source == "profile_holes";
    const fstiff::HeightMap<double> map = half_space_map(holes ? "skewed" : "gaussian");
    fstiff::Profile<double> profile{{}, map.dx};
    for (const double z : map.heights.row(holes ? 3 : 17)) profile.heights.push_back(z);
    for (std::size_t i = 5; holes && i < profile.size(); i += 13)
        profile.heights[i] = std::numeric_limits<double>::quiet_NaN();
    return profile;
}

}  // namespace test
