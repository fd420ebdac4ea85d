// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Stiffness of a joint whose faces are not flat: the law of the roughness under the local pressure, on a half space.
///
///     c(p) + u[p] + w = delta,  mean p = nominal pressure      c: closure of the roughness, w: gap of the form
///     y/K_faces(p) + u[y] = 1,  K = mean y                     the same with the loading stiffness
///
/// u[p] is that of a half space that repeats the face. Newton's method steps in ln p where p falls and in p where it
/// rises; a step that overshoots is cut where the energy along it is least, and damped where the energy would rise.
///
/// Reference   halfspace/cosine_compliance.hpp; Johnson, Contact Mechanics (1985), section 13.5 (law on a form)
/// Units       SI: Pa, m, Pa/m
/// Valid       any pressure and height above 0; beyond its range a ContactLaw goes on with K in proportion to p
/// Accuracy    of the equations on the grid 1e-5. Of the grid of 64 points a side, against 128: 1.3 % of crowns, 5 % of
///             saddles; of 32 points 5 % for 136 of 140, 16 % for all (tests/halfspace/formed_joint_test.cpp)

#include <fstiff/core/error.hpp>
#include <fstiff/halfspace/cosine_compliance.hpp>
#include <fstiff/halfspace/joint_form.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace fstiff { inline namespace v0_1 {

/// One solution of a joint with a form.
struct FormedJointState {
    double pressure{};           ///< nominal [Pa]
    double stiffness{};          ///< K of the joint for small steps [Pa/m]
    double loading_stiffness{};  ///< of the joint [Pa/m]
    double touching_share{};     ///< of the area, where p is above 1 % of the nominal pressure
    double greatest_pressure_over_mean{};
    int iterations{};  ///< of Newton's method
};

namespace detail {

/// The law of the roughness at one pressure.
struct LocalContact {
    double closure;            ///< c [m], from any pressure, rising with p
    double stiffness;          ///< K [Pa/m]
    double loading_stiffness;  ///< dp/dc [Pa/m]
};

/// Conjugate gradients for (a + v u[v ]) t = b, with sum(v t) = 0 if \p balanced. u[] is that of \p compliance.
class SpringGradients {
    using Field = CosineCompliance::Field;

public:
    SpringGradients(CosineCompliance& compliance, Field springs, Field weights, double mean_compliance, bool balanced)
        : compliance_(&compliance), a_(std::move(springs)), v_(std::move(weights)), balanced_(balanced) {
        inverse_ = 1 / (a_ + mean_compliance * v_.square());
        weighted_ = inverse_ * v_;
        balance_ = (v_ * weighted_).sum();
    }

    /// t, to the \p tolerance of the residual over that of t = 0.
    [[nodiscard]] Field solve(Field rest, double tolerance) {
        Field t = Field::Zero(rest.rows(), rest.cols()), pull = conditioned(rest), direction = pull, response;
        double norm = (rest * pull).sum();
        const double end = tolerance * tolerance * norm;
        for (int k = 0; k < 400 && norm > end; ++k) {
            response = v_ * direction;
            compliance_->deflect(response);
            response = a_ * direction + v_ * response;
            const double curvature = (direction * response).sum();
            if (!(curvature > 0)) break;
            t += norm / curvature * direction;
            rest -= norm / curvature * response;
            pull = conditioned(rest);
            const double last = std::exchange(norm, (rest * pull).sum());
            direction = pull + norm / last * direction;
        }
        return t;
    }

private:
    [[nodiscard]] Field conditioned(const Field& rest) const {
        Field pull = inverse_ * rest;
        if (balanced_) pull -= (v_ * pull).sum() / balance_ * weighted_;
        return pull;
    }

