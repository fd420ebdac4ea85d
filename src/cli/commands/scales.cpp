// SPDX-License-Identifier: BSD-3-Clause
#include "commands/scales.hpp"

#include "document/file.hpp"
#include "document/shown_unit.hpp"

#include <algorithm>
#include <functional>

namespace fstiff::cli {
namespace {

using Value = std::function<std::optional<double>(const Scale&)>;

Value parameter(Parameter which) {
    return [which](const Scale& scale) -> std::optional<double> {
        const auto* known = scale.surface ? scale.surface->found.find(which) : nullptr;
        return known ? std::optional(known->value) : std::nullopt;
    };
}

std::optional<double> gradient(const Scale& scale) {
    return scale.surface && scale.surface->found.heights ? std::optional(scale.surface->found.rms_gradient.value)
                                                         : std::nullopt;
}

std::optional<double> stiffness(const Scale& scale) { return scale.stiffness; }

template <class Visit>
void for_each(const Scales& scales, const Visit& visit) {
    for (const auto* rows : {&scales.short_waves, &scales.long_waves})
        for (const Scale& scale : *rows) visit(scale);
}

}  // namespace

Rows scales_rows(const Scales& scales) {
    Rows rows;
    const auto add = [&](Heading heading, const Value& value) {
        std::vector<std::optional<double>> all;
        for_each(scales, [&](const Scale& scale) { all.push_back(value(scale)); });
        rows.add(std::move(heading), all);
    };
    std::vector<std::string> shown_s, shown_c, notes;
    for_each(scales, [&](const Scale& scale) {
        const auto length = [](const std::optional<double>& one) {
            return one ? shown_length(*one, 4) : std::string("none");
        };
        shown_s.push_back(length(scale.cut_offs.lambda_s) + (scale.chosen ? " *" : ""));
        shown_c.push_back(length(scale.cut_offs.lambda_c));
        notes.push_back(scale.refusal);
    });
    add({.key = "lambda_s_m"}, [](const Scale& scale) { return scale.cut_offs.lambda_s; });
    add({.key = "lambda_c_m"}, [](const Scale& scale) { return scale.cut_offs.lambda_c; });
    rows.add({"", "lambda_s"}, shown_s);
    rows.add({"", "lambda_c"}, shown_c);
    add({"rms_height_m", "sigma [µm]", 1e6}, parameter(Parameter::rms_height));
    add({"rms_gradient", "gradient"}, gradient);
    add({"peak_radius_m", "R [µm]", 1e6}, parameter(Parameter::peak_radius));
    add({"peak_density_per_m2", "D_p [/mm²]", 1e-6}, parameter(Parameter::peak_density));
    add({"fractal_dimension", "D"}, parameter(Parameter::fractal_dimension));
    add({"stiffness_Pa_per_m", "K/A0 [GPa/µm]", 1e-15}, stiffness);
    rows.add({.key = "refusal", .shown = "", .csv = false}, notes);
    return rows;
}

std::string scales_text(const Scales& scales, const ScalesOptions& how) {
    std::string text = "\nwith other cut-offs (* chosen), K by " + scales.law + " at " + rounded(how.pressure / 1e6) +
                       " MPa, effective modulus " + rounded(how.modulus / 1e9) + " GPa\n\n" +
                       scales_rows(scales).text() + "\n";
    for (const std::string& sentence : what_is_settled(scales)) text += "  " + sentence + "\n";
    for_each(scales, [&](const Scale& scale) {
        if (!scale.refusal.empty()) text += "  " + sentence_of(scale.cut_offs) + ": " + scale.refusal + "\n";
    });
    return text;
}

std::vector<Panel> scales_panels(const Scales& scales) {
    const auto panel = [](const std::vector<Scale>& rows, const std::string& name, auto cut_off) {
        Panel of;
        of.title = "Filtered with other " + name + (name == "λc" ? ", none at the length of the surface" : "");
        of.x = {.label = name, .si = "m"};
        of.y = {.label = "ratio to the value at the chosen " + name};
        const Scale* chosen = nullptr;
        for (const Scale& scale : rows)
            if (scale.chosen) chosen = &scale;
        if (!chosen) return of;
        const auto add = [&](const char* label, const Value& value, Marker marker) {
            const auto unit = value(*chosen);
            if (!unit) return;
            PlotLine line{.label = label, .x = {}, .y = {}};
            line.marker = marker;
            for (const Scale& scale : rows)
                if (const auto one = value(scale); one && cut_off(scale))
                    line.x.push_back(*cut_off(scale)), line.y.push_back(*one / *unit);
            if (!line.x.empty()) of.lines.push_back(std::move(line));
        };
        add("K", stiffness, Marker::circle);
        add("σ", parameter(Parameter::rms_height), Marker::square);
        add("gradient", gradient, Marker::triangle);
        add("R", parameter(Parameter::peak_radius), Marker::diamond);
        add("D_p", parameter(Parameter::peak_density), Marker::cross);
        return of;
    };
    std::vector<Panel> panels{
        panel(scales.short_waves, "λs", [](const Scale& scale) { return scale.cut_offs.lambda_s; }),
        panel(scales.long_waves, "λc",
              [&](const Scale& scale) { return std::optional(scale.cut_offs.lambda_c.value_or(scales.length)); })};
    const auto is_curve = [](const PlotLine& line) { return line.x.size() > 1; };
    std::erase_if(panels, [&](const Panel& one) { return std::none_of(one.lines.begin(), one.lines.end(), is_curve); });
    return panels;
}

}  // namespace fstiff::cli
