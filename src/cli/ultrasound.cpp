// SPDX-License-Identifier: BSD-3-Clause
// fstiff ultrasound: reflection of an interface from its stiffness, or the stiffness from measured reflections.
#include "commands.hpp"
#include "measured_curve.hpp"

#include <fstiff/core/version.hpp>
#include <fstiff/io/quantity.hpp>
#include <fstiff/ultrasound/propagation.hpp>
#include <fstiff/ultrasound/spring_interface.hpp>

#include <filesystem>
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
    std::string stiffness, frequency, reflection;
    std::optional<double> reflection_error;
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

/// The number that \p text is; none: the name of a file. "nan" and "inf" are numbers, so that they are refused as such.
std::optional<double> as_number(const std::string& text) {
    const std::string word = io::detail::lower_case(text);
    if (word == "nan" || word == "inf" || word == "-inf")
        throw domain_error("reflection = " + text + ": must be greater than 0 and less than 1");
    const auto number = io::detail::leading_number(text);
    if (number.length != text.size() || number.status != io::detail::NumberStatus::ok) return std::nullopt;
    return number.value;
}

/// A row of K(p) from R(p).
struct Row {
    MeasuredPoint point;
    double reflection_error;
    std::optional<MeasuredStiffness<double>> stiffness;  ///< none: no K has this R
};

