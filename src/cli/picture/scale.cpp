// SPDX-License-Identifier: BSD-3-Clause
// The scales of the axes of a figure, and their ticks.
#include "picture/plot.hpp"

#include <fstiff/core/text.hpp>

#include <algorithm>
#include <array>
#include <limits>

namespace fstiff::cli {

namespace {

/// 10 to the power \p exponent, in superscript digits.
std::string power_of_ten(int exponent) {
    static constexpr std::array<const char*, 10> digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = exponent < 0 ? "10⁻" : "10";
    for (const char c : std::to_string(std::abs(exponent))) text += digits[static_cast<std::size_t>(c - '0')];
    return text;
}

}  // namespace

Scale::Scale(const Axis& axis, const std::vector<double>& values) : logarithmic_(axis.logarithmic) {
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (const double value : values)
        if (shows(value)) least = std::min(least, value), most = std::max(most, value);
    if (!(least <= most)) least = logarithmic_ ? 1 : 0, most = logarithmic_ ? 10 : 1;
    low_ = place(axis.low.value_or(least)), high_ = place(axis.high.value_or(most));
    // at least two numbers are on a logarithmic axis, and seven digits distinguish those of a linear one
    const double span = logarithmic_ ? 0.7 : std::max(1e-6 * std::max(std::abs(low_), std::abs(high_)), 1e-300);
    const double lack = std::max(0.0, span - (high_ - low_)) / 2, space = 0.04 * (high_ - low_ + 2 * lack);
    low_ -= lack + (axis.low ? 0 : space);
    high_ += lack + (axis.high ? 0 : space);
}

std::vector<Tick> Scale::decades() const {
    std::vector<Tick> result;
    const double span = high_ - low_;
    const int every = std::max(1, static_cast<int>(std::ceil(span / 9)));
    const int first = static_cast<int>(std::floor(low_)), last = static_cast<int>(std::ceil(high_));
    const bool plain = low_ > -3.5 && high_ < 4.5;  // else all of them are powers
    for (int k = first; k <= last; ++k)
        for (int m = 1; m < 10; ++m) {
            const double exponent = k + std::log10(m);
            if (exponent < low_ - 1e-9 || exponent > high_ + 1e-9) continue;
            const bool numbered = m == 1       ? k % every == 0
                                  : span < 0.8 ? m < 6 || m == 7
                                               : span < 2 && (m == 2 || m == 5);
            if (m > 1 && !numbered && span > 4.5) continue;
            const double value = m * std::pow(10.0, k);
            result.push_back({value, !numbered ? ""
                                     : plain   ? detail::fixed_text(value, std::max(0, -k))
                                     : m == 1  ? power_of_ten(k)
                                               : std::to_string(m) + "·" + power_of_ten(k)});
        }
    return result;
}

std::vector<Tick> Scale::steps() const {
    const double raw = (high_ - low_) / 6, decade = std::pow(10.0, std::floor(std::log10(raw))), part = raw / decade,
                 width = decade * (part <= 1   ? 1
                                   : part <= 2 ? 2
                                   : part <= 5 ? 5
                                               : 10);
    const int decimals = std::max(0, -static_cast<int>(std::floor(std::log10(width) + 1e-9)));
    std::vector<Tick> result;
    for (double k = std::ceil(low_ / width - 1e-9); k * width <= high_ + 1e-9 * width; ++k)
        result.push_back({k * width, detail::fixed_text(k == 0 ? 0.0 : k * width, decimals)});
    return result;
}

}  // namespace fstiff::cli
