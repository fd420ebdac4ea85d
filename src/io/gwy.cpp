// SPDX-License-Identifier: BSD-3-Clause
/// \file
/// Reads one channel of a file of Gwyddion (.gwy).
///
/// "GWYP" and a tree of objects, least significant byte first. An object is its name with a NUL byte, the bytes of its
/// content as uint32, and components: name, NUL, a letter of the type, and the value.
///
///     b, c   1 byte           s   text with a NUL byte                 C, I, Q, D   uint32 count, then the elements
///     i      int32            o   an object                            S, O         uint32 count, then texts or
///     objects q, d   int64, float64
///
/// The outer object is a GwyContainer. Channel N is the GwyDataField "/N/data" of xres columns and yres rows over a
/// width xreal and a height yreal in the unit si_unit_xy, its heights in si_unit_z as float64, row after row from the
/// top. Its name is "/N/data/title". Points that its mask "/N/mask" marks (1; 0 elsewhere) are taken for missing.
///
///     dx = xreal / xres,    dy = yreal / yres
///
/// The lowest channel whose units are lengths is read, or the one that the options name by its number or its title;
/// the record lists the others. Graphs, volumes, clouds of points and the files of Gwyddion 1 (GWYO) are not read.
///
/// Reference   Gwyddion user guide, "Format of Gwyddion Files". Deviation: a missing or empty unit is refused.
/// Units       map in m
/// Valid       2 points a side at least, or one row; heights that vary; files up to 2^31 bytes
/// Accuracy    number times unit, rounded once (tests/io/gwy_test.cpp)

#include "io/readers.hpp"

#include "io/binary_numbers.hpp"
#include "io/required.hpp"

#include <fstiff/io/units.hpp>

#include <map>

namespace fstiff::inline v0_1::io::detail {

namespace {

/// Content of the file.
struct GwyHeader {
    std::string channel;              // "0 \"Height\""
    std::string channel_from;         // why it is that one
    std::vector<std::string> others;  // channels that were not read, with their units
    std::string lateral_unit, height_unit;
    std::size_t columns{}, rows{};
    std::size_t masked{};   // of the missing ones, those that the mask marks
    std::size_t trailer{};  // bytes after the tree
};

/// The components of one object, read from its front to its end.
class GwyCursor {
public:
    GwyCursor(std::string_view bytes, const std::string& name) : rest_(bytes), name_(name) {}

    bool at_end() const { return rest_.empty(); }
    std::size_t left() const { return rest_.size(); }

    std::string_view take(std::uint64_t size, std::string_view what) {
        if (size > rest_.size())
            refuse_file(name_, {"ends within ", shown_cell(what), ", which has ", size, " bytes where ", rest_.size(),
                                " are left; must be whole"});
        const std::string_view taken = rest_.substr(0, static_cast<std::size_t>(size));
        rest_.remove_prefix(taken.size());
        return taken;
    }
    std::string_view text(std::string_view what) {
        const std::size_t end = rest_.find('\0');
        if (end == std::string_view::npos)
            refuse_file(name_, {"ends within the text of ", shown_cell(what), "; must have a NUL byte after it"});
        const std::string_view found = rest_.substr(0, end);
        rest_.remove_prefix(end + 1);
        return found;
    }
    std::uint64_t count(std::string_view what) { return unsigned_at(take(4, what), false); }

