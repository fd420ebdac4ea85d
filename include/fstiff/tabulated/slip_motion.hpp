// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Motions of many contacts with friction at once: pressure, traction and tangents of every step, and derivatives by
/// numbers that a motion depends on, such as the amplitudes of harmonics.
///
///     const fstiff::SlipMotion<double> motion{.contacts = 600, .steps = 128, .separations = d, .slips = s};
///     fstiff::SlipResponses<double> found;
///     fstiff::slip_responses<double>(laws, motion, found);       // found.tractions[2 * (contact * 128 + step)]
///
/// Reference   tabulated/tangential_law.hpp
/// Units       d, s [m], p, q [Pa], tangents [Pa/m], derivatives [Pa] over the unit of a direction
/// Valid       as TangentialLaw
/// Accuracy    that of TangentialLaw::step; derivatives against differences 1e-6 or better at slight, partial and gross
///             slip (tests/tabulated/slip_motion_test.cpp)
/// Threads     by a ParallelHook, a contact a piece

#include <fstiff/core/parallel.hpp>
#include <fstiff/tabulated/tangential_law.hpp>

#include <algorithm>
#include <span>
#include <string>
#include <vector>

namespace fstiff { inline namespace v0_1 {

/// What contacts go through, contact after contact and step after step.
template <Real T = double>
struct SlipMotion {
    std::size_t contacts = 0, steps = 0;
    std::span<const T> separations{};  ///< at the end of each step [m]
    std::span<const T> slips{};        ///< of each step, two numbers [m]
    /// d(-separation, slip) of each step, three numbers by each of `directions`; of all contacts alike, or of each.
    /// They begin with the first step: what was before it does not depend on them.
    std::span<const T> motion_by{};
    std::size_t directions = 0;
    std::span<SlipState<T, 2>> states{};  ///< before the first step, and then after the last; none: nothing has slipped
                                          ///< at the first separation
};

/// What they answer, in the same order.
template <Real T = double>
struct SlipResponses {
    std::vector<T> pressures{};     ///< p [Pa]
    std::vector<T> tractions{};     ///< q, two numbers a step [Pa]
    std::vector<T> tangents{};      ///< d(p, q)/d(-d, s), three rows of three a step [Pa/m]: of that step alone
    std::vector<T> responses_by{};  ///< d(p, q) of each step, three numbers by each direction of the whole motion
};

namespace detail {

inline void require_numbers(const char* name, std::size_t given, std::size_t wanted) {
    if (given != wanted)
        throw domain_error(Refusal{.parameter = name,
                                   .allowed = std::to_string(wanted) + " for these contacts and steps",
                                   .reason = "has " + std::to_string(given) + ": must be " + std::to_string(wanted)});
}

/// Derivatives of contact \p c by Columns directions from \p first on.
template <int Columns, Real T>
void slip_derivatives(const TangentialLaw<T>& law, const SlipMotion<T>& motion, std::size_t c, SlipState<T, 2> state,
                      std::size_t first, SlipResponses<T>& out) {
    const std::size_t steps = motion.steps, all = motion.directions,
                      count = (std::min)(all - first, std::size_t{Columns});
    const bool of_each = motion.motion_by.size() != steps * 3 * all;
    Eigen::Matrix<T, 3, Columns> by = Eigen::Matrix<T, 3, Columns>::Zero();
    SlipDerivatives<T, 2, Columns> memory;
    for (std::size_t i = 0; i < steps; ++i) {
        const std::size_t at = c * steps + i;
        for (std::size_t row = 0; row < 3; ++row)
            for (std::size_t k = 0; k < count; ++k)
                by(static_cast<int>(row), static_cast<int>(k)) =
                    motion.motion_by[((of_each ? at : i) * 3 + row) * all + first + k];
        const Eigen::Matrix<T, 1, Columns> separation_by = -by.row(0);
        if (i == 0 && motion.states.empty()) memory.edge.level = separation_by;  // where it began
        const auto found = law.step(state, motion.separations[at], {motion.slips[2 * at], motion.slips[2 * at + 1]},
                                    memory, separation_by, Eigen::Matrix<T, 2, Columns>(by.template bottomRows<2>()));
        for (std::size_t k = 0; k < count; ++k) {
            T* to = &out.responses_by[at * 3 * all + first + k];
            const int column = static_cast<int>(k);
            to[0] = found.pressure_by[column];
            to[all] = found.traction_by(0, column), to[2 * all] = found.traction_by(1, column);
        }
    }
}

}  // namespace detail

/// Moves contacts of \p laws, one for all or one for each, and fills \p out. \throws domain_error for arrays of other
/// sizes, and as TangentialLaw::step, of the first contact that refuses.
template <Real T>
void slip_responses(std::span<const TangentialLaw<T>* const> laws, const SlipMotion<T>& motion, SlipResponses<T>& out,
                    const ParallelHook& parallel = {}) {
    const std::size_t count = motion.contacts * motion.steps, numbers = 3 * motion.directions;
    if (laws.size() != 1) detail::require_numbers("laws", laws.size(), motion.contacts);
    detail::require_numbers("separations", motion.separations.size(), count);
    detail::require_numbers("slips", motion.slips.size(), 2 * count);
    if (motion.motion_by.size() != motion.steps * numbers)
        detail::require_numbers("motion_by", motion.motion_by.size(), count * numbers);
    if (!motion.states.empty()) detail::require_numbers("states", motion.states.size(), motion.contacts);
    for (const T x : motion.motion_by) detail::require(std::isfinite(x), "motion_by", x, "finite");
    out.pressures.resize(count), out.tractions.resize(2 * count), out.tangents.resize(9 * count);
    out.responses_by.resize(count * numbers);
    detail::run_pieces(parallel, motion.contacts, [&](std::size_t c) {
        const TangentialLaw<T>& law = *laws[laws.size() == 1 ? 0 : c];
        if (motion.steps == 0) return;
        SlipState<T, 2> state{.separation = motion.separations[c * motion.steps]};
        if (!motion.states.empty()) state = motion.states[c];
        constexpr int at_once = 9;  // three harmonic amplitudes of three displacements
        for (std::size_t first = 0; first < motion.directions; first += at_once)
            detail::slip_derivatives<at_once>(law, motion, c, state, first, out);
        for (std::size_t i = 0; i < motion.steps; ++i) {
            const std::size_t at = c * motion.steps + i;
            const auto found =
                law.step(state, motion.separations[at], {motion.slips[2 * at], motion.slips[2 * at + 1]}, state);
            out.pressures[at] = found.pressure;
            std::copy_n(found.traction.data(), 2, &out.tractions[2 * at]);
            Eigen::Map<Eigen::Matrix<T, 3, 3, Eigen::RowMajor>>(&out.tangents[9 * at]) = found.tangent;
        }
        if (!motion.states.empty()) motion.states[c] = state;
    });
}

}}  // namespace fstiff
