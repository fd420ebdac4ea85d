// SPDX-License-Identifier: BSD-3-Clause
#include "actions/identify.hpp"

#include "actions/run.hpp"
#include "document/file.hpp"
#include "document/shown_unit.hpp"
#include "io/number.hpp"

#include <fstiff/answer/concerns.hpp>
#include <fstiff/answer/laws.hpp>
#include <fstiff/wave/spring_interface.hpp>
#include <fstiff/wave/uncertain_reflection.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace fstiff::actions {

using document::Cell, document::Json, document::Rows;

namespace {

/// "sigma, g and E", in the order of --fit.
std::string names_of(const std::vector<Parameter>& parameters) {
    std::string text;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const char* const between = i == 0 ? "" : i + 1 == parameters.size() ? " and " : ", ";
        text.append(between).append(detail::row_of(parameters[i]).short_name);
    }
    return text;
}

Json matrix_json(const Eigen::MatrixXd& matrix) {
    Json rows = Json::array();
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
        Json row = Json::array();
        for (const double value : matrix.row(i)) row.push_back(Cell::finite(value).json());
        rows.push_back(std::move(row));
    }
    return rows;
}

Json parameter_json(const Fit& fit, const IdentifiedParameter<double>& p) {
    const detail::ParameterRow& row = detail::row_of(p.parameter);
    Json entry{{"name", row.short_name}, {"unit", row.unit}, {"start", fit.start[p.parameter]}};
    if (fit.found.status == math::FitStatus::singular)
        entry["null_share"] = p.null_share;
    else
        entry["value"] = p.value;
    if (p.at_bound) entry["at_bound"] = true;
    if (fit.found.covariance.size() > 0) {
        const auto interval = [](double low, double high) -> Json {
            return {{"level", 0.95}, {"low", Cell::finite(low).json()}, {"high", Cell::finite(high).json()}};
        };
        entry["standard_error"] = Cell::finite(p.standard_error).json();
        entry["interval"] = interval(p.low, p.high);
        entry["interval_with_law"] = interval(p.low_with_law, p.high_with_law);
    }
    return entry;
}

/// Measured and fitted values at the points of \p fit.
Rows point_rows(const MeasuredCurve& curve, const Fit& fit) {
    std::vector<double> values;
    for (const MeasuredPoint& point : curve.points) values.push_back(point.value);
    const document::ShownUnit unit = document::shown_unit(values, "Pa/m");
    const document::Heading value =
        curve.is_reflection ? document::Heading{"reflection", "|R| measured"}
                            : document::Heading{"stiffness_Pa_per_m", unit.heading("K/A0 measured"), unit.factor};
    Rows rows;
    rows.add({"pressure_Pa", "p [MPa]", 1e-6}, fit.points, &MeasuredPoint::pressure);
    rows.add(value, fit.points, &MeasuredPoint::value);
    if (curve.has_errors) rows.add({"error"}, fit.points, &MeasuredPoint::error);
    rows.add({"model", "model", value.factor}, fit.found.model);
    rows.add({"residual", fit.found.errors_known ? "residual [errors]" : "residual [scatter]", 1, 3},
             fit.found.residuals);
    return rows;
}

/// The fitted model from the least pressure to the greatest, at enough pressures for a smooth picture.
Json curve_json(const detail::ResolvedJoint& problem, const Identified& identified, const Fit& fit) {
    constexpr int steps = 40;
    const auto [least, most] = std::minmax_element(
        fit.points.begin(), fit.points.end(), [](const auto& a, const auto& b) { return a.pressure < b.pressure; });
    std::vector<double> pressures, loads;
    for (int k = 0; k <= steps; ++k) {
        const double p = least->pressure * std::pow(most->pressure / least->pressure, double(k) / steps);
        pressures.push_back(p);
        loads.push_back(std::max(p + fit.found.optimum.offset, 1e-6 * p));
    }
    const auto& wave = identified.found.wave;
    std::vector<ContactPoint<double>> points = fitted_points(problem, fit, loads);
    Rows rows;
    rows.add({"pressure_Pa"}, pressures);
    rows.add({wave ? "reflection" : "stiffness_Pa_per_m"}, points, [&](const ContactPoint<double>& point) {
        const double K = point.state.stiffness.value;
        return !point.ok() ? Cell()
               : wave      ? Cell(reflection(wave->seen(K), wave->media, wave->angular_frequency))
                           : Cell(K);
    });
    return rows.arrays();
}

