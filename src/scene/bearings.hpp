// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The crowded contacts of maps by their bearing curves, and their highest points. They cost a sort and a transform of each map,
// so that they are made when a law first asks for them; all copies of a surface share them.

#include <fstiff/contact/bearing_contact.hpp>
#include <fstiff/contact/hand_over.hpp>
#include <fstiff/contact/plastic_contact.hpp>
#include <fstiff/measured/height_shape.hpp>
#include <fstiff/topography/height_map.hpp>
#include <fstiff/topography/line_transform.hpp>

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <tuple>
#include <vector>

namespace fstiff::scene {

/// The bearing curve of heights over their rms; none of a Gaussian shape. \throws domain_error as bearing_of_moments.
[[nodiscard]] std::shared_ptr<const BearingSlope<double>> bearing_of_shape(const HeightShape<double>& shape);

class BearingsOfMaps {
public:
    explicit BearingsOfMaps(std::vector<std::shared_ptr<const HeightMap<double>>> maps) : maps_(std::move(maps)) {}

    /// Of the map number \p index. \throws domain_error for missing points, and as PerssonContact.
    [[nodiscard]] BearingContact<double> contact(std::size_t index, Edges edges, double modulus, double gamma) const;
    /// How hybrid goes from the summits of the map number \p index to that. \throws domain_error as contact() and SummitContact.
    [[nodiscard]] HandOver<double> hand_over(std::size_t index, Edges edges, double modulus, double gamma) const;
    /// The highest points of the map number \p index. \throws domain_error as HighestPoints.
    [[nodiscard]] MapCut<double> cut(std::size_t index, Edges edges, double modulus) const;

private:
    std::vector<std::shared_ptr<const HeightMap<double>>> maps_;
    mutable std::mutex guard_;
    mutable std::map<std::tuple<std::size_t, Edges, double, double>, BearingContact<double>> made_;
    mutable std::map<std::tuple<std::size_t, Edges, double, double>, HandOver<double>> hand_overs_;
    mutable std::map<std::tuple<std::size_t, Edges, double>, MapCut<double>> cuts_;
};

}  // namespace fstiff::scene
