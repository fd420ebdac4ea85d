// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Files of points that may hold one row: that row is a profile, and its dy is no more than a word.
///
/// Units       m

#include <fstiff/io/surface_file.hpp>

namespace fstiff::io {

/// A map and how it was read.
struct DescribedMap {
    HeightMap<double> map;
    std::vector<std::string> sentences;
    std::vector<std::string> warnings{};
    double resolution{};  ///< step in which the heights are counted [m]; 0 where it is not known
};

namespace detail {

/// A map of one row has \p points at least, a map of more at least as many a side. \throws domain_error otherwise.
void validate_map_or_row(const HeightMap<double>& map, Eigen::Index points);

/// Gives \p map the spacings that file \p name states: dy = dx for one row whose dy is 0.
/// \throws domain_error when the heights are too few, do not vary, or are not finite.
void set_spacings(HeightMap<double>& map, double dx, double dy, const std::string& name);

/// One row is a profile, which has 16 points at least. \throws domain_error naming the file \p name.
ProfileOrMap as_surface(HeightMap<double> map, const std::string& name);

}  // namespace detail

}  // namespace fstiff::io
