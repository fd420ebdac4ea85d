// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/contact/greenwood_williamson.hpp>
#include <fstiff/contact/rough_contact.hpp>
#include <fstiff/peaks/single_radius.hpp>
#include <fstiff/tabulated/contact_law.hpp>
#include <fstiff/tabulated/tangential_law.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/paper.hpp"

#include <Eigen/LU>

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace tangential_law_test {

using namespace fstiff;

namespace {

using Law = ContactLaw<double>;
using Friction = TangentialLaw<double>;
const Roughness<double> fine = test::sand_blasted_fine.roughness();
constexpr double modulus = 112.6e9, mu = 0.3, ratio = 0.8235294117647058;

Law hertz() {
    return Law::tabulate(
        RoughContact(fine, PeakDistribution<double>::exponential(std::numbers::pi / 3), HertzLaw<double>{}, modulus),
        {1e3, 1e9, OutsideRange::extrapolate});
}

/// One sphere, p = x^(3/2) with x = 10 - d, as a contact that can be tabulated.
struct Sphere {
    ContactPoint<double> point_at_separation(double d, Quantity) const {
        const double x = 10 - d, k = 1.5 * std::sqrt(x);
        return {.state = {.eta = d,
                          .separation = {d, 0},
                          .pressure = {std::pow(x, 1.5), 0},
                          .stiffness = {k, 0},
                          .real_area_fraction = {},
                          .contact_density = {},
                          .loading_stiffness = {k, 0}}};
    }
    ContactPoint<double> point_at_pressure(double p, Quantity wanted) const {
        return point_at_separation(10 - std::pow(p, 2.0 / 3), wanted);
    }
    ContactState<double> at_separation(double d, Quantity wanted) const { return point_at_separation(d, wanted).state; }
    ContactState<double> at_pressure(double p, Quantity wanted) const { return point_at_pressure(p, wanted).state; }
    /// A line goes on where the sphere does not touch any more.
    LogSlope<double> log_pressure(double eta) const {
        const double x = std::max(10 - eta, 1e-3);
        return {1.5 * (std::log(x) + (10 - eta) / x - 1), -1.5 / x, 0};
    }
    Estimate<double> log_stiffness(double eta) const { return {std::log(1.5 * std::sqrt(10 - eta)), 0}; }
    Interaction<double> interaction() const { return {}; }
    double rms_height() const { return 1; }
    double bulk_compliance() const { return 0; }
    double stiffness_over_slope() const { return 1; }
};

}  // namespace

TEST_CASE("one sphere follows Cattaneo, Mindlin and Deresiewicz") {
    const Friction friction(Law::tabulate(Sphere{}, {0.1, 3}), mu, ratio);
    const double d = 10 - 1.3, p = std::pow(1.3, 1.5), kt = ratio * 1.5 * std::sqrt(1.3);
    for (const double share : {0.01, 0.2, 0.5, 0.9}) {  // Q/(mu P); Johnson (1985), (7.42) and (7.57)
        CAPTURE(share);
        const double tolerance = share < 0.9 ? 1e-11 : 1e-5;  // near touch p is not a polynomial
        const double slip = 1.5 * mu * p / kt * (1 - std::pow(1 - share, 2.0 / 3));
        const auto at = friction.first_slip(d, slip);
        CHECK(test::relative_error(at.traction, share * mu * p) < tolerance);
        CHECK(test::relative_error(at.stiffness, kt * std::cbrt(1 - share)) < tolerance);
        const double lost = 7.2 * mu * mu * p * p / kt *
                            (1 - std::pow(1 - share, 5.0 / 3) - 5 * share / 6 * (1 + std::pow(1 - share, 2.0 / 3)));
        CHECK(test::relative_error(friction.cycle(d, slip).lost, lost) < 1000 * tolerance);  // a difference of two
    }
}

TEST_CASE("an exponential law slips in closed form") {
    const auto exponential =
        Law::tabulate(GreenwoodWilliamson<double>(fine, modulus, Heights::exponential), {1e4, 1e8});
    const Friction friction(exponential, mu, ratio);
    const double p = 1e7, d = exponential.separation(p), u0 = p / exponential.stiffness(p);
    for (const double x : {1e-7, 1e-3, 0.3, 2.0, 40.0}) {  // k s/(mu u0)
        CAPTURE(x);
        const double slip = x * mu * u0 / ratio, share = -std::expm1(-x);
        const auto at = friction.first_slip(d, slip);
        CHECK(test::relative_error(at.traction, mu * p * share) < 1e-8);
        CHECK(std::abs(at.stiffness / (ratio * p / u0) - (1 - share)) < 1e-8);
        // (1 + exp(-x)) x - 2 (1 - exp(-x)), which is x^3/6 - x^4/12 and less for a small x
        const double excess = x < 0.01 ? x * x * x / 6 * (1 - x / 2) : (2 - share) * x - 2 * share;
        const auto cycle = friction.cycle(d, slip);
        const double tolerance = x < 0.01 ? 1e-6 : 1e-8;
        CHECK(test::relative_error(cycle.lost, 4 * mu * mu / ratio * p * u0 * excess) < tolerance);
        CHECK(test::relative_error(cycle.loss_factor, 4 * excess / (std::numbers::pi * share * x)) < tolerance);
    }
    CHECK(friction.cycle(d, 0).loss_factor == 0);
    CHECK(friction.cycle(d, 1).loss_factor > 1.27);  // 4/pi: all of it slips
    CHECK(friction.cycle(d, 1).loss_factor < 4 / std::numbers::pi);
}

TEST_CASE("unloading and reloading follow Masing's rule and a closed loop loses the energy of the closed form") {
    const Friction friction(hertz(), mu, ratio);
    const double d = friction.normal().separation(1e7), most = 1e-7;
    SlipState<double, 1> state{.separation = d};
    using Along = Friction::Vector<1>;
    const double top = friction.step(state, d, Along(most), state).traction[0];
    CHECK(test::relative_error(top, friction.first_slip(d, most).traction) < 1e-13);
    double lost = 0, at = most, before = top;
    const auto go = [&](double to, double sign, double from, double traction) {
        const int steps = 400;
        const double start = at;
        for (int i = 1; i <= steps; ++i) {
            const double next = start + (to - start) * i / steps;
            const auto found = friction.step(state, d, Along(next - at), state);
            const double masing = traction + sign * 2 * friction.first_slip(d, std::abs(next - from) / 2).traction;
            CHECK(std::abs(found.traction[0] - masing) < 1e-12 * mu * 1e7);
            lost += (found.traction[0] + before) / 2 * (next - at);
            at = next, before = found.traction[0];
        }
    };
    go(-most, -1, most, top);
    go(0.3 * most, 1, -most, -top);
    const SlipState<double, 1> turned = state;
    go(-0.2 * most, -1, at, before);  // a small loop is forgotten when it closes
    go(0.3 * most, 1, at, before);
    CHECK(state.count == turned.count);
    go(most, 1, -most, -top);
    CHECK(state.count == 1);
    const double both = friction.cycle(d, most).lost + friction.cycle(d, 0.25 * most).lost;
    CHECK(std::abs(lost / both - 1) < 1e-4);  // the rule of trapezia
}

namespace {

/// The same contact as many springs of one level each, which slip one by one: nothing is shared with the law but p.
template <int Directions>
class Springs {
public:
    using Vector = Friction::Vector<Directions>;
    Springs(const Law& law, double closest, double furthest, int count) : step_((furthest - closest) / count) {
        for (int i = 0; i < count; ++i) {
            const double at = closest + i * step_;
            level_.push_back(at + step_ / 2);
            stiffness_.push_back(law.slope_at_separation(at) - law.slope_at_separation(at + step_));
        }
        drag_.assign(level_.size(), Vector::Zero());
    }
    Vector step(double from, double to, const Vector& slip) {
        Vector traction = Vector::Zero();
        for (std::size_t i = 0; i < level_.size(); ++i) {
            if (level_[i] < from) drag_[i].setZero();
            if (level_[i] <= to) continue;
            const double share = level_[i] < from ? (level_[i] - to) / (from - to) : 1;
            const Vector tried = drag_[i] + share * slip;
            const double most = mu / ratio * (level_[i] - to);
            drag_[i] = tried * std::min(1.0, most / tried.norm());
            traction += ratio * stiffness_[i] * drag_[i];
        }
        return traction;
    }

private:
    double step_;
    std::vector<double> level_, stiffness_;
    std::vector<Vector> drag_;
};

/// The largest departure from springs over mu p, on a random path in steps of up to \p size times mu/k p/K that turn
/// by up to \p turn.
template <int Directions>
double departure(double size, double turn, int steps) {
    const Friction friction(hertz(), mu, ratio);
    const Law& law = friction.normal();
    const double u0 = 1e7 / law.stiffness(1e7);
    Springs<Directions> springs(law, law.separation(1.2e8), law.separations()[1] + 20 * u0, 8000);
    std::mt19937 random(5);
    const auto uniform = [&](double a, double b) { return a + (b - a) * double(random()) * 0x1p-32; };
    SlipState<double, Directions> state{.separation = law.separation(1e7)};
    double worst = 0, angle = 0;
    for (int n = 0; n < steps; ++n) {
        angle = n % 20 == 0 ? uniform(0, 6.3) : angle + uniform(-turn, turn);
        Friction::Vector<Directions> slip = Friction::Vector<Directions>::Zero();
        const double length = size * mu / ratio * u0 * uniform(0, 1);
        slip[0] = length * (Directions == 1 ? std::copysign(1, std::cos(angle)) : std::cos(angle));
        if constexpr (Directions == 2) slip[1] = length * std::sin(angle);
        const double before = state.separation;
        const double d = std::clamp(before + uniform(-0.3, 0.3) * size * u0, law.separation(1e8), law.separation(1e6));
        const auto found = friction.step(state, d, slip, state);
        const double p = law.pressure_at_separation(d);
        CHECK(found.pressure == p);
        CHECK(found.traction.norm() <= mu * p * (1 + 1e-12));
        CHECK(state.count <= state.capacity);
        worst = std::max(worst, (found.traction - springs.step(before, d, slip)).norm() / (mu * p));
        CHECK(friction.stored_energy(state) >= 0);
    }
    return worst;
}

}  // namespace

TEST_CASE("paths along a line, closing and opening on the way, are those of many springs") {
    for (const double size : {0.03, 0.3, 2.0}) CHECK(departure<1>(size, 0, 200) < 5e-6);  // 8000 springs
}

TEST_CASE("paths that turn in a plane are those of many springs to a share of the friction") {
    CHECK(departure<2>(0.03, 0.2, 200) < 1e-3);
    CHECK(departure<2>(0.3, 0.2, 200) < 0.01);
    CHECK(departure<2>(1, 0.2, 200) < 0.02);
}

TEST_CASE("a contact in friction never gives energy back, and a straight path loses what its springs lose") {
    const Friction friction(hertz(), mu, ratio);
    const Law& law = friction.normal();
    const double u0 = 1e7 / law.stiffness(1e7), d0 = law.separation(1e7);
    std::mt19937 random(9);
    const auto uniform = [&](double a, double b) { return a + (b - a) * double(random()) * 0x1p-32; };
    SlipState<double, 2> state{.separation = d0};
    double stored = 0, lost = 0;
    Friction::Vector<2> q = Friction::Vector<2>::Zero();
    for (int leg = 0; leg < 40; ++leg) {
        const Friction::Vector<2> slip(uniform(-1, 1) * mu * u0 / ratio, uniform(-1, 1) * mu * u0 / ratio);
        const double opening =
            std::clamp(state.separation + uniform(-0.5, 0.5) * u0, law.separation(1e8), law.separation(1e6)) -
            state.separation;
        double work = 0;
        constexpr int steps = 200;
        for (int i = 0; i < steps; ++i) {
            const auto next = friction.step(state, state.separation + opening / steps, slip / steps, state);
            work += (q + next.traction).dot(slip / steps) / 2;
            q = next.traction;
        }
        const double now = friction.stored_energy(state), loss = work - (now - stored);
        CHECK(loss > -1e-4 * mu * 1e7 * u0);  // the rule of trapezia over 200 steps
        stored = now, lost += loss;
    }
    CHECK(lost > 0);
}

TEST_CASE("the tangent is the derivative of the returned value") {
    const Friction friction(hertz(), mu, ratio);
    const Law& law = friction.normal();
    const double u0 = 1e7 / law.stiffness(1e7), h = 1e-6 * u0;
    std::mt19937 random(3);
    const auto uniform = [&](double a, double b) { return a + (b - a) * double(random()) * 0x1p-32; };
    SlipState<double, 2> state{.separation = law.separation(1e7)}, unused;
    int compared = 0;
    for (int n = 0; n < 300; ++n) {
        const Friction::Vector<2> slip(uniform(-1, 1) * 0.2 * u0, uniform(-1, 1) * 0.2 * u0);
        const double d =
            std::clamp(state.separation + uniform(-0.1, 0.1) * u0, law.separation(1e8), law.separation(1e6));
        for (int input = 0; input < 3; ++input) {
            const auto at = [&](double by) {
                Friction::Vector<2> moved = slip;
                if (input > 0) moved[input - 1] += by;
                const auto found = friction.step(state, input == 0 ? d - by : d, moved, unused);
                return Eigen::Vector3d(found.pressure, found.traction[0], found.traction[1]);
            };
            const Eigen::Vector3d middle = at(0), up = (at(h) - middle) / h, down = (middle - at(-h)) / h;
            const auto tangent = friction.step(state, d, slip, unused).tangent;
            const double scale = tangent.norm();
            if ((up - down).norm() > 1e-4 * scale) continue;  // a node comes or goes between the three
            CHECK(((up + down) / 2 - tangent.col(input)).norm() < 1e-5 * scale);
            ++compared;
        }
        static_cast<void>(friction.step(state, d, slip, state));
    }
    CHECK(compared > 850);
}

TEST_CASE("the tangent is that of the first slip where a cycle turns round, in whatever steps it got there") {
    const Friction friction(hertz(), mu, ratio);
    const double d = friction.normal().separation(1e7), most = 2e-7, wanted = friction.first_slip(d, most).stiffness;
    for (const int quarter : {1, 2, 5, 20}) {
        SlipState<double, 2> state{.separation = d};
        for (int i = 1; i <= 5 * quarter; ++i) {
            const double step = (i <= quarter || i > 3 * quarter ? most : -most) / quarter;
            const auto tangent = friction.step(state, d, {step, 0}, state).tangent;
            if (i % (2 * quarter) == quarter) CHECK(test::relative_error(tangent(1, 1), wanted) < 1e-9);
        }
    }
}

TEST_CASE("any state is room enough for its points") {
    const Friction friction(hertz(), mu, ratio);
    const double d = friction.normal().separation(1e7), step = 1e-8;
    for (const double over : {1.1, 2.0, 10.0})
        for (double turn = 0.3; turn < 3.2; turn += 0.1) {  // 16 levels outside the cone of friction
            SlipState<double, 2> state{.separation = d, .count = 16}, after;
            for (int i = 0; i < 16; ++i) {
                const double level = step * (i + 1), length = over * mu / ratio * level;
                state.nodes[std::size_t(i)] = {d + level, {length * std::cos(turn * i), length * std::sin(turn * i)}};
            }
            const auto at = friction.step(state, d, {0, 0}, after);
            CHECK(at.traction.norm() <= mu * at.pressure);
            CHECK(at.tangent.allFinite());
        }
    SlipState<double, 2> apart{.separation = d};
    CHECK(friction.step(apart, 1e30, {1e-3, 0}, apart).traction.norm() == 0);
    CHECK(apart.count == 0);  // no level is that close to the edge
}

TEST_CASE("Newton's method finds the displacements of given loads, and squares its error") {
    const Friction friction(hertz(), mu, ratio);
    SlipState<double, 2> state{.separation = friction.normal().separation(1e7)}, tried;
    for (const Eigen::Vector3d& load :
         {Eigen::Vector3d(1.2e7, 1e6, 0.5e6), Eigen::Vector3d(1.1e7, 1.8e6, 1e6), Eigen::Vector3d(1.3e7, 1e6, 1.6e6)}) {
        Eigen::Vector3d x(-state.separation, 0, 0);
        std::vector<double> errors;
        for (int i = 0; i < 30 && (errors.empty() || errors.back() > 1e-13); ++i) {
            const auto at = friction.step(state, -x[0], x.tail<2>(), tried);
            const Eigen::Vector3d missing = load - Eigen::Vector3d(at.pressure, at.traction[0], at.traction[1]);
            errors.push_back(missing.norm() / load.norm());
            x += at.tangent.partialPivLu().solve(missing);
        }
        CAPTURE(errors);
        CHECK(errors.back() <= 1e-13);
        CHECK(errors.size() <= 9);
        for (std::size_t i = 1; i + 1 < errors.size(); ++i)
            if (errors[i] < 1e-2) CHECK(errors[i + 1] <= std::max(10 * errors[i] * errors[i], 1e-13));
        state = tried;
    }
}

TEST_CASE("friction is refused where its theorem does not hold, and for numbers that are none") {
    const Law plastic = Law::tabulate(
        RoughContact(fine, PeakDistribution<double>(0, std::numbers::pi / 4), FractalLaw<double>(1.62), modulus),
        {1e5, 1e8});
    CHECK(test::refused_for("must be elastic", [&] { (void)Friction(plastic, mu, ratio); }));
    CHECK(test::refused_for("law = empty", [&] { (void)Friction(Law(), mu, ratio); }));
    CHECK(test::refused_for("friction", [&] { (void)Friction(hertz(), -0.1, ratio); }));
    CHECK(test::refused_for("ratio", [&] { (void)Friction(hertz(), mu, -1); }));
    const Friction friction(hertz(), mu, ratio);
    CHECK(test::refused_for("slip", [&] { (void)friction.first_slip(1e-6, -1e-9); }));
    CHECK(test::refused_for("amplitude", [&] { (void)friction.cycle(1e-6, std::nan("")); }));
    SlipState<double, 2> state{.separation = 1e-6};
    CHECK(test::refused_for("separation", [&] { (void)friction.step(state, std::nan(""), {0, 0}, state); }));
    CHECK(test::refused_for("slip", [&] { (void)friction.step(state, 1e-6, {0, std::nan("")}, state); }));
    CHECK(state.count == 0);
    const Law ends = hertz().with(OutsideRange::refuse);  // more pressure than the table has
    const Friction within(ends, mu, ratio);
    const double closer = ends.separations()[0] - 1e-9;
    CHECK(test::refused_for("separation", [&] { (void)within.first_slip(closer, 1e-9); }));
    CHECK(test::refused_for("separation", [&] { (void)within.cycle(closer, 1e-9); }));
    CHECK(test::refused_for("separation", [&] { (void)within.step(state, closer, {0, 0}, state); }));
    CHECK(within.cycle(ends.separations()[1] + 1e-9, 1e-9).lost > 0);        // less, which goes on to 0
    CHECK(friction.step(state, 1, {1, 1}, state).traction.norm() < 1e-200);  // far apart
    CHECK(friction.step(state, 1e-6, {1, 0}, state).traction.allFinite());   // a metre of slip
    CHECK(test::relative_error(friction.step(state, 1e-6, {1, 0}, state).traction[0],
                               mu * friction.normal().pressure_at_separation(1e-6)) < 1e-12);
}

}  // namespace tangential_law_test
