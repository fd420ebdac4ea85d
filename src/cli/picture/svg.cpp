// SPDX-License-Identifier: BSD-3-Clause
// The figure as SVG: each part of a panel is drawn into coordinates of its own frame.
#include "picture/scale.hpp"

#include <fstiff/core/text.hpp>

#include <algorithm>
#include <array>

namespace fstiff::cli {
namespace {

struct Colour {
    const char *light, *dark;
};
constexpr std::array<Colour, 8> palette{{{"#b3261e", "#ff8a80"},
                                         {"#0b57a4", "#7db8ff"},
                                         {"#1b7f54", "#5ccf97"},
                                         {"#7a2f9e", "#dba4f5"},
                                         {"#b06000", "#ffb961"},
                                         {"#00737a", "#5fd4dc"},
                                         {"#9c2470", "#f59acb"},
                                         {"#6b6200", "#e0cf5a"}}};
constexpr Colour grey{"#5f5f66", "#a9a9b2"}, window_colour{"#8a7200", "#ffe28a"};
Range range_of(const Panel& panel, bool of_y) {
    Range range;
    const bool logarithmic = (of_y ? panel.y : panel.x).logarithmic;
    for (const PlotLine& line : panel.lines) {
        for (const auto* values : {of_y ? &line.y : &line.x, of_y ? &line.low : nullptr, of_y ? &line.high : nullptr})
            if (values)
                for (const double value : *values) range.add(value, logarithmic);
    }
    return range;
}

/// One sample and its text, whose lines are below one another.
struct Entry {
    const PlotLine* line;      ///< with its band, or
    const PlotWindow* window;  ///< a shaded window
    std::vector<std::string> text;
};

/// A panel with its scales.
struct Drawing {
    explicit Drawing(const Panel& drawn)
        : panel(drawn), x_scale(drawn.x, range_of(drawn, false)), y_scale(drawn.y, range_of(drawn, true)) {}
    double place_x(double x) const { return panel.width * x_scale(x); }
    bool shows(const PlotLine& line, std::size_t i) const {
        return x_scale.shows(line.x[i]) && y_scale.shows(line.y[i]);
    }
    double place_y(double y) const { return panel.height * (1 - y_scale(y)); }

    const Panel& panel;
    Scale x_scale, y_scale;
};

std::vector<Entry> legend_of(const Panel& panel) {
    std::vector<Entry> result;
    constexpr std::size_t most = 44;  // characters of a line
    for (const PlotLine& line : panel.lines)
        if (!line.label.empty())
            result.push_back({&line, nullptr, wrapped(line.label + (line.band.empty() ? "" : ", " + line.band), most)});
    for (const PlotWindow& window : panel.windows)
        if (!window.label.empty()) result.push_back({nullptr, &window, wrapped(window.label, most)});
    return result;
}

constexpr double left = 84, title_height = 26, below = 54, row_height = 24, line_height = 17, gap = 24;

/// \p text between the tags of SVG.
std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : scene::printable(text)) {
        if (c == '<')
            result += "&lt;";
        else if (c == '>')
            result += "&gt;";
        else if (c == '&')
            result += "&amp;";
        else if (c == '"')
            result += "&quot;";
        else
            result += c;
    }
    return result;
}

/// Pixels to a tenth, as short as can be.
std::string px(double value) {
    std::string text = parts::fixed_text(value, 1);
    if (text.ends_with(".0")) text.resize(text.size() - 2);
    return text == "-0" ? "0" : text;
}

using Attributes = std::initializer_list<std::pair<const char*, double>>;
std::string element(std::string_view name, std::string_view kind, const Attributes& attributes,
                    const std::string& data = "") {
    std::string text = "<" + std::string(name);
    if (!kind.empty()) text += " class=\"" + std::string(kind) + "\"";
    text += data;
    for (const auto& [key, value] : attributes) text += " " + std::string(key) + "=\"" + px(value) + "\"";
    return text + "/>\n";
}
std::string line_at(std::string_view kind, double x1, double y1, double x2, double y2) {
    return element("line", kind, {{"x1", x1}, {"y1", y1}, {"x2", x2}, {"y2", y2}});
}
std::string rectangle(std::string_view kind, double x, double y, double width, double height,
                      const std::string& data = "") {
    return element("rect", kind, {{"x", x}, {"y", y}, {"width", width}, {"height", height}}, data);
}
std::string text_at(double x, double y, std::string_view text, std::string_view attributes = "") {
    return "<text x=\"" + px(x) + "\" y=\"" + px(y) + "\"" + (attributes.empty() ? "" : " ") + std::string(attributes) +
           ">" + escaped(text) + "</text>\n";
}
std::string paragraph_at(double x, double y, const std::vector<std::string>& lines, std::string_view attributes = "") {
    std::string out;
    for (std::size_t i = 0; i < lines.size(); ++i)
        out += text_at(x, y + line_height * static_cast<double>(i), lines[i], attributes);
    return out;
}

