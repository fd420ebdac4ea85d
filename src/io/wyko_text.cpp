// SPDX-License-Identifier: BSD-3-Clause
/// \file
/// Reads the text that Wyko and Bruker Vision export ("Wyko ASCII").
///
///     Wyko ASCII Data File Format 0 U 1     U: heights in waves (0) or in nm (1)
///     X Size 640, Y Size 480                counts of points, not lengths
///     Block Name, Type, Length, Value       of the blocks that follow, one a line
///     RAW_DATA 3 4915200                    the heights follow, a line for each x; "Bad" where missing
///
/// The step along x is Pixel_size [mm], along y Pixel_size times Aspect; a height in waves is number times Wavelength
/// [nm] over Mult. A line of the file is a row of the map, along which y grows; where the lines are as many as Y Size
/// and as long as X Size, x does. Other arrays, such as intensities, are named and left out.
///
/// Reference   files as the open readers of Gwyddion and SurfaceTopography describe them
/// Units       map in m
/// Valid       2 points a side at least, of heights that vary; lines up to 2^20 characters, files up to 2^31
/// Accuracy    number times step, rounded twice (tests/io/wyko_text_test.cpp)

#include "io/given_lengths.hpp"
#include "io/map_text.hpp"

#include "io/required.hpp"
#include "io/text_blocks.hpp"

namespace fstiff::inline v0_1::io {

bool is_wyko_text(std::string_view line) { return line.starts_with("Wyko ASCII Data File"); }

namespace detail {

namespace {

/// A line above the heights: "Pixel_size 7 4 0.002", "X Size 60".
struct WykoBlock {
    std::string name;
    std::string_view type, value;
    std::size_t line{};
};

class WykoTextReader {
public:
    WykoTextReader(const std::vector<Line>& lines, const std::string& name) : lines_(lines), name_(name) {}

    Reading read() {
        read_header();
        const std::size_t nx = count("X Size"), ny = count("Y Size");
        RawMap map;
        read_heights(map, nx, ny);
        const double pixel = number("Pixel_size", {}) * 1e-3, aspect = number("Aspect", 1);
        const bool along_x = map.columns == nx && nx != ny;
        set_spacings(map, along_x ? pixel : pixel * aspect, along_x ? pixel * aspect : pixel, name_);
        Record record;
        record.note("form", "Wyko ASCII, array " + shown_cell(array_));
        record.note("units", waves_ ? "heights in waves of " + number_text(number("Wavelength", {})) + " nm over " +
                                          number_text(number("Mult", 1)) + ", from Wavelength and Mult"
                                    : "heights in nm, from line 1");
        record.note("spacing", "from Pixel_size, in mm, and Aspect; a line of the file is along " +
                                   std::string(along_x ? "x" : "y"));
        record.note_points(map);
        if (!others_.empty()) record.note("other arrays", others_ + ", not read");
        return {std::move(map), std::move(record)};
    }

private:
    static std::optional<double> number_of(std::string_view cell) {
        const auto number = number_in(cell, false);
        return number ? number : number_in(cell, true);
    }

    /// The words before the first number of \p line are a name, what follows a type, a length and a value.
    WykoBlock block_of(const Line& line) {
        WykoBlock block{.name = {}, .type = {}, .value = {}, .line = line.number};
        split_line(line.text, ' ', cells_);
        std::size_t first = 1;
        while (first < cells_.size() && !number_of(cells_[first])) ++first;
        for (std::size_t i = 0; i < (std::min)(first, cells_.size()); ++i)
            block.name += (i == 0 ? "" : " ") + std::string(cells_[i]);
        const std::size_t left = cells_.size() - (std::min)(first, cells_.size());
        if (left == 1) block.value = cells_[first];
        if (left > 1) block.type = cells_[first];
        if (left > 2) block.value = cells_[first + 2];
        return block;
    }

