// SPDX-License-Identifier: BSD-3-Clause
/// \file
/// Reads surfaces and profiles of Digital Surf (.sur, .pro), compressed or not.
///
/// A header of 512 bytes, a comment, a private zone, and the heights row after row as integers of 16 or 32 bits. Fields
/// of the header that are used, by byte offset:
///
///     0   "DIGITAL SURF", or       86  non-measured points are marked     120  steps of x, y, z (float32)
///         "DSCOMPRESSED"           98  bits of a height                   180  their units (3 x 16 characters)
///     12  0: least significant     100 lowest number                      290  1, 2, 3: inverted
///         byte first, 257: last    108 points of a row                    334  bytes of the comment
///     14  objects in the file      112 rows                               336  bytes of the private zone
///     18  1 profile, 2 surface
///
/// The heights of a compressed file are zlib streams after a table: their count, then of each its bytes when inflated
/// and when deflated (uint32). Together they hold the heights as in the other form.
///
/// Heights are number times step of z; the offset of the axis, a constant, is not added. Where missing points are
/// marked, the lowest number less 2 marks them. A file that states an inversion is read as stored, with
/// a warning.
///
/// Reference   the header of the formats SUR and PRO of Digital Surf, as the open reader of Gwyddion lays it out; files
///             of both forms from an open program are read (tests/data), none from MountainsMap
/// Units       map in m
/// Valid       one object; 2 points a side at least, or one row; heights that vary; files up to 2^31 bytes
/// Accuracy    number times step times unit: two roundings (tests/io/sur_test.cpp)

#include "io/readers.hpp"

#include "io/binary_numbers.hpp"
#include "io/required.hpp"
#include "io/unpack.hpp"

namespace fstiff::inline v0_1::io::detail {

namespace {

/// Content of the header.
struct SurHeader {
    bool profile{};
    bool big_endian{};
    int bits{};          // of a height: 16 or 32
    std::string object;  // its name, printable characters only
    std::string x_unit, z_unit;
    double step{};          // of the heights [m]
    bool marked{};          // missing points are marked
    int inversion{};        // 0: none
    std::size_t streams{};  // of a compressed file; 0: it is not compressed
    std::size_t skipped{};  // bytes of the comment and the private zone
    std::size_t columns{}, rows{};
    std::size_t trailer{};  // bytes after the heights
};

Record record_of(const SurHeader& file, const RawMap& map) {
    Record record;
    record.note("form", "Digital Surf " + std::string(file.streams == 0 ? "" : "compressed ") +
                            (file.profile ? "profile" : "surface") + " of " + std::to_string(file.bits) + " bits, " +
                            (file.big_endian ? "most" : "least") + " significant byte first" +
                            (file.object.empty() ? "" : ", \"" + file.object + "\""));
    record.note("units", "x in " + file.x_unit + ", heights in " + file.z_unit + ", in steps of " +
                             number_text(file.step) + " m, from the header; the offset of z is not added");
    record.note("spacing", "from the steps of x and y in the header");
    record.note_points(map, file.marked ? "" : " (the header states that none are marked)");
    if (file.skipped != 0) record.note("comment and private zone", std::to_string(file.skipped) + " bytes, not read");
    record.say_trailer(file.trailer);
    if (file.inversion != 0)
        record.warnings.push_back("the file states that its heights are inverted (code " +
                                  std::to_string(file.inversion) +
                                  "); they were read as stored, so that hills may be valleys");
    record.resolution = std::abs(file.step);
    return record;
}

bool is_sur(std::string_view bytes) { return bytes.starts_with("DIGITAL SURF") || bytes.starts_with("DSCOMPRESSED"); }

class SurReader {
public:
    SurReader(std::string_view bytes, std::string_view name, const Inflate& inflate)
        : bytes_(bytes), name_(name), inflate_(inflate) {}

