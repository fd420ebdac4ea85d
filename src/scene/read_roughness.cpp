// SPDX-License-Identifier: BSD-3-Clause
// Height and gradient of [surface] by the names that drawings and instruments have for them.
#include "document/file.hpp"
#include "scene/readers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace fstiff::scene {
namespace {

using parts::PriorRange;
using parts::Unknown;
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

void read_height(Source& source, const Section& surface, Face& face) {
    const std::string_view key = one_of(source, surface, height_keys);
    if (key.empty())
        (void)surface.at("rms_height",
                         "is missing; the scene needs the height of the surface: rms_height, Rq, Sq, Ra or Sa");
    const double height = surface.positive(key, Dimension::length);
    if (key.back() != 'a') {
        face.write(Parameter::rms_height, height);
        if (key == "rms_height") return;
    } else {
        const PriorRange& ratio = parts::prior_of(face.process).mean_over_rms;
        face.write(Parameter::rms_height, height / ratio.middle);
        face.priors.push_back({Unknown::height, height / ratio.high, height / ratio.low,
                               key == "Ra" ? Origin::mean_height : Origin::mean_heights, ratio});
    }
    source.record(surface.key("rms_height"), "of " + std::string(key) + " (default)", face.parameters.rms_height.value,
                  "m");
}

/// A gradient of the range \p range, which is from \p origin.
void take_gradient(const PriorRange& range, Origin origin, Face& face) {
    face.rms_gradient = range.middle;
    if (range.low < range.high) face.priors.push_back({Unknown::gradient, range.low, range.high, origin, range});
}

void read_gradient(Source& source, const Section& surface, Face& face) {
    const std::string_view key = one_of(source, surface, gradient_keys);
    if (key.empty() || key == "rms_gradient") return;  // read_spectrum() reads that
    const toml::node& node = surface.at(key);
    const PriorRange of_slope = parts::gradient_of_slope(parts::prior_of(face.process));
    const auto times = [](const PriorRange& a, const PriorRange& b) {
        const auto side = [&](double PriorRange::*end) {  // independent factors
            return std::hypot(std::log(a.*end / a.middle), std::log(b.*end / b.middle));
        };
        const double middle = a.middle * b.middle;
        return PriorRange{middle * std::exp(-side(&PriorRange::low)), middle,
                          middle * std::exp(side(&PriorRange::high))};
    };
    if (key == "RSm") {
        const double spacing = surface.positive(key, Dimension::length);
        take_gradient(times(parts::slope_of_spacing(face.parameters.rms_height.value, spacing), of_slope),
                      Origin::spacing, face);
    } else {
        const double slope = source.number(node, surface.key(key));
        if (!(slope > 0)) source.refuse(node, surface.key(key), "must be greater than 0");
        if (key == "Sdq")
            face.rms_gradient = slope;
        else
            take_gradient(times({slope, slope, slope}, of_slope), Origin::slope, face);
    }
    source.record(surface.key("rms_gradient"), "of " + std::string(key) + " (default)", *face.rms_gradient);
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

void read_roughness(Source& source, const Section& surface, Face& face) {
    read_height(source, surface, face);
    read_gradient(source, surface, face);
}

double over_written(const Section& surface, std::string_view key, double value) {
    const toml::node& node = surface.at(key);
    return value / (node.is_string() ? io::parse_quantity(written(node), Dimension::length, std::string(key))
                                     : plain_number(node).value_or(value));
}

}  // namespace fstiff::scene
