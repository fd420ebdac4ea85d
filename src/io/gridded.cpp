// SPDX-License-Identifier: BSD-3-Clause
#include "io/gridded.hpp"

#include "io/column_titles.hpp"
#include "io/lines.hpp"
#include "io/option_names.hpp"
#include "io/regular_grid.hpp"
#include "io/triangle_mesh.hpp"

#include <fstiff/core/text.hpp>
#include <fstiff/io/units.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace fstiff::inline v0_1::io::detail {

namespace {

constexpr double most_nodes = 67108864;            // 2^26
constexpr double most_nodes_a_point = 100;         // more only draw the triangles
constexpr double most_tilt = 1, much_tilt = 0.36;  // 45 and 20 degrees
constexpr double slack = 2e-6;                     // in steps, of nodes on an edge

using Point = std::array<double, 3>;

/// In mm, um or nm.
std::string length(double metres, int digits = 4) {
    for (const auto& [unit, factor] : {std::pair(" mm", 1e3), std::pair(" um", 1e6)})
        if (metres * factor >= 0.9995) return fstiff::detail::rounded_text(metres * factor, digits) + unit;
    return fstiff::detail::rounded_text(metres * 1e9, digits) + " nm";
}

/// The positions of nodes on one axis, from the corner of the mesh.
struct Nodes {
    double first{}, step{};
    std::size_t count{};
    double at(std::size_t i) const { return first + step * static_cast<double>(i); }
    /// The numbers of the nodes from \p low to \p high, the second excluded.
    std::pair<std::size_t, std::size_t> between(double low, double high) const {
        const auto end = static_cast<double>(count);
        const double from = std::clamp((low - first) / step, 0.0, end),
                     to = std::clamp((high - first) / step, -1.0, end - 1);
        const auto whole = [](double i) { return static_cast<std::int64_t>(i); };  // faster than ceil and floor
        return {static_cast<std::size_t>(whole(from) + (static_cast<double>(whole(from)) < from)),
                to < 0 ? 0 : static_cast<std::size_t>(whole(to) + 1)};
    }
};

Nodes nodes_of(const TriangleMesh& mesh, std::size_t axis, const SurfaceOptions& options) {
    const double step = *options.grid, side = mesh.sides[axis];
    const double phase = options.grid_origin ? (*options.grid_origin)[axis] - mesh.corner[axis] : mesh.phase[axis];
    const double first = phase - step * std::floor(phase / step + slack);
    return {first, step, static_cast<std::size_t>((std::max)(0.0, std::floor((side - first) / step + slack) + 1))};
}

/// Gives the nodes in the triangles, or up to \p margin outside of them, their heights. Of two faces the upper one
/// counts; with a margin, nodes that have a height keep it.
void draw(const TriangleMesh& mesh, const Nodes& xs, const Nodes& ys, double margin, std::vector<double>& heights) {
    // whether a node near a triangle from x_low to x_high, in these rows, may get a height
    const auto may_give = [&](double x_low, double x_high, std::size_t row, std::size_t last_row) {
        const auto [column, last_column] = xs.between(x_low - slack * xs.step, x_high + slack * xs.step);
        for (std::size_t j = row; j < last_row; ++j)
            for (std::size_t i = column; i < last_column; ++i)
                if (margin == 0 || std::isnan(heights[j * xs.count + i])) return true;
        return false;
    };
    for (const Triangle& triangle : mesh.triangles) {
        const Point &a = mesh.points[triangle[0]], &b = mesh.points[triangle[1]], &c = mesh.points[triangle[2]];
        const auto low_of = [&](std::size_t k) { return (std::min)((std::min)(a[k], b[k]), c[k]); };
        const auto high_of = [&](std::size_t k) { return (std::max)((std::max)(a[k], b[k]), c[k]); };
        const auto [row, last_row] = ys.between(low_of(1) - margin, high_of(1) + margin);
        if (!may_give(low_of(0), high_of(0), row, last_row)) continue;
        const Point* const corners[] = {&a, &b, &c};
        const double area = doubled_area(a, b, c);
        for (std::size_t j = row; j < last_row; ++j) {
            const double y = ys.at(j);
            double low = -std::numeric_limits<double>::infinity(), high = -low;
            for (std::size_t k = 0; k < 3; ++k) {  // to the left of each edge
                const Point &from = *corners[k], &to = *corners[(k + 1) % 3];
                const double dx = to[0] - from[0], dy = to[1] - from[1];
                const double across = dx * (y - from[1]) + (margin > 0 ? margin * std::hypot(dx, dy) : 0);
                if (dy > 0)
                    high = (std::min)(high, from[0] + across / dy);
                else if (dy < 0)
                    low = (std::max)(low, from[0] + across / dy);
                else if (across < 0)
                    high = -std::numeric_limits<double>::infinity();
            }
            if (!(low <= high)) continue;
            const auto [column, last_column] = xs.between(low, high);
            for (std::size_t i = column; i < last_column; ++i) {
                const Point p{xs.at(i), y, 0};
                double& height = heights[j * xs.count + i];
                if (margin > 0 && !std::isnan(height)) continue;
                const double z =
                    a[2] + doubled_area(a, p, c) / area * (b[2] - a[2]) + doubled_area(a, b, p) / area * (c[2] - a[2]);
                if (!(height >= z)) height = margin > 0 ? std::clamp(z, low_of(2), high_of(2)) : z;
            }
        }
    }
}

/// Leaves out outer lines of \p map with more missing nodes than those next to them; moves \p first of x and y.
void trim(RawMap& map, std::array<double, 2>& first) {
    const auto missing = [&](bool row, std::size_t line) {
        std::size_t count = 0;
        for (std::size_t i = 0; i < (row ? map.columns : map.rows); ++i)
            count += std::isnan(row ? map.at(line, i) : map.at(i, line));
        return count;
    };
    const auto cut = [&](bool row, bool at_end) {
        const std::size_t lines = row ? map.rows : map.columns;
        return lines > 4 && missing(row, at_end ? lines - 1 : 0) > missing(row, at_end ? lines - 2 : 1);
    };
    const std::size_t left = cut(false, false), right = cut(false, true), below = cut(true, false),
                      above = cut(true, true);
    RawMap kept;
    kept.rows = map.rows - below - above;
    kept.columns = map.columns - left - right;
    kept.dx = map.dx, kept.dy = map.dy;
    kept.heights.reserve(kept.rows * kept.columns);
    for (std::size_t j = below; j < map.rows - above; ++j) {
        const auto row = map.heights.begin() + static_cast<std::ptrdiff_t>(j * map.columns + left);
        kept.heights.insert(kept.heights.end(), row, row + static_cast<std::ptrdiff_t>(kept.columns));
    }
    first[0] += static_cast<double>(left) * map.dx, first[1] += static_cast<double>(below) * map.dy;
    map = std::move(kept);
}

/// z = at_corner + x slope[0] + y slope[1], from the first node.
struct Plane {
    double at_corner{};
    std::array<double, 2> slope{};
    double at(double x, double y) const { return at_corner + x * slope[0] + y * slope[1]; }
};

Plane plane_of(const RawMap& map) {
    const auto each = [&](const auto& take) {
        for (std::size_t j = 0; j < map.rows; ++j)
            for (std::size_t i = 0; i < map.columns; ++i)
                if (const double z = map.at(j, i); !std::isnan(z))
                    take(static_cast<double>(i) * map.dx, static_cast<double>(j) * map.dy, z);
    };
    double n = 0, x = 0, y = 0, z = 0, xx = 0, xy = 0, yy = 0, xz = 0, yz = 0;
    each([&](double px, double py, double pz) { ++n, x += px, y += py, z += pz; });
    x /= n, y /= n, z /= n;
    each([&](double px, double py, double pz) {
        px -= x, py -= y, pz -= z;
        xx += px * px, xy += px * py, yy += py * py, xz += px * pz, yz += py * pz;
    });
    const double determinant = xx * yy - xy * xy;
    if (!(determinant > 0)) return {z, {}};
    const std::array slope{(xz * yy - yz * xy) / determinant, (yz * xx - xz * xy) / determinant};
    return {z - slope[0] * x - slope[1] * y, slope};
}

/// The rms height and the rms gradient from a plane.
struct Rms {
    double height{}, gradient{};
};

/// Of every \p stride-th node of \p map.
Rms rms_of_nodes(const RawMap& map, const Plane& plane, std::size_t stride) {
    double squares = 0, heights = 0, along_x = 0, pairs_x = 0, along_y = 0, pairs_y = 0;
    const auto level = [&](std::size_t j, std::size_t i) {
        return map.at(j, i) - plane.at(static_cast<double>(i) * map.dx, static_cast<double>(j) * map.dy);
    };
    const auto add = [](double difference, double step, double& sum, double& count) {
        if (std::isnan(difference)) return;
        sum += difference * difference / (step * step);
        ++count;
    };
    for (std::size_t j = 0; j < map.rows; j += stride)
        for (std::size_t i = 0; i < map.columns; i += stride) {
            const double z = level(j, i), step = static_cast<double>(stride);
            if (std::isnan(z)) continue;
            squares += z * z;
            ++heights;
            if (i + stride < map.columns) add(level(j, i + stride) - z, step * map.dx, along_x, pairs_x);
            if (j + stride < map.rows) add(level(j + stride, i) - z, step * map.dy, along_y, pairs_y);
        }
    return {std::sqrt(squares / heights), std::sqrt(along_x / pairs_x + along_y / pairs_y)};
}

/// Of the triangles, exactly; \p plane begins at \p first.
Rms rms_of_triangles(const TriangleMesh& mesh, const Plane& plane, const std::array<double, 2>& first) {
    double area = 0, squares = 0, slopes = 0;
    for (const Triangle& t : mesh.triangles) {
        const auto level = [&](std::uint32_t i) {
            Point p = mesh.points[i];
            p[2] -= plane.at(p[0] - first[0], p[1] - first[1]);
            return p;
        };
        const Point a = level(t[0]), b = level(t[1]), c = level(t[2]);
        const double own = doubled_area(a, b, c);
        const auto [x, y] = slope_of(a, b, c, own);
        area += own;
        squares += own / 6 * (a[2] * a[2] + b[2] * b[2] + c[2] * c[2] + a[2] * b[2] + b[2] * c[2] + c[2] * a[2]);
        slopes += own * (x * x + y * y);
    }
    return {std::sqrt(squares / area), std::sqrt(slopes / area)};
}

std::string text_of(const Rms& rms) {
    return length(rms.height, 3) + " and " + fstiff::detail::rounded_text(rms.gradient, 3);
}

/// Refuses or reports a tilt, and notes the mesh and what the step does to sigma and g.
void describe(const TriangleMesh& mesh, const RawMap& map, const std::array<double, 2>& first, const std::string& name,
              Record& record) {
    const Plane plane = plane_of(map);
    const double tilt = std::hypot(plane.slope[0], plane.slope[1]), degrees = std::atan(tilt) * 180 / std::numbers::pi;
    const std::string tilted = fstiff::detail::rounded_text(degrees, 2) + " degrees";
    if (tilt > most_tilt)
        refuse_file(name, {"lies in a plane that is tilted by ", tilted,
                           "; must be turned until z is along its height, to below 45 degrees"});
    if (tilt > much_tilt)
        record.warnings.push_back("the plane of the points is tilted by " + tilted +
                                  ": lengths along it are longer than those in x and y; turn the points until z is "
                                  "along the height");
    const auto share = [](double part) { return fstiff::detail::rounded_text(100 * part, 2) + " % of the area "; };
    record.note(
        "triangles",
        std::to_string(mesh.triangles.size()) + (mesh.triangulated ? " of a Delaunay triangulation" : " of the mesh") +
            ", median edge " + length(mesh.spacing) +
            (mesh.bridges > 0 ? "; " + share(mesh.bridges) + "bridges holes and is left out" : "") +
            (mesh.repeated > 0 ? "; " + std::to_string(mesh.repeated) + " repeated points, whose mean counts" : "") +
            (mesh.turned_over > 0 ? "; " + share(mesh.turned_over) + "lies under other faces" : "") +
            (mesh.incomplete > 0 ? "; " + std::to_string(mesh.incomplete) + " points without a height" : ""));
    record.note("grid", "step " + length(map.dx) + ": sigma and gradient " + text_of(rms_of_nodes(map, plane, 1)) +
                            " from the plane; at twice the step " + text_of(rms_of_nodes(map, plane, 2)) +
                            ", of the triangles " + text_of(rms_of_triangles(mesh, plane, first)));
}

void require_step(const TriangleMesh& mesh, double step, const std::string& name) {
    const auto [width, height] = mesh.sides;
    const double nodes = (width / step + 1) * (height / step + 1);
    const double most =
        (std::min)(most_nodes, (std::max)(1048576.0, most_nodes_a_point * static_cast<double>(mesh.points.size())));
    if (!(nodes <= most))
        refuse_field(name, "grid", length(step),
                     "at least " + length(1.01 * std::sqrt(width * height / most)) + ", of " +
                         std::to_string(static_cast<std::size_t>(most)) + " nodes at most for so many points");
    if (!(3 * step <= (std::min)(width, height)))
        refuse_field(name, "grid", length(step),
                     "at most " + length((std::min)(width, height) / 3) + ", a third of the shorter side");
}

}  // namespace

