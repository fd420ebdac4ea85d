// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Random numbers from a seed: the bits are the same on every platform.
///
/// Reference   Steele, Lea, Flood, OOPSLA 2014 (splitmix64, public domain); Box, Muller, Ann. Math. Stat. 29 (1958)
/// Accuracy    normal numbers to the rounding of the local log, cos and sin (tests/math/random_test.cpp)

#include <fstiff/math/statistics.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <numbers>
#include <span>
#include <vector>

namespace fstiff { inline namespace v0_1 { namespace math {

/// 64 well-mixed bits a call; \p state is any number at first.
constexpr std::uint64_t splitmix64(std::uint64_t& state) {
    state += 0x9E3779B97F4A7C15ULL;
    std::uint64_t bits = state;
    bits = (bits ^ (bits >> 30)) * 0xBF58476D1CE4E5B9ULL;
    bits = (bits ^ (bits >> 27)) * 0x94D049BB133111EBULL;
    return bits ^ (bits >> 31);
}

/// Two independent standard normal numbers.
template <Real T>
[[nodiscard]] std::complex<T> normal_pair(std::uint64_t& state) {
    const T uniform = static_cast<T>((splitmix64(state) >> 11) + 1) * T(0x1p-53L);  // in (0, 1]: its log exists
    const T turn = static_cast<T>(splitmix64(state) >> 11) * T(0x1p-53L);
    return std::polar(std::sqrt(-2 * std::log(uniform)), 2 * std::numbers::pi_v<T> * turn);
}

/// The value below which the share \p probability of the sorted \p values lies, linear between neighbours.
/// \throws domain_error without values, or for a probability that is not between 0 and 1.
template <Real T>
[[nodiscard]] T sorted_quantile(std::span<const T> values, T probability) {
    detail::require(!values.empty(), "values of a quantile", values.size(), "at least 1");
    detail::require(probability >= T(0) && probability <= T(1), "probability", probability, "between 0 and 1");
    const T place = probability * static_cast<T>(values.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = (std::min)(below + 1, values.size() - 1);
    const T share = place - static_cast<T>(below);
    return values[below] + share * (values[above] - values[below]);
}

/// The value below which a standard normal number lies with a probability.
template <Real T = double>
struct NormalQuantile {
    T probability{}, value{};
};
template <Real T = double>
inline constexpr NormalQuantile<T> normal_95{T(0.95), T(1.644853626951472714863848907991632136L)};
template <Real T = double>
inline constexpr NormalQuantile<T> normal_975{T(0.975), T(1.959963984540054235524594430520551527L)};

/// The same for Student's t at \p degrees_of_freedom (0 or less: the normal value). Closed for 1 and 2; else an
/// expansion, right to 1e-3 from 5 on and to 1 % at 3.
template <Real T>
[[nodiscard]] T student_quantile(const NormalQuantile<T>& normal, int degrees_of_freedom) {
    const T z = normal.value, middle = 2 * normal.probability - 1;
    if (degrees_of_freedom <= 0) return z;
    const auto n = static_cast<T>(degrees_of_freedom);
    if (degrees_of_freedom == 1) return std::tan(middle / 2 * std::numbers::pi_v<T>);
    if (degrees_of_freedom == 2) return middle * std::sqrt(2 / (1 - middle * middle));
    const T s = z * z;
    return z * (1 + (s + 1) / (4 * n) + ((5 * s + 16) * s + 3) / (96 * n * n) +
                (((3 * s + 19) * s + 17) * s - 15) / (384 * n * n * n) +
                ((((79 * s + 776) * s + 1482) * s - 1920) * s - 945) / (92160 * n * n * n * n));
}

/// Draws blocks of neighbouring parts with replacement, as many as make the whole. Correlation within a block is kept.
class BlockDraw {
public:
    /// \p parts in blocks of \p block, between 1 and \p parts.
    BlockDraw(std::size_t parts, std::size_t block, std::uint64_t seed) : parts_(parts), block_(block), state_(seed) {}

    /// Blocks of one resample.
    [[nodiscard]] std::size_t blocks() const { return (parts_ + block_ - 1) / block_; }
    /// First part of the next block.
    [[nodiscard]] std::size_t operator()() {
        return static_cast<std::size_t>(splitmix64(state_) % (parts_ - block_ + 1));
    }

private:
    std::size_t parts_, block_;
    std::uint64_t state_;
};

/// Resamples of a mean that is a sum over parts divided by a count over them. The same draws for whatever is averaged.
template <Real T = double>
class BlockBootstrap {
public:
    BlockBootstrap(std::size_t parts, std::size_t block, std::size_t resamples, std::uint64_t seed)
        : block_(block), sum_to_(parts + 1), count_to_(parts + 1), mean_(resamples) {
        BlockDraw draw(parts, block, seed);
        blocks_ = draw.blocks();
        starts_.resize(resamples * blocks_);
        for (std::size_t& start : starts_) start = draw();
    }

    /// The mean of every resample; \p part gives sum and count of a part. An empty resample has the mean of
    /// the whole. Valid until the next call.
    template <class Part>
    const std::vector<T>& means(const Part& part) {
        for (std::size_t i = 0; i + 1 < sum_to_.size(); ++i) {
            const auto [sum, count] = part(i);
            sum_to_[i + 1] = sum_to_[i] + sum;
            count_to_[i + 1] = count_to_[i] + count;
        }
        for (std::size_t r = 0; r < mean_.size(); ++r) {
            T sum = 0, count = 0;
            for (std::size_t b = r * blocks_; b < (r + 1) * blocks_; ++b) {
                sum += sum_to_[starts_[b] + block_] - sum_to_[starts_[b]];
                count += count_to_[starts_[b] + block_] - count_to_[starts_[b]];
            }
            mean_[r] = count > T(0) && sum > T(0) ? sum / count : sum_to_.back() / count_to_.back();
        }
        return mean_;
    }

private:
    std::size_t block_, blocks_{};
    std::vector<std::size_t> starts_;   // of the blocks of the first resample, then of the next
    std::vector<T> sum_to_, count_to_;  // over all parts before this one
    std::vector<T> mean_;
};

}}}  // namespace fstiff::math
