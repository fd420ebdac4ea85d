// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The subcommands, one file each: they parse, call the library and print.

#include "input/output_options.hpp"

#include <functional>

namespace fstiff::cli {

/// A subcommand: what CLI11 parsed it into, and what to do then.
struct Command {
    CLI::App* app;
    const OutputOptions* output;
    std::function<Report()> execute;
};

Command add_run(CLI::App& app);
Command add_measure(CLI::App& app);
Command add_fit(CLI::App& app);
Command add_islands(CLI::App& app);
Command add_spectrum(CLI::App& app);
Command add_peaks(CLI::App& app);
Command add_generate(CLI::App& app);
Command add_ultrasound(CLI::App& app);
Command add_identify(CLI::App& app);
Command add_reproduce(CLI::App& app);
Command add_report(CLI::App& app);
Command add_truth(CLI::App& app);
Command add_formats(CLI::App& app);
Command add_export(CLI::App& app);
Command add_sweep(CLI::App& app);
Command add_merge(CLI::App& app);

}  // namespace fstiff::cli
