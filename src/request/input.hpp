// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The record of one value of a request.

#include <optional>
#include <string>

namespace fstiff::request {

/// One key of a scene as its author wrote it, and what it came to in SI units.
struct Input {
    std::string key;      ///< path, such as "surface.rms_height"
    std::string written;  ///< the text of the scene
    std::optional<double> value;
    std::string unit;   ///< SI unit of value; empty when it has none
    bool given = true;  ///< in the text of the scene

    [[nodiscard]] std::string shown() const { return given ? written : written + " (default)"; }  ///< as printed
};

}  // namespace fstiff::request
