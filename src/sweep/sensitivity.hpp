// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// How much of the scatter of K comes from each distributed input.
//
//     S_i = Var(E[K | x_i])/Var(K)        first-order index of Sobol': the share of the variance that would vanish on
//                                         average if x_i were known
//     S_i ~ (mean of K_(j) K_(j+1) - mean(K)^2)/Var(K)     with K in the order of x_i, the last followed by the first
//     rho_i = correlation of the ranks of x_i and K (Spearman): whether K rises or falls with x_i, -1 to 1
//
// The difference of the sum of S_i from 1 is due to inputs acting together. Both need only the
// available draws.
//
// Reference   Gamboa, Gremaud, Klein, Lagnoux, Bernoulli 28 (2022) 2345, eq. (12) (the estimator by ranks); Sobol',
//             Math. Comput. Simul. 55 (2001) 271 (the index)
// Accuracy    the estimate scatters by about 1/sqrt(draws) (tests/sweep/sensitivity_test.cpp, against the closed form
//             of a product of powers of lognormal inputs)

#include "sweep/grid.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fstiff::sweep {

struct Sensitivity {
    double first_order = 0;       ///< S_i; a little below 0 or above 1 by its scatter
    double rank_correlation = 0;  ///< rho_i
};

/// Sensitivity of \p output to \p input, with equally many values, at least 3; none where the output does not vary.
[[nodiscard]] std::optional<Sensitivity> sensitivity(std::span<const double> input, std::span<const double> output);

/// Sensitivities of K of one law, joint distribution of peaks and point of a scene.
struct SensitivityRow {
    std::string law;
    std::optional<double> theta{}, r{};
    std::size_t point = 0;
    std::optional<double> pressure{};    ///< that all scenes have [Pa]; none where they differ
    std::size_t draws = 0, places = 0;   ///< draws that have a K at each point of the grid; points of the grid
    std::vector<Sensitivity> of_inputs;  ///< in the order of the distributed axes; means over the points of the grid
};

/// Sensitivities in the results \p file of the whole \p grid, which has a distribution. Of more than a million draws at
/// one point of the grid the first million is taken. \throws domain_error where no K in the results varies.
[[nodiscard]] std::vector<SensitivityRow> sensitivities(const Grid& grid, const std::string& file);

}  // namespace fstiff::sweep
