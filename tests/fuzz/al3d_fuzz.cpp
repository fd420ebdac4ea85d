// SPDX-License-Identifier: BSD-3-Clause
// Maps of Alicona.
#include "io/al3d.hpp"

#include "fuzz.hpp"

using namespace fstiff;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string bytes = fuzz::bytes(data, size);
    fuzz::returns([&] { fuzz::check(io::read_al3d(bytes, "file")); });
    return 0;
}
