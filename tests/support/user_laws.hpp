// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Laws of an asperity as a user writes them, without powers of the interference: their integrals have two dimensions.
#include <fstiff/asperity/laws.hpp>

#include <cmath>
#include <numbers>

namespace test {

/// Hertz without its powers.
struct HertzByUser {
    static constexpr fstiff::NodeClustering axis = fstiff::NodeClustering::even;
    static constexpr bool stiffness_is_slope = true;
    auto load(const auto& omega, double radius) const {
        return (4.0 / 3 * std::sqrt(radius) * omega * sqrt(omega)).eval();
    }
    auto stiffness(const auto& omega, double radius) const { return (2 * std::sqrt(radius) * sqrt(omega)).eval(); }
    auto area(const auto& omega, double radius) const { return (std::numbers::pi * radius * omega).eval(); }
};

/// Hertz up to omega_c = R/500; beyond it the load is a line and the stiffness is still the root of the area.
struct YieldByUser {
    double critical(double radius) const { return 0.002 * radius; }
    auto load(const auto& omega, double radius) const {
        const double c = critical(radius), root = std::sqrt(radius * c);
        return (omega < c)
            .select(4.0 / 3 * std::sqrt(radius) * omega * sqrt(omega), root * (4.0 / 3 * c + 2 * (omega - c)))
            .eval();
    }
    auto stiffness(const auto& omega, double radius) const { return (2 * std::sqrt(radius) * sqrt(omega)).eval(); }
    auto area(const auto& omega, double radius) const { return (std::numbers::pi * radius * omega).eval(); }
};

}  // namespace test
