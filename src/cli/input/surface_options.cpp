// SPDX-License-Identifier: BSD-3-Clause
#include "input/surface_options.hpp"

#include <algorithm>

namespace fstiff::cli {

void add_surface_options(Arguments& arguments, SurfaceOptions& options, SurfaceKind kind) {
    options.prefix = "--";
    options.format_name = "--input-format";
    const bool profiles = kind != SurfaceKind::map, maps = kind != SurfaceKind::profile;
    arguments
        .option("--input-format", options.format,
                "form of the file: auto (default), profile, triples, matrix, sdf, x3p, npy, gsf, gwy, sur or smd")
        .one_of(choices<io::SurfaceFormat>());
    arguments.option(
        "--units", options.units,
        "units of lengths and heights of a text or .npy, such as um,nm, or one for both; replace those of the file");
    arguments.option(
        "--missing", options.missing,
        "number or word that stands for missing points of a text or .npy, such as -9999; none: every number is a "
        "height");
    arguments
        .option("--x3p-increment", options.x3p_increment,
                "of X3P with heights of floating point: apply the increment of z (default) or ignore it")
        .one_of(choices<io::X3pIncrement>());
    arguments.option("--channel", options.channel,
                     "of a Gwyddion file (.gwy): number or title of the channel; default the lowest in lengths");
    std::vector<std::string_view> words;
    const auto allow = [&](std::span<const std::string_view> more) {
        for (const std::string_view word : more)
            if (std::find(words.begin(), words.end(), word) == words.end()) words.push_back(word);
    };
    std::string forms;
    if (profiles) {
        allow(choices<Form>());
        words.push_back(gaussian_form);
        forms = "; of a profile none, mean, line (default), parabola or gaussian";
        arguments.option("--spacing", options.spacing,
                         "distance of neighbouring points of a profile, such as \"0.5 um\"; replaces that of the file");
        arguments
            .option("--column", options.column,
                    "column of the heights of a profile, counted from 1; default the last of one or two")
            .between(1, most_columns);
        arguments
            .option("--x-column", options.x_column,
                    "column of the positions of a profile, counted from 1; default the first that does not number the "
                    "points")
            .between(1, most_columns);
        arguments.flag("--resample", options.resample,
                       "a profile of unequal steps is interpolated at as many equal ones");
        arguments.option("--cutoff", options.cutoff,
                         "wavelength that the Gaussian filter (ISO 16610-21) halves, such as \"0.8 mm\"");
    }
    if (maps) {
        allow(choices<MapForm>());
        forms += "; of a map none, mean, plane (default), quadratic or cubic";
        arguments.option("--dx", options.dx,
                         "distance of neighbouring columns of a matrix or .npy; replaces the one in the file");
        arguments.option("--dy", options.dy, "distance of neighbouring rows of a matrix or .npy");
        arguments.option("--width", options.width,
                         "width of a matrix or .npy (number of columns times dx), instead of --dx");
        arguments.option("--height", options.height,
                         "height of a matrix or .npy (number of rows times dy), instead of --dy");
    }
    arguments.option(
        "--crop", options.crop,
        maps ? "part that is kept: \"x0,x1\" of a profile, \"x0,x1,y0,y1\" of a map, such as \"0,1 mm,0,1 mm\""
             : "part that is kept: \"x0,x1\", such as \"0,1 mm\"");
    arguments.option("--mask", options.mask,
                     "file of 0 and 1 with the shape of the surface, text or .npy: points of 0 become missing");
    arguments
        .option(
            "--spikes", options.spikes,
            "points farther than so many robust standard deviations, such as 5, from the median of their neighbours "
            "become missing")
        .between(3.0, 1000.0);
    arguments.flag("--fill", options.fill,
                   "missing points are filled: by straight lines in a profile, by Laplace's equation in a map");
    arguments.option("--detrend", options.detrend, "form that is removed before anything is computed" + forms)
        .one_of(words);
    arguments.option(
        "--lambda-s", options.lambda_s,
        "shortest waves that are kept, such as \"1 um\": the Gaussian filter (ISO 16610-21 and -61) halves "
        "them once the form is removed; auto (default) takes the standards' index of five steps; none keeps all");
    arguments.option(
        "--lambda-c", options.lambda_c,
        "longest waves that are kept, such as \"0.8 mm\", after --lambda-s; auto (default) takes that of the "
        "standards' table for a profile of five of them, and none for a map; none keeps all");
    arguments.option(
        "--filter", options.filter,
        "filter of --lambda-c: gaussian (default), or robust (ISO 16610-31 and -71), whose mean line grooves and "
        "spikes do not draw towards them");
}

std::string source_lines(const SurfaceInput& input, std::string_view indent) {
    std::string text;
    for (const std::string& decision : input.surface.record.sentences()) text += std::string(indent) + decision + "\n";
    return text;
}

}  // namespace fstiff::cli
