// SPDX-License-Identifier: BSD-3-Clause
#include "scene/law_options.hpp"

#include "document/file.hpp"

#include <string>
#include <vector>

namespace fstiff::scene {
namespace {

using enum LawName;
using Of = LawOptions;

// clang-format off
constexpr LawOption rows[] = {
    {summits, "mutual", &Of::mutual, "summits push each other down"},
    {persson, "gamma", &Of::gamma, "share of the elastic energy of full contact", 0, 1},
    {persson, "spectrum", &Of::spectrum, "spectrum of persson and hybrid: that of the map, or of the moments"},
    {boundary_elements, "points", &Of::points, "points along the longer side of the grid", 16, 4096},
    {boundary_elements, "edges", &Of::edges, "how the map goes on beyond its edges"},
    {boundary_elements, "hardness", &Of::hardness, "pressure at which contacts flow", 0, 0, Dimension::pressure},
};
// clang-format on

/// Reads the value of one row at \p node.
class Reader {
public:
    Reader(Source& source, const LawOption& row, const toml::node& node, std::string key, const Scene& scene)
        : source_(source), row_(row), node_(node), key_(std::move(key)), scene_(scene) {}

    void operator()(bool& flag) const {
        const auto value =
            node_.is_boolean() ? std::optional(node_.as_boolean()->get() ? 1.0 : 0.0) : node_.value<double>();
        if (!value || (*value != 0 && *value != 1)) source_.refuse(node_, key_, "must be true or false, or 1 or 0");
        source_.record(key_, written(node_), *value);
        flag = *value == 1;
    }
    void operator()(double& number) const {
        if (row_.dimension) {
            number = source_.positive(node_, key_, *row_.dimension);
            return;
        }
        number = source_.number(node_, key_);
        if (!(number > row_.low && number <= row_.high))
            source_.refuse(node_, key_, "must be greater than " + shortest(row_.low) + " and at most " + shortest(row_.high));
    }
    void operator()(int& count) const {
        const auto* whole = node_.as_integer();
        if (!whole || !(static_cast<double>(whole->get()) >= row_.low && static_cast<double>(whole->get()) <= row_.high))
            source_.refuse(node_, key_, "must be a whole number from " + shortest(row_.low) + " to " + shortest(row_.high));
        source_.record(key_, written(node_), static_cast<double>(whole->get()));
        count = static_cast<int>(whole->get());
    }
    void operator()(Edges& edges) const { edges = source_.choice<Edges>(node_, key_); }
    void operator()(std::optional<SpectrumSource>& spectrum) const {
        spectrum = source_.choice<SpectrumSource>(node_, key_);
        if (spectrum == SpectrumSource::map && !scene_.map)
            source_.refuse(node_, key_, "needs a map: surface.from, or --surface, must name the file of one");
    }

private:
    Source& source_;
    const LawOption& row_;
    const toml::node& node_;
    std::string key_;
    const Scene& scene_;
};

/// The section contact.\p law, or \p law at the root where it is shared; null where there is neither. \p path is where it was
/// found.
const toml::table* section_of_law(Source& source, const Section& root, LawName law, std::string& path) {
    const std::string name(name_of(law));
    const toml::node* contact = root.find("contact");
    const toml::node* within = contact && contact->is_table() ? contact->as_table()->get(name) : nullptr;
    const toml::node* at_root = is_shared(law) ? root.find(name) : nullptr;
    path = (within || !is_shared(law) ? "contact." : "") + name;
    if (within && at_root)
        throw domain_error(source.at(*at_root) + ": " + name + ": must not stand next to " + path +
                           "; give one of the two");
    const toml::node* found = within ? within : at_root;
    if (!found) return nullptr;
    if (!found->is_table()) source.refuse(*found, path, "must be a section of keys");
    return found->as_table();
}

}  // namespace

std::span<const LawOption> law_option_table() { return rows; }

bool is_shared(LawName law) { return law == persson || law == boundary_elements; }

std::vector<LawName> laws_with_options() {
    std::vector<LawName> laws;
    for (const LawOption& row : rows)
        if (laws.empty() || laws.back() != row.law) laws.push_back(row.law);
    return laws;
}

void read_law_options(Source& source, const Section& root, LawName law, Scene& scene) {
    std::string path;
    static const toml::table none;
    const toml::table* table = section_of_law(source, root, law, path);
    std::vector<std::string_view> keys;
    for (const LawOption& row : rows)
        if (row.law == law) keys.push_back(row.key);
    const Section section(source, table ? *table : none, path, keys);
    for (const LawOption& row : rows) {
        if (row.law != law) continue;
        if (const toml::node* node = section.find(row.key))
            std::visit([&](auto field) { Reader(source, row, *node, section.key(row.key), scene)(scene.law_options.*field); },
                       row.field);
        else if (const auto* flag = std::get_if<bool LawOptions::*>(&row.field); flag && !is_shared(law))
            source.record(section.key(row.key), scene.law_options.**flag ? "1 (default)" : "0 (default)",
                          scene.law_options.**flag ? 1 : 0);
    }
}

}  // namespace fstiff::scene
