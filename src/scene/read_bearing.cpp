// SPDX-License-Identifier: BSD-3-Clause
// The bearing curve of [surface] as it is written: skewness and kurtosis, parameters of the core, or a list of heights.
#include "scene/readers.hpp"

#include <fstiff/surface/bearing_family.hpp>
#include <fstiff/surface/material_ratio.hpp>

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <vector>

namespace fstiff::scene {
namespace {

/// The parameters of the core of a map and of a profile.
using CoreKeys = std::array<std::string_view, 5>;
constexpr std::array<CoreKeys, 2> core_keys{
    {{"Sk", "Spk", "Svk", "Smr1", "Smr2"}, {"Rk", "Rpk", "Rvk", "Rmr1", "Rmr2"}}};

parts::BearingSlope<double> read_core(const Section& surface, const CoreKeys& keys) {
    parts::MaterialRatio<double> core{};
    const std::array<double*, 5> members{&core.core_height, &core.reduced_peak_height, &core.reduced_valley_depth,
                                         &core.peak_share, &core.core_and_peak_share};
    const auto fields = [&](auto take) {
        for (std::size_t i = 0; i < keys.size(); ++i)
            take(keys[i], *members[i], i < 3 ? Field{.dimension = Dimension::length} : Field{});
    };
    std::string names(keys[0]);
    for (std::size_t i = 1; i < keys.size(); ++i)
        names += (i + 1 < keys.size() ? ", " : " and ") + std::string(keys[i]);
    surface.read(fields, [&](std::string_view key, double) {
        static_cast<void>(surface.at(key, "is missing; " + names + " belong together"));
    });
    try {
        return parts::bearing_of_core(core);
    } catch (const domain_error& error) {  // by the names of a map
        const auto place =
            std::find(core_keys[0].begin(), core_keys[0].end(), error.parameter()) - core_keys[0].begin();
        surface.refuse(keys[static_cast<std::size_t>(place)], std::string(error.reason()));
    }
}

parts::BearingSlope<double> read_heights(Source& source, const toml::node& node, const std::string& key) {
    constexpr std::size_t least = 10;
    const auto* list = node.as_array();
    if (!list || list->size() < least)
        source.refuse(node, key,
                      "must be a list of at least " + std::to_string(least) +
                          " lengths, heights at equal "
                          "steps of the material ratio in any order");
    std::vector<double> heights;
    for (std::size_t i = 0; i < list->size(); ++i)
        heights.push_back(source.quantity((*list)[i], key + "[" + std::to_string(i) + "]", Dimension::length));
    return source.located(node, [&] { return parts::BearingSlope<double>::of_heights(heights); });
}

}  // namespace

std::vector<std::string_view> bearing_keys() {
    std::vector<std::string_view> keys{"skewness", "kurtosis", "bearing_curve"};
    for (const CoreKeys& core : core_keys) keys.insert(keys.end(), core.begin(), core.end());
    return keys;
}

std::string first_bearing_key(const Section& surface) {
    for (const std::string_view key : bearing_keys())
        if (surface.find(key)) return std::string(key);
    return {};
}

void read_bearing(Source& source, const Section& surface, JointFace& face) {
    const auto first_of = [&](std::span<const std::string_view> keys) {
        const auto there =
            std::find_if(keys.begin(), keys.end(), [&](std::string_view key) { return surface.find(key); });
        return there == keys.end() ? std::string_view() : *there;
    };
    constexpr std::array<std::string_view, 2> moments{"skewness", "kurtosis"};
    std::vector<std::string_view> ways{first_of(moments), surface.find("bearing_curve") ? "bearing_curve" : ""};
    for (const CoreKeys& keys : core_keys) ways.push_back(first_of(keys));
    std::erase(ways, "");
    (void)surface.one_of(ways, "give one bearing curve");
    surface.read([&](auto take) {
        take("skewness", face.skewness, Field{});
        take("kurtosis", face.kurtosis, Field{});
    });
    for (const CoreKeys& keys : core_keys)
        if (!first_of(keys).empty()) face.bearing = read_core(surface, keys);
    if (const toml::node* node = surface.find("bearing_curve"))
        face.bearing = read_heights(source, *node, surface.key("bearing_curve"));
}

}  // namespace fstiff::scene
