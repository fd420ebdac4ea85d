// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/math/random.hpp>
#include <fstiff/measure/measure.hpp>
#include <fstiff/measure/unmeasured_waves.hpp>
#include <fstiff/profile/levelled_profile.hpp>
#include <fstiff/profile/profile_form.hpp>
#include <fstiff/synthetic/self_affine.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

namespace unmeasured_waves_test {

using namespace fstiff;

namespace {

/// Number of pieces with a known whole in their band, and their mean predicted growth.
struct Coverage {
    static constexpr int wholes = 20;     // of four pieces each, which share what the whole scatters
    int pieces{}, rougher{}, smoother{};  ///< wholes above and below the band of 90 %
    double growth{}, law{}, true_growth{};

    void add(const SurfaceParameters<double>& piece, double side, double whole) {
        const auto [value, error] = piece.rms_height;
        const double reach = math::normal_95<double>.value * std::sqrt(std::log1p(error * error / value / value));
        const double more = detail::unmeasured_waves(piece.long_end, side).growth, truth = std::log(whole / value);
        ++pieces;
        rougher += truth > more + reach, smoother += truth < -reach;
        growth += more, true_growth += truth;
        law += piece.long_end.open * piece.long_end.hurst * std::log(side / piece.long_end.side);
    }
    void check(double hurst, double longest) const {
        WARN("H = " << hurst << ", flat from " << longest << " of the piece on: " << 100.0 * rougher / pieces
                    << " % above the band, " << 100.0 * smoother / pieces << " % below it; mean growth "
                    << growth / pieces << ", true " << true_growth / pieces);
        CHECK(rougher <= (longest > 3 ? 0.2 : 0.06) * pieces);  // of few waves the wholes scatter as the pieces do
        CHECK(smoother <= 0.06 * pieces);
        if (longest <= 0.13) CHECK(growth / pieces < 0.25);                   // the roll-off is seen
        if (longest > 3) CHECK(std::abs(law - true_growth) / pieces < 0.15);  // the law goes on
    }
};

detail::SurfaceParameterOptions<double> quick() { return {.fit = {.resamples = 0}, .resamples = 50}; }

}  // namespace

TEST_CASE("A contact larger than the piece has the waves of the law of the long end, a smaller one no more") {
    const LongEnd<double> end{.side = 1e-3, .hurst = 0.6, .open = 0.5, .law = true};
    CHECK(test::relative_error(detail::unmeasured_waves(end, 1e-2).growth, 0.3 * std::log(10.0)) < 1e-15);
    CHECK(test::relative_error(detail::unmeasured_waves(end, 1e-2).expected, 0.75 * 0.3 * std::log(10.0)) < 1e-15);
    CHECK_FALSE(detail::unmeasured_waves(end, 1e-2).at_least);
    CHECK(detail::unmeasured_waves(end, 1e-3).growth == 0);
    CHECK(detail::unmeasured_waves(LongEnd<double>{.side = 1e-3, .hurst = 0.6, .open = 0.5}, 1e-2).at_least);
    const LongEnd<double> rolled{.side = 1e-3, .hurst = 0.6, .open = 0.001};
    CHECK_FALSE(detail::unmeasured_waves(rolled, 1e-2).at_least);
    const LongEnd<double> few{.side = 1e-3, .hurst = 0.6, .open = 1, .error = 0.2, .law = true};
    CHECK(test::relative_error(detail::unmeasured_waves(few, 2e-3).growth,
                               0.6 * std::log(2.0) + (std::sqrt(2.0) - 1) * math::normal_95<double>.value * 0.1) <
          1e-14);
    CHECK(detail::unmeasured_waves(LongEnd<double>{}, 1e-2).growth == 0);
    const LongEnd<double> other{.side = 4e-3, .hurst = 0.8, .open = 1, .law = true};
    const auto mean = detail::mean_of_ends(end, other, 0.5);
    CHECK(test::relative_error(mean.side, 2e-3) < 1e-15);
    CHECK(test::relative_error(mean.open, 0.75) < 1e-15);
    CHECK(detail::mean_of_ends(LongEnd<double>{}, end, 0.5).side == end.side);
    CHECK(detail::mean_of_ends(LongEnd<double>{}, end, 0.5).open == 0.25);
}

TEST_CASE("A power law without a roll-off is open, one that turns flat is not, and the long waves give H") {
    Eigen::ArrayXXd law(16, 16), flat(16, 16);
    for (Eigen::Index y = 0; y < 16; ++y)
        for (Eigen::Index x = 0; x < 16; ++x) {
            const double k = std::hypot(x, y);
            law(y, x) = k > 0 ? std::pow(k, -3.2) : 0;
            flat(y, x) = std::pow(std::max(k, 8.0), -3.2);
        }
    const auto open = detail::long_end<double>(law, {}), rolled = detail::long_end<double>(flat, {});
    CHECK(open.open == 1);
    CHECK(std::abs(open.hurst - 0.6) < 0.05);
    CHECK(rolled.open < 1e-3);
    CHECK(std::abs(detail::long_end<double>(law.topRows(1), {0.6, 0.1}).open - 1) < 1e-12);  // 14 waves alone
}

TEST_CASE("sigma of the whole lies in the band of a piece, with and without a roll-off", "[long]") {
    constexpr std::size_t points = 8192, piece = 1024;
    for (const double hurst : {0.3, 0.45, 0.6, 0.75, 0.9})
        for (const double longest : {8.0, 1.0, 0.5, 0.25, 0.125}) {
            Coverage of_profiles;
            for (std::uint64_t seed = 1; seed <= Coverage::wholes; ++seed) {
                const auto whole = self_affine_profile<double>({.hurst = hurst,
                                                                .rms = 1e-6,
                                                                .longest_wavelength = longest * piece * 1e-6,
                                                                .shortest_wavelength = 8e-6,
                                                                .exact_rms = false,
                                                                .seed = seed},
                                                               points, 1e-6);
                const double sigma = rms_height(detail::level(whole, Form::line).profile);
                for (const std::ptrdiff_t from : {0, 2048, 4096, 6144}) {
                    const auto begin = whole.heights.begin() + from;
                    const Profile<double> part{{begin, begin + piece}, 1e-6};
                    of_profiles.add(detail::surface_parameters(detail::level(part, Form::line), quick()),
                                    points * 1e-6 / std::numbers::sqrt2_v<double>, sigma);
                }
            }
            of_profiles.check(hurst, longest);
        }
}

TEST_CASE("sigma of a map lies in the band of a quarter of its side, with and without a roll-off", "[long]") {
    for (const double hurst : {0.3, 0.6, 0.9})
        for (const double longest : {4.0, 0.5, 0.125}) {
            Coverage of_maps;
            for (std::uint64_t seed = 1; seed <= Coverage::wholes; ++seed) {
                const auto whole = self_affine_map<double>({.hurst = hurst,
                                                            .rms = 1e-6,
                                                            .longest_wavelength = longest * 64e-6,
                                                            .shortest_wavelength = 4e-6,
                                                            .exact_rms = false,
                                                            .seed = seed},
                                                           256, 256, 1e-6, 1e-6);
                const double sigma = rms_height(detail::level(whole, MapForm::plane).map);
                for (const Eigen::Index from : {0, 64, 128, 192}) {
                    HeightMap<double> part{whole.heights.block(from, from, 64, 64), 1e-6, 1e-6};
                    auto how = quick();
                    how.texture = false;
                    of_maps.add(detail::surface_parameters(detail::level(part, MapForm::plane), how), 256e-6, sigma);
                }
            }
            of_maps.check(hurst, longest);
        }
}

TEST_CASE("All waves of a trace count for the contact, and Ra keeps the cut-off of its standard") {
    const auto trace =
        self_affine_profile<double>({.hurst = 0.6, .rms = 0.4e-6, .longest_wavelength = 3e-3, .seed = 1}, 6000, 0.5e-6);
    const auto whole = measure(trace, {.neighbours = false});
    CHECK_FALSE(whole.cut_offs.lambda_c);
    CHECK(std::abs(whole.rms_height.value - 0.4e-6) < whole.rms_height.error);
    CHECK(whole.rms_height.value > 0.2e-6);
    CHECK(detail::unmeasured_waves(whole.long_end, 20e-3).growth > 0.2);
    CHECK(std::abs(whole.long_end.hurst - 0.6) < 0.15);
    const auto by_drawing = with_drawing_cut_off(*whole.profile);
    REQUIRE(by_drawing.cut_offs.lambda_c);
    CHECK(*by_drawing.cut_offs.lambda_c < 1e-3);
    CHECK(by_drawing.rms < 0.5 * whole.rms_height.value);
    const auto given = measure(trace, {.lambda_c = *by_drawing.cut_offs.lambda_c, .neighbours = false});
    CHECK(test::relative_error(given.rms_height.value, by_drawing.rms) < 1e-12);
    CHECK(given.long_end.open == 0);
}

TEST_CASE("The form takes of sigma what the long waves can explain, not the tilt of the instrument") {
    for (const double longest : {64e-6, 32e-6}) {  // a quarter and an eighth of the side
        double taken = 0, found = 0;
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            auto map = self_affine_map<double>(
                {.hurst = 0.8, .rms = 1e-6, .longest_wavelength = longest, .shortest_wavelength = 16e-6, .seed = seed},
                512, 512, 1e-6, 1e-6);
            HeightMap<double> part{map.heights.block(0, 0, 256, 256), 1e-6, 1e-6};
            const MeasureOptions<double> how{.texture = false, .dimension = false, .neighbours = false};
            const double share = measure(part, how).long_end.form_share;
            const double ratio = rms_height(part) / rms_height(detail::level(part, MapForm::plane).map);
            const double actual = std::sqrt(ratio * ratio - 1);
            CHECK(share <= actual * (1 + 1e-9));
            taken += actual, found += share;
            for (Eigen::Index i = 0; i < 256; ++i) part.heights.col(i) += 1e-6 * static_cast<double>(i);
            CHECK(measure(part, how).long_end.form_share < 0.5);  // the rms height is 70 times as great
        }
        WARN("waves of " << longest << " m: the plane took " << taken / 20 << " of sigma, form_share " << found / 20);
        CHECK(found > 0.6 * taken);
        const auto map =
            self_affine_map<double>({.hurst = 0.8, .rms = 1e-6, .longest_wavelength = longest}, 128, 128, 1e-6, 1e-6);
        const MeasureOptions<double> mean{
            .map_form = MapForm::mean, .texture = false, .dimension = false, .neighbours = false};
        CHECK(measure(map, mean).long_end.form_share == 0);
    }
}

}  // namespace unmeasured_waves_test
