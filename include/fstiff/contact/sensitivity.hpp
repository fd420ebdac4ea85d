// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Derivatives of the stiffness at a given pressure by each parameter, for fits and error bands.
///
///     ln K = ln B + ln J[x,-y](eta),   ln p = ln A + ln J[u,-v](eta)    load ~ omega^u R^v, stiffness ~ omega^x R^y
///     dJ[a,b]/deta   = -a J[a-1,b]                                       (a = 0: the density at eta)
///     dJ[a,b]/dr     = a I[(zeta-eta)^(a-1) d/dt (t^b erf(k t))]         (by parts; b = -1: and its value at t = 0)
///     dJ[a,b]/dtheta = -J[a,b]/theta + dk/dtheta I[(zeta-eta)^a t^b d/dk erf(k t)]
///
/// I has the normal density phi(zeta, t; r) in place of erf(k t) phi. Derivation: docs/theory-numerics.md, section 17.
/// Reference   Plackett, Biometrika 41 (1954) 351-360 (by r); Abramowitz and Stegun, 25.3 (differences)
/// Units       each derivative in Pa/m per unit of its parameter (SI)
/// Valid       as RoughContact; factors and lengths of the law are held but for D. A law without powers: r > 0
/// Accuracy    1e-11 of K per relative change, 1e-10 for r and theta near pi/2, else 1e-8
///             (tests/contact/sensitivity_test.cpp)

#include <fstiff/contact/rough_contact.hpp>
#include <fstiff/core/numbers.hpp>
#include <fstiff/peaks/peak_distribution.hpp>
#include <fstiff/peaks/peak_sums.hpp>
#include <fstiff/peaks/single_radius.hpp>
#include <fstiff/surface/moments.hpp>

#include <numbers>

namespace fstiff { inline namespace v0_1 {

/// K at a pressure and its derivatives at constant pressure.
template <Real T = double>
struct Sensitivity {
    T stiffness{};          ///< K [Pa/m]
    T pressure{};           ///< dK/dp [1/m]
    T rms_height{};         ///< dK/dsigma [Pa/m^2]
    T peak_radius{};        ///< dK/dR [Pa/m^2]
    T peak_density{};       ///< dK/dD_p [Pa m]
    T fractal_dimension{};  ///< dK/dD [Pa/m]; 0 for HertzLaw, NaN for a law that is no DimensionalLaw
    T effective_modulus{};  ///< dK/dE [1/m]
    T r{};                  ///< dK/dr [Pa/m]; 0 for peaks of one radius, as theta
    T theta{};              ///< dK/dtheta [Pa/m per radian]
};

namespace detail {

/// Law with the derivatives of its load and its stiffness by D: d ln/dD, 0 without a D.
template <class Law, class T>
concept DimensionalLaw = requires(const Law& law) {
    { law.log_load_slope() } -> std::convertible_to<T>;
    { law.log_stiffness_slope() } -> std::convertible_to<T>;
};

/// ln K and ln p with their derivatives at constant eta, without the factors of the law.
template <Real T>
struct LogDerivatives {
    struct One {
        T log, eta, r, theta;
    };
    One stiffness, load;
};

/// a F_{a-1} over the factor a (1 where a = 0), a = Twice/2, or its replacement: see scaled_moment.
template <int Twice, Real T>
T lower_moment(T x) {
    if constexpr (Twice == 0)
        return x < 0 ? std::exp(-x * x / 2) : T(1);
    else
        return math::scaled_moment<Twice - 2>(x);
}
template <int Twice, Real T>
inline constexpr T lower_factor = Twice == 0 ? T(1) : T(Twice) / 2;

/// The sums that the derivatives of J[a,b] need.
template <HalfPowers powers, Real T>
struct DerivativeSums {
    T value{}, eta{}, r{}, theta{};

    /// One node: \p moment is F_a, \p lower F_{a-1}, \p erf that of k t with its mass, \p layer its derivative.
    void add(T erf, T layer, T k, T t, T root, T moment, T lower) {
        const T power = powers.radius == 0 ? T(1) : powers.radius == 1 ? root : root * root;  // t^b
        const T with_erf = erf * power;
        T with_r = k * layer * power;
        if (powers.radius > 0) with_r -= with_erf * root * root * (T(powers.radius) / 2);
        value += with_erf * moment;
        eta += with_erf * lower;
        r += with_r * lower;
        theta += layer * t * power * moment;
    }

