// SPDX-License-Identifier: BSD-3-Clause
// fstiff export: the law of a scene as the table of a contact in a finite-element program, or as the text of a tabulated law.
#include "commands/commands.hpp"
#include "input/progress.hpp"
#include "input/scene_options.hpp"
#include "scene/overclosure.hpp"

#include <fstiff/core/version.hpp>
#include <fstiff/io/quantity.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace fstiff::cli {
namespace {

enum class Solver { calculix, abaqus, law };

}  // namespace
}  // namespace fstiff::cli

namespace fstiff {

template <>
inline constexpr auto names<cli::Solver> = name_list<cli::Solver>({{cli::Solver::calculix, "calculix"},
                                                                   {cli::Solver::abaqus, "abaqus"},
                                                                   {cli::Solver::law, "law"}});

}  // namespace fstiff

namespace fstiff::cli {
namespace export_command {
namespace {

struct Options {
    OutputOptions output;
    SceneOptions scene;
    Solver solver = Solver::calculix;
    std::string units = "mm,N,MPa", tolerance = "1%", from, to, law;
    int peaks = 1;
};

/// The units of a model.
struct Units {
    std::string length, force, pressure;
    double metre = 1, pascal = 1;  ///< one of them in these units
};

Units units_of(const std::string& list) {
    static constexpr std::array<std::pair<std::string_view, double>, 6> forces{
        {{"N", 1}, {"kN", 1e3}, {"MN", 1e6}, {"mN", 1e-3}, {"uN", 1e-6}, {"lbf", 4.4482216152605}}};
    const std::size_t first = list.find(','), second = list.find(',', first + 1);
    if (first == std::string::npos || second == std::string::npos)
        throw domain_error("--units = \"" + list +
                           "\": must be length, force and pressure, such as mm,N,MPa or m,N,Pa");
    Units units{.length = list.substr(0, first),
                .force = list.substr(first + 1, second - first - 1),
                .pressure = list.substr(second + 1)};
    const double length = io::parse_quantity("1 " + units.length, io::Dimension::length, "--units");
    const double pressure = io::parse_quantity("1 " + units.pressure, io::Dimension::pressure, "--units");
    const auto force =
        std::find_if(forces.begin(), forces.end(), [&](const auto& one) { return one.first == units.force; });
    if (force == forces.end())
        throw domain_error("--units = \"" + list + "\": " + units.force +
                           " is no unit of force; must be one of N, kN, MN, "
                           "mN, uN, lbf");
    if (std::abs(force->second / (length * length) / pressure - 1) > 1e-9)
        throw domain_error("--units = \"" + list + "\": must be consistent: 1 " + units.force + "/" + units.length +
                           "^2 is " + shortest(force->second / (length * length) / pressure) + " " + units.pressure);
    units.metre = 1 / length;
    units.pascal = 1 / pressure;
    return units;
}

double share_of(const std::string& text) {
    const bool percent = text.ends_with('%');
    const double number = io::parse_number(text.substr(0, text.size() - (percent ? 1 : 0)), "--tolerance");
    return percent ? number / 100 : number;
}

bool is_stiffness(const std::optional<scene::PressureTable::Range>& slope_over_stiffness) {
    constexpr double rounding = 1e-6;
    return slope_over_stiffness && std::abs(slope_over_stiffness->least - 1) < rounding &&
           std::abs(slope_over_stiffness->greatest - 1) < rounding;
}

/// The slope of the table against the K that run prints: the rest of a sentence "its slope is ...".
std::string slope_of(const scene::PressureTable& table) {
    const auto& ratio = table.slope_over_stiffness;
    if (!ratio) return "-dp/dd of law " + table.law + ", not the K of its unloading";
    if (is_stiffness(ratio)) return "-dp/dd, which is K of law " + table.law;
    const std::string least = rounded(ratio->least, 3), greatest = rounded(ratio->greatest, 3);
    return "-dp/dd, " + least + (least == greatest ? "" : " to " + greatest) + " of K of law " + table.law;
}

std::string document_of(const Scene& scene, const PressureTable& table, const Options& options,
                        const Units& units) {
    const bool calculix = options.solver == Solver::calculix;
    const auto pressure = [&](double p) { return rounded(p * units.pascal, 10); };
    const auto length = [&](double x) { return rounded(x * units.metre, 10); };
    std::string text;
    const auto say = [&](const std::string& line) { text += "** " + printable(line) + "\n"; };
    say("fstiff " FSTIFF_VERSION ": contact law for " + std::string(name_of(options.solver)) +
        ", pressure against overclosure; its slope is " + slope_of(table));
    say("scene     " + scene.name + " (" + scene.file + "), SHA-256 " + scene.sha256);
    for (const auto& [name, face] : measured_faces(scene))
        say(std::string(name) + "   " + face->measured->file + ", SHA-256 " + face->measured->sha256);
    say("law       " + table.title);
    say("units     " + units.length + ", " + units.force + ", " + units.pressure + "; pressure [" + units.pressure +
        "] against overclosure [" + units.length + "]");
    say("range     " + pressure(table.from) + " to " + pressure(table.to) + " " + units.pressure);
    say("rows      " + std::to_string(table.rows.size()) +
        "; between them the pressure is linear in the overclosure, at most " + rounded(100 * table.error, 3) +
        " % off the law");
    say("          at " + std::to_string(table.compared) + " pressures in the range (tolerance " +
        rounded(100 * share_of(options.tolerance), 3) + " %)");
    say("zero      faces drawn in touch have overclosure 0: the mean planes of the roughness are then");
    say("          " + length(table.zero_separation) + " " + units.length +
        " apart, and come closer by the overclosure.");
    say("          There the line of the first rows of the law meets pressure 0; below the range the table");
    say("          is that line, while the law falls to 0 as the faces part.");
    say("beyond    the last row " +
        std::string(calculix ? "the pressure stays what it is: choose --until above every pressure of the model"
                             : "Abaqus goes on along the last line"));
    if (calculix) say("contact   *CONTACT PAIR, INTERACTION=FSTIFF, TYPE=NODE TO SURFACE");
    text += calculix ? "*SURFACE INTERACTION, NAME=FSTIFF\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=TABULAR\n"
                     : "*Surface Interaction, name=FSTIFF\n1.,\n*Surface Behavior, pressure-overclosure=TABULAR\n";
    for (const auto& [p, x] : table.rows) text += pressure(p) + ", " + length(x) + "\n";
    return text;
}

Report execute(const Options& options) {
    if (const std::string file = options.output.target(); !file.empty()) require_own(file);
    const Units units = units_of(options.units);
    const auto pressure = [](const std::string& text, const char* name) {
        return text.empty() ? std::nullopt : std::optional(parse_positive(text, io::Dimension::pressure, name));
    };
    const scene::PressureTableOptions wanted{.law = options.law,
                                             .peaks = options.peaks,
                                             .from = pressure(options.from, "--from"),
                                             .to = pressure(options.to, "--to"),
                                             .tolerance = share_of(options.tolerance),
                                             .progress = progress_bar()};
    const Scene scene = read_scene(options.scene);
    if (options.solver == Solver::law) return {.document = law_text(scene, wanted), .diagnostics = {}};
    const scene::PressureTable table = pressure_table(scene, wanted);
    Report report{.document = document_of(scene, table, options, units), .diagnostics = {}};
    for (const std::string& warning : table.warnings) report.diagnostics.push_back("warning: " + warning);
    if (!is_stiffness(table.slope_over_stiffness))
        report.diagnostics.push_back("warning: the slope of the table is " + slope_of(table) +
                                     ", which fstiff run prints");
    if (table.doubtful) report.status = doubtful_result;
    return report;
}

}  // namespace
}  // namespace export_command

Command add_export(CLI::App& app) {
    using namespace export_command;
    auto options = std::make_shared<Options>();
    Arguments command(app, "export", "The law of a scene as the contact law of a finite-element program");
    add_scene_options(
        command, options->scene,
        "scene file (TOML); - is standard input; without it the fine sand-blasted surface of the paper",
        "profile, map, or JSON of fstiff measure, in place of the scene's [surface]; - is standard input");
    command.option("--to", options->solver, "program whose input is written; law: the tabulated law itself, for C, C++, Python and Fortran").required();
    command.option("--units", options->units, "units of the model, length, force and pressure, such as m,N,Pa")
        .show_default();
    command.option("--tolerance", options->tolerance, "largest error of the pressure between two rows").show_default();
    command.option("--from", options->from, "least pressure of the table; the default is that of the scene");
    command.option("--until", options->to, "greatest pressure of the table; the default is that of the scene");
    command.option("--law", options->law, "law of the scene; the default is its first that gives a separation");
    command.option("--peaks", options->peaks, "which of the scene's contact.peaks, from 1 on").show_default();
    add_output_option(command, options->output);
    command.footer(
        "A file that fstiff did not make is not replaced.\n"
        "Example:\n  fstiff export --to calculix --units mm,N,MPa --tolerance 1%");
    return {command.app(), &options->output, [options] { return execute(*options); }};
}

}  // namespace fstiff::cli
