// SPDX-License-Identifier: BSD-3-Clause
// X3P files. Damaged archives seldom get past their check sums: bytes that are no archive are taken for main.xml, and
// those behind its end for the heights, both put into an archive here.
#include "io/x3p.hpp"

#include "fuzz.hpp"

#include <zip.h>

using namespace fstiff;

namespace {

/// An archive of main.xml and bindata/data.bin; also the mask when there are bytes for it.
std::string archive(const std::string& main, const std::string& heights) {
    std::string bytes;
    zip_source_t* const source = zip_source_buffer_create(nullptr, 0, 0, nullptr);
    zip_source_keep(source);
    zip_t* const zip = zip_open_from_source(source, ZIP_TRUNCATE, nullptr);
    const std::string mask = heights.substr(0, 2);
    const auto add = [&](const char* name, const std::string& content) {
        const zip_int64_t index = zip_file_add(zip, name, zip_source_buffer(zip, content.data(), content.size(), 0), 0);
        zip_set_file_compression(zip, static_cast<zip_uint64_t>(index), ZIP_CM_STORE, 0);
    };
    add("main.xml", main);
    add("bindata/data.bin", heights);
    add("bindata/valid.bin", mask);
    fuzz::require(zip_close(zip) == 0 && zip_source_open(source) == 0, "an archive in memory");
    zip_stat_t stat;
    zip_source_stat(source, &stat);
    bytes.resize(stat.size);
    fuzz::require(zip_source_read(source, bytes.data(), stat.size) == static_cast<zip_int64_t>(stat.size), "whole");
    zip_source_close(source);
    zip_source_free(source);
    return bytes;
}

void read(const std::string& bytes) {
    fuzz::returns([&] {
        const io::Reading found = io::read_x3p(bytes, "file", {.x3p_limits = {.bytes = 1 << 24}});
        fuzz::check(found);
    });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string bytes = fuzz::bytes(data, size);
    read(bytes);
    if (bytes.starts_with("PK\3\4")) return 0;
    const std::size_t end = bytes.rfind('>') == std::string::npos ? bytes.size() : bytes.rfind('>') + 1;
    read(archive(bytes.substr(0, end), bytes.substr(end)));
    return 0;
}
