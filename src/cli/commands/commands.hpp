// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The commands, one file each: they add their options, call the library and print. commands.cpp has their table.

#include "input/output_options.hpp"

namespace fstiff::cli {

[[nodiscard]] std::span<const CommandRow> commands();
/// The tables of `fstiff help`: materials, processes and units.
[[nodiscard]] std::span<const HelpTopic> help_topics();

Command add_run(Arguments& command);
Command add_sweep(Arguments& command);
Command add_export(Arguments& command);
Command add_ultrasound(Arguments& command);
Command add_measure(Arguments& command);
Command add_fit(Arguments& command);
Command add_islands(Arguments& command);
Command add_spectrum(Arguments& command);
Command add_generate(Arguments& command);
Command add_identify(Arguments& command);
Command add_truth(Arguments& command);
Command add_formats(Arguments& command);

}  // namespace fstiff::cli
