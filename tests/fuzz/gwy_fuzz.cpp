// SPDX-License-Identifier: BSD-3-Clause
// Files of Gwyddion: the channel that is chosen, one by number, one by title.
#include "io/gwy.hpp"

#include "fuzz.hpp"

using namespace fstiff;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string bytes = fuzz::bytes(data, size);
    for (const char* channel : {"", "1", "Height"}) {
        io::Reading read;
        if (!fuzz::returns([&] { read = io::read_gwy(bytes, "file", channel); })) continue;
        fuzz::check(read);
    }
    return 0;
}
