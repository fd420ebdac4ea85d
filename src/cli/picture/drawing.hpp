// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// A panel made ready to be drawn: colours settled, scales chosen, overlapping curves marked, and the
// lines of its legend.

#include "picture/plot.hpp"
#include "picture/scale.hpp"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace fstiff::cli {

struct Colour {
    const char *light, *dark;
};
inline constexpr std::array<Colour, 8> palette{{{"#b3261e", "#ff8a80"},
                                                {"#0b57a4", "#7db8ff"},
                                                {"#1b7f54", "#5ccf97"},
                                                {"#7a2f9e", "#dba4f5"},
                                                {"#b06000", "#ffb961"},
                                                {"#00737a", "#5fd4dc"},
                                                {"#9c2470", "#f59acb"},
                                                {"#6b6200", "#e0cf5a"}}};
inline constexpr Colour grey{"#5f5f66", "#a9a9b2"}, window_colour{"#8a7200", "#ffe28a"};
inline Colour colour_of(int colour) {
    return colour < 0 ? grey : palette[static_cast<std::size_t>(colour) % palette.size()];
}

/// One sample and its text, whose lines are below one another.
struct Entry {
    const PlotLine* line;      ///< with its band, or
    const PlotWindow* window;  ///< a shaded window
    std::vector<std::string> text;
};

struct Drawing {
    explicit Drawing(const Panel& drawn);
    double place_x(double x) const { return panel.width * x_scale(x); }
    bool shows(const PlotLine& line, std::size_t i) const {
        return x_scale.shows(line.x[i]) && y_scale.shows(line.y[i]);
    }
    double place_y(double y) const { return panel.height * (1 - y_scale(y)); }
    std::vector<Entry> legend() const;

    const Panel& panel;
    std::vector<PlotLine> lines;
    Scale x_scale, y_scale;
};

}  // namespace fstiff::cli
