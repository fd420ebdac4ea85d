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
void add_option(Arguments& command, const std::string& name, Value& to, const request::Field& field) {
    if constexpr (std::is_same_v<Value, bool>) {
        command.flag(name, to, field.help);
    } else {
        Option option = command.option(name, to, field.help);
        if (field.required) option.required();
        if (!field.type.empty()) option.type_name(std::string(field.type));
        if (!field.words.empty()) option.one_of(field.words);
        if (field.shows_default) option.show_default();
        if constexpr (std::is_same_v<Value, std::vector<std::string>>) option.delimiter(',');
        if constexpr (std::is_arithmetic_v<Value>) {
            using Bound = std::conditional_t<std::is_unsigned_v<Value>, std::uint64_t, Value>;
            if (field.has_range()) option.between(static_cast<Bound>(field.low), static_cast<Bound>(field.high));
        }
    }
}

/// Adds every option of \p request, whose fields are the targets.
template <class Owner>
void add_request_options(Arguments& command, Owner& owner) {
    owner.each_field([&](std::string_view key, auto& to, const request::Field& field) {
        add_option(command, (field.positional ? "" : "--") + scene::with_dashes(key), to, field);
    });
}

}  // namespace fstiff::cli
