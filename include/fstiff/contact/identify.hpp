// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Parameters of the contact from a measured curve, K(p) or the reflection R(p), by weighted least squares.
///
///     minimise  sum_i [(model(p_i + p_0) - y_i)/e_i]^2       over some of sigma, R, D_p, D, E, r, theta, p_0
///
/// with the analytic derivatives of contact/sensitivity.hpp and ultrasound/propagation.hpp. Each parameter is fitted as its
/// row of surface/contact_parameter.hpp says: positive ones as their logarithms, D, r and theta as ln (x-a)/(b-x) between
/// their ends, the pressure offset p_0 as it is. Intervals are symmetric in the fitted variable. Without errors e_i, all
/// points count alike (K by relative, R by absolute residual) and the covariance is scaled by chi^2 over the degrees of
/// freedom.
///
/// What a curve can tell: K(p) = B g(p/A) with A = E D_p sigma^(3/2) R^(1/2) a and B = E D_p sigma^(1/2) R^(1/2) b, where g
/// depends on r and theta, a and b on D. So E, D_p and R enter in the product E D_p sqrt(R) alone, and of
/// sigma, that product and D no more than two can be found. Asked for more, the fit says singular and which; and also where
/// the noise is all that tells parameters apart: one that the data hold to a factor of 100 alone, but not beside the others.
///
/// At an end of the range of D, r or theta the fitted variable is infinite, and nothing there is a minimum: a fit that would
/// go beyond it, or is there within its error, says at_bound. Standard errors have no meaning then.
///
/// Reference   this project; the derivatives as in their headers
/// Units       SI
/// Valid       laws with the slopes of contact/sensitivity.hpp, no interaction; pressures p_i + p_0 > 0
/// Accuracy    the truth lies in the 95 % interval in 95 +- 4 of 100 runs (tests/contact/identify_test.cpp)

#include <fstiff/contact/sensitivity.hpp>
#include <fstiff/core/numbers.hpp>
#include <fstiff/math/least_squares.hpp>
#include <fstiff/surface/contact_parameter.hpp>
#include <fstiff/ultrasound/propagation.hpp>

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <vector>

namespace fstiff {

/// Values of all parameters: those that are fitted start from here, the others stay.
template <Real T>
struct ContactParameters {
    T rms_height{};         ///< sigma [m]
    T peak_radius{};        ///< R [m]
    T peak_density{};       ///< D_p [1/m^2]
    T fractal_dimension{};  ///< D; not used by HertzLaw
    T effective_modulus{};  ///< E [Pa]
    T r{};
    T theta{};   ///< [rad]
    T offset{};  ///< p_0 [Pa]: what is added to the measured pressures

