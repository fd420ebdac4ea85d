// SPDX-License-Identifier: BSD-3-Clause
#include "io/unequal_steps.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace fstiff::inline v0_1::io::detail {

std::vector<double> steps_of(const std::vector<double>& x) {
    std::vector<double> steps(x.size() - 1);
    for (std::size_t i = 0; i + 1 < x.size(); ++i) steps[i] = x[i + 1] - x[i];
    return steps;
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

bool has_equal_steps(const std::vector<double>& x, double tolerance) {
    if (x.size() < 2) return false;
    const double step = (x.back() - x.front()) / static_cast<double>(x.size() - 1);
    for (std::size_t i = 0; i < x.size(); ++i)
        if (!(std::abs(x[i] - x.front() - static_cast<double>(i) * step) <= tolerance * std::abs(step))) return false;
    return step != 0;
}

bool is_interrupted(const std::vector<double>& x, double printed) {
    const std::vector<double> steps = steps_of(x);
    const double usual = median(steps);
    if (printed < 0.1 * std::abs(usual) || usual == 0) return false;
    const auto odd =
        std::count_if(steps.begin(), steps.end(), [&](double step) { return std::abs(step - usual) > 0.5 * printed; });
    return odd == 1 || odd == 2;
}

std::vector<double> at_equal_steps(const std::vector<double>& heights, const std::vector<double>& x) {
    const double step = (x.back() - x.front()) / static_cast<double>(x.size() - 1);
    std::vector<double> even(heights.size());
    for (std::size_t i = 0, k = 0; i < even.size(); ++i) {
        const double at = i + 1 == even.size() ? x.back() : x.front() + static_cast<double>(i) * step;
        while (k + 2 < x.size() && (x[k + 1] - at) * step < 0) ++k;
        const double share = x[k + 1] == x[k] ? 0 : (at - x[k]) / (x[k + 1] - x[k]);
        even[i] = share <= 0   ? heights[k]
                  : share >= 1 ? heights[k + 1]
                               : heights[k] + share * (heights[k + 1] - heights[k]);
    }
    return even;
}

}  // namespace fstiff::inline v0_1::io::detail
