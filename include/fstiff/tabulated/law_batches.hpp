// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Values of a table at arrays of arguments, four at a time.

#include <fstiff/core/error.hpp>
#include <fstiff/math/piecewise.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// \throws domain_error unless \p a and \p b, the sizes of two arrays, are equal.
inline void require_same_size(Eigen::Index a, Eigen::Index b) {
    if (a != b)
        throw domain_error(Refusal{.parameter = "batch",
                                   .reason = "the arrays have " + std::to_string(a) + " and " + std::to_string(b) +
                                             " elements: must have the same number"});
}

/// Fills \p out, the results of the elements of \p x. Those within \p pieces go through \p four, and four are filled up
/// where fewer are left, so that a result does not depend on the place of its element; the others go through \p single.
template <class Pieces, Real T, std::size_t N, class FourAt, class OneAt>
void law_batch(const Pieces& pieces, const Eigen::Ref<const Eigen::ArrayX<T>>& x, const std::array<T*, N>& out,
               const FourAt& four, const OneAt& single) {
    const auto put = [&out](Eigen::Index i, const std::array<T, N>& value) {
        for (std::size_t n = 0; n < N; ++n) out[n][i] = value[n];
    };
    const Eigen::Index count = x.size();
    if constexpr (!math::four_at_once<T>) {
        for (Eigen::Index i = 0; i < count; ++i) put(i, single(x[i]));
    } else {
        T arguments[4], values[N][4];
        for (Eigen::Index i = 0; i < count; i += 4) {
            const T* from = x.data() + i;
            std::array<T*, N> to = out;
            for (T*& target : to) target += i;
            const bool full = count - i >= 4 && pieces.contains(from[0]) && pieces.contains(from[1]) &&
                              pieces.contains(from[2]) && pieces.contains(from[3]);
            if (full) [[likely]] {
                four(pieces, from, to);
                continue;
            }
            const Eigen::Index left = std::min<Eigen::Index>(count - i, 4);
            for (Eigen::Index k = 0; k < 4; ++k)
                arguments[k] = k < left && pieces.contains(from[k]) ? from[k] : pieces.lowest();
            for (std::size_t n = 0; n < N; ++n) to[n] = values[n];
            four(pieces, arguments, to);
            for (Eigen::Index k = 0; k < left; ++k) {
                if (!pieces.contains(from[k])) {
                    put(i + k, single(from[k]));
                    continue;
                }
                for (std::size_t n = 0; n < N; ++n) out[n][i + k] = values[n][k];
            }
        }
    }
}

}}}  // namespace fstiff::detail