    [[nodiscard]] T& operator[](Parameter parameter) noexcept { return at(*this, parameter); }
    [[nodiscard]] T operator[](Parameter parameter) const noexcept { return at(*this, parameter); }

private:
    template <class Self>
    static auto& at(Self& self, Parameter parameter) noexcept {
        constexpr std::array members{
            &ContactParameters::rms_height,        &ContactParameters::peak_radius, &ContactParameters::peak_density,
            &ContactParameters::fractal_dimension, &ContactParameters::r,           &ContactParameters::theta,
            &ContactParameters::effective_modulus, &ContactParameters::offset};  // in the order of Parameter
        static_assert(members.size() == parameter_table.size());
        return self.*members[index_of(parameter)];
    }
};

template <Real T>
struct Observation {
    T pressure{};  ///< nominal [Pa]
    T value{};     ///< K [Pa/m] or |R|
    T error{};     ///< its standard error; 0 in every point when it is not known
};

/// How a reflection was measured; none: the observations are stiffnesses.
template <Real T>
struct Wave {
    Impedances<T> media{};
    T angular_frequency{};
    T stiffness_ratio = T(1);  ///< of the stiffness that the wave sees to K: 1, or Mindlin's for shear waves
};

template <Real T>
struct IdentifyOptions {
    std::optional<Wave<T>> wave{};
    CurvatureScale curvature = CurvatureScale::bush_gibson_thomas;
    LeastSquaresOptions<T> search{};
};

template <Real T>
struct IdentifiedParameter {
    Parameter parameter{};
    T value{}, standard_error{};
    T low{}, high{};        ///< of the 95 % interval
    T looseness = 0;        ///< when singular: its share in the combination that the data do not see, of the largest
    bool at_bound = false;  ///< came to the end of its range
};

template <Real T>
struct Identification {
    FitStatus status{};
    std::vector<IdentifiedParameter<T>> parameters;                ///< in the order asked for
    ContactParameters<T> all{};                                    ///< fitted and fixed
    Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic> covariance;   ///< of the values; empty when singular or at_bound
    Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic> correlation;  ///< empty when singular or at_bound
    std::vector<T> model;                                          ///< at each observation
    std::vector<T> residuals;                                      ///< (model - value)/error
    T chi_squared{};
    int degrees_of_freedom = 0;
    bool errors_known = false;  ///< else scaled so that chi^2 = degrees_of_freedom
    int evaluations = 0;
};

/// Half the width of the 95 % interval in standard errors: Student's t at \p degrees_of_freedom (0: the normal value).
/// Closed for 1 and 2; else an expansion, right to 1e-3 from 5 on and to 1 % at 3.
template <Real T>
[[nodiscard]] T interval_factor(int degrees_of_freedom) {
    const T z = T(1.959963984540054);
    if (degrees_of_freedom <= 0) return z;
    const auto n = static_cast<T>(degrees_of_freedom);
    if (degrees_of_freedom == 1) return std::tan(T(0.475) * numbers::pi_v<T>);
    if (degrees_of_freedom == 2) return T(0.95) * std::sqrt(2 / (1 - T(0.95) * T(0.95)));
    const T s = z * z;
    return z * (1 + (s + 1) / (4 * n) + ((5 * s + 16) * s + 3) / (96 * n * n) +
                (((3 * s + 19) * s + 17) * s - 15) / (384 * n * n * n) +
                ((((79 * s + 776) * s + 1482) * s - 1920) * s - 945) / (92160 * n * n * n * n));
}

namespace detail {

/// dK/dx of \p parameter; an offset adds to the pressure.
template <Real T>
T slope_of(const Sensitivity<T>& s, Parameter parameter) {
    const std::array slopes{s.rms_height, s.peak_radius, s.peak_density,      s.fractal_dimension,
                            s.r,          s.theta,       s.effective_modulus, s.pressure};  // in the order of Parameter
    static_assert(slopes.size() == parameter_table.size());
    return slopes[index_of(parameter)];
}

/// \throws domain_error naming the first point that no model has.
template <Real T>
void require_observations(const std::vector<Observation<T>>& data, bool is_reflection, bool errors_known) {
    const auto check = [](bool satisfied, std::size_t point, std::string_view name, T value, std::string_view allowed) {
        if (!satisfied) refuse("data[" + std::to_string(point) + "]." + std::string(name), value, allowed);
    };
    constexpr std::string_view positive = "finite and greater than 0";
    const auto is_positive = [](T x) { return x > 0 && x <= std::numeric_limits<T>::max(); };
    for (std::size_t i = 0; i < data.size(); ++i) {
        const auto& o = data[i];
        check(is_positive(o.pressure), i, "pressure", o.pressure, positive);
        check(is_positive(o.value), i, is_reflection ? "reflection" : "stiffness", o.value, positive);
        // R a little above 1 is what noise makes of light loads; left out, it would bias the rest
        check(!is_reflection || o.value < 2, i, "reflection", o.value, "at most 1, but for noise");
        check(!errors_known || is_positive(o.error), i, "error", o.error,
              "finite and greater than 0, or 0 in every point when it is not known");
    }
}

/// A standard error above ln 100 of the logarithm that is fitted, which is a factor of 100 or nearly the whole range, tells
/// nothing.
template <Real T>
inline constexpr T useless_error = T(4.6);

/// Whether the value \p x is at an end of the range of its parameter: as good as there, or there within its error, or a search that
/// knew no end would leave the range. \p step is that of Gauss and Newton, \p deviation the standard error, both of the
/// variable and 0 unless the search came to rest.
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

/// The parameter that the data do not hold, though they would if it were alone or it has the whole of its range to be in: that
/// of the largest \p deviation; -1 when there is none.
template <Real T, class Vector, class Matrix>
Eigen::Index lost_parameter(const std::vector<Parameter>& wanted, const Vector& deviation, const Matrix& jacobian,
                            T scale) {
    Eigen::Index lost = -1;
    for (Eigen::Index i = 0; i < deviation.size(); ++i) {
        const Variation kind = row_of(wanted[static_cast<std::size_t>(i)]).variation;
        const bool alone = scale <= useless_error<T> * jacobian.col(i).norm();
        if ((kind == Variation::between || (kind == Variation::log && alone)) &&
            deviation(i) > (lost < 0 ? useless_error<T> : deviation(lost)))
            lost = i;
    }
    return lost;
}

}  // namespace detail

/// Fits \p wanted to \p data, from \p start. \p law(D) makes the asperity law, such as
/// [](T dimension) { return FractalLaw<T>(dimension); }.
/// \throws domain_error for data or starting values that no model has, or fewer points than parameters.
template <Real T, class MakeLaw>
[[nodiscard]] Identification<T> identify(const std::vector<Observation<T>>& data, const std::vector<Parameter>& wanted,
                                         const ContactParameters<T>& start, const MakeLaw& law,
                                         const IdentifyOptions<T>& options = {}) {
    using Vector = Eigen::Matrix<T, Eigen::Dynamic, 1>;
    using Matrix = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic>;
    // an error that is NaN or negative is no way to say that it is not known
    const bool known = std::any_of(data.begin(), data.end(), [](const auto& o) { return o.error != 0; });
    detail::require_observations(data, options.wave.has_value(), known);
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const T x = start[wanted[i]];
        require(ParameterScale<T>(wanted[i]).inside(x), name_of(wanted[i]), x, row_of(wanted[i]).starting_range());
        if (std::count(wanted.begin(), wanted.end(), wanted[i]) > 1)
            throw domain_error(std::string(name_of(wanted[i])) + ": is fitted twice; must be named once");
    }
    const auto count = static_cast<Eigen::Index>(wanted.size());
    const auto points = static_cast<Eigen::Index>(data.size());

