// SPDX-License-Identifier: BSD-3-Clause
/// \file
/// Reads maps that are triangles (.stl), binary and text: a height over x and y.
///
/// Binary are 80 bytes, the number of triangles (uint32), and of each triangle its normal, its three corners (x, y, z;
/// float32) and two bytes more, the least significant byte first. Text is "solid", then of each triangle
///
///     facet normal n n n   outer loop   vertex x y z   vertex x y z   vertex x y z   endloop   endfacet
///
/// The corners must lie on a regular grid of x and y, one height to a point, and each triangle within one cell of it.
/// Points of the grid without a corner are missing. Closed bodies, walls and other meshes are refused. Normals and
/// colours are not read.
///
/// Reference   3D Systems, StereoLithography Interface Specification (1989), as published by many
/// Units       map in m; the file states none, so that an option must
/// Valid       2 points a side at least; heights that vary; rows from the lowest y
/// Accuracy    the number of the file times the unit, rounded once (tests/io/stl_test.cpp)

#include "io/readers.hpp"

#include "io/column_titles.hpp"
#include "io/file_bytes.hpp"
#include "io/option_names.hpp"
#include "io/regular_grid.hpp"

namespace fstiff::inline v0_1::io::detail {

namespace {

constexpr std::uint64_t stl_head = 84, stl_triangle = 50;

/// The triangles that a binary file states.
std::uint64_t stl_count(std::string_view bytes) {
    return bytes.size() < stl_head ? 0 : unsigned_at(bytes.substr(80, 4), false);
}

/// Corners of triangles, three of each.
struct StlCorners {
    std::vector<double> x, y, z;
    double printed_x{}, printed_y{};  // what the last digit of a position is worth

    void add(double at_x, double at_y, double at_z) {
        x.push_back(at_x);
        y.push_back(at_y);
        z.push_back(at_z);
    }
};

StlCorners binary_corners(const FileBytes& file) {
    const std::uint64_t triangles = file.number(80, 4, "the number of triangles");
    if (file.size() != stl_head + stl_triangle * triangles)
        refuse_file(file.name(),
                    {"declares ", triangles, " triangles, which make ", stl_head + stl_triangle * triangles,
                     " bytes, but has ", file.size(), "; must have as many"});
    StlCorners corners;
    double largest_x = 0, largest_y = 0;
    for (std::uint64_t i = 0; i < triangles; ++i)
        for (std::uint64_t corner = 0; corner < 3; ++corner) {
            const std::uint64_t place = stl_head + stl_triangle * i + 12 + 12 * corner;
            double at[3];
            for (std::size_t axis = 0; axis < 3; ++axis) {
                at[axis] = file.real(place + 4 * axis, 4, "a triangle");
                if (!std::isfinite(at[axis]))
                    refuse_file(file.name(), {"has a triangle ", i + 1, " with a corner that is not finite; must be"});
            }
            largest_x = (std::max)(largest_x, std::abs(at[0]));
            largest_y = (std::max)(largest_y, std::abs(at[1]));
            corners.add(at[0], at[1], at[2]);
        }
    corners.printed_x = largest_x * 1.2e-7;  // of a float32
    corners.printed_y = largest_y * 1.2e-7;
    return corners;
}

/// The words of a text.
class StlWords {
public:
    StlWords(std::string_view text, const std::string& name) : rest_(text), name_(name) {}

