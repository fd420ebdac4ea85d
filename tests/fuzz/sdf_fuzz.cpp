// SPDX-License-Identifier: BSD-3-Clause
// Surface data files, text and binary; what is read is written in both forms and comes back.
#include "io/sdf.hpp"
#include <fstiff/io/write.hpp>

#include "fuzz.hpp"

#include <sstream>

using namespace fstiff;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string bytes = fuzz::bytes(data, size);
    io::SdfSurface read;
    if (!fuzz::returns([&] {
            std::istringstream input(bytes);
            read = io::read_sdf(input, "file");
        }))
        return 0;
    fuzz::check(read.map);
    fuzz::require(read.record.sentences().size() >= 4, "four sentences at least");
    for (const bool binary : {true, false}) {
        std::ostringstream output;
        if (!fuzz::returns([&] { io::write_sdf(output, read.map, {.binary = binary}); })) continue;
        std::istringstream again(output.str());  // what is written must be read
        const HeightMap<double> back = io::read_sdf(again, "again").map;
        fuzz::require(back.rows() == read.map.rows() && back.columns() == read.map.columns(), "the same shape");
        for (Eigen::Index i = 0; i < back.size(); ++i) {
            const double old = read.map.heights.data()[i], now = back.heights.data()[i];
            fuzz::require(old == now || (std::isnan(old) && std::isnan(now)), "the same heights");
        }
    }
    return 0;
}
