// SPDX-License-Identifier: BSD-3-Clause
#include "document/document.hpp"

namespace fstiff::cli {
namespace {

using Kind = Cell::Kind;

/// \p real where the cell holds a number; \p nothing where it holds none.
template <class Real>
std::string written(const Cell& cell, const char* nothing, const Real& real) {
    if (cell.kind == Kind::absent || cell.kind == Kind::null) return nothing;
    if (cell.kind == Kind::real) return real(cell.number);
    return cell.kind == Kind::count ? std::to_string(cell.whole) : cell.words;
}

std::string text_of(const Cell& cell, const Heading& heading) {
    return written(cell, "-", [&](double x) { return rounded(x * heading.factor, heading.digits); });
}

std::string csv_of(const Cell& cell) {
    return written(cell, "", [](double x) { return exact(x); });
}

Json json_of(const Cell& cell) {
    if (cell.kind == Kind::real) return cell.number;
    if (cell.kind == Kind::count) return cell.whole;
    return cell.kind == Kind::text ? Json(cell.words) : Json(nullptr);
}

}  // namespace

std::string Rows::text(const Select& select) const {
    std::vector<std::string> header;
    for (const Column& column : columns_)
        if (!column.heading.shown.empty()) header.push_back(column.heading.shown);
    TextTable table(std::move(header));
    for (std::size_t i = 0; i < size(); ++i) {
        if (select && !select(i)) continue;
        std::vector<std::string> row;
        for (const Column& column : columns_)
            if (!column.heading.shown.empty()) row.push_back(text_of(column.cells[i], column.heading));
        table.add(std::move(row));
    }
    return table.str();
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
                row[column.heading.key] = json_of(column.cells[i]);
        list.push_back(std::move(row));
    }
}

Json Rows::arrays() const {
    Json all = Json::object();
    for (const Column& column : columns_) {
        if (!column.heading.json || column.heading.key.empty()) continue;
        Json& list = all[column.heading.key] = Json::array();
        for (const Cell& cell : column.cells) list.push_back(json_of(cell));
    }
    return all;
}

std::string csv(const Numbers& numbers) {
    Rows rows;
    for (const auto& [key, value] : numbers) rows.repeat({key}, value, 1);
    return rows.csv();
}

void put(Json& document, const Numbers& numbers) {
    for (const auto& [key, value] : numbers) document[key] = value;
}

Report report(const Document& document, Format format) {
    Report made;
    made.status = document.status;
    if (format == Format::table) {
        made.document = document.table();
        for (const std::string& warning : document.warnings) made.document += "warning: " + warning + "\n";
        return made;
    }
    if (format == Format::csv) {
        made.document = document.csv();
        made.diagnostics = document.csv_notes;
    } else {
        Json json = document.json();
        if (document.json_warnings) json["warnings"] = document.warnings;
        made.document = json.str();
    }
    for (const std::string& warning : document.warnings) made.diagnostics.push_back("warning: " + warning);
    return made;
}

}  // namespace fstiff::cli
