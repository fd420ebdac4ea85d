// SPDX-License-Identifier: BSD-3-Clause
/// \file
/// Reads the vertices and the faces of a Wavefront object (.obj).
///
/// Lines "v x y z ..." are vertices, lines "f 1 2 3", "f 1/4/2 2/5/2 3/6/2" or "f -3 -2 -1" are polygons of vertices
/// counted from 1, or backwards from the last one; they are cut into triangles. All other lines are left out. The form
/// states no unit.
///
/// Reference   Alias/Wavefront, Advanced Visualizer manual, appendix B1 (object files)
/// Units       map in m
/// Valid       as io/gridded.hpp
/// Accuracy    as io/gridded.hpp (tests/io/obj_test.cpp)

#include "io/cells.hpp"
#include "io/lines.hpp"
#include "io/readers.hpp"
#include "io/triangle_mesh.hpp"

#include <cmath>
#include <utility>

namespace fstiff::inline v0_1::io::detail {

namespace {

/// Whether the first line that is no remark is one of an object: "v" and a number, or another, and then "v".
bool is_obj(std::string_view bytes) {
    std::string_view rest = bytes.substr(bytes.starts_with("\xEF\xBB\xBF") ? 3 : 0);
    while (rest.starts_with('#') || rest.starts_with('\n') || rest.starts_with('\r'))
        rest.remove_prefix((std::min)(rest.find('\n'), rest.size() - 1) + 1);
    if (rest.starts_with("v ")) return leading_number(trimmed(rest.substr(2, 64))).status == NumberStatus::ok;
    const bool begins = rest.starts_with("mtllib ") || rest.starts_with("o ") || rest.starts_with("g ");
    return begins && rest.substr(0, 4096).find("\nv ") < rest.size();
}

class ObjReader {
public:
    ObjReader(std::string_view bytes, const std::string& name, const SurfaceOptions& options)
        : bytes_(bytes), name_(name), options_(options) {}

    Reading read() {
        std::size_t count = 0;
        for (const Line& line : lines_of(bytes_, name_, count)) {
            split_line(line.text, ' ', cells_);
            if (cells_[0] == "v") cloud_.points.push_back(vertex(line));
            if (cells_[0] == "f") take_face(line);
        }
        return map_of_mesh(std::move(cloud_), "Wavefront object", 1, name_, options_);
    }

private:
    std::array<double, 3> vertex(const Line& line) const {
        if (cells_.size() < 4) refuse_line(name_, line.number, {"has no x, y and z after v; must have them"});
        std::array<double, 3> point{};
        for (std::size_t k = 0; k < 3; ++k) {
            const std::string_view cell = cells_[k + 1];
            const auto number = number_in(cell, false);
            if (!number && !is_missing_word(cell))
                refuse_line(name_, line.number, {shown_cell(cell), " is not a number; must be one"});
            point[k] = number.value_or(std::numeric_limits<double>::quiet_NaN());
        }
        return point;
    }

    void take_face(const Line& line) {
        std::vector<std::uint32_t> corners;
        for (std::size_t k = 1; k < cells_.size(); ++k) {
            const std::string_view cell = cells_[k].substr(0, cells_[k].find('/'));
            const double index = number_in(cell, false).value_or(0),
                         place = index < 0 ? static_cast<double>(cloud_.points.size()) + index : index - 1;
            if (!(place >= 0 && place < 4294967294.0) || place != std::floor(place) || index == 0)
                refuse_line(name_, line.number,
                            {shown_cell(cell), " is no vertex; must be a whole number from 1, or from -1 backwards"});
            corners.push_back(static_cast<std::uint32_t>(place));
        }
        for (std::size_t k = 2; k < corners.size(); ++k)
            cloud_.faces.push_back({corners[0], corners[k - 1], corners[k]});
    }

    std::string_view bytes_;
    std::string name_;
    const SurfaceOptions& options_;
    std::vector<std::string_view> cells_;
    PointCloud cloud_;
};

}  // namespace

extern constexpr Reader obj_reader{.format = SurfaceFormat::obj,
                                   .endings = ".obj",
                                   .holds = "points or a mesh: vertices and faces of a Wavefront object",
                                   .recognised = "its first lines, v and three numbers",
                                   .asks_for = "--units, and --grid where x and y are on no regular grid",
                                   .options = "units grid",
                                   .begins = is_obj,
                                   .read = read_by<ObjReader>};

}  // namespace fstiff::inline v0_1::io::detail
