// SPDX-License-Identifier: BSD-3-Clause
#include "io/unpack.hpp"

#include <zlib.h>

namespace fstiff::inline v0_1::io::detail {

bool inflate_zlib(std::string_view stream, std::span<char> out) {
    if (stream.empty() || out.empty()) return false;
    auto length = static_cast<uLongf>(out.size());
    const int status = ::uncompress(reinterpret_cast<Bytef*>(out.data()), &length,
                                    reinterpret_cast<const Bytef*>(stream.data()), static_cast<uLong>(stream.size()));
    return status == Z_OK && length == out.size();
}

}  // namespace fstiff::inline v0_1::io::detail