/// Numbers in the units of the axes, for programs that read the picture.
std::string data_range(const char* name, double low, double high, int digits) {
    return std::string(" data-") + name + "=\"" + rounded(low, digits) + " " + rounded(high, digits) + "\"";
}

std::string colour_class(int colour) {
    return colour < 0 ? "cn" : "c" + std::to_string(colour % static_cast<int>(palette.size()));
}
std::string stroke_class(const PlotLine& line) { return colour_class(line.colour) + (line.dashed ? " dash" : ""); }

std::string mark(double x, double y) { return "<circle cx=\"" + px(x) + "\" cy=\"" + px(y) + "\" r=\"3.2\"/>"; }

std::string style() {
    // every rule is under .fstiff: several pictures share a page and its own rules stay its own
    std::string light =
        ".fstiff text{font:13px system-ui,'DejaVu Sans',sans-serif;fill:#1d1d1f}.fstiff .back{fill:#ffffff}"
        ".fstiff .grid{stroke:#d9d9de}.fstiff .fine{stroke:#eeeef1}.fstiff .frame{fill:none;stroke:#6b6b70}"
        ".fstiff .title{font-size:15px;font-weight:600}.fstiff .small{font-size:11px}"
        ".fstiff .line{fill:none;stroke-width:2;stroke-linejoin:round}.fstiff .dash{stroke-dasharray:7 4}"
        ".fstiff .dot{stroke-dasharray:2 4}.fstiff .bar{fill:none;stroke-width:1.4}.fstiff "
        ".band{stroke:none;opacity:.18}"
        ".fstiff .window{fill-opacity:.14;stroke-opacity:.7;fill:";
    light += std::string(window_colour.light) + "}";
    std::string dark =
        ".fstiff text{fill:#ececf1}.fstiff .back{fill:#16161a}.fstiff .grid{stroke:#3a3a42}.fstiff "
        ".fine{stroke:#26262c}"
        ".fstiff .frame{stroke:#9a9aa2}.fstiff .band{opacity:.26}.fstiff .window{fill-opacity:.18;fill:";
    dark += std::string(window_colour.dark) + "}";
    const auto add = [&](const std::string& name, const Colour& colour) {
        light += ".fstiff ." + name + "{stroke:" + colour.light + "}.fstiff .f" + name + "{fill:" + colour.light + "}";
        dark += ".fstiff ." + name + "{stroke:" + colour.dark + "}.fstiff .f" + name + "{fill:" + colour.dark + "}";
    };
    for (std::size_t i = 0; i < palette.size(); ++i) add("c" + std::to_string(i), palette[i]);
    add("cn", grey);
    return "<style>" + light + "@media screen and (prefers-color-scheme:dark){" + dark + "}</style>\n";
}

/// Background of the lines: shaded windows, changes of the law, the grid.
std::string background(const Drawing& d) {
    const Panel& panel = d.panel;
    const double width = panel.width, height = panel.height;
    std::string out;
    for (const PlotWindow& window : panel.windows) {
        const double high = std::clamp(d.place_y(window.high), 0.0, height),
                     low = std::clamp(d.place_y(window.low), 0.0, height);
        out += rectangle("window", 0, high, width, low - high, data_range("range", window.low, window.high, 15));
    }
    double y = height - 8;
    for (const PlotChange& change : panel.changes) {  // close ones have their names above one another
        const double x = d.place_x(change.x);
        out += line_at("line cn dot", x, 0, x, height);
        if (&change == &panel.changes.front())
            out += text_at(x - 6, y, change.before, "class=\"small\" text-anchor=\"end\"");
        out += text_at(x + 6, y, change.after, "class=\"small\"");
        y -= line_height;
    }
    const auto kind = [](const Tick& tick) { return tick.label.empty() ? "fine" : "grid"; };
    for (const Tick& tick : d.x_scale.ticks())
        out += line_at(kind(tick), d.place_x(tick.value), 0, d.place_x(tick.value), height);
    for (const Tick& tick : d.y_scale.ticks())
        out += line_at(kind(tick), 0, d.place_y(tick.value), width, d.place_y(tick.value));
    return out;
}

