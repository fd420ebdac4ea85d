// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Maps of many kinds, each from a seed: Gaussian, skewed, kurtotic, honed, worn, stretched, turned, milled, with particles, the sum
// of two faces, with waves as long as the map, and with a broad spectrum. They repeat themselves over the unit square
// and have an rms gradient of 0.1.
#include <fstiff/core/numbers.hpp>
#include <fstiff/math/random.hpp>
#include <fstiff/synthetic/self_affine.hpp>
#include <fstiff/topography/height_map.hpp>
#include <fstiff/topography/map_spectrum.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace test {

/// Heights in periods of the map.
using Heights = fstiff::HeightMap<double>::Array;

/// A Gaussian map of rms 1 with \p points a side: from \p rolloff to \p cut waves a side C(q) = q^(-2-2H), constant below, stretched
/// \p stretch times along y.
inline Heights gaussian_map(Eigen::Index points, double rolloff, double cut, double hurst, std::uint64_t seed,
                            double stretch = 1) {
    fstiff::SelfAffineOptions<double> options;
    options.hurst = hurst;
    options.rms = 1;
    options.longest_wavelength = 1 / rolloff;
    options.shortest_wavelength = 1 / cut;
    options.seed = seed;
    const double root = std::sqrt(stretch), step = 1.0 / static_cast<double>(points);
    return fstiff::self_affine_map(options, static_cast<std::size_t>(points), static_cast<std::size_t>(points), step * root,
                                   step / root)
        .heights;
}

/// Without the overtones above \p cut waves a side, by exp(-(q/cut)^8): so that the grid resolves what a function of each
/// height by itself has made.
inline Heights without_overtones(Heights z, double cut = 40) {
    fstiff::parts::LineTransform<double> line(static_cast<std::size_t>(z.rows()), fstiff::Edges::periodic);
    const auto both = [&](auto&& call) {
        for (int side = 0; side < 2; ++side) {
            for (Eigen::Index j = 0; j < z.rows(); ++j) {
                Eigen::Array<double, Eigen::Dynamic, 1> row = z.row(j);
                call(row.data());
                z.row(j) = row;
            }
            z = z.transpose().eval();
        }
    };
    both([&](double* row) { line.forward(row); });
    for (Eigen::Index j = 0; j < z.rows(); ++j)
        for (Eigen::Index i = 0; i < z.cols(); ++i)
            z(j, i) *= std::exp(-std::pow(std::hypot(line.wave_number(static_cast<std::size_t>(i)),
                                                     line.wave_number(static_cast<std::size_t>(j))) /
                                              cut,
                                          8));
    both([&](double* row) { line.inverse(row); });
    return z;
}

/// \p along(x) for the rows, x from 0 to 1.
template <class Along>
Heights ridges(Eigen::Index points, const Along& along) {
    Heights z(points, points);
    for (Eigen::Index j = 0; j < points; ++j) z.row(j) = along(static_cast<double>(j) / static_cast<double>(points));
    return z - z.mean();
}

/// \p count Gaussian hills of random heights up to \p height, of the width 0.012.
inline Heights particles(Heights z, int count, double height, std::uint64_t seed) {
    std::uint64_t state = seed;
    const auto uniform = [&state] { return static_cast<double>(fstiff::math::splitmix64(state) >> 11) * 0x1p-53; };
    const double step = 1.0 / static_cast<double>(z.rows());
    for (int n = 0; n < count; ++n) {
        const double x = uniform(), y = uniform(), high = height * uniform();
        for (Eigen::Index j = 0; j < z.rows(); ++j)
            for (Eigen::Index i = 0; i < z.cols(); ++i) {
                const double dx = std::remainder(static_cast<double>(i) * step - x, 1.0),
                             dy = std::remainder(static_cast<double>(j) * step - y, 1.0);
                z(j, i) += high * std::exp(-(dx * dx + dy * dy) / (2 * 0.012 * 0.012));
            }
    }
    return z;
}

/// The map of \p heights over the unit square, scaled to an rms gradient of 0.1.
inline fstiff::HeightMap<double> of_gradient(const Heights& heights) {
    fstiff::HeightMap<double> map;
    map.dx = map.dy = 1.0 / static_cast<double>(heights.rows());
    map.heights = heights - heights.mean();
    map.heights *= 0.1 / fstiff::map_spectrum(map, fstiff::Edges::periodic).rms_gradient();
    return map;
}

