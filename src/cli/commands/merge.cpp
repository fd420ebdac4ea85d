// SPDX-License-Identifier: BSD-3-Clause
// fstiff sweep --merge: the shards of a sweep as one file.
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
    report.document = "fstiff sweep --merge: " + counted(merged.scenes, "scene") + " of " +
                      counted(merged.shards, "shard") + " in " + printable(options.merged) + "\n";
    warn_of_failed_scenes(report, merged.failed);
    return report;
}

}  // namespace
}  // namespace merge_command

Command add_merge(Arguments& command) {
    using namespace merge_command;
    auto options = std::make_shared<Options>();
    command.option("files", options->files,
                   {.help = "files of results of fstiff sweep; names in .sweep are left out",
                    .required = true,
                    .form = request::Form::file});
    command.option("-o,--output", options->merged,
                   {.help = "file of all results, lines of JSON", .required = true, .type = "FILE"});
    return {&options->output, [options] { return execute(*options); }};
}

}  // namespace fstiff::cli
