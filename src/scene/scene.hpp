// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// A scene: a surface, two bodies and what is asked of their contact, read from TOML. Every key, unit and default is in
// docs/scene.md. actions/answered.hpp computes it.

#include <fstiff/answer/answer.hpp>
#include <fstiff/answer/resolved_joint.hpp>
#include "request/field.hpp"
#include "surface/measured_surface.hpp"

#include <fstiff/asperity/named_materials.hpp>
#include <fstiff/core/error.hpp>
#include <fstiff/core/parallel.hpp>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace fstiff::scene {

using request::Input;

/// Values between two ends, by { from, to, count, spacing } of a scene.
struct Range {
    double from = 0, to = 0;
    std::uint64_t count = 2;
    bool log = false;  ///< equal steps of the logarithm; else of the value

    /// The value at place \p i of count, the ends exactly as given.
    [[nodiscard]] double at(std::uint64_t i) const {
        if (i == 0) return from;
        if (i + 1 == count) return to;
        const double share = static_cast<double>(i) / static_cast<double>(count - 1);
        return log ? std::exp((1 - share) * std::log(from) + share * std::log(to)) : (1 - share) * from + share * to;
    }
};

/// A ball that is pressed on the face.
struct Ball {
    double radius;               ///< [m], of two 1/(1/R_1 + 1/R_2)
    std::vector<double> forces;  ///< [N]
};

struct NamedFace {
    std::string_view name;
    const detail::Face* face;
    const surface::MeasuredSurface* measured;  ///< null where it was not
};

/// H or alpha of a spectrum that is a band: not given, so taken from other numbers or for a usual one.
struct Assumed {
    std::string_view key, symbol;  ///< "hurst" and "Hurst", "alpha" and "alpha"
    std::string how;               ///< where the value comes from
    double value;
};

/// A number of a point that a column has: a quantity, its numerical error "_error", or "_p05" or "_p95", an end of its
/// band.
struct NumberOf {
    const AnswerQuantity* quantity;
    std::string_view part{};

    [[nodiscard]] std::string key() const { return quantity->key(part); }
    /// NaN where it is not there.
    [[nodiscard]] double operator()(const AnswerPoint& point) const;
    [[nodiscard]] bool operator==(const NumberOf& other) const = default;
};

/// A joint, what is asked of it, and the text that both come from.
struct Scene {
    Joint given;  ///< as it is written; of two rough faces without these
    detail::ResolvedJoint joint;
    std::string name;
    bool named = false;  ///< by its key name, and not by its file
    std::string file;    ///< as given, or "built-in scene"
    std::string sha256;  ///< of the text of the scene

    /// Of each rough face; null where it was not measured.
    std::vector<std::shared_ptr<const surface::MeasuredSurface>> measured;
    int shifts = 1;  ///< of the lower map over the upper one
    std::vector<std::string> warnings;
    bool implausible = false;  ///< a number, such as the rms gradient of a face, is likely in another unit

    /// Phrases on what was assumed, such as "both bodies steel, 210 GPa"; printed with the answer.
    std::vector<std::string> assumptions;
    std::vector<std::string> assumptions_of_answer;  ///< the others that it has, where laws are named

    const NamedMaterial *upper_name = nullptr, *lower_name = nullptr;  ///< null: numbers alone were given

    bool at_separations = false;  ///< points are separations [m], not pressures [Pa]
    std::vector<double> points;
    bool listed = true;          ///< the points were written one by one
    std::vector<double> forces;  ///< that the points are the pressures of [N]; empty: contact.force is not there
    std::optional<Ball> ball{};  ///< `points` are pressures below it
    double seating = 1e3;        ///< the approach is 0 at this pressure [Pa]
    std::string points_where;    ///< file, line and key for messages
    std::vector<const detail::Law*> laws;
    bool best = false;  ///< no law is named: `laws` is the one of the answer
    bool solves_map =
        true;           ///< the answer takes boundary elements of a map; of a sweep it does not, for they take seconds
    int samples = 400;  ///< of the band; 0: no band
    std::uint64_t seed = 2014;

