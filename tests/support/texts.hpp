// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Tables of texts of numbers: what is written, the options it is read with, and what must be decided or the words of
// its refusal. Another text is another row. Truth: the heights that the texts are made of.
#include "support/samples.hpp"
#include "support/surfaces.hpp"

#include <cstdio>
#include <functional>
#include <optional>

namespace test {

inline constexpr FileReader read_text{};

inline std::string with_commas(std::string text) {
    std::replace(text.begin(), text.end(), '.', ',');
    return text;
}
inline std::string all_replaced(std::string text, const std::string& from, const std::string& to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
    return text;
}

/// The text that \p line(0), line(1), ... make.
template <class Line>
std::string lines(int count, const Line& line) {
    std::string text;
    for (int i = 0; i < count; ++i) text += line(i);
    return text;
}

/// Tenths that change sign; 20 of them differ.
inline double height(int i) { return ((7 * i) % 20 - 3) / 10.0; }
using Cell = std::function<std::string(int)>;
inline std::string height_text(int i) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f", height(i));
    return text;
}

/// \p pattern for every row, in which {i} is its number, {x} a position 0.5 apart and {z} the height.
inline std::string rows(const std::string& pattern, int count = 20, const Cell& z = height_text) {
    return lines(count, [&](int i) {
        const std::string number = std::to_string(i), x = std::to_string(i / 2) + (i % 2 ? ".5" : ".0");
        return all_replaced(all_replaced(all_replaced(pattern, "{i}", number), "{x}", x), "{z}", z(i));
    });
}

/// The same heights as a map of 4 rows of 5.
inline std::string matrix(const std::string& separator, const Cell& z = height_text, const std::string& end = "\n") {
    return lines(20, [&](int i) { return z(i) + (i % 5 < 4 ? separator : end); });
}
/// \p pattern for every point of that map, in which {i} and {j} are its column and row.
inline std::string triples(const std::string& pattern, const Cell& z = height_text) {
    return lines(20, [&](int i) {
        return all_replaced(
            all_replaced(all_replaced(pattern, "{i}", std::to_string(i % 5)), "{j}", std::to_string(i / 5)), "{z}",
            z(i));
    });
}

/// What a text is: refused, or a profile or map of these numbers.
struct Decision {
    std::vector<std::string> refused{};   ///< parts of the sentence; where there are none the text is read
    double dx = 0, dy = 0;                ///< [m]; 0: not checked
    double dx_error = 2.3e-16;            ///< relative
    double unit = 0;                      ///< the heights are those above times this [m]; 0: not checked
    std::vector<std::string> says{};      ///< parts of its record, whose sentences begin and end with "\n"
    std::vector<std::string> warnings{};  ///< a part of each
    std::size_t size = 20, rows = 1;      ///< points, and rows of a map
    std::vector<int> missing{};           ///< points
    std::optional<fstiff::io::SurfaceFormat> format{};
};
template <class... Part>
Decision refused(const Part&... parts) {
    return {.refused = {parts...}};
}
inline Decision profile(double dx, double unit, std::vector<std::string> says = {},
                        std::vector<std::string> warnings = {}) {
    return {.dx = dx, .unit = unit, .says = std::move(says), .warnings = std::move(warnings)};
}
inline Decision map(double dx, double dy, double unit, std::vector<std::string> says = {},
                    std::vector<std::string> warnings = {}) {
    return {.dx = dx, .dy = dy, .unit = unit, .says = std::move(says), .warnings = std::move(warnings), .rows = 4};
}

struct TextRow {
    std::string name;
    std::string text;
    Decision expected;
    fstiff::io::SurfaceOptions options{};
};

/// Checks \p row, whose text holds the heights \p truth.
inline void check_text(const TextRow& row, double (*truth)(int) = height) {
    const Decision& expected = row.expected;
    std::optional<fstiff::io::Surface> found;
    const std::string sentence = refusal([&] { found = read_text(row.text, row.options); });
    const std::string text = row.text.substr(0, 300);
    CAPTURE(row.name, text, sentence);
    CHECK(sentence.empty() == expected.refused.empty());
    for (const std::string& part : expected.refused) {
        CAPTURE(part);
        CHECK(contains(sentence, part));
    }
    if (!found || !expected.refused.empty()) return;

    const fstiff::io::SurfaceRecord& record = found->record;
    std::string said = "\n";
    for (const std::string& line : record.sentences()) said += line + "\n";
    for (const std::string& part : expected.says) {
        CAPTURE(said, part);
        CHECK(contains(said, part));
    }
    std::string warned;
    for (const std::string& warning : record.warnings) warned += warning + "\n";
    CAPTURE(warned);
    CHECK(record.warnings.size() == expected.warnings.size());
    for (std::size_t i = 0; i < std::min(record.warnings.size(), expected.warnings.size()); ++i)
        CHECK(contains(record.warnings[i], expected.warnings[i]));

    const bool is_map = !found->is_profile();
    const auto size = is_map ? static_cast<std::size_t>(found->map().size()) : found->profile().size();
    CHECK(size == expected.size);
    CHECK((is_map ? static_cast<std::size_t>(found->map().rows()) : 1) == expected.rows);
    if (expected.format) CHECK(record.format == *expected.format);
    const double dx = is_map ? found->map().dx : found->profile().spacing;
    if (expected.dx > 0) CHECK(relative_error(dx, expected.dx) <= expected.dx_error);
    if (expected.dy > 0 && is_map) CHECK(ulps(found->map().dy, expected.dy) <= 1);
    const double* heights = is_map ? found->map().heights.data() : found->profile().heights.data();
    std::vector<int> missing, wrong;
    for (int i = 0; i < static_cast<int>(size); ++i)
        if (std::isnan(heights[i]))
            missing.push_back(i);
        else if (expected.unit != 0 && heights[i] != truth(i) * expected.unit)
            wrong.push_back(i);
    CAPTURE(missing, wrong);
    CHECK(missing == expected.missing);
    CHECK(wrong.empty());
}

inline void check_texts(const std::vector<TextRow>& table, double (*truth)(int) = height) {
    for (const TextRow& row : table) check_text(row, truth);
}

}  // namespace test
