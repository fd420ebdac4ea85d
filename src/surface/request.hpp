// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Common parts of the requests of commands: quantities as people or programs give them, and one list of options each. A
// request hands its options, by key and with the help of the command line, to whatever reads them (the command line,
// Python, C):
//
//     template <class Take>
//     void each_option(Take take) { take("points", points, "points of a row; the default is 256", {.low = 16, .high =
//     4096}); }

#include <fstiff/core/error.hpp>
#include <fstiff/core/text.hpp>
#include <fstiff/io/quantity.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace fstiff::scene {

/// A quantity of an option: a text with its unit, such as "7 MHz", or a number in SI. It is read where it is needed, so
/// that a refusal quotes it.
class Amount {
public:
    Amount() = default;  ///< none
    Amount(std::string text) : text_(std::move(text)) {}
    Amount(const char* text) : text_(text) {}
    Amount(double si) : si_(si) {}

    [[nodiscard]] bool empty() const { return text_.empty() && !si_; }
    /// The number that it was given as, in SI.
    [[nodiscard]] std::optional<double> number() const { return si_; }
    /// As it was written; a number by its fewest digits.
    [[nodiscard]] std::string text() const;
    /// [SI]. \throws domain_error, which names the option \p name, for a text that is not such a quantity.
    [[nodiscard]] double value(io::Dimension dimension, std::string_view name) const;
    /// The same as value(), greater than 0. \throws domain_error as above.
    [[nodiscard]] double positive(io::Dimension dimension, std::string_view name) const;

private:
    std::string text_;
    std::optional<double> si_;
};

/// Further properties of one option.
struct OptionTraits {
    double low = 0, high = 0;                                          ///< of a number, both allowed; equal: any
    bool required = false, positional = false, shows_default = false;  ///< on the command line
    std::string_view type{};                                           ///< there: how its help calls the value
    std::vector<std::string_view> words{};  ///< of a text, or two of a number: those that are allowed

    [[nodiscard]] bool has_range() const { return low < high; }
    /// \throws domain_error for a value of the option \p key that is not allowed.
    template <class Value>
    void check(std::string_view key, const Value& value) const {
        if constexpr (std::is_arithmetic_v<Value>) {
            const auto text = [](double bound) {
                return std::is_integral_v<Value> ? std::to_string(std::llround(bound)) : parts::shortest_text(bound);
            };
            if (has_range())
                require(static_cast<double>(value) >= low && static_cast<double>(value) <= high, key, value,
                        "from " + text(low) + " to " + text(high));
            if (!words.empty())
                require(std::find(words.begin(), words.end(), std::to_string(value)) != words.end(), key, value,
                        std::string(words.front()) + " or " + std::string(words.back()));
        }
    }
};

/// Name of the option of \p key in messages: "reflection_error", or after the prefix of a command line
/// "--reflection-error".
[[nodiscard]] std::string option_name(std::string_view prefix, std::string_view key);

}  // namespace fstiff::scene
