// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/io/surface_file.hpp>

#include "io/ambiguous_signs.hpp"
#include "io/map_text.hpp"
#include "io/profile_text.hpp"
#include "io/readers.hpp"
#include "io/row_layout.hpp"
#include "io/text_blocks.hpp"
#include "io/thousands.hpp"

#include <tuple>

namespace fstiff::inline v0_1::io {

namespace detail {

namespace {

/// Refuses the options that \p format has no use for.
void check_options(SurfaceFormat format, const SurfaceOptions& options, const std::string& name) {
    const std::string useful = " " + std::string(reader_of(format).options) + " ";
    const std::pair<std::string_view, bool> given[] = {
        {"units", !options.units.empty()},     {"spacing", options.spacing.has_value()},
        {"column", options.column != 0},       {"x-column", options.x_column != 0},
        {"dx", options.dx.has_value()},        {"dy", options.dy.has_value()},
        {"width", options.width.has_value()},  {"height", options.height.has_value()},
        {"missing", !options.missing.empty()}, {"thousands", !options.thousands.empty()},
        {"resample", options.resample},        {"channel", !options.channel.empty()},
        {"grid", options.grid.has_value()},    {"x3p-increment", options.x3p_increment != X3pIncrement::apply}};
    for (const auto& [option, is_given] : given)
        if (is_given && useful.find(" " + std::string(option) + " ") == std::string::npos)
            refuse_file(name, {"is read as ", name_of(format), ", which has no use for ", option,
                               "; must not be given, or ", options.names.format, " must be another"});
}

/// Whether the line above the rows of \p table has a unit for each of its \p columns.
bool has_units_above(const NumberTable& table, std::size_t columns) {
    return table.first > 0 && !units_in(table.lines[table.first - 1].text, columns, table.dialect.separator).empty();
}

/// Whether \p options ask for a profile, or have a use for one alone.
bool asks_for_profile(const SurfaceOptions& options) {
    return options.format == SurfaceFormat::profile || options.column != 0 || options.x_column != 0 || options.spacing;
}

/// The form of a text, and why.
std::pair<SurfaceFormat, std::string> text_form(MapTable& reader, const std::string& name,
                                                const SurfaceOptions& options) {
    const std::size_t written = reader.opened().columns;  // in the first row
    const auto named = [](std::size_t columns) {
        return columns == 1 ? std::string("one column") : std::to_string(columns) + " columns";
    };
    const std::string found = named(written);
    const bool sized = gives_size(options) || stated_grid(reader.entries(), "m", name).has_size();
    const auto as = [&](const char* form) { return format_as(options.names, form); };
    const auto ambiguous = [&](const std::string& what, const std::string& choice) {
        refuse_file(name, {"has ", found, what, "; give ", choice});
    };
    if (asks_for_profile(options)) return {SurfaceFormat::profile, "options that only a profile has"};
    if (const auto form = stated_form(reader.entries()); form && written > 1)
        return {*form == MapForm::triples ? SurfaceFormat::triples : SurfaceFormat::matrix, "the header"};
    if (written <= 2) {
        if (sized && written == 2)
            ambiguous(" and the size of a map: may be a profile or a matrix", as("profile") + " or " + as("matrix"));
        return {SurfaceFormat::profile, found};
    }
    const std::size_t columns = reader.table(options.missing).columns;  // without those that number the points
    if (options.grid && columns > 2) return {SurfaceFormat::triples, "grid, which only points have"};
    if (reader.is_zygo()) return {SurfaceFormat::triples, "the header"};
    if (reader.axes()) return {SurfaceFormat::matrix, MapTable::axes_from};
    if (columns <= 2)
        return {SurfaceFormat::profile,
                named(columns) + (reader.opened().words.empty() ? " next to one that numbers the points"
                                                                : " next to those of words")};
    if (!sized && (columns == 3 || reader.is_titled()) && !reader.grid() && reader.columns_of_lengths() == 2)
        return {SurfaceFormat::profile, "two columns next to others of neither positions nor heights"};
    if (columns == 3) {
        const bool grid = reader.grid().has_value();
        if (grid && sized && !reader.counts_pixels())
            ambiguous(", of which two form a grid, and a stated size: may be x, y, z triples or a matrix",
                      as("triples") + " or " + as("matrix"));
        if (grid) return {SurfaceFormat::triples, "three columns, the first two of which form a grid"};
        refuse_thousands(reader.opened(), {0, 1}, false, name);
        if (sized || (written != 3 && reader.opened().words.empty()))
            return {SurfaceFormat::matrix, found + " and a stated size"};
        ambiguous(
            " that begin with no regular grid, and no stated size: may be scattered triples, a matrix "
            "or a profile with a column to choose",
            as("triples") + " with " + options.names.prefix + "grid, " + as("matrix") + ", or " + as("profile") +
                " with column");
    }
    if (reader.begins_with_triples()) {
        if (sized && !reader.counts_pixels())
            ambiguous(", which begin with x, y and z, and a stated size: may be triples or a matrix",
                      as("triples") + " or " + as("matrix"));
        return {SurfaceFormat::triples, reader.triples_from()};
    }
    if (has_units_above(reader.opened(), written) && !sized)
        ambiguous(" with a unit above each: may be columns of a profile or a matrix",
                  as("profile") + " with column, or " + as("matrix"));
    reader.require_no_lone_axis(options.names);
    return {SurfaceFormat::matrix, found};
}

}  // namespace

}  // namespace detail

bool reads_x3p() { return detail::reader_of(SurfaceFormat::x3p).read != nullptr; }

bool reads_compressed_sur() {
#ifdef FSTIFF_HAS_ZLIB
    return true;
#else
    return false;
#endif
}

std::vector<std::string> SurfaceRecord::sentences() const {
    std::vector<std::string> all{"format: " + std::string(name_of(format)) + ", from " + format_from};
    all.insert(all.end(), details.begin(), details.end());
    return all;
}

namespace detail {

namespace {

/// The text of a table of one or two rows with its rows as columns (io/row_layout.hpp); none for other tables, and for a
/// map: where \p options give its size, or where they do not ask for a profile and the header above two rows states a
/// form or both sides. A step alone may be that of a profile.
std::optional<std::string> turned_text(const NumberTable& table, const SurfaceOptions& options,
                                       const std::string& name) {
    if (gives_size(options)) return std::nullopt;
    std::optional<TurnedRows> turned = turned_rows(table);
    if (!turned) return std::nullopt;
    if (turned->rows == 2 && !asks_for_profile(options)) {
        const auto entries = header_entries(table);
        const StatedGrid grid = stated_grid(entries, "m", name);
        const bool one_step = grid.dx && grid.dy && grid.dx->line == grid.dy->line;
        if (stated_form(entries) || (grid.has_size() && !one_step)) return std::nullopt;
    }
    return std::move(turned->text);
}

/// Reads a text of the form record.format, which is chosen here where it is automatic.
Reading read_text(SurfaceRecord& record, const std::string& text, const SurfaceOptions& options) {
    const std::string& name = record.name;
    std::size_t count = 0;
    std::vector<Line> lines = lines_of(text, name, count);
    drop_frame(lines);
    const bool may_be_matrix = record.format == SurfaceFormat::automatic || record.format == SurfaceFormat::matrix;
    const bool may_be_profile = record.format == SurfaceFormat::automatic || record.format == SurfaceFormat::profile;
    if (may_be_matrix && !lines.empty() && is_wyko_text(lines.front().text)) {
        record.format = SurfaceFormat::matrix;
        record.format_from = "the first words";
        check_options(record.format, options, name);
        return read_wyko_text(std::move(lines), name, options);
    }
    ChosenBlock chosen = chosen_block(blocks_of(std::move(lines), name, options), name, options);
    NumberTable& table = chosen.block.table;
    const auto turned = may_be_profile ? turned_text(table, options, name) : std::nullopt;
    if (turned) table = open_table(lines_of(*turned, name, count), name, options, table.before);
    std::optional<MapTable> map;
    if (record.format != SurfaceFormat::profile) map.emplace(std::move(table), name);
    if (record.format == SurfaceFormat::automatic)
        std::tie(record.format, record.format_from) = text_form(*map, name, options);
    check_options(record.format, options, name);
    Reading found = record.format != SurfaceFormat::profile
                        ? read_map(std::move(*map), record.format, options)
                        : read_profile(map ? std::move(*map).unread() : std::move(table), name, options);
    if (turned) found.record.note("rows", "of the file are read as columns");
    note_channels(found.record, chosen);
    return found;
}

/// Warns of a second file of the same form after the first one, which begins with the same bytes.
void warn_of_second_file(const Reader& reader, std::string_view bytes, Record& record) {
    std::size_t place = std::string_view::npos;
    if (bytes.starts_with("PK\3\4")) {  // after the end of an archive
        const std::size_t end = bytes.find("PK\5\6");
        if (end < bytes.size()) place = bytes.find("PK\3\4", end);
    } else if (bytes.size() > reader.mark) {
        place = bytes.find(bytes.substr(0, reader.mark), reader.mark);
    }
    if (place < bytes.size() && form_of_first_bytes(bytes.substr(place)) == reader.format)
        record.warnings.push_back("the file holds a second one of the form " + std::string(name_of(reader.format)) +
                                  " from byte " + std::to_string(place) + " on, which is not read");
}

/// Reads bytes of a form that has a reader of its own.
Reading read_binary(const Reader& reader, std::string_view bytes, const std::string& name,
                    const SurfaceOptions& options) {
    // an archive of something else is named by its reader
    if (reader.format != SurfaceFormat::x3p || bytes.find("main.xml") < bytes.size())
        check_options(reader.format, options, name);
    if (!reader.read)
        refuse_file(name, {"is of the form ", name_of(reader.format),
                           ", which this program was built without; must be another form"});
    Reading found = reader.read(bytes, name, options);
    warn_of_second_file(reader, bytes, found.record);
    if (found.map.rows == 1) fstiff::detail::located({.file = name}, [&] { validate_map(found.map, 16); });
    return found;
}

}  // namespace

ReadSurface read(std::string bytes, std::string_view name, const SurfaceOptions& options) {
    SurfaceRecord record{.name = std::string(name), .format = options.format, .format_from = "options"};
    if (record.format == SurfaceFormat::automatic) {
        record.format = form_of_first_bytes(bytes);
        if (record.format != SurfaceFormat::automatic) record.format_from = "the first bytes";
    }
    Reading found;
    if (record.format != SurfaceFormat::automatic && reader_of(record.format).begins) {
        found = read_binary(reader_of(record.format), bytes, record.name, options);
    } else {
        const bool utf16 = is_utf16(bytes);
        const std::string text =
            without_thousands(text_of(std::move(bytes), record.name, "numbers, or a file of another form"),
                              options.thousands, record.name);
        found = read_text(record, text, options);
        if (utf16) found.record.note("encoding", "UTF-16, from its byte order mark");
    }
    record.details = found.record.sentences();
    record.warnings = std::move(found.record.warnings);
    record.resolution = found.record.resolution;
    record.origin = found.record.origin;
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
