// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The columns of results, as the CSV, the JSON and the table of fstiff run have them.

#include "actions/results.hpp"
#include "document/document.hpp"
#include "document/shown_unit.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace fstiff::actions {

/// The units of the columns, by the sizes of the scene; that of K fits the answer at points_of_answer().
struct Units {
    document::ShownUnit pressure, height, density, stiffness, force, joint_stiffness;
};

/// The name, the file and the SHA-256 of \p scene, for a JSON document.
[[nodiscard]] document::Json scene_json(const scene::Scene& scene);

[[nodiscard]] Units units_of(const scene::Scene& scene, const Results& results);
/// How people read \p column; one that is not for them is in CSV and JSON alone.
[[nodiscard]] document::Heading heading_of(const scene::Column& column, const Units& units);
/// Every column of \p curve: law, theta, r, and what the scene asks for; the same keys for every curve of \p results.
[[nodiscard]] document::Rows point_rows(const Results& results, const Curve& curve, const Units& units = {});

/// Point \p i of \p scene for people: "10 MPa", "20 kN, 100 MPa" of a force, "0.5 µm" of a separation.
[[nodiscard]] std::string shown_point(const scene::Scene& scene, std::size_t i);
/// The answer for a JSON document: a row for each point, empty where nothing answers.
[[nodiscard]] document::Json answer_json(const scene::Scene& scene, const Results& results);
/// The ball of the scene, a force a row, next to that of smooth faces.
[[nodiscard]] document::Rows ball_rows(const Results& results);
/// A line of the input that the results rest on, for people: "surface", {"sigma 0.8 µm", "rms gradient 0.1"}.
struct InputLine {
    std::string label;
    std::vector<std::string> parts;
};
/// \p line as text: its parts with commas between them, in lines of at most 100 columns.
[[nodiscard]] std::string in_lines(const InputLine& line);
/// Surface, measured files, material, contact, waves, what was assumed, and what to measure next.
[[nodiscard]] std::vector<InputLine> input_lines(const scene::Scene& scene, const Results& results);
/// The document of fstiff run. The text is a summary at the points of the answer or, \p full, every point and quantity;
/// the CSV has the rows of the answer, then those of the laws that are named.
[[nodiscard]] document::Document document_of(const scene::Scene& scene, const Results& results, bool full = false);
/// Its JSON, without the warnings.
[[nodiscard]] document::Json run_document(const scene::Scene& scene, const Results& results);
/// The answer of \p results, which have one, for people: K, its band, the law and its greatest \p causes at
/// points_of_answer().
[[nodiscard]] document::TextRows answer_table(const scene::Scene& scene, const Results& results,
                                              std::size_t causes = 2);

}  // namespace fstiff::actions
