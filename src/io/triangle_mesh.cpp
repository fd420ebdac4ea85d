// SPDX-License-Identifier: BSD-3-Clause
#include "io/triangle_mesh.hpp"

#include "io/lines.hpp"
#include "io/number.hpp"

#include <fstiff/core/text.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

namespace fstiff::inline v0_1::io::detail {

namespace {

constexpr double longest_edge = 5;      // in median edges: in a random cloud of 10^6 points a few triangles are longer
constexpr double steepest = 10;         // 84 degrees
constexpr double most_steep = 0.2;      // of the area
constexpr double most_turned = 0.01;    // of the area
constexpr double most_repeated = 0.01;  // of the points

using Point = std::array<double, 3>;

std::string percent(double share) { return fstiff::detail::rounded_text(100 * share, 2) + " %"; }

/// Moves the points in m to their corner, without those that are incomplete.
void take_points(const PointCloud& cloud, TriangleMesh& mesh) {
    mesh.points.reserve(cloud.points.size());
    for (const Point& point : cloud.points) {
        Point& moved = mesh.points.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) moved[k] = point[k] * cloud.units[k];
    }
    const auto is_incomplete = [](const Point& p) { return !std::isfinite(p[0] + p[1] + p[2]); };
    mesh.incomplete = static_cast<std::size_t>(std::count_if(mesh.points.begin(), mesh.points.end(), is_incomplete));
    if (cloud.faces.empty()) std::erase_if(mesh.points, is_incomplete);
    for (std::size_t k = 0; k < 2; ++k) {
        double least = std::numeric_limits<double>::infinity(), most = -least;
        for (const Point& p : mesh.points)
            if (!is_incomplete(p)) least = (std::min)(least, p[k]), most = (std::max)(most, p[k]);
        mesh.corner[k] = least, mesh.sides[k] = most - least;
        for (Point& p : mesh.points) p[k] -= least;
    }
}

/// Makes the points of one position one, in the order of their positions, and triangulates them.
void triangulate(TriangleMesh& mesh, const std::string& name) {
    const double side = (std::max)(mesh.sides[0], mesh.sides[1]);
    struct Placed {
        GridPoint at;
        std::uint32_t index;
        std::uint64_t order() const { return std::uint64_t(at.x) << 32 | std::uint64_t(at.y); }
    };
    std::vector<Placed> placed;
    placed.reserve(mesh.points.size());
    const auto on_grid = [&](double x) {
        return static_cast<std::int32_t>(std::lround(x / side * most_grid_position));
    };
    for (const Point& p : mesh.points)
        placed.push_back({{on_grid(p[0]), on_grid(p[1])}, static_cast<std::uint32_t>(placed.size())});
    std::sort(placed.begin(), placed.end(), [&](const Placed& a, const Placed& b) {
        return a.order() != b.order() ? a.order() < b.order() : mesh.points[a.index] < mesh.points[b.index];
    });
    std::vector<GridPoint> positions;
    std::vector<Point> points;
    positions.reserve(placed.size()), points.reserve(placed.size());
    std::size_t contradicting = 0;
    for (std::size_t i = 0, end = 0; i < placed.size(); i = end) {
        double sum = 0;
        const Point& first = mesh.points[placed[i].index];
        for (end = i; end < placed.size() && placed[end].at == placed[i].at; ++end) {
            const double z = mesh.points[placed[end].index][2];
            sum += z;
            contradicting += z != first[2];
        }
        positions.push_back(placed[i].at);
        points.push_back(first);
        if (end > i + 1) points.back()[2] = sum / static_cast<double>(end - i);
    }
    mesh.repeated = placed.size() - points.size();
    if (static_cast<double>(contradicting) > most_repeated * static_cast<double>(placed.size()))
        refuse_file(name, {"is no field of heights: ", contradicting, " of ", placed.size(),
                           " points have the x and y of another one and another height; must be one face, with z "
                           "along its height"});
    mesh.points = std::move(points);
    mesh.triangles = delaunay(positions);
    mesh.triangulated = true;
}

/// Takes the faces that have an area in x and y, counterclockwise.
void take_faces(const std::vector<Triangle>& faces, TriangleMesh& mesh, const std::string& name) {
    double up = 0, down = 0;
    for (Triangle face : faces) {
        const auto point = [&](std::size_t corner) -> const Point& { return mesh.points[face[corner]]; };
        const double area = doubled_area(point(0), point(1), point(2));
        if (!std::isfinite(area + point(0)[2] + point(1)[2] + point(2)[2])) continue;
        (area > 0 ? up : down) += std::abs(area);
        if (area < 0) std::swap(face[1], face[2]);
        if (area != 0) mesh.triangles.push_back(face);
    }
    mesh.turned_over = (std::min)(up, down) / (std::max)(up + down, std::numeric_limits<double>::min());
    if (mesh.turned_over > most_turned)
        refuse_file(name, {"is no field of heights: ", percent(mesh.turned_over),
                           " of its faces, by their area in x and y, lie over or under others; must be one face, "
                           "without the sides and the back of the body, with z along its height"});
}

/// The offset that the positions have in the mean, modulo \p step.
double phase_of(const TriangleMesh& mesh, std::size_t axis, double step) {
    double cosine = 0, sine = 0;
    const double factor = 2 * std::numbers::pi / step;
    for (const Point& p : mesh.points) {
        if (!std::isfinite(p[axis])) continue;
        cosine += std::cos(factor * p[axis]);
        sine += std::sin(factor * p[axis]);
    }
    return std::atan2(sine, cosine) / factor;
}

/// Numbers the points in the order in which the triangles use them, those that none uses last.
void order_points(TriangleMesh& mesh) {
    constexpr auto none = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> numbers(mesh.points.size(), none);
    std::vector<Point> points;
    points.reserve(mesh.points.size());
    const auto number = [&](std::uint32_t i) {
        if (numbers[i] == none) {
            numbers[i] = static_cast<std::uint32_t>(points.size());
            points.push_back(mesh.points[i]);
        }
        return numbers[i];
    };
    for (Triangle& triangle : mesh.triangles)
        for (std::uint32_t& corner : triangle) corner = number(corner);
    for (std::uint32_t i = 0; i < numbers.size(); ++i) number(i);
    mesh.points = std::move(points);
}

/// The square of the length in x and y of edge \p k of \p triangle.
double squared_edge(const TriangleMesh& mesh, const Triangle& triangle, std::size_t k) {
    const Point &a = mesh.points[triangle[k]], &b = mesh.points[triangle[(k + 1) % 3]];
    return (b[0] - a[0]) * (b[0] - a[0]) + (b[1] - a[1]) * (b[1] - a[1]);
}

double median_edge(const TriangleMesh& mesh) {
    std::vector<double> lengths;
    lengths.reserve(3 * mesh.triangles.size());
    for (const Triangle& triangle : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k) lengths.push_back(squared_edge(mesh, triangle, k));
    const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::nth_element(lengths.begin(), middle, lengths.end());
    return std::sqrt(*middle);
}

/// Leaves out triangles that bridge a hole, and refuses what is too steep.
void check_triangles(TriangleMesh& mesh, const std::string& name) {
    double area = 0, steep = 0, long_area = 0;
    const double longest = longest_edge * longest_edge * mesh.spacing * mesh.spacing;
    std::erase_if(mesh.triangles, [&](const Triangle& t) {
        const Point &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
        const double own = doubled_area(a, b, c);
        bool bridges = !(own > 0);
        for (std::size_t k = 0; k < 3 && mesh.triangulated && !bridges; ++k)
            bridges = squared_edge(mesh, t, k) > longest;
        area += (std::max)(own, 0.0);
        if (bridges) {
            long_area += (std::max)(own, 0.0);
        } else {
            const auto [x, y] = slope_of(a, b, c, own);
            if (x * x + y * y > steepest * steepest) steep += own;
        }
        return bridges;
    });
    mesh.bridges = long_area / area;
    if (steep > most_steep * (area - long_area))
        refuse_file(name, {"is no field of heights: over ", percent(steep / (area - long_area)),
                           " of its area neighbouring heights differ by more than 10 times their distance; must be "
                           "one face, with z along its height, in units that are right"});
}

}  // namespace

