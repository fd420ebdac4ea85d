// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// A function as many short polynomials, found without a search, a logarithm or a branch, one number or four at a time.
///
///     f(x) = c_0 + c_1 s + ... + c_7 s^7        eight coefficients a piece, one row of a table, one cache line
///     BinaryPieces    eight equal pieces to each power of 2: the leading bits of x name the piece, the others are s
///     UniformPieces   equal pieces of [begin, end], s in [-1, 1]
///
/// Rows are kept in a std::vector, since the alignment of Eigen's storage depends on compiler flags. four_at_once is
/// true if four rows are transposed in registers (AVX for double, any for float).
///
/// Valid       BinaryPieces: 0 < low <= x <= high, normal numbers. UniformPieces: begin <= x <= end. contains()
///             compares integers and is false for a NaN under any compiler flag
/// Accuracy    that of the coefficients and 2 ulp of the largest term; value() gives the same bits everywhere, and so
///             does four_values(); the two differ by rounding

#include <fstiff/core/numbers.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <vector>

namespace fstiff { inline namespace v0_1 { namespace math {

/// The bits of a float or double as a number: for numbers from 0 on they are in the order of the numbers, and those of
/// all negative numbers and NaN come after that of infinity.
template <Real T>
using Bits = std::conditional_t<sizeof(T) == 8, std::uint64_t, std::uint32_t>;
template <Real T>
[[nodiscard]] constexpr Bits<T> bits_of(T x) noexcept {
    return std::bit_cast<Bits<T>>(x);
}
/// Also with -ffinite-math-only.
template <Real T>
[[nodiscard]] constexpr bool is_nan(T x) noexcept {
    return (bits_of(x) << 1) > (bits_of(std::numeric_limits<T>::infinity()) << 1);
}

/// One row: its polynomial and the derivative by s, by two interleaved Horner rules in s^2 at half the latency.
struct Row {
    static constexpr int terms = 8;

