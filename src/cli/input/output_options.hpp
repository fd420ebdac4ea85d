// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// --format and --output, which every subcommand takes.

#include "document/output.hpp"
#include "input/arguments.hpp"

namespace fstiff::cli {

/// Adds --format and --output; \p initial is the format without --format.
void add_output_options(Arguments& arguments, OutputOptions& options,
                        document::Format initial = document::Format::table);
/// --output alone, for a subcommand that has one form.
void add_output_option(Arguments& arguments, OutputOptions& options);
/// --format alone, for a subcommand that writes a folder: its document goes to standard output.
void add_format_option(Arguments& arguments, OutputOptions& options,
                       document::Format initial = document::Format::table);

}  // namespace fstiff::cli
