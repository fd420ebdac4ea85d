// SPDX-License-Identifier: BSD-3-Clause
// fstiff run: a scene to its curves, one per law and peak density.
#include "commands/commands.hpp"
#include "document/document.hpp"
#include "input/progress.hpp"
#include "input/scene_options.hpp"
#include "input/surface_options.hpp"
#include "picture/panels.hpp"
#include "surface/documents.hpp"
#include "scene/result_rows.hpp"
#include "document/shown_unit.hpp"

#include <fstiff/validity/checks.hpp>
#include <fstiff/validity/validated_ratio.hpp>
#include <fstiff/core/version.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace fstiff::cli {

extern const char* const example_scene;  // data/example_scene.toml

namespace run_command {
namespace {

struct Options {
    OutputOptions output;
    SceneOptions scene;
    std::string picture;  ///< file; empty: none
    bool full = false;    ///< every point and quantity in the table
    bool example = false;
};

std::string csv(const Results& results) {
    std::string text;
    for (const Curve& curve : results.curves) text += rows_of(results, curve).csv(text.empty());
    return text;
}

Json json(const Scene& scene, const Results& results) {
    Json document = json_document("run");
    document["scene"] = scene_json(scene);
    for (const auto& [name, face] : measured_faces(scene)) {
        Json measured = measured_document(*face->measured);
        Json& place = scene.faces.empty() ? document["surface"] : document["surface"][name];
        place = {{"source", measured["source"]}, {"measured", measured["surface"]}};
        put_cut_offs(place, face->measured->found.cut_offs);
    }
    if (has_band(results))
        document["uncertainty"] = {
            {"samples", scene.samples}, {"seed", scene.seed}, {"quantiles", {0.05, 0.95}}, {"of", "stiffness"}};
    Json& inputs = document["inputs"] = Json::object();
    for (const Input& input : scene.inputs) {
        Json& entry = inputs[input.key] = {{"written", input.written}};
        if (input.value) entry["value"] = *input.value;
        if (!input.unit.empty()) entry["unit"] = input.unit;
    }
    document["verdict"] = results.verdict;
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
    for (const Law* law : scene.laws)
        laws[law->name] = {{"load", law->load}, {"stiffness", law->stiffness}, {"peaks", law->peaks}};
    Json& rows = document["rows"] = Json::array();
    for (const Curve& curve : results.curves) rows_of(results, curve).append_to(rows);
    return document;
}

constexpr std::size_t widest = 100;  ///< columns of the summary

/// Parts with commas between them, in lines of at most \p widest that begin with \p first and go on below it.
std::string in_lines(const std::string& first, const std::vector<std::string>& parts) {
    std::string text = "  " + first + std::string(10 - first.size(), ' ');
    std::size_t used = text.size();
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const std::size_t size = shown_width(parts[i]) + 2;
        if (i > 0 && used + size > widest) {
            text.back() = '\n';
            text += std::string(12, ' ');
            used = 12;
        }
        text += parts[i] + (i + 1 < parts.size() ? ", " : "\n");
        used += size;
    }
    return text;
}

/// Which law to believe, in lines of at most \p widest: what stands first after the name of the scene.
std::string believed(const Results& results) {
    std::string text;
    for (const std::string& sentence : results.verdict)
        for (const std::string& line : wrapped(sentence, widest - 11))
            text += (text.empty() ? "  believe  " : "           ") + line + "\n";
    return text;
}

/// The surface that the contact is of, and what was assumed of it.
std::vector<std::string> surface_parts(const Scene& scene) {
    const parts::SurfaceParameters<double>& s = scene.face.parameters;
    const std::vector<Parameter> unknown = unknown_parameters(scene);
    const auto digits = [&](Parameter one) { return std::count(unknown.begin(), unknown.end(), one) > 0 ? 2 : 5; };
    std::vector<std::string> parts{"sigma " + shown_length(s.rms_height.value, digits(Parameter::rms_height)),
                                   "R " + shown_length(s.peak_radius.value, digits(Parameter::peak_radius)),
                                   "D_p " + with_unit(s.peak_density.value, "/m^2", digits(Parameter::peak_density))};
    if (s.max_peak_height.value > 0) parts.push_back("R_p " + shown_length(s.max_peak_height.value));
    if (s.fractal_dimension)
        parts.push_back("D " + rounded(s.fractal_dimension->value, digits(Parameter::fractal_dimension)));
    if (const auto& g = s.fractal_roughness)
        parts.push_back("G " + shown_length(g->value, parts::is_known(*g) ? 5 : 2));
    if (s.r) parts.push_back("r " + rounded(s.r->value, digits(Parameter::r)));
    if (s.theta) parts.push_back("theta " + rounded(s.theta->value, digits(Parameter::theta)));
    for (const Assumed& one : assumed(scene))
        parts.push_back(std::string(one.symbol) + " " + rounded(one.value, 3) + " (" + one.how + ")");
    if (scene.faces.empty()) parts.push_back("the other face smooth");
    return parts;
}

/// The bodies, the nominal area and the waves.
std::string bodies_text(const Scene& scene, const Results& results) {
    const auto pressure = [](double x) { return with_unit(x, "Pa"); };
    const auto material = [&](const Material<double>& m) {
        return pressure(m.youngs_modulus) + ", nu " + rounded(m.poisson_ratio);
    };
    std::vector<std::string> parts{"upper " + material(scene.upper) + "; lower " + material(scene.lower),
                                   "effective modulus " + pressure(results.modulus)};
    if (scene.yield_strength) parts.push_back("yield strength " + pressure(*scene.yield_strength));
    std::string text = in_lines("material", parts);
    parts.clear();
    if (scene.nominal_area) parts.push_back("nominal area " + rounded(*scene.nominal_area * 1e6) + " mm²");
    const auto how = interaction(scene);
    parts.push_back(
        how.reading == InteractionReading::none
            ? "no interaction"
            : std::string("interaction ") +
                  (how.reading == InteractionReading::as_printed ? "as printed" : "by effective separation") +
                  " over " + shown_length(how.length));
    if (results.plasticity_index) parts.push_back("plasticity index " + rounded(*results.plasticity_index, 3));
    text += in_lines("contact", parts);
    if (scene.ultrasound) {
        const Waves& waves = *scene.ultrasound;
        const auto pair = [](const Impedances<double>& z) {
            return rounded(z.incident / 1e6) + " and " + rounded(z.beyond / 1e6) + " MRayl";
        };
        parts = {rounded(waves.frequency / 1e6) + " MHz", "impedances " + pair(waves.longitudinal)};
        if (waves.shear) parts.push_back("of shear waves " + pair(*waves.shear));
        text += in_lines("waves", parts);
    }
    return text;
}

/// What was computed of what: the lines above the curves.
std::string introduction(const Scene& scene, const Results& results) {
    std::string text = "fstiff " FSTIFF_VERSION ": " + printable(scene.name + " (" + scene.file + ")") + "\n";
    text += believed(results) + in_lines("surface", surface_parts(scene));
    if (!scene.faces.empty()) {
        std::vector<std::string> parts{"of the sum of two rough faces"};
        if (scene.face.map)
            parts.push_back("laws of a map are means over " + std::to_string(scene.shifts) + " random shifts");
        text += in_lines("", parts);
    }
    for (const auto& [name, face] : measured_faces(scene)) {
        std::vector<std::string> parts;
        const MeasuredSurface& measured = *face->measured;
        for (const parts::ParameterRow& row : parts::surface_parameter_table)
            if (const auto* known = face->parameters.find(row.parameter))
                parts.push_back(std::string(row.symbol) + " " + shown_percent(known->error / known->value));
        parts.front() = printable(measured.file) + " (" + measured.kind + "), errors of " + parts.front();
        if (measured.found.cut_offs.any()) parts.push_back(sentence_of(measured.found.cut_offs));
        text += in_lines(scene.faces.empty() ? "measured" : std::string(name), parts);
    }
    return text + bodies_text(scene, results);
}

/// What the symbols of the tables mean, and where a band comes from.
std::string explanations(const Scene& scene, const Results& results) {
    std::string text;
    if (scene.stiffness) text += "K/A0 is the normal stiffness per nominal area (1 GPa/µm = 1e15 Pa/m = 1e15 N/m³)\n";
    if (scene.tangential_stiffness || scene.shear_reflection)
        text +=
            "Kt/A0 is the tangential stiffness, " + rounded(results.tangential_ratio) + " K/A0 by Mindlin's ratio\n";
    if (scene.reflection || scene.shear_reflection)
        text += "|R| is the reflection of the interface as a spring, eq. (5.1); shear waves see Kt/A0\n";
    if (has_band(results))
        text += "5 % and 95 %: of " + std::to_string(scene.samples) +
                " surfaces drawn about this one by its errors, seed " + std::to_string(scene.seed) +
                (results.about_band.empty() ? "\n" : ", widened by the spread over lambda_s\n");
    else if (scene.needs_stiffness())
        text += scene.face.has_errors() ? "K has no band: the scene asks for no samples\n"
                                   : "K has no band: no error of a parameter of the surface is known\n";
    return text;
}

std::string full_table(const Scene& scene, const Results& results) {
    const Units units = units_of(scene, results);
    std::string text = introduction(scene, results);
    for (const Curve& curve : results.curves)
        text += "\n" + title(curve) + "\n" + rows_of(results, curve, units).text();
    const std::string notes =
        explanations(scene, results) + (scene.real_area ? "mean pressure is that on the real area\n" : "");
    return notes.empty() ? text : text + "\n" + notes;
}

std::string label_of(const Curve& curve) {
    return std::string(curve.law->name) +
           (curve.theta ? ", theta " + rounded(*curve.theta, 4) + ", r " + rounded(*curve.r, 4) : "");
}

/// A header or a row of the summary at \p points, whose first cells are as wide as those of all blocks.
class Summary {
public:
    Summary(const Scene& scene, const Results& results, std::vector<std::size_t> points)
        : scene_(scene), results_(results), points_(std::move(points)) {
        for (const Curve& curve : results.curves) first_ = std::max(first_, label_of(curve).size());
    }

