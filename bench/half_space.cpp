// SPDX-License-Identifier: BSD-3-Clause
// Times the truth of one map: its contact, K of it, and both on the grid half as fine.
//
//     fstiff_half_space MAP POINTS [PRESSURES P...]
//
// MAP: POINTS x POINTS heights, 64-bit floats, of a repeating square of side 1. PRESSURES: the file that takes the
// pressures at the points; P: mean pressures over E. Prints one line of CSV each; seconds are the least processor time
// of three. half_space.py makes maps and compares with Tamaas where it is installed.
#include <fstiff/halfspace/solve_half_space.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <vector>

namespace {

fstiff::HeightMap<double> read(const char* name, Eigen::Index points) {
    fstiff::HeightMap<double> map;
    map.dx = map.dy = 1.0 / static_cast<double>(points);
    map.heights.resize(points, points);
    std::ifstream file(name, std::ios::binary);
    if (!file.read(reinterpret_cast<char*>(map.heights.data()),
                   static_cast<std::streamsize>(sizeof(double)) * map.heights.size()))
        throw std::runtime_error("MAP is not a file of POINTS x POINTS numbers");
    return map;
}

void time_truth(const fstiff::HeightMap<double>& map, double pressure) {
    const std::vector<double> pressures{pressure};
    double least = std::numeric_limits<double>::infinity();
    fstiff::HalfSpacePoint<double> point;
    for (int repetition = 0; repetition < 3; ++repetition) {
        const std::clock_t begin = std::clock();
        point =
            fstiff::solve_half_space(map, 1.0, pressures, {.points = map.columns(), .edges = fstiff::Edges::periodic})
                .front();
        least = std::min(least, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    }
    const auto& state = point.state;
    std::printf("%d,%g,%.4f,%.9g,%.2g,%.6g,%d,%s\n", static_cast<int>(map.columns()), pressure, least, state.stiffness,
                point.stiffness_error, state.contact_fraction, state.iterations, state.converged ? "yes" : "no");
    std::fflush(stdout);
}

}  // namespace

int main(int count, char** arguments) try {
    if (count < 3) throw std::runtime_error("usage: fstiff_half_space MAP POINTS [PRESSURES P...]");
    const fstiff::HeightMap<double> map = read(arguments[1], std::atol(arguments[2]));
    std::printf("points,pressure,seconds,K,K_grid_error,area,iterations,converged\n");
    std::ofstream out;
    if (count > 3) out.open(arguments[3], std::ios::binary);
    for (int i = 4; i < count; ++i) {
        const double pressure = std::atof(arguments[i]);
        time_truth(map, pressure);
        fstiff::BoundaryElements<double> solver(map, 1.0, {.edges = fstiff::Edges::periodic});
        (void)solver.at_pressure(pressure);
        const fstiff::detail::GridField<double> pressures = solver.pressures();
        out.write(reinterpret_cast<const char*>(pressures.data()),
                  static_cast<std::streamsize>(sizeof(double)) * pressures.size());
    }
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
