// SPDX-License-Identifier: BSD-3-Clause
#include "document/shown_unit.hpp"

#include "document/file.hpp"

#include <algorithm>
#include <cmath>

namespace fstiff::scene {

std::string ShownUnit::operator()(double value, int digits) const {
    return rounded(value * factor, digits) + (name.empty() ? "" : " ") + std::string(name);
}

ShownUnit unit_of_length(double metres) {
    const double size = std::abs(metres);
    if (size == 0) return {"µm", 1e6};
    if (size < 1e-11 || size >= 1) return {"m", 1};
    return size < 1e-7 ? ShownUnit{"nm", 1e9} : size < 1e-3 ? ShownUnit{"µm", 1e6} : ShownUnit{"mm", 1e3};
}

std::string shown_length(double metres, int digits) { return unit_of_length(metres)(metres, digits); }

ShownUnit unit_of_density(double per_area) {
    return per_area < 1e11 ? ShownUnit{"/mm²", 1e-6} : ShownUnit{"/µm²", 1e-12};
}

ShownUnit unit_of_pressure(double pressure) {
    const double size = std::abs(pressure);
    if (size < 100) return {"Pa", 1};
    return size < 1e5 ? ShownUnit{"kPa", 1e-3} : size < 1e9 ? ShownUnit{"MPa", 1e-6} : ShownUnit{"GPa", 1e-9};
}

ShownUnit shown_unit(double value, std::string_view si) {
    return si == "m" ? unit_of_length(value) : si == "/m^2" ? unit_of_density(value) : ShownUnit{si, 1};
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

std::string shown_count(double count, int digits) {
    const double step = std::pow(10, std::max(0.0, std::floor(std::log10(std::max(count, 1.0))) + 1 - digits));
    return rounded(std::round(count / step) * step, 15);
}

}  // namespace fstiff::scene
