// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// hybrid from the heights of a map on: its summits, its bearing curve, the hand-over.
#include <fstiff/contact/hand_over.hpp>
#include <fstiff/contact/hybrid_contact.hpp>
#include <fstiff/contact/summit_contact.hpp>
#include <fstiff/topography/gaussian_order.hpp>
#include <fstiff/topography/map_spectrum.hpp>

namespace bench {

/// Of a map that repeats itself, the effective modulus being 1.
inline auto hybrid_of_map(const fstiff::HeightMap<double>& map) {
    const auto order = fstiff::parts::gaussian_order(map);
    const fstiff::Summits<double> summits = fstiff::summits_of(map);
    const fstiff::parts::BearingContact<double> crowded(
        fstiff::PerssonContact<double>(fstiff::map_spectrum(order.map, fstiff::Edges::periodic), 1.0), order.curve,
        order.rms_height);
    return fstiff::HybridContact(fstiff::SummitContact<double>(summits, 1.0), crowded,
                                 fstiff::parts::hand_over_of(summits, crowded, fstiff::Edges::periodic));
}

}  // namespace bench
