// SPDX-License-Identifier: BSD-3-Clause
#include "picture/plot.hpp"

#include "document/output.hpp"

#include <fstiff/core/error.hpp>
#include <fstiff/core/text.hpp>

#include <fstiff/core/version.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <numeric>

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

/// Pixels to a tenth, as short as can be.
std::string px(double value) {
    std::string text = fixed_text(value, 1);
    if (text.ends_with(".0")) text.resize(text.size() - 2);
    return text == "-0" ? "0" : text;
}

/// Characters of UTF-8 text.
double characters(std::string_view text) {
    return static_cast<double>(std::count_if(text.begin(), text.end(),
                                             [](char c) { return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u; }));
}

/// 10 to the power \p exponent, in superscript digits.
std::string power_of_ten(int exponent) {
    if (exponent >= -2 && exponent <= 3) return shortest(std::pow(10.0, exponent));
    static constexpr std::array<const char*, 10> digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = "10";
    if (exponent < 0) text += "⁻";
    for (const char c : std::to_string(std::abs(exponent))) text += digits[static_cast<std::size_t>(c - '0')];
    return text;
}

struct Tick {
    double value;
    std::string label;  ///< empty: a fainter line without a number
};

/// An axis with its range: where a value stands, from 0 to 1, and its ticks.
class Scale {
public:
    Scale(const Axis& axis, double low, double high) : logarithmic_(axis.logarithmic) {
        const bool found = low <= high;
        if (!found) low = logarithmic_ ? 1 : 0, high = logarithmic_ ? 10 : 1;
        if (axis.low) low = *axis.low;
        if (axis.high) high = *axis.high;
        low_ = place(low), high_ = place(high);
        const double least = logarithmic_ ? 0.3 : 1e-9 * std::max(std::abs(low), 1e-300);
        if (!(high_ - low_ > least)) low_ -= std::max(least, 0.5 * least), high_ += std::max(least, 0.5 * least);
        const double space = 0.04 * (high_ - low_);
        if (!axis.low) low_ -= space;
        if (!axis.high) high_ += space;
    }
    bool shows(double value) const { return std::isfinite(value) && (!logarithmic_ || value > 0); }
    double operator()(double value) const { return (place(value) - low_) / (high_ - low_); }

    std::vector<Tick> ticks() const { return logarithmic_ ? decades() : steps(); }

private:
    double place(double value) const { return logarithmic_ ? std::log10(value) : value; }

    std::vector<Tick> decades() const {
        std::vector<Tick> result;
        const double span = high_ - low_;
        const int every = std::max(1, static_cast<int>(std::ceil(span / 9)));
        for (int k = static_cast<int>(std::floor(low_)); k <= static_cast<int>(std::ceil(high_)); ++k)
            for (int m = 1; m < 10; ++m) {
                const double at = k + std::log10(m);
                if (at < low_ - 1e-9 || at > high_ + 1e-9) continue;
                const bool numbered = m == 1 ? k % every == 0 : span < 1.6 && (m == 2 || m == 5);
                if (m > 1 && !numbered && span > 4.5) continue;
                std::string label;
                if (numbered)
                    label = m == 1              ? power_of_ten(k)
                            : k >= -2 && k <= 3 ? rounded(m * std::pow(10.0, k), 3)
                                                : std::to_string(m) + "·" + power_of_ten(k);
                result.push_back({m * std::pow(10.0, k), label});
            }
        return result;
    }

    std::vector<Tick> steps() const {
        const double raw = (high_ - low_) / 6, decade = std::pow(10.0, std::floor(std::log10(raw)));
        const double step = decade * (raw / decade <= 1 ? 1 : raw / decade <= 2 ? 2 : raw / decade <= 5 ? 5 : 10);
        std::vector<Tick> result;
        for (double k = std::ceil(low_ / step - 1e-9); k * step <= high_ + 1e-9 * step; ++k)
            result.push_back({k * step, k == 0 ? "0" : rounded(k * step, 6)});
        return result;
    }

    bool logarithmic_;
    double low_ = 0, high_ = 1;
};

/// Least and greatest of what sets the range of an axis.
struct Range {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    void add(double value, bool logarithmic) {
        if (!std::isfinite(value) || (logarithmic && !(value > 0))) return;
        low = std::min(low, value);
        high = std::max(high, value);
    }
};

