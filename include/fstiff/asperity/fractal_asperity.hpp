// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// One asperity of a fractal surface: a single cosine of base diameter l, pressed in by the approach omega. Contacts
/// take the laws in asperity/laws.hpp, eq. (3.14) among them.
///
///     z(x) = delta cos(2 pi x/l),  delta = G^(D-1) l^(2-D),  R = l^D / (4 pi^2 G^(D-1))      eqs. (3.1)-(3.3)
///     omega = q delta,  q = 1 - cos(pi l_t/l)                                                eq. (3.4), truncation l_t
///     family: l = G (omega/(q G))^(1/(2-D)),  R = l^2 q/(4 pi^2 omega),  area = q l^2/(4 pi)   (3.5), (3.6), (3.12)
///              load = 2/(3 pi) sqrt(q) l omega (times E),  k_n = d load/d omega                    eqs. (3.8), (3.10)
///
/// Derivation: docs/theory-contact.md, section 3. The slope under load of one asperity, l fixed, is k_n/f.
/// Reference   Buczkowski, Kleiber, Starzynski, Arch. Mech. 66 (2014), eqs. (3.1)-(3.14)
/// Units       lengths [m], area [m^2]; loads and stiffnesses are divided by the effective modulus E: [m^2], [m]
/// Valid       1 < D < 2, G > 0, l > 0, 0 <= l_t <= l, 0 < q <= 2 (the paper's omega <= delta is q <= 1)
/// Accuracy    FractalAsperity 4 ulp; AsperityFamily (2 + |ln(omega/(qG))|/2) / (2-D) + 2 ulp, radius and area twice
///             that (tests/asperity/fractal_asperity_test.cpp)

#include <fstiff/asperity/laws.hpp>

#include <algorithm>
#include <numbers>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// q = 1 - cos(pi l_t/l) of eq. (3.4), formed as 2 sin^2(pi l_t/(2l)): no digits are lost for small l_t/l.
/// \throws domain_error unless l > 0 and 0 <= l_t <= l.
template <Real T>
[[nodiscard]] T truncation_share(T truncation_diameter, T base_diameter) {
    require_positive("base_diameter", base_diameter);
    require(truncation_diameter >= 0 && truncation_diameter <= base_diameter, "truncation_diameter",
            truncation_diameter, "between 0 and the base diameter");
    const T sine = std::sin(std::numbers::pi_v<T> / 2 * (truncation_diameter / base_diameter));
    return 2 * sine * sine;
}

/// k_n/E of eq. (3.13) from the contact area \p area: 4/(3 sqrt(pi)) (3-D)/(2-D) sqrt(a) [m].
/// \throws domain_error unless 1 < D < 2 and the area is finite and not negative.
template <Real T>
[[nodiscard]] T fractal_stiffness_from_area(T area, T fractal_dimension) {
    require(area >= 0 && area <= (std::numeric_limits<T>::max)(), "area", area, "finite and not negative");
    return 2 * detail::fractal_stiffness_factor(fractal_dimension) * std::numbers::inv_sqrtpi_v<T> * std::sqrt(area);
}

/// One asperity of base diameter l on a surface {D, G}.
template <Real T = double>
class FractalAsperity {
public:
    /// \throws domain_error for D, G or l out of range, or an asperity whose height or radius T cannot hold.
    FractalAsperity(const Fractal<T>& fractal, T base_diameter) : base_(base_diameter) {
        detail::require_fractal_dimension(fractal.dimension);
        require_positive("fractal_roughness", fractal.roughness);
        require_positive("base_diameter", base_diameter);
        constexpr T pi = std::numbers::pi_v<T>;
        const T slenderness = std::pow(fractal.roughness / base_, fractal.dimension - 1);  // delta/l
        height_ = base_ * slenderness;
        radius_ = base_ / (4 * pi * pi * slenderness);
        require(std::isnormal(height_) && std::isnormal(radius_), "base_diameter", base_diameter,
                "such that the height and the radius of the asperity are in the range of the floating-point type");
    }

    [[nodiscard]] T base_diameter() const noexcept { return base_; }
    [[nodiscard]] T height() const noexcept { return height_; }  ///< delta, eq. (3.2)
    [[nodiscard]] T radius() const noexcept { return radius_; }  ///< R, eq. (3.3)

    /// z at the distance \p x from the peak, eq. (3.1). \throws domain_error unless |x| <= l/2.
    [[nodiscard]] T profile(T x) const {
        require(std::abs(x) <= base_ / 2, "x", x, "at most half the base diameter away from the peak");
        return height_ * std::cos(2 * std::numbers::pi_v<T> * (x / base_));
    }

