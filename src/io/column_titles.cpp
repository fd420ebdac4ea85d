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

/// What a title states of a unit.
struct TitleParts {
    std::vector<std::string_view> inside;  // the brackets, those of length first
    std::size_t lengths{};                 // of them
    bool contradicts{}, scaled{};          // two units; a factor next to the unit
    std::string_view from_bracket;         // the title from the first bracket on
};

TitleParts parts_of(std::string_view title) {
    TitleParts parts;
    std::string_view outside = title;
    for (std::string_view rest = title; !rest.empty();) {
        const std::size_t begin = rest.find_first_of("[({<");
        if (begin == std::string_view::npos) break;
        const std::size_t end = rest.find(rest[begin] == '['   ? ']'
                                          : rest[begin] == '(' ? ')'
                                          : rest[begin] == '{' ? '}'
                                                               : '>',
                                          begin);
        if (end == std::string_view::npos) break;
        const auto inside = trimmed(rest.substr(begin + 1, end - begin - 1));
        if (parts.from_bracket.empty()) parts.from_bracket = trimmed(rest.substr(begin));
        // "(0.1 mm)" may be a length: a number belongs to a unit in square brackets, or after a sign of multiplication
        const bool bare_number = !inside.empty() && rest[begin] != '[' && (is_digit(inside[0]) || inside[0] == '.') &&
                                 inside.find('^') == std::string_view::npos;
        if (is_length(inside) && !bare_number)
            parts.inside.insert(parts.inside.begin() + static_cast<std::ptrdiff_t>(parts.lengths++), inside);
        else if (!inside.empty())
            parts.inside.push_back(inside);
        rest.remove_prefix(end + 1);
        outside = rest;
    }
    for (std::size_t i = 0; i < parts.inside.size(); ++i)
        if (i >= parts.lengths)
            parts.scaled = parts.scaled || is_factor(parts.inside[i]);
        else if (unit_factor(parts.inside[i], Dimension::length) != unit_factor(parts.inside[0], Dimension::length))
            parts.contradicts = true;
    parts.scaled = parts.lengths > 0 && (parts.scaled || is_factor(outside));
    return parts;
}

}  // namespace

std::string_view title_unit(std::string_view title) {
    title = unquoted(title);
    const TitleParts parts = parts_of(title);
    if (std::any_of(parts.inside.begin(), parts.inside.end(), measures_no_length)) return {};  // "force (N/m)"
    if (parts.lengths > 0) return parts.contradicts || parts.scaled ? std::string_view() : parts.inside[0];
    const std::size_t last = title.find_last_of(" \t/_:=");
    const std::string_view word = last == std::string_view::npos ? title : title.substr(last + 1);
    if (!is_length(word) || std::any_of(word.begin(), word.end(), is_digit)) return {};
    if (word == "A" && (last == std::string_view::npos || title[last] != '/'))
        return {};  // the name of a column, or a channel
    if (last == std::string_view::npos) return word;
    const std::string_view before = trimmed(title.substr(0, last));
    // "0.0 um" is a length, no title; a bare "in" after a word is a preposition that lost its unit
    if (before.empty() || is_digit(before.back()) || (word == "in" && title[last] != '/' && !before.ends_with(" in")))
        return {};
    return word;
}

std::string_view unread_unit(std::string_view title) {
    title = unquoted(title);
    const TitleParts parts = parts_of(title);
    if (parts.contradicts || parts.scaled) return parts.from_bracket;
    if (parts.lengths > 0 || !title_unit(title).empty()) return {};
    for (const std::string_view inside : parts.inside)
        if (std::any_of(inside.begin(), inside.end(), [](char c) { return c != '-' && c != ' '; })) return inside;
    return {};
}

std::string_view without_comment_sign(std::string_view line, char separator) {
    line = trimmed(line);
    const bool signed_line = is_comment(line);
    while (!line.empty() && (line.front() == '#' || line.front() == '%' || line.front() == '!' || line.front() == '/'))
        line.remove_prefix(1);
    if (signed_line && line.starts_with(separator) && separator != ' ') line.remove_prefix(1);  // "#;x [um];z [nm]"
    return line;
}

