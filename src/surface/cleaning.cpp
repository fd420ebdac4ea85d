// SPDX-License-Identifier: BSD-3-Clause
#include "surface/surface_file.hpp"

#include <fstiff/double/surfaces.hpp>
#include "document/shown_unit.hpp"
#include "io/readers.hpp"

#include <fstiff/core/text.hpp>
#include <fstiff/measure/prepare.hpp>
#include <fstiff/profile/profile_repair.hpp>
#include <fstiff/topography/map_repair.hpp>

#include <algorithm>
#include <variant>

namespace fstiff::surface {
namespace {

std::string share_of_points(std::size_t count, std::size_t total) {
    return std::to_string(count) + " of " + std::to_string(total) + " points";
}

/// \throws domain_error with the name of the option unless points from \p from to \p to lie on a line of \p points at
/// \p step.
std::size_t points_of(double from, double to, std::size_t points, double step, const std::string& name) {
    const auto range = detail::points_between(from, to, points, step);
    if (!range)
        throw domain_error(name + ": from " + document::shown_length(from) + " to " + document::shown_length(to) +
                           " must rise, and lie between 0 and the length of " +
                           document::shown_length(static_cast<double>(points - 1) * step));
    if (range->count == 0) throw domain_error(name + ": no point lies between its lengths; must hold some");
    return range->count;
}

/// Points along x and y; a profile has one row.
struct Extent {
    std::size_t columns, rows;
};

Extent extent_of(const io::Surface& surface) {
    if (surface.is_profile()) return {surface.profile().size(), 1};
    const HeightMap<double>& map = surface.map();
    return {static_cast<std::size_t>(map.columns()), static_cast<std::size_t>(map.rows())};
}

/// The crop of \p options, and into \p extent what it leaves. \throws option_error, domain_error as above.
Crop<double> crop_of(const SurfaceOptions& options, const io::Surface& surface, Extent& extent) {
    const std::string name = options.name("crop");
    const std::vector<double> box = parse_lengths(options.crop, name);
    const std::size_t wanted = surface.is_profile() ? 2 : 4;
    if (box.size() != wanted)
        throw document::option_error(
            name + " = \"" + options.crop.text("m") + "\": must be " +
            (wanted == 2 ? "two lengths of a profile, \"x0,x1\"" : "four lengths of a map, \"x0,x1,y0,y1\""));
    const double dx = surface.is_profile() ? surface.profile().spacing : surface.map().dx;
    extent.columns = points_of(box[0], box[1], extent.columns, dx, name);
    if (surface.is_profile()) return {box[0], box[1]};
    extent.rows = points_of(box[2], box[3], extent.rows, surface.map().dy, name);
    return {box[0], box[1], box[2], box[3]};
}

/// Zeros and ones of a text, one row a line, or of a .npy.
HeightMap<double>::Array read_mask(const std::string& file) {
    const std::string bytes = document::read_all(file), name = document::display_name(file);
    if (const io::detail::Reader& npy = io::detail::reader_of(io::SurfaceFormat::npy); npy.begins(bytes)) {
        io::SurfaceOptions reading;
        reading.dx = reading.dy = reading.spacing = 1;
        reading.units = "m";
        reading.missing = "none";
        const io::RawMap read = npy.read(bytes, name, reading).map;
        return Eigen::Map<const HeightMap<double>::Array>(read.heights.data(), static_cast<Eigen::Index>(read.rows),
                                                          static_cast<Eigen::Index>(read.columns));
    }
    std::vector<double> values;
    std::size_t rows = 0, columns = 0, here = 0;
    for (std::size_t i = 0; i <= bytes.size(); ++i) {
        const char c = i < bytes.size() ? bytes[i] : '\n';
        if (c == '0' || c == '1') {
            values.push_back(c - '0');
            ++here;
        } else if (c == '\n') {
            if (here == 0) continue;
            if (rows > 0 && here != columns)
                throw domain_error(name + ": row " + std::to_string(rows + 1) + " has " + std::to_string(here) +
                                   " numbers; must have as many as the rows before, " + std::to_string(columns));
            columns = here;
            here = 0;
            ++rows;
        } else if (std::string_view(" \t\r,;").find(c) == std::string_view::npos) {
            throw domain_error(name + ": a mask must hold 0 and 1 alone, one row a line");
        }
    }
    return Eigen::Map<HeightMap<double>::Array>(values.data(), static_cast<Eigen::Index>(rows),
                                                static_cast<Eigen::Index>(columns));
}

/// The mask of \p options for a surface of \p extent. \throws domain_error, file_error.
PointMask mask_of(const SurfaceOptions& options, bool profile, const Extent& extent) {
    const auto marks = read_mask(options.mask);
    const auto columns = static_cast<Eigen::Index>(extent.columns), rows = static_cast<Eigen::Index>(extent.rows);
    const bool fits = profile ? marks.size() == columns && (marks.rows() == 1 || marks.cols() == 1)
                              : marks.rows() == rows && marks.cols() == columns;
    const std::string name = document::display_name(options.mask);
    if (!fits)
        throw domain_error(name + ": the mask has " + std::to_string(marks.cols()) + " x " +
                           std::to_string(marks.rows()) + " numbers; must have those of the surface, " +
                           std::to_string(columns) + " x " + std::to_string(rows));
    if (!((marks == 0) || (marks == 1)).all()) throw domain_error(name + ": a mask must hold 0 and 1 alone");
    return marks != 0;
}

/// Notes of clean().
void describe(const SurfaceOptions& options, const CleaningReport& report, bool profile,
              std::vector<std::string>& details) {
    const std::size_t points = report.columns * report.rows;
    if (!options.crop.empty())
        details.push_back("crop: " +
                          (profile ? share_of_points(report.columns, report.columns_read)
                                   : std::to_string(report.columns) + " x " + std::to_string(report.rows) + " of " +
                                         std::to_string(report.columns_read) + " x " +
                                         std::to_string(report.rows_read) + " points") +
                          " kept (" + options.crop.text("m") + ")");
    if (!options.mask.empty())
        details.push_back("mask: " + share_of_points(report.masked, points) + " became missing (" +
                          document::display_name(options.mask) + ")");
    if (report.aligned > 0)
        details.push_back("align: " + std::to_string(report.aligned) + " lines along " +
                          std::string(name_of(report.scan_axis)) + " aligned (" + std::string(name_of(options.align)) +
                          "); the steps between them had " + document::shown_length(report.line_step, 3) + " rms");
    if (options.spikes != 0)
        details.push_back("spikes: " + share_of_points(report.spikes, points) + " became missing, beyond " +
                          detail::shortest_text(options.spikes) +
                          " standard deviations from the median of their neighbours");
    if (options.fill)
        details.push_back("fill: " + share_of_points(report.filled, points) + " filled " +
                          (profile ? "by straight lines" : "by Laplace's equation") +
                          (report.filled > 0 ? ", the largest hole " + std::to_string(report.largest_hole) : ""));
}

}  // namespace

void clean(const SurfaceOptions& options, io::Surface& surface) {
    const bool profile = surface.is_profile();
    Cleaning<double> cleaning;
    Extent extent = extent_of(surface);
    if (!options.crop.empty()) cleaning.crop = crop_of(options, surface, extent);
    if (!options.mask.empty()) cleaning.mask = mask_of(options, profile, extent);
    if (options.spikes != 0)
        detail::require(options.spikes >= detail::min_spike_limit && options.spikes <= detail::max_spike_limit,
                        options.name("spikes").c_str(), options.spikes, "between 3 and 1000 standard deviations");
    cleaning.align = options.align, cleaning.scan_axis = options.scan_axis;
    cleaning.spikes = options.spikes;
    cleaning.fill = options.fill;
    const CleaningReport report =
        std::visit([&](auto& heights) { return detail::clean(heights, cleaning); }, surface.data);
    describe(options, report, profile, surface.record.details);
}

std::vector<std::string> cleaning_hints(const SurfaceOptions& options, const io::Surface& surface) {
    constexpr double sure = 30;  // standard deviations: real surfaces of heavy tails have points up to 20 or 30
    constexpr double limit = 20;
    constexpr Eigen::Index most = 1024;
    std::vector<std::string> hints;
    if (options.spikes != 0) return hints;
    std::size_t spikes = 0;
    if (surface.is_profile()) {
        if (surface.profile().size() < 16) return hints;
        Profile<double> copy = surface.profile();
        if (detail::find_spikes(copy, sure, false).removed > 0)
            spikes = detail::find_spikes(copy, limit, false).removed;
    } else {
        const HeightMap<double>& map = surface.map();
        if (map.rows() < 16 || map.columns() < 16) return hints;
        const Eigen::Index rows = std::min(map.rows(), most), columns = std::min(map.columns(), most);
        HeightMap<double> part{map.heights.topLeftCorner(rows, columns), map.dx, map.dy};
        if (detail::find_spikes(part, sure, false).removed > 0) {
            if (part.size() < map.size()) part = map;
            spikes = detail::find_spikes(part, limit, false).removed;
        }
    }
    if (spikes > 0)
        hints.push_back((spikes == 1 ? "1 point deviates" : std::to_string(spikes) + " points deviate") +
                        " by over 20 sigma, like spikes; " + options.name("spikes") +
                        (options.prefix.empty() ? " = 20" : " 20") + " removes " + (spikes == 1 ? "it" : "them"));
    return hints;
}

}  // namespace fstiff::surface
