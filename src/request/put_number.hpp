// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// A number or a flag of a joint by its name, for those who have a name and a value: C and sweeps.

#include <fstiff/answer/joint_fields.hpp>

#include <optional>
#include <string_view>

namespace fstiff::request {

/// Puts \p value into the number of \p owner called \p name, or by another word for it, whatever its range.
/// \return what is known of the number; none: there is no such one.
template <class Owner>
[[nodiscard]] std::optional<NumberFacts> put_number(Owner& owner, std::string_view name, double value) {
    std::optional<NumberFacts> of;
    each_field(owner, [&](std::string_view each, auto& to, const NumberFacts& facts) {
        if (each != name && !facts.has_word(name)) return;
        to = value, of = facts;
    });
    return of;
}

/// The same with what is true or false of \p face. \return whether there is such a flag.
[[nodiscard]] inline bool put_flag(JointFace& face, std::string_view name, bool value) {
    bool known = false;
    detail::each_flag(face, [&](std::string_view each, bool& to, std::string_view) {
        if (each == name) to = value, known = true;
    });
    return known;
}

}  // namespace fstiff::request
