// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Table of parabolas of a law whose stiffness has kinks, from its states at pressures.
///
///     K = ratio (-dp/dd)    K linear in d between points 1/40 of p apart or closer, p and d as its integrals
///     own K             p(d) through all nodes, with a knot half-way between two of them; slopes are weighted harmonic
///                           means of the chords on both sides, at most 1.8 times either, so that p rises strictly
///
/// Intervals of log p are divided where log K, or d of an own K, is off a straight line by more than 1.5e-4 (5e-4 with
/// d). The table is compared with the law at other pressures and refined until it is within 2.5e-4.
///
/// Reference   Schumaker, SIAM J. Numer. Anal. 20 (1983) 853; Fritsch, Butland, SIAM J. Sci. Stat. Comput. 5 (1984) 300
/// Units       SI
/// Valid       K > 0, separations that fall as the pressure rises
/// Accuracy    2.5 times the largest relative error of K, p and d (over the rms height) of the last comparison, kept in
///             the tables: 1e-3 or less for every law of a map (tests/tabulated/kinked_law_test.cpp)

#include <fstiff/core/error.hpp>
#include <fstiff/tabulated/law_tables.hpp>

#include <functional>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// The state of a law at one pressure.
template <Real T>
struct LawPoint {
    T separation{};  ///< [m]
    T stiffness{};   ///< K [Pa/m]
};

template <Real T>
class KinkedTabulator {
public:
    /// The state at a pressure; the separation is left out where the second argument is false.
    using Law = std::function<LawPoint<T>(T pressure, bool with_separation)>;

    /// \p ratio: K over -dp/dd; 0 where that is no constant.
    KinkedTabulator(Law law, T ratio, T rms_height) : law_(std::move(law)), ratio_(ratio), rms_(rms_height) {}

    /// The table of a smooth K, at nodes 1/20 of p apart and without a separation of the law: that of the greatest
    /// pressure is 0. \p own is another K than that, whose slope is p then; none: ratio times it. A tenth of the
    /// evaluations of tabulate(). \throws domain_error as it.
    [[nodiscard]] LawTables<T> tabulate_evenly(T min_pressure, T max_pressure,
                                               const std::function<T(T pressure)>& own) {
        constexpr T width = T(0.05);
        const T first = std::log(min_pressure), length = std::log(max_pressure) - first;
        const int intervals = (std::max)(2, static_cast<int>(std::ceil(length / width)));
        const auto at = [&](T place) { return std::exp(first + length * place / T(intervals)); };
        nodes_.push_back(node(min_pressure, false));
        for (int i = 1; i < intervals; ++i) nodes_.push_back(node(at(T(i)), false));
        nodes_.push_back(node(max_pressure, false));
        std::vector<Parabola<T>> pieces = integrated();
        const T last = pieces.back().separation;
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            Parabola<T>& piece = pieces[i];
            piece.separation -= last;
            if (!own) continue;
            piece.stiffness = own(piece.pressure);
            piece.stiffness_per_fall = 0;
            if (i > 0)
                pieces[i - 1].stiffness_per_fall =
                    (piece.stiffness - pieces[i - 1].stiffness) / (pieces[i - 1].separation - piece.separation);
        }
        LawTables<T> tables;
        tables.min_pressure = min_pressure, tables.max_pressure = max_pressure;
        tables.stiffness_over_slope = own ? T(0) : ratio_;
        tables.kinked = KinkedTables<T>(std::move(pieces));
        T worst = 0;
        for (int i = 0; i < intervals; ++i) {
            const Node middle = node(at(T(i) + T(0.5)), false);
            const auto found = tables.kinked.at_pressure(middle.pressure);
            worst = (std::max)(worst, std::abs(found.slope * ratio_ / middle.stiffness - 1));
            if (own) worst = (std::max)(worst, std::abs(found.stiffness / own(middle.pressure) - 1));
        }
        tables.relative_error = worst + 64 * epsilon;
        tables.evaluations = evaluations_;
        return tables;
    }

    /// \throws domain_error as the law, for K that is not greater than 0, and for separations that do not fall.
    [[nodiscard]] LawTables<T> tabulate(T min_pressure, T max_pressure) {
        first_nodes(min_pressure, max_pressure);
        LawTables<T> tables;
        tables.min_pressure = min_pressure, tables.max_pressure = max_pressure;
        tables.stiffness_over_slope = ratio_;
        for (int round = 0; round < 24; ++round) {
            tables.kinked = KinkedTables<T>(has_own_stiffness() ? through_nodes() : integrated());
            std::vector<Node> missed;
            tables.relative_error = T(2.5) * measure(tables.kinked, round, missed) + 64 * epsilon;
            if (missed.empty() || evaluations_ > most_evaluations) break;
            add(missed);
        }
        tables.evaluations = evaluations_;
        return tables;
    }

