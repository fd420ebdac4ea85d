// SPDX-License-Identifier: BSD-3-Clause
// The document of fstiff run: the answer first, what it was computed of, and the laws that are named.
#include "actions/run.hpp"
#include "actions/explanation.hpp"

#include <fstiff/answer/concerns.hpp>
#include <fstiff/answer/curves.hpp>
#include <fstiff/core/version.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace fstiff::actions {

using scene::CurveQuantity, scene::Scene;

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
std::string answered(const Scene& scene, const Results& results) {
    if (!results.answer) return "";
    std::string text;
    for (const std::size_t causes : {2u, 1u, 0u})  // as many as the page has room for
        if (causes == 2 || width_of(text) > widest) text = document::table_text(answer_table(scene, results, causes));
    if (scene.ball)
        text += in_text(
            "a: 16/(3 pi) of the mean radius of the load. Hertz: smooth faces. Approach: of points far "
            "away, from where the mean planes would touch.");
    for (const std::string& sentence : results.explanation) text += in_text(sentence);
    if (scene.asks(CurveQuantity::approach) && !results.answer->curve.separation_at_seating.empty())
        text += in_text("Approach: how far the faces have closed since p was " +
                        document::with_unit(scene.seating, "Pa") + " (contact.seating).");
    return text + in_text(outside_band(scene, results));
}

