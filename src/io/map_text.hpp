// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Reads a height map from delimited text, and records every decision it took about the file.
///
/// Two forms. A *matrix* has a row of the map a line, its size and units in a header of "key: value" or "key = value"
/// lines, with or without a comment sign: Gwyddion's "# Width: 10 um", "# Height: 5 um", "# Value units: m"; "dx",
/// "pixel size" and the like; "h=305 w=75" is compared with what is there; heights in another unit (rad) need a
/// "height conversion factor (-> m)". *Triples* have x, y and z a line, in any order of the points; the grid is
/// recovered from the coordinates, x and y rise in the map, and points that are not there are missing.
/// Exports of Keyence ("XY Calibration","277.8","nm"), of SPIP ("# x-length = 2000", in nm, "# Bit2nm = 0.5") and of
/// Gwyddion in other languages are matrices too (<fstiff/io/header_words.hpp>).
/// Three columns are triples where x and y form a grid, a matrix where the header states a size; otherwise the form
/// must be given. Four and more are triples too where the first two form a grid that is filled, or are called x and y; what
/// is not x, y or z is left out. A matrix may have positions as its first row and column (io/matrix_axes.hpp), which give its
/// steps. Zygo's XYZ text has its pixel in the header. Missing points are empty cells,
/// "nan", "NA", "N/A", "BAD", "No Data", "***" and the number that the header ("NODATA_value -9999") or the options name. Rows of a matrix keep the order of the file.
///
/// Nothing is guessed: without units, without a physical size, or with points off the grid, the file is refused.
///
///     dx = width / columns,    dy = height / rows               a point stands for a cell, as in Gwyddion
///
/// Units       map in m; MapTextOptions::units are the file's
/// Valid       2 points a side at least, of heights that vary; lines up to 2^20 characters, files up to 2^31
/// Accuracy    heights and a stated pitch within 1 ulp of the printed number (tests/io/map_text_test.cpp)

#include "io/map_table.hpp"

#include <fstiff/topography/height_map.hpp>

namespace fstiff::io {

/// What the text of a map does not say itself.
struct MapTextOptions {
    MapForm form = MapForm::automatic;
    std::optional<double> dx{}, dy{};         ///< of a matrix, between points [m]; replace the header's
    std::optional<double> width{}, height{};  ///< of a matrix, columns dx and rows dy [m]; replace the header's
    std::string units{};                      ///< "um,nm" (x and y, heights), "um,um,nm" or "um" (all)
    std::string missing{};                    ///< stands for missing points: "-9999", "void", both, or "none"
    OptionNames names{};                      ///< for messages
};

/// What was decided about a file, and why.
struct MapTextRecord : TextRecord {
    MapForm form{};
    std::string form_from;  ///< why it is triples, or a matrix
    std::string units;      ///< of x and y (where the file needs them) and of the heights
    std::string size_from;  ///< where dx and dy come from
    std::size_t columns{}, rows{};
    std::string columns_text;  ///< which columns are used, or what the axes are; empty where all are heights or triples

    /// The above as sentences for people, one a line, without a full stop.
    [[nodiscard]] std::vector<std::string> sentences() const;
};

/// A map, and how its text was taken.
struct MapFromText {
    HeightMap<double> map;
    MapTextRecord record;
};

/// Reads what \p table has opened, whose text must outlive the call.
[[nodiscard]] MapFromText read_map(detail::MapTable table, const MapTextOptions& options);

/// Reads all of \p input; \p name stands for it in messages.
/// \throws domain_error naming file, line, value and what is allowed.
[[nodiscard]] MapFromText read_map(std::istream& input, std::string_view name, const MapTextOptions& options = {});

/// Reads the file \p path. \throws file_error when it cannot be opened or read.
[[nodiscard]] MapFromText read_map(const std::filesystem::path& path, const MapTextOptions& options = {});

}  // namespace fstiff::io
