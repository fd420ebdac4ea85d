// SPDX-License-Identifier: BSD-3-Clause
/// \file
/// Reads grids of Surfer (.grd): the text and the binary form of version 6, and the form of version 7.
///
///     DSAA   text: columns, rows, x from and to, y from and to, z from and to, then the heights
///     DSBB   columns, rows (int16), the same six numbers (float64), then the heights (float32)
///     DSRB   sections of a tag of four letters and their bytes (int32): of DSRB the version (int32), of GRID rows,
///            columns (int32), x, y of the first point, steps of x and y, z from and to, rotation, blank value
///            (float64), of DATA the heights (float64); others are left out
///
/// The least significant byte comes first. Rows follow one another from the least y on, as those of triples do. A blank
/// is 1.70141e38 and more; in a file of version 7 what equals its blank value, or from version 1 on is as large.
///
/// Reference   Golden Software, Surfer Help: Surfer 6 Text, Surfer 6 Binary and Surfer 7 Grid File Format
/// Units       map in m; SurfaceOptions::units are the file's, which states none
/// Valid       2 points a side at least, or one row; heights that vary; files up to 2^31 bytes
/// Accuracy    number times unit, rounded once (tests/io/surfer_test.cpp)

#include "io/readers.hpp"

#include "io/file_bytes.hpp"
#include "io/given_lengths.hpp"
#include "io/missing_values.hpp"

namespace fstiff::inline v0_1::io::detail {

namespace {

constexpr double surfer_blank = 1.7e38;  // 1.70141e38 is written with more digits and with fewer

bool is_surfer(std::string_view bytes) {
    return (bytes.starts_with("DSAA") && bytes.size() > 4 && is_blank(bytes[4])) || bytes.starts_with("DSBB") ||
           bytes.starts_with("DSRB");
}

class SurferReader {
public:
    SurferReader(std::string_view bytes, const std::string& name, const SurfaceOptions& options)
        : file_(bytes, name), bytes_(bytes), options_(options) {}

    Reading read() {
        if (!is_surfer(bytes_))
            refuse_file(file_.name(), {"does not begin as a grid of Surfer; must begin with DSAA, DSBB or DSRB"});
        const GivenUnits units = given_lengths(options_, file_.name(), true);
        RawMap map;
        if (bytes_.starts_with("DSAA"))
            read_text(map);
        else if (bytes_.starts_with("DSBB"))
            read_six(map);
        else
            read_seven(map);
        const std::string missing = take_heights(map.heights, units, options_, file_.name());
        set_spacings(map, require_step(file_.name(), "step of x", map.dx * units.lateral),
                     map.rows == 1 ? 0 : require_step(file_.name(), "step of y", map.dy * units.lateral), file_.name());
        Record record;
        record.note("form", "grid of Surfer " + form_);
        record.note("units", units.note());
        record.note("spacing", "from the extents of x and y over the points");
        record.note_points(map, missing);
        record.say_trailer(trailer_);
        return {std::move(map), std::move(record)};
    }

private:
    void set_steps(RawMap& map, double width, double height) const {
        map.dx = width / static_cast<double>(map.columns - 1);
        map.dy = map.rows == 1 ? 0 : height / static_cast<double>(map.rows - 1);
    }

    /// The number between blanks that the text goes on with, which is taken from it.
    double next(std::string_view what) {
        text_ = trimmed(text_);
        const std::string_view cell = text_.substr(0, text_.find_first_of(" \t\r\n"));
        const auto number = number_in(cell, false);
        if (cell.empty()) refuse_file(file_.name(), {"ends within ", what, "; must be whole"});
        if (!number || !std::isfinite(*number))
            refuse_file(file_.name(), {"has ", shown_cell(cell), " within ", what, "; must be a number"});
        text_.remove_prefix(cell.size());
        return *number;
    }
    std::size_t next_count(std::string_view what) { return require_count(file_.name(), what, next("its header")); }

