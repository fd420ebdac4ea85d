// SPDX-License-Identifier: BSD-3-Clause
#include "io/roles.hpp"

#include "io/ambiguous_signs.hpp"
#include "io/given_lengths.hpp"
#include "io/height_sense.hpp"
#include "io/readers.hpp"
#include "io/row_layout.hpp"
#include "io/unequal_steps.hpp"
#include "io/zygo_xyz.hpp"

#include <tuple>

namespace fstiff::inline v0_1::io::detail {

std::vector<std::size_t> TextTable::columns(Role role) const {
    std::vector<std::size_t> columns;
    for (std::size_t c = 0; c < roles.size(); ++c)
        if (roles[c] == role) columns.push_back(c);
    return columns;
}

std::optional<std::size_t> TextTable::column(Role role) const {
    const auto column = std::find(roles.begin(), roles.end(), role);
    return column == roles.end() ? std::nullopt : std::optional(static_cast<std::size_t>(column - roles.begin()));
}

bool TextTable::is_zygo() const { return numbers.lines.front().text.starts_with(zygo_xyz_begin); }

std::vector<double> TextTable::take_heights(const std::string& name, const std::string& unit) {
    const std::vector<std::size_t> used = columns(Role::heights);
    std::vector<double> heights = form == SurfaceFormat::matrix ? std::move(numbers.values) : numbers.values;
    std::size_t count = 0;
    for (std::size_t r = 0; r < numbers.rows(); ++r)
        for (const std::size_t c : used) heights[count++] = heights[r * numbers.columns + c];
    heights.resize(count);
    LoneWhole whole;
    for (const std::size_t c : used) whole.add(numbers.wholes[c]);
    mark_missing(heights.data(), count, numbers.missing, whole, name, numbers.names, unit,
                 [&](std::size_t i) { return numbers.row_lines[i / used.size()]; });
    if (form == SurfaceFormat::matrix) numbers.columns = used.size();
    return heights;
}

double TextTable::resolution() const {
    double resolution = 0;
    const std::vector<std::size_t> used = columns(Role::heights);
    for (std::size_t k = 0; k < (std::min)(used.size(), std::size_t{3}); ++k)
        resolution = (std::max)(resolution, printed_step(numbers, used[k]));
    return resolution;
}

bool rises_evenly(const NumberTable& table, std::size_t c) { return has_equal_steps(column_of(table, c), 0.6); }

namespace {

/// Whether column \p c goes one way throughout.
bool rises_or_falls(const NumberTable& table, std::size_t c) {
    const std::vector<double> numbers = column_of(table, c);
    const auto has_step = [&](auto which) {
        return std::adjacent_find(numbers.begin(), numbers.end(), which) != numbers.end();
    };
    return !(has_step(std::less<>()) && has_step(std::greater<>()));
}

/// Whether the rows of column \p c count: whole numbers that rise, and \p from_start, by one from 0 or 1.
bool counts_points(const NumberTable& table, std::size_t c, bool from_start) {
    for (std::size_t r = 0; r < table.rows(); ++r) {
        const double value = table.at(r, c);
        if (!(value == std::floor(value))) return false;  // NaN too
        if (r > 0 && !(from_start ? value == table.at(r - 1, c) + 1 : value > table.at(r - 1, c))) return false;
    }
    return table.rows() > 1 && (!from_start || table.at(0, c) == 0 || table.at(0, c) == 1);
}

/// Whether \p title is of neither positions nor heights, such as "Time" and "Intensity" without a unit of length.
bool names_other(const ColumnTitle& title) {
    return names_error(title.name) || (title.unit.empty() && (names_neither(title.name) || !title.no_length.empty()));
}

/// Whether column \p c holds neither positions nor heights: by its \p title, or one number, or none, throughout.
bool is_spare(const NumberTable& table, std::size_t c, const ColumnTitle& title) {
    if (names_other(title)) return true;
    const std::vector<double> numbers = column_of(table, c);
    return numbers.size() > 1 && std::all_of(numbers.begin(), numbers.end(), [&](double number) {
               return number == numbers[0] || (std::isnan(number) && std::isnan(numbers[0]));
           });
}

bool names_length(const ColumnTitle& title) {
    return !title.unit.empty() || names_position(title.name) || names_height(title.name);
}

bool is_pixel(const ColumnTitle& title) {
    return title.unit.empty() && (names_pixel(title.name) || names_pixel(lower_case(title.unread)));
}

std::string counted(std::size_t columns) { return columns == 1 ? "one column" : std::to_string(columns) + " columns"; }

using Form = std::pair<SurfaceFormat, std::string>;

/// Finds the form of a table and the roles of its columns, which needs its numbers and titles.
class RoleFinder {
public:
    RoleFinder(const std::string& name, const SurfaceOptions& options) : name_(name), options_(options) {}

