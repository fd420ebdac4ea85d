// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Contact of the summits of a map that push each other down. Derivation: docs/theory-contact.md, section 7.
///
///     omega_i + sum_j g_ij F_j/E = z_i - d,   F_i = E c_i omega_i^(3/2),   p = sum F_i/A0
///     K = 1/A0 1^T (diag(1/k) + g/E)^(-1) 1,  k_i = (3/2) E c_i omega_i^(1/2)
///
/// c_i: Hertz's ellipse (asperity/elliptic_hertz.hpp); g_ij: periodic, less its mean (halfspace/point_forces.hpp).
/// Reference   Ciavarella, Greenwood, Paggi, Wear 265 (2008) 729; Johnson, Contact Mechanics (1985), eq. (4.26); the
///             periodic g and the rule for close pairs: this project
/// Units       SI
/// Valid       up to 5000 summits in contact, on 8 % of the area: p/(E g) of 0.03 or so
/// Accuracy    equations 1e-8 in K (tests/contact/mutual_summits_test.cpp); K over boundary elements of 39 maps rms 3.5
///             to 6 % at p/(E g) = 0.0003 to 0.01, 0.81 to 0.88 where one hill carries all (docs/validation.md)
/// Cost        5 ms for 200 contacts, 40 ms for 1100, 0.5 s for 4800

#include <fstiff/asperity/elliptic_hertz.hpp>
#include <fstiff/contact/contact.hpp>
#include <fstiff/contact/contact_state.hpp>
#include <fstiff/contact/slope_contact.hpp>
#include <fstiff/contact/summit_contact.hpp>
#include <fstiff/halfspace/point_forces.hpp>
#include <fstiff/peaks/quantity.hpp>
#include <fstiff/topography/summits.hpp>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// Effect of the push of the others on the contacts, a measure of the range of the law.
template <Real T = double>
struct Crowding {
    T softening{};             ///< K of the same contacts without each other, over K
    T real_area_fraction{};    ///< A/A0
    Eigen::Index contacts{};   ///< that carry
    Eigen::Index displaced{};  ///< above the flat, but too close to a higher one
};

/// The contact of the summits of one map, each of which sinks under the loads of all others.
template <Real T = double>
class MutualSummits : public SlopeContact<MutualSummits<T>, T> {
    using Values = Eigen::Array<T, Eigen::Dynamic, 1>;

public:
    /// \throws domain_error for no summits and a modulus that is not finite and positive.
    MutualSummits(Summits<T> summits, std::type_identity_t<T> effective_modulus, Edges edges = Edges::mirrored)
        : map_(std::move(summits)), alone_(map_, effective_modulus), modulus_(effective_modulus), edges_(edges) {
        const T a = map_.width, b = map_.height;
        require_positive("width", a);
        require_positive("height", b);
        for (const Summit<T>& s : map_.summits) hertz_.push_back(elliptic_hertz(s.max_curvature, s.min_curvature));
    }

    /// \throws domain_error unless the pressure [Pa] is positive and at most 5000 summits on 8 % of the area carry it.
    [[nodiscard]] ContactState<T> at_pressure(T pressure, Quantity quantities = Quantity::all) const {
        ContactState<T> state = state_of(solved(pressure), quantities);
        state.pressure = {pressure, 0, state.pressure.evaluations};
        return state;
    }

    /// \throws domain_error for a separation at which no summit touches, and as at_pressure.
    [[nodiscard]] ContactState<T> at_separation(T separation, Quantity quantities = Quantity::all) const {
        ContactState<T> state = state_of(held(separation), quantities);
        state.separation.value = separation;
        return state;
    }

    /// log(p/Pa) and its slope against eta, the separation over the rms height. \throws domain_error as at_separation.
    [[nodiscard]] LogSlope<T> log_pressure(T eta) const {
        const Solution s = held(eta * map_.rms_height);
        return {std::log(s.pressure), -s.stiffness / s.pressure * map_.rms_height, T(1e-9)};
    }

    /// \throws domain_error as at_pressure.
    [[nodiscard]] Crowding<T> crowding(T pressure) const { return solved(pressure).crowding; }

    [[nodiscard]] T rms_height() const { return map_.rms_height; }
    /// Nominal area of the summits [m^2].
    [[nodiscard]] T area() const { return map_.area; }
    /// K has a kink wherever another summit touches.
    [[nodiscard]] static constexpr bool has_kinks() { return true; }

private:
    static constexpr Eigen::Index max_summits = 5000;
    static constexpr T max_area = T(0.08);

