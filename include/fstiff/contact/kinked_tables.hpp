// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Table of a law whose stiffness has kinks, such as that of a map, each of whose summits adds one: parabolas.
///
///     p = p_i + s_i x + b_i x^2/2      -dp/dd = s_i + b_i x      K = K_i + c_i x      x = d_i - d       by separation
///     s = sqrt(s_i^2 + 2 b_i (p - p_i))      x = 2 (p - p_i)/(s_i + s)                                  by pressure
///
/// The inverse of a parabola is closed, so that all quantities are one function, and -dp/dd is the derivative of p. A
/// piece is found through equal cells of d and of the leading bits of p, two for each piece, and bisection.
///
/// Units       SI: Pa, m, Pa/m
/// Valid       float and double; arguments within the table
/// Accuracy    that of the pieces (contact/kinked_tabulator.hpp); the inverse 4 epsilon of the pressure

#include <fstiff/math/piecewise.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace fstiff::detail {

/// One piece, from its lowest pressure on.
template <Real T>
struct Parabola {
    T separation{}, pressure{};           ///< d_i [m], p_i [Pa]
    T slope{}, bend{};                    ///< s_i [Pa/m], b_i [Pa/m^2]
    T stiffness{}, stiffness_per_fall{};  ///< K_i [Pa/m], c_i [Pa/m^2]
    [[nodiscard]] bool operator==(const Parabola&) const = default;
};

template <Real T>
class KinkedTables {
public:
    struct State {
        T separation, pressure, slope, stiffness, stiffness_slope;  ///< stiffness_slope: dK/dp [1/m]
    };

    KinkedTables() = default;
    /// Of pieces in the order of their pressures; the last one is the end of the table.
    explicit KinkedTables(std::vector<Parabola<T>> pieces) : pieces_(std::move(pieces)) {
        const Parabola<T>&first = pieces_.front(), &last = pieces_.back();
        low_ = bits_of(first.pressure), count_ = bits_of(last.pressure) - low_ + 1;
        while (shift_ > 0 && (count_ >> shift_) < 2 * pieces_.size()) --shift_;
        furthest_ = first.separation, length_ = furthest_ - last.separation;
        cells_per_length_ = static_cast<T>(2 * pieces_.size()) / length_;
        by_pressure_ = cells([this](const Parabola<T>& at) { return pressure_cell(at.pressure); });
        by_separation_ = cells([this](const Parabola<T>& at) { return separation_cell(at.separation); });
    }

    [[nodiscard]] bool empty() const noexcept { return pieces_.empty(); }
    [[nodiscard]] const std::vector<Parabola<T>>& pieces() const noexcept { return pieces_; }
    /// The least and the greatest separation [m].
    [[nodiscard]] T closest() const { return pieces_.back().separation; }
    [[nodiscard]] T furthest() const { return pieces_.front().separation; }

    /// False for a NaN, and for every number where the table is empty.
    [[nodiscard]] bool contains_pressure(T p) const noexcept { return bits_of(p) - low_ < count_; }
    [[nodiscard]] bool contains_separation(T d) const noexcept {
        return !empty() && bits_of(T(furthest_ - d)) <= bits_of(length_);
    }

    [[nodiscard]] State at_separation(T d) const noexcept {
        const Parabola<T>& at = piece(by_separation_, separation_cell(d),
                                      [d](const Parabola<T>& one) { return one.separation >= d; });
        const T x = at.separation - d, slope = at.slope + at.bend * x;
        return state(at, x, at.pressure + x * (at.slope + slope) / 2, slope);
    }
    [[nodiscard]] State at_pressure(T p) const noexcept {
        const Parabola<T>& at =
            piece(by_pressure_, pressure_cell(p), [p](const Parabola<T>& one) { return one.pressure <= p; });
        const T more = p - at.pressure, slope = std::sqrt((std::max)(at.slope * at.slope + 2 * at.bend * more, T(0)));
        return state(at, 2 * more / (at.slope + slope), p, slope);
    }
    /// dK/dp over the last tenth of the pressures, never less than 0: how the law goes on [1/m].
    [[nodiscard]] T growth_at_end() const {
        const Parabola<T>& last = pieces_.back();
        const T from = (std::max)(last.pressure * T(0.9), pieces_.front().pressure);
        return (std::max)((last.stiffness - at_pressure(from).stiffness) / (last.pressure - from), T(0));
    }

    [[nodiscard]] bool operator==(const KinkedTables& other) const { return pieces_ == other.pieces_; }

private:
    using Index = std::uint32_t;

    [[nodiscard]] static State state(const Parabola<T>& at, T x, T pressure, T slope) noexcept {
        return {at.separation - x, pressure, slope, at.stiffness + at.stiffness_per_fall * x, at.stiffness_per_fall / slope};
    }
    [[nodiscard]] std::size_t pressure_cell(T p) const noexcept {
        return static_cast<std::size_t>((bits_of(p) - low_) >> shift_);
    }
    [[nodiscard]] std::size_t separation_cell(T d) const noexcept {
        return static_cast<std::size_t>((furthest_ - d) * cells_per_length_);
    }
    /// The last of the pieces that begin in the cells before each cell, and at the end the last of all.
    template <class Cell>
    [[nodiscard]] std::vector<Index> cells(const Cell& cell) const {
        std::vector<Index> last_before(cell(pieces_.back()) + 2, 0);
        for (std::size_t i = 0; i + 1 < pieces_.size(); ++i) last_before[cell(pieces_[i]) + 1] = static_cast<Index>(i);
        for (std::size_t c = 1; c < last_before.size(); ++c)
            last_before[c] = (std::max)(last_before[c], last_before[c - 1]);
        return last_before;
    }
    /// The last piece of a cell that \p begins says yes of. The end of the table is none.
    template <class Begins>
    [[nodiscard]] const Parabola<T>& piece(const std::vector<Index>& cells, std::size_t cell,
                                           const Begins& begins) const noexcept {
        Index first = cells[cell], last = cells[cell + 1];
        while (first < last) {
            const Index middle = last - (last - first) / 2;
            begins(pieces_[middle]) ? first = middle : last = middle - 1;
        }
        return pieces_[first];
    }

    std::vector<Parabola<T>> pieces_;
    Bits<T> low_ = 0, count_ = 0;  ///< of the pressures; count_ 0 of an empty table
    int shift_ = std::numeric_limits<T>::digits - 2;  ///< bits of a cell
    T furthest_{}, length_{}, cells_per_length_{};
    std::vector<Index> by_pressure_, by_separation_;
};

}  // namespace fstiff::detail
