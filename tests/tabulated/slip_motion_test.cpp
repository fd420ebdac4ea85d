// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/contact/greenwood_williamson.hpp>
#include <fstiff/tabulated/slip_motion.hpp>

#include "support/catch.hpp"
#include "support/paper.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <string>
#include <vector>

namespace slip_motion_test {

using namespace fstiff;

namespace {

using Friction = TangentialLaw<double>;
constexpr double mu = 0.3, ratio = 0.8235294117647058, pi = std::numbers::pi;

const Friction& rough() {
    static const Friction kept(
        ContactLaw<double>::tabulate(GreenwoodWilliamson<double>(test::sand_blasted_fine.roughness(), 112.6e9),
                                     {1e3, 1e9, OutsideRange::extrapolate}),
        mu, ratio);
    return kept;
}

/// Two cycles of three displacements, the last of which opens and closes the contact; each is a mean, a cosine and a
/// sine, and these nine amplitudes are the directions.
struct Harmonics {
    std::size_t steps = 0;
    double mean_separation = 0;
    std::array<double, 9> amplitudes{};  ///< of approach, slip x, slip y [m]

    [[nodiscard]] static double shape(std::size_t part, double phase) {
        return part == 0 ? 1 : part == 1 ? std::cos(phase) : std::sin(phase);
    }
    [[nodiscard]] double phase(std::size_t step) const {
        return 2 * pi * static_cast<double>(step) / static_cast<double>(steps / 2);
    }
    [[nodiscard]] double displacement(std::size_t row, std::size_t step) const {
        double sum = 0;
        for (std::size_t part = 0; part < 3; ++part) sum += amplitudes[3 * row + part] * shape(part, phase(step));
        return sum;
    }
    /// Slips are from step to step; before the first nothing has moved.
    void fill(std::vector<double>& separations, std::vector<double>& slips, std::vector<double>& by) const {
        for (std::size_t i = 0; i < steps; ++i) {
            separations.push_back(mean_separation - displacement(0, i));
            for (std::size_t row = 1; row < 3; ++row)
                slips.push_back(displacement(row, i) - (i > 0 ? displacement(row, i - 1) : 0.0));
            for (std::size_t row = 0; row < 3; ++row)
                for (std::size_t column = 0; column < 9; ++column)
                    by.push_back(column / 3 != row ? 0.0
                                                   : shape(column % 3, phase(i)) -
                                                         (row > 0 && i > 0 ? shape(column % 3, phase(i - 1)) : 0.0));
        }
    }
};

SlipResponses<double> answer_of(const std::vector<Harmonics>& contacts, bool with_derivatives,
                                const ParallelHook& parallel = {}) {
    std::vector<double> separations, slips, by;
    for (const Harmonics& contact : contacts) contact.fill(separations, slips, by);
    const Friction* const law = &rough();
    SlipResponses<double> found;
    slip_responses<double>(std::span(&law, 1),
                           {.contacts = contacts.size(),
                            .steps = contacts.front().steps,
                            .separations = separations,
                            .slips = slips,
                            .motion_by = with_derivatives ? std::span<const double>(by) : std::span<const double>(),
                            .directions = with_derivatives ? std::size_t{9} : std::size_t{0}},
                           found, parallel);
    return found;
}

/// \p turn: of the second direction, a quarter of a cycle late; 0 of a motion along a line.
Harmonics harmonics(double share_of_full_slip, double opening, double turn) {
    const double p = 10e6, d = rough().normal().separation(p), u = p / rough().normal().stiffness(p);
    const double s = share_of_full_slip * mu / ratio * u, a = opening * u;
    return {128, d, {0.02 * a, a, 0.3 * a, 0.1 * s, 0.4 * s, s, 0.05 * turn * s, turn * s, -0.7 * turn * s}};
}

/// p, qx, qy of contact \p c at step \p i.
double number(const SlipResponses<double>& found, std::size_t at, std::size_t row) {
    return row == 0 ? found.pressures[at] : found.tractions[2 * at + row - 1];
}

/// The derivatives by \p column at all steps against differences, over the largest of any column. The nodes of a path
/// change at some amplitudes, where it is not smooth, so that the step is made less until none is between.
double worst_derivative(const Harmonics& motion, std::size_t column) {
    const SlipResponses<double> exact = answer_of({motion}, true);
    const double size = *std::max_element(motion.amplitudes.begin(), motion.amplitudes.end());
    double least = 1, greatest = 0;
    for (const double by : exact.responses_by) greatest = std::max(greatest, std::abs(by));
    for (const double relative : {1e-5, 1e-6, 1e-7}) {
        const double h = relative * size;
        std::vector<Harmonics> moved(2, motion);
        moved[0].amplitudes[column] -= h, moved[1].amplitudes[column] += h;
        const SlipResponses<double> around = answer_of(moved, false);
        double off = 0;
        for (std::size_t i = 0; i < motion.steps; ++i)
            for (std::size_t row = 0; row < 3; ++row) {
                const double difference = (number(around, motion.steps + i, row) - number(around, i, row)) / (2 * h);
                off = std::max(off, std::abs(exact.responses_by[(i * 3 + row) * 9 + column] - difference));
            }
        least = std::min(least, off / greatest);
    }
    return least;
}

/// What the tangent of each step alone makes of a derivative, off the exact one in the first harmonics of the last
/// cycle: the traction along x by its own sine.
double error_of_last_tangents(const Harmonics& motion) {
    const SlipResponses<double> found = answer_of({motion}, true);
    double by = 0, alone = 0;
    for (std::size_t i = motion.steps / 2; i < motion.steps; ++i) {
        const double weight = Harmonics::shape(2, motion.phase(i));
        by += weight * found.responses_by[(i * 3 + 1) * 9 + 5];
        alone += weight * weight * found.tangents[9 * i + 4];
    }
    return std::abs(alone / by - 1);
}

}  // namespace

TEST_CASE("slip motion: derivatives by harmonics are those of the whole motion, from slight to gross slip") {
    for (const double share : {0.01, 0.3, 1.0, 3.0, 30.0})
        for (const double opening : {0.1, 0.6})
            for (const double turn : {0.0, 0.3, 1.0})
                for (std::size_t column = 0; column < 9; ++column) {
                    if (turn == 0 && column >= 6) continue;  // below
                    CAPTURE(share, opening, turn, column);
                    CHECK(worst_derivative(harmonics(share, opening, turn), column) < 1e-6);
                }
}

TEST_CASE("slip motion: across a motion along a line the memory has no room for all levels") {
    for (const double share : {0.01, 0.3, 1.0, 3.0, 30.0})
        for (std::size_t column = 6; column < 9; ++column) {
            CAPTURE(share, column);
            CHECK(worst_derivative(harmonics(share, 0.1, 0), column) < (share < 0.1 ? 1e-6 : 3e-2));
        }
}

TEST_CASE("slip motion: the tangent of the last step leaves out the memory") {
    CHECK(error_of_last_tangents(harmonics(0.01, 0.1, 0)) < 0.02);
    CHECK(error_of_last_tangents(harmonics(3, 0.1, 0)) > 0.2);
}

TEST_CASE("slip motion: many contacts are what each is by itself, on threads too, and go on from where they were") {
    const std::vector<Harmonics> contacts{harmonics(0.3, 0.1, 0.3), harmonics(3, 0.6, 0), harmonics(1, 0, 1)};
    const auto backwards = [](std::size_t count, const auto& run) {
        for (std::size_t i = count; i-- > 0;) run(i);
    };
    const SlipResponses<double> all = answer_of(contacts, true, backwards);
    const std::size_t steps = contacts[0].steps;
    for (std::size_t c = 0; c < contacts.size(); ++c) {
        const SlipResponses<double> one = answer_of({contacts[c]}, true);
        const auto same = [&](const std::vector<double>& part, const std::vector<double>& whole) {
            CHECK(std::equal(part.begin(), part.end(), whole.begin() + static_cast<std::ptrdiff_t>(c * part.size())));
        };
        same(one.pressures, all.pressures), same(one.tractions, all.tractions);
        same(one.tangents, all.tangents), same(one.responses_by, all.responses_by);
    }
    std::vector<double> separations, slips, by;
    contacts[0].fill(separations, slips, by);
    std::vector<SlipState<double, 2>> states{{.separation = separations[0]}};
    const Friction* const law = &rough();
    for (std::size_t half = 0; half < 2; ++half) {
        SlipResponses<double> found;
        const std::span d(separations), s(slips);
        slip_responses<double>(std::span(&law, 1),
                               {.contacts = 1,
                                .steps = steps / 2,
                                .separations = d.subspan(half * steps / 2, steps / 2),
                                .slips = s.subspan(half * steps, steps),
                                .states = states},
                               found);
        CHECK(std::equal(found.pressures.begin(), found.pressures.end(),
                         all.pressures.begin() + static_cast<std::ptrdiff_t>(half * steps / 2)));
        CHECK(std::equal(found.tractions.begin(), found.tractions.end(),
                         all.tractions.begin() + static_cast<std::ptrdiff_t>(half * steps)));
    }
}

TEST_CASE("slip motion: without friction there is no traction, and no derivative of one") {
    const Friction smooth(rough().normal(), 0, ratio);
    SlipState<double, 2> state{.separation = rough().normal().separation(10e6)};
    const double d = state.separation;
    const auto found = smooth.step(state, d, {1e-6, 1e-7}, state);
    CHECK(found.pressure == rough().normal().pressure_at_separation(d));
    CHECK(found.traction.norm() == 0);
    CHECK(found.tangent(0, 0) == rough().normal().slope_at_separation(d));
    CHECK(found.tangent.bottomRows<2>().norm() == 0);
    CHECK(smooth.first_slip(d, 1e-6).traction == 0);
    CHECK(smooth.first_slip(d, 1e-6).stiffness == 0);
    CHECK(smooth.cycle(d, 1e-6).lost == 0);
    CHECK(smooth.stored_energy(state) == 0);
}

TEST_CASE("slip motion: an open contact has no pressure and no traction, stays finite, and touches again unslipped") {
    const double d = rough().normal().separation(10e6), far = 1e-3;
    const std::vector<double> separations{d, d, far, far, d, d}, slips{0, 0, 1e-6, 0, 1e-6, 0, 1e-3, 0, 0, 0, 1e-9, 0};
    std::vector<double> by(3 * separations.size(), 1.0);
    const Friction* const law = &rough();
    SlipResponses<double> found;
    slip_responses<double>(std::span(&law, 1),
                           {.contacts = 1,
                            .steps = separations.size(),
                            .separations = separations,
                            .slips = slips,
                            .motion_by = by,
                            .directions = 1},
                           found);
    for (const std::vector<double>* numbers :
         {&found.pressures, &found.tractions, &found.tangents, &found.responses_by})
        CHECK(std::all_of(numbers->begin(), numbers->end(), [](double x) { return std::isfinite(x); }));
    CHECK(found.pressures[2] == 0);
    CHECK(found.tractions[6] == 0);
    CHECK(std::abs(found.tractions[8]) < 1e-6 * found.pressures[4]);
    CHECK(found.pressures[4] == found.pressures[0]);
    const double fresh = rough().first_slip(d, 1e-9).traction;
    CHECK(std::abs(found.tractions[10] / fresh - 1) < 1e-6);
}

TEST_CASE("slip motion: arrays of other sizes and numbers that are not finite are refused") {
    const Friction* const law = &rough();
    const double d = rough().normal().separation(10e6), nan = std::numeric_limits<double>::quiet_NaN();
    const std::array separations{d, d}, bad{d, nan};
    const std::array<double, 4> slips{};
    SlipResponses<double> found;
    const auto refused = [&](const SlipMotion<double>& motion) {
        try {
            slip_responses<double>(std::span(&law, 1), motion, found);
        } catch (const domain_error& error) {
            return std::string(error.parameter());
        }
        return std::string();
    };
    const std::array by{0.0};
    CHECK(refused({.contacts = 1, .steps = 2, .separations = separations, .slips = slips}).empty());
    CHECK(refused({.contacts = 2, .steps = 2, .separations = separations, .slips = slips}) == "separations");
    CHECK(refused({.contacts = 2, .steps = 1, .separations = separations, .slips = separations}) == "slips");
    CHECK(refused({.contacts = 1, .steps = 2, .separations = bad, .slips = slips}) == "separation");
    CHECK(refused({.contacts = 1,
                   .steps = 2,
                   .separations = separations,
                   .slips = slips,
                   .motion_by = by,
                   .directions = 2}) == "motion_by");
}

}  // namespace slip_motion_test
