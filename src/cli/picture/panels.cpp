// SPDX-License-Identifier: BSD-3-Clause
// The figure of results, and its files: the picture, and its numbers as CSV.
#include "picture/plot.hpp"

#include "actions/run.hpp"
#include "document/own_output.hpp"

#include <fstiff/contact/persson_contact.hpp>
#include <fstiff/core/error.hpp>
#include <fstiff/core/version.hpp>
#include <fstiff/wave/spring_interface.hpp>
#include <fstiff/wave/uncertain_reflection.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace fstiff::cli {

using actions::Answered;

namespace {

constexpr std::size_t most_curves = 8, most_marks = 12;

/// One law at the points of a scene and, where they are computed, between them.
struct DrawnCurve {
    const AnswerCurve* own;
    bool is_answer = false;
    const AnswerCurve* between = nullptr;

    /// The points with a K, from the least pressure to the greatest.
    [[nodiscard]] std::vector<const AnswerPoint*> points() const {
        std::vector<const AnswerPoint*> points;
        for (const AnswerCurve* part : {own, between})
            if (part)
                for (const AnswerPoint& point : part->points)
                    if (point.ok()) points.push_back(&point);
        std::stable_sort(points.begin(), points.end(),
                         [](const auto* a, const auto* b) { return a->pressure < b->pressure; });
        return points;
    }
};

/// Boundary elements, whose error is that of their grid.
bool is_truth(const AnswerCurve& curve) { return curve.law == LawKind::boundary_elements; }

/// The answer, then the laws in the order of the scene.
std::vector<DrawnCurve> curves_of(const Answered& answered, const std::optional<Answered>& between) {
    std::vector<DrawnCurve> curves;
    for (const AnswerCurve* own : answered.shown_curves()) {
        if (actions::count_of(*own) == 0) continue;  // no pressure is within its reach
        curves.push_back({own, answered.is_answer(*own)});
        for (const AnswerCurve* fine : between ? between->shown_curves() : std::vector<const AnswerCurve*>())
            if (fine->law == own->law && fine->theta == own->theta && fine->r == own->r &&
                between->is_answer(*fine) == answered.is_answer(*own))
                curves.back().between = fine;
    }
    return curves;
}

/// \p quantity of \p curve in a unit by \p factor, with the ends of its band or, of boundary elements, with the error
/// of K as bars.
PlotLine line_of(const DrawnCurve& curve, const AnswerQuantity& quantity, const document::ShownUnit& unit_of_pressure,
                 double factor) {
    PlotLine line{.label =
                      curve.is_answer ? "answer (" + actions::laws_of(*curve.own) + ")" : actions::title(*curve.own)};
    const bool of_grid = quantity.word == "stiffness" && is_truth(*curve.own) && !curve.own->has_band;
    for (const AnswerPoint* point : curve.points()) {
        const AnswerPoint::Value* value = point->find(quantity.word);
        if (!value) continue;
        const auto& [low, middle, high] = value->number;
        line.x.push_back(point->pressure * unit_of_pressure.factor);
        line.y.push_back(middle * factor);
        const auto put = [&](double least, double most) {
            line.low.push_back(least * factor), line.high.push_back(most * factor);
        };
        if (quantity.follows_stiffness() && curve.own->has_band)
            put(std::min(low, high), std::max(low, high));
        else if (of_grid)
            put(value->error < 0.9 * middle ? middle - value->error : 0, middle + value->error);
    }
    if (line.low.size() != line.x.size()) line.low.clear(), line.high.clear();
    if (!line.low.empty()) line.band = of_grid ? "± error" : "5\u00A0to\u00A095\u00A0%";  // unbroken
    line.bars = of_grid || line.x.size() == 1;                                            // where a band has no width
    return line;
}

/// \p quantity of \p curves against the pressure, with marks at the few points of a scene.
Panel panel_of(const std::vector<DrawnCurve>& curves, const AnswerQuantity& quantity, std::string title,
               const actions::Units& units) {
    const document::Heading heading = actions::heading_of({&quantity}, units);
    Panel panel{.title = std::move(title),
                .x = {units.at("Pa").heading("nominal pressure p")},
                .y = {heading.shown},
                .height = 240};
    const std::size_t count = std::min(curves.size(), most_curves);
    for (std::size_t k = 0; k < count; ++k) {
        panel.lines.push_back(line_of(curves[k], quantity, units.at("Pa"), heading.factor));
        panel.lines.back().colour = static_cast<int>(k);
    }
    for (std::size_t k = 0; k < count; ++k) {
        if (!curves[k].between || actions::count_of(*curves[k].own) > most_marks) continue;
        const PlotLine own = line_of({curves[k].own, curves[k].is_answer}, quantity, units.at("Pa"), heading.factor);
        panel.lines.push_back({.x = own.x, .y = own.y, .marks = true, .colour = static_cast<int>(k)});
    }
    return panel;
}

/// The lines of \p gap next to those of the \p spots, which are parallel to it.
void add_gap(Panel& spots, Panel gap) {
    const auto named = [](PlotLine& line, const std::string& part) {
        if (!line.label.empty()) line.label = part + line.label;
    };
    const int colours = 1 + std::max_element(spots.lines.begin(), spots.lines.end(), [](const auto& a, const auto& b) {
                                return a.colour < b.colour;
                            })->colour;
    for (PlotLine& line : spots.lines) named(line, "contacts, ");
    for (PlotLine& line : gap.lines) {
        named(line, "gap, ");
        line.colour = (line.colour + colours) % neutral;
        spots.lines.push_back(std::move(line));
    }
    spots.title += " and of the gap";
    spots.height = gap.height + 60;
}

/// |R| of \p panel: the frame leaves room about 0 and 1; what is all close to one of them fills it.
void frame_reflection(Panel& panel) {
    double least = 1, greatest = 0;
    for (const PlotLine& line : panel.lines)
        for (const auto* values : {&line.y, &line.low, &line.high})
            for (const double value : *values) least = std::min(least, value), greatest = std::max(greatest, value);
    const bool high = least > 0.8, low = greatest < 0.2 && greatest > 0;
    const double span = high ? std::max(1 - least, 1e-6) : low ? greatest : 1;
    panel.y = {.label = "|R|",
               .logarithmic = false,
               .low = (high ? 1 - span : 0) - 0.04 * span,
               .high = (low ? span : 1) + 0.04 * span};
}

/// K, with the law of light loads for comparison, the changes of the law of the answer, and the K that a wave of the
/// scene's frequency can distinguish from a weld and from a gap.
Panel stiffness_panel(const detail::ResolvedJoint& problem, const std::vector<DrawnCurve>& curves,
                      const actions::Units& units) {
    Panel panel = panel_of(curves, detail::quantity_called("stiffness"), "Normal stiffness per nominal area", units);
    panel.y.label = units.at("Pa/m").heading("K/A₀");
    panel.height = 360;
    if (problem.ultrasound) {
        const UltrasonicWaves& waves = *problem.ultrasound;
        if (const auto range = resolvable_stiffness(waves.longitudinal, waves.angular()))
            panel.window = {"|R| " + document::rounded(range->min_reflection, 2) + " to " +
                                document::rounded(range->max_reflection, 2) + " at " +
                                document::rounded(waves.frequency / 1e6, 3) + " MHz",
                            std::max(range->low - waves.film_stiffness, 0.0) * units.at("Pa/m").factor,
                            std::max(range->high - waves.film_stiffness, 0.0) * units.at("Pa/m").factor};
    }
    double least = std::numeric_limits<double>::infinity(), most = 0, last = 0;
    LawKind before = LawKind::none;
    for (const DrawnCurve& curve : curves)
        for (const AnswerPoint* point : curve.points()) {
            const double p = point->pressure;
            least = std::min(least, p), most = std::max(most, p);
            if (!curve.is_answer) continue;
            if (before != LawKind::none && point->law != before)
                panel.changes.push_back(
                    {std::sqrt(last * p) * units.at("Pa").factor, name_of(before), name_of(point->law)});
            before = point->law, last = p;
        }
    // a straight line on logarithmic axes: two points are enough
    PlotLine reference{.label = "linear law, elastic: p/(0.48 σ)", .colour = neutral};
    for (const double p : {least, most}) {
        if (!(p > 0) || (!reference.x.empty() && least == most)) continue;
        reference.x.push_back(p * units.at("Pa").factor);
        reference.y.push_back(detail::linear_stiffness(p, problem.face.parameters.rms_height.value) *
                              units.at("Pa/m").factor);
    }
    panel.lines.push_back(std::move(reference));
    return panel;
}

std::string figure_csv(const Figure& figure) {
    std::string text =
        "# fstiff " FSTIFF_VERSION_TEXT ": the numbers of a picture\n" +
        document::csv_line({"curve", "panel", "label", "x_quantity", "x", "y_quantity", "y", "low", "high"});
    std::size_t curve = 0, number = 0;
    for (const Panel& panel : figure.panels) {
        ++number;
        for (const PlotLine& line : panel.lines) {
            ++curve;
            const auto end = [](const std::vector<double>& ends, std::size_t i) {
                return ends.empty() ? "" : document::exact(ends[i]);
            };
            for (std::size_t i = 0; i < line.x.size(); ++i)
                text += document::csv_line({std::to_string(curve), std::to_string(number), line.label, panel.x.label,
                                            document::exact(line.x[i]), panel.y.label, document::exact(line.y[i]),
                                            end(line.low, i), end(line.high, i)});
        }
    }
    return text;
}

/// trace.svg to trace.plot.csv. \throws Usage unless \p file ends in .svg.
std::string table_of(const std::string& file) {
    const std::filesystem::path path = document::path_of(file);
    if (path.extension() != ".svg")
        throw Usage("--plot = \"" + file + "\": must end in .svg; the numbers (.plot.csv) are written next to it");
    return document::name_of_path(std::filesystem::path(path).replace_extension(".plot.csv"));
}

}  // namespace

