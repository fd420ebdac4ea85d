// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The functions of answer/law_fits.hpp.

#include <fstiff/answer/law_fits.hpp>
#include <fstiff/answer/laws.hpp>
#include <fstiff/asperity/laws.hpp>

namespace fstiff { inline namespace v0_1 { namespace detail {

FSTIFF_INLINE std::vector<std::string_view> fitted_law_names() {
    std::vector<std::string_view> names;
    for (const ChosenLaw& law : all_laws())
        if (law.row().varies) names.push_back(law.row().name);
    return names;
}

FSTIFF_INLINE bool has_exact_fit(LawKind law) {
    return law == LawKind::fractal || law == LawKind::fractal_consistent || law == LawKind::hertz;
}

FSTIFF_INLINE Identification<double> fit_exactly(LawKind law, const FitInputs& inputs) {
    const auto of_dimension = [law](double dimension) -> ElasticLaw<double> {  // one fit is compiled for all three
        if (law == LawKind::fractal) return FractalLaw<double>(dimension);
        if (law == LawKind::fractal_consistent) return FractalConsistentLaw<double>(dimension);
        return HertzLaw<double>{};
    };
    return identify(inputs.data, inputs.parameters, inputs.start, of_dimension, inputs.options);
}

FSTIFF_INLINE Identification<double> fit_curve(const FitInputs& inputs, const CurveOfParameters<double>& curve) {
    return detail::identify_by_differences(inputs.data, inputs.parameters, inputs.start, curve, inputs.options);
}

}}}  // namespace fstiff::detail