RawMap gridded(PointCloud cloud, const std::string& name, const SurfaceOptions& options, Record& record) {
    fstiff::detail::located({.file = name}, [&] { fstiff::detail::require_positive("grid", *options.grid); });
    const TriangleMesh mesh = mesh_of(std::move(cloud), name, options.grid_origin ? 0 : *options.grid);
    require_step(mesh, *options.grid, name);
    const Nodes xs = nodes_of(mesh, 0, options), ys = nodes_of(mesh, 1, options);
    RawMap map;
    map.rows = ys.count;
    map.columns = xs.count;
    map.dx = map.dy = *options.grid;
    map.heights.assign(map.rows * map.columns, std::numeric_limits<double>::quiet_NaN());
    for (const double margin : {0.0, slack * *options.grid}) draw(mesh, xs, ys, margin, map.heights);
    std::array first{xs.first, ys.first};
    trim(map, first);
    describe(mesh, map, first, name, record);
    record.origin = {mesh.corner[0] + first[0], mesh.corner[1] + first[1]};
    return map;
}

std::string proposed_grid(PointCloud cloud, const std::string& name, const OptionNames& names) {
    const std::string option = names.prefix + "grid";
    const double unit = cloud.units[0];
    const std::string unit_name = cloud.unit_names[0];
    try {
        return option + names.equals + "\"" +
               fstiff::detail::rounded_text(mesh_of(std::move(cloud), name).spacing / unit, 2) + " " + unit_name +
               "\", the median distance of neighbouring points";
    } catch (const domain_error&) {
        return option + " and a step";
    }
}

