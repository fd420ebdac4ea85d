// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Sums of peaks/law_sums for a law without powers: integrals in two dimensions, or over the heights of one radius.
///
///     joint distribution    I[f] of peaks/tensor_integrals.hpp; -dI[f]/deta = I[f (zeta - r t)/c^2]       (by parts)
///     peaks of one radius   int f(e) phi(eta + e) de, split at the kinks of the law; its slope by parts as well
///
/// Reference   this project; Buczkowski, Kleiber, Starzynski, Arch. Mech. 66 (2014), eqs. (4.5)-(4.9)
/// Units       SI; load/E [m^2], stiffness/E [m], area [m^2] of the law
/// Valid       as the integrals that are called
/// Accuracy    that of the integrals that are called (tests/peaks/any_law_test.cpp)

#include <fstiff/math/double_exponential.hpp>
#include <fstiff/math/quadrature.hpp>
#include <fstiff/peaks/law_sums.hpp>
#include <fstiff/peaks/single_radius.hpp>
#include <fstiff/peaks/tensor_integrals.hpp>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// A function of excess height and curvature with \p count kinks, called through a virtual function: the rule in two
/// dimensions, which takes far longer to compile than any law, is compiled once for each count instead of once for each
/// quantity of each law. One call serves eight nodes, so that its cost is small against that of their exponentials.
template <Real T, std::size_t count>
class PeakFunction {
public:
    virtual TensorLanes<T> operator()(const TensorLanes<T>& excess, T t) const = 0;
    /// The excess of the first kink over its multiple.
    [[nodiscard]] T critical(T t) const requires(count > 0) { return critical_of(t); }
    [[nodiscard]] const std::array<T, count>& kinks() const { return kinks_; }

protected:
    explicit PeakFunction(const std::array<T, count>& kinks) : kinks_(kinks) {}
    ~PeakFunction() = default;

private:
    [[nodiscard]] virtual T critical_of(T t) const = 0;
    std::array<T, count> kinks_;  ///< as multiples of critical(t)
};

template <class F, class T>
inline constexpr std::size_t kink_count = std::tuple_size_v<decltype(detail::kinks_of<T>(std::declval<const F&>()))>;

/// \p F as a PeakFunction.
template <Real T, class F>
class PeakFunctionOf final : public PeakFunction<T, kink_count<F, T>> {
public:
    explicit PeakFunctionOf(const F& f) : PeakFunction<T, kink_count<F, T>>(detail::kinks_of<T>(f)), f_(f) {}
    TensorLanes<T> operator()(const TensorLanes<T>& excess, T t) const override { return f_(excess, t); }

private:
    [[nodiscard]] T critical_of([[maybe_unused]] T t) const override {
        if constexpr (KinkedLaw<F, T>)
            return static_cast<T>(f_.critical(t));
        else
            return T(0);
    }
    const F& f_;
};

/// A quantity of any law as a function of the excess height over sigma and of the curvature over sigma_kappa.
template <Real T, class Law, class F>
struct ScaledLaw {
    const Law& law;
    T rms_height, curvature;  ///< sigma, sigma_kappa
    F f;                      ///< of omega, R, excess and t

    auto operator()(const TensorLanes<T>& excess, T t) const -> TensorLanes<T> {
        return f((rms_height * excess).eval(), 1 / (curvature * t), excess, t);
    }
    /// The law's critical interference [m], where it has a kink; its multiples are the law's too.
    [[nodiscard]] T critical(T t) const requires requires { law.critical(t); }
    { return static_cast<T>(law.critical(1 / (curvature * t))) / rms_height; }
    [[nodiscard]] auto kinks() const requires requires { law.kinks(); }
    { return law.kinks(); }
};

/// \p f of all approaches at once, or of one after the other where it is a function of numbers.
template <Real T, class F>
TensorLanes<T> of_lanes(const TensorLanes<T>& omega, const F& f) {
    if constexpr (requires { f(omega); })
        return f(omega);
    else
        return omega.unaryExpr([&f](T approach) { return static_cast<T>(f(approach)); });
}

