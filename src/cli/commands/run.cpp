// SPDX-License-Identifier: BSD-3-Clause
// fstiff run: a scene to its curves, one per law and peak density.
#include "commands/commands.hpp"
#include "document/document.hpp"
#include "input/progress.hpp"
#include "input/scene_options.hpp"
#include "picture/panels.hpp"
#include "scene/results.hpp"

#include <fstiff/contact/validity.hpp>
#include <fstiff/core/version.hpp>

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

namespace fstiff::cli {

extern const char* const example_scene;  // data/example_scene.toml

namespace {

struct Options {
    OutputOptions output;
    SceneOptions scene;
    std::string picture;  ///< file; empty: none
    bool example = false;
};

/// How people read the columns of a curve; a column that is not here stands in CSV and JSON alone.
const std::vector<Heading> headings{{"pressure_Pa", "p [MPa]", 1e-6},
                                    {"eta", "eta"},
                                    {"separation_m", "separation [µm]", 1e6},
                                    {"stiffness_Pa_per_m", "K/A0 [GPa/µm]", 1e-15},
                                    {"stiffness_error_Pa_per_m", "error [Pa/m]", 1, 2},
                                    {"stiffness_p05_Pa_per_m", "5 % [GPa/µm]", 1e-15},
                                    {"stiffness_p95_Pa_per_m", "95 % [GPa/µm]", 1e-15},
                                    {"tangential_stiffness_Pa_per_m", "Kt/A0 [GPa/µm]", 1e-15},
                                    {"reflection", "|R|"},
                                    {"reflection_p05", "5 %"},
                                    {"reflection_p95", "95 %"},
                                    {"shear_reflection", "shear |R|"},
                                    {"shear_reflection_p05", "5 %"},
                                    {"shear_reflection_p95", "95 %"},
                                    {"real_area_fraction", "real area"},
                                    {"contacts_per_m2", "contacts [1/mm²]", 1e-6}};

Heading heading_of(const std::string& key) {
    const auto found = std::find_if(headings.begin(), headings.end(), [&](const auto& one) { return one.key == key; });
    return found == headings.end() ? Heading{key} : *found;
}

/// p over the real area; absent without contact.
std::vector<Cell> mean_pressures(const Curve& curve) {
    std::vector<Cell> cells;
    for (const auto& state : curve.states) {
        const double area = state.real_area_fraction.value;
        cells.push_back(area > 0 ? Cell(state.pressure.value / area) : Cell());
    }
    return cells;
}

Rows rows_of(const Results& results, const Curve& curve) {
    Rows rows;
    const std::size_t size = curve.states.size();
    const auto put = [&](Heading heading, const std::vector<double>& values) {
        if (values.empty())
            rows.repeat(std::move(heading), Cell(), size);
        else
            rows.add(std::move(heading), values);
    };
    rows.repeat({"law"}, curve.law->name, size);
    rows.repeat({"theta"}, curve.theta, size);
    rows.repeat({"r"}, curve.r, size);
    for (const scene::Column& column : curve.columns) {
        put(heading_of(column.key), column.values);
        if (column.key == "pressure_Pa" && curve.rms_gradient) {
            std::vector<double> relative;
            for (const double p : column.values)
                relative.push_back(dimensionless_pressure(p, results.modulus, *curve.rms_gradient));
            put({"", "p*", 1, 3}, relative);
        } else if (column.key == "stiffness_Pa_per_m") {
            put({"", "K/A0 [Pa/m]", 1, 6}, column.values);
        } else if (column.key == "real_area_fraction") {
            rows.add({"", "mean pressure [GPa]", 1e-9}, mean_pressures(curve));
        }
    }
    std::vector<std::size_t> failed;
    for (const auto& band : curve.band) failed.push_back(band.failed);
    if (!failed.empty()) rows.add({.key = "samples_out_of_reach", .csv = false}, failed);
    return rows;
}

std::string csv(const Results& results) {
    std::string text;
    for (const Curve& curve : results.curves) text += rows_of(results, curve).csv(text.empty());
    return text;
}

Json json(const Scene& scene, const Results& results) {
    Json document = json_document("run");
    document["scene"] = scene_json(scene);
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
        if (input.value) entry["value"] = *input.value;
        if (!input.unit.empty()) entry["unit"] = input.unit;
    }
    document["effective_modulus_Pa"] = results.modulus;
    if (results.plasticity_index) document["plasticity_index"] = *results.plasticity_index;
    if (scene.tangential_stiffness || scene.shear_reflection) document["tangential_ratio"] = results.tangential_ratio;
    if (scene.ultrasound) {
        const Waves& waves = *scene.ultrasound;
        Json& entry = document["ultrasound"] = {{"frequency_Hz", waves.frequency},
                                                {"impedance_Rayl", waves.longitudinal.incident},
                                                {"impedance2_Rayl", waves.longitudinal.beyond},
                                                {"equations", {"(5.1)"}}};
        if (waves.shear) {
            entry["shear_impedance_Rayl"] = waves.shear->incident;
            entry["shear_impedance2_Rayl"] = waves.shear->beyond;
        }
    }
    Json& laws = document["laws"] = Json::object();
    for (const ChosenLaw& chosen : scene.laws) {
        const Law& law = *chosen.law;
        laws[law.name] = {{"load", law.load}, {"stiffness", law.stiffness}, {"peaks", law.peaks}};
    }
    Json& rows = document["rows"] = Json::array();
    for (const Curve& curve : results.curves) rows_of(results, curve).append_to(rows);
    return document;
}

/// What was computed of what: the lines above the curves.
std::string introduction(const Scene& scene, const Results& results) {
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
    return text;
}

std::string table(const Scene& scene, const Results& results) {
    std::string text = introduction(scene, results);
    for (const Curve& curve : results.curves) text += "\n" + title(curve) + "\n" + rows_of(results, curve).text();
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
    return text;
}

Report execute(const Options& options) {
    if (options.example) {
        if (!options.scene.scene.empty() || !options.scene.surface.empty() || !options.picture.empty())
            throw Usage("--example prints a scene and computes nothing; give no scene, --surface or --plot with it");
        return {example_scene, {}, success};
    }
    if (!options.picture.empty()) keep_for_picture(options.picture);
    const Scene scene = read_scene(options.scene);
    const Results results = compute(scene, progress_bar());
    std::vector<std::string> files;
    if (!options.picture.empty()) files = write_figure(results_figure(scene, results), options.picture);
    Report made = report({.table = [&] { return table(scene, results); },
                          .csv = [&] { return csv(results); },
                          .json = [&] { return json(scene, results); },
                          .warnings = results.warnings,
                          .status = results.doubtful ? doubtful_result : success},
                         options.output.format);
    say_written(made, files);
    return made;
}

}  // namespace

Command add_run(CLI::App& app) {
    auto options = std::make_shared<Options>();
    Arguments command(app, "run", "Stiffness, separation and real area of a scene against pressure");
    add_scene_options(command, options->scene,
                      "scene file (TOML); - is standard input; without it the fine sand-blasted surface of the paper",
                      "profile, map, or JSON of fstiff measure, in place of the scene's [surface] and contact.peaks; "
                      "- is standard input");
    add_output_options(command, options->output);
    add_picture_option(command, options->picture, "draw K(p)");
    command.flag("--example", options->example, "print a scene with comments, to begin one of your own");
    command.footer(
        "A scene says what is in contact; run --example > my.toml is one to change. Exit code 4: a real area above the "
        "nominal one, or no convergence.\n"
        "Example:\n  fstiff run --format csv");
    return {command.app(), &options->output, [options] { return execute(*options); }};
}

}  // namespace fstiff::cli
