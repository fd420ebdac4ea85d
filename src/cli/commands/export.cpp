// SPDX-License-Identifier: BSD-3-Clause
// fstiff export: the law of a scene as the table of a contact in a finite-element program, or as the text of a
// tabulated law.
#include "commands/commands.hpp"
#include "input/progress.hpp"
#include "input/scene_options.hpp"
#include "scene/exported_law.hpp"

#include <memory>

namespace fstiff::cli {
namespace export_command {
namespace {

struct Options {
    OutputOptions output;
    SceneOptions scene;
    ExportRequest request;
};

Report execute(const Options& options) {
    if (const std::string file = options.output.target(); !file.empty()) require_own(file);
    ExportRequest request = options.request;
    request.progress = progress_bar();
    check(request);  // errors of the request are reported before the scene is read
    const ExportedLaw made = export_law(read_scene(options.scene), request);
    Report report{.document = made.text, .diagnostics = {}, .status = made.doubtful ? doubtful_result : success};
    for (const std::string& warning : made.warnings) report.diagnostics.push_back("warning: " + warning);
    return report;
}

}  // namespace
}  // namespace export_command

Command add_export(Arguments& command) {
    using namespace export_command;
    auto options = std::make_shared<Options>();
    ExportRequest& request = options->request;
    request.prefix = "--";
    add_scene_options(
        command, options->scene,
        "scene file (TOML); - is standard input; without it the fine sand-blasted surface of the paper",
        "profile, map, or JSON of fstiff measure, in place of the scene's [surface]; - is standard input");
    command.fields(request);
    add_output_option(command, options->output);
    return {&options->output, [options] { return execute(*options); }};
}

}  // namespace fstiff::cli
