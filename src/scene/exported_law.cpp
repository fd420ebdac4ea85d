// SPDX-License-Identifier: BSD-3-Clause
#include "scene/exported_law.hpp"

#include "document/file.hpp"

#include <fstiff/core/version.hpp>
#include <fstiff/io/units.hpp>

#include <algorithm>
#include <cmath>

namespace fstiff::scene {
namespace {

/// The units of a model.
struct ModelUnits {
    std::string length, force, pressure;
    double metre = 1, pascal = 1;  ///< one of them in these units
};

ModelUnits units_of(const ExportRequest& request) {
    const std::string &list = request.units, name = option_name(request.prefix, "units");
    const std::size_t first = list.find(','), second = list.find(',', first + 1);
    if (first == std::string::npos || second == std::string::npos)
        throw domain_error(name + " = \"" + list +
                           "\": must be length, force and pressure, such as mm,N,MPa or m,N,Pa");
    ModelUnits units{.length = list.substr(0, first),
                .force = list.substr(first + 1, second - first - 1),
                .pressure = list.substr(second + 1)};
    const double length = io::parse_quantity("1 " + units.length, io::Dimension::length, name);
    const double pressure = io::parse_quantity("1 " + units.pressure, io::Dimension::pressure, name);
    if (!io::is_unit(units.force, io::Dimension::force))
        throw domain_error(name + " = \"" + list + "\": " + units.force + " is no unit of force; must be one of " +
                           io::accepted_units(io::Dimension::force));
    const double force = io::unit_factor(units.force, io::Dimension::force);
    if (std::abs(force / (length * length) / pressure - 1) > 1e-9)
        throw domain_error(name + " = \"" + list + "\": must be consistent: 1 " + units.force + "/" + units.length +
                           "^2 is " + shortest(force / (length * length) / pressure) + " " + units.pressure);
    units.metre = 1 / length;
    units.pascal = 1 / pressure;
    return units;
}

double share_of(const ExportRequest& request) {
    const std::string& text = request.tolerance;
    const bool percent = text.ends_with('%');
    const std::string number_alone = text.substr(0, text.size() - (percent ? 1 : 0));
    const double number = io::parse_number(number_alone, option_name(request.prefix, "tolerance"));
    return percent ? number / 100 : number;
}

bool is_stiffness(const std::optional<PressureTable::Range>& slope_over_stiffness) {
    constexpr double rounding = 1e-6;
    return slope_over_stiffness && std::abs(slope_over_stiffness->least - 1) < rounding &&
           std::abs(slope_over_stiffness->greatest - 1) < rounding;
}

/// The slope of the table against the K that run prints: the rest of a sentence "its slope is ...".
std::string slope_of(const PressureTable& table) {
    const auto& ratio = table.slope_over_stiffness;
    if (!ratio) return "-dp/dd of law " + table.law + ", not the K of its unloading";
    if (is_stiffness(ratio)) return "-dp/dd, which is K of law " + table.law;
    const std::string least = rounded(ratio->least, 3), greatest = rounded(ratio->greatest, 3);
    return "-dp/dd, " + least + (least == greatest ? "" : " to " + greatest) + " of K of law " + table.law;
}

std::string document_of(const Scene& scene, const PressureTable& table, const ExportRequest& request,
                        const ModelUnits& units) {
    const bool calculix = request.to == Solver::calculix;
    const auto pressure = [&](double p) { return rounded(p * units.pascal, 10); };
    const auto length = [&](double x) { return rounded(x * units.metre, 10); };
    std::string text;
    const auto say = [&](const std::string& line) { text += "** " + printable(line) + "\n"; };
    say("fstiff " FSTIFF_VERSION ": contact law for " + std::string(name_of(request.to)) +
        ", pressure against overclosure; its slope is " + slope_of(table));
    say("scene     " + scene.name + " (" + scene.file + "), SHA-256 " + scene.sha256);
    for (const auto& [name, face] : measured_faces(scene))
        say(std::string(name) + "   " + face->measured->file + ", SHA-256 " + face->measured->sha256);
    say("law       " + table.title);
    const auto slope = [&](double K) { return rounded(K * units.pascal / units.metre, 4); };
    for (const auto& [p, K, low, high, law] : table.answer)
        say("answer    at " + pressure(p) + " " + units.pressure + " K is " + slope(K) + " " + units.pressure + "/" +
            units.length + ", 90 % band " + slope(low) + " to " + slope(high) + ", by " + law +
            (law == "boundary_elements" ? ", which has no table" : ""));
    say("units     " + units.length + ", " + units.force + ", " + units.pressure + "; pressure [" + units.pressure +
        "] against overclosure [" + units.length + "]");
    say("range     " + pressure(table.from) + " to " + pressure(table.to) + " " + units.pressure);
    say("rows      " + std::to_string(table.rows.size()) +
        "; between them the pressure is linear in the overclosure, at most " + rounded(100 * table.error, 3) +
        " % off the law");
    say("          at " + std::to_string(table.compared) + " pressures in the range (tolerance " +
        rounded(100 * share_of(request), 3) + " %)");
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

PressureTableOptions options_of(const ExportRequest& request) {
    const auto pressure = [&](const Amount& given, const char* key) {
        return given.empty() ? std::nullopt
                             : std::optional(given.positive(io::Dimension::pressure, option_name(request.prefix, key)));
    };
    return {.law = request.law,
            .peaks = request.peaks,
            .from = pressure(request.from, "from"),
            .to = pressure(request.until, "until"),
            .tolerance = share_of(request),
            .prefix = request.prefix,
            .progress = request.progress};
}

}  // namespace

void check(const ExportRequest& request) {
    (void)units_of(request);
    (void)options_of(request);
}

ExportedLaw export_law(const Scene& scene, const ExportRequest& request) {
    const ModelUnits units = units_of(request);
    const PressureTableOptions wanted = options_of(request);
    if (request.to == Solver::law) return {.text = law_text(scene, wanted)};
    const PressureTable table = pressure_table(scene, wanted);
    ExportedLaw made{.text = document_of(scene, table, request, units),
                     .warnings = table.warnings,
                     .doubtful = table.doubtful};
    if (!is_stiffness(table.slope_over_stiffness))
        made.warnings.push_back("the slope of the table is " + slope_of(table) + ", which fstiff run prints");
    return made;
}

}  // namespace fstiff::scene
