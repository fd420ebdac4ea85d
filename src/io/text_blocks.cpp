// SPDX-License-Identifier: BSD-3-Clause
#include "io/text_blocks.hpp"

#include "io/option_names.hpp"
#include "io/row_layout.hpp"
#include "io/unit_table.hpp"
#include "io/word_columns.hpp"
#include "io/zygo_xyz.hpp"

namespace fstiff::inline v0_1::io::detail {

namespace {

constexpr std::size_t least_profile = 16;  // rows

/// "Channel: Height" of Gwyddion, in the languages of its interface, and its like.
bool is_title_key(const std::string& key) {
    static constexpr std::array<std::string_view, 16> words{"channel",
                                                            "kanal",
                                                            "kan\xC3\xA1l",
                                                            "canal",
                                                            "canale",
                                                            "\xE3\x83\x81\xE3\x83\xA3\xE3\x83\x8D\xE3\x83\xAB",
                                                            "\xEC\xB1\x84\xEB\x84\x90",
                                                            "\xD0\x9A\xD0\xB0\xD0\xBD\xD0\xB0\xD0\xBB",
                                                            "title",
                                                            "titel",
                                                            "titre",
                                                            "name",
                                                            "data name",
                                                            "image",
                                                            "layer",
                                                            "trace"};
    return is_one_of_words(key, words);
}

/// \p line without its digits, for which "Trace 1" and "Trace 2" are one.
std::string without_digits(std::string_view line) {
    std::string rest(line);
    std::erase_if(rest, is_digit);
    return rest;
}

/// Lines that may be a block: where they begin, their first row, the line after them, and how many rows they have.
struct Stretch {
    std::size_t begin{}, row{}, end{}, rows{};
};

/// Finds where the blocks of the lines begin.
class BlockFinder {
public:
    BlockFinder(NumberTable table, const std::string& name, const SurfaceOptions& options)
        : name_(name), missing_(given_missing(options.missing, name)), table_(std::move(table)) {
        table_.lines.insert(table_.lines.end(), table_.footer.begin(), table_.footer.end());  // of the last block
    }

    std::vector<Stretch> parts() {
        find_starts();
        for (const std::vector<std::size_t>& starts : starts_) {
            if (starts.empty()) continue;
            std::vector<Stretch> found = parts_from(starts);
            if (found.size() > 1 && (&starts == &starts_[stated] || are_blocks(found, &starts == &starts_[blank])))
                return found;
            if (&starts == &starts_[stated]) break;
        }
        return {};
    }
    const NumberTable& table() const& { return table_; }
    /// The table as it was opened.
    NumberTable table() && {
        table_.lines.resize(table_.lines.size() - table_.footer.size());
        return std::move(table_);
    }
    std::span<const Line> lines() const { return table_.lines; }
    /// What the header states.
    const std::vector<HeaderEntry>& entries() {
        if (entries_.empty()) entries_ = header_entries(table_);
        return entries_;
    }

private:
    enum Kind { stated, repeated, blank };

    /// Whether line \p i may be a row; cheaply for those that begin with a number.
    bool is_row(std::size_t i) {
        const std::string_view line = table_.lines[i].text;
        const std::size_t sign = line[0] == '-' || line[0] == '+' || line[0] == '.' ? 1 : 0;
        if (line.size() > sign && is_digit(line[sign])) return true;
        if (is_comment(line)) return false;
        split_row(line, table_.dialect.separator, cells_);
        if (!table_.words.empty()) return cells_.size() == table_.words.size() && is_row_of(table_, cells_);
        const std::string_view cell = cells_.empty() ? std::string_view() : cells_.front();
        return cell.empty() || is_missing_word(cell) || missing_.has_word(cell) ||
               number_in(cell, table_.dialect.decimal_comma) || number_in(cell, false);
    }

    void find_starts() {
        const std::vector<Line>& lines = table_.lines;
        for (std::size_t i = table_.first + 1; i < lines.size(); ++i) {
            const bool gap = lines[i].number != lines[i - 1].number + 1;
            const std::size_t begin = i;
            const bool zygo = lines[i].text.starts_with(zygo_xyz_begin);
            while (i < lines.size() && (zygo ? lines[i].text != "#" : !is_row(i))) ++i;
            if (i == lines.size()) break;
            if (const auto kind = begin == i ? std::nullopt : kind_of(begin, i))
                starts_[zygo ? stated : *kind].push_back(begin);
            else if (gap || (begin < i && lines[i].number != lines[i - 1].number + 1))
                starts_[blank].push_back(begin);
        }
    }

