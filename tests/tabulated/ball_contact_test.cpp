// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/answer/rising_curve.hpp>
#include <fstiff/tabulated/ball_contact.hpp>

#include <fstiff/answer/curves.hpp>
#include <fstiff/halfspace/boundary_elements.hpp>
#include <fstiff/synthetic/self_affine.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace ball_contact_test {

using namespace fstiff;
using std::numbers::pi;

namespace {

constexpr double radius = 5e-3, load = 10, stiffest = 1e9;

/// p = 1 GPa exp(-d/scale), whose K is p/scale.
ContactLaw<double> exponential(double scale) {
    return ContactLaw<double>::tabulate_points(
        [scale](double p) {
            return detail::LawPoint<double>{scale * std::log(stiffest / p), p / scale};
        },
        scale, {.min_pressure = 1e2, .max_pressure = 1e11, .outside = OutsideRange::extrapolate}, 1);
}

/// A ball of radius 1 by boundary elements, on a periodic square of side 1 and of twelve radii of Hertz' contact, with
/// the modulus 1.
struct SolvedBall {
    static constexpr Eigen::Index points = 256;
    static constexpr double hertz = 1.0 / 12, spacing = 1.0 / points, force = 4 * hertz * hertz * hertz / 3;
    /// Approach over force that the images take away: -4 zeta(1/2) beta(1/2)/pi, zeta and beta of a square lattice.
    static constexpr double images = 3.90026492 / pi;

    double radius = 0, approach = 0, pressure = 0, stiffness = 0;

    /// On \p rough times \p rms, which is shifted by \p right and \p up points.
    SolvedBall(const HeightMap<double>& rough, double rms, Eigen::Index right, Eigen::Index up) {
        const auto distance = [](Eigen::Index j, Eigen::Index i) {
            return spacing * std::hypot(double(i - points / 2), double(j - points / 2));
        };
        HeightMap<double> map = rough;
        map.heights = HeightMap<double>::Array::NullaryExpr(points, points, [&](Eigen::Index j, Eigen::Index i) {
            return rms * rough.heights((j + up) % points, (i + right) % points) - std::pow(distance(j, i), 2) / 2;
        });
        BoundaryElements<double> solver(map, 1.0, {.edges = Edges::periodic});
        const BoundaryElementState<double> state = solver.at_pressure(force);
        REQUIRE(state.converged);
        const auto p = solver.pressures();
        double moment = 0;
        for (Eigen::Index j = 0; j < points; ++j)
            for (Eigen::Index i = 0; i < points; ++i) moment += p(j, i) * distance(j, i);
        radius = 16 / (3 * pi) * moment / p.sum();
        approach = force * images - state.mean_gap - map.heights.mean();
        pressure = state.max_pressure;
        stiffness = 1 / (1 / state.stiffness + images);
    }
};

HeightMap<double> gaussian_map(std::uint64_t seed) {
    return self_affine_map(SelfAffineOptions<double>{.hurst = 0.8,
                                                     .rms = 1,
                                                     .longest_wavelength = SolvedBall::hertz / 3,
                                                     .shortest_wavelength = 4 * SolvedBall::spacing,
                                                     .long_waves = LongWaves::none,
                                                     .seed = seed},
                           SolvedBall::points, SolvedBall::points, SolvedBall::spacing, SolvedBall::spacing);
}

/// The law of a map of gaussian_map() by boundary elements from 3e-4 to 0.6 of E g.
class SolvedLaw {
public:
    explicit SolvedLaw(const HeightMap<double>& map) {
        constexpr double gradient = 282;  // of both maps, within 1 %
        BoundaryElements<double> solver(map, 1.0, {.edges = Edges::periodic});
        for (int i = 0; i <= 14; ++i) {
            const BoundaryElementState<double> state = solver.at_pressure(gradient * 3e-4 * std::pow(3.0, i / 2.0));
            points_.emplace_back(std::log(state.pressure), std::log(state.stiffness));
            closest_ = state.mean_gap;
        }
    }
    /// That of \p rms times the heights.
    [[nodiscard]] ContactLaw<double> times(double rms) const {
        const detail::RisingCurve curve(points_);
        const double first = std::exp(points_.front().first), last = std::exp(points_.back().first);
        return ContactLaw<double>::tabulate_points(
            [&](double p) {
                const double x = std::log(p / rms);
                return detail::LawPoint<double>{rms * (closest_ + curve.fall(x, points_.back().first)),
                                                std::exp(curve.at(x))};
            },
            rms, {.min_pressure = rms * first, .max_pressure = rms * last, .outside = OutsideRange::extrapolate}, 1);
    }

private:
    std::vector<std::pair<double, double>> points_;  ///< ln p and ln K
    double closest_ = 0;
};

}  // namespace

