// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The columns of results, as the CSV, the JSON and the table of fstiff run have them.

#include "actions/answered.hpp"
#include "document/document.hpp"
#include "document/shown_unit.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fstiff::actions {

/// The units of the columns, each by its SI unit and by the sizes of the scene; that of K fits the answer at
/// points_of_answer().
using Units = std::map<std::string_view, document::ShownUnit>;

/// The name, the file and the SHA-256 of \p scene, for a JSON document.
[[nodiscard]] document::Json scene_json(const scene::Scene& scene);

[[nodiscard]] Units units_of(const Answered& answered);
/// How people read \p column; one that is not for them is in CSV and JSON alone.
[[nodiscard]] document::Heading heading_of(const scene::NumberOf& column, const Units& units);
/// Every column of \p curve: law, theta, r, and what the scene asks for, with \p bands the ends of bands too.
[[nodiscard]] document::Rows point_rows(const scene::Scene& scene, const AnswerCurve& curve, bool bands,
                                        const Units& units = {});

/// Whether an approach was asked of \p answer, and is known.
[[nodiscard]] bool has_approach(const Answer& answer);
/// Whether \p quantity is neither K nor a part of the state of the contact.
[[nodiscard]] bool is_further(const AnswerQuantity& quantity);
/// The ball of the scene, a force a row, next to that of smooth faces.
[[nodiscard]] document::Rows ball_rows(const Answered& answered);
/// What was assumed for \p answered.
[[nodiscard]] std::vector<std::string> assumptions_of(const Answered& answered);
/// psi of the surface and the softer body, where both are known.
[[nodiscard]] std::optional<double> plasticity_index(const detail::ResolvedJoint& joint);
/// A line of the input that the results rest on, for people: "surface", {"sigma 0.8 µm", "rms gradient 0.1"}.
struct InputLine {
    std::string label;
    std::vector<std::string> parts;
};
/// \p line as text: its parts with commas between them, in lines of at most 100 columns.
[[nodiscard]] std::string in_lines(const InputLine& line);
/// Surface, measured files, material, contact, waves, what was assumed, and what to measure next.
[[nodiscard]] std::vector<InputLine> input_lines(const Answered& answered);
/// The document of fstiff run. The text is a summary at the points of the answer or, \p full, every point and quantity;
/// the CSV has the rows of the answer, then those of the laws that are named.
[[nodiscard]] document::Document document_of(const Answered& answered, bool full = false);
/// Its JSON, without the warnings.
[[nodiscard]] document::Json run_document(const Answered& answered);
/// The answer of \p answered, which have one, for people: K, its band, the law and its greatest \p causes at
/// points_of_answer().
[[nodiscard]] document::TextRows answer_table(const Answered& answered, std::size_t causes = 2);

}  // namespace fstiff::actions
