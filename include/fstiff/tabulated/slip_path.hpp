// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// One step of a rough contact in friction: the drag of each of its levels, and its derivatives by what moves it.
///
///     levels x >= d, dragged by u(x) with |u| <= c (x - d), c = mu K_n/K_t; u is linear between nodes
///     v = u + s                                        trial: all levels move by s; new ones by their share of it
///     u = v where |v| <= c (x - d), else c (x - d) v/|v|, with a node where one turns into the other
///
/// Units       m; derivatives by any numbers: those of d, s and of the drag before the step come with it
/// Valid       as tabulated/tangential_law, which uses it
/// Accuracy    rounding; u is exact between nodes while its direction is constant there

#include <fstiff/core/numbers.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace fstiff { inline namespace v0_1 {

/// Memory of the slip of a contact: the levels that are dragged, and by how much. \p Directions is 1 for a plane
/// model and 2 for a body. Plain numbers: copy it, and keep it with the other variables of a step.
template <Real T = double, int Directions = 2>
struct SlipState {
    static constexpr int capacity = 16;  ///< of nodes; of more, those go that change the traction least
    /// Drag of one level.
    struct Node {
        T level{};                                      ///< x [m]
        std::array<T, std::size_t{Directions}> drag{};  ///< u [m]
    };

    T separation{};                                   ///< d [m], where the drag is 0
    int count = 0;                                    ///< of nodes
    std::array<Node, std::size_t{capacity}> nodes{};  ///< from the closest on; beyond the last the drag is constant
};

/// Derivatives of a SlipState by \p Columns numbers, which the whole motion depends on.
template <Real T = double, int Directions = 2, int Columns = Directions + 1>
struct SlipDerivatives {
    using Level = Eigen::Matrix<T, 1, Columns>;
    using Drag = Eigen::Matrix<T, Directions, Columns>;
    /// Of one node.
    struct Node {
        Level level = Level::Zero();
        Drag drag = Drag::Zero();
    };

    Node edge{};  ///< of the separation, and of the drag next to it: not 0 where nothing slips
    std::array<Node, std::size_t{SlipState<T, Directions>::capacity}> nodes{};
};

namespace detail {

/// The numbers of a step, and their derivatives by \p Columns numbers.
template <Real T, int Directions, int Columns>
struct SlipStep {
    T separation;
    Eigen::Matrix<T, Directions, 1> slip;
    Eigen::Matrix<T, 1, Columns> separation_by;
    Eigen::Matrix<T, Directions, Columns> slip_by;
};

template <Real T, int Directions, int Columns>
class SlipPath {
public:
    using State = SlipState<T, Directions>;
    using StateBy = SlipDerivatives<T, Directions, Columns>;
    using Step = SlipStep<T, Directions, Columns>;
    using Vector = Eigen::Matrix<T, Directions, 1>;
    struct Point {
        T level;
        Vector drag;
        typename StateBy::Level level_by;
        typename StateBy::Drag drag_by;
        T pressure, slope;  ///< of the law at the level: p [Pa] and -dp/dd [Pa/m], by evaluate()
    };

    /// The path from \p before, whose derivatives are \p before_by, or 0 of null, by \p step. \p cone: c.
    SlipPath(const State& before, const StateBy* before_by, const Step& step, T cone) : step_(step), cone_(cone) {
        move(before, before_by);
        for (int i = 0; i < tries_; ++i) {
            slide(tried_[i]);
            if (i == 0) hold_edge();
            if (i + 1 == tries_)
                cross_beyond(tried_[i]);
            else if (!(sticks(tried_[i]) && sticks(tried_[i + 1])))  // else all between do: the cone is convex
                between(tried_[i], tried_[i + 1]);
        }
    }

    [[nodiscard]] const Point* begin() const { return points_; }
    [[nodiscard]] const Point* end() const { return points_ + count_; }

    /// p and -dp/dd of each point by \p tangent of its level, which returns the two.
    template <class Tangent>
    void evaluate(const Tangent& tangent) {
        for (int i = 0; i < count_; ++i) {
            const auto [pressure, slope] = tangent(points_[i].level);
            points_[i].pressure = pressure, points_[i].slope = slope;
        }
    }

