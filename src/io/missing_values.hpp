// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Numbers that mark missing points, such as -9999 or 1e20: given by an option or by the header, else noticed and
/// refused, because as heights they would be measured.
///
/// A number is suspected that is the highest or the lowest of all, and lies beyond the range of the rest by
///     10 times that range, where it is there twice or more;
///     a quarter of that range, where it is also one that instruments and programs use so (-9999, -32768, 1e20).
/// So is one of these that is there twice and is the only number without decimals; any number, where the others are a
/// hundred and more with as many decimals each.
/// A plateau, such as that of heights beyond the range of an instrument, adjoins the rest and is not suspected.
///
/// Units       those of the file
/// Valid       heights finite or NaN (missing)

#include "io/lines.hpp"
#include "io/option_names.hpp"

namespace fstiff::inline v0_1::io::detail {

/// Mark of a missing point in addition to an empty cell and the words of is_missing_word().
struct MissingValues {
    std::vector<double> numbers;
    std::vector<std::string> words;  // lower case
    std::string from;                // "options" or "line 6"; empty without a source

    bool has(double value) const {
        return std::any_of(numbers.begin(), numbers.end(), [&](double number) {
            // a number of single precision may be printed with fewer digits here than there
            return value == number || std::abs(value - number) <= 1e-7 * std::min(std::abs(number), 1e300);
        });
    }
    bool has_word(std::string_view cell) const {
        return !words.empty() && std::find(words.begin(), words.end(), lower_case(cell)) != words.end();
    }
    /// The numbers and words, for a record.
    std::string text() const {
        std::string all;
        const auto add = [&](const std::string& one) { all += (all.empty() ? "" : ", ") + one; };
        for (const double number : numbers) add(number_text(number));
        for (const std::string& word : words) add(shown_cell(word));
        return all.empty() ? "no number" : all;
    }
    /// " (-9999, from line 6)" after a count of missing points; empty without a source.
    std::string note() const { return from.empty() ? "" : " (" + text() + ", from " + from + ")"; }
};

/// "-9999", "-32768,void" or "none". \throws domain_error for an empty one.
MissingValues given_missing(std::string_view text, const std::string& name);

/// The number of a column that alone is printed without decimals.
class LoneWhole {
public:
    /// \p value is what fills \p cell.
    void add(std::string_view cell, double value) {
        const auto sign = std::find_if(cell.begin(), cell.end(), is_decimal_sign);
        if (sign != cell.end())
            add_decimals(std::find_if_not(sign + 1, cell.end(), is_digit) - sign, 1);
        else if (std::isnan(value_))
            value_ = value;
        else
            others_ = others_ || value != value_;
    }
    void add(const LoneWhole& other) {
        if (other.cells_ > 0) add_decimals(other.decimals_, other.cells_);
        vary_ = vary_ || other.vary_;
        others_ = others_ || other.others_ || (other.value_ != value_ && !std::isnan(other.value_ + value_));
        if (std::isnan(value_)) value_ = other.value_;
    }
    /// NaN where there is none, or several.
    [[nodiscard]] double value() const {
        return cells_ > 0 && !others_ ? value_ : std::numeric_limits<double>::quiet_NaN();
    }
    /// Whether all others have as many decimals, as no program prints that leaves out zeros at the end.
    [[nodiscard]] bool is_next_to_fixed() const { return !vary_ && decimals_ > 2 && cells_ >= 100; }

private:
    void add_decimals(std::ptrdiff_t decimals, std::size_t cells) {
        vary_ = vary_ || (cells_ > 0 && decimals != decimals_);
        decimals_ = decimals;
        cells_ += cells;
    }

    double value_ = std::numeric_limits<double>::quiet_NaN();
    bool others_ = false, vary_ = false;
    std::ptrdiff_t decimals_ = 0;  // with their sign
    std::size_t cells_ = 0;        // with decimals
};

/// A number that may mark missing points.
struct Suspect {
    double value{};
    std::size_t times{}, first{};  // how often, and where first
    double low{}, high{};          // the range of the rest
    bool among{};                  // it is within that range, alone without decimals
};

/// The number among the \p count heights that may mark missing points; none when all look like heights. \p whole is the
/// only one that is printed without decimals.
std::optional<Suspect> suspected_missing(const double* heights, std::size_t count, const LoneWhole& whole = {});

/// Makes NaN of the heights that \p missing names; when it names none, \throws domain_error for a suspected one.
/// \p whole as above, \p line_of(i) is the line of height i, \p unit what their numbers are in.
template <class LineOf>
void mark_missing(double* heights, std::size_t count, const MissingValues& missing, const LoneWhole& whole,
                  const std::string& name, const OptionNames& names, const std::string& unit, const LineOf& line_of) {
    if (!missing.numbers.empty())
        for (std::size_t i = 0; i < count; ++i)
            if (missing.has(heights[i])) heights[i] = std::numeric_limits<double>::quiet_NaN();
    if (missing.from == "options") return;
    const auto found = suspected_missing(heights, count, whole);
    if (!found) return;
    const std::string value = number_text(found->value);
    refuse_line(name, line_of(found->first),
                {"height ",
                 value,
                 " ",
                 unit,
                 " is here",
                 (found->times == 1 ? std::string() : " and " + std::to_string(found->times - 1) + " times more"),
                 found->among ? ", alone without decimals among " : ", far outside ",
                 "the others, which are ",
                 found->low,
                 " to ",
                 found->high,
                 " ",
                 unit,
                 "; a number that marks missing points must be ",
                 given_as(names, "missing", "\"" + value + "\""),
                 ", and true heights confirmed by ",
                 names.prefix,
                 "missing",
                 names.equals,
                 "none"});
}

}  // namespace fstiff::inline v0_1::io::detail
