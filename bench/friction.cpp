// SPDX-License-Identifier: BSD-3-Clause
// Friction of a tabulated law: its first slip, and a step of a path, next to a look-up of the law itself.
#include "methods.hpp"
#include "row.hpp"

#include <fstiff/tabulated/tangential_law.hpp>

#include <algorithm>
#include <utility>

namespace {

using namespace bench;

using Friction = fstiff::TangentialLaw<double>;
constexpr double coefficient = 0.3, stiffness_ratio = 0.82;

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

const Rows rows_of_friction([] {
    const auto first = [](const Slip& at) { return rough().first_slip(at.separation, at.forth).traction; };
    friction_row("friction/first_slip", &Slip::traction, first,
                 [](const Slip& at, std::size_t) { return rough().first_slip(at.separation, at.forth); });
    const auto look_up = [](const Slip& at) { return rough().normal().pressure_at_separation(at.separation); };
    friction_row("friction/look_up", &Slip::pressure, look_up,
                 [](const Slip& at, std::size_t) { return rough().normal().tangent_at_separation(at.separation); });
    step_rows<1>("line");
    step_rows<2>("plane");
});

}  // namespace
