// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/io/write.hpp>

#include "io/number.hpp"
#include "io/reading.hpp"

#include <fstiff/core/error.hpp>
#include <fstiff/core/text.hpp>

#include <bit>
#include <cstdint>
#include <ostream>

namespace fstiff::inline v0_1::io {

namespace detail {

namespace {

template <class T>
void put_little_endian(std::string& bytes, T value) {
    for (std::size_t i = 0; i < sizeof(T); ++i) bytes += static_cast<char>((value >> (8 * i)) & 0xff);
}

std::string sdf_binary(const RawMap& map, const SdfOptions& options) {
    const bool short_sides = map.rows <= 65535 && map.columns <= 65535;
    std::string text = short_sides ? "bISO-1.0" : "bISO-2.0";
    text += options.manufacturer + std::string(10 - options.manufacturer.size(), ' ');
    text += options.date + options.date;
    for (const std::size_t count : {map.columns, map.rows})
        if (short_sides)
            put_little_endian(text, static_cast<std::uint16_t>(count));
        else
            put_little_endian(text, static_cast<std::uint32_t>(count));
    for (const double scale : {map.dx, map.dy, 1.0, -1.0}) put_little_endian(text, std::bit_cast<std::uint64_t>(scale));
    text += std::string("\0\7\0", 3);
    for (const double z : map.heights)
        put_little_endian(text,
                          std::bit_cast<std::uint64_t>(std::isnan(z) ? std::numeric_limits<double>::lowest() : z));
    return text;
}

std::string sdf_text(const RawMap& map, const SdfOptions& options) {
    const std::string end = "\r\n";
    std::string text =
        "aISO-1.0" + end + "ManufacID = " + options.manufacturer + end + "CreateDate = " + options.date + end +
        "ModDate = " + options.date + end + "NumPoints = " + std::to_string(map.columns) + end +
        "NumProfiles = " + std::to_string(map.rows) + end + "Xscale = " + fstiff::detail::shortest_text(map.dx) + end +
        "Yscale = " + fstiff::detail::shortest_text(map.dy) + end + "Zscale = 1" + end + "Zresolution = -1" + end +
        "Compression = 0" + end + "DataType = 7" + end + "CheckType = 0" + end + "*" + end;
    for (std::size_t j = 0; j < map.rows; ++j) {
        for (std::size_t i = 0; i < map.columns; ++i) {
            const double z = map.at(j, i);
            text += (i == 0 ? "" : " ") + (std::isnan(z) ? std::string("BAD") : fstiff::detail::shortest_text(z));
        }
        text += end;
    }
    text += "*" + end + "*" + end;
    return text;
}

void put_sdf(std::ostream& output, const RawMap& map, const SdfOptions& options) {
    validate_map(map, 2);
    fstiff::detail::require_positive("dy", map.dy);
    const auto printable = [](char c) { return c >= ' ' && c <= '~'; };
    if (options.manufacturer.size() > 10 ||
        !std::all_of(options.manufacturer.begin(), options.manufacturer.end(), printable))
        throw domain_error({.parameter = "manufacturer",
                            .value = shown_cell(options.manufacturer),
                            .allowed = "at most 10 printable characters"});
    if (options.date.size() != 12 || !std::all_of(options.date.begin(), options.date.end(), is_digit))
        throw domain_error(
            {.parameter = "date", .value = shown_cell(options.date), .allowed = "12 digits, DDMMYYYYHHMM"});
    if (map.rows > 4294967295 || map.columns > 4294967295)
        throw domain_error("map of " + std::to_string(map.columns) + " x " + std::to_string(map.rows) +
                           " points: must have at most 4294967295 a side");

    const auto is_reserved = [](double z) { return z == std::numeric_limits<double>::lowest(); };
    if (std::any_of(map.heights.begin(), map.heights.end(), is_reserved))
        throw domain_error("map with the height -1.8e308: marks a missing point in the file; must not occur");

    const std::string text = options.binary ? sdf_binary(map, options) : sdf_text(map, options);
    output.write(text.data(), static_cast<std::streamsize>(text.size()));
    if (!output) throw file_error("surface data file", "cannot be written; the output must take it");
}

}  // namespace

}  // namespace detail

void write_sdf(std::ostream& output, const HeightMap<double>& map, const SdfOptions& options) {
    const double* const z = map.heights.data();
    detail::put_sdf(output,
                    {.heights = {z, z + map.size()},
                     .rows = static_cast<std::size_t>(map.rows()),
                     .columns = static_cast<std::size_t>(map.columns()),
                     .dx = map.dx,
                     .dy = map.dy},
                    options);
}

void write_sdf(std::ostream& output, const Profile<double>& profile, const SdfOptions& options) {
    profile.validate(2);
    detail::put_sdf(output,
                    {.heights = profile.heights,
                     .rows = 1,
                     .columns = profile.size(),
                     .dx = profile.spacing,
                     .dy = profile.spacing},
                    options);
}

}  // namespace fstiff::inline v0_1::io