    /// The content of an object, which must be called \p wanted where that is not empty.
    std::string_view object(std::string_view what, std::string_view wanted = {}) {
        const std::string_view called = text(what);
        if (!wanted.empty() && called != wanted)
            refuse_file(name_,
                        {"holds an object ", shown_cell(called), " as ", shown_cell(what), "; must be a ", wanted});
        return take(count(what), what);
    }
    /// Leaves out a value of \p type.
    void skip(char type, std::string_view what) {
        switch (type) {
            case 'b':
            case 'c':
            case 'C': take(type == 'C' ? count(what) : 1, what); return;
            case 'i': take(4, what); return;
            case 'q':
            case 'd': take(8, what); return;
            case 'I': take(4 * count(what), what); return;
            case 'Q':
            case 'D': take(8 * count(what), what); return;
            case 's': text(what); return;
            case 'o': object(what); return;
            case 'S':
                for (std::uint64_t left = count(what); left > 0; --left)
                    text(what);  // every one takes a byte, or ends it
                return;
            case 'O':
                for (std::uint64_t left = count(what); left > 0; --left) object(what);
                return;
            default:
                refuse_file(name_, {"holds ", shown_cell(what), " of the type ", shown_cell({&type, 1}),
                                    "; must be one of b, c, i, q, d, s, o, C, I, Q, D, S, O"});
        }
    }
    /// Calls use(name, type) for every component; what it does not take (false) is left out.
    template <class Use>
    void components(const Use& use) {
        while (!at_end()) {
            const std::string_view called = text("a component");
            const char type = take(1, called).front();
            if (!use(called, type)) skip(type, called);
        }
    }

private:
    std::string_view rest_;
    const std::string& name_;
};

Record record_of(const GwyHeader& file, const RawMap& map) {
    Record record;
    record.note("form", "Gwyddion file, channel " + file.channel + ", " +
                            (file.channel_from == "options" ? "from options" : file.channel_from));
    std::string others;
    for (const std::string& other : file.others) others += (others.empty() ? "" : ", ") + other;
    if (!others.empty()) record.note("other channels", others + ", not read");
    record.note("units", "x and y in " + file.lateral_unit + ", heights in " + file.height_unit + ", from the file");
    record.note("spacing", "from xreal / xres and yreal / yres");
    const std::string masked = std::to_string(file.masked);
    record.note_points(map, file.masked == 0 ? "" : " (" + masked + " of them under the mask)");
    record.say_trailer(file.trailer);
    if (file.masked != 0)
        record.warnings.push_back(
            "the file has a mask over " + masked +
            " points, which were taken for missing; where it marks something else, save the file without the mask");
    return record;
}

bool is_gwy(std::string_view bytes) { return bytes.starts_with("GWYP"); }

class GwyReader {
public:
    GwyReader(std::string_view bytes, std::string_view name, const SurfaceOptions& options)
        : bytes_(bytes), name_(name), wanted_(trimmed(options.channel)) {}

    Reading read() {
        if (!is_gwy(bytes_)) refuse_file(name_, {"does not begin as a file of Gwyddion; must begin with GWYP"});
        find_channels();
        const Channel& chosen = choose();
        const Field field = field_of(chosen.data, chosen.called + "/data");
        header_.columns = field.columns;
        header_.rows = field.rows;
        header_.lateral_unit = length_unit("si_unit_xy", field.lateral_unit);
        header_.height_unit = length_unit("si_unit_z", field.height_unit);
        RawMap map;
        read_heights(map, field);
        if (!chosen.mask.empty()) apply(field_of(chosen.mask, chosen.called + "/mask"), map);
        const double lateral = unit_factor(header_.lateral_unit, Dimension::length);
        set_spacings(map, require_step(name_, "xreal", field.width) * lateral / static_cast<double>(field.columns),
                     require_step(name_, "yreal", field.height) * lateral / static_cast<double>(field.rows), name_);
        Record record = record_of(header_, map);
        return {std::move(map), std::move(record)};
    }

private:
    struct Channel {
        std::string called;  // "/0"
        std::string title;   // printable characters only
        std::string_view data, mask;
    };
    struct Field {
        std::size_t columns{}, rows{};
        double width{}, height{};
        std::string lateral_unit, height_unit;
        std::string_view numbers;
    };

