// SPDX-License-Identifier: BSD-3-Clause
// fstiff: normal contact stiffness of rough surfaces. Exit codes are listed in output.hpp and at the end of --help.
#include "commands/commands.hpp"
#include "document/own_output.hpp"
#include "document/system.hpp"

#include <fstiff/core/error.hpp>
#include <fstiff/core/version.hpp>

#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <utility>
#include <vector>

namespace fstiff::cli {

namespace {

using document::option_error;

/// One line on standard error, whatever the message holds.
void say(const std::string& message) { std::cerr << "fstiff: " << document::printable(message) << '\n'; }

int execute(const Command& command) {
    name_inputs(command.texts);
    const std::string file = command.output->target();
    if (!file.empty()) {
        require_writable(file);
        keep_for_output(file);
        if (!command.output->force) require_own(file);
    }
    const Report report = command.execute();
    deliver(report.document, file);
    for (const std::string& line : report.diagnostics) say(line);
    return report.status;
}

constexpr OldName old_names[] = {
    {"fit", "is fstiff measure --show fit, with the same options"},
    {"islands", "is fstiff measure --show islands, with the same options"},
    {"peaks", "is PeakDistribution of the C++ library; r and theta of a profile are in fstiff measure --show fit"},
    {"spectrum", "is fstiff measure --show spectrum, with the same options"},
    {"merge", "is cat part-*.jsonl > all.jsonl, of parts whose names are in the order of their --rows"},
    {"report", "is python -m fstiff report SCENE -o FILE.html, of the Python package"},
    {"reproduce", "is python examples/paper/reproduce.py FOLDER, a program of the source over the Python package"},
    {"materials", "is fstiff help materials"},
    {"processes", "is fstiff help processes"},
    {"units", "is fstiff help units"},
    {"plot", "is fstiff run SCENE --plot FILE.svg"},
    {"integral", "is a program of its own, example_integral, which a build from source makes"},
};

int run(std::vector<std::string> words) {
    Program program("fstiff", "fstiff " FSTIFF_VERSION_TEXT,
                    "Normal contact stiffness of rough surfaces against pressure, with a 90 % band.",
                    "Exit codes: 0 done, 1 internal error, 2 usage, 3 bad input or data, or an output that "
                    "cannot be written, 4 result\noutside validity or not converged.\nExample:\n  fstiff run --example "
                    "> joint.toml; fstiff run joint.toml",
                    commands(), help_topics(), old_names);
    if (const auto command = program.parse(std::move(words))) return execute(*command);
    deliver("", "");  // refuses when the help could not be written
    return success;
}

/// What main returns: every exception becomes a message and an exit code.
int run_or_say(int argc, char** argv) {
    try {
        return run(document::os::arguments(argc, argv));
    } catch (const Usage& error) {
        say(error.what());
        return usage_error;
    } catch (const option_error& error) {
        say(error.what());
        return usage_error;
    } catch (const domain_error& error) {
        say(error.what());
        return input_error;
    } catch (const file_error& error) {
        say(error.what());
        return input_error;
    } catch (const std::bad_alloc&) {
        say("out of memory");
        return internal_error;
    } catch (const std::exception& error) {
        say(std::string("internal error: ") + error.what());
        return internal_error;
    }
}

}  // namespace

}  // namespace fstiff::cli

int main(int argc, char** argv) {
    const fstiff::document::os::Surroundings surroundings;
    return fstiff::cli::run_or_say(argc, argv);
}
