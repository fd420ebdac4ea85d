// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// What the command prints as JSON.
#include "command.hpp"

#include <nlohmann/json.hpp>

#include <string>

namespace test {

/// JSON of a run that succeeds; exit code 4, a doubtful parameter, is accepted here.
inline nlohmann::json json_of(const std::string& arguments, const std::string& input = "") {
    const auto outcome = run_fstiff(arguments, input);
    INFO("fstiff " << arguments << "\n" << outcome.err);
    REQUIRE(outcome.status % 4 == 0);
    return nlohmann::json::parse(outcome.out);
}

}  // namespace test
