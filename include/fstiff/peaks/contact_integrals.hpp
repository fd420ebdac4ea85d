// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Contact integrals: moments of the peaks above a separation.
///
///     J[a,b](eta; r, theta) = int_0^inf int_eta^inf t^b (zeta - eta)^a p_peak(zeta, t) dzeta dt      eqs. (4.5), (4.9)
///     contacts   N J[0,0]                              load       (4/3) E N sigma^(3/2) sigma_kappa^(-1/2) J[3/2,-1/2]
///     real area  pi N (sigma/sigma_kappa) J[1,-1]          stiffness  2 E N sigma^(1/2) sigma_kappa^(-1/2) J[1/2,-1/2]
///
/// The integral over zeta is closed (math/gaussian_moment.hpp); that over t is a trapezoidal rule whose nodes all
/// quantities share (peaks/peak_sums.hpp). Functions without such powers: peaks/tensor_integrals.hpp.
///
/// ```cpp
/// #include <fstiff/peaks/contact_integrals.hpp>
///
/// #include <cstdio>
///
/// int main() {
///     const fstiff::PeakDistribution<double> peaks(0.5, 1.0);  // r, theta
///     const auto j = fstiff::contact_integral(0.5, -0.5, peaks, 2.0);
///     std::printf("J = %.15f, error below %.0e, %d evaluations\n", j.value, j.error, static_cast<int>(j.evaluations));
/// }
/// ```
/// ```text
/// J = 0.027259826841705, error below 3e-15, 40 evaluations
/// ```
/// Reference   Buczkowski, Kleiber, Starzynski, Arch. Mech. 66 (2014), eqs. (4.5)-(4.9)
/// Units       dimensionless
/// Valid       0 <= r < 1, 0 < theta < pi/2, |eta| <= 1e6; beyond the peaks the value underflows to 0
/// Accuracy    relative_tolerance; at the default 2e-14 (double) 6e-15 on the tables of tests/data, and the error
///             returned covers the true one (tests/peaks/contact_integrals_test.cpp)

#include <fstiff/core/error.hpp>
#include <fstiff/core/numbers.hpp>
#include <fstiff/peaks/peak_distribution.hpp>
#include <fstiff/peaks/peak_sums.hpp>
#include <fstiff/peaks/quantity.hpp>

namespace fstiff { inline namespace v0_1 {

/// Tolerance of the contact integrals.
template <Real T = double>
struct IntegralOptions {
    /// Relative error to aim at, between 100 epsilon and 0.1.
    T relative_tolerance = 100 * std::numeric_limits<T>::epsilon();
};

/// J[0,0], J[3/2,-1/2], J[1/2,-1/2] and J[1,-1]; quantities that were not asked for are 0. Each value times
/// exp(log_scale).
template <Real T = double>
struct ContactIntegrals {
    Estimate<T> contacts;
    Estimate<T> load;
    Estimate<T> stiffness;
    Estimate<T> area;
    T log_scale{};
};

namespace detail {

/// Logarithm of the factor that every integral over the peaks at \p eta leaves out.
template <Real T>
[[nodiscard]] T log_scale_at(T eta) {
    const T floor = (std::max)(eta, T(0));
    return -floor * floor / 2;
}

/// The integrals of a PowerSet for one density of peaks. Numbers that depend on it and on the tolerance alone are
/// computed once, and erf at the nodes of the smooth map as long as a new eta takes the same ones.
template <Real T>
class PeakIntegrator {
public:
    /// \throws domain_error for a tolerance out of its range.
    PeakIntegrator(const PowerSet& minus_two_b, const PeakDistribution<T>& peaks, T tolerance)
        : minus_two_b_(minus_two_b),
          tolerance_(checked(tolerance)),
          // few nodes: the fitted steps scatter more
          log_accuracy_(static_cast<double>(-std::log(tolerance) + (tolerance > T(1e-10) ? 1 : 0))),
          problem_(peaks, 0.0, log_accuracy_ + 5),
          sums_(problem_, minus_two_b, static_cast<double>(tolerance)) {}

