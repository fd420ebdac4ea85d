// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Content of the header of a text: units of columns, spacings, and the size and form of a map.
///
/// Units       lengths in m, once their unit is read

#include "io/column_titles.hpp"
#include "io/header_words.hpp"

#include <fstiff/io/write.hpp>

#include <span>

namespace fstiff::inline v0_1::io::detail {

/// "key: value" or "key = value" of a header, or another line of it.
struct HeaderEntry {
    std::string key;    // lower case, blanks for underscores; empty for a line without a sign
    std::string value;  // with a decimal point
    std::size_t line;
};

/// Those of \p lines, whose lengths have the decimal sign of \p dialect; \p all: with lines without a sign.
std::vector<HeaderEntry> header_entries(std::span<const Line> lines, Dialect dialect, bool all = false);
/// Those of the header of \p table.
std::vector<HeaderEntry> header_entries(const NumberTable& table, bool all = false);

/// Grid of a matrix by its header: lengths [m], counts.
struct StatedGrid {
    struct Length {
        double value{};
        std::size_t line{};
        std::string unit_from{};  // why it is in nm without a unit after it; for a record
        std::string unit{};       // as it is written; empty where there is none
        std::string from{};       // where it is not a line of the header; for a record
    };
    std::optional<Length> width, height, dx, dy;
    std::optional<std::size_t> columns, rows;
    std::size_t columns_line{}, rows_line{};
    std::string without_unit;  // the first length that lacks its unit, for messages
    std::size_t without_unit_line{};

    bool has_size() const { return (width || dx) && (height || dy); }
};

/// The entry called \p key; nullptr where there is none.
const HeaderEntry* find_entry(const std::vector<HeaderEntry>& entries, std::string_view key);

/// A spacing that the header of a profile states, such as "Resolution,0.156 um/sample" or "Punktabstand [um]: 0,5";
/// with the weight of its last digit [m].
struct StatedSpacing {
    double value{}, resolution{};
    std::size_t line{};
    std::string text;
};
std::optional<StatedSpacing> stated_spacing(const std::vector<HeaderEntry>& entries);

/// \p unit is that of a length without one; "" for refusing to guess.
StatedGrid stated_grid(const std::vector<HeaderEntry>& entries, const std::string& unit, const std::string& name);

/// Whether \p key of a header names a size, a step or a count of a map.
bool is_size_key(const std::string& key);

/// Whether \p key of a header names the unit of the heights.
bool is_height_unit_key(const std::string& key);

/// The unit of the positions along x, or \p along_y, by a header: of y that of x where it has none of its own; nullptr
/// where it has none.
const HeaderEntry* stated_axis_unit(const std::vector<HeaderEntry>& entries, bool along_y = false);

/// The line of \p entry, for messages: "line 6, which states ...".
std::string shown_line(const HeaderEntry& entry);

/// The factor of the heights that \p entry states (io/height_sense.hpp); none for 1, and for other lines.
std::optional<double> height_factor(const HeaderEntry& entry);

/// A number that the heights may have to be multiplied by, such as "Z scale: 10"; nullptr where there is none but 1.
/// Nova states whether ("DataScaleNeeded = no").
struct StatedScale {
    const HeaderEntry* entry = nullptr;
    double factor = 1;
    bool needed{};  // stated; else it may be
};
StatedScale stated_scale(const std::vector<HeaderEntry>& entries);

/// Refuses a scale of the heights of which it is not stated whether it is to be applied; its factor, or 1.
double require_scale(const std::vector<HeaderEntry>& entries, const std::string& name, const OptionNames& names);

/// One unit of the heights by a header; nullptr where it has none.
struct StatedHeightUnit {
    const HeaderEntry* unit = nullptr;
    const HeaderEntry* factor = nullptr;
};
StatedHeightUnit stated_height_unit(const std::vector<HeaderEntry>& entries, const std::string& name);

/// Refuses a header that states a unit of the heights that is of no length, such as deg.
void refuse_no_length(const std::vector<HeaderEntry>& entries, const std::string& name);

/// Mark of missing points: \p given, or the number that a header states.
MissingValues stated_missing(const std::vector<HeaderEntry>& entries, std::string_view given, const std::string& name);

/// "Form: triples" or "Form: matrix" of a header, as write_csv writes it.
std::optional<MapForm> stated_form(const std::vector<HeaderEntry>& entries);

}  // namespace fstiff::inline v0_1::io::detail
