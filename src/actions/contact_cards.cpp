// SPDX-License-Identifier: BSD-3-Clause
#include "actions/contact_cards.hpp"

#include "document/file.hpp"

#include <algorithm>
#include <cmath>

#include <fstiff/core/error.hpp>
#include <fstiff/io/quantities.hpp>
#include <fstiff/io/units.hpp>

namespace fstiff::actions {

ModelUnits model_units(const std::string& list, const std::string& name) {
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
        throw domain_error(name + " = \"" + list + "\": " + units.force + " is not a unit of force; must be one of " +
                           io::accepted_units(io::Dimension::force));
    const double force = io::unit_factor(units.force, io::Dimension::force);
    if (std::abs(force / (length * length) / pressure - 1) > 1e-9)
        throw domain_error(name + " = \"" + list + "\": must be consistent: 1 " + units.force + "/" + units.length +
                           "^2 is " + document::shortest(force / (length * length) / pressure) + " " + units.pressure);
    units.metre = 1 / length;
    units.newton = 1 / force;
    units.pascal = 1 / pressure;
    return units;
}

namespace {

std::string number(double value) { return document::rounded(value, 10); }

/// Conductances against what a program looks them up by.
struct CardRows {
    std::string text;
    double error = 0;
    std::size_t count = 0;
};

/// Lines "\p value, \p by" and \p end, as few as the tolerance asks for.
CardRows card_rows(const LawInModel& law, const std::vector<double>& value, const std::vector<double>& by,
                   const std::string& end = {}) {
    const std::vector<Line> lines{LawColumns::line(by, value)};
    const std::vector<std::size_t> chosen = rows_within(lines, fine_tolerance(law.tolerance));
    CardRows rows{.text = number(value[0]) + ", " + number(by[0]) + end + "\n",
                  .error = error_of_rows(lines, chosen).value,
                  .count = chosen.size() + 1};
    for (const std::size_t i : chosen) rows.text += number(value[i + 1]) + ", " + number(by[i + 1]) + end + "\n";
    return rows;
}

/// \p values in other units.
template <class Convert>
std::vector<double> converted(std::vector<double> values, Convert convert) {
    for (double& value : values) value = convert(value);
    return values;
}

std::vector<double> pressures_of(const LawInModel& law) {
    return converted(law.table.columns.pressure, [&](double p) { return p * law.units.pascal; });
}

std::vector<double> heat_of(const LawInModel& law) {
    return converted(law.table.columns.heat, [&](double h) { return law.units.heat(h); });
}

std::vector<double> current_of(const LawInModel& law) {
    return converted(law.table.columns.current, [&](double h) { return law.units.current(h); });
}

std::string pressure_rows(const LawInModel& law) {
    std::string text;
    for (const auto& [p, x] : law.table.rows) text += law.pressure(p) + ", " + law.length(x) + "\n";
    return text;
}

std::string comment_of_heat(const LawInModel& law, const CardRows& rows) {
    return "** heat      " + law.units.of_heat() + ", of which 1 W/(m^2 K) is " + number(law.units.heat(1)) + "; " +
           std::to_string(rows.count) + " rows, at most " + document::rounded(100 * rows.error, 3) +
           " % off between them\n";
}

/// The tangential stiffness at \p pressure [Pa], by a power law between two points of the fine grid: to six digits.
double tangential_at(const LawColumns& columns, double pressure) {
    const auto& p = columns.pressure;
    const auto above = std::clamp(std::lower_bound(p.begin(), p.end(), pressure), p.begin() + 2, p.end() - 1);
    const auto i = static_cast<std::size_t>(above - p.begin());
    const double share = std::log(pressure / p[i - 1]) / std::log(p[i] / p[i - 1]);
    return columns.tangential[i - 1] * std::pow(columns.tangential[i] / columns.tangential[i - 1], share);
}

/// "at 1 MPa; 2 at 0.1 MPa and 3 at 10 MPa, the ends of the range".
template <class Value>
std::string where_it_holds(const LawInModel& law, const std::string& unit, Value value) {
    const auto at_pressure = [&](double p) { return " at " + law.pressure(p) + " " + law.units.pressure; };
    return "holds" + at_pressure(law.at) + "; it is " + document::rounded(value(law.table.from), 4) +
           at_pressure(law.table.from) + " and " + document::rounded(value(law.table.to), 4) +
           at_pressure(law.table.to) + " [" + unit + "]";
}

/// The overclosure as CalculiX sees it where it looks up a conductance: see calculix_heat().
std::vector<double> exponentials_of(const LawColumns& columns) {
    const double last = columns.overclosure.back();
    return converted(columns.overclosure, [=](double x) { return std::pow(100, x / last); });
}

/// CalculiX looks conductances up by the pressure of an exponential law, whichever law the contact has: one of our own,
/// which rises from 1 to 100 and is before the table, makes a table over the overclosure of them.
std::string calculix_heat(const LawInModel& law) {
    if (law.table.columns.heat.empty()) return {};
    const CardRows rows = card_rows(law, heat_of(law), exponentials_of(law.table.columns), ", 293");
    return comment_of_heat(law, rows) + "**           the second number is 100^(overclosure/" +
           law.length(law.table.columns.overclosure.back()) +
           "), by which CalculiX finds a row; every\n"
           "**           step must have NLGEOM, without which it takes the first\n"
           "*GAP CONDUCTANCE\n" +
           rows.text;
}

std::string calculix_friction(const LawInModel& law) {
    if (!law.friction) return {};
    const auto slope = [&](double p) { return law.units.stiffness(tangential_at(law.table.columns, p)); };
    return "** friction  the stick slope, the tangential stiffness, " +
           where_it_holds(law, law.units.of_stiffness(), slope) + "\n*FRICTION\n" + number(*law.friction) + ", " +
           document::rounded(slope(law.at), 6) + "\n";
}

/// A card of Abaqus with conductances against the pressure.
std::string abaqus_rows(const std::string& card, const CardRows& rows) { return card + ", pressure\n" + rows.text; }

std::string abaqus_heat(const LawInModel& law) {
    if (law.table.columns.heat.empty()) return {};
    const CardRows rows = card_rows(law, heat_of(law), pressures_of(law));
    return comment_of_heat(law, rows) + abaqus_rows("*Gap Conductance", rows);
}

std::string abaqus_current(const LawInModel& law) {
    if (law.table.columns.current.empty()) return {};
    const CardRows rows = card_rows(law, current_of(law), pressures_of(law));
    return "** current   " + law.units.of_current() + ", of volts and amperes; " + std::to_string(rows.count) +
           " rows, at most " + document::rounded(100 * rows.error, 3) + " % off between them\n" +
           abaqus_rows("*Gap Electrical Conductance", rows);
}

/// The stiffness of sticking is mu p over the elastic slip.
std::string abaqus_friction(const LawInModel& law) {
    if (!law.friction) return {};
    const auto slip = [&](double p) {
        return *law.friction * p / tangential_at(law.table.columns, p) * law.units.metre;
    };
    return "** friction  the elastic slip, mu p over the tangential stiffness, " +
           where_it_holds(law, law.units.length, slip) +
           "\n*Friction, elastic slip=" + document::rounded(slip(law.at), 6) + "\n" + number(*law.friction) + ",\n";
}

/// A column of a table, by the name of what it holds.
struct NamedColumn {
    std::string name, unit;
    std::vector<double> values, slopes{};  ///< over the overclosure, where rows keep them
};

std::vector<NamedColumn> columns_of(const LawInModel& law) {
    const LawColumns& law_columns = law.table.columns;
    const ModelUnits& units = law.units;
    std::vector<NamedColumn> columns{
        {"overclosure", units.length, converted(law_columns.overclosure, [&](double x) { return x * units.metre; })},
        {"pressure", units.pressure, pressures_of(law),
         converted(law_columns.slope, [&](double K) { return units.stiffness(K); })},
        {"tangential_stiffness", units.of_stiffness(),
         converted(law_columns.tangential, [&](double K) { return units.stiffness(K); })},
        {"thermal_conductance", units.of_heat(), heat_of(law)},
        {"electrical_conductance", units.of_current(), current_of(law)}};
    std::erase_if(columns, [](const NamedColumn& column) { return column.values.empty(); });
    return columns;
}

/// Every column over the overclosure, and those after the pressure over the pressure too.
std::vector<Line> lines_of(const std::vector<NamedColumn>& columns) {
    std::vector<Line> lines;
    for (std::size_t c = 1; c < columns.size(); ++c) {
        lines.push_back(LawColumns::line(columns[0].values, columns[c].values, columns[c].slopes));
        if (c > 1) lines.push_back(LawColumns::line(columns[1].values, columns[c].values));
    }
    return lines;
}

std::string joined(const std::vector<std::string>& words, const std::string& between) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
    return text;
}

/// The comments on \p columns, and their rows with \p between the numbers.
std::string table_of(const LawInModel& law, const std::vector<NamedColumn>& columns, const std::string& comment,
                     const std::string& names, const std::string& between) {
    const std::vector<Line> lines = lines_of(columns);
    const std::vector<std::size_t> chosen = rows_within(lines, fine_tolerance(law.tolerance));
    const ChordErrors error = error_of_rows(lines, chosen);
    std::vector<std::string> units;
    for (const NamedColumn& column : columns) units.push_back(column.name + " [" + column.unit + "]");
    std::string text = comment + "columns   " + joined(units, ", ") + "\n";
    if (law.friction) text += comment + "friction  coefficient " + number(*law.friction) + "\n";
    text += comment + "rows      " + std::to_string(chosen.size() + 1) + ", at most " +
            document::rounded(100 * error.value, 3) + " % off between them in every column" +
            (error.slope > 0 ? ", and " + document::rounded(100 * error.slope, 3) + " % in the slope of the pressure"
                             : "") +
            "\n" + names;
    const auto add = [&](std::size_t row) {
        std::vector<std::string> numbers;
        for (const NamedColumn& column : columns) numbers.push_back(number(column.values[row]));
        text += joined(numbers, between) + "\n";
    };
    add(0);
    for (const std::size_t row : chosen) add(row + 1);
    return text;
}

std::vector<std::string> names_of(const std::vector<NamedColumn>& columns) {
    std::vector<std::string> names;
    for (const NamedColumn& column : columns) names.push_back(column.name);
    return names;
}

}  // namespace

