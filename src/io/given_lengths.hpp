// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Units and steps of the options, for a file of numbers that states none.
///
/// Units       m

#include <fstiff/io/surface_file.hpp>

namespace fstiff::inline v0_1::io::detail {

/// Units of x and y and of the heights, and their factors [m].
struct GivenUnits {
    std::string lengths, heights;
    double lateral{}, vertical{};

    /// "x and y in um, heights in nm, from options"
    [[nodiscard]] std::string note() const;
};
/// \p of_positions: whether the file has positions too. \throws domain_error without units, or for one of no length.
GivenUnits given_lengths(const SurfaceOptions& options, const std::string& name, bool of_positions);

/// Steps of a map, and the options that they come from.
struct GivenSteps {
    double dx{}, dy{};
    std::string from;
};
/// Those of \p rows x \p columns points, of which one row is a profile.
/// \throws domain_error unless each is given once.
GivenSteps given_steps_of(std::size_t rows, std::size_t columns, const SurfaceOptions& options,
                          const std::string& name);

}  // namespace fstiff::inline v0_1::io::detail
