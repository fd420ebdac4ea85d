// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The answer to a request, described once and printed in three forms: text for people, CSV, and JSON for programs.
//
//     Document document("ultrasound");
//     document.facts("frequency", {{"frequency_Hz", 7e6, "", 1e-6, " MHz"}});   in all forms: "frequency  7 MHz"
//     document.table(rows, {.key = "psd"});                                     in all forms
//     document.line("by", "Persson et al. 2005");                               for people alone
//     document.json["equations"] = {"(5.1)"};                                   for programs alone
//
// Tables and parts that are functions are made when their form is printed, and not for another one.

#include "document/rows.hpp"

#include <fstiff/core/names.hpp>

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace fstiff::document {

/// The form of a document.
enum class Format { table, csv, json };

}  // namespace fstiff::document

template <>
inline constexpr auto fstiff::enum_names<fstiff::document::Format> = detail::name_list<document::Format>(
    {{document::Format::table, "table"}, {document::Format::csv, "csv"}, {document::Format::json, "json"}});

namespace fstiff::document {

/// A value by its key in JSON and CSV, and for people as a part of a sentence.
struct Fact {
    std::string key;
    Cell value;
    const char* before = nullptr;  ///< words before the number; null: not for people
    double factor = 1;             ///< from the value to the number that people read
    std::string after{};           ///< its unit, and further words
    int digits = 5;
};

/// How a document prints a table.
struct TableOptions {
    std::string key{};           ///< in JSON; empty: it is not there
    bool as_list = false;        ///< there: a list of rows; else an object of columns
    std::string_view thinned{};  ///< people read some 24 of the rows; the noun for all of them, such as "lags"
    Rows::Select shown{};        ///< the rows that people read of a long table too
    Rows::Select csv{};          ///< the rows of CSV; none: all
};

class Document {
public:
    /// \p label_width: of the labels of facts and lines.
    explicit Document(std::string_view command, std::size_t label_width = 9)
        : json(json_document(command)), label_width_(label_width) {}
    /// That of a command whose one form is a file, which is made when it is printed. It has no values.
    [[nodiscard]] static Document of_file(std::function<std::string()> file);

    Json json;  ///< values
    std::vector<std::string> warnings{};
    std::vector<std::string> notes{};     ///< printed next to the CSV
    bool doubtful = false;                ///< no result can rest on it
    bool has_warnings = true;             ///< whether JSON has the key
    std::function<std::string()> file{};  ///< in place of the CSV

    /// A line "fstiff VERSION: what".
    void title(std::string_view what);
    void line(std::string text = "");
    /// The line "  label  sentence".
    void line(std::string_view label, std::string_view sentence);
    /// One sentence of \p facts, after the label where there is one. JSON has them below \p key, or at its top. The CSV
    /// is one row of all facts at the top unless the document has tables.
    void facts(std::string_view label, const std::vector<Fact>& facts, std::string_view key = {});
    void table(Rows rows, const TableOptions& options = {});
    /// Rows of the CSV alone, under one header with those before.
    void csv(std::function<Rows()> rows);
    /// The same in place of all rows before.
    void csv_alone(std::function<Rows()> rows);
    /// A part of the text.
    void text(std::function<std::string()> part) { text_.push_back(std::move(part)); }
    /// Values that take time or memory.
    void values(std::function<void(Json&)> part) { values_.push_back(std::move(part)); }

    /// The text, with the warnings at its end.
    [[nodiscard]] std::string text() const;
    [[nodiscard]] std::string csv() const;
    /// All values; the warnings are the last key.
    [[nodiscard]] Json values() const;
    [[nodiscard]] std::string str(Format format) const;

private:
    std::size_t label_width_;
    Rows facts_{};
    std::vector<std::function<std::string()>> text_{};
    std::vector<std::function<std::string(bool with_header)>> csv_{};
    std::vector<std::function<void(Json&)>> values_{};
};

}  // namespace fstiff::document
