// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Values between two ends, as { from, to, count, spacing } of a scene says.

#include <cmath>
#include <cstdint>

namespace fstiff::scene {

struct Range {
    double from = 0, to = 0;
    std::uint64_t count = 2;
    bool log = false;  ///< equal steps of the logarithm; else of the value

    /// The value at place \p i of count, the ends exactly as given.
    [[nodiscard]] double at(std::uint64_t i) const {
        if (i == 0) return from;
        if (i + 1 == count) return to;
        const double share = static_cast<double>(i) / static_cast<double>(count - 1);
        return log ? std::exp((1 - share) * std::log(from) + share * std::log(to)) : (1 - share) * from + share * to;
    }
};

}  // namespace fstiff::scene
