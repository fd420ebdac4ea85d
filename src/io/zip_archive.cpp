// SPDX-License-Identifier: BSD-3-Clause
#include "io/zip_archive.hpp"

#include "io/binary_numbers.hpp"

#include <zlib.h>

#include <algorithm>
#include <utility>

namespace fstiff::inline v0_1::io::detail {

namespace {

// Lengths of the records without what varies, and the values that refer to 64 bits elsewhere.
constexpr std::size_t end_length = 22, locator_length = 20, end64_length = 56, entry_length = 46, local_length = 30;
constexpr std::uint64_t in_16_bits = 0xffff, in_32_bits = 0xffffffff;
constexpr std::size_t zlib_step = std::size_t(1) << 30;  // zlib counts in 32 bits

std::uint64_t zip_number(std::string_view bytes, std::size_t at, std::size_t length) {
    return unsigned_at(bytes.substr(at, length), false);
}

/// Whether a record of \p length bytes that begins with \p signature lies at \p at.
bool has_record(std::string_view bytes, std::uint64_t at, std::string_view signature, std::size_t length) {
    return at <= bytes.size() && bytes.size() - at >= length && bytes.substr(at, signature.size()) == signature;
}

/// The content of the extra field that holds 64-bit sizes; empty where there is none.
std::string_view sizes64(std::string_view extra) {
    while (extra.size() >= 4) {
        const std::uint64_t kind = zip_number(extra, 0, 2), length = zip_number(extra, 2, 2);
        if (kind == 1) return extra.substr(4, length);
        extra.remove_prefix(std::min<std::size_t>(extra.size(), 4 + length));
    }
    return {};
}

/// \p value, or where it refers to 64 bits the next number of \p sizes. False where there is none.
bool resolve(std::uint64_t& value, std::string_view& sizes) {
    if (value != in_32_bits) return true;
    if (sizes.size() < 8) return false;
    value = zip_number(sizes, 0, 8);
    sizes.remove_prefix(8);
    return true;
}

/// Whether the deflated \p stream fills \p out and is used up.
bool inflate_raw(std::string_view stream, std::string& out) {
    z_stream state{};
    if (inflateInit2(&state, -MAX_WBITS) != Z_OK) return false;
    char beyond = 0;  // a stream that holds more than the entry states writes here
    std::size_t taken = 0, made = 0;
    int status = Z_OK;
    while (status == Z_OK) {
        const bool full = made == out.size();
        const std::size_t in = std::min(zlib_step, stream.size() - taken),
                          room = full ? 1 : std::min(zlib_step, out.size() - made);
        state.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(stream.data() + taken));
        state.avail_in = static_cast<uInt>(in);
        state.next_out = reinterpret_cast<Bytef*>(full ? &beyond : out.data() + made);
        state.avail_out = static_cast<uInt>(room);
        status = inflate(&state, Z_NO_FLUSH);
        taken += in - state.avail_in;
        if (!full)
            made += room - state.avail_out;
        else if (state.avail_out == 0)
            status = Z_DATA_ERROR;
    }
    inflateEnd(&state);
    return status == Z_STREAM_END && taken == stream.size() && made == out.size();
}

std::uint32_t crc_of(std::string_view bytes) {
    uLong crc = crc32(0, nullptr, 0);
    for (; !bytes.empty(); bytes.remove_prefix(std::min(zlib_step, bytes.size())))
        crc = crc32(crc, reinterpret_cast<const Bytef*>(bytes.data()),
                    static_cast<uInt>(std::min(zlib_step, bytes.size())));
    return static_cast<std::uint32_t>(crc);
}

}  // namespace

ZipArchive::ZipArchive(std::string_view bytes, std::string name, const X3pLimits& limits)
    : bytes_(bytes), name_(std::move(name)), limits_(limits) {
    const auto refuse = [&] {
        refuse_file(name_, {"is not a zip archive, or a damaged one; must be a whole archive"});
    };
    const std::optional<Directory> found = directory();
    if (!found) refuse();
    if (found->count > static_cast<std::uint64_t>(std::max<std::int64_t>(limits_.files, 0)))
        refuse_file(name_, {"holds ", found->count, " files; must be at most ", limits_.files});
    std::string_view rest = bytes_.substr(found->begin, found->size);
    for (std::uint64_t i = 0; i < found->count; ++i) {
        const std::optional<std::size_t> length = read_entry(rest);
        if (!length) refuse();
        rest.remove_prefix(*length);
    }
    if (!rest.empty()) refuse();
}

/// Where the directory lies; none where the end of the archive does not give it, or gives an impossible place.
std::optional<ZipArchive::Directory> ZipArchive::directory() const {
    const std::size_t end = bytes_.rfind("PK\5\6");
    if (end == std::string_view::npos || !has_record(bytes_, end, "PK\5\6", end_length)) return std::nullopt;
    if (bytes_.size() - end - end_length < zip_number(bytes_, end + 20, 2)) return std::nullopt;  // its comment
    Directory found{.count = zip_number(bytes_, end + 10, 2),
                    .begin = zip_number(bytes_, end + 16, 4),
                    .size = zip_number(bytes_, end + 12, 4)};
    std::uint64_t last = end;
    if (found.count == in_16_bits || found.begin == in_32_bits || found.size == in_32_bits) {
        if (end < locator_length || !has_record(bytes_, end - locator_length, "PK\6\7", locator_length))
            return std::nullopt;
        last = zip_number(bytes_, end - locator_length + 8, 8);
        if (!has_record(bytes_, last, "PK\6\6", end64_length)) return std::nullopt;
        found = {.count = zip_number(bytes_, last + 32, 8),
                 .begin = zip_number(bytes_, last + 48, 8),
                 .size = zip_number(bytes_, last + 40, 8)};
    }
    if (found.begin > last || found.size > last - found.begin) return std::nullopt;
    if (found.count > found.size / entry_length) return std::nullopt;
    return found;
}

