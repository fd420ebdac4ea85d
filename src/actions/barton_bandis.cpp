// SPDX-License-Identifier: BSD-3-Clause
// The hyperbola of Barton and Bandis next to the fits of fstiff identify.
#include "actions/identify.hpp"
#include "document/shown_unit.hpp"

namespace fstiff::actions {

detail::BartonBandis<double> hyperbola_of(const MeasuredCurve& curve, const IdentifyRequest& request) {
    const std::string option = surface::option_name(request.prefix, "barton_bandis");
    if (curve.is_reflection)
        throw document::option_error(option + " is for measured stiffnesses; " + curve.name + " holds reflections");
    if (curve.computed.size() > 1)
        throw document::option_error(option + " is for one curve; " + curve.name + " holds " +
                                     std::to_string(curve.computed.size()));
    std::vector<Observation<double>> data;
    for (const MeasuredPoint& point : curve.points) data.push_back({point.pressure, point.value, point.error});
    return detail::located(Place{.file = curve.name}, [&] { return detail::fit_barton_bandis(data); });
}

void add_hyperbola(document::Document& document, const detail::BartonBandis<double>& fit) {
    document::Json& entry = document.json["barton_bandis"];
    entry["status"] = name_of(fit.status);
    document.line("\nBarton-Bandis, K = K_n0 (1 - p/(V_m K_n0 + p))^-2: " + std::string(name_of(fit.status)));
    if (fit.status != math::FitStatus::converged) return;
    const auto add = [&](const char* key, const char* shown, const detail::HyperbolaParameter<double>& parameter,
                         const char* unit) {
        document::Json& number = entry[key];
        number = {{"value", parameter.value}, {"unit", unit}};
        std::string text = document::with_unit(parameter.value, unit, 4);
        if (fit.has_errors) {
            number["standard_error"] = parameter.standard_error;
            number["interval"] = {{"level", 0.95}, {"low", parameter.low}, {"high", parameter.high}};
            text += ", standard error " + document::with_unit(parameter.standard_error, unit, 2) + ", 95 % from " +
                    document::with_unit(parameter.low, unit, 3) + " to " + document::with_unit(parameter.high, unit, 3);
        }
        document.line(shown, text);
    };
    add("initial_stiffness", "K_n0", fit.initial_stiffness, "Pa/m");
    add("closure", "V_m", fit.closure, "m");
    entry["chi_squared"] = fit.chi_squared;
    entry["degrees_of_freedom"] = fit.degrees_of_freedom;
    entry["errors_known"] = fit.errors_known;
    if (fit.degrees_of_freedom < 1) return;
    document.line("fit", fit.errors_known ? "chi²/dof " + document::rounded(fit.chi_squared / fit.degrees_of_freedom, 3)
                                          : "the points scatter by " + document::rounded(100 * fit.scatter, 2) + " %");
}

}  // namespace fstiff::actions
