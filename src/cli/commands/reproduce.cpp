// SPDX-License-Identifier: BSD-3-Clause
// fstiff reproduce: the tables, figures and conclusions of the paper, from its own parameters.
#include "commands/commands.hpp"
#include "input/progress.hpp"
#include "picture/page.hpp"
#include "picture/plot.hpp"
#include "instances/contact_instances.hpp"
#include "instances/surface_instances.hpp"

#include <fstiff/asperity/laws.hpp>
#include <fstiff/asperity/material.hpp>
#include <fstiff/asperity/plastic_laws.hpp>
#include <fstiff/contact/contact_integrals.hpp>
#include <fstiff/contact/greenwood_williamson.hpp>
#include <fstiff/contact/interaction.hpp>
#include <fstiff/contact/rough_contact.hpp>
#include <fstiff/core/version.hpp>
#include <fstiff/peaks/peak_distribution.hpp>
#include <fstiff/profile/fractal_fit.hpp>
#include <fstiff/surface/cut_offs.hpp>
#include <fstiff/synthetic/self_affine.hpp>
#include <fstiff/synthetic/weierstrass_mandelbrot.hpp>
#include <fstiff/topography/islands.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>
#include <numbers>
#include <sstream>
#include <utility>
#include <vector>

namespace fstiff::cli {

extern const char* const errata_page;  // docs/errata.md

namespace reproduce_command {
namespace {

struct Options {
    OutputOptions output;
    std::string folder;
};

constexpr double pi = std::numbers::pi;
constexpr double nominal_area = 195e-6;  // [m^2]
constexpr std::uint64_t seed = 2014;
constexpr const char* no_points =
    "Experimental points are not drawn: they stand in the paper's figures and nowhere in its text or tables.";

constexpr const char* plastic_remark =
    "The curves of plastic peaks are not in the paper: peaks that flow (H = 2.8 Y, θ = π/4, r = 0) as a wave sees "
    "them, "
    "by unloading.";

constexpr const char* remark =
    "The discussion adds that a smoother surface has the larger D; Table 2 has the largest D, 1.70, on the roughest "
    "one.";

/// A row of Tables 1 and 2; the scenes in data/ hold the same numbers.
struct Surface {
    const char *name, *figure;
    Roughness<double> roughness;
    Fractal<double> fractal;
};
const std::array<Surface, 3> surfaces{
    Surface{"sand blasted (fine)", "fig7", {0.832e-6, 40e-6, 500e6, 5.3e-6}, {1.62, 1.2e-8}},
    Surface{"sand blasted (coarse)", "fig8", {5.13e-6, 30e-6, 230e6, 15.3e-6}, {1.58, 1.1e-7}},
    Surface{"electrical discharge machining", "fig9", {8.94e-6, 19e-6, 160e6, 48e-6}, {1.70, 8.2e-7}}};
const Material<double> steel{205e9, 0.3};
constexpr double yield_strength = 400e6;  // [Pa]

struct Bounds {
    double low = std::numeric_limits<double>::infinity(), high = 0;
    void add(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
};

/// What the conclusions are about: the key for machines, its conclusion, and the words for people.
enum class Measure { over_elastic, over_greenwood_williamson, theta_at_pressure, theta_at_separation, shift };
struct Words {
    const char *key, *text;
    int conclusion;
};
constexpr std::array<Words, 5> measures{
    Words{"fractal_over_elastic", "K fractal over K statistical elastic, at equal pressure", 1},
    Words{"fractal_over_greenwood_williamson", "K fractal over K Greenwood-Williamson, at equal pressure", 1},
    Words{"theta_at_equal_pressure", "K(θ = π/3) over K(θ = π/4), at equal pressure", 2},
    Words{"theta_at_equal_separation", "K(θ = π/3) over K(θ = π/4), at equal separation, η from 0 to 3", 2},
    Words{"interaction_shift", "shift Δη of the separation (4.11), from 0.1 to 100 MPa", 3}};

/// One number behind a conclusion.
struct Finding {
    Measure measure;
    std::string surface;
    Bounds range;
    const Words& words() const { return measures[static_cast<std::size_t>(measure)]; }
};

struct Conclusion {
    int number;
    std::string paper, verdict, because;
};

struct Picture {
    std::string name, caption;
    Figure figure;
};

struct Reproduction {
    std::vector<Finding> findings;
    std::vector<Conclusion> conclusions;
    std::vector<std::vector<std::string>> generated;  ///< what came out of the generated surfaces, with a header
    std::vector<Picture> pictures;
    std::vector<std::string> errata;
};

std::vector<double> pressures() {
    std::vector<double> result;
    for (int k = 0; k <= 30; ++k) result.push_back(1e5 * std::pow(10.0, k / 10.0));
    return result;
}

/// The headings of the page of errata.
std::vector<std::string> errata() {
    std::vector<std::string> titles;
    std::istringstream page(errata_page);
    for (std::string line; std::getline(page, line);)
        if (line.starts_with("### ")) titles.push_back(line.substr(4));
    return titles;
}

Picture figure_2() {
    Panel panel{.x = {.label = "height of a peak ζ = z/σ", .logarithmic = false},
                .y = {.label = "probability density", .logarithmic = false, .low = 0.0}};
    const auto height = [](std::size_t k) { return (static_cast<int>(k) - 80) / 20.0; };
    int colour = 0;
    for (const auto& [r, name, stroke] : {std::tuple{1.0 / 2, "1/2", Stroke::dotted},
                                          {1.0 / 3, "1/3", Stroke::solid},
                                          {1.0 / 5, "1/5", Stroke::dashed}}) {
        const PeakDistribution<double> peaks(r, pi / 3);
        panel.lines.push_back(
            line_of(std::string("r = ") + name, 161, height, [&](auto k) { return peaks.height_marginal(height(k)); }));
        panel.lines.back().colour = colour++;
        panel.lines.back().stroke = stroke;
    }
    panel.lines.push_back(line_of("Gaussian heights of all ordinates", 161, height, [](std::size_t k) {
        const int n = static_cast<int>(k) - 80;
        return std::exp(-n * n / 800.0) / std::sqrt(2 * pi);
    }));
    panel.lines.back().colour = neutral;
    panel.lines.back().stroke = Stroke::dotted;
    return {"fig2",
            "Fig. 2: density of the heights of the peaks for θ = π/3, eq. (4.4) integrated over the curvature.",
            {.title = "Fig. 2: heights of the peaks, θ = π/3", .panels = {panel}}};
}

Picture figure_4(Reproduction& all) {
    const ProgressHook bar = progress_bar();
    Panel densities{.title = "Density of islands",
                    .x = {.label = "bearing area [%]", .logarithmic = false, .low = 0.0, .high = 100.0},
                    .y = {.label = "islands [1/mm²]", .logarithmic = false, .low = 0.0},
                    .height = 300};
    Panel radii{.title = "Radius of the mean island",
                .x = {.label = "bearing area [%]", .logarithmic = false, .low = 0.0, .high = 50.0},
                .y = {.label = "R [µm]", .high = 1000.0},
                .height = 260};
    for (const Surface& surface : surfaces) {
        const double hurst = 2 - surface.fractal.dimension;
        const double longest = longest_wave(surface.fractal, surface.roughness.rms_height);
        const double most = std::pow(2 * pi, -1.5) * std::exp(-0.5);  // islands over m2/m0 of a Gaussian surface
        const double shortest = shortest_wave(hurst, longest, surface.roughness.peak_density / most);
        constexpr std::size_t points = 1024;
        const double spacing = shortest / 4;
        SelfAffineOptions<double> options{.hurst = hurst,
                                          .rms = surface.roughness.rms_height,
                                          .longest_wavelength = longest,
                                          .shortest_wavelength = shortest,
                                          .long_waves = LongWaves::none,
                                          .seed = seed};
        const HeightMap<double> map = self_affine_map<double>(options, points, points, spacing, spacing);
        IslandOptions<double> how;
        IslandSpread spread{.tiles = 4, .resamples = 200, .seed = seed};
        if (bar) {  // one bar for the three maps; the sweep of a map takes nearly all the time
            const auto before = static_cast<std::size_t>(&surface - surfaces.data());
            how.progress = [&bar, before](std::string_view, std::size_t done, std::size_t of) {
                bar("maps of Fig. 4", before * of + done, 3 * of);
            };
        }
        const auto islands = representative_islands(map, how, spread);
        const auto& curve = islands.curve;
        const auto share = [&](auto k) { return 100 * curve.bearing_area[k]; };
        densities.lines.push_back(
            line_of(surface.name, curve.size(), share, [&](auto k) { return curve.density[k] * 1e-6; }));
        radii.lines.push_back(
            line_of(surface.name, curve.size(), share, [&](auto k) { return curve.radius[k] * 1e6; }));
        const auto row = [&](const std::string& quantity, const std::string& value, const std::string& table) {
            all.generated.push_back({"Fig. 4", surface.name, quantity, value, table});
        };
        row("longest wave [mm]", rounded(longest * 1e3, 3), "from σ, D, G");
        row("shortest wave [µm]", rounded(shortest * 1e6, 3), "from D_p, by 0.0385 m2/m0");
        row("bearing area at most islands [%]", rounded(100 * islands.bearing_area, 3), "about 20");
        row("D_p [1/mm²]", rounded(islands.density * 1e-6, 4) + " ± " + rounded(islands.density_error * 1e-6, 2),
            rounded(surface.roughness.peak_density * 1e-6));
        row("R [µm]", rounded(islands.radius * 1e6, 3) + " ± " + rounded(islands.radius_error * 1e6, 2),
            rounded(surface.roughness.peak_radius * 1e6));
    }
    densities.windows.push_back({"about 20 %, the paper", 18, 22});
    Figure figure{.title = "Fig. 4: islands against the bearing area, generated maps",
                  .panels = {densities, radii},
                  .note = "Gaussian self-affine maps of 1024 × 1024 points, D, G and σ of Tables 1 and 2, seed 2014"};
    return {"fig4",
            "Fig. 4, from generated maps: the measured ones are not in the text. D, G and σ fix the longest wave; the "
            "shortest one is chosen for the density of Table 1, so that the density is put in, while the bearing area "
            "of its maximum and the radius come out.",
            figure};
}

/// \p value [m^2] at the lags of \p s, in µm and µm².
template <class Value>
PlotLine curve_of(const char* label, int colour, const StructureFunction<double>& s, const Value& value) {
    PlotLine line = line_of(
        label, s.size(), [&](auto k) { return s.lag[k] * 1e6; }, [&](auto k) { return value(k) * 1e12; });
    line.colour = colour;
    line.sets_range = false;
    return line;
}

/// Nine points a decade of \p s.
PlotLine points_of(const char* label, int colour, Marker marker, const StructureFunction<double>& s) {
    StructureFunction<double> few;
    for (std::size_t k = 0; k < s.size(); ++k)
        if (few.lag.empty() || s.lag[k] >= 1.3 * few.lag.back()) {
            few.lag.push_back(s.lag[k]);
            few.value.push_back(s.value[k]);
        }
    PlotLine line = curve_of(label, colour, few, [&](auto k) { return few.value[k]; });
    line.stroke = Stroke::none;
    line.marker = marker;
    line.sets_range = true;
    return line;
}

Picture figure_6(Reproduction& all) {
    const Surface& surface = surfaces[0];
    const double spacing = 0.5e-6;
    constexpr std::size_t points = 16000;  // 8 mm
    const double longest = longest_cosine(surface.fractal, surface.roughness.rms_height);
    const WeierstrassMandelbrot<double> wm(
        surface.fractal, {.longest_wavelength = longest, .shortest_wavelength = 2 * spacing, .seed = seed});
    const Profile<double> profile = wm.sample(points, spacing);
    FractalFitOptions<double> options;
    options.seed = seed;
    const FractalFit<double> fit = fit_fractal(profile, options);
    const StructureFunction<double>&first = fit.structure_function, &second = fit.second_differences;
    const PlotLine measured = points_of("S of the profile, eq. (2.8)", 0, Marker::circle, first),
                   summed = curve_of("S of the cosines that were summed", 0, first,
                                     [&](auto k) { return wm.structure_function(first.lag[k]); }),
                   differences = points_of("S₂ of its second differences", 1, Marker::triangle, second),
                   fitted = curve_of("what is fitted to S₂, with D and G", 1, fit.fitted,
                                     [&](auto k) { return fit.fitted.value[k]; });
    PlotLine law = curve_of("C τ^(4-2D), D and G of Table 2: a sum without ends", neutral, first,
                            [&](auto k) { return structure_function_at(first.lag[k], surface.fractal); });
    law.stroke = Stroke::dashed;
    const auto row = [&](const std::string& quantity, const std::string& value, const std::string& table) {
        all.generated.push_back({"Fig. 6", surface.name, quantity, value, table});
    };
    row("longest wave [mm]", rounded(longest * 1e3, 3), "from σ, D, G");
    row("D", rounded(fit.fractal.dimension, 4) + " ± " + rounded(fit.dimension_error, 2),
        rounded(surface.fractal.dimension));
    row("G [nm]", rounded(fit.fractal.roughness * 1e9, 3) + " ± " + rounded(fit.roughness_error * 1e9, 2),
        rounded(surface.fractal.roughness * 1e9));
    row("rms height [µm]", rounded(rms_height(profile) * 1e6, 3), rounded(surface.roughness.rms_height * 1e6));
    Figure figure{.title = "Fig. 6: structure function, sand blasted (fine), generated profile",
                  .panels = {{.x = {.label = "lag τ [µm]"},
                              .y = {.label = "S, S₂ [µm²]"},
                              .lines = {measured, summed, law, differences, fitted},
                              .windows = {{"window of the fit", fit.window.from * 1e6, fit.window.to * 1e6}}}},
                  .note = "sum of cosines (2.1), γ = 1.5, random phases of seed 2014, 16000 points 0.5 µm apart"};
    return {"fig6",
            "Fig. 6, from a generated profile with the D and G of Table 2: the measured one is not in the text. The "
            "longest "
            "wave is the one that gives the σ of Table 1. D and G are fitted to the second differences, S₂, which feel "
            "the ends of the sum of cosines less than S does.",
            figure};
}

/// K of peaks that flow, which the paper has not, for every law that is drawn: its label and a value for each pressure.
std::vector<std::pair<const char*, std::vector<double>>> plastic_curves(const Surface& surface,
                                                                        const PeakDistribution<double>& peaks,
                                                                        const std::vector<double>& points) {
    const double modulus = effective_modulus(steel, steel);
    const PlasticMaterial<double> material{modulus, yield_strength, steel.poisson_ratio};
    RoughContactOptions<double> options;
    options.integrals.relative_tolerance = 1e-9;  // the law is known to some percent
    const RoughContact plastic(surface.roughness, peaks, PlasticLaw<double>(material.hardness_or_default(), modulus),
                               modulus, options);
    const RoughContact jackson_green(surface.roughness, peaks, JacksonGreenLaw<double>(material), modulus, options);
    std::vector<std::pair<const char*, std::vector<double>>> curves{
        {"plastic peaks (not in the paper): plastic", {}}, {"plastic peaks (not in the paper): jackson_green", {}}};
    for (const double p : points) {
        curves[0].second.push_back(plastic.at_pressure(p, Quantity::stiffness).stiffness.value);
        curves[1].second.push_back(jackson_green.at_pressure(p, Quantity::stiffness).stiffness.value);
    }
    return curves;
}

/// Fig. 7, 8 or 9, and the numbers behind the conclusions.
Picture stiffness_figure(const Surface& surface, Reproduction& all) {
    const double modulus = effective_modulus(steel, steel);
    const PeakDistribution<double> quarter = PeakDistribution<double>::exponential(pi / 4),
                                   third = PeakDistribution<double>::exponential(pi / 3);
    const FractalLaw<double> fractal(surface.fractal.dimension);
    const HertzLaw<double> hertz;
    const RoughContactOptions<double> alone{},
        interacting{.interaction = {InteractionReading::effective_separation, std::sqrt(nominal_area)}};
    const GreenwoodWilliamson<double> gw(surface.roughness, modulus);
    const std::vector<double> points = pressures();

    const auto panel = [](const char* title) {
        return Panel{
            .title = title, .x = {.label = "nominal pressure p [MPa]"}, .y = {.label = "K/A₀ [GPa/µm]"}, .height = 300};
    };
    const auto stiffness = [&](const auto& contact) {
        std::vector<double> values;
        for (const double p : points) values.push_back(contact.at_pressure(p, Quantity::stiffness).stiffness.value);
        return values;
    };
    const auto draw = [&](Panel& into, const char* label, int colour, Stroke stroke,
                          const std::vector<double>& values) {
        PlotLine line = line_of(
            label, points.size(), [&](auto k) { return points[k] / 1e6; }, [&](auto k) { return values[k] / 1e15; });
        line.colour = colour;
        line.stroke = stroke;
        into.lines.push_back(std::move(line));
    };
    Panel without = panel("The interface alone"), with = panel("With the interaction (4.11), L = √A₀, η_old effective");
    const auto at_quarter = stiffness(RoughContact(surface.roughness, quarter, fractal, modulus, alone));
    const auto at_third = stiffness(RoughContact(surface.roughness, third, fractal, modulus, alone));
    const auto elastic = stiffness(RoughContact(surface.roughness, quarter, hertz, modulus, alone));
    const auto classic = stiffness(gw);
    draw(without, "fractal, θ = π/4", 0, Stroke::solid, at_quarter);
    draw(without, "fractal, θ = π/3", 0, Stroke::dashed, at_third);
    draw(without, "statistical elastic, θ = π/4", 1, Stroke::solid, elastic);
    draw(without, "Greenwood-Williamson", 2, Stroke::solid, classic);
    int colour = 3;
    for (const auto& [label, values] : plastic_curves(surface, quarter, points))
        draw(without, label, colour++, Stroke::solid, values);
    draw(with, "fractal, θ = π/4", 0, Stroke::solid,
         stiffness(RoughContact(surface.roughness, quarter, fractal, modulus, interacting)));
    draw(with, "fractal, θ = π/3", 0, Stroke::dashed,
         stiffness(RoughContact(surface.roughness, third, fractal, modulus, interacting)));
    draw(with, "statistical elastic, θ = π/4", 1, Stroke::solid,
         stiffness(RoughContact(surface.roughness, quarter, hertz, modulus, interacting)));
    draw(with, "Greenwood-Williamson (without)", 2, Stroke::solid, classic);

    Bounds over_elastic, over_classic, of_theta, of_theta_at_gap, shift;
    for (std::size_t k = 0; k < points.size(); ++k) {
        over_elastic.add(at_quarter[k] / elastic[k]);
        over_classic.add(at_quarter[k] / classic[k]);
        of_theta.add(at_third[k] / at_quarter[k]);
        shift.add(points[k] * std::sqrt(nominal_area) / (modulus * surface.roughness.rms_height));
    }
    for (int eighths = 0; eighths <= 24; ++eighths) {
        const double eta = eighths / 8.0;
        of_theta_at_gap.add(contact_integral(0.5, -0.5, third, eta).value /
                            contact_integral(0.5, -0.5, quarter, eta).value);
    }
    const auto find = [&](Measure measure, const Bounds& range) {
        all.findings.push_back({measure, surface.name, range});
    };
    find(Measure::over_elastic, over_elastic);
    find(Measure::over_greenwood_williamson, over_classic);
    find(Measure::theta_at_pressure, of_theta);
    find(Measure::theta_at_separation, of_theta_at_gap);
    find(Measure::shift, shift);

    const std::string number(1, surface.figure[3]);
    return {surface.figure,
            "Fig. " + number + ": normal contact stiffness of the surface " + surface.name + ". " + no_points + " " +
                plastic_remark,
            {.title = "Fig. " + number + ": normal contact stiffness, " + surface.name,
             .panels = {without, with},
             .note = "Curves of the models; the experimental points are not in the paper's text."}};
}

/// Every verdict follows from the numbers, so that a change of the model changes it.
std::vector<Conclusion> judge(const std::vector<Finding>& findings) {
    Bounds factor, classic, of_theta, of_theta_at_gap;
    std::vector<double> shifts;
    bool same_factor = true;
    for (const Finding& finding : findings) {
        const auto both = [&](Bounds& of) {
            of.add(finding.range.low);
            of.add(finding.range.high);
        };
        switch (finding.measure) {
            case Measure::over_elastic:
                both(factor);
                same_factor = same_factor && finding.range.high / finding.range.low < 1 + 1e-9;
                break;
            case Measure::over_greenwood_williamson:
                both(classic);
                break;
            case Measure::theta_at_pressure:
                both(of_theta);
                break;
            case Measure::theta_at_separation:
                both(of_theta_at_gap);
                break;
            case Measure::shift:
                shifts.push_back(finding.range.high);
        }
    }
    const bool slight = of_theta.high<1.25, largest_on_smoothest = shifts[0]> shifts[1] && shifts[1] > shifts[2];
    return {
        {1, "The fractal model is close to the experiment, the statistical elastic models are far below it.",
         same_factor ? "not testable: only that the models differ by a constant factor" : "the factor is not constant",
         "The two differ by (2/3)(3-D)/(2-D) at every pressure, " + rounded(factor.low, 4) + " to " +
             rounded(factor.high, 4) + " with D alone; Greenwood-Williamson lies lower by " + rounded(classic.low, 3) +
             " to " + rounded(classic.high, 3) +
             ". That the fractal model is closer says that such a factor was missing. The experimental points are not "
             "in the text."},
        {2, "The stiffness is almost independent of θ.",
         slight ? "holds at equal pressure, not at equal separation" : "does not hold",
         "From π/4 to π/3 K rises by " + rounded(of_theta.low, 3) + " to " + rounded(of_theta.high, 3) +
             " at equal pressure, and by " + rounded(of_theta_at_gap.low, 3) + " to " +
             rounded(of_theta_at_gap.high, 3) + " at equal separation."},
        {3, "The interaction matters for rough surfaces at high load, and hardly at low load.",
         largest_on_smoothest ? "half: it grows with the load, but is largest on the smoothest surface"
                              : "holds for these surfaces",
         "The shift of η at 100 MPa is " + rounded(shifts[0], 4) + " (fine), " + rounded(shifts[1], 4) + " (coarse), " +
             rounded(shifts[2], 4) +
             " (electrical discharge): it is in proportion to the pressure and to 1/σ. The discussion says so, the "
             "conclusion the opposite."}};
}

Reproduction compute() {
    Reproduction all;
    all.generated.push_back({"figure", "surface", "quantity", "generated", "paper"});
    all.pictures.push_back(figure_2());
    all.pictures.push_back(figure_4(all));
    all.pictures.push_back(figure_6(all));
    for (const Surface& surface : surfaces) all.pictures.push_back(stiffness_figure(surface, all));
    std::stable_sort(all.findings.begin(), all.findings.end(),
                     [](const Finding& a, const Finding& b) { return a.measure < b.measure; });
    for (Picture& picture : all.pictures) picture.figure.legend_below = true;  // for a telephone too
    all.conclusions = judge(all.findings);
    all.errata = errata();
    return all;
}

std::vector<std::vector<std::string>> tables() {
    std::vector<std::vector<std::string>> rows{
        {"surface", "σ [µm]", "R [µm]", "D_p [1/mm²]", "R_p [µm]", "D", "G [nm]"}};
    for (const Surface& s : surfaces)
        rows.push_back({s.name, rounded(s.roughness.rms_height * 1e6), rounded(s.roughness.peak_radius * 1e6),
                        rounded(s.roughness.peak_density * 1e-6), rounded(s.roughness.max_peak_height * 1e6),
                        rounded(s.fractal.dimension), rounded(s.fractal.roughness * 1e9)});
    return rows;
}

std::vector<std::vector<std::string>> finding_rows(const Reproduction& all) {
    std::vector<std::vector<std::string>> rows{{"conclusion", "surface", "quantity", "least", "greatest"}};
    for (const Finding& f : all.findings)
        rows.push_back({std::to_string(f.words().conclusion), f.surface, f.words().text, rounded(f.range.low, 4),
                        rounded(f.range.high, 4)});
    return rows;
}

std::string page(const Reproduction& all) {
    Page page("The paper reproduced");
    page.paragraph(
        "R. Buczkowski, M. Kleiber, G. Starzyński, Normal contact stiffness of fractal rough surfaces, Arch. Mech. 66 "
        "(2014). Computed by fstiff " FSTIFF_VERSION " from Tables 1 and 2. " +
        std::string(no_points));
    page.heading("Tables 1 and 2");
    page.table(tables());
    page.paragraph("E₁ = E₂ = 205 GPa, ν = 0.3, Y = 400 MPa, A₀ = 195 mm².");
    page.heading("Conclusions");
    std::vector<std::vector<std::string>> rows{{"conclusion", "the paper", "verdict", "numbers"}};
    for (const Conclusion& c : all.conclusions)
        rows.push_back({std::to_string(c.number), c.paper, c.verdict, c.because});
    page.table(rows);
    page.paragraph(remark);
    page.heading("The numbers behind them");
    page.table(finding_rows(all));
    page.heading("Figures");
    for (const Picture& picture : all.pictures) page.figure(picture.figure, picture.caption);
    page.heading("Generated surfaces against the paper");
    page.table(all.generated);
    page.heading("Errata");
    page.paragraph("Where fstiff departs from the print; in full in errata.md beside this page.");
    page.list(all.errata);
    return page.str();
}

std::string table(const Reproduction& all, const std::vector<std::string>& files) {
    const auto text_of = [](const std::vector<std::vector<std::string>>& rows) {
        TextTable text(rows.front());
        for (std::size_t i = 1; i < rows.size(); ++i) text.add(rows[i]);
        return text.str();
    };
    std::string text = "fstiff " FSTIFF_VERSION
                       ": Buczkowski, Kleiber, Starzyński, Arch. Mech. 66 (2014), reproduced\n\nTables 1 and 2\n" +
                       text_of(tables()) + "\nNumbers behind the conclusions\n" + text_of(finding_rows(all)) +
                       "\nGenerated surfaces\n" + text_of(all.generated) + "\n";
    for (const Conclusion& c : all.conclusions)
        text += "conclusion " + std::to_string(c.number) + ": " + c.paper + "\n  verdict: " + c.verdict + "\n  " +
                c.because + "\n";
    text += std::string(remark) + "\n\n" + no_points + "\n\nErrata (in full in errata.md)\n";
    for (const std::string& title : all.errata) text += "  " + title + "\n";
    text += "\nFiles\n";
    for (const std::string& file : files) text += "  " + file + "\n";
    return text;
}

std::string csv(const Reproduction& all) {
    std::string text = csv_line({"conclusion", "surface", "key", "quantity", "least", "greatest", "verdict"});
    for (const Finding& f : all.findings)
        text += csv_line({std::to_string(f.words().conclusion), f.surface, f.words().key,
                          f.words().text, exact(f.range.low), exact(f.range.high),
                          all.conclusions[static_cast<std::size_t>(f.words().conclusion - 1)].verdict});
    return text;
}

std::string json(const Reproduction& all, const std::vector<std::string>& files) {
    Json document = json_document("reproduce");
    document["reference"] = "Buczkowski, Kleiber, Starzynski, Arch. Mech. 66 (2014)";
    document["experimental_points"] = no_points;
    document["remark"] = remark;
    Json& inputs = document["surfaces"] = Json::array();
    for (const Surface& s : surfaces)
        inputs.push_back({{"name", s.name},
                          {"rms_height_m", s.roughness.rms_height},
                          {"peak_radius_m", s.roughness.peak_radius},
                          {"peak_density_per_m2", s.roughness.peak_density},
                          {"max_peak_height_m", s.roughness.max_peak_height},
                          {"fractal_dimension", s.fractal.dimension},
                          {"fractal_roughness_m", s.fractal.roughness}});
    document["youngs_modulus_Pa"] = steel.youngs_modulus;
    document["poisson_ratio"] = steel.poisson_ratio;
    document["nominal_area_m2"] = nominal_area;
    document["seed"] = seed;
    Json& conclusions = document["conclusions"] = Json::array();
    for (const Conclusion& c : all.conclusions) {
        Json numbers = Json::array();
        for (const Finding& f : all.findings)
            if (f.words().conclusion == c.number)
                numbers.push_back({{"surface", f.surface},
                                   {"key", f.words().key},
                                   {"quantity", f.words().text},
                                   {"least", f.range.low},
                                   {"greatest", f.range.high}});
        conclusions.push_back({{"number", c.number},
                               {"paper", c.paper},
                               {"verdict", c.verdict},
                               {"because", c.because},
                               {"numbers", numbers}});
    }
    Json& generated = document["generated"] = Json::array();
    for (std::size_t i = 1; i < all.generated.size(); ++i) {
        Json row;
        for (std::size_t k = 0; k < all.generated[i].size(); ++k) row[all.generated[0][k]] = all.generated[i][k];
        generated.push_back(std::move(row));
    }
    document["errata"] = all.errata;
    document["files"] = files;
    return document.str();
}

Report execute(const Options& options) {
    refuse_standard_output(options.folder, "a folder");
    const std::filesystem::path folder(options.folder);
    const std::string errata = (folder / "errata.md").string(), index = (folder / "index.html").string();
    require_own(errata);
    require_own(index);
    for (const char* name : {"fig2", "fig4", "fig6", "fig7", "fig8", "fig9"})
        for (const std::string& file : PictureFiles((folder / name).string() + ".svg").all()) require_own(file);
    const Reproduction all = compute();
    std::vector<OutputFile> written;
    for (const Picture& picture : all.pictures)
        for (OutputFile& file : figure_files(picture.figure, (folder / (picture.name + ".svg")).string()))
            written.push_back(std::move(file));
    written.push_back({errata, std::string(page_mark) + errata_page});
    written.push_back({index, page_mark + page(all)});
    deliver(written, options.folder);
    std::vector<std::string> files;
    for (const OutputFile& file : written) files.push_back(file.name);
    const Format format = options.output.format;
    return {format == Format::table ? table(all, files)
            : format == Format::csv ? csv(all)
                                    : json(all, files),
            {},
            success};
}

}  // namespace
}  // namespace reproduce_command

Command add_reproduce(CLI::App& app) {
    using namespace reproduce_command;
    auto options = std::make_shared<Options>();
    Arguments command(app, "reproduce", "The figures, tables and conclusions of the reference paper, into a folder");
    command.option("-o,--output", options->folder, "folder for the figures and index.html; made when missing")
        .type_name("FOLDER")
        .required();
    add_format_option(command, options->output);
    command.footer(
        "Figs. 2, 4, 6, 7, 8, 9 as SVG with their numbers (.plot.csv), errata.md, and "
        "index.html "
        "with "
        "all of it.\nExample:\n  fstiff reproduce -o reproduced");
    return {command.app(), &options->output, [options] { return execute(*options); }};
}

}  // namespace fstiff::cli
