// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Persson's stiffness of a rough contact from the spectrum of the roughness: the law of dense contacts.
///
///     1/K = sqrt(2/pi)/p int_0^g f(p/(E G)) dG/q(G),     f(x) = B(P) exp(-2 x^2),  P = erf(sqrt(2) x)
///     d   = sqrt(2/pi) int_0^g W(sqrt(2) p/(E G)) dG/q,  W(y) = int_y^inf B(erf s) exp(-s^2) ds/s
///     B   = gamma + (1-gamma) [3 (1-c) P^2 + 17 c P^16],    A/A0 = erf(sqrt(2) p/(E g)),  no number of contacts (0)
///
/// G(q): rms gradient of all waves up to q (surface/spectrum.hpp). Derivation: docs/theory-contact.md, section 8.
/// Reference   Persson, Phys. Rev. Lett. 99 (2007) 125502; Yang, Persson, J. Phys. Condens. Matter 20 (2008) 215214
///             (gamma); Almqvist et al., J. Mech. Phys. Solids 59 (2011) 2355 (gamma = 0.45); c = 1/4: this project
/// Units       SI: m, Pa, Pa/m
/// Valid       0 < gamma <= 1, 0 <= c <= 1; states up to 0.75 E g, stiffness() and separation() up to 18 E g; isotropic
///             Gaussian surfaces. K is too small where few peaks touch: 0.65 of boundary elements at p/(E g) = 0.002
/// Accuracy    K 1e-13, separation 1e-13 of the rms height, in double (tests/contact/persson_contact_test.cpp)

#include <fstiff/contact/contact_state.hpp>
#include <fstiff/contact/slope_contact.hpp>
#include <fstiff/core/error.hpp>
#include <fstiff/math/normal_distribution.hpp>
#include <fstiff/math/quadrature.hpp>
#include <fstiff/peaks/quantity.hpp>
#include <fstiff/surface/band_spectrum.hpp>
#include <fstiff/surface/gradient_spectrum.hpp>
#include <fstiff/surface/spectrum.hpp>

// Stiffness of elastic contact far from both ends of the load: proportional to the pressure, whatever the peaks.
//
//     K = p/(gamma sigma),  gamma = 0.48
//
// Reference   Akarapu et al., Phys. Rev. Lett. 106 (2011) 204301; Campana et al., J. Phys. Condens. Matter 23 (2011)
//             085001
// Units       p [Pa], sigma [m], K [Pa/m] per nominal area
// Valid       self-affine Gaussian surfaces, elastic; p* = p/(E g_rms) from 0.008 to 0.12 (answer/checks)
// Accuracy    a fifth of K there, a factor of 2 for p* of 0.002 to 0.25 (docs/validation.md,
//             tests/docs/validation_test.cpp)

namespace fstiff { inline namespace v0_1 { namespace detail {

template <Real T>
inline constexpr T linear_law_factor = T(0.48);  ///< gamma

/// K = p/(0.48 sigma) [Pa/m]. \throws domain_error unless p >= 0 and sigma > 0, both finite.
template <Real T>
[[nodiscard]] constexpr T linear_stiffness(T pressure, T rms_height) {
    require(pressure >= T(0) && pressure <= (std::numeric_limits<T>::max)(), "pressure", pressure,
            "finite and not negative");
    require_positive("rms_height", rms_height);
    return pressure / (linear_law_factor<T> * rms_height);
}

}}}  // namespace fstiff::detail

namespace fstiff { inline namespace v0_1 {

namespace detail {

/// B(P) = gamma + square P^2 + late P^16, of numbers or of several at once.
template <class V>
struct PerssonEnergy {
    V gamma, square, late;