Json fit_json(const detail::ResolvedJoint& problem, const Identified& identified, const Fit& fit) {
    const auto& identification = fit.found;
    Json entry{{"law", fit.law->name}};
    if (fit.theta) entry["theta"] = *fit.theta, entry["r"] = *fit.r;
    entry["status"] = name_of(identification.status);
    entry["chi_squared"] = identification.chi_squared;
    entry["degrees_of_freedom"] = identification.degrees_of_freedom;
    entry["errors_known"] = identification.errors_known;
    entry["evaluations"] = identification.evaluations;
    Json& concerns = entry["concerns"] = Json::array();
    for (const auto& finding : detail::concerns_of(identification)) concerns.push_back(name_of(finding.concern));
    Json& parameters = entry["parameters"] = Json::array();
    for (const auto& p : identification.parameters) parameters.push_back(parameter_json(fit, p));
    if (identification.covariance.size() > 0) {
        entry["covariance"] = matrix_json(identification.covariance);
        entry["correlation"] = matrix_json(identification.correlation);
    }
    if (identification.status == math::FitStatus::singular) return entry;
    point_rows(identified.curve, fit).append_to(entry["rows"] = Json::array());
    entry["curve"] = curve_json(problem, identified, fit);
    return entry;
}

/// What is fitted to what.
void introduce(document::Document& document, const scene::Scene& scene, const Identified& identified) {
    const MeasuredCurve& curve = identified.curve;
    const auto [least, most] = std::minmax_element(
        curve.points.begin(), curve.points.end(), [](const auto& a, const auto& b) { return a.pressure < b.pressure; });
    document.title("parameters of " + document::printable(scene.name + " (" + scene.file + ")") + " from " +
                   (curve.is_reflection ? "R(p)" : "K(p)") + " of " + document::printable(curve.name));
    document.line(
        "measured",
        std::to_string(curve.points.size()) + " points, p " + document::rounded(least->pressure / 1e6) + " to " +
            document::rounded(most->pressure / 1e6) + " MPa, " +
            (curve.has_errors ? "weighed by their errors" : "no errors: equal weights, errors from the scatter"));
    if (!curve.left_out.empty()) document.line("left out", curve.left_out);
    if (!scene.assumptions.empty()) {
        InputLine assumed{"assumed", scene.assumptions};
        assumed.parts.emplace_back("which the intervals leave out");
        document.text([text = in_lines(assumed)] { return text; });
        document.json["assumed"] = scene.assumptions;
    }
    document.json["scene"] = scene_json(scene);
    document.json["measured"] = {{"file", curve.name},
                                 {"sha256", curve.sha256},
                                 {"quantity", curve.is_reflection ? "reflection" : "stiffness"},
                                 {"has_errors", curve.has_errors},
                                 {"decisions", curve.decisions}};
    if (!curve.left_out.empty()) document.json["measured"]["left_out"] = curve.left_out;
    const auto& wave = identified.found.wave;
    if (!wave) return;
    document.json["wave"] = {{"angular_frequency_rad_per_s", wave->angular_frequency},
                             {"impedance_Rayl", wave->media.incident},
                             {"impedance2_Rayl", wave->media.beyond},
                             {"stiffness_ratio", wave->stiffness_ratio}};
    if (wave->film_stiffness > 0) document.json["wave"]["film_stiffness_Pa_per_m"] = wave->film_stiffness;
    document.line(
        "wave",
        document::rounded(wave->angular_frequency / (2 * std::numbers::pi) / 1e6) + " MHz, impedances " +
            document::rounded(wave->media.incident / 1e6) + " and " + document::rounded(wave->media.beyond / 1e6) +
            " MRayl, sees " + (wave->stiffness_ratio == 1 ? "K" : document::rounded(wave->stiffness_ratio) + " K") +
            (wave->film_stiffness > 0 ? " and a film of " + document::with_unit(wave->film_stiffness, "Pa/m") : ""));
}

