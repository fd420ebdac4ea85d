// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The pictures of `run --plot` and `ultrasound --plot` as SVG that needs nothing else: no script, no font, no other
// file. Colours follow the reader's light or dark setting. The same figure is written as CSV. The same figure gives the
// same bytes.
//
// panels.cpp makes the figure of results and its files, reflections.cpp that of measured reflections, svg.cpp draws
// them by the ticks of scale.cpp.

#include "actions/answered.hpp"
#include "actions/ultrasound.hpp"
#include "document/output.hpp"

#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace fstiff::cli {

struct Axis {
    std::string label;  ///< with its unit, such as "p [MPa]"
    bool logarithmic = true;
    std::optional<double> low{}, high{};  ///< none: from the curves
};

/// Colours 0 to 7 distinguish curves; a line in `neutral` grey is a reference, and is dashed.
inline constexpr int neutral = 8;

/// Points, a line through them, and a band about it when low and high are given. On a logarithmic axis a point that is
/// not positive breaks the line.
struct PlotLine {
    std::string label{};  ///< empty: not in the legend
    std::vector<double> x{}, y{};
    std::vector<double> low{}, high{};  ///< of the band, one for every x
    std::string band{};                 ///< what the band is, for the legend
    bool bars = false;                  ///< an error bar at every point in place of the band
    bool marks = false;                 ///< marks alone
    int colour = 0;
};

/// A shaded range of the vertical axis.
struct PlotWindow {
    std::string label;
    double low = 0, high = 0;
};

/// Where the law changes: a dotted line with the names of the laws at its sides.
struct PlotChange {
    double x = 0;
    std::string_view before, after;
};

struct Panel {
    std::string title;
    Axis x, y;
    double height;  ///< of the plot itself
    std::vector<PlotLine> lines{};
    std::optional<PlotWindow> window{};
    std::vector<PlotChange> changes{};
};

struct Figure {
    std::string title;
    std::vector<std::string> explanation;  ///< short sentences below the title
    std::vector<Panel> panels;             ///< from top to bottom
    std::string note;                      ///< below, small
};

/// K(p) of \p scene with marks at its points, on lines through these and the points \p between them; below it what
/// follows from K and is asked for. In the units of the tables.
/// \throws domain_error when the scene asks for no stiffness.
[[nodiscard]] Figure results_figure(const actions::Answered& answered, const std::optional<actions::Answered>& between);
/// K of the curve of \p reflection: of each load against the frequency, on the K by all of them, and against the
/// pressure.
[[nodiscard]] Figure reflections_figure(const actions::Reflection& reflection);
/// \p figure as a file of its own.
[[nodiscard]] std::string svg(const Figure& figure);
/// Before anything is read: no input may be \p file or the table of its numbers, FILE.plot.csv. Does nothing without a
/// \p file. \throws Usage unless it ends in .svg, file_error for a file that fstiff did not make, unless \p force.
void keep_for_picture(const std::string& file, bool force);
/// Writes \p figure as \p file, unless that is empty, and next to it the numbers that are drawn: curve, panel, label,
/// x_quantity, x, y_quantity, y, low, high. \p report names both. \throws file_error for what cannot be written.
[[nodiscard]] Report with_picture(Report report, const std::function<Figure()>& figure, const std::string& file);

struct Tick {
    double value;
    std::string label;  ///< empty: a fainter line without a number
};

class Scale {
public:
    /// Scale of \p axis for \p values. Close values get room about them.
    Scale(const Axis& axis, const std::vector<double>& values);
    bool shows(double value) const { return std::isfinite(value) && (!logarithmic_ || value > 0); }
    /// 0 at the lower end, 1 at the upper one.
    double operator()(double value) const { return (place(value) - low_) / (high_ - low_); }
    /// Moves the upper end up by \p share of the length.
    void extend(double share) { high_ += share * (high_ - low_); }
    double low() const { return logarithmic_ ? std::pow(10.0, low_) : low_; }
    double high() const { return logarithmic_ ? std::pow(10.0, high_) : high_; }
    std::vector<Tick> ticks() const { return logarithmic_ ? decades() : steps(); }

private:
    double place(double value) const { return logarithmic_ ? std::log10(value) : value; }
    std::vector<Tick> decades() const;
    std::vector<Tick> steps() const;

    bool logarithmic_;
    double low_, high_;
};

}  // namespace fstiff::cli