    template <Real T>
    [[nodiscard]] static T value(const T* c, T s) noexcept {
        const T square = s * s;
        const T even = ((c[6] * square + c[4]) * square + c[2]) * square + c[0];
        const T odd = ((c[7] * square + c[5]) * square + c[3]) * square + c[1];
        return odd * s + even;
    }
    template <Real T>
    [[nodiscard]] static T derivative(const T* c, T s) noexcept {
        const T square = s * s;
        const T even = ((7 * c[7] * square + 5 * c[5]) * square + 3 * c[3]) * square + c[1];
        const T odd = (6 * c[6] * square + 4 * c[4]) * square + 2 * c[2];
        return odd * s + even;
    }
    /// Integral of the polynomial from \p s to 1.
    template <Real T>
    [[nodiscard]] static T integral_to_end(const T* c, T s) noexcept {
        T sum{}, powers = 1;  // (1 - s^(k+1))/(1 - s) term by term, without cancellation as s goes to 1
        T power = 1;
        for (int k = 0; k < terms; ++k) {
            sum += c[k] * powers / T(k + 1);
            power *= s;
            powers += power;
        }
        return (1 - s) * sum;
    }
};

/// The coefficients of one polynomial.
template <Real T>
struct alignas(sizeof(T) * Row::terms) Coefficients {
    T c[Row::terms];
    [[nodiscard]] bool operator==(const Coefficients&) const = default;
};

template <Real T>
using Four = typename Eigen::internal::find_best_packet<T, 4>::type;
/// True if there are registers of four T, or two that Eigen takes for one.
template <Real T>
inline constexpr bool four_at_once = Eigen::internal::unpacket_traits<Four<T>>::size == 4;

/// Four rows, side by side: written out, because the loops would not be unrolled at -O2 nor the rows stay in registers.
template <Real T>
requires four_at_once<T>
class FourRows {
public:
    EIGEN_ALWAYS_INLINE FourRows(const T* a, const T* b, const T* c, const T* d) {
        using namespace Eigen::internal;
        low_.packet[0] = ploadu<Four<T>>(a);
        low_.packet[1] = ploadu<Four<T>>(b);
        low_.packet[2] = ploadu<Four<T>>(c);
        low_.packet[3] = ploadu<Four<T>>(d);
        high_.packet[0] = ploadu<Four<T>>(a + 4);
        high_.packet[1] = ploadu<Four<T>>(b + 4);
        high_.packet[2] = ploadu<Four<T>>(c + 4);
        high_.packet[3] = ploadu<Four<T>>(d + 4);
        ptranspose(low_);
        ptranspose(high_);
    }
    struct ValueAndDerivative {
        Four<T> value, derivative;
    };
    /// The derivative is that of the Horner rule of the value; it is free where it is not used.
    [[nodiscard]] EIGEN_ALWAYS_INLINE ValueAndDerivative value_and_derivative(const Four<T>& s) const {
        using Eigen::internal::pmadd;
        Four<T> slope = high_.packet[3];
        Four<T> sum = pmadd(high_.packet[3], s, high_.packet[2]);
        slope = pmadd(slope, s, sum);
        sum = pmadd(sum, s, high_.packet[1]);
        slope = pmadd(slope, s, sum);
        sum = pmadd(sum, s, high_.packet[0]);
        slope = pmadd(slope, s, sum);
        sum = pmadd(sum, s, low_.packet[3]);
        slope = pmadd(slope, s, sum);
        sum = pmadd(sum, s, low_.packet[2]);
        slope = pmadd(slope, s, sum);
        sum = pmadd(sum, s, low_.packet[1]);
        slope = pmadd(slope, s, sum);
        return {pmadd(sum, s, low_.packet[0]), slope};
    }

private:
    Eigen::internal::PacketBlock<Four<T>, 4> low_, high_;
};

template <Real T = double>
struct BinaryPieces {
    static constexpr int bits_of_piece = 3;  ///< eight pieces a power of 2
    static constexpr int shift = std::numeric_limits<T>::digits - 1 - bits_of_piece;
    static constexpr Bits<T> rest = (Bits<T>(1) << shift) - 1;  ///< the bits within a piece
    static constexpr T half = T(1) / (2 << bits_of_piece);      ///< s is within -half and half

    Bits<T> low = 0, count = 0, first = 0;  ///< count: of the numbers from low to high; 0 of an empty table
    std::vector<Coefficients<T>> rows;

    BinaryPieces() = default;
    BinaryPieces(T from, T to)
        : low(bits_of(from)),
          count(bits_of(to) - low + 1),
          first(low >> shift),
          rows(static_cast<std::size_t>(pieces(from, to))) {}

    [[nodiscard]] static Eigen::Index pieces(T from, T to) {
        return static_cast<Eigen::Index>((bits_of(to) >> shift) - (bits_of(from) >> shift)) + 1;
    }
    /// Beginning of the piece, end of the one before it. The outermost pieces are whole, beyond low and high.
    [[nodiscard]] T edge(Eigen::Index piece) const {
        return std::bit_cast<T>((first + static_cast<Bits<T>>(piece)) << shift);
    }

    [[nodiscard]] T lowest() const noexcept { return std::bit_cast<T>(low); }
    [[nodiscard]] bool contains(T x) const noexcept { return bits_of(x) - low < count; }
    [[nodiscard]] T value(T x) const noexcept { return Row::value(row(x), s(x)); }
    [[nodiscard]] T derivative(T x) const noexcept {
        constexpr Bits<T> exponent = bits_of(std::numeric_limits<T>::infinity());
        return Row::derivative(row(x), s(x)) / std::bit_cast<T>(bits_of(x) & exponent);
    }

