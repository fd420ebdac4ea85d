// SPDX-License-Identifier: BSD-3-Clause
#include "io/sur.hpp"

#include "io/inflate.hpp"

namespace fstiff::io {

bool is_sur(std::string_view bytes) { return bytes.starts_with("DIGITAL SURF") || bytes.starts_with("DSCOMPRESSED"); }

namespace detail {

namespace {

class SurReader {
public:
    SurReader(std::string_view bytes, std::string_view name, const Inflate& inflate)
        : bytes_(bytes), name_(name), inflate_(inflate) {}

    SurSurface read() {
        if (!is_sur(bytes_))
            refuse_file(name_,
                        {"does not begin as a file of Digital Surf; must begin with DIGITAL SURF or DSCOMPRESSED"});
        if (bytes_.size() < header_bytes)
            refuse_file(name_, {"ends after ", bytes_.size(), " bytes; its header must have ", header_bytes});
        record_.name = name_;
        read_header();
        SurSurface result;
        const double dx = step("step of x", 120, 180, false, record_.x_unit);
        std::string y_unit;
        const double dy = record_.rows == 1 ? dx : step("step of y", 124, 196, false, y_unit);
        record_.step = step("step of z", 128, 212, true, record_.z_unit);
        read_heights(result.map);
        set_spacings(result.map, dx, dy, name_);
        record_.missing = static_cast<std::size_t>(result.map.size() - result.map.present());
        result.record = record_;
        return result;
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
        record_.big_endian = big_ = order == 257;
        require_one_of("number of objects", integer(14, 2), {0, 1}, "1: save each object as a file of its own");
        require_one_of("type of object", integer(18, 2), {1, 2}, "1 (a profile) or 2 (a surface)");
        record_.profile = integer(18, 2) == 1;
        require_one_of("bits of a height", integer(98, 2), {16, 32}, "16 or 32");
        record_.bits = static_cast<int>(integer(98, 2));
        record_.object = printable(words(20, 30), 30);
        record_.marked = integer(86, 2) != 0;
        record_.inversion = static_cast<int>(integer(290, 2));
        const std::int64_t columns = integer(108, 4), rows = integer(112, 4);
        if (columns < 2 || rows < 1)
            refuse_field(name_, "points of a row x rows", std::to_string(columns) + " x " + std::to_string(rows),
                         "at least 2 x 1");
        record_.columns = static_cast<std::size_t>(columns);
        record_.rows = static_cast<std::size_t>(rows);
        record_.skipped = static_cast<std::size_t>(unsigned_at(bytes_.substr(334, 2), big_)) +
                          static_cast<std::size_t>(unsigned_at(bytes_.substr(336, 2), big_));
    }

    /// The step at byte \p at in the unit at byte \p unit_at [m]; a step of z may be negative.
    double step(const std::string& field, std::size_t at, std::size_t unit_at, bool negative, std::string& unit) const {
        const double value = real_at(bytes_.substr(at, 4), big_);
        if (!std::isfinite(value) || value == 0 || (value < 0 && !negative))
            refuse_field(name_, field, number_text(value), negative ? "finite and not 0" : "finite and greater than 0");
        unit = words(unit_at, 16);
        if (!is_unit(unit, Dimension::length))
            refuse_field(name_, "unit of the " + field, shown_cell(unit),
                         "a unit of length: " + accepted_units(Dimension::length));
        const double factor = unit_factor(unit, Dimension::length);
        unit = printable(unit, 16);
        return value * factor;
    }

    void read_heights(HeightMap<double>& map) {
        const std::size_t size = static_cast<std::size_t>(record_.bits) / 8;
        std::string_view rest = bytes_.substr(header_bytes);
        rest.remove_prefix((std::min)(record_.skipped, rest.size()));
        // both below 2^31: the product fits into 64 bits
        const std::uint64_t points = std::uint64_t(record_.columns) * record_.rows;
        std::string inflated;
        if (bytes_.starts_with("DSCOMPRESSED")) rest = inflated = inflated_heights(rest, points, size);
        if (points > rest.size() / size)
            refuse_file(name_, {"declares ", record_.columns, " x ", record_.rows, " heights of ", size,
                                " bytes, but holds ", rest.size(), " bytes of them; must hold all"});
        if (record_.streams == 0) record_.trailer = rest.size() - static_cast<std::size_t>(points) * size;
        const std::int64_t reserved = integer(100, 4) - 2;
        map.heights.resize(static_cast<Eigen::Index>(record_.rows), static_cast<Eigen::Index>(record_.columns));
        for (std::size_t i = 0; i < points; ++i) {
            const std::int64_t number = signed_at(rest.substr(i * size, size), big_);
            map.heights.data()[i] = record_.marked && number == reserved ? std::numeric_limits<double>::quiet_NaN()
                                                                         : static_cast<double>(number) * record_.step;
        }
    }

    /// The heights of a compressed file, of \p size bytes each.
    std::string inflated_heights(std::string_view rest, std::uint64_t points, std::size_t size) {
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
        if (whole != points * size || whole > most_bytes)
            refuse_file(name_, {"declares ", record_.columns, " x ", record_.rows, " heights of ", size,
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
        record_.streams = static_cast<std::size_t>(streams);
        record_.trailer = stream.size();
        return all;
    }

    std::string_view bytes_;
    std::string name_;
    const Inflate& inflate_;
    bool big_ = false;
    SurRecord record_;
};

}  // namespace

}  // namespace detail

std::vector<std::string> SurRecord::sentences() const {
    std::vector<std::string> all;
    all.push_back("form: Digital Surf " + std::string(streams == 0 ? "" : "compressed ") +
                  (profile ? "profile" : "surface") + " of " + std::to_string(bits) + " bits, " +
                  (big_endian ? "most" : "least") + " significant byte first" +
                  (object.empty() ? "" : ", \"" + object + "\""));
    all.push_back("units: x in " + x_unit + ", heights in " + z_unit + ", in steps of " + detail::number_text(step) +
                  " m, from the header; the offset of z is not added");
    all.push_back("spacing: from the steps of x and y in the header");
    all.push_back("points: " + std::to_string(columns) + " x " + std::to_string(rows) + ", of which " +
                  std::to_string(missing) + " missing" + (marked ? "" : " (the header says that none are marked)"));
    if (skipped != 0) all.push_back("comment and private zone: " + std::to_string(skipped) + " bytes, not read");
    if (trailer != 0) all.push_back("trailer: " + std::to_string(trailer) + " bytes, not read");
    return all;
}

std::vector<std::string> SurRecord::warnings() const {
    if (inversion == 0) return {};
    return {"the file states that its heights are inverted (code " + std::to_string(inversion) +
            "); they were read as the numbers stand, so that hills may be valleys"};
}

Inflate inflate_where_built() {
#ifdef FSTIFF_HAS_ZLIB
    return inflate_zlib;
#else
    return {};
#endif
}

SurSurface read_sur(std::string_view bytes, std::string_view name, const Inflate& inflate) {
    return detail::SurReader(bytes, name, inflate).read();
}

}  // namespace fstiff::io
