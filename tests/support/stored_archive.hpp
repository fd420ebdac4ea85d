// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// A zip archive whose files are stored, made without a library.
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace test {

/// \p value as \p size bytes, at most 8, the least significant first.
inline std::string little(std::int64_t value, std::size_t size) {
    std::string bytes;
    for (std::size_t i = 0; i < size; ++i) bytes += static_cast<char>(static_cast<std::uint64_t>(value) >> (8 * i));
    return bytes;
}

/// The CRC-32 of \p bytes.
inline std::uint32_t check_sum(const std::string& bytes) {
    std::uint32_t sum = 0xFFFFFFFFU;
    for (const char byte : bytes) {
        sum ^= static_cast<unsigned char>(byte);
        for (int bit = 0; bit < 8; ++bit) sum = sum >> 1 ^ (sum & 1 ? 0xEDB88320U : 0);
    }
    return sum ^ 0xFFFFFFFFU;
}

/// An archive of \p files, each a name and its content.
inline std::string stored_archive(const std::vector<std::pair<std::string, std::string>>& files) {
    std::string bytes, list;
    const auto many = static_cast<std::int64_t>(files.size());
    for (const auto& [name, content] : files) {
        const auto size = static_cast<std::int64_t>(content.size());
        const std::string entry = little(20, 2) + little(0, 8) + little(check_sum(content), 4) + little(size, 4) +
                                  little(size, 4) + little(static_cast<std::int64_t>(name.size()), 2) + little(0, 2);
        list += "PK\1\2" + little(20, 2) + entry + little(0, 8) + little(0, 2) +
                little(static_cast<std::int64_t>(bytes.size()), 4) + name;
        bytes += "PK\3\4" + entry + name + content;
    }
    return bytes + list + "PK\5\6" + little(0, 4) + little(many, 2) + little(many, 2) +
           little(static_cast<std::int64_t>(list.size()), 4) + little(static_cast<std::int64_t>(bytes.size()), 4) +
           little(0, 2);
}

}  // namespace test
