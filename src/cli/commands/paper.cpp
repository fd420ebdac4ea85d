// SPDX-License-Identifier: BSD-3-Clause
#include "commands/paper.hpp"

#include <fstiff/double/integrals.hpp>
#include <fstiff/double/surfaces.hpp>
#include "input/progress.hpp"

#include <fstiff/asperity/laws.hpp>
#include <fstiff/asperity/plastic_laws.hpp>
#include <fstiff/contact/contact_integrals.hpp>
#include <fstiff/contact/greenwood_williamson.hpp>
#include <fstiff/contact/interaction.hpp>
#include <fstiff/contact/rough_contact.hpp>
#include <fstiff/peaks/peak_distribution.hpp>
#include <fstiff/profile/fractal_fit.hpp>
#include <fstiff/surface/cut_offs.hpp>
#include <fstiff/synthetic/self_affine.hpp>
#include <fstiff/synthetic/weierstrass_mandelbrot.hpp>
#include <fstiff/topography/islands.hpp>

#include <cmath>
#include <numbers>
#include <utility>

namespace fstiff::cli::paper {
namespace {

constexpr double pi = std::numbers::pi;

std::vector<double> pressures() {
    std::vector<double> result;
    for (int k = 0; k <= 30; ++k) result.push_back(1e5 * std::pow(10.0, k / 10.0));
    return result;
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
        const double longest = parts::longest_wave(surface.fractal, surface.roughness.rms_height);
        const double most = std::pow(2 * pi, -1.5) * std::exp(-0.5);  // islands over m2/m0 of a Gaussian surface
        const double shortest = parts::shortest_wave(hurst, longest, surface.roughness.peak_density / most);
        constexpr std::size_t points = 1024;
        const double spacing = shortest / 4;
        SelfAffineOptions<double> options{.hurst = hurst,
                                          .rms = surface.roughness.rms_height,
                                          .longest_wavelength = longest,
                                          .shortest_wavelength = shortest,
                                          .long_waves = parts::LongWaves::none,
                                          .seed = seed};
        const HeightMap<double> map = self_affine_map<double>(options, points, points, spacing, spacing);
        IslandOptions<double> how;
        parts::IslandSpread spread{.tiles = 4, .resamples = 200, .seed = seed};
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
            all.generated.add_row({"Fig. 4", surface.name, quantity, value, table});
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
    const double longest = parts::longest_cosine(surface.fractal, surface.roughness.rms_height);
    const WeierstrassMandelbrot<double> wm(
        surface.fractal, {.longest_wavelength = longest, .shortest_wavelength = 2 * spacing, .seed = seed});
    const Profile<double> profile = wm.sample(points, spacing);
    parts::FractalFitOptions<double> options;
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
                            [&](auto k) { return parts::structure_function_at(first.lag[k], surface.fractal); });
    law.stroke = Stroke::dashed;
    const auto row = [&](const std::string& quantity, const std::string& value, const std::string& table) {
        all.generated.add_row({"Fig. 6", surface.name, quantity, value, table});
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
            "wave is the one that gives the σ of Table 1. D and G are fitted to the second differences, S₂, which "
            "depend less on the ends of the sum of cosines than S does.",
            figure};
}

/// The curves of one model in one of Figs. 7 to 9: K at every pressure.
struct ModelCurve {
    const char* label;
    int colour;
    Stroke stroke;
    std::vector<double> stiffness;
};

template <class Contact>
std::vector<double> stiffness_of(const Contact& contact) {
    std::vector<double> values;
    for (const double p : pressures()) values.push_back(contact.at_pressure(p, Quantity::stiffness).stiffness.value);
    return values;
}

PeakDistribution<double> peaks_at(double theta) { return PeakDistribution<double>::exponential(theta); }

/// The models of the paper, that of Greenwood and Williamson without an interaction.
std::vector<ModelCurve> paper_curves(const Surface& surface, const RoughContactOptions<double>& options,
                                     const char* classic) {
    const double modulus = effective_modulus(steel, steel);
    const FractalLaw<double> fractal(surface.fractal.dimension);
    const auto of = [&](const auto& peaks, const auto& law) {
        return stiffness_of(RoughContact(surface.roughness, peaks, law, modulus, options));
    };
    return {{"fractal, θ = π/4", 0, Stroke::solid, of(peaks_at(pi / 4), fractal)},
            {"fractal, θ = π/3", 0, Stroke::dashed, of(peaks_at(pi / 3), fractal)},
            {"statistical elastic, θ = π/4", 1, Stroke::solid, of(peaks_at(pi / 4), HertzLaw<double>())},
            {classic, 2, Stroke::solid, stiffness_of(GreenwoodWilliamson<double>(surface.roughness, modulus))}};
}

/// Peaks that flow, which the paper has not.
std::vector<ModelCurve> plastic_curves(const Surface& surface) {
    const double modulus = effective_modulus(steel, steel);
    const PlasticMaterial<double> material{modulus, yield_strength, steel.poisson_ratio};
    RoughContactOptions<double> options;
    options.integrals.relative_tolerance = 1e-9;  // the law is known to some percent
    const auto of = [&](const auto& law) {
        return stiffness_of(RoughContact(surface.roughness, peaks_at(pi / 4), law, modulus, options));
    };
    return {
        {"plastic peaks (not in the paper): plastic", 3, Stroke::solid,
         of(PlasticLaw<double>(material.hardness_or_default(), modulus))},
        {"plastic peaks (not in the paper): jackson_green", 4, Stroke::solid, of(JacksonGreenLaw<double>(material))}};
}

Panel stiffness_panel_of(const char* title, const std::vector<ModelCurve>& curves) {
    Panel panel{
        .title = title, .x = {.label = "nominal pressure p [MPa]"}, .y = {.label = "K/A₀ [GPa/µm]"}, .height = 300};
    const std::vector<double> points = pressures();
    for (const ModelCurve& curve : curves) {
        PlotLine line = line_of(
            curve.label, points.size(), [&](auto k) { return points[k] / 1e6; },
            [&](auto k) { return curve.stiffness[k] / 1e15; });
        line.colour = curve.colour;
        line.stroke = curve.stroke;
        panel.lines.push_back(std::move(line));
    }
    return panel;
}

/// Numbers for the conclusions, for the models in the order of paper_curves.
std::vector<Finding> findings_of(const Surface& surface, const std::vector<ModelCurve>& curves) {
    std::array<Bounds, measures.size()> of;
    const auto add = [&](Measure measure, double value) { of[static_cast<std::size_t>(measure)].add(value); };
    const double modulus = effective_modulus(steel, steel);
    const std::vector<double> points = pressures();
    for (std::size_t k = 0; k < points.size(); ++k) {
        const double fractal = curves[0].stiffness[k];
        add(Measure::over_elastic, fractal / curves[2].stiffness[k]);
        add(Measure::over_greenwood_williamson, fractal / curves[3].stiffness[k]);
        add(Measure::theta_at_pressure, curves[1].stiffness[k] / fractal);
        add(Measure::shift, points[k] * std::sqrt(nominal_area) / (modulus * surface.roughness.rms_height));
    }
    for (int eighths = 0; eighths <= 24; ++eighths) {
        const double eta = eighths / 8.0;
        add(Measure::theta_at_separation, contact_integral(0.5, -0.5, peaks_at(pi / 3), eta).value /
                                              contact_integral(0.5, -0.5, peaks_at(pi / 4), eta).value);
    }
    std::vector<Finding> findings;
    for (std::size_t i = 0; i < of.size(); ++i) findings.push_back({static_cast<Measure>(i), surface.name, of[i]});
    return findings;
}

/// Fig. 7, 8 or 9, and the numbers for the conclusions.
Picture stiffness_figure(const Surface& surface, Reproduction& all) {
    const RoughContactOptions<double> interacting{
        .interaction = {InteractionReading::effective_separation, std::sqrt(nominal_area)}};
    std::vector<ModelCurve> alone = paper_curves(surface, {}, "Greenwood-Williamson");
    const std::vector<ModelCurve> with = paper_curves(surface, interacting, "Greenwood-Williamson (without)");
    for (Finding& finding : findings_of(surface, alone)) all.findings.push_back(std::move(finding));
    for (ModelCurve& curve : plastic_curves(surface)) alone.push_back(std::move(curve));
    const std::string number(1, surface.figure[3]);
    return {surface.figure,
            "Fig. " + number + ": normal contact stiffness of the surface " + surface.name + ". " + no_points +
                " The curves of plastic peaks are not in the paper: their peaks yield (H = 2.8 Y, θ = π/4, r = 0), and "
                "K is that of unloading, which a wave measures.",
            {.title = "Fig. " + number + ": normal contact stiffness, " + surface.name,
             .panels = {stiffness_panel_of("The interface alone", alone),
                        stiffness_panel_of("With the interaction (4.11), L = √A₀, η_old effective", with)},
             .note = "Curves of the models; the experimental points are not in the paper's text."}};
}

/// Every result follows from the numbers, so that a change of the model changes it.
std::vector<Conclusion> judge(const std::vector<Finding>& findings) {
    std::array<Bounds, measures.size()> of;
    std::vector<double> shifts;
    bool same_factor = true;
    for (const auto& [measure, surface, range] : findings) {
        of[static_cast<std::size_t>(measure)].add(range.low);
        of[static_cast<std::size_t>(measure)].add(range.high);
        if (measure == Measure::shift) shifts.push_back(range.high);
        if (measure == Measure::over_elastic) same_factor = same_factor && range.high / range.low < 1 + 1e-9;
    }
    const auto bounds = [&](Measure measure) { return of[static_cast<std::size_t>(measure)]; };
    const auto range = [&](Measure measure, int digits = 3) {
        return rounded(bounds(measure).low, digits) + " to " + rounded(bounds(measure).high, digits);
    };
    const bool slight = bounds(Measure::theta_at_pressure).high < 1.25;
    const bool largest_on_smoothest = shifts[0] > shifts[1] && shifts[1] > shifts[2];
    return {
        {1, "The fractal model is close to the experiment, the statistical elastic models are far below it.",
         same_factor ? "not testable: only that the models differ by a constant factor" : "the factor is not constant",
         "The two differ by (2/3)(3-D)/(2-D) at every pressure, " + range(Measure::over_elastic, 4) +
             " with D alone; Greenwood-Williamson lies lower by " + range(Measure::over_greenwood_williamson) +
             ". The fractal model is closer because such a factor was missing. The experimental points are not "
             "in the text."},
        {2, "The stiffness is almost independent of θ.",
         slight ? "holds at equal pressure, not at equal separation" : "does not hold",
         "From π/4 to π/3 K rises by " + range(Measure::theta_at_pressure) + " at equal pressure, and by " +
             range(Measure::theta_at_separation) + " at equal separation."},
        {3, "The interaction matters for rough surfaces at high load, and hardly at low load.",
         largest_on_smoothest ? "half: it grows with the load, but is largest on the smoothest surface"
                              : "holds for these surfaces",
         "The shift of η at 100 MPa is " + rounded(shifts[0], 4) + " (fine), " + rounded(shifts[1], 4) + " (coarse), " +
             rounded(shifts[2], 4) +
             " (electrical discharge): it is in proportion to the pressure and to 1/σ. The discussion states this, the "
             "conclusion the opposite."}};
}

}  // namespace

Reproduction reproduce() {
    Reproduction all;
    all.generated = Rows::under({{"figure", "figure"},
                                 {"surface", "surface"},
                                 {"quantity", "quantity"},
                                 {"generated", "generated"},
                                 {"paper", "paper"}});
    all.pictures.push_back(figure_2());
    all.pictures.push_back(figure_4(all));
    all.pictures.push_back(figure_6(all));
    for (const Surface& surface : surfaces) all.pictures.push_back(stiffness_figure(surface, all));
    std::stable_sort(all.findings.begin(), all.findings.end(),
                     [](const Finding& a, const Finding& b) { return a.measure < b.measure; });
    for (Picture& picture : all.pictures) picture.figure.legend_below = true;  // for a telephone too
    all.conclusions = judge(all.findings);
    return all;
}

}  // namespace fstiff::cli::paper