/// Reads the entry that \p rest begins with. Returns its length; none where it is damaged.
std::optional<std::size_t> ZipArchive::read_entry(std::string_view rest) {
    if (!has_record(rest, 0, "PK\1\2", entry_length)) return std::nullopt;
    const std::size_t name = zip_number(rest, 28, 2), extra = zip_number(rest, 30, 2),
                      comment = zip_number(rest, 32, 2);
    const std::size_t length = entry_length + name + extra + comment;
    if (rest.size() < length) return std::nullopt;
    Entry entry{.size = zip_number(rest, 24, 4),
                .packed = zip_number(rest, 20, 4),
                .offset = zip_number(rest, 42, 4),
                .crc = static_cast<std::uint32_t>(zip_number(rest, 16, 4)),
                .method = static_cast<unsigned>(zip_number(rest, 10, 2)),
                .encrypted = (zip_number(rest, 8, 2) & 1) != 0};
    std::string_view sizes = sizes64(rest.substr(entry_length + name, extra));
    if (!resolve(entry.size, sizes) || !resolve(entry.packed, sizes) || !resolve(entry.offset, sizes))
        return std::nullopt;
    names_.emplace_back(rest.substr(entry_length, name));
    entries_.push_back(entry);
    return length;
}

std::optional<std::size_t> ZipArchive::find(std::string_view entry) const {
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < names_.size(); ++i) {
        if (names_[i] != entry) continue;
        if (found) refuse_file(name_, {"holds two files ", shown_cell(entry), "; must hold one"});
        found = i;
    }
    return found;
}

std::size_t ZipArchive::size(std::size_t index) const {
    const Entry& entry = entries_[index];
    if (entry.encrypted) refuse_file(name_, {shown_cell(names_[index]), " is encrypted; must not be"});
    if (entry.packed > bytes_.size())
        refuse_file(name_, {shown_cell(names_[index]), " declares ", entry.packed,
                            " deflated bytes, more than the file has; must be a whole archive"});
    if (entry.size > limits_.bytes)
        refuse_file(name_, {shown_cell(names_[index]), " would inflate to ", entry.size, " bytes; must be at most ",
                            limits_.bytes});
    if (entry.size > (std::uint64_t(1) << 20) && entry.size / limits_.ratio > entry.packed)
        refuse_file(name_, {shown_cell(names_[index]), " would inflate from ", entry.packed, " to ", entry.size,
                            " bytes; must be at most ", limits_.ratio, " times as many"});
    return static_cast<std::size_t>(entry.size);
}

/// The bytes of a file after its local header; none without them.
std::optional<std::string_view> ZipArchive::packed(const Entry& entry) const {
    if (!has_record(bytes_, entry.offset, "PK\3\4", local_length)) return std::nullopt;
    const std::string_view local = bytes_.substr(entry.offset);
    const std::size_t skipped = local_length + zip_number(local, 26, 2) + zip_number(local, 28, 2);
    if (local.size() < skipped || local.size() - skipped < entry.packed) return std::nullopt;
    return local.substr(skipped, entry.packed);
}

std::string ZipArchive::content(std::size_t index) const {
    const std::size_t length = size(index);
    const Entry& entry = entries_[index];
    const std::optional<std::string_view> stream = packed(entry);
    if (!stream) refuse_file(name_, {shown_cell(names_[index]), " has no readable entry; must be a whole archive"});
    if (entry.method != 0 && entry.method != Z_DEFLATED)
        refuse_file(name_, {shown_cell(names_[index]), " cannot be inflated; must be deflated or stored"});
    std::string text;
    bool whole = true;
    if (entry.method == 0) {
        text = *stream;
        whole = text.size() == length;
    } else {
        text.resize(length);
        whole = inflate_raw(*stream, text);
    }
    if (!whole || crc_of(text) != entry.crc)
        refuse_file(name_, {shown_cell(names_[index]), " is damaged; must be a whole archive"});
    return text;
}

void ZipArchive::require_points(std::size_t index, std::size_t width, std::size_t columns, std::size_t rows) const {
    const std::size_t there = size(index);
    if (there % width != 0 || there / width != std::uint64_t(columns) * rows)
        refuse_file(name_, {shown_cell(names_[index]), " has ", there, " bytes; must have ", width, " for each of ",
                            columns, " x ", rows, " points"});
}

std::string ZipArchive::content_of(std::string_view entry) const {
    const auto index = find(entry);
    if (!index) refuse_file(name_, {"holds no ", shown_cell(entry), "; must hold it in its archive"});
    return content(*index);
}

}  // namespace fstiff::inline v0_1::io::detail
