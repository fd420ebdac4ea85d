// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Reads X3P files: a zip archive of main.xml and the heights. Needs libzip and pugixml.
///
/// main.xml may lie in a folder of the archive, and its root element in any namespace or in none; other files are left
/// alone. Heights are number times increment plus offset, of the types I (int16), L (int32), F and D, from a file
/// or from the list in main.xml. Missing points are NaN, an empty Datum, or not set in the mask of valid points (one
/// bit a point, the least significant first). Rows keep the order of the file.
///
/// Names in the archive are compared, never used as paths. Sizes are compared with the limits and with what main.xml
/// declares before anything is inflated. The CRC of the archive is verified, MD5 sums are not.
///
/// Reference   ISO 25178-72:2017 (ISO 5436-2). Refused: absolute x or y axes, layers (SizeZ > 1), point clouds.
/// Units       map in m, as the increments of the file
/// Valid       2 points a side at least, or one profile (dy = dx where the file states none), of heights that vary;
///             files up to 2^30 bytes
/// Accuracy    number times increment, plus offset where there is one, each rounded once (tests/io/x3p_test.cpp)

#include "io/profile_or_map.hpp"

namespace fstiff::io {

/// What was found in a file.
struct X3pRecord {
    std::string name;
    std::string main;        ///< of main.xml in the archive
    std::string data;        ///< of the heights in the archive; empty when they are in main.xml
    char data_type{};        ///< I, L, F or D
    std::string instrument;  ///< printable characters only
    std::size_t side_files{};
    std::size_t columns{}, rows{};
    std::size_t missing{};
    bool mask{};           ///< there is a mask of valid points
    double increment = 1;  ///< of the z axis, as the file states it
    bool applied = true;   ///< the heights are times the increment

    /// Heights of floating point with an increment that changes them: two readings are possible.
    [[nodiscard]] bool doubtful() const { return (data_type == 'F' || data_type == 'D') && increment != 1; }

    /// The above as sentences for people, one a line, without a full stop.
    [[nodiscard]] std::vector<std::string> sentences() const;
};

/// What an X3P file holds.
struct X3pSurface {
    HeightMap<double> map;  ///< of one row when the file holds a profile
    X3pRecord record;
};

/// \throws domain_error naming file, element, value and what is allowed.
[[nodiscard]] X3pSurface read_x3p(std::string_view bytes, std::string_view name, const X3pLimits& limits = {},
                                  X3pIncrement increment = X3pIncrement::apply);
/// Reads all of \p input.
[[nodiscard]] X3pSurface read_x3p(std::istream& input, std::string_view name, const X3pLimits& limits = {});
/// Reads the file \p path. \throws file_error when it cannot be opened or read.
[[nodiscard]] X3pSurface read_x3p(const std::filesystem::path& path, const X3pLimits& limits = {});

/// With the record as sentences, and the other reading that the increment allows as a warning.
[[nodiscard]] DescribedMap described_x3p(std::string_view bytes, std::string_view name, const SurfaceOptions& options);

}  // namespace fstiff::io