namespace {

/// The points as a table, and its grid; none when they lie on no regular one.
std::optional<Grid> grid_of(const PointCloud& cloud, NumberTable& table) {
    table.columns = 3;
    table.printed.resize(3);
    for (std::size_t i = 0; i < cloud.points.size(); ++i) {
        const Point& point = cloud.points[i];
        if (!std::isfinite(point[0]) || !std::isfinite(point[1])) return std::nullopt;
        table.values.insert(table.values.end(), point.begin(), point.end());
        table.row_lines.push_back(i + 1);
    }
    return grid_of(table);
}

/// \throws domain_error without units.
void take_units(PointCloud& cloud, const std::string& name, const SurfaceOptions& options, Record& record) {
    const auto given = given_units(options.units, 3, name, "one unit, or \"mm,um\" (x and y, heights)");
    if (given.empty())
        refuse_file(name, {"states no units and none are given; must be ", given_as(options.names, "units", "\"mm\""),
                           ", one of ", accepted_units(Dimension::length)});
    for (std::size_t k = 0; k < 3; ++k) {
        cloud.unit_names[k] = std::string(k == 2 ? given.back() : given[given.size() == 3 ? k : 0]);
        cloud.units[k] = unit_factor(cloud.unit_names[k], Dimension::length);
    }
    record.note("units", "x in " + cloud.unit_names[0] + ", y in " + cloud.unit_names[1] + ", heights in " +
                             cloud.unit_names[2] + ", from options");
}

}  // namespace