    /// The lines up to the array of heights.
    void read_header() {
        split_line(lines_.front().text, ' ', cells_);
        const std::string_view flag = cells_.size() > 6 ? cells_[6] : std::string_view();
        if (flag != "0" && flag != "1")
            refuse_line(name_, lines_.front().number,
                        {"states the units of the heights as ", shown_cell(flag), "; must be 0 (waves) or 1 (nm)"});
        waves_ = flag == "0";
        for (next_ = 1; next_ < lines_.size(); ++next_) {
            WykoBlock block = block_of(lines_[next_]);
            if (block.type != "3") {
                blocks_.push_back(std::move(block));
            } else if (block.name == "RAW_DATA" || block.name == "OPD" || block.name == "Raw" ||
                       block.name == "SAMPLE_DATA") {
                array_ = block.name;
                ++next_;
                return;
            } else {
                next_ = end_of_array(next_, block.name);
            }
        }
        refuse_file(name_, {"has no array of heights; must have RAW_DATA, OPD, Raw or SAMPLE_DATA"});
    }

    bool is_row(std::size_t i) {
        split_line(lines_[i].text, ' ', cells_);
        return std::all_of(cells_.begin(), cells_.end(),
                           [](std::string_view cell) { return number_of(cell) || is_missing_word(cell); });
    }
    /// The last line of the array that is \p called in line \p i, which is left out.
    std::size_t end_of_array(std::size_t i, const std::string& called) {
        others_ += (others_.empty() ? "" : ", ") + printable(called, 40);
        while (i + 1 < lines_.size() && is_row(i + 1)) ++i;
        return i;
    }

    /// The number in the block \p called, greater than 0; \p otherwise where there is none.
    double number(std::string_view called, std::optional<double> otherwise) const {
        for (const WykoBlock& block : blocks_) {
            if (block.name != called) continue;
            const auto value = number_of(block.value);
            if (!value || !(*value > 0) || !std::isfinite(*value))
                refuse_line(name_, block.line,
                            {called, " ", shown_cell(block.value), "; must be a number greater than 0"});
            return *value;
        }
        if (!otherwise) refuse_file(name_, {"states no ", called, "; must state it above its heights"});
        return *otherwise;
    }
    std::size_t count(std::string_view called) const { return require_count(name_, called, number(called, {})); }

    void read_heights(RawMap& map, std::size_t nx, std::size_t ny) {
        const double unit = waves_ ? number("Wavelength", {}) * 1e-9 / number("Mult", 1) : 1e-9;
        for (std::size_t i = next_; i < lines_.size(); ++i) {
            if (!is_row(i)) {
                const WykoBlock block = block_of(lines_[i]);
                if (block.type != "3" || map.heights.size() < nx)
                    refuse_line(name_, lines_[i].number,
                                {shown_cell(lines_[i].text), " is no row of heights; must be numbers, or Bad"});
                i = end_of_array(i, block.name);
                continue;
            }
            if (map.columns == 0) map.columns = cells_.size();
            for (const std::string_view cell : cells_)
                map.heights.push_back(is_missing_word(cell) ? std::numeric_limits<double>::quiet_NaN()
                                                            : *number_of(cell) * unit);
        }
        if (map.heights.size() / nx != ny || map.heights.size() % nx != 0)
            refuse_file(name_, {"states ", nx, " x ", ny, " points, but holds ", map.heights.size(), "; must agree"});
        map.columns = map.columns == nx ? nx : ny;  // a line may be broken
        map.rows = nx * ny / map.columns;
        if (nx == ny) map.columns = map.rows = nx;
    }

    const std::vector<Line>& lines_;
    const std::string& name_;
    std::vector<WykoBlock> blocks_;
    std::string array_, others_;
    bool waves_ = false;
    std::size_t next_ = 0;  // of the lines
    std::vector<std::string_view> cells_;
};

}  // namespace

}  // namespace detail

Reading read_wyko_text(std::vector<detail::Line> lines, const std::string& name, const SurfaceOptions& options) {
    using namespace detail;
    if (!options.units.empty() || gives_size(options))
        refuse_file(name, {"is Wyko ASCII, which states its units and steps; units, dx, dy, width and height must not "
                           "be given"});
    std::vector<TextBlock> files;  // exports one after the other
    for (const Line& line : lines) {
        if (is_wyko_text(line.text)) files.push_back({.table = {}, .line = line.number, .unit = "nm"});
        files.back().table.lines.push_back(line);
    }
    const ChosenBlock chosen = chosen_block(std::move(files), name, options);
    Reading found = WykoTextReader(chosen.block.table.lines, name).read();
    note_channels(found.record, chosen);
    return found;
}

}  // namespace fstiff::inline v0_1::io
