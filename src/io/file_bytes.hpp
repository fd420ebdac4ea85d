// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Fields of a binary file by their byte offset, and its grid of heights. What lies beyond the end of the
/// file is refused.
///
/// Units       heights in m
/// Valid       files up to 2^31 bytes

#include "io/binary_numbers.hpp"
#include "io/required.hpp"

namespace fstiff::inline v0_1::io::detail {

/// The bytes of a file in one byte order.
class FileBytes {
public:
    FileBytes(std::string_view bytes, std::string name, bool big = false)
        : bytes_(bytes), name_(std::move(name)), big_(big) {}

    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] std::size_t size() const { return bytes_.size(); }

    /// The \p size bytes from byte \p place on, which hold \p what. \throws domain_error when the file ends before.
    [[nodiscard]] std::string_view at(std::uint64_t place, std::uint64_t size, std::string_view what) const;
    [[nodiscard]] std::uint64_t number(std::uint64_t place, std::size_t size, std::string_view what) const {
        return unsigned_at(at(place, size, what), big_);
    }
    [[nodiscard]] std::int64_t integer(std::uint64_t place, std::size_t size, std::string_view what) const {
        return signed_at(at(place, size, what), big_);
    }
    [[nodiscard]] double real(std::uint64_t place, std::size_t size, std::string_view what) const {
        return real_at(at(place, size, what), big_);
    }
    /// The same number, finite and greater than 0. \throws domain_error otherwise.
    [[nodiscard]] double positive(std::uint64_t place, std::size_t size, const std::string& what) const;
    /// The text in the \p size bytes from \p place on, up to a NUL byte, without blanks around it.
    [[nodiscard]] std::string_view words(std::uint64_t place, std::uint64_t size, std::string_view what) const;

private:
    std::string_view bytes_;
    std::string name_;
    bool big_;
};

/// Place of the heights of a map, row after row.
struct StoredGrid {
    std::uint64_t place{};            // of the first height
    std::size_t size{};               // bytes of a height
    std::uint64_t columns{}, rows{};  // below 2^32
    std::uint64_t padding{};          // bytes after each row, below 16
};

/// The bytes of all heights. \throws domain_error for less than 2 columns or 1 row, and when the file ends before.
[[nodiscard]] std::string_view stored_heights(const FileBytes& file, const StoredGrid& grid);

/// The heights of \p grid, height_of(bytes) being each [m], NaN where it is missing.
template <class HeightOf>
void read_grid(RawMap& map, const FileBytes& file, const StoredGrid& grid, const HeightOf& height_of) {
    const std::string_view heights = stored_heights(file, grid);
    const auto rows = static_cast<std::size_t>(grid.rows), columns = static_cast<std::size_t>(grid.columns);
    const std::size_t row_bytes = columns * grid.size + static_cast<std::size_t>(grid.padding);
    allocate(map, rows, columns);
    for (std::size_t row = 0; row < rows; ++row)
        for (std::size_t column = 0; column < columns; ++column)
            set_height(map, row * columns + column,
                       height_of(heights.substr(row * row_bytes + column * grid.size, grid.size)));
}

}  // namespace fstiff::inline v0_1::io::detail
