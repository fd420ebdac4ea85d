// SPDX-License-Identifier: BSD-3-Clause
#include "input/surface_options.hpp"

#include <algorithm>

namespace fstiff::cli {

void add_surface_option(Arguments& arguments, SurfaceOptions& options, std::string_view key, SurfaceKind kind) {
    const SurfaceOptionRow& row = surface_option(key);
    row.visit(options, [&](auto& to) { arguments.option(row.flag_name(), to, row.field_for(kind)); });
}

void add_surface_options(Arguments& arguments, SurfaceOptions& options, SurfaceKind kind) {
    options.prefix = "--";
    options.format_name = "--input-format";
    std::vector<const SurfaceOptionRow*> rows;
    for (const SurfaceOptionRow& row : surface_option_table())
        if (row.group != OptionGroup::estimate && row.is_for(kind)) rows.push_back(&row);
    std::stable_sort(rows.begin(), rows.end(), [](const auto* a, const auto* b) { return a->group < b->group; });
    for (const SurfaceOptionRow* row : rows) add_surface_option(arguments, options, row->key, kind);
}

}  // namespace fstiff::cli
