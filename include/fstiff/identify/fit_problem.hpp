// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Input of a fit: the parameters, the observations, and the model with its slopes at each of them.
///
///     model_i = K(p_i + p_0), or |R| of it       d model_i/du = dR/dK dK/du
///
/// K is any function of the parameters. Its slopes by a fitted variable u are differences (math/difference.hpp) of the
/// step 0.004; that of an offset is a share of each pressure.
///
/// Reference   the slope of |R| of wave/spring_interface.hpp
/// Units       SI
/// Valid       as identify/identify; K smooth over changes of 0.8 % of each parameter
/// Accuracy    slopes of ln K of hertz and of hybrid by logarithms within 1e-10 of differences of other steps, of hertz
///             within 1e-10 of the identities of its scales (tests/identify/fit_problem_test.cpp)

#include <fstiff/core/error.hpp>
#include <fstiff/math/difference.hpp>
#include <fstiff/surface/parameter.hpp>
#include <fstiff/wave/spring_interface.hpp>
#include <fstiff/wave/uncertain_reflection.hpp>

#include <Eigen/Core>

#include <functional>
#include <span>

namespace fstiff { inline namespace v0_1 {

/// Values of all parameters: those that are fitted start from here, the others stay.
template <Real T = double>
struct ContactParameters {
    T rms_height{};         ///< sigma [m]
    T peak_radius{};        ///< R [m]
    T peak_density{};       ///< D_p [1/m^2]
    T fractal_dimension{};  ///< D; not used by HertzLaw
    T effective_modulus{};  ///< E [Pa]
    T r{};
    T theta{};         ///< [rad]
    T offset{};        ///< p_0 [Pa]: what is added to the measured pressures
    T rms_gradient{};  ///< g of the surface; as alpha and hardness not used by peaks of an asperity law
    T alpha{};         ///< Nayak's
    T hardness{};      ///< [Pa]

    [[nodiscard]] T& operator[](Parameter parameter) noexcept { return at(*this, parameter); }
    [[nodiscard]] T operator[](Parameter parameter) const noexcept { return at(*this, parameter); }

private:
    template <class Self>
    static auto& at(Self& self, Parameter parameter) noexcept {
        constexpr std::array members{&ContactParameters::rms_height,
                                     &ContactParameters::peak_radius,
                                     &ContactParameters::peak_density,
                                     &ContactParameters::fractal_dimension,
                                     &ContactParameters::r,
                                     &ContactParameters::theta,
                                     &ContactParameters::effective_modulus,
                                     &ContactParameters::offset,
                                     &ContactParameters::rms_gradient,
                                     &ContactParameters::alpha,
                                     &ContactParameters::hardness};  // in the order of Parameter
        static_assert(members.size() == detail::parameter_table.size());
        return self.*members[detail::index_of(parameter)];
    }
};

/// One measured point of K(p) or R(p).
template <Real T = double>
struct Observation {
    T pressure{};  ///< nominal [Pa]
    T value{};     ///< K [Pa/m] or |R|
    T error{};     ///< its standard error; 0 in every point when it is not known
};

/// Measurement of a reflection; none: the observations are stiffnesses.
template <Real T = double>
struct ObservedWave {
    Impedances<T> media{};
    T angular_frequency{};
    T stiffness_ratio = T(1);  ///< of the stiffness that the wave sees to K: 1, or Mindlin's for shear waves
    T film_stiffness{};        ///< of a fluid film next to the contacts, which longitudinal waves see too [Pa/m]

    /// The stiffness that the wave sees.
    [[nodiscard]] T seen(T stiffness) const { return stiffness_ratio * stiffness + film_stiffness; }
};

namespace detail {

/// \throws domain_error naming the first point that no model has.
template <Real T>
void require_observations(const std::vector<Observation<T>>& data, bool is_reflection, bool errors_known) {
    const auto check = [](bool satisfied, std::size_t point, std::string_view name, T value, std::string_view allowed) {
        if (!satisfied) detail::refuse("data[" + std::to_string(point) + "]." + std::string(name), value, allowed);
    };
    constexpr std::string_view positive = "finite and greater than 0";
    const auto is_positive = [](T x) { return x > 0 && x <= (std::numeric_limits<T>::max)(); };
    for (std::size_t i = 0; i < data.size(); ++i) {
        const auto& o = data[i];
        check(is_positive(o.pressure), i, "pressure", o.pressure, positive);
        check(is_positive(o.value), i, is_reflection ? "reflection" : "stiffness", o.value, positive);
        // noise makes R a little above 1 at light loads; to leave such points out would bias the rest
        check(!is_reflection || o.value < 2, i, "reflection", o.value, "at most 1, but for noise");
        check(!errors_known || is_positive(o.error), i, "error", o.error,
              "finite and greater than 0, or 0 in every point when it is not known");
    }
}

/// \throws domain_error naming the first of \p parameters that no fit can start from, or that is named twice.
template <Real T>
void require_start(const std::vector<Parameter>& parameters, const ContactParameters<T>& start) {
    for (const Parameter p : parameters) {
        const T x = start[p];
        require(ParameterScale<T>(p).inside(x), name_of(p), x, detail::row_of(p).starting_range());
        if (std::count(parameters.begin(), parameters.end(), p) > 1)
            throw domain_error(Refusal{.parameter = name_of(p), .reason = "is fitted twice; must be named once"});
    }
}

/// K [Pa/m] at pressures [Pa] of a contact with the given parameters; the offset is in the pressures already.
/// \throws domain_error without one.
template <Real T = double>
using CurveOfParameters = std::function<std::vector<T>(const ContactParameters<T>&, std::span<const T>)>;

/// The residuals of a curve and their slopes, as functions of the fitted variables.
template <Real T>
class CurveModel {
public:
    using Vector = Eigen::Matrix<T, Eigen::Dynamic, 1>;
    using Matrix = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic>;
    static constexpr T step = T(0.004);

