// SPDX-License-Identifier: BSD-3-Clause
// Friction of a tabulated law: its first slip, and a step of a path, next to a look-up of the law itself.
#include "methods.hpp"
#include "row.hpp"

#include <fstiff/tabulated/slip_motion.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

namespace {

using namespace bench;

using Friction = fstiff::TangentialLaw<double>;
constexpr double coefficient = 0.3, stiffness_ratio = 0.82, pi = std::numbers::pi;

const Friction& rough() {
    static const Friction kept = [] {
        const fstiff::Roughness<double> surface{
            .rms_height = rms_height, .peak_radius = peak_radius, .peak_density = peak_density};
        const fstiff::RoughContact contact(surface, fstiff::PeakDistribution<double>(0.5, 1),
                                           fstiff::HertzLaw<double>{}, modulus);
        return Friction(
            fstiff::ContactLaw<double>::tabulate(contact, {.min_pressure = min_pressure, .max_pressure = max_pressure}),
            coefficient, stiffness_ratio);
    }();
    return kept;
}

/// A slip, and one back of it. Partial slip is a difference of two pressures, which those of law_points() give.
struct Slip {
    double separation, pressure, forth, back, traction, traction_back;
    template <int Directions>
    fstiff::SlipState<double, Directions> after_forth() const {
        fstiff::SlipState<double, Directions> state{.separation = separation};
        rough().step(state, separation, Friction::Vector<Directions>::Unit(0) * forth, state);
        return state;
    }
};
const std::vector<Slip>& slips() {
    static const std::vector<Slip> kept = [] {
        const std::vector<LawPoint>& points = law_points();
        std::vector<Slip> out;
        for (std::size_t i = 0; i + 2 < points.size(); ++i) {
            std::array<LawPoint, 3> at{points[i], points[i + 1], points[i + 2]};
            std::sort(at.begin(), at.end(), [](const auto& a, const auto& b) { return a.separation < b.separation; });
            const auto slip_to = [&](std::size_t to) {
                return std::pair{coefficient / stiffness_ratio * (at[to].separation - at[0].separation),
                                 coefficient * (at[0].pressure - at[to].pressure)};
            };
            const auto [forth, traction] = slip_to(2);
            const auto [half_back, half_fall] = slip_to(1);
            if (half_fall > 0.1 * coefficient * at[0].pressure)  // else p itself is not known that well
                out.push_back(
                    {at[0].separation, at[0].pressure, forth, 2 * half_back, traction, traction - 2 * half_fall});
        }
        return out;
    }();
    return kept;
}

/// Errors over mu p.
template <class TractionAt, class Call>
void friction_row(const std::string& name, double Slip::*truth, const TractionAt& traction_at, const Call& call) {
    verified_row(
        name, 1e-9,
        [=] {
            AccuracyCollector collector;
            for (const Slip& at : slips()) {
                const double whole = coefficient * at.pressure;
                collector.add(whole + traction_at(at), whole + at.*truth);
            }
            return collector.accuracy();
        },
        [=](benchmark::State& state) {
            time_elements(state, slips().size(), [&](std::size_t i) { return call(slips()[i], i); });
        });
}

template <int Directions>
void step_rows(const std::string& directions) {
    using State = fstiff::SlipState<double, Directions>;
    const auto step = [](const State& before, double separation, double slip) {
        State after;
        return rough().step(before, separation, Friction::Vector<Directions>::Unit(0) * slip, after);
    };
    friction_row(
        "friction/step/first/" + directions, &Slip::traction,
        [=](const Slip& at) { return step({.separation = at.separation}, at.separation, at.forth).traction[0]; },
        [=](const Slip& at, std::size_t) { return step({.separation = at.separation}, at.separation, at.forth); });
    friction_row(
        "friction/step/back/" + directions, &Slip::traction_back,
        [=](const Slip& at) { return step(at.after_forth<Directions>(), at.separation, -at.back).traction[0]; },
        [=](const Slip& at, std::size_t i) {
            static const std::vector<State> states = [] {
                std::vector<State> out;
                for (const Slip& slip : slips()) out.push_back(slip.after_forth<Directions>());
                return out;
            }();
            return step(states[i], at.separation, -at.back);
        });
}

/// A cycle of 600 contacts in 128 steps, each preloaded by its own pressure: along a line, or turning in the plane.
/// With derivatives by nine amplitudes; \p scale is of the first.
struct Motion {
    static constexpr std::size_t contacts = 600, steps = 128, amplitudes = 9;
    std::vector<double> separations, slips, by, first_slips;

