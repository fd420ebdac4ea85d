// SPDX-License-Identifier: BSD-3-Clause
#include "document/rows.hpp"

#include "document/file.hpp"

#include <algorithm>
#include <cmath>

namespace fstiff::document {
namespace {

using Kind = Cell::Kind;

/// Whether \p byte of UTF-8 is the first of a character.
bool begins_character(char byte) { return (static_cast<unsigned char>(byte) & 0xC0u) != 0x80u; }

/// \p real where the cell holds a number; \p nothing where it holds none.
template <class Real>
std::string cell_text(const Cell& cell, const char* nothing, const Real& real) {
    if (cell.kind == Kind::absent || cell.kind == Kind::null) return nothing;
    if (cell.kind == Kind::real) return real(cell.number);
    return cell.kind == Kind::count ? std::to_string(cell.whole) : cell.words;
}

/// A text that a spreadsheet would take for a formula, and that is no number with its sign, begins with an apostrophe.
std::string csv_of(const Cell& cell) {
    const bool sign = cell.words.starts_with('+') || cell.words.starts_with('-');
    const bool number = sign && cell.words.find_first_not_of("0123456789.eE+-") == std::string::npos;
    const bool formula =
        cell.kind == Kind::text && !number && (sign || cell.words.starts_with('=') || cell.words.starts_with('@'));
    return (formula ? "'" : "") + cell_text(cell, "", [](double x) { return exact(x); });
}

}  // namespace

Cell Cell::finite(double value, Kind otherwise) { return std::isfinite(value) ? Cell(value) : Cell(otherwise); }

std::string Cell::text(double factor, int digits) const {
    return cell_text(*this, "-", [&](double x) { return rounded(x * factor, digits); });
}

Json Cell::json() const {
    if (kind == Kind::real) return number;
    if (kind == Kind::count) return whole;
    return kind == Kind::text ? Json(words) : Json(nullptr);
}

std::size_t shown_width(std::string_view text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), begins_character));
}

std::vector<std::string> wrapped(std::string_view text, std::size_t most) {
    std::vector<std::string> lines;
    while (shown_width(text) > most) {
        std::size_t end = 0, space = 0;
        for (std::size_t count = 0; count <= most; ++end) {
            if (text[end] == ' ') space = end;
            count += begins_character(text[end]);
        }
        --end;  // the first character too many
        const std::size_t length = space > 0 ? space : end;
        lines.emplace_back(text.substr(0, length));
        text.remove_prefix(space > 0 ? length + 1 : length);
    }
    lines.emplace_back(text);
    return lines;
}

std::string table_text(const TextRows& rows) {
    std::vector<std::size_t> widths(rows.front().size());
    for (const auto& row : rows)
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], shown_width(row[i]));
    std::string text;
    for (const auto& row : rows) {
        for (std::size_t i = 0; i < row.size(); ++i)
            text += std::string(2 + widths[i] - shown_width(row[i]), ' ') + row[i];
        text.erase(text.find_last_not_of(' ') + 1);
        text += '\n';
    }
    return text;
}

std::string csv_line(const std::vector<std::string>& cells) {
    std::string text;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        text += i ? "," : "";
        const bool plain = cells[i].find_first_of(",\"\r\n") == std::string::npos;
        if (!plain) text += '"';
        for (const char c : cells[i]) text += !plain && c == '"' ? "\"\"" : std::string(1, c);
        if (!plain) text += '"';
    }
    return text + '\n';
}

TextRows Rows::table(const Select& select) const {
    TextRows rows(1);
    std::vector<const Column*> shown;
    for (const Column& column : columns_) {
        if (column.heading.shown.empty()) continue;
        shown.push_back(&column);
        rows.front().push_back(column.heading.shown);
    }
    for (std::size_t i = 0; i < size(); ++i) {
        if (select && !select(i)) continue;
        rows.emplace_back();
        for (const Column* column : shown)
            rows.back().push_back(column->cells[i].text(column->heading.factor, column->heading.digits));
    }
    return rows;
}

std::string Rows::text(const Select& select) const {
    const TextRows rows = table(select);
    return rows.front().empty() ? "" : table_text(rows);
}

std::string Rows::csv(bool with_header, const Select& select) const {
    const auto line = [&](const auto& cell_of) {
        std::vector<std::string> cells;
        for (const Column& column : columns_)
            if (column.heading.csv && !column.heading.key.empty()) cells.push_back(cell_of(column));
        return csv_line(cells);
    };
    std::string text = with_header ? line([](const Column& column) { return column.heading.key; }) : "";
    for (std::size_t i = 0; i < size(); ++i)
        if (!select || select(i)) text += line([&](const Column& column) { return csv_of(column.cells[i]); });
    return text;
}

void Rows::append_to(Json& list) const {
    for (std::size_t i = 0; i < size(); ++i) {
        Json row = Json::object();
        for (const Column& column : columns_)
            if (column.heading.json && !column.heading.key.empty() && column.cells[i].kind != Kind::absent)
                row[column.heading.key] = column.cells[i].json();
        list.push_back(std::move(row));
    }
}

Json Rows::arrays() const {
    Json table = Json::object();
    for (const Column& column : columns_) {
        if (!column.heading.json || column.heading.key.empty()) continue;
        Json& list = table[column.heading.key] = Json::array();
        for (const Cell& cell : column.cells) list.push_back(cell.json());
    }
    return table;
}

}  // namespace fstiff::document