    /// The number N of "/N/rest"; none for other names.
    static std::optional<unsigned> number_of(std::string_view key, std::string_view rest) {
        if (!key.starts_with('/') || !key.ends_with(rest)) return std::nullopt;
        const std::string_view digits = key.substr(1, key.size() - (std::min)(key.size(), 1 + rest.size()));
        if (digits.empty() || digits.size() > 9 || !std::all_of(digits.begin(), digits.end(), is_digit))
            return std::nullopt;
        unsigned number = 0;
        for (const char digit : digits) number = 10 * number + static_cast<unsigned>(digit - '0');
        return number;
    }

    void find_channels() {
        GwyCursor file(bytes_.substr(4), name_);
        GwyCursor tree(file.object("the tree", "GwyContainer"), name_);
        header_.trailer = file.left();
        const auto once = [&](std::string_view& slot, std::string_view key, std::string_view content) {
            if (slot.data() != nullptr) refuse_file(name_, {"holds ", shown_cell(key), " twice; must be stated once"});
            slot = content;
        };
        tree.components([&](std::string_view key, char type) {
            if (const auto n = number_of(key, "/data"); n && type == 'o')
                once(channels_[*n].data, key, tree.object(key, "GwyDataField"));
            else if (const auto of = number_of(key, "/mask"); of && type == 'o')
                once(channels_[*of].mask, key, tree.object(key, "GwyDataField"));
            else if (const auto titled = number_of(key, "/data/title"); titled && type == 's')
                channels_[*titled].title = printable(tree.text(key), 80);
            else
                return false;
            return true;
        });
        std::erase_if(channels_, [](const auto& channel) { return channel.second.data.data() == nullptr; });
        for (auto& [number, channel] : channels_) channel.called = "/" + std::to_string(number);
        if (channels_.empty()) refuse_file(name_, {"holds no image (no /0/data); must hold a map of heights"});
    }

    Field field_of(std::string_view content, const std::string& what) const {
        Field field;
        GwyCursor object(content, name_);
        object.components([&](std::string_view key, char type) {
            const auto is = [&](std::string_view called, char of) {
                if (key != called) return false;
                if (type != of)
                    refuse_file(name_, {"holds ", key, " of ", what, " as type ", shown_cell({&type, 1}), "; must be ",
                                        shown_cell({&of, 1})});
                return true;
            };
            if (is("xres", 'i'))
                field.columns = count_of("xres", object.take(4, key));
            else if (is("yres", 'i'))
                field.rows = count_of("yres", object.take(4, key));
            else if (is("xreal", 'd'))
                field.width = double_at(object.take(8, key));
            else if (is("yreal", 'd'))
                field.height = double_at(object.take(8, key));
            else if (is("si_unit_xy", 'o'))
                field.lateral_unit = unit_of(object.object(key, "GwySIUnit"));
            else if (is("si_unit_z", 'o'))
                field.height_unit = unit_of(object.object(key, "GwySIUnit"));
            else if (is("data", 'D'))
                field.numbers = object.take(8 * object.count(key), key);
            else
                return false;
            return true;
        });
        // both below 2^31: the product fits into 64 bits
        if (std::uint64_t(field.columns) * field.rows != field.numbers.size() / 8 || field.numbers.empty())
            refuse_file(name_, {"declares ", field.columns, " x ", field.rows, " numbers in ", what, ", but holds ",
                                field.numbers.size() / 8, "; must hold all"});
        return field;
    }
    std::size_t count_of(const std::string& field, std::string_view bytes) const {
        const std::int64_t value = signed_at(bytes, false);
        if (value < 1) refuse_field(name_, field, std::to_string(value), "at least 1");
        return static_cast<std::size_t>(value);
    }
    std::string unit_of(std::string_view content) const {
        std::string unit;
        GwyCursor object(content, name_);
        object.components([&](std::string_view key, char type) {
            if (key != "unitstr" || type != 's') return false;
            unit = object.text(key);
            return true;
        });
        return unit;
    }
    std::string length_unit(const std::string& field, const std::string& unit) const {
        (void)require_length_unit(name_, field + " of channel " + header_.channel, unit);
        return unit;
    }

