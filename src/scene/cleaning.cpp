// SPDX-License-Identifier: BSD-3-Clause
#include "scene/cleaning.hpp"

#include "io/npy.hpp"
#include "scene/shown_unit.hpp"
#include "scene/surface_file.hpp"

#include <fstiff/core/text.hpp>
#include <fstiff/profile/repair.hpp>
#include <fstiff/topography/repair.hpp>

#include <cmath>

namespace fstiff::scene {
namespace {

std::string named(const SurfaceOptions& options, const char* name) { return std::string(options.prefix) + name; }

std::string of(std::size_t count, std::size_t all) {
    return std::to_string(count) + " of " + std::to_string(all) + " points";
}

/// The lengths of "a,b" or "a,b,c,d", which may be 0.
std::vector<double> lengths(const std::string& text, const std::string& name) {
    std::vector<double> values;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const std::string part = text.substr(begin, end - begin);
        const auto first = part.find_first_not_of(' ');
        const bool zero = first != std::string::npos && part.find_first_not_of("0. ", first) == std::string::npos &&
                          part.find('0') != std::string::npos;
        values.push_back(zero ? 0 : io::parse_quantity(part, io::Dimension::length, name));
        begin = end + 1;
    }
    return values;
}

struct PointRange {
    std::size_t from, count;
};

/// The points of [from, to] among \p points of \p step; a bound that lies a rounding beside a point takes it.
PointRange range_of(double from, double to, std::size_t points, double step, const std::string& name) {
    const double last = static_cast<double>(points - 1) * step, slack = 1e-6 * step;
    if (!(from >= 0 && from < to && to <= last + step))
        throw domain_error(name + ": from " + shown_length(from) + " to " + shown_length(to) +
                           " must rise, and lie between 0 and the length of " + shown_length(last));
    const auto begin = static_cast<std::size_t>(std::ceil((from - slack) / step));
    const auto end = std::min(points - 1, static_cast<std::size_t>(std::floor((to + slack) / step)));
    if (begin > end) throw domain_error(name + ": no point lies between its lengths; must hold some");
    return {begin, end - begin + 1};
}

void crop(const SurfaceOptions& options, io::Surface& surface) {
    const std::string name = named(options, "crop");
    const std::vector<double> box = lengths(options.crop, name);
    const std::size_t wanted = surface.is_profile() ? 2 : 4;
    if (box.size() != wanted)
        throw option_error(
            name + " = \"" + options.crop + "\": must be " +
            (wanted == 2 ? "two lengths of a profile, \"x0,x1\"" : "four lengths of a map, \"x0,x1,y0,y1\""));
    std::string kept;
    if (surface.is_profile()) {
        auto& profile = std::get<0>(surface.data);
        const PointRange x = range_of(box[0], box[1], profile.size(), profile.spacing, name);
        kept = of(x.count, profile.size());
        const auto begin = profile.heights.begin() + static_cast<std::ptrdiff_t>(x.from);
        profile.heights = std::vector<double>(begin, begin + static_cast<std::ptrdiff_t>(x.count));
    } else {
        auto& map = std::get<1>(surface.data);
        const auto size = [](Eigen::Index n) { return static_cast<std::size_t>(n); };
        const auto index = [](std::size_t n) { return static_cast<Eigen::Index>(n); };
        const PointRange x = range_of(box[0], box[1], size(map.columns()), map.dx, name);
        const PointRange y = range_of(box[2], box[3], size(map.rows()), map.dy, name);
        kept = std::to_string(x.count) + " x " + std::to_string(y.count) + " of " + std::to_string(map.columns()) +
               " x " + std::to_string(map.rows()) + " points";
        const HeightMap<double>::Array part =
            map.heights.block(index(y.from), index(x.from), index(y.count), index(x.count));
        map.heights = part;
    }
    surface.record.details.push_back("crop: " + kept + " kept (" + options.crop + ")");
}

/// Zeros and ones of a text, one row a line, or of a .npy.
HeightMap<double>::Array read_mask(const std::string& file) {
    const std::string bytes = read_all(file), name = display_name(file);
    if (io::is_npy(bytes)) {
        io::SurfaceOptions how;
        how.dx = how.dy = how.spacing = 1;
        how.units = "m";
        how.missing = "none";
        const io::RawMap read = io::read_npy(bytes, name, how).map;
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

void mask(const SurfaceOptions& options, io::Surface& surface, Eigen::Index rows, Eigen::Index columns) {
    const auto marks = read_mask(options.mask);
    const bool profile = surface.is_profile();
    const bool fits = profile ? marks.size() == columns && (marks.rows() == 1 || marks.cols() == 1)
                              : marks.rows() == rows && marks.cols() == columns;
    const std::string name = display_name(options.mask);
    if (!fits)
        throw domain_error(name + ": the mask has " + std::to_string(marks.cols()) + " x " +
                           std::to_string(marks.rows()) + " numbers; must have those of the surface, " +
                           std::to_string(columns) + " x " + std::to_string(rows));
    if (!((marks == 0) || (marks == 1)).all()) throw domain_error(name + ": a mask must hold 0 and 1 alone");
    double* heights = profile ? std::get<0>(surface.data).heights.data() : std::get<1>(surface.data).heights.data();
    std::size_t taken = 0;
    for (Eigen::Index k = 0; k < marks.size(); ++k)
        if (marks.data()[k] == 0) {
            taken += std::isnan(heights[k]) ? 0 : 1;
            heights[k] = std::nan("");
        }
    surface.record.details.push_back("mask: " + of(taken, static_cast<std::size_t>(marks.size())) +
                                     " became missing (" + name + ")");
}

}  // namespace

void clean(const SurfaceOptions& options, io::Surface& surface) {
    const auto size = [&] {
        return surface.is_profile() ? surface.profile().size() : static_cast<std::size_t>(surface.map().size());
    };
    auto& details = surface.record.details;
    if (!options.crop.empty()) crop(options, surface);
    if (!options.mask.empty())
        mask(options, surface, surface.is_profile() ? 1 : surface.map().rows(),
             surface.is_profile() ? static_cast<Eigen::Index>(size()) : surface.map().columns());
    if (options.spikes != 0) {
        require(options.spikes >= 3 && options.spikes <= 1000, named(options, "spikes").c_str(), options.spikes,
                "between 3 and 1000 standard deviations");
        const std::size_t taken = surface.is_profile() ? find_spikes(std::get<0>(surface.data), options.spikes).removed
                                                       : find_spikes(std::get<1>(surface.data), options.spikes).removed;
        details.push_back("spikes: " + of(taken, size()) + " became missing, beyond " + shortest_text(options.spikes) +
                          " standard deviations from the median of their neighbours");
    }
    if (options.fill) {
        std::size_t filled = 0, longest = 0;
        if (surface.is_profile()) {
            const Repair repair = fill_missing(std::get<0>(surface.data));
            filled = repair.missing, longest = repair.longest;
        } else {
            const MapRepair repair = fill_missing(std::get<1>(surface.data));
            filled = repair.missing, longest = repair.longest;
        }
        details.push_back("fill: " + of(filled, size()) + " filled " +
                          (surface.is_profile() ? "by straight lines" : "by Laplace's equation") +
                          (filled > 0 ? ", the largest hole " + std::to_string(longest) : ""));
    }
}

std::vector<std::string> cleaning_hints(const SurfaceOptions& options, const io::Surface& surface) {
    constexpr double sure = 30;  // standard deviations: real surfaces of heavy tails have points up to 20 or 30
    constexpr Eigen::Index most = 1024;
    std::vector<std::string> hints;
    if (options.spikes != 0) return hints;
    std::size_t found = 0;
    if (surface.is_profile()) {
        if (surface.profile().size() < 16) return hints;
        Profile<double> copy = surface.profile();
        found = find_spikes(copy, sure, false).removed;
    } else {
        const HeightMap<double>& map = surface.map();
        if (map.rows() < 16 || map.columns() < 16) return hints;
        const Eigen::Index rows = std::min(map.rows(), most), columns = std::min(map.columns(), most);
        HeightMap<double> part{map.heights.topLeftCorner(rows, columns), map.dx, map.dy};
        found = find_spikes(part, sure, false).removed;
    }
    if (found > 0)
        hints.push_back((found == 1 ? "1 point stands" : std::to_string(found) + " points stand") +
                        " more than 30 standard deviations from the neighbours, as "
                        "spikes do; " +
                        named(options, "spikes") + (options.prefix.empty() ? " = 20" : " 20") +
                        " takes such points out");
    return hints;
}

}  // namespace fstiff::scene