    /// Boundary term of the integration by parts at t = 0, where t^b erf(k t) is 2 k/sqrt(pi) for b = -1.
    void add_boundary(const PeakProblem<T>& p, T step) {
        if constexpr (powers.radius == 2) {
            const T at_zero = p.eta / p.c, outer = p.floor * p.r / p.c;
            r += 2 * std::numbers::inv_sqrtpi_v<T> * p.k * lower_moment<powers.omega>(at_zero) *
                 std::exp(-outer * outer / 2) / step;
        }
    }

    /// J[a,b] = c^a/(2 theta) step value: the common factors cancel in every logarithmic derivative.
    [[nodiscard]] typename LogDerivatives<T>::One log_derivatives(const PeakProblem<T>& p, T log_factor) const {
        const T inverse_c = 1 / p.c, cosine = std::cos(p.theta);
        const T dk = 1 / (std::numbers::sqrt2_v<T> * cosine * cosine);
        constexpr T factor = lower_factor<powers.omega, T>;
        return {std::log(value) + log_factor + T(powers.omega) / 2 * std::log(p.c), -factor * inverse_c * eta / value,
                factor * inverse_c * r / value, dk * theta / value - 1 / p.theta};
    }
};

/// Those of a load and of a stiffness, over the same nodes.
template <HalfPowers load_powers, HalfPowers stiffness_powers, Real T>
class DerivativeAccumulator {
public:
    explicit DerivativeAccumulator(const PeakProblem<T>& problem) : k_(problem.k) {}

    EIGEN_DONT_INLINE void add(const PeakNodes<T>& nodes) {
        T erf[PeakNodes<T>::capacity], moment[4];
        detail::erf_at(nodes, k_, math::ErfPolynomials::for_tolerance(0), erf);
        std::array<math::Lanes<T, 4>, 8> moments;
        for (int i = 0; i < nodes.size(); ++i) {
            if (i % 8 == 0) math::scaled_moments<math::MomentTable::terms>(nodes.x() + i, moments);
            moments[static_cast<std::size_t>(i % 8)].store(moment);
            const T t = nodes.t()[i], root = nodes.inverse_root()[i], mass = nodes.mass()[i];
            const T layer = mass * 2 * std::numbers::inv_sqrtpi_v<T> * std::exp(-(k_ * t) * (k_ * t));
            const auto add_to = [&]<HalfPowers powers>(DerivativeSums<powers, T>& sums) {
                constexpr int twice = powers.omega;
                T lower{};
                if constexpr (twice >= 2)
                    lower = moment[twice - 2];
                else
                    lower = lower_moment<twice>(nodes.x()[i]);
                sums.add(mass * erf[i], layer, k_, t, root, moment[twice], lower);
            };
            add_to(load);
            add_to(stiffness);
        }
    }

