// SPDX-License-Identifier: BSD-3-Clause
#include "document/document.hpp"

namespace fstiff::cli {
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
        made.document = printable(document.table(), "\n");
        for (const std::string& warning : document.warnings) made.document += "warning: " + printable(warning) + "\n";
        return made;
    }
    if (format == Format::csv) {
        made.document = printable(document.csv(), "\n");
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
