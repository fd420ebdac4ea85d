// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Reader of measured files: a profile or a map, the recognised form and all decisions. Compiled: link fstiff::io.
///
/// First bytes identify surface data files (SDF), X3P, NumPy, MATLAB, Gwyddion, Digital Surf, Surfer, profiles of ISO
/// 5436-2, maps of Zygo, Keyence, Wyko, Alicona and Sensofar, and meshes (PLY, OBJ). The columns of the first row
/// identify text: 1 or 2 a profile, 3 triples x, y, z on a grid, else a matrix of stated size, 4 or more a matrix
/// unless titles or SurfaceOptions::column name columns of a profile. SurfaceOptions::grid puts points and meshes on a
/// grid. An ambiguous file is refused with the option `format` that decides. Rules of text and of each form:
/// docs/formats.md.
///
/// Units       profile and map in m; SurfaceOptions::units are those of the file
/// Valid       profiles of at least 16 points, maps of at least 2 points a side, heights that vary; files up to 2^31
///             bytes, SDF and X3P up to 2^30; lines of text up to 2^20 characters; see the readers in src/io
/// Accuracy    the printed or stored numbers times their unit, each rounded once, or twice where the file has a scale
///             too (tests/io/surface_file_test.cpp, and the test of each reader)

#include <fstiff/core/names.hpp>
#include <fstiff/profile/profile.hpp>
#include <fstiff/topography/height_map.hpp>

#include <array>
#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace fstiff { inline namespace v0_1 { namespace io {

/// Forms of files that are read.
enum class SurfaceFormat {
    automatic,
    profile,
    triples,
    matrix,
    sdf,
    x3p,
    npy,
    gsf,
    gwy,
    sur,
    smd,
    metropro,
    vk4,
    opd,
    al3d,
    plu,
    plux,
    netcdf,
    opdx,
    zygo,
    surfer,
    mat,
    ply,
    obj
};

/// Use of the z increment for X3P heights in floating point: ISO 25178-72 multiplies by it, but some programs write an
/// increment that must not be applied.
enum class X3pIncrement { apply, ignore };

}}}  // namespace fstiff::io

namespace fstiff { inline namespace v0_1 {

template <>
inline constexpr auto enum_names<io::SurfaceFormat> = fstiff::detail::name_list<io::SurfaceFormat>({
    {io::SurfaceFormat::automatic, "auto"},  {io::SurfaceFormat::profile, "profile"},
    {io::SurfaceFormat::triples, "triples"}, {io::SurfaceFormat::matrix, "matrix"},
    {io::SurfaceFormat::sdf, "sdf"},         {io::SurfaceFormat::x3p, "x3p"},
    {io::SurfaceFormat::npy, "npy"},         {io::SurfaceFormat::gsf, "gsf"},
    {io::SurfaceFormat::gwy, "gwy"},         {io::SurfaceFormat::sur, "sur"},
    {io::SurfaceFormat::smd, "smd"},         {io::SurfaceFormat::metropro, "metropro"},
    {io::SurfaceFormat::vk4, "vk4"},         {io::SurfaceFormat::opd, "opd"},
    {io::SurfaceFormat::al3d, "al3d"},       {io::SurfaceFormat::plu, "plu"},
    {io::SurfaceFormat::plux, "plux"},       {io::SurfaceFormat::netcdf, "netcdf"},
    {io::SurfaceFormat::opdx, "opdx"},       {io::SurfaceFormat::zygo, "zygo"},
    {io::SurfaceFormat::surfer, "surfer"},   {io::SurfaceFormat::mat, "mat"},
    {io::SurfaceFormat::ply, "ply"},         {io::SurfaceFormat::obj, "obj"},
});
template <>
inline constexpr auto enum_names<io::X3pIncrement> = fstiff::detail::name_list<io::X3pIncrement>(
    {{io::X3pIncrement::apply, "apply"}, {io::X3pIncrement::ignore, "ignore"}});

}}  // namespace fstiff

