// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The picture of a sweep: K against the swept quantity with the most values, a line for each value of the next one, and
// the median with 5 to 95 % over all others and over the draws.

#include "picture/plot.hpp"
#include "sweep/grid.hpp"

namespace fstiff::cli {

/// Picture of the results \p file of the whole \p grid. Where nothing is swept but distributions, at one point, the
/// share of the scenes below K. \throws domain_error where the results have no K.
Figure sweep_figure(const sweep::Grid& grid, const std::string& file);

/// "rms height" of "surface.rms_height", for people.
std::string shown_key(const std::string& key);

}  // namespace fstiff::cli
