// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The table and the picture of a surface with other cut-offs: fstiff measure --scales, and the report.

#include "document/document.hpp"
#include "picture/plot.hpp"
#include "scene/scales.hpp"

#include <string>

namespace fstiff::cli {

/// One row a pair of cut-offs, those of lambda_s first.
[[nodiscard]] Rows scales_rows(const Scales& scales);
/// The same for people, with what of K is settled.
[[nodiscard]] std::string scales_text(const Scales& scales, const ScalesOptions& how);
/// sigma, gradient, R, D_p and K over those with the chosen cut-offs, against lambda_s and against lambda_c.
[[nodiscard]] std::vector<Panel> scales_panels(const Scales& scales);

}  // namespace fstiff::cli