bool is_key_and_number(std::string_view line) {
    const std::size_t sign = line.find_first_of(",;\t:=");
    return sign != std::string_view::npos &&
           leading_number(trimmed(line.substr(sign + 1))).status != NumberStatus::no_number;
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
    if (columns == 1 || parts_of(line).scaled) return {};
    // "x [um] z [nm]": as many bracketed found as columns, in their order
    found.clear();
    for (std::string_view rest = line; !rest.empty();) {
        const std::size_t begin = rest.find_first_of("[(");
        if (begin == std::string_view::npos) break;
        const std::size_t end = rest.find(rest[begin] == '[' ? ']' : ')', begin);
        if (end == std::string_view::npos) break;
        const auto inside = trimmed(rest.substr(begin + 1, end - begin - 1));
        if (is_unit(inside, Dimension::length) && (rest[begin] == '[' || !is_digit(inside[0]))) found.push_back(inside);
        rest.remove_prefix(end + 1);
    }
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

namespace {

/// The unit of \p title that is of no length, in brackets or as its last word, where it has none of length.
std::string_view other_unit(std::string_view title) {
    if (!title_unit(title).empty()) return {};
    const std::size_t end = title.find_last_of("])}"), begin = title.substr(0, end).find_last_of("[({");
    if (end != std::string_view::npos && begin != std::string_view::npos)
        if (const auto inside = trimmed(title.substr(begin + 1, end - begin - 1)); measures_no_length(inside))
            return inside;
    for (const char* sign : {" \t_:=", "/"}) {
        const std::size_t last = title.find_last_of(sign);
        const std::string_view word = title.substr(last + 1);  // the whole title where there is no sign
        // a letter alone, or one with a number, is a name unless a stroke is before it
        const bool is_name = word.size() < 2 || std::any_of(word.begin(), word.end(), is_digit);
        if ((!is_name || (sign[0] == '/' && last < title.size())) && measures_no_length(word)) return word;
    }
    return {};
}

}  // namespace

ColumnTitle title_of(std::string_view cell) {
    cell = unquoted(cell);
    std::string name = lower_case(trimmed(cell.substr(0, (std::min)(cell.find_first_of("[({<"), cell.size()))));
    while (name.size() > 1 && (name.back() == '.' || name.back() == ':' || name.back() == ' ')) name.pop_back();
    while (name.size() > 1 && (name.front() == '#' || name.front() == ' ')) name.erase(0, 1);
    return {std::move(name), !title_unit(cell).empty(), std::string(title_unit(cell)), std::string(unread_unit(cell)),
            std::string(other_unit(cell))};
}

void split_titles(std::string_view line, char separator, std::vector<std::string_view>& cells) {
    if (separator != ' ') return split_row(line, separator, cells);
    std::vector<std::string_view> words;
    split_line(line, separator, words);
    cells.clear();
    for (const std::string_view word : words)
        if (!cells.empty() && !word.empty() && (word.front() == '[' || word.front() == '('))
            cells.back() = {cells.back().data(),
                            static_cast<std::size_t>(word.data() + word.size() - cells.back().data())};
        else
            cells.push_back(word);
}

bool may_be_titles(const NumberTable& table, std::string_view line, const std::vector<std::string_view>& cells,
                   bool above) {
    const auto may_be_title = [&](std::string_view cell) {
        return !number_in(cell, table.dialect.decimal_comma) && !(above && !cell.empty() && is_digit(cell.front()));
    };
    return cells.size() == table.columns && std::all_of(cells.begin(), cells.end(), may_be_title) &&
           !(table.columns == 1 && is_key_and_number(line));
}

std::vector<ColumnTitle> titles_above(const NumberTable& table) {
    std::vector<ColumnTitle> titles;
    std::vector<std::string_view> cells;
    const char separator = table.dialect.separator;
    int lines = 0;
    for (std::size_t i = table.first; i-- > 0 && lines < 2;) {
        const std::string_view raw = table.lines[i].text;
        for (const std::string_view line : {raw, without_comment_sign(raw, separator)}) {
            split_titles(line, separator, cells);
            if (!may_be_titles(table, line, cells, lines == 1)) continue;
            ++lines;
            titles.resize(table.columns);
            for (std::size_t c = 0; c < cells.size(); ++c) {
                ColumnTitle title = title_of(cells[c]);
                titles[c].has_unit = titles[c].has_unit || title.has_unit;
                if (titles[c].no_length.empty()) titles[c].no_length = title.no_length;
                if (titles[c].unit.empty()) titles[c].unit = title.unit;
                if (titles[c].unread.empty()) titles[c].unread = title.unread;
                titles[c].line = table.lines[i].number;
                if (lines == 1 || title_unit(titles[c].name) == titles[c].name) titles[c].name = std::move(title.name);
            }
            break;
        }
    }
    return titles;
}

std::vector<bool> spare_columns(const NumberTable& table, const std::vector<ColumnTitle>& titles) {
    std::vector<bool> spare(table.columns);
    for (std::size_t c = 0; c < table.columns; ++c) {
        bool constant = table.rows() > 1;  // or empty, as between two tabs
        for (std::size_t r = 1; constant && r < table.rows(); ++r)
            constant = table.at(r, c) == table.at(0, c) || (std::isnan(table.at(r, c)) && std::isnan(table.at(0, c)));
        const ColumnTitle* const title = c < titles.size() ? &titles[c] : nullptr;
        const bool named = title && !title->has_unit && (names_neither(title->name) || !title->no_length.empty());
        spare[c] = constant || named || (title && names_error(title->name));
    }
    return spare;
}

bool may_be_exchanged(const ColumnTitle& first, const ColumnTitle& second) {
    return !names_position(first.name) && (!names_height(second.name) || names_position(second.name));
}

void refuse_no_length(const std::vector<ColumnTitle>& titles, std::size_t column, const std::string& name) {
    if (column == 0 || column > titles.size() || titles[column - 1].no_length.empty()) return;
    refuse_file(name, {"has a column ", column, " in ", shown_cell(titles[column - 1].no_length),
                       ", which is of no length; must be a column in a unit of length"});
}

bool counts_points(const NumberTable& table, std::size_t c, bool from_start) {
    for (std::size_t r = 0; r < table.rows(); ++r) {
        const double value = table.at(r, c);
        if (!(value == std::floor(value))) return false;  // NaN too
        if (r > 0 && !(from_start ? value == table.at(r - 1, c) + 1 : value > table.at(r - 1, c))) return false;
    }
    return table.rows() > 1 && (!from_start || table.at(0, c) == 0 || table.at(0, c) == 1);
}

std::vector<bool> index_columns(const NumberTable& table) {
    if (table.columns < 2) return {};
    std::vector<bool> index = table.words;
    if (!index.empty()) index.resize(table.columns);
    const std::vector<ColumnTitle> titles = titles_above(table);
    if (titles.empty()) return index;
    index.resize(table.columns);
    bool any = false;
    for (std::size_t c = 0; c < table.columns; ++c)
        if (!index[c]) index[c] = !titles[c].has_unit && names_index(titles[c].name) && counts_points(table, c, false);
    const bool length_beside = std::any_of(titles.begin() + 1, titles.end(), [](const ColumnTitle& title) {
        return title.has_unit || names_position(title.name) || names_height(title.name);
    });
    if (!titles[0].has_unit && !names_position(titles[0].name) && !names_height(titles[0].name) && length_beside &&
        counts_points(table, 0, true))
        index[0] = true;
    for (const bool one : index) any = any || one;
    return any ? index : std::vector<bool>();
}

}  // namespace fstiff::inline v0_1::io::detail
