// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The roughness parameters of the standards, of what fstiff measure has measured.

#include "surface/surface_file.hpp"

#include <optional>
#include <string>
#include <vector>

namespace fstiff::actions {

/// One parameter by its symbol in the standard.
struct RoughnessLine {
    std::string symbol, unit;     ///< Ra and m; no unit: a plain number
    std::optional<double> value;  ///< none where it is not defined
    std::string meaning;          ///< what it is, or the reason why there is none
};

struct RoughnessTable {
    std::string standard;  ///< "ISO 21920-2:2021"
    std::vector<RoughnessLine> lines;
    std::string sections;      ///< how the sections of a profile were chosen; empty of a map
    double section_length{};   ///< [m]; 0 of a map
    CutOffs<double> cut_offs;  ///< that these parameters have: lambda_c of a profile is that of the standard
    std::size_t files = 1;     ///< whose means these are
};

/// Parameters of the existing heights, about their mean. \throws domain_error for a surface out of range.
/// A profile without lambda_c takes \p lambda_c, by default that of the standard's table.
[[nodiscard]] RoughnessTable roughness_table(const PreparedProfile<double>& levelled,
                                             const CutOff<double>& lambda_c = {});
[[nodiscard]] RoughnessTable roughness_table(const PreparedMap<double>& levelled);

/// The means of \p tables, of one kind of surface; none where one of them has none.
[[nodiscard]] RoughnessTable mean_of(const std::vector<RoughnessTable>& tables);

}  // namespace fstiff::actions
