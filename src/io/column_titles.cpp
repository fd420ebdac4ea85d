// SPDX-License-Identifier: BSD-3-Clause
#include "io/column_titles.hpp"

#include "io/unit_table.hpp"

namespace fstiff::inline v0_1::io::detail {

namespace {

bool is_length(std::string_view text) { return is_unit(text, Dimension::length); }

/// Whether \p text is a factor, as "x100" and "10^-3" are.
bool is_factor(std::string_view text) {
    text = trimmed(text);
    const bool before = text.starts_with('x') || text.starts_with('X') || text.starts_with('*') ||
                        text.starts_with("\xC3\x97") || text.starts_with('\xD7') || text.starts_with('/');
    if (before) text = trimmed(text.substr(text.starts_with("\xC3\x97") ? 2 : 1));
    const LeadingNumber number = leading_number(text);
    if (number.status != NumberStatus::ok) return false;
    const std::string_view rest = text.substr(number.length);
    return rest.empty() ? before : rest[0] == '^' || rest == "x" || rest == "X" || rest == "\xC3\x97";
}

/// The last word of \p title where it is a unit, as in "height in um".
std::string_view last_unit(std::string_view title) {
    const std::size_t last = title.find_last_of(" \t/_:=");
    const std::string_view word = last == std::string_view::npos ? title : title.substr(last + 1);
    if (!is_length(word) || std::any_of(word.begin(), word.end(), is_digit)) return {};
    if (word == "A" && (last == std::string_view::npos || title[last] != '/'))
        return {};  // the name of a column, or a channel
    if (last == std::string_view::npos) return word;
    const std::string_view before = trimmed(title.substr(0, last));
    // "0.0 um" is a length, no title; a bare "in" after a word is a preposition that lost its unit
    const std::string_view word_before = before.substr(before.find_last_of(" \t([{<") + 1);
    const bool after_sign = title[last] == '/' || before.ends_with('/') || before.ends_with(" in");
    if (before.empty() || is_number(word_before) || (word == "in" && !after_sign)) return {};
    return word;
}

/// The unit of \p title that is of no length, in brackets or as its last word.
std::string_view other_unit(std::string_view title) {
    if (const auto brackets = brackets_in(title); !brackets.empty() && measures_no_length(brackets.back().inside))
        return brackets.back().inside;
    for (const char* sign : {" \t_:=", "/"}) {
        const std::size_t last = title.find_last_of(sign);
        const std::string_view word = title.substr(last + 1);  // the whole title where there is no sign
        // a letter alone, or one with a number, is a name unless a stroke is before it
        const bool is_name = word.size() < 2 || std::any_of(word.begin(), word.end(), is_digit);
        if ((!is_name || (sign[0] == '/' && last < title.size())) && measures_no_length(word)) return word;
    }
    return {};
}

/// Whether \p line is a key and a number, as "Pitch [um]: 0.5" is, and no title of one column.
bool is_key_and_number(std::string_view line) {
    const std::size_t sign = line.find_first_of(",;\t:=");
    return sign != std::string_view::npos &&
           leading_number(trimmed(line.substr(sign + 1))).status != NumberStatus::no_number;
}

/// Whether \p line is the name of a part of the file, "[Data]", and no unit.
bool is_section(std::string_view line) {
    line = trimmed(line);
    if (line.size() < 5 || line.front() != '[' || line.back() != ']' || line[1] < 'A' || line[1] > 'Z') return false;
    const std::string_view name = line.substr(1, line.size() - 2);
    return !is_length(name) && !measures_no_length(name);
}

/// Whether \p line is a key and a unit, or a number with one, as "x-unit: mm" and "Stylus radius = 2 um" are.
bool is_key_and_unit(std::string_view line) {
    const std::size_t sign = line.find_first_of(":=");
    if (sign == std::string_view::npos) return false;
    const std::string_view value = trimmed(line.substr(sign + 1));
    const std::size_t end = (std::min)(value.find_first_not_of("+-0123456789.,"), value.size());
    const std::string_view unit = trimmed(value.substr(end));
    return unit.empty() ? end > 0 : is_length(unit) || measures_no_length(unit);
}

}  // namespace

std::vector<Bracket> brackets_in(std::string_view text) {
    constexpr std::string_view opening = "[({<", closing = "])}>";
    std::vector<Bracket> brackets;
    for (std::size_t begin = 0; (begin = text.find_first_of(opening, begin)) != std::string_view::npos;) {
        const std::size_t end = text.find(closing[opening.find(text[begin])], begin);
        if (end == std::string_view::npos) break;
        brackets.push_back({text[begin], trimmed(text.substr(begin + 1, end - begin - 1)), begin, end + 1});
        begin = end + 1;
    }
    return brackets;
}

bool Bracket::states_unit() const {
    const bool number = !inside.empty() && (is_digit(inside[0]) || inside[0] == '.');
    return is_length(inside) && (!number || sign == '[' || inside.find('^') != std::string_view::npos);
}

TitleUnit unit_of_title(std::string_view title) {
    title = unquoted(title);
    std::vector<std::string_view> lengths, others;
    const std::vector<Bracket> brackets = brackets_in(title);
    for (const Bracket& bracket : brackets)
        if (!bracket.inside.empty()) (bracket.states_unit() ? lengths : others).push_back(bracket.inside);
    TitleUnit stated;
    stated.scaled = !lengths.empty() && (is_factor(title.substr(brackets.back().end)) ||
                                         std::any_of(others.begin(), others.end(), is_factor));
    const bool agree = std::all_of(lengths.begin(), lengths.end(), [&](std::string_view unit) {
        return unit_factor(unit, Dimension::length) == unit_factor(lengths[0], Dimension::length);
    });
    if (stated.scaled || !agree)
        stated.unread = trimmed(title.substr(brackets.front().begin));
    else if (std::none_of(others.begin(), others.end(), measures_no_length))  // else "force (N/m)"
        stated.length = lengths.empty() ? last_unit(title) : lengths[0];
    const auto is_word = [](std::string_view inside) { return inside.find_first_not_of("- ") < inside.size(); };
    const auto word = std::find_if(others.begin(), others.end(), is_word);
    if (lengths.empty() && stated.length.empty() && word != others.end()) stated.unread = *word;
    return stated;
}

std::string_view title_unit(std::string_view title) { return unit_of_title(title).length; }

std::string_view without_comment_sign(std::string_view line, char separator) {
    line = trimmed(line);
    const bool signed_line = is_comment(line);
    while (!line.empty() && (line.front() == '#' || line.front() == '%' || line.front() == '!' || line.front() == '/'))
        line.remove_prefix(1);
    if (signed_line && line.starts_with(separator) && separator != ' ') line.remove_prefix(1);  // "#;x [um];z [nm]"
    return line;
}

std::vector<std::string_view> units_in(std::string_view line, std::size_t columns, char separator,
                                       const FreeColumns& free) {
    const auto is_free = [&](std::size_t c) { return !free.empty() && free[c]; };
    const auto needed =
        static_cast<std::size_t>(std::count_if(free.begin(), free.end(), [](bool one) { return !one; }));
    std::vector<std::string_view> cells, found;
    const auto in_cells = [&](char candidate) {
        split_line(line, candidate, cells);
        if (cells.size() != columns || (columns == 1 && is_key_and_number(line))) return false;
        found.clear();
        std::size_t stated = 0;
        for (std::size_t c = 0; c < columns; ++c) {
            found.push_back(title_unit(cells[c]));
            stated += !found.back().empty();
            if (found.back().empty() && !(is_free(c) && candidate == separator)) return false;
        }
        return stated > 0;
    };
    if (!free.empty() && in_cells(separator)) return found;  // "#;x [um];z [um]": the sign may be a title
    line = without_comment_sign(line, separator);
    for (const char candidate : {separator, ';', '\t', ',', ' '})
        if ((candidate == separator || line.find(candidate) < line.size()) && in_cells(candidate)) return found;
    if (columns == 1 || unit_of_title(line).scaled) return {};
    found.clear();  // "x [um] z [nm]": as many in brackets as columns, in their order
    for (const Bracket& bracket : brackets_in(line))
        if (bracket.states_unit()) found.push_back(bracket.inside);
    if (found.size() == columns) return found;
    if (free.empty() || found.size() != needed) return {};
    for (std::size_t c = 0; c < columns; ++c)
        if (is_free(c)) found.insert(found.begin() + static_cast<std::ptrdiff_t>(c), std::string_view());
    return found;
}

std::vector<std::string_view> given_units(const std::string& text, std::size_t most, const std::string& name,
                                          std::string_view allowed) {
    std::vector<std::string_view> given;
    if (text.empty()) return given;
    split_line(text, ',', given);
    if (given.empty() || given.size() > most) refuse_field(name, "units", shown_cell(text), allowed);
    for (const std::string_view unit : given) (void)unit_factor(unit, Dimension::length);
    return given;
}

TitleUnits title_units(const NumberTable& table, std::size_t columns, const FreeColumns& free) {
    for (std::size_t i = table.first; i-- > 0;)
        if (auto found = units_in(table.lines[i].text, columns, table.dialect.separator, free); !found.empty())
            return {std::move(found), "line " + std::to_string(table.lines[i].number)};
    return {};
}

ColumnTitle title_of(std::string_view cell) {
    cell = unquoted(cell);
    std::string name = lower_case(trimmed(cell.substr(0, (std::min)(cell.find_first_of("[({<"), cell.size()))));
    while (name.size() > 1 && (name.back() == '.' || name.back() == ':' || name.back() == ' ')) name.pop_back();
    while (name.size() > 1 && (name.front() == '#' || name.front() == ' ')) name.erase(0, 1);
    const TitleUnit stated = unit_of_title(cell);
    return {std::move(name), stated.length, stated.unread,
            stated.length.empty() ? other_unit(cell) : std::string_view()};
}

void split_titles(std::string_view line, char separator, std::vector<std::string_view>& cells) {
    if (separator != ' ') return split_row(line, separator, cells);
    std::vector<std::string_view> words;
    split_line(line, separator, words);
    cells.clear();
    const auto is_open = [](std::string_view cell) {  // "z [10^-6" of "z [10^-6 m]"
        const std::size_t begin = cell.find_last_of("[(");
        return begin < cell.size() && cell.find_first_of("])", begin) == std::string_view::npos;
    };
    const auto begins_unit = [](std::string_view word) { return word.starts_with('[') || word.starts_with('('); };
    const bool titled = !words.empty() && !begins_unit(words.front());  // else "[mm] [nm]"
    for (const std::string_view word : words)
        if (!cells.empty() && !word.empty() && ((titled && begins_unit(word)) || is_open(cells.back())))
            cells.back() = {cells.back().data(),
                            static_cast<std::size_t>(word.data() + word.size() - cells.back().data())};
        else
            cells.push_back(word);
}

bool names_something(std::string_view cell) {
    const ColumnTitle title = title_of(cell);
    return !title.unit.empty() || !title.no_length.empty() || names_index(title.name) || names_position(title.name) ||
           names_height(title.name) || names_neither(title.name) || names_error(title.name) || names_pixel(title.name);
}

std::vector<std::string_view> cells_above(const std::vector<Line>& lines, std::size_t first, char separator) {
    std::vector<std::string_view> cells;
    if (first > 0) split_titles(without_comment_sign(lines[first - 1].text, separator), separator, cells);
    return cells;
}

bool has_titles(const std::vector<Line>& lines, std::size_t first, char separator, std::size_t columns) {
    const auto cells = cells_above(lines, first, separator);
    return cells.size() == columns &&
           std::none_of(cells.begin(), cells.end(), [](auto cell) { return !cell.empty() && is_digit(cell.front()); });
}

bool is_titled(const std::vector<ColumnTitle>& titles) {
    return std::any_of(titles.begin(), titles.end(), [](const ColumnTitle& title) { return !title.name.empty(); });
}

namespace {

/// The titles in \p line that end with a unit in brackets each.
void split_at_units(std::string_view line, std::vector<std::string_view>& cells) {
    cells.clear();
    for (std::string_view rest = trimmed(line); !rest.empty();) {
        const std::size_t end = rest.find_first_of("])");
        if (end == std::string_view::npos) return cells.clear();
        cells.push_back(trimmed(rest.substr(0, end + 1)));
        if (title_unit(cells.back()).empty()) return cells.clear();
        rest = trimmed(rest.substr(end + 1));
    }
}

/// Lines of titles above a table, cut in the way of its rows or otherwise.
class TitleLines {
public:
    explicit TitleLines(const NumberTable& table) : table_(table), titles_(table.columns) {}

