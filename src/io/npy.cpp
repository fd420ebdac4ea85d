// SPDX-License-Identifier: BSD-3-Clause
/// \file
/// Reads an array of NumPy (.npy): one dimension is a profile, two are a map, whose rows are the first index.
///
/// A magic string, the version (2 bytes), the length of the header (2 bytes, 4 from version 2.0, least significant
/// first), the header, a dictionary such as {'descr': '<f8', 'fortran_order': False, 'shape': (3, 4), }, and the
/// numbers. The reader takes integers (i1, i2, i4, i8, u1, u2, u4, u8) and floating-point numbers (f4, f8) of either
/// byte order, in the order of C or of Fortran. The file holds neither units nor steps: they are given. NaN is a
/// missing point, and so are the numbers that the options name. Sizes are compared with the bytes that are there before
/// memory is taken.
///
/// Reference   NumPy manual, numpy.lib.format (format versions 1.0, 2.0, 3.0)
/// Units       map in m; SurfaceOptions::units are the file's
/// Valid       2 points a side at least, or one row; heights that vary; files up to 2^31 bytes
/// Accuracy    number times unit, rounded once (tests/io/npy_test.cpp)

#include "io/readers.hpp"

#include "io/binary_numbers.hpp"
#include "io/given_lengths.hpp"
#include "io/lines.hpp"

namespace fstiff::inline v0_1::io::detail {

namespace {

/// Content of the header.
struct NpyHeader {
    std::string type;  // as NumPy writes it: "<f8"
    bool fortran_order{};
    std::size_t columns{}, rows{};
    std::string missing_note;  // of the numbers that mark missing points
    std::string unit;          // of the heights
    std::string size_from;     // where the spacings come from
    std::size_t trailer{};     // bytes after the heights
    double resolution{};       // step in which integers count [m]; 0 of floating-point numbers
};

Record record_of(const NpyHeader& file, const RawMap& map) {
    Record record;
    record.note("form", "NumPy array of " + file.type + ", in the order of " + (file.fortran_order ? "Fortran" : "C"));
    record.note("units", "heights in " + file.unit + ", from options");
    record.note("spacing", "from " + file.size_from);
    record.note_points(map, file.missing_note);
    record.say_trailer(file.trailer);
    record.resolution = file.resolution;
    return record;
}

bool is_npy(std::string_view bytes) { return bytes.starts_with("\x93NUMPY"); }

class NpyReader {
public:
    NpyReader(std::string_view bytes, std::string_view name, const SurfaceOptions& options)
        : rest_(bytes), name_(name), options_(options) {}

    Reading read() {
        if (!is_npy(rest_)) refuse_file(name_, {"does not begin as an array of NumPy; must begin with \\x93NUMPY"});
        read_header(header());
        check_type();
        check_shape();
        RawMap map;
        const GivenSteps steps = given_steps_of(header_.rows, header_.columns, options_, name_);
        const GivenUnits units = given_lengths(options_, name_, false);
        read_heights(map);
        header_.unit = units.heights;
        header_.size_from = steps.from;
        header_.missing_note = take_heights(map.heights, units, options_, name_);
        set_spacings(map, steps.dx, steps.dy, name_);
        if (type_ != 'f') header_.resolution = units.vertical;
        Record record = record_of(header_, map);
        return {std::move(map), std::move(record)};
    }

private:
    /// The text of the header; the numbers are the rest.
    std::string_view header() {
        const auto cut_short = [&] { refuse_file(name_, {"ends in its header; must have all of it"}); };
        if (rest_.size() < 8) cut_short();
        const int version = static_cast<unsigned char>(rest_[6]);
        if (version < 1 || version > 3) refuse_field(name_, "version", std::to_string(version), "1, 2 or 3");
        const std::size_t width = version == 1 ? 2 : 4;
        if (rest_.size() < 8 + width) cut_short();
        const auto length = static_cast<std::size_t>(unsigned_at(rest_.substr(8, width), false));
        if (rest_.size() - 8 - width < length) cut_short();
        const std::string_view text = rest_.substr(8 + width, length);
        rest_.remove_prefix(8 + width + length);
        return text;
    }

    [[noreturn]] void refuse_header(std::string_view at) const {
        refuse_file(name_, {"has a header that goes wrong at ", shown_cell(at),
                            "; must be such as {'descr': '<f8', 'fortran_order': False, 'shape': (3, 4), }, of plain "
                            "numbers and not of records"});
    }

