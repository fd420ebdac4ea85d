// SPDX-License-Identifier: BSD-3-Clause
// fstiff measure: every parameter of a scene's [surface] from a measured profile or map, with errors.
#include "commands/commands.hpp"
#include "commands/scales.hpp"
#include "document/document.hpp"
#include "document/shown_unit.hpp"
#include "input/progress.hpp"
#include "input/scene_options.hpp"
#include "input/surface_options.hpp"
#include "picture/plot.hpp"
#include "surface/documents.hpp"
#include "surface/measured_surface.hpp"
#include "surface/roughness.hpp"

#include <fstiff/core/version.hpp>
#include <fstiff/io/quantity.hpp>

#include <memory>

namespace fstiff::cli {
namespace measure_command {
namespace {

struct Options {
    OutputOptions output;
    scene::MeasureOptions measure;
    std::vector<std::string> files;
    bool scales = false;
    std::string show;  ///< a command of its own, which Program::forward() chooses
    std::string modulus = "112.6 GPa", pressure = "10 MPa", picture;
};

/// \p file is the first column; empty: no such column.
Rows rows_of(const MeasuredSurface& surface, const std::string& file = "") {
    std::vector<std::string> names, units, ways, shown, shown_errors, shown_units;
    std::vector<std::optional<double>> values, errors;
    for (const ParameterLine& line : parameter_lines(surface)) {
        const auto [value, error] = line.measured;
        const ShownUnit unit = shown_unit(value, line.unit);
        names.push_back(line.name);
        values.push_back(value);
        errors.push_back(error);
        units.push_back(line.unit);
        shown.push_back(rounded(value * unit.factor, line.known ? 5 : 2));
        shown_errors.push_back(rounded(error * unit.factor, 2));
        shown_units.emplace_back(unit.name);
        ways.push_back(line.how);
    }
    for (const Parameter which : {Parameter::peak_radius, Parameter::peak_density}) {
        if (surface.found.find(which)) continue;
        names.emplace_back(parts::row_of(which).key), values.emplace_back(), errors.emplace_back();
        units.emplace_back(), shown.emplace_back("-"), shown_errors.emplace_back("-"), shown_units.emplace_back();
        ways.push_back("not known: " + surface.found.why_no_density);
    }
    Rows rows;
    if (!file.empty()) rows.repeat({.key = "file"}, file, names.size());
    rows.add({"parameter", "parameter"}, names);
    rows.add({"value"}, values);
    rows.add({"error"}, errors);
    rows.add({"unit"}, units);
    rows.add({"", "value"}, shown);
    rows.add({"", "+-"}, shown_errors);
    rows.add({"", "unit"}, shown_units);
    rows.add({"", "found by"}, ways);
    return rows;
}

std::string text_of(const RoughnessTable& table) {
    std::vector<std::string> symbols, values, units, meanings;
    for (const RoughnessLine& line : table.lines) {
        const ShownUnit unit = shown_unit(line.value.value_or(0), line.unit);
        symbols.push_back(line.symbol);
        values.push_back(line.value ? rounded(*line.value * unit.factor) : "-");
        units.emplace_back(line.value ? unit.name : "");
        meanings.push_back(line.meaning);
    }
    Rows rows;
    rows.add({"", "parameter"}, symbols);
    rows.add({"", "value"}, values);
    rows.add({"", "unit"}, units);
    rows.add({"", "meaning"}, meanings);
    return "\n  by " + table.standard + ", about the mean" +
           (table.files > 1 ? ": means of " + std::to_string(table.files) + " files" : "") + "\n  " +
           sentence_of(table.cut_offs) + "\n" +
           (table.sections.empty()
                ? ""
                : "  sections: " + table.sections +
                      (table.section_length > 0 ? ", " + shown_length(table.section_length) : "") + "\n") +
           "\n" + rows.text();
}

std::string table(const MeasuredSurface& surface) {
    std::string text = "fstiff " FSTIFF_VERSION_TEXT ": surface of " + printable(surface.file) + "\n";
    for (const std::string& decision : surface.decisions) text += "  " + decision + "\n";
    text += "\n" + rows_of(surface).text() + text_of(roughness_of(surface));
    for (const MeasuredSurface& part : surface.parts) {
        text += "\n" + printable(part.file) + "\n";
        for (const std::string& decision : part.decisions) text += "  " + decision + "\n";
        text += rows_of(part).text() + text_of(roughness_of(part));
    }
    return text;
}

/// For several files the pooled rows come first, with the file name "pooled".
std::string csv(const MeasuredSurface& surface) {
    if (surface.parts.empty()) return rows_of(surface).csv();
    std::string text = rows_of(surface, "pooled").csv();
    for (const MeasuredSurface& part : surface.parts) text += rows_of(part, part.file).csv(false);
    return text;
}

/// The table of --scales, and the picture where one is asked for.
Report execute_scales(const Options& options) {
    if (options.files.size() != 1) throw Usage("--scales is of one file");
    if (!options.picture.empty()) keep_for_picture(options.picture);
    ScalesOptions how{.progress = progress_bar()};
    how.pressure = parse_positive(options.pressure, io::Dimension::pressure, "--pressure");
    how.modulus = parse_positive(options.modulus, io::Dimension::pressure, "--modulus");
    scene::MeasureOptions measure = options.measure;
    measure.input.file = options.files.front();
    const SurfaceInput input = read_surface_input(measure.input);
    const MeasuredSurface surface = measure_surface(measure, input, progress_bar());
    const Scales scales = scales_of(surface, input, how);
    std::vector<std::string> files;
    if (!options.picture.empty()) {
        Figure figure{.title = shown_file(surface.file) + " filtered with other cut-offs",
                      .panels = scales_panels(scales)};
        if (figure.panels.empty()) throw domain_error(surface.file + ": holds no other cut-off; no picture is drawn");
        figure.note = "K by " + scales.law + " at " + rounded(how.pressure / 1e6) + " MPa, effective modulus " +
                      rounded(how.modulus / 1e9) + " GPa";
        files = write_figure(figure, options.picture);
    }
    Report made = report({.table = [&] { return table(surface) + scales_text(scales, how); },
                          .csv = [&] { return scales_rows(scales).csv(); },
                          .json =
                              [&] {
                                  Json document = measure_json(measure, surface);
                                  Json& of = document["scales"] = {{"law", scales.law},
                                                                   {"pressure_Pa", how.pressure},
                                                                   {"effective_modulus_Pa", how.modulus},
                                                                   {"settled", what_is_settled(scales)}};
                                  scales_rows(scales).append_to(of["rows"]);
                                  return document;
                              },
                          .warnings = surface.warnings,
                          .status = is_doubtful(surface) ? doubtful_result : success},
                         options.output.chosen());
    say_written(made, files);
    return made;
}

Report execute(const Options& options) {
    if (options.scales) return execute_scales(options);
    if (!options.picture.empty()) throw Usage("--plot draws what --scales computes; give both");
    scene::MeasureOptions measure = options.measure;
    measure.keep_maps = false;
    const MeasuredSurface surface = measure_files(measure, options.files, progress_bar());
    return report({.table = [&] { return table(surface); },
                   .csv = [&] { return csv(surface); },
                   .json = [&] { return measure_json(options.measure, surface); },
                   .warnings = surface.warnings,
                   .status = is_doubtful(surface) ? doubtful_result : success},
                  options.output.chosen());
}

}  // namespace
}  // namespace measure_command

Command add_measure(Arguments& command) {
    using namespace measure_command;
    auto options = std::make_shared<Options>();
    scene::MeasureOptions& measure = options->measure;
    command.option(
        "files", options->files,
        {.help = "profile or map of any form; - is standard input. Several files of one surface, or a folder of them, "
                 "are pooled",
         .required = true,
         .form = request::Form::file});
    add_surface_options(command, measure.input);
    for (const char* key : {"peaks", "tip_radius", "resolution", "window"})
        add_surface_option(command, measure.input, key);
    command.fields(measure);
    command.option(
        "--scales", options->scales,
        {"repeat the measurement and K with the cut-offs varied by factors of two, to show their influence"});
    command.option("--pressure", options->pressure,
                   {.help = "nominal pressure of the K of --scales", .shows_default = true});
    command.option(
        "--modulus", options->modulus,
        {.help = "effective modulus of the K of --scales; the default is steel on steel", .shows_default = true});
    command.option(
        "--show", options->show,
        {.help = "another analysis of the file, with its own options (--show fit --help lists them): fit (D and G), "
                 "islands (for a map), peaks (for a profile) or spectrum",
         .words = {"fit", "islands", "peaks", "spectrum"}});
    add_picture_option(command, options->picture, "draw what --scales computes");
    add_output_options(command, options->output, Format::json);
    return {&options->output, [options] { return execute(*options); }};
}

}  // namespace fstiff::cli
