// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Access of tests to a surface that was read.
#include <fstiff/io/surface_file.hpp>

namespace test {

/// Entry of the record under \p key; empty without one.
inline std::string said(const fstiff::io::Surface& surface, const std::string& key) {
    for (const std::string& sentence : surface.record.details)
        if (sentence.starts_with(key + ": ")) return sentence.substr(key.size() + 2);
    return {};
}

inline std::size_t missing(const fstiff::io::Surface& surface) {
    return surface.is_profile() ? surface.profile().size() - surface.profile().present()
                                : static_cast<std::size_t>(surface.map().size() - surface.map().present());
}

}  // namespace test
