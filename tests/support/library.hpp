// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Work of the command on a file or a scene, done by the library in this process: options as they are written on a
// command line, results as JSON, rows or the sentence of a refusal. FSTIFF_SCENES is the folder of the scenes, set by
// CMake.
#include "actions/answered.hpp"
#include "actions/fractal.hpp"
#include "actions/islands.hpp"
#include "actions/measure.hpp"
#include "actions/run.hpp"
#include "surface/measured_surface.hpp"
#include "surface/surface_option_table.hpp"

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/csv.hpp"
#include "support/files.hpp"

#include <fstiff/answer/face.hpp>
#include <fstiff/io/write.hpp>
#include <fstiff/synthetic/self_affine.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace test {

inline nlohmann::json parsed(const fstiff::document::Json& document) { return nlohmann::json::parse(document.str()); }

/// The words of \p line; one with blanks is in '...'.
inline std::vector<std::string> words_of(const std::string& line) {
    std::vector<std::string> words;
    std::string word;
    bool quoted = false, begun = false;
    for (const char c : line + " ") {
        if (c == ' ' && !quoted) {
            if (begun) words.push_back(word);
            word.clear();
            begun = false;
        } else {
            if (c == '\'')
                quoted = !quoted;
            else
                word += c;
            begun = true;
        }
    }
    return words;
}

/// Puts a word into an option of a surface; a flag takes none.
struct PutWord {
    const std::string& word;

    bool operator()(bool& to) const { return !(to = true); }
    template <class To>
    bool operator()(To& to) const {
        if constexpr (std::is_arithmetic_v<To>)
            to = static_cast<To>(std::stod(word));
        else if constexpr (std::is_enum_v<To>)
            to = fstiff::detail::find_named<To>(word).value();
        else if constexpr (std::is_same_v<To, std::optional<fstiff::io::X3pIncrement>>)
            to = fstiff::detail::find_named<fstiff::io::X3pIncrement>(word);
        else
            to = word;
        return true;
    }
};

/// The options of \p line, such as "--lambda-s '8 um' --fill", for the surface in \p file.
inline fstiff::surface::SurfaceOptions surface_options(const std::string& line, const std::string& file = "-") {
    fstiff::surface::SurfaceOptions options;
    options.file = file;
    options.prefix = "--";
    options.format_name = "--input-format";
    const std::vector<std::string> words = words_of(line);
    for (std::size_t i = 0; i < words.size(); ++i) {
        const auto rows = fstiff::surface::surface_option_table();
        const auto row =
            std::find_if(rows.begin(), rows.end(), [&](const auto& one) { return one.flag_name() == words[i]; });
        if (row == rows.end()) throw std::logic_error("no option " + words[i]);
        const std::string next = i + 1 < words.size() ? words[i + 1] : "";
        if (row->visit(options, PutWord{next})) ++i;
    }
    return options;
}

inline fstiff::document::Json values_of(const fstiff::surface::MeasureOptions& how,
                                        fstiff::surface::MeasuredSurface surface) {
    return fstiff::actions::document_of(how,
                                        std::make_shared<const fstiff::surface::MeasuredSurface>(std::move(surface)))
        .values();
}

/// The document of fstiff measure for the surface in \p bytes.
inline nlohmann::json measured(const std::string& line, const std::string& bytes,
                               fstiff::surface::MeasureOptions how = {}) {
    how.input = surface_options(line);
    return parsed(values_of(how, fstiff::surface::measure_surface(how, bytes)));
}

/// The same for the surface in \p files.
inline nlohmann::json measured_files(const std::string& line, const std::vector<std::string>& files) {
    fstiff::surface::MeasureOptions how;
    how.input = surface_options(line);
    return parsed(values_of(how, fstiff::surface::measure_files(how, files)));
}

/// The document of fstiff measure --show fit for the profile or map in \p bytes.
inline nlohmann::json fitted(const std::string& line, const std::string& bytes,
                             fstiff::actions::FractalOptions how = {}) {
    how.surface = surface_options(line);
    return parsed(fstiff::actions::document_of(how, fstiff::surface::read_surface_input(how.surface, bytes)).values());
}

