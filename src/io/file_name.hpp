// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Names of files are texts of UTF-8 with / between folders, on Windows too, where a path that is made of a plain text
// would have its code page.

#include <filesystem>
#include <string>
#include <string_view>

namespace fstiff::inline v0_1::io::detail {

[[nodiscard]] inline std::filesystem::path path_of(std::string_view name) {
    return std::u8string(name.begin(), name.end());
}
[[nodiscard]] inline std::string name_of_path(const std::filesystem::path& path) {
    const std::u8string name = path.generic_u8string();
    return {name.begin(), name.end()};
}

}  // namespace fstiff::inline v0_1::io::detail
