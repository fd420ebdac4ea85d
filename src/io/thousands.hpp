// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The option that names the separator of thousands: it is removed before anything is read. Without it, what may
/// separate thousands is refused (io/ambiguous_signs.hpp).
///
/// Valid       blanks of Unicode and of CP1252 count as blanks, the typographic apostrophe as an apostrophe
/// Accuracy    none: characters (tests/io/thousands_test.cpp)

#include <string>

namespace fstiff::inline v0_1::io::detail {

/// \p text without the separators of thousands that \p given names: "," "." "'" or " "; as it is for "" and "none".
/// \throws domain_error for another name, and for a row of numbers in which that character does something else too.
std::string without_thousands(std::string text, const std::string& given, const std::string& name);

}  // namespace fstiff::inline v0_1::io::detail
