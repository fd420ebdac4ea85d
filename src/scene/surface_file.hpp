// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// A measured surface: the options that say how a file is read, the reading, and the removal of the form.

#include "scene/cut_offs.hpp"
#include "scene/file.hpp"

#include <fstiff/core/error.hpp>
#include <fstiff/io/surface_file.hpp>
#include <fstiff/measured/prepare.hpp>
#include <fstiff/profile/fractal_fit.hpp>

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
    /// Gives up the map, whose memory is needed, and keeps its counts.
    [[nodiscard]] HeightMap<double> take_map();
};

/// \throws domain_error in one sentence with the name of the file.
[[nodiscard]] SurfaceInput read_surface_input(const SurfaceOptions& options);
/// The same from bytes that were read already.
[[nodiscard]] SurfaceInput read_surface_input(const SurfaceOptions& options, std::string bytes);

/// Heights that no file holds, cleaned as \p options say; options.file stands for them in messages, and \p origin says
/// where they come from. \throws domain_error for heights or steps that are no surface.
[[nodiscard]] SurfaceInput surface_of_heights(const SurfaceOptions& options, io::ProfileOrMap heights,
                                              const std::string& origin);

/// The options of the library for a surface, of a profile or of a map.
/// \throws option_error for the form of the other kind or a cut-off without its filter, domain_error when the surface
/// is of the other kind, and for cut-offs that the file cannot hold.
[[nodiscard]] fstiff::MeasureOptions<double> options_for_profile(const SurfaceOptions& options,
                                                                 const SurfaceInput& input);
[[nodiscard]] fstiff::MeasureOptions<double> options_for_map(const SurfaceOptions& options, const SurfaceInput& input);

/// The name of the form that was removed: one of Form, or gaussian_form; one of MapForm.
[[nodiscard]] std::string form_name(const LevelledProfile<double>& levelled);
[[nodiscard]] std::string form_name(const LevelledMap<double>& levelled);

/// prepare() for a profile. \throws as options_for_profile() and, with the name of the file, prepare().
[[nodiscard]] PreparedProfile<double> level_profile(const SurfaceOptions& options, const SurfaceInput& input);
/// prepare() for a map. \throws as above.
[[nodiscard]] PreparedMap<double> level_map(const SurfaceOptions& options, const SurfaceInput& input);
/// The same for an \p input that is not needed afterwards and gives up its map.
[[nodiscard]] PreparedMap<double> level_map_of(const SurfaceOptions& options, SurfaceInput& input);

/// A warning about an rms gradient that no surface has, found as \p origin says; empty for any other.
[[nodiscard]] std::string gradient_warning(double rms_gradient, std::string_view origin);
/// What the reading leaves in doubt: a sentence on missing points, where there are some, and the warnings of the
/// reader; and gradient_warning() of the \p rms_gradient that was measured, where it is known yet.
[[nodiscard]] std::vector<std::string> reading_warnings(const SurfaceInput& input, std::string_view consequence,
                                                        std::optional<double> rms_gradient = {});

/// A length with its unit, greater than 0, of the option called \p name in messages. \throws as parse_positive().
[[nodiscard]] double parse_length(const std::string& text, std::string_view name);
/// Two such lengths with a comma between them, each greater than 0, the first the shorter.
/// \throws option_error unless they are two and rise, domain_error as above.
[[nodiscard]] LagWindow<double> parse_window(const std::string& text, std::string_view name);

}  // namespace fstiff::scene
