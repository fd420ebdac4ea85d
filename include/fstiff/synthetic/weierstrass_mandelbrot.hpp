// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Weierstrass-Mandelbrot profiles: sums of cosines whose wavelengths fall geometrically.
///
///     z(x) = G^(D-1) sum_n gamma^(-(2-D)n) cos(2 pi (gamma^n x + phi_n))            eq. (2.1)
///          = sum_j a_j cos(2 pi (x/lambda_j + phi_j)),  lambda_j = lambda_0 gamma^-j,  a_j = G^(D-1) lambda_j^(2-D)
///     S(tau) = sum_j 2 a_j^2 sin^2(pi tau/lambda_j)                                 mean over random phases
///
/// The longest wavelength lambda_0 is given, so that the profile does not depend on the unit of length. The paper's
/// profile is {.longest_wavelength = 1, .shortest_wavelength = gamma^-n_max, .random_phases = false}.
///
/// Reference   Buczkowski et al., Arch. Mech. 66 (2014), eq. (2.1); Berry, Lewis, Proc. R. Soc. A 370 (1980)
/// Units       lengths [m]; phases in turns
/// Valid       1 < D < 2, G > 0, gamma > 1, longest >= shortest > 0, at most 10000 terms
/// Accuracy    1e-12 of the amplitudes for 2^16 points in double, 2e-11 where long double is double
///             (tests/synthetic/weierstrass_mandelbrot_test.cpp)

#include <fstiff/core/error.hpp>
#include <fstiff/math/random.hpp>
#include <fstiff/math/statistics.hpp>
#include <fstiff/profile/profile.hpp>
#include <fstiff/surface/fractal.hpp>

#include <numbers>

namespace fstiff { inline namespace v0_1 {

/// Waves of the profile of Weierstrass and Mandelbrot.
template <Real T = double>
struct WeierstrassMandelbrotOptions {
    T longest_wavelength{};     ///< lambda_0 [m]
    T shortest_wavelength{};    ///< terms with lambda_j below this are left out [m]
    T gamma = T(1.5);           ///< ratio of successive wavelengths
    bool random_phases = true;  ///< else all are zero
    std::uint64_t seed = 1;     ///< of the random phases
};

namespace detail {

/// The fraction of a turn in \p turns, as an integer: 2^64 is one turn.
inline std::uint64_t turn_fraction(long double turns) {
    const long double fraction = turns - std::floor(turns);
    const long double scaled = std::ldexp(fraction, 64);
    // fraction may round up to 1, and where long double is double so may the scaled value: both mean no turn at all
    return scaled >= 18446744073709551616.0L ? 0 : static_cast<std::uint64_t>(scaled);
}

}  // namespace detail

/// A profile of Weierstrass and Mandelbrot, (2.1).
template <Real T = double>
class WeierstrassMandelbrot {
public:
    /// \throws domain_error naming the parameter that is out of range.
    WeierstrassMandelbrot(const Fractal<T>& fractal, const WeierstrassMandelbrotOptions<T>& options) {
        detail::require_fractal_dimension(fractal.dimension);
        detail::require_positive("fractal_roughness", fractal.roughness);
        detail::require_positive("longest_wavelength", options.longest_wavelength);
        detail::require_positive("shortest_wavelength", options.shortest_wavelength);
        detail::require(options.longest_wavelength >= options.shortest_wavelength, "shortest_wavelength",
                        options.shortest_wavelength, "at most the longest wavelength");
        detail::require(options.gamma > T(1) && options.gamma <= (std::numeric_limits<T>::max)(), "gamma",
                        options.gamma, "finite and greater than 1");
        const long double decades = std::log(static_cast<long double>(options.longest_wavelength)) -
                                    std::log(static_cast<long double>(options.shortest_wavelength));
        const long double last = decades / std::log(static_cast<long double>(options.gamma));
        detail::require(last < 10000, "gamma", options.gamma,
                        "so large that at most 10000 waves fit between the two wavelengths");
        // a shortest wavelength that was computed as longest * gamma^-n counts as reached
        const auto count = static_cast<std::size_t>(last + 1e-6L) + 1;
        std::uint64_t state = options.seed;
        for (std::size_t j = 0; j < count; ++j) {
            const long double share = std::pow(static_cast<long double>(options.gamma), -static_cast<long double>(j));
            const long double wavelength = options.longest_wavelength * share;
            const T ratio = static_cast<T>(fractal.roughness / wavelength);
            const T amplitude = static_cast<T>(wavelength) * std::pow(ratio, fractal.dimension - 1);
            terms_.push_back({amplitude, wavelength, options.random_phases ? math::splitmix64(state) : 0});
        }
    }

    /// z(x) [m]. The phase of a wave carries the rounding of x/lambda_j; sample() does not.
    [[nodiscard]] T operator()(T x) const {
        detail::require(std::abs(x) <= (std::numeric_limits<T>::max)(), "x", x, "finite");
        T height = 0;
        for (const Term& term : terms_)
            height += term.amplitude * cosine(term.phase + detail::turn_fraction(x / term.wavelength));
        return height;
    }

    /// z at x = 0, spacing, 2 spacing, ... [m]. \throws domain_error unless \p spacing > 0.
    [[nodiscard]] Profile<T> sample(std::size_t points, T spacing) const {
        detail::require_positive("spacing", spacing);
        Profile<T> profile{std::vector<T>(points, T(0)), spacing};
        // shortest waves first: small amplitudes are added before the large ones
        for (auto term = terms_.rbegin(); term != terms_.rend(); ++term) {
            const std::uint64_t step = detail::turn_fraction(spacing / term->wavelength);
            std::uint64_t turn = term->phase;
            for (T& height : profile.heights) {
                height += term->amplitude * cosine(turn);
                turn += step;  // modulo one turn
            }
        }
        return profile;
    }

    /// Mean of [z(x + lag) - z(x)]^2 over random phases [m^2].
    [[nodiscard]] T structure_function(T lag) const {
        T sum = 0;
        for (auto term = terms_.rbegin(); term != terms_.rend(); ++term) {
            const T sine = std::sin(std::numbers::pi_v<T> * static_cast<T>(std::fmod(lag / term->wavelength, 1.0L)));
            sum += 2 * term->amplitude * term->amplitude * sine * sine;
        }
        return sum;
    }

    /// Mean of z^2 over random phases [m^2].
    [[nodiscard]] T variance() const {
        T sum = 0;
        for (const Term& term : terms_) sum += term.amplitude * term.amplitude / 2;
        return sum;
    }

    [[nodiscard]] std::size_t terms() const { return terms_.size(); }

private:
    struct Term {
        T amplitude;
        long double wavelength;
        std::uint64_t phase;  // 2^64 is one turn
    };
    static T cosine(std::uint64_t turn) {
        // signed fraction in [-1/2, 1/2): the argument of cos stays in its most accurate range
        const auto half_turns = static_cast<T>(static_cast<std::int64_t>(turn)) * T(0x1p-63L);
        return std::cos(std::numbers::pi_v<T> * half_turns);
    }
    std::vector<Term> terms_;
};

}}  // namespace fstiff
