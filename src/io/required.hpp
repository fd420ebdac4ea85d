// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// What readers require of the numbers, units and counts that a file states. The file is called \p name in refusals.
///
/// Units       m

#include "io/lines.hpp"
#include "io/reading.hpp"

namespace fstiff::inline v0_1::io::detail {

/// The number that \p text is. \throws domain_error where it is none.
double stated_number(const std::string& name, const std::string& field, std::string_view text);

/// \p value, which the file states as \p field. \throws domain_error unless it is finite and greater than 0.
double require_step(const std::string& name, const std::string& field, double value);

/// The same for a whole number from \p least to 2^32 - 1.
std::size_t require_count(const std::string& name, std::string_view field, double value, int least = 1);

/// The factor of \p unit [m], which the file states as \p field. \throws domain_error unless it is a unit of length.
double require_length_unit(const std::string& name, const std::string& field, std::string_view unit);

/// Makes room for \p rows x \p columns heights, below 2^32 each, of \p size bytes. \return those of the \p bytes that
/// follow the heights \throws domain_error for fewer bytes than the heights have.
std::size_t allocate_stored(RawMap& map, std::size_t rows, std::size_t columns, std::size_t size, std::size_t bytes,
                            const std::string& name);

/// The same for heights of a text with blanks between them. \throws domain_error for less than two a row, too.
void allocate_text(RawMap& map, std::size_t rows, std::size_t columns, std::size_t characters, const std::string& name);

}  // namespace fstiff::inline v0_1::io::detail