/// From the upper to the lower end, with a short line across both.
std::string bar(double x, double high, double low) {
    return "M" + px(x - 4) + " " + px(high) + "h8M" + px(x) + " " + px(high) + "V" + px(low) + "M" + px(x - 4) + " " +
           px(low) + "h8";
}

/// The bands, and the error bars of what has those.
std::string bands(const Drawing& d) {
    std::string out;
    for (const PlotLine& line : d.panel.lines) {
        if (line.low.size() != line.x.size() || line.high.size() != line.x.size() || line.x.empty()) continue;
        const auto low = [&](std::size_t i) {
            return d.y_scale.shows(line.low[i]) ? d.place_y(line.low[i]) : d.panel.height + 10;
        };
        std::string path;
        if (line.bars) {
            for (std::size_t i = 0; i < line.x.size(); ++i)
                if (d.shows(line, i)) path += bar(d.place_x(line.x[i]), d.place_y(line.high[i]), low(i));
            out += "<path class=\"bar " + colour_class(line.colour) + "\" d=\"" + path + "\"/>\n";
            continue;
        }
        for (std::size_t i = 0; i < line.x.size(); ++i)
            path += (i ? "L" : "M") + px(d.place_x(line.x[i])) + " " + px(d.place_y(line.high[i]));
        for (std::size_t i = line.x.size(); i-- > 0;) path += "L" + px(d.place_x(line.x[i])) + " " + px(low(i));
        out += "<path class=\"band f" + colour_class(line.colour) + "\" d=\"" + path + "Z\"/>\n";
    }
    return out;
}

/// One line, or its marks; one point, which no line shows, has a mark.
std::string line_and_marks(const Drawing& d, const PlotLine& line) {
    std::string path, marks;
    bool joined = false;
    for (std::size_t i = 0; i < line.x.size(); ++i) {
        if (!d.shows(line, i)) {
            joined = false;
            continue;
        }
        // far outside the frame is as good as anywhere there; numbers stay short
        const double x = std::clamp(d.place_x(line.x[i]), -1e4, 1e4), y = std::clamp(d.place_y(line.y[i]), -1e4, 1e4);
        path += (joined ? "L" : "M") + px(x) + " " + px(y);
        if (line.points || line.x.size() == 1) marks += mark(x, y);
        joined = true;
    }
    std::string out;
    if (!line.points && !path.empty()) out += "<path class=\"line " + stroke_class(line) + "\" d=\"" + path + "\"/>\n";
    if (!marks.empty()) out += "<g class=\"f" + colour_class(line.colour) + "\">" + marks + "</g>\n";
    return out;
}

/// Numbers and labels of both axes of a plot whose upper edge is at \p plot_top.
std::string axes(const Drawing& d, double plot_top) {
    const Panel& panel = d.panel;
    const double width = panel.width, height = panel.height;
    std::string out;
    for (const Tick& tick : d.x_scale.ticks())
        if (!tick.label.empty())
            out += text_at(left + d.place_x(tick.value), plot_top + height + 18, tick.label, "text-anchor=\"middle\"");
    for (const Tick& tick : d.y_scale.ticks())
        if (!tick.label.empty())
            out += text_at(left - 7, plot_top + d.place_y(tick.value) + 4.5, tick.label, "text-anchor=\"end\"");
    out += text_at(left + width / 2, plot_top + height + 40, d.x_scale.label(), "text-anchor=\"middle\"");
    return out + text_at(18, plot_top + height / 2, d.y_scale.label(),
                         "text-anchor=\"middle\" transform=\"rotate(-90 18 " + px(plot_top + height / 2) + ")\"");
}

double height_of(const std::vector<Entry>& legend) {
    double height = 0;
    for (const Entry& entry : legend) height += row_height + line_height * static_cast<double>(entry.text.size() - 1);
    return height;
}

