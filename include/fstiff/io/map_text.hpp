// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Reads a height map from delimited text, and records every decision it took about the file.
///
/// Two forms. A *matrix* has a row of the map a line, its size and units in a header of "key: value" or "key = value"
/// lines, with or without a comment sign: Gwyddion's "# Width: 10 um", "# Height: 5 um", "# Value units: m"; "dx",
/// "pixel size" and the like; "h=305 w=75" is compared with what is there; heights in another unit (rad) need a
/// "height conversion factor (-> m)". *Triples* have x, y and z a line, in any order of the points; the grid is
/// recovered from the coordinates, x and y rise in the map, and points that are not there are missing.
/// Three columns are triples where x and y form a grid, a matrix where the header states a size; otherwise the form
/// must be given. Missing points are empty cells, "nan" or "BAD". Rows of a matrix keep the order of the file.
///
/// Nothing is guessed: without units, without a physical size, or with points off the grid, the file is refused.
///
///     dx = width / columns,    dy = height / rows               a point stands for a cell, as in Gwyddion
///
/// Units       map in m; MapTextOptions::units are the file's
/// Valid       2 points a side at least, of heights that vary; lines up to 2^20 characters, files up to 2^30
/// Accuracy    heights and a stated pitch within 1 ulp of the printed number (tests/io/map_text_test.cpp)

#include <fstiff/io/text_table.hpp>
#include <fstiff/topography/height_map.hpp>

namespace fstiff::io {

enum class MapForm { automatic, triples, matrix };

struct MapTextOptions {
    MapForm form = MapForm::automatic;
    std::optional<double> dx{}, dy{};         ///< of a matrix, between points [m]; replace the header's
    std::optional<double> width{}, height{};  ///< of a matrix, columns dx and rows dy [m]; replace the header's
    std::string units{};                      ///< "um,nm" (x and y, heights), "um,um,nm" or "um" (all)
};

/// What was decided about a file, and why.
struct MapTextRecord {
    std::string name;
    MapForm form{};
    std::string form_from;  ///< why it is triples, or a matrix
    std::string separator;  ///< "comma", "semicolon", "tab" or "blanks"
    bool decimal_comma{};
    std::size_t lines{};
    std::size_t header_lines{};  ///< before the first row of numbers
    std::string units;           ///< of x and y (where the file needs them) and of the heights
    std::string units_from;
    std::string size_from;  ///< where dx and dy come from
    std::size_t columns{}, rows{};
    std::size_t missing{};

    /// The above as sentences for people, one a line, without a full stop.
    [[nodiscard]] std::vector<std::string> sentences() const;
};

struct MapFromText {
    HeightMap<double> map;
    MapTextRecord record;
};

/// Reads all of \p input; \p name stands for it in messages.
/// \throws domain_error naming file, line, value and what is allowed.
[[nodiscard]] inline MapFromText read_map(std::istream& input, std::string_view name,
                                          const MapTextOptions& options = {});

/// Reads the file \p path. \throws file_error when it cannot be opened or read.
[[nodiscard]] inline MapFromText read_map(const std::filesystem::path& path, const MapTextOptions& options = {});

namespace detail {

/// Rows of numbers below a header. Views point into the text, which must outlive them.
struct NumberTable {
    std::vector<Line> lines;
    std::size_t line_count{};
    std::size_t first{};  // of `lines`: the first row
    Dialect dialect;
    std::size_t columns{};
    std::vector<double> values;  // by row; NaN where missing
    std::vector<std::size_t> row_lines;
    std::vector<PrintedDigits> printed;  // of the first three columns