    Identification<T> out;
    out.errors_known = known;
    const auto parameters_at = [&](const Vector& u) {
        ContactParameters<T> x = start;
        for (Eigen::Index i = 0; i < count; ++i) {
            const Parameter p = wanted[static_cast<std::size_t>(i)];
            x[p] = ParameterScale<T>(p).value(u(i));
        }
        return x;
    };
    std::vector<T> model(data.size());
    const auto evaluate = [&](const Vector& u, Vector& f, Matrix& jacobian) {
        const ContactParameters<T> x = parameters_at(u);
        for (const Parameter p : wanted)
            if (!ParameterScale<T>(p).inside(x[p])) return false;
        for (std::size_t i = 0; i < data.size(); ++i) {
            if (!(data[i].pressure + x.offset > 0)) return false;
            Sensitivity<T> s;
            try {
                s = sensitivity(Roughness<T>{x.rms_height, x.peak_radius, x.peak_density, T(0)},
                                PeakDensity<T>(x.r, x.theta), law(x.fractal_dimension), x.effective_modulus,
                                data[i].pressure + x.offset, options.curvature);
            } catch (const domain_error&) {
                return false;  // beyond the reach of the model
            }
            T value = s.stiffness, chain = 1;
            if (options.wave) {
                const auto& wave = *options.wave;
                value = reflection(wave.stiffness_ratio * s.stiffness, wave.media, wave.angular_frequency);
                chain = wave.stiffness_ratio *
                        reflection_slope(wave.stiffness_ratio * s.stiffness, wave.media, wave.angular_frequency);
            }
            const T error = known ? data[i].error : options.wave ? T(1) : data[i].value;
            const auto row = static_cast<Eigen::Index>(i);
            model[i] = value;
            f(row) = (value - data[i].value) / error;
            for (Eigen::Index k = 0; k < count; ++k) {
                const Parameter p = wanted[static_cast<std::size_t>(k)];
                jacobian(row, k) = detail::slope_of(s, p) * chain * ParameterScale<T>(p).slope(x[p]) / error;
            }
        }
        return true;
    };
    Vector u(count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const Parameter p = wanted[static_cast<std::size_t>(i)];
        u(i) = ParameterScale<T>(p).variable(start[p]);
    }
    LeastSquaresFit<T> fit = least_squares<T>(u, points, evaluate, options.search);

