// SPDX-License-Identifier: BSD-3-Clause
// Truth: Ewald's sum carried out over images and waves, with another split; pressures on a grid; reciprocity.
#include <fstiff/halfspace/point_forces.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/lattice_sum.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace point_forces_test {

using namespace fstiff;
using Values = Eigen::ArrayXd;

/// Deflection of point \p i by periodic images, by the definition.
double direct(const Values& x, const Values& y, const Values& force, double width, double height, Eigen::Index i) {
    double u = 0;
    for (Eigen::Index j = 0; j < x.size(); ++j)
        u += test::lattice_influence(x[i] - x[j], y[i] - y[j], width, height) * force[j];
    return u;
}

struct Points {
    Values x, y, force;
};
Points drawn(Eigen::Index count, double width, double height) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform;
    Points points{Values(count), Values(count), Values(count)};
    for (Eigen::Index i = 0; i < count; ++i) {
        points.x[i] = width * uniform(random);
        points.y[i] = height * (i % 3 == 0 ? std::pow(uniform(random), 4) : uniform(random));  // crowded at one edge
        points.force[i] = std::pow(uniform(random), 2);
    }
    return points;
}

/// Compares the deflections of at most \p compared points with the sum over all images and waves.
void check_deflections(Eigen::Index compared) {
    for (const double height : {1.0, 0.4, 3.0})
        for (const Eigen::Index count : {1, 2, 30, 300}) {
            const auto [x, y, force] = drawn(count, 1, height);
            const Values u = detail::PointForces<double>(x, y, 1, height, Edges::periodic).deflections(force);
            const Values of_quick =
                detail::PointForces<double, detail::QuickSplit>(x, y, 1, height, Edges::periodic).deflections(force);
            double greatest = 0, error = 0, error_of_quick = 0;
            for (Eigen::Index i = 0; i < count; i += std::max<Eigen::Index>(1, count / compared)) {
                const double truth = direct(x, y, force, 1, height, i);
                greatest = std::max(greatest, std::abs(truth));
                error = std::max(error, std::abs(u[i] - truth));
                error_of_quick = std::max(error_of_quick, std::abs(of_quick[i] - truth));
            }
            CAPTURE(height, count, greatest);
            CHECK(error < 2e-9 * greatest);
            CHECK(error_of_quick < 2e-4 * greatest);
        }
}

TEST_CASE("deflections by neighbours and a grid against the sum over all images and waves, at 30 points") {
    check_deflections(30);
}
TEST_CASE("deflections by neighbours and a grid against the sum over all images and waves, at 300 points", "[long]") {
    check_deflections(300);
}

TEST_CASE("no point without a force is lower than the least deflection, and some is nearly as low") {
    for (const Edges edges : {Edges::periodic, Edges::mirrored}) {
        const auto [x, y, drawn_force] = drawn(200, 1, 0.7);
        Values force = drawn_force;
        force.tail(150) = 0;
        detail::PointForces<double> forces(x, y, 1, 0.7, edges), loaded(x.head(50), y.head(50), 1, 0.7, edges);
        const double least = loaded.least_deflection(force.head(50));
        const double lowest = forces.deflections(force).tail(150).minCoeff();
        CAPTURE(least, lowest);
        CHECK(least < lowest);
        CHECK(least > lowest - force.sum() / std::sqrt(0.7));
    }
}

TEST_CASE("mirrored points are the points and their images in a cell four times as large") {
    const auto [x, y, force] = drawn(60, 1, 0.7);
    Values all_x(240), all_y(240), all_force(240);
    all_x << x, 2 - x, x, 2 - x;
    all_y << y, y, 1.4 - y, 1.4 - y;
    all_force << force, force, force, force;
    detail::PointForces<double> mirrored(x, y, 1, 0.7, Edges::mirrored),
        periodic(all_x, all_y, 2, 1.4, Edges::periodic);
    const Values u = mirrored.deflections(force), truth = periodic.deflections(all_force).head(60);
    CHECK((u - truth).abs().maxCoeff() < 2e-9 * truth.abs().maxCoeff());
}

TEST_CASE("forces that are spread over a grid deflect it as pressures do, and lengths scale") {
    const int n = 24;
    Values x(n * n), y(n * n), force(n * n);
    detail::GridField<double> field(n, n);
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            x[j * n + i] = (i + 0.5) / n;
            y[j * n + i] = (j + 0.5) / n;
            field(j, i) = force[j * n + i] = std::cos(2 * std::numbers::pi * x[j * n + i]);
        }
    detail::SurfaceCompliance<double> compliance(n, n, 1.0 / n, 1.0 / n, Edges::periodic);
    compliance.deflect(field);
    const Values u = detail::PointForces<double>(x, y, 1, 1, Edges::periodic).deflections(force) / (n * n);
    // a cell as a point misses its own 4 ln(1 + sqrt 2)/(pi n), and of its neighbours what is of the fourth order in
    // the wave
    const double pi = std::numbers::pi, lattice = 3.9002649200019563 / (pi * n);
    for (int k = 0; k < n; ++k)
        CHECK(std::abs(u[k] + lattice * std::cos(2 * pi * x[k]) - field(0, k)) < 0.02 * std::abs(field(0, k)));
    const Values scaled =
        detail::PointForces<double>(x * 1e-5, y * 1e-5, 1e-5, 1e-5, Edges::periodic).deflections(force * 1e-10);
    CHECK((scaled * 1e5 / (n * n) - u).abs().maxCoeff() < 1e-13 * u.abs().maxCoeff());
}

TEST_CASE("deflections of points are reciprocal, and points outside of the cell refused") {
    const Points points = drawn(500, 1, 1);
    const Values& x = points.x;
    const Values& y = points.y;
    detail::PointForces<double> forces(x, y, 1, 1, Edges::mirrored);
    const Values other = Values::LinSpaced(500, -1, 2), u = forces.deflections(points.force);
    CHECK(test::relative_error((forces.deflections(other) * points.force).sum(), (u * other).sum()) < 1e-12);
    CHECK(test::refusal([&] { detail::PointForces<double>(x + 1, y, 1, 1, Edges::periodic); }).find("points") == 0);
    CHECK(test::refusal([&] { detail::PointForces<double>(x, y.head(3), 1, 1, Edges::periodic); }).find("points") == 0);
    CHECK(test::refusal([&] { detail::PointForces<double>(x, y, 0, 1, Edges::periodic); }).find("width") == 0);
}

}  // namespace point_forces_test
