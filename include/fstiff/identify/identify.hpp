// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Parameters of the contact from a measured curve, K(p) or the reflection R(p), by weighted least squares.
///
///     minimise  sum_i [(model(p_i + p_0) - y_i)/e_i]^2       over some of sigma, R, D_p, D, E, r, theta, p_0
///
/// surface/parameter.hpp defines the fitted variable of each parameter; intervals are symmetric in it. Without
/// errors e_i all points count alike and the covariance is scaled by chi^2. At most two of sigma, E D_p sqrt(R) and D
/// can be found (docs/theory-numerics.md): a fit that asks for more is singular, by a singular value of the scaled
/// slopes below 1e-5 of the largest, and names the parameters; one at an end of D, r or theta is at_bound.
///
/// Reference   this project
/// Units       SI
/// Valid       as the contact; pressures p_i + p_0 > 0; the length of an interaction is held
/// Accuracy    the truth lies in the 95 % interval in 95 +- 4 of 100 runs (tests/identify/identify_test.cpp)

#include <fstiff/contact/rough_contact.hpp>
#include <fstiff/identify/fit_problem.hpp>
#include <fstiff/math/least_squares.hpp>
#include <fstiff/math/random.hpp>
#include <fstiff/math/statistics.hpp>
#include <fstiff/surface/parameter.hpp>

#include <limits>

namespace fstiff { inline namespace v0_1 {

/// Observations and options of a fit.
template <Real T = double>
struct IdentifyOptions {
    std::optional<ObservedWave<T>> wave{};
    RoughContactOptions<T> contact{};  ///< of the contact that is fitted: interaction, sigma_kappa of R
    math::LeastSquaresOptions<T> search{};
};

/// One fitted parameter.
template <Real T = double>
struct IdentifiedParameter {
    Parameter parameter{};
    T value{}, standard_error{};
    T low{}, high{};                                                                     ///< of the 95 % interval
    T low_with_law = std::numeric_limits<T>::quiet_NaN(), high_with_law = low_with_law;  ///< where the law errs, too
    T null_share = 0;  ///< when singular: its share in the combination that the data do not determine, of the largest
    bool at_bound = false;  ///< came to the end of its range
};

/// The outcome of identify().
template <Real T = double>
struct Identification {
    math::FitStatus status{};
    std::vector<IdentifiedParameter<T>> parameters;                ///< in the order asked for
    ContactParameters<T> start{};                                  ///< start of the search
    ContactParameters<T> optimum{};                                ///< fitted and fixed
    Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic> covariance;   ///< of the values; empty when singular or at_bound
    Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic> correlation;  ///< empty when singular or at_bound
    std::vector<T> model;                                          ///< at each observation
    std::vector<T> residuals;                                      ///< (model - value)/error
    T chi_squared{};
    int degrees_of_freedom = 0;
    bool errors_known = false;  ///< else scaled so that chi^2 = degrees_of_freedom
    T scatter{};  ///< of points without errors, rms over the degrees of freedom: of K relative, of |R| absolute
    int evaluations = 0;
};

namespace detail {

/// A standard error above ln 100 of the logarithm that is fitted, a factor of 100 or nearly the whole range: no
/// information.
template <Real T>
inline constexpr T useless_error = T(4.6);

/// True if the value \p x is at an end of the range of its parameter: as good as there, or there within its error, or a
/// search that knew no end would leave the range. \p step is that of Gauss and Newton, \p deviation the standard error,
/// both of the variable and 0 unless the search came to rest.
template <Real T>
bool is_at_bound(Parameter parameter, T x, T step, T deviation) {
    const ParameterRow& row = row_of(parameter);
    if (row.variation != Variation::between) return false;
    const ParameterScale<T> chart(parameter);
    const auto low = static_cast<T>(row.low.value), high = static_cast<T>(row.high.value);
    const T range = high - low, close = T(1e-6) * range, moved = x + chart.slope(x) * step;
    return !(x - low > close && high - x > close) || !(moved > low && moved < high) ||
           (deviation > useless_error<T> && chart.slope(x) * deviation < T(0.1) * range);
}

/// Index of the parameter that the data do not determine, although they would if it were alone or may be anywhere in
/// its range: that of the largest \p deviation; -1 without one.
template <Real T, class Vector, class Matrix>
Eigen::Index lost_parameter(const std::vector<Parameter>& parameters, const Vector& deviation, const Matrix& jacobian,
                            T scale) {
    Eigen::Index lost = -1;
    for (Eigen::Index i = 0; i < deviation.size(); ++i) {
        const Variation kind = row_of(parameters[static_cast<std::size_t>(i)]).variation;
        const bool alone = scale <= useless_error<T> * jacobian.col(i).norm();
        if ((kind == Variation::between || (kind == Variation::log && alone)) &&
            deviation(i) > (lost < 0 ? useless_error<T> : deviation(lost)))
            lost = i;
    }
    return lost;
}

/// Evaluates a finished search: its status, the parameters at an end of their range, and the errors.
template <Real T>
class FitSummary {
public:
    using Vector = Eigen::Matrix<T, Eigen::Dynamic, 1>;
    using Matrix = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic>;