    std::vector<ColumnTitle> titles() {
        for (std::size_t i = table_.first; i-- > 0 && own_ < 2;) {
            const std::string_view text = table_.lines[i].text;
            const bool as_rows = is_cut_as_rows(text);
            if (!as_rows && (written_ == 2 || !is_cut_otherwise(text))) continue;
            if (as_rows) ++own_;
            if (as_rows && table_.columns > 1 && is_key_and_unit(text)) {
                ++written_;  // no title, but what is above is as far away as above one
                continue;
            }
            const std::size_t number = table_.lines[i].number;
            for (std::size_t c = 0; as_rows && c < cells_.size(); ++c) add(titles_[c], title_of(cells_[c]), number);
            if (as_rows) are_units_ = own_ == 1 && std::all_of(cells_.begin(), cells_.end(), is_unit_alone);
            if (++written_ > 2) continue;
            for (std::size_t c = 0; c < cells_.size(); ++c) {
                titles_[c].text = std::string(cells_[c]) + (written_ > 1 ? " " + titles_[c].text : "");
                titles_[c].line = number;
            }
        }
        return std::move(titles_);
    }

private:
    /// Whether the cells are titles, where \p lines of titles are below them: a line above may be a key and its value,
    /// "Objective:;20X".
    bool may_be_titles(std::string_view line, int lines) const {
        if (cells_.size() != table_.columns) return false;
        if (table_.columns == 1 && (is_key_and_number(line) || is_section(line))) return false;
        return std::none_of(cells_.begin(), cells_.end(), [&](std::string_view cell) {
            return number_in(cell, table_.dialect.decimal_comma) ||
                   (lines > 0 && !cell.empty() && is_digit(cell.front()));
        });
    }