    DerivativeSums<load_powers, T> load;
    DerivativeSums<stiffness_powers, T> stiffness;

private:
    T k_;
};

/// \p eta as in contact_integral, to the last digits. Does not allocate.
template <class Law, Real T>
LogDerivatives<T> log_derivatives(const PeakDistribution<T>& peaks, T eta) {
    const T log_accuracy = -std::log(100 * std::numeric_limits<T>::epsilon());
    const PeakProblem<T> p(peaks, eta, log_accuracy + 5);
    DerivativeAccumulator<Law::load_powers, Law::stiffness_powers, T> sums(p);
    const T step = detail::visit_nodes(p, log_accuracy, sums);
    sums.load.add_boundary(p, step);
    sums.stiffness.add_boundary(p, step);
    const T log_factor = std::log(step / (2 * p.theta)) - p.floor * p.floor / 2;
    return {sums.stiffness.log_derivatives(p, log_factor), sums.load.log_derivatives(p, log_factor)};
}

/// The same for peaks of one radius: closed.
template <class Law, Real T>
LogDerivatives<T> log_derivatives(const SingleRadius<T>& peaks, T eta) {
    const auto d = [&]<int twice>() -> typename LogDerivatives<T>::One {
        const auto [value, log_scale] = peaks.template scaled_height_moment<twice>(eta);
        T lower{};
        if constexpr (twice == 0)
            lower = peaks.density(eta) * std::exp(-log_scale);
        else
            lower = peaks.template scaled_height_moment<twice - 2>(eta).first;
        return {std::log(value) + log_scale, -lower_factor<twice, T> * lower / value, T(0), T(0)};
    };
    return {d.template operator()<Law::stiffness_powers.omega>(), d.template operator()<Law::load_powers.omega>()};
}

/// d ln K/dz and d ln p/dz at constant eta for every parameter z, each times z where z is a scale.
template <Real T>
struct Exponents {
    struct Pair {
        T stiffness, load;
    };
    T k{};  ///< K without interaction [Pa/m]
    Pair eta{}, rms_height{}, peak_radius{}, fractal_dimension{}, r{}, theta{};
};

template <class Law, Real T>
typename Exponents<T>::Pair of_dimension(const Law& law) {
    if constexpr (DimensionalLaw<Law, T>)
        return {static_cast<T>(law.log_stiffness_slope()), static_cast<T>(law.log_load_slope())};
    else
        return {std::numeric_limits<T>::quiet_NaN(), T(0)};
}

/// Exponents by the powers of the law.
template <Real T, PowerLaw<T> Law, class Peaks>
Exponents<T> exponents(const RoughContact<T, Law, Peaks>& contact, T eta) {
    const Roughness<T>& surface = contact.surface();
    const Peaks& peaks = contact.peaks();
    const CurvatureScale scale = contact.options().curvature;
    const LogDerivatives<T> j = log_derivatives<Law>(peaks, eta);
    const PeakScales<T> scales{surface.rms_height, surface.peak_density, contact.effective_modulus(),
                               rms_curvature(surface, peaks, scale)};
    constexpr HalfPowers load = Law::load_powers, stiffness = Law::stiffness_powers;
    Exponents<T> out;
    const T unit = scales.unit(scales.effective_modulus * static_cast<T>(contact.law().stiffness_factor()), stiffness);
    out.k = unit * std::exp(j.stiffness.log);
    out.eta = {j.stiffness.eta, j.load.eta};
    out.rms_height = {T(stiffness.omega) / 2, T(load.omega) / 2};
    out.peak_radius = {T(stiffness.radius) / 2, T(load.radius) / 2};
    out.fractal_dimension = of_dimension<Law, T>(contact.law());
    out.r = {j.stiffness.r, j.load.r};
    out.theta = {j.stiffness.theta, j.load.theta};
    if constexpr (std::same_as<Peaks, PeakDistribution<T>>)
        if (scale == CurvatureScale::consistent) {
            // sigma_kappa = 1/(R E t) depends on theta: d ln E t/dtheta = cot(theta) - 1/theta
            const T curvature = -(std::cos(peaks.theta()) / std::sin(peaks.theta()) - 1 / peaks.theta());
            out.theta.stiffness -= curvature * (T(stiffness.radius) / 2);
            out.theta.load -= curvature * (T(load.radius) / 2);
        }
    return out;
}

/// Exponents by differences of six points, for a law without powers.
template <Real T, class Law, class Peaks>
requires(!PowerLaw<Law, T>) Exponents<T> exponents(const RoughContact<T, Law, Peaks>& contact, T eta) {
    using Pair = typename Exponents<T>::Pair;
    const auto logs = [](const auto& sums, T x) { return Pair{sums.log_stiffness(x).value, sums.log_pressure(x).log}; };
    // \p f of z at a distance; the formula errs by h^6, rounding and the integrals by their errors over h
    const auto slopes = [](T h, const auto& f) -> Pair {
        Pair sum{};
        constexpr std::array<int, 3> weight{45, -9, 1};
        for (int i = 1; i <= 3; ++i) {
            const Pair up = f(T(i) * h), down = f(T(-i) * h);
            const T share = T(weight[static_cast<std::size_t>(i - 1)]) / (60 * h);
            sum.stiffness += share * (up.stiffness - down.stiffness);
            sum.load += share * (up.load - down.load);
        }
        return sum;
    };
    const auto model = [&](const Roughness<T>& surface, const Peaks& peaks) {
        RoughContactOptions<T> options = contact.options();
        options.interaction = {};
        return RoughContact<T, Law, Peaks>(surface, peaks, contact.law(), contact.effective_modulus(), options);
    };
    const Roughness<T>& surface = contact.surface();
    const auto of_surface = [&](T Roughness<T>::*scale) {
        return slopes(T(0.02), [&](T x) {
            Roughness<T> moved = surface;
            moved.*scale *= 1 + x;
            return logs(model(moved, contact.peaks()), eta);
        });
    };
    Exponents<T> out;
    out.k = std::exp(contact.log_stiffness(eta).value);
    out.eta = slopes(T(0.05) / (1 + (std::max)(eta, T(0))), [&](T x) { return logs(contact, eta + x); });
    out.eta.load = contact.log_pressure(eta).slope;
    out.rms_height = of_surface(&Roughness<T>::rms_height);
    out.peak_radius = of_surface(&Roughness<T>::peak_radius);
    out.fractal_dimension = of_dimension<Law, T>(contact.law());
    if constexpr (std::same_as<Peaks, PeakDistribution<T>>) {
        const T r = contact.peaks().r(), theta = contact.peaks().theta();
        out.r =
            slopes(T(0.03) * (std::min)(r, 1 - r), [&](T x) { return logs(model(surface, Peaks(r + x, theta)), eta); });
        out.theta = slopes(T(0.03) * (std::min)(theta, std::numbers::pi_v<T> / 2 - theta),
                           [&](T x) { return logs(model(surface, Peaks(r, theta + x)), eta); });
    }
    return out;
}

}  // namespace detail

/// K of \p contact and its derivatives at the nominal pressure \p pressure [Pa]. With interaction the bulk is in
/// series, 1/K' = 1/K + L/(E f), and L is held. Does not allocate for a law with powers; others take differences of six
/// points. \throws domain_error as at_pressure of the contact, and for interaction as_printed.
template <Real T, class Law, class Peaks>
[[nodiscard]] Sensitivity<T> sensitivity(const RoughContact<T, Law, Peaks>& contact, std::type_identity_t<T> pressure) {
    const InteractionReading reading = contact.interaction().reading;
    detail::require(reading != InteractionReading::as_printed, "interaction", T(2),
                    "none or effective_separation for a derivative");
    const T eta = contact.at_pressure(pressure, Quantity::pressure).eta;
    const detail::Exponents<T> exponents = detail::exponents(contact, eta);
    const T k = exponents.k, modulus = contact.effective_modulus();
    const T follow = exponents.eta.stiffness / exponents.eta.load;  // d ln K / d ln p along the curve
    const auto at_constant_pressure = [&](const typename detail::Exponents<T>::Pair& z) {
        return k * (z.stiffness - follow * z.load);
    };
    Sensitivity<T> out;
    out.stiffness = k;
    out.pressure = k * follow / pressure;
    out.rms_height = at_constant_pressure(exponents.rms_height) / contact.surface().rms_height;
    out.peak_radius = at_constant_pressure(exponents.peak_radius) / contact.surface().peak_radius;
    out.peak_density = at_constant_pressure({T(1), T(1)}) / contact.surface().peak_density;
    out.effective_modulus = at_constant_pressure({T(1), T(1)}) / modulus;
    out.fractal_dimension = at_constant_pressure(exponents.fractal_dimension);
    out.r = at_constant_pressure(exponents.r);
    out.theta = at_constant_pressure(exponents.theta);
    if (reading == InteractionReading::none) return out;
    T ratio = 1;
    if constexpr (RoughContact<T, Law, Peaks>::stiffness_follows_slope) ratio = contact.stiffness_over_slope();
    const T compliance = contact.bulk_compliance() / ratio;
    const T share = 1 / (1 + k * compliance);  // K'/K
    for (T* slope : {&out.pressure, &out.rms_height, &out.peak_radius, &out.peak_density, &out.fractal_dimension,
                     &out.effective_modulus, &out.r, &out.theta})
        *slope *= share * share;
    out.stiffness = k * share;
    const T of_bulk = out.stiffness * out.stiffness * compliance;
    out.effective_modulus += of_bulk / modulus;
    if constexpr (RoughContact<T, Law, Peaks>::stiffness_follows_slope)
        out.fractal_dimension += of_bulk * (exponents.fractal_dimension.stiffness - exponents.fractal_dimension.load);
    return out;
}

}}  // namespace fstiff
