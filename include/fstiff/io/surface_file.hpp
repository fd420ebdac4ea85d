// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// A measured file of any known form: a profile or a map, with the form that was recognised and every decision.
///
/// Surface data files, X3P, arrays of NumPy, files and simple fields of Gwyddion, files of Digital Surf and profiles of
/// ISO 5436-2 are known by their first bytes. Other text is known by the columns of its first row: one or two
/// make a profile; three are x, y, z triples where x and y form a grid, else a matrix where a size is stated; four and
/// more are a matrix, unless they begin with x, y and z, titles with units stand above them, or SurfaceOptions::column says that
/// they are columns of a profile. Columns that number the points do not count (io/column_titles.hpp); a matrix may have
/// positions as its first row and column (io/matrix_axes.hpp). What could be two things is refused, naming the option `format` that decides.
/// Binary files of one row are profiles; an array of NumPy takes units and steps from the options.
///
/// Units       profile and map in m; SurfaceOptions::units are the file's
/// Valid       as <fstiff/io/profile_text.hpp>, <fstiff/io/map_text.hpp>, <fstiff/io/sdf.hpp>, <fstiff/io/npy.hpp>,
///             <fstiff/io/gsf.hpp>, <fstiff/io/gwy.hpp>, <fstiff/io/sur.hpp>, <fstiff/io/smd.hpp> and <fstiff/io/x3p.hpp>
/// Accuracy    as there (tests/io/surface_file_test.cpp)

#include <fstiff/core/names.hpp>
#include <fstiff/io/gsf.hpp>
#include <fstiff/io/gwy.hpp>
#include <fstiff/io/map_text.hpp>
#include <fstiff/io/npy.hpp>
#include <fstiff/io/profile_text.hpp>
#include <fstiff/io/sdf.hpp>
#include <fstiff/io/smd.hpp>
#include <fstiff/io/sur.hpp>

#include <functional>
#include <tuple>

namespace fstiff::io {

/// The forms of files that are read.
enum class SurfaceFormat { automatic, profile, triples, matrix, sdf, x3p, npy, gsf, gwy, sur, smd };

/// Heights of X3P that are numbers of floating point are times the increment of the z axis, as ISO 25178-72 says; some
/// programs write an increment that is not to be applied to them.
enum class X3pIncrement { apply, ignore };

}  // namespace fstiff::io

namespace fstiff {

template <>
inline constexpr auto names<io::SurfaceFormat> = name_list<io::SurfaceFormat>({
    {io::SurfaceFormat::automatic, "auto"},
    {io::SurfaceFormat::profile, "profile"},
    {io::SurfaceFormat::triples, "triples"},
    {io::SurfaceFormat::matrix, "matrix"},
    {io::SurfaceFormat::sdf, "sdf"},
    {io::SurfaceFormat::x3p, "x3p"},
    {io::SurfaceFormat::npy, "npy"},
    {io::SurfaceFormat::gsf, "gsf"},
    {io::SurfaceFormat::gwy, "gwy"},
    {io::SurfaceFormat::sur, "sur"},
    {io::SurfaceFormat::smd, "smd"},
});
template <>
inline constexpr auto names<io::X3pIncrement> = name_list<io::X3pIncrement>({{io::X3pIncrement::apply, "apply"},
                                                                             {io::X3pIncrement::ignore, "ignore"}});

}  // namespace fstiff

