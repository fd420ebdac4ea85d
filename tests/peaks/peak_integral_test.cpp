// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/peaks/contact_integrals.hpp>
#include <fstiff/peaks/tensor_integrals.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <cmath>
#include <limits>

namespace peak_integral_test {

using fstiff::peak_integral;
using fstiff::PeakDistribution;

TEST_CASE("an integral over the peaks has the closed forms of 1, of t and of powers") {
    for (const double eta : {-2.0, 0.5, 3.0}) {  // r = 0: heights are normal, and do not depend on the curvature
        const auto share = peak_integral([](double, double) { return 1.0; }, PeakDistribution<double>(0, 1), eta);
        CHECK(std::abs(share.value - std::erfc(eta / std::sqrt(2.0)) / 2) <= share.error);
    }
    const PeakDistribution<double> peaks(0.6, 0.9);
    const auto curvature = peak_integral([](const auto&, double t) { return t; }, peaks, -40);
    CHECK(std::abs(curvature.value - peaks.mean_curvature()) <= curvature.error);
    CHECK(curvature.error < 1e-11);
    const auto height = peak_integral([](double e, double) { return e - 40; }, peaks, -40);
    CHECK(std::abs(height.value - peaks.mean_height()) <= height.error);
    for (const double eta : {-1.0, 0.0, 2.0, 12.0})
        for (const auto& [a, b] :
             {std::pair(0.0, 0.0), std::pair(1.5, -0.5), std::pair(0.5, -0.5), std::pair(1.0, -1.0)}) {
            const auto power = [a = a, b = b](double e, double t) { return std::pow(e, a) * std::pow(t, b); };
            const auto truth = fstiff::contact_integral(a, b, peaks, eta);
            const auto found = peak_integral(power, peaks, eta);
            CHECK(std::abs(found.value - truth.value) <= found.error + truth.error);
            CHECK(found.error < 1e-11 * truth.value);
        }
}

TEST_CASE("an integral over the peaks of any other function, against mpmath") {
    // quad() of mpmath over zeta - eta in (0, 14) and t in (0, 13), 18 to 25 digits
    const auto grows =
        peak_integral([](auto e, double t) { return (e.exp() - 1) * t; }, PeakDistribution<double>(0.5, 1), 1);
    CHECK(std::abs(grows.value - 0.46732994754542622249) <= grows.error);
    CHECK(test::relative_error(grows.value, 0.46732994754542622249) < 1e-12);
    const auto logarithm = [](double e, double t) { return std::log1p(e) * t; };
    const auto found = peak_integral(logarithm, PeakDistribution<double>(0.3, 0.7), -1);
    CHECK(std::abs(found.value - 0.95673927655604269891) <= found.error);
    CHECK(test::relative_error(found.value, 0.95673927655604269891) < 1e-12);
    const auto above = peak_integral(logarithm, PeakDistribution<double>(0.3, 0.7), 2);
    CHECK(std::abs(above.value - 0.020069743357441374) <= above.error);
}

TEST_CASE("an integral over the peaks of what grows as an exponential, or changes its sign, covers its error") {
    for (const double k : {1.0, 2.0, 4.0})
        for (const double eta : {-3.0, 0.0, 5.0}) {
            // r = 0: exp(k e) under the normal density is exp(k^2/2 - k eta) erfc((eta - k)/sqrt 2)/2
            const double truth = std::exp(k * k / 2 - k * eta) * std::erfc((eta - k) / std::sqrt(2.0)) / 2;
            const auto found =
                peak_integral([k](auto e, double) { return (k * e).exp(); }, PeakDistribution<double>(0, 1), eta);
            INFO("k " << k << " eta " << eta << " off by " << found.value / truth - 1 << ", error "
                      << found.error / truth);
            CHECK(std::abs(found.value - truth) <= found.error + 1e-14 * truth);
            CHECK(found.error < 1e-11 * truth);
        }
    const PeakDistribution<double> peaks(0.5, 1);
    const double mean = peaks.mean_curvature();
    const auto none = peak_integral([mean](double, double t) { return t - mean; }, peaks, -40);
    CHECK(std::abs(none.value) <= none.error);
    CHECK(none.error < 1e-13);
}

namespace {

struct Step {
    static double critical(double) { return 0.4; }
    double operator()(double e, double) const { return e < 0.4 ? 0 : 1; }
};
struct Untold {
    static constexpr auto axis = fstiff::NodeClustering::rough;
    double operator()(double e, double t) const { return Step{}(e, t); }
};

}  // namespace

TEST_CASE("an integral over the peaks splits at kinks, and falls to 0 in good order") {
    const PeakDistribution<double> peaks(0.5, 1);
    const double truth = fstiff::contact_integral(0.0, 0.0, peaks, 1.4).value;
    const auto told = peak_integral(Step{}, peaks, 1, {.relative_tolerance = 1e-9});
    CHECK(std::abs(told.value - truth) <= told.error);
    CHECK(told.error <= 1e-9 * truth);
    const auto untold = peak_integral(Untold{}, peaks, 1);
    CHECK(std::abs(untold.value - truth) <= untold.error);
    CHECK(untold.error > 1e-6 * truth);

    const auto load = [](double e, double t) { return e * std::sqrt(e / t); };
    const auto far = peak_integral(load, peaks, 38.0), gone = peak_integral(load, peaks, 1e3);
    const auto of_far = fstiff::contact_integral(1.5, -0.5, peaks, 38.0);
    CHECK(std::abs(far.value - of_far.value) <= far.error + of_far.error);
    CHECK(gone.value == 0);
    CHECK((gone.error > 0 && gone.error < std::numeric_limits<double>::min()));
    const auto coarse = peak_integral(load, PeakDistribution<float>(0.5F, 1), 1);
    CHECK(test::relative_error(double(coarse.value), fstiff::contact_integral(1.5, -0.5, peaks, 1.0).value) < 1e-4);
}

TEST_CASE("an integral over the peaks is refused where the function is not finite, or an argument out of range") {
    const PeakDistribution<double> peaks(0.5, 1);
    const auto refusal = [&](const auto& f, double eta, double tolerance) {
        return test::refusal(
            [&] { static_cast<void>(peak_integral(f, peaks, eta, {.relative_tolerance = tolerance})); });
    };
    CHECK(refusal([](double e, double) { return std::sqrt(e - 1); }, 0, 1e-6).find("f must be finite for every peak") !=
          std::string::npos);
    CHECK(refusal([](double e, double) { return e; }, 2e6, 1e-6).starts_with("eta = 2000000: must be"));
    CHECK(refusal([](double e, double) { return e; }, std::nan(""), 1e-6).starts_with("eta = nan: must be"));
    CHECK(refusal([](double e, double) { return e; }, 0, 0).starts_with("relative_tolerance = 0: must be"));
}

}  // namespace peak_integral_test
