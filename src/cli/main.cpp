// SPDX-License-Identifier: BSD-3-Clause
// fstiff: normal contact stiffness of rough surfaces. Exit codes are listed in output.hpp and at the end of --help.
#include "commands/commands.hpp"
#include "document/system.hpp"

#include <fstiff/core/error.hpp>
#include <fstiff/core/version.hpp>
#include <fstiff/io/units.hpp>

#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace fstiff::cli;
using fstiff::scene::option_error;

/// One line on standard error, whatever the message holds.
void say(const std::string& message) { std::cerr << "fstiff: " << printable(message) << '\n'; }

int execute(const Command& command) {
    name_inputs(given_texts(*command.app));
    const std::string file = command.output->target();
    if (!file.empty()) {
        require_writable(file);
        keep_for_output(file);
    }
    const Report report = command.execute();
    deliver(report.document, file);
    for (const std::string& line : report.diagnostics) say(line);
    return report.status;
}

/// The units of every kind of quantity.
std::string units() {
    std::string text = "Units, after a number and in quotation marks, such as \"0.5 um\" or \"0.5 µm\":";
    for (const auto& [dimension, name] : fstiff::names<fstiff::io::Dimension>)
        text += "\n  " + std::string(name) + std::string(25 - name.size(), ' ') + fstiff::io::accepted_units(dimension);
    return text;
}

/// The commands in the order of --help, under its headings; without a heading: an older name, which is not listed.
struct Listed {
    Command (*add)(CLI::App&);
    const char* group;
};
// clang-format off
constexpr Listed listed[] = {
    {add_run, "Compute"},          {add_report, "Compute"},    {add_sweep, "Compute"},    {add_export, "Compute"},
    {add_ultrasound, "Compute"},   {add_measure, "Surfaces"},  {add_formats, "Surfaces"}, {add_generate, "Surfaces"},
    {add_identify, "Measured K"},  {add_truth, "Checks"},      {add_reproduce, "Checks"}, {add_fit, ""},
    {add_islands, ""},             {add_peaks, ""},            {add_spectrum, ""},        {add_merge, ""}};
// clang-format on

int run(std::vector<std::string> words) {
    Program program("fstiff", "fstiff " FSTIFF_VERSION_TEXT,
                    "Normal contact stiffness of rough surfaces: load, real area and stiffness against pressure.",
                    units() +
                        "\nOlder names: fit, islands, peaks and spectrum are measure --show, merge is sweep --merge.\n"
                        "Exit codes: 0 done, 1 internal error, 2 usage, 3 bad input or data, or an output that cannot "
                        "be written, 4 result\noutside validity or not converged.\nExample:\n  fstiff run");
    std::vector<Command> commands;
    for (const Listed& one : listed) {
        commands.push_back(one.add(program.app()));
        program.list_under(*commands.back().app, one.group);
    }
    for (const char* shown : {"fit", "islands", "peaks", "spectrum"})
        program.forward("measure", {"--show", shown}, shown);
    program.forward("sweep", {"--merge"}, "merge");
    const CLI::App* chosen = program.parse(std::move(words));
    for (const Command& command : commands)
        if (command.app == chosen) return execute(command);
    deliver("", "");  // refuses when the help could not be written
    return success;
}

}  // namespace

int main(int argc, char** argv) {
    const fstiff::scene::os::Surroundings surroundings;
    try {
        return run(fstiff::scene::os::arguments(argc, argv));
    } catch (const Usage& error) {
        say(error.what());
        return usage_error;
    } catch (const option_error& error) {
        say(error.what());
        return usage_error;
    } catch (const fstiff::domain_error& error) {
        say(error.what());
        return input_error;
    } catch (const fstiff::file_error& error) {
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
