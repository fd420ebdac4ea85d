// SPDX-License-Identifier: BSD-3-Clause
// The document of fstiff run: the answer first, what it was computed of, and the laws that are named.
#include "actions/run.hpp"
#include "actions/explanation.hpp"

#include <fstiff/answer/concerns.hpp>
#include <fstiff/asperity/tangential_ratio.hpp>
#include <fstiff/core/version.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

namespace fstiff::actions {

namespace run_text {
namespace {

constexpr std::size_t widest = 100;  ///< columns of the summary

std::size_t width_of(const std::string& text) {
    std::size_t most = 0;
    for (std::size_t start = 0; start < text.size();) {
        const std::size_t end = std::min(text.find('\n', start), text.size());
        most = std::max(most, document::shown_width(std::string_view(text).substr(start, end - start)));
        start = end + 1;
    }
    return most;
}

/// \p sentence in lines of at most \p widest.
std::string in_text(const std::string& sentence) {
    std::string text;
    for (const std::string& line : document::wrapped(sentence, widest - 2)) text += "  " + line + "\n";
    return text;
}

/// The answer: K and its band, which K it is, and what the band does not hold.
std::string answer_lines(const Answered& answered) {
    const auto& scene = *answered.scene;
    if (!answered.has_answer()) return "";
    std::string text;
    for (const std::size_t causes : {2u, 1u, 0u})  // as many as the page has room for
        if (causes == 2 || width_of(text) > widest) text = document::table_text(answer_table(answered, causes));
    if (scene.ball)
        text += in_text(
            "a: 16/(3 pi) of the mean radius of the load. Hertz: smooth faces. Approach: of points far "
            "away, from where the mean planes would touch.");
    for (const std::string& sentence : answered.explanation) text += in_text(sentence);
    if (has_approach(answered.answer))
        text += in_text("Approach: how far the faces have closed since p was " +
                        document::with_unit(scene.seating, "Pa") + " (contact.seating).");
    return text + in_text(outside_band(answered));
}

/// The surface that the contact is of, and what was assumed of it; with an answer, what that uses of it.
std::vector<std::string> surface_parts(const Answered& answered) {
    const auto& scene = *answered.scene;
    const SurfaceParameters<double>& s = scene.joint.face.parameters;
    const std::vector<Parameter> unknown = unknown_parameters(scene.joint, scene.best);
    const auto digits = [&](Parameter parameter) {
        return std::count(unknown.begin(), unknown.end(), parameter) > 0 ? 2 : 5;
    };
    const bool answers = scene.best && answered.has_answer();
    std::vector<std::string> parts{
        "sigma " + document::shown_length(s.rms_height.value, answers ? 3 : digits(Parameter::rms_height))};
    if (answers) {
        if (const auto& g = answered.answer.rms_gradient) parts.push_back("rms gradient " + document::rounded(*g, 3));
    } else {
        if (s.find(Parameter::peak_radius))
            parts.push_back("R " + document::shown_length(s.peak_radius.value, digits(Parameter::peak_radius)));
        parts.push_back(
            s.find(Parameter::peak_density)
                ? "D_p " + document::with_unit(s.peak_density.value, "/m^2", digits(Parameter::peak_density))
                : (s.find(Parameter::peak_radius) ? "D_p not known: " : "R and D_p not known: ") + s.why_no_density);
        if (s.max_peak_height.value > 0) parts.push_back("R_p " + document::shown_length(s.max_peak_height.value));
        if (s.fractal_dimension)
            parts.push_back("D " + document::rounded(s.fractal_dimension->value, digits(Parameter::fractal_dimension)));
        if (const auto& g = s.fractal_roughness)
            parts.push_back("G " + document::shown_length(g->value, detail::is_known(*g) ? 5 : 2));
        if (s.r) parts.push_back("r " + document::rounded(s.r->value, digits(Parameter::r)));
        if (s.theta) parts.push_back("theta " + document::rounded(s.theta->value, digits(Parameter::theta)));
    }
    for (const scene::Assumed& assumption : scene.assumed())
        if (!answers || !scene.joint.face.is_open(Unknown::hurst))  // else it is among what was assumed
            parts.push_back(std::string(assumption.symbol) + " " + document::rounded(assumption.value, 3) + " (" +
                            assumption.how + ")");
    if (scene.joint.faces.empty()) parts.emplace_back("the other face smooth");
    return parts;
}

/// The bodies, the nominal area, the waves, what was assumed, and what to measure next.
void add_bodies(const Answered& answered, std::vector<InputLine>& lines) {
    const auto& scene = *answered.scene;
    const auto pressure = [](double x) { return document::with_unit(x, "Pa"); };
    const auto material = [&](const Material<double>& m, const NamedMaterial* name) {
        return (name ? std::string(name->name) + " " : "") + pressure(m.youngs_modulus) + ", nu " +
               document::rounded(m.poisson_ratio);
    };
    const std::string upper = material(scene.joint.upper, scene.upper_name),
                      lower = material(scene.joint.lower, scene.lower_name);
    const bool alike = scene.best && upper == lower;
    std::vector<std::string> parts{alike ? "both bodies " + upper : "upper " + upper + "; lower " + lower};
    if (!scene.best) parts.push_back("effective modulus " + document::with_unit(scene.joint.effective_modulus, "Pa"));
    if (scene.joint.hardness)
        parts.push_back(std::isfinite(*scene.joint.hardness) ? "hardness " + pressure(*scene.joint.hardness)
                                                             : "never yields");
    if (scene.joint.yield_strength) parts.push_back("yield strength " + pressure(*scene.joint.yield_strength));
    const std::string area = scene.ball ? "ball of radius " + document::shown_length(scene.ball->radius)
                             : scene.joint.nominal_area
                                 ? "nominal area " + document::rounded(*scene.joint.nominal_area * 1e6) + " mm²"
                                 : "";
    if (scene.best && !area.empty()) parts.push_back(area);
    lines.push_back({"material", parts});
    parts.clear();
    if (!scene.best && !area.empty()) parts.push_back(area);
    const auto reach = interaction(scene.joint);
    if (!scene.best)
        parts.push_back(
            reach.reading == InteractionReading::none
                ? "no interaction"
                : std::string("interaction ") +
                      (reach.reading == InteractionReading::as_printed ? "as printed" : "by effective separation") +
                      " over " + document::shown_length(reach.length));
    if (const auto index = plasticity_index(scene.joint); index && !scene.best)
        parts.push_back("plasticity index " + document::rounded(*index, 3));
    if (!parts.empty()) lines.push_back({"contact", parts});
    if (scene.joint.ultrasound) {
        const UltrasonicWaves& waves = *scene.joint.ultrasound;
        const auto pair = [](const Impedances<double>& z) {
            return document::rounded(z.incident / 1e6) + " and " + document::rounded(z.beyond / 1e6) + " MRayl";
        };
        parts = {document::rounded(waves.frequency / 1e6) + " MHz", "impedances " + pair(waves.longitudinal)};
        if (waves.shear) parts.push_back("of shear waves " + pair(*waves.shear));
        if (waves.film_stiffness > 0)
            parts.push_back("fluid film " + document::with_unit(waves.film_stiffness, "Pa/m") + " in parallel with K");
        lines.push_back({"waves", parts});
    }
    if (const auto all = assumptions_of(answered); !all.empty()) lines.push_back({"assumed", all});
    if (std::string next = scene.best ? measure_next(answered) : ""; !next.empty())
        lines.push_back({"next", {std::move(next)}});
}

/// The answer and what was computed of what: the lines above the curves.
std::string introduction(const Answered& answered) {
    const auto& scene = *answered.scene;
    std::string text =
        "fstiff " FSTIFF_VERSION_TEXT ": " + document::printable(scene.name + " (" + scene.file + ")") + "\n";
    text += answer_lines(answered);
    for (const InputLine& line : input_lines(answered)) text += in_lines(line);
    return text;
}

/// Meaning of the symbols in the tables, and origin of a band.
std::string explanations(const Answered& answered) {
    const auto& scene = *answered.scene;
    std::string text;
    if (scene.asks("stiffness"))
        text += "K/A0 is the normal stiffness per nominal area (1 MPa/µm = 1e12 Pa/m = 1e12 N/m³)\n";
    if (scene.asks("joint_stiffness")) text += "K is that of the nominal area; 1 kN/µm = 1e9 N/m\n";
    if (scene.asks("tangential_stiffness") || scene.asks("shear_reflection"))
        text += "Kt/A0 is the tangential stiffness, " +
                document::rounded(tangential_ratio(scene.joint.upper, scene.joint.lower)) +
                " K/A0 by Mindlin's ratio\n";
    if (scene.asks("reflection") || scene.asks("shear_reflection"))
        text += "|R| is the reflection of the interface as a spring, eq. (5.1); shear waves see Kt/A0\n";
    if (answered.has_band())
        text += "5 % and 95 %: " + origin_of_band(answered) + "\n";
    else if (scene.needs_stiffness())
        text += "named laws have no band: " + why_no_band(answered) +
                (answered.has_answer() ? "; the answer's is above\n" : "\n");
    return text;
}

std::string label_of(const Answered& answered, const AnswerCurve& curve) {
    const auto& scene = *answered.scene;
    if (answered.is_answer(curve)) return (scene.best ? "" : "answer: ") + laws_of(curve);
    return std::string(name_of(curve.law)) +
           (curve.theta ? ", theta " + document::rounded(*curve.theta, 4) + ", r " + document::rounded(*curve.r, 4)
                        : "");
}

std::string full_table(const Answered& answered) {
    const auto& scene = *answered.scene;
    const Units units = units_of(answered);
    std::string text = introduction(answered);
    for (const AnswerCurve* curve : answered.shown_curves()) {
        const bool is_answer = answered.is_answer(*curve);
        text += "\n" + (is_answer ? label_of(answered, *curve) : title(*curve)) + "\n" +
                point_rows(scene, *curve, is_answer || answered.has_band(), units).text();
    }
    const std::string notes =
        explanations(answered) + (scene.asks("real_area") ? "mean pressure is that on the real area\n" : "");
    return notes.empty() ? text : text + "\n" + notes;
}

/// \p cell of each of \p curves at every point of the summary, below \p what: in several tables where one is wider than
/// the page.
template <class Cell>
std::string curve_tables(const Answered& answered, const std::vector<const AnswerCurve*>& curves, std::string what,
                         const Cell& cell) {
    const auto& scene = *answered.scene;
    std::size_t first =
        std::max<std::size_t>(28, document::shown_width(what));  // columns of all blocks begin at one place
    for (const AnswerCurve* curve : curves) first = std::max(first, document::shown_width(label_of(answered, *curve)));
    const auto padded = [&](std::string label) {
        return label + std::string(first - document::shown_width(label), ' ');
    };
    const std::vector<std::size_t> points = scene.points_of_answer();
    const auto table = [&](std::span<const std::size_t> some) {
        document::TextRows rows{{padded(what)}};
        for (const std::size_t i : some) rows[0].push_back(scene.shown_point(i));
        for (const AnswerCurve* curve : curves) {
            rows.push_back({padded(label_of(answered, *curve))});
            for (const std::size_t i : some) rows.back().push_back(cell(*curve, i));
        }
        return document::table_text(rows);
    };
    std::string text;
    for (std::size_t parts = 1; parts <= points.size(); ++parts) {
        text.clear();
        for (std::size_t part = 0; part < parts; ++part) {
            const std::size_t from = part * points.size() / parts, to = (part + 1) * points.size() / parts;
            text += (part > 0 ? "\n" : "") + table(std::span(points).subspan(from, to - from));
        }
        if (width_of(text) <= widest) break;
    }
    return text;
}

std::vector<const AnswerCurve*> named_curves(const Answered& answered) {
    std::vector<const AnswerCurve*> curves;
    for (const AnswerCurve& curve : answered.curves()) curves.push_back(&curve);
    return curves;
}

/// The quantities of the answer that its own table has, above all others.
constexpr std::array<std::string_view, 3> in_answer{"stiffness", "joint_stiffness", "approach"};
bool is_in_answer(std::string_view word) {
    return std::find(in_answer.begin(), in_answer.end(), word) != in_answer.end();
}

/// \p quantity of every curve, that of the answer first, of one that K gives with its band.
std::string quantity_tables(const Answered& answered, const Units& units, const AnswerQuantity& quantity) {
    using enum AnswerQuantity::WithStiffness;
    const document::Heading heading = heading_of({&quantity}, units);
    const std::vector<const AnswerCurve*> curves =
        is_in_answer(quantity.word) ? named_curves(answered) : answered.shown_curves();
    const bool band =
        quantity.follows_stiffness() &&
        std::any_of(curves.begin(), curves.end(), [](const AnswerCurve* curve) { return curve->has_band; });
    const auto text = [reflection = quantity.with_stiffness == falls && quantity.unit.empty()](double x, int digits) {
        const double rest = std::max(1 - x, 1e-15);  // 1 - |R| has two digits
        return document::rounded(x,
                                 reflection ? 1 + std::max(2, static_cast<int>(std::ceil(-std::log10(rest)))) : digits);
    };
    return curve_tables(answered, curves, heading.shown + (band ? ", 5 % to 95 %" : ""),
                        [&](const AnswerCurve& curve, std::size_t i) -> std::string {
                            const AnswerPoint* point = curve.at(i);
                            const AnswerPoint::Value* value = point ? point->find(quantity.word) : nullptr;
                            if (!value) return "-";
                            const double middle = value->number.value * heading.factor,
                                         low = value->number.low * heading.factor,
                                         high = value->number.high * heading.factor;
                            if (!band || !curve.has_band) return document::rounded(middle);
                            const double nearest = std::min({high - low, 2 * (high - middle), 2 * (middle - low)});
                            const int digits = nearest < 0.2 * middle ? 3 : 2;  // that distinguish all three
                            return text(middle, 3) + " (" + text(low, digits) + "–" + text(high, digits) + ")";
                        });
}

/// The tables of the summary.
std::string blocks(const Answered& answered) {
    const auto& scene = *answered.scene;
    const Units units = units_of(answered);
    std::vector<std::string_view> shown{in_answer.begin(), in_answer.end()};
    for (const AnswerQuantity& quantity : answer_quantities())
        if (is_further(quantity)) shown.push_back(quantity.word);
    if (!scene.needs_stiffness()) shown = {"separation", "approach", "real_area", "contacts"};
    std::string text;
    for (const std::string_view word : shown) {
        if (!scene.asks(word) || (scene.best && is_in_answer(word))) continue;
        text += "\n" + quantity_tables(answered, units, detail::quantity_called(word));
    }
    if (!scene.needs_stiffness() || !answered.has_answer() || scene.best) return text;
    return text + "\n" +
           curve_tables(answered, named_curves(answered), "K over the answer",
                        [&](const AnswerCurve& curve, std::size_t i) {
                            const AnswerPoint *point = curve.at(i), *best = answered.answer.at(i);
                            const double ratio = point && best ? point->stiffness.value / best->stiffness.value
                                                               : std::numeric_limits<double>::quiet_NaN();
                            return std::isfinite(ratio) ? document::rounded(ratio, 3) : "-";
                        });
}

/// The answer, and each law that is named at the points of the summary.
std::string summary(const Answered& answered) {
    const auto& scene = *answered.scene;
    const std::string more = "every point and quantity: --full, --format csv, --format json\n";
    if (scene.best) return introduction(answered) + blocks(answered) + more;
    std::string text = introduction(answered) + blocks(answered) + "\n";
    for (const detail::Law* law : scene.laws)
        text += "  " + std::string(law->name) + " is " + std::string(law->nature) + "\n";
    return text + "\n" + explanations(answered) + more;
}

}  // namespace
}  // namespace run_text

std::string in_lines(const InputLine& line) {
    const std::vector<std::string>& parts = line.parts;
    std::string text = "  " + line.label + std::string(10 - line.label.size(), ' ');
    const std::string below(text.size(), ' ');
    if (parts.size() == 1) {  // a sentence
        const std::vector<std::string> lines = document::wrapped(parts.front(), run_text::widest - below.size());
        for (std::size_t i = 0; i < lines.size(); ++i) text += (i > 0 ? below : "") + lines[i] + "\n";
        return text;
    }
    std::size_t used = below.size();
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const std::size_t size = document::shown_width(parts[i]) + 2;
        if (i > 0 && used + size > run_text::widest) {
            text.back() = '\n';
            text += below;
            used = below.size();
        }
        text += parts[i] + (i + 1 < parts.size() ? ", " : "\n");
        used += size;
    }
    return text;
}