    struct Solution {
        T pressure = 0, separation = 0, stiffness = 0, error = 0;
        Crowding<T> crowding{};
    };

    /// The push of those that carry, and of some that nearly do: for Newton's steps.
    struct QuickPush {
        std::vector<Eigen::Index> indices{};
        std::vector<char> holds{};  ///< of all
        std::optional<PointForces<T, QuickSplit>> forces{};

        /// Deflections by a force on each of all, 0 on those that it does not hold.
        [[nodiscard]] Values deflections(const Values& force) {
            Values u = Values::Zero(force.size());
            u(indices) = forces->deflections(force(indices));
            return u;
        }
    };

    /// The highest summits, their push and where Newton's method is. Forces are over E.
    struct Newton {
        Values x, y, z, load_factor, area_factor;
        PointForces<T> forces;
        QuickPush quick;
        Values omega;            ///< approach; of an open one less than 0
        T delta;                 ///< separation
        std::vector<char> shut;  ///< too close to a higher one
        Values unit;             ///< (I + r g r) unit = r, r = sqrt(k): warm start
        bool definite = true;

        [[nodiscard]] Values carried(const Values& all_values) const {
            Values values = all_values;
            for (Eigen::Index i = 0; i < z.size(); ++i)
                if (shut[static_cast<std::size_t>(i)] != 0) values[i] = 0;
            return values;
        }
        [[nodiscard]] Values loads() const {
            return carried(load_factor * (omega.max)(T(0)) * (omega.max)(T(0)).sqrt());
        }
        [[nodiscard]] Values slopes() const { return T(1.5) * load_factor * (omega.max)(T(0)).sqrt(); }
    };

    [[nodiscard]] Newton start(Eigen::Index count, T delta) const {
        require(count <= 4 * max_summits, "summits that may touch", count,
                "at most 20000 that push each other down (hybrid and boundary_elements go on)");
        // from the edge: half a step outside of the first point
        Values x(count), y(count), z(count), load(count), area(count);
        for (Eigen::Index i = 0; i < count; ++i) {
            const auto k = static_cast<std::size_t>(i);
            x[i] = (std::min)((std::max)(map_.summits[k].x + map_.dx / 2, T(0)), map_.width);
            y[i] = (std::min)((std::max)(map_.summits[k].y + map_.dy / 2, T(0)), map_.height);
            z[i] = map_.summits[k].height;
            load[i] = hertz_[k].load_factor;
            area[i] = hertz_[k].area_factor;
        }
        // clang-format off
        return {x, y, z, load, area, PointForces<T>(x, y, map_.width, map_.height, edges_), {}, z - delta, delta,
                std::vector<char>(static_cast<std::size_t>(count), 0), Values::Zero(count)};
        // clang-format on
    }

    /// Makes the quick push hold all with a stiffness \p r^2.
    void widen_quick(Newton& newton, const Values& r) const {
        QuickPush& quick = newton.quick;
        bool complete = quick.forces.has_value();
        for (Eigen::Index i = 0; complete && i < r.size(); ++i)
            complete = !(r[i] > 0) || quick.holds[static_cast<std::size_t>(i)] != 0;
        if (complete) return;
        const T highest = newton.omega.maxCoeff(), nearly = highest - T(1.1) * std::abs(highest);
        quick.indices.clear();
        quick.holds.assign(static_cast<std::size_t>(r.size()), 0);
        for (Eigen::Index i = 0; i < r.size(); ++i) {
            if (!(newton.omega[i] >= nearly)) continue;
            quick.indices.push_back(i);
            quick.holds[static_cast<std::size_t>(i)] = 1;
        }
        quick.forces.emplace(newton.x(quick.indices), newton.y(quick.indices), map_.width, map_.height, edges_);
    }

    /// (I + r g r) y = right by conjugate gradients from \p y, to \p tolerance of the right side.
    static void solve(Newton& newton, const Values& r, const Values& right, Values& y, T tolerance) {
        const auto image = [&](const Values& v) -> Values { return v + r * newton.quick.deflections(r * v); };
        Values rest = right - image(y), direction = rest;
        T norm = rest.square().sum();
        const T end = tolerance * tolerance * right.square().sum();
        for (int i = 0; i < 300 && norm > end; ++i) {
            const Values moved = image(direction);
            const T curvature = (direction * moved).sum();
            newton.definite = curvature > 0;
            if (!newton.definite) break;
            y += norm / curvature * direction;
            rest -= norm / curvature * moved;
            const T next = rest.square().sum();
            direction = rest + next / norm * direction;
            norm = next;
        }
    }

