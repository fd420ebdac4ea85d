// SPDX-License-Identifier: BSD-3-Clause
// fstiff ultrasound: reflection of an interface from its stiffness, or the stiffness from measured reflections.
#include "commands/commands.hpp"
#include "document/document.hpp"
#include "scene/reflections.hpp"

#include <fstiff/core/version.hpp>

#include <memory>

namespace fstiff::cli {
namespace ultrasound_command {
namespace {

struct Options {
    OutputOptions output;
    ReflectionRequest request;
};

std::string six(double value) { return rounded(value, 6); }

std::string table_of_curve(const Reflection& found) {
    return "fstiff " FSTIFF_VERSION_TEXT ": stiffness from the reflections of " + found.curve->curve.name +
           ", interface as a spring, eq. (5.1)\n  " + six(found.frequency / 1e6) + " MHz, impedances " +
           six(found.media.incident / 1e6) + " and " + six(found.media.beyond / 1e6) + " MRayl, welded joint |R| " +
           six(found.welded) + "\n" + rows_of(*found.curve).text();
}

std::string table(const Reflection& found) {
    if (found.curve) return table_of_curve(found);
    const Reflected& one = found.one;
    return "interface as a spring, eq. (5.1)\n  frequency          " + six(found.frequency / 1e6) +
           " MHz\n  impedances         " + six(found.media.incident / 1e6) + " and " + six(found.media.beyond / 1e6) +
           " MRayl\n  K per nominal area " + six(one.stiffness / 1e15) + " GPa/µm = " + six(one.stiffness) + " Pa/m" +
           (one.stiffness_error ? " +- " + rounded(*one.stiffness_error / 1e15, 2) + " GPa/µm" : "") +
           "\n  |R|                " + six(one.reflection) + " (welded joint " + six(found.welded) +
           ")\n  phase of R         " + six(one.phase) + " rad\n  |T|                " + six(one.transmission) +
           " of displacement, " + six(one.transmitted_energy) + " of the energy\n";
}

std::string csv_of(const Reflection& found) {
    if (!found.curve) return csv(numbers_of(found));
    return rows_of(*found.curve).csv(true, [&](std::size_t i) { return found.curve->stiffness[i].has_value(); });
}

Report execute(const Options& options) {
    const Reflection found = reflection_of(options.request);
    return report(
        answer_of(found), [&] { return table(found); }, [&] { return csv_of(found); }, options.output.format);
}

}  // namespace
}  // namespace ultrasound_command

Command add_ultrasound(Arguments& command) {
    using namespace ultrasound_command;
    auto options = std::make_shared<Options>();
    ReflectionRequest& request = options->request;
    request.prefix = "--";
    command.fields(request);
    add_output_options(command, options->output);
    return {&options->output, [options] { return execute(*options); }};
}

}  // namespace fstiff::cli
