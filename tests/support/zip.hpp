// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Zip archives for tests, laid out by APPNOTE 6.3 with zlib: whole ones, and ones that lie.
#include <zlib.h>

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test {

using Members = std::vector<std::pair<std::string, std::string>>;

inline std::string little_endian(std::uint64_t value, int bytes) {
    std::string text;
    for (int k = 0; k < bytes; ++k) text += static_cast<char>(k < 8 ? value >> 8 * k & 0xff : 0);
    return text;
}

inline std::string deflated(const std::string& content) {
    z_stream state{};
    if (deflateInit2(&state, 9, Z_DEFLATED, -MAX_WBITS, 9, Z_DEFAULT_STRATEGY) != Z_OK)
        throw std::runtime_error("deflateInit2");
    std::string out(deflateBound(&state, static_cast<uLong>(content.size())), '\0');
    state.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(content.data()));
    state.avail_in = static_cast<uInt>(content.size());
    state.next_out = reinterpret_cast<Bytef*>(out.data());
    state.avail_out = static_cast<uInt>(out.size());
    if (deflate(&state, Z_FINISH) != Z_STREAM_END) throw std::runtime_error("deflate");
    out.resize(state.total_out);
    deflateEnd(&state);
    return out;
}

/// False values in the entries of an archive.
struct ZipLies {
    std::optional<std::uint64_t> size{}, packed{}, count{}, offset{};
    std::optional<std::uint32_t> crc{};
    std::string behind{};  ///< the packed bytes of each file, which its entry counts
    std::optional<unsigned> method{};
    unsigned flags = 0;
    bool sizes64 = false;  ///< 64-bit sizes, where 32 bits would do
};

/// An archive of files, by name and content. Without \p deflate they are stored.
inline std::string zipped(const Members& members, bool deflate = true, const ZipLies& lies = {}) {
    std::string files, directory;
    for (const auto& [name, content] : members) {
        const std::string packed = (deflate ? deflated(content) : content) + lies.behind;
        const auto* const bytes = reinterpret_cast<const Bytef*>(content.data());
        const std::uint64_t crc = crc32(0, bytes, static_cast<uInt>(content.size()));
        const std::uint64_t size = lies.size.value_or(content.size()), offset = lies.offset.value_or(files.size());
        const std::uint64_t length = lies.packed.value_or(packed.size());
        const auto in_32 = [&](std::uint64_t value) { return little_endian(lies.sizes64 ? 0xffffffff : value, 4); };
        const std::string common = little_endian(lies.flags, 2) +
                                   little_endian(lies.method.value_or(deflate ? 8 : 0), 2) + little_endian(0, 4) +
                                   little_endian(lies.crc.value_or(crc), 4) + in_32(length) + in_32(size) +
                                   little_endian(name.size(), 2);
        std::string extra;  // after one that readers must skip
        if (lies.sizes64)
            extra = little_endian(7, 2) + little_endian(1, 2) + "x" + little_endian(1, 2) + little_endian(24, 2) +
                    little_endian(size, 8) + little_endian(length, 8) + little_endian(offset, 8);
        directory += "PK\1\2" + little_endian(45, 2) + little_endian(45, 2) + common + little_endian(extra.size(), 2) +
                     little_endian(0, 10) + in_32(offset) + name + extra;
        files += "PK\3\4" + little_endian(45, 2) + common + little_endian(0, 2) + name + packed;
    }
    const std::uint64_t count = lies.count.value_or(members.size());
    std::string end;
    if (lies.sizes64)
        end = "PK\6\6" + little_endian(44, 8) + little_endian(45, 2) + little_endian(45, 2) + little_endian(0, 8) +
              little_endian(count, 8) + little_endian(count, 8) + little_endian(directory.size(), 8) +
              little_endian(files.size(), 8) + "PK\6\7" + little_endian(0, 4) +
              little_endian(files.size() + directory.size(), 8) + little_endian(1, 4);
    const auto in = [&](std::uint64_t value, int bytes) { return little_endian(lies.sizes64 ? ~0ull : value, bytes); };
    end += "PK\5\6" + little_endian(0, 4) + in(count, 2) + in(count, 2) + in(directory.size(), 4) +
           in(files.size(), 4) + little_endian(0, 2);
    return files + directory + end;
}

}  // namespace test
