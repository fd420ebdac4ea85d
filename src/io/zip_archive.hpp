// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The files of a zip archive in memory, within limits. Needs zlib.
///
/// The directory at the end of the archive is read: its count, length and entries must agree. Names are compared, never
/// used as paths. Sizes are compared with the limits before anything is inflated. A file must inflate to the size and
/// the CRC of its entry, and use up its bytes.
///
/// Reference   PKWARE, .ZIP File Format Specification (APPNOTE) 6.3, sections 4.3 to 4.5, with 64-bit sizes
/// Valid       one archive in one file; entries stored (0) or deflated (8)

#include "io/lines.hpp"

#include <fstiff/io/surface_file.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fstiff::inline v0_1::io::detail {

/// A zip archive in memory. The bytes must outlive it.
class ZipArchive {
public:
    ZipArchive(std::string_view bytes, std::string name, const X3pLimits& limits);

    const std::vector<std::string>& names() const { return names_; }

    /// The one file called \p entry; none when there is none.
    std::optional<std::size_t> find(std::string_view entry) const;

    /// Size of file \p index once inflated, which is within the limits.
    std::size_t size(std::size_t index) const;

    /// Refuses file \p index unless it has \p width bytes for each of \p columns x \p rows points, below 2^32 a side.
    void require_points(std::size_t index, std::size_t width, std::size_t columns, std::size_t rows) const;

    std::string content(std::size_t index) const;
    /// That of the file \p entry. \throws domain_error without one.
    std::string content_of(std::string_view entry) const;

private:
    /// Entry of the directory for one file.
    struct Entry {
        std::uint64_t size{}, packed{}, offset{};
        std::uint32_t crc{};
        unsigned method{};
        bool encrypted{};
    };
    struct Directory {
        std::uint64_t count{}, begin{}, size{};
    };

    [[nodiscard]] std::optional<Directory> directory() const;
    [[nodiscard]] std::optional<std::size_t> read_entry(std::string_view rest);
    [[nodiscard]] std::optional<std::string_view> packed(const Entry& entry) const;

    std::string_view bytes_;
    std::string name_;
    X3pLimits limits_;
    std::vector<std::string> names_;
    std::vector<Entry> entries_;
};

}  // namespace fstiff::inline v0_1::io::detail
