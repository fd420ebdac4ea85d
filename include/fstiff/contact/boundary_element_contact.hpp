// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Contact of a map by boundary elements: states at pressures and at separations, with the error of the grid.
///
///     const fstiff::BoundaryElementContact contact(map, 112e9, {.points = 256});
///     const auto curve = fstiff::curve_at_pressures(contact, std::vector{1e6, 3e6, 1e7});
///
/// Each state is one solution on two grids (halfspace/solve_half_space.hpp); no table and no fit is made from it.
///
/// Reference   halfspace/solve_half_space.hpp
/// Units       SI
/// Valid       as solve_half_space(): a map without missing points whose form is removed, at least 16 points a side;
///             separations greater than 0, with a hardness than the lowest point, and less than the highest one
/// Accuracy    that of solve_half_space(), bit for bit; at a separation the pressure to 1e-7
///             (tests/contact/boundary_element_contact_test.cpp)

#include <fstiff/contact/contact.hpp>
#include <fstiff/contact/interaction.hpp>
#include <fstiff/core/text.hpp>
#include <fstiff/halfspace/solve_half_space.hpp>
#include <fstiff/math/root.hpp>
#include <fstiff/topography/height_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <utility>

namespace fstiff { inline namespace v0_1 {

/// Contact of a map on an elastic half space, or on one with a hardness. The separation is the mean gap of the deformed
/// faces; the pressure at a separation is found by Newton's method with K as the slope.
template <Real T = double>
class BoundaryElementContact {
public:
    /// Presses the surface \p map against a smooth flat; options.progress is called while a state is computed.
    /// \throws domain_error as solve_half_space().
    BoundaryElementContact(const HeightMap<T>& map, std::type_identity_t<T> effective_modulus,
                           const HalfSpaceOptions<T>& options = {})
        : modulus_(effective_modulus), rms_height_(fstiff::rms_height(map)), area_(map.area()), options_(options) {
        map.require_whole("before boundary elements");
        detail::require_positive("effective_modulus", effective_modulus);
        if (options.hardness != T(0)) detail::require_positive("hardness", options.hardness);
        map_ = detail::map_for_truth(map, options.points);
    }

    /// The state under \p pressure [Pa]; out of reach where all points touch, where the solver does not converge, and
    /// from the hardness on. \throws domain_error for a pressure that is not positive.
    [[nodiscard]] ContactPoint<T> point_at_pressure(T pressure, Quantity quantities = Quantity::all) const {
        detail::require_positive("pressure", pressure);
        if (options_.hardness > T(0) && !(pressure < options_.hardness))
            return ContactPoint<T>::out_of_reach("pressure = " + detail::shortest_text(pressure) +
                                                 ": must be less than the hardness (Pa)");
        HalfSpaceOptions<T> options = options_;
        options.loading = detail::has(quantities, Quantity::loading_stiffness);
        const HalfSpacePoint<T> solved = solve_half_space(map_, modulus_, std::array{pressure}, options).front();
        if (std::isinf(solved.state.stiffness))
            return ContactPoint<T>::out_of_reach("all points of the map are in contact");
        if (std::isinf(solved.stiffness_error))
            return ContactPoint<T>::out_of_reach("all points of the grid half as fine are in contact");
        if (!solved.state.converged) return ContactPoint<T>::out_of_reach("the boundary elements do not converge");
        return ContactPoint<T>::of(state_of(solved));
    }
    /// The state at the mean gap \p separation [m].
    [[nodiscard]] ContactPoint<T> point_at_separation(T separation, Quantity quantities = Quantity::all) const {
        const T mean = map_.heights.mean(), highest = map_.heights.maxCoeff() - mean;
        const T lowest = options_.hardness > T(0) ? map_.heights.minCoeff() - mean : T(0);
        if (!(separation > lowest && separation < highest))
            return ContactPoint<T>::out_of_reach("separation = " + detail::shortest_text(separation) +
                                                 ": must be greater than " + detail::shortest_text(lowest) +
                                                 " and less than the highest point (m)");
        HalfSpaceOptions<T> one_grid = options_;
        one_grid.grid_error = one_grid.loading = false;
        one_grid.progress = {};
        const auto excess = [&](T log_pressure) {  // of the gap, and its slope over log p
            const T pressure = std::exp(log_pressure);
            const auto [state, stiffness_error, gap_error] =
                solve_half_space(map_, modulus_, std::array{pressure}, one_grid).front();
            return std::pair(state.mean_gap - separation, -pressure / state.stiffness);
        };
        const T most = options_.hardness > T(0) ? std::log(options_.hardness) - T(1e-6) : std::log(T(1e3) * modulus_);
        const T guess = std::log(modulus_ * rms_height_ / std::sqrt(area_)) - 3 * separation / rms_height_;
        const auto solution = math::newton_bracketed(excess, (std::min)(guess, most) - 60, most, guess, T(1e-8));
        if (!solution.converged())
            return ContactPoint<T>::out_of_reach("separation = " + detail::shortest_text(separation) +
                                                 ": must be that of some pressure (m)");
        return point_at_pressure(std::exp(solution.root), quantities);
    }
    /// \throws domain_error where there is no point.
    [[nodiscard]] ContactState<T> at_pressure(T pressure, Quantity quantities = Quantity::all) const {
        return detail::state_or_throw(point_at_pressure(pressure, quantities));
    }
    /// \throws domain_error where there is no point.
    [[nodiscard]] ContactState<T> at_separation(T separation, Quantity quantities = Quantity::all) const {
        return detail::state_or_throw(point_at_separation(separation, quantities));
    }
    [[nodiscard]] T rms_height() const { return rms_height_; }  ///< of the map before it is made coarser [m]

private:
    [[nodiscard]] ContactState<T> state_of(const HalfSpacePoint<T>& solved) const {
        const BoundaryElementState<T>& elements = solved.state;
        ContactState<T> state;
        state.pressure = {elements.pressure, 0, 0};
        state.separation = {elements.mean_gap, solved.gap_error, elements.iterations};
        state.eta = elements.mean_gap / rms_height_;
        state.stiffness = {elements.stiffness, solved.stiffness_error, elements.iterations};
        state.loading_stiffness = {elements.loading_stiffness, solved.stiffness_error, elements.iterations};
        state.real_area_fraction = {elements.contact_fraction, 0, 0};
        state.contact_density = {static_cast<T>(elements.spots) / area_, 0, 0};
        return state;
    }

    T modulus_, rms_height_, area_;
    HalfSpaceOptions<T> options_;
    HeightMap<T> map_;
};

}}  // namespace fstiff
