// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Result of every reader: the heights of a file, and a record of the decisions about it. Heights of one row are
/// a profile, whose dy is no more than a word.
///
/// Units       m

#include <fstiff/io/surface_file.hpp>

#include <utility>

namespace fstiff::inline v0_1::io {

using detail::RawMap;

/// Record of the reading of a file: its notes under each key, in that order, and its warnings.
struct Record {
    std::vector<std::pair<std::string, std::string>> entries;
    std::vector<std::string> warnings;
    std::size_t missing{};  ///< points
    double resolution{};    ///< step in which the heights are printed or counted [m]; 0 where it is not known
    std::optional<std::array<double, 2>> origin{};  ///< x and y of the first point of a map [m], where they are stated

    void note(std::string key, std::string text) { entries.emplace_back(std::move(key), std::move(text)); }
    /// "3 x 4, of which 2 missing", and \p more.
    void note_points(const RawMap& map, const std::string& more = "");
    /// "20, of which 2 missing", and \p more.
    void say_points_of_profile(const RawMap& map, const std::string& more = "");
    /// The bytes after what was read, where there are any.
    void say_trailer(std::size_t bytes);

    /// The note under \p key; empty without one.
    [[nodiscard]] std::string said(std::string_view key) const;
    /// "key: text" for people, one a line, without a full stop.
    [[nodiscard]] std::vector<std::string> sentences() const;
};

/// Result of a reader.
struct Reading {
    RawMap map;
    Record record;
};

namespace detail {

/// Makes room for the heights of \p rows x \p columns points.
void allocate(RawMap& map, std::size_t rows, std::size_t columns);

/// Makes height \p index of \p map \p z, missing where it is infinite.
void set_height(RawMap& map, std::size_t index, double z);

/// Points of \p map that are not missing.
[[nodiscard]] std::size_t present(const RawMap& map);

/// A map of one row has \p points at least, a map of more at least as many a side. \throws domain_error otherwise.
void validate_map(const RawMap& map, std::size_t points);

/// Gives \p map the spacings that file \p name states: dy = dx for one row whose dy is 0.
/// \throws domain_error when the heights are too few, do not vary, or are not finite.
void set_spacings(RawMap& map, double dx, double dy, const std::string& name);

}  // namespace detail

}  // namespace fstiff::inline v0_1::io
