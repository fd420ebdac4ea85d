// SPDX-License-Identifier: BSD-3-Clause
// Boundary elements of one Gaussian self-affine map with a known spectrum, as CSV, for tools/make_broad.py.
//     fstiff_broad hurst roll_off plateau|none cut_off points seed [p/(E g) ...]
// Wave numbers count waves a side; the map repeats itself. Lengths in sides, pressures in effective moduli, rms
// gradient 0.1.
#include <fstiff/halfspace/boundary_elements.hpp>
#include <fstiff/surface/moments.hpp>
#include <fstiff/synthetic/self_affine.hpp>
#include <fstiff/topography/map_spectrum.hpp>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace {

using namespace fstiff;

SpectralMoments<double> moments_of_waves(const HeightMap<double>& map) {
    SpectralMoments<double> moments;
    const double unit = 2 * std::numbers::pi_v<double>;
    detail::visit_waves<double>(map.heights, Edges::periodic, [&](double k, double l, double power) {
        const double square = unit * unit * (k * k + l * l);
        moments.m0 += power;
        moments.m2 += square * power / 2;
        moments.m4 += 3 * square * square * power / 8;
    });
    return moments;
}

HeightMap<double> map_of(char** argument) {
    const auto points = std::strtoul(argument[5], nullptr, 10);
    const SelfAffineOptions<double> options{
        .hurst = std::strtod(argument[1], nullptr),
        .rms = 1,
        .longest_wavelength = 1 / std::strtod(argument[2], nullptr),
        .shortest_wavelength = 1 / std::strtod(argument[4], nullptr),
        .long_waves = std::string(argument[3]) == "plateau" ? LongWaves::plateau : LongWaves::none,
        .exact_rms = false,
        .seed = std::strtoul(argument[6], nullptr, 10)};
    const double step = 1 / static_cast<double>(points);
    HeightMap<double> map = self_affine_map(options, points, points, step, step);
    map.heights *= 0.1 / std::sqrt(2 * moments_of_waves(map).m2);
    return map;
}

/// p/(E g): as given, else fewer where a solution is dear.
std::vector<double> pressures_of(Eigen::Index points, int count, char** argument) {
    if (count > 7) {
        std::vector<double> given;
        for (int i = 7; i < count; ++i) given.push_back(std::strtod(argument[i], nullptr));
        return given;
    }
    if (points >= 2048) return {0.25, 0.06, 0.01, 0.003, 0.001, 3e-4};
    if (points >= 1024) return {0.6, 0.25, 0.1, 0.03, 0.01, 0.003, 0.001, 3e-4};
    return {0.75, 0.6, 0.47, 0.35, 0.25, 0.17, 0.1, 0.06, 0.03, 0.01, 0.003, 0.001, 3e-4};
}

}  // namespace

int main(int count, char** argument) {
    if (count < 7) {
        std::fputs("fstiff_broad hurst roll_off plateau|none cut_off points seed [p/(E g) ...]\n", stderr);
        return 2;
    }
    const HeightMap<double> map = map_of(argument);
    const SpectralMoments<double> moments = moments_of_waves(map);
    // K of a map of 256 points changes by 1e-4 or less from 1e-7 to this tolerance
    BoundaryElements<double> solver(map, 1.0, {.edges = Edges::periodic, .tolerance = 1e-5});
    for (const double share : pressures_of(map.columns(), count, argument)) {
        const auto found = solver.at_pressure(share * 0.1);
        if (!found.converged) std::fprintf(stderr, "p* = %g: residual %g\n", share, found.residual);
        std::printf("%s,%s,%s,%s,%s,%s,%.6g,%.6g,%.6g,%g,%.5g,%.5g,%.5g,%lld\n", argument[1], argument[2], argument[3],
                    argument[4], argument[5], argument[6], moments.m0, moments.m2, moments.m4, share, found.stiffness,
                    found.contact_fraction, found.mean_gap, static_cast<long long>(found.spots));
        std::fflush(stdout);
    }
}
