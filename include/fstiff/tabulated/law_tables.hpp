// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Numbers of a tabulated law and their evaluation within and beyond its range: all that is written to text.
///
///     p(d), -dp/dd       one table, uniform in d; K(d) too where K is a constant times -dp/dd, else from its own table
///     d(p), K(p), dK/dp  two tables, in the binary exponent of p
///     with kinks, one of parabolas for all:  p = p_i + s_i x + b_i x^2/2,  -dp/dd = s_i + b_i x,  K = K_i + c_i x
///       x = d_i - d;  by pressure x = 2 (p - p_i)/(s_i + s),  s = sqrt(s_i^2 + 2 b_i (p - p_i))
///     extrapolate, d > d_max:  p = p_e exp(-(d - d_max) s_e/p_e),  K = K_e p/p_e;  to p = K = 0 for an open contact
///     extrapolate, d < d_min:  p = p_e + s_e x + s_e' x^2/2,  s = s_e + s_e' x,  x = d_min - d,  K/K_e = s/s_e
///
/// e marks the ends, s the slope -dp/dd, which is the derivative of p throughout: s_e' is that of K_e' s_e/K_e.
///
/// Units       SI: Pa, m, Pa/m
/// Valid       float and double; arguments within the tables, but for the functions of the continuation
/// Accuracy    relative_error, as the tabulators measure it; the inverse of a parabola 4 epsilon of the pressure

#include <fstiff/core/error.hpp>
#include <fstiff/core/text.hpp>
#include <fstiff/math/piecewise.hpp>

namespace fstiff { inline namespace v0_1 {

namespace detail {

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
    /// Takes pieces in the order of their pressures; the last one is the end of the table.
    explicit KinkedTables(std::vector<Parabola<T>> pieces) : pieces_(std::move(pieces)) {
        const Parabola<T>&first = pieces_.front(), &last = pieces_.back();
        low_ = math::bits_of(first.pressure), count_ = math::bits_of(last.pressure) - low_ + 1;
        while (shift_ > 0 && (count_ >> shift_) < 2 * pieces_.size()) --shift_;
        furthest_ = first.separation, length_ = furthest_ - last.separation;
        cells_per_length_ = static_cast<T>(2 * pieces_.size()) / length_;
        energy_.resize(pieces_.size());
        for (std::size_t i = 1; i < pieces_.size(); ++i)
            energy_[i] = energy_[i - 1] + work(pieces_[i - 1], pieces_[i - 1].separation - pieces_[i].separation);
        by_pressure_ = cells([this](const Parabola<T>& arc) { return pressure_cell(arc.pressure); });
        by_separation_ = cells([this](const Parabola<T>& arc) { return separation_cell(arc.separation); });
    }

    [[nodiscard]] bool empty() const noexcept { return pieces_.empty(); }
    [[nodiscard]] const std::vector<Parabola<T>>& pieces() const noexcept { return pieces_; }
    /// The least and the greatest separation [m].
    [[nodiscard]] T closest() const { return pieces_.back().separation; }
    [[nodiscard]] T furthest() const { return pieces_.front().separation; }

    /// False for a NaN, and for every number where the table is empty.
    [[nodiscard]] bool contains_pressure(T p) const noexcept { return math::bits_of(p) - low_ < count_; }
    [[nodiscard]] bool contains_separation(T d) const noexcept {
        return !empty() && math::bits_of(T(furthest_ - d)) <= math::bits_of(length_);
    }

