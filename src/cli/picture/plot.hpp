// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Pictures of curves as SVG that needs nothing else: no script, no font, no other file. Colours follow the reader's
// light or dark setting. The same figure is written as CSV. The same figure gives the same bytes.
//
// svg.cpp draws it; scale.hpp chooses its ticks, drawing.hpp its colours and legend; raster.cpp makes maps.

#include "document/output.hpp"
#include "document/shown_unit.hpp"

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fstiff::cli {

struct Axis {
    std::string label;  ///< with its unit, such as "p [MPa]", unless si is given
    bool logarithmic = true;
    std::optional<double> low = {}, high = {};  ///< none: from the curves
    bool ticks = true;
    std::string si = {};  ///< unit of the values, such as "Pa": the picture chooses nm or mm and adds it to the label
    std::optional<ShownUnit> unit = {};  ///< of \p si, where something next to the picture has chosen one
};

enum class Stroke { solid, dashed, dotted, none };
enum class Marker { none, circle, square, triangle, diamond, cross };

/// Colours 0 to 7 distinguish curves; `neutral` is the grey of references.
inline constexpr int neutral = -1, next_colour = -2;

/// Points, a line through them, and a band about it when low and high are given. On a logarithmic axis a point that is
/// not positive breaks the line.
struct PlotLine {
    std::string label;  ///< empty: not in the legend
    std::vector<double> x, y;
    std::vector<double> low = {}, high = {};  ///< of the band, one for every x
    std::string band = {};                    ///< what the band is, for the legend
    bool bars = false;                        ///< an error bar at every point in place of the band
    int colour = next_colour;
    Stroke stroke = Stroke::solid;
    Marker marker = Marker::none;
    bool sets_range = true;  ///< whether the axes are chosen to show it
    int covered = 0;         ///< how many lines lie on it, which is drawn the wider for it; svg() finds those
    double aside = 0;        ///< pixels to the right, which svg() chooses where all points have one place
};

/// A curve of \p size points.
template <class X, class Y>
PlotLine line_of(std::string label, std::size_t size, const X& x, const Y& y) {
    PlotLine line{.label = std::move(label), .x = {}, .y = {}};
    for (std::size_t k = 0; k < size; ++k) {
        line.x.push_back(x(k));
        line.y.push_back(y(k));
    }
    return line;
}

/// A shaded range of the horizontal or of the vertical axis, drawn over the lines \p from to \p to.
struct PlotWindow {
    std::string label;
    double low = 0, high = 0;
    bool of_y = false;
    int colour = next_colour;  ///< that of the line it belongs to; else one of its own
};

/// A BMP that fills a range of the axes.
struct PlotImage {
    std::string bmp;  ///< bytes
    double x_low = 0, x_high = 1, y_low = 0, y_high = 1;
};

struct Panel {
    std::string title = {};
    Axis x, y;
    std::vector<PlotLine> lines = {};
    std::vector<PlotWindow> windows = {};
    std::optional<PlotImage> image = {};
    double width = 560, height = 360;  ///< of the plot itself
    bool legend = true;
};

struct Figure {
    std::string title;
    std::vector<std::string> explanation = {};  ///< short sentences below the title
    std::vector<Panel> panels;                  ///< from top to bottom
    std::string note = {};                      ///< below, small
    bool legend_below = false;                  ///< else at the right
};

/// The values of every axis in the unit that fits their size, named in its label.
Figure in_units(Figure figure);

/// A file of its own, or an element inside a page.
std::string svg(const Figure& given);
/// Size of the panel in a picture of its own, in pixels.
double height_of(const Panel& panel);
/// The figure with plots as wide as a telephone shows, and the legends below them.
Figure narrow(Figure figure);
/// Gives \p lines colours and strokes by their \p kinds, such as a law and a distribution of peaks, so that each colour
/// and each stroke means one thing; what has no second kind is solid.
void choose_look(std::vector<PlotLine>& lines,
                 const std::vector<std::pair<std::size_t, std::optional<std::size_t>>>& kinds);
/// A page of its own: the title, the narrow picture and the note.
std::string html_page(const Figure& figure);
/// curve,panel,label,x_quantity,x,y_quantity,y,low,high: the numbers that are drawn.
std::string figure_csv(const Figure& given);

/// The names of a picture and of its numbers: trace.svg and trace.plot.csv.
struct PictureFiles {
    std::string picture, table;
    /// \throws Usage unless \p file ends in .svg or .html.
    explicit PictureFiles(const std::string& file);
    [[nodiscard]] std::vector<std::string> all() const { return {picture, table}; }
};

/// Before anything is read: no input may be one of the files. Does nothing without a \p file.
/// \throws Usage for another ending, file_error for a file next to the picture that fstiff did not make.
void keep_for_picture(const std::string& file);
/// The figure as \p file (.svg or .html), and its numbers (.plot.csv).
std::vector<OutputFile> figure_files(const Figure& figure, const std::string& file);
/// Writes both. \returns their names. \throws file_error for a file that cannot be written.
std::vector<std::string> write_figure(const Figure& figure, const std::string& file);
/// Writes \p figure, unless there is no \p file, and names it in \p report.
[[nodiscard]] Report with_picture(Report report, const std::function<Figure()>& figure, const std::string& file);

/// Description of a band, unbroken, for a legend.
inline constexpr const char* shown_band = "5\u00A0to\u00A095\u00A0%";
/// "8 of 30 curves are drawn"; empty where all are.
std::string some_of(std::size_t some, std::size_t all);
/// The name of \p file without its folders, for a title.
std::string shown_file(const std::string& file);
/// \p text between the tags of SVG or HTML.
std::string escaped(std::string_view text);

/// Bytes of an indexed BMP: \p shade holds rows from bottom to top, 0 to 254 from low to high, 255 for a missing point.
std::string heat_map_bmp(const std::vector<unsigned char>& shade, std::size_t columns, std::size_t rows);
std::string base64(std::string_view bytes);

}  // namespace fstiff::cli
