// SPDX-License-Identifier: BSD-3-Clause
// Files of Digital Surf; compressed ones where zlib is.
#include "io/sur.hpp"

#include "fuzz.hpp"

using namespace fstiff;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string bytes = fuzz::bytes(data, size);
    io::Reading read;
    if (!fuzz::returns([&] { read = io::read_sur(bytes, "file", io::inflate_where_built()); })) return 0;
    fuzz::check(read);
    return 0;
}
