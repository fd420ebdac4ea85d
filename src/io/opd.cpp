// SPDX-License-Identifier: BSD-3-Clause
/// \file
/// Reads maps of Wyko and Bruker Vision (.opd).
///
/// Two bytes (1, 0) and a directory of 24 bytes a block, the first of which is the directory itself; the blocks follow
/// in that order. The least significant byte comes first.
///
///     0   name (16 characters)      18  bytes of the block (int32; nothing follows where it is below 1)
///     16  type (int16)              22  attribute (uint16)
///
/// A block of type 3 is an array: columns, rows, bytes of a number (uint16), then the numbers column after column, each
/// from the bottom: int16 or float32. The first of the arrays RAW_DATA, "RAW DATA", OPD, Raw and SAMPLE_DATA is read,
/// with the blocks
///
///     Wavelength lambda [nm], Mult M (1 where there is none), Pixel_size dx [mm], Aspect a (1 where there is none)
///
///     height = number lambda / M,     dy = a dx
///
/// Missing points are int16 of 32766 and more, float32 of 1e38 and more, and NaN.
///
/// Reference   layout as in SurfaceTopography 1.27.1 (MIT licence), whose maps of three measured files are the same
/// Units       map in m, rows from the top
/// Valid       2 points a side at least, or one row; heights that vary
/// Accuracy    five roundings, and those of float32 in the file (tests/io/opd_test.cpp)

#include "io/readers.hpp"

#include "io/file_bytes.hpp"

namespace fstiff::inline v0_1::io::detail {

namespace {

constexpr std::string_view opd_heights[] = {"RAW_DATA", "RAW DATA", "OPD", "Raw", "SAMPLE_DATA"};

/// A block by its entry in the directory.
struct OpdBlock {
    std::string name;
    std::int64_t type{};
    std::uint64_t place{}, size{};
};

/// Content of the file.
struct OpdHeader {
    std::string array;                // that was read
    std::vector<std::string> others;  // arrays that were not
    std::string title;                // printable characters only
    std::size_t bits{};
    double step{};  // of the heights [m]
};

Record record_of(const OpdHeader& file, const RawMap& map) {
    Record record;
    record.note("form", "Wyko or Bruker Vision (.opd), array " + shown_cell(file.array) + " of " +
                            std::to_string(file.bits) + " bits" +
                            (file.title.empty() ? "" : ", \"" + file.title + "\""));
    std::string others;
    for (const std::string& other : file.others) others += (others.empty() ? "" : ", ") + shown_cell(other);
    if (!others.empty()) record.note("other arrays", others + ", not read");
    record.note("units", "heights in units of " + number_text(file.step) + " m, from Wavelength and Mult");
    record.note("spacing", "from Pixel_size and Aspect");
    record.note_points(map);
    record.resolution = file.bits == 16 ? file.step : 0;
    return record;
}

bool is_opd(std::string_view bytes) { return bytes.starts_with(std::string_view("\x01\0Directory", 11)); }

class OpdReader {
public:
    OpdReader(std::string_view bytes, std::string_view name) : file_(bytes, std::string(name)) {}

    Reading read() {
        if (!is_opd(file_.at(0, file_.size(), "the file")))
            refuse_file(file_.name(), {"does not begin as a file of Wyko Vision; must begin with its directory"});
        read_directory();
        const OpdBlock& array = heights();
        if (const OpdBlock* const title = find("Title"))
            header_.title =
                printable(file_.words(title->place, (std::min<std::uint64_t>)(title->size, 80), "Title"), 80);
        const double mult = number_of("Mult", 1);
        header_.step = require_step(file_.name(), "Wavelength / Mult", number_of("Wavelength", 0) / mult) * 1e-9;
        const double dx = number_of("Pixel_size", 0) * 1e-3;
        const double dy = dx * number_of("Aspect", 1);
        RawMap map;
        read_heights(map, array);
        set_spacings(map, require_step(file_.name(), "Pixel_size", dx),
                     require_step(file_.name(), "Pixel_size times Aspect", dy), file_.name());
        Record record = record_of(header_, map);
        return {std::move(map), std::move(record)};
    }

private:
    static constexpr std::uint64_t entry_bytes = 24;