std::string colour_class(int colour) {
    return colour < 0 ? "cn" : "c" + std::to_string(colour % static_cast<int>(palette.size()));
}

/// The lines of a panel with their colours settled.
std::vector<PlotLine> coloured(const Panel& panel) {
    std::vector<PlotLine> lines = panel.lines;
    int next = 0;
    for (PlotLine& line : lines)
        if (line.colour == next_colour) line.colour = next++;
    return lines;
}

std::string stroke_class(Stroke stroke) {
    return stroke == Stroke::dashed ? " dash" : stroke == Stroke::dotted ? " dot" : "";
}

std::string mark(Marker marker, double x, double y) {
    using Points = std::vector<std::pair<double, double>>;
    Points corners;
    switch (marker) {
        case Marker::none:
            return "";
        case Marker::circle:
            return "<circle cx=\"" + px(x) + "\" cy=\"" + px(y) + "\" r=\"3.2\"/>";
        case Marker::square:
            corners = {{-3, -3}, {3, -3}, {3, 3}, {-3, 3}};
            break;
        case Marker::triangle:
            corners = {{0, -4}, {3.8, 3}, {-3.8, 3}};
            break;
        case Marker::diamond:
            corners = {{0, -4.4}, {4.4, 0}, {0, 4.4}, {-4.4, 0}};
            break;
        case Marker::cross:
            corners = {{-1, -4}, {1, -4}, {1, -1}, {4, -1}, {4, 1},   {1, 1},
                       {1, 4},   {-1, 4}, {-1, 1}, {-4, 1}, {-4, -1}, {-1, -1}};
            break;
    }
    std::string text = "<polygon points=\"";
    for (std::size_t i = 0; i < corners.size(); ++i)
        text += (i ? " " : "") + px(x + corners[i].first) + "," + px(y + corners[i].second);
    return text + "\"/>";
}

std::string text_at(double x, double y, std::string_view text, std::string_view attributes = "") {
    return "<text x=\"" + px(x) + "\" y=\"" + px(y) + "\"" + (attributes.empty() ? "" : " ") + std::string(attributes) +
           ">" + escaped(text) + "</text>\n";
}

std::string line_at(std::string_view kind, double x1, double y1, double x2, double y2) {
    return "<line class=\"" + std::string(kind) + "\" x1=\"" + px(x1) + "\" y1=\"" + px(y1) + "\" x2=\"" + px(x2) +
           "\" y2=\"" + px(y2) + "\"/>\n";
}

std::string rectangle(std::string_view kind, double x, double y, double width, double height) {
    return "<rect class=\"" + std::string(kind) + "\" x=\"" + px(x) + "\" y=\"" + px(y) + "\" width=\"" + px(width) +
           "\" height=\"" + px(height) + "\"/>\n";
}

std::string style() {
    // every rule is under .fstiff: several pictures share a page and its own rules stay its own
    std::string light =
        ".fstiff text{font:13px system-ui,'DejaVu Sans',sans-serif;fill:#1d1d1f}.fstiff .back{fill:#ffffff}"
        ".fstiff .grid{stroke:#d9d9de}.fstiff .fine{stroke:#eeeef1}.fstiff .frame{fill:none;stroke:#6b6b70}"
        ".fstiff .title{font-size:15px;font-weight:600}.fstiff .small{font-size:11px}"
        ".fstiff .line{fill:none;stroke-width:2;stroke-linejoin:round}.fstiff .dash{stroke-dasharray:7 4}"
        ".fstiff .dot{stroke-dasharray:2 4}.fstiff .band{stroke:none;opacity:.18}"
        ".fstiff .window{fill:#8a7200;opacity:.14}";
    std::string dark =
        ".fstiff text{fill:#ececf1}.fstiff .back{fill:#16161a}.fstiff .grid{stroke:#3a3a42}.fstiff "
        ".fine{stroke:#26262c}"
        ".fstiff .frame{stroke:#9a9aa2}.fstiff .band{opacity:.26}.fstiff .window{fill:#ffe28a;opacity:.18}";
    const auto add = [&](const std::string& name, const Colour& colour) {
        light += ".fstiff ." + name + "{stroke:" + colour.light + "}.fstiff .f" + name + "{fill:" + colour.light + "}";
        dark += ".fstiff ." + name + "{stroke:" + colour.dark + "}.fstiff .f" + name + "{fill:" + colour.dark + "}";
    };
    for (std::size_t i = 0; i < palette.size(); ++i) add("c" + std::to_string(i), palette[i]);
    add("cn", {"#5f5f66", "#a9a9b2"});
    return "<style>" + light + "@media screen and (prefers-color-scheme:dark){" + dark + "}</style>\n";
}

