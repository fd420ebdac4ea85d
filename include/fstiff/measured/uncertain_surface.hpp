// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Surfaces drawn at random about the measured parameters of one, for a band about whatever is computed of them.
///
///     x = value exp(s z),  s^2 = ln(1 + (error/value)^2)      sigma, R, D_p: lognormal, the value is the median
///     x = value + error z                                     D in (1, 2), r in [0, 1), theta in (0, pi/2): truncated
///     z                                                       standard normal, with the correlation of the errors
///
/// Which of the two a parameter takes stands in its row of surface/contact_parameter.hpp.
/// A draw in which D, r or theta leaves its range is drawn again, all of it. An error of 0 gives the value itself.
///
/// Reference   Box, Muller, Ann. Math. Stat. 29 (1958); math/random.hpp: the random
///             bits of a seed are the same on every platform; values agree to the rounding of the local log, cos, exp
///             and eigenvectors
/// Units       SI
/// Valid       values in the range of each parameter, errors finite and not negative, a correlation that is positive
///             semidefinite (an eigenvalue below -1e-9 is refused)

#include <fstiff/math/decompositions.hpp>
#include <fstiff/math/random.hpp>
#include <fstiff/measured/surface_parameters.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace fstiff {

/// The parameters that enter the contact, with errors.
template <Real T = double>
struct UncertainSurface {
    std::array<T, surface_parameter_count> value{}, error{};  ///< in the order of Parameter
    std::array<bool, surface_parameter_count> known{};        ///< D, r and theta may not be
    ParameterCorrelation<T> correlation = uncorrelated<T>();

    /// \throws domain_error for a parameter that is not of the surface.
    constexpr void set(Parameter which, const Measurement<T>& measured) {
        const std::size_t i = index_of(which);
        if (i >= surface_parameter_count)
            throw domain_error(std::string(name_of(which)) +
                               ": is no parameter of a surface; must be one that SurfaceParameters holds");
        value[i] = measured.value, error[i] = measured.error, known[i] = true;
    }
    /// \throws domain_error naming the parameter that is out of range.
    void validate() const;
};

/// The parameters of a measured surface.
template <Real T>
[[nodiscard]] UncertainSurface<T> uncertain(const SurfaceParameters<T>& measured);

/// Draws surfaces, one a call.
template <Real T = double>
class SurfaceSampler {
public:
    /// \throws domain_error as UncertainSurface::validate().
    SurfaceSampler(const UncertainSurface<T>& surface, std::uint64_t seed);
    /// In the order of Parameter; what is not known stays 0.
    /// \throws domain_error when 1000 draws in a row leave the range of D, r or theta.
    [[nodiscard]] std::array<T, surface_parameter_count> operator()();

private:
    UncertainSurface<T> surface_;
    std::array<std::array<T, surface_parameter_count>, surface_parameter_count> root_{};  ///< of the correlation
    std::uint64_t state_;
};

template <Real T>
void UncertainSurface<T>::validate() const {
    for (std::size_t i = 0; i < surface_parameter_count; ++i) {
        if (!known[i]) continue;
        const ParameterRow& row = parameter_table[i];
        require(parameter_in_range(row.parameter, value[i]), row.key, value[i], row.range());
        require(error[i] >= T(0) && error[i] <= (std::numeric_limits<T>::max)(), std::string(row.key) + " error",
                error[i], "finite and not negative");
        for (std::size_t j = 0; j < surface_parameter_count; ++j)
            require(!known[j] || (std::abs(correlation[i][j]) <= T(1) && correlation[i][j] == correlation[j][i]),
                    "correlation", correlation[i][j], "symmetric, between -1 and 1");
        require(correlation[i][i] == T(1), "correlation of a parameter with itself", correlation[i][i], "1");
    }
}

template <Real T>
UncertainSurface<T> uncertain(const SurfaceParameters<T>& measured) {
    UncertainSurface<T> surface;
    surface.set(Parameter::rms_height, measured.rms_height);
    surface.set(Parameter::peak_radius, measured.peak_radius);
    surface.set(Parameter::peak_density, measured.peak_density);
    if (measured.fractal_dimension) surface.set(Parameter::fractal_dimension, *measured.fractal_dimension);
    if (measured.r) surface.set(Parameter::r, *measured.r);
    if (measured.theta) surface.set(Parameter::theta, *measured.theta);
    surface.correlation = measured.correlation;
    return surface;
}

template <Real T>
SurfaceSampler<T>::SurfaceSampler(const UncertainSurface<T>& surface, std::uint64_t seed)
    : surface_(surface), state_(seed) {
    surface_.validate();
    constexpr auto size = static_cast<Eigen::Index>(surface_parameter_count);
    Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic> correlation(size, size);
    correlation.setIdentity();
    for (std::size_t i = 0; i < surface_parameter_count; ++i)
        for (std::size_t j = 0; j < surface_parameter_count; ++j)
            if (surface.known[i] && surface.known[j])
                correlation(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = surface.correlation[i][j];
    // the symmetric root: a correlation of exactly 1, or rounded to a few digits, does it no harm
    const auto [values, vectors] = symmetric_eigen<T>(correlation);
    const T least = *std::min_element(values.data(), values.data() + size);
    const T rounding = (std::max)(T(1e-9), 16 * std::numeric_limits<T>::epsilon());
    require(least >= -rounding, "least eigenvalue of the correlation", least, "at least 0");
    for (Eigen::Index i = 0; i < size; ++i)
        for (Eigen::Index j = 0; j < size; ++j)
            for (Eigen::Index k = 0; k < size; ++k)
                root_[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] +=
                    vectors(i, k) * std::sqrt((std::max)(T(0), values[k])) * vectors(j, k);
}

template <Real T>
std::array<T, surface_parameter_count> SurfaceSampler<T>::operator()() {
    for (int attempt = 0; attempt < 1000; ++attempt) {
        std::array<T, surface_parameter_count> z{};
        for (T& one : z) one = normal_pair<T>(state_).real();
        std::array<T, surface_parameter_count> draw{};
        bool inside = true;
        for (std::size_t i = 0; i < surface_parameter_count; ++i) {
            if (!surface_.known[i]) continue;
            const T one = std::inner_product(z.begin(), z.end(), root_[i].begin(), T(0));
            const T value = surface_.value[i], error = surface_.error[i], relative = error / value;
            const ParameterRow& row = parameter_table[i];
            draw[i] = row.variation == Variation::log
                          ? value * std::exp(std::sqrt(std::log1p(relative * relative)) * one)
                          : value + error * one;
            inside = inside && parameter_in_range(row.parameter, draw[i]);
        }
        if (inside) return draw;
    }
    throw domain_error("errors so large that 1000 draws in a row leave the range of D, r or theta: must be smaller");
}

}  // namespace fstiff
