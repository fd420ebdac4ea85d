// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Fractal parameters of a profile, and the scaling of its structure function.
///
///     S(tau) = C tau^(4-2D)                                                         eq. (2.3)
///
/// Reference   Buczkowski, Kleiber, Starzynski, Arch. Mech. 66 (2014), eqs. (2.1)-(2.5); the constants C:
///             docs/errata.md
/// Units       D dimensionless; G in the length unit of heights and distances (SI: m); S in its square
/// Valid       1 < D < 2, G > 0

#include <fstiff/core/error.hpp>
#include <fstiff/core/names.hpp>

namespace fstiff { inline namespace v0_1 {

/// Fractal dimension D and fractal roughness G of a profile.
template <Real T = double>
struct Fractal {
    T dimension{};  ///< D, in (1, 2)
    T roughness{};  ///< G [m], > 0
};

namespace detail {

/// \throws domain_error unless 1 < D < 2.
template <Real T>
constexpr void require_fractal_dimension(T dimension) {
    require(dimension > T(1) && dimension < T(2), "fractal_dimension", dimension, "between 1 and 2, both excluded");
}

}  // namespace detail

}}  // namespace fstiff