/// Load, stiffness, area and -dp/dd of any law; the contacts are left 0. \p mean(f) is the mean of f(omega, R) over the
/// peaks, \p mean_of_area the same for an area, and \p mean_of_loading(f) the slope of the mean of f against -eta.
template <Real T, class Law, class Mean, class MeanOfArea, class MeanOfLoading>
LawSums<T> means_of_law(const Law& law, const PeakScales<T>& scales, Quantity quantities, const Mean& mean,
                        const MeanOfArea& mean_of_area, const MeanOfLoading& mean_of_loading) {
    const T sigma = scales.rms_height, density = scales.peak_density, modulus = scales.effective_modulus;
    // in units of sigma, so that no intermediate result is tiny
    const auto load = [&law, sigma](const TensorLanes<T>& omega, T r) -> TensorLanes<T> {
        return of_lanes(omega, [&](const auto& w) -> decltype(law.load(w, r)) { return law.load(w, r); }) /
               (sigma * sigma);
    };
    const auto stiffness = [&law, sigma](const TensorLanes<T>& omega, T r) -> TensorLanes<T> {
        return of_lanes(omega, [&](const auto& w) -> decltype(law.stiffness(w, r)) { return law.stiffness(w, r); }) /
               sigma;
    };
    const auto area = [&law, sigma](const TensorLanes<T>& omega, T r) -> TensorLanes<T> {
        return of_lanes(omega, [&](const auto& w) -> decltype(law.area(w, r)) { return law.area(w, r); }) /
               (sigma * sigma);
    };
    LawSums<T> out;
    if (has(quantities, Quantity::pressure)) out.load = mean(load) * (modulus * density * sigma * sigma);
    if (has(quantities, Quantity::stiffness)) out.stiffness = mean(stiffness) * (modulus * density * sigma);
    if (has(quantities, Quantity::real_area_fraction)) out.area = mean_of_area(area) * (density * sigma * sigma);
    if (has(quantities, Quantity::loading_stiffness)) out.loading = mean_of_loading(load) * (modulus * density * sigma);
    return out;
}

/// Any law over the joint distribution: an integral in two dimensions for each quantity.
template <Real T, class Law>
requires(!detail::PowerLaw<Law, T>) class LawIntegrator<T, Law, PeakDistribution<T>> {
public:
    LawIntegrator(const Law& law, const PeakDistribution<T>& peaks, const PeakScales<T>& scales, Quantity quantities,
                  T tolerance)
        : law_(law), peaks_(peaks), scales_(scales), mask_(quantities), options_{tolerance_for(tolerance)} {}

    LawSums<T> operator()(T eta) const {
        const T c2 = (1 - peaks_.r()) * (1 + peaks_.r()), r = peaks_.r();
        // an area has whole powers where load and stiffness have half ones
        constexpr NodeClustering axis = detail::axis_of<Law>(),
                                 area_axis = axis == NodeClustering::even ? NodeClustering::graded : axis;
        LawSums<T> out = means_of_law(
            law_, scales_, mask_,
            [&](const auto& f) {
                return mean<axis>(eta, [&](const auto& omega, T radius, const auto&, T) { return f(omega, radius); });
            },
            [&](const auto& f) {
                return mean<area_axis>(eta,
                                       [&](const auto& omega, T radius, const auto&, T) { return f(omega, radius); });
            },
            [&](const auto& load) {
                return mean<axis>(eta, [&](const auto& omega, T radius, const auto& excess, T t) -> TensorLanes<T> {
                    return load(omega, radius) * ((excess + (eta - r * t)) / c2);
                });
            });
        out.log_scale = detail::log_scale_at(eta);
        if (has(mask_, Quantity::contact_density))
            out.contacts = PeakIntegrator<T>({0, absent, absent, absent}, peaks_,
                                             100 * std::numeric_limits<T>::epsilon())(eta)[0] *
                           scales_.peak_density;
        return out;
    }

private:
    static T tolerance_for(T tolerance) { return (std::max)(tolerance, TensorOptions<T>{}.relative_tolerance); }

    template <NodeClustering axis, class F>
    Estimate<T> mean(T eta, const F& f) const {
        const ScaledLaw<T, Law, F> scaled{law_, scales_.rms_height, scales_.curvature, f};
        const PeakFunctionOf<T, ScaledLaw<T, Law, F>> function(scaled);
        return detail::scaled_tensor_integral<axis>(
            static_cast<const PeakFunction<T, kink_count<decltype(scaled), T>>&>(function), peaks_, eta, options_);
    }

    Law law_;
    PeakDistribution<T> peaks_;
    PeakScales<T> scales_;
    Quantity mask_;
    TensorOptions<T> options_;
};

