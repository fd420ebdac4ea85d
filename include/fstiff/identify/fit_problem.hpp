// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Input of a fit: the parameters, the observations, and the model with its slopes at each of them.
///
///     model_i = K(p_i + p_0), or |R| of it       d model_i/dx = dR/dK dK/dx
///
/// Reference   the derivatives of contact/sensitivity.hpp and wave/spring_interface.hpp
/// Units       SI
/// Valid       as identify/identify
/// Accuracy    that of contact/sensitivity (tests/identify/identify_test.cpp)

#include <fstiff/contact/sensitivity.hpp>
#include <fstiff/core/error.hpp>
#include <fstiff/surface/parameter.hpp>
#include <fstiff/wave/spring_interface.hpp>
#include <fstiff/wave/uncertain_reflection.hpp>

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

/// dK/dx of \p parameter; an offset adds to the pressure. 0 for parameters that peaks of an asperity law do not have.
template <Real T>
T slope_of(const Sensitivity<T>& s, Parameter parameter) {
    const std::array slopes{s.rms_height, s.peak_radius, s.peak_density,      s.fractal_dimension,
                            s.r,          s.theta,       s.effective_modulus, s.pressure};  // in the order of Parameter
    const std::size_t index = detail::index_of(parameter);
    return index < slopes.size() ? slopes[index] : T(0);
}

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

/// Fitted parameters, their points, and K with its slopes there.
template <Real T>
class CurveProblem {
public:
    using Vector = Eigen::Matrix<T, Eigen::Dynamic, 1>;
    using Matrix = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic>;

    /// The objects of the arguments must live as long.
    CurveProblem(const std::vector<Observation<T>>& data, const std::vector<Parameter>& parameters,
                 const ContactParameters<T>& start, const std::optional<ObservedWave<T>>& wave)
        : data_(data),
          parameters_(parameters),
          start_(start),
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

protected:
    /// True if a model can have the parameters \p x at all; beyond a thousand times the start it only takes time.
    [[nodiscard]] bool can_have(const ContactParameters<T>& x) const {
        for (const Parameter parameter : parameters_) {
            const bool log = detail::row_of(parameter).variation == Variation::log,
                       distant = log && std::abs(std::log(x[parameter] / start_[parameter])) > 7;
            if (distant || !ParameterScale<T>(parameter).inside(x[parameter])) return false;
        }
        return std::all_of(data_.begin(), data_.end(), [&](const auto& d) { return d.pressure + x.offset > 0; });
    }
    /// Row \p i of the residuals and their slopes, of K and \p slope(k), dK by the fitted variable k.
    template <class Slope>
    void put(std::size_t i, T stiffness, const Slope& slope, Vector& residuals, Matrix& jacobian) {
        T value = stiffness, chain = 1;
        if (wave_) {
            const T k = wave_->seen(stiffness);
            value = reflection(k, wave_->media, wave_->angular_frequency);
            chain = wave_->stiffness_ratio * detail::reflection_slope(k, wave_->media, wave_->angular_frequency);
        }
        const T error = errors_known_ ? data_[i].error : wave_ ? T(1) : data_[i].value;
        const auto row = static_cast<Eigen::Index>(i);
        values_[i] = value;
        residuals(row) = (value - data_[i].value) / error;
        for (std::size_t k = 0; k < parameters_.size(); ++k)
            jacobian(row, static_cast<Eigen::Index>(k)) = slope(k) * chain / error;
    }

private:
    const std::vector<Observation<T>>& data_;
    const std::vector<Parameter>& parameters_;
    const ContactParameters<T>& start_;
    const std::optional<ObservedWave<T>>& wave_;
    bool errors_known_;
    std::vector<T> values_;
};

/// The residuals of a curve and their slopes, as functions of the fitted variables.
template <Real T, class MakeLaw>
class CurveModel : public CurveProblem<T> {
public:
    using typename CurveProblem<T>::Vector, typename CurveProblem<T>::Matrix;

    /// The objects of the arguments must live as long.
    CurveModel(const std::vector<Observation<T>>& data, const std::vector<Parameter>& parameters,
               const ContactParameters<T>& start, const MakeLaw& law, const std::optional<ObservedWave<T>>& wave,
               const RoughContactOptions<T>& contact)
        : CurveProblem<T>(data, parameters, start, wave), law_(law), contact_(contact) {
        using Law = decltype(law(start.fractal_dimension));
        if constexpr (!DimensionalLaw<Law, T>)
            require(std::count(parameters.begin(), parameters.end(), Parameter::fractal_dimension) == 0,
                    name_of(Parameter::fractal_dimension), start.fractal_dimension,
                    "fixed: this law has no members log_load_slope() and log_stiffness_slope()");
    }

    /// (model - value)/error and its slopes by the fitted variables. \return whether \p u is within reach
    [[nodiscard]] bool operator()(const Vector& u, Vector& residuals, Matrix& jacobian) {
        const ContactParameters<T> x = this->parameters_at(u);
        if (!this->can_have(x)) return false;
        try {
            const RoughContact contact(Roughness<T>{x.rms_height, x.peak_radius, x.peak_density, T(0)},
                                       PeakDistribution<T>(x.r, x.theta), law_(x.fractal_dimension),
                                       x.effective_modulus, contact_);
            for (std::size_t i = 0; i < this->data().size(); ++i) {
                const Sensitivity<T> s = sensitivity(contact, this->data()[i].pressure + x.offset);
                const auto slope = [&](std::size_t k) {
                    const Parameter parameter = this->parameters()[k];
                    return slope_of(s, parameter) * ParameterScale<T>(parameter).slope(x[parameter]);
                };
                this->put(i, s.stiffness, slope, residuals, jacobian);
            }
        } catch (const domain_error&) {
            return false;  // beyond the reach of the model
        }
        return true;
    }

private:
    const MakeLaw& law_;
    const RoughContactOptions<T>& contact_;
};

}  // namespace detail
}}  // namespace fstiff
