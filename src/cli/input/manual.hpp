// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace fstiff::cli {

/// Page \p name of section 1 of the manual, in roff, with what \p help prints; \p also are the pages to see.
[[nodiscard]] std::string manual_page(const std::string& name, const std::string& version, const std::string& help,
                                      const std::vector<std::string>& also);

}  // namespace fstiff::cli
