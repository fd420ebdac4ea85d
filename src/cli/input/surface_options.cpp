// SPDX-License-Identifier: BSD-3-Clause
#include "input/surface_options.hpp"

#include <algorithm>

namespace fstiff::cli {

namespace {

/// Adds one option of the surface.
struct OptionAdder {
    Arguments& arguments;
    const std::string name, help;
    const SurfaceOptionRow& row;
    SurfaceKind kind;

    void operator()(std::string& to) const {
        Option option = arguments.option(name, to, help);
        if (row.more.words) option.one_of(row.more.words(kind));
    }
    void operator()(Lengths& to) const {
        take<Lengths>(to, [](const std::string& text) { return text; });
    }
    void operator()(int& to) const { arguments.option(name, to, help).between(row.more.low, row.more.high); }
    void operator()(double& to) const {
        arguments.option(name, to, help).between(static_cast<double>(row.more.low), static_cast<double>(row.more.high));
    }
    void operator()(bool& to) const { arguments.flag(name, to, help); }
    template <parts::NamedEnum Enum>
    void operator()(Enum& to) const {
        arguments.option(name, to, help);
    }
    template <parts::NamedEnum Enum>
    void operator()(std::optional<Enum>& to) const {
        take<std::optional<Enum>>(to, parts::find_named<Enum>).one_of(parts::choices<Enum>());
    }

private:
    template <class To, class Read>
    Option take(To& to, const Read& read) const {
        const std::function<void(const std::string&)> put = [&to, read](const std::string& text) { to = read(text); };
        return arguments.option(name, put, help);
    }
};

}  // namespace

void add_surface_option(Arguments& arguments, SurfaceOptions& options, std::string_view key, std::string_view help) {
    const SurfaceOptionRow& row = surface_option(key);
    const std::string text(help.empty() ? row.help : help);
    row.visit(options, OptionAdder{arguments, row.flag_name(), text, row, SurfaceKind::any});
}

void add_surface_options(Arguments& arguments, SurfaceOptions& options, SurfaceKind kind) {
    options.prefix = "--";
    options.format_name = "--input-format";
    std::vector<const SurfaceOptionRow*> rows;
    for (const SurfaceOptionRow& row : surface_option_table())
        if (row.group != OptionGroup::estimate && row.is_for(kind)) rows.push_back(&row);
    std::stable_sort(rows.begin(), rows.end(), [](const auto* a, const auto* b) { return a->group < b->group; });
    for (const SurfaceOptionRow* row : rows)
        row->visit(options, OptionAdder{arguments, row->flag_name(), std::string(row->help_for(kind)), *row, kind});
}

std::string source_lines(const SurfaceInput& input, std::string_view indent) {
    std::string text;
    for (const std::string& decision : input.surface.record.sentences()) text += std::string(indent) + decision + "\n";
    return text;
}

}  // namespace fstiff::cli
