// SPDX-License-Identifier: BSD-3-Clause
// Peers: Gauss-Legendre in two dimensions, from the paper's 50 x 50 points to the best that hand tuning makes of it.
#include "../methods.hpp"
#include "../row.hpp"
#include "window.hpp"

#include <fstiff/math/normal_distribution.hpp>

#include <Eigen/Core>

namespace {

using namespace bench;
using Eight = Eigen::Array<double, 8, 1>;

/// N nodes on [0, 1], ascending, in eights; beyond N the weight is 0.
template <std::size_t N>
struct Nodes {
    static constexpr std::size_t eights = (N + 7) / 8;
    std::array<Eight, eights> node, weight;
    Nodes() {
        const auto& rule = fstiff::math::GaussLegendre<double, N>::get();
        for (std::size_t i = 0; i < 8 * eights; ++i) {
            const auto lane = static_cast<Eigen::Index>(i % 8);
            node[i / 8][lane] = i < N ? (1 + rule.node[i]) / 2 : 1;
            weight[i / 8][lane] = i < N ? rule.weight[i] / 2 : 0;
        }
    }
};
template <std::size_t N>
const Nodes<N> nodes{};

// 50 x 50 on the box 0 <= t <= 6.2, eta <= zeta <= max(eta, 0) + 4.6 (the box of the least error on the plain grid),
// with everything hoisted that depends on one direction alone. No substitution: this is the rule of the paper.
constexpr std::size_t paper_points = 50;
constexpr double box_t = 6.2, box_height = 4.6;

Values box_scalar(const Problem& p, const Which& which) {
    const auto& rule = fstiff::math::GaussLegendre<double, paper_points>::get();
    const double c = std::sqrt((1 - p.r) * (1 + p.r)), k = std::tan(p.theta) / std::sqrt(2.0);
    const double height = box_height + std::max(p.eta, 0.0) - p.eta;
    std::array<double, paper_points> excess, over_c;
    std::array<std::array<double, paper_points>, 4> in_excess;
    for (std::size_t j = 0; j < paper_points; ++j) {
        excess[j] = height * (1 + rule.node[j]) / 2;
        over_c[j] = (p.eta + excess[j]) / c;
        const double root = std::sqrt(excess[j]);
        const double w = rule.weight[j] * height / 2;
        for (const std::size_t q : which)
            in_excess[q][j] = w * (q == 0 ? 1 : q == 1 ? excess[j] * root : q == 2 ? root : excess[j]);
    }
    Values out{{}, no_estimate, static_cast<long>(paper_points * paper_points)};
    for (std::size_t i = 0; i < paper_points; ++i) {
        const double t = box_t * (1 + rule.node[i]) / 2;
        const double shift = p.r * t / c;
        std::array<double, 4> row{};
        for (std::size_t j = 0; j < paper_points; ++j) {
            const double z = over_c[j] - shift;
            const double g = std::exp(-z * z / 2);
            for (const std::size_t q : which) row[q] += in_excess[q][j] * g;
        }
        const double common = rule.weight[i] * box_t / 2 * std::erf(k * t) * std::exp(-t * t / 2) / (2 * p.theta * c);
        for (const std::size_t q : which)
            out.value[q] += common * row[q] * (q == 0 ? 1 : q == 3 ? 1 / t : 1 / std::sqrt(t));
    }
    return out;
}

/// Four integrals, or the stiffness alone.
template <bool all>
Values box_eigen(const Problem& p) {
    const auto& rule = nodes<paper_points>;
    const double c = std::sqrt((1 - p.r) * (1 + p.r)), k = std::tan(p.theta) / std::sqrt(2.0);
    const double height = box_height + std::max(p.eta, 0.0) - p.eta;
    constexpr std::size_t eights = Nodes<paper_points>::eights;
    std::array<Eight, eights> over_c, excess, half, weighted;
    for (std::size_t j = 0; j < eights; ++j) {
        excess[j] = height * rule.node[j];
        over_c[j] = (p.eta + excess[j]) / c;
        half[j] = excess[j].sqrt();
        weighted[j] = height * rule.weight[j];
    }
    std::array<Eight, 4> sum;
    for (Eight& s : sum) s.setZero();
    for (std::size_t i = 0; i < eights; ++i) {
        const Eight t = box_t * rule.node[i];
        Eight erf;
        for (Eigen::Index lane = 0; lane < 8; ++lane) erf[lane] = std::erf(k * t[lane]);
        const Eight at_0 = box_t * rule.weight[i] * erf * (t * t * -0.5).exp();
        const Eight at_half = at_0 / t.sqrt();
        const Eight at_1 = at_0 / t;
        const Eight shift = p.r / c * t;
        for (Eigen::Index lane = 0; lane < 8; ++lane) {
            std::array<Eight, 4> row;
            for (Eight& s : row) s.setZero();
            for (std::size_t j = 0; j < eights; ++j) {
                const Eight g = weighted[j] * ((over_c[j] - shift[lane]).square() * -0.5).exp();
                const Eight g_half = g * half[j];
                row[2] += g_half;
                if constexpr (all) {
                    row[0] += g;
                    row[1] += g_half * excess[j];
                    row[3] += g * excess[j];
                }
            }
            sum[2] += at_half[lane] * row[2];
            if constexpr (all) {
                sum[0] += at_0[lane] * row[0];
                sum[1] += at_half[lane] * row[1];
                sum[3] += at_1[lane] * row[3];
            }
        }
    }
    const double factor = 1 / (2 * p.theta * c);
    return {{factor * sum[0].sum(), factor * sum[1].sum(), factor * sum[2].sum(), factor * sum[3].sum()},
            no_estimate,
            static_cast<long>(paper_points * paper_points)};
}

// The hand-tuned rule: both substitutions and the moving box of window.hpp, fixed-size arrays in registers, one
// vectorised exponential a node, no power, no heap, all four integrals from the same nodes. The outer direction is
// vectorised too, and borrows fstiff's erf: std::erf would add 0.4 microseconds.

/// int 2 w^(1,2,3,4) exp(-(w^2 + x)^2/2) dw/2 in the lanes of \p sum, exp(-max(x,0)^2/2) taken out.
template <std::size_t N>
EIGEN_ALWAYS_INLINE void tuned_row(double x, double from, double width, double shift, std::array<Eight, 4>& sum) {
    for (Eight& s : sum) s.setZero();
    for (std::size_t j = 0; j < Nodes<N>::eights; ++j) {
        const Eight w = from + width * nodes<N>.node[j];
        const Eight v = w * w;
        Eight g = nodes<N>.weight[j] * w * (v * (-0.5 * v - x) - shift).exp();
        sum[0] += g;
        g *= w;
        sum[1] += g;
        g *= w;
        sum[2] += g;
        g *= w;
        sum[3] += g;
    }
}

/// NS x NW nodes; with NW = 0 as many in each row as it needs for 1e-12.
template <std::size_t NS, std::size_t NW>
Values tuned(const Problem& p, double depth, double column_depth) {
    const Window window(p, depth, column_depth);
    const double s_width = window.s_to - window.s_from, over_c = 1 / window.c, twice_depth = 2 * depth;
    std::array<Eight, 4> sum, row;
    for (Eight& total : sum) total.setZero();
    long evaluations = 0;
    for (std::size_t i = 0; i < Nodes<NS>::eights; ++i) {
        const Eight s = window.s_from + s_width * nodes<NS>.node[i];
        const Eight t = s * s;
        const Eight x = (p.eta - p.r * t) * over_c;
        const Eight ahead = x.max(0.0), behind = x.min(0.0);
        const Eight radius = (ahead * ahead + twice_depth).sqrt();
        const Eight from = (-x - radius).max(0.0).sqrt();
        const Eight width = (radius - x).sqrt() - from;
        Eight erf;
        fstiff::math::erf_of_eight(t.data(), window.k, erf.data());
        const Eight at_half =
            nodes<NS>.weight[i] * width * erf * (0.5 * (window.floor * window.floor - t * t - ahead * ahead)).exp();
        const Eight at_0 = at_half * s, at_1 = at_half / s, shift = 0.5 * behind * behind;
        for (Eigen::Index lane = 0; lane < 8 && 8 * i + static_cast<std::size_t>(lane) < NS; ++lane) {
            const auto fill = [&]<std::size_t N>() {
                tuned_row<N>(x[lane], from[lane], width[lane], shift[lane], row);
                evaluations += static_cast<long>(N);
            };
            if constexpr (NW > 0)
                fill.template operator()<NW>();
            else if (x[lane] >= 0)
                fill.template operator()<24>();
            else if (x[lane] > -3.25)
                fill.template operator()<32>();
            else
                fill.template operator()<40>();
            sum[0] += at_0[lane] * row[0];
            sum[1] += at_half[lane] * row[3];
            sum[2] += at_half[lane] * row[1];
            sum[3] += at_1[lane] * row[2];
        }
    }
    const double factor = s_width * 2 / p.theta * std::exp(-0.5 * window.floor * window.floor);
    const double root_c = std::sqrt(window.c);
    return {{factor * sum[0].sum(), factor * sum[1].sum() * window.c * root_c, factor * sum[2].sum() * root_c,
             factor * sum[3].sum() * window.c},
            no_estimate,
            evaluations};
}

/// As many nodes as the problem needs for 1e-12 on the plain grid, in both directions.
Values tuned_to_problem(const Problem& p) {
    constexpr double depth = 31.6, column_depth = 31.1;
    const bool far = p.r * p.r * p.eta * p.eta > 1.3 * (1 - p.r * p.r) && p.eta > 0;  // the Gaussian is clear of t = 0
    return far ? tuned<40, 0>(p, depth, column_depth) : tuned<32, 0>(p, depth, column_depth);
}

const Rows rows_of_gauss_legendre([] {
    const std::string points = "50x50";
    row("gauss_legendre-scalar", "stiffness", plain, points, one, 1e-4,
        [](const Problem& p) { return box_scalar(p, one); });
    row("gauss_legendre-scalar", "four", plain, points, four, 1e-4,
        [](const Problem& p) { return box_scalar(p, four); });
    row("gauss_legendre-eigen", "stiffness", plain, points, one, 1e-4, box_eigen<false>);
    row("gauss_legendre-eigen", "four", plain, points, four, 1e-4, box_eigen<true>);
    // the fewest nodes that meet the tolerance on the plain grid, and the depths that leave the least error with them:
    // by search
    const auto add = [](const char* method, double tolerance, auto integrals) {
        row(method, "four", plain, text_of(tolerance), four, tolerance, integrals);
    };
    add("gauss_legendre-tuned", 1e-3, [](const Problem& p) { return tuned<10, 12>(p, 11.9, 8.4); });
    add("gauss_legendre-tuned", 1e-6, [](const Problem& p) { return tuned<21, 24>(p, 18.8, 15.8); });
    add("gauss_legendre-tuned", 1e-9, [](const Problem& p) { return tuned<31, 32>(p, 25.2, 23.7); });
    add("gauss_legendre-tuned", 1e-12, [](const Problem& p) { return tuned<40, 40>(p, 31.6, 31.1); });
    add("gauss_legendre-fitted", 1e-12, tuned_to_problem);
    row("gauss_legendre-fitted", "four", hard, text_of(1e-12), four, 1e-6, tuned_to_problem, Expect::wrong);
});

}  // namespace
