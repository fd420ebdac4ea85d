// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Usual ranges (5, 50, 95 %) of surface parameters that a drawing leaves open, by the process that made the surface.
///
///     Ra/Rq                   Gaussian heights 0.798, cusps of a round tool 0.861, plateaus with scratches less
///     g = slope sqrt(sigma)   g the rms gradient of the surface, sigma in um
///     kurtosis = 3 + 1.5 skewness^2 + tail             tail 0 for heights with the density of a gamma distribution
///     g = sqrt(2) 2.3 (1.3 to 4.4) 2 pi sigma/RSm      from the mean spacing of a profile
///     m2 = D_p sigma^2/0.0425, g^2 = 1.5 sigma/R       from R and D_p of islands
///     find_process("sand-blasted")                     Process::blasted, by the table of other words
///
/// Reference   docs/theory-surface.md: sources of the slopes and of the ranges, of which several are second-hand
/// Units       sigma, R [m], D_p [1/m^2], RSm [m]; all else dimensionless
/// Valid       sigma 0.01 to 30 um; the range of the slope widens beyond 0.1 to 10 um
/// Accuracy    nine of ten surfaces, according to the sources and to this project's estimate

#include <fstiff/core/error.hpp>
#include <fstiff/core/names.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>

namespace fstiff { inline namespace v0_1 {

/// Process that made a surface.
enum class Process { unknown, ground, turned, milled, honed, lapped, polished, blasted, eroded, superfinished };

/// 5, 50 and 95 % quantiles of an unknown.
struct PriorRange {
    double low, middle, high;
};

}}  // namespace fstiff

