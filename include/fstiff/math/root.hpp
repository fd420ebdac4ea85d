// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The root of a monotone function of one variable: Newton's method kept inside a bracket.
///
///     x <- x - f(x) / f'(x)      while that stays inside the bracket and halves the step,
///     x <- middle of the bracket else
///
/// "Converged" is a proof, not a guess from a small step: f was evaluated on both sides of the root, no further apart
/// than the tolerance (or was exactly 0). Near the root one extra evaluation just beyond it closes the bracket. An end
/// of the bracket is evaluated only when the search is driven to it: a good first guess saves the far ends.
///
/// Units       those of x and f; the tolerance is absolute, in the unit of x
/// Valid       f monotone on [lower, upper]; kinks are allowed, and where f jumps across 0 the jump is found. The slope
///             may be inaccurate, 0, infinite or NaN, which only costs time, but its sign must be right
/// Accuracy    |root - true root| <= error <= max(tolerance, 4 eps |root|) when converged (tests/math/root_test.cpp)

#include <fstiff/core/numbers.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <utility>

namespace fstiff { inline namespace v0_1 { namespace math {

/// End of a search for a root.
enum class RootStatus {
    converged,
    no_bracket,    ///< f has one sign on [lower, upper], or the bounds are not finite and in order
    not_converged  ///< max_iterations spent, or f returned NaN
};

/// The outcome of the search for a root.
template <Real T = double>
struct RootResult {
    T root{};          ///< the best estimate, also when not converged
    T error{};         ///< width of the bracket around it that was reached
    int iterations{};  ///< evaluations of f
    RootStatus status = RootStatus::not_converged;

    [[nodiscard]] constexpr bool converged() const noexcept { return status == RootStatus::converged; }
};

/// Three times the evaluations of bisection, for a slope that misleads.
inline constexpr int root_iterations = 200;

/// Bracket of a root, and whether f was evaluated at the ends.
template <Real T>
struct Bracket {
    T low, high;
    bool low_seen = false, high_seen = false;

    /// Newton's root \p expected where it is within the bracket, else an end that was not evaluated, or the middle.
    [[nodiscard]] T probe(T expected, int side) const {
        if (side > 0 && expected >= high && !high_seen) return high;
        if (side < 0 && expected <= low && !low_seen) return low;
        return expected > low && expected < high ? expected : std::midpoint(low, high);
    }
};

/// A function {value, slope} of x that is called by its address: a search is compiled once for all of them.
template <Real T>
struct SlopedFunction {
    void* function;
    std::pair<T, T> (*call)(void*, T);

    std::pair<T, T> operator()(T x) const { return call(function, x); }
};

/// newton_bracketed() of \p f.
template <Real T>
RootResult<T> newton_of(const SlopedFunction<T> f, T lower, T upper, T guess, T tolerance, int max_iterations) {
    if (!(std::isfinite(lower) && std::isfinite(upper) && lower <= upper)) return {guess, 0, 0, RootStatus::no_bracket};

    Bracket<T> bracket{lower, upper};
    auto& [low, high, low_seen, high_seen] = bracket;
    T x = std::isnan(guess) ? std::midpoint(low, high) : std::clamp(guess, low, high);
    int direction = 0;  // +1 rising, -1 falling, 0 not known yet
    T last_move = std::numeric_limits<T>::infinity();
    int last_side = 0;
    T reach = 0;  // how far beyond the expected root to probe; doubled while it falls short

    for (int i = 1; i <= max_iterations; ++i) {
        const auto [value, slope] = f(x);
        if (std::isnan(value)) return {x, high - low, i, RootStatus::not_converged};
        if (value == 0) return {x, 0, i, RootStatus::converged};

        if (direction == 0 && slope != 0 && !std::isnan(slope)) direction = slope > 0 ? 1 : -1;
        if (direction == 0) {  // no slope: compare with the ends
            const T at_low = f(lower).first, at_high = f(upper).first;
            i += 2;
            direction = at_low < at_high ? 1 : -1;
            if (!(at_low != 0)) return {lower, 0, i, at_low == 0 ? RootStatus::converged : RootStatus::not_converged};
            if (!(at_high != 0)) return {upper, 0, i, at_high == 0 ? RootStatus::converged : RootStatus::not_converged};
            if ((at_low < 0) == (at_high < 0)) return {x, upper - lower, i, RootStatus::no_bracket};
            low_seen = high_seen = true;
        }

        const int side = (value < 0) == (direction > 0) ? 1 : -1;  // where the root is, seen from x
        if (side > 0 ? x >= upper : x <= lower) return {x, high - low, i, RootStatus::no_bracket};
        (side > 0 ? low : high) = x;
        (side > 0 ? low_seen : high_seen) = true;

        const T width = (std::max)(tolerance, 4 * std::numeric_limits<T>::epsilon() * std::abs(x));
        const T step = -value / slope;
        if (high - low <= width) {
            if (low_seen && high_seen) {
                const T newton = x + step, root = newton >= low && newton <= high ? newton : std::midpoint(low, high);
                return {root, (std::max)(root - low, high - root), i, RootStatus::converged};
            }
            x = low_seen ? high : low;
            continue;
        }

        if (side != last_side) reach = width / 2;
        last_side = side;
        T next = x + step;
        if (std::abs(step) <= width / 4)
            next += T(side) * std::exchange(reach, 2 * reach);
        else if (!(std::abs(step) <= last_move / 2))
            next = std::midpoint(low, high);
        next = bracket.probe(next, side);
        last_move = std::abs(next - x);
        x = next;
    }
    return {x, high - low, (std::max)(max_iterations, 0), RootStatus::not_converged};
}

/// The root of the monotone function \p f in [\p lower, \p upper], sought from \p guess (moved there when outside).
/// \p f takes x and returns a pair {value, slope}. Does not allocate; throws only what f throws.
template <Real T, class F>
[[nodiscard]] RootResult<T> newton_bracketed(
    F f, T lower, T upper, T guess, T tolerance,
    int max_iterations = root_iterations) noexcept(std::is_nothrow_invocable_v<F&, T>) {
    const SlopedFunction<T> sloped{
        std::addressof(f), [](void* function, T x) -> std::pair<T, T> { return (*static_cast<F*>(function))(x); }};
    return newton_of(sloped, lower, upper, guess, tolerance, max_iterations);
}

}}}  // namespace fstiff::math
