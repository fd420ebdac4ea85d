// SPDX-License-Identifier: BSD-3-Clause
// Archives of Sensofar. Bytes that are no archive are taken for index.xml, and those behind its end for the heights,
// both stored in an archive here.
#include "io/plux.hpp"

#include "fuzz.hpp"

using namespace fstiff;

namespace {

std::string little(std::size_t value, std::size_t size) {
    std::string bytes;
    for (std::size_t i = 0; i < size; ++i) bytes += static_cast<char>(value >> (8 * i));
    return bytes;
}

std::size_t check_sum(const std::string& bytes) {
    std::uint32_t sum = 0xFFFFFFFFU;
    for (const char byte : bytes) {
        sum ^= static_cast<unsigned char>(byte);
        for (int bit = 0; bit < 8; ++bit) sum = sum >> 1 ^ (sum & 1 ? 0xEDB88320U : 0);
    }
    return sum ^ 0xFFFFFFFFU;
}

/// An archive of index.xml and z, neither deflated.
std::string stored(const std::string& index, const std::string& heights) {
    std::string bytes, list;
    for (const auto& [name, content] : {std::pair<std::string, std::string>{"index.xml", index}, {"z", heights}}) {
        const std::string entry = little(20, 2) + little(0, 8) + little(check_sum(content), 4) +
                                  little(content.size(), 4) + little(content.size(), 4) + little(name.size(), 2) +
                                  little(0, 2);
        list += "PK\1\2" + little(20, 2) + entry + little(0, 8) + little(0, 2) + little(bytes.size(), 4) + name;
        bytes += "PK\3\4" + entry + name + content;
    }
    return bytes + list + "PK\5\6" + little(0, 4) + little(2, 2) + little(2, 2) + little(list.size(), 4) +
           little(bytes.size(), 4) + little(0, 2);
}

bool read_archive(const std::string& bytes) {
    return fuzz::returns([&] { fuzz::check(io::read_plux(bytes, "file", {.x3p_limits = {.bytes = 1 << 24}})); });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string bytes = fuzz::bytes(data, size);
    read_archive(bytes);
    if (bytes.starts_with("PK\3\4")) return 0;
    const std::size_t end = bytes.rfind('>') == std::string::npos ? bytes.size() : bytes.rfind('>') + 1;
    read_archive(stored(bytes.substr(0, end), bytes.substr(end)));
    return 0;
}
