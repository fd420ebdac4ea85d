// SPDX-License-Identifier: BSD-3-Clause
// Height and gradient of [surface] by the names that drawings and instruments have for them.
#include "scene/readers.hpp"

#include <array>
#include <optional>
#include <string>

namespace fstiff::scene {
namespace {

using Keys = std::span<const std::string_view>;

constexpr std::array<std::string_view, 5> height_keys{"rms_height", "Rq", "Sq", "Ra", "Sa"};
constexpr std::array<std::string_view, 4> gradient_keys{"rms_gradient", "Sdq", "Rdq", "RSm"};

/// The one of \p keys that is there; empty where none is.
std::string_view one_of(const Source& source, const Section& surface, Keys keys) {
    std::string_view found;
    for (const std::string_view key : keys) {
        const toml::node* node = surface.find(key);
        if (!node) continue;
        if (!found.empty())
            throw domain_error(source.at(*node) + ": " + surface.key(key) + ": must not be given with " +
                               surface.key(found) + "; give one of the two");
        found = key;
    }
    return found;
}

std::optional<Following> read_height(Source& source, const Section& surface, JointFace& of) {
    const std::string_view key = one_of(source, surface, height_keys);
    if (key.empty())
        (void)surface.at("rms_height",
                         "is missing; the scene needs the height of the surface: rms_height, Rq, Sq, Ra or Sa");
    (key.back() == 'a' ? of.mean_height : of.rms_height) = surface.positive(key, Dimension::length);
    if (key == "rms_height") return std::nullopt;
    return Following{source.inputs.size(), Parameter::rms_height, key};
}

std::optional<Following> read_gradient(Source& source, const Section& surface, JointFace& of) {
    const std::string_view key = one_of(source, surface, gradient_keys);
    if (key.empty() || key == "rms_gradient") return std::nullopt;  // read_spectrum() reads that
    if (key == "RSm") {
        of.profile_spacing = surface.positive(key, Dimension::length);
    } else {
        const double slope = source.number(surface.at(key), surface.key(key));
        if (!(slope > 0)) source.refuse(surface.at(key), surface.key(key), "must be greater than 0");
        (key == "Sdq" ? of.rms_gradient : of.profile_gradient) = slope;
    }
    return Following{source.inputs.size(), Parameter::rms_gradient, key};
}

}  // namespace

std::vector<std::string_view> roughness_keys() {
    std::vector<std::string_view> keys(height_keys.begin() + 1, height_keys.end());
    keys.insert(keys.end(), gradient_keys.begin() + 1, gradient_keys.end());
    return keys;
}

void refuse_extremes(const Source& source, const toml::table& table, const std::string& path) {
    for (const char* key : {"Rz", "Rt", "Sz", "Rmax"})
        if (const toml::node* node = table.get(key))
            source.refuse(*node, path + "." + key,
                          "is the height from the deepest valley to the highest peak, 4 to 10 times Ra and different "
                          "at every place; give Ra or Rq (Sa or Sq for a map)");
}

std::vector<Following> read_roughness(Source& source, const Section& surface, JointFace& of) {
    std::vector<Following> all;
    for (const auto read : {read_height, read_gradient})
        if (const auto one = read(source, surface, of)) all.push_back(*one);
    return all;
}

}  // namespace fstiff::scene