/// The document of fstiff measure --show islands for the map in \p bytes.
inline nlohmann::json islands_of(const std::string& line, const std::string& bytes,
                                 fstiff::actions::IslandsRequest how = {}) {
    how.surface = surface_options(line);
    const auto document = fstiff::actions::document_of(how, fstiff::surface::read_surface_input(how.surface, bytes));
    nlohmann::json all = parsed(document.values());
    all["doubtful"] = document.doubtful;
    return all;
}

/// The decisions of \p document that hold \p words.
inline bool decided(const nlohmann::json& document, const std::string& words) {
    for (const std::string line : document["source"]["decisions"])
        if (contains(line, words)) return true;
    return false;
}

/// \p text as the scene in \p file, next to which its surfaces are.
inline fstiff::scene::Scene scene_of(const std::string& text, const std::string& file = "scene.toml") {
    return fstiff::scene::read_scene(text, {.name = file});
}

inline fstiff::actions::Answered results_of(const std::string& text, const std::string& file = "scene.toml") {
    return fstiff::actions::compute(scene_of(text, file));
}

/// The face of \p scene that a smooth one meets.
inline const fstiff::detail::Face& face(const fstiff::scene::Scene& scene) { return scene.joint.face; }
inline fstiff::detail::Face& face(fstiff::scene::Scene& scene) { return scene.joint.face; }
/// The measured surface of a scene with one rough face.
inline const fstiff::surface::MeasuredSurface& measured_of(const fstiff::scene::Scene& scene) {
    return *scene.measured.front();
}

/// The input of \p key that \p scene records.
inline const fstiff::request::Input& input_of(const fstiff::scene::Scene& scene, const std::string& key) {
    const auto found = std::ranges::find(scene.inputs, key, &fstiff::request::Input::key);
    if (found == scene.inputs.end()) throw std::runtime_error("no input " + key);
    return *found;
}

/// The states of the points of \p curve that have one.
inline std::vector<fstiff::ContactState<double>> states_of(const fstiff::AnswerCurve& curve) {
    std::vector<fstiff::ContactState<double>> states;
    for (const fstiff::AnswerPoint& point : curve.points)
        if (point.ok()) states.push_back(point.state);
    return states;
}
/// The number of \p curve at \p place that CSV has under the quantity \p word with \p part; none where it has none.
inline std::optional<double> value_at(const fstiff::AnswerCurve& curve, std::size_t place, std::string_view word,
                                      std::string_view part = "") {
    const fstiff::AnswerPoint* point = curve.at(place);
    if (!point || (part.starts_with("_p") && !curve.has_band)) return std::nullopt;
    const double value = fstiff::scene::NumberOf{&fstiff::detail::quantity_called(word), part}(*point);
    return std::isnan(value) ? std::nullopt : std::optional(value);
}

/// CSV output of fstiff run.
inline std::string csv_of(const fstiff::actions::Answered& answered) {
    std::string text;
    for (const auto& curve : answered.curves())
        text += fstiff::actions::point_rows(*answered.scene, curve, answered.has_band()).csv(text.empty());
    return text;
}

/// The rows of the scene \p text.
inline Csv rows_of_scene(const std::string& text, const std::string& file = "scene.toml") {
    return Csv(csv_of(results_of(text, file)));
}

/// The sentence in which a scene is refused, read or computed; "" where it is not.
inline std::string refused_scene(const std::string& text, const std::string& file = "scene.toml") {
    return refusal([&] { (void)results_of(text, file); });
}

/// Checks that \p sentence is a refusal in one line with all \p parts.
inline void check_sentence(const std::string& sentence, const std::vector<std::string>& parts) {
    INFO("refusal: " << sentence);
    CHECK_FALSE(sentence.empty());
    CHECK(sentence.find('\n') == std::string::npos);
    for (const std::string& part : parts) {
        INFO("expected: " << part);
        CHECK(contains(sentence, part));
    }
}

/// \p heights, a profile or a map, as the text of a file.
template <class Heights>
std::string file_text(const Heights& heights) {
    std::ostringstream text;
    fstiff::io::write_csv(text, heights);
    return text.str();
}

/// A self-affine profile or map of \p points (a side) every \p spacing [m], as the text of a file.
inline std::string profile_text(std::size_t points, double spacing, const fstiff::SelfAffineOptions<double>& how) {
    return file_text(self_affine_profile(how, points, spacing));
}
inline std::string map_text(std::size_t points, double spacing, const fstiff::SelfAffineOptions<double>& how) {
    return file_text(self_affine_map(how, points, points, spacing, spacing));
}

}  // namespace test
