// SPDX-License-Identifier: BSD-3-Clause
#include "actions/curve_titles.hpp"

#include "io/number.hpp"

#include <fstiff/core/error.hpp>
#include <fstiff/io/units.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace fstiff::actions {
namespace {

namespace text = io::detail;

/// A title in parts: "|r|", "%" and 5 MHz of "|R| at 5 MHz [%]".
struct Parts {
    std::string name, unit;
    std::optional<double> frequency, pressure;
};

constexpr std::array unit_dimensions{io::Dimension::pressure, io::Dimension::stiffness_per_area,
                                     io::Dimension::frequency, io::Dimension::angle};

bool is_percent(std::string_view unit) { return unit == "%" || unit == "percent" || unit == "Prozent"; }
bool is_decibel(std::string_view unit) { return unit == "dB" || unit == "db"; }
bool is_loss(std::string_view unit) {
    return unit == "-dB" || unit ==
                                "\xE2\x88\x92"
                                "dB";
}
/// A unit that states that there is none.
bool is_plain(std::string_view unit) { return unit.empty() || unit == "-" || unit == "1" || unit == "\xE2\x80\x93"; }

bool is_any_unit(std::string_view unit) {
    return is_percent(unit) || is_decibel(unit) ||
           std::any_of(unit_dimensions.begin(), unit_dimensions.end(),
                       [&](io::Dimension dimension) { return io::is_unit(unit, dimension); });
}

/// Lower case, blanks in place of underscores, one each, and no colon or full stop at the end.
std::string plain_name(std::string_view title) {
    std::string name;
    for (const char c : text::lower_case(title)) {
        const bool blank = c == '_' || c == ' ' || c == '\t';
        if (blank && (name.empty() || name.back() == ' ')) continue;
        name += blank ? ' ' : c;
    }
    while (!name.empty() && std::string_view(" .:").find(name.back()) != std::string_view::npos) name.pop_back();
    return name;
}

/// Takes the number with a unit of frequency or pressure out of \p title, as in "R (5 MHz)" and "|R| @ 20 MPa".
void take_quantity(std::string& title, Parts& parts) {
    for (std::size_t i = 1; i < title.size(); ++i) {
        const bool begins = text::is_digit(title[i]) && std::string_view(" ([@=_,/").find(title[i - 1]) < 8;
        if (!begins) continue;
        const auto number = text::leading_number(std::string_view(title).substr(i));
        if (number.status != text::NumberStatus::ok) continue;
        std::size_t begin = i + number.length;
        while (begin < title.size() && (title[begin] == ' ' || title[begin] == '_')) ++begin;
        std::size_t end = std::min(title.find_first_of(" )],_", begin), title.size());
        const std::string_view unit = std::string_view(title).substr(begin, end - begin);
        std::optional<double>* to = io::is_unit(unit, io::Dimension::frequency)  ? &parts.frequency
                                    : io::is_unit(unit, io::Dimension::pressure) ? &parts.pressure
                                                                                 : nullptr;
        if (!to) continue;
        *to = number.value *
              io::unit_factor(unit, to == &parts.frequency ? io::Dimension::frequency : io::Dimension::pressure);
        if (end < title.size() && title[end] != ' ' && title[end] != '_') ++end;
        std::string before = plain_name(title.substr(0, i));
        for (const std::string_view word : {"(", "[", "@", "=", ",", "/", "f", "p", " at", " bei", " for"})
            while (before.size() > word.size() && before.ends_with(word) &&
                   (word.size() > 1 || std::string_view("fp").find(word) > 1 ||
                    std::string_view(" (@,").find(before[before.size() - 2]) < 4))
                before = plain_name(before.substr(0, before.size() - word.size()));
        title = before + title.substr(end);
        return;
    }
}

Parts parts_of(std::string_view cell) {
    Parts parts;
    std::string title(text::trimmed(cell));
    take_quantity(title, parts);
    for (const auto& [open, close] : {std::pair{'[', ']'}, {'(', ')'}}) {
        const std::size_t begin = title.find(open), end = title.rfind(close);
        if (begin == 0 || begin == title.npos || end == title.npos || end < begin) continue;
        parts.name = plain_name(title.substr(0, begin));
        parts.unit = text::trimmed(std::string_view(title).substr(begin + 1, end - begin - 1));
        return parts;
    }
    for (std::size_t i = 1; i < title.size(); ++i) {
        if (title[i] != '_' && title[i] != '/' && title[i] != ' ') continue;
        std::string unit(text::trimmed(std::string_view(title).substr(i + 1)));
        if (const std::size_t per = unit.find("_per_"); per != std::string::npos) unit.erase(per, 4), unit[per] = '/';
        if (!is_any_unit(unit)) continue;
        parts.name = plain_name(title.substr(0, i)), parts.unit = unit;
        return parts;
    }
    parts.name = plain_name(title);
    return parts;
}

/// Names of a column, with commas between them.
struct Meaning {
    CurveColumn column;
    std::optional<io::Dimension> dimension;  ///< none: a plain number
    CellScale scale;
    std::string_view names;
};

constexpr Meaning meanings[] = {
    {CurveColumn::pressure, io::Dimension::pressure, CellScale::factor,
     "pressure,p,stress,load,sigma,sigma n,\xCF\x83,\xCF\x83 n,\xCF\x83n,druck,kontaktdruck,anpressdruck,normaldruck,"
     "pressung,normalspannung,fl\xC3\xA4"
     "chenpressung,fl\xE4"
     "chenpressung,flaechenpressung,anpressung,pression,pression de contact,contrainte,contrainte normale,"
     "presi\xC3\xB3n,presion,pressione"},
    {CurveColumn::frequency, io::Dimension::frequency, CellScale::factor,
     "frequency,freq,f,f0,frequenz,pr\xC3\xBC"
     "ffrequenz,pr\xFC"
     "ffrequenz,prueffrequenz,mittenfrequenz,fr\xC3\xA9quence,fr\xE9quence,frequence,frecuencia,frequenza"},
    {CurveColumn::stiffness, io::Dimension::stiffness_per_area, CellScale::factor,
     "stiffness,k,k/a0,steifigkeit,raideur,rigidezza,rigidez"},
    {CurveColumn::reflection,
     {},
     CellScale::factor,
     "reflection,r,|r|,r12,|r12|,abs(r),reflection coefficient,reflection coefficient r,reflection coefficient |r|,"
     "reflection coeff,refl coeff,reflection factor,reflection amplitude,reflexion,reflexionskoeffizient,"
     "reflexionsfaktor,r\xC3\xA9"
     "flexion,coefficient de r\xC3\xA9"
     "flexion,coefficient de r\xE9"
     "flexion,coefficient de reflexion,coefficiente di riflessione,riflessione,coeficiente de reflexi\xC3\xB3n,"
     "coeficiente de reflexion"},
    {CurveColumn::reflection,
     {},
     CellScale::loss,
     "reflection loss,return loss,reflexionsd\xC3\xA4mpfung,reflexionsdaempfung"},
    {CurveColumn::reflection,
     {},
     CellScale::energy,
     "r^2,|r|^2,r\xC2\xB2,|r|\xC2\xB2,energy reflection coefficient,energy reflection,intensity reflection "
     "coefficient"},
    {CurveColumn::phase, io::Dimension::angle, CellScale::factor,
     "phase,phase angle,phase of r,phase r,phase(r),arg(r),arg r,phi,\xCF\x86,\xCF\x95,phasenwinkel,phasenlage,"
     "reflection phase"},
    {CurveColumn::error, io::Dimension::stiffness_per_area, CellScale::factor, "stiffness error,k error,error of k"},
    {CurveColumn::error, {}, CellScale::factor, "reflection error,r error,|r| error,error of r,error of |r|"},
    // takes its unit from its title, or none
    {CurveColumn::error, io::Dimension::stiffness_per_area, CellScale::factor,
     "error,standard error,uncertainty,std,stdev,sd,standard deviation,fehler,unsicherheit,standardabweichung,"
     "incertitude"}};
constexpr const Meaning* plain_error = std::end(meanings) - 1;

/// Some programs print energies under these names, and others amplitudes.
constexpr std::string_view amplitudes_or_energies =
    "reflexionsgrad,schallreflexionsgrad,reflectance,reflectivity,r\xC3\xA9"
    "flectance,reflectance r";

bool has_name(std::string_view names, std::string_view name) {
    while (!names.empty()) {
        const std::size_t end = std::min(names.find(','), names.size());
        if (names.substr(0, end) == name) return true;
        names.remove_prefix(std::min(end + 1, names.size()));
    }
    return false;
}

/// \p name without words that do not change its meaning.
std::string_view without_qualifiers(std::string_view name) {
    for (bool again = true; again;) {
        again = false;
        for (const std::string_view word :
             {"nominal ", "contact ", "mean ", "average ", "normal ", "applied ", "interface ", "interfacial ",
              "apparent ", "measured ", "mittlerer ", "nomineller ", "center ", "centre ", "test "})
            if (name.starts_with(word) && name.size() > word.size()) name.remove_prefix(word.size()), again = true;
    }
    return name;
}

const Meaning* meaning_of(std::string_view name) {
    for (const std::string_view word : {name, without_qualifiers(name)})
        for (const Meaning& meaning : meanings)
            if (has_name(meaning.names, word)) return &meaning;
    return nullptr;
}

/// The scale and factor of a number without a dimension in \p unit.
void take_share(CurveTitle& title, CellScale scale) {
    const std::string& unit = title.unit;
    title.scale = scale;
    if (is_decibel(unit) && scale != CellScale::energy)
        title.scale = scale == CellScale::loss ? scale : CellScale::decibel;
    else if (is_loss(unit) && scale == CellScale::factor)
        title.scale = CellScale::loss;
    else if (scale == CellScale::loss)
        throw domain_error("must be in dB, as a loss is");
    else if (is_percent(unit))
        title.factor = 0.01;
    else if (!is_plain(unit))
        throw domain_error("has the unit \"" + unit + "\"; must be a plain number, or in %" +
                           (scale == CellScale::energy ? "" : " or dB"));
}

}  // namespace

