// SPDX-License-Identifier: BSD-3-Clause
// Maps as delimited text, and the recognition of any file: as it is, with units, as triples, with a size.
#include <fstiff/io/surface_file.hpp>
#include <fstiff/io/write.hpp>

#include "fuzz.hpp"

#include <sstream>

using namespace fstiff;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string bytes = fuzz::bytes(data, size);
    for (const io::SurfaceOptions& options :
         {io::SurfaceOptions{}, io::SurfaceOptions{.format = io::SurfaceFormat::triples, .units = "mm,um"},
          io::SurfaceOptions{.format = io::SurfaceFormat::matrix, .units = "um", .dx = 1e-6, .height = 1e-3},
          io::SurfaceOptions{.format = io::SurfaceFormat::matrix, .units = "um,um", .missing = "-9999,void"},
          io::SurfaceOptions{.format = io::SurfaceFormat::triples, .units = "um,um", .missing = "-9999,void"}}) {
        io::Surface read;
        if (!fuzz::returns([&] { read = io::read_surface(bytes, "file", options); })) continue;
        fuzz::check(read);
        if (read.is_profile()) continue;
        for (const io::MapForm form : {io::MapForm::matrix, io::MapForm::triples}) {
            std::ostringstream output;
            if (!fuzz::returns([&] { io::write_csv(output, read.map(), form); })) continue;
            const io::Surface back = io::read_surface(output.str(), "again", {.missing = "none"});  // must be read
            fuzz::require(back.map().rows() == read.map().rows() && back.map().columns() == read.map().columns(),
                          "the same shape");
        }
    }
    return 0;
}