    /// The objects of the arguments must live as long.
    CurveModel(const std::vector<Observation<T>>& data, const std::vector<Parameter>& parameters,
               const ContactParameters<T>& start, const CurveOfParameters<T>& curve,
               const std::optional<ObservedWave<T>>& wave)
        : data_(data),
          parameters_(parameters),
          start_(start),
          curve_(curve),
          wave_(wave),
          // an error that is NaN or negative does not mean "unknown"
          errors_known_(std::any_of(data.begin(), data.end(), [](const auto& o) { return o.error != 0; })),
          values_(data.size()) {
        require_observations(data, wave.has_value(), errors_known_);
        require_start(parameters, start);
    }

    [[nodiscard]] ContactParameters<T> parameters_at(const Vector& u) const {
        ContactParameters<T> x = start_;
        for (std::size_t i = 0; i < parameters_.size(); ++i)
            x[parameters_[i]] = ParameterScale<T>(parameters_[i]).value(u(static_cast<Eigen::Index>(i)));
        return x;
    }
    [[nodiscard]] Vector start() const {
        Vector u(static_cast<Eigen::Index>(parameters_.size()));
        for (std::size_t i = 0; i < parameters_.size(); ++i)
            u(static_cast<Eigen::Index>(i)) = ParameterScale<T>(parameters_[i]).variable(start_[parameters_[i]]);
        return u;
    }
    /// Model at the last point within its reach.
    [[nodiscard]] const std::vector<T>& values() const { return values_; }
    [[nodiscard]] const std::vector<Observation<T>>& data() const { return data_; }
    [[nodiscard]] const std::vector<Parameter>& parameters() const { return parameters_; }
    [[nodiscard]] bool errors_known() const { return errors_known_; }

    /// (model - value)/error and its slopes by the fitted variables. \return whether \p u is within reach
    [[nodiscard]] bool operator()(const Vector& u, Vector& residuals, Matrix& jacobian) {
        if (!can_have(parameters_at(u))) return false;
        try {
            const Vector stiffness = stiffness_at(u, 0);
            Matrix slopes(stiffness.size(), u.size());
            for (Eigen::Index k = 0; k < u.size(); ++k) slopes.col(k) = slopes_by(u, k);
            for (Eigen::Index i = 0; i < stiffness.size(); ++i) put(i, stiffness(i), slopes, residuals, jacobian);
        } catch (const domain_error&) {
            return false;  // beyond the reach of the model
        }
        return true;
    }

private:
    /// True if a model can have the parameters \p x at all; beyond a thousand times the start it only takes time.
    [[nodiscard]] bool can_have(const ContactParameters<T>& x) const {
        for (const Parameter parameter : parameters_) {
            const bool log = detail::row_of(parameter).variation == Variation::log,
                       distant = log && std::abs(std::log(x[parameter] / start_[parameter])) > 7;
            if (distant || !ParameterScale<T>(parameter).inside(x[parameter])) return false;
        }
        return std::all_of(data_.begin(), data_.end(), [&](const auto& d) { return d.pressure + x.offset > 0; });
    }
    /// K at all points, whose pressures are larger by the share \p more.
    [[nodiscard]] Vector stiffness_at(const Vector& u, T more) const {
        const ContactParameters<T> x = parameters_at(u);
        std::vector<T> pressures;
        for (const auto& point : data_) pressures.push_back((point.pressure + x.offset) * (1 + more));
        const std::vector<T> stiffness = curve_(x, pressures);
        return Eigen::Map<const Vector>(stiffness.data(), static_cast<Eigen::Index>(stiffness.size()));
    }
    /// dK/du of the variable \p k at all points.
    [[nodiscard]] Vector slopes_by(const Vector& u, Eigen::Index k) const {
        const bool offset = parameters_[static_cast<std::size_t>(k)] == Parameter::offset;
        Vector slopes = math::central_difference(
            [&](T shift) {
                Vector shifted = u;
                if (!offset) shifted(k) += shift;
                return stiffness_at(shifted, offset ? shift : T(0));
            },
            step);
        if (offset)
            for (std::size_t i = 0; i < data_.size(); ++i)
                slopes(static_cast<Eigen::Index>(i)) /= data_[i].pressure + parameters_at(u).offset;
        return slopes;
    }
    /// Row \p row of the residuals and their slopes, of K and \p slopes, dK by the fitted variables.
    void put(Eigen::Index row, T stiffness, const Matrix& slopes, Vector& residuals, Matrix& jacobian) {
        const auto i = static_cast<std::size_t>(row);
        T value = stiffness, chain = 1;
        if (wave_) {
            const T k = wave_->seen(stiffness);
            value = reflection(k, wave_->media, wave_->angular_frequency);
            chain = wave_->stiffness_ratio * detail::reflection_slope(k, wave_->media, wave_->angular_frequency);
        }
        const T error = errors_known_ ? data_[i].error : wave_ ? T(1) : data_[i].value;
        values_[i] = value;
        residuals(row) = (value - data_[i].value) / error;
        for (Eigen::Index k = 0; k < slopes.cols(); ++k) jacobian(row, k) = slopes(row, k) * chain / error;
    }

    const std::vector<Observation<T>>& data_;
    const std::vector<Parameter>& parameters_;
    const ContactParameters<T>& start_;
    const CurveOfParameters<T>& curve_;
    const std::optional<ObservedWave<T>>& wave_;
    bool errors_known_;
    std::vector<T> values_;
};

}  // namespace detail
}}  // namespace fstiff