namespace fstiff { inline namespace v0_1 { namespace io {

/// Form, other than a table of numbers, that begins like \p bytes; automatic where none matches.
[[nodiscard]] SurfaceFormat form_of_first_bytes(std::string_view bytes);
/// Whether fstiff::io was built with zlib and pugixml, which X3P needs.
[[nodiscard]] bool reads_x3p();
/// Whether fstiff::io was built with zlib, which compressed files of Digital Surf need.
[[nodiscard]] bool reads_compressed_sur();

/// Names of the options of a reader in messages: units = "um" in a program, --units "um" on a command line.
struct OptionNames {
    std::string prefix{};           ///< before the name of an option
    std::string format = "format";  ///< the whole name of the option for the form
    std::string equals = " = ";     ///< between an option and its value
};

/// Limits of the inflated data of an X3P file. Measured heights shrink to a half or a tenth.
struct X3pLimits {
    std::uint64_t bytes = std::uint64_t(1) << 30;  ///< of one file of the archive
    std::uint64_t ratio = 200;                     ///< inflated to deflated, above 2^20 bytes
    std::int64_t files = 10000;                    ///< in the archive
};

/// Options of the readers; only those that apply to the form may be given.
struct SurfaceOptions {
    SurfaceFormat format = SurfaceFormat::automatic;
    std::string units{};  ///< of text, npy, mat, surfer: "um,nm" (lengths, heights), "um" (both); replaces the header's
    std::optional<double>
        spacing{};             ///< of a profile, of npy, mat of a map too [m]; replaces the positions of the file
    std::size_t column = 0;    ///< of a profile, with the heights, counted from 1; 0: the last of one or two
    std::size_t x_column = 0;  ///< of a profile, with the positions, counted from 1; 0: the first that may be
    std::optional<double> dx{}, dy{};         ///< of a matrix, npy, mat, between points [m]
    std::optional<double> width{}, height{};  ///< of a matrix, npy, mat: columns dx and rows dy [m]
    std::string missing{};    ///< of text, npy, mat, surfer: marks missing points: "-9999", "void", both, or "none"
    std::string thousands{};  ///< of text, separator of thousands: "," "." "'" or " "; "none": commas are decimal
    bool resample = false;    ///< of a profile: unequally spaced positions are interpolated
    X3pIncrement x3p_increment = X3pIncrement::apply;  ///< of X3P with floating-point heights
    X3pLimits x3p_limits{};
    std::string channel{};         ///< of gwy, text, mat: number or title; empty: the lowest in lengths or only one
    std::optional<double> grid{};  ///< of triples, ply and obj: step of the grid on which the points are put [m]
    std::optional<std::array<double, 2>> grid_origin{};  ///< a point of that grid [m]; none: by the points
    OptionNames names{};                                 ///< for messages
};

namespace detail {
/// Columns of which a profile may choose one.
inline constexpr std::size_t max_profile_columns = 4096;
}  // namespace detail

/// Form of a file and the decisions of its reader.
struct SurfaceRecord {
    std::string name;
    SurfaceFormat format{};
    std::string format_from;              ///< how the form was recognised
    std::vector<std::string> details{};   ///< of the reader of that form
    std::vector<std::string> warnings{};  ///< of readings that may be wrong, with the option of the other
    double resolution{};  ///< step in which the heights are printed or counted [m]; 0 where it is not known
    std::optional<std::array<double, 2>> origin{};  ///< x and y of the first point of a map [m], where they are stated

    /// These decisions as sentences for people, one a line, without a full stop.
    [[nodiscard]] std::vector<std::string> sentences() const;
};

/// Content of a measured file.
using ProfileOrMap = std::variant<Profile<double>, HeightMap<double>>;

/// A profile or a map from any file, and how it was read.
struct Surface {
    ProfileOrMap data;
    SurfaceRecord record;

    [[nodiscard]] bool is_profile() const { return data.index() == 0; }
    [[nodiscard]] const Profile<double>& profile() const { return std::get<0>(data); }
    [[nodiscard]] const HeightMap<double>& map() const { return std::get<1>(data); }
};

namespace detail {

/// Heights in row order; one row is a profile. Compiled code returns no array of Eigen, because a program can free one
/// only where both were compiled for the same processor.
struct RawMap {
    std::vector<double> heights;  ///< [m], NaN where missing
    std::size_t rows{}, columns{};
    double dx{}, dy{};  ///< [m]

    [[nodiscard]] double at(std::size_t row, std::size_t column) const { return heights[row * columns + column]; }
};

/// Conversion of the raw result of read_surface() to a Surface.
struct ReadSurface {
    RawMap map;
    SurfaceRecord record;
};
[[nodiscard]] ReadSurface read(std::string bytes, std::string_view name, const SurfaceOptions& options);
[[nodiscard]] ReadSurface read(std::istream& input, std::string_view name, const SurfaceOptions& options);
[[nodiscard]] ReadSurface read(const std::filesystem::path& path, const SurfaceOptions& options);

[[nodiscard]] inline Surface surface_of(ReadSurface read) {
    RawMap& raw = read.map;
    if (raw.rows == 1) return {Profile<double>{std::move(raw.heights), raw.dx}, std::move(read.record)};
    HeightMap<double> map;
    map.heights = Eigen::Map<const HeightMap<double>::Array>(raw.heights.data(), static_cast<Eigen::Index>(raw.rows),
                                                             static_cast<Eigen::Index>(raw.columns));
    map.dx = raw.dx;
    map.dy = raw.dy;
    return {std::move(map), std::move(read.record)};
}

}  // namespace detail

/// Reads the bytes of a file; \p name denotes it in messages.
/// \throws domain_error naming file, place, value and what is allowed, or the option that resolves an ambiguity.
[[nodiscard]] inline Surface read_surface(std::string bytes, std::string_view name,
                                          const SurfaceOptions& options = {}) {
    return detail::surface_of(detail::read(std::move(bytes), name, options));
}
/// Reads all of \p input.
[[nodiscard]] inline Surface read_surface(std::istream& input, std::string_view name,
                                          const SurfaceOptions& options = {}) {
    return detail::surface_of(detail::read(input, name, options));
}
/// Reads the file \p path. \throws file_error when it cannot be opened or read.
[[nodiscard]] inline Surface read_surface(const std::filesystem::path& path, const SurfaceOptions& options = {}) {
    return detail::surface_of(detail::read(path, options));
}

}}}  // namespace fstiff::io
