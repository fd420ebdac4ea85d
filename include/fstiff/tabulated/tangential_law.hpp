// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Friction of a rough contact: tangential traction, microslip and loss, from the normal law and one coefficient.
///
///     q = mu [p(d) - p(d*)],   d* = d + k s/mu,   k = K_t/K_n     first displacement s, at constant d
///     dq/ds = k K(d*)                                             k K(d) at s = 0; full slip q = mu p as d* grows
///     W = (4 mu^2/k) [(p + p*) D - 2 (E - E*)],   D = d* - d       lost in a cycle between -s and s; E: energy of d
///     q = k sum (u_b - u_a)/(x_b - x_a) [p(x_a) - p(x_b)]         any history: level x is dragged by u (slip_path.hpp)
///
/// Reference   Jaeger, Arch. Appl. Mech. 65 (1995) 478; Ciavarella, J. Appl. Mech. 65 (1998) 998; levels as
///             springs: Popov, Hess (2015), ch. 5; derivation: docs/theory-applications.md, section 13
/// Units       d, s [m], p, q [Pa], E, W [J/m^2], tangents [Pa/m]
/// Valid       bodies of like elastic constants, Coulomb friction, a law whose K is -dp/dd: no peaks that yield
/// Accuracy    that of the law, and 1e-15 mu p on straight paths (tests/tabulated/tangential_law_test.cpp, which also
///             measures the error of paths that turn in a plane)
/// Threads     as ContactLaw; a state belongs to whoever holds it. No call allocates

#include <fstiff/core/error.hpp>
#include <fstiff/core/numbers.hpp>
#include <fstiff/tabulated/contact_law.hpp>
#include <fstiff/tabulated/slip_path.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

// Microslip and loss at one pressure, without a table of the law: from p, K and the fall of K with p.
//
//     x = k K s/(mu p)                        tangential displacement s over what slips, k = K_t/K
//     q = mu p (1 - P),  dq/ds = -k K P'       P(x): the load left when the contact is parted by x p/K, over p
//     W = (4 mu^2 p^2/(k K)) [(1 + P) x - 2 I],  I: integral of P from 0 to x;  loss factor W/(pi q s)
//     K ~ p^m below p     P = [1 - (1 - m) x]^(1/(1-m));  m = 1/3 one sphere, 1 far from both ends of the load
//     yielded contacts    P = (2/pi) [acos y - y sqrt(1 - y^2)],  y = pi x/4: equal ones, under the hardness all over
//
// Reference   tabulated/tangential_law.hpp; P of a yielded contact: Popov, Hess, Method of Dimensionality Reduction
//             (2015), ch. 2; derivation: docs/theory-applications.md, section 13
// Units       dimensionless
// Valid       x >= 0, 0 <= m < 2; beyond full slip P = 0. Like bodies, Coulomb friction
// Accuracy    1e-13; with m between 0.6 p and p the loss factor of three laws is within 3 % of that of the law itself,
//             x from 0.01 to 1, 0.1 to 100 MPa (tests/tabulated/microslip_test.cpp)

namespace fstiff { inline namespace v0_1 { namespace detail {

/// K ~ p^growth while the contact opens.
template <Real T>
struct PowerUnloading {
    T growth;

