// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Parameters of a law from a measured curve, for a law that is known by name. Compiled in fstiff::double alone.

#include <fstiff/answer/law_names.hpp>
#include <fstiff/identify/differences.hpp>
#include <fstiff/identify/identify.hpp>

#include <string_view>
#include <vector>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// A measured curve and how it is fitted.
struct FitInputs {
    const std::vector<Observation<double>>& data;
    const std::vector<Parameter>& parameters;
    ContactParameters<double> start;
    IdentifyOptions<double> options;
};

/// The laws that can be fitted.
[[nodiscard]] std::vector<std::string_view> fitted_law_names();
/// Whether \p law has exact derivatives by its parameters.
[[nodiscard]] bool has_exact_fit(LawKind law);
/// Fits \p law, which has exact derivatives. \throws as fstiff::identify.
[[nodiscard]] Identification<double> fit_exactly(LawKind law, const FitInputs& inputs);
/// Fits the parameters of any curve, by differences. \throws as detail::identify_by_differences.
[[nodiscard]] Identification<double> fit_curve(const FitInputs& inputs, const CurveOfParameters<double>& curve);

}}}  // namespace fstiff::detail
