// SPDX-License-Identifier: BSD-3-Clause
// fstiff measure: every parameter of a scene's [surface] from a measured profile or map, with errors.
#include "commands.hpp"
#include "measured_surface.hpp"

#include <fstiff/core/version.hpp>

#include <memory>

namespace fstiff::cli {
namespace {

struct Options {
    OutputOptions output;
    MeasureOptions measure;
};

std::string csv(const MeasuredSurface& surface) {
    std::string text = csv_line({"parameter", "value", "error", "unit"});
    for (const ParameterLine& line : parameter_lines(surface))
        text += csv_line({line.name, exact(line.measured.value), exact(line.measured.error), line.unit});
    return text;
}

std::string table(const MeasuredSurface& surface) {
    std::string text = "fstiff " FSTIFF_VERSION ": surface of " + surface.file + "\n";
    for (const std::string& decision : surface.decisions) text += "  " + decision + "\n";
    text += "\n";
    TextTable rows({"parameter", "value", "+-", "unit", "found by"});
    for (const ParameterLine& line : parameter_lines(surface))
        rows.add({line.name, rounded(line.measured.value), rounded(line.measured.error, 2), line.unit, line.how});
    text += rows.str();
    for (const std::string& warning : surface.warnings) text += "warning: " + warning + "\n";
    return text;
}

Report execute(const Options& options) {
    const MeasuredSurface surface = measure_surface(options.measure, read_all(options.measure.input.file));
    Report report;
    if (options.output.format == Format::table) {
        report.document = table(surface);
        return report;
    }
    if (options.output.format == Format::csv) {
        report.document = csv(surface);
    } else {
        Json document = measured_document(surface);
        const MeasureOptions& m = options.measure;
        document["inputs"] = json_inputs(m.input, m.input.detrend);
        document["inputs"].update({{"peaks", name_of(m.peaks)},
                                   {"tip_radius", m.tip_radius},
                                   {"resolution", m.resolution},
                                   {"window", m.window},
                                   {"resamples", m.resamples},
                                   {"seed", m.seed}});
        report.document = document.str();
    }
    for (const std::string& warning : surface.warnings) report.diagnostics.push_back("warning: " + warning);
    return report;
}

}  // namespace

Command add_measure(CLI::App& app) {
    auto options = std::make_shared<Options>();
    MeasureOptions& measure = options->measure;
    Arguments command(app, "measure",
                      "Every parameter of a scene's surface from a measured profile or map, with errors");
    command.option("file", measure.input.file, "profile or map of any form; - is standard input").required();
    add_surface_options(command, measure.input);
    command.option("--peaks", measure.peaks, "of a map, R and D_p of its islands (default) or its summits");
    command.option("--tip-radius", measure.tip_radius,
                   "of the stylus, of a profile: shorter lags that may show it do not enter D");
    command.option("--resolution", measure.resolution, "of the instrument: shorter lags do not enter D");
    command.option("--window", measure.window, "lags that give D, such as \"1 um,100 um\"; default automatic");
    command.option("--resamples", measure.resamples, "for the errors; default 400").between(2, 100000);
    command.option("--seed", measure.seed, "of the resamples; default 2014");
    add_output_options(command, options->output, Format::json);
    command.footer(
        "The JSON is what run --surface and a scene's [surface] from = \"...\" read. The example makes a random walk.\n"
        "Example:\n"
        "  awk 'BEGIN { srand(1); for (i = 0; i < 4096; ++i) print z += rand() - 0.5 }' |\n"
        "      fstiff measure - --spacing \"0.5 um\" --units um | fstiff run --surface -");
    return {command.app(), &options->output, [options] { return execute(*options); }};
}

}  // namespace fstiff::cli
