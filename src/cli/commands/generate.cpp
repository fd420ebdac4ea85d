// SPDX-License-Identifier: BSD-3-Clause
// fstiff generate: Weierstrass-Mandelbrot profiles, self-affine Gaussian profiles and maps, as files that `fit` and
// `islands` read.
#include "commands/commands.hpp"
#include "input/surface_options.hpp"
#include "instances/surface_instances.hpp"

#include <fstiff/core/version.hpp>
#include <fstiff/io/quantity.hpp>
#include <fstiff/io/write.hpp>
#include <fstiff/synthetic/self_affine.hpp>
#include <fstiff/synthetic/weierstrass_mandelbrot.hpp>

#include <algorithm>
#include <memory>
#include <optional>
#include <sstream>
#include <variant>

namespace fstiff::cli {
namespace generate_command {
namespace {

struct Options {
    OutputOptions output;
    std::string kind, form = "csv";
    std::size_t points = 0, rows = 0;  ///< 0: by default
    std::string spacing;
    std::optional<double> dimension, hurst;
    std::string roughness, rms, longest, shortest;
    double gamma = 1.5;
    LongWaves long_waves = LongWaves::plateau;
    std::uint64_t seed = 1;
};

/// Of one document: 2^22 heights are some 90 MB of text.
constexpr std::size_t max_points = std::size_t(1) << 22;

using Surface = std::variant<Profile<double>, HeightMap<double>>;
using Parameters = std::vector<std::pair<std::string, std::string>>;

struct Generated {
    Surface surface;
    Parameters parameters;  ///< all of them, as they were used
};

/// Refuses the options that the kind has no use for, and those that it misses.
void check_options(const Options& options) {
    const bool wm = options.kind == "wm", map = options.kind == "map";
    const auto only = [&](bool given, bool wanted, const std::string& name, bool needed) {
        if (given && !wanted) throw Usage(name + " is not for generate " + options.kind + "; must not be given");
        if (!given && wanted && needed) throw Usage("generate " + options.kind + " needs " + name);
    };
    only(!options.spacing.empty(), true, "--spacing", true);
    only(options.dimension.has_value(), wm, "--dimension", true);
    only(!options.roughness.empty(), wm, "--roughness", true);
    only(options.gamma != 1.5, wm, "--gamma", false);
    only(options.hurst.has_value(), !wm, "--hurst", true);
    only(!options.rms.empty(), !wm, "--rms", true);
    only(options.long_waves != LongWaves::plateau, !wm, "--long-waves", false);
    only(options.rows != 0, map, "--rows", false);
    const std::size_t rows = !map ? 1 : options.rows == 0 ? options.points : options.rows;
    if (options.points > max_points || rows > max_points / options.points)
        throw domain_error("points = " + std::to_string(options.points) + " x " + std::to_string(rows) +
                           ": must be at most 2^22 (4194304) in all");
}

Generated make(Options options) {
    if (options.points == 0) options.points = options.kind == "map" ? 256 : 4096;
    check_options(options);
    const double spacing = parse_length(options.spacing, "--spacing");
    const auto length = [](const std::string& text, const char* name, double otherwise) {
        return text.empty() ? otherwise : parse_length(text, name);
    };
    const bool map = options.kind == "map";
    const std::size_t rows = !map ? 1 : options.rows == 0 ? options.points : options.rows;
    const double side = static_cast<double>(std::max(options.points, rows)) * spacing;
    const double longest = length(options.longest, "--longest", side);
    const double shortest_wave = length(options.shortest, "--shortest", 2 * spacing);
    Generated result;
    const auto say = [&](const std::string& name, const std::string& value) {
        result.parameters.emplace_back(name, value);
    };
    const auto metres = [](double value) { return shortest(value) + " m"; };
    say("kind", options.kind);
    if (options.kind == "wm") {
        const Fractal<double> fractal{*options.dimension, parse_length(options.roughness, "--roughness")};
        const WeierstrassMandelbrot<double> wm(fractal, {.longest_wavelength = longest,
                                                         .shortest_wavelength = shortest_wave,
                                                         .gamma = options.gamma,
                                                         .seed = options.seed});
        // each point is a sum over all waves
        if (options.points > (std::size_t(1) << 30) / wm.terms())
            throw domain_error("points times waves = " + std::to_string(options.points) + " x " +
                               std::to_string(wm.terms()) + ": must be at most 2^30");
        result.surface = wm.sample(options.points, spacing);
        say("D", shortest(fractal.dimension));
        say("G", metres(fractal.roughness));
        say("gamma", shortest(options.gamma));
        say("waves", std::to_string(wm.terms()));
    } else {
        SelfAffineOptions<double> how;
        how.hurst = *options.hurst;
        how.rms = parse_length(options.rms, "--rms");
        how.longest_wavelength = longest;
        how.shortest_wavelength = shortest_wave;
        how.long_waves = options.long_waves;
        how.seed = options.seed;
        if (map)
            result.surface = self_affine_map(how, options.points, rows, spacing, spacing);
        else
            result.surface = self_affine_profile(how, options.points, spacing);
        say("H", shortest(how.hurst));
        say("rms", metres(how.rms));
        say("beyond the longest wave", std::string(name_of(options.long_waves)));
    }
    say("longest wave", metres(longest));
    say("shortest wave", metres(shortest_wave));
    say("seed", std::to_string(options.seed));
    return result;
}

/// Comments above the numbers, worded so that no reader takes them for a size or a unit.
std::string header(const Generated& generated) {
    std::string line;
    for (const auto& [name, value] : generated.parameters) line += (line.empty() ? "" : ", ") + name + " " + value;
    return "# made by fstiff " FSTIFF_VERSION " generate (" + line + ")\n";
}

Report execute(const Options& options) {
    const Generated generated = make(options);
    Report report;
    std::ostringstream stream;
    std::visit(
        [&](const auto& surface) {
            if (options.form == "csv") {
                stream << header(generated);
                io::write_csv(stream, surface);
            } else {
                io::write_sdf(stream, surface, {.binary = options.form == "sdf"});
            }
        },
        generated.surface);
    report.document = std::move(stream).str();
    if (options.form != "csv") {  // there is no room for it in the file
        std::string text = header(generated).substr(2);
        text.pop_back();
        report.diagnostics.push_back(std::move(text));
    }
    return report;
}

}  // namespace
}  // namespace generate_command

Command add_generate(CLI::App& app) {
    using namespace generate_command;
    auto options = std::make_shared<Options>();
    Arguments command(app, "generate", "Profiles and maps of known D or H, as files to read back");
    command
        .option("kind", options->kind,
                "wm: Weierstrass-Mandelbrot profile; profile, map: self-affine Gaussian, periodic")
        .required()
        .one_of({"wm", "profile", "map"});
    command
        .option("--points", options->points,
                "number of points of the profile (default 4096) or of a row of the map (default 256)")
        .between(std::size_t(16), max_points);
    command.option("--rows", options->rows, "number of rows of the map; the default is the number of points")
        .between(std::size_t(16), max_points);
    command.option("--spacing", options->spacing, "distance of neighbouring points, such as \"0.5 um\"");
    command.option("--dimension", options->dimension, "fractal dimension D of a wm profile, between 1 and 2");
    command.option("--roughness", options->roughness, "fractal roughness G of a wm profile, such as \"12 nm\"");
    command.option("--gamma", options->gamma, "ratio of neighbouring wavelengths of a wm profile; default 1.5");
    command.option("--hurst", options->hurst,
                   "Hurst exponent H of a profile or map, between 0 and 1; a section has D = 2 - H");
    command.option("--rms", options->rms, "rms height (Rq or Sq) of the profile or map, such as \"1 um\"");
    command.option("--longest", options->longest, "longest wavelength; the default is the longest side");
    command.option("--shortest", options->shortest, "shortest wavelength; the default is two spacings");
    command.option("--long-waves", options->long_waves,
                   "waves beyond the longest wavelength: plateau (default), as strong as it, or none");
    command.option("--seed", options->seed, "seed of the random phases or amplitudes; the default is 1");
    command.option("--format", options->form, "form of the file: csv (default), sdf (binary) or sdf-text")
        .type_name("FORMAT")
        .one_of({"csv", "sdf", "sdf-text"});
    add_output_option(command, options->output);
    command.footer(
        "The parameters and the seed stand in the first line of the CSV, on standard error for SDF.\n"
        "Example:\n"
        "  fstiff generate profile --points 8192 --spacing \"0.5 um\" --hurst 0.5 --rms \"1 um\" | fstiff fit -");
    return {command.app(), &options->output, [options] { return execute(*options); }};
}

}  // namespace fstiff::cli
