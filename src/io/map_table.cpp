// SPDX-License-Identifier: BSD-3-Clause
#include "io/map_table.hpp"

namespace fstiff::inline v0_1::io::detail {

const NumberTable& MapTable::table(std::string_view missing) {
    if (!table_.row_lines.empty()) return table_;
    table_.missing = stated_missing(entries_, missing, name_);
    read_rows(table_, name_, map_rules);
    axes_ = is_zygo() ? std::nullopt : axes_of(table_);
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
    return table_;
}

bool MapTable::begins_with_triples() {
    if (table().columns < 4 || table_.columns > 12 || axes_) return false;
    if (titles_[columns_[0] - 1].name == "x" && titles_[columns_[1] - 1].name == "y") return true;
    return table_.rows() >= 9 && grid() && 2 * points_on(*grid(), table_) > grid()->x.count * grid()->y.count;
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

NumberTable MapTable::reopened(const TableRules& rules) && {
    SurfaceOptions options;
    options.names = table_.names;
    options.thousands = table_.thousands;
    return open_table(std::move(table_.lines), name_, rules, options, table_.before);
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

}  // namespace fstiff::inline v0_1::io::detail
