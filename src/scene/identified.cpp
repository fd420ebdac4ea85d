// SPDX-License-Identifier: BSD-3-Clause
#include "scene/identified.hpp"

#include "document/file.hpp"
#include "io/number.hpp"
#include "scene/result_rows.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fstiff::scene {
namespace {

/// An interval of data with little information may end beyond the range of numbers: the cell is then empty.
Json finite_json(double value) { return std::isfinite(value) ? value : Json(nullptr); }

/// Measured value, model and residual are in these units.
struct ShownValue {
    std::string_view name, unit, column;
    double factor;
};
ShownValue shown_value(const MeasuredCurve& curve) {
    return curve.is_reflection ? ShownValue{"|R|", "", "reflection", 1}
                               : ShownValue{"K/A0", " [GPa/µm]", "stiffness_Pa_per_m", 1e-15};
}

Json matrix_json(const Eigen::MatrixXd& matrix) {
    Json rows = Json::array();
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
        Json row = Json::array();
        for (Eigen::Index k = 0; k < matrix.cols(); ++k) row.push_back(finite_json(matrix(i, k)));
        rows.push_back(std::move(row));
    }
    return rows;
}

Json parameter_json(const Fit& fit, const parts::IdentifiedParameter<double>& p) {
    const parts::ParameterRow& row = parts::row_of(p.parameter);
    Json one{{"name", row.short_name}, {"unit", row.unit}, {"start", fit.start[p.parameter]}};
    if (fit.found.status == math::FitStatus::singular)
        one["null_share"] = p.null_share;
    else
        one["value"] = p.value;
    if (p.at_bound) one["at_bound"] = true;
    if (fit.found.covariance.size() > 0) {
        one["standard_error"] = finite_json(p.standard_error);
        one["interval"] = {{"level", 0.95}, {"low", finite_json(p.low)}, {"high", finite_json(p.high)}};
        one["interval_with_law"] = {
            {"level", 0.95}, {"low", finite_json(p.low_with_law)}, {"high", finite_json(p.high_with_law)}};
    }
    return one;
}

Json fit_json(const MeasuredCurve& curve, const Fit& fit) {
    const auto& found = fit.found;
    Json entry{{"law", fit.law->name}};
    if (fit.theta) entry["theta"] = *fit.theta, entry["r"] = *fit.r;
    entry["status"] = name_of(found.status);
    entry["chi_squared"] = found.chi_squared;
    entry["degrees_of_freedom"] = found.degrees_of_freedom;
    entry["errors_known"] = found.errors_known;
    entry["evaluations"] = found.evaluations;
    Json& concerns = entry["concerns"] = Json::array();
    for (const auto& finding : concerns_of(found)) concerns.push_back(name_of(finding.concern));
    Json& parameters = entry["parameters"] = Json::array();
    for (const auto& p : found.parameters) parameters.push_back(parameter_json(fit, p));
    if (found.covariance.size() > 0) {
        entry["covariance"] = matrix_json(found.covariance);
        entry["correlation"] = matrix_json(found.correlation);
    }
    if (found.status != math::FitStatus::singular) rows_of(curve, fit).append_to(entry["rows"] = Json::array());
    return entry;
}

}  // namespace

std::vector<Parameter> parameters_of(const IdentifyRequest& request) {
    std::vector<Parameter> wanted;
    const std::string option = option_name(request.prefix, "fit");
    for (const std::string& written : request.fit) {
        const std::string name(io::detail::trimmed(written));
        const auto found =
            std::find_if(parts::parameter_table.begin(), parts::parameter_table.end(),
                         [&](const parts::ParameterRow& row) { return name == row.short_name || name == row.key; });
        if (found == parts::parameter_table.end())
            throw option_error(option + ": \"" + name + "\" is not a parameter; must be one of " +
                               list_of(parameter_short_names));
        if (std::count(wanted.begin(), wanted.end(), found->parameter) > 0)
            throw option_error(option + ": \"" + name + "\" is listed twice");
        wanted.push_back(found->parameter);
    }
    return wanted;
}

Identified identify_scene(const Scene& scene, const IdentifyRequest& request, std::optional<MeasuredCurve> curve) {
    Identified all;
    all.wanted = parameters_of(request);
    all.curve = curve ? *std::move(curve) : read_measured_curve(request.measured);
    all.found = identify(scene, all.curve, {all.wanted, request.law, request.wave == WaveKind::shear, request.prefix});
    return all;
}

Rows rows_of(const MeasuredCurve& curve, const Fit& fit) {
    const ShownValue y = shown_value(curve);
    std::vector<double> pressures, values, errors;
    for (const MeasuredPoint& point : fit.points) {
        pressures.push_back(point.pressure);
        values.push_back(point.value);
        if (curve.has_errors) errors.push_back(point.error);
    }
    Rows rows;
    rows.add({"pressure_Pa", "p [MPa]", 1e-6}, pressures);
    rows.add({std::string(y.column), std::string(y.name) + " measured" + std::string(y.unit), y.factor}, values);
    if (curve.has_errors) rows.add({"error"}, errors);
    rows.add({"model", "model", y.factor}, fit.found.model);
    rows.add({"residual", fit.found.errors_known ? "residual [errors]" : "residual [scatter]", 1, 3},
             fit.found.residuals);
    return rows;
}

Answer answer_of(const Scene& scene, const Identified& identified) {
    const MeasuredCurve& curve = identified.curve;
    Json document = json_document("identify");
    document["scene"] = scene_json(scene);
    document["measured"] = {{"file", curve.name},
                            {"sha256", curve.sha256},
                            {"quantity", curve.is_reflection ? "reflection" : "stiffness"},
                            {"has_errors", curve.has_errors},
                            {"decisions", curve.decisions}};
    if (const auto& wave = identified.found.wave)
        document["wave"] = {{"angular_frequency_rad_per_s", wave->angular_frequency},
                            {"impedance_Rayl", wave->media.incident},
                            {"impedance2_Rayl", wave->media.beyond},
                            {"stiffness_ratio", wave->stiffness_ratio}};
    Json& fits = document["fits"] = Json::array();
    for (const Fit& fit : identified.found.fits) fits.push_back(fit_json(curve, fit));
    return {std::move(document), identified.found.warnings, identified.found.doubtful};
}

}  // namespace fstiff::scene
