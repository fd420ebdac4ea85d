// SPDX-License-Identifier: BSD-3-Clause
#include "io/turned_rows.hpp"

namespace fstiff::inline v0_1::io::detail {

std::optional<TurnedRows> turned_rows(const NumberTable& table) {
    constexpr std::size_t least = 16;
    std::vector<std::vector<std::string_view>> rows;
    for (std::size_t i = table.first; i < table.lines.size(); ++i) {
        if (is_comment(table.lines[i].text)) continue;
        if (rows.size() == 2) return std::nullopt;
        split_line(without_comment(table.lines[i].text), table.dialect.separator, rows.emplace_back());
    }
    if (rows.empty() || rows[0].size() < least || rows.back().size() != rows[0].size()) return std::nullopt;
    const std::size_t begin = !table.words.empty() && table.words[0] ? 1 : 0, count = rows[0].size();
    if (std::count(table.words.begin(), table.words.end(), true) != static_cast<std::ptrdiff_t>(begin)) return {};
    if (rows.size() == 2) {
        std::vector<double> x;
        for (std::size_t c = begin; c < count; ++c)
            x.push_back(number_in(rows[0][c], table.dialect.decimal_comma).value_or(HUGE_VAL));
        const double step = (x.back() - x.front()) / static_cast<double>(x.size() - 1);
        for (std::size_t k = 0; k < x.size(); ++k)
            if (!(std::abs(x[k] - x[0] - static_cast<double>(k) * step) <= 0.6 * std::abs(step))) return std::nullopt;
    }
    std::string text;
    std::size_t line = 1;
    for (std::size_t i = 0; i < table.first; ++i) {
        for (; line < table.lines[i].number; ++line) text += '\n';
        text += table.lines[i].text;
    }
    for (std::size_t c = 0; c < count; ++c) {
        text += '\n';
        for (std::size_t r = 0; r < rows.size(); ++r) {
            const std::string quote = rows[r][c].find(table.dialect.separator) < rows[r][c].size() ? "\"" : "";
            text += (r == 0 ? "" : std::string(1, table.dialect.separator)) + quote + std::string(rows[r][c]) + quote;
        }
    }
    return TurnedRows{text + '\n', rows.size()};
}

}  // namespace fstiff::inline v0_1::io::detail
