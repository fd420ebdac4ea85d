// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Common part of the fuzz targets: a reader returns something valid or throws domain_error with a printable sentence.
#include "io/reading.hpp"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace fuzz {

/// assert that no build type switches off
inline void require(bool satisfied, const char* what) {
    if (satisfied) return;
    std::fprintf(stderr, "fuzz: %s\n", what);
    std::abort();
}

inline std::string bytes(const std::uint8_t* data, std::size_t size) {
    return size == 0 ? std::string() : std::string(reinterpret_cast<const char*>(data), size);
}

inline void check(const fstiff::io::Reading& read) {
    fstiff::io::detail::validate_map(read.map, 2);
    require(read.record.sentences().size() >= 4, "four sentences at least");
    for (const auto& [key, text] : read.record.entries)
        require(!key.empty() && !text.empty(), "a sentence says something");
}
inline void check(const fstiff::io::Surface& read) {
    if (read.is_profile())
        read.profile().validate(2);
    else
        read.map().validate(2);
}

/// Whether \p call returned; else it refused, in one line.
template <class Call>
bool returns(const Call& call) {
    try {
        call();
        return true;
    } catch (const fstiff::domain_error& error) {
        const std::string text = error.what();
        require(!text.empty() && text.size() < 2000, "a refusal must be one sentence");
        for (const char c : text) require(c != '\n' && c != '\0', "a refusal must be one line");
        return false;
    }
}

}  // namespace fuzz