    Motion(bool turns, double scale) {
        for (std::size_t c = 0; c < contacts; ++c) {
            const double p = min_pressure * std::pow(max_pressure / min_pressure, 0.3 + 0.4 * double(c) / contacts),
                         d = rough().normal().separation(p), u = p / rough().normal().stiffness(p);
            first_slips.push_back(0.5 * coefficient / stiffness_ratio * u);
            double last[2] = {0, 0};
            for (std::size_t i = 0; i < steps; ++i) {
                const double phase = 2 * pi * double(i) / steps;
                const double at[2] = {scale * first_slips.back() * std::sin(phase),
                                      0.2 * coefficient / stiffness_ratio * u * std::sin(phase + (turns ? 0.5 : 0))};
                separations.push_back(d - 0.1 * u * std::sin(phase + 0.3));
                for (int k = 0; k < 2; ++k) slips.push_back(at[k] - last[k]), last[k] = at[k];
            }
        }
        for (std::size_t i = 0; i < steps; ++i)
            for (std::size_t row = 0; row < 3; ++row)
                for (std::size_t k = 0; k < amplitudes; ++k) {
                    const auto shape = [&](std::size_t step) {
                        const double phase = 2 * pi * double(step) / steps;
                        return k % 3 == 0 ? std::sin(phase) : k % 3 == 1 ? std::cos(phase) : 1;
                    };
                    const double before = row > 0 && i > 0 ? shape(i - 1) : 0;
                    by.push_back(k / 3 == row ? shape(i) - before : 0);
                }
    }
    [[nodiscard]] fstiff::SlipResponses<double> answer(bool derivatives) const {
        const Friction* const law = &rough();
        fstiff::SlipResponses<double> found;
        fstiff::slip_responses<double>(
            std::span(&law, 1),
            {.contacts = contacts,
             .steps = steps,
             .separations = separations,
             .slips = slips,
             .motion_by = derivatives ? std::span<const double>(by) : std::span<const double>(),
             .directions = derivatives ? amplitudes : 0},
            found);
        return found;
    }
};

/// The error is that of the derivative by the amplitude of the first slip, of the sine in its traction, against a
/// difference: what the Jacobian of a harmonic balance is made of.
Accuracy accuracy_of_motion(bool turns) {
    constexpr double h = 1e-6;
    constexpr std::size_t steps = Motion::steps;
    const Motion middle(turns, 1);
    const auto exact = middle.answer(true), up = Motion(turns, 1 + h).answer(false),
               down = Motion(turns, 1 - h).answer(false);
    AccuracyCollector collector;
    for (std::size_t c = 0; c < Motion::contacts; ++c) {
        double by = 0, difference = 0;
        for (std::size_t i = 0; i < steps; ++i) {
            const std::size_t at = c * steps + i;
            const double weight = std::sin(2 * pi * double(i) / steps);
            by += weight * exact.responses_by[(3 * at + 1) * Motion::amplitudes + 3];
            difference += weight * (up.tractions[2 * at] - down.tractions[2 * at]) / (2 * h * middle.first_slips[c]);
        }
        collector.add(by, difference);
    }
    return collector.accuracy();
}

void motion_rows(bool turns) {
    for (const bool derivatives : {false, true})
        verified_row(
            std::string("friction/motion/") + (turns ? "turning" : "line") + (derivatives ? "/derivatives" : ""), 1e-4,
            [=] { return accuracy_of_motion(turns); },
            [=](benchmark::State& state) {
                const Motion motion(turns, 1);
                for (auto _ : state) {
                    auto found = motion.answer(derivatives);
                    benchmark::DoNotOptimize(found);
                }
            });
}

const Rows rows_of_friction([] {
    const auto first = [](const Slip& at) { return rough().first_slip(at.separation, at.forth).traction; };
    friction_row("friction/first_slip", &Slip::traction, first,
                 [](const Slip& at, std::size_t) { return rough().first_slip(at.separation, at.forth); });
    const auto look_up = [](const Slip& at) { return rough().normal().pressure_at_separation(at.separation); };
    friction_row("friction/look_up", &Slip::pressure, look_up,
                 [](const Slip& at, std::size_t) { return rough().normal().tangent_at_separation(at.separation); });
    step_rows<1>("line");
    step_rows<2>("plane");
    for (const bool turns : {false, true}) motion_rows(turns);
});

}  // namespace
