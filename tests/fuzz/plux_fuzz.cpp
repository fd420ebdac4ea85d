// SPDX-License-Identifier: BSD-3-Clause
// Archives of Sensofar. Bytes that are no archive are taken as index.xml, and those after its end as the heights, both
// stored in an archive here.
#include "io/plux.hpp"

#include "../support/stored_archive.hpp"
#include "fuzz.hpp"

using namespace fstiff;

namespace {

void read_archive(const std::string& bytes) {
    fuzz::returns([&] { fuzz::check(io::read_plux(bytes, "file", {.x3p_limits = {.bytes = 1 << 24}})); });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string bytes = fuzz::bytes(data, size);
    read_archive(bytes);
    if (bytes.starts_with("PK\3\4")) return 0;
    const std::size_t end = bytes.rfind('>') == std::string::npos ? bytes.size() : bytes.rfind('>') + 1;
    read_archive(test::stored_archive({{"index.xml", bytes.substr(0, end)}, {"z", bytes.substr(end)}}));
    return 0;
}
