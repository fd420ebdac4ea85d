// SPDX-License-Identifier: BSD-3-Clause
#include "actions/scales.hpp"

#include "actions/measure.hpp"
#include "document/file.hpp"
#include "document/shown_unit.hpp"

#include <fstiff/answer/answer.hpp>
#include <fstiff/answer/face.hpp>
#include <fstiff/answer/lacks.hpp>
#include <fstiff/measure/roughness_cut_off.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

namespace fstiff::actions {
namespace {

std::optional<double> stiffness_of(const surface::MeasuredSurface& surface, const ChosenLaw& law,
                                   const ScalesOptions& load) {
    try {
        const Body body{.elastic = {2 * load.modulus, 0.0}};  // of which both are
        const Joint joint{.face = {.measured = measured_face(surface.found)}, .upper = body, .lower = body};
        const auto points = contact_of(joint, law)->at_pressures({&load.pressure, 1}, Quantity::stiffness);
        return points.front().ok() ? std::optional(points.front().state.stiffness.value) : std::nullopt;
    } catch (const domain_error&) {
        return {};
    }
}

ChosenLaw law_for(const surface::MeasuredSurface& surface) {
    const detail::Face face = measured_face(surface.found)->face();
    if (lack_of_spectrum(face) == detail::Lack::nothing && (face.has_peaks() || face.map)) return laws::hybrid;
    return face.has_peaks() ? laws::hertz : laws::greenwood_williamson;
}

request::Amount option_of(const std::optional<double>& cut_off) {
    return cut_off ? request::Amount(*cut_off) : request::Amount("none");
}

/// The row of the cut-offs that \p surface has.
Scale scale_of(const surface::MeasuredSurface& surface, const ChosenLaw& law, const ScalesOptions& load) {
    Scale scale{.cut_offs = surface.found.cut_offs, .chosen = true};
    scale.surface = surface;
    scale.stiffness = stiffness_of(surface, law, load);
    if (!scale.stiffness) scale.refusal = "no K by " + std::string(name_of(law.which));
    return scale;
}

Scale scale_at(surface::MeasureOptions options, const surface::SurfaceInput& input, const CutOffs<double>& cut_offs,
               const ChosenLaw& law, const ScalesOptions& load) {
    options.neighbours = false;
    options.resamples = 2;  // errors are not asked
    options.input.lambda_s = option_of(cut_offs.lambda_s);
    options.input.lambda_c = option_of(cut_offs.lambda_c);
    Scale scale{.cut_offs = cut_offs};
    try {
        scale = scale_of(measure_surface(options, input), law, load);
        scale.cut_offs = cut_offs;
        scale.chosen = false;
    } catch (const domain_error& error) {
        scale.refusal = error.what();
    }
    return scale;
}

using ScaleRows = std::vector<std::reference_wrapper<const Scale>>;

document::Rows scale_rows(const ScaleRows& scales) {
    const auto length = [](const std::optional<double>& cut_off) {
        return cut_off ? document::shown_length(*cut_off, 4) : "none";
    };
    const auto parameter = [](Parameter which) { return [which](const Scale& scale) { return scale.value(which); }; };
    std::vector<double> stiffnesses;
    for (const Scale& scale : scales) stiffnesses.push_back(scale.stiffness.value_or(0));
    const document::ShownUnit unit = document::shown_unit(stiffnesses, "Pa/m");
    document::Rows rows;
    rows.add({.key = "lambda_s_m"}, scales, [](const Scale& scale) { return scale.cut_offs.lambda_s; });
    rows.add({.key = "lambda_c_m"}, scales, [](const Scale& scale) { return scale.cut_offs.lambda_c; });
    rows.add({"", "lambda_s"}, scales,
             [&](const Scale& scale) { return length(scale.cut_offs.lambda_s) + (scale.chosen ? " *" : ""); });
    rows.add({"", "lambda_c"}, scales, [&](const Scale& scale) { return length(scale.cut_offs.lambda_c); });
    rows.add({"rms_height_m", "sigma [µm]", 1e6}, scales, parameter(Parameter::rms_height));
    rows.add({"rms_gradient", "gradient"}, scales, &Scale::gradient);
    rows.add({"peak_radius_m", "R [µm]", 1e6}, scales, parameter(Parameter::peak_radius));
    rows.add({"peak_density_per_m2", "D_p [/mm²]", 1e-6}, scales, parameter(Parameter::peak_density));
    rows.add({"fractal_dimension", "D"}, scales, parameter(Parameter::fractal_dimension));
    rows.add({"stiffness_Pa_per_m", unit.heading("K/A0"), unit.factor}, scales, &Scale::stiffness);
    rows.add({.key = "refusal", .shown = "", .csv = false}, scales, &Scale::refusal);
    return rows;
}

}  // namespace

Scales scales_of(const surface::MeasuredSurface& chosen, const surface::SurfaceInput& input,
                 const ScalesOptions& load) {
    const ChosenLaw law = law_for(chosen);
    double step = 0, length = 0;
    if (chosen.found.profile) {
        step = chosen.found.profile->profile.spacing;
        length = step * static_cast<double>(chosen.found.profile->profile.size());
    } else {
        const HeightMap<double>& map = chosen.found.map->map;
        step = std::max(map.dx, map.dy);
        length = std::min(static_cast<double>(map.columns()) * map.dx, static_cast<double>(map.rows()) * map.dy);
    }
    std::vector<std::pair<bool, CutOffs<double>>> asked;  // whether lambda_s varies
    const CutOffs<double>& own = chosen.found.cut_offs;
    const double shortest = own.lambda_s.value_or(4 * step), longest = own.lambda_c.value_or(length / 2);
    const auto ask = [&](bool of_short_waves, std::optional<double> lambda_s, std::optional<double> lambda_c) {
        CutOffs<double> cut_offs;
        cut_offs.lambda_s = lambda_s, cut_offs.lambda_c = lambda_c, cut_offs.filter = own.filter;
        asked.emplace_back(of_short_waves, cut_offs);
    };
    ask(true, {}, own.lambda_c);
    // powers of two that differ from a bound by rounding alone are within it
    const auto first_at_least = [](double ratio) { return static_cast<int>(std::ceil(std::log2(ratio) - 1e-9)); };
    const auto last_at_most = [](double ratio) { return static_cast<int>(std::floor(std::log2(ratio) + 1e-9)); };
    const double longest_s = std::min(length / 20, own.lambda_c.value_or(length) / 5);
    for (int k = first_at_least(2 * step / shortest); k <= last_at_most(longest_s / shortest); ++k)
        ask(true, std::ldexp(shortest, k), own.lambda_c);
    ask(false, own.lambda_s, {});
    const double shortest_c = std::max(10 * own.lambda_s.value_or(0), 20 * step);
    for (int k = last_at_most(length / 2 / longest); k >= first_at_least(shortest_c / longest); --k)
        ask(false, own.lambda_s, std::ldexp(longest, k));
    const auto same = [](const std::optional<double>& a, const std::optional<double>& b) {
        return a.has_value() == b.has_value() && (!a || std::abs(*a - *b) < 1e-9 * *b);
    };
    const Scale of_chosen = scale_of(chosen, law, load);
    Scales scales{.law = std::string(name_of(law.which)), .length = length, .short_waves = {}, .long_waves = {}};
    for (std::size_t i = 0; i < asked.size(); ++i) {
        if (load.progress) load.progress("scales", i, asked.size());
        const CutOffs<double>& cut_offs = asked[i].second;
        const bool is_own = same(cut_offs.lambda_s, own.lambda_s) && same(cut_offs.lambda_c, own.lambda_c);
        Scale scale = is_own ? of_chosen : scale_at(*chosen.how, input, cut_offs, law, load);
        (asked[i].first ? scales.short_waves : scales.long_waves).push_back(std::move(scale));
    }
    return scales;
}

std::vector<std::string> convergence_sentences(const Scales& scales) {
    const auto about = [&](const std::vector<Scale>& rows, const std::string& name) {
        const auto chosen = std::find_if(rows.begin(), rows.end(), [](const Scale& scale) { return scale.chosen; });
        if (chosen == rows.end() || !chosen->stiffness) return "K at the chosen " + name + " is not known";
        double low = 0, high = 0;
        int known = 0;
        for (const std::ptrdiff_t away : {-1, 1}) {
            const std::ptrdiff_t place = (chosen - rows.begin()) + away;
            if (place < 0 || place >= std::ssize(rows) || !rows[static_cast<std::size_t>(place)].stiffness) continue;
            const double change = *rows[static_cast<std::size_t>(place)].stiffness / *chosen->stiffness - 1;
            low = std::min(low, change), high = std::max(high, change);
            ++known;
        }
        if (known == 0) return "no other " + name + " is possible for this file: its effect on K is not known";
        return "the next " + name + " below and above change K by " + document::shown_change(1 + low) + " to " +
               document::shown_change(1 + high) +
               (std::max(high, -low) <= 0.1 ? ": settled to 10 %" : ": not settled to 10 %");
    };
    return {about(scales.short_waves, "lambda_s"), about(scales.long_waves, "lambda_c")};
}

std::optional<double> Scale::value(Parameter parameter) const {
    const auto* known = surface ? surface->found.find(parameter) : nullptr;
    return known ? std::optional(known->value) : std::nullopt;
}

std::optional<double> Scale::gradient() const {
    return surface && surface->found.heights ? std::optional(surface->found.rms_gradient.value) : std::nullopt;
}

document::Document document_of(const surface::MeasureOptions& options,
                               const std::shared_ptr<const surface::MeasuredSurface>& surface, const Scales& scales,
                               const ScalesOptions& load) {
    ScaleRows pairs(scales.short_waves.begin(), scales.short_waves.end());
    pairs.insert(pairs.end(), scales.long_waves.begin(), scales.long_waves.end());
    const document::Rows rows = scale_rows(pairs);
    const std::vector<std::string> settled = convergence_sentences(scales);
    document::Document document = document_of(options, surface);
    document.line("\nwith other cut-offs (* chosen), K by " + scales.law + " at " +
                  document::rounded(load.pressure / 1e6) + " MPa, effective modulus " +
                  document::rounded(load.modulus / 1e9) + " GPa\n");
    document.text([rows] { return rows.text() + "\n"; });
    for (const std::string& sentence : settled) document.line("  " + sentence);
    for (const Scale& scale : pairs)
        if (!scale.refusal.empty()) document.line("  " + surface::sentence_of(scale.cut_offs) + ": " + scale.refusal);
    document.csv_alone([rows] { return rows; });
    document.values([=, law = scales.law, pressure = load.pressure, modulus = load.modulus](document::Json& to) {
        document::Json& object = to["scales"] = {
            {"law", law}, {"pressure_Pa", pressure}, {"effective_modulus_Pa", modulus}, {"settled", settled}};
        rows.append_to(object["rows"]);
    });
    return document;
}

}  // namespace fstiff::actions