std::vector<InputLine> input_lines(const Answered& answered) {
    const auto& scene = *answered.scene;
    std::vector<InputLine> lines{{"surface", run_text::surface_parts(answered)}};
    if (!scene.joint.faces.empty()) {
        lines.push_back({"", {"both rough faces together"}});
        if (scene.joint.face.map)
            lines.back().parts.push_back("laws of a map are means over " + std::to_string(scene.shifts) +
                                         " random shifts");
    }
    for (const auto& [name, face, file] : scene.measured_files()) {
        std::vector<std::string> parts;
        const surface::MeasuredSurface& measured = *file;
        for (const detail::ParameterRow& row : detail::surface_parameter_table)
            if (const auto* known = face->parameters.find(row.parameter);
                known && (!scene.best || row.parameter == Parameter::rms_height))
                parts.push_back(std::string(row.symbol) + " " + document::shown_percent(known->error / known->value));
        parts.front() = "errors of " + parts.front();
        parts.insert(parts.begin(), document::printable(measured.file) + " (" + measured.kind + ")");
        const auto& cut_offs = measured.found.cut_offs;
        if (cut_offs.any() && !scene.best) parts.push_back(surface::sentence_of(cut_offs));
        if (scene.best && cut_offs.lambda_s && !face->filtered)
            parts.push_back("lambda_s " + document::shown_length(*cut_offs.lambda_s, 3));
        if (scene.best && cut_offs.lambda_c)
            parts.push_back("lambda_c " + document::shown_length(*cut_offs.lambda_c, 3));
        lines.push_back({scene.joint.faces.empty() ? "measured" : std::string(name), std::move(parts)});
    }
    run_text::add_bodies(answered, lines);
    return lines;
}

document::Document document_of(const Answered& computed, bool full) {
    const auto answered = std::make_shared<const Answered>(computed);
    document::Document document("run");
    document.text([=] { return full ? run_text::full_table(*answered) : run_text::summary(*answered); });
    document.values([=](document::Json& to) { to = run_document(*answered); });
    const auto add = [&](const AnswerCurve& curve, int answers) {
        document.csv([=, &curve] {
            document::Rows rows = point_rows(*answered->scene, curve, answered->has_answer() || answered->has_band());
            rows.repeat({"answer"}, answers, rows.size());
            return rows;
        });
    };
    if (answered->scene->ball)
        document.csv([=] { return ball_rows(*answered); });
    else if (answered->has_answer())
        add(answered->answer, 1);
    for (const AnswerCurve& curve : answered->answer.laws) add(curve, 0);
    document.warnings = answered->warnings;
    document.doubtful = answered->doubtful;
    return document;
}

}  // namespace fstiff::actions
