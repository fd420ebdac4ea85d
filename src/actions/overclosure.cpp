// SPDX-License-Identifier: BSD-3-Clause
#include "actions/overclosure.hpp"

#include "actions/answered.hpp"
#include "actions/law_of_answer.hpp"
#include "actions/one_contact.hpp"
#include "document/file.hpp"
#include "surface/surface_option_table.hpp"

#include <fstiff/tabulated/contact_law.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fstiff::actions {

namespace {

/// Raises \p worst to the errors of the chords from the points \p begin to the points \p end of \p lines.
void add_chords(const std::vector<Line>& lines, std::size_t begin, std::size_t end, ChordErrors& worst) {
    for (const Line& line : lines) {
        const LinePoint a = line[begin], b = line[end];
        const double slope = (b.y - a.y) / (b.x - a.x);
        for (std::size_t i = begin; i <= end; ++i) {
            const double on_chord = i == end ? b.y : a.y + slope * (line[i].x - a.x);
            worst.value = std::max(worst.value, std::abs(on_chord / line[i].y - 1));
            if (line[i].slope > 0) worst.slope = std::max(worst.slope, std::abs(slope / line[i].slope - 1));
        }
    }
}

bool are_chords_within(const std::vector<Line>& lines, std::size_t begin, std::size_t end, ChordErrors within) {
    ChordErrors worst;
    add_chords(lines, begin, end, worst);
    return worst.value <= within.value && worst.slope <= within.slope;
}

}  // namespace

std::vector<std::size_t> rows_within(const std::vector<Line>& lines, ChordErrors within) {
    const std::size_t size = lines.front().size();
    std::vector<std::size_t> rows{0};
    while (rows.back() + 1 < size) {
        std::size_t end = rows.back() + 1;
        while (end + 1 < size && are_chords_within(lines, rows.back(), end + 1, within)) ++end;
        rows.push_back(end);
    }
    return rows;
}

ChordErrors error_of_rows(const std::vector<Line>& lines, const std::vector<std::size_t>& rows) {
    ChordErrors worst;
    for (std::size_t i = 1; i < rows.size(); ++i) add_chords(lines, rows[i - 1], rows[i], worst);
    return worst;
}

using scene::Scene;

