// SPDX-License-Identifier: BSD-3-Clause
// Maps as delimited text, and the recognition of any file: as it is, with units, as triples, with a size.
#include <fstiff/io/map_text.hpp>
#include <fstiff/io/surface_file.hpp>

#include "fuzz.hpp"

#include <sstream>

using namespace fstiff;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string bytes = fuzz::bytes(data, size);
    for (const io::MapTextOptions& options :
         {io::MapTextOptions{}, io::MapTextOptions{.form = io::MapForm::triples, .units = "mm,um"},
          io::MapTextOptions{.form = io::MapForm::matrix, .dx = 1e-6, .height = 1e-3, .units = "um"}})
        fuzz::refuse_or_return([&] {
            std::istringstream input(bytes);
            const io::MapFromText read = io::read_map(input, "file", options);
            fuzz::check(read.map);
            fuzz::require(read.record.sentences().size() == 6, "six sentences");
        });
    fuzz::refuse_or_return([&] {
        const io::Surface read = io::read_surface(bytes, "file");
        std::visit([](const auto& found) { fuzz::check(found); }, read.data);
    });
    return 0;
}
