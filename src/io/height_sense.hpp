// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Statements of a text on its heights in addition to their unit: a sense (depths grow downwards) and a factor.
///
///     sense     "depth [um]", "Tiefe", "-z" and "z inverted" as titles; "inverted: yes", "Channel: Depth" and
///               "# heights are inverted" in the header: heights are the numbers with the other sign
///     factor    "z/10 [um]", "10*z", "z x 10", "z (gain 10)" as titles; "scale = 0.1", "ZFactor;0.1", "# vertical
///               magnification 10x" in the header: refused, because the numbers may contain it or not
///
/// A key or a line of the header counts where all its words are of the heights: "Integral gain", "Lens magnification"
/// and "x scale" do not.
///
/// Units       none
/// Valid       words in UTF-8 or an 8-bit code page, of the languages of io/header_words.hpp
/// Accuracy    none: words (tests/io/height_sense_test.cpp)

#include "io/header.hpp"

namespace fstiff::inline v0_1::io::detail {

/// Whether the column \p title holds depths, or heights with the other sign.
bool names_depth(std::string_view title);

/// Whether \p title has a factor outside of its unit, as "z/10 [um]" has; one of positions may have a number after x.
bool has_factor(std::string_view title, bool heights = true);

/// Gives the heights of \p map the other sign, with a warning, where the \p title of their column (empty for a matrix)
/// or the header states that they grow downwards. \throws domain_error for statements that contradict.
void turn_over(RawMap& map, const ColumnTitle& title, const std::vector<HeaderEntry>& entries, const std::string& name,
               Record& record);

}  // namespace fstiff::inline v0_1::io::detail