    [[nodiscard]] State at_separation(T d) const noexcept {
        const Parabola<T>& arc =
            piece(by_separation_, separation_cell(d), [d](const Parabola<T>& piece) { return piece.separation >= d; });
        const T x = arc.separation - d, slope = arc.slope + arc.bend * x;
        return state(arc, x, arc.pressure + x * (arc.slope + slope) / 2, slope);
    }
    [[nodiscard]] State at_pressure(T p) const noexcept {
        const Parabola<T>& arc =
            piece(by_pressure_, pressure_cell(p), [p](const Parabola<T>& piece) { return piece.pressure <= p; });
        const T dp = p - arc.pressure, slope = std::sqrt((std::max)(arc.slope * arc.slope + 2 * arc.bend * dp, T(0)));
        return state(arc, 2 * dp / (arc.slope + slope), p, slope);
    }
    /// Integral of p from \p d to furthest() [J/m^2].
    [[nodiscard]] T energy(T d) const noexcept {
        const Parabola<T>& arc =
            piece(by_separation_, separation_cell(d), [d](const Parabola<T>& piece) { return piece.separation >= d; });
        return energy_[static_cast<std::size_t>(&arc - pieces_.data())] + work(arc, arc.separation - d);
    }
    /// dK/dp over the last tenth of the pressures, never less than 0: the growth of the continued law [1/m].
    [[nodiscard]] T growth_at_end() const {
        const Parabola<T>& last = pieces_.back();
        const T from = (std::max)(last.pressure * T(0.9), pieces_.front().pressure);
        return (std::max)((last.stiffness - at_pressure(from).stiffness) / (last.pressure - from), T(0));
    }

    [[nodiscard]] bool operator==(const KinkedTables& other) const { return pieces_ == other.pieces_; }

private:
    using Index = std::uint32_t;

    /// State of a piece as it closes by \p x.
    [[nodiscard]] static T work(const Parabola<T>& arc, T x) noexcept {
        return x * (arc.pressure + x * (arc.slope / 2 + x * arc.bend / 6));
    }
    [[nodiscard]] static State state(const Parabola<T>& arc, T x, T pressure, T slope) noexcept {
        return {arc.separation - x, pressure, slope, arc.stiffness + arc.stiffness_per_fall * x,
                arc.stiffness_per_fall / slope};
    }
    [[nodiscard]] std::size_t pressure_cell(T p) const noexcept {
        return static_cast<std::size_t>((math::bits_of(p) - low_) >> shift_);
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
    /// The last piece of a cell for which \p begins is true. The end of the table is none.
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
    math::Bits<T> low_ = 0, count_ = 0;               ///< of the pressures; count_ 0 of an empty table
    int shift_ = std::numeric_limits<T>::digits - 2;  ///< bits of a cell
    T furthest_{}, length_{}, cells_per_length_{};
    std::vector<Index> by_pressure_, by_separation_;
    std::vector<T> energy_;  ///< at the beginning of each piece
};

}  // namespace detail

/// Behaviour of a law outside the range of its table.
enum class OutsideRange {
    refuse,      ///< throw domain_error
    clamp,       ///< the values at the nearer end of the range; with derivatives 0
    exact,       ///< evaluate the model itself: microseconds; not for a law that goes to text
    extrapolate  ///< continue the law smoothly: an opening contact ends with p = K = 0
};

/// Range of pressures of a tabulated law.
template <Real T = double>
struct LawRange {
    T min_pressure{};  ///< [Pa]
    T max_pressure{};  ///< [Pa]
    OutsideRange outside = OutsideRange::refuse;
};

namespace detail {

template <Real T>
struct LawTables {
    struct Whole {
        T pressure, stiffness, slope;
    };
    struct AtPressure {
        T separation, stiffness, stiffness_slope;
    };

    T min_pressure{}, max_pressure{};    ///< 0 of an empty law
    T slope_scale{}, stiffness_scale{};  ///< from dp/ds to -dp/dd and to K
    T stiffness_over_slope = T(1);       ///< 0 where K has its own table
    T relative_error{};
    OutsideRange outside = OutsideRange::refuse;
    int evaluations = 0;
    math::UniformPieces<T> by_separation;  ///< p
    math::UniformPieces<T>
        own_stiffness;  ///< K by separation, of the same pieces; empty where it is a constant times -dp/dd
    math::BinaryPieces<T> stiffness, separation;  ///< by pressure
    std::vector<T> energies;                      ///< of by_separation
    KinkedTables<T> kinked;                       ///< in place of all these

    [[nodiscard]] bool empty() const { return by_separation.rows.empty() && kinked.empty(); }
    /// The least and the greatest separation [m]; NaN of an empty law.
    [[nodiscard]] T closest() const { return kinked.empty() ? by_separation.begin : kinked.closest(); }
    [[nodiscard]] T furthest() const { return kinked.empty() ? by_separation.end : kinked.furthest(); }
    [[nodiscard]] bool has_separation(T d) const noexcept {
        return by_separation.contains(d) || kinked.contains_separation(d);
    }
    [[nodiscard]] bool has_own_stiffness() const noexcept { return stiffness_over_slope == T(0); }