/// A row for each parameter of \p fit: in SI for the CSV, in the units of headings for people.
Rows parameter_rows(const Identified& identified, const Fit& fit) {
    using P = IdentifiedParameter<double>;
    const auto& identification = fit.found;
    const std::vector<P>& estimates = identification.parameters;
    const bool has_errors = identification.covariance.size() > 0,
               singular = identification.status == math::FitStatus::singular;
    const auto row = [](const P& p) -> const detail::ParameterRow& { return detail::row_of(p.parameter); };
    Rows rows;
    rows.repeat({"law"}, fit.law->name, estimates.size());
    rows.repeat({"theta"}, fit.theta, estimates.size());
    rows.repeat({"r"}, fit.r, estimates.size());
    rows.repeat({"status"}, name_of(identification.status), estimates.size());
    rows.repeat({"chi_squared"}, identification.chi_squared, estimates.size());
    rows.repeat({"degrees_of_freedom"}, identification.degrees_of_freedom, estimates.size());
    rows.add({"parameter"}, estimates, [&](const P& p) { return row(p).short_name; });
    rows.add({"unit"}, estimates, [&](const P& p) { return row(p).unit; });
    rows.add({"", "parameter"}, estimates, [&](const P& p) { return row(p).heading(); });
    const auto add = [&](const char* key, const char* shown, int digits, bool known, const auto& value) {
        rows.add({key}, estimates, [&](const P& p) { return known ? Cell::finite(value(p)) : Cell(); });
        rows.add({"", shown, 1, digits}, estimates,
                 [&](const P& p) { return known ? Cell::finite(value(p) * row(p).shown_factor) : Cell(); });
    };
    add("start", "start", 5, true, [&](const P& p) { return fit.start[p.parameter]; });
    add("value", "estimate", 5, !singular, [](const P& p) { return p.value; });
    add("standard_error", "standard error", 2, has_errors, [](const P& p) { return p.standard_error; });
    add("low", "95 % from", 5, has_errors, [](const P& p) { return p.low; });
    add("high", "to", 5, has_errors, [](const P& p) { return p.high; });
    add("low_with_law", "with the law's error", 2, has_errors, [](const P& p) { return p.low_with_law; });
    add("high_with_law", "to", 2, has_errors, [](const P& p) { return p.high_with_law; });
    for (std::size_t k = 0; k < identified.wanted.size(); ++k)
        rows.add({"correlation_" + std::string(detail::row_of(identified.wanted[k]).short_name)}, estimates,
                 [&](const P& p) {
                     return has_errors
                                ? Cell(identification.correlation(&p - estimates.data(), static_cast<Eigen::Index>(k)))
                                : Cell();
                 });
    return rows;
}

Rows correlation_rows(const std::vector<Parameter>& wanted, const Eigen::MatrixXd& correlation) {
    const auto name = [](Parameter parameter) { return std::string(detail::row_of(parameter).short_name); };
    Rows rows;
    rows.add({"", "correlation"}, wanted, name);
    for (Eigen::Index k = 0; k < correlation.cols(); ++k)
        rows.add({"", name(wanted[static_cast<std::size_t>(k)]), 1, 3}, correlation.col(k));
    return rows;
}

void add_fit(document::Document& document, const Identified& identified, const Fit& fit) {
    const auto& identification = fit.found;
    document.line("\n" + title(fit) + ": " +
                  (identification.status == math::FitStatus::not_converged ? "not converged"
                   : identification.status == math::FitStatus::at_bound    ? "a parameter at the end of its range"
                                                                        : std::string(name_of(identification.status))));
    document.table(parameter_rows(identified, fit));
    if (identification.status == math::FitStatus::singular) return;
    if (identification.covariance.size() > 0 && identified.wanted.size() > 1)
        document.line("\n" + correlation_rows(identified.wanted, identification.correlation).text());
    else
        document.line();
    document.line(
        "  degrees of freedom " + std::to_string(identification.degrees_of_freedom) +
        (identification.errors_known && identification.degrees_of_freedom > 0
             ? ", chi²/dof " + document::rounded(identification.chi_squared / identification.degrees_of_freedom, 3)
             : "") +
        "\n");
    document.text([rows = point_rows(identified.curve, fit)] { return rows.text(); });
}

}  // namespace

std::vector<std::string_view> fitted_law_names() {
    std::vector<std::string_view> names;
    for (const ChosenLaw& law : detail::all_laws())
        if (law.row().varies) names.push_back(law.row().name);
    return names;
}

std::string sentence(const Fit& fit, const detail::FitFinding<double>& finding) {
    const std::string names = names_of(finding.parameters);
    switch (finding.concern) {
        case FitConcern::singular:
            return (finding.parameters.size() < 2 ? "the data do not depend on " + names + " here"
                                                  : "the data cannot distinguish " + names +
                                                        ": a change of one is compensated by the others, so only a "
                                                        "combination of them can be found") +
                   "; fit fewer parameters. K(p) contains " +
                   (fit.law->needs_spectrum
                        ? "g and E only as the product E g, and under light loads neither this nor the hardness; R and "
                          "Dp count only where g or alpha follows from them"
                        : "R, Dp and E only as the product E Dp sqrt(R); of sigma, this product and D at most two can "
                          "be found; only the fractal laws depend on D");
        case FitConcern::not_converged:
            return "the search did not converge: start closer to the data, or fit fewer parameters";
        case FitConcern::misfit:
            return "chi^2/dof = " + document::rounded(finding.value, 3) +
                   ": the model does not describe the data within their errors, and the standard errors are too small";
        case FitConcern::scattered:
            return "the points scatter by " + std::to_string(std::lround(100 * finding.value)) +
                   " % about the model: the model does not describe them, or some of them are wrong";
        case FitConcern::outlier:
            return "the point at p = " + document::with_unit(fit.points[finding.point].pressure, "Pa") + " is " +
                   document::rounded(finding.value, 2) +
                   " times as far from the model as the median of the points: it distorts the fit";
        case FitConcern::far_from_start:
            return names + " is " + document::rounded(finding.value, 2) +
                   " times its starting value: check the units of the measured columns; if they are right, start from "
                   "the value found";
        case FitConcern::no_errors: return "no standard errors: as many parameters as points, and no column of errors";
        case FitConcern::at_bound:
            return names +
                   " is at the end of its range: no value within it fits the data, and its errors are not available";
        case FitConcern::unresolved:
            return "the data hardly constrain " + names +
                   ": the ends of its interval differ by a factor of 100 or more";
        case FitConcern::correlated:
            return names + " can hardly be separated (correlation " + document::rounded(finding.value, 4) + ")";
    }
    return {};
}