    out.evaluations = fit.evaluations;
    out.all = parameters_at(fit.parameters);
    Vector residuals(points);
    Matrix jacobian(points, count);
    static_cast<void>(evaluate(fit.parameters, residuals, jacobian));  // at the end, not at the last trial
    out.model = model;
    out.residuals.assign(fit.residuals.data(), fit.residuals.data() + points);
    out.degrees_of_freedom = static_cast<int>(points - count);
    out.chi_squared = fit.sum_of_squares;
    T scale = 1;
    if (!known && out.degrees_of_freedom > 0) {
        scale = std::sqrt(fit.sum_of_squares / static_cast<T>(out.degrees_of_freedom));
        if (scale > 0)
            for (T& residual : out.residuals) residual /= scale;
        out.chi_squared = scale > 0 ? static_cast<T>(out.degrees_of_freedom) : T(0);
    }
    Vector step = Vector::Zero(count), deviation = step;
    if (fit.covariance.size() > 0) deviation = fit.covariance.diagonal().cwiseSqrt() * scale;
    const bool at_rest = fit.status == FitStatus::converged;
    if (at_rest) step = -(fit.covariance * (jacobian.transpose() * residuals));
    std::vector<bool> at_bound(wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const auto index = static_cast<Eigen::Index>(i);
        at_bound[i] =
            detail::is_at_bound(wanted[i], out.all[wanted[i]], step(index), at_rest ? deviation(index) : T(0));
    }
    const Eigen::Index lost = at_rest ? detail::lost_parameter(wanted, deviation, jacobian, scale) : -1;
    const bool ended = std::count(at_bound.begin(), at_bound.end(), true) > 0;
    if (ended || lost >= 0) {
        fit.status = ended ? FitStatus::at_bound : FitStatus::singular;
        if (ended)
            fit.loose.resize(0);
        else
            fit.loose = fit.covariance.col(lost).cwiseProduct(jacobian.colwise().norm().transpose());
        fit.covariance.resize(0, 0);
    }
    out.status = fit.status;
    const bool has_errors = fit.covariance.size() > 0 && (known || out.degrees_of_freedom > 0);
    const T factor = interval_factor<T>(known ? 0 : out.degrees_of_freedom);
    if (has_errors) {
        out.covariance = fit.covariance * (scale * scale);
        out.correlation = fit.covariance;
        const Vector root = fit.covariance.diagonal().cwiseSqrt();
        for (Eigen::Index i = 0; i < count; ++i)
            for (Eigen::Index k = 0; k < count; ++k)
                out.correlation(i, k) = i == k ? T(1) : fit.covariance(i, k) / (root(i) * root(k));
    }
    const T largest = fit.loose.size() > 0 ? fit.loose.cwiseAbs().maxCoeff() : T(1);
    for (Eigen::Index i = 0; i < count; ++i) {
        const Parameter p = wanted[static_cast<std::size_t>(i)];
        const ParameterScale<T> fitted(p);
        IdentifiedParameter<T> found;
        found.parameter = p;
        found.at_bound = at_bound[static_cast<std::size_t>(i)];
        found.value = found.low = found.high = out.all[p];
        if (fit.loose.size() > 0) found.looseness = std::abs(fit.loose(i)) / largest;
        if (has_errors) {
            found.standard_error = deviation(i) * fitted.slope(found.value);
            found.low = fitted.value(fit.parameters(i) - factor * deviation(i));
            found.high = fitted.value(fit.parameters(i) + factor * deviation(i));
        }
        out.parameters.push_back(found);
    }
    if (has_errors)
        for (Eigen::Index i = 0; i < count; ++i)
            for (Eigen::Index k = 0; k < count; ++k) {
                const Parameter a = wanted[static_cast<std::size_t>(i)], b = wanted[static_cast<std::size_t>(k)];
                out.covariance(i, k) *= ParameterScale<T>(a).slope(out.all[a]) * ParameterScale<T>(b).slope(out.all[b]);
            }
    return out;
}

}  // namespace fstiff
