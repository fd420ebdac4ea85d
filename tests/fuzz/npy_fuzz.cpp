// SPDX-License-Identifier: BSD-3-Clause
// Arrays of NumPy, with units and steps given for a map and for a profile.
#include "io/npy.hpp"

#include "fuzz.hpp"

using namespace fstiff;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string bytes = fuzz::bytes(data, size);
    const io::SurfaceOptions ways[] = {{.units = "nm", .dx = 1e-6, .dy = 2e-6},
                                       {.units = "nm", .spacing = 1e-6, .missing = "-9999"}};
    for (const io::SurfaceOptions& options : ways) {
        io::Reading read;
        if (!fuzz::returns([&] { read = io::read_npy(bytes, "file", options); })) continue;
        fuzz::check(read);
    }
    return 0;
}