std::string draw(const std::vector<Entry>& legend, double x, double y) {
    std::string out;
    for (const Entry& entry : legend) {
        if (entry.window)
            out += rectangle("window", x, y - 7, 30, 14);
        else {
            const std::string colour = colour_class(entry.line->colour);
            if (entry.line->bars)
                out += "<path class=\"bar " + colour + "\" d=\"" + bar(x + 15, y - 7, y + 7) + "\"/>\n";
            else if (!entry.line->band.empty())
                out += rectangle("band f" + colour, x, y - 7, 30, 14);
            out += line_at("line " + stroke_class(*entry.line), x, y, x + 30, y);
        }
        out += paragraph_at(x + 38, y + 4.5, entry.text);
        y += height_of({entry});
    }
    return out;
}

/// Size of a panel with its legend.
struct Size {
    double width, height;
};
Size size_of(const Panel& panel) {
    const std::vector<Entry> legend = legend_of(panel);
    std::size_t widest = 0;
    for (const Entry& entry : legend)
        for (const auto& text : entry.text) widest = std::max(widest, shown_width(text));
    const double title = panel.title.empty() ? 12 : title_height;
    return {left + panel.width + gap + 46 + 7.3 * static_cast<double>(widest),
            title + std::max(panel.height, height_of(legend)) + below};
}

/// One panel whose upper edge is at \p top.
std::string draw(const Panel& panel, double top) {
    const Drawing d(panel);
    std::string out;
    if (!panel.title.empty()) out += text_at(left, top + 16, panel.title, "font-weight=\"600\"");
    const double plot_top = top + (panel.title.empty() ? 12 : title_height);
    // what may reach beyond the frame is in an inner picture, which cuts it off there
    out += "<svg x=\"" + px(left) + "\" y=\"" + px(plot_top) + "\" width=\"" + px(panel.width) + "\" height=\"" +
           px(panel.height) + "\"" + data_range("x", d.x_scale.low(), d.x_scale.high(), 6) +
           data_range("y", d.y_scale.low(), d.y_scale.high(), 6) + " overflow=\"hidden\">\n" + background(d) + bands(d);
    for (const PlotLine& line : d.panel.lines) out += line_and_marks(d, line);
    out += "</svg>\n" + rectangle("frame", left, plot_top, panel.width, panel.height) + axes(d, plot_top);
    return out + draw(legend_of(panel), left + panel.width + gap, plot_top + 12);
}

}  // namespace

std::string svg(const Figure& figure) {
    const std::string name = escaped(figure.title);
    double width = 300;
    for (const Panel& panel : figure.panels) width = std::max(width, size_of(panel).width);
    const auto lines_of = [&](const std::string& text, double character) {
        return text.empty() ? std::vector<std::string>{}
                            : wrapped(text, static_cast<std::size_t>((width - left - 16) / character));
    };
    const auto title = lines_of(figure.title, 8.4), note = lines_of(figure.note, 6.3);
    std::vector<std::string> explanation;
    for (const std::string& sentence : figure.explanation)
        for (std::string& line : lines_of(sentence, 7.3)) explanation.push_back(std::move(line));
    const auto height_of_lines = [](const auto& lines) { return line_height * static_cast<double>(lines.size()); };
    const double below_title = 24 + height_of_lines(title);
    const double first = explanation.empty() ? below_title : below_title + 8 + height_of_lines(explanation);
    std::string panels;
    double top = first;
    for (const Panel& panel : figure.panels) {
        panels += draw(panel, top);
        top += size_of(panel).height;
    }
    const double height = top + (note.empty() ? 0 : 6 + line_height * static_cast<double>(note.size()));
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"fstiff\" viewBox=\"0 0 " + px(width) + " " + px(height) +
           "\" width=\"" + px(width) + "\" height=\"" + px(height) + "\" role=\"img\" aria-label=\"" + name +
           "\">\n<title>" + name + "</title>\n" + style() + rectangle("back", 0, 0, width, height) +
           paragraph_at(left, 27, title, "class=\"title\"") +
           paragraph_at(left, below_title + 10, explanation, "class=\"brief\"") + panels +
           paragraph_at(left, top + 8, note, "class=\"small\"") + "</svg>\n";
}

}  // namespace fstiff::cli