namespace fstiff::io {

/// "profile", "triples", "matrix", "sdf", "x3p", "npy", "gsf", "gwy", "sur", "smd" or "auto". \throws domain_error listing them.
[[nodiscard]] inline SurfaceFormat surface_format(std::string_view name);
/// The word of \p format, as surface_format() takes it.
[[nodiscard]] inline std::string_view surface_format_name(SurfaceFormat format);

/// A map and how it was read.
struct DescribedMap {
    HeightMap<double> map;
    std::vector<std::string> sentences;
    std::vector<std::string> warnings{};
    double resolution{};  ///< step in which the heights are counted [m]; 0 where it is not known
};

/// Only what the form has use for may be given.
struct SurfaceOptions {
    SurfaceFormat format = SurfaceFormat::automatic;
    std::string units{};  ///< of text and npy: "um,nm" (lengths, heights), "um" (both); replaces the header's
    std::optional<double> spacing{};   ///< of a profile and npy [m]; replaces the positions of the file
    std::size_t column = 0;            ///< of a profile, with the heights, counted from 1; 0: the last of one or two
    std::size_t x_column = 0;          ///< of a profile, with the positions, counted from 1; 0: the first that may be
    std::optional<double> dx{}, dy{};  ///< of a matrix and npy, between points [m]
    std::optional<double> width{}, height{};  ///< of a matrix and npy, columns dx and rows dy [m]
    std::string
        missing{};  ///< of text and npy, stands for missing points: "-9999", "void", both with a comma, or "none"
    bool resample = false;                             ///< of a profile: unequally spaced positions are interpolated
    X3pIncrement x3p_increment = X3pIncrement::apply;  ///< of X3P with heights of floating point
    std::string channel{};  ///< of gwy: its number or its title; empty: the lowest whose units are lengths
    OptionNames names{};    ///< for messages
    Inflate inflate{};      ///< of compressed sur: inflate_zlib() of <fstiff/io/inflate.hpp>, or nothing without zlib
    /// Reads the bytes of an X3P file: x3p_reader() of <fstiff/io/x3p.hpp>, or nothing where X3P is not there.
    std::function<DescribedMap(std::string_view bytes, std::string_view name, const SurfaceOptions& options)> x3p{};
};

/// How a file was taken.
struct SurfaceRecord {
    std::string name;
    SurfaceFormat format{};
    std::string format_from;            ///< how the form was recognised
    std::vector<std::string> details;   ///< of the reader of that form
    std::vector<std::string> warnings;  ///< of readings that may be wrong, with the option of the other
    double resolution{};  ///< step in which the heights are printed or counted [m]; 0 where it is not known

    /// The above as sentences for people, one a line, without a full stop.
    [[nodiscard]] std::vector<std::string> sentences() const;
};

/// A profile or a map of any file, and how it was taken.
struct Surface {
    ProfileOrMap data;
    SurfaceRecord record;

