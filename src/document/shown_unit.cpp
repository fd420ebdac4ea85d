// SPDX-License-Identifier: BSD-3-Clause
#include "document/shown_unit.hpp"

#include "document/file.hpp"

#include <fstiff/core/text.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace fstiff::document {
namespace {

struct Step {
    ShownUnit unit;
    double from;  ///< the least size [SI] that is shown in it
};
struct Ladder {
    std::string_view si;
    std::vector<Step> steps;  ///< rising
    std::size_t usual;        ///< of 0
};

const Ladder* ladder_of(std::string_view si) {
    static const std::vector<Ladder> ladders{
        {"m", {{{"m"}, 0}, {{"nm", 1e-9}, 1e-11}, {{"µm", 1e-6}, 1e-7}, {{"mm", 1e-3}, 1e-3}, {{"m"}, 1}}, 2},
        {"m along", {{{"nm", 1e-9}, 0}, {{"µm", 1e-6}, 1e-6}, {{"mm", 1e-3}, 1e-4}, {{"m"}, 1}}, 2},
        {"m^2", {{{"nm²", 1e-18}, 0}, {{"µm²", 1e-12}, 1e-14}, {{"mm²", 1e-6}, 1e-6}, {{"m²"}, 1}}, 1},
        {"/m^2", {{{"/m²"}, 0}, {{"/mm²", 1e6}, 1e4}, {{"/µm²", 1e12}, 1e11}}, 1},
        {"Pa", {{{"Pa"}, 0}, {{"kPa", 1e3}, 100}, {{"MPa", 1e6}, 1e5}, {{"GPa", 1e9}, 1e9}}, 2},
        {"Pa/m",
         {{{"kPa/µm", 1e9}, 0}, {{"MPa/µm", 1e12}, 1e12}, {{"GPa/µm", 1e15}, 1e15}, {{"TPa/µm", 1e18}, 1e18}},
         2},
        {"N", {{{"N"}, 0}, {{"kN", 1e3}, 1e3}, {{"MN", 1e6}, 1e6}}, 0},
        {"N/m", {{{"N/mm", 1e3}, 0}, {{"N/µm", 1e6}, 1e5}, {{"kN/µm", 1e9}, 1e9}, {{"MN/µm", 1e12}, 1e12}}, 2},
        {"S/m^2", {{{"S/m²"}, 0}}, 0},
        {"W/(m^2 K)", {{{"W/(m² K)"}, 0}}, 0},
        {"Hz", {{{"Hz"}, 0}, {{"kHz", 1e3}, 1e3}, {{"MHz", 1e6}, 1e4}, {{"GHz", 1e9}, 1e9}}, 2}};
    if (si == "1/m^2") si = "/m^2";
    const auto entry =
        std::find_if(ladders.begin(), ladders.end(), [&](const Ladder& ladder) { return ladder.si == si; });
    return entry == ladders.end() ? nullptr : &*entry;
}

/// \p digits of the value, without a power of ten where people write none.
std::string plain(double value, int digits) {
    const double size = std::abs(value);
    if (!(size >= std::pow(10.0, digits)) || size >= 1e7) return rounded(value, digits);
    const double last = std::pow(10.0, std::floor(std::log10(size)) - digits + 1);
    return detail::fixed_text(std::round(value / last) * last, 0);
}

}  // namespace

std::string ShownUnit::operator()(double value, int digits, double error) const {
    return plain(value * factor, digits) + (error > 0 ? " ± " + plain(error * factor, 2) : "") +
           (name.empty() ? "" : " ") + std::string(name);
}

std::string ShownUnit::heading(std::string_view quantity) const {
    if (name.empty()) return std::string(quantity);
    return std::string(quantity) + (name.front() == '/' ? " [1" : " [") + std::string(name) + "]";
}

ShownUnit shown_unit(double size, std::string_view si) {
    const Ladder* const ladder = ladder_of(si);
    if (!ladder) return {si};
    if (size == 0) return ladder->steps[ladder->usual].unit;
    ShownUnit best = ladder->steps.front().unit;
    for (const auto& [unit, from] : ladder->steps)
        if (std::abs(size) >= 0.999999 * from) best = unit;
    return best;
}

ShownUnit shown_unit(std::span<const double> values, std::string_view si) {
    ShownUnit best{si};
    const Ladder* const ladder = ladder_of(si);
    if (!ladder) return best;
    std::ptrdiff_t most = -1;
    for (const auto& step : ladder->steps) {
        const double size = step.unit.size;
        const auto count = std::count_if(values.begin(), values.end(),
                                         [size](double value) { return value >= size && value < 1000 * size; });
        if (count > most) best = step.unit, most = count;
    }
    return best;
}

std::string with_unit(double value, std::string_view si, int digits, double error) {
    return shown_unit(value, si)(value, digits, error);
}

std::string shown_change(double factor) {
    const double change = 100 * (factor - 1);
    if (change >= 100) return rounded(factor, 2) + " times";
    return (change < 0 ? "" : "+") + rounded(change, 2) + " %";
}

std::string shown_percent(double share) {
    const double percent = 100 * share;
    return (std::abs(percent) < 10 ? rounded(percent, 2) : rounded(std::round(percent), 15)) + " %";
}

}  // namespace fstiff::document
