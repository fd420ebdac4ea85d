// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// What the asperities of a surface carry together: a law of one asperity summed over a distribution of peaks.
///
///     p = E D_p <load>,  K = E D_p <stiffness>,  A = D_p <area>,  n = D_p <1>,  -dp/dd
///
/// <f> is the mean over all peaks, those below the separation counting 0. With omega = sigma (zeta - eta), R = 1/(sigma_kappa t):
///
///     power law       <omega^x R^y> = sigma^x sigma_kappa^-y J[x,-y],  d/deta J[a,b] = -a J[a-1,b]     one dimension
///     any other       I[f] of contact/tensor_integrals.hpp; -dI[f]/deta = I[f (zeta - r t)/c^2]           (by parts)
///     peaks of one R  <omega^x R^y> = sigma^x R^y G_x(eta)                                                closed
///
/// Which of them is chosen when the contact is compiled. A quantity whose powers are those of another costs nothing more.
///
/// Reference   Buczkowski, Kleiber, Starzynski, Arch. Mech. 66 (2014), eqs. (4.5)-(4.9).
/// Units       SI; load/E [m^2], stiffness/E [m], area [m^2] of the law
/// Valid       as the integrals that are called
/// Accuracy    that of the integrals that are called (tests/contact/any_law_test.cpp)

#include <fstiff/asperity/laws.hpp>
#include <fstiff/contact/contact_integrals.hpp>
#include <fstiff/contact/quantity.hpp>
#include <fstiff/contact/tensor_integrals.hpp>
#include <fstiff/core/estimate.hpp>
#include <fstiff/core/numbers.hpp>
#include <fstiff/math/double_exponential.hpp>
#include <fstiff/peaks/peak_density.hpp>
#include <fstiff/peaks/single_radius.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace fstiff {

/// A law that any contact takes: given its powers, or as functions of an array of approaches and a radius.
template <class Law, class T>
concept ContactableLaw = PowerLaw<Law, T> || AsperityLaw<Law, Eigen::Array<T, 8, 1>, T>;

namespace detail {

/// The sums over the peaks per nominal area, each times exp(log_scale); what is not asked for is 0.
template <Real T>
struct LawSums {
    Estimate<T> contacts;   ///< [1/m^2]
    Estimate<T> load;       ///< [Pa]
    Estimate<T> stiffness;  ///< [Pa/m]
    Estimate<T> area;       ///< over the nominal area
    Estimate<T> loading;    ///< -dp/dd [Pa/m]
    T log_scale{};
};

/// What turns dimensionless means into SI.
template <Real T>
struct PeakScales {
    T rms_height, peak_density, effective_modulus;
    T curvature;  ///< sigma_kappa, or 1/R for peaks of one radius [1/m]

