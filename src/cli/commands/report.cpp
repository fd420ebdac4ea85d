// SPDX-License-Identifier: BSD-3-Clause
// fstiff report: a scene and all that follows from it, on one page that needs nothing else.
#include "commands/commands.hpp"
#include "commands/measured_section.hpp"
#include "document/shown_unit.hpp"
#include "input/progress.hpp"
#include "input/scene_options.hpp"
#include "picture/figures.hpp"
#include "picture/panels.hpp"
#include "scene/explanation.hpp"
#include "scene/result_rows.hpp"
#include "surface/documents.hpp"

#include <fstiff/answer/checks.hpp>
#include <fstiff/core/version.hpp>

#include <algorithm>
#include <filesystem>
#include <memory>

namespace fstiff::cli {
namespace report_command {
namespace {

struct Options {
    OutputOptions output;
    SceneOptions scene;
    std::string place;  ///< the page, or the folder for report.html
};

/// Name and value with its error of what the surface is given by.
TextRows surface_rows(const Face& face) {
    const parts::SurfaceParameters<double>& s = face.parameters;
    TextRows rows;
    const auto add = [&](const char* name, const std::optional<Measurement<double>>& one, std::string_view si) {
        if (one) rows.push_back({name, with_unit(one->value, si, 4, one->error)});
    };
    add("rms height σ", s.rms_height, "m");
    if (s.find(Parameter::peak_radius)) add("peak radius R", s.peak_radius, "m");
    if (s.find(Parameter::peak_density))
        add("peak density D_p", s.peak_density, "1/m^2");
    else
        rows.push_back({"peak density D_p", "not known: " + s.why_no_density});
    add("fractal dimension D", s.fractal_dimension, "");
    add("r", s.r, "");
    add("θ", s.theta, "rad");
    add("fractal roughness G", s.fractal_roughness, "m");
    if (s.max_peak_height.value > 0) rows.push_back({"highest peak R_p", with_unit(s.max_peak_height.value, "m", 4)});
    return rows;
}

std::string range_of(double low, double high, int digits = 3) {
    if (!(low <= high)) return "none";
    return low == high ? rounded(low, digits) : rounded(low, digits) + " to " + rounded(high, digits);
}

constexpr std::ptrdiff_t first_warnings = 5;  ///< shown in the answer; the others are under Validity

void validity_section(Page& page, const Problem& problem, const Results& results) {
    page.heading("Validity");
    TextRows rows{{"check", "value", "holds where", "result"}};
    if (const auto* gaussian = parts::find_check(results.surface_checks, parts::Concern::gaussian_surface))
        rows.push_back({"σ R D_p, that an isotropic Gaussian surface can have", rounded(gaussian->least, 3),
                        "at least " + rounded(gaussian->limit, 3),
                        gaussian->holds() ? "holds" : "does not hold: R and D_p are of islands, not summits"});
    const auto* plastic = parts::find_check(results.surface_checks, parts::Concern::plasticity);
    rows.push_back({"plasticity index ψ = (E/H)√(σ/R), H = 2.8 Y",
                    plastic                  ? rounded(plastic->least, 3)
                    : problem.yield_strength ? "R and D_p not known"
                                             : "yield strength not given",
                    "elastic below 1",
                    !plastic           ? "not known"
                    : plastic->holds() ? "holds"
                                       : std::string(scene::yielding_peaks)});
    const double hardness = hardness_of(problem);
    const bool known = hardness > 0 && std::isfinite(hardness);
    for (const Curve& curve : results.curves) {
        const std::string name = legend_of(curve);
        if (const auto* pressure = parts::find_check(curve.checks, parts::Concern::interacting_asperities))
            rows.push_back(
                {"p* = p/(E g_rms), " + name, range_of(pressure->least, pressure->greatest),
                 "at most " + rounded(pressure->limit, 3),
                 pressure->holds() ? "holds" : "does not hold up to the greatest pressure: K is too small there"});
        if (const auto* pressure = parts::find_check(curve.checks, parts::Concern::above_hardness))
            rows.push_back({"mean contact pressure [GPa], " + name,
                            range_of(pressure->least / 1e9, pressure->greatest / 1e9),
                            "below the hardness" + (known ? ", " + with_unit(hardness, "Pa", 3) : ""),
                            !known                           ? "not known"
                            : pressure->greatest <= hardness ? "holds"
                                                             : "does not hold"});
    }
    page.table(rows);
    if (results.warnings.size() > first_warnings)
        page.list({results.warnings.begin() + first_warnings, results.warnings.end()});
}

std::string body(const Material<double>& material) {
    return "E = " + with_unit(material.youngs_modulus, "Pa", 4) + ", ν = " + rounded(material.poisson_ratio, 3);
}

/// Materials of the bodies, and whether they were assumed.
std::string material_sentence(const Scene& scene) {
    const bool assumed = scene.file == "built-in scene";
    const bool alike = scene.upper.youngs_modulus == scene.lower.youngs_modulus &&
                       scene.upper.poisson_ratio == scene.lower.poisson_ratio;
    std::string text = assumed ? "Material assumed, not given: steel of the built-in scene, " : "Material: ";
    text += alike ? body(scene.upper) + " of both bodies" : body(scene.upper) + " on " + body(scene.lower);
    const auto same = [](const Input& input) { return input.key == "material.lower" && !input.given; };
    if (std::any_of(scene.inputs.begin(), scene.inputs.end(), same))
        text += " (the lower is assumed to be as the upper)";
    if (scene.hardness)
        text += std::isfinite(*scene.hardness) ? ", hardness " + with_unit(*scene.hardness, "Pa", 4) : ", never yields";
    if (scene.hardness_range) text += ", " + phrase_of_hardness(scene) + " (assumed)";
    if (scene.yield_strength) text += ", yield strength " + with_unit(*scene.yield_strength, "Pa", 4);
    return text + (assumed ? ". Give your own in a scene, section [material]." : ".");
}

/// \p quantity of every curve at the points of a summary, with its band.
TextRows quantity_rows(const Scene& scene, const Results& results, CurveQuantity quantity, std::string heading,
                       double factor = 1) {
    const std::vector<std::size_t> points = points_of_answer(scene);
    TextRows rows{{std::move(heading)}};
    for (const std::size_t i : points)
        rows[0].push_back((scene.at_separations ? "at d = " : "at ") + shown_point(scene, i));
    for (const Curve& curve : results.curves) {
        std::vector<std::string> row{legend_of(curve)};
        for (const std::size_t i : points) {
            const auto shown = [&](Statistic statistic) {
                const auto value = curve.value_at(i, quantity, statistic);
                return value ? with_unit(*value * factor, "", 3) : "-";
            };
            row.push_back(shown(Statistic::value));
            if (curve.value_at(i, quantity, Statistic::p05))
                row.back() += " (" + shown(Statistic::p05) + " to " + shown(Statistic::p95) + ")";
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

/// Quantities that follow from K and are asked for.
void tables_after_stiffness(Page& page, const Scene& scene, const Results& results) {
    const auto show_rows = [&](bool asked, CurveQuantity quantity, const char* heading) {
        if (asked) page.table(quantity_rows(scene, results, quantity, heading));
    };
    show_rows(scene.asks(CurveQuantity::loss_factor), CurveQuantity::loss_factor,
              "loss factor of a tangential cycle, 5 % to 95 %");
    show_rows(scene.asks(CurveQuantity::thermal_conductance), CurveQuantity::thermal_conductance,
              "h of the spots [W/(m² K)], 5 % to 95 %");
    show_rows(scene.asks(CurveQuantity::thermal_conductance_gap), CurveQuantity::thermal_conductance_gap,
              "h of the gap [W/(m² K)]");
    show_rows(scene.asks(CurveQuantity::electrical_conductance), CurveQuantity::electrical_conductance,
              "h of current [S/m²], 5 % to 95 %");
}

/// The table of the laws that are named, and what their bands are.
void named_laws(Page& page, const Scene& scene, const Results& results, const Units& units) {
    TextRows rows = quantity_rows(scene, results, CurveQuantity::stiffness, units.stiffness.heading("K/A₀"),
                                  units.stiffness.factor);
    constexpr std::size_t most = 7;
    const std::size_t curves = rows.size() - 1;
    if (curves > most) rows.resize(most + 1);
    page.table(rows);
    std::string about = "Laws that the scene names. ";
    about += !has_band(results) ? "Their K has no band: " + why_no_band(scene, results) + "."
                                : "In brackets 5 % and 95 %: " + origin_of_band(scene) + ".";
    if (curves > most) about += " The first " + std::to_string(most) + " of " + std::to_string(curves) + " curves.";
    page.paragraph(about);
}

/// The first screen: surface, K, what speaks against it, and the picture.
void answer_section(Page& page, const Scene& scene, const Results& results, const Units& units) {
    std::string surface;
    for (const auto& [name, face, file] : measured_files(scene))
        surface += (surface.empty() ? "Surface measured from " : " and ") + shown_file(file->file);
    surface = surface.empty() ? "Surface as given in " + shown_file(scene.file) + ": " : surface + ": ";
    const TextRows parameters = surface_rows(scene.face);
    for (std::size_t i = 0; i < parameters.size(); ++i)
        surface += (i ? ", " : "") + parameters[i][0] + " = " + parameters[i][1];
    page.begin("div class=\"answer\"");
    page.begin("div");
    page.paragraph(surface + (scene.faces.empty() ? "; the other face is smooth." : "; the sum of two rough faces."));
    page.paragraph(material_sentence(scene));
    if (results.answer) page.table(answer_table(scene, results));
    const std::size_t count = results.warnings.size();
    const bool yields = results.answer && !results.answer->flows && results.answer->relative_hardness;
    page.begin(count == 0 && !yields ? "div class=\"result\"" : "div class=\"result warned\"");
    page.paragraph(results.doubtful ? "Result: doubtful. Read the warnings before using any of these numbers."
                   : count > 0      ? "Result: computed, but not all assumptions of the model hold."
                   : yields         ? "Result: no warnings, but K is elastic and its band does not include yielding."
                                    : "Result: no warnings; the band of K includes the known uncertainties.");
    page.list(results.explanation);
    const std::ptrdiff_t shown = std::min(static_cast<std::ptrdiff_t>(count), first_warnings);
    page.list({results.warnings.begin(), results.warnings.begin() + shown});
    if (static_cast<std::ptrdiff_t>(count) > shown)
        page.paragraph(std::to_string(static_cast<std::ptrdiff_t>(count) - shown) + " more under Validity.");
    page.end("div");
    if (results.answer) page.paragraph(outside_band(scene, results));
    std::string assumed;
    for (const std::string& one : scene.assumptions) assumed += (assumed.empty() ? "Assumed: " : "; ") + one;
    if (!assumed.empty()) page.paragraph(assumed + ".");
    if (const std::string next = measure_next(scene, results); !next.empty()) page.paragraph(sentence_case(next) + ".");
    if (!scene.best) named_laws(page, scene, results, units);
    tables_after_stiffness(page, scene, results);
    page.end("div");
    Panel picture = stiffness_panel(scene, results);
    picture.y.unit = units.stiffness;
    const std::string some = left_out(results);
    show(page, {std::move(picture)}, some.empty() ? some : some + ".", results.short_explanation);
    page.end("div");
}

void other_figures(Page& page, const Scene& scene, const Results& results) {
    page.heading("Under the same pressures");
    page.begin("div class=\"pair\"");
    if (scene.ultrasound)
        for (Panel& panel : reflection_panels(scene, results))
            show(page, {std::move(panel)}, "Reflection of ultrasound by the contact, eq. (5.1).");
    for (Panel& panel : panels_after_stiffness(scene, results)) show(page, {std::move(panel)}, "It follows from K.");
    std::vector<Panel> panels{quantity_panel(results, {.label = "real area / nominal"},
                                             [](const ContactState<double>& s) { return s.real_area_fraction.value; }),
                              quantity_panel(results, {.label = "contacts", .si = "1/m^2"},
                                             [](const ContactState<double>& s) { return s.contact_density.value; }),
                              quantity_panel(results, {.label = "separation", .logarithmic = false, .si = "m"},
                                             [](const ContactState<double>& s) { return s.separation.value; })};
    panels[0].title = "Real area";
    panels[1].title = "Contacts";
    panels[2].title = "Separation of the mean planes";
    std::erase_if(panels, [](const Panel& panel) {  // the law does not count contacts
        return panel.y.logarithmic && std::all_of(panel.lines.begin(), panel.lines.end(), [](const PlotLine& line) {
                   return std::all_of(line.y.begin(), line.y.end(), [](double y) { return !(y > 0); });
               });
    });
    for (Panel& panel : panels) show(page, {std::move(panel)});
    page.end("div");
    if (!scene.ultrasound) page.paragraph("The scene has no section [ultrasound]: no reflection is computed.");
}

/// Every number, one closed table for each curve.
void numbers_section(Page& page, const Results& results, const Units& units) {
    page.heading("Numbers");
    for (const Curve* curve : shown_curves(results)) {
        page.begin_details(legend_of(*curve) + ": " + std::to_string(curve->states.size()) + " points");
        page.table(rows_of(results, *curve, units).table());
        page.end("details");
    }
}

void inputs_section(Page& page, const Scene& scene) {
    page.heading("Inputs");
    TextRows inputs{{"key", "value", "as written"}};
    for (const Input& input : scene.inputs)
        if (!input.key.ends_with("(measured)"))  // those are under Measured surface
            inputs.push_back({input.key, input.value ? with_unit(*input.value, input.unit) : "", input.shown()});
    page.table(inputs);
    if (measured_faces(scene).empty())
        page.paragraph("The surface is given by its parameters; there is no measured profile or map to show.");
}

void equations_section(Page& page, const Scene& scene, const Results& results) {
    page.heading("Equations");
    TextRows rows{{"law", "load", "stiffness", "peaks"}};
    for (const Law* law : scene.laws)
        rows.push_back(
            {std::string(law->name), std::string(law->load), std::string(law->stiffness), std::string(law->peaks)});
    page.table(rows);
    std::string rest = "Effective modulus " + rounded(scene.effective_modulus / 1e9) +
                       " GPa from both bodies. Rms curvature of the peaks by (4.10). Interaction " +
                       (scene.reading == InteractionReading::none ? "left out" : "by (4.11)") + ".";
    if (scene.ultrasound)
        rest += " Reflection by (5.1); shear waves depend on the tangential stiffness, " +
                rounded(results.tangential_ratio) + " K by Mindlin.";
    if (has_band(results) && scene.samples > 0 && scene.face.has_measured_errors())
        rest += " The band is of seed " + std::to_string(scene.seed) + ".";
    page.paragraph(rest);
    page.paragraph(
        "Equation numbers refer to R. Buczkowski, M. Kleiber, G. Starzyński, Normal contact stiffness "
        "of fractal rough surfaces, Arch. Mech. 66 (2014). K is the stiffness per nominal area, 1 GPa/µm = 1e15 Pa/m.");
    page.paragraph("Normal contact stiffness, computed by fstiff " FSTIFF_VERSION_TEXT " from " + scene.file +
                   ", SHA-256 " + scene.sha256 + ".");
}

/// The surface with other cut-offs, and its K at the middle point of the scene.
void scales_section(Page& page, const Scene& scene, const Results& results, const MeasuredSurface& surface) {
    if (!surface.how || surface.how->input.file == "-" || scene.at_separations) return;
    const scene::ScalesOptions how{.pressure = scene.points[scene.points.size() / 2],
                                   .modulus = scene.effective_modulus,
                                   .progress = progress_bar()};
    const scene::Scales scales = scales_of(surface, read_surface_input(surface.how->input), how);
    std::vector<Panel> panels = scales_panels(scales);
    if (panels.empty()) return;
    page.heading("Influence of the cut-offs");
    for (const std::string& sentence : what_is_settled(scales)) page.paragraph(sentence_case(sentence) + ".");
    page.begin("div class=\"pair\"");
    for (Panel& panel : panels) show(page, {std::move(panel)});
    page.end("div");
    page.paragraph("K by " + scales.law + " at " + with_unit(how.pressure, "Pa") +
                   ", and the parameters of the surface, over their values at the chosen cut-offs.");
}

std::string page_of(const Scene& scene, const Results& results) {
    Page page(scene.name);
    const Units units = summary_units(scene, results);
    answer_section(page, scene, results, units);
    other_figures(page, scene, results);
    inputs_section(page, scene);
    for (const auto& [name, face, file] : measured_files(scene)) {
        measured_section(page, *file);
        scales_section(page, scene, results, *file);
        for (const MeasuredSurface& part : file->parts) measured_section(page, part);
    }
    validity_section(page, scene, results);
    numbers_section(page, results, units);
    equations_section(page, scene, results);
    return page.str();
}

Report execute(const Options& options) {
    refuse_standard_output(options.place, "a folder or a file that ends with .html");
    const bool is_file = options.place.ends_with(".html") && !std::filesystem::is_directory(path_of(options.place));
    const std::string file = is_file ? options.place : name_of_path(path_of(options.place) / "report.html");
    const std::string folder = name_of_path(path_of(file).parent_path());
    require_own(file);
    keep_for_output(file);
    Scene scene = read_scene(options.scene);
    // for a map the report shows boundary elements next to the laws
    const scene::Law& elements = scene::find_law(LawName::boundary_elements);
    if (!scene.best && refusal_of(elements, scene).empty() && !scene.at_separations &&
        std::find(scene.laws.begin(), scene.laws.end(), &elements) == scene.laws.end())
        scene.laws.push_back(&elements);
    // a report shows everything, whatever output.quantities asks of run
    using enum CurveQuantity;
    for (const CurveQuantity quantity : {stiffness, separation, real_area, contacts}) scene.ask(quantity);
    if (scene.ultrasound) {
        scene.ask(reflection);
        scene.ask(shear_reflection, scene.ultrasound->shear.has_value());
    }
    const Results results = computed(scene);
    const std::string document = page_of(scene, results);
    deliver({{file, page_mark + document}}, folder.empty() ? "." : folder);
    Document made("report");
    made.title("report of " + printable(scene.name + " (" + scene.file + ")"));
    made.line("  " + printable(file));
    made.json["scene"] = scene_json(scene);
    made.json["files"] = {file};
    made.csv([file] {
        Rows rows;
        rows.repeat({"file"}, file, 1);
        return rows;
    });
    made.warnings = results.warnings;
    made.doubtful = results.doubtful;
    return report(made, options.output.format);
}

}  // namespace
}  // namespace report_command

Command add_report(Arguments& command) {
    using namespace report_command;
    auto options = std::make_shared<Options>();
    add_scene_options(
        command, options->scene,
        "scene file (TOML); - is standard input; without it the fine sand-blasted surface of the paper",
        "profile, map, or JSON of fstiff measure, in place of the scene's [surface]; - is standard input");
    command.option("-o,--output", options->place,
                   {.help = "the page, FILE.html, or a folder for report.html; made when missing",
                    .required = true,
                    .type = "FILE"});
    add_format_option(command, options->output);
    return {&options->output, [options] { return execute(*options); }};
}

}  // namespace fstiff::cli
