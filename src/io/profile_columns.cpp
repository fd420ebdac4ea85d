// SPDX-License-Identifier: BSD-3-Clause
#include "io/profile_columns.hpp"

namespace fstiff::inline v0_1::io::detail {

namespace {

/// Whether column \p c of \p table, counted from 0, rises or falls in equal steps, as positions do.
bool rises_evenly(const NumberTable& table, std::size_t c) {
    const std::size_t last = table.rows() - 1;
    const double first = table.at(0, c), step = (table.at(last, c) - first) / static_cast<double>(last);
    for (std::size_t r = 0; r < table.rows(); ++r)
        if (!(std::abs(table.at(r, c) - first - static_cast<double>(r) * step) <= 0.6 * std::abs(step))) return false;
    return step != 0;
}

/// Whether column \p c of \p table, counted from 0, goes one way throughout.
bool rises_or_falls(const NumberTable& table, std::size_t c) {
    bool rises = false, falls = false;
    for (std::size_t r = 1; r < table.rows(); ++r) {
        rises = rises || table.at(r, c) > table.at(r - 1, c);
        falls = falls || table.at(r, c) < table.at(r - 1, c);
    }
    return !(rises && falls);
}

/// Without titles, a first column that counts next to one of equal steps may be either. \throws domain_error then.
void require_no_count(const NumberTable& table, const std::string& name, std::size_t heights,
                      const std::string& x_option) {
    if (table.columns < 3 || !titles_above(table).empty() || !counts_points(table, 0, true)) return;
    for (std::size_t c = 1; c < table.columns; ++c)
        if (c + 1 != heights && rises_evenly(table, c))
            refuse_file(name, {"counts the points in column 1, and column ", c + 1,
                               " rises in equal steps: either may hold the positions; give ", x_option});
}

}  // namespace

std::string ProfileColumns::left_out(const NumberTable& table) const {
    std::string text;
    if (const std::size_t column = first_index(); column != 0)
        text += "; column " + std::to_string(column) + " numbers the points";
    for (std::size_t c = 0; c < unused.size(); ++c)
        if (unused[c] && (c >= table.words.size() || !table.words[c]))
            text += "; column " + std::to_string(c + 1) + " not used";
    return text;
}

std::string must_rise(const NumberTable& table, std::size_t heights, std::size_t positions, const OptionNames& names) {
    const std::string rule = "; positions must rise, or fall, throughout", column = std::to_string(heights);
    if (!rises_evenly(table, heights - 1)) return rule;
    return rule + "; column " + column + " does in equal steps: if it holds them, give " + of_words(names, "x_column") +
           names.equals + column + " and " + of_words(names, "column") + names.equals + std::to_string(positions);
}

ProfileColumns profile_columns(const NumberTable& table, const std::string& name, const ColumnChoice& choice) {
    const std::size_t columns = table.columns;
    const std::string x_option = of_words(choice.names, "x_column");
    for (const auto& [option, column] : {std::pair<std::string, std::size_t>{"column", choice.column},
                                         std::pair<std::string, std::size_t>{x_option, choice.x_column}})
        if (column > columns)
            refuse_field(name, option, std::to_string(column), "between 1 and " + std::to_string(columns));
    if (choice.x_column != 0 && choice.x_column == choice.column)
        refuse_field(name, x_option, std::to_string(choice.x_column), "another column than that of the heights");
    if (choice.x_column != 0 && choice.spacing)
        refuse_file(name, {"spacing and ", x_option, " are both given; must be one of them"});
    ProfileColumns found{.index = index_columns(table), .unused = table.words};
    found.index.resize(columns);
    found.unused.resize(columns);
    for (std::size_t c = 0; c < columns; ++c) found.index[c] = found.index[c] && !found.unused[c];
    if (choice.x_column != 0) found.index[choice.x_column - 1] = false;
    if (choice.column != 0) found.index[choice.column - 1] = false;
    std::vector<std::size_t> rest;  // may be positions and heights
    for (std::size_t c = 1; c <= columns; ++c)
        if (c != choice.x_column && !found.index[c - 1] && !found.unused[c - 1]) rest.push_back(c);
    const std::size_t most = choice.x_column != 0 ? 1 : 2;
    const std::vector<ColumnTitle> titles = titles_above(table);
    if (choice.column == 0 && rest.size() > most) {
        const std::vector<bool> spare = spare_columns(table, titles);
        std::erase_if(rest, [&](std::size_t column) { return spare[column - 1]; });
        for (std::size_t c = 1; c <= columns; ++c)
            if (spare[c - 1] && c != choice.x_column) found.unused[c - 1] = true;
    }
    if (choice.column == 0 && (rest.empty() || rest.size() > most))
        refuse_file(
            name, {"has ", columns,
                   " columns; must be one (heights) or two (positions and heights), or give the column of the heights",
                   choice.spacing ? ", or of a map dx and dy in place of spacing" : ""});
    const bool exchanged = choice.column == 0 && choice.x_column == 0 && rest.size() == 2 &&
                           (titles.empty() || may_be_exchanged(titles[rest.front() - 1], titles[rest.back() - 1])) &&
                           !rises_or_falls(table, rest.front() - 1) && rises_evenly(table, rest.back() - 1);
    if (exchanged) std::swap(rest.front(), rest.back());
    found.heights = choice.column != 0 ? choice.column : rest.back();
    if (choice.x_column != 0)
        found.positions = choice.x_column;
    else if (rest.front() != found.heights)
        found.positions = rest.front();
    if (choice.x_column == 0 && found.positions == 1 && !choice.spacing)
        require_no_count(table, name, found.heights, x_option);
    return found;
}

}  // namespace fstiff::inline v0_1::io::detail