    TextTable find(NumberTable opened, SurfaceFormat form) {
        table_.form = form;
        numbers_ = std::move(opened);
        table_.entries = header_entries(numbers_, true);
        if (form == SurfaceFormat::automatic) std::tie(table_.form, table_.form_from) = form_by_header();
        check_options(table_.form, options_, name_);
        if (table_.form == SurfaceFormat::profile) {
            read_as_profile();
            choose_profile();
        } else {
            read_map();
            table_.form == SurfaceFormat::triples ? choose_triples() : choose_matrix();
        }
        std::vector<std::size_t> used = table_.columns(Role::heights);
        for (const Role role : {Role::x, Role::y})
            if (const auto column = table_.column(role); column && !options_.spacing) used.push_back(*column);
        refuse_thousands(numbers_, used, table_.form == SurfaceFormat::matrix, name_);
        return std::move(table_);
    }

private:
    void read(RowEnds ends) {
        numbers_.missing = stated_missing(table_.entries, options_.missing, name_);
        read_rows(numbers_, name_, ends);
        table_.titles = titles_above(numbers_);
        table_.roles = first_roles(numbers_, table_.titles);
    }

    void read_as_profile() {
        numbers_.forget_rows();  // they may have been read as those of a map
        take_rows_above(numbers_);
        numbers_.missing = given_missing(options_.missing, name_);
        settle_lone_commas(numbers_);
        table_.entries = header_entries(numbers_, true);
        read(RowEnds::may_be_short);
    }

    /// Reads the rows of a map, once, and finds what may be x, y and heights, and axes.
    void read_map() {
        if (!numbers_.row_lines.empty()) return;
        read(RowEnds::whole);
        if (!table_.is_zygo() && numbers_.words.empty()) table_.axes = axes_of(numbers_);
        if (table_.axes && table_.axes->in_table && states_other_count()) table_.axes.reset();
        if (table_.axes || table_.is_zygo()) table_.roles.assign(numbers_.columns, Role::open);
        points_ = table_.columns(Role::open);
        if (!table_.axes) order_points();
        if (points_.size() < 3) return;
        table_.grid = grid_of(numbers_, points_[0], points_[1]);
        table_.counts_pixels = table_.grid && table_.grid->x.step == 1 && table_.grid->y.step == 1 &&
                               is_pixel(title(0)) && is_pixel(title(1));
    }

    /// Whether the header counts the columns of the whole table, or states a size of it.
    bool states_other_count() const {
        const StatedGrid stated = stated_grid(table_.entries, "m", name_);
        return stated.columns ? *stated.columns == numbers_.columns : stated.has_size();
    }

    /// Of the points.
    const ColumnTitle& title(std::size_t k) const { return table_.titles[points_[k]]; }

    /// Leaves x, y and z alone where one title each names them, in another order.
    void order_points() {
        std::array<std::vector<std::size_t>, 3> named;
        for (const std::size_t c : points_) {
            const std::string& name = table_.titles[c].name;
            if (const bool is_x = name == "x"; is_x || name == "y") named[is_x ? 0 : 1].push_back(c);
            if (names_height(name)) named[2].push_back(c);
        }
        if (std::any_of(named.begin(), named.end(), [](const auto& columns) { return columns.size() != 1; })) return;
        const std::vector<std::size_t> xyz{named[0][0], named[1][0], named[2][0]};
        if (!std::equal(xyz.begin(), xyz.end(), points_.begin())) points_ = xyz;
    }

