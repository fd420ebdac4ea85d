// SPDX-License-Identifier: BSD-3-Clause
// fstiff generate: Weierstrass-Mandelbrot profiles, self-affine Gaussian profiles and maps, as files to read back.
#include "commands/commands.hpp"
#include "surface/generated.hpp"

#include <memory>

namespace fstiff::cli {
namespace generate_command {
namespace {

struct Options {
    OutputOptions output;
    GenerateRequest request;
};

Report execute(const Options& options) {
    const Generated generated = generate(options.request);
    Report report{.document = file_of(generated, options.request.format), .diagnostics = {}};
    if (options.request.format != GeneratedForm::csv)
        report.diagnostics.push_back(generated.origin());  // there is no room for it in the file
    return report;
}

}  // namespace
}  // namespace generate_command

Command add_generate(Arguments& command) {
    using namespace generate_command;
    auto options = std::make_shared<Options>();
    GenerateRequest& request = options->request;
    request.prefix = "--";
    command.fields(request);
    add_output_option(command, options->output);
    return {&options->output, [options] { return execute(*options); }};
}

}  // namespace fstiff::cli