    void read_text(RawMap& map) {
        form_ = "6, text";
        text_ = bytes_.substr(4);
        const std::size_t columns = next_count("columns"), rows = next_count("rows");
        double limits[6];
        for (double& limit : limits) limit = next("its header");
        allocate_text(map, rows, columns, text_.size(), file_.name());
        set_steps(map, limits[1] - limits[0], limits[3] - limits[2]);
        for (double& z : map.heights) {
            const double number = next("its heights");
            z = number >= surfer_blank ? std::numeric_limits<double>::quiet_NaN() : number;
        }
        trailer_ = trimmed(text_).size();
    }

    void read_six(RawMap& map) {
        form_ = "6, binary";
        const auto limit = [&](std::uint64_t place) { return file_.real(place, 8, "its header"); };
        const StoredGrid grid{
            .place = 56, .size = 4, .columns = file_.number(4, 2, "columns"), .rows = file_.number(6, 2, "rows")};
        read_grid(map, file_, grid, [&](std::string_view bytes) {
            const double z = real_at(bytes, false);
            return z >= surfer_blank ? std::numeric_limits<double>::quiet_NaN() : z;
        });
        set_steps(map, limit(16) - limit(8), limit(32) - limit(24));
        trailer_ = file_.size() - static_cast<std::size_t>(56 + 4 * grid.columns * grid.rows);
    }

    void read_seven(RawMap& map) {
        form_ = "7";
        std::uint64_t grid = 0, place = 0, size = 0;  // of the sections GRID and DATA, after their tags
        for (; size == 0; place += 8) {
            const std::string_view tag = file_.at(place, 8, "the tag of a section").substr(0, 4);
            const std::uint64_t bytes = file_.number(place + 4, 4, "the bytes of a section");
            (void)file_.at(place + 8, bytes, "section " + shown_cell(tag));
            if (tag == "GRID") grid = place + 8;
            if (tag == "DATA" && grid == 0)
                refuse_file(file_.name(), {"has a section DATA before its section GRID; must have GRID first"});
            if (tag == "DATA")
                size = bytes;
            else
                place += bytes;
            if (tag == "DATA" && size == 0) refuse_file(file_.name(), {"has an empty section DATA; must have heights"});
        }
        const auto limit = [&](std::uint64_t field) { return file_.real(grid + field, 8, "section GRID"); };
        const std::int64_t version = file_.integer(8, 4, "section DSRB");
        const StoredGrid heights{.place = place,
                                 .size = 8,
                                 .columns = file_.number(grid + 4, 4, "section GRID"),
                                 .rows = file_.number(grid, 4, "section GRID")};
        // both below 2^32: the product fits into 64 bits
        if (heights.columns * heights.rows != size / 8 || size % 8 != 0)
            refuse_file(file_.name(), {"declares ", heights.columns, " x ", heights.rows,
                                       " heights of 8 bytes, but has ", size, " bytes of them; must agree"});
        const double blank = limit(64);
        const MissingValues blanks{.numbers = {blank}, .words = {}, .from = "section GRID"};
        read_grid(map, file_, heights, [&](std::string_view bytes) {
            const double z = real_at(bytes, false);
            const bool is_blank = z >= surfer_blank || blanks.has(z) || (version == 1 && z >= blank);
            return is_blank ? std::numeric_limits<double>::quiet_NaN() : z;
        });
        map.dx = limit(24), map.dy = limit(32);
        trailer_ = file_.size() - static_cast<std::size_t>(place + size);
    }

    FileBytes file_;
    std::string_view bytes_, text_;
    const SurfaceOptions& options_;
    std::string form_;
    std::size_t trailer_ = 0;
};

}  // namespace

extern constexpr Reader surfer_reader{.format = SurfaceFormat::surfer,
                                      .endings = ".grd",
                                      .holds = "grid of Surfer 6, text or binary, or 7",
                                      .recognised = "its first bytes, DSAA, DSBB or DSRB",
                                      .asks_for = "--units",
                                      .options = "units missing",
                                      .begins = is_surfer,
                                      .read = read_by<SurferReader>};

}  // namespace fstiff::inline v0_1::io::detail