    std::size_t rows() const { return row_lines.size(); }
    double at(std::size_t row, std::size_t column) const { return values[row * columns + column]; }
};

/// Finds the header's end and the separators. \throws domain_error when no line is a row of numbers.
inline NumberTable open_table(std::string_view text, const std::string& name) {
    NumberTable table;
    table.lines = lines_of(text, name, table.line_count);
    if (table.lines.empty()) refuse_file(name, "holds blank lines only; must hold rows of numbers");
    for (table.first = 0; table.first < table.lines.size(); ++table.first) {
        const std::string_view line = table.lines[table.first].text;
        if (is_comment(line)) continue;
        if (const auto dialect = dialect_of(without_comment(line), true)) {
            table.dialect = *dialect;
            break;
        }
    }
    if (table.first == table.lines.size())
        refuse_line(name, table.lines.front().number,
                    shown_cell(table.lines.front().text) +
                        " is no row of numbers, nor is any line after it; must hold rows of numbers");
    // the first row alone may hide the decimal commas of "0;1,5"
    for (std::size_t i = table.first; i < table.lines.size() && table.dialect.separator != ','; ++i) {
        if (is_comment(table.lines[i].text)) continue;
        const std::size_t sign = without_comment(table.lines[i].text).find_first_of(".,");
        if (sign == std::string_view::npos) continue;
        table.dialect.decimal_comma = table.lines[i].text[sign] == ',';
        break;
    }
    std::vector<std::string_view> cells;
    split_line(without_comment(table.lines[table.first].text), table.dialect.separator, cells);
    table.columns = cells.size();
    return table;
}

/// The cells of a line, empty ones at its end included.
inline void split_row(std::string_view line, char separator, std::vector<std::string_view>& cells) {
    split_line(line, separator, cells);
    if (separator != ' ') cells.resize(static_cast<std::size_t>(std::count(line.begin(), line.end(), separator)) + 1);
}

/// Reads the rows of a table that open_table has opened.
inline void read_rows(NumberTable& table, const std::string& name) {
    std::vector<std::string_view> cells;
    const std::size_t shown = table.columns;  // in the first row
    std::size_t last_cells = 0;               // rows with something in their last cell
    table.columns = 0;
    for (std::size_t i = table.first; i < table.lines.size(); ++i) {
        if (i != table.first && is_comment(table.lines[i].text)) continue;
        const std::size_t line = table.lines[i].number;
        split_row(without_comment(table.lines[i].text), table.dialect.separator, cells);
        if (cells.empty()) continue;
        if (table.row_lines.empty()) {
            table.columns = cells.size();
            table.printed.resize(std::min<std::size_t>(cells.size(), 3));
        }
        const bool whole = cells.size() == table.columns;
        for (std::size_t c = 0; c < cells.size(); ++c) {
            double value = std::numeric_limits<double>::quiet_NaN();
            if (!cells[c].empty() && !is_missing_word(cells[c])) {
                const auto number = number_in(cells[c], table.dialect.decimal_comma);
                if (!number)
                    refuse_line(name, line,
                                shown_cell(cells[c]) +
                                    " is no number; allowed are finite decimal numbers (an empty "
                                    "cell, nan or BAD is a missing point)");
                if (!std::isfinite(number->value))
                    refuse_line(
                        name, line,
                        shown_cell(cells[c]) + " is beyond the range of double precision; allowed are finite numbers");
                value = number->value;
                if (whole && c < table.printed.size()) table.printed[c].add(*number);
            }
            if (whole) table.values.push_back(value);
        }
        if (!whole)
            refuse_line(name, line,
                        "has " + std::to_string(cells.size()) + " columns; must be " + std::to_string(table.columns) +
                            " as in line " + std::to_string(table.row_lines.front()));
        if (!cells.back().empty()) ++last_cells;
        table.row_lines.push_back(line);
    }
    // a separator at the end of every line makes no column
    if (last_cells == 0 && shown < table.columns && table.columns > 1) {
        const std::size_t old = table.columns--;
        for (std::size_t r = 1; r < table.rows(); ++r)
            std::copy_n(table.values.begin() + static_cast<std::ptrdiff_t>(r * old), table.columns,
                        table.values.begin() + static_cast<std::ptrdiff_t>(r * table.columns));
        table.values.resize(table.rows() * table.columns);
    }
}

/// "key: value" or "key = value" of a header.
struct HeaderEntry {
    std::string key;  // lower case, blanks for underscores
    std::string_view value;
    std::size_t line;
};

inline std::string header_key(std::string_view text) {
    std::string key = lower_case(trimmed(text));
    std::replace(key.begin(), key.end(), '_', ' ');
    return key;
}

inline std::vector<HeaderEntry> header_entries(const NumberTable& table) {
    std::vector<HeaderEntry> entries;
    std::vector<std::string_view> words;
    const auto add = [&](std::string_view text, std::size_t sign, std::size_t line) {
        std::string_view value = trimmed(text.substr(sign + 1));
        while (!value.empty() && (value.back() == ',' || value.back() == ';' || is_blank(value.back())))
            value.remove_suffix(1);
        entries.push_back({header_key(text.substr(0, sign)), value, line});
    };
    for (std::size_t i = 0; i < table.first; ++i) {
        std::string_view line = table.lines[i].text;
        while (!line.empty() && (is_blank(line.front()) || line.front() == '#' || line.front() == '%' ||
                                 line.front() == '!' || line.front() == '/' || line.front() == ';'))
            line.remove_prefix(1);
        const std::size_t sign = line.find_first_of(":=");
        if (sign == std::string_view::npos || sign == 0) continue;
        // "h=305 w=75": every word an entry
        split_line(line, ' ', words);
        const bool every_word = std::all_of(words.begin(), words.end(), [](std::string_view word) {
            const std::size_t equal = word.find('=');
            return equal != std::string_view::npos && equal > 0 && equal + 1 < word.size();
        });
        if (words.size() > 1 && every_word)
            for (const std::string_view word : words) add(word, word.find('='), table.lines[i].number);
        else
            add(line, sign, table.lines[i].number);
    }
    return entries;
}

/// What a header says about the grid of a matrix: lengths [m], counts.
struct StatedGrid {
    struct Length {
        double value{};
        std::size_t line{};
    };
    std::optional<Length> width, height, dx, dy;
    std::optional<std::size_t> columns, rows;
    std::size_t columns_line{}, rows_line{};
    std::string without_unit;  // the first length that lacks its unit, for messages
    std::size_t without_unit_line{};

