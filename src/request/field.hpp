// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// One list of fields for every owner of options, and one way to put a value into a field. An owner hands its fields, by
// key and with what is known of each, to whatever reads them: a section of a scene, the command line, Python, C.
//
//     template <class Take>
//     void each_field(Take take) { take("points", points, {.help = "points of a row", .low = 16, .high = 4096}); }

#include <fstiff/answer/joint_fields.hpp>
#include <fstiff/core/error.hpp>
#include <fstiff/core/names.hpp>
#include <fstiff/io/units.hpp>

#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fstiff::request {

/// A quantity of a field: a text with its unit, such as "7 MHz" or "1 um,100 um", a word of the field, or numbers in
/// SI. It is read where it is needed, so that a refusal quotes it.
class Amount {
public:
    Amount() = default;  ///< none
    Amount(std::string text) : text_(std::move(text)) {}
    Amount(const char* text) : text_(text) {}
    Amount(double si) : si_{si} {}
    Amount(std::vector<double> si) : si_(std::move(si)) {}

    [[nodiscard]] bool empty() const { return text_.empty() && si_.empty(); }
    /// As it was written; numbers by their fewest digits, with \p unit.
    [[nodiscard]] std::string text(std::string_view unit = "") const;
    /// The numbers that it was given as, in SI; none of a text.
    [[nodiscard]] const std::vector<double>& numbers() const { return si_; }
    /// [SI]. \throws domain_error, which names the field \p name, for a text that is not such a quantity, and for more
    /// than one number.
    [[nodiscard]] double value(io::Dimension dimension, std::string_view name) const;
    /// The same as value(), finite and greater than 0. \throws domain_error as above.
    [[nodiscard]] double positive(io::Dimension dimension, std::string_view name) const;
    bool operator==(const Amount&) const = default;

private:
    std::string text_;
    std::vector<double> si_;
};

/// What a field takes in addition to the kind of its member.
enum class Form {
    plain,
    or_number,  ///< a text that may be a number; true or false that may be 1 or 0
    file        ///< a text that names a file
};

/// What is known of one field next to its key and its member, whose type is the kind of its value.
struct Field {
    std::string help{};                                                ///< of the command line
    double low = 0, high = 0;                                          ///< of a number, both allowed; equal: any
    bool above_low = false;                                            ///< low itself is not allowed
    std::optional<io::Dimension> dimension{};                          ///< of a number: a text with its unit gives it
    bool required = false, positional = false, shows_default = false;  ///< on the command line
    std::string_view type{};                                           ///< there: how its help calls the value
    std::vector<std::string_view> words{};                             ///< of a text: those that are allowed
    Form form = Form::plain;

    [[nodiscard]] bool has_range() const { return low < high; }
    /// Whether \p value is in the range.
    [[nodiscard]] bool holds(double value) const {
        return !has_range() || ((above_low ? value > low : value >= low) && value <= high);
    }
    /// \p bound of the range: 100000, where shortest_text() has 1e+05.
    [[nodiscard]] static std::string text_of(double bound);
    /// "a number from 3 to 1000", "greater than 0 and at most 1", "a whole number from 16 to 4096".
    [[nodiscard]] std::string allowed(bool integer = false) const;
};

/// Greater than 0, of \p dimension.
[[nodiscard]] inline Field positive(io::Dimension dimension) {
    return {.high = std::numeric_limits<double>::max(), .above_low = true, .dimension = dimension};
}

[[nodiscard]] std::string_view si_unit(io::Dimension dimension);
/// The dimension whose SI unit is \p unit; none of a plain number.
[[nodiscard]] std::optional<io::Dimension> dimension_of(std::string_view unit);
/// A number of a joint as a field: a quantity is positive where its range begins there; the library checks the rest.
[[nodiscard]] Field field_of(const NumberFacts& facts);
/// A quantity as an example of how to write one.
[[nodiscard]] std::string_view example(io::Dimension dimension);

/// A value as it was given.
struct Value {
    enum class Kind { truth, integer, real, text, list, other };
    /// What gives it: a person by a scene or a command, whose quantities have a unit; a program, whose numbers are in
    /// SI, by its types or by a line of text. Texts of a command and of a line have no kinds.
    enum class Giver { scene, command, program, line };

    Kind kind = Kind::text;
    std::string written{};  ///< for messages and for texts
    double number = 0;      ///< truth is 0 or 1
    std::vector<Value> items{};
    Giver giver = Giver::program;

    /// \p text of a line or of a command: a word of truth or a number, if it can be one.
    [[nodiscard]] static Value of_text(std::string text, Giver giver);
    /// Whether a quantity must have its unit.
    [[nodiscard]] bool is_of_person() const { return giver == Giver::scene || giver == Giver::command; }
};

/// Puts \p value into \p to. \throws domain_error "<key> = <value>: must be ..." where it is of another kind or out of
/// the range of \p field.
void put(const Value& value, bool& to, std::string_view key, const Field& field);
void put(const Value& value, double& to, std::string_view key, const Field& field);
void put(const Value& value, std::string& to, std::string_view key, const Field& field);
void put(const Value& value, std::vector<std::string>& to, std::string_view key, const Field& field);
void put(const Value& value, Amount& to, std::string_view key, const Field& field);
/// A whole number of \p field, or from \p least to \p most where that has no range.
[[nodiscard]] std::int64_t integer(const Value& value, std::string_view key, const Field& field, std::int64_t least,
                                   std::int64_t most);
/// The same without a sign: of a text up to 2^64 - 1.
[[nodiscard]] std::uint64_t count(const Value& value, std::string_view key, const Field& field);
/// The place of a word among \p words.
[[nodiscard]] std::size_t word(const Value& value, std::string_view key, const std::vector<std::string_view>& words);

template <std::integral Whole>
void put(const Value& value, Whole& to, std::string_view key, const Field& field) {
    constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();
    if constexpr (std::is_signed_v<Whole>)
        to = static_cast<Whole>(integer(value, key, field, -most, most));
    else
        to = static_cast<Whole>(count(value, key, field));
}
template <detail::NamedEnum Enum>
void put(const Value& value, Enum& to, std::string_view key, const Field&) {
    constexpr auto words = detail::choices<Enum>();
    to = enum_names<Enum>[word(value, key, {words.begin(), words.end()})].value;
}
template <class Member>
void put(const Value& value, std::optional<Member>& to, std::string_view key, const Field& field) {
    Member member{};
    put(value, member, key, field);
    to = std::move(member);
}

/// The keys of the fields that \p each hands over.
template <class Each>
[[nodiscard]] std::vector<std::string_view> keys_of(const Each& each) {
    std::vector<std::string_view> keys;
    each([&](std::string_view key, const auto&, const Field&) { keys.push_back(key); });
    return keys;
}

/// One key of a scene as its author wrote it, and what it came to in SI units.
struct Input {
    std::string key;      ///< path, such as "surface.rms_height"
    std::string written;  ///< the text of the scene
    std::optional<double> value;
    std::string unit;   ///< SI unit of value; empty when it has none
    bool given = true;  ///< in the text of the scene

    [[nodiscard]] std::string shown() const { return given ? written : written + " (default)"; }  ///< as printed
};

}  // namespace fstiff::request
