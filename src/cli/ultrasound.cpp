// SPDX-License-Identifier: BSD-3-Clause
// fstiff ultrasound: reflection of an interface from its stiffness, or the stiffness from a measured reflection.
#include "commands.hpp"

#include <fstiff/io/quantity.hpp>
#include <fstiff/ultrasound/spring_interface.hpp>

#include <memory>
#include <optional>

namespace fstiff::cli {
namespace {

/// A body: its impedance, or the density and velocity that give it.
struct Body {
    std::string impedance, density, velocity;
    bool given() const { return !impedance.empty() || !density.empty() || !velocity.empty(); }
};

struct Options {
    OutputOptions output;
    std::string stiffness, frequency;
    std::optional<double> reflection;
    Body incident, beyond;
};

double impedance(const Body& body, const std::string& suffix) {
    if (!body.impedance.empty() && (!body.density.empty() || !body.velocity.empty()))
        throw Usage("--impedance" + suffix + " stands beside --density" + suffix + " or --velocity" + suffix +
                    "; give the impedance or the other two");
    if (!body.impedance.empty())
        return io::parse_quantity(body.impedance, io::Dimension::impedance, "--impedance" + suffix);
    if (body.density.empty() || body.velocity.empty())
        throw Usage("the impedance is not known; give --impedance" + suffix + ", or --density" + suffix +
                    " and --velocity" + suffix);
    return acoustic_impedance(io::parse_quantity(body.density, io::Dimension::density, "--density" + suffix),
                              io::parse_quantity(body.velocity, io::Dimension::velocity, "--velocity" + suffix));
}

Report execute(const Options& options) {
    if (options.stiffness.empty() == !options.reflection)
        throw Usage("give one of --stiffness and --reflection; the other is computed");
    const double frequency = io::parse_quantity(options.frequency, io::Dimension::frequency, "--frequency");
    const double omega = angular_frequency(frequency);
    Impedances<double> media{};
    media.incident = impedance(options.incident, "");
    media.beyond = options.beyond.given() ? impedance(options.beyond, "2") : media.incident;

    const double stiffness =
        options.reflection ? stiffness_from_reflection(*options.reflection, media, omega)
                           : io::parse_quantity(options.stiffness, io::Dimension::stiffness_per_area, "--stiffness");
    const double reflected = options.reflection ? *options.reflection : reflection(stiffness, media, omega);
    const double transmitted = std::abs(complex_transmission(stiffness, media, omega));
    const double phase = std::arg(complex_reflection(stiffness, media, omega));

    const std::vector<std::pair<std::string, double>> numbers{
        {"frequency_Hz", frequency},
        {"impedance_Rayl", media.incident},
        {"impedance2_Rayl", media.beyond},
        {"stiffness_Pa_per_m", stiffness},
        {"reflection", reflected},
        {"reflection_phase_rad", phase},
        {"transmission", transmitted},
        {"transmitted_energy", transmitted_energy(stiffness, media, omega)},
        {"welded_reflection", welded_reflection(media)}};
    Report report;
    if (options.output.format == Format::csv) {
        std::vector<std::string> names, cells;
        for (const auto& [name, value] : numbers) {
            names.push_back(name);
            cells.push_back(exact(value));
        }
        report.document = csv_line(names) + csv_line(cells);
    } else if (options.output.format == Format::json) {
        Json document = json_document("ultrasound");
        document["given"] = options.reflection ? "reflection" : "stiffness";
        document["equations"] = {"(5.1)"};
        for (const auto& [name, value] : numbers) document[name] = json_number(value);
        report.document = json_text(document);
    } else {
        report.document =
            "interface as a spring, eq. (5.1)\n"
            "  frequency          " +
            rounded(frequency / 1e6, 6) +
            " MHz\n"
            "  impedances         " +
            rounded(media.incident / 1e6, 6) + " and " + rounded(media.beyond / 1e6, 6) +
            " MRayl\n"
            "  K per nominal area " +
            rounded(stiffness / 1e15, 6) + " GPa/µm = " + rounded(stiffness, 6) +
            " Pa/m\n"
            "  |R|                " +
            rounded(reflected, 6) + " (welded joint " + rounded(welded_reflection(media), 6) +
            ")\n"
            "  phase of R         " +
            rounded(phase, 6) +
            " rad\n"
            "  |T|                " +
            rounded(transmitted, 6) + " of displacement, " + rounded(transmitted_energy(stiffness, media, omega), 6) +
            " of the energy\n";
    }
    return report;
}

void add_body(CLI::App& command, Body& body, const std::string& suffix, const std::string& which) {
    command.add_option("--impedance" + suffix, body.impedance, "impedance of " + which + ", such as \"46 MRayl\"");
    command.add_option("--density" + suffix, body.density, "with --velocity" + suffix + " instead: \"7850 kg/m^3\"");
    command.add_option("--velocity" + suffix, body.velocity, "with --density" + suffix + " instead: \"5900 m/s\"");
}

}  // namespace

Command add_ultrasound(CLI::App& app) {
    auto options = std::make_shared<Options>();
    CLI::App* command =
        app.add_subcommand("ultrasound", "Ultrasonic reflection from the stiffness of an interface, or back");
    command->add_option("--stiffness", options->stiffness, "K per nominal area, such as \"1.764 GPa/um\"");
    command->add_option("--reflection", options->reflection, "measured |R| of displacement amplitudes, less than 1");
    command->add_option("--frequency", options->frequency, "frequency of the wave, such as \"7 MHz\"")->required();
    add_body(*command, options->incident, "", "the body that the wave comes from");
    add_body(*command, options->beyond, "2", "the body beyond (default: the same)");
    add_output_options(*command, options->output);
    command->footer(
        "Example:\n  fstiff ultrasound --stiffness \"1.764 GPa/um\" --frequency \"7 MHz\" --impedance \"46 MRayl\"");
    return {command, &options->output, [options] { return execute(*options); }};
}

}  // namespace fstiff::cli
