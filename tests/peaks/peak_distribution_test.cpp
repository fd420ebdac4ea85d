// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/peaks/peak_distribution.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <functional>
#include <numbers>
#include <vector>

namespace peak_distribution_test {

using fstiff::PeakDistribution;

namespace {

constexpr double pi = std::numbers::pi;

/// The mean of f(zeta, t) over the density, by a plain product rule: slow and independent of the closed forms.
double mean(const PeakDistribution<double>& peaks, const std::function<double(double, double)>& f) {
    const double step = 0.02;
    double sum = 0;
    for (double u = -4; u < 10; u += step) {  // t = log(1 + exp(u - exp(-u)))
        const double rise = std::exp(u - std::exp(-u));
        const double t = std::log1p(rise);
        const double weight = (1 + std::exp(-u)) * rise / (1 + rise);
        for (double z = -9; z < 9; z += 0.1) {
            const double zeta = peaks.r() * t + z * peaks.c();
            sum += step * 0.1 * peaks.c() * weight * peaks(zeta, t) * f(zeta, t);
        }
    }
    return sum;
}

}  // namespace

TEST_CASE("the density is normalised and its moments are the closed forms") {
    for (const auto& [r, theta] :
         std::vector<std::pair<double, double>>{{0, pi / 4}, {0.5, pi / 3}, {0.8, 1.3}, {0.3, 0.01}}) {
        const PeakDistribution<double> peaks(r, theta);
        INFO("r " << r << " theta " << theta);
        CHECK(std::abs(mean(peaks, [](double, double) { return 1; }) - 1) < 1e-13);  // (4.3)
        for (int n = 1; n <= 4; ++n)
            CHECK(test::relative_error(mean(peaks, [n](double, double t) { return std::pow(t, n); }),
                                       peaks.curvature_moment(n)) < 1e-12);
        const double m = peaks.mean_height();
        const double v = peaks.height_variance();
        CHECK(std::abs(mean(peaks, [](double z, double) { return z; }) - m) < 1e-13);
        CHECK(test::relative_error(mean(peaks, [m](double z, double) { return std::pow(z - m, 2); }), v) < 1e-12);
        CHECK(std::abs(mean(peaks, [&](double z, double) { return std::pow((z - m) / std::sqrt(v), 3); }) -
                       peaks.height_skewness()) < 1e-12);
        CHECK(std::abs(mean(peaks, [&](double z, double) { return std::pow((z - m) / std::sqrt(v), 4); }) -
                       peaks.height_kurtosis()) < 1e-11);
    }
}

TEST_CASE("the height distributions of Fig. 2") {
    // closed forms by mpmath with 30 digits, rounded to five; theta = pi/3
    struct Row {
        double r, mean, variance, skewness, kurtosis;
    };
    for (const Row& row : {Row{1.0 / 2, .51824, .83480, .02686, 3.00737}, Row{1.0 / 3, .34549, .92658, .00680, 3.00118},
                           Row{1.0 / 5, .20730, .97357, .00136, 3.00014}}) {
        const PeakDistribution<double> peaks(row.r, pi / 3);
        CHECK(std::abs(peaks.mean_height() - row.mean) < 5.1e-6);
        CHECK(std::abs(peaks.height_variance() - row.variance) < 5.1e-6);
        CHECK(std::abs(peaks.height_skewness() - row.skewness) < 5.1e-6);
        CHECK(std::abs(peaks.height_kurtosis() - row.kurtosis) < 5.1e-6);
    }
}

TEST_CASE("the marginal of the height has the moments of the density") {
    for (const auto& [r, theta] :
         std::vector<std::pair<double, double>>{{0, pi / 4}, {0.5, pi / 3}, {0.9, 1.5}, {0.999, 0.3}, {0.3, 1.5707}}) {
        const PeakDistribution<double> peaks(r, theta);
        double total = 0, first = 0, second = 0;
        const double step = 0.01;
        for (double zeta = -9; zeta < 12; zeta += step) {
            const double p = peaks.height_marginal(zeta) * step;
            total += p;
            first += p * zeta;
            second += p * zeta * zeta;
        }
        INFO("r " << r << " theta " << theta);
        CHECK(std::abs(total - 1) < 1e-11);
        CHECK(std::abs(first - peaks.mean_height()) < 1e-11);
        CHECK(std::abs(second - first * first - peaks.height_variance()) < 1e-11);
    }
    CHECK(PeakDistribution<double>(0.5, 1).height_marginal(60) == 0);
    CHECK(test::relative_error(PeakDistribution<double>(0.0, 1.0).height_marginal(1.0),
                               std::exp(-0.5) / std::sqrt(2 * pi)) < 1e-13);
}

TEST_CASE("the limits: Rayleigh for small theta, half-normal for theta near pi/2") {
    const PeakDistribution<double> small(0, 1e-5), large(0, pi / 2 - 1e-6);
    for (const double t : {0.1, 1.0, 2.5}) {
        CHECK(test::relative_error(small(0, t), t * std::exp(-t * t / 2) / std::sqrt(2 * pi)) < 1e-9);
        CHECK(test::relative_error(large(0, t), 2 / std::sqrt(2 * pi) * std::exp(-t * t / 2) / std::sqrt(2 * pi)) <
              1e-6);
    }
}

TEST_CASE("autocorrelations and (r, theta) are each other's inverse") {
    for (const double r : {0.1, 0.5, 0.9})
        for (const double theta : {0.1, 0.8, 1.3, 1.5}) {
            const double rho1 = 1 - 2 * r * r * std::pow(std::sin(theta), 2);
            const double rho2 = 1 - 2 * r * r * std::pow(std::sin(2 * theta), 2);
            const auto peaks = PeakDistribution<double>::from_autocorrelation(rho1, rho2);
            INFO("r " << r << " theta " << theta);
            // 3 - 4 rho1 + rho2 cancels to 8 r^2 sin^4 theta: 4e-16 / 8e-6 at worst
            CHECK(test::relative_error(peaks.r(), r) < 1e-9);
            CHECK(test::relative_error(peaks.theta(), theta) < 1e-9);
        }
}

TEST_CASE("exponential autocorrelation: 1 - r^2 = cot^2 theta") {
    const auto quarter = PeakDistribution<double>::exponential(pi / 4);
    const auto third = PeakDistribution<double>::exponential(pi / 3);
    CHECK(quarter.r() < 1e-7);
    CHECK(test::ulps(third.r(), std::sqrt(2.0 / 3)) <= 4);
    const double rho = 0.4;
    const auto from_rho = PeakDistribution<double>::from_autocorrelation(rho, rho * rho);
    CHECK(test::ulps(PeakDistribution<double>::exponential(from_rho.theta()).r(), from_rho.r()) <= 20);
    CHECK_NOTHROW(PeakDistribution<float>::exponential(std::numbers::pi_v<float> / 3));
}

TEST_CASE("peaks of an isotropic surface: r = 1/sqrt(alpha), and the limit of a vanishing step") {
    const auto peaks = PeakDistribution<double>::isotropic(4.0);
    CHECK(peaks.r() == 0.5);
    // theta -> 0: t/(c sqrt(2 pi)) exp(-(zeta - r t)^2/(2 c^2)) exp(-t^2/2), a Rayleigh distribution of curvatures
    const double c = std::sqrt(0.75);
    for (const double t : {0.1, 1.0, 3.0}) {
        const double z = (1.2 - 0.5 * t) / c, limit = t / (c * std::sqrt(2 * pi)) * std::exp(-(z * z + t * t) / 2);
        CHECK(test::relative_error(peaks(1.2, t), limit) < 2e-6);
    }
    CHECK(test::relative_error(peaks.mean_curvature(), std::sqrt(pi / 2)) < 1e-6);
    for (const double alpha : {1.0, 0.0, std::nan("")})
        CHECK(test::refusal([&] { PeakDistribution<double>::isotropic(alpha); }).starts_with("Nayak's alpha"));
}

TEST_CASE("parameters out of range are refused by name, value and range") {
    const auto refused = [](double r, double theta) {
        return test::refusal([&] { PeakDistribution<double>(r, theta); });
    };
    CHECK(refused(1, 1) == "r = 1: must be at least 0 and less than 1");
    CHECK(refused(-0.1, 1).starts_with("r = -0.1: must be"));
    CHECK(refused(std::nan(""), 1).starts_with("r = nan: must be"));
    CHECK(refused(0.5, 0).starts_with("theta = 0: must be between 0 and pi/2"));
    CHECK(refused(0.5, 1.6).starts_with("theta = 1.6: must be between 0 and pi/2"));
    CHECK(test::refusal([] {
              PeakDistribution<double>::exponential(0.5);
          }).starts_with("theta = 0.5: must be between pi/4 and pi/3"));
    CHECK(test::refusal([] { PeakDistribution<double>::from_autocorrelation(0.5, -0.9); }).starts_with("rho2 = -0.9"));
    CHECK(test::refusal([] { PeakDistribution<double>::from_autocorrelation(1, 0.5); }).starts_with("rho1 = 1"));
    CHECK(test::refusal([] {
              static_cast<void>(PeakDistribution<double>(0.5, 1).curvature_moment(5));
          }).starts_with("moment order = 5"));
}

}  // namespace peak_distribution_test