/// The surface that the contact is of, and what was assumed of it; with an answer, what that uses of it.
std::vector<std::string> surface_parts(const Scene& scene, const Results& results) {
    const SurfaceParameters<double>& s = scene.face.parameters;
    const std::vector<Parameter> unknown = unknown_parameters(scene, scene.best);
    const auto digits = [&](Parameter parameter) {
        return std::count(unknown.begin(), unknown.end(), parameter) > 0 ? 2 : 5;
    };
    const bool answers = scene.best && results.answer;
    std::vector<std::string> parts{
        "sigma " + document::shown_length(s.rms_height.value, answers ? 3 : digits(Parameter::rms_height))};
    if (answers) {
        if (const auto& g = results.answer->curve.rms_gradient)
            parts.push_back("rms gradient " + document::rounded(*g, 3));
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
    for (const scene::Assumed& assumption : assumed(scene))
        if (!answers || !scene.face.is_open(Unknown::hurst))  // else it is among what was assumed
            parts.push_back(std::string(assumption.symbol) + " " + document::rounded(assumption.value, 3) + " (" +
                            assumption.how + ")");
    if (scene.faces.empty()) parts.emplace_back("the other face smooth");
    return parts;
}

/// The bodies, the nominal area, the waves, what was assumed, and what to measure next.
void add_bodies(const Scene& scene, const Results& results, std::vector<InputLine>& lines) {
    const auto pressure = [](double x) { return document::with_unit(x, "Pa"); };
    const auto material = [&](const Material<double>& m, const NamedMaterial* name) {
        return (name ? std::string(name->name) + " " : "") + pressure(m.youngs_modulus) + ", nu " +
               document::rounded(m.poisson_ratio);
    };
    const std::string upper = material(scene.upper, scene.upper_name), lower = material(scene.lower, scene.lower_name);
    const bool alike = scene.best && upper == lower;
    std::vector<std::string> parts{alike ? "both bodies " + upper : "upper " + upper + "; lower " + lower};
    if (!scene.best) parts.push_back("effective modulus " + document::with_unit(scene.effective_modulus, "Pa"));
    if (scene.hardness)
        parts.push_back(std::isfinite(*scene.hardness) ? "hardness " + pressure(*scene.hardness) : "never yields");
    if (scene.yield_strength) parts.push_back("yield strength " + pressure(*scene.yield_strength));
    const std::string area = scene.ball ? "ball of radius " + document::shown_length(scene.ball->radius)
                             : scene.nominal_area
                                 ? "nominal area " + document::rounded(*scene.nominal_area * 1e6) + " mm²"
                                 : "";
    if (scene.best && !area.empty()) parts.push_back(area);
    lines.push_back({"material", parts});
    parts.clear();
    if (!scene.best && !area.empty()) parts.push_back(area);
    const auto reach = interaction(scene);
    if (!scene.best)
        parts.push_back(
            reach.reading == InteractionReading::none
                ? "no interaction"
                : std::string("interaction ") +
                      (reach.reading == InteractionReading::as_printed ? "as printed" : "by effective separation") +
                      " over " + document::shown_length(reach.length));
    if (results.plasticity_index && !scene.best)
        parts.push_back("plasticity index " + document::rounded(*results.plasticity_index, 3));
    if (!parts.empty()) lines.push_back({"contact", parts});
    if (scene.ultrasound) {
        const Waves& waves = *scene.ultrasound;
        const auto pair = [](const Impedances<double>& z) {
            return document::rounded(z.incident / 1e6) + " and " + document::rounded(z.beyond / 1e6) + " MRayl";
        };
        parts = {document::rounded(waves.frequency / 1e6) + " MHz", "impedances " + pair(waves.longitudinal)};
        if (waves.shear) parts.push_back("of shear waves " + pair(*waves.shear));
        if (waves.film_stiffness > 0)
            parts.push_back("fluid film " + document::with_unit(waves.film_stiffness, "Pa/m") + " in parallel with K");
        lines.push_back({"waves", parts});
    }
    if (const auto all = assumptions_of(scene, results); !all.empty()) lines.push_back({"assumed", all});
    if (std::string next = scene.best ? measure_next(scene, results) : ""; !next.empty())
        lines.push_back({"next", {std::move(next)}});
}

/// The answer and what was computed of what: the lines above the curves.
std::string introduction(const Scene& scene, const Results& results) {
    std::string text =
        "fstiff " FSTIFF_VERSION_TEXT ": " + document::printable(scene.name + " (" + scene.file + ")") + "\n";
    text += answered(scene, results);
    for (const InputLine& line : input_lines(scene, results)) text += in_lines(line);
    return text;
}

/// Meaning of the symbols in the tables, and origin of a band.
std::string explanations(const Scene& scene, const Results& results) {
    std::string text;
    if (scene.asks(CurveQuantity::stiffness))
        text += "K/A0 is the normal stiffness per nominal area (1 MPa/µm = 1e12 Pa/m = 1e12 N/m³)\n";
    if (scene.asks(CurveQuantity::joint_stiffness)) text += "K is that of the nominal area; 1 kN/µm = 1e9 N/m\n";
    if (scene.asks(CurveQuantity::tangential_stiffness) || scene.asks(CurveQuantity::shear_reflection))
        text += "Kt/A0 is the tangential stiffness, " + document::rounded(results.tangential_ratio) +
                " K/A0 by Mindlin's ratio\n";
    if (scene.asks(CurveQuantity::reflection) || scene.asks(CurveQuantity::shear_reflection))
        text += "|R| is the reflection of the interface as a spring, eq. (5.1); shear waves see Kt/A0\n";
    if (has_band(results))
        text += "5 % and 95 %: " + origin_of_band(scene) + "\n";
    else if (scene.needs_stiffness())
        text += "named laws have no band: " + why_no_band(scene, results) +
                (results.answer ? "; the answer's is above\n" : "\n");
    return text;
}

std::string label_of(const Scene& scene, const Curve& curve) {
    if (!curve.by.empty()) return (scene.best ? "" : "answer: ") + laws_of(curve);
    return std::string(curve.law->name) +
           (curve.theta ? ", theta " + document::rounded(*curve.theta, 4) + ", r " + document::rounded(*curve.r, 4)
                        : "");
}

std::string full_table(const Scene& scene, const Results& results) {
    const Units units = units_of(scene, results);
    std::string text = introduction(scene, results);
    for (const Curve* curve : shown_curves(results))
        text += "\n" + (curve->by.empty() ? title(*curve) : label_of(scene, *curve)) + "\n" +
                point_rows(results, *curve, units).text();
    const std::string notes = explanations(scene, results) +
                              (scene.asks(CurveQuantity::real_area) ? "mean pressure is that on the real area\n" : "");
    return notes.empty() ? text : text + "\n" + notes;
}

/// \p cell of each of \p curves at every point of the summary, below \p what: in several tables where one is wider than
/// the page.
template <class Cell>
std::string curve_tables(const Scene& scene, const std::vector<const Curve*>& curves, std::string what,
                         const Cell& cell) {
    std::size_t first =
        std::max<std::size_t>(28, document::shown_width(what));  // columns of all blocks begin at one place
    for (const Curve* curve : curves) first = std::max(first, document::shown_width(label_of(scene, *curve)));
    const auto padded = [&](std::string label) {
        return label + std::string(first - document::shown_width(label), ' ');
    };
    const std::vector<std::size_t> points = points_of_answer(scene);
    const auto table = [&](std::span<const std::size_t> some) {
        document::TextRows rows{{padded(what)}};
        for (const std::size_t i : some) rows[0].push_back(shown_point(scene, i));
        for (const Curve* curve : curves) {
            rows.push_back({padded(label_of(scene, *curve))});
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

std::vector<const Curve*> named_curves(const Results& results) {
    std::vector<const Curve*> curves;
    for (const Curve& curve : results.curves) curves.push_back(&curve);
    return curves;
}

/// Whether \p quantity of the answer is in its own table, above all others.
bool is_in_answer(CurveQuantity quantity) {
    return quantity == CurveQuantity::stiffness || quantity == CurveQuantity::joint_stiffness ||
           quantity == CurveQuantity::approach;
}

/// \p quantity of every curve, that of the answer first, of one that K gives with its band.
std::string quantity_tables(const Scene& scene, const Results& results, const Units& units, CurveQuantity quantity) {
    const scene::Column column{quantity};
    const document::Heading heading = heading_of(column, units);
    const scene::OfStiffness of = column.row().of_stiffness;
    const std::vector<const Curve*> curves = is_in_answer(quantity) ? named_curves(results) : shown_curves(results);
    const bool band =
        of != scene::OfStiffness::none &&
        std::any_of(curves.begin(), curves.end(), [](const Curve* curve) { return !curve->band.empty(); });
    const auto text = [reflection = of == scene::OfStiffness::falls && column.row().unit.empty()](double x,
                                                                                                  int digits) {
        const double rest = std::max(1 - x, 1e-15);  // 1 - |R| has two digits
        return document::rounded(x,
                                 reflection ? 1 + std::max(2, static_cast<int>(std::ceil(-std::log10(rest)))) : digits);
    };
    return curve_tables(
        scene, curves, heading.shown + (band ? ", 5 % to 95 %" : ""), [&](const Curve& curve, std::size_t i) {
            const auto value = [&](scene::Statistic statistic) {
                const auto number = curve.value_at(i, quantity, statistic);
                return number ? std::optional(*number * heading.factor) : number;
            };
            const auto middle = value(scene::Statistic::value), low = value(scene::Statistic::p05),
                       high = value(scene::Statistic::p95);
            if (!middle || !band || !low || !high) return middle ? document::rounded(*middle) : "-";
            const double nearest = std::min({*high - *low, 2 * (*high - *middle), 2 * (*middle - *low)});
            const int digits = nearest < 0.2 * *middle ? 3 : 2;  // that distinguish all three
            return text(*middle, 3) + " (" + text(*low, digits) + "–" + text(*high, digits) + ")";
        });
}

/// The tables of the summary.
std::string blocks(const Scene& scene, const Results& results) {
    using enum CurveQuantity;
    const Units units = units_of(scene, results);
    std::vector<CurveQuantity> shown{stiffness,
                                     joint_stiffness,
                                     approach,
                                     tangential_stiffness,
                                     loss_factor,
                                     reflection,
                                     shear_reflection,
                                     thermal_conductance,
                                     thermal_conductance_gap,
                                     electrical_conductance,
                                     thermal_resistance,
                                     electrical_resistance};
    if (!scene.needs_stiffness()) shown = {separation, approach, real_area, contacts};
    std::string text;
    for (const CurveQuantity quantity : shown) {
        if (!scene.asks(quantity) || (scene.best && is_in_answer(quantity))) continue;
        text += "\n" + quantity_tables(scene, results, units, quantity);
    }
    if (!scene.needs_stiffness() || !results.answer || scene.best) return text;
    return text + "\n" +
           curve_tables(scene, named_curves(results), "K over the answer", [&](const Curve& curve, std::size_t i) {
               const Curve& answer = results.answer->curve;
               const auto mine = curve.state_at(i), best = answer.state_at(i);
               const double ratio = mine && best
                                        ? curve.states[*mine].stiffness.value / answer.states[*best].stiffness.value
                                        : std::numeric_limits<double>::quiet_NaN();
               return std::isfinite(ratio) ? document::rounded(ratio, 3) : "-";
           });
}

/// The answer, and each law that is named at the points of the summary.
std::string summary(const Scene& scene, const Results& results) {
    const std::string more = "every point and quantity: --full, --format csv, --format json\n";
    if (scene.best) return introduction(scene, results) + blocks(scene, results) + more;
    std::string text = introduction(scene, results) + blocks(scene, results) + "\n";
    for (const detail::Law* law : scene.laws)
        text += "  " + std::string(law->name) + " is " + std::string(law->nature) + "\n";
    return text + "\n" + explanations(scene, results) + more;
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

std::vector<InputLine> input_lines(const Scene& scene, const Results& results) {
    std::vector<InputLine> lines{{"surface", run_text::surface_parts(scene, results)}};
    if (!scene.faces.empty()) {
        lines.push_back({"", {"of the sum of two rough faces"}});
        if (scene.face.map)
            lines.back().parts.push_back("laws of a map are means over " + std::to_string(scene.shifts) +
                                         " random shifts");
    }
    for (const auto& [name, face, file] : measured_files(scene)) {
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
        lines.push_back({scene.faces.empty() ? "measured" : std::string(name), std::move(parts)});
    }
    run_text::add_bodies(scene, results, lines);
    return lines;
}

document::Document document_of(const Scene& given, const Results& computed, bool full) {
    const auto scene = std::make_shared<const Scene>(given);
    const auto results = std::make_shared<const Results>(computed);
    document::Document document("run");
    document.text([=] { return full ? run_text::full_table(*scene, *results) : run_text::summary(*scene, *results); });
    document.values([=](document::Json& to) { to = run_document(*scene, *results); });
    const auto add = [&](const Curve& curve, int answers) {
        document.csv([=, &curve] {
            Curve shown = curve;
            if (results->answer) shown.columns = columns_of(*scene, curve, true);  // its own has a band
            document::Rows rows = point_rows(*results, shown);
            rows.repeat({"answer"}, answers, rows.size());
            return rows;
        });
    };
    if (scene->ball)
        document.csv([=] { return ball_rows(*results); });
    else if (results->answer)
        add(results->answer->curve, 1);
    if (!scene->best)
        for (const Curve& curve : results->curves) add(curve, 0);
    document.warnings = results->warnings;
    document.doubtful = results->doubtful;
    return document;
}

}  // namespace fstiff::actions