    /// factor D_p sigma^(omega/2) curvature^(-radius/2): of the mean of a law of these powers over the peaks. Written with
    /// sigma times the curvature, which is dimensionless.
    [[nodiscard]] T of(T factor, HalfPowers powers) const {
        const T product = rms_height * curvature;
        const int lengths = powers.omega + powers.radius;  // of 1/2 each
        T scale = lengths >= 4 ? factor * (peak_density * rms_height * rms_height)
                               : factor * peak_density * (lengths >= 2 ? rms_height : T(1));
        if (lengths % 2 == 1) scale *= std::sqrt(rms_height);
        return powers.radius == 0 ? scale : scale / (powers.radius == 1 ? std::sqrt(product) : product);
    }
};

/// Factor and powers of one quantity of a power law.
template <Real T>
struct PowerTerm {
    Quantity quantity;
    HalfPowers powers;
    T scale;  ///< of the mean of these powers
};

/// The five quantities of a power law.
template <Real T, class Law>
std::array<PowerTerm<T>, 5> power_terms(const Law& law, const PeakScales<T>& scales) {
    const T modulus = scales.effective_modulus;
    constexpr HalfPowers load = Law::load_powers;
    const auto load_factor = static_cast<T>(law.load_factor());
    const HalfPowers slope{load.omega - 2, load.radius};
    const auto term = [&](Quantity quantity, HalfPowers powers, T factor) {
        return PowerTerm<T>{quantity, powers, scales.of(factor, powers)};
    };
    return {term(Quantity::contacts, {0, 0}, T(1)), term(Quantity::pressure, load, modulus * load_factor),
            term(Quantity::stiffness, Law::stiffness_powers, modulus * static_cast<T>(law.stiffness_factor())),
            term(Quantity::real_area, Law::area_powers, static_cast<T>(law.area_factor())),
            // per length: the slope against eta over sigma
            term(Quantity::loading_stiffness, slope, modulus * (T(load.omega) / 2 * load_factor))};
}

template <Real T>
Estimate<T>& member_of(LawSums<T>& sums, Quantity quantity) {
    switch (quantity) {
        case Quantity::contacts:
            return sums.contacts;
        case Quantity::pressure:
            return sums.load;
        case Quantity::stiffness:
            return sums.stiffness;
        case Quantity::real_area:
            return sums.area;
        default:
            return sums.loading;
    }
}

/// Sums at separation after separation, of a law and a distribution of peaks.
template <Real T, class Law, class Peaks>
class LawIntegrator;

/// A power law over the joint distribution of height and curvature: one pass over the nodes for each set of distinct powers
/// of omega.
template <Real T, PowerLaw<T> Law>
class LawIntegrator<T, Law, PeakDensity<T>> {
public:
    LawIntegrator(const Law& law, const PeakDensity<T>& peaks, const PeakScales<T>& scales, Quantity wanted,
                  T tolerance)
        : terms_(power_terms(law, scales)) {
        constexpr PowerSet nothing{absent, absent, absent, absent};
        std::array<PowerSet, passes> sets;
        sets.fill(nothing);
        for (std::size_t i = 0; i < terms_.size(); ++i) {
            pass_[i] = passes;
            if (!has(wanted, terms_[i].quantity)) continue;
            const auto omega = static_cast<std::size_t>(terms_[i].powers.omega);
            const int radius = terms_[i].powers.radius;
            pass_[i] = 0;
            while (sets[pass_[i]][omega] != absent && sets[pass_[i]][omega] != radius) ++pass_[i];
            sets[pass_[i]][omega] = radius;
        }
        for (std::size_t pass = 0; pass < passes; ++pass)
            if (pass == 0 || sets[pass] != nothing) integrators_[pass].emplace(sets[pass], peaks, tolerance);
    }

    LawSums<T> operator()(T eta) {
        LawSums<T> out;
        for (std::size_t pass = 0; pass < passes && integrators_[pass]; ++pass) {
            const ScaledIntegrals<T> j = (*integrators_[pass])(eta);
            out.log_scale = j.log_scale;
            for (std::size_t i = 0; i < terms_.size(); ++i)
                if (pass_[i] == pass)
                    member_of(out, terms_[i].quantity) =
                        j.of_power[static_cast<std::size_t>(terms_[i].powers.omega)] * terms_[i].scale;
        }
        return out;
    }

private:
    static constexpr std::size_t passes = 3;  ///< as many as powers of R, all of which one power of omega may have
    std::array<PowerTerm<T>, 5> terms_;
    std::array<std::size_t, 5> pass_{};  ///< of each term; `passes` where it is not wanted
    std::array<std::optional<PeakIntegrator<T>>, passes> integrators_;
};

/// A power law over peaks of one radius: closed.
template <Real T, PowerLaw<T> Law>
class LawIntegrator<T, Law, SingleRadius<T>> {
public:
    LawIntegrator(const Law& law, const SingleRadius<T>& peaks, const PeakScales<T>& scales, Quantity wanted, T)
        : terms_(power_terms(law, scales)), peaks_(peaks), wanted_(wanted) {}

