// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Load, area and stiffness of one asperity of radius R that yields, pressed in by omega: three laws.
///
///     PlasticLaw       load H area,  area 2 pi R omega            s = omega/omega_c, omega_c: first yield
///     JacksonGreenLaw  Hertz for s < 1.9, beyond it a fit to finite elements with a hardness that falls with a/R
///     KogutEtsionLaw   powers of s in four ranges: s < 1, < 6, < 110, beyond
///     all              stiffness 2 sqrt(area/pi) on unloading, as a wave sees it; the slope of the load is another
///
/// Load and stiffness are divided by E. The fits jump by up to 8 % at their ends: docs/theory-contact.md, section 3.
/// Reference   Abbott, Firestone, Mech. Eng. 55 (1933) 569; Jackson, Green, J. Tribol. 127 (2005) 343, 141 (2019)
///             031402, (28); Kogut, Etsion, J. Appl. Mech. 69 (2002) 657; Pharr et al., J. Mater. Res. 7 (1992) 613
/// Units       omega, R [m]; load/E [m^2], stiffness/E [m], area [m^2]; moduli, Y and H [Pa]
/// Valid       omega >= 0, R > 0; PlasticLaw s >= 110, a/R <= 0.4; JacksonGreenLaw a/R <= 0.41; KogutEtsionLaw s <= 110
/// Accuracy    1e-13 relative (tests/asperity/plastic_laws_test.cpp)

#include <fstiff/asperity/laws.hpp>
#include <fstiff/core/error.hpp>
#include <fstiff/core/names.hpp>

#include <numbers>

namespace fstiff { inline namespace v0_1 {

/// Constants of the softer of the two bodies, and the modulus of their contact.
template <Real T = double>
struct PlasticMaterial {
    T effective_modulus{};  ///< E of the contact [Pa]
    T yield_strength{};     ///< Y of the softer body [Pa]
    T poisson_ratio{};      ///< nu of the softer body
    T hardness{};           ///< H of the softer body [Pa]; 0: 2.8 Y (Tabor)

    [[nodiscard]] constexpr T hardness_or_default() const { return hardness > 0 ? hardness : T(2.8) * yield_strength; }

    /// \throws domain_error naming the constant that is out of range.
    constexpr void validate() const {
        detail::require_positive("effective_modulus", effective_modulus);
        detail::require_positive("yield_strength", yield_strength);
        detail::require(poisson_ratio > T(-1) && poisson_ratio <= T(0.5), "poisson_ratio", poisson_ratio,
                        "greater than -1 and at most 0.5");
        if (hardness != T(0)) detail::require_positive("hardness", hardness);
    }
};

/// All peaks yield: the mean pressure of every contact is the hardness.
template <Real T = double>
class PlasticLaw {
public:
    static constexpr HalfPowers load_powers{2, 2}, stiffness_powers{1, 1}, area_powers{2, 2};

    /// Takes the hardness H and the effective modulus E [Pa]. \throws domain_error unless both are finite and positive.
    constexpr PlasticLaw(T hardness, T effective_modulus)
        : hardness_(hardness), load_factor_(2 * std::numbers::pi_v<T> * (hardness / effective_modulus)) {
        detail::require_positive("hardness", hardness);
        detail::require_positive("effective_modulus", effective_modulus);
    }

    [[nodiscard]] constexpr T load_factor() const { return load_factor_; }
    [[nodiscard]] static constexpr T stiffness_factor() { return 2 * std::numbers::sqrt2_v<T>; }
    [[nodiscard]] static constexpr T area_factor() { return 2 * std::numbers::pi_v<T>; }
    /// Nominal pressures stay below the hardness, at which all of the nominal area is in contact [Pa].
    [[nodiscard]] constexpr T pressure_limit() const { return hardness_; }

