// SPDX-License-Identifier: BSD-3-Clause
// Truth: moments of bands in tests/data/persson.csv (20 digits), bands of moments in tests/data/hybrid.csv (15 digits).
#include <fstiff/surface/band_spectrum.hpp>
#include <fstiff/surface/spectrum.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/table.hpp"

namespace roughness_spectrum_test {

using namespace fstiff;

TEST_CASE("moments of a band: the table to 1e-13") {
    const test::Table table("persson.csv");
    for (std::size_t row = 0; row < table.size(); ++row) {
        const auto at = [&](const char* column) { return table.input(row, column); };
        const BandSpectrum<double> band{at("C0"), at("hurst"), at("q1"), at("q_rolloff"), at("q2")};
        CAPTURE(row);
        CHECK(test::relative_error(band.m0(), at("m0")) < 1e-13);
        CHECK(test::relative_error(band.m2(), at("m2")) < 1e-13);
        CHECK(test::relative_error(band.m4(), at("m4")) < 1e-13);
        CHECK(test::relative_error(band.rms_gradient() * band.rms_gradient(), 2 * band.m2()) < 1e-14);
    }
}

TEST_CASE("a band has the moments that it was made of") {
    const test::Table table("hybrid.csv");
    for (std::size_t row = 0; row < table.size(); ++row) {
        const auto at = [&](const char* column) { return table.input(row, column); };
        const SpectralMoments<double> moments{at("m0"), at("m2"), at("m4")};
        const auto band = detail::band_of_moments(moments, at("hurst"));
        CAPTURE(row);
        CHECK(test::relative_error(band.C0, at("C0")) < 1e-13);
        CHECK(test::relative_error(band.q1, at("q1")) < 1e-13);
        CHECK(test::relative_error(band.q2, at("q2")) < 1e-13);
        CHECK(test::relative_error(band.m0(), moments.m0) < 1e-13);
        CHECK(test::relative_error(band.m2(), moments.m2) < 1e-13);
        CHECK(test::relative_error(band.m4(), moments.m4) < 1e-13);
    }
    for (const double hurst : {0.1, 0.5, 0.999999, 1.0})
        for (const double alpha : {1.5001, 2.0, 10.0, 1e4}) {
            const SpectralMoments<double> moments = detail::moments_of_gradient(2e-6, 0.3, alpha);
            const auto band = detail::band_of_moments(moments, hurst);
            CAPTURE(hurst, alpha);
            // next to 1.5 the band is narrow, and its width loses the digits of alpha - 1.5
            const double bound = 1e-13 / std::min(1.0, alpha - 1.5);
            CHECK(test::relative_error(band.m0(), moments.m0) < bound);
            CHECK(test::relative_error(band.m2(), moments.m2) < bound);
            CHECK(test::relative_error(band.m4(), moments.m4) < bound);
        }
}

TEST_CASE("moments that no isotropic surface has are refused") {
    const auto fine = detail::moments_of_peaks(0.832e-6, 40e-6, 500e6);  // Table 1: alpha = 0.67
    CHECK(test::refusal([&] { (void)detail::band_of_moments(fine, 0.38); }).find("greater than 1.5") !=
          std::string::npos);
    const auto good = detail::moments_of_gradient(1e-6, 0.1, 8.0);
    for (const double hurst : {0.0, -0.5, 1.0000001, std::nan("")})
        CHECK(test::refusal([&] { (void)detail::band_of_moments(good, hurst); }).find("hurst") == 0);
    CHECK(test::refusal([&] { (void)detail::moments_of_gradient(1e-6, 0.0, 8.0); }).find("rms_gradient") == 0);
    CHECK(test::refusal([&] { BandSpectrum<double>{1, 0.8, 2, 1, 3}.validate(); }).find("q_rolloff") == 0);
    CHECK(test::refusal([&] { BandSpectrum<double>{1, 0.8, 2, 2, 2}.validate(); }).find("q2") == 0);
    CHECK(test::refusal([&] { SpectrumShells<double>{}.validate(); }).find("shells") == 0);
}

TEST_CASE("a band is cut where alpha has the value asked for, and is left alone where it has less") {
    for (const double hurst : {0.2, 0.8, 1.0})
        for (const double rolloff : {1.0, 3.0}) {
            const BandSpectrum<double> band{1, hurst, 1, rolloff, 1000};
            const auto cut = detail::cut_at_bandwidth(band, 5.0);
            CAPTURE(hurst, rolloff);
            CHECK(test::relative_error(cut.moments().bandwidth(), 5.0) < 1e-12);
            CHECK(cut.C0 == band.C0);
            CHECK(cut.q1 == band.q1);
            CHECK(cut.q_rolloff == band.q_rolloff);
            CHECK(cut.q2 < band.q2);
            CHECK(detail::cut_at_bandwidth(cut, 5.1).q2 == cut.q2);
            // the heights stay, the gradient goes
            CHECK(cut.rms_gradient() < 0.7 * band.rms_gradient());
        }
    const BandSpectrum<double> band{1, 0.8, 1, 1, 1000};
    for (const double alpha : {2.0, 0.0, std::nan("")})
        CHECK(test::refusal([&] { (void)detail::cut_at_bandwidth(band, alpha); }).find("alpha of the cut") == 0);
}

TEST_CASE("the least Hurst exponent of a band that is no wider than asked for") {
    for (const double alpha : {30.0, 200.0, 900.0}) {
        const auto moments = detail::moments_of_gradient(1e-6, 0.1, alpha);
        double last = 1;
        for (const double widest : {100.0, 1500.0, 1e5}) {
            const double hurst = detail::least_hurst(moments, widest);
            CAPTURE(alpha, widest, hurst);
            CHECK(hurst <= last);
            last = hurst;
            if (hurst == 1) {
                const auto band = detail::band_of_moments(moments, hurst);
                CHECK(band.q2 / band.q1 > widest);
            } else if (hurst > 0) {
                const auto band = detail::band_of_moments(moments, hurst);
                CHECK(test::relative_error(band.q2 / band.q1, widest) < 1e-9);
            }
        }
    }
    CHECK(detail::least_hurst(detail::moments_of_gradient(1e-6, 0.1, 2.0), 1e3) == 0);
    CHECK(detail::least_hurst(detail::moments_of_gradient(1e-6, 0.1, 1e4), 10.0) == 1);
    CHECK(detail::least_hurst(detail::moments_of_gradient(1e-6, 0.1, 1e4), std::numeric_limits<double>::infinity()) ==
          0);
    CHECK(test::refusal([] {
              (void)detail::least_hurst(detail::moments_of_gradient(1e-6, 0.1, 9.0), 1.0);
          }).find("widest") == 0);
}

}  // namespace roughness_spectrum_test
