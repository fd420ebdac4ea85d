// SPDX-License-Identifier: BSD-3-Clause
// fstiff measure: every parameter of a scene's [surface] from a measured profile or map, with errors.
#include "actions/measure.hpp"
#include "actions/scales.hpp"
#include "commands/commands.hpp"
#include "input/output_options.hpp"
#include "input/progress.hpp"

#include <fstiff/io/units.hpp>
#include <fstiff/profile/profile_form.hpp>

#include <memory>

namespace fstiff::cli {
namespace measure_command {
namespace {

struct Options {
    OutputOptions output;
    surface::MeasureOptions measure;
    std::vector<std::string> files;
    bool scales = false;
    std::string show;  ///< a command of its own, which Program::forward() chooses
    std::string modulus = "112.6 GPa", pressure = "10 MPa";
};

/// The document of --scales.
Report execute_scales(const Options& options, actions::ScalesOptions load) {
    if (options.files.size() != 1) throw Usage("--scales is of one file");
    load.progress = progress_bar();
    surface::MeasureOptions measure = options.measure;
    measure.input.file = options.files.front();
    const surface::SurfaceInput input = read_surface_input(measure.input);
    const auto surface =
        std::make_shared<const surface::MeasuredSurface>(measure_surface(measure, input, progress_bar()));
    const actions::Scales scales = scales_of(*surface, input, load);
    return report(document_of(measure, surface, scales, load), options.output.chosen());
}

Report execute(const Options& options) {
    actions::ScalesOptions load;  // checked where it is not used either
    load.pressure = document::parse_positive(options.pressure, io::Dimension::pressure, "--pressure");
    load.modulus = document::parse_positive(options.modulus, io::Dimension::pressure, "--modulus");
    if (options.scales) return execute_scales(options, load);
    surface::MeasureOptions measure = options.measure;
    const ProgressHook progress = progress_bar();
    measure.keep_maps = false;
    measure.parallel = all_cores(progress);
    const auto surface =
        std::make_shared<const surface::MeasuredSurface>(measure_files(measure, options.files, progress));
    return report(actions::document_of(measure, surface), options.output.chosen());
}

}  // namespace
}  // namespace measure_command

Command add_measure(Arguments& command) {
    using namespace measure_command;
    auto options = std::make_shared<Options>();
    surface::MeasureOptions& measure = options->measure;
    command.option(
        "files", options->files,
        {.help = "profile or map of any form; - is standard input. Several files of one surface, or a folder of them, "
                 "are pooled",
         .required = true,
         .form = request::Form::file});
    add_surface_options(command, measure.input);
    for (const char* key : {"columns", "channels", "peaks", "tip_radius", "resolution", "window"})
        add_surface_option(command, measure.input, key);
    command.group("Estimates");
    command.fields(measure);
    command.group("Analyses");
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
                 "islands (for a map) or spectrum",
         .words = {"fit", "islands", "spectrum"}});
    add_output_options(command, options->output, document::Format::json);
    return {&options->output, [options] { return execute(*options); }};
}

}  // namespace fstiff::cli
