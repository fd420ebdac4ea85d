// SPDX-License-Identifier: BSD-3-Clause
// The bearing curve of [surface] as it is written: skewness and kurtosis, parameters of the core, or a list of heights.
#include "document/file.hpp"
#include "scene/readers.hpp"

#include <fstiff/surface/bearing_of_core.hpp>
#include <fstiff/surface/material_ratio.hpp>
#include <fstiff/surface/material_ratio_slope.hpp>

#include <algorithm>
#include <array>
#include <span>
#include <string>

namespace fstiff::scene {
namespace {

/// The parameters of the core of a map and of a profile, in the order of CoreKeys.
enum CoreKey { core_height, peak_height, valley_depth, first_share, second_share };
using CoreKeys = std::array<std::string_view, 5>;
constexpr std::array<CoreKeys, 2> core_keys{
    {{"Sk", "Spk", "Svk", "Smr1", "Smr2"}, {"Rk", "Rpk", "Rvk", "Rmr1", "Rmr2"}}};

detail::MaterialRatio<double> read_core(Source& source, const Section& surface, const CoreKeys& keys) {
    const std::string why = "is missing; " + std::string(keys[0]) + ", " + std::string(keys[1]) + ", " +
                            std::string(keys[2]) + ", " + std::string(keys[3]) + " and " + std::string(keys[4]) +
                            " belong together";
    const auto height = [&](CoreKey which) {
        double value = 0;
        static_cast<void>(surface.at(keys[which], why));
        read_number(source, surface, keys[which], value, {.unit = "m", .low_too = which != core_height});
        return value;
    };
    const auto share = [&](CoreKey which) {
        const toml::node& node = surface.at(keys[which], why);
        const double value = source.number(node, surface.key(keys[which]));
        if (!(value >= 0 && value <= 1)) surface.refuse(keys[which], "must be a share from 0 to 1; 10 % is 0.1");
        return value;
    };
    const detail::MaterialRatio<double> core{height(core_height), height(peak_height), height(valley_depth),
                                             share(first_share), share(second_share)};
    if (!(core.peak_share < core.core_and_peak_share))
        surface.refuse(keys[second_share], "must be greater than " + surface.key(keys[first_share]));
    return core;
}

MaterialRatioSlope<double> read_heights(Source& source, const toml::node& node, const std::string& key) {
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
    return source.located(node, [&] { return MaterialRatioSlope<double>::of_heights(heights); });
}

}  // namespace

std::vector<std::string_view> bearing_keys() {
    std::vector<std::string_view> keys{"bearing_curve"};
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
        return there == keys.end() ? nullptr : &*there;
    };
    constexpr std::array<std::string_view, 6> moments{"skewness", "kurtosis", "Ssk", "Sku", "Rsk", "Rku"};
    constexpr std::array<std::string_view, 1> list{"bearing_curve"};
    const std::array<std::span<const std::string_view>, 4> ways{moments, list, core_keys[0], core_keys[1]};
    std::vector<std::string_view> firsts;
    std::size_t chosen = ways.size();
    for (std::size_t i = 0; i < ways.size(); ++i)
        if (const std::string_view* key = first_of(ways[i])) firsts.push_back(*key), chosen = i;
    if (surface.one_of(firsts, "give one bearing curve").empty()) return;
    if (chosen == 0) return;  // which are numbers of the face
    const std::string_view key = *first_of(ways[chosen]);
    const toml::node& node = *surface.find(key);
    if (chosen == 1) {
        face.bearing = read_heights(source, node, surface.key(key));
        return;
    }
    const detail::MaterialRatio<double> core = read_core(source, surface, core_keys[chosen - 2]);
    face.bearing = source.located(node, [&] { return detail::bearing_of_core(core); });
}

}  // namespace fstiff::scene
