// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Ball on a rough face: the law of the rough face between two half-spaces that a smooth paraboloid presses.
///
///     d(r) = delta + r^2/(2 R) + u(r),   p(r) = law(d(r)),   W = 2 pi integral p r dr
///     u    displacement of both half-spaces under p(r), rings of constant pressure (Johnson, section 3.4)
///     K    dW/d(-delta), each ring a spring of its K(p), or of its -dp/dd for the first loading
///     a    16/(3 pi) times the mean radius of the load: that of Hertz where the faces are smooth
///
/// Newton's method in ln p, delta and all rings at once; the error is the difference to half as many rings.
///
/// Reference   Greenwood, Tripp, J. Appl. Mech. 34 (1967) 153; Johnson, Contact Mechanics (1985), section 13.5
/// Units       SI
/// Valid       a law with OutsideRange::extrapolate or exact; contact radius far below R
/// Accuracy    ContactOfBall::error, about 1e-3; against boundary elements of rough balls 1.5 % in the mean, where the
///             waves are a third of a and shorter (tests/tabulated/ball_contact_test.cpp)

#include <fstiff/math/decompositions.hpp>
#include <fstiff/tabulated/contact_law.hpp>

#include <Eigen/Core>

#include <cmath>
#include <numbers>

namespace fstiff { inline namespace v0_1 {

/// A ball under one load.
template <Real T = double>
struct ContactOfBall {
    T load{};               ///< W [N]
    T radius{};             ///< a [m]
    T approach{};           ///< -delta [m]: of points far below the faces, from where the mean planes would touch
    T pressure{};           ///< at the centre [Pa]
    T stiffness{};          ///< dW/d(approach) [N/m] of vibrations and of unloading
    T loading_stiffness{};  ///< that of the first loading [N/m]
    T error{};              ///< relative, the largest of those of radius, pressure and the stiffnesses
};

namespace detail {

/// Complete elliptic integrals K and E of the modulus \p k, below 1, by the arithmetic-geometric mean.
struct EllipticIntegrals {
    double first, second;
    explicit EllipticIntegrals(double k) {
        double a = 1, b = std::sqrt((1 - k) * (1 + k)), sum = k * k / 2, power = 0.5;
        while (std::abs(a - b) > 4e-16 * a) {
            const double c = (a - b) / 2;
            power *= 2, sum += power * c * c;
            b = std::sqrt(a * b), a -= c;
        }
        first = std::numbers::pi / (2 * a), second = first * (1 - sum);
    }
};

/// Displacement [m Pa] times the effective modulus at \p r of 1 Pa on a disc of radius \p a.
inline double displacement_of_disc(double r, double a) {
    if (a == 0) return 0;
    if (r < a) return 4 * a / std::numbers::pi * EllipticIntegrals(r / a).second;
    if (r == a) return 4 * a / std::numbers::pi;
    const double k = a / r;
    const EllipticIntegrals of(k);
    return 4 * r / std::numbers::pi * (of.second - (1 - k) * (1 + k) * of.first);
}

/// Displacement [m Pa] times the effective modulus at the radii \p r of 1 Pa on each ring between two of \p edges.
inline Eigen::MatrixXd compliance_of_rings(const Eigen::VectorXd& r, const Eigen::VectorXd& edges) {
    Eigen::MatrixXd compliance(r.size(), r.size());
    for (Eigen::Index i = 0; i < r.size(); ++i)
        for (Eigen::Index j = 0; j < r.size(); ++j)
            compliance(i, j) = displacement_of_disc(r[i], edges[j + 1]) - displacement_of_disc(r[i], edges[j]);
    return compliance;
}

/// Of smooth faces, Hertz.
inline ContactOfBall<double> hertz_ball(double radius, double modulus, double load) {
    const double a = std::cbrt(0.75 * load * radius / modulus), K = 2 * modulus * a;
    return {load, a, a * a / radius, 1.5 * load / (std::numbers::pi * a * a), K, K, 0};
}

/// The contact with \p rings of equal width up to \p reach. \throws domain_error where Newton's method does not
/// converge.
template <Real T>
[[nodiscard]] ContactOfBall<T> ball_of_rings(const ContactLaw<T>& law, double radius, double modulus, double load,
                                             double reach, Eigen::Index rings) {
    using Vector = Eigen::VectorXd;
    using Matrix = Eigen::MatrixXd;
    const double width = reach / static_cast<double>(rings), pi = std::numbers::pi;
    const Vector edges = Vector::LinSpaced(rings + 1, 0, reach), r = (edges.head(rings) + edges.tail(rings)) / 2;
    const Vector area = 2 * pi * width * r;
    const Matrix compliance = compliance_of_rings(r, edges) / modulus;
    const double p_hertz = hertz_ball(radius, modulus, load).pressure;
    Vector ln_p = (p_hertz * (-2 * (r / reach).array().square() * 8).exp()).log(), p = ln_p.array().exp();
    ln_p.array() += std::log(load / area.dot(p));
    double delta = 0;
    Vector slope(rings), rest(rings + 1);
    Matrix system(rings + 1, rings + 1);
    for (int iteration = 0;; ++iteration) {
        p = ln_p.array().exp();
        Vector d(rings);
        for (Eigen::Index i = 0; i < rings; ++i) {
            d[i] = static_cast<double>(law.separation(static_cast<T>(p[i])));
            slope[i] = static_cast<double>(law.slope_at_separation(static_cast<T>(d[i])));
        }
        rest.head(rings) = d.array() - delta - r.array().square() / (2 * radius) - (compliance * p).array();
        rest[rings] = area.dot(p) - load;
        system.topLeftCorner(rings, rings) = -compliance * p.asDiagonal();
        system.topLeftCorner(rings, rings).diagonal() -= (p.array() / slope.array()).matrix();
        system.topRightCorner(rings, 1).setConstant(-1);
        system.bottomLeftCorner(1, rings) = (area.array() * p.array()).matrix().transpose();
        system(rings, rings) = 0;
        for (Eigen::Index i = 0; i <= rings; ++i) {  // rows of one size: heights, and a load
            const double size = system.row(i).cwiseAbs().maxCoeff();
            system.row(i) /= size, rest[i] /= size;
        }
        const Vector step = math::PivotedQr<double>(system).solve(rest);
        const double longest = step.head(rings).cwiseAbs().maxCoeff(), shortened = (std::min)(1.0, 2 / longest);
        ln_p -= shortened * step.head(rings);
        delta -= shortened * step[rings];
        if (longest < 1e-10) break;
        if (iteration == 200)
            throw domain_error(
                "ball on a rough face: no balance of its pressures was found; must be a law that covers "
                "the pressures from 0 to " +
                shortest_text(p_hertz) + " Pa");
    }
    p = ln_p.array().exp();
    const auto stiffness = [&](const Vector& springs) {
        Matrix moved = compliance * springs.asDiagonal();
        moved.diagonal().array() += 1;
        return area.cwiseProduct(springs).dot(math::PivotedQr<double>(moved).solve(Vector::Ones(rings)));
    };
    Vector springs(rings);
    for (Eigen::Index i = 0; i < rings; ++i) springs[i] = static_cast<double>(law.stiffness(static_cast<T>(p[i])));
    const double mean_radius = area.cwiseProduct(r).dot(p) / area.dot(p);
    return {.load = static_cast<T>(load),
            .radius = static_cast<T>(16 / (3 * pi) * mean_radius),
            .approach = static_cast<T>(-delta),
            .pressure = static_cast<T>(p[0] + (p[0] - p[1]) / 8),  // a parabola through the first two rings
            .stiffness = static_cast<T>(stiffness(springs)),
            .loading_stiffness = static_cast<T>(stiffness(slope))};
}

}  // namespace detail

/// The contact of a ball of the radius \p radius [m] (of two, 1/R = 1/R_1 + 1/R_2), pressed by \p load [N] on a rough
/// face with the law \p law between half-spaces of the effective modulus \p modulus [Pa]: for a law of the roughness
/// alone. \throws domain_error unless all are positive, and for a law that refuses a pressure.
template <Real T>
[[nodiscard]] ContactOfBall<T> ball_on_rough_face(const ContactLaw<T>& law, std::type_identity_t<T> radius,
                                                  std::type_identity_t<T> modulus, std::type_identity_t<T> load) {
    detail::require_positive("radius", radius);
    detail::require_positive("modulus", modulus);
    detail::require_positive("load", load);
    // beyond the reach the pressure is below 1e-7 of that of Hertz
    const ContactOfBall<double> hertz = detail::hertz_ball(radius, modulus, load);
    const double roughness = static_cast<double>(law.separation(static_cast<T>(1e-7 * hertz.pressure)) -
                                                 law.separation(static_cast<T>(hertz.pressure)));
    // faces that are smooth to such a ball: Hertz, to the ratio of the roughness to the approach
    if (roughness < 3e-3 * hertz.approach)
        return {load,
                static_cast<T>(hertz.radius),
                static_cast<T>(hertz.approach),
                static_cast<T>(hertz.pressure),
                static_cast<T>(hertz.stiffness),
                static_cast<T>(hertz.stiffness),
                static_cast<T>(roughness / hertz.approach)};
    const double reach = std::sqrt(1.2 * hertz.radius * hertz.radius + 2 * radius * (std::max)(roughness, 0.0));
    ContactOfBall<T> coarse = detail::ball_of_rings(law, radius, modulus, load, reach, 48),
                     fine = detail::ball_of_rings(law, radius, modulus, load, reach, 96);
    for (const auto member : {&ContactOfBall<T>::radius, &ContactOfBall<T>::pressure, &ContactOfBall<T>::stiffness,
                              &ContactOfBall<T>::loading_stiffness})
        fine.error = (std::max)(fine.error, std::abs(coarse.*member / (fine.*member) - 1));
    return fine;
}

}}  // namespace fstiff
