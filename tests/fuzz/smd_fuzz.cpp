// SPDX-License-Identifier: BSD-3-Clause
// Profiles of ISO 5436-2 and their elder form.
#include "io/smd.hpp"

#include "fuzz.hpp"

using namespace fstiff;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string bytes = fuzz::bytes(data, size);
    io::Reading read;
    if (!fuzz::returns([&] { read = io::read_smd(bytes, "file"); })) return 0;
    fuzz::check(read);
    fuzz::require(read.map.rows == 1 && read.map.columns >= 16, "a profile");
    return 0;
}
