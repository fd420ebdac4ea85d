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
    const std::lock_guard lock(guard_);
    const auto key = std::tuple(index, edges, modulus, gamma);
    if (const auto found = made_.find(key); found != made_.end()) return found->second;
    parts::GaussianOrder<double> order = parts::gaussian_order(*maps_[index]);
    const PerssonContact<double> gaussian(map_spectrum(order.map, edges), modulus, gamma);
    return made_.emplace(key, parts::BearingContact<double>(gaussian, std::move(order.curve), order.rms_height))
        .first->second;
}

FSTIFF_INLINE parts::HandOver<double> BearingsOfMaps::hand_over(std::size_t index, Edges edges, double modulus,
                                                                double gamma) const {
    const parts::BearingContact<double> crowded = contact(index, edges, modulus, gamma);
    const std::lock_guard lock(guard_);
    const auto key = std::tuple(index, edges, modulus, gamma);
    if (const auto found = hand_overs_.find(key); found != hand_overs_.end()) return found->second;
    return hand_overs_.emplace(key, parts::hand_over_of(summits_[index], crowded, edges)).first->second;
}

FSTIFF_INLINE parts::MapCut<double> BearingsOfMaps::cut(std::size_t index, Edges edges, double modulus) const {
    const std::lock_guard lock(guard_);
    const auto key = std::tuple(index, edges, modulus);
    if (const auto found = cuts_.find(key); found != cuts_.end()) return found->second;
    return cuts_.emplace(key, parts::MapCut<double>(*maps_[index], modulus, edges)).first->second;
}

}  // namespace fstiff::inline v0_1::detail