    template <class Omega, class Radius>
    [[nodiscard]] auto load(const Omega& omega, const Radius& radius) const {
        return load_factor_ * radius * omega;
    }
    template <class Omega, class Radius>
    [[nodiscard]] auto stiffness(const Omega& omega, const Radius& radius) const {
        using std::sqrt;
        return stiffness_factor() * sqrt(radius * omega);
    }
    template <class Omega, class Radius>
    [[nodiscard]] auto area(const Omega& omega, const Radius& radius) const {
        return area_factor() * radius * omega;
    }

private:
    T hardness_, load_factor_;
};

namespace detail {

/// \p law at each of \p omega, numbers or an Eigen array of them: a law in pieces has no common formula.
template <class Omega, class Law>
[[nodiscard]] auto each(const Omega& omega, const Law& law) {
    if constexpr (requires { omega.size(); }) {
        typename Omega::PlainObject out(omega.rows(), omega.cols());
        for (decltype(omega.size()) i = 0; i < omega.size(); ++i) out(i) = law(omega(i));
        return out;
    } else {
        return law(omega);
    }
}

/// The stiffness of unloading, from the area.
template <class Derived>
struct UnloadsElastically {
    template <class Omega, class Radius>
    [[nodiscard]] auto stiffness(const Omega& omega, const Radius& radius) const {
        return each(omega, [&](auto w) {
            using T = decltype(w);
            using std::sqrt;
            return 2 *
                   sqrt(static_cast<const Derived&>(*this).area_of(w, static_cast<T>(radius)) / std::numbers::pi_v<T>);
        });
    }
    template <class Omega, class Radius>
    [[nodiscard]] auto load(const Omega& omega, const Radius& radius) const {
        return each(omega, [&](auto w) {
            return static_cast<const Derived&>(*this).load_of(w, static_cast<decltype(w)>(radius));
        });
    }
    template <class Omega, class Radius>
    [[nodiscard]] auto area(const Omega& omega, const Radius& radius) const {
        return each(omega, [&](auto w) {
            return static_cast<const Derived&>(*this).area_of(w, static_cast<decltype(w)>(radius));
        });
    }
};

}  // namespace detail

/// Fall of the hardness as a contact grows, in JacksonGreenLaw.
enum class HardnessLaw {
    cosine,   ///< H_G/Y = 2.84 - 0.92 (1 - cos(pi a/R))
    exponent  ///< H_G/Y = 2.84 (1 - exp(-0.82 (a/R)^-0.7)), of 2005
};

template <>
inline constexpr auto enum_names<HardnessLaw> = detail::name_list<HardnessLaw>({{HardnessLaw::cosine, "cosine"},
                                                                                {HardnessLaw::exponent, "2005"}});

/// One asperity by Jackson and Green: elastic, then elastic-plastic, with a hardness that falls as the contact grows.
///
///     load   s < 1.9: Hertz; else P_c [exp(-s^(5/12)/4) s^(3/2) + 4 H_G/(C Y) (1 - exp(-s^(5/9)/25)) s]
///     area   pi R omega, times (s/1.9)^B from s = 1.9 on,  B = 0.14 exp(23 Y/E),  s = omega/omega_c
///     omega_c = (pi C Y/(2E))^2 R,  C = 1.295 exp(0.736 nu),  P_c = (4/3) (R/E)^2 (pi C Y/2)^3
template <Real T = double>
class JacksonGreenLaw : public detail::UnloadsElastically<JacksonGreenLaw<T>> {
public:
    /// \throws domain_error naming the constant of the material that is out of range.
    explicit JacksonGreenLaw(const PlasticMaterial<T>& material, HardnessLaw hardness_law = HardnessLaw::cosine)
        : hardness_law_(hardness_law) {
        material.validate();
        const T C = T(1.295) * std::exp(T(0.736) * material.poisson_ratio);
        const T yield = material.yield_strength / material.effective_modulus;
        critical_strain_ = std::numbers::pi_v<T> * C * yield / 2;
        hardness_factor_ = 4 / C;
        exponent_ = T(0.14) * std::exp(23 * yield);
    }

    /// omega_c [m] of the radius \p radius [m]; the law bends at kinks() times it.
    template <class Radius>
    [[nodiscard]] Radius critical(Radius radius) const {
        return static_cast<Radius>(critical_strain_ * critical_strain_) * radius;
    }
    [[nodiscard]] static constexpr std::array<T, 1> kinks() { return {begin}; }