    bool has_size() const { return (width || dx) && (height || dy); }
};

/// \p unit stands where a length has none; "" for refusing to guess.
inline StatedGrid stated_grid(const std::vector<HeaderEntry>& entries, const std::string& unit,
                              const std::string& name) {
    StatedGrid grid;
    const auto is_one_of = [](const std::string& key, std::initializer_list<std::string_view> keys) {
        return std::find(keys.begin(), keys.end(), key) != keys.end();
    };
    const auto set = [&](auto& slot, auto value, const HeaderEntry& entry, auto old) {
        if (slot && old != value)
            refuse_line(name, entry.line,
                        shown_cell(entry.key) + " is stated twice, with two values; must be one value");
        slot = value;
    };
    for (const HeaderEntry& entry : entries) {
        const bool width = is_one_of(entry.key, {"width", "w", "x size", "size x", "x range", "scan size x"});
        const bool height = is_one_of(entry.key, {"height", "h", "y size", "size y", "y range", "scan size y"});
        const bool both = is_one_of(entry.key, {"pixel size", "pixel pitch", "pixel spacing", "lateral spacing"});
        const bool dx = both || is_one_of(entry.key, {"dx", "pixel width", "x pixel size", "pixel size x", "x spacing",
                                                      "spacing x", "x step", "x increment"});
        const bool dy = both || is_one_of(entry.key, {"dy", "pixel height", "y pixel size", "pixel size y", "y spacing",
                                                      "spacing y", "y step", "y increment"});
        const bool columns = is_one_of(entry.key, {"columns", "cols", "x pixels", "xres", "nx"});
        const bool rows = is_one_of(entry.key, {"rows", "lines", "y pixels", "yres", "ny"});
        if (!(width || height || dx || dy || columns || rows)) continue;
        const LeadingNumber number = leading_number(entry.value);
        if (number.status != NumberStatus::ok) continue;
        const std::string_view written = trimmed(entry.value.substr(number.length));
        const std::string word = lower_case(written);
        const bool counted = word == "px" || word == "pixel" || word == "pixels" || word == "points";
        const bool whole = number.value >= 1 && number.value < 4294967296.0 && number.value == std::floor(number.value);
        const bool short_count = (entry.key == "w" || entry.key == "h") && written.empty();
        if (columns || rows || counted || (short_count && whole)) {
            if (!whole || dx || dy || !(written.empty() || counted)) continue;
            const auto count = static_cast<std::size_t>(number.value);
            auto& slot = columns || width ? grid.columns : grid.rows;
            set(slot, count, entry, slot.value_or(0));
            (columns || width ? grid.columns_line : grid.rows_line) = entry.line;
            continue;
        }
        if (written.empty() && unit.empty()) {
            if (grid.without_unit.empty()) grid.without_unit_line = entry.line;
            if (grid.without_unit.empty()) grid.without_unit = entry.key;
            continue;
        }
        if (!written.empty() && !is_unit(written, Dimension::length)) continue;
        const std::string quantity =
            std::string(entry.value.substr(0, number.length)) + " " + (written.empty() ? unit : std::string(written));
        const double value = naming_file(name, [&] { return parse_quantity(quantity, Dimension::length, entry.key); });
        if (!(value > 0))
            refuse_line(name, entry.line,
                        shown_cell(entry.key) + " = " + number_text(value) + " m: must be greater than 0");
        const auto store = [&](std::optional<StatedGrid::Length>& slot) {
            if (slot && slot->value != value)
                refuse_line(name, entry.line,
                            shown_cell(entry.key) + " disagrees with line " + std::to_string(slot->line) +
                                "; must be one value");
            slot = StatedGrid::Length{value, entry.line};
        };
        if (width) store(grid.width);
        if (height) store(grid.height);
        if (dx) store(grid.dx);
        if (dy) store(grid.dy);
    }
    return grid;
}

/// "Form: triples" or "Form: matrix" of a header, as write_csv writes it.
inline std::optional<MapForm> stated_form(const std::vector<HeaderEntry>& entries) {
    for (const HeaderEntry& entry : entries)
        if (entry.key == "form") {
            if (entry.value == "triples") return MapForm::triples;
            if (entry.value == "matrix") return MapForm::matrix;
        }
    return std::nullopt;
}

/// Equally spaced positions, some of which may be missing.
struct GridAxis {
    double origin{}, step{};
    std::size_t count{};
    std::size_t index(double position) const {
        return static_cast<std::size_t>(std::max(0.0, std::round((position - origin) / step)));
    }
};

/// The axis on which \p positions lie to within their last printed digit; none when there is none.
inline std::optional<GridAxis> axis_of(std::vector<double> positions, double printed) {
    std::sort(positions.begin(), positions.end());
    for (const double merged : {0.0, 1.01 * printed}) {
        std::vector<double> lines;
        double begin = 0;
        for (const double x : positions) {
            if (lines.empty() || x - lines.back() > merged) {
                lines.push_back(x);
                begin = x;
            } else {
                lines.back() = begin + (x - begin) / 2;
            }
        }
        if (lines.size() < 2 || !std::isfinite(lines.back() - lines.front())) continue;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 1; i < lines.size(); ++i) least = std::min(least, lines[i] - lines[i - 1]);
        // in steps: how far each line is from the first
        std::vector<double> at(lines.size());
        bool fits = true;
        for (std::size_t i = 1; i < lines.size() && fits; ++i) {
            at[i] = at[i - 1] + std::round((lines[i] - lines[i - 1]) / least);
            fits = at[i] < 1e9;
        }
        if (!fits) continue;
        const double step = (lines.back() - lines.front()) / at.back();
        // printed to less than a quarter of the step, a missing line cannot be told from rounding
        if (printed > 0.25 * step && at.back() >= static_cast<double>(lines.size())) continue;
        const double allowed = 0.01 * step + std::min(1.01 * printed, 0.3 * step);
        for (std::size_t i = 1; i < lines.size() && fits; ++i)
            fits = std::abs(lines[i] - (lines.front() + at[i] * step)) <= allowed;
        if (fits) return GridAxis{lines.front(), step, static_cast<std::size_t>(at.back()) + 1};
    }
    return std::nullopt;
}

struct Grid {
    GridAxis x, y;
};

/// The grid of the first two columns; none when there is none, or hardly any of its points is there.
inline std::optional<Grid> grid_of(const NumberTable& table) {
    std::vector<double> positions[2];
    for (std::size_t c = 0; c < 2; ++c) {
        positions[c].resize(table.rows());
        for (std::size_t r = 0; r < table.rows(); ++r) {
            positions[c][r] = table.at(r, c);
            if (std::isnan(positions[c][r])) return std::nullopt;
        }
    }
    const auto x = axis_of(std::move(positions[0]), table.printed[0].resolution());
    if (!x) return std::nullopt;
    const auto y = axis_of(std::move(positions[1]), table.printed[1].resolution());
    if (!y) return std::nullopt;
    // scattered points lie on a very fine grid of which they fill next to nothing
    const double points = static_cast<double>(x->count) * static_cast<double>(y->count);
    if (points > 10 * static_cast<double>(table.rows())) return std::nullopt;
    return Grid{*x, *y};
}

/// Everything that reading one file needs to pass between its steps.
class MapTextReader {
public:
    MapTextReader(std::string_view text, std::string name, const MapTextOptions& options)
        : name_(std::move(name)), options_(options), table_(open_table(text, name_)) {}

