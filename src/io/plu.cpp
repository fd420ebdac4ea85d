// SPDX-License-Identifier: BSD-3-Clause
/// \file
/// Reads maps of Sensofar and Leica DCM (.plu, .apx).
///
/// A header of 500 bytes without a mark of its own, and layers of heights, the least significant byte first. Fields
/// of the header that are used, by byte offset:
///
///     0    date and time as text ("Fri Mar 10 16:35:59 2023")    428  type of the measurement (uint32): 3 is a map
///     388  rows, columns (uint32)                                489  layers (uint8)
///     404  steps of x and y [um] (float32)                       492  pictures after each layer (uint8)
///
/// A layer is rows, columns (uint32), the heights in um row after row as float32, the lowest and the highest of them
/// (float32), and the pictures of 3 bytes a point. 1000001 marks a missing point. The first layer is read.
///
/// A file is known by its date and by counts that agree with each other.
///
/// Reference   layout as in SurfaceTopography 1.27.1 (MIT licence), whose maps of two measured files are the same
/// Units       map in m
/// Valid       2 points a side at least, or one row; heights that vary; no profiles and other measurements
/// Accuracy    the float32 of the file times 1e-6, rounded once (tests/io/plu_test.cpp)

#include "io/readers.hpp"

#include "io/file_bytes.hpp"

namespace fstiff::inline v0_1::io::detail {

namespace {

constexpr std::size_t plu_header = 500;
constexpr double plu_missing = 1000001;

Record record_of(const FileBytes& file, const RawMap& map, std::uint64_t layers) {
    Record record;
    record.note("form", "Sensofar (.plu), measured " + printable(file.words(0, 128, "the date"), 40));
    if (layers > 1) record.note("other layers", std::to_string(layers - 1) + ", not read");
    record.note("units", "um, 32-bit floating-point heights");
    record.note("spacing", "from the steps of x and y in the header");
    record.note_points(map);
    return record;
}

bool is_plu(std::string_view bytes) {
    if (bytes.size() < plu_header) return false;
    const std::string_view date = bytes.substr(0, (std::min<std::size_t>)(bytes.find('\0'), 128));
    const auto number = [&](std::size_t place) { return unsigned_at(bytes.substr(place, 4), false); };
    return date.size() >= 16 && date.size() <= 40 && std::count(date.begin(), date.end(), ':') == 2 &&
           std::all_of(date.begin(), date.end(), [](char c) { return c >= ' ' && c <= '~'; }) && number(388) > 0 &&
           number(392) > 0 && number(428) <= 16 && number(440) <= 1000;
}

Reading read_plu(std::string_view bytes, const std::string& name, const SurfaceOptions&) {
    const FileBytes file(bytes, name);
    (void)file.at(0, plu_header, "its header");
    if (!is_plu(bytes))
        refuse_file(file.name(), {"does not begin as a file of Sensofar (.plu); must begin with a date and counts"});
    if (const std::uint64_t type = file.number(428, 4, "type"); type != 3)
        refuse_field(file.name(), "type of the measurement", std::to_string(type), "3 (a map of heights)");
    const std::uint64_t layers = file.number(489, 1, "layers");
    if (layers == 0) refuse_field(file.name(), "layers", "0", "at least 1");
    const StoredGrid grid{.place = plu_header + 8,
                          .size = 4,
                          .columns = file.number(plu_header + 4, 4, "columns of the first layer"),
                          .rows = file.number(plu_header, 4, "rows of the first layer")};
    RawMap map;
    read_grid(map, file, grid, [](std::string_view height) {
        const double z = real_at(height, false);
        return z == plu_missing ? std::numeric_limits<double>::quiet_NaN() : z * 1e-6;
    });
    set_spacings(map, file.positive(404, 4, "step of x") * 1e-6, file.positive(408, 4, "step of y") * 1e-6,
                 file.name());
    Record record = record_of(file, map, layers);
    return {std::move(map), std::move(record)};
}

}  // namespace

extern constexpr Reader plu_reader{.format = SurfaceFormat::plu,
                                   .endings = ".plu .apx",
                                   .holds = "map of Sensofar and Leica DCM",
                                   .recognised = "the date and the counts in its header",
                                   .begins = is_plu,
                                   .read = read_plu};

}  // namespace fstiff::inline v0_1::io::detail
