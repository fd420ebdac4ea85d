// SPDX-License-Identifier: BSD-3-Clause
// fstiff identify: parameters of a scene from a measured K(p) or R(p), one fit per law and peak density.
#include "commands/commands.hpp"
#include "document/document.hpp"
#include "input/scene_options.hpp"
#include "io/number.hpp"
#include "picture/fit_figure.hpp"
#include "scene/identification.hpp"
#include "scene/result_rows.hpp"

#include <fstiff/core/version.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

namespace fstiff::cli {
namespace identify_command {
namespace {

struct Options {
    OutputOptions output;
    SceneOptions scene;
    std::string measured, picture;
    std::vector<std::string> fit;
    std::string law;
    std::string wave = "longitudinal";
};

struct Work {
    Scene scene;
    MeasuredCurve curve;
    std::vector<Parameter> wanted;
    Fits found;
};

/// For --fit and in the documents.
constexpr auto short_names() {
    std::array<std::string_view, parameter_table.size()> names;
    for (std::size_t i = 0; i < names.size(); ++i) names[i] = parameter_table[i].short_name;
    return names;
}

std::vector<Parameter> wanted_of(const std::vector<std::string>& names) {
    std::vector<Parameter> wanted;
    for (const std::string& written : names) {
        const std::string name(io::detail::trimmed(written));
        const auto found = std::find_if(parameter_table.begin(), parameter_table.end(), [&](const ParameterRow& row) {
            return name == row.short_name || name == row.key;
        });
        if (found == parameter_table.end())
            throw Usage("--fit: \"" + name + "\" is no parameter; must be one of " + list_of(short_names()));
        if (std::count(wanted.begin(), wanted.end(), found->parameter) > 0)
            throw Usage("--fit: \"" + name + "\" is there twice; each may be named once");
        wanted.push_back(found->parameter);
    }
    return wanted;
}

Work work_of(const Options& options) {
    if (options.scene.scene == "-" && options.measured == "-")
        throw Usage("the scene and --measured are both standard input; one of them must be a file");
    Work work;
    work.wanted = wanted_of(options.fit);
    work.scene = read_scene(options.scene);
    work.curve = read_measured_curve(options.measured);
    work.found = identify(work.scene, work.curve, {work.wanted, options.law, options.wave == "shear"});
    return work;
}

/// An interval of data that say little may end beyond the range of numbers: nothing is shown there.
Json finite_json(double value) { return std::isfinite(value) ? value : Json(nullptr); }

/// Measured value, model and residual are in these units.
struct Shown {
    std::string_view name, unit, column;
    double factor;
};
Shown shown(const MeasuredCurve& curve) {
    return curve.is_reflection ? Shown{"|R|", "", "reflection", 1}
                               : Shown{"K/A0", " [GPa/µm]", "stiffness_Pa_per_m", 1e-15};
}

/// Measured and fitted values at the points of \p fit.
Rows rows_of(const MeasuredCurve& curve, const Fit& fit) {
    const Shown y = shown(curve);
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

std::string introduction(const Work& work) {
    const MeasuredCurve& curve = work.curve;
    const auto [least, most] = std::minmax_element(
        curve.points.begin(), curve.points.end(), [](const auto& a, const auto& b) { return a.pressure < b.pressure; });
    std::string text = "fstiff " FSTIFF_VERSION ": parameters of " + printable(work.scene.name + " (" + work.scene.file) +
                       ") from " + (curve.is_reflection ? "R(p)" : "K(p)") + " of " + printable(curve.name) + "\n";
    text += "  measured  " + std::to_string(curve.points.size()) + " points, p " + rounded(least->pressure / 1e6) +
            " to " + rounded(most->pressure / 1e6) + " MPa, " +
            (curve.has_errors ? "weighed by their errors"
                              : std::string("no errors: all count alike, errors from the scatter")) +
            "\n";
    if (const auto& wave = work.found.wave)
        text += "  wave      " + rounded(wave->angular_frequency / (2 * std::numbers::pi) / 1e6) + " MHz, impedances " +
                rounded(wave->media.incident / 1e6) + " and " + rounded(wave->media.beyond / 1e6) + " MRayl, sees " +
                (wave->stiffness_ratio == 1 ? "K" : rounded(wave->stiffness_ratio) + " K") + "\n";
    return text;
}

std::string parameter_text(const Fit& fit) {
    const auto& found = fit.found;
    const bool has_errors = found.covariance.size() > 0;
    TextTable parameters({"parameter", "start", "estimate", "standard error", "95 % from", "to"});
    for (const auto& p : found.parameters) {
        const ParameterRow& row = row_of(p.parameter);
        const auto cell = [&](double value, int digits) {
            return has_errors && std::isfinite(value * row.shown_factor) ? rounded(value * row.shown_factor, digits)
                                                                         : "-";
        };
        parameters.add({row.heading(), rounded(fit.start[p.parameter] * row.shown_factor),
                        found.status == FitStatus::singular ? "-" : rounded(p.value * row.shown_factor),
                        cell(p.standard_error, 2), cell(p.low, 5), cell(p.high, 5)});
    }
    return parameters.str();
}

std::string correlation_text(const std::vector<Parameter>& wanted, const Eigen::MatrixXd& correlation) {
    Rows matrix;
    std::vector<std::string> names;
    for (const Parameter p : wanted) names.emplace_back(row_of(p).short_name);
    matrix.add({"", "correlation"}, names);
    for (Eigen::Index k = 0; k < correlation.cols(); ++k)
        matrix.add({"", names[static_cast<std::size_t>(k)], 1, 3},
                   std::vector<double>(correlation.col(k).begin(), correlation.col(k).end()));
    return matrix.text();
}

std::string table(const Work& work) {
    std::string text = introduction(work);
    for (const Fit& fit : work.found.fits) {
        const auto& found = fit.found;
        text += "\n" + title(fit) + ": " +
                (found.status == FitStatus::not_converged ? "not converged"
                 : found.status == FitStatus::at_bound    ? "a parameter at the end of its range"
                                                          : std::string(name_of(found.status))) +
                "\n" + parameter_text(fit);
        if (found.status == FitStatus::singular) continue;
        if (found.covariance.size() > 0 && work.wanted.size() > 1)
            text += "\n" + correlation_text(work.wanted, found.correlation);
        text += "\n  degrees of freedom " + std::to_string(found.degrees_of_freedom);
        if (found.errors_known && found.degrees_of_freedom > 0)
            text += ", chi²/dof " + rounded(found.chi_squared / found.degrees_of_freedom, 3);
        text += "\n\n" + rows_of(work.curve, fit).text();
    }
    return text + "\n";
}

/// One row a parameter of a fit.
std::string csv(const Work& work) {
    std::vector<Heading> headings;
    for (const char* key : {"law", "theta", "r", "status", "chi_squared", "degrees_of_freedom", "parameter", "unit",
                            "start", "value", "standard_error", "low", "high"})
        headings.push_back({key});
    for (const Parameter p : work.wanted) headings.push_back({"correlation_" + std::string(row_of(p).short_name)});
    Rows rows = Rows::under(std::move(headings));
    for (const auto& [law, theta, r, start, points, found] : work.found.fits)
        for (const auto& p : found.parameters) {
            const bool has_errors = found.covariance.size() > 0;
            const auto if_known = [&](double value) {
                return has_errors && std::isfinite(value) ? Cell(value) : Cell();
            };
            std::vector<Cell> cells{law->name,
                                    theta,
                                    r,
                                    name_of(found.status),
                                    found.chi_squared,
                                    found.degrees_of_freedom,
                                    row_of(p.parameter).short_name,
                                    row_of(p.parameter).unit,
                                    start[p.parameter],
                                    found.status == FitStatus::singular ? Cell() : Cell(p.value),
                                    if_known(p.standard_error),
                                    if_known(p.low),
                                    if_known(p.high)};
            const auto i = &p - found.parameters.data();
            for (std::ptrdiff_t k = 0; k < std::ssize(work.wanted); ++k)
                cells.push_back(has_errors ? Cell(found.correlation(i, k)) : Cell());
            rows.add_row(std::move(cells));
        }
    return rows.csv();
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

Json parameter_json(const Fit& fit, const IdentifiedParameter<double>& p) {
    const ParameterRow& row = row_of(p.parameter);
    Json one{{"name", row.short_name}, {"unit", row.unit}, {"start", fit.start[p.parameter]}};
    if (fit.found.status == FitStatus::singular)
        one["looseness"] = p.null_share;
    else
        one["value"] = p.value;
    if (p.at_bound) one["at_bound"] = true;
    if (fit.found.covariance.size() > 0) {
        one["standard_error"] = finite_json(p.standard_error);
        one["interval"] = {{"level", 0.95}, {"low", finite_json(p.low)}, {"high", finite_json(p.high)}};
    }
    return one;
}

Json fit_json(const MeasuredCurve& curve, const Fit& fit) {
    const auto& found = fit.found;
    Json entry{{"law", fit.law->name},
               {"theta", fit.theta},
               {"r", fit.r},
               {"status", name_of(found.status)},
               {"chi_squared", found.chi_squared},
               {"degrees_of_freedom", found.degrees_of_freedom},
               {"errors_known", found.errors_known},
               {"evaluations", found.evaluations}};
    Json& concerns = entry["concerns"] = Json::array();
    for (const auto& finding : concerns_of(found)) concerns.push_back(name_of(finding.concern));
    Json& parameters = entry["parameters"] = Json::array();
    for (const auto& p : found.parameters) parameters.push_back(parameter_json(fit, p));
    if (found.covariance.size() > 0) {
        entry["covariance"] = matrix_json(found.covariance);
        entry["correlation"] = matrix_json(found.correlation);
    }
    if (found.status != FitStatus::singular) rows_of(curve, fit).append_to(entry["rows"] = Json::array());
    return entry;
}

Json json(const Work& work) {
    const MeasuredCurve& curve = work.curve;
    Json document = json_document("identify");
    document["scene"] = scene_json(work.scene);
    document["measured"] = {{"file", curve.name},
                            {"sha256", curve.sha256},
                            {"quantity", curve.is_reflection ? "reflection" : "stiffness"},
                            {"has_errors", curve.has_errors},
                            {"decisions", curve.decisions}};
    if (const auto& wave = work.found.wave)
        document["wave"] = {{"angular_frequency_rad_per_s", wave->angular_frequency},
                            {"impedance_Rayl", wave->media.incident},
                            {"impedance2_Rayl", wave->media.beyond},
                            {"stiffness_ratio", wave->stiffness_ratio}};
    Json& fits = document["fits"] = Json::array();
    for (const Fit& fit : work.found.fits) fits.push_back(fit_json(curve, fit));
    return document;
}

Report execute(const Options& options) {
    if (!options.picture.empty()) keep_for_picture(options.picture);
    const Work work = work_of(options);
    std::vector<std::string> files;
    if (!options.picture.empty()) files = write_figure(fit_figure(work.scene, work.curve, work.found), options.picture);
    Report made = report({.table = [&] { return table(work); },
                          .csv = [&] { return csv(work); },
                          .json = [&] { return json(work); },
                          .warnings = work.found.warnings,
                          .status = work.found.doubtful ? doubtful_result : success},
                         options.output.format);
    say_written(made, files);
    return made;
}

}  // namespace
}  // namespace identify_command

Command add_identify(CLI::App& app) {
    using namespace identify_command;
    auto options = std::make_shared<Options>();
    Arguments command(app, "identify",
                      "Parameters of a scene from a measured stiffness or reflection against pressure");
    add_scene_options(command, options->scene,
                      "scene file (TOML) with the starting values; - is standard input; without it the fine "
                      "sand-blasted surface of the paper");
    command
        .option("--measured", options->measured,
                "file (CSV) of pressure and stiffness or reflection, with their errors if they are known")
        .required()
        .type_name("FILE");
    std::string fitted;
    for (const std::string_view name : short_names()) fitted += (fitted.empty() ? "" : ", ") + std::string(name);
    command
        .option("--fit", options->fit,
                "parameters to fit, among " + fitted + " (offset: of the pressure); the others keep their values")
        .required()
        .delimiter(',')
        .type_name("NAME,...");
    command.option("--law", options->law, "fit only this law of the scene").one_of(fitted_law_names());
    command.option("--wave", options->wave, "kind of wave whose reflection coefficients were measured")
        .one_of({"longitudinal", "shear"})
        .show_default();
    add_output_options(command, options->output);
    add_picture_option(command, options->picture, "draw the fit and its residuals");
    command.footer(
        "The measured file begins with its columns and their units: pressure [MPa], stiffness [GPa/um], "
        "stiffness_error [GPa/um].\n"
        "Every law and peak density of the scene is fitted by itself, but for greenwood_williamson. Exit code 4: the "
        "data cannot\ntell the parameters apart, no convergence, no law that describes the points, an outlier, or a "
        "parameter 30 times\nits starting value.\n"
        "Example:\n"
        "  printf 'pressure [MPa],stiffness [GPa/um],error [GPa/um]\\n1,0.0039,0.0002\\n3,0.0105,0.0005\\n"
        "10,0.029,0.0015\\n30,0.085,0.004\\n' |\n  fstiff identify --measured - --law hertz --fit sigma,Dp");
    return {command.app(), &options->output, [options] { return execute(*options); }};
}

}  // namespace fstiff::cli
