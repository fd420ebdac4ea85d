// SPDX-License-Identifier: BSD-3-Clause
#include "io/header.hpp"

#include "io/unit_table.hpp"

#include <fstiff/io/quantities.hpp>

namespace fstiff::inline v0_1::io::detail {

namespace {

std::string header_key(std::string_view text) {
    // French sets a blank that does not break before the colon; alone, its second byte is a letter's too
    text = trimmed(text);
    const auto last = text.size();
    if (text.ends_with("\xC2\xA0"))
        text.remove_suffix(2);
    else if (last > 1 && text.back() == '\xA0' && static_cast<unsigned char>(text[last - 2]) < 0x80)
        text.remove_suffix(1);
    std::string key = lower_case(trimmed(text));
    std::replace(key.begin(), key.end(), '_', ' ');
    return key;
}

/// The words of the header of an ESRI grid, which have a blank after them.
bool is_grid_word(std::string_view word) {
    const std::string key = lower_case(word);
    return key == "ncols" || key == "nrows" || key == "cellsize" || key == "nodata_value";
}

/// "10,5 um" as "10.5 um" where its comma is decimal: the table's is, or other than three digits follow or a zero
/// leads, as of no thousands.
std::string with_decimal_point(std::string_view value, bool decimal_comma) {
    std::string text(value);
    const std::size_t sign = !text.empty() && (text[0] == '-' || text[0] == '+') ? 1 : 0;
    const std::size_t comma = text.find_first_not_of("0123456789", sign);
    if (comma == std::string::npos || comma == sign || text[comma] != ',') return text;
    const std::size_t end = (std::min)(text.find_first_not_of("0123456789", comma + 1), text.size());
    const std::size_t digits = end - comma - 1;
    if (digits > 0 && (decimal_comma || digits != 3 || text[sign] == '0') &&
        (end == text.size() || (text[end] != ',' && text[end] != '.')))
        text[comma] = '.';
    return text;
}

constexpr std::string_view wide_colon = "\xEF\xBC\x9A";  // of Chinese and Japanese

/// "XY Calibration","277.8","nm", as Keyence exports it, or Pitch,0.5,um, as Mitutoyo does: the cells, of which there
/// are two or three; none of other lines.
std::vector<std::string_view> entry_cells(std::string_view line) {
    std::vector<std::string_view> cells;
    const bool quoted = line.starts_with('"');
    const std::size_t end = quoted ? line.find('"', 1) : 0;
    const std::size_t next = end == std::string_view::npos ? end : line.find_first_of(",;\t", end);
    if (next == std::string_view::npos) return cells;
    if (!quoted && (line.find_first_of(":=") < line.size() || line.find(wide_colon) < line.size())) return cells;
    split_line(line, line[next], cells);
    if (cells.size() < 2 || cells.size() > 3 || cells[0].empty()) cells.clear();
    return cells;
}

}  // namespace

std::vector<HeaderEntry> header_entries(std::span<const Line> lines, Dialect dialect, bool all) {
    std::vector<HeaderEntry> entries;
    std::vector<std::string_view> words;
    const auto add = [&](std::string_view entry, std::size_t sign, std::size_t length, std::size_t line) {
        std::string_view value = trimmed(entry.substr(sign + length));
        while (!value.empty() && (value.back() == ',' || value.back() == ';' || is_blank(value.back())))
            value.remove_suffix(1);
        entries.push_back({header_key(entry.substr(0, sign)), with_decimal_point(value, dialect.decimal_comma), line});
    };
    for (const auto& [text, number] : lines) {
        std::string_view line = text;
        while (!line.empty() && (is_blank(line.front()) || line.front() == '#' || line.front() == '%' ||
                                 line.front() == '!' || line.front() == '/' || line.front() == ';'))
            line.remove_prefix(1);
        if (const auto cells = entry_cells(line); !cells.empty()) {
            entries.push_back({header_key(cells[0]),
                               with_decimal_point(cells[1], dialect.decimal_comma) +
                                   (cells.size() == 3 ? " " + std::string(cells[2]) : std::string()),
                               number});
            continue;
        }
        const std::size_t wide = line.find(wide_colon), narrow = line.find_first_of(":=");
        const std::size_t sign = (std::min)(wide, narrow);
        // "NODATA_value -9999" of an ESRI grid
        if (split_line(line, ' ', words); words.size() == 2 && is_grid_word(words[0])) {
            const auto at = static_cast<std::size_t>(words[0].data() - line.data());
            add(line, at + words[0].size(), 1, number);
            continue;
        }
        if (sign == std::string_view::npos || sign == 0) {
            if (all && !line.empty()) entries.push_back({"", std::string(line), number});
            continue;
        }
        // "h=305 w=75": every word an entry
        const bool every_word = std::all_of(words.begin(), words.end(), [](std::string_view word) {
            const std::size_t equal = word.find('=');
            return equal != std::string_view::npos && equal > 0 && equal + 1 < word.size();
        });
        if (words.size() > 1 && every_word)
            for (const std::string_view word : words) add(word, word.find('='), 1, number);
        else
            add(line, sign, sign == wide ? wide_colon.size() : 1, number);
    }
    return entries;
}

std::vector<HeaderEntry> header_entries(const NumberTable& table, bool all) {
    return header_entries(std::span(table.lines).first(table.first), table.dialect, all);
}

const HeaderEntry* find_entry(const std::vector<HeaderEntry>& entries, std::string_view key) {
    const auto found =
        std::find_if(entries.begin(), entries.end(), [&](const HeaderEntry& entry) { return entry.key == key; });
    return found == entries.end() ? nullptr : &*found;
}

std::string shown_line(const HeaderEntry& entry) {
    return "line " + std::to_string(entry.line) + ", which states " + printable(entry.key, 24) +
           (entry.key.empty() ? "" : " ") + printable(entry.value, 40);
}

std::optional<StatedSpacing> stated_spacing(const std::vector<HeaderEntry>& entries) {
    for (const HeaderEntry& entry : entries) {
        const std::string_view key = entry.key;
        if (!is_one_of_words(trimmed(key.substr(0, (std::min)(key.find_first_of("[("), key.size()))), spacing_words))
            continue;
        std::string_view text = trimmed(std::string_view(entry.value).substr(0, entry.value.find_first_of(",;\t")));
        const std::size_t per = text.find('/');
        const LeadingNumber number = leading_number(text);
        if (number.status != NumberStatus::ok || !(number.value > 0)) continue;
        if (per != std::string_view::npos && per < number.length) continue;
        std::string_view unit =
            trimmed(text.substr(number.length, per == std::string_view::npos ? per : per - number.length));
        if (unit.empty()) unit = title_unit(key);
        if (!is_unit(unit, Dimension::length)) continue;
        const double factor = unit_factor(unit, Dimension::length);
        return StatedSpacing{number.value * factor,
                             std::pow(10.0, last_digit_of(text.substr(0, number.length))) * factor, entry.line,
                             std::string(text)};
    }
    return std::nullopt;
}

namespace {

/// Whether the header is one of SPIP, whose x-length and y-length are in nm.
bool is_spip(const std::vector<HeaderEntry>& entries) {
    const HeaderEntry* const form = find_entry(entries, "file format");
    return form && form->value == "ASCII";
}

/// Meaning of the key of a header line for the grid.
struct GridMeaning {
    bool width, height;  ///< of the whole map
    bool both, dx, dy;   ///< of one step; both: along x and y
    bool columns, rows;
};

GridMeaning meaning_of(const std::string& key) {
    const auto is_one_of = [&](std::initializer_list<std::string_view> keys) {
        return std::find(keys.begin(), keys.end(), key) != keys.end();
    };
    GridMeaning of{};
    of.width = is_one_of({"width", "w", "x size", "size x", "x range", "xrange", "scan size x", "x-length"}) ||
               is_one_of_words(key, width_words);
    of.height = is_one_of({"height", "h", "y size", "size y", "y range", "yrange", "scan size y", "y-length"}) ||
                is_one_of_words(key, height_words);
    of.both = is_one_of({"pixel size", "pixel pitch", "pixel spacing", "lateral spacing", "cellsize"}) ||
              is_one_of_words(key, pitch_words);
    of.dx = of.both || is_one_of({"dx", "scale x", "pixel width", "x pixel size", "pixel size x", "x spacing",
                                  "spacing x", "x step", "x increment"});
    of.dy = of.both || is_one_of({"dy", "scale y", "pixel height", "y pixel size", "pixel size y", "y spacing",
                                  "spacing y", "y step", "y increment"});
    of.columns = is_one_of({"columns", "cols", "x pixels", "x-pixels", "xres", "nx", "ncols"}) ||
                 is_one_of_words(key, columns_words);
    of.rows =
        is_one_of({"rows", "lines", "y pixels", "y-pixels", "yres", "ny", "nrows"}) || is_one_of_words(key, rows_words);
    return of;
}

}  // namespace

namespace {

/// The unit of a length or step that states none itself, and where it is from: of its axis, or SPIP's nm for a \p size.
std::pair<std::string_view, std::string> unit_of_axis(const std::vector<HeaderEntry>& entries, bool vertical,
                                                      bool size) {
    const bool spip = size && is_spip(entries);
    // SPIP's lengths are in nm each by itself
    const HeaderEntry* const axis =
        spip && vertical && !find_entry(entries, "y-unit") ? nullptr : stated_axis_unit(entries, vertical);
    if (axis && is_unit(axis->value, Dimension::length)) return {axis->value, ""};
    if (spip) return {"nm", " (in nm, as SPIP writes it)"};
    return {};
}

/// "um/pixel" as "um".
std::string_view without_per_pixel(std::string_view unit) {
    for (const std::string_view per : {"/pixel", "/px", "/point"})
        if (unit.ends_with(per)) return trimmed(unit.substr(0, unit.size() - per.size()));
    return unit;
}

/// The key of \p entry without the unit of length in brackets after it, and that unit; "x [um/pixel]" and a resolution
/// in um/px are pixel sizes.
std::pair<std::string, std::string> key_and_unit(const HeaderEntry& entry) {
    const std::string& key = entry.key;
    const LeadingNumber number = leading_number(entry.value);
    const std::string_view written = trimmed(std::string_view(entry.value).substr(number.length));
    const bool per_pixel = without_per_pixel(written) != written;
    if (per_pixel && (key == "resolution" || key == "lateral resolution" || key == "xy resolution"))
        return {"pixel size", ""};
    if (per_pixel && (key == "xscale" || key == "x scale")) return {"dx", ""};
    if (per_pixel && (key == "yscale" || key == "y scale")) return {"dy", ""};
    const std::size_t begin = key.find_first_of("[(");
    if (begin == std::string::npos || (key.back() != ']' && key.back() != ')')) return {key, ""};
    const std::string_view inside = trimmed(std::string_view(key).substr(begin + 1, key.size() - begin - 2));
    const std::string_view unit = without_per_pixel(inside);
    if (!is_unit(unit, Dimension::length)) return {key, ""};
    const std::string name(trimmed(std::string_view(key).substr(0, begin)));
    const bool pixel = unit != inside;
    return {pixel && name == "x" ? "dx" : pixel && name == "y" ? "dy" : name, std::string(unit)};
}

}  // namespace

StatedGrid stated_grid(const std::vector<HeaderEntry>& entries, const std::string& unit, const std::string& name) {
    StatedGrid grid;
    const auto set = [&](auto& slot, auto value, const HeaderEntry& entry, auto old) {
        if (slot && old != value)
            refuse_line(name, entry.line,
                        {shown_cell(entry.key), " is stated twice, with two values; must be one value"});
        slot = value;
    };
    for (const HeaderEntry& entry : entries) {
        const auto [key, unit_of_key] = key_and_unit(entry);
        const auto [width, height, both, dx, dy, columns, rows] = meaning_of(key);
        if (!(width || height || dx || dy || columns || rows)) continue;
        const LeadingNumber number = leading_number(entry.value);
        if (number.status != NumberStatus::ok) continue;
        std::string_view written = trimmed(std::string_view(entry.value).substr(number.length));
        if (both || dx || dy) written = without_per_pixel(written);  // "277.8 nm/pixel"
        if (written.empty()) written = unit_of_key;
        std::string unit_from;
        if (written.empty() && unit.empty() && !columns && !rows)
            std::tie(written, unit_from) = unit_of_axis(entries, height || (dy && !both), width || height);
        const std::string word = lower_case(written);
        const bool counted = word == "px" || word == "pixel" || word == "pixels" || word == "points";
        const bool whole = number.value >= 1 && number.value < 4294967296.0 && number.value == std::floor(number.value);
        const bool short_count = (entry.key == "w" || entry.key == "h") && written.empty();
        if (columns || rows || counted || (short_count && whole)) {
            if (!whole || dx || dy || !(written.empty() || counted)) continue;
            const auto count = static_cast<std::size_t>(number.value);
            auto& slot = columns || width ? grid.columns : grid.rows;
            set(slot, count, entry, slot.value_or(0));
            (columns || width ? grid.columns_line : grid.rows_line) = entry.line;
            continue;
        }
        if (written.empty() && unit.empty()) {
            if (grid.without_unit.empty()) grid.without_unit_line = entry.line, grid.without_unit = entry.key;
            continue;
        }
        if (!written.empty() && !is_unit(written, Dimension::length)) continue;
        const std::string quantity =
            std::string(entry.value.substr(0, number.length)) + " " + (written.empty() ? unit : std::string(written));
        const double value = fstiff::detail::located(
            {.file = name}, [&] { return parse_quantity(quantity, Dimension::length, entry.key); });
        fstiff::detail::located({.file = name, .line = entry.line}, [&] {
            if (!(value > 0))
                fstiff::detail::refuse(shown_cell(entry.key), number_text(value) + " m", "greater than 0");
        });
        const auto store = [&](std::optional<StatedGrid::Length>& slot) {
            if (slot && slot->value != value)
                refuse_line(name, entry.line,
                            {shown_cell(entry.key), " disagrees with line ", slot->line, "; must be one value"});
            slot = StatedGrid::Length{value, entry.line, unit_from, std::string(unit_from.empty() ? written : "")};
        };
        if (width) store(grid.width);
        if (height) store(grid.height);
        if (dx) store(grid.dx);
        if (dy) store(grid.dy);
    }
    return grid;
}

bool is_size_key(const std::string& key) {
    const GridMeaning of = meaning_of(key);
    return of.width || of.height || of.dx || of.dy || of.columns || of.rows;
}

bool is_height_unit_key(const std::string& key) {
    static constexpr std::string_view keys[] = {
        "value units",     "value unit",  "data unit", "data units",   "z unit",      "z-unit",
        "z units",         "height unit", "unit",      "height units", "units",       "unit z",
        "units z",         "zunit",       "unit data", "units data",   "z axis unit", "vertical unit",
        "unit of heights", "z-units",     "einheit z", "z-einheit",    "dataunit",    "unitz"};
    return std::find(std::begin(keys), std::end(keys), key) != std::end(keys) ||
           is_one_of_words(key, height_unit_words);
}

const HeaderEntry* stated_axis_unit(const std::vector<HeaderEntry>& entries, bool along_y) {
    const HeaderEntry *x = nullptr, *y = nullptr;
    for (const HeaderEntry& entry : entries)
        if (!entry.value.empty()) {
            if (is_one_of_words(entry.key, x_unit_words)) x = &entry;
            if (is_one_of_words(entry.key, y_unit_words)) y = &entry;
        }
    return along_y && y ? y : x;
}

StatedScale stated_scale(const std::vector<HeaderEntry>& entries) {
    const HeaderEntry* const needed = find_entry(entries, "datascaleneeded");
    const std::string word = needed ? lower_case(needed->value) : "";
    if (word == "no") return {};
    for (const HeaderEntry& entry : entries)
        if (const auto factor = height_factor(entry)) return {&entry, *factor, word == "yes"};
    return {};
}

double require_scale(const std::vector<HeaderEntry>& entries, const std::string& name, const OptionNames& names) {
    const auto [entry, factor, needed] = stated_scale(entries);
    if (entry && !needed)
        refuse_line(name, entry->line,
                    {"states ", shown_cell(entry->key.empty() ? entry->value : entry->key), " ", factor,
                     ", and not whether the heights are to be multiplied by it; must be ",
                     given_as(names, "units", "\"UNIT\""), ", in which the numbers are, such as \"10 nm\""});
    return factor;
}

StatedHeightUnit stated_height_unit(const std::vector<HeaderEntry>& entries, const std::string& name) {
    const HeaderEntry* unit = nullptr;
    const HeaderEntry* factor = nullptr;
    for (const HeaderEntry& entry : entries) {
        if (is_height_unit_key(entry.key)) {
            const bool same =
                unit && is_unit(unit->value, Dimension::length) && is_unit(entry.value, Dimension::length) &&
                unit_factor(unit->value, Dimension::length) == unit_factor(entry.value, Dimension::length);
            if (unit && unit->value != entry.value && !same)
                refuse_line(name, entry.line,
                            {"states another unit of the heights than line ", unit->line, "; must be one unit"});
            unit = &entry;
        }
        if (entry.key.starts_with("height conversion factor")) factor = &entry;
    }
    return {unit, factor};
}

void refuse_no_length(const std::vector<HeaderEntry>& entries, const std::string& name) {
    for (const HeaderEntry& entry : entries)
        if (is_height_unit_key(entry.key) && measures_no_length(entry.value))
            refuse_line(name, entry.line,
                        {"states ", shown_cell(entry.value),
                         " as the unit of the values, which is of no length; must be heights in a unit of length"});
}

MissingValues stated_missing(const std::vector<HeaderEntry>& entries, std::string_view given, const std::string& name) {
    MissingValues missing = given_missing(given, name);
    if (!missing.from.empty()) return missing;
    for (const HeaderEntry& entry : entries)
        for (const char* key : {"nodata value", "nodata", "no data", "no data value", "missing", "missing value",
                                "missing values", "missing data", "bad value", "bad data", "invalid value",
                                "invalid data", "undefined value", "fill value", "fillvalue", "null value"})
            if (const auto number = entry.key == key ? number_in(unquoted(entry.value), false) : std::nullopt) {
                missing.numbers.push_back(*number);
                missing.from = "line " + std::to_string(entry.line);
            }
    return missing;
}

std::optional<MapForm> stated_form(const std::vector<HeaderEntry>& entries) {
    for (const HeaderEntry& entry : entries)
        if (const auto form = fstiff::detail::find_named<MapForm>(entry.value);
            entry.key == "form" && form && *form != MapForm::automatic)
            return form;
    return std::nullopt;
}

}  // namespace fstiff::inline v0_1::io::detail
