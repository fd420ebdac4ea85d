// SPDX-License-Identifier: BSD-3-Clause
#include "picture/drawing.hpp"

#include "picture/unit.hpp"

#include <algorithm>

namespace fstiff::cli {
namespace {

bool begins_character(char c) { return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u; }

std::vector<PlotLine> coloured(const Panel& panel) {
    std::vector<PlotLine> lines = panel.lines;
    int next = 0;
    for (PlotLine& line : lines)
        if (line.colour == next_colour) line.colour = next++;
    return lines;
}

Range range_of(const Panel& panel, bool of_y) {
    Range range;
    const bool logarithmic = (of_y ? panel.y : panel.x).logarithmic;
    for (const PlotLine& line : panel.lines) {
        if (!line.sets_range) continue;
        for (const auto* values : {of_y ? &line.y : &line.x, of_y ? &line.low : nullptr, of_y ? &line.high : nullptr})
            if (values)
                for (const double value : *values) range.add(value, logarithmic);
    }
    if (const auto& image = panel.image)
        for (const double end : {of_y ? image->y_low : image->x_low, of_y ? image->y_high : image->x_high})
            range.add(end, logarithmic);
    return range;
}

void choose_unit(Panel& panel, bool of_y) {
    Axis& axis = of_y ? panel.y : panel.x;
    if (axis.si.empty()) return;
    Range range = range_of(panel, of_y);
    for (const auto& end : {axis.low, axis.high})
        if (end) range.add(*end, axis.logarithmic);
    const double size = !(range.low <= range.high) ? 0
                        : axis.logarithmic         ? std::sqrt(range.low) * std::sqrt(range.high)
                                                   : std::max(std::abs(range.low), std::abs(range.high));
    const Unit unit = unit_for(axis.si, size);
    const auto convert = [&](auto&... values) { ((values /= unit.size), ...); };
    for (PlotLine& line : panel.lines) {
        if (!of_y) std::for_each(line.x.begin(), line.x.end(), convert);
        if (of_y)
            for (auto* values : {&line.y, &line.low, &line.high})
                std::for_each(values->begin(), values->end(), convert);
    }
    for (PlotWindow& window : panel.windows)
        if (window.of_y == of_y) convert(window.low, window.high);
    if (auto& image = panel.image) of_y ? convert(image->y_low, image->y_high) : convert(image->x_low, image->x_high);
    if (axis.low) convert(*axis.low);
    if (axis.high) convert(*axis.high);
    axis.label += " [" + std::string(unit.name) + "]";
    axis.si.clear();
}

}  // namespace

Figure in_units(Figure figure) {
    for (Panel& panel : figure.panels)
        for (const bool of_y : {false, true}) choose_unit(panel, of_y);
    return figure;
}

std::size_t characters(std::string_view text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), begins_character));
}

std::vector<std::string> wrapped(std::string_view text, std::size_t most) {
    std::vector<std::string> lines;
    while (characters(text) > most) {
        std::size_t end = 0, space = 0;
        for (std::size_t count = 0; count <= most; ++end) {
            if (text[end] == ' ') space = end;
            count += begins_character(text[end]);
        }
        --end;  // the first character too many
        const std::size_t at = space > 0 ? space : end;
        lines.emplace_back(text.substr(0, at));
        text.remove_prefix(space > 0 ? at + 1 : at);
    }
    lines.emplace_back(text);
    return lines;
}

Drawing::Drawing(const Panel& drawn)
    : panel(drawn),
      lines(coloured(drawn)),
      x_scale(drawn.x, range_of(drawn, false)),
      y_scale(drawn.y, range_of(drawn, true)) {
    tell_apart();
}

/// Whether no point of the two is more than a pixel apart.
bool Drawing::on_one_another(const PlotLine& one, const PlotLine& other) const {
    if (one.stroke == Stroke::none || other.stroke == Stroke::none || one.x.size() < 2 ||
        one.x.size() != other.x.size())
        return false;
    bool any = false;
    for (std::size_t i = 0; i < one.x.size(); ++i) {
        const bool shown = x_scale.shows(one.x[i]) && y_scale.shows(one.y[i]);
        if (shown != (x_scale.shows(other.x[i]) && y_scale.shows(other.y[i]))) return false;
        if (!shown) continue;
        any = true;
        if (!(std::abs(place_x(one.x[i]) - place_x(other.x[i])) < 1 &&
              std::abs(place_y(one.y[i]) - place_y(other.y[i])) < 1))
            return false;
    }
    return any;
}

/// Of curves that lie on one another the first is wide and seen through the dashes of the others.
void Drawing::tell_apart() {
    std::vector<int> above(lines.size());  // how many lie on the line
    for (std::size_t upper = 1; upper < lines.size(); ++upper)
        for (std::size_t lower = 0; lower < upper; ++lower) {
            PlotLine &under = lines[lower], &over = lines[upper];
            if (over.label.empty() || under.label != panel.lines[lower].label || under.label.empty()) continue;
            if (!on_one_another(under, over)) continue;
            under.beneath = true;
            over.stroke = under.stroke == Stroke::solid && above[lower]++ == 0 ? Stroke::dashed : Stroke::dotted;
            over.label += " (lies on " + under.label + ")";
            break;
        }
}

std::vector<Entry> Drawing::legend() const {
    std::vector<Entry> result;
    if (!panel.legend) return result;
    constexpr std::size_t most = 44;  // characters of a line
    for (const PlotLine& line : lines)
        if (!line.label.empty())
            result.push_back({&line, nullptr, wrapped(line.label + (line.band.empty() ? "" : ", " + line.band), most)});
    for (const PlotWindow& window : panel.windows)
        if (!window.label.empty()) result.push_back({nullptr, &window, wrapped(window.label, most)});
    return result;
}

}  // namespace fstiff::cli