double CurveTitle::value(double number) const {
    switch (scale) {
        case CellScale::decibel: return std::pow(10, number / 20);
        case CellScale::loss: return std::pow(10, -number / 20);
        case CellScale::energy: return std::sqrt(number * factor);
        case CellScale::factor: break;
    }
    return number * factor;
}

bool is_curve_unit(std::string_view unit) { return is_plain(unit) || is_loss(unit) || is_any_unit(unit); }

bool names_curve_column(std::string_view title) {
    const std::string name = parts_of(title).name;
    return meaning_of(name) || has_name(amplitudes_or_energies, name);
}

std::optional<CurveTitle> curve_title(std::string_view cell) {
    const Parts parts = parts_of(cell);
    if (has_name(amplitudes_or_energies, parts.name))
        throw domain_error(
            "may be a ratio of amplitudes or of energies; must be called R for the one or R^2 for the other");
    const Meaning* meaning = meaning_of(parts.name);
    if (!meaning) return std::nullopt;
    CurveTitle title{.column = meaning->column, .name = parts.name, .unit = parts.unit};
    title.frequency = parts.frequency, title.pressure = parts.pressure;
    const bool of_wave = title.column != CurveColumn::pressure && title.column != CurveColumn::frequency;
    if (!of_wave && (title.frequency || title.pressure))
        throw domain_error("has a number in its unit; must be a unit alone");
    const bool no_dimension =
        !meaning->dimension ||
        (meaning == plain_error && (is_plain(title.unit) || is_percent(title.unit) || is_decibel(title.unit)));
    title.is_share = title.column == CurveColumn::error && no_dimension;
    if (no_dimension) {
        take_share(title, meaning->scale);
        return title;
    }
    if (title.unit.empty())
        throw domain_error("has no unit; must be one of " + io::accepted_units(*meaning->dimension));
    if (title.column == CurveColumn::pressure && io::is_unit(title.unit, io::Dimension::force))
        throw domain_error("is a force; must be a pressure, the force over the nominal area");
    title.factor = io::unit_factor(title.unit, *meaning->dimension);
    return title;
}

}  // namespace fstiff::actions
