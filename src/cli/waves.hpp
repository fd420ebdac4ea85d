// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The section [ultrasound] of a scene: the waves that meet the contact, and what they see of a stiffness K.

#include <fstiff/core/estimate.hpp>
#include <fstiff/ultrasound/propagation.hpp>
#include <fstiff/ultrasound/spring_interface.hpp>

#include <cmath>
#include <limits>
#include <optional>

namespace fstiff::cli {

/// Longitudinal waves see K, shear waves the tangential stiffness.
struct Waves {
    double frequency = 0;                     ///< [Hz]
    Impedances<double> longitudinal{};        ///< the wave comes from material.upper
    std::optional<Impedances<double>> shear;  ///< none: not known

    [[nodiscard]] double angular() const { return angular_frequency(frequency); }
};

/// |R| of the stiffness \p value; its error is that of \p value carried on to first order, and the rounding of R.
inline Estimate<double> reflection_of(double value, double error, const Impedances<double>& media, double angular) {
    Estimate<double> result;
    result.value = reflection(value, media, angular);
    result.error = std::abs(reflection_slope(value, media, angular)) * error +
                   spring_interface_ulps * std::numeric_limits<double>::epsilon() * result.value;
    return result;
}

}  // namespace fstiff::cli
