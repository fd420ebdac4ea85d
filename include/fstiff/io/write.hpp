// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Writers of profiles and maps as delimited text and as surface data files (SDF). read_surface() of
/// <fstiff/io/surface_file.hpp> reads both back bit for bit. Compiled: link fstiff::io.
///
/// A profile as text has rows of x and z, triples have rows of x, y and z, separated by commas below a line of titles
/// with units. A matrix has a row of the map per line, separated by tabs below the header that Gwyddion writes, with
/// dx and dy in addition to width and height. The header contains the exact spacings; positions are multiples of them,
/// rounded. A missing point is an empty cell of a profile, "nan" in a map.
///
/// Reference   ISO 25178-71:2017 (versions 1.0, 2.0) for SDF
/// Units       m, stated in the header; Zscale of SDF is 1
/// Valid       data that the readers accept: 16 points of a profile, 2 a side of a map, heights that vary; 2 points of
///             a profile as SDF
/// Accuracy    heights and spacings come back bit for bit (tests/io/write_csv_test.cpp, tests/io/write_sdf_test.cpp)

#include <fstiff/core/names.hpp>
#include <fstiff/profile/profile.hpp>
#include <fstiff/topography/height_map.hpp>

#include <iosfwd>
#include <string>

namespace fstiff { inline namespace v0_1 { namespace io {

/// Layout of the text of a map.
enum class MapForm { automatic, triples, matrix };

}}}  // namespace fstiff::io

namespace fstiff { inline namespace v0_1 {

template <>
inline constexpr auto enum_names<io::MapForm> = fstiff::detail::name_list<io::MapForm>(
    {{io::MapForm::automatic, "automatic"}, {io::MapForm::triples, "triples"}, {io::MapForm::matrix, "matrix"}});

}}  // namespace fstiff

namespace fstiff { inline namespace v0_1 { namespace io {

/// Writes a profile as text.
/// \throws domain_error when the profile is not valid, file_error when the output fails.
void write_csv(std::ostream& output, const Profile<double>& profile);
/// Writes a map as MapForm::matrix or MapForm::triples.
void write_csv(std::ostream& output, const HeightMap<double>& map, MapForm form = MapForm::matrix);

/// Header fields of a surface data file in addition to the map.
struct SdfOptions {
    bool binary = true;
    std::string manufacturer = "fstiff";  ///< at most 10 printable ASCII characters
    std::string date = "010120000000";    ///< of creation and change, DDMMYYYYHHMM
};

/// Writes numbers of double precision, version ISO-1.0 (ISO-2.0 where a side of a binary map exceeds 65535 points).
/// \throws domain_error when the map, or an option, cannot be written, file_error when the output fails.
void write_sdf(std::ostream& output, const HeightMap<double>& map, const SdfOptions& options = {});
/// Writes a file of one profile, whose Yscale is the spacing too.
void write_sdf(std::ostream& output, const Profile<double>& profile, const SdfOptions& options = {});

}}}  // namespace fstiff::io
