// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Roughness parameters of one nominally flat surface, as in Table 1 of the reference paper.
///
/// Units       SI
/// Valid       every length and density finite and > 0; max_peak_height 0 when it is not known

#include <fstiff/core/error.hpp>

namespace fstiff::inline v0_1 {

/// A rough surface in four numbers.
template <Real T = double>
struct Roughness {
    T rms_height{};       ///< sigma = R_q [m]
    T peak_radius{};      ///< R, mean radius of curvature at the peaks [m]
    T peak_density{};     ///< D_p, peaks per nominal area [1/m^2]
    T max_peak_height{};  ///< R_p, highest peak above the mean plane [m]; 0: not known

    /// \throws domain_error naming the first parameter that is out of range.
    constexpr void validate() const {
        require_positive("rms_height", rms_height);
        require_positive("peak_radius", peak_radius);
        require_positive("peak_density", peak_density);
        if (max_peak_height != T(0)) require_positive("max_peak_height", max_peak_height);
    }
};

}  // namespace fstiff::inline v0_1
