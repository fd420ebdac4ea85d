// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// What the command line takes, as plain text: from it are made the manual pages and what shells complete, so that neither can
// say anything else than --help.

#include <string>
#include <vector>

namespace fstiff::cli {

struct DescribedOption {
    std::vector<std::string> names;    // as typed, such as -o and --output; of an argument without a dash the one name
    std::string type;                  // what stands for its value: TEXT, FILE, ...; empty for a flag
    std::vector<std::string> choices;  // the values that are taken, where they are words
    std::string range;                 // "in [1 - 1000]", or nothing
    std::string help;
    bool positional = false, required = false, many = false;
};

struct DescribedCommand {
    std::string name, description, footer;
    std::vector<DescribedOption> options;
};

struct DescribedProgram {
    DescribedCommand whole;  // the program itself
    std::string version;     // "fstiff 0.1.0"
    std::vector<DescribedCommand> commands;
};

/// Page of section 1 of the manual, in roff: that of the program where \p command is null.
[[nodiscard]] std::string manual_page(const DescribedProgram& program, const DescribedCommand* command);

/// Script that makes bash complete the program's commands, options and words; zsh takes it after `bashcompinit`.
[[nodiscard]] std::string completion_script(const DescribedProgram& program);

}  // namespace fstiff::cli
