// SPDX-License-Identifier: BSD-3-Clause
// Profiles as delimited text: as it is, with units, with a column chosen; what is read is written and read again.
#include "io/profile_text.hpp"
#include <fstiff/io/write.hpp>

#include "fuzz.hpp"

#include <sstream>

using namespace fstiff;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string bytes = fuzz::bytes(data, size);
    for (const io::ProfileTextOptions& options :
         {io::ProfileTextOptions{}, io::ProfileTextOptions{.units = "um,nm"},
          io::ProfileTextOptions{.spacing = 1e-6, .units = "um", .column = 1},
          io::ProfileTextOptions{.units = "um", .x_column = 2},
          io::ProfileTextOptions{.units = "um", .missing = "-9999,void", .resample = true}}) {
        io::ProfileFromText read;
        std::ostringstream output;
        if (!fuzz::returns([&] {
                std::istringstream input(bytes);
                read = io::read_profile(input, "file", options);
            }))
            continue;
        fuzz::check(read.profile);
        fuzz::require(read.record.sentences().size() == 6, "six sentences");
        if (!fuzz::returns([&] { io::write_csv(output, read.profile); })) continue;
        std::istringstream again(output.str());  // what is written must be read
        fuzz::require(io::read_profile(again, "again", {.missing = "none"}).profile.size() == read.profile.size(),
                      "written and read");
    }
    return 0;
}