namespace {

bool has_separation(const detail::Law& law) { return detail::has(law.quantities, Quantity::separation); }

const detail::Law& law_of(const Scene& scene, const PressureTableOptions& options) {
    if (options.quantile) {
        detail::ResolvedJoint problem = scene.joint;
        return detail::law_of_answer(problem, false);
    }
    const std::string& name = options.law;
    const std::vector<const detail::Law*> laws = name.empty() ? scene.laws : scene.offered_laws();
    std::vector<std::string_view> names;
    for (const detail::Law* law : laws) {
        if (has_separation(*law) && (name.empty() || name == law->name)) return *law;
        if (has_separation(*law)) names.push_back(law->name);
    }
    if (names.empty()) throw domain_error(scene.file + ": contact.laws: no law of the scene gives a separation");
    names.push_back(answer_word);
    throw domain_error(surface::option_name(options.prefix, "law") + " = \"" + name +
                       "\": is not a law of the scene that gives a separation; must be one of " +
                       document::list_and_suggestion(name, names));
}

/// \p scene with one law, its separation, K and -dp/dd, at pressures so close that sixteen or so lie between two rows,
/// eight where the slope rules, or one for a law that takes seconds for each.
Scene fine_scene(const Scene& scene, const PressureTableOptions& options) {
    const std::string least_name = surface::option_name(options.prefix, "from");
    const std::string most_name = surface::option_name(options.prefix, "until");
    if (scene.at_separations && !(options.from && options.to))
        throw domain_error("the scene has separations; " + least_name + " and " + most_name +
                           " must give the range of pressures");
    const auto [least, greatest] = std::minmax_element(scene.points.begin(), scene.points.end());
    const double from = options.from ? *options.from : *least, to = options.to ? *options.to : *greatest;
    detail::require_positive(least_name, from);
    detail::require(
        to > from, most_name, to,
        "greater than " + least_name + ", " + document::shortest(from) + " Pa" +
            (*least == *greatest && !(options.from && options.to) ? "; the scene has only one pressure" : ""));

    constexpr double widest = 1e15;
    if (!(to / from <= widest))
        detail::refuse(most_name, to, 6, "at most 1e15 times " + least_name + ", " + document::shortest(from) + " Pa");

    Scene fine = scene;
    fine.laws = {&law_of(scene, options)};
    if (!scene.joint.peaks.empty()) {
        detail::require(options.peaks >= 1 && static_cast<std::size_t>(options.peaks) <= scene.joint.peaks.size(),
                        surface::option_name(options.prefix, "peaks"), options.peaks,
                        "between 1 and " + std::to_string(scene.joint.peaks.size()) + ", as many as contact.peaks has");
        fine.joint.peaks = {scene.joint.peaks[static_cast<std::size_t>(options.peaks) - 1]};
    }
    fine.samples = 0;
    fine.best = fine.solves_map = false;
    for (const char* word : {"separation", "stiffness", "loading_stiffness"}) fine.quantities.emplace(word);
    std::erase_if(fine.quantities, [](const std::string& word) {
        const AnswerQuantity& quantity = detail::quantity_called(word);
        return word == "real_area" || word == "contacts" || (quantity.needs & (quantity.waves | quantity.slip)) != 0;
    });
    if (scene.joint.friction) fine.quantities.emplace("tangential_stiffness");
    fine.at_separations = false;
    // the chord of an exponential is off by (log ratio)^2/8, and its slope by (log ratio)/2
    const double decades = std::log(to / from), by_slope = 2 * options.slope_tolerance;
    const double step =
        std::min(std::sqrt(8 * options.tolerance) / 16, fine.laws[0]->varies ? by_slope / 8.2 : by_slope);
    const auto steps = static_cast<std::size_t>(std::max(32.0, std::ceil(decades / step)));
    fine.points.clear();
    for (std::size_t i = 0; i <= steps; ++i)
        fine.points.push_back(from * std::exp(decades * static_cast<double>(i) / static_cast<double>(steps)));
    return fine;
}

/// Those pressures of the answer of \p scene that are between \p from and \p to.
std::vector<double> answered_between(const Scene& scene, double from, double to) {
    std::vector<double> kept;
    if (scene.at_separations) return kept;
    for (const std::size_t place : scene.points_of_answer())
        if (const double p = scene.points[place]; p >= from * (1 - 1e-9) && p <= to * (1 + 1e-9)) kept.push_back(p);
    return kept;
}

/// The points of \p answer whose pressures are among \p pressures.
std::vector<PressureTable::Answer> rows_of(const Answer& answer, const std::vector<double>& pressures) {
    std::vector<PressureTable::Answer> rows;
    for (const AnswerPoint& point : answer.points) {
        const auto is_own = [&](double other) { return std::abs(other / point.pressure - 1) < 1e-9; };
        if (!point.ok() || std::none_of(pressures.begin(), pressures.end(), is_own)) continue;
        rows.push_back({point.pressure, point.stiffness.value, point.stiffness.low, point.stiffness.high,
                        std::string(name_of(point.law))});
    }
    return rows;
}

using States = std::vector<ContactState<double>>;

States states_of(const AnswerCurve& curve) {
    States states;
    for (const AnswerPoint& point : curve.points)
        if (point.ok()) states.push_back(point.state);
    return states;
}

/// The answer of \p scene, which names no law, at those of its pressures that are between \p from and \p to.
std::vector<PressureTable::Answer> answer_between(Scene scene, double from, double to, const ProgressHook& progress) {
    scene.points = answered_between(scene, from, to);
    if (scene.points.empty()) return {};
    return rows_of(compute(scene, progress).answer, scene.points);
}

/// What a table is made of.
struct Tabulated {
    AnswerCurve curve;  ///< at the pressures of the fine grid
    std::string title, law;
    std::vector<PressureTable::Answer> answer{};
    std::vector<std::string> warnings{};
    bool doubtful = false;
};

/// The law of the answer of \p scene that \p options ask for.
LawOfAnswer answer_of(const Scene& scene, const PressureTableOptions& options, double from, double to) {
    try {
        return law_of_answer(scene, *options.quantile, from, to, options.after, options.progress);
    } catch (const domain_error& error) {
        if (!options.after || error.parameter() != "greatest_pressure") throw;
        throw error.with_parameter(surface::option_name(options.prefix, "after"));
    }
}

/// The law of the answer of \p scene, at \p fine.
Tabulated of_answer(const Scene& scene, const Scene& fine, const PressureTableOptions& options) {
    const double from = fine.points.front(), to = fine.points.back();
    const LawOfAnswer found = answer_of(scene, options, from, to);
    const Answer& answer = found.answered.answer;
    std::string end = *options.quantile < 0.5   ? ", the 5 % end of its band"
                      : *options.quantile > 0.5 ? ", the 95 % end of its band"
                                                : "";
    if (options.after) end += ", after " + document::with_unit(*options.after, "Pa", 3);
    return {.curve = curve_at(found, fine, fine.points),
            .title = "of the answer" + end + ", by " + actions::laws_of(answer),
            .law = "the answer" + end,
            .answer = rows_of(answer, answered_between(scene, from, to)),
            .warnings = found.answered.warnings,
            .doubtful = found.answered.doubtful};
}

/// The law of \p scene that \p options name, at \p fine.
Tabulated of_law(const Scene& scene, const Scene& fine, const PressureTableOptions& options) {
    const Answered answered = compute(fine, options.progress);
    Tabulated made{.curve = answered.curves().front(),
                   .title = {},
                   .law = {},
                   .warnings = answered.warnings,
                   .doubtful = answered.doubtful};
    made.title = title(made.curve), made.law = "law " + std::string(name_of(made.curve.law));
    const States states = states_of(made.curve);
    if (scene.best && options.law.empty() && !states.empty())
        made.answer =
            answer_between(scene, states.front().pressure.value, states.back().pressure.value, options.progress);
    return made;
}

/// The least and the greatest slope of \p points over K of the \p states of \p law.
std::optional<PressureTable::Range> slope_over_stiffness(LawKind law, const States& states, const Line& points) {
    const Quantity given = detail::find_law(law).quantities;
    if (!detail::has(given, Quantity::stiffness) || !detail::has(given, Quantity::loading_stiffness))
        return std::nullopt;
    PressureTable::Range range{std::numeric_limits<double>::infinity(), 0};
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double ratio = points[i].slope / states[i].stiffness.value;
        if (!(ratio > 0)) return std::nullopt;  // boundary elements that yield have K of unloading alone
        range = {std::min(range.least, ratio), std::max(range.greatest, ratio)};
    }
    return range;
}