TEST_CASE("Boundary elements of a smooth ball are Hertz") {
    const SolvedBall smooth(gaussian_map(1), 0, 0, 0);
    const ContactOfBall<double> hertz = detail::hertz_ball(1, 1, SolvedBall::force);
    CHECK(test::relative_error(smooth.stiffness, hertz.stiffness) < 1e-3);
    CHECK(test::relative_error(smooth.radius, hertz.radius) < 1e-3);
    CHECK(test::relative_error(smooth.pressure, hertz.pressure) < 1e-3);
    CHECK(test::relative_error(smooth.approach, hertz.approach) < 2e-3);
}

namespace {

/// A row of the table of docs/validation.md: means over 16 places on each of two maps.
struct RoughBalls {
    double alpha;
    Eigen::Array<double, 5, 1> means;  // K and a of the law over Hertz', of boundary elements over the law,
                                       // and the difference of the approach over sigma
};

void check_rough_balls(const std::vector<RoughBalls>& rows) {
    const ContactOfBall<double> hertz = detail::hertz_ball(1, 1, SolvedBall::force);
    constexpr Eigen::Index maps = 2, places = 16;
    const std::array surfaces{gaussian_map(1), gaussian_map(2)};
    const std::array laws{SolvedLaw(surfaces[0]), SolvedLaw(surfaces[1])};
    for (const auto& row : rows) {
        const double sigma = row.alpha * hertz.approach;
        Eigen::Array<double, maps * places, 5> found;
        for (Eigen::Index i = 0; i < found.rows(); ++i) {
            const auto map = static_cast<std::size_t>(i / places);
            const Eigen::Index place = i % places;
            const ContactOfBall<double> ball = ball_on_rough_face(laws[map].times(sigma), 1, 1, SolvedBall::force);
            const SolvedBall solved(surfaces[map], sigma, 97 * place, 31 * place * place + 53 * place);
            found.row(i) << ball.stiffness / hertz.stiffness, ball.radius / hertz.radius,
                solved.stiffness / ball.stiffness, solved.radius / ball.radius,
                (solved.approach - ball.approach) / sigma;
        }
        const Eigen::Array<double, 5, 1> mean = found.colwise().mean().transpose(),
                                         scatter =
                                             (found.rowwise() - mean.transpose()).square().colwise().mean().sqrt();
        CAPTURE(row.alpha, mean.transpose(), scatter.transpose());
        CHECK((mean - row.means).abs().maxCoeff() < 1.5e-3);  // digits of the table, and rounding of another machine
    }
}

}  // namespace

TEST_CASE("Boundary elements of a rough ball are the law of the roughness on a ball, at one roughness") {
    check_rough_balls({{0.5, {0.879, 1.292, 1.002, 0.998, -0.005}}});
}
TEST_CASE("Boundary elements of a rough ball are the law of the roughness on a ball, at little and at much roughness",
          "[long]") {
    check_rough_balls({{0.05, {0.990, 1.029, 0.995, 1.000, 0.005}}, {2, {0.607, 1.890, 1.014, 1.004, -0.005}}});
}

