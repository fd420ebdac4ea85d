// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Deflection of a half space by a force and its periodic images, by Ewald's sum over all images and waves that matter:
// slow and exact.
#include <algorithm>
#include <cmath>
#include <numbers>

namespace test {

/// g(x, y) of a cell of width by height [1/m], of mean 0; at (0, 0) without the 1/r of the force itself.
inline double lattice_influence(double x, double y, double width, double height) {
    const double pi = std::numbers::pi, a = 3 / std::min(width, height), area = width * height;
    const auto count = [](double extent) { return static_cast<int>(std::ceil(extent)) + 1; };
    const int images_x = count(6 / a / width), images_y = count(6 / a / height);
    const int waves_x = count(12 * a * width / (2 * pi)), waves_y = count(12 * a * height / (2 * pi));
    double g = (x == 0 && y == 0 ? -2 * a / std::pow(pi, 1.5) : 0) - 2 / (a * std::sqrt(pi) * area);
    for (int m = -images_x; m <= images_x; ++m)
        for (int n = -images_y; n <= images_y; ++n) {
            const double r = std::hypot(x + m * width, y + n * height);
            if (r > 0) g += std::erfc(a * r) / (pi * r);
        }
    for (int m = -waves_x; m <= waves_x; ++m)
        for (int n = -waves_y; n <= waves_y; ++n) {
            const double qx = 2 * pi * m / width, qy = 2 * pi * n / height, q = std::hypot(qx, qy);
            if (q > 0) g += 2 / q * std::erfc(q / (2 * a)) * std::cos(qx * x + qy * y) / area;
        }
    return g;
}

}  // namespace test