constexpr double left = 84, title_height = 26, below = 54, row = 24, gap = 24;

/// Lines of the legend: marker and text.
struct Entry {
    const PlotLine* line;      ///< or
    const PlotWindow* window;  ///< a shaded window, or
    bool band;                 ///< the band of the line
    std::string text;
};

std::vector<Entry> entries(const Panel& panel, const std::vector<PlotLine>& lines) {
    std::vector<Entry> result;
    if (!panel.legend) return result;
    for (const PlotLine& line : lines) {
        if (!line.label.empty()) result.push_back({&line, nullptr, false, line.label});
        if (!line.band.empty()) result.push_back({&line, nullptr, true, line.band});
    }
    for (const PlotWindow& window : panel.windows)
        if (!window.label.empty()) result.push_back({nullptr, &window, false, window.label});
    return result;
}

double legend_width(const Panel& panel) {
    double widest = 0;
    const std::vector<PlotLine> lines = coloured(panel);
    for (const Entry& entry : entries(panel, lines)) widest = std::max(widest, characters(entry.text));
    return widest > 0 ? 46 + 7.3 * widest : 0;
}

double panel_height(const Panel& panel) {
    const std::vector<PlotLine> lines = coloured(panel);
    return (panel.title.empty() ? 12 : title_height) +
           std::max(panel.height, row * static_cast<double>(entries(panel, lines).size())) + below;
}

/// A panel with its scales; the functions below draw its parts, each into coordinates of its own frame.
struct Drawing {
    const Panel& panel;
    std::vector<PlotLine> lines;
    Scale x_scale, y_scale;
    double width, height;

    double place_x(double x) const { return width * x_scale(x); }
    double place_y(double y) const { return height * (1 - y_scale(y)); }
};

Drawing drawing_of(const Panel& panel) {
    const std::vector<PlotLine> lines = coloured(panel);
    Range x_range, y_range;
    for (const PlotLine& line : lines) {
        if (!line.sets_range) continue;
        for (const double x : line.x) x_range.add(x, panel.x.logarithmic);
        for (const auto* values : {&line.y, &line.low, &line.high})
            for (const double y : *values) y_range.add(y, panel.y.logarithmic);
    }
    if (panel.image) {
        for (const double x : {panel.image->x_low, panel.image->x_high}) x_range.add(x, panel.x.logarithmic);
        for (const double y : {panel.image->y_low, panel.image->y_high}) y_range.add(y, panel.y.logarithmic);
    }
    return {
        panel,       lines,       Scale(panel.x, x_range.low, x_range.high), Scale(panel.y, y_range.low, y_range.high),
        panel.width, panel.height};
}

/// What lies behind the lines: an image, shaded windows, the grid.
std::string background(const Drawing& d) {
    const Panel& panel = d.panel;
    const double width = d.width, height = d.height;
    const auto place_x = [&](double x) { return d.place_x(x); };
    const auto place_y = [&](double y) { return d.place_y(y); };
    std::string out;
    if (panel.image) {
        const PlotImage& image = *panel.image;
        out += "<image x=\"" + px(place_x(image.x_low)) + "\" y=\"" + px(place_y(image.y_high)) + "\" width=\"" +
               px(place_x(image.x_high) - place_x(image.x_low)) + "\" height=\"" +
               px(place_y(image.y_low) - place_y(image.y_high)) +
               "\" preserveAspectRatio=\"none\" href=\"data:image/png;base64," + base64(image.png) + "\"/>\n";
    }
    for (const PlotWindow& window : panel.windows) {
        const auto bounded = [](double at, double size) { return std::clamp(at, 0.0, size); };
        if (window.of_y) {
            const double high = bounded(place_y(window.high), height), low = bounded(place_y(window.low), height);
            out += rectangle("window", 0, high, width, low - high);
        } else {
            const double low = bounded(place_x(window.low), width), high = bounded(place_x(window.high), width);
            out += rectangle("window", low, 0, high - low, height);
        }
    }
    if (!panel.image) {
        for (const Tick& tick : d.x_scale.ticks())
            out += line_at(tick.label.empty() ? "fine" : "grid", place_x(tick.value), 0, place_x(tick.value), height);
        for (const Tick& tick : d.y_scale.ticks())
            out += line_at(tick.label.empty() ? "fine" : "grid", 0, place_y(tick.value), width, place_y(tick.value));
    }
    return out;
}

