// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Quantiles, of values and of Student's t, and resampling of neighbouring parts together.
///
/// Reference   Hyndman, Fan, Am. Stat. 50 (1996) 361, definition 7 (quantile); Kunsch, Ann. Stat. 17 (1989) 1217
///             (blocks); Abramowitz, Stegun (1964) 26.7.5 (Student's t)
/// Accuracy    rounding of the sums (tests/math/statistics_test.cpp)

#include <fstiff/core/error.hpp>
#include <fstiff/core/numbers.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

// Order of heights by a radix sort of 11 bits a pass, in half the time of std::sort for a million of them, and sums.
//
// Reference   Knuth, The Art of Computer Programming 3, section 5.2.5
// Valid       no NaN; -0 equals 0

namespace fstiff { inline namespace v0_1 { namespace math {

/// Sorts \p items so that \p height(item) falls, with equal ones in their order.
template <Real T, class Item, class Height>
void sort_falling(std::vector<Item>& items, const Height& height) {
    using Bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
    constexpr int width = 8 * static_cast<int>(sizeof(T)), digit = 11, passes = (width + digit - 1) / digit;
    constexpr Bits sign = Bits(1) << (width - 1), mask = (Bits(1) << digit) - 1;
    const auto key = [&](const Item& item) -> Bits {                 // falls as the height rises
        const Bits bits = std::bit_cast<Bits>(height(item) + T(0));  // -0 becomes +0
        return (bits & sign) != 0 ? bits : ~(bits | sign);
    };
    std::vector<std::array<std::size_t, std::size_t(mask) + 1>> start(passes);
    for (const Item& item : items)
        for (int pass = 0; pass < passes; ++pass) ++start[std::size_t(pass)][key(item) >> (pass * digit) & mask];
    std::vector<Item> other(items.size());
    for (int pass = 0; pass < passes; ++pass) {
        auto& place = start[std::size_t(pass)];
        std::size_t sum = 0;
        for (std::size_t& count : place) sum += std::exchange(count, sum);
        for (const Item& item : items) other[place[key(item) >> (pass * digit) & mask]++] = item;
        items.swap(other);
    }
}

/// Sums of \p term(i), i from \p from to below \p to, over runs that end at multiples of \p run, passed to \p take in
/// their order. Each sum waits for its last addition, so that four runs are summed at once.
template <class S, class Term, class Take>
void sum_runs(std::size_t from, std::size_t to, std::size_t run, const Term& term, const Take& take) {
    const auto one = [&](std::size_t end) {
        S sum = 0;
        for (; from < end; ++from) sum += term(from);
        take(sum);
    };
    if (from < to && from % run != 0) one((std::min)(to, from + run - from % run));
    for (; from + 4 * run <= to; from += 4 * run) {
        S a = 0, b = 0, c = 0, d = 0;
        for (std::size_t i = from; i < from + run; ++i)
            a += term(i), b += term(i + run), c += term(i + 2 * run), d += term(i + 3 * run);
        take(a), take(b), take(c), take(d);
    }
    while (from < to) one((std::min)(to, from + run));
}

}}}  // namespace fstiff::math
