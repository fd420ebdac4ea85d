// SPDX-License-Identifier: BSD-3-Clause
#include "input/output_options.hpp"

#include "input/progress.hpp"

#include <algorithm>
#include <utility>

namespace fstiff::cli {

void add_format_option(Arguments& arguments, OutputOptions& options, document::Format initial) {
    arguments.group("Output");
    options.format = initial;
    options.for_people = initial != document::Format::table;
    const request::Field field{.help = "table, csv or json; default " + std::string(name_of(initial)) +
                                       (options.for_people ? ", and table on a terminal" : ""),
                               .type = "FORMAT"};
    constexpr auto words = detail::choices<document::Format>();
    arguments.add("--format", field,
                  {"",
                   {words.begin(), words.end()},
                   "",
                   &options,
                   [](const request::Value& value, void* member, const std::string& key, const request::Field& range) {
                       auto& output = *static_cast<OutputOptions*>(member);
                       request::put(value, output.format, key, range);
                       output.for_people = false;
                   }});
}

void add_output_options(Arguments& arguments, OutputOptions& options, document::Format initial) {
    add_format_option(arguments, options, initial);
    add_output_option(arguments, options);
}

void add_output_option(Arguments& arguments, OutputOptions& options) {
    arguments.group("Output");
    arguments.option("-o,--output", options.file,
                     {.help = "write to FILE instead of standard output, which - is", .type = "FILE"});
    arguments.option("--force", options.force, {.help = "replace a file that fstiff did not make"});
}

namespace {

/// The headings of the options of a surface, in the order of the help.
constexpr std::string_view headings[] = {"Reading", "Cleaning", "Form, cut-offs", "Estimates"};

/// The place of the heading of \p row.
std::size_t heading_of(const surface::SurfaceOptionRow& row) {
    using surface::OptionGroup;
    switch (row.group) {
        case OptionGroup::file:
        case OptionGroup::step:
        case OptionGroup::file_of_profile:
        case OptionGroup::step_of_map:
        case OptionGroup::file_of_map: return 0;
        case OptionGroup::cleaning:
        case OptionGroup::cleaning_of_map: return 1;
        case OptionGroup::form_of_profile:
        case OptionGroup::form:
        case OptionGroup::filter: return 2;
        case OptionGroup::estimate: break;
    }
    return 3;
}

}  // namespace

void add_surface_option(Arguments& arguments, surface::SurfaceOptions& options, std::string_view key,
                        surface::SurfaceKind kind) {
    const surface::SurfaceOptionRow& row = surface::surface_option(key);
    arguments.group(headings[heading_of(row)]);
    row.visit(options, [&](auto& to) { arguments.option(row.flag_name(), to, row.field_for(kind)); });
}

void add_surface_options(Arguments& arguments, surface::SurfaceOptions& options, surface::SurfaceKind kind) {
    options.prefix = "--";
    options.format_name = "--input-format";
    std::vector<const surface::SurfaceOptionRow*> rows;
    for (const surface::SurfaceOptionRow& row : surface::surface_option_table())
        if (row.group != surface::OptionGroup::estimate && row.is_for(kind)) rows.push_back(&row);
    std::stable_sort(rows.begin(), rows.end(), [](const auto* a, const auto* b) {
        return std::pair(heading_of(*a), a->group) < std::pair(heading_of(*b), b->group);
    });
    for (const surface::SurfaceOptionRow* row : rows) add_surface_option(arguments, options, row->key, kind);
}

void add_scene_options(Arguments& arguments, SceneOptions& options, const std::string& scene_help,
                       const std::string& surface_help) {
    arguments.option("scene", options.scene, {.help = scene_help});
    if (!surface_help.empty()) arguments.option("--surface", options.surface, {.help = surface_help});
}

scene::Scene read_scene(const SceneOptions& options) {
    const ProgressHook progress = progress_bar();
    if (options.scene == "-" && options.surface == "-")
        throw Usage("the scene and --surface are both standard input; one of them must be a file");
    const bool builtin = options.scene.empty();
    scene::Scene scene =
        scene::read_scene(builtin ? scene::builtin_scene : document::read_all(options.scene, document::longest_scene),
                          {.name = builtin ? "built-in scene" : document::display_name(options.scene),
                           .surface = options.surface,
                           .progress = progress,
                           .parallel = all_cores(progress)});
    for (const std::string& file : scene.files) require_no_output(file);
    return scene;
}

actions::Answered computed(const scene::Scene& scene) {
    const ProgressHook progress = progress_bar();
    return actions::compute(scene, progress, all_cores(progress));
}

}  // namespace fstiff::cli
