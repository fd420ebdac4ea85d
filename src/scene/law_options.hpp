// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The table of what the sections contact.<law> of a scene may hold: reading, refusals and docs/scene.md follow its
// rows.

#include "scene/scene.hpp"
#include "scene/source.hpp"

#include <span>
#include <string_view>
#include <variant>

namespace fstiff::scene {

/// One option, whose kind is the type of its field: true or false, a number, a whole number, or a word.
struct LawOption {
    LawName law;
    std::string_view key;
    std::variant<bool LawOptions::*, double LawOptions::*, int LawOptions::*, Edges LawOptions::*,
                 std::optional<SpectrumSource> LawOptions::*>
        field;
    double low = 0, high = 0;                 ///< of a number (low, high], of a whole one [low, high]
    std::optional<Dimension> dimension = {};  ///< of a number: with a unit, and greater than 0
};

/// All rows, those of one law one after the other.
[[nodiscard]] std::span<const LawOption> law_option_table();
/// Whether the section of \p law may also be at the root of a scene; its options count for other laws too.
[[nodiscard]] bool is_shared(LawName law);
/// The laws that have options.
[[nodiscard]] std::vector<LawName> laws_with_options();

/// Reads the section contact.\p law, or \p law at \p root, into \p scene.law_options. Of a section that is not shared
/// the defaults are recorded.
void read_law_options(Source& source, const Section& root, LawName law, Scene& scene);

}  // namespace fstiff::scene