TEST_CASE("Displacements of a disc are the integral of Boussinesq's over it") {
    // 1/(pi E) integral dA/distance in polar coordinates about the point: of a point inside, the chord in each
    // direction
    for (const double r : {0.0, 0.3, 0.9}) {
        double chords = 0;
        constexpr int directions = 20000;
        for (int i = 0; i < directions; ++i) {
            const double angle = 2 * pi * (i + 0.5) / directions;
            chords += -r * std::cos(angle) + std::sqrt(1 - r * r * std::sin(angle) * std::sin(angle));
        }
        CHECK(test::relative_error(detail::displacement_of_disc(r, 1), chords * 2 * pi / directions / pi) < 1e-10);
    }
    // far away the disc is a point; its edge is continuous, with a slope that is not
    CHECK(test::relative_error(detail::displacement_of_disc(1e4, 1), 1e-4) < 1e-8);
    for (const double beside : {1 - 1e-12, 1 + 1e-12})
        CHECK(test::relative_error(detail::displacement_of_disc(beside, 1), 4 / pi) < 1e-10);
}

TEST_CASE("Bodies that do not yield carry what the law has over the paraboloid") {
    for (const double scale : {1e-8, 1e-6}) {
        const ContactOfBall<double> ball = ball_on_rough_face(exponential(scale), radius, 1e18, load);
        // W = 2 pi R integral of p over d
        CHECK(test::relative_error(ball.pressure, load / (2 * pi * radius * scale)) < 1e-3);
        CHECK(test::relative_error(ball.stiffness, load / scale) < 1e-3);
        CHECK(test::relative_error(ball.radius, 8 / (3 * pi) * std::sqrt(2 * pi * radius * scale)) < 1e-3);
        CHECK(std::abs(ball.approach + scale * std::log(2 * pi * radius * stiffest * scale / load)) < 1e-3 * scale);
        CHECK(ball.error < 5e-3);
    }
}

TEST_CASE("Smooth faces give Hertz, and roughness parts from it in proportion") {
    const double modulus = 110e9, a = std::cbrt(0.75 * load * radius / modulus), approach = a * a / radius;
    double before = 0;
    for (const double scale : {1e-13, 1e-9, 2e-9, 4e-9, 8e-9}) {
        const ContactOfBall<double> ball = ball_on_rough_face(exponential(scale), radius, modulus, load);
        const double part = ball.radius / a - 1;
        CAPTURE(scale, part);
        CHECK(std::abs(part) < 1.6 * scale / approach + ball.error);
        CHECK(std::abs(ball.stiffness / (2 * modulus * a) - 1) < 1.2 * scale / approach + ball.error);
        CHECK(std::abs(ball.pressure / (1.5 * load / (pi * a * a)) - 1) < 2.5 * scale / approach + ball.error);
        if (scale > 1e-9) CHECK(part > before);
        before = part;
    }
}

TEST_CASE("The loading stiffness is the derivative of the load by the approach") {
    for (const double scale : {3e-8, 1e-7, 1e-6}) {
        const auto at = [&](double w) { return ball_on_rough_face(exponential(scale), radius, 110e9, w); };
        const ContactOfBall<double> ball = at(load), more = at(1.01 * load), less = at(0.99 * load);
        // the reach of the rings moves with the load, so that the difference has their error
        CHECK(test::relative_error(0.02 * load / (more.approach - less.approach), ball.loading_stiffness) < 3e-3);
        CHECK(test::relative_error(ball.stiffness, ball.loading_stiffness) < 1e-3);
    }
}

TEST_CASE("A ball without radius, modulus or load, and a law that ends, are refused") {
    const ContactLaw<double> law = exponential(1e-7);
    CHECK(test::refused_for("radius = 0: must be", [&] { return ball_on_rough_face(law, 0, 1e11, 1); }));
    CHECK(test::refused_for("modulus = -1: must be", [&] { return ball_on_rough_face(law, 1, -1, 1); }));
    CHECK(test::refused_for("load = 0: must be", [&] { return ball_on_rough_face(law, 1, 1e11, 0); }));
    CHECK(test::refused_for("pressure",
                            [&] { return ball_on_rough_face(law.with(OutsideRange::refuse), radius, 110e9, 1e-6); }));
}

}  // namespace ball_contact_test
