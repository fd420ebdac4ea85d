// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The unit of the heights of a matrix: of the options, or stated as a unit, a conversion factor or SPIP's Bit2nm.
///
/// Units       m

#include "io/header.hpp"

namespace fstiff::inline v0_1::io::detail {

struct MatrixUnit {
    double factor{};             // [m]
    std::string shown;           // for messages
    std::string text, from;      // for a record
    std::string contradicted{};  // of the options: the place in the file that states another, and which; empty for none
};

/// The unit of the options, \p given or empty, or the one that the header states. \throws domain_error without one.
MatrixUnit matrix_unit(const std::vector<HeaderEntry>& entries, std::string_view given, const std::string& name,
                       const OptionNames& names);

}  // namespace fstiff::inline v0_1::io::detail
