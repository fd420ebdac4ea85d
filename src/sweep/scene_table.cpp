// SPDX-License-Identifier: BSD-3-Clause
#include "sweep/scene_table.hpp"

#include "document/file.hpp"
#include "sweep/template.hpp"

#include <cmath>
#include <cstdint>

namespace fstiff::sweep {

toml::table table_of(const Grid& grid, const std::vector<Value>& values) {
    toml::table root = grid.form->root;
    for (std::size_t i = 0; i < grid.axes.size(); ++i) {
        const Axis& axis = grid.axes[i];
        const double number = values[i].number;
        const auto put = [&](const toml::node& node) { put_at(root, axis.key, node, grid.file); };
        if (!grid.form->listed[i].empty())
            put(*grid.form->listed[i].get(values[i].place));
        else if (!axis.unit.empty())
            put(toml::value(document::shortest(number) + " " + axis.unit));
        else if (axis.whole && number == std::round(number))
            put(toml::value(static_cast<std::int64_t>(number)));
        else
            put(toml::value(number));
    }
    return root;
}

}  // namespace fstiff::sweep