/// Any law over peaks of one radius: an integral over the heights for each quantity, split at the kinks of the law.
template <Real T, class Law>
requires(!detail::PowerLaw<Law, T>) class LawIntegrator<T, Law, SingleRadius<T>> {
public:
    LawIntegrator(const Law& law, const SingleRadius<T>& peaks, const PeakScales<T>& scales, Quantity quantities,
                  T tolerance)
        : law_(law), peaks_(peaks), scales_(scales), mask_(quantities), tolerance_((std::max)(tolerance, T(1e-13))) {}

    LawSums<T> operator()(T eta) const {
        const T sigma = scales_.rms_height, radius = 1 / scales_.curvature, density = scales_.peak_density;
        const auto mean_of = [&](const auto& f) {
            return mean(eta, [&](const TensorLanes<T>& e) -> TensorLanes<T> { return f((sigma * e).eval(), radius); });
        };
        LawSums<T> out = means_of_law(law_, scales_, mask_, mean_of, mean_of, [&](const auto& load) {
            // by parts; exponential heights end at s = 0, where peaks that press already press on
            const bool gaussian = peaks_.heights == Heights::gaussian;
            Estimate<T> loading = mean(eta, [&](const TensorLanes<T>& e) -> TensorLanes<T> {
                const TensorLanes<T> lanes = load((sigma * e).eval(), radius);
                return gaussian ? (lanes * (e + eta)).eval() : lanes;
            });
            if (!gaussian && eta < 0) loading.value -= load((sigma * TensorLanes<T>::Constant(-eta)).eval(), radius)[0];
            return loading;
        });
        const auto [count, log_scale] = peaks_.template scaled_height_moment<0>(eta);
        out.log_scale = log_scale;
        if (has(mask_, Quantity::contact_density))
            out.contacts = {density * count, 16 * std::numeric_limits<T>::epsilon() * density * count, 0};
        return out;
    }

private:
    /// int f(e) phi(eta + e) de without exp(log_scale), from where heights begin.
    template <class F>
    Estimate<T> mean(T eta, const F& f) const {
        const bool gaussian = peaks_.heights == Heights::gaussian;
        const T floor = (std::max)(eta, T(0));
        const auto integrand = [&](const TensorLanes<T>& e) -> TensorLanes<T> {
            if (gaussian)
                return f(e) * ((floor * floor - (eta + e).square()) / 2).exp() *
                       (std::numbers::inv_sqrtpi_v<T> / std::numbers::sqrt2_v<T>);
            return f(e) * (floor - (eta + e)).exp();
        };
        const T reach = gaussian
                            ? (std::max)(-eta, T(0)) + 2 * std::sqrt(-std::log((std::numeric_limits<T>::min)()) / 8)
                            : (std::max)(-eta, T(0)) - std::log(std::numeric_limits<T>::epsilon()) * 2;
        T from = gaussian ? T(0) : (std::max)(-eta, T(0));
        Estimate<T> out;
        const auto add = [&](const Estimate<T>& part) {
            out.value += part.value;
            out.error += part.error;
            out.evaluations += part.evaluations;
        };
        const auto split = [&](T point) {
            if (point <= from || point >= reach) return;
            add(math::integral_over_interval(integrand, from, point, tolerance_));
            from = point;
        };
        if constexpr (requires { law_.critical(T(1)); }) {
            const T critical = static_cast<T>(law_.critical(1 / scales_.curvature)) / scales_.rms_height;
            if constexpr (requires { law_.kinks(); })
                for (const auto& multiple : law_.kinks()) split(critical * static_cast<T>(multiple));
            else
                split(critical);
        }
        if (eta + from < 0) split(-eta);  // the middle of the heights
        add(math::integral_over_half_line(integrand, from, 1 / (1 + (std::max)(eta + from, T(0))), reach, tolerance_));
        return out;
    }

    Law law_;
    SingleRadius<T> peaks_;
    PeakScales<T> scales_;
    Quantity mask_;
    T tolerance_;
};

}}}  // namespace fstiff::detail
