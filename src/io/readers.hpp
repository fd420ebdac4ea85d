// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The forms of files that are read, one row each: what a form holds, what begins it, and its reader. A row is at the
/// end of the source of its reader, and its name in the list of io/readers.cpp; the recognition of files, refusals,
/// `fstiff formats` and the fuzzer are loops over the rows.

#include "io/reading.hpp"

#include <span>
#include <type_traits>

namespace fstiff::inline v0_1::io::detail {

/// A form of files, and its reader.
struct Reader {
    SurfaceFormat format;
    std::string_view endings, holds, recognised;       ///< for people
    std::string_view asks_for = "nothing";             ///< for people: options that a file needs
    std::string_view options{};                        ///< words of those that have a use; others are refused
    bool (*begins)(std::string_view bytes) = nullptr;  ///< none of a text, whose columns decide
    Reading (*read)(std::string_view bytes, const std::string& name, const SurfaceOptions& options) =
        nullptr;            ///< \throws domain_error naming file, field and what is allowed; none where it is not built
    std::size_t mark = 12;  ///< first bytes that a second file after the first repeats
    /// Whether a longer file that begins so is for this reader, be it to refuse it, where that needs more bytes.
    bool (*may_begin)(std::string_view bytes) = nullptr;
};

/// All forms, as SurfaceFormat lists them.
[[nodiscard]] std::span<const Reader* const> readers();
/// The row of \p format, which is not automatic.
[[nodiscard]] const Reader& reader_of(SurfaceFormat format);

/// Refuses the options that \p format has no use for.
void check_options(SurfaceFormat format, const SurfaceOptions& options, const std::string& name);

/// The function `read` of a row by a class of the bytes, the name and, where it has a use for them, the options.
template <class Source>
Reading read_by(std::string_view bytes, const std::string& name, [[maybe_unused]] const SurfaceOptions& options) {
    if constexpr (std::is_constructible_v<Source, std::string_view, const std::string&, const SurfaceOptions&>)
        return Source(bytes, name, options).read();
    else
        return Source(bytes, name).read();
}

}  // namespace fstiff::inline v0_1::io::detail
