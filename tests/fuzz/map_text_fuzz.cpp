// SPDX-License-Identifier: BSD-3-Clause
// Maps as delimited text, and the recognition of any file: as it is, with units, as triples, with a size.
#include "io/map_text.hpp"
#include <fstiff/io/surface_file.hpp>
#include <fstiff/io/write.hpp>

#include "fuzz.hpp"

#include <sstream>

using namespace fstiff;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string bytes = fuzz::bytes(data, size);
    for (const io::MapTextOptions& options :
         {io::MapTextOptions{}, io::MapTextOptions{.form = io::MapForm::triples, .units = "mm,um"},
          io::MapTextOptions{.form = io::MapForm::matrix, .dx = 1e-6, .height = 1e-3, .units = "um"},
          io::MapTextOptions{.units = "um,um", .missing = "-9999,void"}}) {
        io::MapFromText read;
        if (!fuzz::returns([&] {
                std::istringstream input(bytes);
                read = io::read_map(input, "file", options);
            }))
            continue;
        fuzz::check(read.map);
        fuzz::require(read.record.sentences().size() == (read.record.columns_text.empty() ? 6 : 7), "all sentences");
        for (const io::MapForm form : {io::MapForm::matrix, io::MapForm::triples}) {
            std::ostringstream output;
            if (!fuzz::returns([&] { io::write_csv(output, read.map, form); })) continue;
            std::istringstream again(output.str());  // what is written must be read
            const HeightMap<double> back = io::read_map(again, "again", {.missing = "none"}).map;
            fuzz::require(back.rows() == read.map.rows() && back.columns() == read.map.columns(), "the same shape");
        }
    }
    fuzz::returns([&] {
        const io::Surface read = io::read_surface(bytes, "file");
        std::visit([](const auto& found) { fuzz::check(found); }, read.data);
    });
    return 0;
}
