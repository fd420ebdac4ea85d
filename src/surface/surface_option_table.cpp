// SPDX-License-Identifier: BSD-3-Clause
#include "surface/surface_option_table.hpp"

#include <fstiff/measure/prepare.hpp>
#include <fstiff/profile/profile_form.hpp>

#include <algorithm>
#include <stdexcept>

namespace fstiff::surface {
namespace {

/// The forms that may be removed of \p kind.
std::vector<std::string_view> words_of_form(SurfaceKind kind) {
    std::vector<std::string_view> words;
    const auto add = [&](std::span<const std::string_view> more) {
        for (const std::string_view word : more)
            if (std::find(words.begin(), words.end(), word) == words.end()) words.push_back(word);
    };
    if (kind != SurfaceKind::map) {
        add(detail::choices<Form>());
        words.push_back(gaussian_form);
    }
    if (kind != SurfaceKind::profile) add(detail::choices<MapForm>());
    return words;
}

/// ", profile, triples, ... or opdx": all but auto.
std::string forms() {
    std::string text = detail::choices_text<io::SurfaceFormat>().substr(name_of(io::SurfaceFormat::automatic).size());
    return text.replace(text.rfind(", "), 2, " or ");
}

namespace of_surface {

using enum OptionGroup;
using enum Echo;
using Of = SurfaceOptions;

// clang-format off
constexpr SurfaceOptionRow rows[] = {
    {"format", file, &Of::format, always,
     "form of the file: auto (default)", {.flag = "input-format", .json = "input_format", .more_help = forms}},
    {"units", file, &Of::units, always,
     "units of lengths and heights in a text, .npy, .mat, X3P or Surfer file, such as um,nm, or one for both; they replace "
     "those of the file"},
    {"spacing", step, &Of::spacing, always,
     "distance between neighbouring points of a profile or of a .npy or .mat map, such as \"0.5 um\"; replaces that of the file"},
    {"column", file_of_profile, &Of::column, always,
     "column of the heights of a profile, counted from 1; default the last of one or two",
     {.low = 1, .high = most_columns}},
    {"x_column", file_of_profile, &Of::x_column, if_not_default,
     "column of the positions of a profile, counted from 1; default the first that does not number the points",
     {.low = 1, .high = most_columns}},
    {"dx", step_of_map, &Of::dx, always,
     "distance between neighbouring columns of a matrix, .npy or .mat file; replaces that of the file"},
    {"dy", step_of_map, &Of::dy, always, "distance between neighbouring rows of a matrix, .npy or .mat file"},
    {"width", file_of_map, &Of::width, always,
     "width of a matrix, .npy or .mat file (number of columns times dx), instead of --dx"},
    {"height", file_of_map, &Of::height, always,
     "height of a matrix, .npy or .mat file (number of rows times dy), instead of --dy"},
    {"detrend", form, &Of::detrend, always,
     "form, as a drawing defines it, removed before anything is computed; for a profile none, mean, line "
     "(default), parabola, circle or gaussian; for a map none, mean, plane (default), quadratic, cubic, sphere or cylinder",
     {.help_of_profile = "form, as a drawing defines it, removed before anything is computed; for a profile none, "
                         "mean, line (default), parabola, circle or gaussian",
      .help_of_map = "form, as a drawing defines it, removed before anything is computed; for a map none, "
                     "mean, plane (default), quadratic, cubic, sphere or cylinder",
      .words = words_of_form}},
    {"radius", form, &Of::radius, if_not_default,
     "radius of a circle, sphere or cylinder, such as \"5 mm\"; default that of the best one"},
    {"cutoff", form_of_profile, &Of::cutoff, always,
     "wavelength that the Gaussian filter (ISO 16610-21) halves, such as \"0.8 mm\""},
    {"columns", estimate, &Of::columns, if_not_default,
     "columns of one file whose profiles are traces of one face and are pooled, such as 2-180 or 2,4,6-9"},
    {"channels", estimate, &Of::channels, if_not_default,
     "tables of one text, or channels of one Gwyddion file, that are traces or maps of one face and are pooled, such as 1-3"},
    {"peaks", estimate, &Of::peaks, always,
     "what counts as a peak of a map, for R and D_p: its islands (default) or its summits"},
    {"tip_radius", estimate, &Of::tip_radius, always,
     "radius of the stylus, such as \"2 um\": shorter lags of a profile may show it and are not used for D"},
    {"resolution", estimate, &Of::resolution, always,
     "lateral resolution of the instrument; shorter lags are not used for D"},
    {"window", estimate, &Of::window, always,
     "shortest and longest lag that give D, such as \"1 um,100 um\"; the default is chosen automatically"},
    {"missing", file, &Of::missing, if_not_default,
     "number or word that marks missing points in a text, .npy, .mat or Surfer file, such as -9999; none: every number is a "
     "height",
     {.form = request::Form::or_number}},
    {"thousands", file, &Of::thousands, if_not_default,
     "separator of thousands in a text file: a comma, a point, an apostrophe or a blank in quotes; none: a comma or "
     "point is decimal"},
    {"resample", file_of_profile, &Of::resample, if_not_default,
     "resample a profile with unequal steps at the same number of equal steps"},
    {"x3p_increment", file, &Of::x3p_increment, if_not_default,
     "for X3P files with floating-point heights: apply the increment of z (default) or ignore it"},
    {"lambda_s", filter, &Of::lambda_s, if_not_default,
     "shortest waves that are kept, such as \"1 um\": the Gaussian filter (ISO 16610-21 and -61) halves "
     "them once the form is removed; auto (default) takes the standards' index of five steps, for the parameters of a map and not for its K; none keeps all"},
    {"lambda_c", filter, &Of::lambda_c, if_not_default,
     "longest waves that are kept, such as \"0.8 mm\", after --lambda-s; auto (default) keeps all, but for Ra, Rq "
     "and the like of a profile takes the value of the standards' table; none keeps all for these too"},
    {"filter", filter, &Of::filter, if_not_default,
     "filter of --lambda-c: gaussian (default), or robust (ISO 16610-31 and -71), whose mean line is not pulled "
     "towards grooves and spikes"},
    {"crop", cleaning, &Of::crop, if_not_default,
     "part that is kept: \"x0,x1\" for a profile, \"x0,x1,y0,y1\" for a map, such as \"0,1 mm,0,1 mm\"",
     {.help_of_profile = "part that is kept: \"x0,x1\", such as \"0,1 mm\""}},
    {"mask", cleaning, &Of::mask, if_not_default,
     "text or .npy file of zeros and ones, as large as the surface: points with 0 become missing",
     {.form = request::Form::file}},
    {"align", cleaning_of_map, &Of::align, if_not_default,
     "removes the offsets of scan lines, as a scanning probe leaves them: none (default), median, or "
     "median_of_differences where a line crosses a plateau or a pit"},
    {"scan_axis", cleaning_of_map, &Of::scan_axis, if_not_default,
     "axis along which the lines of --align were scanned: x (the rows of a file), y, or auto (default): that whose "
     "lines have offsets, else x"},
    {"spikes", cleaning, &Of::spikes, if_not_default,
     "points farther from the median of their neighbours than this many robust standard deviations, such as 5, "
     "become missing",
     {.low = detail::min_spike_limit, .high = detail::max_spike_limit}},
    {"fill", cleaning, &Of::fill, if_not_default,
     "fill missing points: by straight lines in a profile, by Laplace's equation in a map"},
    {"channel", file, &Of::channel, if_not_default,
     "for Gwyddion files (.gwy), text with several tables and MATLAB files: number or title of the channel, number or "
     "name of the variable; the default is the lowest number whose values are lengths, else the only one"},
    {"grid", file_of_map, &Of::grid, if_not_default,
     "step of the regular grid on which points in any order or a mesh are put, such as \"0.2 mm\": text with x, y, z, "
     ".ply, .obj and JSON"},
    {"facing", file_of_map, &Of::facing, if_not_default,
     "file of the face that lies on this one, in the same coordinates with z upwards: the sum of both is measured",
     {.form = request::Form::file}},
};
// clang-format on

}  // namespace of_surface
}  // namespace

std::string SurfaceOptionRow::flag_name() const {
    return "--" + (more.flag.empty() ? with_dashes(key) : std::string(more.flag));
}

bool SurfaceOptionRow::is_for(SurfaceKind kind) const {
    using enum OptionGroup;
    const bool profile = group == file_of_profile || group == form_of_profile;
    const bool map = group == step_of_map || group == file_of_map || group == cleaning_of_map;
    return !(profile && kind == SurfaceKind::map) && !(map && kind == SurfaceKind::profile);
}

bool SurfaceOptionRow::is_of_file() const {
    using enum OptionGroup;
    return group == file || group == file_of_profile || group == file_of_map;
}

Field SurfaceOptionRow::field_for(SurfaceKind kind) const {
    const bool of_profile = kind == SurfaceKind::profile && !more.help_of_profile.empty(),
               of_map = kind == SurfaceKind::map && !more.help_of_map.empty();
    Field field{.help = std::string(of_profile ? more.help_of_profile
                                    : of_map   ? more.help_of_map
                                               : help) +
                        (more.more_help ? more.more_help() : ""),
                .low = static_cast<double>(more.low),
                .high = static_cast<double>(more.high),
                .form = more.form};
    if (more.words) field.words = more.words(kind);
    return field;
}

std::span<const SurfaceOptionRow> surface_option_table() { return of_surface::rows; }

const SurfaceOptionRow& surface_option(std::string_view key) {
    for (const SurfaceOptionRow& row : of_surface::rows)
        if (row.key == key) return row;
    throw std::logic_error("no option of a surface is called " + std::string(key));
}

std::string with_dashes(std::string_view key) {
    std::string text(key);
    std::replace(text.begin(), text.end(), '_', '-');
    return text;
}

std::string option_name(std::string_view prefix, std::string_view key) {
    return prefix.empty() ? std::string(key) : std::string(prefix) + with_dashes(key);
}

std::string SurfaceOptions::name(std::string_view key) const {
    if (prefix.empty()) return std::string(key);
    return key == "format" ? std::string(format_name) : std::string(prefix) + with_dashes(key);
}

}  // namespace fstiff::surface
