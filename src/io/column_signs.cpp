// SPDX-License-Identifier: BSD-3-Clause
#include "io/column_signs.hpp"

namespace fstiff::inline v0_1::io::detail {

void ColumnSigns::add(std::string_view cell, double value, std::size_t line, std::string_view sign) {
    if (decimal_) return;
    const double size = std::abs(value);
    if (is_grouped(cell, sign)) {
        if (groups_++ == 0) grouped_ = {std::string(cell), line};
        largest_group_ = (std::max)(largest_group_, size);
        smallest_group_ = (std::min)(smallest_group_, size);
    } else if (cell.find_first_not_of("+-0123456789") == std::string_view::npos) {
        if (wholes_++ == 0) whole_ = {std::string(cell), line};
        largest_whole_ = (std::max)(largest_whole_, size);
        sum_of_whole_ += size;
    } else {
        decimal_ = true;
    }
}

namespace {

constexpr std::string_view digits = "0123456789";

/// Whether \p cell is three digits, with decimals or none.
bool is_group(std::string_view cell) {
    if ((std::min)(cell.find_first_not_of(digits), cell.size()) != 3) return false;
    return cell.size() == 3 ||
           ((cell[3] == '.' || cell[3] == ',') && cell.find_first_not_of(digits, 4) == std::string_view::npos);
}

/// Whether \p cell is one to three digits that begin with no zero.
bool begins_groups(std::string_view cell) {
    if (cell.starts_with('-') || cell.starts_with('+')) cell.remove_prefix(1);
    return !cell.empty() && cell.size() <= 3 && cell[0] != '0' &&
           cell.find_first_not_of(digits) == std::string_view::npos;
}

}  // namespace

void ColumnSigns::add_pair(std::string_view before, std::string_view cell, char separator, std::size_t line) {
    if (!pairs_) return;
    const char* const end = before.data() + before.size();
    pairs_ = is_group(cell) && begins_groups(before) && end + 1 == cell.data() && *end == separator;
    if (pairs_ && cell[0] == '0' && zero_line_ == 0) zero_line_ = line;
}

void ColumnSigns::add(const ColumnSigns& other) {
    const auto take_first = [](Place& own, const Place& one) {
        if (own.line == 0 || (one.line != 0 && one.line < own.line)) own = one;
    };
    decimal_ = decimal_ || other.decimal_;
    groups_ += other.groups_, wholes_ += other.wholes_;
    largest_group_ = (std::max)(largest_group_, other.largest_group_);
    smallest_group_ = (std::min)(smallest_group_, other.smallest_group_);
    largest_whole_ = (std::max)(largest_whole_, other.largest_whole_);
    sum_of_whole_ += other.sum_of_whole_;
    take_first(grouped_, other.grouped_);
    take_first(whole_, other.whole_);
}

bool ColumnSigns::may_be_thousands(bool known) const {
    if (decimal_ || groups_ == 0 || wholes_ == 0) return false;
    // some languages separate thousands from 10 000 on only
    if (!(largest_whole_ < 10000 && largest_whole_ < 1000 * smallest_group_)) return false;
    const bool may_lack_zeros = groups_ < 50 || largest_whole_ == 0;
    return !(known && may_lack_zeros && sum_of_whole_ <= 2 * largest_group_ * static_cast<double>(wholes_));
}

}  // namespace fstiff::inline v0_1::io::detail
