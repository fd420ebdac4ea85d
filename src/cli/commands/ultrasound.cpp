// SPDX-License-Identifier: BSD-3-Clause
// fstiff ultrasound: the reflection of a stiffness, or the stiffness of measured reflections.
#include "actions/ultrasound.hpp"
#include "commands/commands.hpp"
#include "input/output_options.hpp"
#include "picture/plot.hpp"

#include <memory>

namespace fstiff::cli {
namespace ultrasound_command {
namespace {

struct Options {
    OutputOptions output;
    actions::ReflectionRequest request;
    std::string picture;  ///< file; empty: none
};

Report execute(const Options& options) {
    keep_for_picture(options.picture, options.output.force);
    const actions::Reflection reflection = actions::reflection_of(options.request);
    if (!options.picture.empty() && !reflection.curve)
        throw Usage("--plot draws the stiffness of a file of reflections, --reflection FILE, which is not there");
    return with_picture(
        report(actions::document_of(reflection), options.output.format), [&] { return reflections_figure(reflection); },
        options.picture);
}

}  // namespace
}  // namespace ultrasound_command

Command add_ultrasound(Arguments& command) {
    using namespace ultrasound_command;
    auto options = std::make_shared<Options>();
    options->request.prefix = "--";
    command.fields(options->request);
    add_output_options(command, options->output);
    command.option("--plot", options->picture,
                   {.help = "draw K of a file against the frequency and the pressure into FILE.svg; the numbers go to "
                            "FILE.plot.csv",
                    .type = "FILE"});
    return {&options->output, [options] { return execute(*options); }};
}

}  // namespace fstiff::cli
