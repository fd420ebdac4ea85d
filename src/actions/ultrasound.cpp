// SPDX-License-Identifier: BSD-3-Clause
#include "actions/ultrasound.hpp"

#include "document/file.hpp"
#include "document/shown_unit.hpp"
#include "io/number.hpp"

#include <fstiff/wave/uncertain_reflection.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <filesystem>
#include <utility>

namespace fstiff::actions {
namespace {

double impedance_of(const BodyRequest& body, const ReflectionRequest& request, const std::string& suffix) {
    const auto name = [&](std::string_view key) { return surface::option_name(request.prefix, key) + suffix; };
    if (!body.impedance.empty() && (!body.density.empty() || !body.velocity.empty()))
        throw document::option_error(name("impedance") + " is given with " + name("density") + " or " +
                                     name("velocity") + "; give the impedance or the other two");
    if (!body.impedance.empty()) return body.impedance.positive(io::Dimension::impedance, name("impedance"));
    if (body.density.empty() || body.velocity.empty())
        throw document::option_error("the impedance is not known; give " + name("impedance") + ", or " +
                                     name("density") + " and " + name("velocity"));
    return acoustic_impedance(body.density.positive(io::Dimension::density, name("density")),
                              body.velocity.positive(io::Dimension::velocity, name("velocity")));
}

/// The number that \p given is; none: the name of a file. "nan" and "inf" are numbers, so that they are refused as
/// such.
std::optional<double> as_number(const request::Amount& given) {
    if (!given.numbers().empty()) return given.numbers().front();
    const std::string text = given.text();
    const std::string word = io::detail::lower_case(text);
    if (word == "nan" || word == "inf" || word == "-inf")
        throw domain_error("reflection = " + text + ": must be greater than 0 and less than 1");
    const auto number = io::detail::leading_number(text);
    if (number.length != text.size() || number.status != io::detail::NumberStatus::ok) return std::nullopt;
    return number.value;
}

/// Counts the rows of a curve that have a fault, and keeps the first.
struct Faults {
    std::size_t count = 0, first_line = 0;
    void add(std::size_t line) {
        if (count++ == 0) first_line = line;
    }
    [[nodiscard]] std::string in(const MeasuredCurve& curve) const {
        return " in " + std::to_string(count) + " of " + std::to_string(curve.points.size()) +
               " rows, the first at line " + std::to_string(first_line);
    }
};

/// Whether a stiffness reflects \p R.
bool is_reached(double R, double welded, double film_alone) { return R > welded && R < film_alone; }

/// On an R within two of its errors of where K has no value, \p where.
std::string near_the_end(const std::string& most, const std::string& where) {
    return "R is within two errors of " + most + " or of the welded joint" + where +
           ": the first-order error of K is unreliable there";
}

std::string most_of(double film_alone) {
    return document::rounded(film_alone) + (film_alone < 1 ? ", that of the film alone" : "");
}

void convert(const ReflectionRequest& request, MeasuredCurve measured, Reflection& reflection) {
    if (!measured.is_reflection)
        throw domain_error(measured.name + ": holds stiffnesses; must hold a column reflection to compute them from");
    CurveOfStiffness& converted = reflection.curve.emplace(CurveOfStiffness{.curve = std::move(measured)});
    const MeasuredCurve& curve = converted.curve;
    if (!curve.has_errors) converted.error = request.reflection_error;
    const double omega = detail::angular_frequency(reflection.frequency);
    Faults doubtful;
    for (const MeasuredPoint& point : curve.points) {
        const double error = curve.has_errors ? point.error : request.reflection_error.value_or(0);
        if (curve.has_errors || request.reflection_error) converted.errors.push_back(error);
        if (!is_reached(point.value, reflection.welded, reflection.film_alone)) {  // noise, of light or heavy loads
            converted.stiffness.emplace_back();
            continue;
        }
        converted.stiffness.emplace_back(
            detail::located(Place{.file = curve.name, .line = point.line, .before_line = ":"},
                            [&] { return detail::measured_stiffness(point.value, error, reflection.media, omega); }));
        converted.stiffness.back()->value -= reflection.film_stiffness;
        if (!converted.stiffness.back()->bounded || 2 * error >= reflection.film_alone - point.value)
            doubtful.add(point.line);
    }
    const std::string most = most_of(reflection.film_alone),
                      unreached = beyond_reach(curve, reflection.welded, reflection.film_alone);
    reflection.warnings = curve.warnings;
    if (curve.has_errors && request.reflection_error)
        reflection.warnings.push_back("the errors are those of " + curve.name + ", not the one that is given");
    if (std::none_of(converted.stiffness.begin(), converted.stiffness.end(),
                     [](const auto& K) { return K.has_value(); }))
        throw domain_error(curve.name + ":" + std::to_string(curve.points.front().line) +
                           ": reflection = " + document::shortest(curve.points.front().value) +
                           ": must be greater than " + document::shortest(reflection.welded) +
                           ", that of the welded joint, and less than " + most + "; no row is");
    reflection.doubtful = !unreached.empty();
    if (reflection.doubtful) reflection.warnings.push_back(unreached + ": no stiffness there");
    if (doubtful.count > 0) reflection.warnings.push_back(near_the_end(most, doubtful.in(curve)));
}

/// R of the stiffness, or K of the one reflection that is \p given, and what else follows.
Reflected at_one(const ReflectionRequest& request, const Reflection& experiment, std::optional<double> given) {
    const Impedances<double>& media = experiment.media;
    const double omega = detail::angular_frequency(experiment.frequency), film = experiment.film_stiffness;
    detail::require(!given || film == 0 || *given < experiment.film_alone, "reflection", given.value_or(0),
                    "less than " + document::rounded(experiment.film_alone) + ", that of the film alone");
    Reflected reflected{.from_stiffness = !given};
    if (given && request.reflection_error) {
        reflected.reflection_error = request.reflection_error;
        reflected.stiffness_error = detail::measured_stiffness(*given, *request.reflection_error, media, omega).error;
    }
    reflected.stiffness = given ? stiffness_from_reflection(*given, media, omega) - film
                                : request.stiffness.value(io::Dimension::stiffness_per_area,
                                                          surface::option_name(request.prefix, "stiffness"));
    const double seen = reflected.stiffness + film;
    reflected.reflection = given ? *given : reflection(seen, media, omega);
    reflected.transmission = std::abs(detail::complex_transmission(seen, media, omega));
    reflected.phase = std::arg(detail::complex_reflection(seen, media, omega));
    reflected.transmitted_energy = detail::transmitted_energy(seen, media, omega);
    return reflected;
}

/// The curve in \p file.
MeasuredCurve curve_of(const std::string& file, const std::string& name) {
    std::error_code ignored;
    if (file != "-" && !std::filesystem::exists(document::path_of(file), ignored))
        throw domain_error(name + " = \"" + file + "\": must be a number or an existing file of measured reflections");
    return read_measured_curve(file);
}

/// A row of the curve a row.
document::Rows point_rows(const CurveOfStiffness& converted) {
    using K = detail::MeasuredStiffness<double>;
    const auto cell = [](const auto& value, document::Cell::Kind otherwise = document::Cell::Kind::absent) {
        return [=](const std::optional<K>& k) { return k ? document::Cell(value(*k)) : document::Cell(otherwise); };
    };
    const bool errors = !converted.errors.empty();
    std::vector<double> stiffnesses;
    for (const auto& stiffness : converted.stiffness) stiffnesses.push_back(stiffness ? stiffness->value : 0);
    const document::ShownUnit unit = document::shown_unit(stiffnesses, "Pa/m");
    document::Rows rows;
    rows.add({"pressure_Pa", "p [MPa]", 1e-6}, converted.curve.points, &MeasuredPoint::pressure);
    rows.add({.key = "reflection", .shown = "|R|", .csv = false}, converted.curve.points, &MeasuredPoint::value);
    if (errors) rows.add({.key = "reflection_error", .shown = "error", .digits = 2, .csv = false}, converted.errors);
    rows.add({"stiffness_Pa_per_m", unit.heading("K/A0"), unit.factor}, converted.stiffness,
             cell([](const K& k) { return k.value; }, document::Cell::Kind::null));
    if (errors) {
        rows.add({"stiffness_error_Pa_per_m", unit.heading("error"), unit.factor, 2}, converted.stiffness,
                 cell([](const K& k) { return k.error; }));
        rows.add({"", "error of K [%]", 100, 2}, converted.stiffness,
                 cell([](const K& k) { return k.error / k.value; }));
    }
    rows.add({.key = "slope_Pa_per_m", .csv = false}, converted.stiffness, cell([](const K& k) { return k.slope; }));
    return rows;
}

void add_curve(document::Document& document, const Reflection& reflection) {
    const CurveOfStiffness& converted = *reflection.curve;
    document.title("stiffness from the reflections of " + converted.curve.name + ", interface as a spring, eq. (5.1)");
    document.json["file"] = {{"name", converted.curve.name}, {"sha256", converted.curve.sha256}};
    document.json["decisions"] = converted.curve.decisions;
    document.json["equations"] = {"(5.1)"};
    document.facts("", {{"frequency_Hz", reflection.frequency, "", 1e-6, " MHz, impedances ", 6},
                        {"impedance_Rayl", reflection.media.incident, "", 1e-6, " and ", 6},
                        {"impedance2_Rayl", reflection.media.beyond, "", 1e-6, " MRayl, welded joint |R| ", 6},
                        {"welded_reflection", reflection.welded, "", 1, "", 6}});
    if (converted.error) document.json["reflection_error"] = *converted.error;
    document.table(
        point_rows(converted),
        {.key = "rows", .as_list = true, .csv = [k = converted.stiffness](std::size_t i) { return k[i].has_value(); }});
}

/// Reflection and transmission of a wave at one stiffness.
void add_one(document::Document& document, const Reflection& reflection) {
    const Reflected& reflected = reflection.one;
    const document::ShownUnit unit = document::shown_unit(reflected.stiffness, "Pa/m");
    const std::string K = document::rounded(reflected.stiffness, 6),
                      error = reflected.stiffness_error ? " +- " + unit(*reflected.stiffness_error, 2) : "";
    document.line("interface as a spring, eq. (5.1)");
    document.json["equations"] = {"(5.1)"};
    document.facts("frequency", {{"frequency_Hz", reflection.frequency, "", 1e-6, " MHz", 6}});
    document.facts("impedances", {{"impedance_Rayl", reflection.media.incident, "", 1e-6, " and ", 6},
                                  {"impedance2_Rayl", reflection.media.beyond, "", 1e-6, " MRayl", 6}});
    document.facts("K per nominal area", {{"stiffness_Pa_per_m", reflected.stiffness, "", unit.factor,
                                           " " + std::string(unit.name) + " = " + K + " Pa/m" + error, 6}});
    document.facts("|R|", {{"reflection", reflected.reflection, "", 1,
                            " (welded joint " + document::rounded(reflection.welded, 6) + ")", 6}});
    document.facts("phase of R", {{"reflection_phase_rad", reflected.phase, "", 1, " rad", 6}});
    document.facts("|T|", {{"transmission", reflected.transmission, "", 1, " of displacement, ", 6},
                           {"transmitted_energy", reflected.transmitted_energy, "", 1, " of the energy", 6},
                           {"welded_reflection", reflection.welded}});
    if (reflected.stiffness_error)
        document.facts("", {{"reflection_error", *reflected.reflection_error},
                            {"stiffness_error_Pa_per_m", *reflected.stiffness_error}});
}

}  // namespace

std::string beyond_reach(const MeasuredCurve& curve, double welded, double film_alone) {
    Faults beyond;
    for (const MeasuredPoint& point : curve.points)
        if (!is_reached(point.value, welded, film_alone)) beyond.add(point.line);
    return beyond.count == 0 ? ""
                             : "R is not between that of the welded joint, " + document::rounded(welded) + ", and " +
                                   most_of(film_alone) + beyond.in(curve);
}

Reflection reflection_of(const ReflectionRequest& request, std::optional<MeasuredCurve> curve) {
    const auto name = [&](std::string_view key) { return surface::option_name(request.prefix, key); };
    const bool of_reflection = curve || !request.reflection.empty();
    const std::string error = name("reflection_error");
    if (request.stiffness.empty() != of_reflection)
        throw document::option_error("give one of " + name("stiffness") + " and " + name("reflection") +
                                     "; the other is computed");
    if (request.reflection_error && !of_reflection)
        throw document::option_error(error + " is that of " + name("reflection") + ", which is not there");
    if (request.reflection_error && !(*request.reflection_error >= 0 && *request.reflection_error < 1))
        throw domain_error(error + " = " + document::shortest(*request.reflection_error) +
                           ": must be at least 0 and less than 1");
    Reflection reflection;
    reflection.frequency = request.frequency.positive(io::Dimension::frequency, name("frequency"));
    reflection.media.incident = impedance_of(request.incident, request, "");
    reflection.media.beyond =
        request.beyond.given() ? impedance_of(request.beyond, request, "2") : reflection.media.incident;
    std::optional<double> given;
    if (of_reflection && !curve) {
        given = as_number(request.reflection);
        if (!given) curve = curve_of(request.reflection.text(), name("reflection"));
    }
    reflection.welded = detail::welded_reflection(reflection.media);
    if (!request.film_stiffness.empty()) {
        reflection.film_stiffness =
            request.film_stiffness.positive(io::Dimension::stiffness_per_area, name("film_stiffness"));
        reflection.film_alone = fstiff::reflection(reflection.film_stiffness, reflection.media,
                                                   detail::angular_frequency(reflection.frequency));
    }
    if (curve)
        convert(request, *std::move(curve), reflection);
    else
        reflection.one = at_one(request, reflection, given);
    if (given && request.reflection_error && 2 * *request.reflection_error >= reflection.film_alone - *given)
        reflection.warnings.push_back(near_the_end(most_of(reflection.film_alone), ""));
    return reflection;
}

document::Document document_of(const ReflectionRequest& request, std::optional<MeasuredCurve> curve) {
    const Reflection reflection = reflection_of(request, std::move(curve));
    document::Document document("ultrasound", 19);
    document.warnings = reflection.warnings;
    document.doubtful = reflection.doubtful;
    document.json["given"] = reflection.one.from_stiffness ? "stiffness" : "reflection";
    reflection.curve ? add_curve(document, reflection) : add_one(document, reflection);
    if (const double film = reflection.film_stiffness; film > 0) {
        const document::ShownUnit unit = document::shown_unit(film, "Pa/m");
        document.facts("fluid film", {{"film_stiffness_Pa_per_m", film, "in parallel with K, of ", unit.factor,
                                       " " + std::string(unit.name), 6}});
    }
    return document;
}

}  // namespace fstiff::actions