    EIGEN_ALWAYS_INLINE void four_values(const T* x, T* out) const noexcept requires four_at_once<T> {
        using namespace Eigen::internal;
        using P = Four<T>;
        const P fraction = pand(ploadu<P>(x), pset1<P>(std::bit_cast<T>(rest)));
        const P place = psub(por(fraction, pset1<P>(T(1))), pset1<P>(1 + half));
        pstoreu(out, FourRows<T>(row(x[0]), row(x[1]), row(x[2]), row(x[3])).value_and_derivative(place).value);
    }

private:
    [[nodiscard]] const T* row(T x) const noexcept {
        return rows[static_cast<std::size_t>((bits_of(x) >> shift) - first)].c;
    }
    [[nodiscard]] static T s(T x) noexcept {
        return std::bit_cast<T>(static_cast<Bits<T>>((bits_of(x) & rest) | bits_of(T(1)))) - (1 + half);
    }
};

template <Real T = double>
struct UniformPieces {
    /// An empty table contains no number: the difference to a NaN is none.
    T begin = std::numeric_limits<T>::quiet_NaN(), end = begin;
    T length{}, pieces_per_length{};
    std::vector<Coefficients<T>> rows;

    UniformPieces() = default;
    UniformPieces(T from, T to, Eigen::Index pieces)
        : begin(from),
          end(to),
          length(to - from),
          pieces_per_length(T(pieces) / length),
          rows(static_cast<std::size_t>(pieces)) {}

    [[nodiscard]] T lowest() const noexcept { return begin; }
    [[nodiscard]] bool contains(T x) const noexcept { return bits_of(T(x - begin)) <= bits_of(length); }

    struct ValueAndDerivative {
        T value, derivative;  ///< by s, 2 to a piece
    };
    [[nodiscard]] ValueAndDerivative operator()(T x) const noexcept {
        const T position = (x - begin) * pieces_per_length;
        const auto piece = (std::min)(static_cast<Eigen::Index>(position), std::ssize(rows) - 1);
        const T s = 2 * (position - T(piece)) - 1;
        const T* c = rows[static_cast<std::size_t>(piece)].c;
        return {Row::value(c, s), Row::derivative(c, s)};
    }

    /// Integral of every piece, and of all that follow it.
    [[nodiscard]] std::vector<T> integrals() const {
        std::vector<T> sums(rows.size() + 1);
        for (std::size_t i = rows.size(); i-- > 0;)
            sums[i] = sums[i + 1] + Row::integral_to_end(rows[i].c, T(-1)) / (2 * pieces_per_length);
        return sums;
    }
    /// Integral from \p x to the end; \p sums are integrals().
    [[nodiscard]] T integral_to_end(T x, const std::vector<T>& sums) const noexcept {
        const T position = (x - begin) * pieces_per_length;
        const auto piece =
            static_cast<std::size_t>((std::min)(static_cast<Eigen::Index>(position), std::ssize(rows) - 1));
        const T s = 2 * (position - T(piece)) - 1;
        return sums[piece + 1] + Row::integral_to_end(rows[piece].c, s) / (2 * pieces_per_length);
    }

    /// The derivatives are multiplied by \p factor.
    EIGEN_ALWAYS_INLINE void four_values(const T* x, T factor, T* values,
                                         T* derivatives) const noexcept requires four_at_once<T> {
        using namespace Eigen::internal;
        using P = Four<T>;
        const P position = pmul(psub(ploadu<P>(x), pset1<P>(begin)), pset1<P>(pieces_per_length));
        const P piece = pmin(pfloor(position), pset1<P>(T(std::ssize(rows) - 1)));
        const P middle = padd(piece, pset1<P>(T(0.5)));
        const P half_s = psub(position, middle);
        T pieces[4];
        pstoreu(pieces, piece);
        const auto row = [&](T i) { return rows.data()[static_cast<std::ptrdiff_t>(i)].c; };
        const auto [value, derivative] = FourRows<T>(row(pieces[0]), row(pieces[1]), row(pieces[2]), row(pieces[3]))
                                             .value_and_derivative(padd(half_s, half_s));
        pstoreu(values, value);
        pstoreu(derivatives, pmul(derivative, pset1<P>(factor)));
    }
};

}}}  // namespace fstiff::math
