// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/contact/hybrid_of_map.hpp>
#include <fstiff/math/random.hpp>
#include <fstiff/topography/scan_lines.hpp>

#include <fstiff/contact/hybrid_contact.hpp>
#include <fstiff/measure/prepare.hpp>
#include <fstiff/synthetic/self_affine.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

namespace scan_lines_test {

using namespace fstiff;

namespace {

HeightMap<double> rough_map(std::uint64_t seed, Eigen::Index side = 128, double hurst = 0.8) {
    const SelfAffineOptions<double> options{
        .hurst = hurst, .rms = 1e-9, .longest_wavelength = 32 * 20e-9, .shortest_wavelength = 4 * 20e-9, .seed = seed};
    return self_affine_map(options, std::size_t(side), std::size_t(side), 20e-9, 20e-9);
}

/// \p map with an offset of standard deviation \p rms for each line.
HeightMap<double> with_offsets(HeightMap<double> map, double rms, ScanAxis axis) {
    std::uint64_t state = 7;
    const Eigen::Index lines = axis == ScanAxis::x ? map.rows() : map.columns();
    for (Eigen::Index k = 0; k < lines; ++k) {
        const double offset = rms * math::normal_pair<double>(state).real();
        if (axis == ScanAxis::x)
            map.heights.row(k) += offset;
        else
            map.heights.col(k) += offset;
    }
    return map;
}

}  // namespace

TEST_CASE("Offsets of any size leave the map as without them") {
    for (const LineAlignment method : {LineAlignment::median, LineAlignment::median_of_differences})
        for (const ScanAxis axis : {ScanAxis::x, ScanAxis::y})
            for (const bool holes : {false, true}) {
                HeightMap<double> plain = rough_map(1);
                if (holes) {
                    plain.heights.block(20, 30, 9, 40) = std::numeric_limits<double>::quiet_NaN();
                    plain.heights.row(60) = std::numeric_limits<double>::quiet_NaN();
                }
                HeightMap<double> shifted = with_offsets(plain, 1e-6, axis);
                detail::align_lines(plain, method, axis);
                const auto [found, step] = detail::align_lines(shifted, method, ScanAxis::automatic);
                CHECK(found == axis);
                CHECK(test::relative_error(step, std::sqrt(2.0) * 1e-6) < 0.15);  // of 127 differences of numbers
                CHECK((shifted.heights.isNaN() == plain.heights.isNaN()).all());
                // median_of_differences leaves the offset of the first line; the rest is the rounding of 128 offsets of
                // 3e-6
                const Eigen::ArrayXXd moved = shifted.heights - plain.heights;
                CHECK((moved - moved(0, 0)).isNaN().select(0, moved - moved(0, 0)).abs().maxCoeff() < 128 * 4e-22);
            }
}

TEST_CASE("Offsets are seen from the size that changes K, and neither roughness nor a lay is taken for them") {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        for (const double hurst : {0.3, 0.5, 0.8}) {
            const HeightMap<double> map = rough_map(seed, 128, hurst);
            CHECK(detail::line_offsets(map).first == ScanAxis::automatic);
            for (const ScanAxis axis : {ScanAxis::x, ScanAxis::y})
                CHECK(detail::line_offsets(with_offsets(map, 0.2e-9, axis)).first == axis);
        }
        HeightMap<double> ground = rough_map(seed, 256);  // ridges along x, eight times as long as wide
        for (Eigen::Index j = 0; j < 256; ++j)
            for (Eigen::Index i = 255; i >= 0; --i) ground.heights(j, i) = ground.heights(j, i / 8);
        CHECK(detail::line_offsets(ground).first == ScanAxis::automatic);
    }
}

TEST_CASE("A plateau whose lines all have one median has no offsets, whatever its rounding is") {
    for (const double plateau : {0., 3e-6, -0.1}) {
        auto map = rough_map(3, 64);
        // pits in one plane, tilted and levelled: the medians are those of rounding
        map.heights =
            (map.heights > 0.8e-9).select(plateau - 1e-6, HeightMap<double>::Array::Constant(64, 64, plateau));
        const auto level = prepare(map, {.lambda_s = no_cut_off});
        CHECK(detail::line_offsets(map).first == ScanAxis::automatic);
        CHECK(detail::line_offsets(level.map).first == ScanAxis::automatic);
        CHECK(detail::line_offsets(with_offsets(map, 1e-15, ScanAxis::x)).first == ScanAxis::automatic);
    }
}

TEST_CASE("K of a map whose lines were offset and aligned is that without offsets to 2 %, where it was off by half") {
    const auto stiffness = [](const HeightMap<double>& map) {
        return hybrid_of_map(prepare(map, {.lambda_s = no_cut_off}).map, 110e9).at_pressure(100e6).stiffness.value;
    };
    double squares = 0, worst = 0;  // of the relative errors
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        const HeightMap<double> plain = rough_map(seed, 256);
        const HeightMap<double> offset = with_offsets(plain, 3e-9, ScanAxis::x);
        const double expected = stiffness(plain);
        CHECK(stiffness(offset) < 0.6 * expected);
        for (const LineAlignment method : {LineAlignment::median, LineAlignment::median_of_differences}) {
            HeightMap<double> aligned = offset;
            detail::align_lines(aligned, method, ScanAxis::automatic);
            const double error = test::relative_error(stiffness(aligned), expected);
            squares += error * error, worst = std::max(worst, error);
        }
    }
    // the waves that all points of a line share are lost: 1 to 2 % of the rms height of a map of eight of its longest
    // waves
    CHECK(std::sqrt(squares / 8) < 0.025);
    CHECK(worst < 0.05);
}

}  // namespace scan_lines_test
