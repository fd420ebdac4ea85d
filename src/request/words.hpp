// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Words that a user writes in place of those of fstiff: what was meant, and what the model does not have.

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace fstiff::request {

/// The key of \p valid that \p wrong means: the same letters in other capitals, else a synonym of the field, else the
/// nearest by its letters; empty where there is none.
[[nodiscard]] std::string_view meant_key(std::string_view wrong, std::span<const std::string_view> valid);

/// What to do with a quantity that the model does not have, or has elsewhere, by the words in \p key, and the page that
/// describes it; empty where \p key has none of them.
[[nodiscard]] std::string_view outside_of_model(std::string_view key);

/// The end of the sentence that refuses the key \p wrong of the section \p path: "unknown key ...".
[[nodiscard]] std::string unknown_key(std::string_view wrong, std::string_view path,
                                      std::span<const std::string_view> valid);

/// The end of the sentence that refuses \p name, which is no material; \p other is another way to give one.
[[nodiscard]] std::string unknown_material(std::string_view name, std::string_view other);

/// Ra [m] of a grade of ISO 1302, "N1" to "N12", or of a class of VDI 3400, "VDI 0" to "VDI 45": 10^(class/20)/10 um.
/// None of any other text.
[[nodiscard]] std::optional<double> mean_height_of_grade(std::string_view text);

}  // namespace fstiff::request