    static std::string shown(unsigned number, const Channel& channel) {
        return std::to_string(number) + (channel.title.empty() ? "" : " \"" + channel.title + "\"");
    }

    /// The channel to read, with a note of the others.
    const Channel& choose() {
        std::string list;
        const std::pair<const unsigned, Channel>* chosen = nullptr;
        std::map<unsigned, std::string> described;
        const bool by_number = !wanted_.empty() && std::all_of(wanted_.begin(), wanted_.end(), is_digit);
        for (const auto& one : channels_) {
            const Field field = field_of(one.second.data, one.second.called + "/data");
            const bool length =
                is_unit(field.height_unit, Dimension::length) && is_unit(field.lateral_unit, Dimension::length);
            described[one.first] = shown(one.first, one.second) + " in " +
                                   (field.height_unit.empty() ? "no unit" : shown_cell(field.height_unit));
            list += (list.empty() ? "" : ", ") + described[one.first];
            const bool wanted = wanted_.empty() ? length
                                : by_number     ? std::to_string(one.first) == wanted_
                                                : lower_case(one.second.title) == lower_case(printable(wanted_, 80));
            if (wanted && chosen && !wanted_.empty())
                refuse_file(name_, {"has two channels ", shown_cell(wanted_), " among ", list, "; give its number"});
            if (wanted && !chosen) chosen = &one;
        }
        if (!chosen && wanted_.empty())
            refuse_file(name_,
                        {"has no channel in units of length (it has ", list, "); must have heights over lengths"});
        if (!chosen) refuse_file(name_, {"has no channel ", shown_cell(wanted_), "; must be one of ", list});
        header_.channel = shown(chosen->first, chosen->second);
        header_.channel_from = !wanted_.empty()        ? "options"
                               : channels_.size() == 1 ? "the only one"
                                                       : "the lowest whose units are lengths";
        for (const auto& [number, text] : described)
            if (number != chosen->first) header_.others.push_back(text);
        return chosen->second;
    }

    void read_heights(RawMap& map, const Field& field) const {
        const double factor = unit_factor(header_.height_unit, Dimension::length);
        allocate(map, field.rows, field.columns);
        for (std::size_t i = 0; i < field.columns * field.rows; ++i) {
            const double z = double_at(field.numbers.substr(8 * i, 8));
            map.heights[i] = std::isinf(z) ? std::numeric_limits<double>::quiet_NaN() : z * factor;
        }
    }

    /// Makes missing what the mask marks.
    void apply(const Field& mask, RawMap& map) {
        if (mask.columns != header_.columns || mask.rows != header_.rows)
            refuse_file(name_, {"has a mask of ", mask.columns, " x ", mask.rows, " points over heights of ",
                                header_.columns, " x ", header_.rows, "; must be as many"});
        for (std::size_t i = 0; i < mask.numbers.size() / 8; ++i)
            if (double_at(mask.numbers.substr(8 * i, 8)) >= 0.5) {
                map.heights[i] = std::numeric_limits<double>::quiet_NaN();
                ++header_.masked;
            }
    }

    std::string_view bytes_;
    std::string name_;
    std::string wanted_;
    std::map<unsigned, Channel> channels_;
    GwyHeader header_;
};

}  // namespace

extern constexpr Reader gwy_reader{.format = SurfaceFormat::gwy,
                                   .endings = ".gwy",
                                   .holds = "Gwyddion file: one channel, its masked points missing",
                                   .recognised = "its first bytes, GWYP",
                                   .asks_for = "--channel, to read another than the lowest in lengths",
                                   .options = "channel",
                                   .begins = is_gwy,
                                   .read = read_by<GwyReader>};

}  // namespace fstiff::inline v0_1::io::detail
