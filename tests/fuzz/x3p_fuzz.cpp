// SPDX-License-Identifier: BSD-3-Clause
// X3P files. Damaged archives seldom pass their check sums: bytes that are no archive are taken as main.xml, and
// those after its end as the heights, both put into an archive here.
#include "io/x3p.hpp"

#include "fuzz.hpp"
#include "support/zip.hpp"

using namespace fstiff;

namespace {

/// An archive of main.xml and bindata/data.bin; also the mask when there are bytes for it.
std::string archive(const std::string& main, const std::string& heights) {
    return test::zipped(
        {{"main.xml", main}, {"bindata/data.bin", heights}, {"bindata/valid.bin", heights.substr(0, 2)}}, false);
}

void read(const std::string& bytes) {
    fuzz::returns([&] {
        const io::Reading found = io::read_x3p(bytes, "file", {.x3p_limits = {.bytes = 1 << 24}});
        fuzz::check(found);
    });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string bytes = fuzz::bytes(data, size);
    read(bytes);
    if (bytes.starts_with("PK\3\4")) return 0;
    const std::size_t end = bytes.rfind('>') == std::string::npos ? bytes.size() : bytes.rfind('>') + 1;
    read(archive(bytes.substr(0, end), bytes.substr(end)));
    return 0;
}