    /// \p out has the values of \p fit already, and whether errors are known.
    FitSummary(const std::vector<Parameter>& parameters, math::LeastSquaresFit<T>& fit, Identification<T>& out)
        : parameters_(parameters), fit_(fit), out_(out), count_(static_cast<Eigen::Index>(parameters.size())) {}

    /// \p residuals and \p jacobian at the end of the search.
    void fill(const Vector& residuals, const Matrix& jacobian) {
        scale_residuals(residuals.size());
        judge(residuals, jacobian);
        out_.status = fit_.status;
        if (has_errors()) correlate();
        for (std::size_t i = 0; i < parameters_.size(); ++i) out_.parameters.push_back(parameter(i));
        if (has_errors())
            for (Eigen::Index i = 0; i < count_; ++i)
                for (Eigen::Index k = 0; k < count_; ++k) out_.covariance(i, k) *= slope_at(i) * slope_at(k);
    }

private:
    [[nodiscard]] bool has_errors() const {
        return fit_.covariance.size() > 0 && (out_.errors_known || out_.degrees_of_freedom > 0);
    }
    [[nodiscard]] T slope_at(Eigen::Index i) const {
        const Parameter parameter = parameters_[static_cast<std::size_t>(i)];
        return ParameterScale<T>(parameter).slope(out_.optimum[parameter]);
    }

    /// Errors that are not known are such that chi^2 = degrees_of_freedom.
    void scale_residuals(Eigen::Index points) {
        out_.residuals.assign(fit_.residuals.data(), fit_.residuals.data() + points);
        out_.degrees_of_freedom = static_cast<int>(points - count_);
        out_.chi_squared = fit_.sum_of_squares;
        if (out_.errors_known || out_.degrees_of_freedom <= 0) return;
        scale_ = std::sqrt(fit_.sum_of_squares / static_cast<T>(out_.degrees_of_freedom));
        out_.scatter = scale_;
        if (scale_ > 0)
            for (T& residual : out_.residuals) residual /= scale_;
        out_.chi_squared = scale_ > 0 ? static_cast<T>(out_.degrees_of_freedom) : T(0);
    }

    /// True if the search came to rest at a minimum: not at an end, and with every parameter held by the data.
    void judge(const Vector& residuals, const Matrix& jacobian) {
        Vector step = Vector::Zero(count_);
        deviation_ = step;
        if (fit_.covariance.size() > 0) deviation_ = fit_.covariance.diagonal().cwiseSqrt() * scale_;
        const bool at_rest = fit_.status == math::FitStatus::converged;
        if (at_rest) step = -(fit_.covariance * (jacobian.transpose() * residuals));
        at_bound_.resize(parameters_.size());
        for (std::size_t i = 0; i < parameters_.size(); ++i) {
            const auto index = static_cast<Eigen::Index>(i);
            at_bound_[i] = is_at_bound(parameters_[i], out_.optimum[parameters_[i]], step(index),
                                       at_rest ? deviation_(index) : T(0));
        }
        const Eigen::Index lost = at_rest ? lost_parameter(parameters_, deviation_, jacobian, scale_) : -1;
        const bool ended = std::count(at_bound_.begin(), at_bound_.end(), true) > 0;
        if (!ended && lost < 0) return;
        fit_.status = ended ? math::FitStatus::at_bound : math::FitStatus::singular;
        if (ended)
            fit_.null_direction.resize(0);
        else
            fit_.null_direction = fit_.covariance.col(lost).cwiseProduct(jacobian.colwise().norm().transpose());
        fit_.covariance.resize(0, 0);
    }

    void correlate() {
        out_.covariance = fit_.covariance * (scale_ * scale_);
        out_.correlation = fit_.covariance;
        const Vector root = fit_.covariance.diagonal().cwiseSqrt();
        for (Eigen::Index i = 0; i < count_; ++i)
            for (Eigen::Index k = 0; k < count_; ++k)
                out_.correlation(i, k) = i == k ? T(1) : fit_.covariance(i, k) / (root(i) * root(k));
    }