    /// What the lines from \p begin to \p end, of which none is a row, state about a block; none for remarks.
    std::optional<Kind> kind_of(std::size_t begin, std::size_t end) {
        const auto run = std::span(table_.lines).subspan(begin, end - begin);
        bool again = false;
        for (const HeaderEntry& entry : header_entries(run, table_.dialect)) {
            if (is_size_key(entry.key) || is_height_unit_key(entry.key) || is_title_key(entry.key)) return stated;
            again = again || find_entry(entries(), entry.key) != nullptr;
        }
        for (const Line& line : run)
            again = again || is_in_head(line.text) ||
                    !units_in(line.text, table_.columns, table_.dialect.separator).empty();
        return again ? std::optional(repeated) : std::nullopt;
    }

    /// Whether the header has \p line, its digits aside; an ornament without a letter is in none.
    bool is_in_head(std::string_view line) {
        const auto is_letter = [](char c) { return (c | 0x20) >= 'a' || static_cast<unsigned char>(c) >= 0x80; };
        if (head_.empty()) {
            for (std::size_t i = 0; i < table_.first; ++i) head_.push_back(without_digits(table_.lines[i].text));
            std::sort(head_.begin(), head_.end());
        }
        return std::any_of(line.begin(), line.end(), is_letter) &&
               std::binary_search(head_.begin(), head_.end(), without_digits(line));
    }

    std::vector<Stretch> parts_from(const std::vector<std::size_t>& starts) {
        std::vector<Stretch> found;
        std::size_t begin = 0;
        for (std::size_t k = 0; k <= starts.size(); ++k) {
            Stretch part{.begin = begin, .end = k < starts.size() ? starts[k] : table_.lines.size()};
            for (part.row = k == 0 ? table_.first : begin; part.row < part.end && !is_row(part.row);) ++part.row;
            for (std::size_t i = part.row; i < part.end; ++i) part.rows += is_row(i);
            begin = part.end;
            found.push_back(part);
        }
        return found;
    }

    std::size_t last_row(const Stretch& part) {
        std::size_t i = part.end - 1;
        while (i > part.row && !is_row(i)) --i;
        return i;
    }

    /// Whether the rows of \p parts, which no statement divides, are tables of their own.
    bool are_blocks(const std::vector<Stretch>& parts, bool by_blanks) {
        std::size_t rows = 0;
        for (const Stretch& part : parts) {
            if (part.rows < (table_.columns == 1 && by_blanks ? least_profile : 2)) return false;
            rows += part.rows;
        }
        if (const auto count = stated_grid(entries(), "m", name_).rows; count && *count == rows) return false;
        if (table_.columns == 1) return true;
        const std::optional<std::size_t> axis = table_.columns == 2 ? std::optional(std::size_t(0)) : slow_axis(parts);
        if (!axis) return !steps_go_on(parts);
        for (std::size_t k = 1; k < parts.size(); ++k)
            if (!goes_on(parts[k - 1], parts[k], *axis, parts[0])) return !steps_go_on(parts);
        return false;
    }

    /// The numbers of the line \p i, NaN where there is none.
    std::vector<double> numbers(std::size_t i) {
        split_row(without_comment(table_.lines[i].text), table_.dialect.separator, cells_);
        std::vector<double> values;
        for (const std::string_view cell : cells_)
            values.push_back(
                number_in(cell, table_.dialect.decimal_comma).value_or(std::numeric_limits<double>::quiet_NaN()));
        values.resize(table_.columns, std::numeric_limits<double>::quiet_NaN());
        return values;
    }

