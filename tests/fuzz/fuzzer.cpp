// SPDX-License-Identifier: BSD-3-Clause
// The target of libFuzzer, for the form that the environment names.
#include "fuzz.hpp"

#include <cstdint>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const std::string form = std::getenv("FSTIFF_FUZZ_FORM");
    fuzz(form, size == 0 ? std::string() : std::string(reinterpret_cast<const char*>(data), size));
    return 0;
}
