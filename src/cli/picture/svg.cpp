// SPDX-License-Identifier: BSD-3-Clause
// The figure as SVG: each panel is drawn into coordinates of its own.
#include "picture/plot.hpp"

#include <fstiff/core/text.hpp>

#include <algorithm>
#include <array>
#include <limits>

namespace fstiff::cli {

namespace {

/// 10 to the power \p exponent, in superscript digits.
std::string power_of_ten(int exponent) {
    static constexpr std::array<const char*, 10> digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = exponent < 0 ? "10⁻" : "10";
    for (const char c : std::to_string(std::abs(exponent))) text += digits[static_cast<std::size_t>(c - '0')];
    return text;
}

}  // namespace

Scale::Scale(const Axis& axis, const std::vector<double>& values) : logarithmic_(axis.logarithmic) {
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (const double value : values)
        if (shows(value)) least = std::min(least, value), most = std::max(most, value);
    if (!(least <= most)) least = logarithmic_ ? 1 : 0, most = logarithmic_ ? 10 : 1;
    low_ = place(axis.low.value_or(least)), high_ = place(axis.high.value_or(most));
    // at least two numbers are on a logarithmic axis, and seven digits distinguish those of a linear one
    const double span = logarithmic_ ? 0.7 : std::max(1e-6 * std::max(std::abs(low_), std::abs(high_)), 1e-300);
    const double lack = std::max(0.0, span - (high_ - low_)) / 2, space = 0.04 * (high_ - low_ + 2 * lack);
    low_ -= lack + (axis.low ? 0 : space);
    high_ += lack + (axis.high ? 0 : space);
}

std::vector<Tick> Scale::decades() const {
    std::vector<Tick> result;
    const double span = high_ - low_;
    const int every = std::max(1, static_cast<int>(std::ceil(span / 9)));
    const int first = static_cast<int>(std::floor(low_)), last = static_cast<int>(std::ceil(high_));
    const bool plain = low_ > -3.5 && high_ < 4.5;  // else all of them are powers
    for (int k = first; k <= last; ++k)
        for (int m = 1; m < 10; ++m) {
            const double exponent = k + std::log10(m);
            if (exponent < low_ - 1e-9 || exponent > high_ + 1e-9) continue;
            const bool numbered = m == 1       ? k % every == 0
                                  : span < 0.8 ? m < 6 || m == 7
                                               : span < 2 && (m == 2 || m == 5);
            if (m > 1 && !numbered && span > 4.5) continue;
            const double value = m * std::pow(10.0, k);
            result.push_back({value, !numbered ? ""
                                     : plain   ? detail::fixed_text(value, std::max(0, -k))
                                     : m == 1  ? power_of_ten(k)
                                               : std::to_string(m) + "·" + power_of_ten(k)});
        }
    return result;
}

std::vector<Tick> Scale::steps() const {
    const double raw = (high_ - low_) / 6, decade = std::pow(10.0, std::floor(std::log10(raw))), part = raw / decade,
                 width = decade * (part <= 1   ? 1
                                   : part <= 2 ? 2
                                   : part <= 5 ? 5
                                               : 10);
    const int decimals = std::max(0, -static_cast<int>(std::floor(std::log10(width) + 1e-9)));
    std::vector<Tick> result;
    for (double k = std::ceil(low_ / width - 1e-9); k * width <= high_ + 1e-9 * width; ++k)
        result.push_back({k * width, detail::fixed_text(k == 0 ? 0.0 : k * width, decimals)});
    return result;
}

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
constexpr double left = 84, panel_width = 560, title_height = 26, below = 54, row_height = 24, line_height = 17,
                 gap = 24;
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
.fstiff .band{stroke:none;opacity:.18}.fstiff .window{fill-opacity:.14;fill:#8a7200}
)";
    std::string dark = R"(
.fstiff text{fill:#ececf1}.fstiff .back{fill:#16161a}.fstiff .frame{stroke:#9a9aa2}
.fstiff .grid{stroke:#3a3a42}.fstiff .fine{stroke:#26262c}
.fstiff .band{opacity:.26}.fstiff .window{fill-opacity:.18;fill:#ffe28a}
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
    double x(double value) const { return panel_width * x_scale(value); }
    double y(double value) const { return panel.height * (1 - y_scale(value)); }
    bool shows(const PlotLine& line, std::size_t i) const {
        return x_scale.shows(line.x[i]) && y_scale.shows(line.y[i]);
    }

    const Panel& panel;
    Scale x_scale, y_scale;
};

/// Background of the lines: the shaded window, changes of the law, the grid.
std::string background(const Drawing& d) {
    const double height = d.panel.height;
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
                     low = d.y_scale.shows(line.low[i]) ? d.y(line.low[i]) : d.panel.height + 10;
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
    const double height = d.panel.height, middle = top + height / 2;
    std::string out;
    for (const Tick& tick : d.x_scale.ticks())
        if (!tick.label.empty()) out += text_at(left + d.x(tick.value), top + height + 18, tick.label, at_middle);
    for (const Tick& tick : d.y_scale.ticks())
        if (!tick.label.empty()) out += text_at(left - 7, top + d.y(tick.value) + 4.5, tick.label, at_end);
    return out + text_at(left + panel_width / 2, top + height + 40, d.panel.x.label, at_middle) +
           text_at(18, middle, d.panel.y.label,
                   at_middle + " transform=\"rotate(-90 " + point_text(18, middle) + ")\"");
}

/// A part of the picture, and the coordinates of its right and lower ends.
struct Part {
    std::string svg;
    double right = 0, low = 0;
};

/// Samples of the lines and of the window of \p panel with their names.
Part legend(const Panel& panel, double x, double y) {
    Part part{"", x, y};
    const auto add = [&](const std::string& sample, const std::string& name) {
        const std::vector<std::string> text = document::wrapped(name, 44);
        part.svg += sample + paragraph_at(x + 38, part.low + 4.5, text);
        part.low += row_height - line_height + height_of(text);
        for (const std::string& line : text)
            part.right = std::max(part.right, x + 46 + 7.3 * static_cast<double>(document::shown_width(line)));
    };
    for (const PlotLine& line : panel.lines) {
        if (line.label.empty()) continue;
        const double point_text = part.low;
        const std::string band = line.bars
                                     ? path_of("bar " + colour_of(line), bar(x + 15, point_text - 7, point_text + 7))
                                 : line.band.empty() ? ""
                                                     : rectangle("band f" + colour_of(line), x, point_text - 7, 30, 14);
        add(band + line_at(stroke_of(line), x, point_text, x + 30, point_text),
            line.label + (line.band.empty() ? "" : ", " + line.band));
    }
    if (panel.window) add(rectangle("window", x, part.low - 7, 30, 14), panel.window->label);
    return part;
}

/// One panel whose upper edge is at \p top.
Part draw(const Panel& panel, double top) {
    const Drawing d(panel);
    const double plot = top + title_height;
    Part part = legend(panel, left + panel_width + gap, plot + 12);
    // what may reach beyond the frame is in an inner picture, which cuts it off there
    std::string out = text_at(left, top + 16, panel.title, "font-weight=\"600\"") +
                      element("svg", "", {{"x", left}, {"y", plot}, {"width", panel_width}, {"height", panel.height}}) +
                      data_range("x", d.x_scale.low(), d.x_scale.high(), 6) +
                      data_range("y", d.y_scale.low(), d.y_scale.high(), 6) + " overflow=\"hidden\">\n" + background(d);
    for (const PlotLine& line : panel.lines) out += band(d, line);
    for (const PlotLine& line : panel.lines) out += line_and_marks(d, line);
    part.svg = out + "</svg>\n" + rectangle("frame", left, plot, panel_width, panel.height) + axes(d, plot) + part.svg;
    part.low = std::max(plot + panel.height, part.low - 12) + below;
    return part;
}

}  // namespace

std::string svg(const Figure& figure) {
    Part panels;
    for (const Panel& panel : figure.panels) {
        Part part = draw(panel, panels.low);
        panels = {panels.svg + part.svg, std::max(panels.right, part.right), part.low};
    }
    const auto lines_of = [&](const std::string& text, double character) {
        return document::wrapped(text, static_cast<std::size_t>((panels.right - left - 16) / character));
    };
    const auto title = lines_of(figure.title, 8.4), note = lines_of(figure.note, 6.3);
    std::vector<std::string> explanation;
    for (const std::string& sentence : figure.explanation)
        for (std::string& line : lines_of(sentence, 7.3)) explanation.push_back(std::move(line));
    const double below_title = 24 + height_of(title),
                 first = below_title + (explanation.empty() ? 0 : 8 + height_of(explanation)),
                 height = first + panels.low + 6 + height_of(note);
    const std::string name = escaped(figure.title), size = point_text(panels.right, height);
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"fstiff\" viewBox=\"0 0 " + size + "\" width=\"" +
           px(panels.right) + "\" height=\"" + px(height) + "\" role=\"img\" aria-label=\"" + name + "\">\n<title>" +
           name + "</title>\n" + style() + rectangle("back", 0, 0, panels.right, height) +
           paragraph_at(left, 27, title, "class=\"title\"") +
           paragraph_at(left, below_title + 10, explanation, "class=\"brief\"") + "<g transform=\"translate(0 " +
           px(first) + ")\">\n" + panels.svg + "</g>\n" + paragraph_at(left, first + panels.low + 8, note, small_text) +
           "</svg>\n";
}

}  // namespace fstiff::cli
