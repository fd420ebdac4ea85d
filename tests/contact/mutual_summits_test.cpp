// SPDX-License-Identifier: BSD-3-Clause
// Truth: Hertz's sphere with its images; a dense matrix of lattice sums; the derivative of p; boundary elements of
// tests/data/bem_maps.csv.
#include <fstiff/asperity/elliptic_hertz.hpp>
#include <fstiff/contact/contact.hpp>
#include <fstiff/contact/interaction.hpp>
#include <fstiff/contact/mutual_summits.hpp>
#include <fstiff/contact/summit_contact.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/half_space_maps.hpp"
#include "support/lattice_sum.hpp"
#include "support/table.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <numbers>
#include <random>

namespace mutual_summits_test {

using namespace fstiff;

static_assert(detail::ProportionalContact<detail::MutualSummits<double>, double>);

TEST_CASE("one summit that repeats: Hertz less the mean field of its images") {
    const double E = 1e11, side = 1e-4, R = 2.5e-5, omega = 1e-7;
    const Summits<double> one{{{2e-6, 4e4, 4e4, 3e-5, 4e-5}}, side * side, side, side, 1e-6};
    const detail::MutualSummits<double> contact(one, E, Edges::periodic);
    // the sum of 1/r over a square lattice, less its mean: 4 zeta(1/2) beta(1/2)
    const double C = 3.9002649200019563 * side / (std::numbers::pi * E);
    const double p = 4.0 / 3 * E * std::sqrt(R) * std::pow(omega, 1.5) / (side * side);
    const auto state = contact.at_pressure(p);
    CHECK(test::relative_error(state.separation.value, 2e-6 - omega + p * C) < 1e-9);
    CHECK(test::relative_error(1 / state.stiffness.value, side * side / (2 * E * std::sqrt(R * omega)) - C) < 1e-8);
    CHECK(test::relative_error(state.real_area_fraction.value, std::numbers::pi * R * omega / (side * side)) < 1e-8);
}

/// K and the separation of \p summits, all of which touch, by Newton's method with a dense matrix.
std::pair<double, double> dense(const Summits<double>& of, double p) {
    const auto n = static_cast<Eigen::Index>(of.summits.size());
    Eigen::MatrixXd g(n, n);
    Eigen::VectorXd z(n), c(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const auto& one = of.summits[static_cast<std::size_t>(i)];
        z[i] = one.height;
        c[i] = detail::elliptic_hertz(one.max_curvature, one.min_curvature).load_factor;
        for (Eigen::Index j = 0; j < n; ++j) {
            const auto& other = of.summits[static_cast<std::size_t>(j)];
            g(i, j) = test::lattice_influence(one.x - other.x, one.y - other.y, of.width, of.height);
        }
    }
    double d = z.minCoeff() - 0.1 * (z.maxCoeff() - z.minCoeff());
    Eigen::VectorXd omega = z.array() - d, k;
    Eigen::MatrixXd all(n + 1, n + 1);  // of omega and d: omega + d + g F = z, sum F = p A0
    for (int i = 0; i < 50; ++i) {
        const Eigen::VectorXd load = c.array() * omega.array().pow(1.5);
        k = 1.5 * c.array() * omega.array().sqrt();
        Eigen::VectorXd rest(n + 1);
        rest << z - omega - g * load - Eigen::VectorXd::Constant(n, d), p * of.area - load.sum();
        all.topLeftCorner(n, n) = Eigen::MatrixXd::Identity(n, n) + g * k.asDiagonal();
        all.topRightCorner(n, 1).setOnes();
        all.bottomLeftCorner(1, n) = k.transpose();
        all(n, n) = 0;
        const Eigen::VectorXd step = all.partialPivLu().solve(rest);
        omega = (omega + step.head(n)).cwiseMax(omega / 4);
        d += step[n];
    }
    const Eigen::MatrixXd compliance = Eigen::MatrixXd(k.cwiseInverse().asDiagonal()) + g;
    return {compliance.partialPivLu().solve(Eigen::VectorXd::Ones(n)).sum() / of.area, d};
}

TEST_CASE("the push by neighbours and a grid against a dense matrix of lattice sums") {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform;
    for (const double height : {1.0, 0.5}) {
        Summits<double> of{{}, 0.9 * height, 1, height, 1e-3};
        for (int i = 0; i < 120; ++i)
            of.summits.push_back({1e-4 * uniform(random), 100 + 400 * uniform(random), 30 + 70 * uniform(random),
                                  uniform(random), height * uniform(random)});
        std::sort(of.summits.begin(), of.summits.end(),
                  [](const auto& a, const auto& b) { return a.height > b.height; });
        const double p = 2e-3;
        const auto [K, d] = dense(of, p);
        const auto state = detail::MutualSummits<double>(of, 1.0, Edges::periodic).at_pressure(p);
        CAPTURE(height, K, d, state.contact_density.value);
        CHECK(state.contact_density.value * of.area > 119.5);  // all touch
        CHECK(test::relative_error(state.stiffness.value, K) < 1e-8);
        CHECK(std::abs(state.separation.value - d) < 1e-8 * 1e-3);
        CHECK(test::relative_error(SummitContact<double>(of, 1.0).at_pressure(p).stiffness.value, K) > 0.05);
    }
}

TEST_CASE("summits that push each other down: K is the slope, pressure and separation undo each other") {
    const auto map = test::half_space_map("rougher");
    for (const Edges edges : {Edges::periodic, Edges::mirrored}) {
        const detail::MutualSummits<double> contact(summits_of(map), 1.0, edges);
        for (const double p : {3e-5, 3e-4, 1e-3}) {
            const auto state = contact.at_pressure(p), low = contact.at_pressure(p * (1 - 1e-5)),
                       high = contact.at_pressure(p * (1 + 1e-5));
            CAPTURE(p);
            const double slope = 2e-5 * p / (low.separation.value - high.separation.value);
            CHECK(test::relative_error(state.stiffness.value, slope) <
                  1e-5);  // of the grid, which changes with the summits
            CHECK(test::relative_error(contact.at_separation(state.separation.value).pressure.value, p) < 1e-6);
            const auto log_p = contact.log_pressure(state.eta);
            CHECK(test::relative_error(log_p.log, std::log(p)) < 1e-6);
            const auto crowding = contact.crowding(p);
            CHECK(crowding.real_area_fraction == state.real_area_fraction.value);
            CHECK(crowding.softening > 0.8);
            CHECK(static_cast<double>(crowding.contacts) == std::round(state.contact_density.value * contact.area()));
        }
    }
}

TEST_CASE("summits that push each other down against boundary elements") {
    const test::Table table("bem_maps.csv");
    double least = 9, most = 0, least_alone = 9, most_alone = 0;
    for (std::size_t row = 0; row < table.size(); ++row) {
        if (table.input(row, "p_star") > 0.0101) continue;
        const auto summits = summits_of(test::half_space_map(table.text(row, "map")));
        const double p = table.input(row, "p_over_E"), truth = table.input(row, "stiffness_times_L_over_E");
        const double ratio =
            detail::MutualSummits<double>(summits, 1.0, Edges::periodic).at_pressure(p).stiffness.value / truth;
        const double alone = SummitContact<double>(summits, 1.0).at_pressure(p).stiffness.value / truth;
        least = std::min(least, ratio), most = std::max(most, ratio);
        least_alone = std::min(least_alone, alone), most_alone = std::max(most_alone, alone);
    }
    CAPTURE(least, most, least_alone, most_alone);
    CHECK(least > 0.90);
    CHECK(most < 1.06);
    CHECK(least_alone < 0.80);  // what the deflection mends
}

TEST_CASE("summits that are too crowded are refused") {
    const auto map = test::half_space_map("rougher");
    const detail::MutualSummits<double> contact(summits_of(map), 1.0, Edges::periodic);
    const auto far_on = contact.point_at_pressure(0.1);
    CHECK(far_on.status == PointStatus::out_of_reach);
    CHECK(far_on.reason.find("hybrid and boundary_elements go on") != std::string::npos);
    CHECK(test::refusal([&] { (void)contact.at_pressure(0.0); }).find("pressure") == 0);
    CHECK(test::refusal([&] { (void)contact.at_separation(1.0); }).find("separation") == 0);
}

}  // namespace mutual_summits_test
