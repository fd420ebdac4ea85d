// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// An axis with its range: the place of a value on it, and its ticks, all written in one style.

#include "picture/plot.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace fstiff::cli {

struct Tick {
    double value;
    std::string label;  ///< empty: a fainter line without a number
};

class Scale {
public:
    /// Scale of \p axis for \p values. Close values get room about them.
    Scale(const Axis& axis, const std::vector<double>& values);
    bool shows(double value) const { return std::isfinite(value) && (!logarithmic_ || value > 0); }
    /// 0 at the lower end, 1 at the upper one.
    double operator()(double value) const { return (place(value) - low_) / (high_ - low_); }
    double low() const { return logarithmic_ ? std::pow(10.0, low_) : low_; }
    double high() const { return logarithmic_ ? std::pow(10.0, high_) : high_; }
    std::vector<Tick> ticks() const { return logarithmic_ ? decades() : steps(); }

private:
    double place(double value) const { return logarithmic_ ? std::log10(value) : value; }
    std::vector<Tick> decades() const;
    std::vector<Tick> steps() const;

    bool logarithmic_;
    double low_, high_;
};

}  // namespace fstiff::cli
