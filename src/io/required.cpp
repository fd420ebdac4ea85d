// SPDX-License-Identifier: BSD-3-Clause
#include "io/required.hpp"

#include <fstiff/io/quantities.hpp>
#include <fstiff/io/units.hpp>

namespace fstiff::inline v0_1::io::detail {

double stated_number(const std::string& name, const std::string& field, std::string_view text) {
    return fstiff::detail::located({.file = name}, [&] { return parse_number(printable(text, 64), field); });
}

double require_step(const std::string& name, const std::string& field, double value) {
    if (!(value > 0 && value <= (std::numeric_limits<double>::max)()))
        refuse_field(name, field, number_text(value), "finite and greater than 0");
    return value;
}

std::size_t require_count(const std::string& name, std::string_view field, double value, int least) {
    if (!(value >= least && value <= 4294967295.0 && value == std::floor(value)))
        refuse_field(name, field, number_text(value),
                     "a whole number from " + std::to_string(least) + " to 4294967295");
    return static_cast<std::size_t>(value);
}

double require_length_unit(const std::string& name, const std::string& field, std::string_view unit) {
    if (!is_unit(unit, Dimension::length))
        refuse_field(name, field, shown_cell(unit), "a unit of length: " + accepted_units(Dimension::length));
    return unit_factor(unit, Dimension::length);
}

std::size_t allocate_stored(RawMap& map, std::size_t rows, std::size_t columns, std::size_t size, std::size_t bytes,
                            const std::string& name) {
    const std::uint64_t points = std::uint64_t(columns) * rows;  // fits into 64 bits
    if (points > bytes / size)
        refuse_file(name, {"declares ", columns, " x ", rows, " heights of ", size, " bytes, but holds ", bytes,
                           " bytes of them; must hold all"});
    allocate(map, rows, columns);
    return bytes - map.heights.size() * size;
}

void allocate_text(RawMap& map, std::size_t rows, std::size_t columns, std::size_t characters,
                   const std::string& name) {
    // a digit and a blank each; the product fits into 64 bits
    if (columns < 2 || std::uint64_t(rows) * columns > (characters + 1) / 2)
        refuse_file(name, {"declares ", columns, " x ", rows, " heights, but has ", characters,
                           " characters of them; must hold all, 2 a row at least"});
    allocate(map, rows, columns);
}

}  // namespace fstiff::inline v0_1::io::detail
