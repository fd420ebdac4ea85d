// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The fit of any curve K(p) that is a function of the parameters, with derivatives by differences.
///
///     dK/du = [8 (K(u+h) - K(u-h)) - (K(u+2h) - K(u-2h))]/(12 h)        u the fitted variable, h = 0.004
///
/// h of an offset is a share of each pressure. The data determine a combination of parameters if its singular value of
/// the scaled derivatives is above 1e-5 of the largest, instead of the 1e-7 of exact ones.
///
/// Reference   Abramowitz and Stegun, 25.3.6
/// Units       SI
/// Valid       as identify/identify; K smooth over changes of 0.8 % of each parameter
/// Accuracy    derivatives of ln K by logarithms, of hertz within 1e-10 of the exact ones, of hybrid within 1e-10 of
///             differences of other steps (tests/identify/difference_fit_test.cpp)

#include <fstiff/identify/identify.hpp>

#include <functional>
#include <span>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// K [Pa/m] at pressures [Pa] of a contact with the given parameters; the offset is in the pressures already.
/// \throws domain_error without one.
template <Real T = double>
using CurveOfParameters = std::function<std::vector<T>(const ContactParameters<T>&, std::span<const T>)>;

/// The residuals of a curve and their slopes by differences, as functions of the fitted variables.
template <Real T>
class DifferenceModel : public fstiff::detail::CurveProblem<T> {
public:
    using Problem = fstiff::detail::CurveProblem<T>;
    using typename Problem::Vector, typename Problem::Matrix;
    static constexpr T step = T(0.004);

    /// The objects of the arguments must live as long.
    DifferenceModel(const std::vector<Observation<T>>& data, const std::vector<Parameter>& parameters,
                    const ContactParameters<T>& start, const CurveOfParameters<T>& curve,
                    const std::optional<ObservedWave<T>>& wave)
        : Problem(data, parameters, start, wave), curve_(curve) {}

    /// (model - value)/error and its slopes by the fitted variables. \return whether \p u is within reach
    [[nodiscard]] bool operator()(const Vector& u, Vector& residuals, Matrix& jacobian) {
        if (!this->can_have(this->parameters_at(u))) return false;
        try {
            const std::vector<T> stiffness = stiffness_at(u, 0);
            std::vector<std::vector<T>> slopes;
            for (std::size_t k = 0; k < this->parameters().size(); ++k) slopes.push_back(slopes_by(u, k));
            for (std::size_t i = 0; i < stiffness.size(); ++i)
                this->put(
                    i, stiffness[i], [&](std::size_t k) { return slopes[k][i]; }, residuals, jacobian);
        } catch (const domain_error&) {
            return false;  // beyond the reach of the model
        }
        return true;
    }

private:
    /// K at all points, whose pressures are larger by the share \p more.
    [[nodiscard]] std::vector<T> stiffness_at(const Vector& u, T more) const {
        const ContactParameters<T> x = this->parameters_at(u);
        std::vector<T> pressures;
        for (const auto& point : this->data()) pressures.push_back((point.pressure + x.offset) * (1 + more));
        return curve_(x, pressures);
    }
    /// dK/du of the variable \p k at all points.
    [[nodiscard]] std::vector<T> slopes_by(const Vector& u, std::size_t k) const {
        const bool offset = this->parameters()[k] == Parameter::offset;
        const auto moved = [&](T shift) {
            Vector shifted = u;
            if (!offset) shifted(static_cast<Eigen::Index>(k)) += shift;
            return stiffness_at(shifted, offset ? shift : T(0));
        };
        const std::vector<T> up = moved(step), down = moved(-step), far_up = moved(2 * step),
                             far_down = moved(-2 * step);
        std::vector<T> slopes(up.size());
        for (std::size_t i = 0; i < slopes.size(); ++i) {
            slopes[i] = (8 * (up[i] - down[i]) - (far_up[i] - far_down[i])) / (12 * step);
            if (offset) slopes[i] /= this->data()[i].pressure + this->parameters_at(u).offset;
        }
        return slopes;
    }

    const CurveOfParameters<T>& curve_;
};

/// Fits \p parameters of \p curve to \p data, from \p start. \p options.contact is not used.
/// \throws domain_error for data or starting values that no model has, and for fewer points than parameters.
template <Real T>
[[nodiscard]] Identification<T> identify_by_differences(const std::vector<Observation<T>>& data,
                                                        const std::vector<Parameter>& parameters,
                                                        const ContactParameters<T>& start,
                                                        const CurveOfParameters<T>& curve,
                                                        IdentifyOptions<T> options = {}) {
    options.search.singular_value = (std::max)(options.search.singular_value, T(1e-5));
    options.search.residual_floor = (std::max)(options.search.residual_floor, T(1e-8));
    DifferenceModel<T> model(data, parameters, start, curve, options.wave);
    return fit_of(model, start, options.search);
}

}}}  // namespace fstiff::detail
