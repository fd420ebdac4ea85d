// SPDX-License-Identifier: BSD-3-Clause
// fstiff sweep: a grid of scenes to one line a row of results.
#include "commands/commands.hpp"
#include "document/own_output.hpp"
#include "input/progress.hpp"
#include "sweep/engine.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <memory>
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
    OutputOptions summary, results;
    std::string grid, rows;
    int threads = 0;  ///< 0: as many as there are cores
    bool counts = false, example = false;
};

/// "1000:2000"; empty are all of \p grid.
sweep::Rows rows_of(const std::string& text, const sweep::Grid& grid) {
    sweep::Rows rows{0, grid.size};
    if (text.empty()) return rows;
    const char* const end = text.data() + text.size();
    const auto from = std::from_chars(text.data(), end, rows.first);
    const bool parted = from.ec == std::errc() && from.ptr != end && *from.ptr == ':';
    const auto to = std::from_chars(parted ? from.ptr + 1 : end, end, rows.end);
    if (to.ec != std::errc() || to.ptr != end) rows.end = 0;
    grid.require(rows, "--rows = \"" + text + "\": must be FROM:TO");
    return rows;
}

/// \throws Usage for the ending of a table or of another binary form.
void require_lines(const std::string& results) {
    for (const char* other : {".parquet", ".h5", ".hdf5", ".csv", ".tsv", ".txt", ".nc", ".npy", ".xlsx"})
        if (results.ends_with(other))
            throw Usage(results + ": results are lines of JSON, file.jsonl; pandas and pyarrow read them");
}

std::string summary(const sweep::Grid& grid, const std::string& rows, const std::string& file) {
    std::string text = "fstiff sweep: " + document::printable(grid.file) + ", " + counted(grid.size, "scene");
    if (!rows.empty()) text += ", of which " + rows + " are computed";
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
    const std::string file = options.results.target();
    if (options.example) {
        if (!options.grid.empty() || !file.empty())
            throw Usage("--example prints a grid and computes nothing; give no grid and no -o with it");
        return {example_grid, {}, success};
    }
    if (options.grid.empty()) throw Usage("a grid is needed; see fstiff sweep --help");
    if (options.counts && (!file.empty() || !options.rows.empty()))
        throw Usage("--count prints a number and computes nothing; give no -o and no --rows with it");
    if (!file.empty()) {
        require_lines(file);
        require_writable(file);
        keep_for_output(file);
        if (!options.results.force) require_own(file);
    }
    const sweep::Grid grid = sweep::read_grid(document::read_all(options.grid, document::longest_scene),
                                              document::display_name(options.grid));
    if (options.counts) return {std::to_string(grid.size) + "\n", {}, success};
    for (const std::string& named : grid.files) require_no_output(named);
    const sweep::Rows rows = rows_of(options.rows, grid);
    sweep::SceneMaker maker(grid);  // before anything is written: it refuses wrong values
    OutputFiles results(file.empty() ? std::vector<std::string>() : std::vector{file});
    Report report;
    std::uint64_t failed = 0;
    const auto begun = std::chrono::steady_clock::now();
    const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
    const unsigned wanted = options.threads > 0 ? static_cast<unsigned>(options.threads) : cores;
    const unsigned started = sweep::run(grid, maker, rows, {.threads = wanted, .progress = progress_bar(true)},
                                        [&](const sweep::Block& block) {
                                            file.empty() ? deliver(block.lines, "") : results.write(0, block.lines);
                                            failed += block.failed;
                                        });
    results.finish();
    if (started < wanted)
        report.diagnostics.push_back(std::to_string(started) + " of " + counted(wanted, "thread") +
                                     " ran; the system has no room for more");
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    report.diagnostics.push_back(counted(rows.end - rows.first, "scene") + " in " + document::rounded(seconds, 3) +
                                 " s, " + document::rounded(static_cast<double>(rows.end - rows.first) / seconds, 3) +
                                 " per second");
    if (!file.empty()) report.document = summary(grid, options.rows, file);
    if (failed > 0) {
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
    add_output_option(command, options->results);
    command.option("--threads", options->threads,
                   {.help = "threads that compute; the default is one for each core", .low = 1, .high = 4096});
    command.option(
        "--rows", options->rows,
        {.help = "scenes whose index, from 0 on, is at least FROM and less than TO; default all", .type = "FROM:TO"});
    command.option("--count", options->counts, {"print the number of scenes and compute none"});
    command.option("--example", options->example, {"print a grid with comments, to begin one of your own"});
    return {&options->summary, [options] { return execute(*options); }};
}

}  // namespace fstiff::cli