    CosineCompliance* compliance_;
    Field a_, v_, inverse_, weighted_;
    double balance_{};
    bool balanced_;
};

/// The law at \p p within its range, and with K in proportion to p beyond it.
template <class Law>
[[nodiscard]] LocalContact local_contact(const Law& law, double p, double floor) {
    double inside = (std::max)(p, floor);
    LocalContact at;
    if constexpr (requires { law.tangent_at_separation(law.separation(p)); }) {  // a ContactLaw
        inside = std::clamp(inside, law.pressures()[0], law.pressures()[1]);
        const double separation = law.separation(inside);
        at = {-separation, law.stiffness(inside), law.tangent_at_separation(separation).slope};
    } else {
        const auto found = law(inside);
        at = {found.closure, found.stiffness, found.loading_stiffness};
    }
    require(at.loading_stiffness > 0 && std::isfinite(at.loading_stiffness), "loading stiffness of the law",
            at.loading_stiffness, "finite and greater than 0");
    require(at.stiffness > 0 && std::isfinite(at.stiffness), "stiffness of the law", at.stiffness,
            "finite and greater than 0");
    require(std::isfinite(at.closure), "closure of the law", at.closure, "finite");
    if (p == inside) return at;
    const double ratio = p / inside;
    return {at.closure + inside / at.loading_stiffness * std::log(ratio), at.stiffness * ratio,
            at.loading_stiffness * ratio};
}

}  // namespace detail

/// The joint of one form, solved at one pressure after another.
template <class Law>
class FormedJoint {
    using Field = detail::CosineCompliance::Field;

public:
    /// \p law: a ContactLaw<double> of the roughness alone, or a function of the pressure [Pa] that returns a struct
    /// of closure [m], rising with p from any datum, stiffness and loading_stiffness [Pa/m].
    /// \throws domain_error for a form with fewer than 2 points a side or a gap that is not finite, and a
    /// modulus that is not positive.
    FormedJoint(const JointForm& form, Law law, double effective_modulus)
        : law_(std::move(law)),
          modulus_(effective_modulus),
          gap_(form.gap.heights),
          compliance_(gap_.rows(), gap_.cols(), form.gap.dx, form.gap.dy) {
        detail::require_positive("effective_modulus", effective_modulus);
        if (!gap_.isFinite().all())
            throw domain_error("form of a joint with a gap that is not a number: must be finite at every point");
        gap_ -= gap_.minCoeff();
        Field point = Field::Zero(gap_.rows(), gap_.cols());
        point(0, 0) = 1;
        compliance_.deflect(point);
        own_ = point(0, 0) / modulus_;
    }

    /// The joint under the nominal \p pressure [Pa], from equal pressures: those of a lighter load take more
    /// steps. \throws domain_error unless 0 < pressure, and as the law.
    [[nodiscard]] FormedJointState at_pressure(double pressure) {
        detail::require_positive("pressure", pressure);
        FormedJointState state{.pressure = pressure};
        x_ = Field::Ones(gap_.rows(), gap_.cols());
        if (gap_.maxCoeff() > 0 && (state.iterations = balance(pressure)) == 0) {
            x_.resize(0, 0);
            throw domain_error("form of a joint: no balance of its pressures was found at " +
                               detail::shortest_text(pressure) + " Pa; must be a law that rises with p");
        }
        pressure_ = pressure;
        Field springs(x_.rows(), x_.cols()), loading = springs;
        for (Eigen::Index k = 0; k < x_.size(); ++k) {
            const detail::LocalContact at = local(x_.data()[k]);
            springs.data()[k] = at.stiffness;
            loading.data()[k] = at.loading_stiffness;
        }
        state.stiffness = stiffness(springs);
        state.loading_stiffness = stiffness(loading);
        state.touching_share = (x_ > 0.01).template cast<double>().mean();
        state.greatest_pressure_over_mean = x_.maxCoeff();
        return state;
    }

    /// Local pressures [Pa] of the last solution, on the grid of the form.
    [[nodiscard]] Field pressures() const { return pressure_ * x_; }

private:
    /// The law at \p x times the nominal pressure.
    [[nodiscard]] detail::LocalContact local(double x) const {
        return detail::local_contact(law_, x * pressure_, 1e-12 * pressure_);
    }
    /// Deflection [m] under \p x times the nominal pressure.
    [[nodiscard]] Field deflection(Field x) {
        x *= pressure_ / modulus_;
        compliance_.deflect(x);
        return x;
    }
    /// \p heights above their mean by load.
    [[nodiscard]] static Field from_mean(Field heights, const Field& x) {
        heights -= (heights * x).sum() / x.sum();
        return heights;
    }
    /// Closures [m] at \p x, and d closure/d ln p in \p slopes.
    [[nodiscard]] Field closures(const Field& x, Field* slopes = nullptr) const {
        Field c(x.rows(), x.cols());
        for (Eigen::Index k = 0; k < x.size(); ++k) {
            const detail::LocalContact at = local(x.data()[k]);
            c.data()[k] = at.closure;
            if (slopes) slopes->data()[k] = x.data()[k] * pressure_ / at.loading_stiffness;
        }
        return c;
    }