    [[nodiscard]] V value(V P) const {
        const V P2 = P * P, P4 = P2 * P2, P8 = P4 * P4;
        return P8 * P8 * late + (P2 * square + gamma);
    }
    /// dB/dP
    [[nodiscard]] V slope(V P) const {
        const V P2 = P * P, P4 = P2 * P2;
        V half = P4 * P4 * P4 * P2 * late;
        for (int i = 0; i < 3; ++i) half = half + half;
        half = half + square;
        return P * (half + half);
    }
};

/// \p closing is c, the share of P^16.
template <class S>
PerssonEnergy<S> persson_energy(S gamma, S closing) {
    return {gamma, 3 * (1 - gamma) * (1 - closing), 17 * (1 - gamma) * closing};
}

/// B(erf(s)) exp(-s^2)
template <class S>
S persson_kernel(S s, const PerssonEnergy<S>& energy) {
    return energy.value(std::erf(s)) * std::exp(-s * s);
}

/// W(y), y > 0, to 1e-15 of max(1, W).
template <class S>
S persson_distance(S y, const PerssonEnergy<S>& energy) {
    const auto& rule = math::GaussLegendre<S, 32>::get();
    const auto integral = [&rule](S a, S b, const auto& f) {
        S sum = 0;
        for (std::size_t i = 0; i < 32; ++i) sum += rule.weight[i] * f((a + b) / 2 + (b - a) / 2 * rule.node[i]);
        return (b - a) / 2 * sum;
    };
    const auto kernel = [&energy](S s) { return persson_kernel(s, energy) / s; };
    if (y >= 1) return integral(y, y + (std::min)(S(6), 45 / y), kernel);
    const auto without_pole = [&energy](S s) { return (persson_kernel(s, energy) - energy.gamma) / s; };
    return integral(S(1), S(7), kernel) + integral(y, S(1), without_pole) - energy.gamma * std::log(y);
}

/// K and its slope at one pressure.
template <Real T>
struct PerssonStiffness {
    T stiffness;  ///< K [Pa/m]
    T slope;      ///< dK/dp [1/m]
};

}  // namespace detail

/// Persson's theory: the contact of a surface with a known spectrum.
template <Real T = double>
class PerssonContact : public detail::SlopeContact<PerssonContact<T>, T> {
public:
    /// Takes a spectrum and the effective modulus [Pa]. \throws domain_error naming the parameter that is out of range.
    PerssonContact(const BandSpectrum<T>& spectrum, std::type_identity_t<T> effective_modulus,
                   std::type_identity_t<T> gamma = T(0.45), std::type_identity_t<T> closing = T(0.25))
        : PerssonContact(detail::gradient_pieces<double>(spectrum), spectrum.rms_height(), effective_modulus, gamma,
                         closing) {}
    PerssonContact(const SpectrumShells<T>& spectrum, std::type_identity_t<T> effective_modulus,
                   std::type_identity_t<T> gamma = T(0.45), std::type_identity_t<T> closing = T(0.25))
        : PerssonContact(detail::gradient_pieces<double>(spectrum), spectrum.rms_height, effective_modulus, gamma,
                         closing) {}

    /// The contact under the nominal pressure \p pressure [Pa].
    /// \throws domain_error unless it is positive and at most largest_compared_pressure().
    [[nodiscard]] ContactState<T> at_pressure(T pressure, Quantity quantities = Quantity::all) const {
        require_compared(pressure);
        ContactState<T> state;
        state.pressure = {pressure, 0, 0};
        if (detail::has(quantities, Quantity::stiffness | Quantity::loading_stiffness)) {
            const T K = stiffness(pressure);
            state.stiffness = {K, error_of_K * K, nodes()};
            if (detail::has(quantities, Quantity::loading_stiffness)) state.loading_stiffness = state.stiffness;
            if (!detail::has(quantities, Quantity::stiffness)) state.stiffness = {};
        }
        if (detail::has(quantities, Quantity::separation)) state.separation = separation(pressure);
        state.eta = state.separation.value / rms_height_;
        if (detail::has(quantities, Quantity::real_area_fraction)) {
            const T share = real_area_fraction(pressure);
            state.real_area_fraction = {share, 4 * std::numeric_limits<T>::epsilon() * share, 0};
        }
        return state;
    }

