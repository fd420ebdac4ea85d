// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The words of an enum, written once: reading them, writing them and the list of choices follow from one list.
///
///     enum class Divisor { pairs, paper };
///     template <>
///     inline constexpr auto enum_names<Divisor> =
///         name_list<Divisor>({{Divisor::pairs, "pairs"}, {Divisor::paper, "paper"}});
///
///     name_of(Divisor::paper)                     "paper"
///     from_name<Divisor>("paper", "divisor")          Divisor::paper
///     from_name<Divisor>("many", "divisor")           throws "divisor = "many": must be one of pairs, paper"
///
/// The list follows its enum, in namespace fstiff; --help, the refusals and the files of fstiff read it.
///
/// Valid       each value and each word once (checked where the list is written); no word is empty

#include <fstiff/core/error.hpp>

#include <array>
#include <optional>

namespace fstiff { inline namespace v0_1 {

namespace detail {

/// A value of an enum and its word.
template <class Enum>
struct Named {
    Enum value;
    std::string_view name;
};

}  // namespace detail

/// The words of \p Enum in the order in which choices are listed. Empty for an enum that has no words; every other one
/// specialises it with a name_list.
template <class Enum>
inline constexpr std::array<detail::Named<Enum>, 0> enum_names{};

namespace detail {

/// The list of a specialisation of `enum_names`. Does not compile when a value or a word is there twice, or a word is
/// empty.
template <class Enum, std::size_t count>
[[nodiscard]] consteval std::array<Named<Enum>, count> name_list(const Named<Enum> (&list)[count]) {
    for (std::size_t i = 0; i < count; ++i) {
        if (list[i].name.empty()) throw "a word is empty";
        for (std::size_t j = 0; j < i; ++j)
            if (list[i].value == list[j].value || list[i].name == list[j].name)
                throw "a value or a word is there twice";
    }
    return std::to_array(list);
}

/// An enum that has words.
template <class Enum>
concept NamedEnum = std::is_enum_v<Enum> && !enum_names<Enum>.empty();

}  // namespace detail

/// The word of \p value; empty for a value that has none.
template <detail::NamedEnum Enum>
[[nodiscard]] constexpr std::string_view name_of(Enum value) noexcept {
    for (const auto& known : enum_names<Enum>)
        if (known.value == value) return known.name;
    return {};
}

namespace detail {

/// The value whose word is \p name, case-sensitive; none when there is no such word.
template <NamedEnum Enum>
[[nodiscard]] constexpr std::optional<Enum> find_named(std::string_view name) noexcept {
    for (const auto& known : enum_names<Enum>)
        if (known.name == name) return known.value;
    return std::nullopt;
}

/// Whether \p a and \p b are the same name: case, blanks, hyphens and "_" do not matter.
[[nodiscard]] constexpr bool is_same_name(std::string_view a, std::string_view b) {
    const auto plain = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
    const auto skip = [](std::string_view& text) {
        while (!text.empty() && (text[0] == ' ' || text[0] == '-' || text[0] == '_')) text.remove_prefix(1);
    };
    for (;; a.remove_prefix(1), b.remove_prefix(1)) {
        skip(a), skip(b);
        if (a.empty() || b.empty()) return a.empty() && b.empty();
        if (plain(a[0]) != plain(b[0])) return false;
    }
}

/// The words alone.
template <NamedEnum Enum>
[[nodiscard]] constexpr auto choices() noexcept {
    std::array<std::string_view, enum_names<Enum>.size()> words;
    for (std::size_t i = 0; i < words.size(); ++i) words[i] = enum_names<Enum>[i].name;
    return words;
}

/// The words as in a sentence: pairs, paper.
template <NamedEnum Enum>
[[nodiscard]] std::string choices_text() {
    std::string text;
    for (const auto& known : enum_names<Enum>) text += (text.empty() ? "" : ", ") + std::string(known.name);
    return text;
}

}  // namespace detail

/// The value whose word is \p text. \throws domain_error with \p parameter, \p text and the words that are allowed.
template <detail::NamedEnum Enum>
[[nodiscard]] Enum from_name(std::string_view text, std::string_view parameter) {
    if (const auto match = detail::find_named<Enum>(text)) return *match;
    detail::refuse(parameter, "\"" + std::string(text) + "\"", "one of " + detail::choices_text<Enum>());
}

}}  // namespace fstiff