/// The pressures of the \p states of \p law, and -dp/dd, over the way that the faces have come closer since the first.
Line points_of(LawKind law, const States& states) {
    Line points;
    for (const auto& state : states) {
        points.push_back({states.front().separation.value - state.separation.value, state.pressure.value,
                          state.loading_stiffness.value});
        if (points.size() > 1 && !(points.back().x > points[points.size() - 2].x))
            throw domain_error("law " + std::string(name_of(law)) + ": the separation does not fall at " +
                               document::shortest(state.pressure.value) +
                               " Pa; a table needs one that falls as the pressure rises");
    }
    if (points.size() < 2) throw domain_error("law " + std::string(name_of(law)) + ": has no range of pressures there");
    return points;
}

/// Gives \p points the slopes of the chords between \p rows.
void set_slopes_of_chords(Line& points, const std::vector<std::size_t>& rows) {
    for (std::size_t row = 1; row < rows.size(); ++row) {
        const LinePoint a = points[rows[row - 1]], b = points[rows[row]];
        for (std::size_t i = rows[row - 1]; i <= rows[row]; ++i) points[i].slope = (b.y - a.y) / (b.x - a.x);
    }
}

/// The value \p at_zero, then those of \p quantity along \p curve; empty where it has none.
std::vector<double> values_after(double at_zero, const AnswerCurve& curve, std::string_view quantity) {
    std::vector<double> values{at_zero};
    for (const AnswerPoint& point : curve.points)
        if (const AnswerPoint::Value* value = point.find(quantity)) values.push_back(value->number.value);
    return values.size() > 1 ? values : std::vector<double>();
}

