// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// A measured surface as the laws take it: measured_face() of answer/joint.hpp, in fstiff/implementation.hpp and in
/// fstiff::double.

#include <fstiff/answer/face.hpp>
#include <fstiff/answer/measured_map.hpp>
#include <fstiff/answer/measured_map_inline.hpp>
#include <fstiff/measure/measure.hpp>
#include <fstiff/measure/roughness_cut_off.hpp>
#include <fstiff/topography/gaussian_map_filter.hpp>

#include <memory>
#include <tuple>
#include <utility>
#include <vector>

namespace fstiff { inline namespace v0_1 {

namespace detail {

/// The map of \p surface in a contact: with all of its short waves, unless a lambda_s was given.
FSTIFF_INLINE std::shared_ptr<const HeightMap<double>> map_of_contact(const Surface<double>& surface) {
    const auto& [cut_offs, map] = std::tie(surface.cut_offs, surface.map);
    if (cut_offs.why_s != LambdaSReason::by_table || !map->unfiltered) return {map, &map->map};
    if (!cut_offs.lambda_c) return map->unfiltered;
    if (cut_offs.filter == CutOffFilter::robust) return {map, &map->map};
    return std::make_shared<const HeightMap<double>>(detail::gaussian_high_pass(*map->unfiltered, *cut_offs.lambda_c));
}

/// \p surface as the contact sees it, with the maps of \p shared, where there are any, in place of its own.
FSTIFF_INLINE Face face_as_found(const Surface<double>& surface,
                                 const std::shared_ptr<const MapOfSurface>& shared = nullptr) {
    Face face;
    face.parameters = surface;
    face.parameters.profile_fit.reset(), face.parameters.map_fit.reset(), face.parameters.islands.reset();
    if (!face.has_peaks()) face.parameters.r.reset(), face.parameters.theta.reset();
    face.widest_band = surface.widest_band;
    face.lambda_s = surface.cut_offs.lambda_s;
    face.heights = surface.heights;
    if (surface.heights) {
        const bool all = surface.all_waves && surface.all_waves->moments.bandwidth() > 1.5;  // else of no spectrum
        const HeightStatistics<double>& waves = all ? *surface.all_waves : *surface.heights;
        face.rms_gradient = waves.rms_gradient.value;
        face.gradient_error = waves.rms_gradient.error;
        face.alpha = waves.moments.bandwidth();
        face.set_shape(detail::counted_shape(*surface.heights, surface.shape_share));
    }
    std::vector<std::shared_ptr<const HeightMap<double>>> maps;  // which live as long as what was measured
    if (surface.map) maps.push_back(map_of_contact(surface));
    for (const Surface<double>& part : surface.parts)
        if (part.map) maps.push_back(map_of_contact(part));
    if (surface.map && maps.front().get() != &surface.map->map) face.filtered = {surface.map, &surface.map->map};
    if (shared)
        face.map = shared;
    else if (!maps.empty())
        face.map = map_of_surface(std::move(maps));
    const bool has_all_waves = surface.cut_offs.why_s == LambdaSReason::by_table;  // K does not depend on lambda_s
    for (const Surface<double>& neighbour : surface.neighbours) {
        face.neighbours.push_back(face_as_found(neighbour, has_all_waves ? face.map : nullptr));
        Face& other = face.neighbours.back();
        if (!other.has_peaks()) other.parameters.r = face.parameters.r, other.parameters.theta = face.parameters.theta;
        if (surface.all_waves) other.rms_gradient = face.rms_gradient, other.alpha = face.alpha;
    }
    return face;
}

/// What measured_face() makes.
class FaceOfSurface final : public MeasuredFace {
public:
    explicit FaceOfSurface(std::shared_ptr<const Surface<double>> surface) : face_(face_as_found(*surface)) {
        face_.measured = std::move(surface);
    }
    const Surface<double>& surface() const override { return *face_.measured; }
    Face face() const override { return face_; }

private:
    Face face_;
};

}  // namespace detail

FSTIFF_INLINE std::shared_ptr<const MeasuredFace> measured_face(std::shared_ptr<const Surface<double>> surface) {
    if (!surface) throw domain_error("surface: must not be null");
    return std::make_shared<const detail::FaceOfSurface>(std::move(surface));
}

FSTIFF_INLINE std::shared_ptr<const MeasuredFace> measured_face(Surface<double> surface) {
    return measured_face(std::make_shared<const Surface<double>>(std::move(surface)));
}

}}  // namespace fstiff
