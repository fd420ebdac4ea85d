// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// What a surface usually is, by the process that made it: the range of every number that a drawing leaves open.
///
///     Ra/Rq                   Gaussian heights 0.798, cusps of a round tool 0.861, plateaus with scratches less
///     g = slope sqrt(sigma)   g the rms gradient of the surface, sigma in um
///     kurtosis = 3 + 1.5 skewness^2 + tail             tail 0 of heights with the density of a gamma distribution
///     g = sqrt(2) 2.3 (1.3 to 4.4) 2 pi sigma/RSm      of the mean spacing of a profile
///     m2 = D_p sigma^2/0.0425, g^2 = 1.5 sigma/R       of R and D_p of islands, which no Gaussian summits have
///
/// A range is that of 90 % of the surfaces, in the order 5, 50 and 95 %.
///
/// Reference   slope: mean absolute slopes of profiles of metals, 0.152 sigma^0.4 (Tanner, Fahoum, Wear 36 (1976) 299),
///             0.124 sigma^0.743 (Antonetti, White, Simons, J. Electron. Packag. 115 (1993)), 0.076 sigma^0.52
///             (Lambert, Fletcher, J. Thermophys. Heat Transf. 11 (1997) 129), 0.125 sigma^0.402 (unsourced), times
///             sqrt(pi): 0.27, 0.22, 0.13, 0.22 at 1 um; none read, the last two quoted by programs. Five measured
///             surfaces of 0.009 to 34 um gave 0.07 to 0.73. Skewness: turned and eroded faces positive, ground, honed,
///             milled ones negative with a high kurtosis (Whitehouse, Handbook of Surface Metrology, 1994, after
///             Bhushan, Modern Tribology Handbook, 2001, ch. 2; neither read); hard turned ones at fine feeds to -0.52
///             (Molnar, Symmetry 14 (2022) 1591, read in part). The ends of every range, alpha and H: this project's
///             estimate. RSm: 78 Gaussian profiles, alpha 2 to 130, without what is below a tenth of Rz (ISO 4287:1997,
///             quoted by Keyence): 1.3 to 4.4; a tenth of Rp and Rv (MarSurf) gives less, the crossings of Rice (Bell
///             Syst. Tech. J. 24 (1945) 46) 1. Islands: 20 Gaussian maps, alpha 2 to 40 (fstiff measure, peaks =
///             "islands"): 0.040 to 0.050, 1.4 to 2.2, the least where sigma R D_p is.
/// Units       sigma, R [m], D_p [1/m^2], RSm [m]; all else dimensionless
/// Valid       sigma 0.01 to 30 um; the range of the slope widens beyond 0.1 to 10 um
/// Accuracy    nine of ten surfaces, as far as the sources say

#include <fstiff/core/error.hpp>
#include <fstiff/core/names.hpp>
#include <fstiff/core/numbers.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace fstiff::inline v0_1::parts {

/// How a surface was made.
enum class Process { unknown, ground, turned, milled, honed, lapped, polished, blasted, eroded };

/// 5, 50 and 95 % of what is not known.
struct PriorRange {
    double low, middle, high;
};

/// One row of the table.
struct ProcessPrior {
    Process process;
    bool has_lay;              ///< marks in one direction, across which profiles are measured
    PriorRange mean_over_rms;  ///< Ra/Rq, Sa/Sq
    PriorRange slope;          ///< rms gradient at an rms height of 1 um
    PriorRange alpha;          ///< Nayak's m0 m4/m2^2
    PriorRange hurst;
    PriorRange skewness, tail;
};

// clang-format off
/// In the order of Process.
inline constexpr std::array<ProcessPrior, 9> process_priors{{
    //                  lay    Ra/Rq               slope                alpha         H                  skewness             tail
    {Process::unknown,  false, {0.74, 0.80, 0.86}, {0.067, 0.20, 0.60}, {2, 8, 50},  {0.5, 0.8, 1.0}, {-0.4,  0.0, 0.4}, {-0.3,  0.0, 0.6}},
    {Process::ground,   true,  {0.74, 0.79, 0.82}, {0.080, 0.20, 0.50}, {3, 10, 50}, {0.5, 0.8, 1.0}, {-0.8, -0.2, 0.3}, {-0.3,  0.1, 1.0}},
    {Process::turned,   true,  {0.79, 0.84, 0.90}, {0.030, 0.10, 0.35}, {3, 15, 80}, {0.5, 0.8, 1.0}, {-0.1,  0.4, 0.9}, {-0.8, -0.4, 0.4}},
    {Process::milled,   true,  {0.77, 0.82, 0.88}, {0.030, 0.12, 0.40}, {3, 15, 80}, {0.5, 0.8, 1.0}, {-0.6, -0.1, 0.6}, {-0.6, -0.1, 0.8}},
    {Process::honed,    true,  {0.68, 0.76, 0.81}, {0.080, 0.20, 0.50}, {3, 10, 50}, {0.5, 0.8, 1.0}, {-2.2, -1.0, 0.0}, {-0.4,  0.2, 1.5}},
    {Process::lapped,   false, {0.74, 0.79, 0.82}, {0.067, 0.20, 0.60}, {2, 8, 50},  {0.5, 0.8, 1.0}, {-0.8, -0.2, 0.2}, {-0.3,  0.1, 1.0}},
    {Process::polished, false, {0.70, 0.78, 0.82}, {0.020, 0.10, 0.50}, {3, 15, 80}, {0.5, 0.8, 1.0}, {-0.8, -0.1, 0.5}, {-0.3,  0.3, 2.0}},
    {Process::blasted,  false, {0.77, 0.80, 0.82}, {0.100, 0.22, 0.50}, {2, 6, 30},  {0.5, 0.8, 1.0}, {-0.4,  0.0, 0.4}, {-0.3,  0.0, 0.5}},
    {Process::eroded,   false, {0.77, 0.80, 0.82}, {0.120, 0.30, 0.70}, {2, 6, 30},  {0.5, 0.8, 1.0}, {-0.1,  0.3, 0.8}, {-0.3,  0.0, 0.5}}}};