std::string bands(const Drawing& d) {
    std::string out;
    for (const PlotLine& line : d.lines) {
        if (line.low.size() != line.x.size() || line.high.size() != line.x.size()) continue;
        std::string path;
        for (std::size_t i = 0; i < line.x.size(); ++i)
            path += (i ? "L" : "M") + px(d.place_x(line.x[i])) + " " + px(d.place_y(line.high[i]));
        for (std::size_t i = line.x.size(); i-- > 0;)
            path += "L" + px(d.place_x(line.x[i])) + " " +
                    px(d.y_scale.shows(line.low[i]) ? d.place_y(line.low[i]) : d.height + 10);
        out += "<path class=\"band f" + colour_class(line.colour) + "\" d=\"" + path + "Z\"/>\n";
    }
    return out;
}

std::string lines_and_marks(const Drawing& d) {
    std::string out;
    for (const PlotLine& line : d.lines) {
        std::string path, marks;
        bool pen_down = false;
        for (std::size_t i = 0; i < line.x.size(); ++i) {
            if (!d.x_scale.shows(line.x[i]) || !d.y_scale.shows(line.y[i])) {
                pen_down = false;
                continue;
            }
            // far outside the frame is as good as anywhere there; numbers stay short
            const double x = std::clamp(d.place_x(line.x[i]), -1e4, 1e4),
                         y = std::clamp(d.place_y(line.y[i]), -1e4, 1e4);
            path += (pen_down ? "L" : "M") + px(x) + " " + px(y);
            marks += mark(line.marker, x, y);
            pen_down = true;
        }
        if (line.stroke != Stroke::none && !path.empty())
            out += "<path class=\"line " + colour_class(line.colour) + stroke_class(line.stroke) + "\" d=\"" + path +
                   "\"/>\n";
        if (!marks.empty()) out += "<g class=\"f" + colour_class(line.colour) + "\">" + marks + "</g>\n";
    }
    return out;
}

/// Numbers and labels of both axes of a plot whose upper edge is at \p plot_top.
std::string axes(const Drawing& d, double plot_top) {
    const Panel& panel = d.panel;
    const double width = d.width, height = d.height;
    std::string out;
    for (const Tick& tick : d.x_scale.ticks())
        if (panel.x.ticks && !tick.label.empty())
            out += text_at(left + d.place_x(tick.value), plot_top + height + 18, tick.label, "text-anchor=\"middle\"");
    for (const Tick& tick : d.y_scale.ticks())
        if (panel.y.ticks && !tick.label.empty())
            out += text_at(left - 7, plot_top + d.place_y(tick.value) + 4.5, tick.label, "text-anchor=\"end\"");
    out += text_at(left + width / 2, plot_top + height + 40, panel.x.label, "text-anchor=\"middle\"");
    const std::string middle = px(plot_top + height / 2);
    out += text_at(18, plot_top + height / 2, panel.y.label,
                   "text-anchor=\"middle\" transform=\"rotate(-90 18 " + middle + ")\"");
    return out;
}

std::string legend(const Drawing& d, double plot_top) {
    std::string out;
    double y = plot_top + 12;
    const double x = left + d.width + gap;
    for (const Entry& entry : entries(d.panel, d.lines)) {
        if (entry.window)
            out += rectangle("window", x, y - 7, 30, 14);
        else if (entry.band)
            out += rectangle("band f" + colour_class(entry.line->colour), x, y - 7, 30, 14);
        else {
            if (entry.line->stroke != Stroke::none)
                out += line_at("line " + colour_class(entry.line->colour) + stroke_class(entry.line->stroke), x, y,
                               x + 30, y);
            if (entry.line->marker != Marker::none)
                out += "<g class=\"f" + colour_class(entry.line->colour) + "\">" + mark(entry.line->marker, x + 15, y) +
                       "</g>\n";
        }
        out += text_at(x + 38, y + 4.5, entry.text);
        y += row;
    }
    return out;
}