    MapFromText read() {
        record_.name = name_;
        record_.lines = table_.line_count;
        record_.header_lines = table_.lines[table_.first].number - 1;
        record_.separator = separator_name(table_.dialect.separator);
        record_.decimal_comma = table_.dialect.decimal_comma;
        read_rows(table_, name_);
        split_units();
        entries_ = header_entries(table_);
        stated_ = stated_grid(entries_, lateral_unit_, name_);
        choose_form();
        MapFromText result;
        result.map = record_.form == MapForm::triples ? triples() : matrix();
        naming_file(name_, [&] { result.map.validate(2); });
        record_.columns = static_cast<std::size_t>(result.map.columns());
        record_.rows = static_cast<std::size_t>(result.map.rows());
        record_.missing = static_cast<std::size_t>(result.map.size() - result.map.present());
        result.record = record_;
        return result;
    }

private:
    void split_units() {
        if (options_.units.empty()) return;
        split_line(options_.units, ',', given_units_);
        if (given_units_.empty() || given_units_.size() > 3)
            refuse_file(name_, "units = " + shown_cell(options_.units) +
                                   ": must be one unit, or \"um,nm\" (x and y, heights), or \"um,um,nm\"");
        for (const std::string_view unit : given_units_) require_unit(unit, Dimension::length);
        if (given_units_.size() > 1) lateral_unit_ = given_units_.front();
    }

