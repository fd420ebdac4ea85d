// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Parameters of a surface with their standard errors, and random surfaces drawn about them.
///
///     x = value exp(s z),  s^2 = ln(1 + (error/value)^2)      sigma, R, D_p: lognormal, the value is the median
///     x = value + error z                                     D in (1, 2), r in [0, 1), theta in (0, pi/2): truncated
///     z                                                       standard normal, with the correlation of the errors
///
/// The form of each parameter is in its row of surface/parameter.hpp. A draw with D, r or theta out of range is
/// repeated as a whole. An error of 0 gives the value itself.
/// Reference   Box, Muller, Ann. Math. Stat. 29 (1958); math/statistics.hpp: a seed gives the same random bits on every
///             platform; values agree to the rounding of log, cos, exp and eigenvectors
/// Units       SI
/// Valid       values in the range of each parameter, errors finite and not negative, correlation positive semidefinite
///             (eigenvalues below -1e-9 are refused)

#include <fstiff/math/decompositions.hpp>
#include <fstiff/math/random.hpp>
#include <fstiff/math/statistics.hpp>
#include <fstiff/measure/lay.hpp>
#include <fstiff/measure/long_waves.hpp>
#include <fstiff/measure/measurement.hpp>
#include <fstiff/measure/plain_form.hpp>
#include <fstiff/measure/sections.hpp>
#include <fstiff/measure/unmeasured_waves.hpp>
#include <fstiff/surface/parameter.hpp>
#include <fstiff/topography/island_spread.hpp>
#include <fstiff/topography/scan_lines.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <string>

namespace fstiff { inline namespace v0_1 {

namespace detail {

/// Correlation matrix of the parameters of a surface; rows and columns in the order of Parameter.
template <Real T>
using ParameterCorrelation = std::array<std::array<T, surface_parameter_count>, surface_parameter_count>;

/// Correlation matrix of independent parameters: the identity.
template <Real T>
[[nodiscard]] constexpr ParameterCorrelation<T> uncorrelated() {
    ParameterCorrelation<T> identity{};
    for (std::size_t i = 0; i < surface_parameter_count; ++i) identity[i][i] = T(1);
    return identity;
}

}  // namespace detail

/// Parameters of a measured surface, each with its standard error.
template <Real T = double>
struct SurfaceParameters {
    Measurement<T> rms_height;       ///< sigma [m]
    Measurement<T> peak_radius;      ///< R [m]; 0: not known
    Measurement<T> peak_density;     ///< D_p [1/m^2]; 0: not known
    Measurement<T> max_peak_height;  ///< R_p [m]; the error is a lower bound
    std::optional<Measurement<T>> fractal_dimension;
    std::optional<Measurement<T>> fractal_roughness;  ///< G [m]
    T log_fractal_roughness_error{};                  ///< standard deviation of ln G
    T dimension_window_error{};                       ///< share of the window of lags in the error of D
    std::optional<Measurement<T>> r, theta;           ///< theta [rad]
    std::string why_no_dimension, why_no_peaks;       ///< why there is no D, no r and theta; empty when there are
    std::string why_no_density;                       ///< why there is no D_p, of a map no R either
    /// Correlation of the errors; those of different origin (D; the islands of a map) are assumed independent.
    detail::ParameterCorrelation<T> correlation = detail::uncorrelated<T>();
    LengthRange<T> window;        ///< lags that gave D, of the direction with the smaller error [m]; 0 to 0: none
    T long_wave_share{};          ///< of the mean square height in waves longer than an eighth of the surface
    LongEnd<T> long_end{};        ///< waves of a larger contact beyond these
    bool anisotropic{};           ///< of a map
    Repetition<T> repetition{};   ///< of a profile
    PlainForm<T> plain_form{};    ///< none where the mean alone, or nothing, was removed
    T texture_aspect_ratio{1};    ///< Str of a map
    ScanAxis offset_lines{};      ///< lines of a map that have offsets; automatic: none seen
    T line_step{};                ///< rms step between them [m]
    bool curved{};                ///< no clean power law in the window
    std::size_t peaks_counted{};  ///< number of peaks for R and D_p
    std::size_t blocks{};         ///< independent parts that the errors come from
    T block_length{};             ///< of a profile [m]
    std::uint64_t seed{};
    std::optional<FractalFit<T>> profile_fit;         ///< fit of D and G of a profile; else see why_no_dimension
    std::optional<DirectionalFit<T>> map_fit;         ///< same for a map; without x and y where neither can be fitted
    std::optional<RepresentativeIslands<T>> islands;  ///< source of R and D_p of a map, PeakSource::islands