    /// Words of answer_quantities(): pressure and eta, those of output.quantities, and force and the conductance of the
    /// gap where the scene has them.
    std::set<std::string, std::less<>> quantities{"pressure", "eta"};
    [[nodiscard]] bool asks(std::string_view word) const { return quantities.find(word) != quantities.end(); }
    /// Whether K is computed, though it may not be shown.
    [[nodiscard]] bool needs_stiffness() const;

    std::vector<std::string> files;  ///< that the scene names: surfaces and masks
    std::vector<Input> inputs;       ///< every key that was written or filled in by a default

    /// Every rough face, called surface, or upper and lower; and those that were measured.
    [[nodiscard]] std::vector<NamedFace> named_faces() const;
    [[nodiscard]] std::vector<NamedFace> measured_files() const;
    /// Assumptions of the laws; empty where no law takes a band, or both numbers were given or measured.
    [[nodiscard]] std::vector<Assumed> assumed() const;
    /// "hardness 2.6 GPa (1.2 to 9.5) of steel", where it was assumed.
    [[nodiscard]] std::string phrase_of_hardness() const;
    /// The points that the answer of a table and boundary elements are of, in their order: all up to twelve or of a
    /// list; else the ends and the decades.
    [[nodiscard]] std::vector<std::size_t> points_of_answer() const;
    /// How the answer is computed.
    [[nodiscard]] AnswerOptions options() const;
    /// The columns, with \p bands those of the ends too, which only a curve with a band has numbers in.
    [[nodiscard]] std::vector<NumberOf> columns(bool bands) const;
    /// Point \p i for people: "10 MPa", "20 kN, 100 MPa" of a force, "0.5 µm" of a separation.
    [[nodiscard]] std::string shown_point(std::size_t i) const;
    /// Why \p law cannot be computed; empty where it can.
    [[nodiscard]] std::string refusal_of(const detail::Law& law) const;
    /// The laws that may be asked for by name: those that the scene names; where it names none, all that can be
    /// computed.
    [[nodiscard]] std::vector<const detail::Law*> offered_laws() const;
};

/// "alpha 8 (2 to 50), of any process": what was assumed of \p face; empty of what was measured.
[[nodiscard]] std::string phrase_of(const detail::Prior& prior, const detail::Face& face);
/// "3 points are missing; fill = true ... fills them": of the map of a face, empty where none is.
[[nodiscard]] std::string missing_phrase(const detail::Face& face);

/// The number that CSV and JSON call \p key. \throws domain_error with the keys, of the parameter \p name.
[[nodiscard]] NumberOf number_called(std::string_view key, std::string_view name = "key");
/// Those of output.quantities, in the order of their words.
[[nodiscard]] std::vector<const AnswerQuantity*> words_for_quantities();

/// Where a scene comes from.
struct SceneSource {
    std::string name;  ///< how messages call the text; files of the scene are searched next to it
    std::string
        surface{};  ///< not empty: file of the surface, in place of [surface] and contact.peaks; "-" is standard input
    ProgressHook progress{};  ///< called while a surface is measured
    ParallelHook parallel{};  ///< of the measurement
    const surface::MeasuredSurface* measured =
        nullptr;  ///< in place of a file of the surface, where it was measured already
    const Scene* surface_of =
        nullptr;  ///< not null: a scene with the very [surface] of this one, which is not read again
    const std::set<std::string>* in_si = nullptr;  ///< not null: keys whose numbers are in SI, without a unit
};

/// \throws domain_error "<name>:<line>: <key> = <value>: must be ...".
[[nodiscard]] Scene read_scene(const std::string& text, const SceneSource& from);

/// The scene that is computed where none is given: data/built_in.toml.
extern const char* const builtin_scene;

}  // namespace fstiff::scene
