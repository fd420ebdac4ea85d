// SPDX-License-Identifier: BSD-3-Clause
#include "io/missing_values.hpp"

namespace fstiff::inline v0_1::io {

namespace detail {

MissingValues given_missing(std::string_view text, const std::string& name) {
    MissingValues missing;
    if (text.empty()) return missing;
    missing.from = "options";
    if (trimmed(text) == "none") return missing;
    for (std::string_view rest = text;;) {
        const std::size_t end = (std::min)(rest.find(','), rest.size());
        const std::string_view one = trimmed(rest.substr(0, end));
        if (one.empty())
            refuse_field(name, "missing", shown_cell(text), "numbers or words with commas between them, or none");
        const std::string word = lower_case(one.substr(one.starts_with('-') || one.starts_with('+') ? 1 : 0));
        if (const auto number = number_in(one, false); number && std::isfinite(*number))
            missing.numbers.push_back(*number);
        else if (word == "inf" || word == "infinity")
            for (const double sign : {1.0, -1.0}) missing.numbers.push_back(sign * HUGE_VAL);
        else
            missing.words.push_back(lower_case(one));
        if (end == rest.size()) return missing;
        rest.remove_prefix(end + 1);
    }
}

namespace {

/// Whether instruments and programs use \p value for a missing point.
bool is_customary_missing(double value) {
    static constexpr double customary[] = {
        999,  9999, 99999, 999999, 32767, 32768, 65535,         2147483647, 2147483648,     8388607,        8388608,
        1e10, 1e20, 1e30,  1e31,   1e37,  1e38,  9.96920997e36, 1.70141e38, 3.402823466e38, 1.797693134e308};
    return std::any_of(std::begin(customary), std::end(customary), [&](double number) {
        return std::abs(std::abs(value) - number) <= (number > 1e10 ? 1e-5 * number : 0);
    });
}

}  // namespace

std::optional<Suspect> suspected_missing(const double* heights, std::size_t count, const LoneWhole& whole) {
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
    Suspect lone{.value = whole.value(), .low = low, .high = high, .among = true};
    for (std::size_t i = 0; i < count; ++i)
        if (heights[i] == lone.value && lone.times++ == 0) lone.first = i;
    if (lone.times > 1 && (is_customary_missing(lone.value) || whole.is_next_to_fixed())) return lone;
    return std::nullopt;
}

}  // namespace detail

}  // namespace fstiff::inline v0_1::io