    bool size_given() const { return options_.dx || options_.dy || options_.width || options_.height; }

    void choose_form() {
        record_.form = options_.form;
        record_.form_from = "options";
        if (options_.form != MapForm::automatic) return;
        record_.form = MapForm::matrix;
        if (table_.columns != 3) {
            record_.form_from = std::to_string(table_.columns) + " columns";
            return;
        }
        if (const auto form = stated_form(entries_)) {
            record_.form = *form;
            record_.form_from = "the header";
            return;
        }
        const bool sized = size_given() || stated_.has_size();
        grid_ = grid_of(table_);
        if (grid_.has_value() == sized)
            refuse_file(name_, std::string("has three columns, ") +
                                   (sized ? "of which two form a grid, and a stated size: may be x, y, z triples or a "
                                            "matrix; must be told which"
                                          : "of which the first two form no regular grid, and no stated size: is "
                                            "neither x, y, z triples nor a matrix; must be told which") +
                                   " by format = triples or format = matrix");
        record_.form = grid_ ? MapForm::triples : MapForm::matrix;
        record_.form_from = grid_ ? "three columns, the first two of which form a grid" : "a size is stated";
    }

    HeightMap<double> triples() {
        if (table_.columns != 3)
            refuse_file(name_, "has " + std::to_string(table_.columns) + " columns; triples must have 3: x, y, z");
        if (size_given())
            refuse_file(name_,
                        "holds x, y, z triples, whose size is in the file; dx, dy, width and height must not "
                        "be given");
        for (std::size_t r = 0; r < table_.rows(); ++r)
            if (std::isnan(table_.at(r, 0)) || std::isnan(table_.at(r, 1)))
                refuse_line(name_, table_.row_lines[r], "has no position; x and y must be finite decimal numbers");
        if (!grid_) grid_ = grid_of(table_);
        if (!grid_)
            refuse_file(name_,
                        "has x and y that lie on no regular grid; must be a raster of equal steps in x and in "
                        "y, of which a tenth of the points at least is there");
        const std::vector<std::string> axes = units_of_triples();
        const double x_unit = unit_factor(axes[0], Dimension::length);
        const double y_unit = unit_factor(axes[1], Dimension::length);
        const double z_unit = unit_factor(axes[2], Dimension::length);
        HeightMap<double> map;
        map.heights.setConstant(static_cast<Eigen::Index>(grid_->y.count), static_cast<Eigen::Index>(grid_->x.count),
                                std::numeric_limits<double>::quiet_NaN());
        std::vector<std::size_t> line_at(grid_->x.count * grid_->y.count);
        for (std::size_t r = 0; r < table_.rows(); ++r) {
            const std::size_t i = std::min(grid_->x.index(table_.at(r, 0)), grid_->x.count - 1);
            const std::size_t j = std::min(grid_->y.index(table_.at(r, 1)), grid_->y.count - 1);
            std::size_t& line = line_at[j * grid_->x.count + i];
            if (line != 0)
                refuse_line(name_, table_.row_lines[r],
                            "repeats the point of line " + std::to_string(line) +
                                ", x = " + number_text(table_.at(r, 0)) + ", y = " + number_text(table_.at(r, 1)) +
                                "; every point must come once");
            line = table_.row_lines[r];
            map.heights(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(i)) = table_.at(r, 2) * z_unit;
        }
        record_.size_from = "steps of x and y";
        map.dx = step_of(grid_->x, x_unit, stated_.dx);
        map.dy = step_of(grid_->y, y_unit, stated_.dy);
        return map;
    }