    /// \p quantity of every curve, of a stiffness with its band.
    [[nodiscard]] std::string block(CurveQuantity quantity, const Units& units) const {
        const Column column{quantity};
        const Heading heading = heading_of(column, units);
        const bool band = has_band(results_) && column.row().unit == "Pa/m";
        return table(heading.shown + (band ? ", 5 % to 95 %" : ""), [&](const Curve& curve, std::size_t i) {
            const auto value = [&](Statistic statistic) {
                const auto found = curve.value_at(i, quantity, statistic);
                return found ? std::optional(*found * heading.factor) : found;
            };
            const auto middle = value(Statistic::value), low = value(Statistic::p05), high = value(Statistic::p95);
            if (!middle || !band || !low || !high) return middle ? rounded(*middle) : "-";
            const int digits = *high - *low < 0.2 * *middle ? 3 : 2;  // as many as tell the ends apart
            return rounded(*middle, 3) + " (" + rounded(*low, digits) + "–" + rounded(*high, digits) + ")";
        });
    }

    /// p* of the points, and K of every curve over that of boundary elements there; every curve has a gradient.
    [[nodiscard]] std::string validity() const {
        return table("p*, K over boundary elements", [&](const Curve& curve, std::size_t i) -> std::string {
            const auto pressure = curve.value_at(i, CurveQuantity::pressure);
            if (!pressure) return "-";  // out of the law's reach
            const double p = parts::dimensionless_pressure(*pressure, results_.modulus, *curve.rms_gradient);
            const auto ratio = parts::validated_ratio(curve.law->which, p);
            return rounded(p, 2) + ": " + (ratio ? rounded(ratio->low, 3) + "–" + rounded(ratio->high, 3) : "-");
        });
    }

private:
    /// \p cell of every curve and point, below \p what.
    template <class Cell>
    [[nodiscard]] std::string table(std::string what, const Cell& cell) const {
        TextRows rows{{std::move(what)}};
        for (const std::size_t i : points_)
            rows[0].push_back(with_unit(scene_.points[i], scene_.at_separations ? "m" : "Pa", 3));
        for (const Curve& curve : results_.curves) {
            rows.push_back({label_of(curve)});
            for (const std::size_t i : points_) rows.back().push_back(cell(curve, i));
        }
        for (auto& row : rows) row[0] += std::string(first_ - std::min(first_, shown_width(row[0])), ' ');
        return TextTable(std::move(rows)).str();
    }

