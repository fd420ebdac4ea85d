// SPDX-License-Identifier: BSD-3-Clause
#include "io/triangulation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fstiff::inline v0_1::io::detail {

namespace {

/// Twice the area of a, b, c; greater than 0 where they turn left.
std::int64_t turn(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
    return std::int64_t(a.x - c.x) * (b.y - c.y) - std::int64_t(a.y - c.y) * (b.x - c.x);
}

/// Whether the sum of the products of \p a and \p b, each below 2^54, is greater than 0: in parts of 27 bits.
bool is_positive(const std::array<std::int64_t, 3>& a, const std::array<std::int64_t, 3>& b) {
    constexpr std::int64_t part = std::int64_t(1) << 27;
    std::int64_t high = 0, middle = 0, low = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::int64_t a1 = a[i] >> 27, a0 = a[i] & (part - 1), b1 = b[i] >> 27, b0 = b[i] & (part - 1);
        high += a1 * b1;
        middle += a1 * b0 + a0 * b1;
        low += a0 * b0;
    }
    middle += low >> 27;
    high += middle >> 27;
    return high > 0 || (high == 0 && ((middle & (part - 1)) != 0 || (low & (part - 1)) != 0));
}

/// Whether \p d is inside of the circle through a, b, c, which turn left.
bool in_circle(const GridPoint& a, const GridPoint& b, const GridPoint& c, const GridPoint& d) {
    struct Offset {  // from d; whole numbers up to 2^26, whose squares and products are exact
        double x, y;
    };
    const auto offset = [&](const GridPoint& p) {
        return Offset{static_cast<double>(p.x - d.x), static_cast<double>(p.y - d.y)};
    };
    const Offset from_d[] = {offset(a), offset(b), offset(c)};
    std::array<double, 3> lift{}, minor{};  // at most 2^53
    double sum = 0, bound = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const Offset &p = from_d[i], &q = from_d[(i + 1) % 3], &r = from_d[(i + 2) % 3];
        lift[i] = p.x * p.x + p.y * p.y;
        minor[i] = q.x * r.y - q.y * r.x;
        const double term = lift[i] * minor[i];
        sum += term;
        bound += std::abs(term);
    }
    if (std::abs(sum) > 1e-15 * bound) return sum > 0;
    const auto whole = [](const std::array<double, 3>& numbers) {
        return std::array{static_cast<std::int64_t>(numbers[0]), static_cast<std::int64_t>(numbers[1]),
                          static_cast<std::int64_t>(numbers[2])};
    };
    return is_positive(whole(lift), whole(minor));
}

/// A point, and its place among those that were given.
struct Site : GridPoint {
    std::uint32_t index{};
};

/// The orders along x, then y; along y, then -x, which is the same after a quarter turn.
std::uint64_t order_x(const GridPoint& p) { return std::uint64_t(p.x) << 32 | std::uint64_t(p.y); }
std::uint64_t order_y(const GridPoint& p) { return std::uint64_t(p.y) << 32 | std::uint64_t(most_grid_position - p.x); }

/// Directed edges around their points; edge e and its reverse e ^ 1.
class Triangulator {
public:
    explicit Triangulator(const std::vector<GridPoint>& points) : spare_(points.size() + 1), keys_(points.size()) {
        sites_.reserve(points.size());
        for (const GridPoint& point : points) sites_.push_back({point, static_cast<std::uint32_t>(sites_.size())});
        const auto before = [](const Site& a, const Site& b) { return order_x(a) < order_x(b); };
        if (!std::is_sorted(sites_.begin(), sites_.end(), before)) std::sort(sites_.begin(), sites_.end(), before);
        edges_.reserve(6 * points.size());
    }

    std::vector<Triangle> triangles() {
        std::vector<Triangle> found;
        if (sites_.size() < 3) return found;
        divide(0, sites_.size(), false);
        found.reserve(2 * sites_.size());
        for (Edge e = 0; e < edges_.size(); ++e) {
            if (edges_[e].from == none) continue;
            const Edge f = left_next(e), g = left_next(f);
            if (e < f && e < g && left_next(g) == e && turn(from(e), from(f), from(g)) > 0)
                found.push_back({index(e), index(f), index(g)});
        }
        return found;
    }

private:
    using Edge = std::uint32_t;
    struct Links {
        std::uint32_t from{};  ///< of the sites; none of a deleted edge
        Edge next{}, last{};   ///< counterclockwise and clockwise around it
    };
    /// Edges of a hull: counterclockwise out of its first point, clockwise out of its last one.
    struct Hull {
        Edge first, last;
    };

    const GridPoint& from(Edge e) const { return sites_[edges_[e].from]; }
    std::uint32_t index(Edge e) const { return sites_[edges_[e].from].index; }
    const GridPoint& to(Edge e) const { return from(e ^ 1); }
    Edge next(Edge e) const { return edges_[e].next; }
    Edge last(Edge e) const { return edges_[e].last; }
    Edge left_next(Edge e) const { return last(e ^ 1); }
    Edge right_next(Edge e) const { return next(e ^ 1); }
    bool is_left(const GridPoint& p, Edge e) const { return turn(p, from(e), to(e)) > 0; }
    bool is_right(const GridPoint& p, Edge e) const { return turn(p, to(e), from(e)) > 0; }

