// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Units, missing points and steps of the options, for a file of numbers that states none.
///
/// Units       m

#include <fstiff/io/surface_file.hpp>

namespace fstiff::inline v0_1::io::detail {

/// Whether \p options give a size of a map.
inline bool gives_size(const SurfaceOptions& options) {
    return options.dx || options.dy || options.width || options.height;
}
/// Whether \p options ask for a profile, or have a use for one alone.
inline bool asks_for_profile(const SurfaceOptions& options) {
    return options.format == SurfaceFormat::profile || options.column != 0 || options.x_column != 0 || options.spacing;
}

/// Units of x and y and of the heights, and their factors [m].
struct GivenUnits {
    std::string lengths, heights;
    double lateral{}, vertical{};

    /// "x and y in um, heights in nm, from options"
    [[nodiscard]] std::string note() const;
};
/// \p of_positions: whether the file has positions too. \throws domain_error without units, or for one of no length.
GivenUnits given_lengths(const SurfaceOptions& options, const std::string& name, bool of_positions);

/// Gives the numbers \p heights their unit [m]; NaN of those that the options mark as missing. \return that mark, for a
/// record \throws domain_error for a suspected one where the options mark none.
std::string take_heights(std::vector<double>& heights, const GivenUnits& units, const SurfaceOptions& options,
                         const std::string& name);

/// An option of a length, by its name; its value [m].
struct LengthOption {
    std::string name;
    std::optional<double> value;
};
/// The option that gives a step of a map, its value, and that step.
struct GivenStep {
    std::string option;
    double value{}, step{};
};
/// The step between \p points by the option \p each, or by \p whole, the length of them all, which is appended to
/// \p from; none where neither is given. \throws domain_error for both, and unless it is finite and greater than 0.
std::optional<GivenStep> step_of_options(const LengthOption& each, const LengthOption& whole, std::size_t points,
                                         const std::string& name, std::string& from);

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