/// One kind of map.
struct MapKind {
    std::string name, group;  ///< the groups are the rows of docs/validation.md
    std::function<Heights(std::uint64_t seed)> make;

    [[nodiscard]] fstiff::HeightMap<double> map(std::uint64_t seed) const { return of_gradient(make(seed)); }
};

/// All kinds.
inline std::vector<MapKind> map_kinds() {
    using Seed = std::uint64_t;
    constexpr Seed other = 50000;  // of a second map beside the first
    const auto base = [](Seed seed) { return gaussian_map(256, 8, 24, 0.8, seed); };
    const auto each = [base](const std::function<double(double)>& f) {
        return [base, f](Seed seed) { return without_overtones(base(seed).unaryExpr(f)); };
    };
    const auto lognormal = [](double a) { return [a](double z) { return std::expm1(a * z) / a; }; };
    const auto gaussian = [](double rolloff, double cut, double hurst, double stretch = 1, Eigen::Index points = 256) {
        return [=](Seed seed) { return gaussian_map(points, rolloff, cut, hurst, seed, stretch); };
    };
    return {
        {"H 0.2, 8 to 32 waves", "Gaussian", gaussian(8, 32, 0.2)},
        {"H 0.5, 8 to 32 waves", "Gaussian", gaussian(8, 32, 0.5)},
        {"H 0.8, 8 to 32 waves", "Gaussian", gaussian(8, 32, 0.8)},
        {"H 0.5, 16 to 32 waves", "Gaussian", gaussian(16, 32, 0.5)},
        {"H 0.8, 4 to 32 waves", "Gaussian, long waves", gaussian(4, 32, 0.8)},
        {"H 0.8, 1 to 32 waves", "Gaussian, long waves", gaussian(1, 32, 0.8)},
        {"H 0.8, 4 to 128 waves", "broad", gaussian(4, 128, 0.8, 1, 512)},
        {"H 0.5, 4 to 128 waves", "broad", gaussian(4, 128, 0.5, 1, 512)},
        {"H 0.8, 2 to 128 waves", "broad", gaussian(2, 128, 0.8, 1, 512)},
        {"skewness 0.5", "skewed", each(lognormal(0.164))},
        {"skewness 1", "skewed", each(lognormal(0.314))},
        {"skewness -0.5", "skewed", each(lognormal(-0.164))},
        {"skewness -1", "skewed", each(lognormal(-0.314))},
        {"skewness -1.7", "skewed", each(lognormal(-0.48))},
        {"kurtosis 5", "kurtotic", each([](double z) { return std::sinh(0.47 * z); })},
        {"kurtosis 1.8", "kurtotic", each([](double z) { return std::tanh(0.9 * z); })},
        {"honed", "worn",
         [base](Seed seed) {
             return without_overtones(base(seed).min(0.3) + 0.12 * gaussian_map(256, 16, 32, 0.8, seed + other));
         }},
        {"worn", "worn", each([](double z) { return z > 0 ? z * std::exp(-0.35 * z) : z; })},
        {"plateaus", "worn",
         [](Seed seed) {
             return without_overtones(gaussian_map(256, 6, 20, 0.6, seed).min(-0.2) +
                                      0.06 * gaussian_map(256, 20, 32, 0.5, seed + other));
         }},
        {"particles", "particles", [](Seed seed) { return particles(gaussian_map(256, 8, 32, 0.8, seed), 60, 5, seed); }},
        {"stretched 2:1", "stretched", gaussian(8, 22, 0.8, 2)},
        {"stretched 4:1", "stretched", gaussian(6, 16, 0.8, 4)},
        {"turned", "machined",
         [](Seed seed) {
             const auto groove = [](double x) {
                 const double t = 8 * x + 0.37 - std::floor(8 * x + 0.37) - 0.5;
                 return 1.6 * 4 * t * t;
             };
             return without_overtones(ridges(256, groove) + 0.35 * gaussian_map(256, 12, 32, 0.8, seed));
         }},
        {"milled", "machined",
         [](Seed seed) {
             const auto wave = [](double x) { return std::cos(20 * fstiff::numbers::pi_v<double> * x); };
             return without_overtones(ridges(256, wave) + 0.5 * gaussian_map(256, 12, 32, 0.8, seed));
         }},
        {"two faces", "two faces",
         [](Seed seed) {
             return Heights(gaussian_map(256, 8, 32, 0.8, seed) + 0.7 * gaussian_map(256, 8, 32, 0.5, seed + other));
         }},
    };
}

}  // namespace test