/// \p points, where the overclosure 0 is at \p foot, and the other columns of \p curve.
LawColumns columns_from(const Scene& scene, const AnswerCurve& curve, const Line& points, double foot,
                        double zero_separation) {
    LawColumns columns{.overclosure = {0}, .pressure = {0}, .slope = {0}};
    for (const LinePoint& point : points) {
        columns.overclosure.push_back(point.x - foot);
        columns.pressure.push_back(point.y);
        columns.slope.push_back(point.slope);
    }
    columns.tangential = values_after(0, curve, "tangential_stiffness");
    columns.current = values_after(0, curve, "electrical_conductance");
    columns.heat = values_after(0, curve, "thermal_conductance");
    if (columns.heat.empty() || !scene.asks("thermal_conductance_gap")) return columns;
    const double open = detail::conductance_of_gap(scene.joint.conduction, zero_separation);
    const std::vector<double> gap = values_after(open, curve, "thermal_conductance_gap");
    for (std::size_t i = 0; i < columns.heat.size(); ++i) columns.heat[i] += gap[i];
    return columns;
}

}  // namespace

Line LawColumns::line(const std::vector<double>& x, const std::vector<double>& y, const std::vector<double>& slope) {
    Line points;
    for (std::size_t i = 1; i < x.size(); ++i) points.push_back({x[i], y[i], slope.empty() ? 0 : slope[i]});
    return points;
}

std::string law_text(const Scene& scene, const PressureTableOptions& options) {
    const Scene fine = fine_scene(scene, options);
    const double from = fine.points.front(), to = fine.points.back();
    if (options.quantile) return answer_of(scene, options, from, to).law.to_text();
    return make_contact(fine, 0, 0, options.progress)
        .contact->tabulate({.min_pressure = from, .max_pressure = to, .outside = OutsideRange::extrapolate})
        .to_text();
}

PressureTable pressure_table(const Scene& scene, const PressureTableOptions& options) {
    detail::require(options.tolerance >= 1e-5 && options.tolerance <= 0.2,
                    surface::option_name(options.prefix, "tolerance"), options.tolerance, "between 0.001 % and 20 %");
    detail::require(options.slope_tolerance >= 1e-3 && options.slope_tolerance <= 1,
                    surface::option_name(options.prefix, "slope_tolerance"), options.slope_tolerance,
                    "between 0.1 % and 100 %");
    const Scene fine = fine_scene(scene, options);
    Tabulated made = options.quantile ? of_answer(scene, fine, options) : of_law(scene, fine, options);
    const AnswerCurve& curve = made.curve;
    const States states = states_of(curve);
    Line points = points_of(curve.law, states);
    const ChordErrors within = fine_tolerance({options.tolerance, options.slope_tolerance});
    std::vector<std::size_t> chosen = rows_within({points}, within);
    const bool follows = error_of_rows({points}, chosen).slope <= within.slope;
    if (!follows) chosen = rows_within({points}, {within.value, std::numeric_limits<double>::infinity()});
    const ChordErrors error = error_of_rows({points}, chosen);
    if (!follows) set_slopes_of_chords(points, chosen);
    const LinePoint first = points.front(), second = points[chosen[1]];
    const double foot = -first.y * second.x / (second.y - first.y);

    PressureTable table{.title = std::move(made.title),
                        .law = std::move(made.law),
                        .from = points.front().y,
                        .to = points.back().y,
                        .zero_separation = states.front().separation.value - foot,
                        .error = error,
                        .answer = std::move(made.answer),
                        .slope_over_stiffness = slope_over_stiffness(curve.law, states, points),
                        .follows_slope = follows,
                        .warnings = std::move(made.warnings),
                        .doubtful = made.doubtful || !follows};
    table.columns = columns_from(scene, curve, points, foot, table.zero_separation);
    if (!follows) table.columns.slope.clear();
    table.rows.push_back({0, 0});
    for (std::size_t i = 1; i < chosen.size(); ++i)
        table.rows.push_back({points[chosen[i]].y, points[chosen[i]].x - foot});
    return table;
}

}  // namespace fstiff::actions
