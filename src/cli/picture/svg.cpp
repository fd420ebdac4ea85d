// SPDX-License-Identifier: BSD-3-Clause
// The figure as SVG: each panel is drawn into coordinates of its own.
#include "picture/plot.hpp"

#include <fstiff/core/text.hpp>

#include <algorithm>
#include <array>

namespace fstiff::cli {

namespace {

struct Colour {
    const char *name, *light, *dark;
};
constexpr std::array<Colour, neutral + 1> palette{{{"c0", "#b3261e", "#ff8a80"},
                                                   {"c1", "#0b57a4", "#7db8ff"},
                                                   {"c2", "#1b7f54", "#5ccf97"},
                                                   {"c3", "#7a2f9e", "#dba4f5"},
                                                   {"c4", "#b06000", "#ffb961"},
                                                   {"c5", "#00737a", "#5fd4dc"},
                                                   {"c6", "#9c2470", "#f59acb"},
                                                   {"c7", "#6b6200", "#e0cf5a"},
                                                   {"cn", "#5f5f66", "#a9a9b2"}}};
constexpr double left = 84, panel_width = 640, title_height = 26, below = 54, row_height = 24, line_height = 17,
                 margin = 24;
const std::string small_text = "class=\"small\"", at_middle = "text-anchor=\"middle\"", at_end = "text-anchor=\"end\"";

/// Every rule is under .fstiff: several pictures share a page, and its own rules stay its own.
std::string style() {
    std::string light = R"(
.fstiff text{font:13px system-ui,'DejaVu Sans',sans-serif;fill:#1d1d1f}
.fstiff .title{font-size:15px;font-weight:600}.fstiff .small{font-size:11px}
.fstiff .back{fill:#ffffff}.fstiff .frame{fill:none;stroke:#6b6b70}
.fstiff .grid{stroke:#d9d9de}.fstiff .fine{stroke:#eeeef1}
.fstiff .line{fill:none;stroke-width:2;stroke-linejoin:round}.fstiff .bar{fill:none;stroke-width:1.4}
.fstiff .dash{stroke-dasharray:7 4}.fstiff .dot{stroke-dasharray:2 4}
.fstiff .veil{fill:#ffffff;fill-opacity:.85}.fstiff .band{stroke:none;opacity:.18}.fstiff .window{fill-opacity:.14;fill:#8a7200}
)";
    std::string dark = R"(
.fstiff text{fill:#ececf1}.fstiff .back{fill:#16161a}.fstiff .frame{stroke:#9a9aa2}
.fstiff .grid{stroke:#3a3a42}.fstiff .fine{stroke:#26262c}
.fstiff .veil{fill:#16161a}.fstiff .band{opacity:.26}.fstiff .window{fill-opacity:.18;fill:#ffe28a}
)";
    for (const Colour& colour : palette)
        for (const auto& [rules, value] : {std::pair(&light, colour.light), std::pair(&dark, colour.dark)})
            *rules += std::string(".fstiff .") + colour.name + "{stroke:" + value + "}.fstiff .f" + colour.name +
                      "{fill:" + value + "}\n";
    return "<style>" + light + "@media screen and (prefers-color-scheme:dark){" + dark + "}</style>\n";
}

/// \p text between the tags of SVG.
std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : document::printable(text)) switch (c) {
            case '<': result += "&lt;"; break;
            case '>': result += "&gt;"; break;
            case '&': result += "&amp;"; break;
            case '"': result += "&quot;"; break;
            default: result += c;
        }
    return result;
}

/// Pixels to a tenth, as short as can be.
std::string px(double value) {
    std::string text = detail::fixed_text(value, 1);
    if (text.ends_with(".0")) text.resize(text.size() - 2);
    return text == "-0" ? "0" : text;
}
std::string point_text(double x, double y) { return px(x) + " " + px(y); }

/// The beginning of an element of the class \p kind, without its end.
std::string element(const std::string& name, const std::string& kind,
                    std::initializer_list<std::pair<const char*, double>> numbers) {
    std::string text = "<" + name + (kind.empty() ? "" : " class=\"" + kind + "\"");
    for (const auto& [key, value] : numbers) text += std::string(" ") + key + "=\"" + px(value) + "\"";
    return text;
}
std::string line_at(const std::string& kind, double x1, double y1, double x2, double y2) {
    return element("line", kind, {{"x1", x1}, {"y1", y1}, {"x2", x2}, {"y2", y2}}) + "/>\n";
}
/// \p data: attributes more.
std::string rectangle(const std::string& kind, double x, double y, double width, double height,
                      const std::string& data = "") {
    return element("rect", kind, {{"x", x}, {"y", y}, {"width", width}, {"height", height}}) + data + "/>\n";
}
std::string path_of(const std::string& kind, const std::string& path) {
    return path.empty() ? "" : "<path class=\"" + kind + "\" d=\"" + path + "\"/>\n";
}
std::string text_at(double x, double y, std::string_view text, const std::string& attributes = "") {
    return element("text", "", {{"x", x}, {"y", y}}) + " " + attributes + ">" + escaped(text) + "</text>\n";
}
std::string paragraph_at(double x, double y, const std::vector<std::string>& lines,
                         const std::string& attributes = "") {
    std::string out;
    for (const std::string& line : lines) out += text_at(x, y, line, attributes), y += line_height;
    return out;
}
double height_of(const std::vector<std::string>& lines) { return line_height * static_cast<double>(lines.size()); }

/// Numbers in the units of the axes, for programs that read the picture.
std::string data_range(const char* name, double low, double high, int digits) {
    return std::string(" data-") + name + "=\"" + document::rounded(low, digits) + " " +
           document::rounded(high, digits) + "\"";
}

std::string colour_of(const PlotLine& line) { return palette[static_cast<std::size_t>(line.colour)].name; }
std::string stroke_of(const PlotLine& line) {
    return "line " + colour_of(line) + (line.colour == neutral ? " dash" : "");
}

/// An error bar, with a short line across both ends.
std::string bar(double x, double high, double low) {
    return "M" + point_text(x - 4, high) + "h8M" + point_text(x, high) + "V" + px(low) + "M" + point_text(x - 4, low) +
           "h8";
}

std::vector<double> values_of(const Panel& panel, bool of_y) {
    std::vector<double> values;
    for (const PlotLine& line : panel.lines)
        for (const auto* part : {of_y ? &line.y : &line.x, of_y ? &line.low : nullptr, of_y ? &line.high : nullptr})
            if (part) values.insert(values.end(), part->begin(), part->end());
    return values;
}

/// A panel with its scales.
struct Drawing {
    explicit Drawing(const Panel& drawn)
        : panel(drawn), x_scale(drawn.x, values_of(drawn, false)), y_scale(drawn.y, values_of(drawn, true)) {}
    /// Room above the lines.
    void add_room(double more) { y_scale.extend(more / panel.height), height += more; }
    double x(double value) const { return panel_width * x_scale(value); }
    double y(double value) const { return height * (1 - y_scale(value)); }
    bool shows(const PlotLine& line, std::size_t i) const {
        return x_scale.shows(line.x[i]) && y_scale.shows(line.y[i]);
    }

    const Panel& panel;
    Scale x_scale, y_scale;
    double height = panel.height;
};

/// Background of the lines: the shaded window, changes of the law, the grid.
std::string background(const Drawing& d) {
    const double height = d.height;
    std::string out;
    if (const auto& window = d.panel.window) {
        const double high = std::clamp(d.y(window->high), 0.0, height), low = std::clamp(d.y(window->low), 0.0, height);
        out +=
            rectangle("window", 0, high, panel_width, low - high, data_range("range", window->low, window->high, 15));
    }
    double y = height - 8;
    for (const PlotChange& change : d.panel.changes) {  // close ones have their names above one another
        const double x = d.x(change.x);
        out += line_at("line cn dot", x, 0, x, height);
        if (&change == &d.panel.changes.front()) out += text_at(x - 6, y, change.before, small_text + " " + at_end);
        out += text_at(x + 6, y, change.after, small_text);
        y -= line_height;
    }
    const auto kind = [](const Tick& tick) { return tick.label.empty() ? "fine" : "grid"; };
    for (const Tick& tick : d.x_scale.ticks()) out += line_at(kind(tick), d.x(tick.value), 0, d.x(tick.value), height);
    for (const Tick& tick : d.y_scale.ticks())
        out += line_at(kind(tick), 0, d.y(tick.value), panel_width, d.y(tick.value));
    return out;
}

/// The band of \p line, or its error bars.
std::string band(const Drawing& d, const PlotLine& line) {
    std::string path, back;
    for (std::size_t i = 0; i < line.low.size(); ++i) {
        const double x = d.x(line.x[i]), high = d.y(line.high[i]),
                     low = d.y_scale.shows(line.low[i]) ? d.y(line.low[i]) : d.height + 10;
        if (line.bars && d.shows(line, i)) path += bar(x, high, low);
        if (line.bars) continue;
        path += (i ? "L" : "M") + point_text(x, high);
        back = "L" + point_text(x, low) + back;
    }
    return line.bars ? path_of("bar " + colour_of(line), path)
                     : path_of("band f" + colour_of(line), path + back + (path.empty() ? "" : "Z"));
}

/// One line, or its marks; one point, which no line shows, has a mark.
std::string line_and_marks(const Drawing& d, const PlotLine& line) {
    std::string path, marks;
    for (std::size_t i = 0; i < line.x.size(); ++i) {
        if (!d.shows(line, i)) continue;
        // far outside the frame is as good as anywhere there; numbers stay short
        const double x = std::clamp(d.x(line.x[i]), -1e4, 1e4), y = std::clamp(d.y(line.y[i]), -1e4, 1e4);
        path += (i > 0 && d.shows(line, i - 1) ? "L" : "M") + point_text(x, y);
        if (line.marks || line.x.size() == 1) marks += element("circle", "", {{"cx", x}, {"cy", y}, {"r", 3.2}}) + "/>";
    }
    return (line.marks ? "" : path_of(stroke_of(line), path)) +
           (marks.empty() ? "" : "<g class=\"f" + colour_of(line) + "\">" + marks + "</g>\n");
}

/// Numbers and labels of both axes of a plot whose upper edge is at \p top.
std::string axes(const Drawing& d, double top) {
    const double height = d.height, middle = top + height / 2;
    std::string out;
    for (const Tick& tick : d.x_scale.ticks())
        if (!tick.label.empty()) out += text_at(left + d.x(tick.value), top + height + 18, tick.label, at_middle);
    for (const Tick& tick : d.y_scale.ticks())
        if (!tick.label.empty()) out += text_at(left - 7, top + d.y(tick.value) + 4.5, tick.label, at_end);
    return out + text_at(left + panel_width / 2, top + height + 40, d.panel.x.label, at_middle) +
           text_at(18, middle, d.panel.y.label,
                   at_middle + " transform=\"rotate(-90 " + point_text(18, middle) + ")\"");
}

/// Samples and names of lines and of the window, from 0 0 to the right and down.
struct Legend {
    std::string svg{};
    double width = 0, height = 0;
};

/// Of the lines of \p panel that are not among those \p shown above it.
Legend legend_of(const Panel& panel, std::vector<std::string>& shown) {
    constexpr double x = 8;
    Legend legend;
    double y = 15;
    const auto add = [&](const std::string& sample, const std::string& name) {
        const std::vector<std::string> text = document::wrapped(name, 44);
        legend.svg += sample + paragraph_at(x + 38, y + 4.5, text);
        y += row_height - line_height + height_of(text);
        for (const std::string& line : text)
            legend.width = std::max(legend.width, x + 46 + 7.3 * static_cast<double>(document::shown_width(line)));
    };
    for (const PlotLine& line : panel.lines) {
        const std::string name = line.label + (line.band.empty() || line.label.empty() ? "" : ", " + line.band);
        if (name.empty() || std::find(shown.begin(), shown.end(), colour_of(line) + line.label) != shown.end())
            continue;
        shown.push_back(colour_of(line) + line.label);
        add((line.bars           ? path_of("bar " + colour_of(line), bar(x + 15, y - 7, y + 7))
             : line.band.empty() ? ""
                                 : rectangle("band f" + colour_of(line), x, y - 7, 30, 14)) +
                (line.marks ? element("circle", "f" + colour_of(line), {{"cx", x + 15}, {"cy", y}, {"r", 3.2}}) + "/>\n"
                            : line_at(stroke_of(line), x, y, x + 30, y)),
            name);
    }
    if (panel.window) add(rectangle("window", x, y - 7, 30, 14), panel.window->label);
    if (!legend.svg.empty()) legend.height = y - 9;
    return legend;
}

/// Whether a line of \p d, or its band, passes through a rectangle.
bool passes(const Drawing& d, double from_x, double from_y, double width, double height) {
    constexpr int steps = 16;  // from point to point
    for (const PlotLine& line : d.panel.lines)
        for (std::size_t i = 0; i < line.x.size(); ++i) {
            const std::size_t next = std::min(i + 1, line.x.size() - 1);
            if (!d.shows(line, i) || !d.shows(line, next)) continue;
            const auto at = [&](const std::vector<double>& ends, double share) {
                const auto place = [&](std::size_t k) {
                    return d.y_scale.shows(ends[k]) ? std::clamp(d.y(ends[k]), 0.0, d.height) : d.height;
                };
                return std::lerp(place(i), place(next), share);
            };
            for (int k = 0; k < steps; ++k) {
                const double share = static_cast<double>(k) / steps, y = at(line.y, share),
                             x = std::lerp(d.x(line.x[i]), d.x(line.x[next]), share),
                             high = line.high.empty() ? y : at(line.high, share),
                             low = line.low.empty() ? y : at(line.low, share);
                if (x > from_x - 8 && x < from_x + width + 8 && low > from_y - 8 && high < from_y + height + 8)
                    return true;
            }
        }
    return false;
}

/// \p legend in a corner of \p d where no line passes, else above the lines.
std::string placed(const Legend& legend, Drawing& d) {
    if (legend.svg.empty()) return "";
    constexpr double space = 7;  // from the frame
    const auto at = [&](bool right, bool low) {
        return std::pair(right ? panel_width - space - legend.width : space,
                         low ? d.height - space - legend.height : space);
    };
    auto [x, y] = at(false, false);
    bool free = false;
    for (const auto& [right, low] : {std::pair(false, false), {true, true}, {true, false}, {false, true}}) {
        if (free || (low && !d.panel.changes.empty())) continue;  // the names of the laws are there
        const auto [corner_x, corner_y] = at(right, low);
        free = !passes(d, corner_x, corner_y, legend.width, legend.height);
        if (free) x = corner_x, y = corner_y;
    }
    if (!free) d.add_room(legend.height + space);
    return "<g class=\"legend\" transform=\"translate(" + point_text(x, y) + ")\">\n" +
           rectangle("veil", 0, 0, legend.width, legend.height) + legend.svg + "</g>\n";
}

/// A part of the picture, and the coordinate of its lower end.
struct Part {
    std::string svg{};
    double low = 0;
};

/// One panel whose upper edge is at \p top; \p shown: the lines that a legend above it names.
Part draw(const Panel& panel, double top, std::vector<std::string>& shown) {
    Drawing d(panel);
    const double plot = top + title_height;
    const std::string legend = placed(legend_of(panel, shown), d);
    // what may reach beyond the frame is in an inner picture, which cuts it off there
    std::string out = text_at(left, top + 16, panel.title, "font-weight=\"600\"") +
                      element("svg", "", {{"x", left}, {"y", plot}, {"width", panel_width}, {"height", d.height}}) +
                      data_range("x", d.x_scale.low(), d.x_scale.high(), 6) +
                      data_range("y", d.y_scale.low(), d.y_scale.high(), 6) + " overflow=\"hidden\">\n" + background(d);
    for (const PlotLine& line : panel.lines) out += band(d, line);
    for (const PlotLine& line : panel.lines) out += line_and_marks(d, line);
    return {out + "</svg>\n<g transform=\"translate(" + point_text(left, plot) + ")\">\n" + legend + "</g>\n" +
                rectangle("frame", left, plot, panel_width, d.height) + axes(d, plot),
            plot + d.height + below};
}

}  // namespace

std::string svg(const Figure& figure) {
    constexpr double width = left + panel_width + margin;
    Part panels;
    std::vector<std::string> shown;
    for (const Panel& panel : figure.panels) {
        Part part = draw(panel, panels.low, shown);
        panels = {panels.svg + part.svg, part.low};
    }
    const auto lines_of = [&](const std::string& text, double character) {
        return document::wrapped(text, static_cast<std::size_t>(panel_width / character));
    };
    const auto title = lines_of(figure.title, 9.5), note = lines_of(figure.note, 6.8);
    std::vector<std::string> explanation;
    for (const std::string& sentence : figure.explanation)
        for (std::string& line : lines_of(sentence, 8)) explanation.push_back(std::move(line));
    const double below_title = 24 + height_of(title),
                 first = below_title + (explanation.empty() ? 0 : 8 + height_of(explanation)),
                 height = first + panels.low + 6 + height_of(note);
    const std::string name = escaped(figure.title), size = point_text(width, height);
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"fstiff\" viewBox=\"0 0 " + size + "\" width=\"" +
           px(width) + "\" height=\"" + px(height) + "\" role=\"img\" aria-label=\"" + name + "\">\n<title>" + name +
           "</title>\n" + style() + rectangle("back", 0, 0, width, height) +
           paragraph_at(left, 27, title, "class=\"title\"") +
           paragraph_at(left, below_title + 10, explanation, "class=\"brief\"") + "<g transform=\"translate(0 " +
           px(first) + ")\">\n" + panels.svg + "</g>\n" + paragraph_at(left, first + panels.low + 8, note, small_text) +
           "</svg>\n";
}

}  // namespace fstiff::cli
