// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/io/surface_file.hpp>

#include "io/al3d.hpp"
#include "io/gsf.hpp"
#include "io/gwy.hpp"
#include "io/map_text.hpp"
#include "io/metropro.hpp"
#include "io/netcdf.hpp"
#include "io/npy.hpp"
#include "io/opd.hpp"
#include "io/opdx.hpp"
#include "io/plu.hpp"
#include "io/plux.hpp"
#include "io/profile_text.hpp"
#include "io/sdf.hpp"
#include "io/smd.hpp"
#include "io/stl.hpp"
#include "io/sur.hpp"
#include "io/text_blocks.hpp"
#include "io/thousands.hpp"
#include "io/vk4.hpp"
#include "io/wyko_text.hpp"
#include "io/x3p.hpp"

#include <tuple>

namespace fstiff::inline v0_1::io {

namespace detail {

namespace {

/// Refuses the options that \p format has no use for.
void check_options(SurfaceFormat format, const SurfaceOptions& options, const std::string& name) {
    const bool profile = format == SurfaceFormat::profile;
    const bool matrix = format == SurfaceFormat::matrix;
    const bool text = profile || matrix || format == SurfaceFormat::triples;
    const bool bare = format == SurfaceFormat::npy;  // states neither units nor steps
    const std::pair<const char*, bool> useless[] = {
        {"units", !options.units.empty() && !text && !bare && format != SurfaceFormat::stl},
        {"spacing", options.spacing && !profile && !bare},
        {"column", options.column != 0 && !profile},
        {"x-column", options.x_column != 0 && !profile},
        {"dx", options.dx && !matrix && !bare},
        {"dy", options.dy && !matrix && !bare},
        {"width", options.width && !matrix && !bare},
        {"height", options.height && !matrix && !bare},
        {"missing", !options.missing.empty() && !text && !bare},
        {"thousands", !options.thousands.empty() && !text},
        {"resample", options.resample && !profile},
        {"channel", !options.channel.empty() && !text && format != SurfaceFormat::gwy},
        {"x3p-increment", options.x3p_increment != X3pIncrement::apply && format != SurfaceFormat::x3p}};
    for (const auto& [option, refused] : useless)
        if (refused)
            refuse_file(name, {"is read as ", surface_format_name(format), ", which has no use for ", option,
                               "; must not be given, or ", options.names.format, " must be another"});
}

/// Whether the end of the zip archive \p bytes, which lists its files, names index.xml and no main.xml.
bool is_plux(std::string_view bytes) {
    const std::string_view list = bytes.substr(bytes.size() - (std::min<std::size_t>)(bytes.size(), 1 << 16));
    return list.find("index.xml") != std::string_view::npos && list.find("main.xml") == std::string_view::npos;
}

/// The form of a text, and why.
std::pair<SurfaceFormat, std::string> text_form(MapTable& reader, const std::string& name,
                                                const SurfaceOptions& options) {
    const std::size_t written = reader.opened().columns;  // in the first row
    const auto named = [](std::size_t columns) {
        return columns == 1 ? std::string("one column") : std::to_string(columns) + " columns";
    };
    const std::string found = named(written);
    const bool sized = options.dx || options.dy || options.width || options.height ||
                       stated_grid(reader.entries(), "m", name).has_size();
    const auto as = [&](const char* form) { return format_as(options.names, form); };
    const auto ambiguous = [&](const std::string& what, const std::string& choice) {
        refuse_file(name, {"has ", found, what, "; give ", choice});
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
        refuse_thousands(reader.opened(), {0, 1}, false, name);
        if (sized || written != 3) return {SurfaceFormat::matrix, found + " and a stated size"};
        ambiguous(
            " that begin with no regular grid, and no stated size: may be scattered triples, a matrix "
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

}  // namespace

}  // namespace detail

SurfaceFormat form_of_first_bytes(std::string_view bytes) {
    if (is_sdf(bytes)) return SurfaceFormat::sdf;
    if (bytes.starts_with("PK\3\4")) return detail::is_plux(bytes) ? SurfaceFormat::plux : SurfaceFormat::x3p;
    if (is_npy(bytes)) return SurfaceFormat::npy;
    if (is_gsf(bytes)) return SurfaceFormat::gsf;
    if (is_gwy(bytes)) return SurfaceFormat::gwy;
    if (is_smd(bytes)) return SurfaceFormat::smd;
    if (is_sur(bytes)) return SurfaceFormat::sur;
    if (is_metropro(bytes)) return SurfaceFormat::metropro;
    if (is_vk4(bytes)) return SurfaceFormat::vk4;
    if (is_opd(bytes)) return SurfaceFormat::opd;
    if (is_netcdf(bytes)) return SurfaceFormat::netcdf;
    if (is_opdx(bytes)) return SurfaceFormat::opdx;
    if (is_al3d(bytes)) return SurfaceFormat::al3d;
    if (is_plu(bytes)) return SurfaceFormat::plu;
    return is_stl(bytes) ? SurfaceFormat::stl : SurfaceFormat::automatic;
}

bool reads_x3p() {
#ifdef FSTIFF_HAS_X3P
    return true;
#else
    return false;
#endif
}

bool reads_compressed_sur() {
#ifdef FSTIFF_HAS_ZLIB
    return true;
#else
    return false;
#endif
}

SurfaceFormat surface_format(std::string_view name) {
    if (const auto format = parts::find_named<SurfaceFormat>(name)) return *format;
    parts::refuse("format", detail::shown_cell(name), "one of " + parts::choices_text<SurfaceFormat>());
}

std::string_view surface_format_name(SurfaceFormat format) { return name_of(format); }

std::vector<std::string> SurfaceRecord::sentences() const {
    std::vector<std::string> all{"format: " + std::string(surface_format_name(format)) + ", from " + format_from};
    all.insert(all.end(), details.begin(), details.end());
    return all;
}

namespace detail {

namespace {

/// Reads a text of the form record.format, which is chosen here where it is automatic.
Reading read_text(SurfaceRecord& record, const std::string& text, const SurfaceOptions& options) {
    const std::string& name = record.name;
    std::size_t count = 0;
    std::vector<Line> lines = lines_of(text, name, count);
    const bool may_be_matrix = record.format == SurfaceFormat::automatic || record.format == SurfaceFormat::matrix;
    if (may_be_matrix && !lines.empty() && is_wyko_text(lines.front().text)) {
        record.format = SurfaceFormat::matrix;
        record.format_from = "the first words";
        check_options(record.format, options, name);
        return read_wyko_text(std::move(lines), name, options);
    }
    ChosenBlock chosen = chosen_block(blocks_of(std::move(lines), name, options), name, options);
    std::vector<Line>& own = chosen.block.lines;
    const std::size_t before = chosen.block.line - 1;
    std::optional<MapTable> map;
    if (record.format != SurfaceFormat::profile) map.emplace(std::move(own), name, options, before);
    if (record.format == SurfaceFormat::automatic)
        std::tie(record.format, record.format_from) = text_form(*map, name, options);
    check_options(record.format, options, name);
    Reading found;
    if (record.format != SurfaceFormat::profile) {
        found = read_map(std::move(*map), record.format, options);
    } else {
        NumberTable table = map ? std::move(*map).reopened(profile_rules)
                                : open_table(std::move(own), name, profile_rules, options, before);
        found = read_profile(std::move(table), name, options);
    }
    say_channels(found.record, chosen);
    return found;
}

/// Reads bytes of the form \p format, which is a zip archive or may hold one.
Reading read_packed(SurfaceFormat format, std::string_view bytes, const std::string& name,
                    [[maybe_unused]] const SurfaceOptions& options) {
#ifdef FSTIFF_HAS_X3P
    if (format == SurfaceFormat::x3p) return read_x3p(bytes, name, options);
    if (format == SurfaceFormat::plux) return read_plux(bytes, name, options);
    return read_vk4(bytes, name, [&](std::string_view archive, const std::string& called, std::string_view entry) {
        return zip_entry(archive, called, entry, options.x3p_limits);
    });
#else
    if (format == SurfaceFormat::vk4) return read_vk4(bytes, name);
    refuse_file(name, {"is ", format == SurfaceFormat::x3p ? "X3P" : "a Sensofar file (.plux)",
                       ", which this program was built without; must be another form"});
#endif
}

/// Warns of a second file of the same form after the first one, which begins with the same bytes.
void warn_of_second_file(SurfaceFormat format, std::string_view bytes, Record& record) {
    constexpr std::size_t same = 12;
    std::size_t place = std::string_view::npos;
    if (bytes.starts_with("PK\3\4")) {  // after the end of an archive
        const std::size_t end = bytes.find("PK\5\6");
        if (end < bytes.size()) place = bytes.find("PK\3\4", end);
    } else if (format != SurfaceFormat::stl && bytes.size() > same) {
        place = bytes.find(bytes.substr(0, format == SurfaceFormat::sdf ? 8 : same), same);
    }
    if (place < bytes.size() && form_of_first_bytes(bytes.substr(place)) == format)
        record.warnings.push_back("the file holds a second one of the form " + std::string(name_of(format)) +
                                  " from byte " + std::to_string(place) + " on, which is not read");
}

/// Reads bytes of the form \p format, which is not a table of numbers.
Reading read_binary(SurfaceFormat format, std::string_view bytes, const std::string& name,
                    const SurfaceOptions& options) {
    switch (format) {
        case SurfaceFormat::sdf: return read_sdf(bytes, name);
        case SurfaceFormat::npy: return read_npy(bytes, name, options);
        case SurfaceFormat::gsf: return read_gsf(bytes, name);
        case SurfaceFormat::gwy: return read_gwy(bytes, name, options.channel);
        case SurfaceFormat::smd: return read_smd(bytes, name);
        case SurfaceFormat::sur: return read_sur(bytes, name, inflate_where_built());
        case SurfaceFormat::metropro: return read_metropro(bytes, name);
        case SurfaceFormat::opd: return read_opd(bytes, name);
        case SurfaceFormat::al3d: return read_al3d(bytes, name);
        case SurfaceFormat::plu: return read_plu(bytes, name);
        case SurfaceFormat::netcdf: return read_netcdf(bytes, name);
        case SurfaceFormat::opdx: return read_opdx(bytes, name);
        case SurfaceFormat::stl: return read_stl(bytes, name, options);
        default: return read_packed(format, bytes, name, options);
    }
}

}  // namespace

ReadSurface read(std::string bytes, std::string_view name, const SurfaceOptions& options) {
    SurfaceRecord record{.name = std::string(name), .format = options.format, .format_from = "options"};
    if (record.format == SurfaceFormat::automatic) {
        record.format = form_of_first_bytes(bytes);
        if (record.format != SurfaceFormat::automatic) record.format_from = "the first bytes";
    }
    Reading found;
    switch (record.format) {
        case SurfaceFormat::automatic:
        case SurfaceFormat::profile:
        case SurfaceFormat::triples:
        case SurfaceFormat::matrix: {
            const bool utf16 = is_utf16(bytes);
            const std::string text =
                without_thousands(text_of(std::move(bytes), record.name, "numbers, or a file of another form"),
                                  options.thousands, record.name);
            found = read_text(record, text, options);
            if (utf16) found.record.say("encoding", "UTF-16, from its byte order mark");
            break;
        }
        default:
            // an archive of something else is named by its reader
            if (record.format != SurfaceFormat::x3p || bytes.find("main.xml") < bytes.size())
                check_options(record.format, options, record.name);
            found = read_binary(record.format, bytes, record.name, options);
            warn_of_second_file(record.format, bytes, found.record);
            if (found.map.rows == 1) parts::located({.file = record.name}, [&] { validate_map(found.map, 16); });
    }
    record.details = found.record.sentences();
    record.warnings = std::move(found.record.warnings);
    record.resolution = found.record.resolution;
    return {std::move(found.map), std::move(record)};
}

ReadSurface read(std::istream& input, std::string_view name, const SurfaceOptions& options) {
    NamedBytes file = read_bytes(input, name);
    return read(std::move(file.bytes), file.name, options);
}

ReadSurface read(const std::filesystem::path& path, const SurfaceOptions& options) {
    NamedBytes file = read_bytes(path, "a profile or a map");
    return read(std::move(file.bytes), file.name, options);
}

}  // namespace detail

}  // namespace fstiff::inline v0_1::io
