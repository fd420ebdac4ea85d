// SPDX-License-Identifier: BSD-3-Clause
// Height and gradient of a face by the names of drawings and instruments: Ra, Rq, Sq, Sdq, RSm, and grades.
#include "request/words.hpp"
#include "scene/readers.hpp"

#include <array>
#include <limits>
#include <optional>
#include <string>

namespace fstiff::scene {

namespace {

constexpr std::array<std::string_view, 5> height_keys{"rms_height", "Rq", "Sq", "Ra", "Sa"};
constexpr std::array<std::string_view, 4> gradient_keys{"rms_gradient", "Sdq", "Rdq", "RSm"};

/// The height \p key: a length, or the grade of a drawing, which is one of Ra.
double read_length_or_grade(Source& source, const Section& surface, std::string_view key) {
    const std::string text = surface.at(key).value_or(std::string());
    if (const auto mean_height = request::mean_height_of_grade(text)) {
        if (key != "Ra") surface.refuse(key, "is a grade of Ra; must be given as Ra = \"" + text + "\"");
        source.record(surface.key(key), text, *mean_height, "m");
        return *mean_height;
    }
    if (key == "Ra" && (text.starts_with('N') || text.starts_with('V')))
        surface.refuse(key,
                       "must be a length such as \"0.8 um\", a grade from \"N1\" to \"N12\" or a class from "
                       "\"VDI 0\" to \"VDI 45\"");
    return surface.positive(key, Dimension::length);
}

std::optional<Following> read_height(Source& source, const Section& surface, JointFace& face) {
    const std::string_view key = surface.one_of(height_keys);
    if (key.empty())
        (void)surface.at("rms_height",
                         "is missing; the scene needs the height of the surface: rms_height, Rq, Sq, Ra or Sa");
    (key.back() == 'a' ? face.mean_height : face.rms_height) = read_length_or_grade(source, surface, key);
    if (key == "rms_height") return std::nullopt;
    return Following{source.inputs.size(), Parameter::rms_height, key};
}

std::optional<Following> read_gradient(Source& source, const Section& surface, JointFace& face) {
    const std::string_view key = surface.one_of(gradient_keys);
    if (key.empty() || key == "rms_gradient") return std::nullopt;  // read_spectrum() reads that
    auto& to = key == "RSm" ? face.profile_spacing : key == "Sdq" ? face.rms_gradient : face.profile_gradient;
    source.read(surface.at(key), surface.key(key), to,
                {.high = std::numeric_limits<double>::max(),
                 .above_low = true,
                 .dimension = key == "RSm" ? std::optional(Dimension::length) : std::nullopt});
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

std::vector<Following> read_roughness(Source& source, const Section& surface, JointFace& face) {
    std::vector<Following> numbers;
    for (const auto read : {read_height, read_gradient})
        if (const auto number = read(source, surface, face)) numbers.push_back(*number);
    return numbers;
}

}  // namespace fstiff::scene