    /// The step of an axis [m]; as stated in the header when both agree, without the rounding of the positions.
    double step_of(const GridAxis& axis, double unit, const std::optional<StatedGrid::Length>& stated) {
        const double step = axis.step * unit;
        if (!stated) return step;
        if (!(std::abs(step - stated->value) <= 0.01 * step))
            refuse_line(name_, stated->line,
                        number_text(stated->value) + " m disagrees with the positions, whose step is " +
                            number_text(step) + " m; must agree");
        if (!(std::abs(step - stated->value) <= 1e-9 * step)) return step;
        record_.size_from = "line " + std::to_string(stated->line) + ", with which the steps of x and y agree";
        return stated->value;
    }

    std::vector<std::string> units_of_triples() {
        std::vector<std::string> axes;
        if (!given_units_.empty()) {
            axes = {std::string(given_units_.front()), std::string(given_units_.front()),
                    std::string(given_units_.back())};
            if (given_units_.size() == 3) axes[1] = given_units_[1];
            record_.units_from = "options";
        }
        for (std::size_t i = table_.first; i-- > 0 && axes.empty();) {
            const auto found = units_in(table_.lines[i].text, 3, table_.dialect.separator);
            if (found.empty()) continue;
            axes.assign(found.begin(), found.end());
            record_.units_from = "line " + std::to_string(table_.lines[i].number);
        }
        if (axes.empty())
            refuse_file(name_,
                        "states no units and none are given; must be given as units = \"um,nm\" (x and y, "
                        "heights), each one of " +
                            accepted_units(Dimension::length));
        record_.units = "x in " + axes[0] + ", y in " + axes[1] + ", heights in " + axes[2];
        return axes;
    }

