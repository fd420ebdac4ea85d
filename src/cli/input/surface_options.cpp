// SPDX-License-Identifier: BSD-3-Clause
#include "input/surface_options.hpp"

#include <algorithm>

namespace fstiff::cli {

void add_surface_option(Arguments& arguments, surface::SurfaceOptions& options, std::string_view key,
                        surface::SurfaceKind kind) {
    const surface::SurfaceOptionRow& row = surface::surface_option(key);
    row.visit(options, [&](auto& to) { arguments.option(row.flag_name(), to, row.field_for(kind)); });
}

void add_surface_options(Arguments& arguments, surface::SurfaceOptions& options, surface::SurfaceKind kind) {
    options.prefix = "--";
    options.format_name = "--input-format";
    std::vector<const surface::SurfaceOptionRow*> rows;
    for (const surface::SurfaceOptionRow& row : surface::surface_option_table())
        if (row.group != surface::OptionGroup::estimate && row.is_for(kind)) rows.push_back(&row);
    std::stable_sort(rows.begin(), rows.end(), [](const auto* a, const auto* b) { return a->group < b->group; });
    for (const surface::SurfaceOptionRow* row : rows) add_surface_option(arguments, options, row->key, kind);
}

}  // namespace fstiff::cli
