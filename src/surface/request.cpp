// SPDX-License-Identifier: BSD-3-Clause
#include "surface/request.hpp"

#include "document/file.hpp"
#include "surface/surface_option_table.hpp"

#include <cmath>

namespace fstiff::scene {

std::string Amount::text() const { return si_ ? shortest(*si_) : text_; }

double Amount::value(io::Dimension dimension, std::string_view name) const {
    if (!si_) return io::parse_quantity(text_, dimension, name);
    if (!std::isfinite(*si_)) throw domain_error({.parameter = name, .value = text(), .allowed = "finite"});
    return *si_;
}

double Amount::positive(io::Dimension dimension, std::string_view name) const {
    if (!si_) return parse_positive(text_, dimension, name);
    require_positive(name, *si_);
    return *si_;
}

std::string option_name(std::string_view prefix, std::string_view key) {
    return prefix.empty() ? std::string(key) : std::string(prefix) + with_dashes(key);
}

}  // namespace fstiff::scene
