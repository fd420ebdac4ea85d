// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Maps of many kinds, each from a seed: Gaussian, skewed, kurtotic, honed, worn, stretched, turned, milled, with
// particles, the sum of two faces, with waves as long as the map, and with a broad spectrum. They repeat themselves
// over the unit square and have an rms gradient of 0.1. Of twice the size a map has twice the points and twice the
// waves a side.
#include <fstiff/math/random.hpp>
#include <fstiff/math/statistics.hpp>
#include <fstiff/synthetic/self_affine.hpp>
#include <fstiff/topography/height_map.hpp>
#include <fstiff/topography/map_spectrum.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

namespace test {

/// Heights in periods of the map.
using Heights = fstiff::HeightMap<double>::Array;

/// A Gaussian map of rms 1 with \p points a side: from \p rolloff to \p cut waves a side C(q) = q^(-2-2H), constant
/// below, stretched
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
    return fstiff::self_affine_map(options, static_cast<std::size_t>(points), static_cast<std::size_t>(points),
                                   step * root, step / root)
        .heights;
}

/// Removes the overtones above \p cut waves a side, by exp(-(q/cut)^8): the grid then resolves the result of a function
/// of each height.
inline Heights without_overtones(Heights z, double cut = 40) {
    fstiff::detail::LineTransform<double> line(static_cast<std::size_t>(z.rows()), fstiff::Edges::periodic);
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

/// \p count Gaussian hills of random heights up to \p height and of \p width.
inline Heights particles(Heights z, int count, double height, std::uint64_t seed, double width = 0.012) {
    std::uint64_t state = seed;
    const auto uniform = [&state] { return static_cast<double>(fstiff::math::splitmix64(state) >> 11) * 0x1p-53; };
    const double step = 1.0 / static_cast<double>(z.rows());
    for (int n = 0; n < count; ++n) {
        const double x = uniform(), y = uniform(), high = height * uniform();
        for (Eigen::Index j = 0; j < z.rows(); ++j)
            for (Eigen::Index i = 0; i < z.cols(); ++i) {
                const double dx = std::remainder(static_cast<double>(i) * step - x, 1.0),
                             dy = std::remainder(static_cast<double>(j) * step - y, 1.0);
                z(j, i) += high * std::exp(-(dx * dx + dy * dy) / (2 * width * width));
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

/// \p map as Gwyddion simple field, a period \p side [m] long.
inline std::string simple_field(const fstiff::HeightMap<double>& map, double side) {
    std::ostringstream head;
    head << "Gwyddion Simple Field 1.0\nXRes = " << map.columns() << "\nYRes = " << map.rows() << "\nXReal = " << side
         << "\nYReal = " << side << "\nXYUnits = m\nZUnits = m\n";
    std::string bytes = head.str();
    bytes.append(4 - bytes.size() % 4, '\0');
    for (Eigen::Index j = 0; j < map.rows(); ++j)
        for (Eigen::Index i = 0; i < map.columns(); ++i) {
            const auto z = static_cast<float>(map.heights(j, i) * side);
            std::array<char, sizeof z> raw;
            std::memcpy(raw.data(), &z, sizeof z);
            bytes.append(raw.data(), raw.size());
        }
    return bytes;
}

/// One kind of map.
struct MapKind {
    std::string name, group;  ///< the groups are the rows of docs/validation.md
    std::function<Heights(std::uint64_t seed)> make;

    [[nodiscard]] fstiff::HeightMap<double> map(std::uint64_t seed) const { return of_gradient(make(seed)); }
};

/// Makes the kinds of one size: \p size times 256 points a side, 512 for broad spectra.
class KindsOfSize {
public:
    explicit KindsOfSize(int size) : size_(size) {}

    using Seed = std::uint64_t;
    using Make = std::function<Heights(Seed)>;
    static constexpr Seed other = 50000;  // of a second map next to the first

    [[nodiscard]] Heights map(double rolloff, double cut, double hurst, Seed seed, double stretch = 1,
                              Eigen::Index points = 256) const {
        return gaussian_map(points * size_, rolloff * size_, cut * size_, hurst, seed, stretch);
    }
    [[nodiscard]] int side() const { return size_; }
    [[nodiscard]] int area() const { return size_ * size_; }
    [[nodiscard]] Heights base(Seed seed) const { return map(8, 24, 0.8, seed); }
    [[nodiscard]] Heights smooth(const Heights& z) const { return without_overtones(z, 40.0 * size_); }
    [[nodiscard]] Make gaussian(double rolloff, double cut, double hurst, double stretch = 1,
                                Eigen::Index points = 256) const {
        return [*this, rolloff, cut, hurst, stretch, points](Seed seed) {
            return map(rolloff, cut, hurst, seed, stretch, points);
        };
    }
    /// \p f of each height.
    [[nodiscard]] Make each(const std::function<double(double)>& f) const {
        return [*this, f](Seed seed) { return smooth(base(seed).unaryExpr(f)); };
    }
    [[nodiscard]] Make lognormal(double a) const {
        return each([a](double z) { return std::expm1(a * z) / a; });
    }
    [[nodiscard]] Make with_particles(int count, double height) const {
        return [*this, count, height](Seed seed) {
            return particles(map(8, 32, 0.8, seed), count * size_ * size_, height, seed, 0.012 / size_);
        };
    }
    /// Ridges along(x), x in periods of a map of size 1, with a Gaussian map of \p rms on them.
    [[nodiscard]] Make machined(const std::function<double(double)>& along, double rms) const {
        return [*this, along, rms](Seed seed) {
            const auto ridge = ridges(256 * size_, [&](double x) { return along(x * size_); });
            return smooth(ridge + rms * map(12, 32, 0.8, seed));
        };
    }

private:
    int size_;
};

/// The kinds of docs/validation.md.
inline std::vector<MapKind> map_kinds(int size = 1) {
    using Seed = KindsOfSize::Seed;
    const KindsOfSize of(size);
    return {
        {"H 0.2, 8 to 32 waves", "Gaussian", of.gaussian(8, 32, 0.2)},
        {"H 0.5, 8 to 32 waves", "Gaussian", of.gaussian(8, 32, 0.5)},
        {"H 0.8, 8 to 32 waves", "Gaussian", of.gaussian(8, 32, 0.8)},
        {"H 0.5, 16 to 32 waves", "Gaussian", of.gaussian(16, 32, 0.5)},
        {"H 0.8, 4 to 32 waves", "Gaussian, long waves", of.gaussian(4, 32, 0.8)},
        {"H 0.8, 1 to 32 waves", "Gaussian, long waves", of.gaussian(1, 32, 0.8)},
        {"H 0.8, 4 to 128 waves", "broad", of.gaussian(4, 128, 0.8, 1, 512)},
        {"H 0.5, 4 to 128 waves", "broad", of.gaussian(4, 128, 0.5, 1, 512)},
        {"H 0.8, 2 to 128 waves", "broad", of.gaussian(2, 128, 0.8, 1, 512)},
        {"skewness 0.5", "skewed", of.lognormal(0.164)},
        {"skewness 1", "skewed", of.lognormal(0.314)},
        {"skewness -0.5", "skewed", of.lognormal(-0.164)},
        {"skewness -1", "skewed", of.lognormal(-0.314)},
        {"skewness -1.7", "skewed", of.lognormal(-0.48)},
        {"kurtosis 5", "kurtotic", of.each([](double z) { return std::sinh(0.47 * z); })},
        {"kurtosis 1.8", "kurtotic", of.each([](double z) { return std::tanh(0.9 * z); })},
        {"honed", "worn",
         [of](Seed seed) { return of.smooth(of.base(seed).min(0.3) + 0.12 * of.map(16, 32, 0.8, seed + of.other)); }},
        {"worn", "worn", of.each([](double z) { return z > 0 ? z * std::exp(-0.35 * z) : z; })},
        {"plateaus", "worn",
         [of](Seed seed) {
             return of.smooth(of.map(6, 20, 0.6, seed).min(-0.2) + 0.06 * of.map(20, 32, 0.5, seed + of.other));
         }},
        {"particles", "particles", of.with_particles(60, 5)},
        {"stretched 2:1", "stretched", of.gaussian(8, 22, 0.8, 2)},
        {"stretched 4:1", "stretched", of.gaussian(6, 16, 0.8, 4)},
        {"turned", "machined",
         of.machined(
             [](double x) {
                 const double t = 8 * x + 0.37 - std::floor(8 * x + 0.37) - 0.5;
                 return 1.6 * 4 * t * t;
             },
             0.35)},
        {"milled", "machined",
         of.machined([](double x) { return std::cos(20 * std::numbers::pi_v<double> * x); }, 0.5)},
        {"two faces", "two faces",
         [of](Seed seed) { return Heights(of.map(8, 32, 0.8, seed) + 0.7 * of.map(8, 32, 0.5, seed + of.other)); }},
    };
}

/// More kinds of the same groups, for docs/accuracy.md.
inline std::vector<MapKind> more_map_kinds(int size = 1) {
    using Seed = KindsOfSize::Seed;
    const KindsOfSize of(size);
    return {
        {"H 0.5, 1 to 32 waves", "Gaussian, long waves", of.gaussian(1, 32, 0.5)},
        {"H 0.5, 3 to 32 waves", "Gaussian, long waves", of.gaussian(3, 32, 0.5)},
        {"kurtosis 3.8", "kurtotic", of.each([](double z) { return std::sinh(0.3 * z); })},
        {"kurtosis 2.3", "kurtotic", of.each([](double z) { return std::tanh(0.5 * z); })},
        {"run in", "worn", of.each([](double z) { return z > -0.5 ? 0.5 * -std::expm1(-2 * (z + 0.5)) - 0.5 : z; })},
        {"stretched 3:1", "stretched", of.gaussian(7, 18, 0.8, 3)},
        {"stretched 6:1", "stretched", of.gaussian(5, 13, 0.8, 6)},
        {"planed", "machined",
         of.machined(
             [](double x) {
                 const double t = 5 * x + 0.2 - std::floor(5 * x + 0.2);
                 return 3 * (std::min)(t, (1 - t) / 3);
             },
             0.3)},
        {"ground", "machined",
         [of](Seed seed) { return Heights(of.map(4, 9, 0.8, seed, 12) + 0.2 * of.map(16, 32, 0.5, seed + of.other)); }},
        {"two worn faces", "two faces",
         [of](Seed seed) { return of.smooth(of.base(seed).min(0.3) + of.base(seed + of.other).min(0.3)); }},
        {"squared", "skewed", of.each([](double z) { return z + 0.13 * z * z; })},
        {"patchy", "kurtotic",
         [of](Seed seed) { return of.smooth(of.base(seed) * (0.4 * of.map(2, 5, 0.8, seed + of.other)).exp()); }},
        {"scratched", "worn",
         [of](Seed seed) {
             const Heights scratches = of.map(4, 12, 0.8, seed + of.other, 12);
             return of.smooth(0.6 * of.base(seed) - 1.5 * (scratches - 0.8).max(0));
         }},
        {"few particles", "particles",
         [of](Seed seed) { return particles(of.map(8, 32, 0.5, seed), 25 * of.area(), 4, seed, 0.016 / of.side()); }},
        {"many particles", "particles",
         [of](Seed seed) { return particles(of.map(6, 32, 0.8, seed), 150 * of.area(), 4, seed, 0.01 / of.side()); }},
        {"worn on rough", "two faces",
         [of](Seed seed) { return of.smooth(of.base(seed).min(0.1) + 0.5 * of.map(8, 32, 0.6, seed + of.other)); }},
        {"shaped", "machined",
         of.machined([](double x) { return 2.2 * std::abs(std::sin(7 * std::numbers::pi_v<double> * x)); }, 0.4)},
    };
}

}  // namespace test