std::vector<Parameter> parameters_of(const IdentifyRequest& request) {
    std::vector<Parameter> wanted;
    const std::string option = surface::option_name(request.prefix, "fit");
    for (const std::string& written : request.fit) {
        const std::string name(io::detail::trimmed(written));
        const auto entry =
            std::find_if(detail::parameter_table.begin(), detail::parameter_table.end(),
                         [&](const detail::ParameterRow& row) { return name == row.short_name || name == row.key; });
        if (entry == detail::parameter_table.end())
            throw document::option_error(option + ": \"" + name + "\" is not a parameter; must be one of " +
                                         document::list_and_suggestion(name, parameter_short_names));
        if (std::count(wanted.begin(), wanted.end(), entry->parameter) > 0)
            throw document::option_error(option + ": \"" + name + "\" is listed twice");
        wanted.push_back(entry->parameter);
    }
    return wanted;
}

namespace {

/// Refuses reflections of one load, and those of another frequency than that of \p scene.
void require_one_frequency(const scene::Scene& scene, const MeasuredCurve& curve) {
    if (!curve.has_pressures)
        throw domain_error(curve.name + ": there is no column pressure; a fit needs reflections under several loads");
    if (!curve.has_frequencies || !curve.is_reflection || !scene.joint.ultrasound) return;
    for (const MeasuredPoint& point : curve.points)
        if (const double own = scene.joint.ultrasound->frequency; std::abs(point.frequency / own - 1) > 1e-6)
            throw domain_error(curve.name + ":" + std::to_string(point.line) + ": frequency = " +
                               document::rounded(point.frequency / 1e6) + " MHz: must be ultrasound.frequency of " +
                               scene.file + ", " + document::rounded(own / 1e6) +
                               " MHz; fstiff ultrasound joins several frequencies to one K(p), as CSV");
}

}  // namespace

Identified identify_scene(const scene::Scene& scene, const IdentifyRequest& request,
                          std::optional<MeasuredCurve> curve) {
    Identified identified;
    identified.wanted = parameters_of(request);
    identified.curve = curve ? *std::move(curve) : read_measured_curve(request.measured);
    require_one_frequency(scene, identified.curve);
    require_distinct_points(identified.curve);
    identified.found = identify(scene, identified.curve,
                                {identified.wanted, request.law, request.wave == WaveKind::shear, request.prefix});
    if (!request.barton_bandis) return identified;
    identified.hyperbola = hyperbola_of(identified.curve, request);
    const double chi_squared = identified.hyperbola->chi_squared, freedom = identified.hyperbola->degrees_of_freedom;
    if (identified.hyperbola->errors_known && chi_squared > freedom + 3 * std::sqrt(2 * freedom))
        identified.found.warnings.push_back(
            "Barton-Bandis: chi^2/dof = " + document::rounded(chi_squared / freedom, 3) +
            ": the hyperbola does not describe the data within their errors");
    return identified;
}

document::Document document_of(const scene::Scene& scene, const Identified& identified) {
    document::Document document("identify", 10);
    introduce(document, scene, identified);
    for (const Fit& fit : identified.found.fits) add_fit(document, identified, fit);
    document.values([problem = detail::ResolvedJoint(scene.joint), identified](Json& to) {
        Json& fits = to["fits"] = Json::array();
        for (const Fit& fit : identified.found.fits) fits.push_back(fit_json(problem, identified, fit));
    });
    if (identified.hyperbola) add_hyperbola(document, *identified.hyperbola);
    document.line();
    document.warnings = identified.found.warnings;
    document.doubtful = identified.found.doubtful;
    return document;
}

}  // namespace fstiff::actions