    Reading read() {
        if (!is_sur(bytes_))
            refuse_file(name_,
                        {"does not begin as a file of Digital Surf; must begin with DIGITAL SURF or DSCOMPRESSED"});
        if (bytes_.size() < header_bytes)
            refuse_file(name_, {"ends after ", bytes_.size(), " bytes; its header must have ", header_bytes});
        read_header();
        RawMap map;
        const double dx = step("step of x", 120, 180, false, header_.x_unit);
        std::string y_unit;
        const double dy = header_.rows == 1 ? dx : step("step of y", 124, 196, false, y_unit);
        header_.step = step("step of z", 128, 212, true, header_.z_unit);
        read_heights(map);
        set_spacings(map, dx, dy, name_);
        Record record = record_of(header_, map);
        return {std::move(map), std::move(record)};
    }

private:
    static constexpr std::size_t header_bytes = 512;

    std::int64_t integer(std::size_t at, std::size_t size) const { return signed_at(bytes_.substr(at, size), big_); }
    std::string words(std::size_t at, std::size_t size) const {
        const std::string_view field = bytes_.substr(at, size);
        return std::string(trimmed(field.substr(0, field.find('\0'))));
    }
    void require_one_of(const std::string& field, std::int64_t value, std::initializer_list<std::int64_t> allowed,
                        std::string_view text) const {
        for (const std::int64_t one : allowed)
            if (value == one) return;
        refuse_field(name_, field, std::to_string(value), text);
    }

    void read_header() {
        const auto order = unsigned_at(bytes_.substr(12, 2), false);  // 0 and 257 are the same in both orders
        require_one_of("byte order", static_cast<std::int64_t>(order), {0, 257}, "0 or 257");
        header_.big_endian = big_ = order == 257;
        require_one_of("number of objects", integer(14, 2), {0, 1}, "1: save each object as a file of its own");
        require_one_of("type of object", integer(18, 2), {1, 2}, "1 (a profile) or 2 (a surface)");
        header_.profile = integer(18, 2) == 1;
        require_one_of("bits of a height", integer(98, 2), {16, 32}, "16 or 32");
        header_.bits = static_cast<int>(integer(98, 2));
        header_.object = printable(words(20, 30), 30);
        header_.marked = integer(86, 2) != 0;
        header_.inversion = static_cast<int>(integer(290, 2));
        const std::int64_t columns = integer(108, 4), rows = integer(112, 4);
        if (columns < 2 || rows < 1)
            refuse_field(name_, "points of a row x rows", std::to_string(columns) + " x " + std::to_string(rows),
                         "at least 2 x 1");
        header_.columns = static_cast<std::size_t>(columns);
        header_.rows = static_cast<std::size_t>(rows);
        header_.skipped = static_cast<std::size_t>(unsigned_at(bytes_.substr(334, 2), big_)) +
                          static_cast<std::size_t>(unsigned_at(bytes_.substr(336, 2), big_));
    }

    /// The step at byte \p at in the unit at byte \p unit_at [m]; a step of z may be negative.
    double step(const std::string& field, std::size_t at, std::size_t unit_at, bool negative, std::string& unit) const {
        const double value = real_at(bytes_.substr(at, 4), big_);
        if (!std::isfinite(value) || value == 0 || (value < 0 && !negative))
            refuse_field(name_, field, number_text(value), negative ? "finite and not 0" : "finite and greater than 0");
        unit = words(unit_at, 16);
        const double factor = require_length_unit(name_, "unit of the " + field, unit);
        unit = printable(unit, 16);
        return value * factor;
    }

    void read_heights(RawMap& map) {
        const std::size_t size = static_cast<std::size_t>(header_.bits) / 8;
        std::string_view rest = bytes_.substr(header_bytes);
        rest.remove_prefix((std::min)(header_.skipped, rest.size()));
        std::string inflated;
        if (bytes_.starts_with("DSCOMPRESSED")) rest = inflated = inflated_heights(rest, size);
        const std::size_t trailer = allocate_stored(map, header_.rows, header_.columns, size, rest.size(), name_);
        if (header_.streams == 0) header_.trailer = trailer;
        const std::int64_t reserved = integer(100, 4) - 2;
        for (std::size_t i = 0; i < map.heights.size(); ++i) {
            const std::int64_t number = signed_at(rest.substr(i * size, size), big_);
            map.heights[i] = header_.marked && number == reserved ? std::numeric_limits<double>::quiet_NaN()
                                                                  : static_cast<double>(number) * header_.step;
        }
    }