    /// Whether every column that rises or falls in equal steps at first goes on from part to part; false without one.
    bool steps_go_on(const std::vector<Stretch>& parts) {
        constexpr std::size_t enough = 8;  // rows that show a step
        if (parts[0].rows < 3) return false;
        std::vector<std::vector<double>> rows;
        for (std::size_t i = parts[0].row; i < parts[0].end && rows.size() < enough; ++i)
            if (is_row(i)) rows.push_back(numbers(i));
        bool any = false;
        for (std::size_t c = 0; c < table_.columns; ++c) {
            const double step = rows[1][c] - rows[0][c];
            bool even = step != 0;
            for (std::size_t r = 2; r < rows.size(); ++r)
                even = even && std::abs(rows[r][c] - rows[r - 1][c] - step) <= 0.1 * std::abs(step);
            if (!even) continue;
            any = true;
            for (std::size_t k = 1; k < parts.size(); ++k) {
                const double end = numbers(last_row(parts[k - 1]))[c], begin = numbers(parts[k].row)[c];
                if (!((begin - end) * step > 0)) return false;
            }
        }
        return any;
    }

    /// Which of x and y is constant along the first scan line, where the first rows are triples.
    std::optional<std::size_t> slow_axis(const std::vector<Stretch>& parts) {
        const std::size_t row = parts[0].row;
        const auto first = numbers(row), second = numbers(row + 1), third = numbers(row + (parts[0].rows > 2 ? 2 : 1));
        for (const std::size_t s : {std::size_t(0), std::size_t(1)}) {
            const double step = second[1 - s] - first[1 - s], next = third[1 - s] - second[1 - s];
            const bool even = parts[0].rows < 3 || std::abs(next - step) <= 0.6 * std::abs(step);
            if (first[s] == second[s] && second[s] == third[s] && step != 0 && even) return s;
        }
        return std::nullopt;
    }

    /// Whether the positions \p s of \p next lie after those of \p last, seen from the rows before.
    bool goes_on(const Stretch& last, const Stretch& next, std::size_t s, const Stretch& first) {
        const double from = numbers(first.row)[s], end = numbers(last_row(last))[s], begin = numbers(next.row)[s];
        const double way = end != from ? end - from : begin - from;
        return table_.columns == 2 ? (begin - end) * way > 0 : begin == end ? begin != from : (begin - end) * way > 0;
    }

