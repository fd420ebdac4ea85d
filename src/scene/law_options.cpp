// SPDX-License-Identifier: BSD-3-Clause
#include "scene/law_options.hpp"

#include "scene/readers.hpp"

#include <string>

namespace fstiff::scene {
namespace {

/// The section contact.\p law, or \p law at the root where it is shared; null where there is neither. \p path is where
/// it was found.
const toml::table* section_of_law(request::Source& source, const Section& root, LawName law, std::string& path) {
    const std::string name(name_of(law));
    const toml::node* contact = root.find("contact");
    const toml::node* within = contact && contact->is_table() ? contact->as_table()->get(name) : nullptr;
    const toml::node* at_root = is_shared(law) ? root.find(name) : nullptr;
    path = (within || !is_shared(law) ? "contact." : "") + name;
    if (within && at_root)
        throw domain_error(source.at(*at_root) + ": " + name + ": must not be given with " + path +
                           "; give one of the two");
    const toml::node* section = within ? within : at_root;
    if (!section) return nullptr;
    if (!section->is_table()) source.refuse(*section, path, "must be a section of keys");
    return section->as_table();
}

}  // namespace

void read_law_options(request::Source& source, const Section& root, LawName law, Scene& scene) {
    std::string path;
    static const toml::table none;
    const toml::table* table = section_of_law(source, root, law, path);
    const auto fields = [&](auto take) { each_law_option(law, scene.law_options, take); };
    const Section section(source, table ? *table : none, path, request::keys_of(fields));
    section.read(fields, [&](std::string_view key, const auto& to) {
        if constexpr (std::is_same_v<decltype(to), const bool&>)
            if (!is_shared(law)) source.record_default(section.key(key), to ? "1" : "0", to ? 1 : 0);
    });
    if (section.find("spectrum") && scene.law_options.spectrum == detail::SpectrumSource::map && !scene.face.map)
        section.refuse("spectrum", "needs a map: surface.from, or --surface, must name the file of one");
}

}  // namespace fstiff::scene