    /// The heights of a compressed file, of \p size bytes each.
    std::string inflated_heights(std::string_view rest, std::size_t size) {
        if (!inflate_)
            refuse_file(name_, {"is compressed, and this program was built without zlib; must be saved uncompressed"});
        const auto number = [&](std::size_t at) { return unsigned_at(rest.substr(at, 4), big_); };
        if (rest.size() < 4) refuse_file(name_, {"ends before its table of streams; must be whole"});
        const std::uint64_t streams = number(0);
        if (streams < 1 || streams > (rest.size() - 4) / 8)
            refuse_field(name_, "number of streams", std::to_string(streams),
                         "at least 1, with their table in the file");
        const std::size_t table = 4 + 8 * static_cast<std::size_t>(streams);
        std::uint64_t deflated = 0, whole = 0;
        for (std::size_t at = 4; at < table; at += 8) {
            // measured heights shrink to a half or a tenth; nothing is set aside for more
            if (number(at) > (std::uint64_t(1) << 20) && number(at) / 200 > number(at + 4))
                refuse_file(name_, {"declares a stream of ", number(at + 4), " bytes that inflates to ", number(at),
                                    "; must be at most 200 times as many"});
            whole += number(at);
            deflated += number(at + 4);
        }
        if (deflated > rest.size() - table)
            refuse_file(name_, {"declares ", deflated, " bytes of streams, but holds ", rest.size() - table,
                                "; must hold all"});
        // both below 2^31: the product fits into 64 bits
        if (whole != std::uint64_t(header_.columns) * header_.rows * size || whole > most_bytes)
            refuse_file(name_, {"declares ", header_.columns, " x ", header_.rows, " heights of ", size,
                                " bytes, but streams that inflate to ", whole, " bytes; must be as many, and at most ",
                                most_bytes});
        std::string all(static_cast<std::size_t>(whole), '\0');
        std::span<char> out(all);
        std::string_view stream = rest.substr(table);
        for (std::size_t at = 4; at < table; at += 8) {
            const auto length = static_cast<std::size_t>(number(at));
            const auto taken = static_cast<std::size_t>(number(at + 4));
            if (!inflate_(stream.substr(0, taken), out.first(length)))
                refuse_file(name_, {"has a stream ", (at - 4) / 8 + 1, " that does not inflate to the ", length,
                                    " bytes of its table; must be whole"});
            stream.remove_prefix(taken);
            out = out.subspan(length);
        }
        header_.streams = static_cast<std::size_t>(streams);
        header_.trailer = stream.size();
        return all;
    }

    std::string_view bytes_;
    std::string name_;
    const Inflate& inflate_;
    bool big_ = false;
    SurHeader header_;
};

}  // namespace

Reading read_sur(std::string_view bytes, const std::string& name, const Inflate& inflate) {
    return SurReader(bytes, name, inflate).read();
}

extern constexpr Reader sur_reader{
    .format = SurfaceFormat::sur,
    .endings = ".sur .pro",
    .holds = "Digital Surf of 16 or 32 bits, one object, compressed where fstiff was built with zlib",
    .recognised = "its first bytes, DIGITAL SURF or DSCOMPRESSED",
    .begins = is_sur,
    .read = [](std::string_view bytes, const std::string& name, const SurfaceOptions&) {
#ifdef FSTIFF_HAS_ZLIB
        return read_sur(bytes, name, inflate_zlib);
#else
        return read_sur(bytes, name);
#endif
    }};

}  // namespace fstiff::inline v0_1::io::detail