    /// x by \p step of ln x: in ln x down, in x up.
    [[nodiscard]] static Field moved(const Field& x, const Field& step) {
        Field next = ((x * (step < 0).select((step.min)(0).exp(), 1 + step)).max)(least);
        next /= next.mean();
        return next;
    }

    /// Share of \p change at which the energy is about least; the slope of the energy is \p slope at the start.
    [[nodiscard]] double least_energy(const Field& x, const Field& change, const Field& still, const Field& deflection,
                                      double slope) const {
        const auto slope_at = [&](double share) {
            return (from_mean(closures(((x + share * change).max)(least)) + still + share * deflection, x) * change)
                .sum();
        };
        double low = 0, high = 1, share = 1;
        for (int k = 0; k < 12; ++k) {
            const double now = slope_at(share);
            if (std::abs(now) < 0.1 * std::abs(slope) || (share == 1 && now < 0)) break;
            (now > 0 ? high : low) = share;
            share = (low + high) / 2;
        }
        return share;
    }

    /// Balances the pressures. \returns the iterations, 0 where they do not converge.
    int balance(double pressure) {
        pressure_ = pressure;
        const double scale = pressure_ / modulus_;
        Field slopes(x_.rows(), x_.cols()), u = deflection(x_);
        double last = std::numeric_limits<double>::infinity();
        for (int iteration = 1; iteration <= 100; ++iteration) {
            const Field still = u + gap_, rest = from_mean(closures(x_, &slopes) + still, x_), v = x_.sqrt();
            Field next, change;
            double slope = 0, size = 0, damping = 0;
            for (int cuts = 0; cuts <= 10; ++cuts) {
                // in t = v ln x the equations are symmetric
                detail::SpringGradients gradients(compliance_, slopes + damping, v * std::sqrt(scale), own_ * modulus_,
                                                  true);
                next = moved(x_, gradients.solve(-v * rest, last > 0.1 ? 1e-2 : 1e-4) / v);
                change = next - x_;
                slope = (rest * change).sum();
                if (cuts == 0) size = change.abs().mean();
                if (slope < 0 || size < converged) break;
                damping = cuts == 0 ? (x_ * rest.abs()).mean() : 4 * damping;
            }
            if (!std::isfinite(size)) return 0;
            const Field deflected = deflection(change);
            const double share =
                size > 0.5 * last && size > converged ? least_energy(x_, change, still, deflected, slope) : 1;
            x_ = share < 1 ? Field(x_ + share * change) : next;
            u += share * deflected;
            if (size < converged) return iteration;
            last = size;
        }
        return 0;
    }

    /// K of the joint [Pa/m] with local \p springs [Pa/m].
    [[nodiscard]] double stiffness(const Field& springs) {
        const double scale = springs.maxCoeff();
        const Field v = (springs / scale).sqrt(), ones = Field::Ones(v.rows(), v.cols());
        detail::SpringGradients gradients(compliance_, ones, v * std::sqrt(scale / modulus_), own_ * modulus_, false);
        return scale * (v * gradients.solve(v, 1e-5)).mean();
    }

    static constexpr double converged = 1e-5;  ///< change of the pressures; the next one is about its square
    static constexpr double least = 1e-290;    ///< share of the nominal pressure that points keep that carry nothing

    Law law_;
    double modulus_, pressure_{}, own_{};  ///< own_: deflection of a point by its own pressure [m/Pa]
    Field gap_;
    detail::CosineCompliance compliance_;
    Field x_;  ///< pressures over the nominal one
};

}}  // namespace fstiff
