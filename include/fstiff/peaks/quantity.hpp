// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The quantities of a contact, as a set: only quantities that are asked for are computed.

#include <fstiff/core/config.hpp>

namespace fstiff { inline namespace v0_1 {

/// Quantities to be computed; join several by |.
enum class Quantity : unsigned {
    none = 0,
    contact_density = 1,
    pressure = 2,
    stiffness = 4,
    real_area_fraction = 8,
    loading_stiffness = 16,  ///< -dp/dd, the slope of the load
    separation = 32,         ///< known without asking, but an integral over pressures in HybridContact, PerssonContact
    all = 63
};

/// Both.
[[nodiscard]] constexpr Quantity operator|(Quantity a, Quantity b) {
    return static_cast<Quantity>(static_cast<unsigned>(a) | static_cast<unsigned>(b));
}

namespace detail {

/// \p set less \p part.
[[nodiscard]] constexpr Quantity without(Quantity set, Quantity part) {
    return static_cast<Quantity>(static_cast<unsigned>(set) & ~static_cast<unsigned>(part));
}

/// True if \p set contains any quantity of \p part.
[[nodiscard]] constexpr bool has(Quantity set, Quantity part) {
    return (static_cast<unsigned>(set) & static_cast<unsigned>(part)) != 0;
}

}  // namespace detail

}}  // namespace fstiff
