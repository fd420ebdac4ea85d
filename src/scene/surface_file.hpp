// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// A measured surface: the options that say how a file is read, the reading, and the removal of the form.

#include "scene/cut_offs.hpp"
#include "scene/file.hpp"

#include <fstiff/core/error.hpp>
#include <fstiff/io/surface_file.hpp>
#include <fstiff/profile/fractal_fit.hpp>
#include <fstiff/profile/level.hpp>
#include <fstiff/topography/areal_statistics.hpp>
#include <fstiff/topography/form.hpp>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fstiff::scene {

/// Columns of a profile of text, as io/number_table.hpp bounds them.
inline constexpr int most_columns = static_cast<int>(io::max_profile_columns);

/// How a file is read; a file name alone will do. What is left empty is taken from the file, or by default.
struct SurfaceOptions {
    std::string file;                   ///< "-" is standard input
    std::string format = "auto";        ///< auto, profile, triples, matrix, sdf, x3p, npy, gsf, gwy, sur or smd
    std::string units;                  ///< "um,nm" (lengths, heights) or "um" (both)
    std::string spacing;                ///< of a profile
    std::string dx, dy, width, height;  ///< of a matrix
    int column = 0;                     ///< of the heights of a profile, counted from 1
    int x_column = 0;                   ///< of its positions
    std::string missing;                ///< stands for missing points of a text: "-9999", or "none"
    bool resample = false;              ///< unequally spaced positions of a profile are interpolated
    std::string x3p_increment;          ///< apply (or empty) or ignore
    std::string channel;                ///< of gwy: its number or its title
    std::string crop, mask;             ///< a part of the surface, "x0,x1" or "x0,x1,y0,y1"; a file of 0 and 1
    double spikes = 0;                  ///< become missing beyond so many standard deviations; 0: none
    bool fill = false;                  ///< missing points are filled
    std::string detrend;                ///< see remove_form(); empty: "line" of a profile, "plane" of a map
    std::string cutoff;                 ///< of detrend = "gaussian"
    std::string lambda_s, lambda_c;     ///< cut-offs of short and of long waves: a length, "none", or "auto" (or empty)
    CutOffFilter filter = CutOffFilter::gaussian;  ///< of lambda_c
    std::string tip_radius, resolution;  ///< of the instrument: they bound lambda_s = "auto" and the lags of D
    /// How messages call the options above: of a command line "--spacing", of a scene's key "spacing".
    std::string_view prefix{};
    std::string_view format_name = "format";
};

/// SurfaceOptions::detrend of a profile beside the forms: the line, then the filter of ISO 16610-21.
inline constexpr std::string_view gaussian_form = "gaussian";

struct SurfaceInput {
    io::Surface surface;
    std::string sha256;

    struct Counts {
        std::size_t points, missing;
    };
    std::optional<Counts> dropped{};  ///< of the map whose heights were given up

    [[nodiscard]] std::size_t points() const;  ///< missing ones included
    [[nodiscard]] std::size_t missing() const;
    /// Gives up the heights of the map, whose memory is needed, and keeps their counts.
    void drop_map();
};

/// \throws domain_error in one sentence with the name of the file.
[[nodiscard]] SurfaceInput read_surface_input(const SurfaceOptions& options);
/// The same from bytes that were read already.
[[nodiscard]] SurfaceInput read_surface_input(const SurfaceOptions& options, std::string bytes);

/// Heights that no file holds, cleaned as \p options say; options.file stands for them in messages, and \p origin says where
/// they come from. \throws domain_error for heights or steps that are no surface.
[[nodiscard]] SurfaceInput surface_of_heights(const SurfaceOptions& options, io::ProfileOrMap heights,
                                              const std::string& origin);

/// A profile without its form and, with cut-offs, without its short and its long waves.
struct PreparedProfile : LevelledProfile<double> {
    double rms_as_read{}, rms{};  ///< Rq before and after [m]
    double rms_levelled{};        ///< without the form, before the cut-offs [m]
    double rms_gradient{};        ///< after them, root of twice the mean square slope between neighbours
    std::string form;             ///< that was removed, by name
    CutOffs cut_offs;             ///< lambda_c is the cut-off of detrend = "gaussian" too
};

/// A map without its form and, with cut-offs, without its short and its long waves.
struct PreparedMap : LevelledMap<double> {
    double rms_as_read{}, rms{};  ///< Sq before and after [m]
    double rms_levelled{};        ///< without the form, before the cut-offs [m]
    ArealStatistics<double> areal;
    std::string form;
    CutOffs cut_offs;
};

/// Removes none, mean, line, parabola or gaussian (line, then the filter of ISO 16610-21 with the cut-off), then the waves
/// below lambda_s, then those above lambda_c.
/// \throws option_error for the form of a map or a cut-off without its filter, domain_error when the surface is a map, and
/// for cut-offs that the file cannot hold.
[[nodiscard]] PreparedProfile level_profile(const SurfaceOptions& options, const SurfaceInput& input);
/// Removes none, mean, plane, quadratic or cubic, then the waves beyond the cut-offs. \throws as above.
[[nodiscard]] PreparedMap level_map(const SurfaceOptions& options, const SurfaceInput& input);
/// The same of an \p input that is needed no more: it gives up its map on the way, so that no more than two are held at once.
[[nodiscard]] PreparedMap level_map_of(const SurfaceOptions& options, SurfaceInput& input);
/// The form alone removed, once for several cut-offs: it stands in `unfiltered`, which the maps behind them share. \p input gives
/// up its map. \throws as level_map().
[[nodiscard]] PreparedMap map_without_form(const SurfaceOptions& options, SurfaceInput& input);
/// The map behind the cut-offs of \p options of what map_without_form() returned. \throws as level_map().
[[nodiscard]] PreparedMap with_cut_offs(const SurfaceOptions& options, PreparedMap without_form);
/// The cut-offs of \p map by \p options. \throws as cut_offs_of().
[[nodiscard]] CutOffs map_cut_offs(const SurfaceOptions& options, const HeightMap<double>& map);

/// A warning about an rms gradient that no surface has, found as \p origin says; empty for any other.
[[nodiscard]] std::string gradient_warning(double rms_gradient, std::string_view origin);
/// What the reading leaves in doubt: a sentence on missing points, where there are some, and the warnings of the reader; and
/// gradient_warning() of the \p rms_gradient that was measured, where it is known yet.
[[nodiscard]] std::vector<std::string> reading_warnings(const SurfaceInput& input, std::string_view consequence,
                                                        std::optional<double> rms_gradient = {});

/// A length with its unit, greater than 0, of the option called \p name in messages. \throws as parse_positive().
[[nodiscard]] double parse_length(const std::string& text, std::string_view name);
/// Two such lengths with a comma between them, each greater than 0, the first the shorter.
/// \throws option_error unless they are two and rise, domain_error as above.
[[nodiscard]] LagWindow<double> parse_window(const std::string& text, std::string_view name);

}  // namespace fstiff::scene
