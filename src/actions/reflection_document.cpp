// SPDX-License-Identifier: BSD-3-Clause
// The document of fstiff ultrasound.
#include "actions/ultrasound.hpp"
#include "document/shown_unit.hpp"

#include <algorithm>
#include <numbers>

namespace fstiff::actions {
namespace {

using document::Cell, document::ShownUnit;

/// The unit of all stiffnesses of \p converted.
ShownUnit unit_of(const CurveOfStiffness& converted) {
    std::vector<double> stiffnesses;
    for (const auto& stiffness : converted.stiffness) stiffnesses.push_back(stiffness ? stiffness->value : 0);
    return document::shown_unit(stiffnesses, "Pa/m");
}

/// A point of the curve a row.
document::Rows point_rows(const CurveOfStiffness& converted) {
    using K = detail::MeasuredStiffness<double>;
    const auto cell = [](const auto& value, Cell::Kind otherwise = Cell::Kind::absent) {
        return [=](const std::optional<K>& k) { return k ? Cell(value(*k)) : Cell(otherwise); };
    };
    const MeasuredCurve& curve = converted.curve;
    const bool errors = !converted.errors.empty();
    const ShownUnit unit = unit_of(converted);
    document::Rows rows;
    if (curve.has_pressures) rows.add({"pressure_Pa", "p [MPa]", 1e-6}, curve.points, &MeasuredPoint::pressure);
    if (curve.has_frequencies)
        rows.add({.key = "frequency_Hz", .shown = "f [MHz]", .factor = 1e-6, .csv = !curve.has_pressures},
                 converted.frequencies);
    rows.add({.key = "reflection", .shown = "|R|", .csv = false}, curve.points, &MeasuredPoint::value);
    if (errors) rows.add({.key = "reflection_error", .shown = "error", .digits = 2, .csv = false}, converted.errors);
    rows.add({"stiffness_Pa_per_m", unit.heading("K/A0"), unit.factor}, converted.stiffness,
             cell([](const K& k) { return k.value; }, Cell::Kind::null));
    if (errors) {
        rows.add({"stiffness_error_Pa_per_m", unit.heading("error"), unit.factor, 2}, converted.stiffness,
                 cell([](const K& k) { return k.error; }));
        rows.add({"", "error of K [%]", 100, 2}, converted.stiffness,
                 cell([](const K& k) { return k.error / k.value; }));
    }
    if (converted.phase) {
        rows.add(
            {.key = "phase_rad", .shown = "phase [deg]", .factor = 180 / std::numbers::pi, .digits = 4, .csv = false},
            curve.points, [](const MeasuredPoint& point) { return Cell(point.phase); });
        rows.add({.key = "stiffness_of_phase_Pa_per_m", .shown = "K by phase", .factor = unit.factor, .csv = false},
                 converted.phase->stiffness, [](const std::optional<double>& K) { return Cell(K); });
    }
    rows.add({.key = "slope_Pa_per_m", .csv = false}, converted.stiffness, cell([](const K& k) { return k.slope; }));
    return rows;
}

/// A load a row; \p of_file: those with a K, for a program that reads K(p).
document::Rows load_rows(const CurveOfStiffness& converted, bool of_file) {
    std::vector<LoadOfCurve> loads = converted.loads;
    if (of_file) std::erase_if(loads, [](const LoadOfCurve& load) { return load.points == 0; });
    const auto cell = [](auto member) {
        return [=](const LoadOfCurve& load) { return load.points > 0 ? Cell(load.K.*member) : Cell(Cell::Kind::null); };
    };
    const ShownUnit unit = unit_of(converted);
    const bool errors = std::all_of(loads.begin(), loads.end(),
                                    [](const LoadOfCurve& load) { return load.points == 0 || load.K.error > 0; });
    document::Rows rows;
    if (converted.curve.has_pressures) rows.add({"pressure_Pa", "p [MPa]", 1e-6}, loads, &LoadOfCurve::pressure);
    rows.add({.key = "frequencies", .shown = "frequencies", .csv = false}, loads, &LoadOfCurve::points);
    rows.add({"stiffness_Pa_per_m", unit.heading("K/A0"), unit.factor}, loads,
             cell(&detail::CommonStiffness<double>::value));
    if (errors || !of_file)
        rows.add({"stiffness_error_Pa_per_m", unit.heading("error"), unit.factor, 2}, loads,
                 cell(&detail::CommonStiffness<double>::error));
    rows.add({.key = "scatter", .shown = "scatter [%]", .factor = 100, .digits = 2, .csv = false}, loads,
             cell(&detail::CommonStiffness<double>::scatter));
    return rows;
}

/// Whether K depends on the frequency.
void add_trend(document::Document& document, const CurveOfStiffness& converted) {
    constexpr std::string_view label = "check";
    const auto& trend = converted.trend;
    if (!trend) {
        document.line(label, "whether K depends on the frequency needs two frequencies with errors, or three");
        return;
    }
    const double to_hertz = 0.5 / std::numbers::pi;
    document.facts(
        label,
        {{"exponent", trend->exponent, "K ~ f^b with b = ", 1, " ± ", 2},
         {"standard_error", trend->error, "", 1, " from ", 2},
         {"low_Hz", trend->low * to_hertz, "", 1e-6, " to ", 4},
         {"high_Hz", trend->high * to_hertz, "", 1e-6,
          trend->depends() ? " MHz: K depends on the frequency" : " MHz: K does not depend on the frequency", 4}},
        "frequency_check");
    document.values([depends = trend->depends()](document::Json& to) { to["frequency_check"]["depends"] = depends; });
}

void add_phase(document::Document& document, const PhaseCheck& phase) {
    document.facts("phase of R",
                   {{"deviation_rad", phase.deviation, "", 180 / std::numbers::pi,
                     "\u00B0 rms off that of a spring with the K of |R|" +
                         std::string(phase.of_stress ? ", read as that of the stress" : ""),
                     2},
                    {"points", phase.count}},
                   "phase_check");
    document.values([of_stress = phase.of_stress](document::Json& to) { to["phase_check"]["of_stress"] = of_stress; });
}

void add_curve(document::Document& document, const Reflection& reflection) {
    const CurveOfStiffness& converted = *reflection.curve;
    const MeasuredCurve& curve = converted.curve;
    document.title("stiffness from the reflections of " + curve.name + ", interface as a spring, eq. (5.1)");
    document.json["file"] = {{"name", curve.name}, {"sha256", curve.sha256}};
    document.json["decisions"] = curve.decisions;
    document.json["equations"] = {"(5.1)"};
    const auto [least, most] = std::minmax_element(converted.frequencies.begin(), converted.frequencies.end());
    std::vector<document::Fact> facts{{"frequency_Hz", reflection.frequency, "", 1e-6, " MHz, impedances ", 6}};
    if (reflection.frequency == 0)
        facts = {{"lowest_frequency_Hz", *least, "", 1e-6, " to ", 6},
                 {"highest_frequency_Hz", *most, "", 1e-6, " MHz, impedances ", 6}};
    facts.insert(facts.end(), {{"impedance_Rayl", reflection.media.incident, "", 1e-6, " and ", 6},
                               {"impedance2_Rayl", reflection.media.beyond, "", 1e-6, " MRayl, welded joint |R| ", 6},
                               {"welded_reflection", reflection.welded, "", 1, "", 6}});
    document.facts("", facts);
    if (!reflection.materials.empty()) document.line("materials", reflection.materials);
    if (!curve.left_out.empty()) {
        document.line("left out", curve.left_out);
        document.json["left_out"] = curve.left_out;
    }
    if (converted.error) document.json["reflection_error"] = *converted.error;
    document.table(point_rows(converted),
                   {.key = "rows",
                    .as_list = true,
                    .thinned = curve.has_pressures ? std::string_view() : "frequencies",
                    .csv = [k = converted.stiffness](std::size_t i) { return k[i].has_value(); }});
    if (!converted.loads.empty()) {
        document.line();
        document.table(load_rows(converted, false), {.key = "loads", .as_list = true});
        if (curve.has_pressures)
            document.csv_alone([converted] { return load_rows(converted, true); });
        else
            document.csv_alone([converted] { return point_rows(converted); });
        add_trend(document, converted);
    }
    if (converted.phase) add_phase(document, *converted.phase);
}

/// Reflection and transmission of a wave at one stiffness.
void add_one(document::Document& document, const Reflection& reflection) {
    const Reflected& reflected = reflection.one;
    const ShownUnit unit = document::shown_unit(reflected.stiffness, "Pa/m");
    const std::string K = document::rounded(reflected.stiffness, 6),
                      error = reflected.stiffness_error ? " +- " + unit(*reflected.stiffness_error, 2) : "";
    document.line("interface as a spring, eq. (5.1)");
    document.json["equations"] = {"(5.1)"};
    document.facts("frequency", {{"frequency_Hz", reflection.frequency, "", 1e-6, " MHz", 6}});
    document.facts("impedances", {{"impedance_Rayl", reflection.media.incident, "", 1e-6, " and ", 6},
                                  {"impedance2_Rayl", reflection.media.beyond, "", 1e-6, " MRayl", 6}});
    if (!reflection.materials.empty()) document.line("materials", reflection.materials);
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

document::Document document_of(const Reflection& reflection) {
    document::Document document("ultrasound", 19);
    document.warnings = reflection.warnings;
    document.doubtful = reflection.doubtful;
    document.json["given"] = reflection.one.from_stiffness ? "stiffness" : "reflection";
    reflection.curve ? add_curve(document, reflection) : add_one(document, reflection);
    if (const double film = reflection.film_stiffness; film > 0) {
        const ShownUnit unit = document::shown_unit(film, "Pa/m");
        document.facts("fluid film", {{"film_stiffness_Pa_per_m", film, "in parallel with K, of ", unit.factor,
                                       " " + std::string(unit.name), 6}});
    }
    return document;
}

document::Document document_of(const ReflectionRequest& request, std::optional<MeasuredCurve> curve) {
    return document_of(reflection_of(request, std::move(curve)));
}

}  // namespace fstiff::actions