/// K of every row of a file of R(p), with the error that follows from that of R.
Report from_file(const Options& options, double frequency, const Impedances<double>& media) {
    const MeasuredCurve curve = read_measured_curve(options.reflection);
    if (!curve.is_reflection)
        throw domain_error(curve.name + ": holds stiffnesses; must hold a column reflection to compute them from");
    const double omega = angular_frequency(frequency), welded = welded_reflection(media);
    const bool errors = curve.has_errors || options.reflection_error;
    std::vector<Row> rows;
    Report report;
    std::size_t doubtful = 0, first = 0, beyond = 0, first_beyond = 0;
    for (const MeasuredPoint& point : curve.points) {
        const double error = curve.has_errors ? point.error : options.reflection_error.value_or(0);
        if (!(point.value > welded && point.value < 1)) {  // what noise makes of light loads, or of heavy ones
            rows.push_back({point, error, {}});
            if (beyond++ == 0) first_beyond = point.line;
            continue;
        }
        try {
            rows.push_back({point, error, measured_stiffness(point.value, error, media, omega)});
        } catch (const domain_error& refusal) {
            throw domain_error(curve.name + ":" + std::to_string(point.line) + ": " + refusal.what());
        }
        if (!rows.back().stiffness->bounded && doubtful++ == 0) first = point.line;
    }
    std::vector<std::string> warnings;
    const auto in_rows = [&](std::size_t count, std::size_t line) {
        return " in " + std::to_string(count) + " of " + std::to_string(rows.size()) + " rows, the first at line " +
               std::to_string(line);
    };
    if (beyond > 0) {
        if (beyond == rows.size())
            throw domain_error(curve.name + ":" + std::to_string(first_beyond) +
                               ": reflection = " + shortest(rows.front().point.value) + ": must be greater than " +
                               shortest(welded) + ", that of the welded joint, and less than 1; no row is");
        warnings.push_back("R is not between that of the welded joint, " + rounded(welded) + ", and 1" +
                           in_rows(beyond, first_beyond) + ": no stiffness there");
        report.status = doubtful_result;
    }
    if (doubtful > 0)
        warnings.push_back("R is within two errors of 1 or of the welded joint" + in_rows(doubtful, first) +
                           ": the error of K is of first order and says too little there");

    if (options.output.format == Format::json) {
        Json document = json_document("ultrasound");
        document["given"] = "reflection";
        document["file"] = {{"name", curve.name}, {"sha256", curve.sha256}};
        document["decisions"] = curve.decisions;
        document["equations"] = {"(5.1)"};
        document["frequency_Hz"] = json_number(frequency);
        document["impedance_Rayl"] = json_number(media.incident);
        document["impedance2_Rayl"] = json_number(media.beyond);
        document["welded_reflection"] = json_number(welded);
        if (options.reflection_error && !curve.has_errors)
            document["reflection_error"] = json_number(*options.reflection_error);
        Json& list = document["rows"] = Json::array();
        for (const Row& row : rows) {
            Json entry{{"pressure_Pa", json_number(row.point.pressure)}, {"reflection", json_number(row.point.value)}};
            if (errors) entry["reflection_error"] = json_number(row.reflection_error);
            if (row.stiffness) {
                entry["stiffness_Pa_per_m"] = json_number(row.stiffness->value);
                if (errors) entry["stiffness_error_Pa_per_m"] = json_number(row.stiffness->error);
                entry["slope_Pa_per_m"] = json_number(row.stiffness->slope);
            } else {
                entry["stiffness_Pa_per_m"] = nullptr;
            }
            list.push_back(std::move(entry));
        }
        document["warnings"] = warnings;
        report.document = document.str();
    } else if (options.output.format == Format::csv) {
        // no column of R and no row without K: the document reads back as a measured K(p)
        std::vector<std::string> header{"pressure_Pa", "stiffness_Pa_per_m"};
        if (errors) header.push_back("stiffness_error_Pa_per_m");
        report.document = csv_line(header);
        for (const Row& row : rows) {
            if (!row.stiffness) continue;
            std::vector<std::string> cells{exact(row.point.pressure), exact(row.stiffness->value)};
            if (errors) cells.push_back(exact(row.stiffness->error));
            report.document += csv_line(cells);
        }
    } else {
        report.document = "fstiff " FSTIFF_VERSION ": stiffness from the reflections of " + curve.name +
                          ", interface as a spring, eq. (5.1)\n  " + rounded(frequency / 1e6, 6) + " MHz, impedances " +
                          rounded(media.incident / 1e6, 6) + " and " + rounded(media.beyond / 1e6, 6) +
                          " MRayl, welded joint |R| " + rounded(welded, 6) + "\n";
        std::vector<std::string> header{"p [MPa]", "|R|"};
        if (errors) header.push_back("error");
        header.push_back("K/A0 [GPa/µm]");
        if (errors) header.insert(header.end(), {"error [GPa/µm]", "error of K [%]"});
        TextTable table(header);
        for (const Row& row : rows) {
            std::vector<std::string> cells{rounded(row.point.pressure / 1e6), rounded(row.point.value)};
            if (errors) cells.push_back(rounded(row.reflection_error, 2));
            if (row.stiffness) {
                cells.push_back(rounded(row.stiffness->value / 1e15));
                if (errors)
                    cells.insert(cells.end(), {rounded(row.stiffness->error / 1e15, 2),
                                               rounded(100 * row.stiffness->error / row.stiffness->value, 2)});
            } else {
                cells.insert(cells.end(), errors ? 3 : 1, "-");
            }
            table.add(std::move(cells));
        }
        report.document += table.str();
    }
    for (const std::string& warning : warnings) {
        if (options.output.format == Format::table)
            report.document += "warning: " + warning + "\n";
        else
            report.diagnostics.push_back("warning: " + warning);
    }
    return report;
}

