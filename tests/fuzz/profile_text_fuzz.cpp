// SPDX-License-Identifier: BSD-3-Clause
// Profiles as delimited text: as it is, with units, with a column chosen; the result is written and read again.
#include <fstiff/io/write.hpp>

#include "fuzz.hpp"

#include <sstream>

using namespace fstiff;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string bytes = fuzz::bytes(data, size);
    constexpr io::SurfaceFormat format = io::SurfaceFormat::profile;
    for (const io::SurfaceOptions& options :
         {io::SurfaceOptions{.format = format}, io::SurfaceOptions{.format = format, .units = "um,nm"},
          io::SurfaceOptions{.format = format, .units = "um", .spacing = 1e-6, .column = 1},
          io::SurfaceOptions{.format = format, .units = "um", .x_column = 2},
          io::SurfaceOptions{.format = format, .units = "um", .missing = "-9999,void", .resample = true}}) {
        io::Surface read;
        std::ostringstream output;
        if (!fuzz::returns([&] { read = io::read_surface(bytes, "file", options); })) continue;
        fuzz::check(read);
        fuzz::require(read.record.details.size() >= 6, "six sentences");
        if (!fuzz::returns([&] { io::write_csv(output, read.profile()); })) continue;
        const io::Surface back = io::read_surface(output.str(), "again", {.missing = "none"});  // must be read
        fuzz::require(back.profile().size() == read.profile().size(), "written and read");
    }
    return 0;
}