    /// Whether the points, of four columns or more, begin with x, y and z.
    bool begins_with_triples() const {
        if (points_.size() < 4 || points_.size() > 12 || table_.axes) return false;
        if ((title(0).name == "x" && title(1).name == "y") || table_.counts_pixels) return true;
        const auto& grid = table_.grid;
        return numbers_.rows() >= 9 && grid && 2 * points_on(*grid, numbers_) > grid->size();
    }

    /// The column of z of more than three: the one of that title, or the only one beyond x and y with a unit of length,
    /// or the third.
    std::size_t height_column() const {
        std::vector<std::size_t> named, with_unit;
        for (std::size_t k = 2; k < points_.size(); ++k) {
            if (names_height(title(k).name) || names_depth(title(k).name)) named.push_back(points_[k]);
            if (!title(k).unit.empty()) with_unit.push_back(points_[k]);
        }
        const auto& found = named.size() == 1 ? named : with_unit;
        return found.size() == 1 ? found.front() : points_[2];
    }

    [[noreturn]] void refuse_form(const std::string& what, const std::string& choice) const {
        refuse_file(name_, {"has ", counted(written_), what, "; give ", choice});
    }
    std::string as(const char* form) const { return format_as(options_.names, form); }

    /// The form, and why: by the options, the header, and the columns of the first row.
    Form form_by_header() {
        written_ = numbers_.columns;
        sized_ = gives_size(options_) || stated_grid(table_.entries, "m", name_).has_size();
        if (asks_for_profile(options_)) return {SurfaceFormat::profile, "options that only a profile has"};
        if (const auto form = stated_form(table_.entries); form && written_ > 1)
            return {*form == MapForm::triples ? SurfaceFormat::triples : SurfaceFormat::matrix, "the header"};
        if (sized_ && written_ == 2)
            refuse_form(" and the size of a map: may be a profile or a matrix", as("profile") + " or " + as("matrix"));
        if (written_ <= 2) return {SurfaceFormat::profile, counted(written_)};
        read_map();
        if (options_.grid && points_.size() > 2) return {SurfaceFormat::triples, "grid, which only points have"};
        if (table_.is_zygo()) return {SurfaceFormat::triples, "the header"};
        if (table_.axes) return {SurfaceFormat::matrix, "positions in the first row and the first column"};
        return form_by_points();
    }

    /// How many of the points may be positions or heights.
    auto lengths() const {
        return std::count_if(points_.begin(), points_.end(),
                             [&](std::size_t c) { return !is_spare(numbers_, c, table_.titles[c]); });
    }

    /// By the columns that neither hold words nor number the points.
    Form form_by_points() const {
        const bool words = !numbers_.words.empty();
        if (points_.size() <= 2)
            return {SurfaceFormat::profile, counted(points_.size()) + (words ? " next to those of words"
                                                                             : " next to one that numbers the points")};
        if (!sized_ && (points_.size() == 3 || is_titled(table_.titles)) && !table_.grid && lengths() == 2)
            return {SurfaceFormat::profile, "two columns next to others of neither positions nor heights"};
        if (points_.size() == 3) return form_of_three();
        if (begins_with_triples()) {
            refuse_sized_triples(", which begin with x, y and z, and a stated size: may be triples or a matrix");
            return {SurfaceFormat::triples, std::to_string(numbers_.columns) + " columns, the first two of which " +
                                                (table_.grid ? "form a grid" : "are called x and y")};
        }
        const NumberTable& table = numbers_;
        if (!sized_ && table.first > 0 &&
            !units_in(table.lines[table.first - 1].text, written_, table.dialect.separator).empty())
            refuse_form(" with a unit above each: may be columns of a profile or a matrix",
                        as("profile") + " with column, or " + as("matrix"));
        refuse_lone_axis();
        return {SurfaceFormat::matrix, counted(written_)};
    }

