// SPDX-License-Identifier: BSD-3-Clause
// fstiff run: a scene to its curves, one per law and peak density.
#include "builtin_scene.hpp"
#include "commands.hpp"
#include "contact_instances.hpp"
#include "pictures.hpp"
#include "progress.hpp"
#include "results.hpp"

#include <fstiff/asperity/laws.hpp>
#include <fstiff/asperity/mindlin.hpp>
#include <fstiff/contact/contact_curve.hpp>
#include <fstiff/contact/greenwood_williamson.hpp>
#include <fstiff/contact/interaction.hpp>
#include <fstiff/contact/rough_contact.hpp>
#include <fstiff/contact/validity.hpp>
#include <fstiff/core/version.hpp>
#include <fstiff/measured/sampled_band.hpp>
#include <fstiff/peaks/peak_density.hpp>
#include <fstiff/ultrasound/propagation.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

namespace fstiff::cli {
namespace {

struct Options {
    OutputOptions output;
    std::string scene, surface;
    std::string picture;  ///< file; empty: none
};

Quantity wanted(const Scene& scene) {
    Quantity set = Quantity::pressure;
    if (scene.needs_stiffness()) set = set | Quantity::stiffness;
    if (scene.real_area) set = set | Quantity::real_area;
    if (scene.contacts) set = set | Quantity::contacts;
    return set;
}

/// The states of \p points. \throws domain_error for the first that the model does not reach, naming its place.
std::vector<ContactState<double>> accepted(const Scene& scene, Law law,
                                           const std::vector<ContactPoint<double>>& points) {
    std::vector<ContactState<double>> states;
    for (const auto& point : points) {
        if (!point.ok())
            throw domain_error(scene.points_where + "law " + std::string(name_of(law)) + ": " +
                               (point.status == PointStatus::out_of_reach
                                    ? point.reason
                                    : "a result for " + shortest(scene.points[states.size()]) +
                                          " is beyond the range of double precision; the values of the scene must be "
                                          "less extreme"));
        states.push_back(point.state);
    }
    return states;
}

template <class Contact>
std::vector<ContactPoint<double>> points_of(const Scene& scene, const Contact& contact, Quantity quantities) {
    return scene.at_separations ? curve_at_separations(contact, scene.points, quantities)
                                : curve_at_pressures(contact, scene.points, quantities);
}

Interaction<double> interaction(const Scene& scene) {
    Interaction<double> result;
    result.reading = scene.reading;
    if (result.reading != InteractionReading::none)
        result.length = scene.length == InteractionLength::nominal ? interaction_length_of_area(*scene.nominal_area)
                        : scene.length == InteractionLength::peak_spacing
                            ? interaction_length_of_peaks(scene.surface.peak_density)
                            : scene.given_length;
    return result;
}

/// Calls \p visit with every contact of the scene, one a law and peak density, and its curve, still without states.
template <class Visit>
void for_each_contact(const Scene& scene, double modulus, const Visit& visit) {
    RoughContactOptions<double> options;
    options.interaction = interaction(scene);
    for (const Law law : scene.laws) {
        if (law == Law::greenwood_williamson) {
            visit(Curve{law, {}, {}, {}, {}, {}, {}}, GreenwoodWilliamson<double>(scene.surface, modulus));
            continue;
        }
        for (const Peaks& of : scene.peaks) {
            const PeakDensity<double> peaks = peak_density(of);
            const Curve curve{law, peaks.theta(), peaks.r(), rms_gradient(scene.surface, peaks), {}, {}, {}};
            const auto with = [&](const auto& asperity) {
                visit(curve, RoughContact(scene.surface, peaks, asperity, modulus, options));
            };
            if (law == Law::fractal)
                with(FractalLaw<double>(*scene.fractal_dimension));
            else if (law == Law::fractal_consistent)
                with(FractalConsistentLaw<double>(*scene.fractal_dimension));
            else
                with(HertzLaw<double>{});
        }
    }
}

std::string title(const Curve& curve) {
    std::string text(name_of(curve.law));
    if (curve.theta) text += ", theta = " + rounded(*curve.theta) + ", r = " + rounded(*curve.r);
    return text;
}

/// Begins the sentence about what does not hold at some points of a curve.
std::string_view sentence(Concern concern) {
    switch (concern) {
        case Concern::interacting_asperities:
            return "p* is above 0.01: asperities that do not feel one another give too small a K there";
        case Concern::mean_planes_crossed:
            return "the separation is below 0: the mean planes have passed each other";
        case Concern::above_highest_peak:
            return "the separation is above the highest peak: real surfaces do not touch there";
        case Concern::few_contacts:
            return "fewer than 10 contacts on the nominal area: a mean over peaks says little there";
        case Concern::area_above_nominal:
            return "the real area exceeds the nominal area: the model does not hold there";
        case Concern::not_converged:
            return "the stiffness has an error above 1e-6 of its size: the integrals did not converge there";
        default:
            return "";
    }
}

/// A warning for all curves that have a point where \p concern does not hold.
void warn_if_any(Results& results, Concern concern) {
    std::size_t count = 0;
    std::string where;
    for (const Curve& curve : results.curves) {
        const Check<double>* check = find_check(curve.checks, concern);
        if (check && !check->holds() && count++ == 0)
            where = title(curve) + " at p = " + rounded(curve.states[check->first].pressure.value / 1e6) + " MPa";
    }
    if (count > 0)
        results.warnings.push_back(std::string(sentence(concern)) + " (" + std::to_string(count) + " of " +
                                   std::to_string(results.curves.size()) + " curves, the first " + where + ")");
}

void add_warnings(const Scene& scene, Results& results) {
    for (const Check<double>& check : results.surface_checks) {
        if (check.holds()) continue;
        const std::string value = rounded(check.least, 3);
        results.warnings.push_back(
            check.concern == Concern::plasticity
                ? "plasticity index " + value +
                      " is above 1: the peaks yield at first loading; an elastic K is that of unloading"
                : "sigma R D_p = " + value + " is below " + rounded(check.limit, 3) +
                      ", the least of an isotropic Gaussian surface: R and D_p are those of islands, not of summits");
    }
    for (const Concern concern : {Concern::interacting_asperities, Concern::mean_planes_crossed,
                                  Concern::above_highest_peak, Concern::few_contacts})
        warn_if_any(results, concern);
    if (scene.reading != InteractionReading::none &&
        std::count(scene.laws.begin(), scene.laws.end(), Law::greenwood_williamson) > 0)
        results.warnings.push_back("interaction is not applied to greenwood_williamson");

    if ((scene.reflection || scene.shear_reflection) && scene.reading != InteractionReading::none)
        results.warnings.push_back(
            "K with interaction holds the elasticity of the bulk over the interaction length: its reflection is not "
            "that of the interface alone");

    const std::size_t before = results.warnings.size();
    for (const Concern concern : {Concern::area_above_nominal, Concern::not_converged}) warn_if_any(results, concern);
    if (results.warnings.size() > before) results.status = doubtful_result;
}

/// The scene with the surface \p drawn about its own.
Scene with_surface(Scene scene, const std::array<double, surface_parameter_count>& drawn) {
    const auto value = [&](Parameter which) { return drawn[index_of(which)]; };
    scene.surface.rms_height = value(Parameter::rms_height);
    scene.surface.peak_radius = value(Parameter::peak_radius);
    scene.surface.peak_density = value(Parameter::peak_density);
    if (scene.fractal_dimension) scene.fractal_dimension = value(Parameter::fractal_dimension);
    for (Peaks& peaks : scene.peaks)
        if (peaks.of_surface) peaks.r = value(Parameter::r), peaks.theta = value(Parameter::theta);
    return scene;
}

/// The band of K over the errors of the surface; every curve and point sees the same samples.
void add_bands(const Scene& scene, Results& results) {
    Scene lean = scene;  // is copied with every surface
    lean.inputs.clear();
    lean.measured.reset();
    const auto stiffness_of = [&](const std::array<double, surface_parameter_count>& drawn) {
        std::vector<double> all;
        for_each_contact(with_surface(lean, drawn), results.modulus, [&](const Curve&, const auto& contact) {
            for (const auto& point : points_of(scene, contact, Quantity::pressure | Quantity::stiffness))
                all.push_back(point.state.stiffness.value);
        });
        return all;
    };
    const auto bands = sampled_band(scene.uncertain, stiffness_of,
                                    {static_cast<std::size_t>(scene.samples), scene.seed, progress_bar()});
    std::size_t failed = 0;
    auto next = bands.begin();
    for (Curve& curve : results.curves)
        for (std::size_t i = 0; i < curve.states.size(); ++i) {
            failed = std::max(failed, next->failed);
            curve.band.push_back(*next++);
        }
    if (failed > 0)
        results.warnings.push_back("up to " + std::to_string(failed) + " of " + std::to_string(scene.samples) +
                                   " sampled surfaces are beyond the reach of the model at a point: the band there is "
                                   "that of the others");
}

Results compute(const Scene& scene) {
    Results results;
    results.modulus = effective_modulus(scene.upper, scene.lower);
    results.warnings = scene.warnings;
    if (scene.yield_strength)
        results.plasticity_index = plasticity_index(scene.surface, results.modulus, *scene.yield_strength);
    results.tangential_ratio = tangential_ratio(scene.upper, scene.lower);
    results.surface_checks = check_surface(scene.surface, results.modulus, scene.yield_strength);
    for_each_contact(scene, results.modulus, [&](Curve curve, const auto& contact) {
        curve.states = accepted(scene, curve.law, points_of(scene, contact, wanted(scene)));
        curve.checks = check_curve<double>(curve.states,
                                           {.effective_modulus = results.modulus,
                                            .rms_gradient = curve.rms_gradient,
                                            .max_peak_height = scene.surface.max_peak_height,
                                            .nominal_area = scene.nominal_area,
                                            .yield_strength = scene.yield_strength},
                                           wanted(scene));
        results.curves.push_back(std::move(curve));
    });
    if (scene.needs_stiffness() && scene.samples > 0 && scene.has_errors()) add_bands(scene, results);
    add_warnings(scene, results);
    return results;
}

const SampledBand<double>* band(const Curve& curve, std::size_t point) {
    return curve.band.empty() ? nullptr : &curve.band[point];
}

/// The machine-readable columns of one row; law, theta and r stand before them.
std::vector<std::pair<std::string, double>> numbers(const Scene& scene, const Results& results,
                                                    const ContactState<double>& state,
                                                    const SampledBand<double>* band) {
    std::vector<std::pair<std::string, double>> row{{"pressure_Pa", state.pressure.value}, {"eta", state.eta}};
    const auto add = [&](const std::string& name, const std::string& unit, double value, double error) {
        row.emplace_back(name + unit, value);
        row.emplace_back(name + "_error" + unit, error);
    };
    const auto add_band = [&](const std::string& name, const std::string& unit, double low, double high) {
        row.emplace_back(name + "_p05" + unit, low);
        row.emplace_back(name + "_p95" + unit, high);
    };
    const double ratio = results.tangential_ratio;
    if (scene.separation) row.emplace_back("separation_m", state.separation.value);
    if (scene.stiffness) {
        add("stiffness", "_Pa_per_m", state.stiffness.value, state.stiffness.error);
        if (band) add_band("stiffness", "_Pa_per_m", band->low, band->high);
    }
    if (scene.tangential_stiffness) {
        add("tangential_stiffness", "_Pa_per_m", ratio * state.stiffness.value, ratio * state.stiffness.error);
        if (band) add_band("tangential_stiffness", "_Pa_per_m", ratio * band->low, ratio * band->high);
    }
    const auto add_reflection = [&](const std::string& name, const Impedances<double>& media, double factor) {
        const double angular = scene.ultrasound->angular();
        const auto of = [&](double stiffness) { return reflection(factor * stiffness, media, angular); };
        const Estimate<double> r = reflection(state.stiffness * factor, media, angular);
        add(name, "", r.value, r.error);
        if (band) add_band(name, "", of(band->high), of(band->low));  // R falls with K
    };
    if (scene.reflection) add_reflection("reflection", scene.ultrasound->longitudinal, 1);
    if (scene.shear_reflection) add_reflection("shear_reflection", *scene.ultrasound->shear, ratio);
    if (scene.real_area) row.emplace_back("real_area_fraction", state.real_area_fraction.value);
    if (scene.contacts) row.emplace_back("contacts_per_m2", state.contact_density.value);
    return row;
}

std::string csv(const Scene& scene, const Results& results) {
    std::vector<std::string> header{"law", "theta", "r"};
    const SampledBand<double> none;
    for (const auto& [name, value] : numbers(scene, results, {}, results.curves.front().band.empty() ? nullptr : &none))
        header.push_back(name);
    std::string text = csv_line(header);
    for (const Curve& curve : results.curves)
        for (std::size_t i = 0; i < curve.states.size(); ++i) {
            std::vector<std::string> cells{std::string(name_of(curve.law)), curve.theta ? exact(*curve.theta) : "",
                                           curve.r ? exact(*curve.r) : ""};
            for (const auto& [name, value] : numbers(scene, results, curve.states[i], band(curve, i)))
                cells.push_back(exact(value));
            text += csv_line(cells);
        }
    return text;
}

}  // namespace

Json equations(Law law) {
    switch (law) {
        case Law::fractal:
            return {{"load", "(3.7)"}, {"stiffness", "(3.14), (4.9)"}, {"peaks", "(4.4)"}};
        case Law::fractal_consistent:
            return {{"load", "integral of (3.14)"}, {"stiffness", "(3.14), (4.9)"}, {"peaks", "(4.4)"}};
        case Law::hertz:
            return {{"load", "(3.7)"}, {"stiffness", "derivative of (3.7)"}, {"peaks", "(4.4)"}};
        case Law::greenwood_williamson:
            return {{"load", "(3.7)"}, {"stiffness", "derivative of (3.7)"}, {"peaks", "Gaussian, one radius"}};
    }
    return {};
}

namespace {

std::string json(const Scene& scene, const Results& results) {
    Json document = json_document("run");
    document["scene"] = {{"name", scene.name}, {"file", scene.file}, {"sha256", scene.sha256}};
    if (scene.measured) {
        Json measured = measured_document(*scene.measured);
        document["surface"] = {{"source", measured["source"]}, {"measured", measured["surface"]}};
    }
    if (!results.curves.front().band.empty())
        document["uncertainty"] = {
            {"samples", scene.samples}, {"seed", scene.seed}, {"quantiles", {0.05, 0.95}}, {"of", "stiffness"}};
    Json& inputs = document["inputs"] = Json::object();
    for (const Input& input : scene.inputs) {
        Json& entry = inputs[input.key] = {{"written", input.written}};
        if (input.value) entry["value"] = json_number(*input.value);
        if (!input.unit.empty()) entry["unit"] = input.unit;
    }
    document["effective_modulus_Pa"] = json_number(results.modulus);
    if (results.plasticity_index) document["plasticity_index"] = json_number(*results.plasticity_index);
    if (scene.tangential_stiffness || scene.shear_reflection)
        document["tangential_ratio"] = json_number(results.tangential_ratio);
    if (scene.ultrasound) {
        const Waves& waves = *scene.ultrasound;
        Json& entry = document["ultrasound"] = {{"frequency_Hz", json_number(waves.frequency)},
                                                {"impedance_Rayl", json_number(waves.longitudinal.incident)},
                                                {"impedance2_Rayl", json_number(waves.longitudinal.beyond)},
                                                {"equations", {"(5.1)"}}};
        if (waves.shear) {
            entry["shear_impedance_Rayl"] = json_number(waves.shear->incident);
            entry["shear_impedance2_Rayl"] = json_number(waves.shear->beyond);
        }
    }
    Json& laws = document["laws"] = Json::object();
    for (const Law law : scene.laws) laws[std::string(name_of(law))] = equations(law);
    Json& rows = document["rows"] = Json::array();
    for (const Curve& curve : results.curves)
        for (std::size_t i = 0; i < curve.states.size(); ++i) {
            Json row{{"law", name_of(curve.law)}};
            if (curve.theta) row["theta"] = json_number(*curve.theta);
            if (curve.r) row["r"] = json_number(*curve.r);
            for (const auto& [name, value] : numbers(scene, results, curve.states[i], band(curve, i)))
                row[name] = json_number(value);
            if (const SampledBand<double>* of = band(curve, i)) row["samples_out_of_reach"] = of->failed;
            rows.push_back(std::move(row));
        }
    document["warnings"] = results.warnings;
    return document.str();
}

std::string table(const Scene& scene, const Results& results) {
    const auto& s = scene.surface;
    std::string text = "fstiff " FSTIFF_VERSION ": " + scene.name + " (" + scene.file + ")\n";
    text += "  surface   sigma " + rounded(s.rms_height * 1e6) + " µm, R " + rounded(s.peak_radius * 1e6) +
            " µm, D_p " + rounded(s.peak_density * 1e-6) + " /mm²";
    if (s.max_peak_height > 0) text += ", R_p " + rounded(s.max_peak_height * 1e6) + " µm";
    if (scene.fractal_dimension) text += ", D " + rounded(*scene.fractal_dimension);
    if (scene.fractal_roughness) text += ", G " + rounded(*scene.fractal_roughness) + " m";
    const auto material = [](const Material<double>& m) {
        return rounded(m.youngs_modulus / 1e9) + " GPa, nu " + rounded(m.poisson_ratio);
    };
    if (scene.r) text += ", r " + rounded(*scene.r) + ", theta " + rounded(*scene.theta);
    if (scene.measured) {
        text += "\n  measured  " + scene.measured->file + " (" + scene.measured->kind + "), errors of";
        const auto& u = scene.uncertain;
        for (std::size_t i = 0; i < surface_parameter_count; ++i)
            if (u.known[i])
                text += (i ? ", " : " ") + std::string(parameter_table[i].symbol) + " " +
                        rounded(100 * u.error[i] / u.value[i], 2) + " %";
    }
    text += "\n  material  upper " + material(scene.upper) + "; lower " + material(scene.lower) +
            "; effective modulus " + rounded(results.modulus / 1e9) + " GPa";
    if (scene.yield_strength) text += "; yield strength " + rounded(*scene.yield_strength / 1e6) + " MPa";
    text += "\n  contact   ";
    if (scene.nominal_area) text += "nominal area " + rounded(*scene.nominal_area * 1e6) + " mm², ";
    const auto how = interaction(scene);
    text += how.reading == InteractionReading::none
                ? "no interaction"
                : std::string("interaction ") +
                      (how.reading == InteractionReading::as_printed ? "as printed" : "by effective separation") +
                      " over " + rounded(how.length * 1e3) + " mm";
    if (results.plasticity_index) text += ", plasticity index " + rounded(*results.plasticity_index, 3);
    if (scene.ultrasound) {
        const Waves& waves = *scene.ultrasound;
        const auto pair = [](const Impedances<double>& z) {
            return rounded(z.incident / 1e6) + " and " + rounded(z.beyond / 1e6) + " MRayl";
        };
        text += "\n  ultrasound  " + rounded(waves.frequency / 1e6) + " MHz, impedances " + pair(waves.longitudinal);
        if (waves.shear) text += ", of shear waves " + pair(*waves.shear);
    }
    text += "\n";

    for (const Curve& curve : results.curves) {
        text += "\n" + title(curve) + "\n";
        std::vector<std::string> header{"p [MPa]"};
        if (curve.rms_gradient) header.push_back("p*");
        header.push_back("eta");
        if (scene.separation) header.push_back("separation [µm]");
        if (scene.stiffness) header.insert(header.end(), {"K/A0 [GPa/µm]", "K/A0 [Pa/m]", "error [Pa/m]"});
        const bool banded = !curve.band.empty();
        if (scene.stiffness && banded) header.insert(header.end(), {"5 % [GPa/µm]", "95 % [GPa/µm]"});
        if (scene.tangential_stiffness) header.push_back("Kt/A0 [GPa/µm]");
        if (scene.reflection) header.push_back("|R|");
        if (scene.reflection && banded) header.insert(header.end(), {"5 %", "95 %"});
        if (scene.shear_reflection) header.push_back("shear |R|");
        if (scene.shear_reflection && banded) header.insert(header.end(), {"5 %", "95 %"});
        if (scene.real_area) header.insert(header.end(), {"real area", "mean pressure [GPa]"});
        if (scene.contacts) header.push_back("contacts [1/mm²]");
        TextTable rows(header);
        for (std::size_t i = 0; i < curve.states.size(); ++i) {
            const ContactState<double>& state = curve.states[i];
            std::vector<std::string> row{rounded(state.pressure.value / 1e6)};
            if (curve.rms_gradient)
                row.push_back(
                    rounded(dimensionless_pressure(state.pressure.value, results.modulus, *curve.rms_gradient), 3));
            row.push_back(rounded(state.eta));
            if (scene.separation) row.push_back(rounded(state.separation.value * 1e6));
            if (scene.stiffness)
                row.insert(row.end(), {rounded(state.stiffness.value / 1e15), rounded(state.stiffness.value, 6),
                                       rounded(state.stiffness.error, 2)});
            const SampledBand<double>* of = band(curve, i);
            if (scene.stiffness && of) row.insert(row.end(), {rounded(of->low / 1e15), rounded(of->high / 1e15)});
            const double ratio = results.tangential_ratio;
            if (scene.tangential_stiffness) row.push_back(rounded(ratio * state.stiffness.value / 1e15));
            const auto reflected = [&](const Impedances<double>& media, double factor) {
                const auto add = [&](double stiffness) {
                    row.push_back(rounded(reflection(factor * stiffness, media, scene.ultrasound->angular())));
                };
                add(state.stiffness.value);
                if (of) add(of->high), add(of->low);
            };
            if (scene.reflection) reflected(scene.ultrasound->longitudinal, 1);
            if (scene.shear_reflection) reflected(*scene.ultrasound->shear, ratio);
            if (scene.real_area) {
                const double area = state.real_area_fraction.value;
                row.insert(row.end(), {rounded(area), area > 0 ? rounded(state.pressure.value / area / 1e9) : "-"});
            }
            if (scene.contacts) row.push_back(rounded(state.contact_density.value * 1e-6));
            rows.add(std::move(row));
        }
        text += rows.str();
    }
    if (scene.needs_stiffness() || scene.real_area) text += "\n";
    if (scene.stiffness) text += "K/A0 is the normal stiffness per nominal area (1 GPa/µm = 1e15 Pa/m = 1e15 N/m³)\n";
    if (scene.tangential_stiffness || scene.shear_reflection)
        text +=
            "Kt/A0 is the tangential stiffness, " + rounded(results.tangential_ratio) + " K/A0 by Mindlin's ratio\n";
    if (scene.reflection || scene.shear_reflection)
        text += "|R| is the reflection of the interface as a spring, eq. (5.1); shear waves see Kt/A0\n";
    if (!results.curves.front().band.empty())
        text += "5 % and 95 %: of " + std::to_string(scene.samples) +
                " surfaces drawn about this one by its errors, seed " + std::to_string(scene.seed) + "\n";
    if (scene.real_area) text += "mean pressure is that on the real area\n";
    for (const std::string& warning : results.warnings) text += "warning: " + warning + "\n";
    return text;
}

Report execute(const Options& options) {
    if (!options.picture.empty()) require_picture_name(options.picture);
    if (options.scene == "-" && options.surface == "-")
        throw Usage("the scene and --surface are both standard input; one of them must be a file");
    const Scene scene = options.scene.empty()
                            ? parse_scene(builtin_scene, "built-in scene", options.surface)
                            : parse_scene(read_all(options.scene), display_name(options.scene), options.surface);
    const Results results = compute(scene);
    Report report;
    report.status = results.status;
    if (!options.picture.empty())
        for (const std::string& file : write_figure(results_figure(scene, results), options.picture))
            report.diagnostics.push_back("wrote " + file);
    if (options.output.format == Format::table) {
        report.document = table(scene, results);
    } else {
        report.document = options.output.format == Format::csv ? csv(scene, results) : json(scene, results);
        for (const std::string& warning : results.warnings) report.diagnostics.push_back("warning: " + warning);
    }
    return report;
}

}  // namespace

Results results_of(const Scene& scene) { return compute(scene); }

Command add_run(CLI::App& app) {
    auto options = std::make_shared<Options>();
    Arguments command(app, "run", "Stiffness, separation and real area of a scene against pressure");
    command.option("scene", options->scene,
                   "scene file (TOML); - is standard input; without it the fine sand-blasted surface of the paper");
    command.option("--surface", options->surface,
                   "profile, map, or JSON of fstiff measure, in place of the scene's [surface] and contact.peaks; "
                   "- is standard input");
    add_output_options(command, options->output);
    command
        .option("--plot", options->picture,
                "draw K(p) into FILE (.svg or .html); its numbers (.csv) and a gnuplot script (.gp) go beside it")
        .type_name("FILE");
    command.footer(
        "The keys of a scene are in docs/scene.md. Exit code 4: a real area above the nominal one, or no convergence.\n"
        "Example:\n  fstiff run --format csv");
    return {command.app(), &options->output, [options] { return execute(*options); }};
}

}  // namespace fstiff::cli