namespace fstiff { inline namespace v0_1 { namespace detail {

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
/// Table of the processes, in the order of Process.
inline constexpr std::array<ProcessPrior, 10> process_priors{{
    //                  lay    Ra/Rq               slope                alpha        H                skewness      tail
    {Process::unknown,  false, {0.74, 0.80, 0.86}, {0.067, 0.20, 0.60}, {2, 8, 50},  {0.3, 0.8, 1.0}, {-2.0,  0.0, 0.7}, {-0.5,  0.0, 1.5}},
    {Process::ground,   true,  {0.74, 0.79, 0.82}, {0.080, 0.20, 0.50}, {3, 10, 50}, {0.3, 0.8, 1.0}, {-0.8, -0.2, 0.3}, {-0.3,  0.1, 1.0}},
    {Process::turned,   true,  {0.79, 0.84, 0.90}, {0.030, 0.10, 0.35}, {3, 15, 80}, {0.3, 0.8, 1.0}, {-0.1,  0.4, 0.9}, {-0.8, -0.4, 0.4}},
    {Process::milled,   true,  {0.77, 0.82, 0.88}, {0.030, 0.12, 0.40}, {3, 15, 80}, {0.3, 0.8, 1.0}, {-0.6, -0.1, 0.6}, {-0.6, -0.1, 0.8}},
    {Process::honed,    true,  {0.68, 0.76, 0.81}, {0.080, 0.20, 0.50}, {3, 10, 50}, {0.3, 0.8, 1.0}, {-2.2, -1.0, 0.0}, {-0.4,  0.2, 1.5}},
    {Process::lapped,   false, {0.74, 0.79, 0.82}, {0.067, 0.20, 0.60}, {2, 8, 50},  {0.3, 0.8, 1.0}, {-0.8, -0.2, 0.2}, {-0.3,  0.1, 1.0}},
    {Process::polished, false, {0.70, 0.78, 0.82}, {0.020, 0.10, 0.50}, {3, 15, 80}, {0.3, 0.8, 1.0}, {-2.2, -0.1, 0.5}, {-0.3,  0.3, 2.0}},
    {Process::blasted,  false, {0.77, 0.80, 0.82}, {0.100, 0.22, 0.50}, {2, 6, 30},  {0.3, 0.8, 1.0}, {-0.4,  0.0, 0.4}, {-0.3,  0.0, 0.5}},
    {Process::eroded,   false, {0.77, 0.80, 0.82}, {0.120, 0.30, 0.70}, {2, 6, 30},  {0.3, 0.8, 1.0}, {-0.1,  0.3, 0.8}, {-0.3,  0.0, 0.5}},
    {Process::superfinished, true, {0.68, 0.76, 0.81}, {0.040, 0.15, 0.50}, {3, 10, 50}, {0.3, 0.8, 1.0}, {-2.4, -1.0, 0.0}, {-0.4,  0.2, 1.5}}}};
// clang-format on

/// Row of \p process; a face that is \p worn has the heights of a honed one.
[[nodiscard]] constexpr ProcessPrior prior_of(Process process, bool worn = false) {
    ProcessPrior prior = process_priors[static_cast<std::size_t>(process)];
    if (!worn) return prior;
    const ProcessPrior& honed = process_priors[static_cast<std::size_t>(Process::honed)];
    prior.mean_over_rms = honed.mean_over_rms, prior.skewness = honed.skewness, prior.tail = honed.tail;
    return prior;
}

/// d ln g/d ln sigma of a gradient that follows from the rms height: gradient_of_height(), slope_of_spacing(),
/// gradient_of_islands().
inline constexpr double growth_of_height = 0.5, growth_of_spacing = 1, growth_of_islands = 0.75;

/// Rms gradient of a surface for which only the rms height \p rms_height [m] is known.
/// \throws domain_error unless it is finite and positive.
[[nodiscard]] inline PriorRange gradient_of_height(const ProcessPrior& prior, double rms_height) {
    require_positive("rms_height", rms_height);
    const double height = rms_height * 1e6, root = std::sqrt(height);
    const double beyond = std::pow((std::max)({1.0, height / 10, 0.1 / height}), 0.25);
    const PriorRange& slope = prior.slope;
    return {slope.low * root / beyond, slope.middle * root, slope.high * root * beyond};
}

/// Rms gradient of a surface over the rms slope of its profile: sqrt(2) if isotropic, 1 to sqrt(2) across a lay.
[[nodiscard]] inline PriorRange gradient_of_slope(const ProcessPrior& prior) {
    const double root = std::numbers::sqrt2_v<double>;
    return prior.has_lay ? PriorRange{1, std::sqrt(root), root} : PriorRange{root, root, root};
}

/// Rms slope of a profile with the rms height \p rms_height [m] and the mean spacing \p spacing [m].
/// \throws domain_error unless both are finite and positive.
[[nodiscard]] inline PriorRange slope_of_spacing(double rms_height, double spacing) {
    require_positive("rms_height", rms_height);
    require_positive("RSm", spacing);
    const double rice = 2 * std::numbers::pi * rms_height / spacing;
    return {1.3 * rice, 2.3 * rice, 4.4 * rice};
}

/// Rms gradient of a surface whose R [m] and D_p [1/m^2] are those of islands: the geometric mean of both formulae,
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

}}}  // namespace fstiff::detail

namespace fstiff { inline namespace v0_1 {

/// Properties of a surface, and of the softer body, that may be open.
enum class Unknown { height, gradient, alpha, hurst, hardness, skewness, kurtosis };

}}  // namespace fstiff

namespace fstiff { inline namespace v0_1 { namespace detail {

inline constexpr std::size_t unknown_count = 7;

/// Whether \p unknown describes the shape of the heights.
[[nodiscard]] constexpr bool is_of_shape(Unknown unknown) { return unknown >= Unknown::skewness; }

}}}  // namespace fstiff::detail

namespace fstiff { inline namespace v0_1 {

template <>
inline constexpr auto enum_names<Process> = detail::name_list<Process>({{Process::unknown, "unknown"},
                                                                        {Process::ground, "ground"},
                                                                        {Process::turned, "turned"},
                                                                        {Process::milled, "milled"},
                                                                        {Process::honed, "honed"},
                                                                        {Process::lapped, "lapped"},
                                                                        {Process::polished, "polished"},
                                                                        {Process::blasted, "blasted"},
                                                                        {Process::eroded, "eroded"},
                                                                        {Process::superfinished, "superfinished"}});

}}  // namespace fstiff