Reading map_of_points(PointCloud cloud, const std::string& name, const SurfaceOptions& options, Record record) {
    take_units(cloud, name, options, record);
    RawMap map;
    if (options.grid) {
        record.note("spacing", "from grid of the options");
        map = gridded(std::move(cloud), name, options, record);
    } else {
        NumberTable table;
        const std::optional<Grid> grid = grid_of(cloud, table);
        if (!grid)
            refuse_file(name, {"has x and y that lie on no regular grid; must be put on one by ",
                               proposed_grid(std::move(cloud), name, options.names)});
        record.note("spacing", "from steps of x and y");
        map.rows = grid->y.count, map.columns = grid->x.count;
        map.dx = grid->x.step * cloud.units[0], map.dy = grid->y.step * cloud.units[1];
        map.heights = heights_on(*grid, table, column_of(table, 2), name);
        for (double& z : map.heights)
            z = std::isfinite(z) ? z * cloud.units[2] : std::numeric_limits<double>::quiet_NaN();
        record.origin = {grid->x.origin * cloud.units[0], grid->y.origin * cloud.units[1]};
    }
    record.note_points(map);
    fstiff::detail::located({.file = name}, [&] { validate_map(map, 2); });
    return {std::move(map), std::move(record)};
}

}  // namespace fstiff::inline v0_1::io::detail
