// SPDX-License-Identifier: BSD-3-Clause
#include "io/option_names.hpp"

#include <algorithm>

namespace fstiff::inline v0_1::io::detail {

std::string format_as(const OptionNames& names, const std::string& form) { return names.format + names.equals + form; }

std::string given_as(const OptionNames& names, const std::string& option, const std::string& value) {
    return "given as " + names.prefix + option + names.equals + value;
}

std::string switched_on(const OptionNames& names, const std::string& option) {
    return names.prefix + option + (names.prefix.empty() ? names.equals + "true" : "");
}

std::string of_words(const OptionNames& names, std::string option) {
    if (!names.prefix.empty()) std::replace(option.begin(), option.end(), '_', '-');
    return names.prefix + option;
}

std::string contradiction(const OptionNames& names, const std::string& option, const std::string& value,
                          const std::string& stated) {
    return names.prefix + option + names.equals + value + " contradicts " + stated + "; the option is used";
}

std::string given_steps(const OptionNames& names) {
    return "given as " + names.prefix + "dx and " + names.prefix + "dy";
}

}  // namespace fstiff::inline v0_1::io::detail
