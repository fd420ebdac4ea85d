// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The sections of a scene, each read by a file of its own. Private to the files that read a scene.

#include "request/toml.hpp"
#include "scene/scene.hpp"
#include "surface/surface_option_table.hpp"

#include <fstiff/core/parallel.hpp>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace fstiff::scene {

using io::Dimension;
using request::Field;
using request::Section;
using request::si_unit;
using request::written;

/// The text of a scene, and what one part of it needs of another.
struct Source : request::Source {
    bool builtin = false;                 ///< the scene is the built-in one, whose laws nobody chose
    bool has_band = true;                 ///< asked for: a measured surface needs its neighbours
    bool needs_dimension_of_maps = true;  ///< some law takes D of a map, or a band of its numbers, for which H is
    std::vector<std::string> files{};     ///< that it names
    ParallelHook parallel{};              ///< of the measurement of a surface
};

/// As read_scene, of the parsed \p root; the scene has no sha256. \p builtin: nobody chose its laws.
[[nodiscard]] Scene read_table(const toml::table& root, const SceneSource& from, bool builtin = false);

/// Takes what was measured, or the file that --surface names, in place of \p surface. Its process, its wear and
/// what part of the face was measured stay.
void take_surface(Source& source, const SceneSource& from, const toml::table* surface, Scene& scene);
/// Reads [surface] into \p scene, or its two faces.
void read_surface(Source& source, const toml::table& table, Scene& scene, const ProgressHook& progress);
/// The bodies of \p table, steel where there is none, and the waves that meet the contact.
void read_materials(Source& source, const toml::table* table, Scene& scene);
void read_ultrasound(Source& source, const toml::table& table, Scene& scene);
/// Reads [gap]: what fills it, what crosses it, and the films on the contacts.
void read_gap(Source& source, const toml::table& table, Scene& scene);
void read_friction(Source& source, const toml::table& table, Scene& scene);
/// \p file, which the scene names relative to itself; "-" is standard input.
[[nodiscard]] std::string beside_scene(Source& source, const std::string& file);
/// Reads the option \p row of a surface from \p section into \p options; the name of a file is relative to the
/// scene. Returns whether it is there.
bool read_surface_option(Source& source, const Section& section, const surface::SurfaceOptionRow& row,
                         surface::SurfaceOptions& options);
/// Reads [contact] of \p root, with the sections of its laws, and of what crosses it, and resolves the joint.
/// \p replaced: the surface is not that of the scene.
void read_contact(Source& source, const Section& root, Scene& scene, bool replaced);
/// contact.nominal_area, or the ring of contact.washer or contact.bolt. The area of the built-in scene is not that of
/// another surface.
void read_area(Source& source, const Section& contact, Scene& scene, bool replaced);
/// How flat the faces are, by contact.flatness or contact.form, and what they have carried.
void read_form(Source& source, const Section& contact, Scene& scene);
/// Resolves scene.given with the faces of scene.joint, but for the laws and the peaks.
void resolve(Scene& scene);
/// The keys of a bearing curve, the first of them that is there, and what they make of \p of.
[[nodiscard]] std::vector<std::string_view> bearing_keys();
[[nodiscard]] std::string first_bearing_key(const Section& surface);
void read_bearing(Source& source, const Section& surface, JointFace& face);
/// Adds the number \p name, and other words for it, to \p keys.
inline void add_keys(std::string_view name, const NumberFacts& facts, std::vector<std::string_view>& keys) {
    keys.push_back(name);
    keys.insert(keys.end(), facts.words.begin(), facts.words.end());
}
/// Adds those of \p owner.
template <class Owner>
void add_keys_of(const Owner& owner, std::vector<std::string_view>& keys) {
    each_field(owner,
               [&](std::string_view name, const auto&, const NumberFacts& facts) { add_keys(name, facts, keys); });
}
/// Reads the number \p name of a joint into \p value, if \p section has it. \return whether it has.
template <class Value>
bool read_number(Source& source, const Section& section, std::string_view name, Value& value,
                 const NumberFacts& facts) {
    const toml::node* node = section.find(name);
    if (!node) return false;
    double number = 0;
    source.read(*node, section.key(name), number, request::field_of(facts));
    if (!facts.holds(number)) source.refuse(*node, section.key(name), "must be " + facts.allowed());
    value = number;
    return true;
}
/// Reads the numbers of \p owner that \p section has.
template <class Owner>
void read_numbers_of(Source& source, const Section& section, Owner& owner) {
    each_field(owner, [&](std::string_view name, auto& value, const NumberFacts& facts) {
        read_number(source, section, name, value, facts);
    });
}
/// The range \p section of values between \p from and \p to, which are read: of at most \p most, equal steps of the
/// logarithm where \p log is true and it has no spacing.
[[nodiscard]] Range read_range(request::Source& source, const Section& section, double from, double to, bool log,
                               std::uint64_t most);
inline constexpr std::array<std::string_view, 4> range_keys{"from", "to", "count", "spacing"};
/// A number that follows from one of another name, and where it belongs among Source::inputs.
struct Following {
    std::size_t place;
    std::string_view name, of;
    double value;  ///< as it is written
};
/// The key by which \p surface writes the number \p name of a face; empty: it does not.
[[nodiscard]] std::string key_of_number(const Section& surface, std::string_view name);
/// Reads the numbers of a face, and their standard errors. \return those that follow from what is written.
[[nodiscard]] std::vector<Following> read_numbers(Source& source, const Section& surface, JointFace& face);
void read_errors(Source& source, const Section& surface, JointFace& face);
/// Refuses Rz and its like in \p table, the section \p path.
void refuse_extremes(const Source& source, const toml::table& table, const std::string& path);

}  // namespace fstiff::scene