Report execute(const Options& options) {
    if (options.stiffness.empty() == options.reflection.empty())
        throw Usage("give one of --stiffness and --reflection; the other is computed");
    if (options.reflection_error && options.reflection.empty())
        throw Usage("--reflection-error is that of --reflection, which is not there");
    if (options.reflection_error && !(*options.reflection_error >= 0 && *options.reflection_error < 1))
        throw domain_error("--reflection-error = " + shortest(*options.reflection_error) +
                           ": must be at least 0 and less than 1");
    const double frequency = io::parse_quantity(options.frequency, io::Dimension::frequency, "--frequency");
    const double omega = angular_frequency(frequency);
    Impedances<double> media{};
    media.incident = impedance(options.incident, "");
    media.beyond = options.beyond.given() ? impedance(options.beyond, "2") : media.incident;

    std::optional<double> given;
    if (!options.reflection.empty()) {
        given = as_number(options.reflection);
        if (!given) {
            std::error_code ignored;
            if (options.reflection != "-" && !std::filesystem::exists(options.reflection, ignored))
                throw domain_error("--reflection = \"" + options.reflection +
                                   "\": must be a number or an existing file of measured reflections");
            return from_file(options, frequency, media);
        }
    }
    std::optional<MeasuredStiffness<double>> with_error;
    if (given && options.reflection_error)
        with_error = measured_stiffness(*given, *options.reflection_error, media, omega);
    const double stiffness =
        given ? stiffness_from_reflection(*given, media, omega)
              : io::parse_quantity(options.stiffness, io::Dimension::stiffness_per_area, "--stiffness");
    const double reflected = given ? *given : reflection(stiffness, media, omega);
    const double transmitted = std::abs(complex_transmission(stiffness, media, omega));
    const double phase = std::arg(complex_reflection(stiffness, media, omega));

    std::vector<std::pair<std::string, double>> numbers{
        {"frequency_Hz", frequency},
        {"impedance_Rayl", media.incident},
        {"impedance2_Rayl", media.beyond},
        {"stiffness_Pa_per_m", stiffness},
        {"reflection", reflected},
        {"reflection_phase_rad", phase},
        {"transmission", transmitted},
        {"transmitted_energy", transmitted_energy(stiffness, media, omega)},
        {"welded_reflection", welded_reflection(media)}};
    if (with_error) {
        numbers.emplace_back("reflection_error", *options.reflection_error);
        numbers.emplace_back("stiffness_error_Pa_per_m", with_error->error);
    }
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
        document["given"] = given ? "reflection" : "stiffness";
        document["equations"] = {"(5.1)"};
        for (const auto& [name, value] : numbers) document[name] = json_number(value);
        report.document = document.str();
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
            rounded(stiffness / 1e15, 6) + " GPa/µm = " + rounded(stiffness, 6) + " Pa/m" +
            (with_error ? " +- " + rounded(with_error->error / 1e15, 2) + " GPa/µm" : "") +
            "\n"
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

void add_body(Arguments& command, Body& body, const std::string& suffix, const std::string& which) {
    command.option("--impedance" + suffix, body.impedance, "impedance of " + which + ", such as \"46 MRayl\"");
    command.option("--density" + suffix, body.density, "with --velocity" + suffix + " instead: \"7850 kg/m^3\"");
    command.option("--velocity" + suffix, body.velocity, "with --density" + suffix + " instead: \"5900 m/s\"");
}

}  // namespace

Command add_ultrasound(CLI::App& app) {
    auto options = std::make_shared<Options>();
    Arguments command(app, "ultrasound", "Ultrasonic reflection from the stiffness of an interface, or back");
    command.option("--stiffness", options->stiffness, "K per nominal area, such as \"1.764 GPa/um\"");
    command.option("--reflection", options->reflection,
                   "measured |R| of displacement amplitudes, less than 1; or a file (CSV) of pressure, reflection "
                   "and, if known, reflection_error, to K(p); - is standard input");
    command.option("--reflection-error", options->reflection_error,
                   "standard error of the reflections that have no column of their own");
    command.option("--frequency", options->frequency, "frequency of the wave, such as \"7 MHz\"").required();
    add_body(command, options->incident, "", "the body that the wave comes from");
    add_body(command, options->beyond, "2", "the body beyond (default: the same)");
    add_output_options(command, options->output);
    command.footer(
        "A file begins with its columns and their units: pressure [MPa], reflection, reflection_error. Shear waves: "
        "give "
        "the\nimpedances of shear waves; the stiffness is then the tangential one. Exit code 4: rows whose R no "
        "stiffness gives.\n"
        "Example:\n  fstiff ultrasound --stiffness \"1.764 GPa/um\" --frequency \"7 MHz\" --impedance \"46 MRayl\"");
    return {command.app(), &options->output, [options] { return execute(*options); }};
}

}  // namespace fstiff::cli