    /// Writes the nodes that are needed, after evaluate(). If there are too many, those of the least weight go first.
    /// \p after_by takes their derivatives; null: they are not asked for.
    void remember(State& after, StateBy* after_by) {
        keep_bends(after_by);
        keep_heaviest(after_by);
        after.separation = step_.separation;
        after.count = kept_count_ - 1;
        if (after_by) after_by->edge = {step_.separation_by, points_[0].drag_by};
        for (int i = 1; i < kept_count_; ++i) {
            const auto k = static_cast<std::size_t>(i - 1);
            const Point& point = points_[kept_[i]];
            after.nodes[k].level = point.level;
            std::copy_n(point.drag.data(), Directions, after.nodes[k].drag.data());
            if (after_by) after_by->nodes[k] = {point.level_by, point.drag_by};
        }
    }

private:
    static constexpr int most_tried = State::capacity + 2;
    /// Number of points: of each tried one itself and two where its way to the next meets the cone, and some where that
    /// turns.
    static constexpr int most = 5 * most_tried, most_turned = most - 3 * most_tried;
    static constexpr T rounding = 64 * std::numeric_limits<T>::epsilon(), straight = 16 * rounding;

    /// A point of the memory.
    struct Kept {
        T level;
        Vector drag;
        typename StateBy::Node by;
    };

    /// The trial: where each level would be if none slipped.
    void move(const State& before, const StateBy* by) {
        const T separation = step_.separation;
        Kept from{before.separation, Vector::Zero(), by ? by->edge : typename StateBy::Node{}};
        bool begun = separation < before.separation;  // then the edge has just touched and is not dragged
        if (begun) begin(Vector::Zero(), Vector::Zero()).drag_by.setZero(), moved(from);
        for (int i = 0; i < before.count; ++i) {
            const auto k = static_cast<std::size_t>(i);
            const Kept node{before.nodes[k].level, Eigen::Map<const Vector>(before.nodes[k].drag.data()),
                            by ? by->nodes[k] : typename StateBy::Node{}};
            if (node.level > separation) {
                if (!begun) begin_between(from, node);
                begun = true;
                moved(node);
            }
            from = node;
        }
        if (!begun) begin(from.drag + step_.slip, Vector::Zero()).drag_by = from.by.drag + step_.slip_by;
    }
    /// The edge, at a place of the trial that rises with \p slope.
    Point& begin(const Vector& drag, const Vector& slope) {
        Point& edge = tried_[tries_++];
        edge.level = step_.separation, edge.drag = drag;
        edge.level_by = step_.separation_by;
        edge_slope_ = slope;
        return edge;
    }
    void begin_between(const Kept& a, const Kept& b) {
        const T t = (step_.separation - a.level) / (b.level - a.level);
        const Vector rise = b.drag - a.drag, slope = rise / (b.level - a.level);
        begin(a.drag + t * rise + step_.slip, slope).drag_by = (1 - t) * (a.by.drag - slope * a.by.level) +
                                                               t * (b.by.drag - slope * b.by.level) + step_.slip_by +
                                                               slope * step_.separation_by;
    }
    void moved(const Kept& node) {
        Point& point = tried_[tries_++];
        point.level = node.level, point.drag = node.drag + step_.slip;
        point.level_by = node.by.level, point.drag_by = node.by.drag + step_.slip_by;
    }
    [[nodiscard]] T bound(T level) const { return cone_ * (level - step_.separation); }
    [[nodiscard]] bool slips(const Point& tried) const {
        return tried.drag.norm() > bound(tried.level) * (1 + rounding);
    }
    /// Well within the cone.
    [[nodiscard]] bool sticks(const Point& tried) const {
        return tried.drag.norm() < bound(tried.level) * (1 - 4 * straight);
    }
    Point& add(const Point& point) { return points_[count_++] = point; }