    [[nodiscard]] T load(T x) const { return std::exp(log_load(x)); }
    [[nodiscard]] T work(T x) const { return -std::expm1((2 - growth) * log_load(x)) / (2 - growth); }
    [[nodiscard]] T bend(T x) const { return growth * std::exp((2 * growth - 1) * log_load(x)); }

private:
    [[nodiscard]] T log_load(T x) const {
        const T rest = 1 - growth;
        return std::abs(rest) < T(1e-8) ? -x : std::log1p(-(std::min)(rest * x, T(1))) / rest;
    }
};

/// Equal circular contacts that yielded under one pressure. They lose far less than elastic ones while little slips, as
/// x^2 against x. Neighbours of other sizes and elastic contacts between them lose more: faces that yielded are between
/// the two, for x >= 0.3 within a factor of 2 of their geometric mean (boundary elements:
/// tests/halfspace/unloading_test.cpp).
template <Real T>
struct FlowedUnloading {
    [[nodiscard]] T load(T x) const {
        const T y = part(x);
        return 2 / pi * (std::acos(y) - y * std::sqrt(1 - y * y));
    }
    [[nodiscard]] T work(T x) const {
        const T y = part(x), root = std::sqrt(1 - y * y);
        return 8 / (pi * pi) * (y * std::acos(y) - root + 1 - (1 - root * root * root) / 3);
    }
    [[nodiscard]] T bend(T x) const {
        const T y = part(x);
        return y < 1 ? pi / 4 * y / std::sqrt(1 - y * y) : T(0);
    }

private:
    static constexpr T pi = std::numbers::pi_v<T>;
    [[nodiscard]] static T part(T x) { return (std::min)(pi / 4 * x, T(1)); }
};

/// Loss factor of a cycle between -x and x, \p x >= 0.
template <Real T, class Unloading>
[[nodiscard]] T loss_factor(const Unloading& contact, T x) {
    x = (std::min)(x, T(1e15));  // all slips long before
    const T load = contact.load(x);
    T excess = (1 + load) * x - 2 * contact.work(x);
    if (x < T(0.1)) {  // which cancels: the integral of t (x - t) P'' by four points of Gauss
        constexpr T abscissas[] = {T(0.86113631159405257522), T(0.33998104358485626480)},
                    weights[] = {T(0.34785484513745385737), T(0.65214515486254614263)};
        excess = 0;
        for (int i = 0; i < 2; ++i)
            for (const T side : {T(-1), T(1)}) {
                const T t = x / 2 * (1 + side * abscissas[i]);
                excess += x / 2 * weights[i] * t * (x - t) * contact.bend(t);
            }
    }
    const T slipped = (1 - load) * x;
    return slipped > 0 ? 4 / std::numbers::pi_v<T> * excess / slipped : T(0);
}

}}}  // namespace fstiff::detail

namespace fstiff { inline namespace v0_1 {

/// p, q and their derivatives under a separation and tangential displacements. Threads may share one.
///
///     const TangentialLaw<double> rough(law, 0.3, tangential_ratio(steel, steel));
///     SlipState<double, 2> before{.separation = d}, after;
///     const auto [p, q, tangent] = rough.step(before, d, {1e-7, 0}, after);     // when it is accepted: before = after
///
/// Paths that are straight from call to call are exact along a line. In a plane a path is exact while u keeps its
/// direction, and a return to the cone of friction where that turns.
template <Real T = double>
class TangentialLaw {
public:
    template <int Directions>
    using Vector = Eigen::Matrix<T, Directions, 1>;

    /// State and derivatives at the end of a step.
    template <int Directions>
    struct Response {
        T pressure;                   ///< [Pa]
        Vector<Directions> traction;  ///< q [Pa]
        /// d(p, q)/d(-d, s) [Pa/m] of the numbers returned, for Newton's method; where something slips not symmetric.
        Eigen::Matrix<T, Directions + 1, Directions + 1> tangent;
    };
    /// State on the curve of a first displacement.
    struct FirstSlip {
        T traction;   ///< q [Pa]
        T stiffness;  ///< dq/ds [Pa/m]
    };
    /// Loss of a cycle between two displacements of one size.
    struct Cycle {
        T lost;         ///< W [J/m^2]
        T loss_factor;  ///< W/(pi q s), W over 2 pi times q s/2; 4/pi where all slips, 0 where all sticks
    };

    /// Without \p friction, 0, there is no traction. \throws domain_error for an empty law, one whose K is not -dp/dd,
    /// a negative friction and a ratio that is not positive.
    TangentialLaw(const ContactLaw<T>& law, T friction, T ratio)
        : law_(law.empty() ? law : law.until_fall()),
          friction_(friction),
          ratio_(ratio),
          widening_(ratio / friction),
          closest_(law.outside() == OutsideRange::refuse ? law.separations()[0] : -std::numeric_limits<T>::infinity()) {
        detail::require(friction >= 0 && std::isfinite(friction), "friction", friction, "finite and 0 or greater");
        detail::require_positive("ratio", ratio);
        if (law.empty() || !law.stiffness_is_slope())
            detail::refuse("law", law.empty() ? "empty" : "of a K that is not -dp/dd",
                           "elastic: what slips follows the unloading");
    }

    /// The law of p, continued outside its range, since d* leaves it and so do faces that part; and from the greatest
    /// load of law_after() on by its K, since along the first loading a cycle would gain energy. Closer than its range
    /// a law of OutsideRange::refuse is refused here too.
    [[nodiscard]] const ContactLaw<T>& normal() const { return law_; }