    const std::string& name_;
    MissingValues missing_;
    NumberTable table_;  // opened, its rows unread
    std::vector<HeaderEntry> entries_;
    std::vector<std::string> head_;  // lines with words above the first row, sorted, once they are needed
    std::array<std::vector<std::size_t>, 3> starts_;  // of lines, by Kind
    std::vector<std::string_view> cells_;
};

/// The words of a line that is neither an entry nor the titles of columns, without signs around them.
std::string prose(const NumberTable& table, const std::vector<HeaderEntry>& entries) {
    for (std::size_t i = table.first; i-- > 0;) {
        const Line& line = table.lines[i];
        if (std::any_of(entries.begin(), entries.end(), [&](const auto& entry) { return entry.line == line.number; }))
            continue;
        std::string_view words = trimmed(without_comment_sign(line.text, ' '));
        while (!words.empty() && std::string_view("[](){}\"'*=-:;,\t ").find(words.front()) < std::string_view::npos)
            words.remove_prefix(1);
        while (!words.empty() && std::string_view("[](){}\"'*=-:;,\t ").find(words.back()) < std::string_view::npos)
            words.remove_suffix(1);
        if (!words.empty() && units_in(line.text, table.columns, table.dialect.separator).empty())
            return printable(words, 40);
    }
    return {};
}

/// Finds what the header of \p block states.
void describe(TextBlock& block) {
    const NumberTable& table = block.table;
    const std::vector<HeaderEntry> entries = header_entries(table);
    for (const HeaderEntry& entry : entries) {
        if (is_title_key(entry.key)) block.title = printable(entry.value, 80);
        if (is_height_unit_key(entry.key)) block.unit = printable(entry.value, 16);
    }
    if (block.title.empty()) block.title = prose(table, entries);
    if (block.unit.empty())
        if (const auto found = title_units(table, table.columns); !found.units.empty())
            block.unit = printable(found.units.back(), 16);
    if (const auto titles = titles_above(table); block.unit.empty() && !titles.empty())
        block.unit = printable(titles.back().no_length, 16);
}

/// The lines of the first header whose keys \p own does not state.
std::vector<Line> inherited(const NumberTable& first, const std::vector<HeaderEntry>& head,
                            const std::vector<HeaderEntry>& own) {
    std::vector<Line> lines;
    for (std::size_t i = 0; i < first.first; ++i) {
        const auto entry =
            std::find_if(head.begin(), head.end(), [&](const auto& one) { return one.line == first.lines[i].number; });
        if (entry != head.end() && find_entry(own, entry->key) == nullptr) lines.push_back(first.lines[i]);
    }
    return lines;
}

std::string called(const TextBlock& block, std::size_t number) {
    return std::to_string(number) + (block.title.empty() ? "" : " \"" + block.title + "\"") + " in " +
           (block.unit.empty() ? "no unit" : block.unit) + " from line " + std::to_string(block.line);
}

}  // namespace

std::vector<TextBlock> blocks_of(std::vector<Line> lines, const std::string& name, const SurfaceOptions& options) {
    BlockFinder finder(open_table(std::move(lines), name, options), name, options);
    const std::vector<Stretch> parts = finder.parts();
    std::vector<TextBlock> blocks;
    if (parts.empty()) {
        blocks.push_back({.table = std::move(finder).table(), .line = 1});
        return blocks;
    }
    const NumberTable& table = finder.table();
    for (const Stretch& part : parts) {
        const auto all = finder.lines().subspan(part.begin, part.end - part.begin);
        const auto entries = header_entries(all.first(part.row - part.begin), table.dialect);
        const bool sized =
            std::any_of(entries.begin(), entries.end(), [](const auto& entry) { return is_size_key(entry.key); });
        std::vector<Line> own;
        if (part.begin > 0 && !sized) own = inherited(table, finder.entries(), entries);
        own.insert(own.end(), all.begin(), all.end());
        const std::size_t line = all.front().number;
        blocks.push_back({.table = open_table(std::move(own), name, options, line - 1), .line = line});
        describe(blocks.back());
    }
    return blocks;
}

ChosenBlock chosen_block(std::vector<TextBlock> blocks, const std::string& name, const SurfaceOptions& options) {
    const std::string wanted(trimmed(options.channel));
    if (blocks.size() == 1 && !wanted.empty()) describe(blocks[0]);
    std::string list;
    std::vector<std::size_t> lengths, unitless, found;
    for (std::size_t k = 0; k < blocks.size(); ++k) {
        const TextBlock& block = blocks[k];
        if (k < 12 || k + 1 == blocks.size())
            list += (list.empty() ? "" : k < 12 ? ", " : " ... ") + called(block, k + 1);
        if (is_unit(block.unit, Dimension::length)) lengths.push_back(k);
        if (!measures_no_length(block.unit)) unitless.push_back(k);
        if (std::to_string(k + 1) == wanted || (!wanted.empty() && lower_case(block.title) == lower_case(wanted)))
            found.push_back(k);
    }
    const std::string choice = given_as(options.names, "channel", "\"1\"");
    if (wanted.empty()) found = lengths.empty() ? unitless : lengths;
    if (found.size() > 1)
        refuse_file(name, {"holds ", blocks.size(), " tables of numbers: ", list, "; must be one of them, ", choice});
    if (found.empty() && wanted.empty())
        refuse_file(name, {"holds ", blocks.size(), " tables of numbers, none of heights: ", list,
                           "; must hold heights in a unit of length"});
    if (found.empty())
        refuse_file(name, {"has no channel ", shown_cell(wanted), "; must be one of ", list, ", ", choice});
    ChosenBlock chosen;
    for (std::size_t k = 0; k < blocks.size() && blocks.size() > 1; ++k) {
        if (k == found.front()) continue;
        chosen.others += (chosen.others.empty() ? "" : ", ") + called(blocks[k], k + 1);
    }
    if (blocks.size() > 1)
        chosen.called = called(blocks[found.front()], found.front() + 1) +
                        (wanted.empty() ? lengths.empty() ? ", the only one that may be of heights"
                                                          : ", the only one in a unit of length"
                                        : ", from options");
    chosen.block = std::move(blocks[found.front()]);
    return chosen;
}

void note_channels(Record& record, const ChosenBlock& chosen) {
    if (chosen.called.empty()) return;
    record.note("channel", chosen.called);
    record.note("other channels", chosen.others + ", not read");
}

}  // namespace fstiff::inline v0_1::io::detail
