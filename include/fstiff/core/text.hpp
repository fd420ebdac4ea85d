// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Floating-point numbers to and from text: the one place with replacements for the standard library (core/config.hpp).
///
///     shortest_text(0.1)              "0.1"            reads back as the same number
///     rounded_text(2.0 / 3, 4)        "0.6667"         as printf %.4g; 17 digits read back as the same double
///     fixed_text(2.0 / 3, 1)          "0.7"            as printf %.1f
///     hexadecimal_text(0.375)         "1.8p-2"         exact, as printf %a without 0x
///
/// The decimal sign is the point in every locale.
///
/// Valid       numbers that are not finite are written as inf, nan, and never read
/// Accuracy    reading is correctly rounded, shortest_text and hexadecimal_text read back bit for bit, rounded_text and
///             fixed_text are correctly rounded (tests/core/text_test.cpp). Without std::to_chars of the scalar
///             shortest_text has the same digits, but may write 1e+05 for 100000.

#include <fstiff/core/numbers.hpp>

#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>
#include <system_error>

namespace fstiff { inline namespace v0_1 { namespace detail {

inline bool is_decimal_digit(char c) { return c >= '0' && c <= '9'; }
inline bool is_hexadecimal_digit(char c) {
    return is_decimal_digit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
}

/// True if a digit, or a point and a digit, follow the sign.
inline bool begins_number(const char* first, const char* last, bool hexadecimal) {
    if (first != last && *first == '-') ++first;
    if (first != last && *first == '.') ++first;
    return first != last && (hexadecimal ? is_hexadecimal_digit(*first) : is_decimal_digit(*first));
}

template <Real T, class... Format>
std::string text_by_to_chars(T value, Format... format) {
    if (std::isnan(value)) return "nan";  // whose sign is an accident of the processor
    char few[64];
    if (const auto [end, error] = std::to_chars(few, few + sizeof few, value, format...); error == std::errc())
        return {few, end};
    for (std::string text(256, '\0');; text.resize(2 * text.size()))
        if (const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value, format...);
            error == std::errc())
            return text.substr(0, static_cast<std::size_t>(end - text.data()));
}

/// Text as printf has it, with \p precision digits and \p conversion, such as g; the decimal sign of the locale is
/// replaced by a point.
template <Real T>
std::string text_by_printf(T value, char conversion, int precision) {
    if (std::isnan(value)) return "nan";
    const char format[] = {'%', '.', '*', conversion, '\0'};
    const auto print = [&](char* text, std::size_t size) {
        return std::snprintf(text, size, format, precision, static_cast<double>(value));
    };
    std::string text(static_cast<std::size_t>(print(nullptr, 0)) + 1, '\0');
    print(text.data(), text.size());
    text.pop_back();
    const auto foreign = [](char c) {
        return !(is_decimal_digit(c) || (c >= 'a' && c <= 'z') || c == '+' || c == '-' || c == '.');
    };
    for (std::size_t i = 0; i < text.size(); ++i)
        if (foreign(text[i])) {
            std::size_t end = i;
            while (end < text.size() && foreign(text[end])) ++end;
            text.replace(i, end - i, ".");
            break;
        }
    return text;
}

#if !FSTIFF_HAS_FLOAT_FROM_CHARS
/// from_chars by strtod: the characters of the number are copied, with the decimal sign of the locale.
template <Real T>
std::from_chars_result read_by_strtod(const char* first, const char* last, T& value, bool hexadecimal) {
    const auto is_digit = [&](char c) { return hexadecimal ? is_hexadecimal_digit(c) : is_decimal_digit(c); };
    std::string copy;
    const char* next = first;
    if (*next == '-') copy += *next++;
    if (hexadecimal) copy += "0x";
    bool is_zero = true;
    const auto take_digits = [&] {
        for (; next != last && is_digit(*next); ++next) {
            is_zero = is_zero && *next == '0';
            copy += *next;
        }
    };
    take_digits();
    if (next != last && *next == '.') {
        char sample[16];  // "0,5"
        const int length = std::snprintf(sample, sizeof sample, "%.1f", 0.5);
        copy.append(sample + 1, static_cast<std::size_t>(length - 2));
        ++next;
        take_digits();
    }
    if (next != last && (*next | 0x20) == (hexadecimal ? 'p' : 'e')) {
        const char* exponent = next + 1;
        if (exponent != last && (*exponent == '+' || *exponent == '-')) ++exponent;
        if (exponent != last && is_decimal_digit(*exponent)) {
            while (exponent != last && is_decimal_digit(*exponent)) ++exponent;
            copy.append(next, exponent);
            next = exponent;
        }
    }
    T read;
    if constexpr (std::is_same_v<T, float>)
        read = std::strtof(copy.c_str(), nullptr);
    else
        read = std::strtod(copy.c_str(), nullptr);
    if ((read == 0 && !is_zero) || std::abs(read) > (std::numeric_limits<T>::max)())
        return {next, std::errc::result_out_of_range};
    value = read;
    return {next, std::errc()};
}
#endif

template <Real T>
std::from_chars_result read_number(const char* first, const char* last, T& value, bool hexadecimal) {
    if (!begins_number(first, last, hexadecimal)) return {first, std::errc::invalid_argument};
#if FSTIFF_HAS_FLOAT_FROM_CHARS
    return std::from_chars(first, last, value, hexadecimal ? std::chars_format::hex : std::chars_format::general);
#else
    return read_by_strtod(first, last, value, hexadecimal);
#endif
}

/// Reads the decimal number that [\p first, \p last) begins with, as std::from_chars does: no blanks, no "+", as many
/// characters as fit. \p value is set only when the error is std::errc(); std::errc::result_out_of_range means a number
/// too large, or too small for anything but 0, std::errc::invalid_argument no number (inf and nan are none).
template <Real T>
std::from_chars_result read_decimal(const char* first, const char* last, T& value) {
    return read_number(first, last, value, false);
}

/// Reads, as read_decimal does, what hexadecimal_text writes.
template <Real T>
std::from_chars_result read_hexadecimal(const char* first, const char* last, T& value) {
    return read_number(first, last, value, true);
}

/// The fewest digits that read back as \p value.
template <Real T>
[[nodiscard]] std::string shortest_text(T value) {
    if constexpr (FSTIFF_HAS_FLOAT_TO_CHARS) {
        return text_by_to_chars(value);
    } else {
        constexpr int most = std::numeric_limits<T>::max_digits10;
        for (int digits = 1; digits < most; ++digits) {
            std::string text = text_by_printf(value, 'g', digits);
            T back{};
            const auto error = read_decimal(text.data(), text.data() + text.size(), back).ec;
            if (back == value || error == std::errc::invalid_argument) return text;  // inf and nan are not read
        }
        return text_by_printf(value, 'g', most);
    }
}

/// \p digits significant digits, trailing zeros dropped.
template <Real T>
[[nodiscard]] std::string rounded_text(T value, int digits) {
    if constexpr (FSTIFF_HAS_FLOAT_TO_CHARS)
        return text_by_to_chars(value, std::chars_format::general, digits);
    else
        return text_by_printf(value, 'g', digits);
}

/// \p decimals digits after the point.
template <Real T>
[[nodiscard]] std::string fixed_text(T value, int decimals) {
    if constexpr (FSTIFF_HAS_FLOAT_TO_CHARS)
        return text_by_to_chars(value, std::chars_format::fixed, decimals);
    else
        return text_by_printf(value, 'f', decimals);
}

/// Hexadecimal digits and a power of two, without 0x.
template <Real T>
[[nodiscard]] std::string hexadecimal_text(T value) {
    if constexpr (FSTIFF_HAS_FLOAT_TO_CHARS) {
        return text_by_to_chars(value, std::chars_format::hex);
    } else {
        std::string text = text_by_printf(value, 'a', -1);
        if (const std::size_t prefix = text.find("0x"); prefix != std::string::npos) text.erase(prefix, 2);
        return text;
    }
}

}}}  // namespace fstiff::detail