private:
    static constexpr T epsilon = std::numeric_limits<T>::epsilon();
    static constexpr T tolerance = T(1.5e-4), tolerance_of_own = T(5e-4), missed_by = T(2.5e-4);
    static constexpr int most_evaluations = 30000;  ///< or so: a law with steps would be refined for ever
    static constexpr T widest = T(0.25), narrowest = T(1e-6), width_of_piece = T(0.025);  ///< of ln p

    struct Node {
        T pressure, log_p, separation, stiffness, log_k;
    };

    [[nodiscard]] bool has_own_stiffness() const { return ratio_ == T(0); }

    [[nodiscard]] Node node(T pressure, bool with_separation) {
        ++evaluations_;
        const LawPoint<T> point = law_(pressure, with_separation || has_own_stiffness());
        require(point.stiffness > 0 && std::isfinite(point.stiffness), "stiffness", point.stiffness,
                "finite and greater than 0 for a tabulated law");
        return {pressure, std::log(pressure), point.separation, point.stiffness, std::log(point.stiffness)};
    }

    void first_nodes(T min_pressure, T max_pressure) {
        const Node first = node(min_pressure, true), last = node(max_pressure, false);
        const T length = last.log_p - first.log_p;
        const int intervals = (std::max)(1, static_cast<int>(std::ceil(length / widest)));
        nodes_.push_back(first);
        for (int i = 1; i < intervals; ++i)
            nodes_.push_back(node(std::exp(first.log_p + length * T(i) / T(intervals)), false));
        nodes_.push_back(last);
        for (int i = 0; i < intervals; ++i)
            refine(nodes_[static_cast<std::size_t>(i)], nodes_[static_cast<std::size_t>(i) + 1]);
        sort();
    }
    void sort() {
        std::sort(nodes_.begin(), nodes_.end(), [](const Node& a, const Node& b) { return a.pressure < b.pressure; });
        nodes_.erase(std::unique(nodes_.begin(), nodes_.end(),
                                 [](const Node& a, const Node& b) { return a.pressure == b.pressure; }),
                     nodes_.end());
    }

    /// Distance of \p node from the straight lines from \p a to \p b.
    [[nodiscard]] T misfit(const Node& a, const Node& b, const Node& node) const {
        const T v = (node.log_p - a.log_p) / (b.log_p - a.log_p);
        const T of_k = std::abs(node.log_k - a.log_k - v * (b.log_k - a.log_k));
        if (!has_own_stiffness()) return of_k;
        const T fall = a.separation - b.separation;
        return (std::max)(of_k, std::abs((a.separation - node.separation) / fall - v) * (b.log_p - a.log_p));
    }
    void refine(const Node a, const Node b) {
        if (evaluations_ > most_evaluations || b.log_p - a.log_p < (std::max)(narrowest, 100 * epsilon)) return;
        const Node low = node(std::exp(a.log_p + T(0.31) * (b.log_p - a.log_p)), false);
        const Node high = node(std::exp(a.log_p + T(0.72) * (b.log_p - a.log_p)), false);
        nodes_.push_back(low);
        nodes_.push_back(high);
        if ((std::max)(misfit(a, b, low), misfit(a, b, high)) <= (has_own_stiffness() ? tolerance_of_own : tolerance))
            return;
        refine(a, low);
        refine(low, high);
        refine(high, b);
    }
    void add(const std::vector<Node>& missed) {
        const std::vector<Node> nodes = nodes_;
        for (const Node& node : missed) {
            const auto above = std::upper_bound(nodes.begin() + 1, nodes.end() - 1, node.pressure,
                                                [](T p, const Node& next) { return p < next.pressure; });
            nodes_.push_back(node);
            refine(*(above - 1), node);
            refine(node, *above);
        }
        sort();
    }

    [[nodiscard]] std::vector<Parabola<T>> integrated() const {
        std::vector<Parabola<T>> pieces;
        T separation = nodes_.front().separation;
        for (std::size_t i = 0; i + 1 < nodes_.size(); ++i) {
            const Node &a = nodes_[i], &b = nodes_[i + 1];
            const int parts = (std::max)(1, static_cast<int>(std::ceil((b.log_p - a.log_p) / width_of_piece)));
            T p = a.pressure, k = a.stiffness;
            for (int part = 1; part <= parts; ++part) {
                const T v = T(part) / T(parts);
                const T next_p = part == parts ? b.pressure : std::exp(a.log_p + v * (b.log_p - a.log_p));
                const T next_k = part == parts ? b.stiffness : std::exp(a.log_k + v * (b.log_k - a.log_k));
                const T fall = 2 * ratio_ * (next_p - p) / (k + next_k), per_fall = (next_k - k) / fall;
                pieces.push_back({separation, p, k / ratio_, per_fall / ratio_, k, per_fall});
                separation -= fall, p = next_p, k = next_k;
            }
        }
        pieces.push_back(
            {separation, nodes_.back().pressure, nodes_.back().stiffness / ratio_, 0, nodes_.back().stiffness, 0});
        return pieces;
    }

    /// -dp/dd from \p a to \p b.
    [[nodiscard]] static T chord(const Node& a, const Node& b) {
        if (!(a.separation > b.separation))
            detail::refuse("pressure range", a.pressure, "where the separation falls as the pressure rises (Pa)");
        return (b.pressure - a.pressure) / (a.separation - b.separation);
    }
    [[nodiscard]] std::vector<T> slopes() const {
        std::vector<T> result{chord(nodes_[0], nodes_[1])};
        for (std::size_t i = 1; i + 1 < nodes_.size(); ++i) {
            const Node &a = nodes_[i - 1], &b = nodes_[i], &c = nodes_[i + 1];
            const T left = chord(a, b), right = chord(b, c), h = a.separation - c.separation;
            const T of_left = (h + b.separation - c.separation) / (3 * h);
            const T mean = 1 / (of_left / left + (1 - of_left) / right);
            result.push_back((std::min)(mean, T(1.8) * (std::min)(left, right)));
        }
        result.push_back(chord(nodes_[nodes_.size() - 2], nodes_.back()));
        return result;
    }
    [[nodiscard]] std::vector<Parabola<T>> through_nodes() const {
        const std::vector<T> slope = slopes();
        std::vector<Parabola<T>> pieces;
        for (std::size_t i = 0; i + 1 < nodes_.size(); ++i) {
            const Node &a = nodes_[i], &b = nodes_[i + 1];
            const T half = (a.separation - b.separation) / 2, s = 2 * chord(a, b) - (slope[i] + slope[i + 1]) / 2;
            const T p = a.pressure + half * (slope[i] + s) / 2, v = (std::log(p) - a.log_p) / (b.log_p - a.log_p);
            const T k = std::exp(a.log_k + v * (b.log_k - a.log_k));
            pieces.push_back(
                {a.separation, a.pressure, slope[i], (s - slope[i]) / half, a.stiffness, (k - a.stiffness) / half});
            pieces.push_back({a.separation - half, p, s, (slope[i + 1] - s) / half, k, (b.stiffness - k) / half});
        }
        const Node& last = nodes_.back();
        pieces.push_back({last.separation, last.pressure, slope.back(), 0, last.stiffness, 0});
        return pieces;
    }

    /// The largest error at pressures that \p round has not compared before, and the states where nodes are missing.
    [[nodiscard]] T measure(const KinkedTables<T>& table, int round, std::vector<Node>& missed) {
        const int checks = std::clamp(evaluations_ / 4, 40, 200);
        const T begin = nodes_.front().log_p, length = nodes_.back().log_p - begin;
        T worst = 0;
        for (int i = 0; i < checks; ++i) {
            const T place = T(0.6180339887) * T(i) + T(0.7548776662) * T(round) + T(0.1234);
            const T p = std::exp(begin + length * (place - std::floor(place)));
            if (!table.contains_pressure(p)) continue;
            const bool with_separation = has_own_stiffness() || i < 40;  // it may be a long integral
            const Node truth = node(p, with_separation);
            const auto at_p = table.at_pressure(p);
            const T of_k = std::abs(at_p.stiffness / truth.stiffness - 1);
            T of_p = 0, of_k_at_d = 0;
            if (with_separation) {
                const auto at_d = table.at_separation(std::clamp(truth.separation, table.closest(), table.furthest()));
                of_p = std::abs(at_d.pressure / p - 1);
                of_k_at_d = std::abs(at_d.stiffness / truth.stiffness - 1);
                worst = (std::max)(worst, std::abs(at_p.separation - truth.separation) / rms_);
            }
            worst = (std::max)({worst, of_k, of_p, of_k_at_d});
            if (of_k > missed_by || of_k_at_d > T(1.5) * missed_by || (has_own_stiffness() && of_p > missed_by))
                missed.push_back(truth);
        }
        return worst;
    }

    Law law_;
    T ratio_, rms_;
    int evaluations_ = 0;
    std::vector<Node> nodes_;  ///< by pressure
};

}}}  // namespace fstiff::detail