    /// State by polynomials.
    [[nodiscard]] Whole at_separation(T g) const {
        const auto [pressure, derivative] = by_separation(g);
        T k = derivative * stiffness_scale;
        if (has_own_stiffness()) [[unlikely]]
            k = own_stiffness(g).value;
        return {pressure, k, derivative * slope_scale};
    }
    /// Separation by its own table, never beyond the ends of by_separation.
    [[nodiscard]] T separation_at(T pressure) const {
        return within(separation.value(pressure), by_separation.begin, by_separation.end);
    }

    [[nodiscard]] AtPressure at_pressure(T pressure) const {
        return {separation_at(pressure), stiffness.value(pressure), stiffness.derivative(pressure)};
    }
    /// State by parabolas.
    [[nodiscard]] Whole kinked_at_separation(T g) const {
        const auto point = kinked.at_separation(g);
        return {point.pressure, point.stiffness, point.slope};
    }
    [[nodiscard]] AtPressure kinked_at_pressure(T pressure) const {
        const auto point = kinked.at_pressure(pressure);
        return {within(point.separation, closest(), furthest()), point.stiffness, point.stiffness_slope};
    }
    /// The state at an end of the range.
    [[nodiscard]] Whole at_closest() const {
        return kinked.empty() ? at_separation(by_separation.begin) : kinked_at_separation(closest());
    }
    [[nodiscard]] Whole at_furthest() const {
        return kinked.empty() ? at_separation(by_separation.end) : kinked_at_separation(furthest());
    }
    [[nodiscard]] AtPressure at_end(T pressure) const {
        return kinked.empty() ? at_pressure(pressure) : kinked_at_pressure(pressure);
    }

    /// K over -dp/dd at \p end, an end of the range; the continuation keeps it.
    [[nodiscard]] T ratio_at(const Whole& end) const {
        return has_own_stiffness() ? end.stiffness / end.slope : stiffness_over_slope;
    }
    /// dK/dp above the range.
    [[nodiscard]] T growth_at_end() const {
        return kinked.empty() ? stiffness.derivative(max_pressure) : kinked.growth_at_end();
    }

    /// The law beyond the range: K/p is constant below it, K dK/dp above it. Each continues its own table, from the
    /// value at the very end. \throws domain_error for a pressure that is negative or not finite.
    [[nodiscard]] AtPressure continued_pressure(T pressure) const {
        require(pressure >= 0 && pressure <= (std::numeric_limits<T>::max)(), "pressure", pressure,
                "finite and at least 0 Pa: the contact does not pull");
        if (pressure < min_pressure) {
            const AtPressure end = at_end(min_pressure);
            const T rate = end.stiffness / min_pressure;
            const T fall = rate / ratio_at(at_furthest());
            return {end.separation + std::log(min_pressure / pressure) / fall, rate * pressure, rate};
        }
        const AtPressure end = at_end(max_pressure);
        const T more = pressure - max_pressure, slope = growth_at_end();
        const T growth = std::sqrt(1 + 2 * (slope / end.stiffness) * more);
        const T k = end.stiffness * growth;
        return {end.separation - 2 * more / ((end.stiffness + k) / ratio_at(at_closest())), k, slope / growth};
    }
    /// \throws domain_error for -infinity.
    [[nodiscard]] Whole continued_separation(T d) const {
        if (d > furthest()) {
            const Whole end = at_furthest();
            const T share = std::exp(-(d - furthest()) * (end.slope / end.pressure));
            return {end.pressure * share, end.stiffness * share, end.slope * share};
        }
        require(d >= std::numeric_limits<T>::lowest(), "separation", d, "greater than -infinity (m)");
        const Whole end = at_closest();
        const T less = closest() - d;
        const T bend = growth_at_end() * end.slope;  // dK/d less
        const T more_slope = bend * less / ratio_at(end);
        const T p = end.pressure + less * (end.slope + more_slope / 2);
        return {p, end.stiffness + bend * less, end.slope + more_slope};
    }