    LawSums<T> operator()(T eta) const {
        constexpr T rounding = 16 * std::numeric_limits<T>::epsilon();
        LawSums<T> out;
        const auto add = [&]<int Omega>(std::size_t i) {
            const auto [value, log_scale] = peaks_.template scaled_height_moment<Omega>(eta);
            out.log_scale = log_scale;
            member_of(out, terms_[i].quantity) = {terms_[i].scale * value, rounding * terms_[i].scale * value, 0};
        };
        for (std::size_t i = 0; i < terms_.size(); ++i) {
            if (!has(wanted_, terms_[i].quantity)) continue;
            const int omega = terms_[i].powers.omega;
            if (omega == 0) add.template operator()<0>(i);
            if (omega == 1) add.template operator()<1>(i);
            if (omega == 2) add.template operator()<2>(i);
            if (omega == 3) add.template operator()<3>(i);
        }
        return out;
    }

private:
    std::array<PowerTerm<T>, 5> terms_;
    SingleRadius<T> peaks_;
    Quantity wanted_;
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

template <class Law>
constexpr Axis axis_of() {
    if constexpr (requires { Law::axis; })
        return Law::axis;
    else
        return Axis::graded;
}

/// Any law over the joint distribution: an integral in two dimensions for each quantity.
template <Real T, class Law>
requires(!PowerLaw<Law, T>) class LawIntegrator<T, Law, PeakDensity<T>> {
public:
    LawIntegrator(const Law& law, const PeakDensity<T>& peaks, const PeakScales<T>& scales, Quantity wanted,
                  T tolerance)
        : law_(law), peaks_(peaks), scales_(scales), wanted_(wanted), options_{tolerance_for(tolerance)} {}

    LawSums<T> operator()(T eta) const {
        const T sigma = scales_.rms_height, density = scales_.peak_density;
        const T modulus = scales_.effective_modulus;
        LawSums<T> out;
        const T floor = std::max(eta, T(0));
        out.log_scale = -floor * floor / 2;
        // in units of sigma, so that no intermediate result is tiny
        const auto load = [this, sigma](const auto& omega, T radius) -> TensorLanes<T> {
            return law_.load(omega, radius) / (sigma * sigma);
        };
        if (has(wanted_, Quantity::contacts))
            out.contacts =
                PeakIntegrator<T>({0, absent, absent, absent}, peaks_, 100 * std::numeric_limits<T>::epsilon())(eta)
                    .of_power[0] *
                density;
        if (has(wanted_, Quantity::pressure))
            out.load = mean(eta, [&](const auto& omega, T radius, const auto&, T) { return load(omega, radius); }) *
                       (modulus * density * sigma * sigma);
        if (has(wanted_, Quantity::stiffness))
            out.stiffness = mean(eta,
                                 [&](const auto& omega, T radius, const auto&, T) -> TensorLanes<T> {
                                     return law_.stiffness(omega, radius) / sigma;
                                 }) *
                            (modulus * density * sigma);
        if (has(wanted_, Quantity::real_area))
            // an area has whole powers where load and stiffness have half ones
            out.area = mean < axis_of<Law>() == Axis::even
                           ? Axis::graded
                           : axis_of<Law>() > (eta, [&](const auto& omega, T radius, const auto&, T) -> TensorLanes<T> {
                                                  return law_.area(omega, radius) / (sigma * sigma);
                                              }) * (density * sigma * sigma);
        if (has(wanted_, Quantity::loading_stiffness)) {
            const T c2 = (1 - peaks_.r()) * (1 + peaks_.r()), r = peaks_.r();
            out.loading = mean(eta,
                               [&](const auto& omega, T radius, const auto& excess, T t) -> TensorLanes<T> {
                                   return load(omega, radius) * ((excess + (eta - r * t)) / c2);
                               }) *
                          (modulus * density * sigma);
        }
        return out;
    }

private:
    static T tolerance_for(T tolerance) { return std::max(tolerance, TensorOptions<T>{}.relative_tolerance); }

    template <Axis axis = axis_of<Law>(), class F>
    Estimate<T> mean(T eta, const F& f) const {
        const ScaledLaw<T, Law, F> scaled{law_, scales_.rms_height, scales_.curvature, f};
        return scaled_tensor_integral<axis>(scaled, peaks_, eta, options_);
    }

    Law law_;
    PeakDensity<T> peaks_;
    PeakScales<T> scales_;
    Quantity wanted_;
    TensorOptions<T> options_;
};

/// Any law over peaks of one radius: an integral over the heights for each quantity, split at the kinks of the law.
template <Real T, class Law>
requires(!PowerLaw<Law, T>) class LawIntegrator<T, Law, SingleRadius<T>> {
public:
    LawIntegrator(const Law& law, const SingleRadius<T>& peaks, const PeakScales<T>& scales, Quantity wanted,
                  T tolerance)
        : law_(law), peaks_(peaks), scales_(scales), wanted_(wanted), tolerance_(std::max(tolerance, T(1e-13))) {}

    LawSums<T> operator()(T eta) const {
        const T sigma = scales_.rms_height, radius = 1 / scales_.curvature, density = scales_.peak_density;
        const T modulus = scales_.effective_modulus;
        LawSums<T> out;
        const auto [count, log_scale] = peaks_.template scaled_height_moment<0>(eta);
        out.log_scale = log_scale;
        const auto load = [&](const TensorLanes<T>& e) -> TensorLanes<T> {
            return law_.load((sigma * e).eval(), radius) / (sigma * sigma);
        };
        if (has(wanted_, Quantity::contacts))
            out.contacts = {density * count, 16 * std::numeric_limits<T>::epsilon() * density * count, 0};
        if (has(wanted_, Quantity::pressure)) out.load = mean(eta, load) * (modulus * density * sigma * sigma);
        if (has(wanted_, Quantity::stiffness))
            out.stiffness = mean(eta,
                                 [&](const TensorLanes<T>& e) -> TensorLanes<T> {
                                     return law_.stiffness((sigma * e).eval(), radius) / sigma;
                                 }) *
                            (modulus * density * sigma);
        if (has(wanted_, Quantity::real_area))
            out.area = mean(eta,
                            [&](const TensorLanes<T>& e) -> TensorLanes<T> {
                                return law_.area((sigma * e).eval(), radius) / (sigma * sigma);
                            }) *
                       (density * sigma * sigma);
        if (has(wanted_, Quantity::loading_stiffness)) {
            // by parts; exponential heights end at s = 0, where peaks that press already press on
            const bool gaussian = peaks_.heights == Heights::gaussian;
            out.loading = mean(eta, [&](const TensorLanes<T>& e) -> TensorLanes<T> {
                return gaussian ? (load(e) * (e + eta)).eval() : load(e);
            });
            if (!gaussian && eta < 0) out.loading.value -= load(TensorLanes<T>::Constant(-eta))[0];
            out.loading = out.loading * (modulus * density * sigma);
        }
        return out;
    }

private:
    /// int f(e) phi(eta + e) de without exp(log_scale), from where heights begin.
    template <class F>
    Estimate<T> mean(T eta, const F& f) const {
        const bool gaussian = peaks_.heights == Heights::gaussian;
        const T floor = std::max(eta, T(0));
        const auto integrand = [&](const TensorLanes<T>& e) -> TensorLanes<T> {
            if (gaussian)
                return f(e) * ((floor * floor - (eta + e).square()) / 2).exp() *
                       (numbers::inv_sqrtpi_v<T> / numbers::sqrt2_v<T>);
            return f(e) * (floor - (eta + e)).exp();
        };
        const T reach = gaussian ? std::max(-eta, T(0)) + 2 * std::sqrt(-std::log(std::numeric_limits<T>::min()) / 8)
                                 : std::max(-eta, T(0)) - std::log(std::numeric_limits<T>::epsilon()) * 2;
        T from = gaussian ? T(0) : std::max(-eta, T(0));
        Estimate<T> out;
        const auto add = [&](const Estimate<T>& part) {
            out.value += part.value;
            out.error += part.error;
            out.evaluations += part.evaluations;
        };
        const auto split = [&](T at) {
            if (at <= from || at >= reach) return;
            add(integral_over_interval(integrand, from, at, tolerance_));
            from = at;
        };
        if constexpr (requires { law_.critical(T(1)); }) {
            const T critical = static_cast<T>(law_.critical(1 / scales_.curvature)) / scales_.rms_height;
            if constexpr (requires { law_.kinks(); })
                for (const auto& multiple : law_.kinks()) split(critical * static_cast<T>(multiple));
            else
                split(critical);
        }
        if (eta + from < 0) split(-eta);  // the middle of the heights
        add(integral_over_half_line(integrand, from, 1 / (1 + std::max(eta + from, T(0))), reach, tolerance_));
        return out;
    }

    Law law_;
    SingleRadius<T> peaks_;
    PeakScales<T> scales_;
    Quantity wanted_;
    T tolerance_;
};

}  // namespace detail
}  // namespace fstiff
