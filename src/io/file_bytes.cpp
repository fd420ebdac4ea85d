// SPDX-License-Identifier: BSD-3-Clause
#include "io/file_bytes.hpp"

namespace fstiff::inline v0_1::io::detail {

std::string_view FileBytes::at(std::uint64_t place, std::uint64_t size, std::string_view what) const {
    if (place > bytes_.size() || size > bytes_.size() - place)
        refuse_file(name_, {"ends within ", printable(what, 80), " (", size, " bytes from byte ", place,
                            " on, where the file has ", bytes_.size(), "); must be whole"});
    return bytes_.substr(static_cast<std::size_t>(place), static_cast<std::size_t>(size));
}

double FileBytes::positive(std::uint64_t place, std::size_t size, const std::string& what) const {
    return require_step(name_, what, real(place, size, what));
}

std::string_view FileBytes::words(std::uint64_t place, std::uint64_t size, std::string_view what) const {
    const std::string_view field = at(place, size, what);
    return trimmed(field.substr(0, field.find('\0')));
}

std::string_view stored_heights(const FileBytes& file, const StoredGrid& grid) {
    if (grid.columns < 2 || grid.rows < 1)
        refuse_field(file.name(), "points of a row x rows",
                     std::to_string(grid.columns) + " x " + std::to_string(grid.rows), "at least 2 x 1");
    const std::uint64_t row = grid.columns * grid.size + grid.padding;  // below 2^36
    if (grid.place > file.size() || grid.rows > (file.size() - grid.place) / row)
        refuse_file(file.name(),
                    {"declares ", grid.columns, " x ", grid.rows, " heights of ", grid.size, " bytes from byte ",
                     grid.place, " on, but has ", file.size(), " bytes; must hold all"});
    return file.at(grid.place, row * grid.rows, "the heights");
}

}  // namespace fstiff::inline v0_1::io::detail
