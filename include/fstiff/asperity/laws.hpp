// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Load, stiffness and contact area of one asperity of radius R pressed in by the approach omega: the elastic laws.
///
///     HertzLaw              load (4/3) sqrt(R) omega^(3/2)       stiffness 2 sqrt(R omega)          eq. (3.7)
///     FractalLaw            load (4/3) sqrt(R) omega^(3/2)       stiffness f * 2 sqrt(R omega)      eqs. (3.7), (3.14)
///     FractalConsistentLaw  load f * (4/3) sqrt(R) omega^(3/2)   stiffness f * 2 sqrt(R omega)   f = (2/3) (3-D)/(2-D)
///     all                   area pi R omega                                                         eq. (3.11)
///
/// FractalLaw is the paper as printed, whose stiffness is f times the slope of its load (docs/errata.md); in
/// FractalConsistentLaw the stiffness is the slope. Loads and stiffnesses are divided by the effective modulus E.
///
/// Reference   Buczkowski, Kleiber, Starzynski, Arch. Mech. 66 (2014), eqs. (3.7), (3.11), (3.14)
/// Units       omega, R [m]; load/E [m^2], stiffness/E [m], area [m^2]
/// Valid       omega >= 0, R > 0, 1 < D < 2 (f diverges as D -> 2)
/// Accuracy    4 ulp (tests/asperity/laws_test.cpp)

#include <fstiff/surface/fractal.hpp>

#include <numbers>

namespace fstiff { inline namespace v0_1 {

/// Asperity law as a contact needs it: load/E [m^2], stiffness/E [m] and area [m^2] of one asperity, for
/// approaches \p omega [m] (a number or an Eigen array) and the radius \p radius [m].
template <class Law, class Omega, class Radius = Omega>
concept AsperityLaw = requires(const Law& law, const Omega& omega, const Radius& radius) {
    law.load(omega, radius);
    law.stiffness(omega, radius);
    law.area(omega, radius);
};

/// omega^(omega/2) R^(radius/2): the powers of a law, doubled.
struct HalfPowers {
    int omega, radius;
    [[nodiscard]] constexpr bool operator==(const HalfPowers&) const = default;
};

namespace detail {

/// True if the integrals over heights and curvatures, that of the slope of the load too, have one dimension.
[[nodiscard]] constexpr bool reduces_to_one_dimension(HalfPowers load, HalfPowers stiffness, HalfPowers area) {
    const auto offered = [](HalfPowers p) { return p.omega >= 0 && p.omega <= 3 && p.radius >= 0 && p.radius <= 2; };
    return offered(load) && offered({load.omega - 2, load.radius}) && offered(stiffness) && offered(area);
}

/// A law whose load, stiffness and area are each a constant factor times half-integer powers of omega and R, such that
/// the integrals over the peaks reduce to one dimension: omega up to 3/2 (of the load from 1 on), R up to 1.
template <class Law, class T = double>
concept PowerLaw = requires(const Law& law) {
    { law.load_factor() } -> std::convertible_to<T>;
    { law.stiffness_factor() } -> std::convertible_to<T>;
    { law.area_factor() } -> std::convertible_to<T>;
    { Law::load_powers } -> std::convertible_to<HalfPowers>;
    { Law::stiffness_powers } -> std::convertible_to<HalfPowers>;
    { Law::area_powers } -> std::convertible_to<HalfPowers>;
}
&&detail::reduces_to_one_dimension(Law::load_powers, Law::stiffness_powers, Law::area_powers);

}  // namespace detail

/// The elastic laws by their factors, and any of them copied into one type.
template <Real T = double>
class ElasticLaw {
public:
    static constexpr HalfPowers load_powers{3, 1}, stiffness_powers{1, 1}, area_powers{2, 2};

    [[nodiscard]] constexpr T load_factor() const { return load_factor_; }
    [[nodiscard]] constexpr T stiffness_factor() const { return stiffness_factor_; }
    [[nodiscard]] static constexpr T area_factor() { return std::numbers::pi_v<T>; }

    template <class Omega, class Radius>
    [[nodiscard]] auto load(const Omega& omega, const Radius& radius) const {
        using std::sqrt;
        return load_factor_ * omega * sqrt(radius * omega);
    }
    template <class Omega, class Radius>
    [[nodiscard]] auto stiffness(const Omega& omega, const Radius& radius) const {
        using std::sqrt;
        return stiffness_factor_ * sqrt(radius * omega);
    }
    template <class Omega, class Radius>
    [[nodiscard]] auto area(const Omega& omega, const Radius& radius) const {
        return area_factor() * radius * omega;
    }

protected:
    constexpr ElasticLaw(T load_factor, T stiffness_factor)
        : load_factor_(load_factor), stiffness_factor_(stiffness_factor) {}

private:
    T load_factor_, stiffness_factor_;
};

namespace detail {

/// f = (2/3) (3-D)/(2-D): ratio of the stiffness (3.14) to that of one Hertzian asperity, at least 4/3.
/// \throws domain_error unless 1 < D < 2.
template <Real T>
[[nodiscard]] constexpr T fractal_stiffness_factor(T fractal_dimension) {
    require_fractal_dimension(fractal_dimension);
    return 2 * (3 - fractal_dimension) / (3 * (2 - fractal_dimension));
}

}  // namespace detail

/// Hertz: the stiffness is the derivative of the load. There is no D.
template <Real T = double>
struct HertzLaw : ElasticLaw<T> {
    constexpr HertzLaw() : ElasticLaw<T>(T(4) / 3, T(2)) {}
};

/// The paper as printed: Hertz load, stiffness (3.14). K is not the derivative of the load.
template <Real T = double>
struct FractalLaw : ElasticLaw<T> {
    /// \throws domain_error unless 1 < D < 2.
    explicit constexpr FractalLaw(T fractal_dimension)
        : ElasticLaw<T>(T(4) / 3, 2 * detail::fractal_stiffness_factor(fractal_dimension)) {}
};

/// Stiffness (3.14) and the load that it is the derivative of.
template <Real T = double>
struct FractalConsistentLaw : ElasticLaw<T> {
    /// \throws domain_error unless 1 < D < 2.
    explicit constexpr FractalConsistentLaw(T fractal_dimension)
        : ElasticLaw<T>(4 * detail::fractal_stiffness_factor(fractal_dimension) / 3,
                        2 * detail::fractal_stiffness_factor(fractal_dimension)) {}
};

}}  // namespace fstiff