TriangleMesh mesh_of(PointCloud cloud, const std::string& name, double step) {
    TriangleMesh mesh;
    take_points(cloud, mesh);
    if (mesh.points.size() < 3)
        refuse_file(name, {"holds ", mesh.points.size(), " points with x, y and a height; must hold at least 3"});
    if (!(mesh.sides[0] > 0 && mesh.sides[1] > 0) || !std::isfinite(mesh.sides[0] + mesh.sides[1]))
        refuse_file(name, {"has x and y on one line; must be points of an area"});
    if (cloud.faces.empty())
        triangulate(mesh, name);
    else
        take_faces(cloud.faces, mesh, name);
    if (mesh.triangles.empty()) refuse_file(name, {"has x and y on one line; must be points of an area"});
    for (std::size_t k = 0; k < 2 && step > 0; ++k) mesh.phase[k] = phase_of(mesh, k, step);
    order_points(mesh);
    mesh.spacing = median_edge(mesh);
    check_triangles(mesh, name);
    return mesh;
}

Reading map_of_mesh(PointCloud cloud, const std::string& form, std::uint32_t first, const std::string& name,
                    const SurfaceOptions& options) {
    const auto points = static_cast<std::uint32_t>(cloud.points.size());
    for (const Triangle& face : cloud.faces)
        for (const std::uint32_t corner : face)
            if (corner >= points)
                refuse_file(name, {"has a face with vertex ", corner + first, " of ", points, "; must be one of them"});
    Record record;
    record.note("form", form + ", " + std::to_string(points) + " vertices, " + std::to_string(cloud.faces.size()) +
                            " triangles");
    return map_of_points(std::move(cloud), name, options, std::move(record));
}

}  // namespace fstiff::inline v0_1::io::detail
