// SPDX-License-Identifier: BSD-3-Clause
// Simple fields of Gwyddion.
#include "io/gsf.hpp"

#include "fuzz.hpp"

using namespace fstiff;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string bytes = fuzz::bytes(data, size);
    io::Reading read;
    if (!fuzz::returns([&] { read = io::read_gsf(bytes, "file"); })) return 0;
    fuzz::check(read);
    return 0;
}
