// SPDX-License-Identifier: BSD-3-Clause
// The nominal area of [contact]: a number, a ring, the bearing face of a bolt; and the form of the faces over it.
#include "scene/bolts.hpp"
#include "scene/readers.hpp"
#include "surface/surface_file.hpp"
#include "surface/surface_option_table.hpp"

#include <fstiff/halfspace/measured_form.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>

namespace fstiff::scene {
namespace {

/// The ring of contact.washer.
Ring read_washer(Source& source, const toml::node& node, const std::string& key) {
    if (!node.is_table()) source.refuse(node, key, "must be a table such as { inner = \"8.4 mm\", outer = \"16 mm\" }");
    const Section ring(source, node.as_table(), key, {"inner", "outer"});
    const double inner = source.quantity(ring.at("inner"), ring.key("inner"), Dimension::length);
    const double outer = ring.positive("outer", Dimension::length);
    if (!(inner >= 0)) ring.refuse("inner", "must be 0 or greater");
    if (!(outer > inner)) ring.refuse("outer", "must be greater than " + ring.key("inner"));
    return {inner, outer};
}

/// The ring under the head of contact.bolt, or under its washer.
Ring read_bolt(Source& source, const toml::node& node, const std::string& key) {
    constexpr std::array<std::string_view, 3> parts{"head", "socket", "washer"};
    if (!node.is_string() && !node.is_table())
        source.refuse(node, key,
                      R"(must be a size such as "M10", or a table such as { size = "M10", under = "washer" })");
    const Section bolt(source, node.as_table(), key, {"size", "under"});
    const toml::node& size = node.is_string() ? node : bolt.at("size");
    const std::string size_key = node.is_string() ? key : bolt.key("size");
    std::vector<std::string_view> names;
    for (const BoltSize& each : bolt_sizes) names.push_back(each.name);
    const BoltSize& found = bolt_sizes[source.choice(size, size_key, names)];
    const toml::node* under = bolt.find("under");
    const std::size_t part = under ? source.choice(*under, bolt.key("under"), parts) : 0;
    if (!under) source.record_default(bolt.key("under"), "head");
    const double outer = part == 0 ? found.head : part == 1 ? found.socket : found.washer;
    source.record(key + " (ring)", document::shortest(found.hole) + " to " + document::shortest(outer) + " mm",
                  found.hole * 1e-3, "m");
    return {found.hole * 1e-3, outer * 1e-3};
}

/// The file of contact.form, or its table: how the map of the gap is read, or both faces, whose gap it is.
surface::SurfaceOptions read_gap_options(Source& source, const toml::node& node, const std::string& key) {
    surface::SurfaceOptions options;
    if (!node.is_table()) {
        options.file = beside_scene(source, source.text(node, key));
        return options;
    }
    const auto is_of_reading = [](const surface::SurfaceOptionRow& row) {
        using enum surface::OptionGroup;
        return row.is_of_file() || row.group == step || row.group == step_of_map || row.group == cleaning;
    };
    std::vector<std::string_view> keys{"from"};
    for (const surface::SurfaceOptionRow& row : surface::surface_option_table())
        if (is_of_reading(row) && row.is_for(surface::SurfaceKind::map)) keys.push_back(row.key);
    const Section form(source, node.as_table(), key, keys);
    options.file = beside_scene(source, source.text(form.at("from"), form.key("from")));
    for (const surface::SurfaceOptionRow& row : surface::surface_option_table())
        read_surface_option(source, form, row, options);
    return options;
}

/// The map of the gap in the file of contact.form; the area of \p scene becomes its own where none is given.
std::shared_ptr<const JointForm> read_gap_map(Source& source, const toml::node& node, const Section& contact,
                                              Scene& scene) {
    const std::string key = contact.key("form"), area_key = contact.key("nominal_area");
    const surface::SurfaceOptions options = read_gap_options(source, node, key);
    return detail::located(source.place(node, key), [&] {
        surface::SurfaceInput input = surface::read_surface_input(options);
        if (input.surface.is_profile())
            throw domain_error(document::display_name(options.file) + ": is a profile; must be a map of the gap");
        HeightMap<double> map = input.take_map();
        if (!options.facing.empty()) map.heights = -map.heights;  // the gap of both faces, not the sum of their heights
        std::optional<double>& area = scene.given.nominal_area;
        if (!area) area = map.area(), source.record_default(area_key, "of the form", *area, si_unit(Dimension::area));
        if (std::abs(map.area() / *area - 1) > 0.02)
            throw domain_error(document::display_name(options.file) + ": has an area of " +
                               document::rounded(map.area() * 1e6, 3) + " mm^2; must be that of " + area_key + ", " +
                               document::rounded(*area * 1e6, 3) + " mm^2");
        return std::make_shared<const JointForm>(measured_form(map));
    });
}

}  // namespace

void read_area(Source& source, const Section& contact, Scene& scene, bool replaced) {
    if (!(source.builtin && replaced))
        scene.given.nominal_area = contact.optional_positive("nominal_area", Dimension::area);
    const std::string_view way = contact.one_of(std::array<std::string_view, 3>{"nominal_area", "washer", "bolt"});
    if (way.empty() || way == "nominal_area") return;
    const toml::node& node = contact.at(way);
    const std::string key = contact.key(way);
    const Ring ring = way == "washer" ? read_washer(source, node, key) : read_bolt(source, node, key);
    const double area = ring.area();
    if (!(area > 0) || !std::isfinite(area))
        source.refuse(node, key, "must have an area in the range of double precision");
    scene.given.nominal_area = area, scene.given.ring = ring;
    scene.joint.is_given.force = true;
    source.record(contact.key("nominal_area"), "of the " + std::string(way) + ", pi/4 (outer^2 - inner^2)", area,
                  si_unit(Dimension::area));
}

void read_form(Source& source, const Section& contact, Scene& scene) {
    each_field(scene.given, [&](std::string_view name, auto& value, const NumberFacts& facts) {
        if (name != "nominal_area" && name != "effective_modulus")  // read before, and that of [material]
            read_number(source, contact, name, value, facts);
    });
    if (const toml::node* node = contact.find("form")) {
        if (contact.find("flatness")) contact.refuse("flatness", "must not be given with " + contact.key("form"));
        scene.given.form = read_gap_map(source, *node, contact, scene);
    }
    if (contact.find("aspect_ratio"))
        for (const char* other : {"washer", "bolt", "form"})
            if (contact.find(other)) contact.refuse("aspect_ratio", "must not be given with " + contact.key(other));
    if (contact.find("aspect_ratio") && !scene.given.nominal_area)
        contact.refuse("aspect_ratio", "needs " + contact.key("nominal_area") + ", of which it is");
    if (contact.find("flatness") && !scene.given.nominal_area)
        contact.refuse("flatness", "needs " + contact.key("nominal_area") + ", " + contact.key("washer") + " or " +
                                       contact.key("bolt") + ", over which it is measured");
    for (const char* other : {"ball_radius", "separations"})
        if ((scene.given.flatness || scene.given.form) && contact.find(other))
            contact.refuse(other, "must not be given with a flatness or a form");
}

}  // namespace fstiff::scene
