// SPDX-License-Identifier: BSD-3-Clause
#include "scene/surface_option_table.hpp"

#include <fstiff/measured/prepare.hpp>

#include <algorithm>
#include <stdexcept>

namespace fstiff::scene {
namespace {

/// The forms that may be removed of \p kind.
std::vector<std::string_view> words_of_form(SurfaceKind kind) {
    std::vector<std::string_view> words;
    const auto add = [&](std::span<const std::string_view> more) {
        for (const std::string_view word : more)
            if (std::find(words.begin(), words.end(), word) == words.end()) words.push_back(word);
    };
    if (kind != SurfaceKind::map) {
        add(choices<Form>());
        words.push_back(gaussian_form);
    }
    if (kind != SurfaceKind::profile) add(choices<MapForm>());
    return words;
}

using Group = OptionGroup;
using Of = SurfaceOptions;

constexpr SurfaceOptionRow option_rows[] = {
    {.key = "format",
     .group = Group::file,
     .field = &Of::format,
     .help = "form of the file: auto (default), profile, triples, matrix, sdf, x3p, npy, gsf, gwy, sur or smd",
     .always_in_json = true,
     .flag = "input-format",
     .json = "input_format"},
    {.key = "units",
     .group = Group::file,
     .field = &Of::units,
     .help = "units of lengths and heights of a text or .npy, such as um,nm, or one for both; replace those of the "
             "file",
     .always_in_json = true},
    {.key = "spacing",
     .group = Group::step_of_profile,
     .field = &Of::spacing,
     .help = "distance of neighbouring points of a profile, such as \"0.5 um\"; replaces that of the file",
     .always_in_json = true},
    {.key = "column",
     .group = Group::file_of_profile,
     .field = &Of::column,
     .help = "column of the heights of a profile, counted from 1; default the last of one or two",
     .low = 1,
     .high = most_columns,
     .always_in_json = true},
    {.key = "x_column",
     .group = Group::file_of_profile,
     .field = &Of::x_column,
     .help = "column of the positions of a profile, counted from 1; default the first that does not number the points",
     .low = 1,
     .high = most_columns},
    {.key = "dx",
     .group = Group::step_of_map,
     .field = &Of::dx,
     .help = "distance of neighbouring columns of a matrix or .npy; replaces the one in the file",
     .always_in_json = true},
    {.key = "dy",
     .group = Group::step_of_map,
     .field = &Of::dy,
     .help = "distance of neighbouring rows of a matrix or .npy",
     .always_in_json = true},
    {.key = "width",
     .group = Group::file_of_map,
     .field = &Of::width,
     .help = "width of a matrix or .npy (number of columns times dx), instead of --dx",
     .always_in_json = true},
    {.key = "height",
     .group = Group::file_of_map,
     .field = &Of::height,
     .help = "height of a matrix or .npy (number of rows times dy), instead of --dy",
     .always_in_json = true},
    {.key = "detrend",
     .group = Group::form,
     .field = &Of::detrend,
     .help = "form that is removed before anything is computed; of a profile none, mean, line (default), parabola or "
             "gaussian; of a map none, mean, plane (default), quadratic or cubic",
     .help_of_profile = "form that is removed before anything is computed; of a profile none, mean, line (default), "
                        "parabola or gaussian",
     .help_of_map = "form that is removed before anything is computed; of a map none, mean, plane (default), quadratic "
                    "or cubic",
     .always_in_json = true,
     .words = words_of_form},
    {.key = "cutoff",
     .group = Group::form_of_profile,
     .field = &Of::cutoff,
     .help = "wavelength that the Gaussian filter (ISO 16610-21) halves, such as \"0.8 mm\"",
     .always_in_json = true},
    {.key = "peaks",
     .group = Group::estimate,
     .field = &Of::peaks,
     .help = "what counts as a peak of a map, for R and D_p: its islands (default) or its summits",
     .always_in_json = true},
    {.key = "tip_radius",
     .group = Group::estimate,
     .field = &Of::tip_radius,
     .help = "radius of the stylus, such as \"2 um\": shorter lags of a profile, which may show it, are not used for D",
     .always_in_json = true},
    {.key = "resolution",
     .group = Group::estimate,
     .field = &Of::resolution,
     .help = "lateral resolution of the instrument; shorter lags are not used for D",
     .always_in_json = true},
    {.key = "window",
     .group = Group::estimate,
     .field = &Of::window,
     .help = "shortest and longest lag that give D, such as \"1 um,100 um\"; the default is chosen automatically",
     .always_in_json = true},
    {.key = "missing",
     .group = Group::file,
     .field = &Of::missing,
     .help = "number or word that stands for missing points of a text or .npy, such as -9999; none: every number is a "
             "height",
     .form = TextForm::or_number},
    {.key = "resample",
     .group = Group::file_of_profile,
     .field = &Of::resample,
     .help = "a profile of unequal steps is interpolated at as many equal ones"},
    {.key = "x3p_increment",
     .group = Group::file,
     .field = &Of::x3p_increment,
     .help = "of X3P with heights of floating point: apply the increment of z (default) or ignore it"},
    {.key = "lambda_s",
     .group = Group::filter,
     .field = &Of::lambda_s,
     .help = "shortest waves that are kept, such as \"1 um\": the Gaussian filter (ISO 16610-21 and -61) halves "
             "them once the form is removed; auto (default) takes the standards' index of five steps; none keeps all"},
    {.key = "lambda_c",
     .group = Group::filter,
     .field = &Of::lambda_c,
     .help = "longest waves that are kept, such as \"0.8 mm\", after --lambda-s; auto (default) takes that of the "
             "standards' table for a profile of five of them, and none for a map; none keeps all"},
    {.key = "filter",
     .group = Group::filter,
     .field = &Of::filter,
     .help = "filter of --lambda-c: gaussian (default), or robust (ISO 16610-31 and -71), whose mean line grooves and "
             "spikes do not draw towards them"},
    {.key = "crop",
     .group = Group::cleaning,
     .field = &Of::crop,
     .help = "part that is kept: \"x0,x1\" of a profile, \"x0,x1,y0,y1\" of a map, such as \"0,1 mm,0,1 mm\"",
     .help_of_profile = "part that is kept: \"x0,x1\", such as \"0,1 mm\""},
    {.key = "mask",
     .group = Group::cleaning,
     .field = &Of::mask,
     .help = "file of 0 and 1 with the shape of the surface, text or .npy: points of 0 become missing",
     .form = TextForm::file},
    {.key = "spikes",
     .group = Group::cleaning,
     .field = &Of::spikes,
     .help = "points farther than so many robust standard deviations, such as 5, from the median of their neighbours "
             "become missing",
     .low = min_spike_limit,
     .high = max_spike_limit},
    {.key = "fill",
     .group = Group::cleaning,
     .field = &Of::fill,
     .help = "missing points are filled: by straight lines in a profile, by Laplace's equation in a map"},
    {.key = "channel",
     .group = Group::file,
     .field = &Of::channel,
     .help = "of a Gwyddion file (.gwy): number or title of the channel; default the lowest in lengths"},
};

}  // namespace

std::string SurfaceOptionRow::flag_name() const { return "--" + (flag.empty() ? with_dashes(key) : std::string(flag)); }

std::string_view SurfaceOptionRow::help_for(SurfaceKind kind) const {
    if (kind == SurfaceKind::profile && !help_of_profile.empty()) return help_of_profile;
    return kind == SurfaceKind::map && !help_of_map.empty() ? help_of_map : help;
}

bool SurfaceOptionRow::is_for(SurfaceKind kind) const {
    switch (group) {
        case OptionGroup::step_of_profile:
        case OptionGroup::file_of_profile:
        case OptionGroup::form_of_profile:
            return kind != SurfaceKind::map;
        case OptionGroup::step_of_map:
        case OptionGroup::file_of_map:
            return kind != SurfaceKind::profile;
        default:
            return true;
    }
}

bool SurfaceOptionRow::is_of_file() const {
    return group == OptionGroup::file || group == OptionGroup::file_of_profile || group == OptionGroup::file_of_map;
}

std::string SurfaceOptionRow::range() const { return "from " + std::to_string(low) + " to " + std::to_string(high); }

std::span<const SurfaceOptionRow> surface_option_table() { return option_rows; }

const SurfaceOptionRow& surface_option(std::string_view key) {
    for (const SurfaceOptionRow& row : option_rows)
        if (row.key == key) return row;
    throw std::logic_error("no option of a surface is called " + std::string(key));
}

std::string with_dashes(std::string_view key) {
    std::string text(key);
    std::replace(text.begin(), text.end(), '_', '-');
    return text;
}

}  // namespace fstiff::scene
