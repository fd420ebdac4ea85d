// SPDX-License-Identifier: BSD-3-Clause
#include "surface/facing.hpp"

#include "document/shown_unit.hpp"
#include "surface/points_json.hpp"

#include <fstiff/core/error.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace fstiff::surface {
namespace {

/// The common points of two axes: where they begin on each, and how many there are.
struct Overlap {
    Eigen::Index lower{}, upper{}, count{};
};

Overlap overlap(Eigen::Index lower, Eigen::Index upper, Eigen::Index shift) {
    const Eigen::Index begin = std::max<Eigen::Index>(0, shift);
    return {begin, begin - shift, std::min(lower, upper + shift) - begin};
}

/// By how many points \p upper begins after \p lower along \p axis.
Eigen::Index shift_of(const io::Surface& lower, const io::Surface& upper, std::size_t axis) {
    const double step = axis == 0 ? lower.map().dx : lower.map().dy;
    const double shift = ((*upper.record.origin)[axis] - (*lower.record.origin)[axis]) / step;
    if (!(std::abs(shift) < 1e9) || std::abs(shift - std::round(shift)) > 0.01)
        throw domain_error(upper.record.name + ": has points between those of " + lower.record.name +
                           "; both faces must be on one grid: grid puts them there");
    return static_cast<Eigen::Index>(std::llround(shift));
}

/// Refuses an upper face that lies below the lower one by more than their heights explain.
void require_order(const HeightMap<double>::Array& sum, const std::string& upper, const std::string& lower) {
    double count = 0, mean = 0, squares = 0;
    for (const double h : sum.reshaped())
        if (!std::isnan(h)) ++count, mean += h;
    mean /= count;
    for (const double h : sum.reshaped())
        if (!std::isnan(h)) squares += (h - mean) * (h - mean);
    if (mean > 3 * std::sqrt(squares / count) && squares > 0)
        throw domain_error(upper + ": lies below " + lower + " by " + document::shown_length(mean, 3) +
                           " in the mean; facing must be the upper face, z upwards in both files");
}

/// The surface in the \p bytes of \p file.
io::Surface surface_of(std::string bytes, const std::string& file, const io::SurfaceOptions& reading) {
    const std::string name = document::display_name(file);
    if (!is_points_json(bytes)) return io::read_surface(std::move(bytes), name, reading);
    PointLines points = lines_of_points(bytes, name);
    io::Surface surface = io::read_surface(std::move(points.text), name, reading);
    surface.record.details.push_back("JSON: " + std::to_string(points.points) + " points" +
                                     (points.list.empty() ? "" : " of the list " + points.list));
    return surface;
}

}  // namespace

void add_facing(io::Surface& lower, const io::Surface& upper) {
    const std::string &name = upper.record.name, &other = lower.record.name;
    if (lower.is_profile() || upper.is_profile())
        throw domain_error((lower.is_profile() ? other : name) +
                           ": is a profile; faces that look at each other must be maps");
    HeightMap<double>& map = std::get<1>(lower.data);
    const HeightMap<double>& above = upper.map();
    if (std::abs(above.dx / map.dx - 1) > 1e-6 || std::abs(above.dy / map.dy - 1) > 1e-6)
        throw domain_error(name + ": has points " + document::shown_length(above.dx) + " and " +
                           document::shown_length(above.dy) + " apart, and " + other + " " +
                           document::shown_length(map.dx) + " and " + document::shown_length(map.dy) +
                           "; both faces must be on one grid: grid puts them there");
    const bool placed = lower.record.origin && upper.record.origin;
    if (!placed && (above.rows() != map.rows() || above.columns() != map.columns()))
        throw domain_error(name + ": has " + std::to_string(above.columns()) + " x " + std::to_string(above.rows()) +
                           " points without a place, and " + other + " " + std::to_string(map.columns()) + " x " +
                           std::to_string(map.rows()) + "; maps without positions must be alike");
    const Overlap x = overlap(map.columns(), above.columns(), placed ? shift_of(lower, upper, 0) : 0),
                  y = overlap(map.rows(), above.rows(), placed ? shift_of(lower, upper, 1) : 0);
    if (x.count < 4 || y.count < 4)
        throw domain_error(name + ": covers " + (x.count > 0 && y.count > 0 ? "hardly any" : "no") + " points of " +
                           other + "; both faces must be measured in one coordinate system");
    map.heights = (map.heights.block(y.lower, x.lower, y.count, x.count) -
                   above.heights.block(y.upper, x.upper, y.count, x.count))
                      .eval();
    map.validate(2);
    require_order(map.heights, name, other);
    if (placed) {
        (*lower.record.origin)[0] += static_cast<double>(x.lower) * map.dx;
        (*lower.record.origin)[1] += static_cast<double>(y.lower) * map.dy;
    }
    for (const std::string& detail : upper.record.details) lower.record.details.push_back("facing " + detail);
    for (const std::string& warning : upper.record.warnings) lower.record.warnings.push_back(name + ": " + warning);
    lower.record.details.push_back("facing: sum of both faces, " + std::to_string(x.count) + " x " +
                                   std::to_string(y.count) + " points, the upper one of " + name);
    lower.record.resolution = 0;
}

void read_faces(const SurfaceOptions& options, std::string bytes, io::SurfaceOptions reading, SurfaceInput& input) {
    input.sha256 = document::sha256(bytes);
    input.surface = surface_of(std::move(bytes), options.file, reading);
    if (options.facing.empty()) return;
    std::string upper = document::read_all(options.facing);
    input.sha256 = document::sha256(input.sha256 + "\n" + document::sha256(upper) + "\n");
    if (reading.grid) reading.grid_origin = input.surface.record.origin;
    add_facing(input.surface, surface_of(std::move(upper), options.facing, reading));
}

}  // namespace fstiff::surface
