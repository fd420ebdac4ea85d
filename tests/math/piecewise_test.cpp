// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/math/chebyshev.hpp>
#include <fstiff/math/piecewise.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>

namespace piecewise_test {

using namespace fstiff;
using namespace fstiff::math;

namespace {

/// Fits \p f to the pieces, whose number \p edge(i) begins at; s is within -half and half.
template <class T, class Rows, class Edge, class F>
void fit(Rows& rows, T half, const Edge& edge, const F& f) {
    const auto& lobatto = math::LobattoPiece<T, math::Row::terms>::get();
    for (std::size_t row = 0; row < rows.size(); ++row) {
        const auto i = static_cast<Eigen::Index>(row);
        std::array<T, math::Row::terms> value;
        for (std::size_t k = 0; k < value.size(); ++k)
            value[k] = f(edge(i) + (edge(i + 1) - edge(i)) * (1 + lobatto.node[k]) / 2);
        lobatto.fit(math::Lanes<T, math::Row::terms>::load(value.data())).store(rows[row].c);
        for (int k = 0; k < math::Row::terms; ++k) rows[row].c[k] /= std::pow(half, T(k));
    }
}

}  // namespace

TEMPLATE_TEST_CASE("pieces by the binary exponent: log x and 1/x, one and four at a time", "", float, double) {
    using T = TestType;
    const T low = T(3e-5), high = T(7e6), epsilon = std::numeric_limits<T>::epsilon();
    math::BinaryPieces<T> pieces(low, high);
    fit(
        pieces.rows, math::BinaryPieces<T>::half, [&](Eigen::Index i) { return pieces.edge(i); },
        [](T x) { return std::log(x); });
    CHECK(pieces.edge(0) <= low);
    CHECK(pieces.edge(1) > low);
    CHECK(pieces.edge(std::ssize(pieces.rows)) > high);
    // interpolation of log over [1, 9/8] in 8 points: 4 / (8 rho^8) with rho = 34 is 3e-13; the conversion to powers
    // has a condition of some hundreds of the largest value, 16, and the slope that over the 1/16 of half a piece
    const T bound = 256 * epsilon + T(3e-13), slope_bound = 100000 * epsilon + T(1e-10);
    Eigen::Index count = 0;
    for (T x = low; x <= high; x *= T(1.0137)) {
        const T more[4] = {x, std::min(x * T(1.9), high), low, high};
        REQUIRE(std::abs(pieces.value(x) - std::log(x)) <= bound * (1 + std::abs(std::log(x))));
        REQUIRE(test::relative_error(pieces.derivative(x), 1 / x) <= slope_bound);
        if constexpr (math::four_at_once<T>) {
            T found[4];
            pieces.four_values(more, found);
            for (int k = 0; k < 4; ++k) REQUIRE(std::abs(found[k] - pieces.value(more[k])) <= 200 * epsilon);
        }
        ++count;
    }
    CHECK(count > 1000);
}

TEMPLATE_TEST_CASE("equal pieces: exp and its slope, one and four at a time", "", float, double) {
    using T = TestType;
    const T from = -3, to = 2, epsilon = std::numeric_limits<T>::epsilon();
    math::UniformPieces<T> pieces(from, to, 20);
    fit(
        pieces.rows, T(1), [&](Eigen::Index i) { return from + (to - from) * T(i) / 20; },
        [](T x) { return std::exp(x); });
    // h^8 / 8! times the largest |w| = 0.02 of the nodes, h = 1/8; times w'(1)/h = 1.8 for the slope
    const T bound = 256 * epsilon + T(1e-14), slope_bound = 3000 * epsilon + T(3e-12);
    for (int i = 0; i <= 1000; ++i) {
        const T x = from + (to - from) * T(i) / 1000;
        const auto [value, derivative] = pieces(x);
        REQUIRE(test::relative_error(value, std::exp(x)) <= bound);
        REQUIRE(test::relative_error(derivative * 8, std::exp(x)) <= slope_bound);  // 2 s to a piece of 1/4
        if constexpr (math::four_at_once<T>) {
            const T four[4] = {from, x, to, x};
            T values[4], derivatives[4];
            pieces.four_values(four, T(8), values, derivatives);
            REQUIRE(test::relative_error(values[1], value) <= 20 * epsilon);
            REQUIRE(test::relative_error(derivatives[1], derivative * 8) <= 100 * epsilon);
            REQUIRE(values[1] == values[3]);
            REQUIRE(test::relative_error(values[0], std::exp(from)) <= bound);
            REQUIRE(test::relative_error(values[2], std::exp(to)) <= bound);
        }
    }
}

TEMPLATE_TEST_CASE("only numbers in the range are contained", "", float, double) {
    using T = TestType;
    using Limits = std::numeric_limits<T>;
    const T low = T(0.7), high = T(123), infinity = Limits::infinity();
    const math::BinaryPieces<T> binary(low, high);
    const math::UniformPieces<T> uniform(low, high, 5);
    for (const T x : {low, std::nextafter(low, T(1)), T(1), T(2), T(64), std::nextafter(high, T(1)), high}) {
        CHECK(binary.contains(x));
        CHECK(uniform.contains(x));
    }
    for (const T x : {std::nextafter(low, T(0)), T(0), -T(0), -low, -T(1), -high, -infinity, infinity, Limits::max(),
                      Limits::denorm_min(), T(124), Limits::quiet_NaN(), -Limits::quiet_NaN()}) {
        CHECK_FALSE(binary.contains(x));
        CHECK_FALSE(uniform.contains(x));
    }
    CHECK_FALSE(binary.contains(std::nextafter(high, T(200))));
    CHECK(math::is_nan(Limits::quiet_NaN()));
    CHECK(math::is_nan(-Limits::quiet_NaN()));
    for (const T x : {T(0), -T(0), T(1), -infinity, infinity, Limits::max(), Limits::denorm_min()})
        CHECK_FALSE(math::is_nan(x));
}

}  // namespace piecewise_test
