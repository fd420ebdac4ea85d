// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Reads a profile from delimited text, and records every decision it took about the file.
///
/// Rows are separated by line ends (LF, CR LF, CR CR LF, CR), columns by comma, semicolon, tab or blanks. The decimal
/// sign is the point, or the comma where the comma does not separate columns. One column holds heights; two hold
/// positions and heights; more need ProfileTextOptions::column. A column that numbers the points, by its title or by
/// counting 1, 2, 3 ... next to one that names a length, is neither (io/column_titles.hpp); ProfileTextOptions::x_column
/// names the positions where that is wrong. Lines before the first row of numbers are the header,
/// lines that begin with "#", "%", "!", "//" or ";" comments; both are searched for units, from the first row upwards:
/// "x [um]; z [nm]", "Lateral um,Raw Micrometer", "x (µm)", or the bare units. Missing points are empty
/// cells, "nan", "NA", "N/A", "BAD", "No Data", "***" and the number that the header or the options name.
/// Positions may fall (the profile is turned round) but must be equally spaced, as far as the digits they are printed
/// with can tell; where all steps but one or two are the same, a row is missing.
/// ProfileTextOptions::resample puts as many points at equal steps from the first position to the last, by straight lines
/// between neighbours; that lowers the finest waves, as the record says.
///
/// Nothing is guessed: without a unit, without a spacing, or with a cell that is no number, the file is refused.
///
/// Units       profile in m; ProfileTextOptions::units are the file's
/// Valid       16 points at least, of heights that vary; lines up to 2^20 characters, files up to 2^31
/// Accuracy    heights within 1 ulp of the printed number (tests/io/profile_text_test.cpp)

#include "io/header.hpp"
#include "io/profile_columns.hpp"

#include <fstiff/profile/profile.hpp>

namespace fstiff::io {

namespace detail {

inline constexpr TableRules profile_rules{.holds = "one or two columns of numbers", .short_rows = true};

}  // namespace detail

/// What the text of a profile does not say itself.
struct ProfileTextOptions {
    std::optional<double> spacing{};  ///< [m]; replaces the positions of the file
    std::string units{};              ///< "um,nm" (positions, heights) or "um" (both); replaces those of the header
    std::size_t column = 0;           ///< of the heights, counted from 1; 0: the last of one or two columns
    std::size_t x_column = 0;  ///< of the positions, counted from 1; 0: the first that does not number the points
    std::string missing{};     ///< stands for missing points: "-9999", "void", both, or "none"
    bool resample = false;     ///< unequally spaced positions are interpolated
    OptionNames names{};       ///< for messages
};

/// What was decided about a file, and why.
struct ProfileTextRecord : TextRecord {
    std::size_t columns{};          ///< that hold something
    std::size_t height_column{};    ///< counted from 1
    std::size_t position_column{};  ///< counted from 1; 0: none used
    std::size_t index_column{};     ///< the first that numbers the points, counted from 1; 0: none
    std::string position_unit;      ///< as written; empty when no positions are used
    std::string height_unit;        ///< as written
    std::string spacing_from;       ///< where the spacing comes from
    bool reversed{};                ///< positions fell: the heights were turned round
    std::size_t points{};

    /// The above as sentences for people, one a line, without a full stop.
    [[nodiscard]] std::vector<std::string> sentences() const;
};

/// A profile, and how its text was taken.
struct ProfileFromText {
    Profile<double> profile;
    ProfileTextRecord record;
};

/// Reads a table that open_table() has opened by profile_rules; the text must outlive the call.
[[nodiscard]] ProfileFromText read_profile(detail::NumberTable table, const std::string& name,
                                           const ProfileTextOptions& options);

/// Reads all of \p input; \p name stands for it in messages.
/// \throws domain_error naming file, line, value and what is allowed.
[[nodiscard]] ProfileFromText read_profile(std::istream& input, std::string_view name,
                                           const ProfileTextOptions& options = {});

/// Reads the file \p path.
/// \throws file_error when it cannot be opened or read.
[[nodiscard]] ProfileFromText read_profile(const std::filesystem::path& path, const ProfileTextOptions& options = {});

}  // namespace fstiff::io
