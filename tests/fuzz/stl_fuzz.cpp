// SPDX-License-Identifier: BSD-3-Clause
// Maps of triangles.
#include "io/stl.hpp"

#include "fuzz.hpp"

using namespace fstiff;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string bytes = fuzz::bytes(data, size);
    fuzz::returns([&] { fuzz::check(io::read_stl(bytes, "file", {.units = "um"})); });
    return 0;
}
