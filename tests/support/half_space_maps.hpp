// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The maps of tests/data/bem_maps.csv: 256 x 256 heights over the unit square, 32-bit floats.
#include <fstiff/topography/height_map.hpp>

#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace test {

inline fstiff::HeightMap<double> half_space_map(const std::string& name) {
    std::vector<float> heights(256 * 256);
    std::ifstream file(FSTIFF_TEST_DATA "/bem_map_" + name + ".f32", std::ios::binary);
    if (!file.read(reinterpret_cast<char*>(heights.data()),
                   static_cast<std::streamsize>(heights.size() * sizeof(float))))
        throw std::runtime_error("no map " + name);
    fstiff::HeightMap<double> map;
    map.dx = map.dy = 1.0 / 256;
    map.heights = Eigen::Map<const Eigen::Array<float, 256, 256, Eigen::RowMajor>>(heights.data()).cast<double>();
    return map;
}

/// A corner of the Gaussian map of \p points a side, in SI over (100 um)^2 as a whole, \p taller times as high.
inline fstiff::HeightMap<double> corner_of_map(Eigen::Index points, double taller = 1) {
    fstiff::HeightMap<double> map = half_space_map("gaussian");
    map.heights = (taller * 1e-4 * map.heights.topLeftCorner(points, points)).eval();
    map.dx = map.dy = 1e-4 / 256;
    return map;
}

}  // namespace test
