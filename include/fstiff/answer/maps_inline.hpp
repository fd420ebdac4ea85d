// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The functions of answer/maps.hpp: inline, or compiled in fstiff::double.

#include <fstiff/answer/maps.hpp>

#include <fstiff/surface/bearing_family.hpp>
#include <fstiff/topography/gaussian_order.hpp>
#include <fstiff/topography/map_spectrum.hpp>

namespace fstiff::inline v0_1::detail {

FSTIFF_INLINE std::shared_ptr<const parts::BearingSlope<double>> bearing_of_shape(
    const parts::HeightShape<double>& shape) {
    if (shape.is_gaussian()) return nullptr;
    return std::make_shared<const parts::BearingSlope<double>>(
        parts::bearing_of_moments(shape.skewness, shape.kurtosis));
}

FSTIFF_INLINE parts::BearingContact<double> BearingsOfMaps::contact(std::size_t index, Edges edges, double modulus,
                                                                    double gamma) const {
    return kept(made_, {index, edges, modulus, gamma}, [&] {
        parts::GaussianOrder<double> order = parts::gaussian_order(*maps_[index]);
        const PerssonContact<double> gaussian(map_spectrum(order.map, edges), modulus, gamma);
        return parts::BearingContact<double>(gaussian, std::move(order.curve), order.rms_height);
    });
}

FSTIFF_INLINE parts::HandOver<double> BearingsOfMaps::hand_over(std::size_t index, Edges edges, double modulus,
                                                                double gamma) const {
    return kept(hand_overs_, {index, edges, modulus, gamma},
                [&] { return parts::hand_over_of(summits_[index], contact(index, edges, modulus, gamma), edges); });
}

FSTIFF_INLINE parts::MapCut<double> BearingsOfMaps::cut(std::size_t index, Edges edges, double modulus) const {
    return kept(cuts_, {index, edges, modulus}, [&] { return parts::MapCut<double>(*maps_[index], modulus, edges); });
}

}  // namespace fstiff::inline v0_1::detail
