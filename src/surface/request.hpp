// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Common parts of the requests of commands.

#include "document/json.hpp"
#include "request/field.hpp"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fstiff::scene {

using request::Amount;
using request::Field;

/// Name of the option of \p key in messages: "reflection_error", or after the prefix of a command line
/// "--reflection-error".
[[nodiscard]] std::string option_name(std::string_view prefix, std::string_view key);

/// Named numbers: a line of CSV under a header, keys of a JSON document.
using NamedNumbers = std::vector<std::pair<std::string, double>>;
[[nodiscard]] std::string csv(const NamedNumbers& numbers);
void put(Json& document, const NamedNumbers& numbers);

/// Result of a command: its document without the warnings, the warnings, and whether the result is doubtful.
struct Answer {
    Json document;
    std::vector<std::string> warnings{};
    bool doubtful = false;

    /// The document with the warnings as its last key.
    [[nodiscard]] Json with_warnings() const;
};

}  // namespace fstiff::scene
