// SPDX-License-Identifier: BSD-3-Clause
#include "scene/bearings.hpp"

#include <fstiff/surface/bearing_family.hpp>
#include <fstiff/topography/gaussian_order.hpp>
#include <fstiff/topography/map_spectrum.hpp>

namespace fstiff::scene {

std::shared_ptr<const BearingSlope<double>> bearing_of_shape(const HeightShape<double>& shape) {
    if (shape.is_gaussian()) return nullptr;
    return std::make_shared<const BearingSlope<double>>(bearing_of_moments(shape.skewness, shape.kurtosis));
}

BearingContact<double> BearingsOfMaps::contact(std::size_t index, Edges edges, double modulus, double gamma) const {
    const std::lock_guard lock(guard_);
    const auto key = std::tuple(index, edges, modulus, gamma);
    if (const auto found = made_.find(key); found != made_.end()) return found->second;
    GaussianOrder<double> order = gaussian_order(*maps_[index]);
    const PerssonContact<double> gaussian(map_spectrum(order.map, edges), modulus, gamma);
    return made_.emplace(key, BearingContact<double>(gaussian, std::move(order.curve), order.rms_height)).first->second;
}

HandOver<double> BearingsOfMaps::hand_over(std::size_t index, Edges edges, double modulus, double gamma) const {
    const BearingContact<double> crowded = contact(index, edges, modulus, gamma);
    const std::lock_guard lock(guard_);
    const auto key = std::tuple(index, edges, modulus, gamma);
    if (const auto found = hand_overs_.find(key); found != hand_overs_.end()) return found->second;
    return hand_overs_.emplace(key, hand_over_of(summits_[index], crowded, edges)).first->second;
}

MapCut<double> BearingsOfMaps::cut(std::size_t index, Edges edges, double modulus) const {
    const std::lock_guard lock(guard_);
    const auto key = std::tuple(index, edges, modulus);
    if (const auto found = cuts_.find(key); found != cuts_.end()) return found->second;
    return cuts_.emplace(key, MapCut<double>(*maps_[index], modulus, edges)).first->second;
}

}  // namespace fstiff::scene