    Edge make(std::uint32_t from, std::uint32_t to) {
        Edge e = free_;
        if (e == none) {
            e = static_cast<Edge>(edges_.size());
            edges_.resize(edges_.size() + 2);
        } else {
            free_ = edges_[e].next;
        }
        edges_[e] = {from, e, e};
        edges_[e ^ 1] = {to, e ^ 1, e ^ 1};
        return e;
    }
    /// Joins or parts the rings of edges around the points of \p a and \p b.
    void splice(Edge a, Edge b) {
        std::swap(edges_[a].next, edges_[b].next);
        edges_[next(a)].last = a;
        edges_[next(b)].last = b;
    }
    /// A new edge from the end of \p a to the start of \p b, with one left face.
    Edge connect(Edge a, Edge b) {
        const Edge e = make(edges_[a ^ 1].from, edges_[b].from);
        splice(e, left_next(a));
        splice(e ^ 1, b);
        return e;
    }
    void remove(Edge e) {
        splice(e, last(e));
        splice(e ^ 1, last(e ^ 1));
        edges_[e].from = edges_[e ^ 1].from = none;
        const Edge even = e & ~Edge(1);
        edges_[even].next = free_;
        free_ = even;
    }

    /// Triangulates the sites from \p begin to \p end, which are in the order of x, halved along \p along_y. Sites that
    /// are near one another end up so in memory.
    Hull divide(std::size_t begin, std::size_t end, bool along_y) {
        if (end - begin <= 3) {
            if (along_y)
                std::sort(&sites_[begin], sites_.data() + end,
                          [](const Site& a, const Site& b) { return order_y(a) < order_y(b); });
            return few(begin, end);
        }
        const std::size_t middle = begin + (end - begin) / 2;
        if (along_y) part(begin, middle, end);
        Hull low = divide(begin, middle, !along_y), high = divide(middle, end, !along_y);
        low = turned(low, along_y), high = turned(high, along_y);
        return merge(low, high);
    }

    /// Moves the sites that are first along y before \p middle; both parts stay in the order of x.
    void part(std::size_t begin, std::size_t middle, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) keys_[i] = order_y(sites_[i]);
        std::nth_element(&keys_[begin], &keys_[middle], keys_.data() + end);
        std::size_t low = begin, high = middle;
        for (std::size_t i = begin; i < end; ++i) {  // without branches, which would be random
            const Site site = sites_[i];
            const bool is_low = order_y(site) < keys_[middle];
            sites_[low] = spare_[high] = site;
            low += is_low, high += !is_low;
        }
        std::copy_n(&spare_[middle], end - middle, &sites_[middle]);
    }

    Hull few(std::size_t begin, std::size_t end) {
        const auto site = static_cast<std::uint32_t>(begin);
        const Edge a = make(site, site + 1);
        if (end - begin == 2) return {a, a ^ 1};
        const Edge b = make(site + 1, site + 2);
        splice(a ^ 1, b);
        const std::int64_t side = turn(from(a), from(b), to(b));
        if (side == 0) return {a, b ^ 1};
        const Edge c = connect(b, a);
        return side > 0 ? Hull{a, b ^ 1} : Hull{c ^ 1, c};
    }

    /// The edges of the same hull at its first and last points along \p along_y.
    Hull turned(const Hull& hull, bool along_y) const {
        const auto order = [&](const GridPoint& p) { return along_y ? order_y(p) : order_x(p); };
        Hull found{hull.first, hull.first ^ 1};
        Edge e = hull.first;
        do {
            if (order(from(e)) < order(from(found.first))) found.first = e;
            if (order(from(found.last)) < order(to(e))) found.last = e ^ 1;
            e = right_next(e);
        } while (e != hull.first);
        return found;
    }

    Hull merge(const Hull& low, const Hull& high) {
        Edge first = low.first, last_edge = high.last, left = low.last, right = high.first;
        while (true) {  // down to the lower common tangent
            if (is_left(from(right), left))
                left = left_next(left);
            else if (is_right(from(left), right))
                right = right_next(right);
            else
                break;
        }
        Edge base = connect(right ^ 1, left);
        if (edges_[left].from == edges_[first].from) first = base ^ 1;
        if (edges_[right].from == edges_[last_edge].from) last_edge = base;
        while (true) {  // upwards, one edge between both parts after another
            const auto is_above = [&](Edge e) { return is_right(to(e), base); };
            Edge low_side = next(base ^ 1), high_side = last(base);
            if (is_above(low_side))
                while (in_circle(to(base), from(base), to(low_side), to(next(low_side))))
                    remove(std::exchange(low_side, next(low_side)));
            if (is_above(high_side))
                while (in_circle(to(base), from(base), to(high_side), to(last(high_side))))
                    remove(std::exchange(high_side, last(high_side)));
            const bool low_above = is_above(low_side), high_above = is_above(high_side);
            if (!low_above && !high_above) break;
            base = !low_above || (high_above && in_circle(to(low_side), from(low_side), from(high_side), to(high_side)))
                       ? connect(high_side, base ^ 1)
                       : connect(base ^ 1, low_side ^ 1);
        }
        return {first, last_edge};
    }

    static constexpr Edge none = ~Edge(0);
    std::vector<Site> sites_, spare_;
    std::vector<std::uint64_t> keys_;
    std::vector<Links> edges_;
    Edge free_ = none;
};

}  // namespace

std::vector<Triangle> delaunay(const std::vector<GridPoint>& points) { return Triangulator(points).triangles(); }

}  // namespace fstiff::inline v0_1::io::detail