    /// Pointer to \p parameter; null where it is not known, or is no parameter of a surface.
    [[nodiscard]] const Measurement<T>* find(Parameter parameter) const { return find_in(*this, parameter); }
    [[nodiscard]] Measurement<T>* find(Parameter parameter) { return find_in(*this, parameter); }
    /// \throws domain_error for a parameter that is not of a surface.
    void set(Parameter parameter, const Measurement<T>& measured);
    /// Values in the order of Parameter; 0 where not known.
    [[nodiscard]] std::array<T, detail::surface_parameter_count> values() const;
    /// \throws domain_error naming the parameter that is out of range.
    void validate() const;

private:
    template <class Self>
    static auto find_in(Self& self, Parameter parameter) -> decltype(&self.rms_height);
};

namespace detail {

/// Sampler of surfaces, one per call.
template <Real T = double>
class SurfaceSampler {
public:
    /// \throws domain_error as SurfaceParameters::validate().
    SurfaceSampler(const SurfaceParameters<T>& surface, std::uint64_t seed);
    /// Draws a surface in the order of Parameter; unknown parameters stay 0.
    /// \throws domain_error when 1000 draws in a row leave the range of D, r or theta.
    [[nodiscard]] std::array<T, surface_parameter_count> operator()();

private:
    std::array<std::optional<Measurement<T>>, surface_parameter_count> known_{};
    std::array<std::array<T, surface_parameter_count>, surface_parameter_count> root_{};  ///< of the correlation
    std::uint64_t state_;
};

}  // namespace detail

template <Real T>
template <class Self>
auto SurfaceParameters<T>::find_in(Self& self, Parameter parameter) -> decltype(&self.rms_height) {
    const auto known = [](auto& measurement) { return measurement ? &*measurement : nullptr; };
    const auto unless_zero = [](auto& measurement) { return measurement.value != T(0) ? &measurement : nullptr; };
    switch (parameter) {
        case Parameter::rms_height: return &self.rms_height;
        case Parameter::peak_radius: return unless_zero(self.peak_radius);
        case Parameter::peak_density: return unless_zero(self.peak_density);
        case Parameter::fractal_dimension: return known(self.fractal_dimension);
        case Parameter::r: return known(self.r);
        case Parameter::theta: return known(self.theta);
        default: return nullptr;
    }
}

template <Real T>
void SurfaceParameters<T>::set(Parameter parameter, const Measurement<T>& measured) {
    if (detail::index_of(parameter) >= detail::surface_parameter_count)
        throw domain_error(std::string(name_of(parameter)) +
                           ": is not a parameter of a surface; must be one that SurfaceParameters holds");
    switch (parameter) {
        case Parameter::rms_height: rms_height = measured; break;
        case Parameter::peak_radius: peak_radius = measured; break;
        case Parameter::peak_density: peak_density = measured; break;
        case Parameter::fractal_dimension: fractal_dimension = measured; break;
        case Parameter::r: r = measured; break;
        default: theta = measured;
    }
}

template <Real T>
std::array<T, detail::surface_parameter_count> SurfaceParameters<T>::values() const {
    std::array<T, detail::surface_parameter_count> result{};
    for (std::size_t i = 0; i < detail::surface_parameter_count; ++i)
        if (const auto* measurement = find(detail::parameter_table[i].parameter)) result[i] = measurement->value;
    return result;
}

template <Real T>
void SurfaceParameters<T>::validate() const {
    const auto known = [&](std::size_t i) { return find(detail::parameter_table[i].parameter); };
    for (std::size_t i = 0; i < detail::surface_parameter_count; ++i) {
        if (!known(i)) continue;
        const auto [value, error] = *known(i);
        const detail::ParameterRow& row = detail::parameter_table[i];
        detail::require(detail::parameter_in_range(row.parameter, value), row.key, value, row.range());
        detail::require(error >= T(0) && error <= (std::numeric_limits<T>::max)(), std::string(row.key) + " error",
                        error, "finite and not negative");
        for (std::size_t j = 0; j < detail::surface_parameter_count; ++j)
            detail::require(
                !known(j) || (std::abs(correlation[i][j]) <= T(1) && correlation[i][j] == correlation[j][i]),
                "correlation", correlation[i][j], "symmetric, between -1 and 1");
        detail::require(correlation[i][i] == T(1), "correlation of a parameter with itself", correlation[i][i], "1");
    }
}

namespace detail {

template <Real T>
SurfaceSampler<T>::SurfaceSampler(const SurfaceParameters<T>& surface, std::uint64_t seed) : state_(seed) {
    surface.validate();
    for (std::size_t i = 0; i < surface_parameter_count; ++i)
        if (const auto* measurement = surface.find(parameter_table[i].parameter)) known_[i] = *measurement;
    constexpr auto size = static_cast<Eigen::Index>(surface_parameter_count);
    Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic> correlation(size, size);
    correlation.setIdentity();
    for (std::size_t i = 0; i < surface_parameter_count; ++i)
        for (std::size_t j = 0; j < surface_parameter_count; ++j)
            if (known_[i] && known_[j])
                correlation(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = surface.correlation[i][j];
    // symmetric root: also valid for a correlation of exactly 1, or one rounded to a few digits
    const auto [values, vectors] = math::symmetric_eigen<T>(correlation);
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
        for (T& normal : z) normal = math::normal_pair<T>(state_).real();
        std::array<T, surface_parameter_count> draw{};
        bool inside = true;
        for (std::size_t i = 0; i < surface_parameter_count; ++i) {
            if (!known_[i]) continue;
            const T deviation = std::inner_product(z.begin(), z.end(), root_[i].begin(), T(0));
            const auto [value, error] = *known_[i];
            const T relative = error / value;
            const ParameterRow& row = parameter_table[i];
            draw[i] = row.variation == Variation::log
                          ? value * std::exp(std::sqrt(std::log1p(relative * relative)) * deviation)
                          : value + error * deviation;
            inside = inside && parameter_in_range(row.parameter, draw[i]);
        }
        if (inside) return draw;
    }
    throw domain_error("errors so large that 1000 draws in a row leave the range of D, r or theta: must be smaller");
}

}  // namespace detail

}}  // namespace fstiff
