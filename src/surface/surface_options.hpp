// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The options of a measured surface. surface_option_table.hpp has their names, ranges and help.

#include "request/field.hpp"

#include <fstiff/io/surface_file.hpp>
#include <fstiff/measure/options.hpp>
#include <fstiff/profile/fractal_fit.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fstiff::surface {

using request::Amount;
using request::Field;

/// How a file is read, cleaned and measured. What is left empty is taken from the file, or by default.
struct SurfaceOptions {
    std::string file;  ///< "-" is standard input
    io::SurfaceFormat format = io::SurfaceFormat::automatic;
    std::string units;                              ///< "um,nm" (lengths, heights) or "um" (both)
    Amount spacing;                                 ///< of a profile
    Amount dx, dy, width, height;                   ///< of a matrix
    int column = 0;                                 ///< of the heights of a profile, counted from 1
    int x_column = 0;                               ///< of its positions
    std::string columns, channels;                  ///< each a part of one surface: "2-180", "1,3"
    std::string missing;                            ///< marks missing points of a text: "-9999", or "none"
    std::string thousands;                          ///< separates thousands in a text: ",", or "none"
    bool resample = false;                          ///< unequally spaced positions of a profile are interpolated
    std::optional<io::X3pIncrement> x3p_increment;  ///< none: apply
    std::string channel;                            ///< of gwy: its number or its title
    Amount grid;                                    ///< step of the grid on which points are put
    std::string facing;                             ///< file of the face on this one, in the same coordinates
    Amount crop;                                    ///< a part of the surface: x0, x1, and y0, y1 of a map
    std::string mask;                               ///< a file of 0 and 1
    LineAlignment align = LineAlignment::none;      ///< of the scan lines of a map
    ScanAxis scan_axis = ScanAxis::automatic;
    double spikes = 0;          ///< become missing beyond so many standard deviations; 0: none
    bool fill = false;          ///< missing points are filled
    std::string detrend;        ///< empty: "line" of a profile, "plane" of a map
    Amount radius;              ///< of detrend = "circle", "sphere" or "cylinder"
    Amount cutoff;              ///< of detrend = "gaussian"
    Amount lambda_s, lambda_c;  ///< cut-offs of short and of long waves: a length, "none", or "auto" (or empty)
    CutOffFilter filter = CutOffFilter::gaussian;  ///< of lambda_c
    PeakSource peaks = PeakSource::islands;        ///< of a map
    Amount tip_radius, resolution;  ///< of the instrument: they bound lambda_s = "auto" and the lags of D
    Amount window;                  ///< of the lags that give D: the shortest and the longest
    /// How messages call the options above: of a command line "--spacing", of a scene's key "spacing".
    std::string_view prefix{};
    std::string_view format_name = "format";

    /// The file and every option; defined with their table, in surface_option_table.hpp.
    template <class Take>
    void each_field(Take take);
    /// How messages call the option of \p key: "x_column", or "--x-column" on a command line.
    [[nodiscard]] std::string name(std::string_view key) const;
};

/// SurfaceOptions::detrend of a profile in addition to the forms: the line, then the filter of ISO 16610-21.
inline constexpr std::string_view gaussian_form = "gaussian";

/// The parts of \p text between its commas.
[[nodiscard]] std::vector<std::string> split_at_commas(const std::string& text);
/// One length greater than 0 [m], of the option called \p name in messages. \throws domain_error, which quotes it.
[[nodiscard]] double parse_length(const Amount& given, std::string_view name);
/// Two lengths greater than 0, the first the shorter.
/// \throws option_error unless they are two and rise, domain_error as above.
[[nodiscard]] LengthRange<double> parse_window(const Amount& given, std::string_view name);
/// Any number of lengths, which may be 0. \throws domain_error for a text that is none.
[[nodiscard]] std::vector<double> parse_lengths(const Amount& given, std::string_view name);
/// A cut-off: a length greater than 0, "none", or "auto" (or empty). \throws domain_error as above.
[[nodiscard]] CutOff<double> parse_cut_off(const Amount& given, std::string_view name);

}  // namespace fstiff::surface