    /// The dictionary of Python, in any order of its keys.
    void read_header(std::string_view text) {
        const auto next = [&] { return (text = trimmed(text)).empty() ? '\0' : text.front(); };
        const auto expect = [&](char sign) {
            if (next() != sign) refuse_header(text);
            text.remove_prefix(1);
        };
        const auto quoted = [&] {
            const char quote = next();
            const std::size_t end = quote == '\'' || quote == '"' ? text.find(quote, 1) : std::string_view::npos;
            if (end == std::string_view::npos) refuse_header(text);
            const std::string_view inner = text.substr(1, end - 1);
            text.remove_prefix(end + 1);
            return inner;
        };
        bool ordered = false, shaped = false;
        expect('{');
        while (next() != '}') {
            const std::string_view key = quoted();
            expect(':');
            if (key == "descr") {
                header_.type = printable(quoted(), 20);
            } else if (key == "fortran_order") {
                next();
                header_.fortran_order = text.starts_with("True");
                if (!header_.fortran_order && !text.starts_with("False")) refuse_header(text);
                text.remove_prefix(header_.fortran_order ? 4 : 5);
                ordered = true;
            } else if (key == "shape") {
                expect('(');
                shape_.clear();
                for (; next() != ')'; next() == ',' ? text.remove_prefix(1) : void()) shape_.push_back(count(text));
                expect(')');
                shaped = true;
            } else {
                refuse_header(key);
            }
            if (next() == ',') text.remove_prefix(1);
        }
        if (header_.type.empty() || !ordered || !shaped)
            refuse_file(name_, {"has a header without descr, fortran_order or shape; must have all three"});
    }

    /// The whole number that \p text begins with, which is taken from it; below 2^32.
    std::size_t count(std::string_view& text) const {
        std::uint64_t value = 0;
        std::size_t digits = 0;
        for (; digits < text.size() && is_digit(text[digits]) && value < std::uint64_t(1) << 32; ++digits)
            value = 10 * value + static_cast<std::uint64_t>(text[digits] - '0');
        if (digits == 0 || value >= std::uint64_t(1) << 32) refuse_header(text);
        text.remove_prefix(digits);
        if (text.starts_with('L')) text.remove_prefix(1);  // Python 2
        return static_cast<std::size_t>(value);
    }

    void check_type() {
        const std::string_view type = header_.type;
        const bool known =
            type.size() == 3 && std::string_view("<>|").find(type[0]) != std::string_view::npos &&
            (type.substr(1) == "f4" || type.substr(1) == "f8" ||
             ((type[1] == 'i' || type[1] == 'u') && std::string_view("1248").find(type[2]) != std::string_view::npos));
        if (!known || (type[0] == '|' && type[2] != '1'))
            refuse_field(name_, "descr", shown_cell(type),
                         "f4, f8, i1, i2, i4, i8, u1, u2, u4 or u8 after < or > (or | before i1 and u1)");
        big_ = type[0] == '>';
        type_ = type[1];
        size_ = static_cast<std::size_t>(type[2] - '0');
    }

    void check_shape() {
        if (shape_.empty() || shape_.size() > 2)
            refuse_file(name_, {"has ", shape_.size(), " dimensions; must have 1 (a profile) or 2 (a map)"});
        header_.rows = shape_.size() == 1 ? 1 : shape_[0];
        header_.columns = shape_.back();
        if (header_.columns == 1) std::swap(header_.rows, header_.columns);  // one column is a profile too
        if (header_.rows == 0 || header_.columns < 2)
            refuse_field(name_, "shape", std::to_string(header_.rows) + " x " + std::to_string(header_.columns),
                         "at least 2 numbers");
        // both below 2^32: the product fits into 64 bits
        const std::uint64_t points = std::uint64_t(header_.rows) * header_.columns;
        if (points > rest_.size() / size_)
            refuse_file(name_, {"declares ", header_.rows, " x ", header_.columns, " numbers of ", size_,
                                " bytes, but holds ", rest_.size(), " bytes of them; must hold all"});
        header_.trailer = rest_.size() - static_cast<std::size_t>(points) * size_;
    }

    double number(std::size_t index) const { return value_at(rest_.substr(index * size_, size_), type_, big_); }

    void read_heights(RawMap& map) {
        const std::size_t rows = header_.rows, columns = header_.columns;
        allocate(map, rows, columns);
        for (std::size_t row = 0; row < rows; ++row)
            for (std::size_t column = 0; column < columns; ++column)
                set_height(map, row * columns + column,
                           number(header_.fortran_order ? column * rows + row : row * columns + column));
    }

    std::string_view rest_;
    std::string name_;
    const SurfaceOptions& options_;
    NpyHeader header_;
    std::vector<std::size_t> shape_;
    bool big_ = false;
    char type_ = 'f';
    std::size_t size_ = 8;
};

}  // namespace

extern constexpr Reader npy_reader{
    .format = SurfaceFormat::npy,
    .endings = ".npy",
    .holds = "NumPy array of integers or floating point: one dimension is a profile, two are a map",
    .recognised = "its first bytes, \\x93NUMPY",
    .asks_for = "--units, and --spacing, or of a map --dx and --dy or --width and --height",
    .options = "units spacing dx dy width height missing",
    .begins = is_npy,
    .read = read_by<NpyReader>};

}  // namespace fstiff::inline v0_1::io::detail
