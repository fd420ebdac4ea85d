// SPDX-License-Identifier: BSD-3-Clause
// Truth: G of the waves up to q by Simpson's rule over 2 pi q^3 C(q), and sums over shells by hand.
#include <fstiff/surface/band_spectrum.hpp>
#include <fstiff/surface/gradient_spectrum.hpp>
#include <fstiff/surface/spectrum.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

namespace gradient_spectrum_test {

using namespace fstiff;

TEST_CASE("q of the gradient of a band is that up to which the spectrum has this gradient") {
    for (const double hurst : {0.3, 0.8, 1.0}) {
        const BandSpectrum<double> band{1e-12, hurst, 2.0, 5.0, 400.0};
        const auto pieces = detail::gradient_pieces<double>(band);
        REQUIRE(pieces.size() == 2);
        CHECK(pieces[0].from == 0);
        CHECK(pieces[0].to == pieces[1].from);
        CHECK(test::relative_error(pieces[1].to, band.rms_gradient()) < 1e-13);
        const auto density = [&](double log_q) {  // 2 pi q^3 C dq = 2 pi q^4 C d ln q
            const double q = std::exp(log_q);
            return 2 * std::numbers::pi_v<double> * std::pow(q, 4) * band.C0 *
                   std::pow(std::max(q, band.q_rolloff), -2 - 2 * hurst);
        };
        const auto simpson = [&](double a, double b) {
            constexpr int n = 2000;
            double sum = density(a) + density(b);
            for (int i = 1; i < n; ++i) sum += (i % 2 == 1 ? 4 : 2) * density(a + (b - a) * i / n);
            return sum * (b - a) / (3 * n);
        };
        const double flat = simpson(std::log(2.0), std::log(5.0));
        for (const double q : {2.5, 4.9, 5.1, 30.0, 399.0}) {
            const double square =
                q < 5 ? simpson(std::log(2.0), std::log(q)) : flat + simpson(std::log(5.0), std::log(q));
            CAPTURE(hurst, q);
            CHECK(test::relative_error(pieces[q < 5 ? 0 : 1].inverse_q(std::sqrt(square)), 1 / q) < 1e-10);
        }
    }
}

TEST_CASE("q of the gradient of shells is constant in a shell") {
    SpectrumShells<double> spectrum;
    spectrum.rms_height = 1;
    spectrum.shells = {{0.09, 0.03}, {0.16, 0.04}};
    const auto pieces = detail::gradient_pieces<double>(spectrum);
    REQUIRE(pieces.size() == 2);
    CHECK(test::relative_error(pieces[0].to, 0.3) < 1e-15);
    CHECK(test::relative_error(pieces[1].to, 0.5) < 1e-15);
    for (const double G : {0.01, 0.2}) CHECK(test::relative_error(pieces[0].inverse_q(G), 1 / 3.0) < 1e-15);
    CHECK(test::relative_error(pieces[1].inverse_q(0.4), 0.25) < 1e-15);
}

}  // namespace gradient_spectrum_test
