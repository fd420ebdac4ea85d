// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Numbers that stand for missing points, such as -9999 or 1e20: told by an option or by the header, else noticed and
/// refused, for as heights they would be measured. But for OptionNames all of it is internal.
///
/// A number is suspected that is the highest or the lowest of all, and lies beyond the range of the rest by
///     10 times that range, where it stands there twice or more;
///     a quarter of that range, where it is besides one that instruments and programs use so (-9999, -32768, 1e20).
/// A plateau, such as that of heights beyond the range of an instrument, adjoins the rest and is not suspected.
///
/// Units       those of the file
/// Valid       heights finite or NaN (missing)

#include <fstiff/io/lines.hpp>

namespace fstiff::io {

/// What messages call the options of a reader: units = "um" in a program, --units "um" on a command line.
struct OptionNames {
    std::string prefix{};           ///< before the name of an option
    std::string format = "format";  ///< the whole name of the option that tells the form
    std::string equals = " = ";     ///< between an option and its value

    [[nodiscard]] std::string format_as(const std::string& form) const { return format + equals + form; }
    [[nodiscard]] std::string given_as(const std::string& option, const std::string& value) const {
        return "given as " + prefix + option + equals + value;
    }
    /// An option that is given or not.
    [[nodiscard]] std::string switched_on(const std::string& option) const {
        return prefix + option + (prefix.empty() ? equals + "true" : "");
    }
    /// An option of two words, told by \p option with "_" between them.
    [[nodiscard]] std::string of_words(std::string option) const {
        if (!prefix.empty()) std::replace(option.begin(), option.end(), '_', '-');
        return prefix + option;
    }
    /// A warning: the option was given as \p value where the file states another one. \p stated begins with its place.
    [[nodiscard]] std::string contradiction(const std::string& option, const std::string& value,
                                            const std::string& stated) const {
        return prefix + option + equals + value + " contradicts " + stated + "; the option is used";
    }
    [[nodiscard]] std::string given_steps() const { return "given as " + prefix + "dx and " + prefix + "dy"; }
};

namespace detail {

/// What stands for a missing point beside an empty cell and the words of is_missing_word().
struct MissingValues {
    std::vector<double> numbers;
    std::vector<std::string> words;  // lower case
    std::string from;                // "options" or "line 6"; empty when nothing is said

    bool has(double value) const {
        return std::any_of(numbers.begin(), numbers.end(), [&](double number) {
            // a number of single precision may be printed with fewer digits here than there
            return std::abs(value - number) <= 1e-7 * std::abs(number);
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
};

/// "-9999", "-32768,void" or "none". \throws domain_error for an empty one.
inline MissingValues given_missing(std::string_view text, const std::string& name) {
    MissingValues missing;
    if (text.empty()) return missing;
    missing.from = "options";
    if (trimmed(text) == "none") return missing;
    for (std::string_view rest = text;;) {
        const std::size_t end = (std::min)(rest.find(','), rest.size());
        const std::string_view one = trimmed(rest.substr(0, end));
        if (one.empty())
            refuse_field(name, "missing", shown_cell(text), "numbers or words with commas between them, or none");
        if (const auto number = number_in(one, false); number && std::isfinite(*number))
            missing.numbers.push_back(*number);
        else
            missing.words.push_back(lower_case(one));
        if (end == rest.size()) return missing;
        rest.remove_prefix(end + 1);
    }
}

/// Whether instruments and programs use \p value for a missing point.
inline bool is_customary_missing(double value) {
    static constexpr double customary[] = {
        999,  9999, 99999, 999999, 32767, 32768, 65535,         2147483647, 2147483648,     8388607,        8388608,
        1e10, 1e20, 1e30,  1e31,   1e37,  1e38,  9.96920997e36, 1.70141e38, 3.402823466e38, 1.797693134e308};
    return std::any_of(std::begin(customary), std::end(customary), [&](double number) {
        return std::abs(std::abs(value) - number) <= (number > 1e10 ? 1e-5 * number : 0);
    });
}

/// A number that may stand for missing points.
struct Suspect {
    double value{};
    std::size_t times{}, first{};  // how often, and where first
    double low{}, high{};          // the range of the rest
};

/// The number among the \p count heights that may stand for missing points; none when all look like heights.
inline std::optional<Suspect> suspected_missing(const double* heights, std::size_t count) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    double low = infinite, high = -infinite;
    for (std::size_t i = 0; i < count; ++i) {  // NaN fails every comparison
        if (heights[i] < low) low = heights[i];
        if (heights[i] > high) high = heights[i];
    }
    if (!(low < high)) return std::nullopt;
    double next = high, last = low;  // the lowest and the highest of the rest
    Suspect lowest{.value = low}, highest{.value = high};
    for (std::size_t i = 0; i < count; ++i) {
        const double z = heights[i];
        if (z > low && z < next) next = z;
        if (z < high && z > last) last = z;
        for (Suspect* one : {&lowest, &highest})
            if (z == one->value && one->times++ == 0) one->first = i;
    }
    const auto suspicious = [](const Suspect& one) {
        const double gap = (std::max)(one.low - one.value, one.value - one.high), range = one.high - one.low;
        const bool customary = is_customary_missing(one.value);
        if (one.times > 1 && customary) return gap > 0.25 * range;
        return (one.times > 1 || customary) && range > 0 && gap > 10 * range;
    };
    lowest.low = next, lowest.high = high;
    highest.low = low, highest.high = last;
    if (suspicious(lowest)) return lowest;
    if (suspicious(highest)) return highest;
    lowest.high = last, highest.low = next;  // both of them
    if (next < last && suspicious(lowest) && suspicious(highest)) return lowest;
    return std::nullopt;
}

/// Makes NaN of the heights that \p missing names; when it says nothing, \throws domain_error for a suspected one.
/// \p line_of(i) is the line of height i, \p unit what their numbers are in.
template <class LineOf>
void mark_missing(double* heights, std::size_t count, const MissingValues& missing, const std::string& name,
                  const OptionNames& names, const std::string& unit, const LineOf& line_of) {
    if (!missing.numbers.empty())
        for (std::size_t i = 0; i < count; ++i)
            if (missing.has(heights[i])) heights[i] = std::numeric_limits<double>::quiet_NaN();
    if (missing.from == "options") return;
    const auto found = suspected_missing(heights, count);
    if (!found) return;
    const std::string value = number_text(found->value);
    refuse_line(name, line_of(found->first),
                {"height ", value, " ", unit, " stands here",
                 (found->times == 1 ? std::string() : " and " + std::to_string(found->times - 1) + " times more"),
                 ", far outside the others, which are ", found->low, " to ", found->high, " ", unit,
                 "; a number that stands for missing points must be ", names.given_as("missing", "\"" + value + "\""),
                 ", and true heights confirmed by ", names.prefix, "missing", names.equals, "none"});
}

}  // namespace detail

}  // namespace fstiff::io
