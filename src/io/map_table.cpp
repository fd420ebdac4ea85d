// SPDX-License-Identifier: BSD-3-Clause
#include "io/map_table.hpp"

namespace fstiff::inline v0_1::io::detail {

const NumberTable& MapTable::table(std::string_view missing) {
    if (!table_.row_lines.empty()) return table_;
    table_.missing = stated_missing(entries_, missing, name_);
    read_rows(table_, name_);
    axes_ = is_zygo() || !table_.words.empty() ? std::nullopt : axes_of(table_);
    if (axes_ && axes_->in_table && states_other_count()) axes_.reset();
    titles_ = titles_above(table_);
    titles_.resize(table_.columns);
    written_ = written_titles(table_);
    for (std::size_t c = 1; c <= table_.columns; ++c) columns_.push_back(c);
    if (const auto index = axes_ || is_zygo() ? std::vector<bool>() : index_columns(table_); !index.empty()) {
        std::vector<std::size_t> kept;
        for (std::size_t c = 0; c < table_.columns; ++c)
            if (!index[c]) kept.push_back(c);
        keep_columns(kept);
    }
    if (!axes_) order_columns();
    return table_;
}

void MapTable::order_columns() {
    const std::size_t none = columns_.size();
    std::array<std::size_t, 3> found{none, none, none};
    for (std::size_t c = 0; c < columns_.size(); ++c) {
        const std::string& title = titles_[columns_[c] - 1].name;
        for (std::size_t k = 0; k < 3; ++k) {
            if (k < 2 ? title != (k == 0 ? "x" : "y") : !names_height(title)) continue;
            if (found[k] != none) return;
            found[k] = c;
        }
    }
    const bool in_place = found == std::array<std::size_t, 3>{0, 1, 2};
    if (*std::max_element(found.begin(), found.end()) == none || in_place) return;
    keep_columns({found.begin(), found.end()});
}

bool MapTable::begins_with_triples() {
    if (table().columns < 4 || table_.columns > 12 || axes_) return false;
    if (titles_[columns_[0] - 1].name == "x" && titles_[columns_[1] - 1].name == "y") return true;
    if (counts_pixels()) return true;
    return table_.rows() >= 9 && grid() && 2 * points_on(*grid(), table_) > grid()->x.count * grid()->y.count;
}

std::size_t MapTable::columns_of_lengths() {
    std::vector<ColumnTitle> titles;  // of the columns that are kept
    for (const std::size_t column : columns_) titles.push_back(titles_[column - 1]);
    const std::vector<bool> spare = spare_columns(table(), titles);
    return static_cast<std::size_t>(std::count(spare.begin(), spare.end(), false));
}

bool MapTable::counts_pixels() {
    if (table().columns < 3 || !grid() || grid()->x.step != 1 || grid()->y.step != 1) return false;
    const auto names_pixel = [&](std::size_t c) {
        static constexpr std::array<std::string_view, 16> words{
            "col", "column", "row",     "line",    "pixel",   "px",      "ix",   "iy",
            "i",   "j",      "pixel x", "pixel y", "x pixel", "y pixel", "x px", "y px"};
        const ColumnTitle& title = titles_[columns_[c] - 1];
        const std::string unit = lower_case(title.unread);
        return !title.has_unit && (std::find(words.begin(), words.end(), title.name) != words.end() || unit == "px" ||
                                   unit == "pixel" || unit == "pixels");
    };
    return names_pixel(0) && names_pixel(1);
}

std::string MapTable::triples_from() {
    return std::to_string(titles_.size()) + " columns, the first two of which " +
           (grid() ? "form a grid" : "are called x and y");
}

void MapTable::require_no_lone_axis(const OptionNames& names) const {
    if (axes_ || table_.columns < 3 || stated_grid(entries_, "m", name_).has_size()) return;
    std::vector<double> row, column;
    for (std::size_t c = 0; c < table_.columns; ++c) row.push_back(table_.at(0, c));
    for (std::size_t r = 0; r < table_.rows(); ++r) column.push_back(table_.at(r, 0));
    const bool in_column = column.size() >= 8 && equal_step(column, table_.printed[0].resolution()) > 0;
    if (in_column || (row.size() >= 8 && equal_step(row, 0) > 0))
        refuse_file(name_, {"has a first ", in_column ? "column" : "row",
                            " that rises in equal steps, as positions do: may be columns of a profile, or a matrix "
                            "with one axis; give ",
                            format_as(names, "profile"), " with column, or, if they are heights, by ",
                            format_as(names, "matrix")});
}

const std::optional<Grid>& MapTable::grid() {
    if (!grid_) grid_ = table().columns < 3 ? std::nullopt : grid_of(table_);
    return *grid_;
}

NumberTable MapTable::unread() && {
    table_.forget_rows();
    return std::move(table_);
}

bool MapTable::states_other_count() const {
    const StatedGrid stated = stated_grid(entries_, "m", name_);
    return stated.columns ? *stated.columns == table_.columns : stated.has_size();
}

void MapTable::keep_columns(const std::vector<std::size_t>& kept) {
    std::vector<std::size_t> columns;
    std::vector<PrintedDigits> printed;
    for (const std::size_t c : kept) {
        columns.push_back(columns_[c]);
        printed.push_back(c < table_.printed.size() ? table_.printed[c] : PrintedDigits());
    }
    for (std::size_t r = 0; r < table_.rows(); ++r) {
        std::vector<double> row;
        for (const std::size_t c : kept) row.push_back(table_.at(r, c));
        std::copy(row.begin(), row.end(), table_.values.data() + r * kept.size());
    }
    table_.columns = kept.size();
    table_.values.resize(table_.rows() * table_.columns);
    table_.printed = std::move(printed);
    columns_ = std::move(columns);
}

std::size_t MapTable::height_column() const {
    std::vector<std::size_t> named, with_unit;
    for (std::size_t c = 2; c < columns_.size(); ++c) {
        const ColumnTitle& title = titles_[columns_[c] - 1];
        if (names_height(title.name) || names_depth(title.name)) named.push_back(c);
        if (title.has_unit) with_unit.push_back(c);
    }
    const auto& found = named.size() == 1 ? named : with_unit;
    return found.size() == 1 ? found.front() : 2;
}

PointCloud MapTable::cloud(const std::array<double, 3>& units, const std::array<std::string, 3>& unit_names) const {
    PointCloud cloud{.units = units, .unit_names = unit_names};
    for (std::size_t r = 0; r < table_.rows(); ++r)
        cloud.points.push_back({table_.at(r, 0), table_.at(r, 1), table_.at(r, 2)});
    return cloud;
}

}  // namespace fstiff::inline v0_1::io::detail