    /// K [Pa/m] of the theory under \p pressure [Pa], compared with boundary elements or not.
    /// \throws domain_error unless it is positive and at most 18 E g.
    [[nodiscard]] T stiffness(T pressure) const {
        require_reach(pressure);
        return static_cast<T>(static_cast<double>(pressure) / (root_2_over_pi() * sums<false>(pressure).value));
    }

    /// K [Pa/m] and dK/dp [1/m]. \throws domain_error as stiffness.
    [[nodiscard]] detail::PerssonStiffness<T> stiffness_and_slope(T pressure) const {
        require_reach(pressure);
        const Sums j = sums<true>(pressure);
        const double K = static_cast<double>(pressure) / (root_2_over_pi() * j.value);
        return {static_cast<T>(K), static_cast<T>(K / static_cast<double>(pressure) * (1 - j.log_slope))};
    }

    /// The separation of the mean planes under \p pressure [Pa]: above 0 at every pressure.
    /// \throws domain_error as stiffness.
    [[nodiscard]] Estimate<T> separation(T pressure) const {
        require_reach(pressure);
        const double x = static_cast<double>(pressure) / static_cast<double>(modulus_), root_2 = std::sqrt(2.0);
        double sum = 0;
        int evaluations = 0;
        if (2 * x > gradient_) {
            directly(x, [&](double gradient, double weight) {
                sum += weight * detail::persson_distance(root_2 * x / gradient, energy_);
            });
        } else {
            const double last = last_y(x);
            for (std::size_t i = 0; i < inverse_.size() && x * inverse_[i] < last; ++i, evaluations += 32)
                sum += weight_[i] * detail::persson_distance(root_2 * x * inverse_[i], energy_);
        }
        const T d = static_cast<T>(root_2_over_pi() * sum);
        // W below y = 1 is as good as a number of size 1
        return {d, 64 * std::numeric_limits<T>::epsilon() * (d + (x < gradient_ ? rms_height_ : T(0))), evaluations};
    }

    /// A/A0 = erf(sqrt(2) p/(E g)).
    [[nodiscard]] T real_area_fraction(T pressure) const {
        return std::erf(std::sqrt(T(2)) * pressure / (modulus_ * rms_gradient()));
    }

    /// log(p/Pa) and its slope against eta, the separation over the rms height.
    /// \throws domain_error unless the pressure of \p eta is within reach.
    [[nodiscard]] LogSlope<T> log_pressure(T eta) const {
        detail::require(eta > 0 && std::isfinite(eta), "eta", eta,
                        "finite and greater than 0 (separation over rms height)");
        const T full = largest_pressure();
        // d = u0 ln(p0/p) for light loads, from the pressure E g
        const T guess = std::log(modulus_ * rms_gradient()) - eta * rms_height_ / light_load_length() - T(0.5);
        return this->searched_log_pressure(
            eta, std::log(full * std::numeric_limits<T>::epsilon()) - 60, std::log(full), guess,
            "within the reach of the model: pressures up to 18 E g, and not 1e-42 of that");
    }

    [[nodiscard]] T rms_height() const { return rms_height_; }
    /// g, of all waves of the spectrum.
    [[nodiscard]] T rms_gradient() const { return static_cast<T>(gradient_); }
    [[nodiscard]] T effective_modulus() const { return modulus_; }
    [[nodiscard]] T gamma() const { return gamma_; }
    /// u0 = sqrt(2/pi) gamma int dG/q [m]: K = p/u0 for light loads.
    [[nodiscard]] T light_load_length() const { return light_load_length_; }
    /// 18 E g [Pa]: beyond exp(2 (p/E g)^2) leaves the range of numbers, and all is in contact from about 2 E g on.
    [[nodiscard]] T largest_pressure() const { return 18 * modulus_ * rms_gradient(); }
    /// 0.75 E g [Pa]: 0.88 of the area is in contact. No comparison goes beyond it.
    [[nodiscard]] T largest_compared_pressure() const { return T(0.75) * modulus_ * rms_gradient(); }
    /// \throws domain_error unless \p pressure [Pa] is positive and at most largest_compared_pressure().
    void require_compared(T pressure) const {
        detail::require_positive("pressure", pressure);
        detail::require(pressure <= largest_compared_pressure(), "pressure", pressure,
                        "at most 0.75 E g: closed beyond, the bulk carries the load (Pa)");
    }

private:
    PerssonContact(std::vector<detail::GradientPiece<double>> pieces, T rms_height, T effective_modulus, T gamma,
                   T closing)
        : modulus_(effective_modulus),
          gamma_(gamma),
          rms_height_(rms_height),
          energy_(detail::persson_energy(static_cast<double>(gamma), static_cast<double>(closing))),
          gradient_(pieces.back().to),
          pieces_(std::move(pieces)) {
        detail::require_positive("effective_modulus", effective_modulus);
        detail::require(gamma > 0 && gamma <= 1, "gamma", gamma, "greater than 0 and at most 1");
        detail::require(closing >= 0 && closing <= 1, "closing", closing, "at least 0 and at most 1");
        make_panels();
    }

