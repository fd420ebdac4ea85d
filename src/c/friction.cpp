// SPDX-License-Identifier: BSD-3-Clause
// Friction of tabulated laws.
#include "c/law.hpp"

#include <fstiff/asperity/material.hpp>
#include <fstiff/asperity/tangential_ratio.hpp>
#include <fstiff/tabulated/slip_motion.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

struct fstiff_friction {
    fstiff::TangentialLaw<double> law;
};

namespace fstiff::c {
namespace {

using Law = TangentialLaw<double>;
using State = SlipState<double, 2>;
static_assert(State::capacity == FSTIFF_SLIP_LEVELS);

void require_finite(const char* name, double value) {
    detail::require(std::abs(value) <= std::numeric_limits<double>::max(), name, value, "finite");
}

/// Checks the state that the caller kept, which may be anything.
State state_of(const fstiff_slip* kept, const char* name) {
    const fstiff_slip from = taken(kept, name);
    State to{.separation = from.separation, .count = from.count};
    require_finite("separation of a slip", from.separation);
    detail::require(from.count >= 0 && from.count <= FSTIFF_SLIP_LEVELS, "count of a slip", from.count, "0 to 16");
    double closer = from.separation;
    for (std::size_t i = 0; i < static_cast<std::size_t>(from.count); ++i) {
        const double level = from.levels[i];
        require_finite("level of a slip", level);
        detail::require(level > closer, "level of a slip", level, "further than the one before it");
        for (const double drag : from.drags[i]) require_finite("drag of a slip", drag);
        to.nodes[i] = {level, {from.drags[i][0], from.drags[i][1]}};
        closer = level;
    }
    return to;
}

bool is_finite(const State& state) {
    return std::all_of(state.nodes.begin(), state.nodes.begin() + state.count, [](const State::Node& node) {
        return std::isfinite(node.level) && std::isfinite(node.drag[0]) && std::isfinite(node.drag[1]);
    });
}

/// Levels that are not in use become 0.
void keep(const State& state, fstiff_slip& after) {
    fstiff_slip to{.size = 0, .separation = state.separation, .levels = {}, .drags = {}, .count = state.count};
    for (std::size_t i = 0; i < static_cast<std::size_t>(state.count); ++i) {
        to.levels[i] = state.nodes[i].level;
        std::copy_n(state.nodes[i].drag.begin(), 2, to.drags[i]);
    }
    give(to, after);
}

}  // namespace
}  // namespace fstiff::c

using namespace fstiff::c;

int fstiff_tangential_ratio(double modulus1, double poisson1, double modulus2, double poisson2, double* ratio) {
    return guarded([&] {
        not_null(ratio, "ratio") = fstiff::tangential_ratio<double>({modulus1, poisson1}, {modulus2, poisson2});
        return FSTIFF_OK;
    });
}

int fstiff_friction_make(const fstiff_law* law, double friction, double ratio, fstiff_friction** made) {
    return made_by(made, [&] { return new fstiff_friction{Law(not_null(law, "law").law, friction, ratio)}; });
}

void fstiff_friction_free(fstiff_friction* friction) { delete friction; }

int fstiff_friction_first_slip(const fstiff_friction* friction, double separation, double slip, double* traction,
                               double* stiffness) {
    return guarded([&]() -> int {
        const auto point = not_null(friction, "friction").law.first_slip(separation, slip);
        if (const int status = all_finite(point.traction, point.stiffness)) return status;
        put(traction, point.traction), put(stiffness, point.stiffness);
        return FSTIFF_OK;
    });
}

int fstiff_friction_cycle(const fstiff_friction* friction, double separation, double amplitude, double* lost,
                          double* loss_factor) {
    return guarded([&]() -> int {
        const auto cycle = not_null(friction, "friction").law.cycle(separation, amplitude);
        if (const int status = all_finite(cycle.lost, cycle.loss_factor)) return status;
        put(lost, cycle.lost), put(loss_factor, cycle.loss_factor);
        return FSTIFF_OK;
    });
}

int fstiff_friction_step(const fstiff_friction* friction, const fstiff_slip* before, double separation,
                         const double slip[2], fstiff_slip* after, double* pressure, double traction[2],
                         double tangent[9]) {
    return guarded([&]() -> int {
        const Law& law = not_null(friction, "friction").law;
        State state = state_of(before, "before");
        if (after) sized(after, "after");
        not_null(slip, "slip");
        const auto point = law.step(state, separation, {slip[0], slip[1]}, state);
        const bool good = std::isfinite(point.pressure) && point.traction.allFinite() && point.tangent.allFinite();
        if (const int status = handed_on(good && is_finite(state))) return status;
        if (after) keep(state, *after);
        put(pressure, point.pressure);
        if (traction) std::copy_n(point.traction.data(), 2, traction);
        for (int i = 0; tangent && i < 9; ++i) tangent[i] = point.tangent(i / 3, i % 3);
        return FSTIFF_OK;
    });
}

int fstiff_friction_motion(const fstiff_friction* const* frictions, size_t laws, const fstiff_motion* motion) {
    return guarded([&]() -> int {
        const fstiff_motion from = taken(motion, "motion");
        not_null(frictions, "frictions"), not_null(from.separations, "separations"), not_null(from.slips, "slips");
        if (from.directions > 0) not_null(from.motion_by, "motion_by"), not_null(from.responses_by, "responses_by");
        std::vector<const Law*> all;
        for (size_t i = 0; i < laws; ++i) all.push_back(&not_null(frictions[i], "frictions").law);
        const size_t count = from.contacts * from.steps, by = 3 * from.directions;
        std::vector<State> states;
        for (size_t c = 0; from.states && c < from.contacts; ++c) states.push_back(state_of(&from.states[c], "states"));
        fstiff::SlipResponses<double> found;
        fstiff::slip_responses<double>(all,
                                       {.contacts = from.contacts,
                                        .steps = from.steps,
                                        .separations = {from.separations, count},
                                        .slips = {from.slips, 2 * count},
                                        .motion_by = {from.motion_by, (from.by_of_each ? count : from.steps) * by},
                                        .directions = from.directions,
                                        .states = states},
                                       found);
        const auto is_good = [](double x) { return std::isfinite(x); };
        const auto good = [&](const std::vector<double>& numbers) {
            return std::all_of(numbers.begin(), numbers.end(), is_good);
        };
        const bool finite = good(found.pressures) && good(found.tractions) && good(found.tangents) &&
                            good(found.responses_by) && std::all_of(states.begin(), states.end(), is_finite);
        if (const int status = handed_on(finite)) return status;
        for (size_t c = 0; c < states.size(); ++c) keep(states[c], from.states[c]);
        const auto hand = [](const std::vector<double>& numbers, double* to) {
            if (to) std::copy(numbers.begin(), numbers.end(), to);
        };
        hand(found.pressures, from.pressures), hand(found.tractions, from.tractions);
        hand(found.tangents, from.tangents), hand(found.responses_by, from.responses_by);
        return FSTIFF_OK;
    });
}

int fstiff_friction_stored_energy(const fstiff_friction* friction, const fstiff_slip* slip, double* energy) {
    return guarded([&]() -> int {
        const double stored = not_null(friction, "friction").law.stored_energy(state_of(slip, "slip"));
        if (const int status = all_finite(stored)) return status;
        not_null(energy, "energy") = stored;
        return FSTIFF_OK;
    });
}
