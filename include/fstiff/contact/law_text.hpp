// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// A tabulated law as text, every number in hexadecimal, so that it comes back bit for bit.
///
///     fstiff contact law 3 8                            version of the form (3 or 4), bytes of a number
///     pieces  policy  evaluations                       of the table by separation; OutsideRange
///     p_min p_max separation_min separation_max K/slope error         then eight coefficients a line: p(separation), K(p), separation(p)
///
/// A law whose K has a table of its own is of version 4: its K/slope is 0, and K(separation) comes last. Every other
/// law is written and read as version 3.
///
/// Units       SI
/// Valid       a law that is not empty, with a policy other than exact; lines may end in LF or CRLF

#include <fstiff/contact/law_tables.hpp>
#include <fstiff/core/error.hpp>

#include <charconv>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>

namespace fstiff::detail {

template <ReadableReal T>
[[nodiscard]] std::string law_text_head(int version) {
    return "fstiff contact law " + std::to_string(version) + ' ' + std::to_string(sizeof(T));
}

template <ReadableReal T>
[[nodiscard]] std::string law_text(const LawTables<T>& law) {
    std::string text = law_text_head<T>(law.has_own_stiffness() ? 4 : 3) + '\n';
    text += std::to_string(law.by_separation.rows.size()) + ' ' + std::to_string(static_cast<int>(law.outside)) + ' ' +
            std::to_string(law.evaluations) + '\n';
    const auto add = [&text](const T* numbers, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) text += hexadecimal_text(numbers[i]) + (i + 1 < count ? ' ' : '\n');
    };
    const T head[] = {law.min_pressure,      law.max_pressure,         law.by_separation.begin,
                      law.by_separation.end, law.stiffness_over_slope, law.relative_error};
    add(head, std::size(head));
    for (const auto* rows :
         {&law.by_separation.rows, &law.stiffness.rows, &law.separation.rows, &law.own_stiffness.rows})
        for (const Coefficients<T>& row : *rows) add(row.c, Row::terms);
    return text;
}

/// \throws domain_error for text that law_text did not write.
template <ReadableReal T>
[[nodiscard]] LawTables<T> read_law_text(std::string_view text) {
    const auto wrong = [](const char* what) {
        return domain_error(Refusal{.parameter = "contact law text",
                                    .reason = std::string(what) + ": must be what to_text wrote for this scalar type"});
    };
    std::string_view line = text.substr(0, text.find('\n'));
    if (line.ends_with('\r')) line.remove_suffix(1);
    const bool own_stiffness = line == law_text_head<T>(4);
    if (!own_stiffness && line != law_text_head<T>(3))
        throw wrong(line.starts_with("fstiff contact law ") ? "is of another version or another scalar type"
                                                            : "begins with something else");
    const char* at = text.data() + line.size();
    const char* const end = text.data() + text.size();
    const auto skip = [&] {
        while (at != end && (*at == ' ' || *at == '\n' || *at == '\r')) ++at;
    };
    const auto number = [&](auto value) {
        skip();
        std::from_chars_result read{};
        if constexpr (std::is_floating_point_v<decltype(value)>)
            read = read_hexadecimal(at, end, value);
        else
            read = std::from_chars(at, end, value);
        const auto [next, error] = read;
        if (error != std::errc{}) throw wrong("ends early or holds no number");
        if constexpr (std::is_floating_point_v<decltype(value)>)
            if (!std::isfinite(value)) throw wrong("holds a number that is not finite");
        at = next;
        return value;
    };
    LawTables<T> law;
    const auto separation_pieces = number(Eigen::Index{});
    law.outside = static_cast<OutsideRange>(number(int{}));
    if (law.outside != OutsideRange::refuse && law.outside != OutsideRange::clamp &&
        law.outside != OutsideRange::extrapolate)
        throw wrong("holds an unknown policy");
    law.evaluations = number(int{});
    T separation_min{}, separation_max{};
    for (T* x : {&law.min_pressure, &law.max_pressure, &separation_min, &separation_max, &law.stiffness_over_slope,
                 &law.relative_error})
        *x = number(T{});
    if (!(law.min_pressure >= (std::numeric_limits<T>::min)() && law.max_pressure > law.min_pressure &&
          separation_max > separation_min &&
          (own_stiffness ? law.stiffness_over_slope == 0 : law.stiffness_over_slope > 0)))
        throw wrong("contradicts itself");
    // each number takes two characters or more: a size that the text cannot hold is refused before it is allocated
    const auto size = static_cast<Eigen::Index>(text.size());
    const Eigen::Index pressure_pieces = BinaryPieces<T>::pieces(law.min_pressure, law.max_pressure);
    if (separation_pieces < 1 || separation_pieces > size || pressure_pieces > size)
        throw wrong("holds impossible sizes");
    law.by_separation = UniformPieces<T>(separation_min, separation_max, separation_pieces);
    if (!(law.by_separation.pieces_per_length > 0 && std::isfinite(law.by_separation.pieces_per_length)))
        throw wrong("contradicts itself");
    if (own_stiffness) law.own_stiffness = law.by_separation;
    law.stiffness = law.separation = BinaryPieces<T>(law.min_pressure, law.max_pressure);
    for (auto* rows : {&law.by_separation.rows, &law.stiffness.rows, &law.separation.rows, &law.own_stiffness.rows})
        for (Coefficients<T>& row : *rows)
            for (T& coefficient : row.c) coefficient = number(T{});
    skip();
    if (at != end) throw wrong("goes on after its end");
    law.set_scales();
    return law;
}

}  // namespace fstiff::detail
