// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The sections of a scene, each read by a file of its own. Private to the files that read a scene.

#include "scene/source.hpp"

#include <fstiff/core/progress.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace fstiff::scene {

/// Measures the file that --surface names, or reads what fstiff measure made of it.
void read_file_of_surface(Source& source, const std::string& file, Scene& scene, const ProgressHook& progress);
/// \p measured in place of [surface].
void take_surface_in_place(Source& source, const MeasuredSurface& measured, Scene& scene);
/// Reads [surface] into \p scene, or its two faces.
void read_surface(Source& source, const toml::table& table, Scene& scene, const ProgressHook& progress);
/// The bodies of \p table, steel where there is none, and the waves that meet the contact.
void read_materials(Source& source, const toml::table* table, Scene& scene);
void read_ultrasound(Source& source, const toml::table& table, Scene& scene);
/// Reads [gap]: what fills it, what crosses it, and the films on the spots.
void read_gap(Source& source, const toml::table& table, Scene& scene);
void read_friction(Source& source, const toml::table& table, Scene& scene);
/// Reads [contact] of \p root, with the sections of its laws. \p replaced: the surface is not that of the scene.
void read_contact(Source& source, const Section& root, Scene& scene, bool replaced);
/// The keys of a bearing curve, and what they make of \p face, whose rms height is known; nothing where none is there.
[[nodiscard]] std::vector<std::string_view> bearing_keys();
[[nodiscard]] bool has_bearing(const Section& surface);
void read_bearing(Source& source, const Section& surface, Face& face);
/// The keys that give height and gradient by other names than rms_height and rms_gradient, and what they make of \p
/// face, which is not measured. What they leave open gets a prior.
[[nodiscard]] std::vector<std::string_view> roughness_keys();
void read_roughness(Source& source, const Section& surface, Face& face);
/// Refuses Rz and its like in \p table, the section \p path.
void refuse_extremes(const Source& source, const toml::table& table, const std::string& path);
/// \p value, which the number or length \p key of \p surface made, over that number or length.
[[nodiscard]] double over_written(const Section& surface, std::string_view key, double value);
/// An angle with its unit, or a number of radians.
[[nodiscard]] double read_angle(Source& source, const toml::node& node, const std::string& key);

}  // namespace fstiff::scene
