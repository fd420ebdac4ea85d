// SPDX-License-Identifier: BSD-3-Clause
/// \file
/// Reads surface data files (SDF), text and binary.
///
/// The reader takes the versions ISO-1.0, ISO-2.0 and their forerunner BCR-1.0, with all eight data types, and files
/// with another maker for ISO, such as NIST-1.0, as ISO. It ignores the trailer; rows keep the order of the file.
/// Heights are number times Zscale. Missing points are "BAD" (or "NaN") in text, infinity in binary files, and there,
/// as in the text of BCR-1.0, the numbers that the version reserves:
///
///     type        ISO                        BCR
///     integers    least (unsigned: largest)  largest
///     reals       least, or NaN              1.7e308 (float: 3.4e38) and above, or NaN
///
/// The binary header is of 81 bytes, little-endian on every host: version (8), manufacturer (10), dates (2 x 12),
/// NumPoints and NumProfiles (2 bytes each; 4 in version 2.0), Xscale, Yscale, Zscale, Zresolution (8 each),
/// Compression, DataType, CheckType (1 each). Sizes are compared with the bytes that are there before memory is taken.
///
/// Reference   ISO 25178-71:2017 (versions 1.0, 2.0); K. J. Stout et al., EUR 15178 EN (1993) (BCR). Deviation: text
///             with a data type of integers may hold decimal fractions.
/// Units       map in m; the scales of the file are in m
/// Valid       2 points a side at least, or one profile (dy = dx where its Yscale is 0), of heights that vary; no
///             compression; files up to 2^30 bytes; the check sum is not verified
/// Accuracy    the product with Zscale is rounded once (tests/io/sdf_test.cpp)

#include "io/readers.hpp"

#include "io/binary_numbers.hpp"
#include "io/number_table.hpp"
#include "io/required.hpp"