    HeightMap<double> matrix() {
        HeightMap<double> map;
        const std::size_t columns = table_.columns, rows = table_.rows();
        if (columns < 2 || rows < 2)
            refuse_file(name_, "is a matrix of " + std::to_string(columns) + " x " + std::to_string(rows) +
                                   " points; must have at least 2 a side");
        check_count("columns", stated_.columns, stated_.columns_line, columns);
        check_count("rows", stated_.rows, stated_.rows_line, rows);
        map.dx = spacing("dx", "width", options_.dx, options_.width, stated_.dx, stated_.width, columns);
        map.dy = spacing("dy", "height", options_.dy, options_.height, stated_.dy, stated_.height, rows);
        const double unit = value_unit();
        map.heights = Eigen::Map<const HeightMap<double>::Array>(table_.values.data(), static_cast<Eigen::Index>(rows),
                                                                 static_cast<Eigen::Index>(columns)) *
                      unit;
        return map;
    }

    void check_count(const char* what, const std::optional<std::size_t>& stated, std::size_t line,
                     std::size_t there) const {
        if (stated && *stated != there)
            refuse_line(name_, line,
                        "states " + std::to_string(*stated) + " " + what + " where there are " + std::to_string(there) +
                            "; must agree");
    }

    double spacing(const std::string& step, const std::string& whole, const std::optional<double>& given_step,
                   const std::optional<double>& given_whole, const std::optional<StatedGrid::Length>& stated_step,
                   const std::optional<StatedGrid::Length>& stated_whole, std::size_t count) {
        const auto points = static_cast<double>(count);
        const auto note = [&](const std::string& from) {
            record_.size_from += (record_.size_from.empty() ? "" : ", ") + from;
        };
        if (given_step && given_whole)
            refuse_file(name_, step + " and " + whole + " are both given; must be one of them");
        if (given_step || given_whole) {
            naming_file(name_,
                        [&] { require_positive(given_step ? step : whole, *(given_step ? given_step : given_whole)); });
            note((given_step ? step : whole) + " of the options");
            return given_step ? *given_step : *given_whole / points;
        }
        if (stated_step) {
            // also with points - 1 steps, which some programs take for the width
            if (stated_whole && std::abs(stated_whole->value - stated_step->value * (points - 0.5)) >
                                    0.51 * stated_step->value + 0.01 * stated_whole->value)
                refuse_line(name_, stated_whole->line,
                            "states a " + whole + " that disagrees with the spacing of line " +
                                std::to_string(stated_step->line) + "; must agree, or " + step + " be given");
            note(step + " of line " + std::to_string(stated_step->line));
            return stated_step->value;
        }
        if (stated_whole) {
            note(whole + " of line " + std::to_string(stated_whole->line));
            return stated_whole->value / points;
        }
        if (!stated_.without_unit.empty())
            refuse_line(
                name_, stated_.without_unit_line,
                shown_cell(stated_.without_unit) +
                    " has no unit; must be given as units = \"um,nm\" (lengths, heights), or dx and dy be given");
        refuse_file(name_,
                    "is a matrix that states no physical size, and none is given; must be given as dx and dy "
                    "(between points) or width and height (of the map)");
    }