    /// Opens the lower one of two contacts that could each carry alone: g_ij^2 k_i k_j >= E^2.
    static void part(Newton& newton, T threshold, bool reopen) {
        const Values k = newton.slopes();
        for (Eigen::Index i = 0; i < k.size(); ++i) {
            bool close = false;
            newton.forces.visit_close(i, [&](Eigen::Index j, T g) {
                close = close ||
                        (j < i && newton.shut[static_cast<std::size_t>(j)] == 0 && g * g * k[i] * k[j] >= threshold);
            });
            char& shut = newton.shut[static_cast<std::size_t>(i)];
            shut = close || (shut != 0 && !reopen) ? 1 : 0;
        }
    }

    /// The solution at a given load over E, or at the separation of \p newton.
    static constexpr T held_separation = -1;
    enum class Aim { rough, exact };
    [[nodiscard]] Solution iterate(Newton& newton, T load, Aim aim, T apart) const {
        const T enough = aim == Aim::rough ? T(0.1) : T(1e-10);
        T change = 1;
        for (int i = 0; i < 40; ++i) {
            part(newton, apart, i < 4);
            const Values r = newton.carried(newton.slopes()).sqrt();
            const Values rest = newton.z - newton.delta - newton.omega - newton.forces.deflections(newton.loads());
            const T missing = load == held_separation ? T(0) : load - newton.loads().sum();
            const T scale = (std::max)(newton.omega.maxCoeff(), (std::numeric_limits<T>::min)());
            change = newton.carried(rest).abs().maxCoeff() / scale;
            if (change < enough && std::abs(missing) <= enough * load) break;
            widen_quick(newton, r);
            Values y = Values::Zero(r.size());
            const T inner = change < T(0.02) ? T(1e-3) : T(0.03);
            solve(newton, r, r * rest, y, inner);
            T lower = 0;
            if (load != held_separation) {
                solve(newton, r, r, newton.unit, T(0.03));
                lower = ((r * y).sum() - missing) / (r * newton.unit).sum();
                y -= lower * newton.unit;
            }
            const Values step = rest - lower - newton.quick.deflections(r * y);
            const T longest = newton.carried(step).abs().maxCoeff(), part = (std::min)(T(1), scale / (2 * longest));
            newton.omega += part * step;
            newton.delta += part * lower;
        }
        return result(newton, change, aim);
    }

    /// 1^T (1/k + g)^(-1) 1 = r u + u m + m (I + r g r)^(-1) m with m = r - (I + r g r) u, of any u: where m is small
    /// the rougher g will do in the last term.
    [[nodiscard]] T held_stiffness(Newton& newton, const Values& r) const {
        widen_quick(newton, r);
        solve(newton, r, r, newton.unit, T(1e-4));
        const Values missing = r - newton.unit - r * newton.forces.deflections(r * newton.unit);
        Values rest = Values::Zero(r.size());
        solve(newton, r, missing, rest, T(0.03));
        return ((r + missing) * newton.unit + missing * rest).sum();
    }

    [[nodiscard]] Solution result(Newton& newton, T change, Aim aim) const {
        const Values r = newton.carried(newton.slopes()).sqrt(), loads = newton.loads();
        const T unit = aim == Aim::exact ? held_stiffness(newton, r) : T(0);
        Solution s;
        s.pressure = loads.sum() * modulus_ / map_.area;
        s.separation = newton.delta;
        s.stiffness = unit * modulus_ / map_.area;
        s.error = change * newton.omega.maxCoeff();
        s.crowding.softening = r.square().sum() * modulus_ / map_.area / s.stiffness;
        s.crowding.real_area_fraction = newton.carried(newton.area_factor * (newton.omega.max)(T(0))).sum() / map_.area;
        s.crowding.contacts = (loads > T(0)).count();
        s.crowding.displaced = (newton.omega > T(0)).count() - s.crowding.contacts;
        if (!newton.definite || !(change < T(1e-9))) s.stiffness = std::numeric_limits<T>::quiet_NaN();
        return s;
    }

