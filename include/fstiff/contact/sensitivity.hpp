// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// How the stiffness at a given pressure depends on each parameter: what a fit to measurements and an error band need.
///
///     ln K = ln B + ln J[1/2,-1/2](eta),   ln p = ln A + ln J[3/2,-1/2](eta)
///     d ln K/dx = d ln B/dx + d ln J[1/2]/dx - (J[1/2]'/J[1/2]) (J[3/2]/J[3/2]') (d ln A/dx + d ln J[3/2]/dx)
///
/// at constant p. The derivatives of the integrals are integrals of the same kind, over the same nodes:
///
///     dJ[a,b]/deta   = -a J[a-1,b]
///     dJ[a,b]/dr     = a I[(zeta-eta)^(a-1) d/dt (t^b erf(k t))]          (d phi/dr = d^2 phi/dzeta dt, by parts twice)
///     dJ[a,b]/dtheta = -J[a,b]/theta + dk/dtheta I[(zeta-eta)^a t^b d/dk erf(k t)]
///
/// where I is the integral with the normal density phi(zeta, t; r) of correlation r in place of erf(k t) phi.
///
/// Reference   Plackett, Biometrika 41 (1954) 351-360 (the derivative with respect to r).
/// Units       each derivative in Pa/m per unit of its parameter (SI)
/// Accuracy    1e-11 of K per relative change of the parameter, 1e-10 for r and theta near pi/2
///             (tests/contact/sensitivity_test.cpp)

#include <fstiff/contact/peak_sums.hpp>
#include <fstiff/contact/rough_contact.hpp>
#include <fstiff/core/concepts.hpp>
#include <fstiff/core/numbers.hpp>
#include <fstiff/surface/roughness.hpp>

#include <array>
#include <cmath>

namespace fstiff {

/// K at a pressure and its derivatives at constant pressure.
template <Real T>
struct Sensitivity {
    T stiffness{};          ///< K [Pa/m]
    T pressure{};           ///< dK/dp [1/m]
    T rms_height{};         ///< dK/dsigma [Pa/m^2]
    T peak_radius{};        ///< dK/dR [Pa/m^2]
    T peak_density{};       ///< dK/dD_p [Pa m]
    T fractal_dimension{};  ///< dK/dD [Pa/m]; 0 for HertzLaw
    T effective_modulus{};  ///< dK/dE [1/m]
    T r{};                  ///< dK/dr [Pa/m]
    T theta{};              ///< dK/dtheta [Pa/m per radian]
};

namespace detail {

/// ln J[1/2,-1/2] and ln J[3/2,-1/2] with their derivatives against eta, r and theta.
template <Real T>
struct LogDerivatives {
    struct One {
        T log, eta, r, theta;
    };
    One stiffness, load;
};

/// The seven sums that the derivatives need, over b = -1/2.
template <Real T>
class DerivativeAccumulator {
public:
    enum Sum { j_minus, j_half, j_three, r_half, r_three, theta_half, theta_three, sums };

    explicit DerivativeAccumulator(const PeakProblem<T>& problem) : k_(problem.k) {}

    EIGEN_DONT_INLINE void add(const PeakNodes<T>& nodes) {
        T erf[PeakNodes<T>::capacity], moment[4];
        erf_at(nodes, k_, ErfPolynomials<T>::for_tolerance(0), erf);
        std::array<Lanes<T, 4>, 8> moments;
        for (int i = 0; i < nodes.size(); ++i) {
            if (i % 8 == 0) scaled_moments<MomentTable<T>::terms>(nodes.x() + i, moments);
            moments[static_cast<std::size_t>(i % 8)].store(moment);
            const T t = nodes.t()[i], root = nodes.inverse_root()[i], mass = nodes.mass()[i];
            const T minus = scaled_moment<-1>(nodes.x()[i]), half = moment[1], three = moment[3];
            // erf'(y), and t^(1/2) d/dt (t^(-1/2) erf(k t)) = k erf'(k t) - erf(k t)/(2 t)
            const T layer = mass * 2 * numbers::inv_sqrtpi_v<T> * std::exp(-(k_ * t) * (k_ * t));
            const T with_erf = mass * erf[i] * root;
            const T with_r = k_ * layer * root - with_erf * root * root / 2;
            const T with_theta = layer * t * root;
            const T term[sums]{with_erf * minus, with_erf * half,   with_erf * three,  with_r * minus,
                               with_r * half,    with_theta * half, with_theta * three};
            for (std::size_t j = 0; j < sums; ++j) sum_[j] += term[j];
        }
    }

