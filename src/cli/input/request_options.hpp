// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The options of a request on the command line.

#include "input/arguments.hpp"
#include "surface/request.hpp"
#include "surface/surface_option_table.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace fstiff::cli {

/// Adds the option \p name, whose value goes to \p to.
template <class Value>
void add_option(Arguments& command, const std::string& name, Value& to, const std::string& help,
                const scene::OptionTraits& traits) {
    if constexpr (std::is_same_v<Value, bool>) {
        command.flag(name, to, help);
    } else {
        Option option = command.option(name, to, help);
        if (traits.required) option.required();
        if (!traits.type.empty()) option.type_name(std::string(traits.type));
        if (!traits.words.empty()) option.one_of(traits.words);
        if (traits.shows_default) option.show_default();
        if constexpr (std::is_same_v<Value, std::vector<std::string>>) option.delimiter(',');
        if constexpr (std::is_arithmetic_v<Value>) {
            using Bound = std::conditional_t<std::is_unsigned_v<Value>, std::uint64_t, Value>;
            if (traits.has_range()) option.between(static_cast<Bound>(traits.low), static_cast<Bound>(traits.high));
        }
    }
}

/// Adds every option of \p request, whose fields are the targets.
template <class Request>
void add_request_options(Arguments& command, Request& request) {
    request.each_option(
        [&](std::string_view key, auto& to, const std::string& help, const scene::OptionTraits& traits = {}) {
            add_option(command, (traits.positional ? "" : "--") + scene::with_dashes(key), to, help, traits);
        });
}

}  // namespace fstiff::cli