    Form form_of_three() const {
        if (table_.grid) {
            refuse_sized_triples(", of which two form a grid, and a stated size: may be x, y, z triples or a matrix");
            return {SurfaceFormat::triples, "three columns, the first two of which form a grid"};
        }
        refuse_thousands(numbers_, {points_[0], points_[1]}, false, name_);
        if (sized_ || (written_ != 3 && numbers_.words.empty()))
            return {SurfaceFormat::matrix, counted(written_) + " and a stated size"};
        refuse_form(
            " that begin with no regular grid, and no stated size: may be scattered triples, a matrix or a profile "
            "with a column to choose",
            as("triples") + " with " + options_.names.prefix + "grid, " + as("matrix") + ", or " + as("profile") +
                " with column");
    }

    void refuse_sized_triples(const std::string& what) const {
        if (sized_ && !table_.counts_pixels) refuse_form(what, as("triples") + " or " + as("matrix"));
    }

    /// Refuses a matrix whose size the header does not state and whose first row or column is positions, the other not.
    void refuse_lone_axis() const {
        if (stated_grid(table_.entries, "m", name_).has_size()) return;
        std::vector<double> row;
        for (const std::size_t c : points_) row.push_back(numbers_.at(0, c));
        const std::vector<double> column = column_of(numbers_, points_[0]);
        const bool in_column = column.size() >= 8 && equal_step(column, printed_step(numbers_, points_[0])) > 0;
        if (in_column || (row.size() >= 8 && equal_step(row, 0) > 0))
            refuse_file(name_, {"has a first ", in_column ? "column" : "row",
                                " that rises in equal steps, as positions do: may be columns of a profile, or a matrix "
                                "with one axis; give ",
                                as("profile"), " with column, or, if they are heights, by ", as("matrix")});
    }

    void choose_triples() {
        table_.axes.reset();
        if (points_.size() > 3 && (options_.grid || begins_with_triples()))
            points_ = {points_[0], points_[1], height_column()};
        if (points_.size() != 3) refuse_file(name_, {"has ", points_.size(), " columns; triples must have 3: x, y, z"});
        if (gives_size(options_) && !table_.counts_pixels)
            refuse_file(name_, {"holds x, y, z triples, whose size is in the file; dx, dy, width and height must not "
                                "be given"});
        table_.roles.assign(numbers_.columns, Role::unused);
        for (std::size_t k = 0; k < 3; ++k) table_.roles[points_[k]] = std::array{Role::x, Role::y, Role::heights}[k];
    }

    void choose_matrix() {
        if (table_.axes) table_.roles[0] = Role::axis;
        if (table_.axes && table_.axes->in_table) drop_first_row(numbers_);
        std::replace(table_.roles.begin(), table_.roles.end(), Role::open, Role::heights);
        const std::size_t columns = table_.columns(Role::heights).size(), rows = numbers_.rows();
        if (columns < 2 || rows < 2)
            refuse_file(name_, {"is a matrix of ", columns, " x ", rows, " points; must have at least 2 a side"});
    }