/// One panel whose upper edge is at \p top.
std::string draw(const Panel& panel, double top) {
    const Drawing d = drawing_of(panel);
    std::string out;
    if (!panel.title.empty()) out += text_at(left, top + 16, panel.title, "font-weight=\"600\"");
    const double plot_top = top + (panel.title.empty() ? 12 : title_height);
    // what may reach beyond the frame stands in an inner picture, which cuts it off there
    out += "<svg x=\"" + px(left) + "\" y=\"" + px(plot_top) + "\" width=\"" + px(d.width) + "\" height=\"" +
           px(d.height) + "\" overflow=\"hidden\">\n" + background(d) + bands(d) + lines_and_marks(d);
    return out + "</svg>\n" + rectangle("frame", left, plot_top, d.width, d.height) + axes(d, plot_top) +
           legend(d, plot_top);
}

std::string quoted(const std::string& text, char quote, const char* escaped_quote) {
    std::string result(1, quote);
    for (const char c : text)
        if (c == quote)
            result += escaped_quote;
        else
            result += static_cast<unsigned char>(c) < 32 ? ' ' : c;
    return result + quote;
}

/// In a script of gnuplot: between single quotes nothing but the quote itself means anything.
std::string for_gnuplot(const std::string& text) { return quoted(text, '\'', "''"); }

// ---------------------------------------------------------------- PNG

std::uint32_t crc32(std::string_view bytes) {
    std::uint32_t crc = 0xFFFFFFFFu;
    for (const char c : bytes) {
        crc ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ (crc & 1u ? 0xEDB88320u : 0u);
    }
    return ~crc;
}

std::string big_endian(std::uint32_t value) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(static_cast<unsigned char>(value >> shift));
    return bytes;
}

std::string chunk(const std::string& name, const std::string& data) {
    return big_endian(static_cast<std::uint32_t>(data.size())) + name + data + big_endian(crc32(name + data));
}

/// \p data as a zlib stream of stored blocks (RFC 1950, 1951): not smaller, but needs no library.
std::string stored(const std::string& data) {
    std::string out = "\x78\x01";
    std::uint32_t a = 1, b = 0;
    for (const char c : data) {
        a = (a + static_cast<unsigned char>(c)) % 65521u;
        b = (b + a) % 65521u;
    }
    for (std::size_t at = 0;;) {
        const std::size_t size = std::min<std::size_t>(65535, data.size() - at);
        const bool last = at + size == data.size();
        for (const std::size_t byte : {std::size_t(last), size & 255u, size >> 8, ~size & 255u, (~size >> 8) & 255u})
            out += static_cast<char>(static_cast<unsigned char>(byte));
        out += data.substr(at, size);
        at += size;
        if (last) break;
    }
    return out + big_endian(b << 16 | a);
}

/// Red, green, blue of a share of the range: dark blue over green to yellow, of rising lightness.
std::array<int, 3> heat(double share) {
    static constexpr std::array<std::array<double, 3>, 5> stops{
        {{38, 22, 78}, {44, 84, 134}, {38, 144, 134}, {126, 196, 84}, {250, 230, 80}}};
    const double at = std::clamp(share, 0.0, 1.0) * (stops.size() - 1);
    const auto k = std::min<std::size_t>(static_cast<std::size_t>(at), stops.size() - 2);
    std::array<int, 3> rgb{};
    for (std::size_t i = 0; i < 3; ++i)
        rgb[i] = static_cast<int>(std::lround(std::lerp(stops[k][i], stops[k + 1][i], at - static_cast<double>(k))));
    return rgb;
}

}  // namespace

std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (c == '<')
            result += "&lt;";
        else if (c == '>')
            result += "&gt;";
        else if (c == '&')
            result += "&amp;";
        else if (c == '"')
            result += "&quot;";
        else
            result += static_cast<unsigned char>(c) < 32 ? ' ' : c;
    }
    return result;
}

