// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Sums of load, stiffness and area of single asperities over a distribution of peaks.
///
///     p = E D_p <load>,  K = E D_p <stiffness>,  A = D_p <area>,  n = D_p <1>,  -dp/dd
///     power law       <omega^x R^y> = sigma^x sigma_kappa^-y J[x,-y],  d/deta J[a,b] = -a J[a-1,b]     one dimension
///     peaks of one R  <omega^x R^y> = sigma^x R^y G_x(eta)                                                closed
///     any other law   peaks/law_means.hpp                      omega = sigma (zeta - eta), R = 1/(sigma_kappa t)
///
/// Angle brackets are means over all peaks, those below the separation counting 0.
///
/// Reference   Buczkowski, Kleiber, Starzynski, Arch. Mech. 66 (2014), eqs. (4.5)-(4.9)
/// Units       SI; load/E [m^2], stiffness/E [m], area [m^2] of the law
/// Valid       as the integrals that are called
/// Accuracy    that of the integrals that are called (tests/peaks/any_law_test.cpp)

#include <fstiff/asperity/laws.hpp>
#include <fstiff/core/numbers.hpp>
#include <fstiff/peaks/contact_integrals.hpp>
#include <fstiff/peaks/peak_distribution.hpp>
#include <fstiff/peaks/quantity.hpp>
#include <fstiff/peaks/single_radius.hpp>

namespace fstiff { inline namespace v0_1 { namespace detail {

// A function of an approach, or of an array of eight, and of a radius.
template <class Law, class T>
concept HasLoad = requires(const Law& law, Eigen::Array<T, 8, 1> omega, T radius) {
    law.load(omega, radius);
}
|| requires(const Law& law, T omega, T radius) { law.load(omega, radius); };
template <class Law, class T>
concept HasStiffness = requires(const Law& law, Eigen::Array<T, 8, 1> omega, T radius) {
    law.stiffness(omega, radius);
}
|| requires(const Law& law, T omega, T radius) { law.stiffness(omega, radius); };
template <class Law, class T>
concept HasArea = requires(const Law& law, Eigen::Array<T, 8, 1> omega, T radius) {
    law.area(omega, radius);
}
|| requires(const Law& law, T omega, T radius) { law.area(omega, radius); };

/// A law that any contact takes: given its powers, or as three functions.
template <class Law, class T>
concept ContactableLaw = PowerLaw<Law, T> ||(HasLoad<Law, T>&& HasStiffness<Law, T>&& HasArea<Law, T>);

/// The sums over the peaks per nominal area, each times exp(log_scale); quantities that are not asked for are 0.
template <Real T>
struct LawSums {
    Estimate<T> contacts;   ///< [1/m^2]
    Estimate<T> load;       ///< [Pa]
    Estimate<T> stiffness;  ///< [Pa/m]
    Estimate<T> area;       ///< over the nominal area
    Estimate<T> loading;    ///< -dp/dd [Pa/m]
    T log_scale{};
};

/// Factors from dimensionless means to SI.
template <Real T>
struct PeakScales {
    T rms_height, peak_density, effective_modulus;
    T curvature;  ///< sigma_kappa, or 1/R for peaks of one radius [1/m]

    /// factor D_p sigma^(omega/2) curvature^(-radius/2): of the mean of a law of these powers over the peaks. Written
    /// with sigma times the curvature, which is dimensionless.
    [[nodiscard]] T unit(T factor, HalfPowers powers) const {
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
        return PowerTerm<T>{quantity, powers, scales.unit(factor, powers)};
    };
    return {term(Quantity::contact_density, {0, 0}, T(1)), term(Quantity::pressure, load, modulus * load_factor),
            term(Quantity::stiffness, Law::stiffness_powers, modulus * static_cast<T>(law.stiffness_factor())),
            term(Quantity::real_area_fraction, Law::area_powers, static_cast<T>(law.area_factor())),
            // per length: the slope against eta over sigma
            term(Quantity::loading_stiffness, slope, modulus * (T(load.omega) / 2 * load_factor))};
}

template <Real T>
Estimate<T>& member_of(LawSums<T>& sums, Quantity quantity) {
    switch (quantity) {
        case Quantity::contact_density: return sums.contacts;
        case Quantity::pressure: return sums.load;
        case Quantity::stiffness: return sums.stiffness;
        case Quantity::real_area_fraction: return sums.area;
        default: return sums.loading;
    }
}

/// Sums at separation after separation, of a law and a distribution of peaks.
template <Real T, class Law, class Peaks>
class LawIntegrator;

/// A power law over the joint distribution of height and curvature: one pass for each set of distinct powers of omega.
template <Real T, PowerLaw<T> Law>
class LawIntegrator<T, Law, PeakDistribution<T>> {
public:
    LawIntegrator(const Law& law, const PeakDistribution<T>& peaks, const PeakScales<T>& scales, Quantity quantities,
                  T tolerance)
        : terms_(power_terms(law, scales)) {
        constexpr PowerSet nothing{absent, absent, absent, absent};
        std::array<PowerSet, passes> sets;
        sets.fill(nothing);
        for (std::size_t i = 0; i < terms_.size(); ++i) {
            pass_[i] = passes;
            if (!detail::has(quantities, terms_[i].quantity)) continue;
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
        out.log_scale = detail::log_scale_at(eta);
        for (std::size_t pass = 0; pass < passes && integrators_[pass]; ++pass) {
            const std::array<Estimate<T>, 4> j = (*integrators_[pass])(eta);
            for (std::size_t i = 0; i < terms_.size(); ++i)
                if (pass_[i] == pass)
                    member_of(out, terms_[i].quantity) =
                        j[static_cast<std::size_t>(terms_[i].powers.omega)] * terms_[i].scale;
        }
        return out;
    }

private:
    static constexpr std::size_t passes = 3;  ///< one for each power of R, which may all have one power of omega
    std::array<PowerTerm<T>, 5> terms_;
    std::array<std::size_t, 5> pass_{};  ///< of each term; `passes` where it is not asked for
    std::array<std::optional<PeakIntegrator<T>>, passes> integrators_;
};

/// A power law over peaks of one radius: closed.
template <Real T, PowerLaw<T> Law>
class LawIntegrator<T, Law, SingleRadius<T>> {
public:
    LawIntegrator(const Law& law, const SingleRadius<T>& peaks, const PeakScales<T>& scales, Quantity quantities, T)
        : terms_(power_terms(law, scales)), peaks_(peaks), mask_(quantities) {}

    LawSums<T> operator()(T eta) const {
        constexpr T rounding = 16 * std::numeric_limits<T>::epsilon();
        LawSums<T> out;
        const auto add = [&]<int Omega>(std::size_t i) {
            const auto [value, log_scale] = peaks_.template scaled_height_moment<Omega>(eta);
            out.log_scale = log_scale;
            member_of(out, terms_[i].quantity) = {terms_[i].scale * value, rounding * terms_[i].scale * value, 0};
        };
        for (std::size_t i = 0; i < terms_.size(); ++i) {
            if (!detail::has(mask_, terms_[i].quantity)) continue;
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
    Quantity mask_;
};

}}}  // namespace fstiff::detail
