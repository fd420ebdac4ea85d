// SPDX-License-Identifier: BSD-3-Clause
/// \file
/// Reads the text that MetroPro and Mx of Zygo export ("Zygo ASCII").
///
/// A header of lines at fixed places, a line "#", the intensities, "#", the heights row after row, "#". Fields of the
/// header that are used, by line and place from 1:
///
///     1  "Zygo ASCII Data File - Format 2"          8  2 scale factor S   3 wavelength lambda [m]
///     4  3 columns   4 rows of the heights             5 obliquity factor O   7 step of x and y [m]
///     7  "part"                                    11  1 phase resolution   8 sign: 0, or turned over
///
///     height = count S O lambda / R                as of the binary form (io/zygo_step.hpp)
///
/// Reference   layout as in the open readers and writers of prysm (MIT licence) and the Superflat evaluation toolkit
/// Units       map in m, rows from the top
/// Valid       2 points a side at least, or one row; heights that vary; files with a step of x and y
/// Accuracy    five roundings (tests/io/zygo_test.cpp)

#include "io/readers.hpp"

#include "io/zygo_step.hpp"

namespace fstiff::inline v0_1::io::detail {

namespace {

bool is_zygo(std::string_view bytes) { return bytes.starts_with("Zygo ASCII Data File"); }

class ZygoReader {
public:
    ZygoReader(std::string_view bytes, const std::string& name) : rest_(bytes), name_(name) {}

    Reading read() {
        if (!is_zygo(rest_)) refuse_file(name_, {"does not begin as Zygo ASCII; must begin with its name"});
        read_header();
        const double step = height_step(), lateral = positive(8, 7, "step of x and y");
        const std::size_t columns = count(4, 3, "columns"), rows = count(4, 4, "rows");
        (void)block("the intensities");
        RawMap map;
        read_heights(map, block("the heights"), rows, columns, step);
        set_spacings(map, lateral, lateral, name_);
        Record record = record_of(map, step);
        return {std::move(map), std::move(record)};
    }

private:
    static constexpr std::size_t least_lines = 12, most_lines = 20;  // of the header

    /// The lines up to the first "#".
    void read_header() {
        for (;;) {
            const std::size_t end = rest_.find('\n');
            if (end == std::string_view::npos || header_.size() == most_lines)
                refuse_file(name_, {"has no line # after its header; must have one within ", most_lines, " lines"});
            header_.push_back(trimmed(rest_.substr(0, end)));
            rest_.remove_prefix(end + 1);
            if (header_.back() == "#") break;
        }
        if (header_.size() <= least_lines)
            refuse_line(name_, header_.size(),
                        {"is the end of the header; must come after ", least_lines, " lines of it at least"});
    }

    /// What blanks enclose at \p place of \p line, both counted from 1.
    std::string_view field(std::size_t line, std::size_t place) const {
        std::string_view text = header_[line - 1];
        while (--place > 0) text = trimmed(text.substr((std::min)(text.find_first_of(" \t"), text.size())));
        return text.substr(0, text.find_first_of(" \t"));
    }
    double number(std::size_t line, std::size_t place, std::string_view what) const {
        const auto value = number_in(field(line, place), false);
        if (!value || !std::isfinite(*value))
            refuse_line(name_, line, {what, " ", shown_cell(field(line, place)), " is no number; must be one"});
        return *value;
    }
    double positive(std::size_t line, std::size_t place, const std::string& what) const {
        return require_step(name_, what, number(line, place, what));
    }
    std::size_t count(std::size_t line, std::size_t place, std::string_view what) const {
        return require_count(name_, what, number(line, place, what));
    }

    /// Value of one count, with its sign [m].
    double height_step() const {
        const double wavelength = positive(8, 3, "wavelength");
        if (wavelength < 1e-7 || wavelength > 1e-4)  // programs write it in um, and heights of kilometres would follow
            refuse_field(name_, "wavelength", number_text(wavelength), "in m, from 1e-7 to 1e-4");
        const double step =
            zygo_step(name_, positive(8, 2, "scale factor of the interferometer"), positive(8, 5, "obliquity factor"),
                      wavelength, number(11, 1, "phase resolution"));
        return number(11, 8, "sign") == 0 ? step : -step;
    }

    /// The numbers before the next "#".
    std::string_view block(std::string_view what) {
        const std::size_t end = rest_.find('#');
        if (end == std::string_view::npos) refuse_file(name_, {"has no line # after ", what, "; must be whole"});
        const std::string_view numbers = rest_.substr(0, end);
        rest_.remove_prefix(end + 1);
        return numbers;
    }

    void read_heights(RawMap& map, std::string_view text, std::size_t rows, std::size_t columns, double step) {
        allocate_text(map, rows, columns, text.size(), name_);
        std::size_t points = 0;
        for (text = trimmed(text); !text.empty(); text = trimmed(text), ++points) {
            const std::string_view cell = text.substr(0, text.find_first_of(" \t\r\n"));
            text.remove_prefix(cell.size());
            const auto height = number_in(cell, false);
            if (!height) refuse_file(name_, {"height ", points + 1, " is ", shown_cell(cell), "; must be a number"});
            if (points < map.heights.size()) map.heights[points] = zygo_height(*height, step);
        }
        if (points != map.heights.size())
            refuse_file(name_, {"declares ", columns, " x ", rows, " heights, but holds ", points, "; must agree"});
    }

    Record record_of(const RawMap& map, double step) const {
        Record record;
        const std::string_view quoted = header_[6];
        const std::string part(trimmed(quoted.substr(quoted.starts_with('"'), quoted.find_last_of('"') - 1)));
        record.note("form", "Zygo ASCII" + (part.empty() ? "" : ", part " + shown_cell(part)));
        note_zygo_step(record, step);
        record.note("spacing", "from the step of x and y in line 8");
        record.note_points(map);
        record.say_trailer(trimmed(rest_).size());
        return record;
    }

    std::string_view rest_;
    const std::string& name_;
    std::vector<std::string_view> header_;
};

}  // namespace

extern constexpr Reader zygo_reader{.format = SurfaceFormat::zygo,
                                    .endings = ".asc",
                                    .holds = "text of Zygo MetroPro and Mx, Zygo ASCII",
                                    .recognised = "its first words, Zygo ASCII Data File",
                                    .begins = is_zygo,
                                    .read = read_by<ZygoReader>};

}  // namespace fstiff::inline v0_1::io::detail