    /// omega for the truncation diameter l_t, eq. (3.4). \throws domain_error unless 0 <= l_t <= l.
    [[nodiscard]] T approach(T truncation_diameter) const {
        return height_ * truncation_share(truncation_diameter, base_);
    }

    /// l_t for the approach omega, the inverse of eq. (3.4). \throws domain_error unless 0 <= omega <= 2 delta.
    [[nodiscard]] T truncation_diameter(T approach) const {
        // Rounding may put the sine just above 1 at omega = 2 delta.
        const T sine = (std::min)(T(1), std::sqrt(checked(approach) / height_ / 2));
        return (std::min)(base_, base_ * (2 / std::numbers::pi_v<T> * std::asin(sine)));
    }

    /// Load/E [m^2] (3.7), stiffness/E [m] (3.14) and area [m^2] (3.11) by \p law at the approach omega.
    /// \throws domain_error unless 0 <= omega <= 2 delta.
    template <AsperityLaw<T> Law>
    [[nodiscard]] T load(const Law& law, T approach) const {
        return law.load(checked(approach), radius_);
    }
    template <AsperityLaw<T> Law>
    [[nodiscard]] T stiffness(const Law& law, T approach) const {
        return law.stiffness(checked(approach), radius_);
    }
    template <AsperityLaw<T> Law>
    [[nodiscard]] T area(const Law& law, T approach) const {
        return law.area(checked(approach), radius_);
    }

private:
    T checked(T approach) const {
        require(approach >= 0 && approach <= 2 * height_, "approach", approach,
                "between 0 and twice the asperity height");
        return approach;
    }

    T base_, height_, radius_;
};

/// The asperities of a surface {D, G} that are cut at one share q of their height, as functions of the approach.
/// Every member throws domain_error for an approach that is not positive, or for a result that T cannot hold.
template <Real T = double>
class AsperityFamily {
public:
    /// \throws domain_error unless 1 < D < 2, G > 0 and 0 < q <= 2.
    AsperityFamily(const Fractal<T>& fractal, T truncation_share) : fractal_(fractal), share_(truncation_share) {
        detail::require_fractal_dimension(fractal.dimension);
        require_positive("fractal_roughness", fractal.roughness);
        require(truncation_share > 0 && truncation_share <= 2, "truncation_share", truncation_share,
                "greater than 0 and at most 2");
    }

    /// l, eq. (3.5)
    [[nodiscard]] T base_diameter(T approach) const {
        require_positive("approach", approach);
        const T ratio = approach / share_ / fractal_.roughness;  // delta/G
        return held(fractal_.roughness * std::pow(ratio, 1 / (2 - fractal_.dimension)), approach);
    }
    /// R, eq. (3.6)
    [[nodiscard]] T radius(T approach) const {
        constexpr T pi = std::numbers::pi_v<T>;
        const T base = base_diameter(approach);
        return held(base / (4 * pi * pi) * (base / (approach / share_)), approach);
    }
    /// W_e/E, eq. (3.8): Hertz's load (3.7) at the radius (3.6)
    [[nodiscard]] T load(T approach) const {
        constexpr T pi = std::numbers::pi_v<T>;
        return held(2 / (3 * pi) * std::sqrt(share_) * base_diameter(approach) * approach, approach);
    }
    /// k_n/E, eq. (3.10), the derivative of load
    [[nodiscard]] T stiffness(T approach) const {
        constexpr T pi = std::numbers::pi_v<T>;
        return held(
            detail::fractal_stiffness_factor(fractal_.dimension) / pi * std::sqrt(share_) * base_diameter(approach),
            approach);
    }
    /// a, eq. (3.12)
    [[nodiscard]] T area(T approach) const {
        constexpr T pi = std::numbers::pi_v<T>;
        const T base = base_diameter(approach);
        return held(share_ / (4 * pi) * base * base, approach);
    }

    /// The member of the family that \p approach belongs to.
    [[nodiscard]] FractalAsperity<T> asperity(T approach) const { return {fractal_, base_diameter(approach)}; }

private:
    // \p value, unless it left the range of T.
    static T held(T value, T approach) {
        require(std::isnormal(value), "approach", approach,
                "such that its asperity is in the range of the floating-point type");
        return value;
    }

    Fractal<T> fractal_;
    T share_;
};

}}}  // namespace fstiff::detail