std::string svg(const Figure& figure) {
    double width = 0, height = figure.title.empty() ? 6 : 40;
    for (const Panel& panel : figure.panels) {
        const double legend = legend_width(panel);
        width = std::max(width, left + panel.width + (legend > 0 ? gap + legend : 24));
        height += panel_height(panel);
    }
    width = std::max({width, left + 16 + 8.2 * characters(figure.title), left + 16 + 6.1 * characters(figure.note)});
    if (!figure.note.empty()) height += 22;
    const std::string size = px(width) + " " + px(height);
    std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"fstiff\" viewBox=\"0 0 " + size +
                      "\" width=\"" + px(width) + "\" height=\"" + px(height) + "\" role=\"img\" aria-label=\"" +
                      escaped(figure.title) + "\">\n<title>" + escaped(figure.title) + "</title>\n" + style() +
                      rectangle("back", 0, 0, width, height);
    double top = 6;
    if (!figure.title.empty()) {
        out += text_at(left, 27, figure.title, "class=\"title\"");
        top = 40;
    }
    for (const Panel& panel : figure.panels) {
        out += draw(panel, top);
        top += panel_height(panel);
    }
    if (!figure.note.empty()) out += text_at(left, top + 8, figure.note, "class=\"small\"");
    return out + "</svg>\n";
}

std::string html_page(const Figure& figure) {
    return "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" + escaped(figure.title) +
           "</title>\n<style>:root{color-scheme:light dark}body{margin:1rem}@media screen and "
           "(prefers-color-scheme:dark){body{background:#16161a}}svg{max-width:100%;height:auto}</style></head>\n"
           "<body>\n" +
           svg(figure) + "</body></html>\n";
}

std::string figure_csv(const Figure& figure) {
    std::string text = "# fstiff " FSTIFF_VERSION ": the numbers of a picture\n" +
                       csv_line({"curve", "panel", "label", "x_quantity", "x", "y_quantity", "y", "low", "high"});
    const auto cell = [](const std::string& s) { return quoted(s, '"', "\"\""); };
    std::size_t curve = 0;
    for (std::size_t p = 0; p < figure.panels.size(); ++p) {
        const Panel& panel = figure.panels[p];
        for (const PlotLine& line : panel.lines) {
            ++curve;
            for (std::size_t i = 0; i < line.x.size(); ++i)
                text += csv_line({std::to_string(curve), std::to_string(p + 1), cell(line.label), cell(panel.x.label),
                                  exact(line.x[i]), cell(panel.y.label), exact(line.y[i]),
                                  line.low.empty() ? "" : exact(line.low[i]),
                                  line.high.empty() ? "" : exact(line.high[i])});
        }
    }
    return text;
}

std::string gnuplot_script(const Figure& figure, const std::string& csv, const std::string& picture) {
    double height = 40;
    for (const Panel& panel : figure.panels) height += panel_height(panel);
    std::string text = "# fstiff " FSTIFF_VERSION ": draws the numbers of " + csv + " with gnuplot" +
                       "\n"
                       "set terminal svg noenhanced size 900," +
                       px(std::round(height)) + "\nset output " + for_gnuplot(picture) +
                       "\nset datafile separator ','\nset encoding utf8\nset grid\nset key outside right top\n"
                       "set multiplot layout " +
                       std::to_string(figure.panels.size()) + ",1 title " + for_gnuplot(figure.title) + "\n";
    std::size_t curve = 0;
    for (const Panel& panel : figure.panels) {
        text += "set title " + for_gnuplot(panel.title) + "\nset xlabel " + for_gnuplot(panel.x.label) +
                "\nset ylabel " + for_gnuplot(panel.y.label) + "\n";
        text += std::string(panel.x.logarithmic ? "set" : "unset") + " logscale x\n" +
                (panel.y.logarithmic ? "set" : "unset") + " logscale y\n";
        const auto range = [](const char* name, const Axis& axis) {
            return std::string("set ") + name + " [" + (axis.low ? shortest(*axis.low) : "*") + ":" +
                   (axis.high ? shortest(*axis.high) : "*") + "]\n";
        };
        text += range("xrange", panel.x) + range("yrange", panel.y) + "unset object\n";
        for (std::size_t i = 0; i < panel.windows.size(); ++i) {
            const PlotWindow& window = panel.windows[i];
            const std::string low = shortest(window.low), high = shortest(window.high);
            text += "set object " + std::to_string(i + 1) + " rectangle from " +
                    (window.of_y ? "graph 0,first " + low + " to graph 1,first " + high
                                 : "first " + low + ",graph 0 to first " + high + ",graph 1") +
                    " fillcolor rgb '#8a7200' fillstyle solid 0.14 noborder behind  # " + window.label + "\n";
        }
        std::string plots;
        for (const PlotLine& line : coloured(panel)) {
            ++curve;
            const auto column = [&](int n) {
                return "($1==" + std::to_string(curve) + "?$" + std::to_string(n) + ":NaN)";
            };
            const auto add = [&](const std::string& what) {
                plots += (plots.empty() ? "plot " : ", \\\n     ") + for_gnuplot(csv) + " skip 2 using " + what;
            };
            const std::string colour =
                line.colour < 0 ? "#5f5f66" : palette[static_cast<std::size_t>(line.colour) % palette.size()].light;
            if (!line.low.empty())
                add(column(5) + ":8:9 with filledcurves fillcolor rgb '" + colour +
                    "' fillstyle transparent solid 0.18 title " + for_gnuplot(line.band));
            const std::string dash = line.stroke == Stroke::dashed   ? " dashtype 2"
                                     : line.stroke == Stroke::dotted ? " dashtype 3"
                                                                     : "";
            const std::string with = line.stroke == Stroke::none   ? "points"
                                     : line.marker == Marker::none ? "lines"
                                                                   : "linespoints";
            add(column(5) + ":7 with " + with + " linecolor rgb '" + colour + "'" + (with == "points" ? "" : dash) +
                (line.label.empty() ? " notitle" : " title " + for_gnuplot(line.label)));
        }
        text += plots.empty() ? "plot NaN notitle\n" : plots + "\n";
    }
    return text + "unset multiplot\n";
}