Figure results_figure(const Answered& answered, const std::optional<Answered>& between) {
    const auto& scene = *answered.scene;
    if (!scene.needs_stiffness())
        throw domain_error(scene.file + ": output.quantities: must name \"stiffness\" for a picture of K(p)");
    std::vector<DrawnCurve> curves = curves_of(answered, between);
    const std::size_t count = curves.size();  // of many curves the first ones are drawn, and the truth of a map
    for (std::size_t k = most_curves; k < count; ++k)
        if (is_truth(*curves[k].own)) std::swap(curves[k], curves[most_curves - 1]);
    const actions::Units units = units_of(answered);
    Figure figure{.title = scene.named ? "Contact stiffness: " + scene.name : "Contact stiffness against pressure",
                  .explanation = answered.short_explanation,
                  .panels = {stiffness_panel(scene.joint, curves, units)},
                  .note = "fstiff " FSTIFF_VERSION_TEXT ", " + scene.file +
                          ", σ = " + document::with_unit(scene.joint.face.parameters.rms_height.value, "m", 4)};
    if (count > most_curves)
        figure.note += "; " + std::to_string(most_curves) + " of " + std::to_string(count) +
                       " curves are drawn, fstiff run --format csv has the numbers of all";
    const std::string waves =
        scene.joint.ultrasound ? ", " + document::rounded(scene.joint.ultrasound->frequency / 1e6) + " MHz" : "";
    const auto is_reflection = [](const AnswerQuantity& quantity) { return (quantity.needs & quantity.waves) != 0; };
    for (const bool of_waves : {true, false})  // which are next to the range of K that they resolve
        for (const AnswerQuantity& quantity : answer_quantities()) {
            if (quantity.title.empty() || is_reflection(quantity) != of_waves || !scene.asks(quantity.word)) continue;
            Panel panel = panel_of(curves, quantity, std::string(quantity.title) + (of_waves ? waves : ""), units);
            if (of_waves) frame_reflection(panel);
            if (!quantity.with.empty())
                add_gap(figure.panels.back(), std::move(panel));
            else
                figure.panels.push_back(std::move(panel));
        }
    return figure;
}

void keep_for_picture(const std::string& file, bool force) {
    if (file.empty()) return;
    const std::string table = table_of(file);
    require_writable(file);
    keep_for_output(file);
    keep_for_output(table);
    if (force) return;
    require_own(file);
    require_own(table, true);
}

Report with_picture(Report report, const std::function<Figure()>& figure, const std::string& file) {
    if (file.empty()) return report;
    const Figure drawn = figure();
    deliver({{file, svg(drawn)}, {table_of(file), figure_csv(drawn)}});
    say_written(report, {file, table_of(file)});
    return report;
}

}  // namespace fstiff::cli
