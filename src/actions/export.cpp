// SPDX-License-Identifier: BSD-3-Clause
#include "actions/export.hpp"

#include "actions/contact_cards.hpp"
#include "document/file.hpp"

#include <fstiff/core/version.hpp>
#include <fstiff/io/quantities.hpp>
#include <fstiff/io/units.hpp>

#include <algorithm>
#include <cmath>

namespace fstiff::actions {
namespace {

double share_of(const std::string& text, const std::string& name) {
    const bool percent = text.ends_with('%');
    const std::string number_alone = text.substr(0, text.size() - (percent ? 1 : 0));
    const double number = io::parse_number(number_alone, name);
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
    const std::string of_law = " of " + table.law;
    if (!ratio) return "-dp/dd" + of_law + ", not the K of its unloading";
    const std::string within = ", within " + document::rounded(100 * table.error.slope, 3) + " %";
    if (is_stiffness(ratio)) return "-dp/dd, which is K" + of_law + within;
    const std::string least = document::rounded(ratio->least, 3), greatest = document::rounded(ratio->greatest, 3);
    const std::string of_K = least + (least == greatest ? "" : " to " + greatest) + " of K" + of_law;
    if (!table.follows_slope) return of_K + "; no table follows -dp/dd, which jumps between neighbouring pressures";
    return "-dp/dd, " + of_K + within;
}

ModelUnits units_of(const ExportRequest& request) {
    return model_units(request.units, surface::option_name(request.prefix, "units"));
}

/// Which K of the answer \p request takes; none: a law of the scene. \throws domain_error for a quantile with
/// another law.
std::optional<double> quantile_of(const ExportRequest& request) {
    const std::string name = surface::option_name(request.prefix, "quantile");
    const std::string law = surface::option_name(request.prefix, "law") + " " + std::string(answer_word);
    if (request.law != answer_word) {
        if (!request.quantile.empty()) throw domain_error(name + ": is for " + law);
        if (!request.after.empty())
            throw domain_error(surface::option_name(request.prefix, "after") + ": is for " + law);
        return std::nullopt;
    }
    const double quantile = request.quantile.empty() ? 0.5 : share_of(request.quantile, name);
    if (quantile != 0.05 && quantile != 0.5 && quantile != 0.95) detail::refuse(name, quantile, 6, "5 %, 50 % or 95 %");
    return quantile;
}

/// Beginning of a comment of the program.
std::string comment_of(Solver to) { return to == Solver::moose ? "# " : to == Solver::comsol ? "% " : "** "; }

/// Behaviour of the program for an overclosure above that of the last row.
std::string beyond(Solver to) {
    switch (to) {
        case Solver::calculix: return "the pressure stays constant: choose --until above every pressure of the model";
        case Solver::abaqus: return "Abaqus extrapolates the last line";
        case Solver::moose: return "PiecewiseLinear keeps the last value unless extrap = true";
        default: return "as the interpolation function is set, constant by default";
    }
}

/// The comments on where the law comes from, how close the table of its pressures is, and what lies outside of it.
std::string heading_of(const scene::Scene& scene, const LawInModel& law, const ExportRequest& request) {
    const PressureTable& table = law.table;
    const ModelUnits& units = law.units;
    std::string text;
    const auto say = [&](const std::string& line) {
        text += comment_of(request.to) + document::printable(line) + "\n";
    };
    say("fstiff " FSTIFF_VERSION_TEXT ": contact law for " + std::string(name_of(request.to)) +
        ", pressure against overclosure; its slope is " + slope_of(table));
    say("scene     " + scene.name + " (" + scene.file + "), SHA-256 " + scene.sha256);
    for (const auto& [name, face, file] : scene.measured_files())
        say(std::string(name) + "   " + file->file + ", SHA-256 " + file->sha256);
    say("law       " + table.title);
    const auto slope = [&](double K) { return document::rounded(units.stiffness(K), 4); };
    for (const auto& [p, K, low, high, by] : table.answer)
        say("answer    at " + law.pressure(p) + " " + units.pressure + " K is " + slope(K) + " " +
            units.of_stiffness() + ", 90 % band " + slope(low) + " to " + slope(high) + ", by " + by +
            (by == "boundary_elements" ? ", which has no table" : ""));
    say("units     " + units.length + ", " + units.force + ", " + units.pressure + "; pressure [" + units.pressure +
        "] against overclosure [" + units.length + "]");
    if (scene.given.form || scene.given.flatness)
        say("faces     conform: their form is that of the mesh, and not in this law");
    say("range     " + law.pressure(table.from) + " to " + law.pressure(table.to) + " " + units.pressure);
    if (request.to == Solver::calculix || request.to == Solver::abaqus) text += comment_of_pressure(law);
    say("zero      faces drawn in contact have overclosure 0: the mean planes of the roughness are then");
    say("          " + law.length(table.zero_separation) + " " + units.length +
        " apart and approach each other by the overclosure.");
    say("          The line through the first rows reaches pressure 0 there; below the range the table");
    say("          is that line, whereas the law falls to 0 as the faces separate.");
    say("beyond    the last row " + beyond(request.to));
    if (request.to == Solver::calculix) say("contact   *CONTACT PAIR, INTERACTION=FSTIFF, TYPE=NODE TO SURFACE");
    return text;
}

std::string body_of(const LawInModel& law, Solver to) {
    switch (to) {
        case Solver::calculix: return calculix_cards(law);
        case Solver::abaqus: return abaqus_cards(law);
        case Solver::moose: return moose_columns(law);
        default: return comsol_columns(law);
    }
}

/// The pressure of the one stiffness that a card of friction holds [Pa].
double pressure_of_friction(const detail::ResolvedJoint& problem, const PressureTable& table,
                            const ExportRequest& request) {
    if (request.at.empty()) return std::sqrt(table.from * table.to);
    const std::string name = surface::option_name(request.prefix, "at");
    if (!problem.friction) throw domain_error(name + " is for a scene with [friction]; this scene has none");
    const double pressure = request.at.positive(io::Dimension::pressure, name);
    constexpr double rounding = 1e-9;
    detail::require(pressure >= table.from * (1 - rounding) && pressure <= table.to * (1 + rounding), name, pressure,
                    "from " + document::rounded(table.from) + " Pa to " + document::rounded(table.to) +
                        " Pa, the range of the table");
    return pressure;
}

PressureTableOptions options_of(const ExportRequest& request) {
    const auto pressure = [&](const request::Amount& given, const char* key) {
        return given.empty()
                   ? std::nullopt
                   : std::optional(given.positive(io::Dimension::pressure, surface::option_name(request.prefix, key)));
    };
    return {
        .law = request.law == answer_word ? std::string() : request.law,
        .quantile = quantile_of(request),
        .after = pressure(request.after, "after"),
        .peaks = request.peaks,
        .from = pressure(request.from, "from"),
        .to = pressure(request.until, "until"),
        .tolerance = share_of(request.tolerance, surface::option_name(request.prefix, "tolerance")),
        .slope_tolerance = share_of(request.slope_tolerance, surface::option_name(request.prefix, "slope_tolerance")),
        .prefix = request.prefix,
        .progress = request.progress};
}

/// The most rows of numbers below one card of \p text.
std::size_t longest_table(std::string_view text) {
    std::size_t longest = 0, rows = 0;
    for (; !text.empty(); text.remove_prefix(text.find('\n') + 1)) {
        rows = text.front() == '*' ? 0 : rows + 1;
        longest = std::max(longest, rows);
    }
    return longest;
}

/// CalculiX makes a table of so many rows from a longer one.
void warn_of_resampling(const LawInModel& law, std::string_view text, document::Document& document) {
    constexpr std::size_t kept = 200, sure = 186;  // a shorter range has other points to choose rows from
    if (longest_table(text) <= kept) return;
    std::string way_out = "give larger tolerances or a shorter range";
    const auto& rows = law.table.rows;
    const auto p = [&](std::size_t row) { return document::rounded(rows[row].pressure * law.units.pascal, 2); };
    if (rows.size() > kept)
        way_out += ", such as " + p(rows.size() - sure) + " to " + p(rows.size() - 1) + " or " + p(1) + " to " +
                   p(sure) + " " + law.units.pressure;
    document.warnings.push_back(
        "CalculiX takes a table of more than " + std::to_string(kept) +
        " rows at as many equal steps, so that the tolerances do not hold at small pressures; " + way_out);
}

}  // namespace

void check(const ExportRequest& request) {
    (void)units_of(request);
    (void)options_of(request);
}

document::Document document_of(const scene::Scene& joint, const ExportRequest& request) {
    scene::Scene scene = joint;  // of the faces: a mesh has the form itself
    scene.joint.form.reset(), scene.joint.flatness = 0;
    const ModelUnits units = units_of(request);
    const PressureTableOptions wanted = options_of(request);
    const auto of_text = [](std::string text) {
        return document::Document::of_file([text = std::move(text)] { return text; });
    };
    if (request.to == Solver::law) return of_text(law_text(scene, wanted));
    const PressureTable table = pressure_table(scene, wanted);
    LawInModel law{.table = table, .units = units, .tolerance = {wanted.tolerance, wanted.slope_tolerance}};
    law.at = pressure_of_friction(scene.joint, table, request);
    if (scene.joint.friction) law.friction = scene.joint.friction->coefficient;
    const std::string text = heading_of(scene, law, request) + body_of(law, request.to);
    document::Document document = of_text(text);
    document.warnings = table.warnings;
    document.doubtful = table.doubtful;
    if (!is_stiffness(table.slope_over_stiffness))
        document.warnings.push_back(
            "the slope of the table is " + slope_of(table) +
            (table.follows_slope ? ", which fstiff run prints; " + surface::option_name(request.prefix, "law") +
                                       " answer has the K of the answer as its slope"
                                 : "; give a larger " + surface::option_name(request.prefix, "slope_tolerance") +
                                       ", or the law hybrid, whose slope is K"));
    if (request.to == Solver::calculix) warn_of_resampling(law, text, document);
    return document;
}

}  // namespace fstiff::actions
