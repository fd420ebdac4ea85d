// SPDX-License-Identifier: BSD-3-Clause
#include "io/unpack.hpp"

#include <zlib.h>

#include <algorithm>

namespace fstiff::inline v0_1::io::detail {

bool inflate_zlib(std::string_view stream, std::span<char> out) {
    if (stream.empty() || out.empty()) return false;
    auto length = static_cast<uLongf>(out.size());
    const int status = ::uncompress(reinterpret_cast<Bytef*>(out.data()), &length,
                                    reinterpret_cast<const Bytef*>(stream.data()), static_cast<uLong>(stream.size()));
    return status == Z_OK && length == out.size();
}

std::size_t inflate_first(std::string_view stream, std::span<char> out) {
    ::z_stream state{};
    state.next_in = reinterpret_cast<z_const Bytef*>(const_cast<char*>(stream.data()));
    state.avail_in = static_cast<uInt>((std::min)(stream.size(), std::size_t(1) << 30));
    state.next_out = reinterpret_cast<Bytef*>(out.data());
    state.avail_out = static_cast<uInt>(out.size());
    if (::inflateInit(&state) != Z_OK) return 0;
    const int status = ::inflate(&state, Z_SYNC_FLUSH);
    ::inflateEnd(&state);
    return status == Z_OK || status == Z_STREAM_END ? out.size() - state.avail_out : 0;
}

}  // namespace fstiff::inline v0_1::io::detail