    void choose_profile() {
        const std::string x_option = of_words(options_.names, "x_column");
        check_chosen_columns(x_option);
        std::vector<Role>& roles = table_.roles;
        const std::size_t chosen = options_.column, x = options_.x_column;  // counted from 1; 0: none
        if (x != 0) roles[x - 1] = Role::x;
        if (chosen != 0 && roles[chosen - 1] == Role::index) roles[chosen - 1] = Role::open;
        const std::size_t most = x != 0 ? 1 : 2;
        if (chosen == 0 && table_.columns(Role::open).size() > most)
            for (const std::size_t c : table_.columns(Role::open))
                if (is_spare(numbers_, c, table_.titles[c])) roles[c] = Role::unused;
        std::vector<std::size_t> open = table_.columns(Role::open);
        if (chosen == 0 && open.size() == 2 && most == 2)  // heights next to their quality
            for (const std::size_t k : {std::size_t(0), std::size_t(1)})
                if (names_height(table_.titles[open[1 - k]].name) && names_other(table_.titles[open[k]])) {
                    roles[open[k]] = Role::unused;
                    open = {open[1 - k]};
                    break;
                }
        if (chosen == 0 && (open.empty() || open.size() > most))
            refuse_file(name_, {"has ", numbers_.columns,
                                " columns; must be one (heights) or two (positions and heights), or give the column of "
                                "the heights",
                                options_.spacing ? ", or of a map dx and dy in place of spacing" : ""});
        if (chosen == 0 && open.size() == 2 && are_exchanged(open[0], open[1])) std::swap(open[0], open[1]);
        const std::size_t heights = chosen != 0 ? chosen - 1 : open.back();
        roles[heights] = Role::heights;
        if (x != 0 || open.empty() || open.front() == heights) return;
        roles[open.front()] = Role::x;
        if (open.front() == 0 && !options_.spacing) refuse_count(heights, x_option);
    }

    void check_chosen_columns(const std::string& x_option) const {
        for (const auto& [option, column] : {std::pair<std::string, std::size_t>{"column", options_.column},
                                             std::pair<std::string, std::size_t>{x_option, options_.x_column}})
            if (column > numbers_.columns)
                refuse_field(name_, option, std::to_string(column),
                             "between 1 and " + std::to_string(numbers_.columns));
        if (options_.x_column == 0) return;
        if (options_.x_column == options_.column)
            refuse_field(name_, x_option, std::to_string(options_.x_column), "another column than that of the heights");
        if (options_.spacing) refuse_file(name_, {"spacing and ", x_option, " are both given; must be one of them"});
    }

    /// Whether the column \p first holds heights and \p second positions, which its title does not exclude.
    bool are_exchanged(std::size_t first, std::size_t second) const {
        const std::string &left = table_.titles[first].name, &right = table_.titles[second].name;
        return !names_position(left) && (!names_height(right) || names_position(right)) &&
               !rises_or_falls(numbers_, first) && rises_evenly(numbers_, second);
    }

    /// Without titles, a first column that counts next to one of equal steps may be either. \throws domain_error then.
    void refuse_count(std::size_t heights, const std::string& x_option) const {
        if (numbers_.columns < 3 || is_titled(table_.titles) || !counts_points(numbers_, 0, true)) return;
        for (std::size_t c = 1; c < numbers_.columns; ++c)
            if (c != heights && rises_evenly(numbers_, c))
                refuse_file(name_, {"counts the points in column 1, and column ", c + 1,
                                    " rises in equal steps: either may hold the positions; give ", x_option});
    }

    const std::string& name_;
    const SurfaceOptions& options_;
    TextTable table_{};
    NumberTable& numbers_ = table_.numbers;
    std::vector<std::size_t> points_{};  // columns of a map that may be x, y and z, in this order, and others
    std::size_t written_ = 0;            // columns in the first row
    bool sized_ = false;                 // a size of a map is given or stated
};

}  // namespace

std::vector<Role> first_roles(const NumberTable& table, const std::vector<ColumnTitle>& titles) {
    std::vector<Role> roles(table.columns, Role::open);
    if (table.columns < 2) return roles;
    for (std::size_t c = 0; c < table.columns; ++c)
        if (table.holds_words(c))
            roles[c] = Role::words;
        else if (titles[c].unit.empty() && names_index(titles[c].name) && counts_points(table, c, false))
            roles[c] = Role::index;
    if (roles[0] == Role::open && !names_length(titles[0]) &&
        std::any_of(titles.begin() + 1, titles.end(), names_length) && counts_points(table, 0, true))
        roles[0] = Role::index;
    return roles;
}

TextTable text_table(NumberTable opened, SurfaceFormat form, const std::string& name, const SurfaceOptions& options) {
    return RoleFinder(name, options).find(std::move(opened), form);
}

}  // namespace fstiff::inline v0_1::io::detail