    /// q and dq/ds at the first displacement \p slip, at the separation \p separation. \throws domain_error unless the
    /// slip is at least 0, and as ContactLaw.
    [[nodiscard]] FirstSlip first_slip(T separation, T slip) const {
        detail::require(slip >= 0, "slip", slip, "0 or greater");
        require_in_range(separation);
        if (friction_ == 0) return {};
        const auto stuck = law_.tangent_at_separation(separation + widening_ * slip);
        return {friction_ * (law_.pressure_at_separation(separation) - stuck.pressure), ratio_ * stuck.slope};
    }

    /// The loss of a cycle of displacements between -amplitude and amplitude, at the separation \p separation. \throws
    /// as first_slip.
    [[nodiscard]] Cycle cycle(T separation, T amplitude) const {
        detail::require(amplitude >= 0, "amplitude", amplitude, "0 or greater");
        const T traction = first_slip(separation, amplitude).traction;
        if (friction_ == 0) return {};
        const T width = widening_ * amplitude;
        const T lost = 4 * friction_ * friction_ / ratio_ * (std::max)(excess(separation, width), T(0));
        return {lost, traction > 0 && lost > 0 ? lost / (std::numbers::pi_v<T> * traction * amplitude) : T(0)};
    }

    /// State and derivatives after a straight path from \p before to \p separation and by \p slip. \p after, which may
    /// be \p before itself, is the memory of the contact from then on; before any slip that is the separation alone.
    /// \throws domain_error for a number that is not finite, and a separation that normal() refuses.
    template <int Directions>
    Response<Directions> step(const SlipState<T, Directions>& before, T separation,
                              const std::type_identity_t<Vector<Directions>>& slip,
                              SlipState<T, Directions>& after) const {
        using Step = detail::SlipStep<T, Directions, Directions + 1>;
        Step to{separation, slip, Step{}.separation_by.Zero(), Step{}.slip_by.Zero()};
        to.separation_by[0] = -1, to.slip_by.template rightCols<Directions>().setIdentity();
        const auto found = moved<Directions + 1>(before, nullptr, to, after, nullptr);
        Response<Directions> result{found.pressure, found.traction, {}};
        result.tangent << found.pressure_by, found.traction_by;
        return result;
    }

    /// p, q and their derivatives by numbers that the whole motion depends on.
    template <int Directions, int Columns>
    struct MotionResponse {
        T pressure;                                         ///< [Pa]
        Vector<Directions> traction;                        ///< q [Pa]
        Eigen::Matrix<T, 1, Columns> pressure_by;           ///< dp of each number
        Eigen::Matrix<T, Directions, Columns> traction_by;  ///< dq of each number
    };
    /// step() whose separation and slip have the derivatives \p separation_by and \p slip_by by some numbers, such as
    /// the amplitudes of harmonics; \p by are those of the memory, before and after, 0 before any slip. They are
    /// carried through stick and slip, so that those of p and q are of all steps. They are exact where the memory has
    /// room: of more than SlipState::capacity nodes those go that change the traction least.
    template <int Directions, int Columns>
    MotionResponse<Directions, Columns> step(SlipState<T, Directions>& state, T separation,
                                             const std::type_identity_t<Vector<Directions>>& slip,
                                             SlipDerivatives<T, Directions, Columns>& by,
                                             const Eigen::Matrix<T, 1, Columns>& separation_by,
                                             const Eigen::Matrix<T, Directions, Columns>& slip_by) const {
        return moved<Columns>(state, &by, {separation, slip, separation_by, slip_by}, state, &by);
    }

