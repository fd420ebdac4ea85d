// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The documents of a subcommand: the table for people, the CSV and the JSON.

#include "document/output.hpp"
#include "surface/request.hpp"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace fstiff::cli {

/// A document in all of its forms, of which one is made. Warnings are at the end of the table, as the last key of the
/// JSON, and on standard error for CSV and JSON.
struct Document {
    std::function<std::string()> table, csv;
    std::function<Json()> json;
    std::vector<std::string> warnings{};
    std::vector<std::string> csv_notes{};  ///< on standard error with the CSV
    Status status = success;
    bool json_warnings = true;  ///< whether the JSON has the key
};
[[nodiscard]] Report report(const Document& document, Format format);
/// The same of what a request was answered.
[[nodiscard]] Report report(const Answer& answer, const std::function<std::string()>& table,
                            const std::function<std::string()>& csv, Format format);

}  // namespace fstiff::cli
