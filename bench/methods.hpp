// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// fstiff's own methods in the form that the benchmarks and the guard call. Everything is cold: a call starts from
// (r, theta, eta), and nothing is kept from one call to the next.
#include <fstiff/contact/rough_contact.hpp>
#include <fstiff/math/quadrature.hpp>
#include <fstiff/peaks/contact_integrals.hpp>
#include <fstiff/peaks/tensor_integrals.hpp>
#include <fstiff/tabulated/contact_law.hpp>

#include "problems.hpp"

#include "support/panels.hpp"
#include "support/twin_integrals.hpp"

#include <cstdio>
#include <numbers>
#include <string>

namespace bench {

using fstiff::Quantity;

inline constexpr std::array<double, 4> tolerances{1e-3, 1e-6, 1e-9, 1e-12};
inline std::string text_of(double tolerance) {
    char text[16];
    std::snprintf(text, sizeof text, "%.0e", tolerance);
    return text;
}

inline const Which four{0, 1, 2, 3};
inline const Which two{1, 2};  ///< load and stiffness
inline const Which one{2};     ///< stiffness

/// contact_integrals.
template <Quantity wanted>
Values reduced(const Problem& p, double tolerance) {
    const auto j =
        fstiff::contact_integrals(fstiff::PeakDistribution<double>(p.r, p.theta), p.eta, wanted, {tolerance});
    return {{j.contacts.value, j.load.value, j.stiffness.value, j.area.value},
            {j.contacts.error, j.load.error, j.stiffness.error, j.area.error},
            std::max(j.contacts.evaluations, j.stiffness.evaluations)};
}

/// The integrals of \p which one after the other, by \p integral(a, b, peaks, eta).
template <class Integral>
Values one_by_one(const Problem& p, const Which& which, const Integral& integral) {
    Values out;
    const fstiff::PeakDistribution<double> peaks(p.r, p.theta);
    for (const std::size_t i : which) {
        const fstiff::Estimate<double> j = integral(powers[i][0], powers[i][1], peaks, p.eta);
        out.value[i] = j.value;
        out.error[i] = j.error;
        out.evaluations += j.evaluations;
    }
    return out;
}
inline Values tensor(const Problem& p, const Which& which, double tolerance) {
    return one_by_one(p, which,
                      [tolerance](double a, double b, const fstiff::PeakDistribution<double>& peaks, double eta) {
                          return test::tensor_integral(a, b, peaks, eta, {tolerance});
                      });
}
inline Values paper(const Problem& p, const Which& which) { return one_by_one(p, which, test::paper_integral<double>); }

// Laws of a user for the kernel in two dimensions; excess and t are dimensionless, V is an Eigen array or a number.

/// Load and stiffness by Hertz, as a user would write them: half-integer powers.
struct HertzByUser {
    template <class V>
    V operator()(const V& excess, double t) const {
        using std::sqrt;
        return excess * sqrt(excess) / std::sqrt(t);
    }
};
struct HertzStiffnessByUser {
    template <class V>
    V operator()(const V& excess, double t) const {
        using std::sqrt;
        return sqrt(excess) / std::sqrt(t);
    }
};

/// Hertz that yields gradually: smooth, and no power law.
struct GradualYield {
    template <class V>
    V operator()(const V& excess, double t) const {
        using std::sqrt;
        return excess * sqrt(excess) / (std::sqrt(t) * (1 + 0.1 * t * excess));
    }
};

/// Hertz up to the excess 0.7/t, linear with half the slope beyond: a kink.
struct ElasticPlastic {
    static constexpr double critical(double t) { return 0.7 / t; }
    template <class V>
    V operator()(const V& excess, double t) const {
        const double limit = critical(t), root = std::sqrt(limit);
        const double at_limit = limit * root / std::sqrt(t), slope = 0.75 * root / std::sqrt(t);
        if constexpr (std::is_floating_point_v<V>)
            return excess < limit ? excess * std::sqrt(excess) / std::sqrt(t) : at_limit + slope * (excess - limit);
        else
            return (excess < limit).select(excess * excess.sqrt() / std::sqrt(t), at_limit + slope * (excess - limit));
    }
};

/// scaled_tensor_integral in the place of the load; with NodeClustering::rough the law keeps its kink to itself.
template <fstiff::NodeClustering axis, class Law>
Values kernel(const Problem& p, double tolerance) {
    const auto silent = [](const auto& excess, double t) { return Law{}(excess, t); };
    const auto law = [&] {
        if constexpr (axis == fstiff::NodeClustering::rough)
            return silent;
        else
            return Law{};
    }();
    const auto j = fstiff::detail::scaled_tensor_integral<axis>(law, fstiff::PeakDistribution<double>(p.r, p.theta),
                                                                p.eta, {tolerance});
    return {{0, j.value, 0, 0}, {0, j.error, 0, 0}, j.evaluations};
}
inline const Which load{1};

/// The integral of \p Law over the peaks, without exp(-eta^2/2) for eta > 0: nested panels that are split at the kink,
/// slow, and independent of fstiff but for the nodes; 1e-13 on the plain grid.
template <class Law>
double reference(double r, double theta, double eta, const Law& law) {
    const double c = std::sqrt((1 - r) * (1 + r)), k = std::tan(theta) / std::sqrt(2.0), floor = std::max(eta, 0.0);
    const double t_end = std::sqrt(floor * floor + 76);
    const auto row = [&](double t) {
        const double end = std::max(r * t - eta, 0.0) + 8.8 * c;
        double kink = end;
        if constexpr (fstiff::detail::KinkedLaw<Law, double>) kink = std::min(law.critical(t), end);
        const auto at = [&](double excess) {
            const double z = (eta + excess - r * t) / c;
            return law(excess, t) * std::exp((floor * floor - t * t - z * z) / 2);
        };
        return std::erf(k * t) * (test::panels(0, kink, 4, at) + (kink < end ? test::panels(kink, end, 6, at) : 0.0));
    };
    return test::panels(0, t_end, 16, row) / (2 * theta * c);
}

/// The plain grid with the true integrals of \p Law.
template <class Law>
const std::vector<Problem>& law_problems() {
    static const std::vector<Problem> kept = [] {
        std::vector<Problem> out = problems(plain);
        for (Problem& p : out) p.truth = {0, reference(p.r, p.theta, p.eta, Law{}), 0, 0};
        return out;
    }();
    return kept;
}

/// The fine sand-blasted surface of the paper's tables (data/sand_blasted_fine.toml) with r = 0.5, theta = 1.
inline constexpr double rms_height = 0.832e-6, peak_radius = 40e-6, peak_density = 500e6, fractal_dimension = 1.62,
                        modulus = 112.6e9;
inline fstiff::RoughContact<double, fstiff::FractalLaw<double>> sand_blasted_contact() {
    const fstiff::Roughness<double> surface{
        .rms_height = rms_height, .peak_radius = peak_radius, .peak_density = peak_density};
    return {surface, fstiff::PeakDistribution<double>(0.5, 1), fstiff::FractalLaw<double>(fractal_dimension), modulus};
}
inline constexpr double min_pressure = 1e5, max_pressure = 1e8;
inline fstiff::ContactLaw<double> tabulated_law() {
    return fstiff::ContactLaw<double>::tabulate(sand_blasted_contact(),
                                                {.min_pressure = min_pressure, .max_pressure = max_pressure});
}

/// A point of the contact, by eqs. (4.9), (4.10), (3.7), (3.14) and reference().
struct LawPoint {
    double pressure, separation, stiffness;
};
inline const std::vector<LawPoint>& law_points() {
    static const std::vector<LawPoint> points = [] {
        const double curvature = 3 * std::sqrt(std::numbers::pi) / (8 * peak_radius);
        const double root = std::sqrt(rms_height * curvature);
        const double stiffness_factor = 2.0 * 2 / 3 * (3 - fractal_dimension) / (2 - fractal_dimension);
        const auto separations = tabulated_law().separations();
        std::vector<LawPoint> out(512);
        double fraction = 0;
        for (LawPoint& at : out) {
            fraction =
                std::fmod(fraction + 0.6180339887498949, 1.0);  // golden section: fills the range evenly, in no order
            const double eta =
                (separations[0] + (separations[1] - separations[0]) * (0.001 + 0.998 * fraction)) / rms_height;
            const double scale = modulus * peak_density * rms_height / root * std::exp(-std::max(eta, 0.0) * eta / 2);
            at = {4.0 / 3 * scale * rms_height * reference(0.5, 1, eta, HertzByUser{}), eta * rms_height,
                  stiffness_factor * scale * reference(0.5, 1, eta, HertzStiffnessByUser{})};
        }
        return out;
    }();
    return points;
}

}  // namespace bench