    /// \p tried, or the point of the cone below it.
    void slide(const Point& tried) {
        Point& point = add(tried);
        if (!slips(tried)) return;
        const T length = tried.drag.norm(), most_drag = bound(tried.level);
        const Vector along = tried.drag / length;
        point.drag = most_drag * along;
        const typename StateBy::Level by_length = along.transpose() * tried.drag_by;
        point.drag_by = most_drag / length * (tried.drag_by - along * by_length);
        point.drag_by += along * (cone_ * (tried.level_by - step_.separation_by));
    }
    /// The edge is not dragged wherever it goes: what is left are levels next to it where nothing slips.
    void hold_edge() {
        Point& edge = points_[0];
        if (slips(tried_[0]))
            edge.drag_by.setZero();
        else
            edge.drag_by -= edge_slope_ * step_.separation_by;
    }
    /// Points between \p a and \p b: where the trial leaves or enters the cone, and others where it slips and turns.
    void between(const Point& a, const Point& b) {
        const T length = b.level - a.level;
        const Vector rise = b.drag - a.drag;
        const T widening = cone_ * length, before = bound(a.level);
        // |a.drag + t rise|^2 = (before + t widening)^2
        const T square = rise.squaredNorm() - widening * widening, half = a.drag.dot(rise) - before * widening,
                rest = a.drag.squaredNorm() - before * before, root = half * half - square * rest;
        T first = -1, second = -1;
        if (root > 0) {
            const T q = -(half + std::copysign(std::sqrt(root), half));
            second = rest / q;
            if (square != 0) first = q / square;  // else the way is as steep as the cone
            if (second < first) std::swap(first, second);
        }
        Point from = a;
        for (const T t : {first, second})
            if (t > -straight && t < 1 + straight) {  // at an end too: a loop that closes there has slid up to it
                Point to = tried_at(a, b, std::clamp(t, T(0), T(1)));
                meet_cone(to, rise / length);
                turn(from, to, a, b);
                from = add(to);
            }
        turn(from, b, a, b);
    }
    /// The trial at the part \p t of the way from \p a to \p b, with its derivatives at constant level.
    [[nodiscard]] static Point tried_at(const Point& a, const Point& b, T t) {
        const Vector slope = (b.drag - a.drag) / (b.level - a.level);
        Point point;
        point.level = a.level + t * (b.level - a.level), point.drag = a.drag + t * (b.drag - a.drag);
        point.level_by.setZero();
        point.drag_by = (1 - t) * (a.drag_by - slope * a.level_by) + t * (b.drag_by - slope * b.level_by);
        return point;
    }
    /// Points between \p from and \p to, on the way from \p a to \p b, where the trial slips and turns.
    void turn(const Point& from, const Point& to, const Point& a, const Point& b) {
        if constexpr (Directions > 1) {
            constexpr T angle = T(0.15);
            const T lengths = from.drag.norm() * to.drag.norm();
            const T cosine = lengths > 0 ? from.drag.dot(to.drag) / lengths : T(1);
            if (!(cosine < 1 - angle * angle / 2)) return;
            const T middle = (from.level + to.level) / 2;
            if (!slips(tried_at(a, b, (middle - a.level) / (b.level - a.level)))) return;
            const int parts = static_cast<int>(std::acos((std::max)(cosine, T(-1))) / angle) + 1;
            for (int i = 1; i < parts && count_ < most_turned; ++i) {
                const T share = T(i) / T(parts), level = from.level + share * (to.level - from.level);
                Point point = tried_at(a, b, (level - a.level) / (b.level - a.level));
                point.level_by = (1 - share) * from.level_by + share * to.level_by;
                point.drag_by += (b.drag - a.drag) / (b.level - a.level) * point.level_by;
                slide(point);
            }
        }
    }
    /// The place where the trial meets the cone beyond the last point, from which on all levels are dragged alike.
    void cross_beyond(const Point& last) {
        if (!slips(last)) return;
        Point point = last;
        point.level = (std::min)(step_.separation + last.drag.norm() / cone_, (std::numeric_limits<T>::max)());
        point.level_by.setZero();
        meet_cone(point, Vector::Zero());
        add(point);
    }
    /// Derivatives of \p point, on the cone and on a trial that rises with \p slope, from those at constant level.
    void meet_cone(Point& point, const Vector& slope) const {
        const Vector along = point.drag.normalized();
        const T steeper = along.dot(slope) - cone_;
        if (!(std::abs(steeper) > rounding * cone_)) return;
        point.level_by = (-along.transpose() * point.drag_by - cone_ * step_.separation_by) / steeper;
        point.drag_by += slope * point.level_by;
    }

