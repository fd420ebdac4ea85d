// SPDX-License-Identifier: BSD-3-Clause
// fstiff sweep: a grid of scenes to one line a row of results.
#include "commands/commands.hpp"
#include "document/output.hpp"
#include "input/progress.hpp"
#include "sweep/engine.hpp"
#include "sweep/results_file.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <thread>

namespace fstiff::cli {

extern const char* const example_grid;  // examples/sweeps/grid.toml

namespace sweep_command {
namespace {

/// "1 scene", "2 scenes".
std::string counted(std::uint64_t count, const std::string& what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

struct Options {
    OutputOptions output;  // of the summary
    std::string grid, results, shard = "1/1";
    int threads = 0;  ///< 0: as many as there are cores
    bool example = false;
};

/// {shard} in the name of the results is the number of the shard, with zeros before it, so that names are in the order
/// of the shards.
std::string results_file(std::string file, const sweep::Shard& shard) {
    const std::string place = "{shard}", number = std::to_string(shard.number);
    const std::string padded = std::string(std::to_string(shard.of).size() - number.size(), '0') + number;
    for (std::size_t begin = file.find(place); begin != std::string::npos; begin = file.find(place))
        file.replace(begin, place.size(), padded);
    return file;
}

std::string summary(const sweep::Grid& grid, const sweep::Description& description, const std::string& file) {
    std::string text = "fstiff sweep: " + document::printable(grid.file) + ", " + counted(grid.size, "scene");
    if (description.shard.of > 1)
        text += ", of which shard " + description.shard.text() + " has " +
                std::to_string(description.shard.end(grid.size) - description.shard.first(grid.size));
    text += "; results in " + document::printable(file) + "\n";
    for (const sweep::Axis& axis : grid.axes) {
        text += "  " + axis.key;
        if (!axis.unit.empty()) text += " [" + axis.unit + "]";
        const auto shown = [](double value) { return document::rounded(value, 6); };
        if (axis.range)
            text += ": " + shown(axis.range->from) + " to " + shown(axis.range->to) + ", " +
                    std::to_string(axis.range->count) + " values by " +
                    (axis.range->log ? "equal factors" : "equal steps");
        else if (axis.drawn)
            text +=
                axis.drawn->kind == sweep::Distribution::Kind::uniform
                    ? ": between " + shown(axis.drawn->a) + " and " + shown(axis.drawn->b)
                : axis.drawn->kind == sweep::Distribution::Kind::normal
                    ? ": normal, " + shown(axis.drawn->a) + " +- " + shown(axis.drawn->b)
                    : ": lognormal, median " + shown(axis.drawn->a) + ", " + shown(axis.drawn->b) + " of the logarithm";
        else
            text += ": " + counted(axis.count(), "listed value");
        text += "\n";
    }
    if (grid.samples > 1)
        text += "  " + counted(grid.samples, "draw") + " at each point of the grid, seed " + std::to_string(grid.seed) +
                "\n";
    return text;
}

Report execute(const Options& options) {
    if (options.example) {
        if (!options.grid.empty() || !options.results.empty())
            throw Usage("--example prints a grid and computes nothing; give no grid and no -o with it");
        return {example_grid, {}, success};
    }
    if (options.grid.empty() || options.results.empty())
        throw Usage("a grid and -o FILE are needed; see fstiff sweep --help");
    refuse_standard_output(options.results, "a file, so that an interrupted run can continue");
    const sweep::Shard shard = sweep::parse_shard(options.shard);
    const std::string file = results_file(options.results, shard);
    sweep::require_lines(file);
    require_writable(file);
    keep_for_output(file);
    const sweep::Grid grid = sweep::read_grid(document::read_all(options.grid, document::longest_scene),
                                              document::display_name(options.grid));
    for (const std::string& named : grid.files) require_no_output(named);
    std::optional<sweep::SceneMaker> maker;  // before anything is written: it refuses wrong values
    if (!std::filesystem::exists(document::path_of(sweep::description_file(file)))) maker.emplace(grid);
    sweep::ResultsFile results(file, {.grid = grid.file, .hash = grid.hash, .scenes = grid.size, .shard = shard});
    Report report;
    if (results.dropped() > 0)
        report.diagnostics.push_back("the run before was interrupted: " + std::to_string(results.dropped()) +
                                     " bytes at the end of " + file + " are computed again");
    const std::uint64_t first = results.next(), end = shard.end(grid.size);
    const auto begun = std::chrono::steady_clock::now();
    if (!results.description().finished) {
        if (!maker) maker.emplace(grid);
        const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
        const unsigned wanted = options.threads > 0 ? static_cast<unsigned>(options.threads) : cores;
        const unsigned started =
            sweep::run(grid, *maker, first, end, {.threads = wanted, .progress = progress_bar(true)},
                       [&](const sweep::Block& block) { results.append(block.lines, block.end, block.failed); });
        results.finish();
        if (started < wanted)
            report.diagnostics.push_back(std::to_string(started) + " of " + counted(wanted, "thread") +
                                         " ran; the system has no room for more");
    }
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    report.diagnostics.push_back(
        first == end ? "nothing is left to compute"
                     : counted(end - first, "scene") + " in " + document::rounded(seconds, 3) + " s, " +
                           document::rounded(static_cast<double>(end - first) / seconds, 3) + " per second");
    report.document = summary(grid, results.description(), file);
    if (const std::uint64_t failed = results.description().failed; failed > 0) {
        report.diagnostics.push_back(
            "warning: " + counted(failed, "scene") +
            " cannot be computed, or only in part; a line with the key \"error\" replaces the missing results");
        report.status = doubtful_result;
    }
    return report;
}

}  // namespace
}  // namespace sweep_command

Command add_sweep(Arguments& command) {
    using namespace sweep_command;
    auto options = std::make_shared<Options>();
    command.option("grid", options->grid, {"scene file (TOML) with swept quantities; - is standard input"});
    command.option(
        "-o,--output", options->results,
        {.help = "file of results, one JSON object a line; {shard} in its name is the number of the shard, and "
                 "cat joins the files of all shards. An interrupted run continues with the same arguments",
         .type = "FILE"});
    command.option("--threads", options->threads,
                   {.help = "threads that compute; the default is one for each core", .low = 1, .high = 4096});
    command.option("--shard", options->shard,
                   {"part i/n of the grid, i from 1 to n, or auto: that of the Slurm job array, or of mpirun"});
    command.option("--example", options->example, {"print a grid with comments, to begin one of your own"});
    return {&options->output, [options] { return execute(*options); }};
}

}  // namespace fstiff::cli
