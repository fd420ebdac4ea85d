// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The pictures of a scene's results: what `run --plot` draws and the report shows.

#include "picture/plot.hpp"
#include "scene/results.hpp"

#include <functional>
#include <optional>
#include <string_view>
#include <utility>

namespace fstiff::cli {

/// "π/4", or the angle in five digits.
std::string shown_angle(double theta);
/// "fractal, θ = π/4, r = 0" for a legend.
std::string legend_of(std::string_view law, std::optional<double> theta, std::optional<double> r);
std::string legend_of(const Curve& curve);

/// From the ends of a band of K to those of what is drawn.
using Ends = std::function<std::pair<double, double>(const parts::SampledBand<double>&)>;

/// K(p) of all curves, with the bands there are.
Panel stiffness_panel(const Problem& problem, const Results& results);
/// One panel of a quantity of the states against the pressure, with \p ends of its band where it is given.
Panel quantity_panel(const Results& results, Axis axis, const std::function<double(const ContactState<double>&)>& value,
                     const Ends& ends = {});
/// "8 of 30 curves are drawn": more cannot be distinguished; empty where all are.
std::string left_out(const Results& results);
/// |R| of longitudinal waves, and of shear waves where they are known; none without [ultrasound].
std::vector<Panel> reflection_panels(const Problem& problem, const Results& results);
/// Panels of quantities that follow from K and are asked for: loss factor and conductances, each with its band.
std::vector<Panel> panels_after_stiffness(const Scene& scene, const Results& results);

/// Picture of `run --plot`. \throws domain_error when the scene asks for no stiffness.
Figure results_figure(const Scene& scene, const Results& results);

}  // namespace fstiff::cli