    OpdBlock block_at(std::uint64_t entry) const {
        const std::int64_t size = file_.integer(entry + 18, 4, "the directory");
        return {std::string(file_.words(entry, 16, "the directory")), file_.integer(entry + 16, 2, "the directory"), 0,
                size < 1 ? 0 : static_cast<std::uint64_t>(size)};
    }
    void read_directory() {
        const std::uint64_t size = block_at(2).size;
        if (size < entry_bytes || size % entry_bytes != 0)
            refuse_field(file_.name(), "bytes of the directory", std::to_string(size), "a multiple of 24");
        (void)file_.at(2, size, "the directory");
        std::uint64_t place = 2 + size;
        for (std::uint64_t entry = 2 + entry_bytes; entry < 2 + size; entry += entry_bytes) {
            OpdBlock block = block_at(entry);
            block.place = place;
            place += block.size;
            if (!block.name.empty()) blocks_.push_back(std::move(block));
        }
    }
    const OpdBlock* find(std::string_view name) const {
        for (const OpdBlock& block : blocks_)
            if (block.name == name && block.size > 0) return &block;
        return nullptr;
    }

    /// The number in block \p name, of whatever type; \p otherwise when there is none.
    double number_of(const std::string& name, double otherwise) const {
        const OpdBlock* const block = find(name);
        if (!block) {
            if (otherwise == 0) refuse_file(file_.name(), {"has no block ", name, "; must have one"});
            return otherwise;
        }
        const std::size_t size = block->size >= 8 ? 8 : block->size >= 4 ? 4 : 2;
        if (block->type == 8) return require_step(file_.name(), name, file_.real(block->place, 8, name));
        if (block->type == 7 && size >= 4) return require_step(file_.name(), name, file_.real(block->place, 4, name));
        if (block->type != 6 && block->type != 7 && block->type != 12)
            refuse_field(file_.name(), "type of block " + name, std::to_string(block->type), "6, 7, 8 or 12 (numbers)");
        return require_step(file_.name(), name,
                            static_cast<double>(file_.integer(block->place, (std::min<std::size_t>)(size, 4), name)));
    }

    /// The array of heights; the names of all other arrays are kept.
    const OpdBlock& heights() {
        const OpdBlock* chosen = nullptr;
        for (const std::string_view name : opd_heights)
            if (const OpdBlock* const block = find(name); block && block->type == 3 && !chosen) chosen = block;
        for (const OpdBlock& block : blocks_)
            if (block.type == 3 && block.size > 0 && &block != chosen) header_.others.push_back(block.name);
        if (!chosen)
            refuse_file(file_.name(), {"has no array of heights; must have RAW_DATA, OPD, Raw or SAMPLE_DATA"});
        header_.array = chosen->name;
        return *chosen;
    }

    void read_heights(RawMap& map, const OpdBlock& array) {
        const std::uint64_t columns = file_.number(array.place, 2, "columns");
        const std::uint64_t rows = file_.number(array.place + 2, 2, "rows");
        const std::uint64_t size = file_.number(array.place + 4, 2, "bytes of a height");
        if (size != 2 && size != 4) refuse_field(file_.name(), "bytes of a height", std::to_string(size), "2 or 4");
        header_.bits = static_cast<std::size_t>(8 * size);
        if (6 + size * columns * rows > array.size)
            refuse_file(file_.name(), {"declares ", columns, " x ", rows, " heights of ", size, " bytes in a block of ",
                                       array.size, "; must hold all"});
        const std::string_view heights =
            stored_heights(file_, {array.place + 6, static_cast<std::size_t>(size), columns, rows, 0});
        allocate(map, static_cast<std::size_t>(rows), static_cast<std::size_t>(columns));
        for (std::size_t i = 0; i < map.heights.size(); ++i) {
            const std::string_view bytes = heights.substr(i * size, static_cast<std::size_t>(size));
            const double number = size == 2 ? static_cast<double>(signed_at(bytes, false)) : real_at(bytes, false);
            const bool missing = !(number < (size == 2 ? 32766 : static_cast<double>(1e38F)));
            const std::size_t row = map.rows - 1 - i % map.rows, column = i / map.rows;
            set_height(map, row * map.columns + column,
                       missing ? std::numeric_limits<double>::quiet_NaN() : number * header_.step);
        }
    }

    FileBytes file_;
    std::vector<OpdBlock> blocks_;
    OpdHeader header_;
};

}  // namespace

extern constexpr Reader opd_reader{.format = SurfaceFormat::opd,
                                   .endings = ".opd",
                                   .holds = "map of Wyko and Bruker Vision",
                                   .recognised = "its first bytes",
                                   .begins = is_opd,
                                   .read = read_by<OpdReader>};

}  // namespace fstiff::inline v0_1::io::detail
