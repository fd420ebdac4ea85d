// SPDX-License-Identifier: BSD-3-Clause
#include "scene/law_options.hpp"

#include "document/file.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace fstiff::scene {
namespace {

using enum LawName;
using Of = LawOptions;

// clang-format off
constexpr LawOption rows[] = {
    {summits, "mutual", &Of::mutual},
    {persson, "gamma", &Of::gamma, 0, 1},
    {persson, "spectrum", &Of::spectrum},
    {boundary_elements, "points", &Of::points, 16, 4096},
    {boundary_elements, "edges", &Of::edges},
    {boundary_elements, "hardness", &Of::hardness, 0, 0, Dimension::pressure},
};
// clang-format on

/// Reads \p node, the value of \p row, into \p field of the options of \p scene.
struct Reader {
    Source& source;
    const LawOption& row;
    const toml::node& node;
    std::string key;
    Scene& scene;

    void operator()(bool Of::*field) const {
        const auto value = node.is_boolean() ? std::optional(node.as_boolean()->get() ? 1.0 : 0.0) : plain_number(node);
        if (!value || (*value != 0 && *value != 1)) source.refuse(node, key, "must be true or false, or 1 or 0");
        source.record(key, written(node), *value);
        scene.law_options.*field = *value == 1;
    }
    void operator()(double Of::*field) const {
        const double value = row.dimension ? source.positive(node, key, *row.dimension) : source.number(node, key);
        if (!row.dimension && !(value > row.low && value <= row.high))
            source.refuse(node, key,
                          "must be greater than " + shortest(row.low) + " and at most " + shortest(row.high));
        scene.law_options.*field = value;
    }
    void operator()(int Of::*field) const {
        const auto whole = node.is_integer() ? node.value<std::int64_t>() : std::nullopt;
        if (!whole || !(static_cast<double>(*whole) >= row.low && static_cast<double>(*whole) <= row.high))
            source.refuse(node, key, "must be a whole number from " + shortest(row.low) + " to " + shortest(row.high));
        source.record(key, written(node), static_cast<double>(*whole));
        scene.law_options.*field = static_cast<int>(*whole);
    }
    void operator()(Edges Of::*field) const { scene.law_options.*field = source.choice<Edges>(node, key); }
    void operator()(std::optional<SpectrumSource> Of::*field) const {
        scene.law_options.*field = source.choice<SpectrumSource>(node, key);
        if (scene.law_options.*field == SpectrumSource::map && !scene.face.map)
            source.refuse(node, key, "needs a map: surface.from, or --surface, must name the file of one");
    }
};

/// The section contact.\p law, or \p law at the root where it is shared; null where there is neither. \p path is where
/// it was found.
const toml::table* section_of_law(Source& source, const Section& root, LawName law, std::string& path) {
    const std::string name(name_of(law));
    const toml::node* contact = root.find("contact");
    const toml::node* within = contact && contact->is_table() ? contact->as_table()->get(name) : nullptr;
    const toml::node* at_root = is_shared(law) ? root.find(name) : nullptr;
    path = (within || !is_shared(law) ? "contact." : "") + name;
    if (within && at_root)
        throw domain_error(source.at(*at_root) + ": " + name + ": must not be given with " + path +
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
            std::visit(Reader{source, row, *node, section.key(row.key), scene}, row.field);
        else if (const auto* flag = std::get_if<bool LawOptions::*>(&row.field); flag && !is_shared(law))
            source.record_default(section.key(row.key), scene.law_options.**flag ? "1" : "0",
                                  scene.law_options.**flag ? 1 : 0);
    }
}

}  // namespace fstiff::scene