    const Scene& scene_;
    const Results& results_;
    std::vector<std::size_t> points_;
    std::size_t first_ = 28;  ///< width of the first column; that of the longest heading, or more
};

std::size_t width_of(const std::string& text) {
    std::size_t most = 0;
    for (std::size_t start = 0; start < text.size();) {
        const std::size_t end = std::min(text.find('\n', start), text.size());
        most = std::max(most, shown_width(std::string_view(text).substr(start, end - start)));
        start = end + 1;
    }
    return most;
}

/// \p table of all points of the summary, below one another where they are wider than the page.
template <class Table>
std::string in_parts(const Scene& scene, const Results& results, const Table& table) {
    const std::vector<std::size_t> points = summary_points(scene);
    std::string text;
    for (std::size_t parts = 1; parts <= points.size(); ++parts) {
        text.clear();
        for (std::size_t part = 0; part < parts; ++part)
            text += (part > 0 ? "\n" : "") +
                    table(Summary(scene, results,
                                  {points.begin() + static_cast<std::ptrdiff_t>(part * points.size() / parts),
                                   points.begin() + static_cast<std::ptrdiff_t>((part + 1) * points.size() / parts)}));
        if (width_of(text) <= widest) break;
    }
    return text;
}

/// How far the models were compared at the p* of the points.
std::string validity(const Scene& scene, const Results& results) {
    if (!results.curves.front().rms_gradient)
        return "  p* is not known, since no gradient of the surface is: docs/validation.md cannot be asked\n";
    return in_parts(scene, results, [](const Summary& summary) { return summary.validity(); }) +
           "  by docs/validation.md: p* of " + rounded(parts::min_validated_pressure) + " to " +
           rounded(parts::max_validated_pressure) + " on Gaussian surfaces without plastic flow\n";
}

/// The tables of the summary.
std::string blocks(const Scene& scene, const Results& results) {
    using enum CurveQuantity;
    const Units units = units_of(scene, results);
    std::vector<CurveQuantity> shown{stiffness, tangential_stiffness, reflection, shear_reflection};
    if (!scene.needs_stiffness()) shown = {separation, real_area, contacts};
    std::string text;
    for (const CurveQuantity quantity : shown) {
        if (const auto asked = Column{quantity}.row().asked; !(scene.*asked)) continue;
        text += "\n" + in_parts(scene, results, [&](const Summary& summary) { return summary.block(quantity, units); });
    }
    return text + (scene.needs_stiffness() ? "\n" + validity(scene, results) : "");
}

/// Each law at the points of the summary, what it is and how far it may be believed.
std::string table(const Scene& scene, const Results& results) {
    std::string text = introduction(scene, results) + blocks(scene, results) + "\n";
    for (const Law* law : scene.laws)
        text += "  " + std::string(law->name) + " is " + std::string(law->nature) + "\n";
    return text + "\n" + explanations(scene, results) +
           "every point and quantity: --full, --format csv, --format json\n";
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
    Report made = report({.table = [&] { return options.full ? full_table(scene, results) : table(scene, results); },
                          .csv = [&] { return csv(results); },
                          .json = [&] { return json(scene, results); },
                          .warnings = results.warnings,
                          .status = results.doubtful ? doubtful_result : success},
                         options.output.format);
    say_written(made, files);
    return made;
}

}  // namespace
}  // namespace run_command

Command add_run(CLI::App& app) {
    using namespace run_command;
    auto options = std::make_shared<Options>();
    Arguments command(app, "run", "Stiffness, separation and real area of a scene against pressure");
    add_scene_options(command, options->scene,
                      "scene file (TOML); - is standard input; without it the fine sand-blasted surface of the paper",
                      "profile, map, or JSON of fstiff measure, in place of the scene's [surface] and contact.peaks; "
                      "- is standard input");
    add_output_options(command, options->output);
    command.flag("--full", options->full, "the table has every point and quantity, not a summary");
    add_picture_option(command, options->picture, "draw K(p)");
    command.flag("--example", options->example, "print a scene with comments, to begin one of your own");
    command.footer(
        "A scene says what is in contact; run --example > my.toml is one to change. Exit code 4: a real area above the "
        "nominal one,\nno convergence, a point that a law does not reach, or a measured parameter that is not known to a "
        "factor of two.\n"
        "Example:\n  fstiff run --format csv");
    return {command.app(), &options->output, [options] { return execute(*options); }};
}

}  // namespace fstiff::cli
