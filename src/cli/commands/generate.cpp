// SPDX-License-Identifier: BSD-3-Clause
// fstiff generate: Weierstrass-Mandelbrot profiles, self-affine Gaussian profiles and maps, as files that `fit` and
// `islands` read.
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

Command add_generate(CLI::App& app) {
    using namespace generate_command;
    auto options = std::make_shared<Options>();
    GenerateRequest& request = options->request;
    request.prefix = "--";
    Arguments command(app, "generate", "Profiles and maps of known D or H, as files to read back");
    command
        .option("kind", request.kind,
                "wm: Weierstrass-Mandelbrot profile; profile, map: self-affine Gaussian, periodic")
        .required();
    command
        .option("--points", request.points,
                "number of points of the profile (default 4096) or of a row of the map (default 256)")
        .between(GenerateRequest::min_side, GenerateRequest::max_points);
    command.option("--rows", request.rows, "number of rows of the map; the default is the number of points")
        .between(GenerateRequest::min_side, GenerateRequest::max_points);
    command.option("--spacing", request.spacing, "distance of neighbouring points, such as \"0.5 um\"");
    command.option("--dimension", request.dimension, "fractal dimension D of a wm profile, between 1 and 2");
    command.option("--roughness", request.roughness, "fractal roughness G of a wm profile, such as \"12 nm\"");
    command.option("--gamma", request.gamma, "ratio of neighbouring wavelengths of a wm profile; default 1.5");
    command.option("--hurst", request.hurst,
                   "Hurst exponent H of a profile or map, between 0 and 1; a section has D = 2 - H");
    command.option("--rms", request.rms, "rms height (Rq or Sq) of the profile or map, such as \"1 um\"");
    command.option("--longest", request.longest, "longest wavelength; the default is the longest side");
    command.option("--shortest", request.shortest, "shortest wavelength; the default is two spacings");
    command.option("--long-waves", request.long_waves,
                   "waves beyond the longest wavelength: plateau (default), as strong as it, or none");
    command.option("--seed", request.seed, "seed of the random phases or amplitudes; the default is 1");
    command.option("--format", request.format, "form of the file: csv (default), sdf (binary) or sdf-text")
        .type_name("FORMAT");
    add_output_option(command, options->output);
    command.footer(
        "The parameters and the seed stand in the first line of the CSV, on standard error for SDF.\n"
        "Example:\n"
        "  fstiff generate profile --points 8192 --spacing \"0.5 um\" --hurst 0.5 --rms \"1 um\" | fstiff fit -");
    return {command.app(), &options->output, [options] { return execute(*options); }};
}

}  // namespace fstiff::cli