PictureFiles::PictureFiles(const std::string& file) : picture(file) {
    const std::filesystem::path path(file);
    if (path.extension() != ".svg" && path.extension() != ".html")
        throw Usage("--plot = \"" + file +
                    "\": must end in .svg or .html; the numbers (.plot.csv) and a script (.plot.gp) are written "
                    "beside it");
    table = std::filesystem::path(path).replace_extension(".plot.csv").string();
    script = std::filesystem::path(path).replace_extension(".plot.gp").string();
}

void keep_for_picture(const std::string& file) {
    const PictureFiles names(file);
    require_writable(file);
    require_own(names.table);
    require_own(names.script);
    for (const std::string& name : names.all()) keep_for_output(name);
}

std::vector<OutputFile> figure_files(const Figure& figure, const std::string& file) {
    const PictureFiles names(file);
    const std::filesystem::path path(file);
    return {{names.picture, path.extension() == ".svg" ? svg(figure) : html_page(figure)},
            {names.table, figure_csv(figure)},
            {names.script, gnuplot_script(figure, std::filesystem::path(names.table).filename().string(),
                                          path.stem().string() + "-gnuplot.svg")}};
}

std::vector<std::string> write_figure(const Figure& figure, const std::string& file) {
    deliver(figure_files(figure, file));
    return PictureFiles(file).all();
}

std::string heat_map_colour(double share) {
    std::string text = "#";
    for (const int value : heat(share))
        for (const int nibble : {value / 16, value % 16}) text += "0123456789abcdef"[nibble];
    return text;
}

std::string heat_map_png(const std::vector<unsigned char>& shade, std::size_t columns, std::size_t rows) {
    std::string header = big_endian(static_cast<std::uint32_t>(columns)) + big_endian(static_cast<std::uint32_t>(rows));
    header += std::string("\x08\x03\x00\x00\x00", 5);  // 8 bits, indexed
    std::string colours, lines;
    for (int i = 0; i < 255; ++i)
        for (const int value : heat(i / 254.0)) colours += static_cast<char>(static_cast<unsigned char>(value));
    colours += "\x80\x80\x80";
    for (std::size_t j = 0; j < rows; ++j) {
        lines += '\0';  // no filter
        for (std::size_t i = 0; i < columns; ++i) lines += static_cast<char>(shade[j * columns + i]);
    }
    const std::string clear = std::string(255, '\xFF') + '\0';  // missing points are transparent
    return "\x89PNG\r\n\x1a\n" + chunk("IHDR", header) + chunk("PLTE", colours) + chunk("tRNS", clear) +
           chunk("IDAT", stored(lines)) + chunk("IEND", "");
}

std::string base64(std::string_view bytes) {
    static constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k) text += i + k > bytes.size() ? '=' : digits[group >> (18 - 6 * k) & 63u];
    }
    return text;
}

}  // namespace fstiff::cli
