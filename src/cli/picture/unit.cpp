// SPDX-License-Identifier: BSD-3-Clause
#include "picture/unit.hpp"

#include <fstiff/core/text.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace fstiff::cli {
namespace {

struct Ladder {
    std::string_view si;
    std::vector<Unit> units;  ///< rising
    std::size_t usual;
    double least = 0.01;  ///< of the usual unit
};

const std::vector<Ladder>& ladders() {
    static const std::vector<Ladder> all{
        {"m", {{"nm", 1e-9}, {"µm", 1e-6}, {"mm", 1e-3}, {"m", 1}}, 1, 0.1},
        {"m along", {{"nm", 1e-9}, {"µm", 1e-6}, {"mm", 1e-3}, {"m", 1}}, 2, 0.1},
        {"m^2", {{"nm²", 1e-18}, {"µm²", 1e-12}, {"mm²", 1e-6}, {"m²", 1}}, 1},
        {"1/m^2", {{"1/m²", 1}, {"1/mm²", 1e6}, {"1/µm²", 1e12}}, 1},
        {"Pa", {{"Pa", 1}, {"kPa", 1e3}, {"MPa", 1e6}, {"GPa", 1e9}}, 2},
        {"Pa/m", {{"kPa/µm", 1e9}, {"MPa/µm", 1e12}, {"GPa/µm", 1e15}, {"TPa/µm", 1e18}}, 2},
        {"Hz", {{"Hz", 1}, {"kHz", 1e3}, {"MHz", 1e6}, {"GHz", 1e9}}, 2},
    };
    return all;
}

/// \p digits of the value, without a power of ten where people write none.
std::string plain(double value, int digits) {
    const double size = std::abs(value);
    if (!(size >= std::pow(10.0, digits)) || size >= 1e7) return rounded_text(value, digits);
    const double last = std::pow(10.0, std::floor(std::log10(size)) - digits + 1);
    return fixed_text(std::round(value / last) * last, 0);
}

}  // namespace

Unit unit_for(std::string_view si, double size) {
    for (const Ladder& ladder : ladders()) {
        if (ladder.si != si) continue;
        const Unit usual = ladder.units[ladder.usual];
        if (!(size > 0) || (size >= ladder.least * usual.size && size < 1000 * usual.size)) return usual;
        Unit best = ladder.units.front();
        for (const Unit& unit : ladder.units)
            if (size >= 0.999999 * unit.size) best = unit;
        return best;
    }
    return {si, 1};
}

Unit unit_for_all(std::string_view si, std::span<const double> values) {
    Unit best{si, 1};
    std::ptrdiff_t most = -1;
    for (const Ladder& ladder : ladders()) {
        if (ladder.si != si) continue;
        for (const Unit& unit : ladder.units) {
            const auto fits = [&](double value) { return value >= unit.size && value < 1000 * unit.size; };
            const auto count = std::count_if(values.begin(), values.end(), fits);
            if (count > most) best = unit, most = count;
        }
    }
    return best;
}

std::string with_unit(double value, std::string_view si, int digits, double error) {
    Unit unit = unit_for(si == "/m^2" ? "1/m^2" : si, std::abs(value));
    if (value != 0 && std::abs(value) < 1e-3 * unit.size) unit = {si, 1};  // no unit has a word for it
    return plain(value / unit.size, digits) + (error > 0 ? " ± " + plain(error / unit.size, 2) : "") +
           (unit.name.empty() ? "" : " " + std::string(unit.name));
}

}  // namespace fstiff::cli
