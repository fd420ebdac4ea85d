// SPDX-License-Identifier: BSD-3-Clause
// fstiff ultrasound: reflection of an interface from its stiffness, or the stiffness from measured reflections.
#include "commands/commands.hpp"
#include "document/document.hpp"
#include "io/number.hpp"
#include "scene/measured_curve.hpp"

#include <fstiff/core/version.hpp>
#include <fstiff/io/quantity.hpp>
#include <fstiff/ultrasound/propagation.hpp>
#include <fstiff/ultrasound/spring_interface.hpp>

#include <filesystem>
#include <memory>
#include <optional>

namespace fstiff::cli {
namespace ultrasound_command {
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
        return parse_positive(body.impedance, io::Dimension::impedance, "--impedance" + suffix);
    if (body.density.empty() || body.velocity.empty())
        throw Usage("the impedance is not known; give --impedance" + suffix + ", or --density" + suffix +
                    " and --velocity" + suffix);
    return acoustic_impedance(parse_positive(body.density, io::Dimension::density, "--density" + suffix),
                              parse_positive(body.velocity, io::Dimension::velocity, "--velocity" + suffix));
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

/// K(p) from the R(p) of a file; no stiffness where no K has the R.
struct FromFile {
    MeasuredCurve curve;
    std::vector<double> errors;  ///< of R; empty: not known
    std::vector<std::optional<MeasuredStiffness<double>>> stiffness;
    std::vector<std::string> warnings;
    Status status = success;
};

FromFile convert(const Options& options, const Impedances<double>& media, double omega) {
    FromFile all{.curve = read_measured_curve(options.reflection), .errors = {}, .stiffness = {}, .warnings = {}};
    const MeasuredCurve& curve = all.curve;
    if (!curve.is_reflection)
        throw domain_error(curve.name + ": holds stiffnesses; must hold a column reflection to compute them from");
    const double welded = welded_reflection(media);
    std::size_t doubtful = 0, first = 0, beyond = 0, first_beyond = 0;
    for (const MeasuredPoint& point : curve.points) {
        const double error = curve.has_errors ? point.error : options.reflection_error.value_or(0);
        if (curve.has_errors || options.reflection_error) all.errors.push_back(error);
        if (!(point.value > welded && point.value < 1)) {  // what noise makes of light loads, or of heavy ones
            all.stiffness.emplace_back();
            if (beyond++ == 0) first_beyond = point.line;
            continue;
        }
        all.stiffness.emplace_back(located(Place{.file = curve.name, .line = point.line, .before_line = ":"},
                                           [&] { return measured_stiffness(point.value, error, media, omega); }));
        if (!all.stiffness.back()->bounded && doubtful++ == 0) first = point.line;
    }
    const auto in_rows = [&](std::size_t count, std::size_t line) {
        return " in " + std::to_string(count) + " of " + std::to_string(curve.points.size()) +
               " rows, the first at line " + std::to_string(line);
    };
    if (beyond > 0) {
        if (beyond == curve.points.size())
            throw domain_error(curve.name + ":" + std::to_string(first_beyond) +
                               ": reflection = " + shortest(curve.points.front().value) + ": must be greater than " +
                               shortest(welded) + ", that of the welded joint, and less than 1; no row is");
        all.warnings.push_back("R is not between that of the welded joint, " + rounded(welded) + ", and 1" +
                               in_rows(beyond, first_beyond) + ": no stiffness there");
        all.status = doubtful_result;
    }
    if (doubtful > 0)
        all.warnings.push_back("R is within two errors of 1 or of the welded joint" + in_rows(doubtful, first) +
                               ": the error of K is of first order and says too little there");
    return all;
}

/// The CSV has no column of R: it reads back as a measured K(p).
Rows rows_of(const FromFile& all) {
    std::vector<double> pressures, values;
    for (const MeasuredPoint& point : all.curve.points) {
        pressures.push_back(point.pressure);
        values.push_back(point.value);
    }
    const auto of = [&](const auto& value, const Cell& otherwise = {}) {
        std::vector<Cell> cells;
        for (const auto& k : all.stiffness) cells.push_back(k ? Cell(value(*k)) : otherwise);
        return cells;
    };
    using K = MeasuredStiffness<double>;
    const bool errors = !all.errors.empty();
    Rows rows;
    rows.add({"pressure_Pa", "p [MPa]", 1e-6}, pressures);
    rows.add({.key = "reflection", .shown = "|R|", .csv = false}, values);
    if (errors) rows.add({.key = "reflection_error", .shown = "error", .digits = 2, .csv = false}, all.errors);
    rows.add({"stiffness_Pa_per_m", "K/A0 [GPa/µm]", 1e-15}, of([](const K& k) { return k.value; }, Cell::Kind::null));
    if (errors) {
        rows.add({"stiffness_error_Pa_per_m", "error [GPa/µm]", 1e-15, 2}, of([](const K& k) { return k.error; }));
        rows.add({"", "error of K [%]", 100, 2}, of([](const K& k) { return k.error / k.value; }));
    }
    rows.add({.key = "slope_Pa_per_m", .csv = false}, of([](const K& k) { return k.slope; }));
    return rows;
}

/// K of every row of a file of R(p), with the error that follows from that of R.
Report from_file(const Options& options, double frequency, const Impedances<double>& media) {
    const FromFile all = convert(options, media, angular_frequency(frequency));
    const double welded = welded_reflection(media);
    const auto json = [&] {
        Json document = json_document("ultrasound");
        document["given"] = "reflection";
        document["file"] = {{"name", all.curve.name}, {"sha256", all.curve.sha256}};
        document["decisions"] = all.curve.decisions;
        document["equations"] = {"(5.1)"};
        put(document, {{"frequency_Hz", frequency},
                       {"impedance_Rayl", media.incident},
                       {"impedance2_Rayl", media.beyond},
                       {"welded_reflection", welded}});
        if (options.reflection_error && !all.curve.has_errors) document["reflection_error"] = *options.reflection_error;
        rows_of(all).append_to(document["rows"] = Json::array());
        return document;
    };
    const auto table = [&] {
        return "fstiff " FSTIFF_VERSION ": stiffness from the reflections of " + all.curve.name +
               ", interface as a spring, eq. (5.1)\n  " + rounded(frequency / 1e6, 6) + " MHz, impedances " +
               rounded(media.incident / 1e6, 6) + " and " + rounded(media.beyond / 1e6, 6) +
               " MRayl, welded joint |R| " + rounded(welded, 6) + "\n" + rows_of(all).text();
    };
    return report(
        {.table = table,
         .csv = [&] { return rows_of(all).csv(true, [&](std::size_t i) { return all.stiffness[i].has_value(); }); },
         .json = json,
         .warnings = all.warnings,
         .status = all.status},
        options.output.format);
}

/// R of --stiffness, or K of the one reflection that is \p given, and what else follows.
Report single(const Options& options, double frequency, const Impedances<double>& media, std::optional<double> given) {
    const double omega = angular_frequency(frequency);
    std::optional<MeasuredStiffness<double>> with_error;
    if (given && options.reflection_error)
        with_error = measured_stiffness(*given, *options.reflection_error, media, omega);
    const double stiffness =
        given ? stiffness_from_reflection(*given, media, omega)
              : io::parse_quantity(options.stiffness, io::Dimension::stiffness_per_area, "--stiffness");
    const double reflected = given ? *given : reflection(stiffness, media, omega);
    const double transmitted = std::abs(complex_transmission(stiffness, media, omega));
    const double phase = std::arg(complex_reflection(stiffness, media, omega));
    const double energy = transmitted_energy(stiffness, media, omega), welded = welded_reflection(media);
    Numbers numbers{
        {"frequency_Hz", frequency},       {"impedance_Rayl", media.incident}, {"impedance2_Rayl", media.beyond},
        {"stiffness_Pa_per_m", stiffness}, {"reflection", reflected},          {"reflection_phase_rad", phase},
        {"transmission", transmitted},     {"transmitted_energy", energy},     {"welded_reflection", welded}};
    if (with_error) {
        numbers.emplace_back("reflection_error", *options.reflection_error);
        numbers.emplace_back("stiffness_error_Pa_per_m", with_error->error);
    }
    const auto six = [](double value) { return rounded(value, 6); };
    const auto table = [&] {
        return "interface as a spring, eq. (5.1)\n  frequency          " + six(frequency / 1e6) +
               " MHz\n  impedances         " + six(media.incident / 1e6) + " and " + six(media.beyond / 1e6) +
               " MRayl\n  K per nominal area " + six(stiffness / 1e15) + " GPa/µm = " + six(stiffness) + " Pa/m" +
               (with_error ? " +- " + rounded(with_error->error / 1e15, 2) + " GPa/µm" : "") +
               "\n  |R|                " + six(reflected) + " (welded joint " + six(welded) +
               ")\n  phase of R         " + six(phase) + " rad\n  |T|                " + six(transmitted) +
               " of displacement, " + six(energy) + " of the energy\n";
    };
    const auto json = [&] {
        Json document = json_document("ultrasound");
        document["given"] = given ? "reflection" : "stiffness";
        document["equations"] = {"(5.1)"};
        put(document, numbers);
        return document;
    };
    return report({.table = table, .csv = [&] { return csv(numbers); }, .json = json, .json_warnings = false},
                  options.output.format);
}

Report execute(const Options& options) {
    if (options.stiffness.empty() == options.reflection.empty())
        throw Usage("give one of --stiffness and --reflection; the other is computed");
    if (options.reflection_error && options.reflection.empty())
        throw Usage("--reflection-error is that of --reflection, which is not there");
    if (options.reflection_error && !(*options.reflection_error >= 0 && *options.reflection_error < 1))
        throw domain_error("--reflection-error = " + shortest(*options.reflection_error) +
                           ": must be at least 0 and less than 1");
    const double frequency = parse_positive(options.frequency, io::Dimension::frequency, "--frequency");
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
    return single(options, frequency, media, given);
}

void add_body(Arguments& command, Body& body, const std::string& suffix, const std::string& which) {
    command.option("--impedance" + suffix, body.impedance, "impedance of " + which + ", such as \"46 MRayl\"");
    command.option("--density" + suffix, body.density,
                   "density of that body, such as \"7850 kg/m^3\"; needs --velocity" + suffix);
    command.option("--velocity" + suffix, body.velocity,
                   "velocity of sound in that body, such as \"5900 m/s\"; needs --density" + suffix);
}

}  // namespace
}  // namespace ultrasound_command

Command add_ultrasound(CLI::App& app) {
    using namespace ultrasound_command;
    auto options = std::make_shared<Options>();
    Arguments command(app, "ultrasound", "Ultrasonic reflection from the stiffness of an interface, or back");
    command.option("--stiffness", options->stiffness,
                   "normal contact stiffness K per nominal area, such as \"1.764 GPa/um\"");
    command.option(
        "--reflection", options->reflection,
        "reflection coefficient |R| of displacement amplitudes, less than 1; or a file (CSV) of pressure, reflection "
        "and, if known, reflection_error, to K(p); - is standard input");
    command.option("--reflection-error", options->reflection_error,
                   "standard error of the reflection coefficient, where a file has no column of it");
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
