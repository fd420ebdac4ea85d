// SPDX-License-Identifier: BSD-3-Clause
/// \file
/// Reads the simple field of Gwyddion (.gsf).
///
/// The line "Gwyddion Simple Field 1.0", lines "key = value", one to four NUL bytes up to a multiple of 4 bytes, and
/// the heights, row after row from the top, as float32, least significant byte first. NaN is a missing point. XRes and
/// YRes are the columns and rows, XReal and YReal the width and the height in XYUnits, and the heights are in ZUnits.
/// The description lets XReal, YReal and the units be left out; here they must be stated, for nothing is guessed.
///
///     dx = XReal / XRes,    dy = YReal / YRes
///
/// Reference   Gwyddion user guide, "Gwyddion Simple Field" (file formats). Deviation: units with a prefix (um) are
///             read.
/// Units       map in m
/// Valid       2 points a side at least, or one row; heights that vary; files up to 2^31 bytes
/// Accuracy    number times unit, rounded once (tests/io/gsf_test.cpp)

#include "io/readers.hpp"

#include "io/binary_numbers.hpp"
#include "io/required.hpp"

namespace fstiff::inline v0_1::io::detail {

namespace {

/// Content of the header.
struct GsfHeader {
    std::string title;  // printable characters only
    std::string lateral_unit, height_unit;
    std::size_t columns{}, rows{};
    std::size_t trailer{};  // bytes after the heights
};

Record record_of(const GsfHeader& file, const RawMap& map) {
    Record record;
    record.note("form", "Gwyddion simple field" + (file.title.empty() ? "" : " \"" + file.title + "\""));
    record.note("units",
                "x and y in " + file.lateral_unit + ", heights in " + file.height_unit + ", from XYUnits and ZUnits");
    record.note("spacing", "from XReal / XRes and YReal / YRes");
    record.note_points(map);
    record.say_trailer(file.trailer);
    return record;
}

bool is_gsf(std::string_view bytes) { return bytes.starts_with("Gwyddion Simple Field 1."); }

class GsfReader {
public:
    GsfReader(std::string_view bytes, std::string_view name) : bytes_(bytes), name_(name) {}

    Reading read() {
        if (!is_gsf(bytes_))
            refuse_file(name_, {"does not begin as a simple field; must begin with \"Gwyddion Simple Field 1.0\""});
        const std::string_view heights = split();
        header_.columns = count("XRes");
        header_.rows = count("YRes");
        const double lateral = factor("XYUnits", header_.lateral_unit),
                     vertical = factor("ZUnits", header_.height_unit);
        header_.title = printable(find("Title").value_or(""), 80);
        const double dx = length("XReal") * lateral / static_cast<double>(header_.columns);
        const double dy = length("YReal") * lateral / static_cast<double>(header_.rows);
        RawMap map;
        header_.trailer = allocate_stored(map, header_.rows, header_.columns, 4, heights.size(), name_);
        for (std::size_t i = 0; i < map.heights.size(); ++i)
            set_height(map, i, real_at(heights.substr(4 * i, 4), false) * vertical);
        set_spacings(map, dx, dy, name_);
        Record record = record_of(header_, map);
        return {std::move(map), std::move(record)};
    }

private:
    /// Finds the fields; returns the bytes after the header.
    std::string_view split() {
        const std::size_t end = bytes_.find('\0');
        if (end == std::string_view::npos)
            refuse_file(name_, {"has no NUL byte that ends its header; must have one to four"});
        const std::size_t start = (end / 4 + 1) * 4;
        if (start > bytes_.size() || bytes_.substr(end, start - end).find_first_not_of('\0') != std::string_view::npos)
            refuse_file(name_, {"has a header of ", end, " bytes; must have NUL bytes after it up to byte ", start});
        std::string_view text = bytes_.substr(0, end);
        for (std::size_t line = 1; !text.empty(); ++line) {
            const std::size_t length = (std::min)(text.find('\n'), text.size());
            const std::string_view one = trimmed(text.substr(0, length));
            text.remove_prefix((std::min)(length + 1, text.size()));
            if (line == 1 || one.empty()) continue;
            const std::size_t equal = one.find('=');
            if (equal == std::string_view::npos)
                refuse_line(name_, line, {shown_cell(one), " has no equals sign; must be such as XRes = 256"});
            const std::string_view key = trimmed(one.substr(0, equal));
            if (find(key)) refuse_line(name_, line, {"states ", shown_cell(key), " again; must be stated once"});
            fields_.emplace_back(key, trimmed(one.substr(equal + 1)));
        }
        return bytes_.substr(start);
    }

    std::optional<std::string_view> find(std::string_view field) const {
        for (const auto& [key, value] : fields_)
            if (key == field) return value;
        return std::nullopt;
    }
    std::string_view stated(const std::string& field) const {
        if (const auto value = find(field)) return *value;
        refuse_file(name_, {"states no ", field, "; must state it in its header"});
    }
    double number(const std::string& field) const { return stated_number(name_, field, stated(field)); }
    std::size_t count(const std::string& field) const { return require_count(name_, field, number(field)); }
    double length(const std::string& field) const { return require_step(name_, field, number(field)); }
    /// The factor of the \p unit that the file states as \p field.
    double factor(const std::string& field, std::string& unit) const {
        unit = stated(field);
        return require_length_unit(name_, field, unit);
    }

    std::string_view bytes_;
    std::string name_;
    std::vector<std::pair<std::string_view, std::string_view>> fields_;
    GsfHeader header_;
};

}  // namespace

extern constexpr Reader gsf_reader{
    .format = SurfaceFormat::gsf,
    .endings = ".gsf",
    .holds = "Gwyddion simple field, with XReal, YReal and units of length",
    .recognised = "its first bytes",
    .begins = is_gsf,
    .read = read_by<GsfReader>,
    .may_begin = [](std::string_view bytes) { return bytes.starts_with("Gwyddion Simple Field"); }};

}  // namespace fstiff::inline v0_1::io::detail
