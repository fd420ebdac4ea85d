// SPDX-License-Identifier: BSD-3-Clause
#include "sweep/template.hpp"

#include "document/file.hpp"

#include <fstiff/core/error.hpp>

#include <cmath>
#include <cstdint>

namespace fstiff::sweep {
namespace {

/// Puts \p value at \p key, such as "surface.rms_height" or "contact.pressures[0]".
template <class Node>
void put(toml::table& root, const std::string& key, Node&& value) {
    const std::size_t end = key.find_last_of(".[");
    toml::node& parent = *toml::at_path(root, std::string_view(key).substr(0, end)).node();
    if (auto* list = parent.as_array())
        list->replace(list->cbegin() + std::stol(key.substr(end + 1)), std::forward<Node>(value));
    else
        parent.as_table()->insert_or_assign(key.substr(end + 1), std::forward<Node>(value));
}

}  // namespace

void put_at(toml::table& root, const std::string& key, const toml::node& node, const std::string& file) {
    const std::size_t end = key.find_last_of(".[");
    if (end == std::string::npos) return node.visit([&](const auto& value) { root.insert_or_assign(key, value); });
    toml::table* table = &root;
    std::size_t begin = 0;
    for (std::size_t dot = 0; table && (dot = key.find('.', begin)) < key.find('['); begin = dot + 1)
        table = table->emplace<toml::table>(key.substr(begin, dot - begin)).first->second.as_table();
    const std::string place = key.back() == ']' ? key : key.substr(0, end);
    if (const auto there = toml::at_path(root, place); !there || (key.back() != ']' && !there.is_table()))
        throw domain_error(file + ": " + key + ": is no place of the scene");
    node.visit([&](const auto& value) { put(root, key, value); });
}

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
