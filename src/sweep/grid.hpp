// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// A grid of scenes: a scene in which some quantities are ranges, lists or distributions. It is never expanded: the
// values of a scene follow from its index. The form of the file is in docs/sweep.md.
//
//     const Grid grid = read_grid(text, "grid.toml");
//     std::vector<Value> values;
//     grid.values(17, values);                    of the 18th scene, one for each of grid.axes
//
// The last quantity in the file varies fastest; the draws of one point of the grid are adjacent.

#include "scene/scene.hpp"
#include "sweep/draws.hpp"

#include <fstiff/core/names.hpp>

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace fstiff::sweep {

enum class Mode {
    product,  ///< every value of one quantity with every value of the others
    zip       ///< the first values of all, the second values of all, ...
};

/// One swept quantity: a range, a distribution, or a list of numbers or texts.
struct Axis {
    std::string key;   ///< path in the scene, such as "surface.rms_height" or "contact.pressures[0]"
    std::string unit;  ///< SI; empty of plain numbers and texts
    std::optional<scene::Range> range{};
    std::optional<Distribution> drawn{};
    std::uint32_t input = 0;             ///< of a distribution: its number among them
    std::vector<double> numbers{};       ///< of a list of quantities or numbers
    std::vector<std::string> texts{};    ///< of any other list: as results show them
    bool whole = false;                  ///< of a range: whole numbers stay whole numbers
    std::optional<std::size_t> point{};  ///< its place among the points of the scene; none: it is not one of them

    /// 1 for a distribution: its draws are samples of every point of the grid.
    [[nodiscard]] std::uint64_t count() const {
        return range ? range->count : drawn ? 1 : numbers.empty() ? texts.size() : numbers.size();
    }
    [[nodiscard]] bool is_text() const { return !texts.empty(); }
    /// The number at \p place; the median of a distribution, 0 of a text.
    [[nodiscard]] double number_at(std::uint64_t place) const {
        return drawn ? drawn->quantile(0.5) : range ? range->at(place) : numbers.empty() ? 0 : numbers[place];
    }
};

/// Value of one scene on an axis.
struct Value {
    double number = 0;        ///< SI; 0 of a text
    std::uint64_t place = 0;  ///< on the axis; 0 of a distribution
    [[nodiscard]] bool operator==(const Value& other) const = default;
};

/// Scenes by their indices: from \p first up to \p end, which is none of them.
struct Rows {
    std::uint64_t first = 0, end = 0;
};

struct Template;  // the TOML of the scene

struct Grid {
    std::string file;                ///< as messages call it
    std::vector<std::string> files;  ///< that it names
    Mode mode = Mode::product;
    std::uint64_t samples = 1;  ///< draws at each point of the grid
    std::uint64_t seed = 2014;
    std::vector<Axis> axes;       ///< in the order of the file
    std::uint64_t size = 0;       ///< scenes
    std::set<std::string> in_si;  ///< keys of axes that a program has given, whose numbers are in SI
    std::shared_ptr<const Template> form;

    /// Replaces \p values by those of the scene \p index, which is less than size.
    void values(std::uint64_t index, std::vector<Value>& values) const;
    /// \throws option_error, which begins with \p shown, where \p rows are none or not all of the grid.
    void require(const Rows& rows, const std::string& shown) const;
};

/// What a program sweeps in a scene, by keys such as those of axes.
struct Given {
    std::string
        text{};  ///< TOML: a range, a distribution or { values = [...] } for each "key"; "sweep" is that section
    std::map<std::string, std::vector<double>> numbers{};  ///< further values of a key whose list has the first one
};

/// \throws domain_error "<file>:<line>: <key> = <value>: must be ...", file_error for a file that the scene names and
/// that cannot be read.
[[nodiscard]] Grid read_grid(const std::string& text, const std::string& file, const Given& given = {});

}  // namespace fstiff::sweep

namespace fstiff {

template <>
inline constexpr auto enum_names<sweep::Mode> = detail::name_list<sweep::Mode>({{sweep::Mode::product, "product"},
                                                                                {sweep::Mode::zip, "zip"}});

}  // namespace fstiff
