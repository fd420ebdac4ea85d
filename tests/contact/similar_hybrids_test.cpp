// SPDX-License-Identifier: BSD-3-Clause
// Truth: the contact of each surface by itself, hybrid_of_band().
#include <fstiff/contact/hybrid_of_band.hpp>
#include <fstiff/contact/similar_hybrids.hpp>
#include <fstiff/math/statistics.hpp>
#include <fstiff/surface/band_spectrum.hpp>
#include <fstiff/surface/bearing_of_core.hpp>
#include <fstiff/surface/material_ratio.hpp>
#include <fstiff/surface/material_ratio_slope.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <cmath>
#include <thread>
#include <vector>

namespace similar_hybrids_test {

using namespace fstiff;

constexpr double modulus = 112.6e9, sigma = 0.8e-6, gradient = 0.07;

/// The largest error over pressures of 1e-5 to 0.3 E g.
template <class ContactOf>
double worst(const detail::SimilarHybrids<double>& similar, double alpha, double hurst, const ContactOf& contact_of) {
    const auto moments = detail::moments_of_gradient(sigma, gradient, alpha);
    const auto contact = contact_of(detail::band_of_moments(moments, hurst));
    double most = 0;
    for (double x = 1e-5; x < 0.3; x *= 3.7) {
        const double p = x * modulus * gradient;
        const auto K = similar.stiffness(moments, hurst, modulus, p);
        REQUIRE(K);
        most = (std::max)(
            most, std::abs(test::relative_error(*K, contact.at_pressure(p, Quantity::stiffness).stiffness.value)));
    }
    return most;
}

TEST_CASE("Surfaces drawn about one have K of the table of similar ones") {
    const detail::SimilarHybrids<double> similar(nullptr);
    const auto contact_of = [](const BandSpectrum<double>& band) { return hybrid_of_band(band, modulus); };
    for (const double alpha : {2.6, 3.3, 5.9, 6.1, 9.0, 40.0, 300.0}) {
        INFO("alpha = " << alpha << ", off by " << worst(similar, alpha, 0.8, contact_of));
        CHECK(worst(similar, alpha, 0.8, contact_of) < 4e-4);
    }
    for (const double hurst : {0.72, 0.77, 0.96}) {
        INFO("H = " << hurst << ", off by " << worst(similar, 12.0, hurst, contact_of));
        CHECK(worst(similar, 12.0, hurst, contact_of) < 4e-4);
        CHECK(worst(similar, 80.0, hurst, contact_of) < 4e-4);
    }
}

TEST_CASE("The table of similar surfaces takes a bearing curve") {
    for (const auto& [skewness, kurtosis] : {std::pair(-1.2, 5.0), std::pair(0.9, 4.0), std::pair(1.8, 75.0)}) {
        const MaterialRatioSlope<double> curve = detail::bearing_of_moments(skewness, kurtosis);
        const detail::SimilarHybrids<double> similar(&curve, 0.42);
        for (const double alpha : {2.7, 11.0}) {
            const double off = worst(similar, alpha, 0.8, [&](const BandSpectrum<double>& band) {
                return hybrid_of_band(band, curve, modulus, 0.42);
            });
            INFO("skewness " << skewness << ", alpha = " << alpha << ", off by " << off);
            CHECK(off < (kurtosis > 10 ? 1.2e-3 : 4e-4));
        }
    }
}

TEST_CASE("Several threads that ask the table of similar surfaces find what one finds") {
    constexpr std::size_t count = 60;
    const auto K = [](const detail::SimilarHybrids<double>& similar, std::size_t i) {
        const double alpha = 3 + 0.5 * static_cast<double>(i % 7), x = 1e-4 * std::pow(1.1, static_cast<double>(i));
        return similar
            .stiffness(detail::moments_of_gradient(sigma, gradient, alpha), 0.8, modulus, x * modulus * gradient)
            .value();
    };
    const detail::SimilarHybrids<double> alone(nullptr), shared(nullptr);
    std::vector<double> found(count);
    const auto ask = [&](std::size_t from, std::size_t by) {
        for (std::size_t i = from; i < count; i += by) found[count - 1 - i] = K(shared, count - 1 - i);
    };
    std::thread other(ask, 0, 2);
    ask(1, 2);
    other.join();
    for (std::size_t i = 0; i < count; ++i) CHECK(found[i] == K(alone, i));
}

TEST_CASE("The table of similar surfaces has no K where no surface or no contact is, and none beyond its reach") {
    const detail::SimilarHybrids<double> similar(nullptr);
    const auto at = [&](double alpha, double hurst, double x) {
        return similar
            .stiffness(detail::moments_of_gradient(sigma, gradient, alpha), hurst, modulus, x * modulus * gradient)
            .has_value();
    };
    CHECK(at(4, 0.8, 0.01));
    CHECK_FALSE(at(2.4, 0.8, 0.01));
    CHECK_FALSE(at(4, 0.25, 0.01));
    CHECK_FALSE(at(2e5, 0.8, 0.01));
    CHECK_FALSE(at(4, 0.8, 0.74));
    CHECK_FALSE(at(4, 0.8, 1e-25));
}

}  // namespace similar_hybrids_test
