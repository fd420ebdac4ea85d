// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// One step of a rough contact in friction: the drag of each of its levels, and its derivatives by the step.
///
///     levels x >= d, dragged by u(x) with |u| <= c (x - d), c = mu K_n/K_t; u is linear between nodes
///     v = u + s                                        trial: all levels move by s; new ones by their share of it
///     u = v where |v| <= c (x - d), else c (x - d) v/|v|, with a node where one turns into the other
///
/// Units       m; derivatives by d and by s
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

namespace detail {

template <Real T, int Directions>
class SlipPath {
public:
    using State = SlipState<T, Directions>;
    using Vector = Eigen::Matrix<T, Directions, 1>;
    using ByInputs = Eigen::Matrix<T, 1, Directions + 1>;  ///< derivatives by d and by s
    struct Point {
        T level;
        Vector drag;
        ByInputs level_by;
        Eigen::Matrix<T, Directions, Directions + 1> drag_by;
    };

    /// The path from \p before to \p separation and by \p slip. \p cone: c.
    SlipPath(const State& before, T separation, const Vector& slip, T cone) : separation_(separation), cone_(cone) {
        move(before, slip);
        for (int i = 0; i < tries_; ++i) {
            slide(tried_[i]);
            if (i == 0) points_[0].drag_by.col(0).setZero();  // the edge is not dragged wherever it goes
            i + 1 < tries_ ? between(tried_[i], tried_[i + 1]) : cross_beyond(tried_[i]);
        }
    }

    [[nodiscard]] const Point* begin() const { return points_; }
    [[nodiscard]] const Point* end() const { return points_ + count_; }

    /// Writes the nodes that are needed. If there are too many, those of the least weight by \p pressure go first.
    template <class Pressure>
    void remember(State& after, const Pressure& pressure) {
        drop_straight();
        while (count_ - 1 > State::capacity) drop_lightest(pressure);
        after.separation = separation_;
        after.count = count_ - 1;
        for (int i = 1; i < count_; ++i) {
            auto& node = after.nodes[static_cast<std::size_t>(i - 1)];
            node.level = points_[i].level;
            std::copy_n(points_[i].drag.data(), Directions, node.drag.data());
        }
    }

private:
    static constexpr int most_tried = State::capacity + 2;
    /// Number of points: of each tried one itself and two where its way to the next meets the cone, and some where that
    /// turns.
    static constexpr int most = 5 * most_tried, most_turned = most - 3 * most_tried;
    static constexpr T rounding = 64 * std::numeric_limits<T>::epsilon(), straight = 16 * rounding;

    /// The trial: where each level would be if none slipped.
    void move(const State& before, const Vector& slip) {
        bool begun = separation_ < before.separation;  // then the edge has just touched and is not dragged
        if (begun) begin(Vector::Zero(), Vector::Zero()).drag_by.setZero(), moved(before.separation, slip);
        typename State::Node from{.level = before.separation};
        for (int i = 0; i < before.count; ++i) {
            const auto& node = before.nodes[static_cast<std::size_t>(i)];
            if (node.level > separation_) {
                const Vector slope = (drag_of(node) - drag_of(from)) / (node.level - from.level);
                if (!begun) begin(drag_of(from) + slope * (separation_ - from.level) + slip, slope);
                begun = true;
                moved(node.level, drag_of(node) + slip);
            }
            from = node;
        }
        if (!begun) begin(drag_of(from) + slip, Vector::Zero());
    }
    /// The edge, at a place of the trial that rises with \p slope.
    Point& begin(const Vector& drag, const Vector& slope) {
        Point& edge = moved(separation_, drag);
        edge.level_by[0] = 1;
        edge.drag_by.col(0) = slope;
        return edge;
    }
    Point& moved(T level, const Vector& drag) {
        Point& point = tried_[tries_++];
        point.level = level, point.drag = drag;
        point.level_by.setZero();
        point.drag_by.col(0).setZero();
        point.drag_by.template rightCols<Directions>().setIdentity();
        return point;
    }
    [[nodiscard]] static Vector drag_of(const typename State::Node& node) {
        return Eigen::Map<const Vector>(node.drag.data());
    }
    [[nodiscard]] T bound(T level) const { return cone_ * (level - separation_); }
    [[nodiscard]] bool slips(const Point& tried) const {
        return tried.drag.norm() > bound(tried.level) * (1 + rounding);
    }
    Point& add(const Point& point) { return points_[count_++] = point; }

    /// \p tried, or the point of the cone below it.
    void slide(const Point& tried) {
        Point& point = add(tried);
        if (!slips(tried)) return;
        const T length = tried.drag.norm(), most_drag = bound(tried.level);
        const Vector along = tried.drag / length;
        ByInputs widening = cone_ * tried.level_by;
        widening[0] -= cone_;
        point.drag = most_drag * along;
        point.drag_by =
            most_drag / length * (tried.drag_by - along * (along.transpose() * tried.drag_by)) + along * widening;
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
        point.level = (std::min)(separation_ + last.drag.norm() / cone_, (std::numeric_limits<T>::max)());
        point.level_by.setZero();
        point.drag_by.col(0).setZero();
        meet_cone(point, Vector::Zero());
        add(point);
    }
    /// Derivatives of \p point, on the cone and on a trial that rises with \p slope, from those at constant level.
    void meet_cone(Point& point, const Vector& slope) const {
        const Vector along = point.drag.normalized();
        const T steeper = along.dot(slope) - cone_;
        if (!(std::abs(steeper) > rounding * cone_)) return;
        point.level_by = -along.transpose() * point.drag_by;
        point.level_by[0] -= cone_;
        point.level_by /= steeper;
        point.drag_by += slope * point.level_by;
    }

    /// Distance of point \p i from the line between \p before and the next one.
    [[nodiscard]] T bend(int before, int i) const {
        const Point &a = points_[before], &point = points_[i];
        if (i + 1 == count_) return (point.drag - a.drag).norm();
        const Point& b = points_[i + 1];
        const T length = b.level - a.level;
        if (!(length > 0)) return 0;
        return (point.drag - a.drag - (b.drag - a.drag) * ((point.level - a.level) / length)).norm();
    }
    void drop_straight() {
        int kept = 1;
        for (int i = 1; i < count_; ++i)
            if (points_[i].level > points_[kept - 1].level && bend(kept - 1, i) > straight * bound(points_[i].level))
                points_[kept++] = points_[i];  // far apart the cone is narrower than the rounding of its levels
        count_ = kept;
    }
    template <class Pressure>
    void drop_lightest(const Pressure& pressure) {
        int lightest = 1;
        T least = std::numeric_limits<T>::infinity();
        for (int i = 1; i < count_; ++i) {
            const T further = i + 1 < count_ ? pressure(points_[i + 1].level) : T(0);
            const T weight = bend(i - 1, i) * (pressure(points_[i - 1].level) - further);
            if (weight < least) least = weight, lightest = i;
        }
        std::move(points_ + lightest + 1, points_ + count_, points_ + lightest);
        --count_;
    }

    T separation_, cone_;
    int tries_ = 0, count_ = 0;
    Point tried_[std::size_t{most_tried}], points_[std::size_t{most}];
};

}  // namespace detail
}}  // namespace fstiff
