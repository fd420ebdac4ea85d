// SPDX-License-Identifier: BSD-3-Clause
// Maps of Wyko Vision.
#include "io/opd.hpp"

#include "fuzz.hpp"

using namespace fstiff;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string bytes = fuzz::bytes(data, size);
    fuzz::returns([&] { fuzz::check(io::read_opd(bytes, "file")); });
    return 0;
}
