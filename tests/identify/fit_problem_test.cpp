// SPDX-License-Identifier: BSD-3-Clause
// Truth: identities of the scales of a contact, differences of other steps, and curves with seeded noise.
#include <fstiff/contact/hybrid_of_band.hpp>
#include <fstiff/identify/identify.hpp>
#include <fstiff/surface/band_spectrum.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/normal.hpp"

namespace fit_problem_test {

using namespace fstiff;

namespace {

using Points = std::vector<Observation<double>>;
using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

const ContactParameters<double> blasted{.rms_height = 0.8e-6,
                                        .peak_radius = 12e-6,
                                        .peak_density = 2e9,
                                        .fractal_dimension = 1.5,
                                        .effective_modulus = 112.6e9,
                                        .r = 0.4,
                                        .theta = 1.0,
                                        .rms_gradient = 0.12,
                                        .alpha = 8};

std::vector<double> hertz(const ContactParameters<double>& x, std::span<const double> pressures) {
    const RoughContact contact(Roughness<double>{x.rms_height, x.peak_radius, x.peak_density, 0},
                               PeakDistribution<double>(x.r, x.theta), HertzLaw<double>{}, x.effective_modulus);
    std::vector<double> stiffness;
    for (const double p : pressures) stiffness.push_back(contact.at_pressure(p, Quantity::stiffness).stiffness.value);
    return stiffness;
}

std::vector<double> hybrid(const ContactParameters<double>& x, std::span<const double> pressures) {
    const auto band = detail::band_of_moments(detail::moments_of_gradient(x.rms_height, x.rms_gradient, x.alpha), 0.8);
    const auto contact = hybrid_of_band(band, x.effective_modulus);
    std::vector<double> stiffness;
    for (const double p : pressures) stiffness.push_back(contact.at_pressure(p, Quantity::stiffness).stiffness.value);
    return stiffness;
}

/// K of \p curve at \p count pressures from 1 to 1000 MPa.
Points points_of(const detail::CurveOfParameters<double>& curve, int count) {
    std::vector<double> pressures;
    for (int i = 0; i < count; ++i) pressures.push_back(1e6 * std::pow(1000.0, double(i) / (count - 1)));
    const auto stiffness = curve(blasted, pressures);
    Points data;
    for (std::size_t i = 0; i < pressures.size(); ++i) data.push_back({pressures[i], stiffness[i], 0});
    return data;
}

/// The greatest difference of two matrices of derivatives of ln K by logarithms.
double distance(const Matrix& a, const Matrix& b) { return (a - b).cwiseAbs().maxCoeff(); }

}  // namespace

TEST_CASE("slopes of hertz are homogeneous in length, modulus and density") {
    using enum Parameter;
    const detail::CurveOfParameters<double> curve = hertz;
    const Points data = points_of(curve, 8);
    const std::vector<Parameter> wanted{rms_height, peak_radius, peak_density, effective_modulus, offset};
    const std::optional<ObservedWave<double>> no_wave;
    detail::CurveModel<double> model(data, wanted, blasted, curve, no_wave);
    Vector residuals(8);
    Matrix slopes(8, 5);
    REQUIRE(model(model.start(), residuals, slopes));  // d ln K/d ln x, of the offset d ln K/dp
    CHECK(slopes.leftCols(4).cwiseAbs().minCoeff() > 1e-4);
    for (Eigen::Index i = 0; i < 8; ++i) {
        const double by_pressure = slopes(i, 4) * data[static_cast<std::size_t>(i)].pressure;
        CAPTURE(i, by_pressure);
        CHECK(1e9 * std::abs(slopes(i, 0) + slopes(i, 1) - 2 * slopes(i, 2) + 1) < 0.1);  // K is over a length
        CHECK(1e9 * std::abs(slopes(i, 3) + by_pressure - 1) < 0.1);                      // K/E is a function of p/E
        CHECK(1e9 * std::abs(slopes(i, 2) - slopes(i, 3)) < 0.1);                         // E and D_p are a product
    }
}

TEST_CASE("slopes are those of steps of other lengths") {
    using enum Parameter;
    const auto check = [](const detail::CurveOfParameters<double>& curve, const std::vector<Parameter>& wanted) {
        const Points data = points_of(curve, 8);
        const std::optional<ObservedWave<double>> no_wave;
        detail::CurveModel<double> model(data, wanted, blasted, curve, no_wave);
        const auto count = static_cast<Eigen::Index>(wanted.size());
        Vector residuals(8);
        Matrix slopes(8, count), unused(8, count), independent(8, count);
        REQUIRE(model(model.start(), residuals, slopes));
        for (Eigen::Index k = 0; k < count; ++k) {
            // Richardson's of central differences of steps of 0.02, 0.01 and 0.005
            const auto central = [&](double step) {
                Vector u = model.start(), up(8), down(8);
                u(k) += step;
                REQUIRE(model(u, up, unused));
                u(k) -= 2 * step;
                REQUIRE(model(u, down, unused));
                return Vector((up - down) / (2 * step));
            };
            const Vector a = central(0.02), b = central(0.01), c = central(0.005);
            independent.col(k) = (64 * c - 20 * b + a) / 45;
        }
        CHECK(independent.cwiseAbs().maxCoeff() > 0.5);
        CHECK(1e9 * distance(slopes, independent) < 0.1);
        return slopes;
    };
    check(hertz, {rms_height, peak_radius, peak_density, effective_modulus, r, theta});
    const Matrix slopes = check(hybrid, {rms_height, rms_gradient, alpha, effective_modulus});
    // K sigma/p is a function of p/(E g), alpha and H
    CHECK(1e9 * distance(slopes.col(1), slopes.col(3)) < 0.1);
}

TEST_CASE("sigma and g of hybrid lie in their 95 % intervals in 95 of 100 runs, within chance") {
    using enum Parameter;
    const detail::CurveOfParameters<double> curve = hybrid;
    const Points exact = points_of(curve, 10);
    Points data = exact;
    int hits[2] = {0, 0};
    for (int run = 0; run < 60; ++run) {
        test::Normal noise(static_cast<std::uint64_t>(500 + run));
        for (std::size_t i = 0; i < data.size(); ++i) {
            data[i].error = 0.01 * exact[i].value;
            data[i].value = exact[i].value + data[i].error * noise();
        }
        ContactParameters<double> start = blasted;
        start.rms_height *= 1.3, start.rms_gradient *= 0.7;
        const auto fit = detail::identify_curve(data, {rms_height, rms_gradient}, start, curve);
        REQUIRE(fit.status == math::FitStatus::converged);
        for (std::size_t i = 0; i < 2; ++i) {
            const double truth = i == 0 ? blasted.rms_height : blasted.rms_gradient;
            hits[i] += fit.parameters[i].low <= truth && truth <= fit.parameters[i].high ? 1 : 0;
        }
    }
    for (const int hit : hits) {  // binomial: 57 with a standard deviation of 1.7
        CAPTURE(hit);
        CHECK(hit >= 53);
    }
}

TEST_CASE("parameters that a curve by differences cannot separate are singular and points out of reach are refused") {
    using enum Parameter;
    const detail::CurveOfParameters<double> curve = hybrid;
    const Points data = points_of(curve, 8);
    const auto product = detail::identify_curve(data, {rms_gradient, effective_modulus}, blasted, curve);
    REQUIRE(product.status == math::FitStatus::singular);
    CHECK(product.parameters[0].null_share > 0.9);
    CHECK(product.parameters[1].null_share > 0.9);
    CHECK(detail::identify_curve(data, {peak_radius}, blasted, curve).status == math::FitStatus::singular);
    ContactParameters<double> start = blasted;
    start.alpha = 1.2;  // no isotropic surface has it
    CHECK_THROWS_AS(detail::identify_curve(data, {rms_height}, start, curve), domain_error);
    start = blasted;
    start.alpha = 6;
    const auto fit = detail::identify_curve(data, {rms_height, alpha, offset}, start, curve);
    CHECK(fit.status == math::FitStatus::converged);
    CHECK(test::relative_error(fit.optimum.alpha, blasted.alpha) < 1e-5);
    CHECK(std::abs(fit.optimum.offset) < 1);
}

}  // namespace fit_problem_test
