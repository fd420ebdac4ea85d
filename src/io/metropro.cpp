// SPDX-License-Identifier: BSD-3-Clause
/// \file
/// Reads maps of Zygo MetroPro (.dat).
///
/// A header of 834 or 4096 bytes, frames of intensities (uint16), and the heights row after row as int32, all the most
/// significant byte first. Fields of the header that are used, by byte offset:
///
///     0   88 1B 03 6F, 70, or 71 (hex)     68  columns, rows of the heights (uint16)    184 step of x and y [m]
///     6   bytes of the header (uint32):    164 scale factor S of the interferometer     218 phase resolution: 0, 1, 2
///         4096 after 71,  else 834         168 wavelength lambda [m]                    232 sign: 0, or turned over
///     52  columns, rows, frames of the     176 obliquity factor O (float32 all three)
///         intensities (uint16)
///
///     height = number S O lambda / R,     R = 4096, 32768, 131072 by the phase resolution
///
/// Numbers of 2147483640 and more are missing points.
///
/// Reference   layout as in SurfaceTopography 1.27.1 (MIT licence), whose maps of a measured file are the same
/// Units       map in m
/// Valid       2 points a side at least, or one row; heights that vary; files with a step of x and y
/// Accuracy    five roundings, and those of float32 in the file (tests/io/metropro_test.cpp)

#include "io/readers.hpp"

#include "io/zygo_step.hpp"

namespace fstiff::inline v0_1::io::detail {

namespace {

constexpr std::string_view metropro_magic = "\x88\x1B\x03";
constexpr std::uint64_t metropro_short = 834, metropro_long = 4096;  // bytes of the header

/// Value of one unit of the numbers, with its sign [m].
double metropro_step(const FileBytes& file) {
    const double scale = file.positive(164, 4, "scale factor of the interferometer");
    const double wavelength = file.positive(168, 4, "wavelength");
    const double obliquity = file.positive(176, 4, "obliquity factor");
    const double step = zygo_step(file.name(), scale, obliquity, wavelength,
                                  static_cast<double>(file.integer(218, 2, "phase resolution")));
    return file.integer(232, 2, "sign") == 0 ? step : -step;
}

Record record_of(const FileBytes& file, const RawMap& map, double step, std::size_t end) {
    Record record;
    const std::string part(file.words(258, 40, "name of the part"));
    record.note("form", "Zygo MetroPro" + (part.empty() ? "" : ", " + shown_cell(part)));
    note_zygo_step(record, step);
    record.note("spacing", "from the step of x and y in the header");
    record.note_points(map);
    record.say_trailer(file.size() - end);
    return record;
}

bool is_metropro(std::string_view bytes) {
    return bytes.size() > 3 && bytes.starts_with(metropro_magic) && bytes[3] >= '\x6F' && bytes[3] <= '\x71';
}

Reading read_metropro(std::string_view bytes, const std::string& name, const SurfaceOptions&) {
    const FileBytes file(bytes, name, true);
    if (!is_metropro(bytes)) refuse_file(file.name(), {"does not begin as a file of Zygo MetroPro; must begin so"});
    (void)file.at(0, metropro_short, "its header");
    const std::uint64_t header = bytes[3] == '\x71' ? metropro_long : metropro_short;
    if (const std::uint64_t stated = file.number(6, 4, "bytes of the header"); stated != header)
        refuse_field(file.name(), "bytes of the header", std::to_string(stated), std::to_string(header));
    // of uint16 each: the product stays below 2^49
    const std::uint64_t intensities =
        2 * file.number(52, 2, "columns") * file.number(54, 2, "rows") * file.number(56, 2, "frames");
    const StoredGrid grid{.place = header + intensities,
                          .size = 4,
                          .columns = file.number(68, 2, "columns"),
                          .rows = file.number(70, 2, "rows")};
    if (grid.columns == 0 && grid.rows == 0) refuse_file(file.name(), {"holds no heights; must hold a map of them"});
    const double step = metropro_step(file);
    RawMap map;
    read_grid(map, file, grid,
              [&](std::string_view height) { return zygo_height(static_cast<double>(signed_at(height, true)), step); });
    const double lateral = file.positive(184, 4, "step of x and y");
    set_spacings(map, lateral, lateral, file.name());
    Record record = record_of(file, map, step, static_cast<std::size_t>(grid.place + 4 * grid.columns * grid.rows));
    return {std::move(map), std::move(record)};
}

}  // namespace

extern constexpr Reader metropro_reader{.format = SurfaceFormat::metropro,
                                        .endings = ".dat",
                                        .holds = "map of Zygo MetroPro",
                                        .recognised = "its first bytes",
                                        .begins = is_metropro,
                                        .read = read_metropro};

}  // namespace fstiff::inline v0_1::io::detail