// clang-format on

/// The row of \p process.
[[nodiscard]] constexpr const ProcessPrior& prior_of(Process process) {
    return process_priors[static_cast<std::size_t>(process)];
}

/// The rms gradient of a surface of which the rms height \p rms_height [m] alone is known.
/// \throws domain_error unless it is finite and positive.
[[nodiscard]] inline PriorRange gradient_of_height(const ProcessPrior& prior, double rms_height) {
    require_positive("rms_height", rms_height);
    const double height = rms_height * 1e6, root = std::sqrt(height);
    const double beyond = std::pow((std::max)({1.0, height / 10, 0.1 / height}), 0.25);
    const PriorRange& slope = prior.slope;
    return {slope.low * root / beyond, slope.middle * root, slope.high * root * beyond};
}

/// The rms gradient of a surface over the rms slope of a profile of it: sqrt(2) of an isotropic one, 1 to sqrt(2)
/// across a lay.
[[nodiscard]] inline PriorRange gradient_of_slope(const ProcessPrior& prior) {
    const double root = numbers::sqrt2_v<double>;
    return prior.has_lay ? PriorRange{1, std::sqrt(root), root} : PriorRange{root, root, root};
}

/// The rms slope of a profile with the rms height \p rms_height [m] and the mean spacing \p spacing [m].
/// \throws domain_error unless both are finite and positive.
[[nodiscard]] inline PriorRange slope_of_spacing(double rms_height, double spacing) {
    require_positive("rms_height", rms_height);
    require_positive("RSm", spacing);
    const double rice = 2 * numbers::pi_v<double> * rms_height / spacing;
    return {1.3 * rice, 2.3 * rice, 4.4 * rice};
}

/// The rms gradient of a surface whose R [m] and D_p [1/m^2] are those of islands: the geometric mean of both readings,
/// each known to 10 %, with half of the logarithm of their ratio as a standard error.
/// \throws domain_error unless all are finite and positive.
[[nodiscard]] inline PriorRange gradient_of_islands(double rms_height, double peak_radius, double peak_density) {
    require_positive("rms_height", rms_height);
    require_positive("peak_radius", peak_radius);
    require_positive("peak_density", peak_density);
    const double by_density = std::sqrt(2 * peak_density / 0.0425) * rms_height,
                 by_radius = std::sqrt(1.5 * (rms_height / peak_radius));
    const double middle = std::sqrt(by_density * by_radius);
    const double apart = std::exp(1.645 * std::hypot(std::log(by_radius / by_density) / 2, 0.1));
    return {middle / apart, middle, middle * apart};
}

/// What of a surface may be open.
enum class Unknown { height, gradient, alpha, hurst, skewness, kurtosis };
inline constexpr std::size_t unknown_count = 6;

/// Whether \p which is of the shape of the heights.
[[nodiscard]] constexpr bool is_of_shape(Unknown which) { return which >= Unknown::skewness; }

}  // namespace fstiff::inline v0_1::parts

namespace fstiff::inline v0_1 {

template <>
inline constexpr auto names<parts::Process> = name_list<parts::Process>({{parts::Process::unknown, "unknown"},
                                                                         {parts::Process::ground, "ground"},
                                                                         {parts::Process::turned, "turned"},
                                                                         {parts::Process::milled, "milled"},
                                                                         {parts::Process::honed, "honed"},
                                                                         {parts::Process::lapped, "lapped"},
                                                                         {parts::Process::polished, "polished"},
                                                                         {parts::Process::blasted, "blasted"},
                                                                         {parts::Process::eroded, "eroded"}});

}  // namespace fstiff::inline v0_1
