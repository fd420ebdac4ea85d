// SPDX-License-Identifier: BSD-3-Clause
// fstiff merge: the shards of a sweep as one file.
#include "commands/commands.hpp"
#include "commands/failed_scenes.hpp"
#include "document/output.hpp"
#include "sweep/results_file.hpp"

#include <memory>

namespace fstiff::cli {
namespace merge_command {
namespace {

struct Options {
    OutputOptions output;
    std::vector<std::string> files;
    std::string merged;
};

Report execute(const Options& options) {
    refuse_standard_output(options.merged, "a file, because its description is written next to it");
    sweep::require_lines(options.merged);
    require_writable(options.merged);
    const sweep::Merged merged = sweep::merge(options.files, options.merged);
    if (!merged.problems.empty()) return {"", merged.problems, doubtful_result};
    Report report;
    report.document = "fstiff merge: " + counted(merged.scenes, "scene") + " of " + counted(merged.shards, "shard") +
                      " in " + printable(options.merged) + "\n";
    warn_of_failed_scenes(report, merged.failed);
    return report;
}

}  // namespace
}  // namespace merge_command

Command add_merge(CLI::App& app) {
    using namespace merge_command;
    auto options = std::make_shared<Options>();
    Arguments command(app, "merge", "The shards of a sweep as one file");
    command.option("files", options->files, "files of results of fstiff sweep; names in .sweep are left out")
        .required();
    command.option("-o,--output", options->merged, "file of all results, lines of JSON").type_name("FILE").required();
    command.footer(
        "Exit code 4: a shard is missing, duplicate, unfinished or from another grid; nothing is written, and each "
        "such shard\n"
        "is listed with the command that computes it. Also 4 if some scenes cannot be computed.\n"
        "Example:\n  fstiff sweep --example > grid.toml; for i in 1 2; do fstiff sweep grid.toml --shard $i/2 -o "
        "part-$i.jsonl; "
        "done; fstiff merge part-*.jsonl -o all.jsonl");
    return {command.app(), &options->output, [options] { return execute(*options); }};
}

}  // namespace fstiff::cli