    /// Number of summits higher than \p level.
    [[nodiscard]] Eigen::Index higher_than(T level) const {
        const auto end = std::partition_point(map_.summits.begin(), map_.summits.end(),
                                              [level](const Summit<T>& summit) { return summit.height > level; });
        return end - map_.summits.begin();
    }

    [[nodiscard]] Solution solved(T pressure) const {
        const T delta = alone_.at_pressure(pressure, Quantity::separation).separation.value;
        return settled(delta, pressure, pressure * map_.area / modulus_);
    }
    [[nodiscard]] Solution held(T separation) const {
        return settled(separation, alone_.at_separation(separation, Quantity::pressure).pressure.value,
                       held_separation);
    }

    /// Solution; where Newton's method fails, the higher of less close pairs carries too: 0.64, 1, 1.6 contact radii.
    [[nodiscard]] Solution settled(T delta, T pressure, T load) const {
        Solution solution;
        for (const T apart : {T(1), T(0.4), T(0.15)}) {
            solution = settled_apart(delta, load, apart);
            if (solution.stiffness > 0 || solution.crowding.contacts > max_summits) break;
        }
        return checked(solution, pressure);
    }
    /// Solution with all summits that touch: those that were left out are compared with the deflected surface.
    [[nodiscard]] Solution settled_apart(T delta, T load, T apart) const {
        Newton newton = start(higher_than(delta - T(0.1) * (map_.summits.front().height - delta)), delta);
        // of a start that is too stiff both of a close pair cannot move: roughly, they are kept farther apart
        for (Aim aim = Aim::rough;; aim = Aim::exact) {
            const Solution s = iterate(newton, load, aim, aim == Aim::rough ? apart / 5 : apart);
            if (aim == Aim::exact && (s.crowding.contacts > max_summits || !(s.stiffness > 0))) return s;
            if (!add_missed(newton, s) && aim == Aim::exact) return s;
        }
    }
    /// Adds the summits that touch the deflected surface of \p s; whether there are any.
    [[nodiscard]] bool add_missed(Newton& newton, const Solution& s) const {
        const Eigen::Index count = newton.z.size(),
                           candidates = higher_than(s.separation + newton.forces.least_deflection(newton.loads()));
        if (candidates <= count) return false;
        Newton more = start(candidates, newton.delta);
        Values loads = Values::Zero(candidates);
        loads.head(count) = newton.loads();
        const Values left = more.z - newton.delta - more.forces.deflections(loads);
        Eigen::Index end = candidates;
        while (end > count && !(left[end - 1] > 0)) --end;
        if (end == count) return false;
        more.omega = left;
        more.omega.head(count) = newton.omega;
        std::copy(newton.shut.begin(), newton.shut.end(), more.shut.begin());
        more.unit.head(count) = newton.unit;
        newton = std::move(more);
        return true;
    }
    [[nodiscard]] Solution checked(const Solution& s, T pressure) const {
        require(s.crowding.contacts <= max_summits, "summits in contact", s.crowding.contacts,
                "at most 5000 that push each other down (hybrid and boundary_elements go on)");
        if (!(s.stiffness > 0 && s.crowding.real_area_fraction <= max_area))
            refuse("pressure", pressure,
                   "so small that the summits are not too dense to be separated (hybrid and boundary_elements "
                   "go on)");
        return s;
    }

    [[nodiscard]] ContactState<T> state_of(const Solution& s, Quantity quantities) const {
        const T relative = (std::max)(T(1e-6), s.error * s.stiffness / s.pressure);
        const auto given = [&](Quantity quantity, T value) {
            return has(quantities, quantity)
                       ? Estimate<T>{value, relative * value, static_cast<int>(s.crowding.contacts)}
                       : Estimate<T>{};
        };
        ContactState<T> state;
        state.separation = {s.separation, s.error, 0};
        state.eta = s.separation / map_.rms_height;
        state.pressure = given(Quantity::pressure, s.pressure);
        state.stiffness = given(Quantity::stiffness, s.stiffness);
        state.loading_stiffness = given(Quantity::loading_stiffness, s.stiffness);
        state.real_area_fraction = given(Quantity::real_area_fraction, s.crowding.real_area_fraction);
        state.contact_density = given(Quantity::contact_density, T(s.crowding.contacts) / map_.area);
        return state;
    }

    Summits<T> map_;
    SummitContact<T> alone_;
    T modulus_;
    Edges edges_;
    std::vector<EllipticHertz<T>> hertz_;
};

}}}  // namespace fstiff::detail