    /// One unit of the heights [m].
    double value_unit() {
        if (!given_units_.empty()) {
            record_.units = "heights in " + std::string(given_units_.back());
            record_.units_from = "options";
            return unit_factor(given_units_.back(), Dimension::length);
        }
        const HeaderEntry* unit = nullptr;
        const HeaderEntry* factor = nullptr;
        for (const HeaderEntry& entry : entries_) {
            for (const char* key : {"value units", "value unit", "data unit", "data units", "z unit", "z units",
                                    "height unit", "height units", "unit", "units"})
                if (entry.key == key) {
                    if (unit && unit->value != entry.value)
                        refuse_line(name_, entry.line,
                                    "states another unit of the heights than line " + std::to_string(unit->line) +
                                        "; must be one unit");
                    unit = &entry;
                }
            if (entry.key.starts_with("height conversion factor")) factor = &entry;
        }
        if (factor) return conversion_factor(*factor, unit);
        if (!unit)
            refuse_file(name_,
                        "states no unit of the heights and none is given; must be given as units = \"nm\", one "
                        "of " +
                            accepted_units(Dimension::length));
        if (!is_unit(unit->value, Dimension::length))
            refuse_line(name_, unit->line,
                        shown_cell(unit->value) +
                            " is no unit of length, and no height conversion factor is stated; must be one of " +
                            accepted_units(Dimension::length));
        record_.units = "heights in " + std::string(unit->value);
        record_.units_from = "line " + std::to_string(unit->line);
        return unit_factor(unit->value, Dimension::length);
    }

    /// "height conversion factor (-> m)=2.9e-8", or "... = 29 nm".
    double conversion_factor(const HeaderEntry& entry, const HeaderEntry* unit) {
        const LeadingNumber number = leading_number(entry.value);
        std::string_view to = trimmed(entry.value.substr(number.length));
        const std::size_t arrow = entry.key.find("->");
        if (to.empty() && arrow != std::string::npos) {
            to = std::string_view(entry.key).substr(arrow + 2);
            to = trimmed(to.substr(0, to.find(')')));
        }
        if (number.status != NumberStatus::ok || !(number.value > 0) || !is_unit(to, Dimension::length))
            refuse_line(name_, entry.line,
                        shown_cell(entry.value) +
                            " is no height conversion factor; must be a positive number with a "
                            "unit of length, such as \"(-> m)=2.9e-8\"");
        const double factor = number.value * unit_factor(to, Dimension::length);
        if (unit && is_unit(unit->value, Dimension::length) &&
            !(std::abs(factor - unit_factor(unit->value, Dimension::length)) <= 1e-6 * factor))
            refuse_line(name_, entry.line,
                        "states a height conversion factor, line " + std::to_string(unit->line) +
                            " a unit of length that disagrees; must agree, or units be given");
        record_.units =
            "heights in " + (unit ? std::string(unit->value) : "units") + " of " + number_text(factor) + " m";
        record_.units_from = "line " + std::to_string(entry.line);
        return factor;
    }

    std::string name_;
    const MapTextOptions& options_;
    NumberTable table_;
    MapTextRecord record_;
    std::vector<std::string_view> given_units_;
    std::string lateral_unit_;
    std::vector<HeaderEntry> entries_;
    StatedGrid stated_;
    std::optional<Grid> grid_;
};

inline MapFromText read_map_bytes(std::string bytes, const std::string& name, const MapTextOptions& options) {
    const std::string text = text_of(std::move(bytes), name, "rows of numbers");
    return MapTextReader(text, name, options).read();
}

}  // namespace detail

inline std::vector<std::string> MapTextRecord::sentences() const {
    std::vector<std::string> all;
    all.push_back(std::string("form: ") + (form == MapForm::triples ? "x, y, z triples" : "matrix") + ", from " +
                  form_from);
    all.push_back("separator: " + separator + ", decimal " + (decimal_comma ? "comma" : "point"));
    all.push_back("header: " + std::to_string(header_lines) + (header_lines == 1 ? " line" : " lines"));
    all.push_back("units: " + units + ", from " + units_from);
    all.push_back("spacing: from " + size_from);
    all.push_back("points: " + std::to_string(columns) + " x " + std::to_string(rows) + ", of which " +
                  std::to_string(missing) + " missing");
    return all;
}

inline MapFromText read_map(std::istream& input, std::string_view name, const MapTextOptions& options) {
    const std::string file(name);
    return detail::read_map_bytes(detail::read_bytes(input, file), file, options);
}

inline MapFromText read_map(const std::filesystem::path& path, const MapTextOptions& options) {
    return detail::read_map_bytes(detail::read_bytes(path, "delimited text"), path.string(), options);
}

}  // namespace fstiff::io