    /// How far a point is from the line between two others: the drag, and its derivatives.
    struct Bend {
        T drag, by;
    };
    /// Of point \p i, between \p before and \p after; past the last point, null, the drag is constant.
    [[nodiscard]] Bend bend(const Point& a, const Point& point, const Point* after, bool with_derivatives) const {
        const T length = after ? after->level - a.level : T(0);
        if (after && !(length > 0)) return {};
        const T t = after ? (point.level - a.level) / length : T(0);
        const Vector rise = after ? Vector(after->drag - a.drag) : Vector(Vector::Zero());
        Bend found{(point.drag - a.drag - t * rise).norm(), 0};
        if (!with_derivatives) return found;
        const Vector slope = after ? Vector(rise / length) : rise;
        const auto still = [&slope](const Point& at) { return (at.drag_by - slope * at.level_by).eval(); };
        auto off = (still(point) - (1 - t) * still(a)).eval();
        if (after) off -= t * still(*after);
        found.by = off.norm();
        return found;
    }
    /// The points that the memory needs, in `kept_`.
    void keep_bends(bool with_derivatives) {
        T scale{};
        for (int i = 0; with_derivatives && i < count_; ++i) scale = (std::max)(scale, points_[i].drag_by.norm());
        kept_count_ = 0;
        kept_[kept_count_++] = 0;
        for (int i = 1; i < count_; ++i) {
            const Point &last = points_[kept_[kept_count_ - 1]], &point = points_[i];
            if (!(point.level > last.level)) continue;
            const Bend off = bend(last, point, i + 1 < count_ ? &points_[i + 1] : nullptr, with_derivatives);
            if (off.drag > straight * bound(point.level) || off.by > straight * scale)
                kept_[kept_count_++] = i;  // far apart the cone is narrower than the rounding of its levels
        }
    }
    /// Lets those go that change the traction least, until there is room.
    void keep_heaviest(bool with_derivatives) {
        if (kept_count_ - 1 <= State::capacity) return;
        Bend weights[std::size_t{most}];
        const auto weigh = [&](int i) {
            const Point &a = points_[kept_[i - 1]], &point = points_[kept_[i]];
            const Point* after = i + 1 < kept_count_ ? &points_[kept_[i + 1]] : nullptr;
            const Bend off = bend(a, point, after, with_derivatives);
            const T load = a.pressure - (after ? after->pressure : T(0));
            weights[i] = {off.drag > straight * bound(point.level) ? off.drag * load : T(0), off.by * load};
        };
        for (int i = 1; i < kept_count_; ++i) weigh(i);
        while (kept_count_ - 1 > State::capacity) {
            int lightest = 1;
            for (int i = 2; i < kept_count_; ++i)
                if (weights[i].drag < weights[lightest].drag ||
                    (weights[i].drag == weights[lightest].drag && weights[i].by < weights[lightest].by))
                    lightest = i;
            std::copy(kept_ + lightest + 1, kept_ + kept_count_, kept_ + lightest);
            std::copy(weights + lightest + 1, weights + kept_count_, weights + lightest);
            --kept_count_;
            if (lightest > 1) weigh(lightest - 1);
            if (lightest < kept_count_) weigh(lightest);
        }
    }

    Step step_;
    T cone_;
    Vector edge_slope_;
    int tries_ = 0, count_ = 0, kept_count_ = 0;
    int kept_[std::size_t{most}];
    Point tried_[std::size_t{most_tried}], points_[std::size_t{most}];
};

}  // namespace detail
}}  // namespace fstiff