    [[nodiscard]] IdentifiedParameter<T> parameter(std::size_t i) const {
        const auto index = static_cast<Eigen::Index>(i);
        const ParameterScale<T> fitted(parameters_[i]);
        IdentifiedParameter<T> result;
        result.parameter = parameters_[i];
        result.at_bound = at_bound_[i];
        result.value = result.low = result.high = out_.optimum[parameters_[i]];
        if (fit_.null_direction.size() > 0)
            result.null_share = std::abs(fit_.null_direction(index)) / fit_.null_direction.cwiseAbs().maxCoeff();
        if (has_errors()) {
            const T factor =
                math::student_quantile(math::normal_975<T>, out_.errors_known ? 0 : out_.degrees_of_freedom);
            result.standard_error = deviation_(index) * fitted.slope(result.value);
            result.low = fitted.value(fit_.parameters(index) - factor * deviation_(index));
            result.high = fitted.value(fit_.parameters(index) + factor * deviation_(index));
        }
        return result;
    }

    const std::vector<Parameter>& parameters_;
    math::LeastSquaresFit<T>& fit_;
    Identification<T>& out_;
    Eigen::Index count_;
    T scale_ = 1;       ///< of the residuals
    Vector deviation_;  ///< standard errors of the fitted variables
    std::vector<bool> at_bound_;
};

/// Residuals and slopes of a curve as least_squares() takes them: a std::function, so that the search is compiled once
/// for all laws.
template <Real T>
using FitCurve =
    std::function<bool(const typename math::LeastSquaresFit<T>::Vector&, typename math::LeastSquaresFit<T>::Vector&,
                       typename math::LeastSquaresFit<T>::Matrix&)>;

/// Searches from where \p model begins.
template <Real T>
[[nodiscard]] Identification<T> fit_of(CurveModel<T>& model, const ContactParameters<T>& start,
                                       const math::LeastSquaresOptions<T>& search) {
    const auto points = static_cast<Eigen::Index>(model.data().size());
    const FitCurve<T> evaluate = [&model](const auto& u, auto& f, auto& j) { return model(u, f, j); };
    math::LeastSquaresFit<T> fit = math::least_squares<T>(model.start(), points, evaluate, search);

    Identification<T> out;
    out.errors_known = model.errors_known();
    out.evaluations = fit.evaluations;
    out.start = start;
    out.optimum = model.parameters_at(fit.parameters);
    typename FitSummary<T>::Vector residuals(points);
    typename FitSummary<T>::Matrix jacobian(points, fit.parameters.size());
    static_cast<void>(model(fit.parameters, residuals, jacobian));  // at the end, not at the last trial
    out.model = model.values();
    FitSummary<T>(model.parameters(), fit, out).fill(residuals, jacobian);
    return out;
}

/// Fits \p parameters of \p curve to \p data, from \p start. \p options.contact is not used.
/// \throws domain_error for data or starting values that no model has, and for fewer points than parameters.
template <Real T>
[[nodiscard]] Identification<T> identify_curve(const std::vector<Observation<T>>& data,
                                               const std::vector<Parameter>& parameters,
                                               const ContactParameters<T>& start, const CurveOfParameters<T>& curve,
                                               IdentifyOptions<T> options = {}) {
    options.search.singular_value = (std::max)(options.search.singular_value, T(1e-5));
    options.search.residual_floor = (std::max)(options.search.residual_floor, T(1e-8));
    CurveModel<T> model(data, parameters, start, curve, options.wave);
    return fit_of(model, start, options.search);
}

}  // namespace detail

/// Fits parameters of a contact to \p data, from \p start. \p parameters lists them. \p law(D) makes the asperity law,
/// such as [](T dimension) { return FractalLaw<T>(dimension); }. \throws domain_error for data or starting values that
/// no model has, and fewer points than parameters.
template <Real T, class MakeLaw>
[[nodiscard]] Identification<T> identify(const std::vector<Observation<T>>& data,
                                         const std::vector<Parameter>& parameters, const ContactParameters<T>& start,
                                         const MakeLaw& law, const IdentifyOptions<T>& options = {}) {
    const detail::CurveOfParameters<T> curve = [&](const ContactParameters<T>& x, std::span<const T> pressures) {
        const RoughContact contact(Roughness<T>{x.rms_height, x.peak_radius, x.peak_density, T(0)},
                                   PeakDistribution<T>(x.r, x.theta), law(x.fractal_dimension), x.effective_modulus,
                                   options.contact);
        std::vector<T> stiffness;
        for (const T p : pressures) stiffness.push_back(contact.at_pressure(p, Quantity::stiffness).stiffness.value);
        return stiffness;
    };
    return detail::identify_curve(data, parameters, start, curve, options);
}

}}  // namespace fstiff