std::string LawInModel::pressure(double pascals) const { return number(pascals * units.pascal); }
std::string LawInModel::length(double metres) const { return number(metres * units.metre); }

std::string comment_of_pressure(const LawInModel& law) {
    const auto [p, slope] = law.table.error;
    const auto within = [](double error, double tolerance) {
        return document::rounded(100 * error, 3) + " % (tolerance " + document::rounded(100 * tolerance, 3) + " %)";
    };
    return "** rows      " + std::to_string(law.table.rows.size()) + "; lines between them, against the law at " +
           std::to_string(law.table.columns.pressure.size() - 1) +
           " pressures of the range, are off\n**           in the pressure by at most " +
           within(p, law.tolerance.value) +
           (slope > 0 ? "\n**           in the slope by at most " + within(slope, law.tolerance.slope) : "") + "\n";
}

std::string calculix_cards(const LawInModel& law) {
    std::string exponential;
    const std::string heat = calculix_heat(law);
    if (!heat.empty())
        exponential = "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=EXPONENTIAL\n" +
                      law.length(law.table.columns.overclosure.back()) + ", 1\n";
    return "*SURFACE INTERACTION, NAME=FSTIFF\n" + exponential + "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=TABULAR\n" +
           pressure_rows(law) + heat + calculix_friction(law);
}

std::string abaqus_cards(const LawInModel& law) {
    return "*Surface Interaction, name=FSTIFF\n1.,\n*Surface Behavior, pressure-overclosure=TABULAR\n" +
           pressure_rows(law) + abaqus_heat(law) + abaqus_current(law) + abaqus_friction(law);
}

std::string moose_columns(const LawInModel& law) {
    const auto columns = columns_of(law);
    return table_of(law, columns, "# ", joined(names_of(columns), ",") + "\n", ",");
}

std::string comsol_columns(const LawInModel& law) {
    const auto columns = columns_of(law);
    return table_of(law, columns, "% ", "% " + joined(names_of(columns), " ") + "\n", " ");
}

}  // namespace fstiff::actions
