// SPDX-License-Identifier: BSD-3-Clause
#include "surface/request.hpp"

#include "document/rows.hpp"
#include "surface/surface_option_table.hpp"

namespace fstiff::scene {

std::string option_name(std::string_view prefix, std::string_view key) {
    return prefix.empty() ? std::string(key) : std::string(prefix) + with_dashes(key);
}

std::string csv(const NamedNumbers& numbers) {
    Rows rows;
    for (const auto& [key, value] : numbers) rows.repeat({key}, value, 1);
    return rows.csv();
}

void put(Json& document, const NamedNumbers& numbers) {
    for (const auto& [key, value] : numbers) document[key] = value;
}

Json Answer::with_warnings() const {
    Json all = document;
    all["warnings"] = warnings;
    return all;
}

}  // namespace fstiff::scene
