// SPDX-License-Identifier: BSD-3-Clause
#include "document/document.hpp"

namespace fstiff::cli {
Report report(const Document& document, Format format) {
    Report made;
    made.status = document.status;
    if (format == Format::table) {
        made.document = printable(document.table(), "\n");
        for (const std::string& warning : document.warnings)
            for (const auto& line : scene::wrapped("warning: " + printable(warning), 100)) made.document += line + "\n";
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

Report report(const Answer& answer, const std::function<std::string()>& table, const std::function<std::string()>& csv,
              Format format) {
    return report({.table = table,
                   .csv = csv,
                   .json = [&] { return answer.document; },
                   .warnings = answer.warnings,
                   .status = answer.doubtful ? doubtful_result : success},
                  format);
}

}  // namespace fstiff::cli