    static constexpr std::size_t points = 16;  ///< a panel
    static constexpr int panels = 60;          ///< octaves of G below g
    static constexpr T error_of_K = 64 * std::numeric_limits<T>::epsilon();

    static double root_2_over_pi() { return std::sqrt(2 / std::numbers::pi); }
    [[nodiscard]] int nodes() const { return static_cast<int>(inverse_.size()); }

    /// x/G from which on f is 1e-26 of its value at g.
    [[nodiscard]] double last_y(double x) const { return std::sqrt(x / gradient_ * (x / gradient_) + 30); }

    void require_reach(T pressure) const {
        detail::require_positive("pressure", pressure);
        if (!(pressure <= largest_pressure())) [[unlikely]]
            detail::require(false, "pressure", pressure, "at most 18 E g: all is in full contact there (Pa)");
    }

    /// Integrates the spectrum against the Lagrange polynomials of each panel.
    void make_panels() {
        const auto& rule = math::GaussLegendre<double, points>::get();
        const double log_2 = std::log(2.0);
        using Polynomials = Eigen::Array<double, static_cast<int>(points), 1>;
        Polynomials scale;  // of the Lagrange polynomials
        for (std::size_t j = 0; j < points; ++j) {
            double& of_node = scale[static_cast<Eigen::Index>(j)] = 1;
            for (std::size_t k = 0; k < points; ++k)
                if (k != j) of_node /= rule.node[j] - rule.node[k];
        }
        weight_.assign(points * panels, 0.0);
        inverse_.resize(points * panels);
        double total = 0;
        for (std::size_t panel = 0; panel < panels; ++panel) {
            const double top = std::ldexp(gradient_, -static_cast<int>(panel)), bottom = top / 2;
            for (std::size_t j = 0; j < points; ++j)  // G falls, so that x = p/(E G) ascends
                inverse_[panel * points + j] = std::exp2((1 + rule.node[j]) / 2) / top;
            for (const auto& piece : pieces_) {
                const double from = (std::max)(piece.from, bottom), to = (std::min)(piece.to, top);
                if (!(from < to)) continue;
                for (std::size_t i = 0; i < points; ++i) {
                    const double u = (1 + rule.node[i]) / 2 * std::log(to / from), gradient = from * std::exp(u);
                    const double mass = rule.weight[i] / 2 * std::log(to / from) * gradient * piece.inverse_q(gradient);
                    const double t = 2 * std::log(top / gradient) / log_2 - 1;
                    total += mass;
                    Polynomials lagrange = scale;  // all at once
                    for (std::size_t k = 0; k < points; ++k) {
                        const double without_own_node = lagrange[static_cast<Eigen::Index>(k)];
                        lagrange *= t - rule.node[k];
                        lagrange[static_cast<Eigen::Index>(k)] = without_own_node;
                    }
                    Eigen::Map<Polynomials>(&weight_[panel * points]) += mass * lagrange;
                }
            }
        }
        light_load_length_ = static_cast<T>(root_2_over_pi() * static_cast<double>(gamma_) * total);
    }