    [[nodiscard]] T total(Sum which) const { return sum_[which]; }

private:
    T k_;
    std::array<T, sums> sum_{};
};

/// \p eta as in contact_integral, to the last digits. Does not allocate.
template <Real T>
LogDerivatives<T> log_derivatives(const PeakDensity<T>& peaks, T eta) {
    const T digits = -std::log(100 * std::numeric_limits<T>::epsilon());
    const PeakProblem<T> p(peaks, eta, digits + 5);
    using Sums = DerivativeAccumulator<T>;
    Sums sums(p);
    const T step = visit_nodes(p, digits, sums);
    const T half = sums.total(Sums::j_half), three = sums.total(Sums::j_three);
    const T inverse_c = 1 / p.c;
    const T cosine = std::cos(p.theta);
    const T dk = 1 / (numbers::sqrt2_v<T> * cosine * cosine);
    // J[a,b] = c^a/(2 theta) step sum: the common factors cancel in every logarithmic derivative
    const T log_factor = std::log(step / (2 * p.theta)) - p.floor * p.floor / 2;
    const T log_c = std::log(p.c);
    return {
        {std::log(half) + log_factor + log_c / 2, T(-0.5) * inverse_c * sums.total(Sums::j_minus) / half,
         T(0.5) * inverse_c * sums.total(Sums::r_half) / half, dk * sums.total(Sums::theta_half) / half - 1 / p.theta},
        {std::log(three) + log_factor + T(1.5) * log_c, T(-1.5) * inverse_c * half / three,
         T(1.5) * inverse_c * sums.total(Sums::r_three) / three,
         dk * sums.total(Sums::theta_three) / three - 1 / p.theta}};
}

}  // namespace detail

/// K and its derivatives at the nominal pressure \p pressure [Pa]; with \p interaction the bulk is in series as in RoughContact.
/// Does not allocate. \throws domain_error as RoughContact and its at_pressure, and for the reading as_printed.
template <Real T, PowerLaw Law>
[[nodiscard]] Sensitivity<T> sensitivity(const Roughness<T>& surface, const PeakDensity<T>& peaks, const Law& law,
                                         T effective_modulus, T pressure, CurvatureScale scale = {},
                                         const Interaction<T>& interaction = {}) {
    interaction.validate();
    require(interaction.reading != InteractionReading::as_printed, "interaction", T(2),
            "none or effective_separation for a derivative");
    const RoughContact<T, Law> contact(surface, peaks, law, effective_modulus, {.curvature = scale});
    const T eta = contact.at_pressure(pressure, Quantity::pressure).eta;
    const auto j = detail::log_derivatives(peaks, eta);
    const T product = surface.rms_height * rms_curvature(surface, peaks, scale);  // sigma sigma_kappa
    const T k = effective_modulus * law.stiffness_factor() * surface.peak_density * surface.rms_height /
                std::sqrt(product) * std::exp(j.stiffness.log);
    const T follow = j.stiffness.eta / j.load.eta;  // d ln K / d ln p along the curve
    // d ln K/dx from d ln A/dx and d ln B/dx, the derivatives of the integrals included
    const auto at_constant_pressure = [&](T load, T stiffness) { return k * (stiffness - follow * load); };
    // sigma_kappa = 1/(R E t) depends on theta: d ln E t/dtheta = cot(theta) - 1/theta
    const T curvature = scale == CurvatureScale::consistent
                            ? -(std::cos(peaks.theta()) / std::sin(peaks.theta()) - 1 / peaks.theta())
                            : T(0);
    Sensitivity<T> out;
    out.stiffness = k;
    out.pressure = k * follow / pressure;
    out.rms_height = at_constant_pressure(T(1.5), T(0.5)) / surface.rms_height;
    out.peak_radius = at_constant_pressure(T(0.5), T(0.5)) / surface.peak_radius;
    out.peak_density = at_constant_pressure(T(1), T(1)) / surface.peak_density;
    out.effective_modulus = at_constant_pressure(T(1), T(1)) / effective_modulus;
    out.fractal_dimension = at_constant_pressure(law.log_load_slope(), law.log_stiffness_slope());
    out.r = at_constant_pressure(j.load.r, j.stiffness.r);
    out.theta = at_constant_pressure(j.load.theta - curvature / 2, j.stiffness.theta - curvature / 2);
    if (interaction.reading == InteractionReading::effective_separation) {
        // 1/K' = 1/K + L/(E rho), rho = K over -dp/dd without interaction (RoughContact), which depends on D alone
        const T compliance = interaction.length / (effective_modulus * contact.stiffness_over_slope());
        const T share = 1 / (1 + k * compliance);  // K'/K
        for (T* slope : {&out.pressure, &out.rms_height, &out.peak_radius, &out.peak_density, &out.fractal_dimension,
                         &out.effective_modulus, &out.r, &out.theta})
            *slope *= share * share;
        out.stiffness = k * share;
        const T of_bulk = out.stiffness * out.stiffness * compliance;
        out.effective_modulus += of_bulk / effective_modulus;
        out.fractal_dimension += of_bulk * (law.log_stiffness_slope() - law.log_load_slope());
    }
    return out;
}

}  // namespace fstiff