    std::string_view next() {
        while (!rest_.empty() && is_blank(rest_.front())) rest_.remove_prefix(1);
        const std::size_t end = (std::min)(rest_.find_first_of(" \t\r\n"), rest_.size());
        const std::string_view word = rest_.substr(0, end);
        rest_.remove_prefix(end);
        return word;
    }
    void skip_line() { rest_.remove_prefix((std::min)(rest_.find_first_of("\r\n"), rest_.size())); }
    void expect(std::initializer_list<std::string_view> words, std::size_t triangle) {
        for (const std::string_view wanted : words)
            if (const std::string_view word = next(); lower_case(word) != wanted)
                refuse_file(name_, {"has ", word.empty() ? "its end" : shown_cell(word), " in triangle ", triangle,
                                    "; must have ", wanted, " there"});
    }
    double number(std::size_t triangle, PrintedDigits* digits) {
        const std::string_view word = next();
        const auto number = word.size() <= 64 ? number_in(word, false) : std::nullopt;
        if (!number || !std::isfinite(*number))
            refuse_file(name_, {"has ", shown_cell(word), " in triangle ", triangle, "; must be a number"});
        if (digits) digits->add(word, *number);
        return *number;
    }

private:
    std::string_view rest_;
    const std::string& name_;
};

StlCorners text_corners(std::string_view text, const std::string& name) {
    StlCorners corners;
    PrintedDigits digits_x, digits_y;
    StlWords words(text, name);
    words.skip_line();  // solid and its name
    for (std::size_t triangle = 1;; ++triangle) {
        const std::string_view word = words.next();
        if (lower_case(word) == "endsolid") break;
        if (lower_case(word) != "facet")
            refuse_file(name, {"has ", word.empty() ? "its end" : shown_cell(word), " after ", triangle - 1,
                               " triangles; must have facet or endsolid there"});
        words.expect({"normal"}, triangle);
        for (int axis = 0; axis < 3; ++axis) words.next();  // may be nan where a triangle is flat
        words.expect({"outer", "loop"}, triangle);
        for (int corner = 0; corner < 3; ++corner) {
            words.expect({"vertex"}, triangle);
            const double x = words.number(triangle, &digits_x), y = words.number(triangle, &digits_y);
            corners.add(x, y, words.number(triangle, nullptr));
        }
        words.expect({"endloop", "endfacet"}, triangle);
    }
    corners.printed_x = digits_x.resolution();
    corners.printed_y = digits_y.resolution();
    return corners;
}

/// The grid on which \p corners lie.
Grid stl_grid(const StlCorners& corners, const std::string& name) {
    const auto x = axis_of(corners.x, corners.printed_x);
    const auto y = x ? axis_of(corners.y, corners.printed_y) : std::nullopt;
    // every point of a map is a corner of a triangle, but for some that are missing
    if (!x || !y || static_cast<double>(x->count) * static_cast<double>(y->count) > 10.0 * double(corners.x.size()))
        refuse_file(name, {"has triangles whose corners lie on no regular grid of x and y; must be a height over x "
                           "and y: sample it on a grid, and save that"});
    return {*x, *y};
}

/// Puts the heights of \p corners on \p grid, each triangle within one cell.
void fill(RawMap& map, const StlCorners& corners, const Grid& grid, double unit, const std::string& name) {
    allocate(map, grid.y.count, grid.x.count);
    std::fill(map.heights.begin(), map.heights.end(), std::numeric_limits<double>::quiet_NaN());
    for (std::size_t i = 0; i < corners.x.size(); i += 3) {
        std::size_t low[2] = {map.columns, map.rows}, high[2] = {0, 0};
        for (std::size_t corner = i; corner < i + 3; ++corner) {
            const std::size_t at[2] = {(std::min)(grid.x.index(corners.x[corner]), map.columns - 1),
                                       (std::min)(grid.y.index(corners.y[corner]), map.rows - 1)};
            for (std::size_t axis = 0; axis < 2; ++axis) {
                low[axis] = (std::min)(low[axis], at[axis]);
                high[axis] = (std::max)(high[axis], at[axis]);
            }
            double& height = map.heights[at[1] * map.columns + at[0]];
            const double z = corners.z[corner] * unit;
            if (!std::isnan(height) && height != z)
                refuse_file(name, {"has two heights at x = ", corners.x[corner], ", y = ", corners.y[corner],
                                   "; must be a height over x and y, without walls or a lower side"});
            height = z;
        }
        if (high[0] - low[0] != 1 || high[1] - low[1] != 1)
            refuse_file(name, {"has a triangle ", i / 3 + 1, " over ", high[0] - low[0], " x ", high[1] - low[1],
                               " cells of the grid of its corners; must be over one: sample it on a grid, and save "
                               "that"});
    }
}

bool may_be_stl(std::string_view bytes) {
    const std::uint64_t triangles = stl_count(bytes);
    if (triangles < 2 || bytes.size() < stl_head + stl_triangle) return false;
    const std::uint64_t whole = stl_head + stl_triangle * triangles;
    bool finite = true;
    for (std::size_t i = 0; i < 12; ++i) finite = finite && std::isfinite(float_at(bytes.substr(stl_head + 4 * i, 4)));
    return finite && bytes.size() <= whole && whole <= most_bytes;
}

bool is_stl(std::string_view bytes) {
    if (may_be_stl(bytes)) return bytes.size() == stl_head + stl_triangle * stl_count(bytes);
    return bytes.starts_with("solid") && bytes.substr(0, 4096).find("facet") != std::string_view::npos;
}

Reading read_stl(std::string_view bytes, const std::string& name, const SurfaceOptions& options) {
    const FileBytes file(bytes, name);
    const bool text = bytes.starts_with("solid") && !may_be_stl(bytes);
    const StlCorners corners = text ? text_corners(bytes, file.name()) : binary_corners(file);
    const auto units = given_units(options.units, 1, file.name(), "one unit of x, y and heights, such as \"mm\"");
    if (units.empty())
        refuse_file(file.name(),
                    {"states no unit and none is given; must be ", given_as(options.names, "units", "\"mm\""),
                     ", one of ", accepted_units(Dimension::length)});
    const double unit = unit_factor(units.back(), Dimension::length);
    const Grid grid = stl_grid(corners, file.name());
    RawMap map;
    fill(map, corners, grid, unit, file.name());
    set_spacings(map, grid.x.step * unit, grid.y.step * unit, file.name());
    Record record;
    record.note("form", std::string(text ? "text" : "binary file") + " of " + std::to_string(corners.x.size() / 3) +
                            " triangles (.stl)");
    record.note("units", std::string(units.back()) + ", from options");
    record.note("spacing", "from the corners of the triangles");
    record.note_points(map);
    return {std::move(map), std::move(record)};
}

}  // namespace

extern constexpr Reader stl_reader{.format = SurfaceFormat::stl,
                                   .endings = ".stl",
                                   .holds = "triangles over a grid of x and y, binary or text",
                                   .recognised = "its size, or its first words, solid and facet",
                                   .asks_for = "--units",
                                   .options = "units",
                                   .begins = is_stl,
                                   .read = read_stl,
                                   .mark = 0,
                                   .may_begin = may_be_stl};

}  // namespace fstiff::inline v0_1::io::detail