    /// sink(G, weight) over the spectrum in panels of its own, short where exp(-2 (x/G)^2) falls quickly, from the top
    /// down. Four points are as good as sixteen in a panel ten times shorter than that: most shells of a map are.
    template <class Sink>
    void directly(double x, const Sink& sink) const {
        const auto part = [&](const auto& piece, double from, double to, const auto& rule) {
            for (std::size_t i = 0; i < rule.node.size(); ++i) {
                const double gradient = (from + to) / 2 + (to - from) / 2 * rule.node[i];
                sink(gradient, rule.weight[i] * (to - from) / 2 * piece.inverse_q(gradient));
            }
        };
        const double least = x / last_y(x);
        for (auto piece = pieces_.rbegin(); piece != pieces_.rend() && piece->to > least; ++piece)
            for (double to = piece->to; to > piece->from && to > least;) {
                const double ratio = x / to, length = (std::min)(0.5, 1 / (1 + ratio * ratio));
                const double from = (std::max)(piece->from, to * std::exp(-length));
                if (to - from < length / 10 * to)
                    part(*piece, from, to, math::GaussLegendre<double, 4>::get());
                else
                    part(*piece, from, to, math::GaussLegendre<double, points>::get());
                to = from;
            }
    }

    struct Sums {
        double value;      ///< int f(p/(E G)) dG/q [m]
        double log_slope;  ///< d ln value/d ln p; 0 without slope
    };

    template <bool with_slope>
    [[nodiscard]] Sums sums(T pressure) const {
        using V = math::Lanes<double, 8>;
        const double x = static_cast<double>(pressure) / static_cast<double>(modulus_), root_2 = std::sqrt(2.0);
        const double dP = 2 * root_2 / std::sqrt(std::numbers::pi);  // dP/dx = dP exp(-2 x^2)
        const auto erf = math::ErfPolynomials::for_tolerance(0);
        const detail::PerssonEnergy<V> energy{V::all(energy_.gamma), V::all(energy_.square), V::all(energy_.late)};
        V values = V::all(0.0), slopes = V::all(0.0);
        const auto add = [&](const V& y, const V& weight, double least, double most) {
            const V fall = exp(V::all(-2.0) * y * y);
            const V P = math::erf_ascending(V::all(root_2) * y, root_2 * least, root_2 * most, erf);
            const V bracket = energy.value(P);
            values = multiply_add(weight * fall, bracket, values);
            if constexpr (with_slope) {
                const V change = multiply_add(energy.slope(P) * V::all(dP), fall, V::all(-4.0) * y * bracket);
                slopes = multiply_add(weight * fall * y, change, slopes);
            }
        };
        if (2 * x > gradient_) {
            alignas(64) std::array<double, 8> ys, weights;
            std::size_t count = 0;
            const auto take = [&](double y, double weight) {
                ys[count] = y, weights[count] = weight;
                if (++count < 8) return;
                const auto [least, most] = std::minmax_element(ys.begin(), ys.end());
                add(V::load(ys.data()), V::load(weights.data()), *least, *most);
                count = 0;
            };
            directly(x, [&](double gradient, double weight) { take(x / gradient, weight); });
            while (count > 0) take(ys[0], 0.0);
        } else {
            const double last = last_y(x);
            for (std::size_t i = 0; i < inverse_.size() && x * inverse_[i] < last; i += 8)
                add(V::all(x) * V::load(&inverse_[i]), V::load(&weight_[i]), x * inverse_[i], x * inverse_[i + 7]);
        }
        alignas(64) std::array<double, 8> v, s;
        values.store(v.data());
        slopes.store(s.data());
        double value = 0, slope = 0;
        for (std::size_t i = 0; i < 8; ++i) value += v[i], slope += s[i];
        return {value, slope / value};
    }

    T modulus_, gamma_, rms_height_{}, light_load_length_{};
    detail::PerssonEnergy<double> energy_;
    double gradient_{};
    std::vector<detail::GradientPiece<double>> pieces_;
    std::vector<double> inverse_, weight_;  ///< 1/G and the weights of f, panel by panel from the top
};

}}  // namespace fstiff