    /// Integral of p from \p d to infinity [J/m^2], of a law that is continued. \throws domain_error for -infinity.
    [[nodiscard]] T energy(T d) const {
        if (d > furthest()) {
            const Whole point = continued_separation(d);
            return point.slope > 0 ? point.pressure * (point.pressure / point.slope) : T(0);
        }
        const Whole open = at_furthest();
        const T beyond = open.pressure * (open.pressure / open.slope), inside = within(d, closest(), furthest());
        const T in_range = kinked.empty() ? by_separation.integral_to_end(inside, energies) : kinked.energy(inside);
        if (!(d < closest())) return beyond + in_range;
        const Whole end = at_closest(), point = continued_separation(d);
        const T x = closest() - d;  // p is a quadratic: the rule of trapezia and its error
        return beyond + in_range + x * ((end.pressure + point.pressure) / 2 - x * (point.slope - end.slope) / 12);
    }

    /// Called once the rows of by_separation are filled.
    void sum_energies() { energies = by_separation.integrals(); }
    /// Called once by_separation and stiffness_over_slope are set.
    void set_scales() {
        slope_scale = -2 * by_separation.pieces_per_length;
        stiffness_scale = slope_scale * stiffness_over_slope;
    }

    /// Never a NaN: that becomes \p low.
    [[nodiscard]] static T within(T x, T low, T high) noexcept { return x > low ? (x < high ? x : high) : low; }

    [[nodiscard]] bool operator==(const LawTables& other) const {
        if (empty() || other.empty()) return empty() && other.empty();
        return min_pressure == other.min_pressure && max_pressure == other.max_pressure &&
               closest() == other.closest() && furthest() == other.furthest() &&
               stiffness_over_slope == other.stiffness_over_slope && relative_error == other.relative_error &&
               outside == other.outside && evaluations == other.evaluations &&
               by_separation.rows == other.by_separation.rows && stiffness.rows == other.stiffness.rows &&
               separation.rows == other.separation.rows && own_stiffness.rows == other.own_stiffness.rows &&
               kinked == other.kinked;
    }
};

/// \p tables up to where K falls by more than a thousandth, as at the greatest load of a joint that has yielded.
template <Real T>
[[nodiscard]] LawTables<T> until_fall(LawTables<T> tables) {
    const std::vector<Parabola<T>>& pieces = tables.kinked.pieces();
    for (std::size_t i = 1; i + 1 < pieces.size(); ++i) {
        const Parabola<T>&last = pieces[i - 1], &next = pieces[i];
        const T length = last.separation - next.separation, K = last.stiffness + last.stiffness_per_fall * length;
        if (!(next.stiffness < T(0.999) * K)) continue;
        std::vector<Parabola<T>> below(pieces.begin(), pieces.begin() + static_cast<std::ptrdiff_t>(i));
        below.push_back({next.separation, next.pressure, last.slope + last.bend * length, 0, K, 0});
        tables.max_pressure = next.pressure;
        tables.kinked = KinkedTables<T>(std::move(below));
        break;
    }
    return tables;
}

/// \p below with its greatest pressure at \p separation, where it still holds, and \p above beyond, both of parabolas;
/// the latter may be empty.
template <Real T>
[[nodiscard]] LawTables<T> joined(LawTables<T> below, const LawTables<T>& above, T separation) {
    std::vector<Parabola<T>> pieces = below.kinked.pieces();
    const T fall = separation - pieces.back().separation;
    for (auto& piece : pieces) piece.separation += fall;
    if (!above.empty()) {
        pieces.pop_back();
        const T drop = separation - above.kinked.furthest();
        const std::size_t first = pieces.size();
        for (auto piece : above.kinked.pieces()) piece.separation += drop, pieces.push_back(piece);
        pieces[first].pressure = std::nextafter(pieces[first].pressure, (std::numeric_limits<T>::max)());
        pieces[first].separation = std::nextafter(pieces[first].separation, std::numeric_limits<T>::lowest());
        below.max_pressure = above.max_pressure;
        below.relative_error = (std::max)(below.relative_error, above.relative_error);
        below.evaluations += above.evaluations;
    }
    below.kinked = KinkedTables<T>(std::move(pieces));
    return below;
}

}  // namespace detail

}}  // namespace fstiff
