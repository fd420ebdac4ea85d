// SPDX-License-Identifier: BSD-3-Clause
// Surface data files, text and binary; the result is written in both forms and read back.
#include <fstiff/io/write.hpp>
#include "io/sdf.hpp"

#include "fuzz.hpp"

#include <cmath>
#include <sstream>

using namespace fstiff;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string bytes = fuzz::bytes(data, size);
    io::Reading read;
    if (!fuzz::returns([&] { read = io::read_sdf(bytes, "file"); })) return 0;
    fuzz::check(read);
    const io::Surface surface = io::detail::surface_of({read.map, {}});
    for (const bool binary : {true, false}) {
        std::ostringstream output;
        if (!fuzz::returns([&] {
                std::visit([&](const auto& found) { io::write_sdf(output, found, {.binary = binary}); }, surface.data);
            }))
            continue;
        const io::detail::RawMap back = io::read_sdf(output.str(), "again").map;  // what is written must be read
        fuzz::require(back.rows == read.map.rows && back.columns == read.map.columns, "the same shape");
        for (std::size_t i = 0; i < back.heights.size(); ++i) {
            const double old = read.map.heights[i], now = back.heights[i];
            fuzz::require(old == now || (std::isnan(old) && std::isnan(now)), "the same heights");
        }
    }
    return 0;
}
