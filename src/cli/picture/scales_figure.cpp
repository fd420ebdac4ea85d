// SPDX-License-Identifier: BSD-3-Clause
#include "picture/figures.hpp"

#include <algorithm>
#include <functional>

namespace fstiff::cli {

std::vector<Panel> scales_panels(const Scales& scales) {
    using Value = std::function<std::optional<double>(const scene::Scale&)>;
    const auto parameter = [](Parameter which) {
        return [=](const scene::Scale& scale) { return scale.value(which); };
    };
    const auto panel = [&](const std::vector<scene::Scale>& rows, const std::string& name, auto cut_off) {
        Panel of;
        of.title = "Filtered with other " + name + (name == "λc" ? ", none at the length of the surface" : "");
        of.x = {.label = name, .si = "m"};
        of.y = {.label = "ratio to the value at the chosen " + name};
        const scene::Scale* chosen = nullptr;
        for (const scene::Scale& scale : rows)
            if (scale.chosen) chosen = &scale;
        if (!chosen) return of;
        const auto add = [&](const char* label, const Value& value, Marker marker) {
            const auto unit = value(*chosen);
            if (!unit) return;
            PlotLine line{.label = label, .x = {}, .y = {}};
            line.marker = marker;
            for (const scene::Scale& scale : rows)
                if (const auto one = value(scale); one && cut_off(scale))
                    line.x.push_back(*cut_off(scale)), line.y.push_back(*one / *unit);
            if (!line.x.empty()) of.lines.push_back(std::move(line));
        };
        add("K", &scene::Scale::stiffness, Marker::circle);
        add("σ", parameter(Parameter::rms_height), Marker::square);
        add("gradient", &scene::Scale::gradient, Marker::triangle);
        add("R", parameter(Parameter::peak_radius), Marker::diamond);
        add("D_p", parameter(Parameter::peak_density), Marker::cross);
        return of;
    };
    std::vector<Panel> panels{
        panel(scales.short_waves, "λs", [](const scene::Scale& scale) { return scale.cut_offs.lambda_s; }),
        panel(scales.long_waves, "λc", [&](const scene::Scale& scale) {
            return std::optional(scale.cut_offs.lambda_c.value_or(scales.length));
        })};
    const auto is_curve = [](const PlotLine& line) { return line.x.size() > 1; };
    std::erase_if(panels,
                  [&](const Panel& panel) { return std::none_of(panel.lines.begin(), panel.lines.end(), is_curve); });
    return panels;
}

}  // namespace fstiff::cli