    /// Energy stored in tangential displacement [J/m^2], in addition to normal().energy(separation).
    template <int Directions>
    [[nodiscard]] T stored_energy(const SlipState<T, Directions>& state) const {
        T sum{}, level = state.separation;
        Vector<Directions> u = Vector<Directions>::Zero();
        for (int i = 0; i < state.count; ++i) {
            const auto& node = state.nodes[static_cast<std::size_t>(i)];
            const Vector<Directions> next = Eigen::Map<const Vector<Directions>>(node.drag.data());
            const Vector<Directions> slope = (next - u) / (node.level - level);
            sum += slope.squaredNorm() * (law_.energy(level) - law_.energy(node.level)) -
                   slope.dot(law_.pressure_at_separation(node.level) * next - law_.pressure_at_separation(level) * u);
            u = next, level = node.level;
        }
        return ratio_ * sum;
    }

private:
    void require_in_range(T separation) const {
        if (separation < closest_)
            detail::refuse("separation", separation,
                           "at least " + detail::shortest_text(closest_) + ", where the table ends");
    }
    template <int Columns, int Directions>
    MotionResponse<Directions, Columns> moved(
        const SlipState<T, Directions>& before,
        const std::type_identity_t<SlipDerivatives<T, Directions, Columns>>* before_by,
        const detail::SlipStep<T, Directions, Columns>& to, SlipState<T, Directions>& after,
        std::type_identity_t<SlipDerivatives<T, Directions, Columns>>* after_by) const {
        constexpr T most = (std::numeric_limits<T>::max)();
        detail::require(std::abs(to.separation) <= most, "separation", to.separation, "finite");
        for (const T s : to.slip) detail::require(std::abs(s) <= most, "slip", s, "finite");
        require_in_range(to.separation);
        if (friction_ == 0) {
            after = {.separation = to.separation};
            if (after_by) *after_by = {};
            const auto [pressure, slope] = law_.tangent_at_separation(to.separation);
            return {pressure, Vector<Directions>::Zero(), -slope * to.separation_by,
                    Eigen::Matrix<T, Directions, Columns>::Zero()};
        }
        detail::SlipPath<T, Directions, Columns> path(before, before_by, to, friction_ / ratio_);
        path.evaluate([this](T level) { return law_.tangent_at_separation(level); });
        const auto result = response(path, to);
        path.remember(after, after_by);
        return result;
    }
    template <int Directions, int Columns>
    [[nodiscard]] MotionResponse<Directions, Columns> response(
        const detail::SlipPath<T, Directions, Columns>& path,
        const detail::SlipStep<T, Directions, Columns>& to) const {
        MotionResponse<Directions, Columns> sum;
        const auto& edge = *path.begin();
        sum.pressure = edge.pressure;
        sum.pressure_by = -edge.slope * to.separation_by;
        sum.traction.setZero();
        sum.traction_by = edge.slope * edge.drag_by;  // not 0 where nothing slips
        for (auto a = path.begin(), b = a + 1; b != path.end(); a = b++) {
            const T length = b->level - a->level;
            // the mean slope of p between both; where that would cancel, of their slopes
            const T mean = length * a->slope > T(1e-6) * a->pressure ? (a->pressure - b->pressure) / length
                                                                     : (a->slope + b->slope) / 2;
            const Vector<Directions> rise = b->drag - a->drag;
            sum.traction += mean * rise;
            sum.traction_by += mean * (b->drag_by - a->drag_by);
            if (length > 0)
                sum.traction_by += rise / length * ((mean - a->slope) * a->level_by + (b->slope - mean) * b->level_by);
        }
        sum.traction *= ratio_;
        sum.traction_by *= ratio_;
        return sum;
    }
    /// (p + p*) width - 2 (E - E*). Where that would cancel, the integral of (width - 2 t) K(d + t) by four points of
    /// Gauss, which share two distances from the middle.
    [[nodiscard]] T excess(T separation, T width) const {
        const auto tangent = law_.tangent_at_separation(separation);
        if (tangent.slope * width > T(0.05) * tangent.pressure) {
            const T stuck = separation + width;
            return (tangent.pressure + law_.pressure_at_separation(stuck)) * width -
                   2 * (law_.energy(separation) - law_.energy(stuck));
        }
        constexpr T abscissas[] = {T(0.86113631159405257522), T(0.33998104358485626480)},
                    weights[] = {T(0.34785484513745385737), T(0.65214515486254614263)};
        T sum{};
        for (int i = 0; i < 2; ++i) {
            const T off = abscissas[i] * width / 2, middle = separation + width / 2;
            sum += weights[i] * abscissas[i] *
                   (law_.slope_at_separation(middle - off) - law_.slope_at_separation(middle + off));
        }
        return width * width / 2 * sum;
    }

    ContactLaw<T> law_;
    T friction_, ratio_, widening_;  ///< widening_: of the separation where contacts stick, k/mu
    T closest_;
};

}}  // namespace fstiff