namespace fstiff::inline v0_1::io::detail {

namespace {

/// Characters of the version that follows the first one, a maker in capitals and two digits: "ISO-1.0", "NIST-1.0"; 0
/// where there is none.
std::size_t version_length(std::string_view bytes) {
    constexpr std::size_t longest = 16;
    const std::string_view text = bytes.substr((std::min<std::size_t>)(1, bytes.size()), longest);
    const std::size_t maker = (std::min)(text.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ"), text.size());
    const std::string_view number = text.substr(maker, 4);
    const bool known = maker >= 2 && number.size() == 4 && number[0] == '-' && is_digit(number[1]) &&
                       number[2] == '.' && is_digit(number[3]);
    return known ? maker + 4 : 0;
}

/// Content of the header.
struct SdfHeader {
    std::string version;       // "ISO-1.0"
    std::string manufacturer;  // printable characters only
    bool binary{};
    int data_type{};  // 0 to 7: uint8, uint16, uint32, float32, int8, int16, int32, float64
    double z_scale{};
    bool check_sum{};  // there is one, which was not verified
    std::size_t columns{}, rows{};
    std::size_t trailer{};  // bytes after the heights
};

Record record_of(const SdfHeader& file, const RawMap& map) {
    static constexpr const char* types[8] = {"uint8", "uint16", "uint32", "float32",
                                             "int8",  "int16",  "int32",  "float64"};
    Record record;
    record.note("form", "surface data file " + file.version + ", " + (file.binary ? "binary" : "text") + ", " +
                            types[file.data_type & 7] + (file.manufacturer.empty() ? "" : ", by " + file.manufacturer));
    record.note("units", "m, heights in units of " + number_text(file.z_scale) + " m, from Zscale");
    record.note("spacing", "from Xscale and Yscale");
    record.note_points(map);
    record.say_trailer(file.trailer);
    if (file.check_sum) record.note("check sum", "not verified");
    const bool counted = file.binary && file.data_type != 3 && file.data_type != 7;
    record.resolution = counted ? file.z_scale : 0;
    return record;
}

bool is_sdf(std::string_view bytes) {
    if (bytes.size() < 8 || std::string_view("aAbB").find(bytes[0]) == std::string_view::npos) return false;
    const std::size_t length = version_length(bytes);
    const std::string_view version = bytes.substr(1, length);
    if (version == "ISO-1.0" || version == "ISO-2.0" || version == "BCR-1.0") return true;
    const bool text = bytes[0] == 'a' || bytes[0] == 'A';
    if (!text) return length == 7 && bytes.size() > 80 && (version.ends_with("1.0") || version.ends_with("2.0"));
    // another maker: what follows must be the header of this form
    const std::string head = lower_case(bytes.substr(0, 4096));
    return length > 0 && head.find("numpoints") != std::string::npos && head.find("zscale") != std::string::npos;
}

/// Whether they are of a version that may not be read.
bool may_be_sdf(std::string_view bytes) {
    return bytes.size() > 4 && (bytes.substr(1, 3) == "ISO" || bytes.substr(1, 3) == "BCR");
}

class SdfReader {
public:
    SdfReader(std::string_view bytes, std::string name) : bytes_(bytes), name_(std::move(name)) {}

    Reading read() {
        if (!is_sdf(bytes_))
            refuse_file(
                name_,
                {"begins with ", shown_cell(bytes_.substr(0, 8)),
                 "; a surface data file must begin with aISO-1.0, aISO-2.0, aBCR-1.0, the name of another maker, "
                 "or b for a"});
        header_.binary = bytes_[0] == 'b' || bytes_[0] == 'B';
        header_.version = std::string(bytes_.substr(1, version_length(bytes_)));
        bcr_ = header_.version == "BCR-1.0";
        if (header_.binary)
            read_binary();
        else
            read_text();
        set_spacings(map_, x_scale_, y_scale_, name_);
        Record record = record_of(header_, map_);
        return {std::move(map_), std::move(record)};
    }

private:
    static constexpr double missing = std::numeric_limits<double>::quiet_NaN();
    static constexpr std::size_t type_bytes[8] = {1, 2, 4, 4, 1, 2, 4, 8};
    static constexpr double largest[8] = {255, 65535, 4294967295.0, static_cast<double>(3.4e38F),
                                          127, 32767, 2147483647,   1.7e308};

    void check_header(int compression, int check_type) {
        if (header_.columns == 0 || header_.rows == 0)
            refuse_field(name_, "NumPoints x NumProfiles",
                         std::to_string(header_.columns) + " x " + std::to_string(header_.rows), "at least 2 x 1");
        require_step(name_, "Xscale", x_scale_);
        if (header_.rows > 1 || y_scale_ != 0) require_step(name_, "Yscale", y_scale_);
        require_step(name_, "Zscale", header_.z_scale);
        if (compression != 0) refuse_field(name_, "Compression", std::to_string(compression), "0 (none)");
        if (header_.data_type < 0 || header_.data_type > 7)
            refuse_field(name_, "DataType", std::to_string(header_.data_type), "between 0 and 7");
        header_.check_sum = check_type != 0;
    }

    /// Height \p index of the file is \p number, in units of Zscale.
    void set(std::size_t index, double number) {
        if (!std::isinf(number) && std::isinf(number * header_.z_scale))
            refuse_file(name_, {"height ", index + 1,
                                " is beyond the range of double precision; "
                                "allowed are finite numbers"});
        set_height(map_, index, number * header_.z_scale);
    }

    void read_binary() {
        const std::size_t count_bytes = header_.version.ends_with("2.0") ? 4 : 2;
        const std::size_t header = 42 + 2 * count_bytes + 35;
        if (bytes_.size() < header)
            refuse_file(name_, {"ends after ", bytes_.size(), " bytes; its header must have ", header});
        std::string manufacturer(trimmed(bytes_.substr(8, 10)));
        std::erase(manufacturer, '\0');
        header_.manufacturer = printable(manufacturer, 10);
        std::string_view rest = bytes_.substr(42);
        const auto count = [&] {
            const std::size_t value =
                count_bytes == 2 ? little_endian<std::uint16_t>(rest) : little_endian<std::uint32_t>(rest);
            rest.remove_prefix(count_bytes);
            return value;
        };
        header_.columns = count();
        header_.rows = count();
        x_scale_ = double_at(rest);
        y_scale_ = double_at(rest.substr(8));
        header_.z_scale = double_at(rest.substr(16));
        header_.data_type = static_cast<unsigned char>(rest[33]);
        check_header(static_cast<unsigned char>(rest[32]), static_cast<unsigned char>(rest[34]));
        rest.remove_prefix(35);

        const std::size_t size = type_bytes[header_.data_type];
        header_.trailer = allocate_stored(map_, header_.rows, header_.columns, size, rest.size(), name_);
        for (std::size_t i = 0; i < map_.heights.size(); ++i) set(i, number_at(rest.substr(i * size, size)));
    }

    double number_at(std::string_view bytes) const {
        switch (header_.data_type) {
            case 0: return height(little_endian<std::uint8_t>(bytes));
            case 1: return height(little_endian<std::uint16_t>(bytes));
            case 2: return height(little_endian<std::uint32_t>(bytes));
            case 3: return height(float_at(bytes));
            case 4: return height(static_cast<std::int8_t>(little_endian<std::uint8_t>(bytes)));
            case 5: return height(static_cast<std::int16_t>(little_endian<std::uint16_t>(bytes)));
            case 6: return height(static_cast<std::int32_t>(little_endian<std::uint32_t>(bytes)));
            default: return height(double_at(bytes));
        }
    }

    /// \p number, unless it is the one that the version reserves for missing points.
    template <class Number>
    double height(Number number) const {
        using Limits = std::numeric_limits<Number>;
        bool reserved = number == (bcr_ || !Limits::is_signed ? (Limits::max)() : Limits::lowest());
        if constexpr (!Limits::is_integer)
            reserved = std::isnan(number) ||
                       (bcr_ ? static_cast<double>(number) >= largest[sizeof(Number) == 4 ? 3 : 7] : reserved);
        return reserved ? missing : static_cast<double>(number);
    }

    /// The next line, without its end; LF, CR and CR LF end one.
    static std::string_view next_line(std::string_view& rest) {
        const std::size_t end = (std::min)(rest.find_first_of("\r\n"), rest.size());
        const std::string_view line = rest.substr(0, end);
        const bool both = rest.substr(end).starts_with("\r\n");
        rest.remove_prefix((std::min)(end + (both ? 2 : 1), rest.size()));
        return line;
    }

    /// BCR allows comments after a semicolon.
    std::string_view content(std::string_view line) const {
        return trimmed(bcr_ ? line.substr(0, line.find(';')) : line);
    }

    void read_text() {
        std::string_view rest = bytes_;
        next_line(rest);
        std::vector<std::pair<std::string, std::string_view>> fields;
        bool ended = false;
        while (!rest.empty() && !ended) {
            const std::string_view line = content(next_line(rest));
            ended = line == "*";
            const std::size_t equal = line.find('=');
            if (ended || equal == std::string_view::npos) continue;
            fields.emplace_back(lower_case(trimmed(line.substr(0, equal))), trimmed(line.substr(equal + 1)));
        }
        if (!ended) refuse_file(name_, {"has no line \"*\" that ends its header; must have one"});
        const auto field = [&](const std::string& name) {
            for (const auto& [key, value] : fields)
                if (key == lower_case(name)) return value;
            refuse_file(name_, {"states no ", name, "; must state it in its header"});
        };
        const auto number = [&](const std::string& name) { return stated_number(name_, name, field(name)); };
        const auto code = [&](const std::string& name, std::initializer_list<std::string_view> names) {
            const std::string word = lower_case(field(name));
            int index = 0;
            for (const std::string_view candidate : names) {
                if (bcr_ && word == candidate) return index;
                ++index;
            }
            const double value = bcr_ && (word == "null" || word == "none") ? 0 : number(name);
            return value >= 0 && value <= 255 && value == std::floor(value) ? static_cast<int>(value) : 255;
        };
        const auto count = [&](const std::string& name) { return require_count(name_, name, number(name)); };
        for (const auto& [key, value] : fields)
            if (key == "manufacid") header_.manufacturer += printable(value, 80);
        header_.columns = count("NumPoints");
        header_.rows = count("NumProfiles");
        x_scale_ = number("Xscale");
        y_scale_ = number("Yscale");
        header_.z_scale = number("Zscale");
        header_.data_type =
            code("DataType", {"uchar", "uinteger", "ulongint", "float", "char", "integer", "longint", "double"});
        check_header(code("Compression", {}), code("CheckType", {}));
        read_text_heights(rest);
    }

    /// The heights of a text, \p rest being what follows its header.
    void read_text_heights(std::string_view rest) {
        // every height needs two characters, the last one needs one
        const std::uint64_t points = std::uint64_t(header_.columns) * header_.rows;
        if (points > rest.size() / 2 + 1)
            refuse_file(name_, {"declares ", header_.columns, " x ", header_.rows, " heights, but has ", rest.size(),
                                " bytes of them; must hold all"});
        allocate(map_, header_.rows, header_.columns);
        std::size_t found = 0;
        std::vector<std::string_view> cells;
        bool ended = false;
        while (!rest.empty()) {
            const std::string_view line = content(next_line(rest));
            ended = line == "*";
            if (ended) break;
            split_line(line, ' ', cells);
            for (const std::string_view cell : cells) {
                if (found == points)
                    refuse_file(name_,
                                {"holds more heights than the ", points, " that it declares; must hold as many"});
                set(found, text_number(cell, found));
                ++found;
            }
        }
        if (found < points)
            refuse_file(name_, {"holds ", found, " heights; must hold the ", points, " that it declares"});
        if (!ended) refuse_file(name_, {"has no line \"*\" after its heights; must have one"});
        header_.trailer = rest.size();
    }

    double text_number(std::string_view cell, std::size_t index) {
        if (is_missing_word(cell)) return missing;
        const auto number = number_in(cell, false);
        if (!number || std::isinf(*number))
            refuse_file(name_, {"height ", index + 1, " is ", shown_cell(cell),
                                "; must be BAD or a decimal number within the range of double precision"});
        return bcr_ ? reserved(*number) : *number;
    }

    /// BCR writes missing points of a text as the largest number of their type.
    double reserved(double number) const {
        const bool real = header_.data_type == 3 || header_.data_type == 7;
        const double limit = largest[header_.data_type];
        return number == limit || (real && number > limit) ? missing : number;
    }

    std::string_view bytes_;
    std::string name_;
    bool bcr_ = false;
    double x_scale_{}, y_scale_{};
    RawMap map_;
    SdfHeader header_;
};

}  // namespace

extern constexpr Reader sdf_reader{.format = SurfaceFormat::sdf,
                                   .endings = ".sdf",
                                   .holds = "ISO 25178-71, text or binary",
                                   .recognised = "its first bytes, such as aISO-1.0 or bISO-1.0",
                                   .begins = is_sdf,
                                   .read = read_by<SdfReader>,
                                   .mark = 8,
                                   .may_begin = may_be_sdf};

}  // namespace fstiff::inline v0_1::io::detail
