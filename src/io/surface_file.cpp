// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/io/surface_file.hpp>

#include "io/given_lengths.hpp"
#include "io/map_text.hpp"
#include "io/profile_text.hpp"
#include "io/readers.hpp"
#include "io/row_layout.hpp"
#include "io/text_blocks.hpp"
#include "io/thousands.hpp"
#include "io/turned_rows.hpp"

namespace fstiff::inline v0_1::io {

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

/// The text of a table of one or two rows with its rows as columns (io/turned_rows.hpp); none for other tables, and for
/// a map: where \p options give its size, or where they do not ask for a profile and the header above two rows states a
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
    NumberTable& opened = chosen.block.table;
    const auto turned = may_be_profile ? turned_text(opened, options, name) : std::nullopt;
    if (turned) opened = open_table(lines_of(*turned, name, count), name, options, opened.before);
    TextTable table = text_table(std::move(opened), record.format, name, options);
    if (record.format == SurfaceFormat::automatic) record.format_from = table.form_from;
    record.format = table.form;
    Reading found = record.format == SurfaceFormat::profile ? read_profile(std::move(table), name, options)
                                                            : read_map(std::move(table), name, options);
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