    [[nodiscard]] bool is_profile() const { return data.index() == 0; }
    [[nodiscard]] const Profile<double>& profile() const { return std::get<0>(data); }
    [[nodiscard]] const HeightMap<double>& map() const { return std::get<1>(data); }
};

/// Reads the bytes of a file; \p name stands for it in messages.
/// \throws domain_error naming file, place, value and what is allowed, or the option that resolves an ambiguity.
[[nodiscard]] inline Surface read_surface(std::string bytes, std::string_view name, const SurfaceOptions& options = {});
/// Reads the file \p path. \throws file_error when it cannot be opened or read.
[[nodiscard]] inline Surface read_surface(const std::filesystem::path& path, const SurfaceOptions& options = {});

namespace detail {

/// Refuses the options that \p format has no use for.
inline void check_options(SurfaceFormat format, const SurfaceOptions& options, const std::string& name) {
    const bool profile = format == SurfaceFormat::profile;
    const bool matrix = format == SurfaceFormat::matrix;
    const bool text = profile || matrix || format == SurfaceFormat::triples;
    const bool bare = format == SurfaceFormat::npy;  // states neither units nor steps
    const std::pair<const char*, bool> useless[] = {
        {"units", !options.units.empty() && !text && !bare},
        {"spacing", options.spacing && !profile && !bare},
        {"column", options.column != 0 && !profile},
        {"x-column", options.x_column != 0 && !profile},
        {"dx", options.dx && !matrix && !bare},
        {"dy", options.dy && !matrix && !bare},
        {"width", options.width && !matrix && !bare},
        {"height", options.height && !matrix && !bare},
        {"missing", !options.missing.empty() && !text && !bare},
        {"resample", options.resample && !profile},
        {"channel", !options.channel.empty() && format != SurfaceFormat::gwy},
        {"x3p-increment", options.x3p_increment != X3pIncrement::apply && format != SurfaceFormat::x3p}};
    for (const auto& [option, refused] : useless)
        if (refused)
            refuse_file(name, {"is read as ", surface_format_name(format), ", which has no use for ", option,
                               "; must not be given, or ", options.names.format, " must be another"});
}

/// The form of a text, and why.
inline std::pair<SurfaceFormat, std::string> text_form(MapTextReader& reader, const std::string& name,
                                                       const SurfaceOptions& options) {
    const std::size_t written = reader.opened().columns;  // in the first row
    const auto named = [](std::size_t columns) {
        return columns == 1 ? std::string("one column") : std::to_string(columns) + " columns";
    };
    const std::string found = named(written);
    const bool sized = options.dx || options.dy || options.width || options.height ||
                       stated_grid(reader.entries(), "m", name).has_size();
    const auto as = [&](const char* form) { return options.names.format_as(form); };
    const auto ambiguous = [&](const std::string& what, const std::string& choice) {
        refuse_file(name, {"has ", found, what, "; must be told by ", choice});
    };
    if (options.column != 0 || options.x_column != 0 || options.spacing)
        return {SurfaceFormat::profile, "options that only a profile has"};
    if (const auto form = stated_form(reader.entries()); form && written > 1)
        return {*form == MapForm::triples ? SurfaceFormat::triples : SurfaceFormat::matrix, "the header"};
    if (written <= 2) {
        if (sized && written == 2)
            ambiguous(" and the size of a map: may be a profile or a matrix", as("profile") + " or " + as("matrix"));
        return {SurfaceFormat::profile, found};
    }
    const std::size_t columns = reader.table(options.missing).columns;  // without those that number the points
    if (reader.is_zygo()) return {SurfaceFormat::triples, "the header"};
    if (reader.axes()) return {SurfaceFormat::matrix, MapTable::axes_from};
    if (columns <= 2) return {SurfaceFormat::profile, named(columns) + " next to one that numbers the points"};
    if (columns == 3) {
        const bool grid = reader.grid().has_value();
        if (grid && sized)
            ambiguous(", of which two form a grid, and a stated size: may be x, y, z triples or a matrix",
                      as("triples") + " or " + as("matrix"));
        if (grid) return {SurfaceFormat::triples, "three columns, the first two of which form a grid"};
        if (sized || written != 3) return {SurfaceFormat::matrix, found + " and a stated size"};
        ambiguous(
            ", of which the first two form no regular grid, and no stated size: may be scattered triples, a matrix "
            "or a profile with a column to choose",
            as("triples") + ", " + as("matrix") + ", or " + as("profile") + " with column");
    }
    if (reader.begins_with_triples()) {
        if (sized)
            ambiguous(", which begin with x, y and z, and a stated size: may be triples or a matrix",
                      as("triples") + " or " + as("matrix"));
        return {SurfaceFormat::triples, reader.triples_from()};
    }
    const NumberTable& opened = reader.opened();
    const bool titled =
        opened.first > 0 && !units_in(opened.lines[opened.first - 1].text, written, opened.dialect.separator).empty();
    if (titled && !sized)
        ambiguous(" with a unit above each: may be columns of a profile or a matrix",
                  as("profile") + " with column, or " + as("matrix"));
    reader.require_no_lone_axis(options.names);
    return {SurfaceFormat::matrix, found};
}

}  // namespace detail

inline SurfaceFormat surface_format(std::string_view name) {
    if (const auto format = find_named<SurfaceFormat>(name)) return *format;
    fstiff::detail::refuse("format", detail::shown_cell(name), "one of " + choices_text<SurfaceFormat>());
}

inline std::string_view surface_format_name(SurfaceFormat format) { return name_of(format); }

inline std::vector<std::string> SurfaceRecord::sentences() const {
    std::vector<std::string> all{"format: " + std::string(surface_format_name(format)) + ", from " + format_from};
    all.insert(all.end(), details.begin(), details.end());
    return all;
}

namespace detail {

/// Reads a text of the form record.format, which is chosen here where it is automatic.
inline void read_text(Surface& surface, const std::string& text, const SurfaceOptions& options) {
    SurfaceRecord& record = surface.record;
    std::optional<MapTextReader> map;
    if (record.format != SurfaceFormat::profile) map.emplace(text, record.name);
    if (record.format == SurfaceFormat::automatic)
        std::tie(record.format, record.format_from) = text_form(*map, record.name, options);
    check_options(record.format, options, record.name);
    if (record.format == SurfaceFormat::profile) {
        const ProfileTextOptions given{.spacing = options.spacing,
                                       .units = options.units,
                                       .column = options.column,
                                       .x_column = options.x_column,
                                       .missing = options.missing,
                                       .resample = options.resample,
                                       .names = options.names};
        NumberTable table =
            map ? std::move(*map).reopened(profile_rules) : open_table(text, record.name, profile_rules);
        ProfileFromText read = ProfileTextReader(std::move(table), record.name, given).read();
        record.details = read.record.sentences();
        record.warnings = read.record.warnings;
        record.resolution = read.record.resolution;
        surface.data = std::move(read.profile);
    } else {
        const bool triples = record.format == SurfaceFormat::triples;
        MapFromText read = map->read({.form = triples ? MapForm::triples : MapForm::matrix,
                                      .dx = options.dx,
                                      .dy = options.dy,
                                      .width = options.width,
                                      .height = options.height,
                                      .units = options.units,
                                      .missing = options.missing,
                                      .names = options.names});
        record.details = read.record.sentences();
        record.warnings = read.record.warnings;
        record.resolution = read.record.resolution;
        record.details.erase(record.details.begin());  // the form, which is said already
        surface.data = std::move(read.map);
    }
}

/// The form, other than a table of numbers, that begins as \p bytes do; automatic where none does.
inline SurfaceFormat form_of_first_bytes(std::string_view bytes) {
    if (is_sdf(bytes)) return SurfaceFormat::sdf;
    if (bytes.starts_with("PK\3\4")) return SurfaceFormat::x3p;
    if (is_npy(bytes)) return SurfaceFormat::npy;
    if (is_gsf(bytes)) return SurfaceFormat::gsf;
    if (is_gwy(bytes)) return SurfaceFormat::gwy;
    if (is_smd(bytes)) return SurfaceFormat::smd;
    return is_sur(bytes) ? SurfaceFormat::sur : SurfaceFormat::automatic;
}

/// Reads bytes of the form \p format, which is no table of numbers.
inline DescribedMap read_binary(SurfaceFormat format, std::string_view bytes, const std::string& name,
                                const SurfaceOptions& options) {
    switch (format) {
        case SurfaceFormat::sdf: {
            SdfSurface found = SdfReader(bytes, name).read();
            const bool counted = found.record.binary && found.record.data_type != 3 && found.record.data_type != 7;
            return {.map = std::move(found.map),
                    .sentences = found.record.sentences(),
                    .resolution = counted ? found.record.z_scale : 0};
        }
        case SurfaceFormat::npy: {
            NpySurface found = read_npy(bytes, name,
                                        {.spacing = options.spacing,
                                         .dx = options.dx,
                                         .dy = options.dy,
                                         .width = options.width,
                                         .height = options.height,
                                         .units = options.units,
                                         .missing = options.missing,
                                         .names = options.names});
            return {.map = std::move(found.map),
                    .sentences = found.record.sentences(),
                    .resolution = found.record.resolution};
        }
        case SurfaceFormat::gsf: {
            GsfSurface found = read_gsf(bytes, name);
            return {.map = std::move(found.map), .sentences = found.record.sentences()};
        }
        case SurfaceFormat::gwy: {
            GwySurface found = read_gwy(bytes, name, options.channel);
            return {.map = std::move(found.map),
                    .sentences = found.record.sentences(),
                    .warnings = found.record.warnings()};
        }
        case SurfaceFormat::smd: {
            const SmdProfile found = read_smd(bytes, name);
            HeightMap<double> map;
            map.heights = Eigen::Map<const HeightMap<double>::Array>(found.profile.heights.data(), 1,
                                                                     static_cast<Eigen::Index>(found.profile.size()));
            map.dx = map.dy = found.profile.spacing;
            return {.map = std::move(map),
                    .sentences = found.record.sentences(),
                    .warnings = found.record.warnings(),
                    .resolution = found.record.resolution};
        }
        case SurfaceFormat::sur: {
            SurSurface found = read_sur(bytes, name, options.inflate);
            return {.map = std::move(found.map),
                    .sentences = found.record.sentences(),
                    .warnings = found.record.warnings(),
                    .resolution = std::abs(found.record.step)};
        }
        default:
            if (!options.x3p) refuse_file(name, {"is X3P, which this program was built without; must be another form"});
            return options.x3p(bytes, name, options);
    }
}

}  // namespace detail

inline Surface read_surface(std::string bytes, std::string_view name, const SurfaceOptions& options) {
    Surface surface;
    SurfaceRecord& record = surface.record;
    record.name = std::string(name);
    record.format = options.format;
    record.format_from = "options";
    if (record.format == SurfaceFormat::automatic) {
        record.format = detail::form_of_first_bytes(bytes);
        if (record.format != SurfaceFormat::automatic) record.format_from = "the first bytes";
    }
    switch (record.format) {
        case SurfaceFormat::automatic:
        case SurfaceFormat::profile:
        case SurfaceFormat::triples:
        case SurfaceFormat::matrix: {
            const bool utf16 = detail::is_utf16(bytes);
            const std::string text =
                detail::text_of(std::move(bytes), record.name, "numbers, or SDF, X3P, .npy, .gsf, .gwy, .sur or .smd");
            detail::read_text(surface, text, options);
            if (utf16) record.details.push_back("encoding: UTF-16, from its byte order mark");
            return surface;
        }
        default:
            break;
    }
    detail::check_options(record.format, options, record.name);
    DescribedMap read = detail::read_binary(record.format, bytes, record.name, options);
    record.details = std::move(read.sentences);
    record.warnings = std::move(read.warnings);
    record.resolution = read.resolution;
    surface.data = detail::as_surface(std::move(read.map), record.name);
    return surface;
}

inline Surface read_surface(const std::filesystem::path& path, const SurfaceOptions& options) {
    detail::NamedBytes file = detail::read_bytes(path, "a profile or a map");
    return read_surface(std::move(file.bytes), file.name, options);
}

}  // namespace fstiff::io