    [[nodiscard]] T area_of(T omega, T radius) const {
        const T s = omega / critical(radius), sphere = std::numbers::pi_v<T> * radius * omega;
        return s < begin ? sphere : sphere * std::pow(s / begin, exponent_);
    }
    /// Load over E.
    [[nodiscard]] T load_of(T omega, T radius) const {
        const T s = omega / critical(radius);
        if (s < begin) return T(4) / 3 * omega * std::sqrt(radius * omega);
        const T critical_load = T(4) / 3 * radius * radius * critical_strain_ * critical_strain_ * critical_strain_;
        const T a_over_R = std::sqrt(area_of(omega, radius) / std::numbers::pi_v<T>) / radius;
        const T hardness = hardness_law_ == HardnessLaw::cosine
                               ? T(2.84) - T(0.92) * (1 - std::cos(std::numbers::pi_v<T> * a_over_R))
                               : T(2.84) * -std::expm1(T(-0.82) * std::pow(a_over_R, T(-0.7)));
        return critical_load * (std::exp(-std::pow(s, T(5) / 12) / 4) * s * std::sqrt(s) -
                                hardness_factor_ * hardness * std::expm1(-std::pow(s, T(5) / 9) / 25) * s);
    }

private:
    static constexpr T begin = T(1.9);

    HardnessLaw hardness_law_;
    T critical_strain_{}, hardness_factor_{}, exponent_{};
};

/// One asperity by Kogut and Etsion: elastic, two elastic-plastic ranges, then fully plastic.
///
///     load   P_c {s^1.5, 1.03 s^1.425, 1.40 s^1.263, 3 s/k}     for s < 1, < 6, < 110, beyond;  s = omega/omega_c
///     area   A_c {s, 0.93 s^1.136, 0.94 s^1.146, 2 s}           A_c = pi R omega_c,  P_c = (2/3) k H pi R omega_c
///     omega_c = (pi k H/(2E))^2 R,  k = 0.454 + 0.41 nu
template <Real T = double>
class KogutEtsionLaw : public detail::UnloadsElastically<KogutEtsionLaw<T>> {
public:
    /// \throws domain_error naming the constant of the material that is out of range.
    explicit KogutEtsionLaw(const PlasticMaterial<T>& material) {
        material.validate();
        k_ = T(0.454) + T(0.41) * material.poisson_ratio;
        hard_ = material.hardness_or_default() / material.effective_modulus;
        critical_strain_ = std::numbers::pi_v<T> * k_ * hard_ / 2;
    }

    /// omega_c [m] of the radius \p radius [m]; the law jumps at kinks() times it.
    template <class Radius>
    [[nodiscard]] Radius critical(Radius radius) const {
        return static_cast<Radius>(critical_strain_ * critical_strain_) * radius;
    }
    [[nodiscard]] static constexpr std::array<T, 3> kinks() { return {T(1), T(6), T(110)}; }

    [[nodiscard]] T area_of(T omega, T radius) const {
        const T s = omega / critical(radius), unit = std::numbers::pi_v<T> * radius * critical(radius);
        if (s < 1) return unit * s;
        if (s < 6) return unit * T(0.93) * std::pow(s, T(1.136));
        if (s < 110) return unit * T(0.94) * std::pow(s, T(1.146));
        return unit * 2 * s;
    }
    /// Load over E.
    [[nodiscard]] T load_of(T omega, T radius) const {
        const T omega_c = critical(radius), s = omega / omega_c;
        const T unit = T(2) / 3 * k_ * hard_ * std::numbers::pi_v<T> * radius * omega_c;
        if (s < 1) return unit * s * std::sqrt(s);
        if (s < 6) return unit * T(1.03) * std::pow(s, T(1.425));
        if (s < 110) return unit * T(1.40) * std::pow(s, T(1.263));
        return unit * 3 * s / k_;
    }

private:
    T k_{}, hard_{}, critical_strain_{};
};

}}  // namespace fstiff
