// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/math/random.hpp>
#include <fstiff/synthetic/self_affine.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

namespace self_affine_test {

using namespace fstiff;

namespace {

using Options = SelfAffineOptions<double>;

/// The sum of waves at one point, term by term in long double, with the spectrum written out again: the slow twin of a
/// map (rows > 1) or profile whose rms is that of the mean over all seeds.
long double slow(const Options& o, int columns, int rows, double dx, double dy, int i, int j) {
    long double sum = 0, total = 0;
    for (int ky = -rows; ky <= rows; ++ky)
        for (int kx = -columns; kx <= columns; ++kx) {
            if (2 * std::abs(kx) >= columns || (rows > 1 ? 2 * std::abs(ky) >= rows : ky != 0)) continue;
            if (ky < 0 || (ky == 0 && kx <= 0)) continue;
            const long double qx = kx / (static_cast<long double>(columns) * dx),
                              qy = rows > 1 ? ky / (static_cast<long double>(rows) * dy) : 0.0L;
            const long double q = std::sqrt(qx * qx + qy * qy);
            if (q > 1.0000000001L / o.shortest_wavelength) continue;
            if (q < 0.9999999999L / o.longest_wavelength && o.long_waves == LongWaves::none) continue;
            const long double w = std::pow(std::max(q, 1 / static_cast<long double>(o.longest_wavelength)),
                                           -2.0L * o.hurst - (rows > 1 ? 2 : 1));
            const std::complex<double> pair = detail::normals_of_wave<double>(o.seed, kx, ky);
            const long double turn =
                static_cast<long double>(kx) * i / columns + static_cast<long double>(ky) * j / rows;
            const long double angle = 2 * std::acos(-1.0L) * (turn - std::floor(turn));
            sum += std::sqrt(w) * (pair.real() * std::cos(angle) - pair.imag() * std::sin(angle));
            total += w;
        }
    return o.rms * sum / std::sqrt(total);
}

double mean_square(const std::vector<double>& z) {
    double sum = 0;
    for (const double v : z) sum += v * v;
    return sum / static_cast<double>(z.size());
}

}  // namespace

TEST_CASE("A self-affine surface is the sum of its waves") {
    const LongWaves long_waves = GENERATE(LongWaves::plateau, LongWaves::none);
    const Options o{.hurst = 0.7,
                    .rms = 2e-7,
                    .longest_wavelength = 3e-5,
                    .shortest_wavelength = 5e-6,
                    .long_waves = long_waves,
                    .exact_rms = false,
                    .seed = 11};
    const auto map = self_affine_map(o, 128, 96, 1e-6, 1.5e-6).heights;
    const auto profile = self_affine_profile(o, 150, 1e-6).heights;
    double worst = 0, worst_profile = 0;
    for (int k = 0; k < 6; ++k) {
        const int i = (k * 53 + 1) % 128, j = (k * 41) % 96;
        worst = std::max(worst, std::abs(map(j, i) - static_cast<double>(slow(o, 128, 96, 1e-6, 1.5e-6, i, j))));
        worst_profile = std::max(worst_profile, std::abs(profile[static_cast<std::size_t>(i)] -
                                                         static_cast<double>(slow(o, 150, 1, 1e-6, 0, i, 0))));
    }
    CAPTURE(worst / o.rms, worst_profile / o.rms);
    CHECK(worst <= 1e-14 * o.rms);  // 45 epsilon for 13 stages of the transform
    CHECK(worst_profile <= 1e-14 * o.rms);
}

TEMPLATE_TEST_CASE("The rms of the realisation is the one asked for, and its mean is 0", "", float, double) {
    using T = TestType;
    const T eps = std::numeric_limits<T>::epsilon();
    const SelfAffineOptions<T> o{.hurst = T(0.5), .rms = T(3e-7), .longest_wavelength = T(2e-5), .seed = 3};
    const auto map = self_affine_map<T>(o, 60, 48, T(1e-6), T(1e-6)).heights;
    const auto profile = self_affine_profile<T>(o, 100, T(1e-6)).heights;
    const auto wide = map.template cast<long double>().eval();
    // each height is rounded once; the mean carries the rounding of the transform, and in long double of this sum
    CHECK(test::relative_error(static_cast<T>(std::sqrt(wide.square().mean())), o.rms) <= 4 * eps);
    CHECK(std::abs(static_cast<T>(wide.mean())) <= 40 * eps * o.rms);
    long double square = 0;
    for (const T z : profile) square += static_cast<long double>(z) * z;
    CHECK(test::relative_error(static_cast<T>(std::sqrt(square / 100)), o.rms) <= 4 * eps);
}

TEST_CASE("Over many seeds the rms has its mean and heights are Gaussian") {
    Options o{.hurst = 0.8, .rms = 1e-6, .longest_wavelength = 2e-5, .exact_rms = false};
    double square = 0, fourth = 0, third = 0, scatter = 0;
    constexpr int seeds = 400;
    for (int seed = 0; seed < seeds; ++seed) {
        o.seed = static_cast<std::uint64_t>(seed);
        const auto z = self_affine_profile(o, 256, 1e-6).heights;
        const double s = mean_square(z) / (o.rms * o.rms);
        square += s / seeds;
        scatter += s * s / seeds;
        double cubes = 0, fourths = 0;
        for (const double v : z) {
            cubes += std::pow(v / o.rms, 3) / 256;
            fourths += std::pow(v / o.rms, 4) / 256;
        }
        third += cubes / seeds;
        fourth += fourths / seeds;
    }
    // Four standard errors, from the scatter over the seeds. A third and a fourth moment scatter like that of a
    // profile of about 10 independent stretches: sqrt(15/4000) and sqrt(96/4000).
    CHECK(std::abs(square - 1) <= 4 * std::sqrt((scatter - square * square) / seeds));
    CHECK(std::abs(third) <= 0.25);
    CHECK(std::abs(fourth - 3) <= 0.62);
}

TEST_CASE("The spectrum of a profile falls as q to the -(2H+1) between its cut-offs, and ends there") {
    const double hurst = GENERATE(0.3, 0.8);
    Options o{.hurst = hurst, .rms = 1e-6, .longest_wavelength = 128e-6, .shortest_wavelength = 8e-6};
    std::vector<double> power(512);
    Eigen::FFT<double> fft;
    constexpr int seeds = 200;
    for (int seed = 0; seed < seeds; ++seed) {
        o.seed = static_cast<std::uint64_t>(1000 + seed);
        std::vector<std::complex<double>> out;
        fft.fwd(out, self_affine_profile(o, 1024, 1e-6).heights);
        for (std::size_t k = 0; k < power.size(); ++k) power[k] += std::norm(out[k]) / (1024.0 * 1024.0);
    }
    // sums over octaves of k: 8 = 1024/128 is the long cut-off, 128 = 1024/8 the short one
    const auto octave = [&](std::size_t from) {
        double sum = 0;
        for (std::size_t k = from; k < 2 * from; ++k) sum += power[k] * std::pow(static_cast<double>(k), 2 * hurst + 1);
        return sum / static_cast<double>(from);
    };
    // 200 seeds times 16 waves and more, each |xi|^2 of relative scatter 1: 0.018; four times that
    CHECK(test::relative_error(octave(16), octave(64)) <= 0.08);
    CHECK(test::relative_error(octave(32), octave(64)) <= 0.08);
    double plateau = 0, above = 0;
    for (std::size_t k = 1; k < 8; ++k) plateau += power[k] / 7;
    for (std::size_t k = 129; k < 512; ++k) above = std::max(above, power[k]);
    CHECK(test::relative_error(plateau, octave(8) * std::pow(8.0, -2 * hurst - 1)) <=
          0.16);  // 1400 waves: 0.027, both ends
    CHECK(above <= 1e-28 * plateau);
}

TEST_CASE("A finer grid over the same period is the same surface") {
    const Options o{.hurst = 0.6,
                    .rms = 1e-6,
                    .longest_wavelength = 40e-6,
                    .shortest_wavelength = 8e-6,
                    .exact_rms = false,
                    .seed = 5};
    const auto coarse = self_affine_map(o, 64, 48, 2e-6, 2e-6).heights,
               fine = self_affine_map(o, 128, 96, 1e-6, 1e-6).heights;
    double worst = 0;
    for (Eigen::Index j = 0; j < 48; ++j)
        for (Eigen::Index i = 0; i < 64; ++i) worst = std::max(worst, std::abs(coarse(j, i) - fine(2 * j, 2 * i)));
    CHECK(worst <= 1e-14 * o.rms);
}

TEST_CASE("The unit of length changes nothing, and another seed everything") {
    const double unit = GENERATE(1e9, 1e-9);
    Options o{.hurst = 0.6, .rms = 1e-6, .longest_wavelength = 40e-6, .seed = 5};
    const auto z = self_affine_map(o, 64, 48, 1e-6, 2e-6).heights;
    CHECK((z == self_affine_map(o, 64, 48, 1e-6, 2e-6).heights).all());
    Options scaled = o;
    scaled.rms *= unit;
    scaled.longest_wavelength *= unit;
    CHECK((self_affine_map(scaled, 64, 48, 1e-6 * unit, 2e-6 * unit).heights / unit - z).abs().maxCoeff() <=
          1e-14 * o.rms);
    o.seed = 6;
    const auto other = self_affine_map(o, 64, 48, 1e-6, 2e-6).heights;
    // two independent maps of some 10 correlated patches: |correlation| below 0.6 here, 1 if the seed did nothing
    CHECK(std::abs((z * other).mean()) < 0.6 * o.rms * o.rms);
}

TEST_CASE("The seed gives the same bits everywhere") {
    // the first two draws of splitmix64 on a state that was mixed from seed and wave, computed by hand in Python
    std::uint64_t state = 1;
    state = math::splitmix64(state) ^ (std::uint64_t(3) << 32 | std::uint64_t(0xFFFFFFFE));
    CHECK(math::splitmix64(state) == 0x4EC2E1AE649E791BULL);
    const auto pair = detail::normals_of_wave<double>(1, -2, 3);
    CHECK(test::ulps(pair.real(), -1.4099665609266887) <= 8);  // of the local log, sqrt, cos
    CHECK(test::ulps(pair.imag(), -0.6078706945355489) <= 8);
}

TEST_CASE("Parameters out of range are named") {
    const Options good{.hurst = 0.5, .rms = 1e-6, .longest_wavelength = 2e-5, .shortest_wavelength = 4e-6};
    const auto says = [&](auto change, const std::string& text) {
        Options o = good;
        change(o);
        const std::string profile = test::refusal([&] { (void)self_affine_profile(o, 64, 1e-6).heights; });
        const std::string map = test::refusal([&] { (void)self_affine_map(o, 64, 64, 1e-6, 1e-6).heights; });
        INFO(profile << " | " << map);
        CHECK(profile.find(text) == 0);
        CHECK(map.find(text) == 0);
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double h : {0.0, 1.0, -1.0, nan}) says([&](Options& o) { o.hurst = h; }, "hurst = ");
    for (const double rms : {0.0, -1.0, nan}) says([&](Options& o) { o.rms = rms; }, "rms = ");
    for (const double l : {1e-6, 1e-3, -1.0, nan})
        says([&](Options& o) { o.shortest_wavelength = l; }, "shortest_wavelength = ");
    for (const double l : {3e-6, -1.0, nan, HUGE_VAL})
        says([&](Options& o) { o.longest_wavelength = l; }, "longest_wavelength = ");
    // no whole wave of a period of 64 um lies between 60 and 50 um
    says(
        [](Options& o) {
            o.long_waves = LongWaves::none;
            o.longest_wavelength = 60e-6;
            o.shortest_wavelength = 50e-6;
        },
        "longest_wavelength = ");
    CHECK(test::refusal([&] { (void)self_affine_profile(good, 3, 1e-6); }).find("points of a side = 3") == 0);
    CHECK(test::refusal([&] { (void)self_affine_map(good, 64, 1, 1e-6, 1e-6); }).find("points of a side = 1") == 0);
    CHECK(test::refusal([&] { (void)self_affine_map(good, 1u << 20, 1u << 20, 1e-6, 1e-6); }).find("points = ") == 0);
    CHECK(test::refusal([&] { (void)self_affine_map(good, 64, 64, 0.0, 1e-6); }).find("dx = 0") == 0);
    CHECK(test::refusal([&] { (void)self_affine_profile(good, 64, nan); }).find("spacing = ") == 0);
}

}  // namespace self_affine_test
