// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// How messages speak of the options of a reader, by the OptionNames that it was given.

#include <fstiff/io/surface_file.hpp>

namespace fstiff::inline v0_1::io::detail {

[[nodiscard]] std::string format_as(const OptionNames& names, const std::string& form);
[[nodiscard]] std::string given_as(const OptionNames& names, const std::string& option, const std::string& value);
/// An option that is given or not.
[[nodiscard]] std::string switched_on(const OptionNames& names, const std::string& option);
/// An option of two words, given by \p option with "_" between them.
[[nodiscard]] std::string of_words(const OptionNames& names, std::string option);
/// A warning: the option was given as \p value where the file states another one. \p stated begins with its place.
[[nodiscard]] std::string contradiction(const OptionNames& names, const std::string& option, const std::string& value,
                                        const std::string& stated);
[[nodiscard]] std::string given_steps(const OptionNames& names);

}  // namespace fstiff::inline v0_1::io::detail