    /// Integral for a = i/2, without exp(log_scale_at(eta)). \throws domain_error unless |eta| <= 1e6.
    std::array<Estimate<T>, 4> operator()(T eta) {
        require(std::abs(eta) <= T(1e6), "eta", eta, "a number between -1e6 and 1e6");
        problem_.move_to(static_cast<double>(eta));
        sums_.clear();
        const PeakSums<double> sums = sums_.result(detail::visit_nodes(problem_, log_accuracy_, sums_));
        const T floor = (std::max)(eta, T(0));
        std::array<Estimate<T>, 4> of_power{};
        // rounding (z inherits that of t), the coefficients left out, and what the extrapolation of the rule's error
        // may miss: more with few nodes
        const T least = std::numeric_limits<T>::epsilon() * (T(8) + floor) + static_cast<T>(sums_.cut()) +
                        tolerance_ * (tolerance_ > T(1e-8) ? T(0.8) : T(0.2));
        const T root_c = static_cast<T>(std::sqrt(problem_.c));
        T factor = static_cast<T>(1 / (2 * problem_.theta));  // c^a / (2 theta)
        for (std::size_t i = 0; i < 4; ++i, factor *= root_c) {
            if (minus_two_b_[i] == detail::absent) continue;
            const T value = factor * static_cast<T>(sums.value[i]);
            of_power[i] = {value, value * (static_cast<T>(sums.relative_error[i]) + least), sums.nodes};
        }
        return of_power;
    }

private:
    static T checked(T tolerance) {
        require(tolerance >= 50 * std::numeric_limits<T>::epsilon() && tolerance <= T(0.1), "relative_tolerance",
                tolerance, "at least 50 epsilon of the scalar type and at most 0.1");
        return tolerance;
    }

    PowerSet minus_two_b_;
    T tolerance_;
    double log_accuracy_;
    PeakProblem<double> problem_;
    PeakAccumulator<double> sums_;
};

/// The contact integrals of one density of peaks, at separation after separation: less work for each than by the
/// functions below. Does not allocate; not to be shared by threads.
template <Real T = double>
class ContactIntegrator {
public:
    /// \throws domain_error for a tolerance out of its range.
    explicit ContactIntegrator(const PeakDistribution<T>& peaks, Quantity quantities = Quantity::all,
                               const IntegralOptions<T>& options = {})
        : integrate_(powers(quantities), peaks, options.relative_tolerance) {}

    /// Integrals at the separation \p eta (in rms heights), over shared nodes. The values leave out exp(log_scale), so
    /// that they neither under- nor overflow. \throws domain_error unless |eta| <= 1e6.
    [[nodiscard]] ContactIntegrals<T> operator()(T eta) {
        const auto j = integrate_(eta);
        return {j[0], j[3], j[1], j[2], log_scale_at(eta)};
    }

private:
    static PowerSet powers(Quantity quantities) {
        const auto when = [quantities](Quantity quantity, int minus_two_b) {
            return has(quantities, quantity) ? minus_two_b : detail::absent;
        };
        return {when(Quantity::contact_density, 0), when(Quantity::stiffness, 1), when(Quantity::real_area_fraction, 2),
                when(Quantity::pressure, 1)};
    }

    PeakIntegrator<T> integrate_;
};

}  // namespace detail

/// The requested integrals at the separation \p eta; log_scale is 0. \throws as ContactIntegrator.
template <Real T>
[[nodiscard]] ContactIntegrals<T> contact_integrals(const PeakDistribution<T>& peaks, T eta,
                                                    Quantity quantities = Quantity::all,
                                                    const IntegralOptions<T>& options = {}) {
    const ContactIntegrals<T> j = detail::ContactIntegrator<T>(peaks, quantities, options)(eta);
    const T scale = math::gaussian((std::max)(eta, T(0)));
    return {j.contacts * scale, j.load * scale, j.stiffness * scale, j.area * scale, T(0)};
}

/// J[a,b] at the separation \p eta. \throws domain_error unless a is 0, 1/2, 1 or 3/2, b 0, -1/2 or -1, and as above.
template <Real T>
[[nodiscard]] Estimate<T> contact_integral(T a, T b, const PeakDistribution<T>& peaks, T eta,
                                           const IntegralOptions<T>& options = {}) {
    const auto j = detail::PeakIntegrator<T>(detail::one_power(a, b), peaks, options.relative_tolerance)(eta);
    return j[static_cast<std::size_t>(2 * a)] * math::gaussian((std::max)(eta, T(0)));
}

}}  // namespace fstiff
