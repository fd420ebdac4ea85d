// SPDX-License-Identifier: BSD-3-Clause
// Simple fields of Gwyddion.
#include "io/gsf.hpp"

#include "fuzz.hpp"

using namespace fstiff;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string bytes = fuzz::bytes(data, size);
    io::GsfSurface read;
    if (!fuzz::returns([&] { read = io::read_gsf(bytes, "file"); })) return 0;
    fuzz::check(read.map);
    fuzz::require(read.record.sentences().size() >= 4, "four sentences at least");
    return 0;
}
