// SPDX-License-Identifier: BSD-3-Clause
// The numbers of a face by their names, or by those of drawings and instruments, with their errors.
#include "request/words.hpp"
#include "scene/readers.hpp"

#include "document/file.hpp"
#include "document/shown_unit.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

namespace fstiff::scene {

namespace {

const JointFace no_face{};  // of which names and facts are read

/// The keys of each number, in the order of each_field(): its own, and those of the numbers that are the same in
/// another way.
std::vector<std::vector<std::string_view>> all_ways() {
    std::vector<std::vector<std::string_view>> all;
    each_field(no_face, [&](std::string_view name, const auto&, const NumberFacts& facts) {
        std::vector<std::string_view>& keys = all.emplace_back();
        each_field(no_face, [&](std::string_view other, const auto&, const NumberFacts& its) {
            if (other == name || (facts.error && its.error == facts.error)) add_keys(other, its, keys);
        });
    });
    return all;
}

/// The key by which \p surface writes the number \p name; empty: it does not.
std::string_view written_key(const Section& surface, std::string_view name, const NumberFacts& facts) {
    if (surface.find(name)) return name;
    const auto word = std::find_if(facts.words.begin(), facts.words.end(),
                                   [&](std::string_view each) { return surface.find(each) != nullptr; });
    return word == facts.words.end() ? std::string_view() : *word;
}

/// The height \p key: a length, or of Ra the grade of a drawing.
double read_length_or_grade(Source& source, const Section& surface, std::string_view key, bool is_Ra) {
    const std::string text = surface.at(key).value_or(std::string());
    if (const auto mean_height = request::mean_height_of_grade(text)) {
        if (!is_Ra) surface.refuse(key, "is a grade of Ra; must be given as Ra = \"" + text + "\"");
        source.record(surface.key(key), text, *mean_height, "m");
        return *mean_height;
    }
    if (is_Ra && (text.starts_with('N') || text.starts_with('V')))
        surface.refuse(key,
                       "must be a length such as \"0.8 um\", a grade from \"N1\" to \"N12\" or a class from "
                       "\"VDI 0\" to \"VDI 45\"");
    return surface.positive(key, Dimension::length);
}

/// The standard error \p key of a number that is \p known.
double read_error(Source& source, const Section& errors, const Section& surface, std::string_view key, bool known,
                  const NumberFacts& facts) {
    const toml::node& node = errors.at(key);
    if (!known) source.refuse(node, errors.key(key), "needs the value of " + surface.key(key));
    double error = 0;
    source.read(node, errors.key(key), error, {.dimension = request::dimension_of(facts.unit)});
    if (!(error >= 0 && std::isfinite(error))) source.refuse(node, errors.key(key), "must be finite and not negative");
    if (facts.row && facts.row->variation == detail::Variation::between)
        if (const auto half = static_cast<double>(facts.row->high.value - facts.row->low.value) / 2; error > half)
            source.refuse(node, errors.key(key),
                          "must be at most " + document::rounded(half, 3) + ", half the range of " + std::string(key));
    return error;
}

/// Whether \p face was measured with the number \p name.
bool is_measured(const JointFace& face, std::string_view name) {
    if (!face.measured) return false;
    const auto& surface = face.measured->surface();
    if (name == "rms_gradient") return surface.heights.has_value();
    const auto which = detail::find_named<Parameter>(name);
    return which && surface.find(*which);
}

}  // namespace

std::string key_of_number(const Section& surface, std::string_view name) {
    std::string key;
    each_field(no_face, [&](std::string_view each, const auto&, const NumberFacts& facts) {
        if (each == name) key = written_key(surface, name, facts);
    });
    return key;
}

std::vector<Following> read_numbers(Source& source, const Section& surface, JointFace& face) {
    static const auto ways = all_ways();
    std::vector<Following> following;
    auto own = ways.begin();
    each_field(face, [&](std::string_view name, std::optional<double>& value, const NumberFacts& facts) {
        const std::string_view first = surface.one_of(*own++), key = written_key(surface, name, facts);
        if (first.empty() && name == "rms_height" && !face.measured)
            (void)surface.at(name,
                             "is missing; the scene needs the height of the surface: rms_height, Rq, Sq, Ra or Sa");
        if (key.empty()) return;
        if (facts.error == &JointFace::Errors::height)
            value = read_length_or_grade(source, surface, key, name == "mean_height" && key != "Sa");
        else
            source.read(surface.at(key), surface.key(key), value, request::field_of(facts));
        const std::string_view of = facts.error == &JointFace::Errors::height     ? "rms_height"
                                    : facts.error == &JointFace::Errors::gradient ? "rms_gradient"
                                                                                  : name;
        if (key != of) following.push_back({source.inputs.size(), of, key, *value});
    });
    return following;
}

void read_errors(Source& source, const Section& surface, JointFace& face) {
    const toml::node* node = surface.find("errors");
    if (!node) return;
    if (!node->is_table()) source.refuse(*node, surface.key("errors"), "must be a table of standard errors");
    std::vector<std::string_view> keys;
    each_field(no_face, [&](std::string_view name, const auto&, const NumberFacts& facts) {
        if (facts.error) add_keys(name, facts, keys);
    });
    const Section errors(source, node->as_table(), surface.key("errors"), keys);
    each_field(std::as_const(face), [&](std::string_view name, const auto&, const NumberFacts& facts) {
        if (const std::string_view key = facts.error ? written_key(errors, name, facts) : ""; !key.empty())
            face.errors.*facts.error = read_error(source, errors, surface, key,
                                                  surface.find(key) || (key == name && is_measured(face, name)), facts);
    });
}

void refuse_extremes(const Source& source, const toml::table& table, const std::string& path) {
    for (const char* key : {"Rz", "Rt", "Sz", "Rmax"})
        if (const toml::node* node = table.get(key))
            source.refuse(*node, path + "." + key,
                          "is the height from the deepest valley to the highest peak, 4 to 10 times Ra and different "
                          "at every place; give Ra or Rq (Sa or Sq for a map)");
}

}  // namespace fstiff::scene