    bool is_cut_as_rows(std::string_view text) {
        const char separator = table_.dialect.separator;
        for (const std::string_view line : {without_comment_sign(text, separator), text}) {  // a title may be "#"
            split_titles(line, separator, cells_);
            if (!may_be_titles(line, own_)) continue;
            const bool may_be_prose = separator == ' ' && table_.columns > 1 && is_comment(text);
            if (!may_be_prose || std::any_of(cells_.begin(), cells_.end(), names_something)) return true;
        }
        return false;
    }

    /// Whether \p cell is a unit and no more, or a sign for none.
    static bool is_unit_alone(std::string_view cell) {
        const auto is_letter = [](char c) { return (c | 0x20) >= 'a' || static_cast<unsigned char>(c) >= 0x80; };
        return title_unit(cell) == cell || measures_no_length(cell) ||
               std::none_of(cell.begin(), cell.end(), is_letter);
    }

    bool is_cut_otherwise(std::string_view text) {
        const std::string_view line = without_comment_sign(text, table_.dialect.separator);
        if (table_.dialect.separator == ' ' && table_.columns > 1)
            for (const char separator : {';', '\t', ','}) {
                split_titles(line, separator, cells_);
                if (cells_.size() == table_.columns) return may_be_titles(line, written_);
            }
        split_at_units(line, cells_);
        return may_be_titles(line, written_);
    }

    void add(ColumnTitle& title, const ColumnTitle& above, std::size_t line) const {
        if (are_units_ || title_unit(title.name) == title.name) title.name = above.name;  // none, or a unit alone
        if (title.no_length.empty()) title.no_length = above.no_length;
        if (title.unit.empty()) title.unit = above.unit;
        if (title.unread.empty()) title.unread = above.unread;
        title.line = line;
    }

    const NumberTable& table_;
    std::vector<ColumnTitle> titles_;
    std::vector<std::string_view> cells_{};
    int own_ = 0, written_ = 0;  // lines that are cut as the rows are, and all
    bool are_units_ = false;     // the nearest of them holds units alone
};

}  // namespace

std::vector<ColumnTitle> titles_above(const NumberTable& table) { return TitleLines(table).titles(); }

}  // namespace fstiff::inline v0_1::io::detail