namespace fstiff { inline namespace v0_1 { namespace detail {

/// Other words for processes, as is_same_name() compares them. Those without a row above are Process::unknown.
struct ProcessWords {
    Process process;
    std::string_view words;  ///< with commas between them; letters beyond ASCII by their bytes in UTF-8
};

// clang-format off
inline constexpr std::array<ProcessWords, 10> process_words{{
    {Process::unknown, "reamed,reaming,gerieben,rolled,rolling,cold rolled,hot rolled,gewalzt,scraped,scraping,geschabt,"
                       "shot peened,shot peening,peened,peening,kugelgestrahlt,"
                       "burnished,burnishing,roller burnished,rolliert,drilled,drilling,gebohrt,bored,boring,broached,broaching,"
                       "ger\xC3\xA4umt,geraeumt,planed,gehobelt,"
                       "extruded,extrusion,drawn,gezogen,sawn,sawed,ges\xC3\xA4gt,gesaegt,etched,etching,ge\xC3\xA4tzt,geaetzt,pickled,"
                       "gebeizt,anodized,anodised,eloxiert,coated,beschichtet,plated,galvanized,galvanised,verzinkt,painted,lackiert,"
                       "moulded,molded,3D printed,printed,additive,SLM,LPBF,EBM,laser melted,selective laser melted,laser melting,"
                       "sintered,gesintert,laser cut,flame cut,water jet cut,filed,gefeilt,brushed,geb\xC3\xBCrstet,gebuerstet,"
                       "electropolished,electropolishing,elektropoliert,chemically polished,worn,hobbed,machined,machining,"
                       "bearbeitet,as built,unbekannt"},
    {Process::ground,   "grinding,surface ground,surface grinding,cylindrical grinding,cylindrically ground,fine ground,geschliffen,"
                        "schleifen,feingeschliffen,plangeschliffen,flachgeschliffen,rundgeschliffen"},
    {Process::turned,   "turning,lathe,face turned,facing,faced,hard turned,hard turning,finish turned,fine turned,diamond turned,"
                        "gedreht,drehen,plangedreht,feingedreht,hartgedreht"},
    {Process::milled,   "milling,face milled,face milling,end milled,end milling,fly cut,gefr\xC3\xA4st,gefraest,fr\xC3\xA4sen,fraesen,"
                        "plangefr\xC3\xA4st,plangefraest"},
    {Process::honed,    "honing,plateau honed,plateau honing,gehont,honen"},
    {Process::lapped,   "lapping,gel\xC3\xA4ppt,gelaeppt,l\xC3\xA4ppen,laeppen"},
    {Process::polished, "polishing,mechanically polished,mirror polished,buffed,buffing,poliert,polieren"},
    {Process::blasted,  "blasting,sand blasted,sand blasting,grit blasted,grit blasting,bead blasted,bead blasting,shot blasted,"
                        "shot blasting,abrasive blasted,gestrahlt,strahlen,sandgestrahlt,sandstrahlen"},
    {Process::eroded,   "erosion,EDM,EDMed,spark eroded,spark erosion,wire eroded,wire EDM,die sinking,sinker EDM,"
                        "electro discharge machined,electro discharge machining,electrical discharge machined,"
                        "electrical discharge machining,electric discharge machined,erodiert,erodieren,funkenerodiert,"
                        "drahterodiert,senkerodiert"},
    {Process::superfinished, "superfinish,superfinishing,microfinished,microfinishing,short stroke honed,kurzhubgehont,superfiniert"}}};
// clang-format on

/// The process of \p word, its name or another word for it; none of a word that is in neither list.
[[nodiscard]] constexpr std::optional<Process> find_process(std::string_view word) {
    for (const auto& known : enum_names<Process>)
        if (is_same_name(word, known.name)) return known.value;
    for (const ProcessWords& row : process_words)
        for (std::string_view rest = row.words; !rest.empty();) {
            const std::size_t end = (std::min)(rest.find(','), rest.size());
            if (is_same_name(word, rest.substr(0, end))) return row.process;
            rest.remove_prefix((std::min)(end + 1, rest.size()));
        }
    return std::nullopt;
}

/// The same. \throws domain_error with \p parameter for a word that is in neither list.
[[nodiscard]] inline Process process_of(std::string_view word, std::string_view parameter) {
    if (const auto process = find_process(word)) return *process;
    refuse(parameter, "\"" + std::string(word) + "\"",
           "one of " + choices_text<Process>() + ", or another word for one of these; any other process is unknown");
}

}}}  // namespace fstiff::detail
