// SPDX-License-Identifier: BSD-3-Clause
// fstiff identify: parameters of a scene from a measured K(p) or R(p), one fit per law and peak density.
#include "builtin_scene.hpp"
#include "commands.hpp"
#include "measured_curve.hpp"
#include "pictures.hpp"
#include "scene.hpp"

#include <fstiff/asperity/mindlin.hpp>
#include <fstiff/fit/fit_concerns.hpp>
#include <fstiff/fit/identify.hpp>
#include <fstiff/core/version.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>

namespace fstiff::cli {
namespace {

struct Options {
    OutputOptions output;
    std::string scene, measured, picture;
    std::vector<std::string> fit;
    std::string law;
    std::string wave = "longitudinal";
};

struct Fit {
    Law law{};
    double theta = 0, r = 0;  ///< of the scene
    ContactParameters<double> start{};
    Identification<double> found{};
};

struct Work {
    Scene scene;
    MeasuredCurve curve;
    std::vector<Parameter> wanted;
    std::optional<Wave<double>> wave;
    std::vector<Fit> fits;
    std::vector<std::string> warnings;
    Status status = success;
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

std::string title(const Fit& fit) {
    return std::string(name_of(fit.law)) + ", theta = " + rounded(fit.theta) + ", r = " + rounded(fit.r);
}

/// "sigma and Dp", in the order of --fit.
std::string names_of(const std::vector<Parameter>& parameters) {
    std::string text;
    for (std::size_t i = 0; i < parameters.size(); ++i)
        text += (i == 0                       ? ""
                 : i + 1 == parameters.size() ? " and "
                                              : ", ") +
                std::string(row_of(parameters[i]).short_name);
    return text;
}

std::vector<Observation<double>> observations(const MeasuredCurve& curve) {
    std::vector<Observation<double>> data;
    for (const MeasuredPoint& point : curve.points) {
        const auto refuse = [&](const char* what, double value, const char* allowed) {
            throw domain_error(curve.name + ":" + std::to_string(point.line) + ": " + what + " = " + shortest(value) +
                               ": must be " + allowed);
        };
        if (curve.has_errors && !(point.error > 0)) refuse("error", point.error, "greater than 0 to weigh the point");
        if (curve.is_reflection && !(point.value < 2)) refuse("reflection", point.value, "at most 1, but for noise");
        data.push_back({point.pressure, point.value, point.error});
    }
    return data;
}

ContactParameters<double> start_of(const Scene& scene, const PeakDensity<double>& peaks) {
    ContactParameters<double> start;
    start.rms_height = scene.surface.rms_height;
    start.peak_radius = scene.surface.peak_radius;
    start.peak_density = scene.surface.peak_density;
    start.fractal_dimension = scene.fractal_dimension.value_or(1.5);
    start.effective_modulus = effective_modulus(scene.upper, scene.lower);
    start.r = peaks.r();
    start.theta = peaks.theta();
    return start;
}

Identification<double> identify(const Work& work, const Fit& fit, const std::vector<Observation<double>>& data) {
    IdentifyOptions<double> options;
    options.wave = work.wave;
    const auto with = [&](const auto& law) { return fstiff::identify(data, work.wanted, fit.start, law, options); };
    try {
        switch (fit.law) {
            case Law::fractal:
                return with([](double dimension) { return FractalLaw<double>(dimension); });
            case Law::fractal_consistent:
                return with([](double dimension) { return FractalConsistentLaw<double>(dimension); });
            default:
                return with([](double) { return HertzLaw<double>{}; });
        }
    } catch (const domain_error& error) {
        throw domain_error(work.curve.name + " with " + work.scene.file + ", " + title(fit) + ": " + error.what());
    }
}

std::string sentence(const FitFinding<double>& finding) {
    const std::string names = names_of(finding.parameters);
    switch (finding.concern) {
        case FitConcern::singular:
            return (finding.parameters.size() < 2
                        ? "the data do not depend on " + names + " here"
                        : "the data cannot tell " + names +
                              " apart: a change of one is undone by the others, so that only a combination of them can "
                              "be found") +
                   "; fit fewer parameters. K(p) holds R, Dp and E as the product E Dp sqrt(R) alone, and of sigma, "
                   "that "
                   "product and D no more than two can be found; no law but the fractal ones depends on D";
        case FitConcern::not_converged:
            return "the search did not converge: start closer to the data, or fit fewer parameters";
        case FitConcern::misfit:
            return "chi^2/dof = " + rounded(finding.value, 3) +
                   ": the model does not describe the data within their errors, and the standard errors are too small";
        case FitConcern::no_errors:
            return "no standard errors: as many parameters as points, and no column of errors";
        case FitConcern::at_bound:
            return names +
                   " came to the end of its range: no value of it fits the data, and no errors are known beside it";
        case FitConcern::unresolved:
            return "the data say next to nothing of " + names +
                   ": the ends of its interval are a factor of 100 or more apart";
        case FitConcern::correlated:
            return names + " are hardly told apart (correlation " + rounded(finding.value, 4) + ")";
    }
    return {};
}

void add_warnings(Work& work) {
    for (const Fit& fit : work.fits)
        for (const auto& finding : concerns_of(fit.found)) {
            work.warnings.push_back(title(fit) + ": " + sentence(finding));
            if (is_fatal(finding.concern)) work.status = doubtful_result;
        }
}

Work work_of(const Options& options) {
    if (options.scene == "-" && options.measured == "-")
        throw Usage("the scene and --measured are both standard input; one of them must be a file");
    Work work;
    work.wanted = wanted_of(options.fit);
    work.scene = options.scene.empty() ? parse_scene(builtin_scene, "built-in scene")
                                       : parse_scene(read_all(options.scene), display_name(options.scene));
    const Scene& scene = work.scene;
    if (scene.reading != InteractionReading::none)
        throw domain_error(scene.file +
                           ": contact.interaction: must be \"none\" to identify parameters: the derivatives are those "
                           "of the interface alone");
    work.curve = read_measured_curve(options.measured);
    if (work.curve.is_reflection) {
        if (!scene.ultrasound)
            throw domain_error(scene.file + ": ultrasound: is missing; the reflections of " + work.curve.name +
                               " need the section");
        const bool shear = options.wave == "shear";
        if (shear && !scene.ultrasound->shear)
            throw domain_error(scene.file +
                               ": ultrasound.upper.shear_impedance: is missing; --wave shear needs it, or "
                               "density and shear_velocity");
        work.wave = Wave<double>{shear ? *scene.ultrasound->shear : scene.ultrasound->longitudinal,
                                 scene.ultrasound->angular(), shear ? tangential_ratio(scene.upper, scene.lower) : 1.0};
    } else if (options.wave == "shear") {
        throw Usage("--wave shear is for measured reflections; " + work.curve.name + " holds stiffnesses");
    }
    work.warnings = scene.warnings;
    bool skipped = false;
    for (const Law law : scene.laws) {
        if (!options.law.empty() && options.law != name_of(law)) continue;
        if (law == Law::greenwood_williamson) {
            skipped = true;
            continue;
        }
        for (const Peaks& peaks : scene.peaks) {
            const PeakDensity<double> density = peak_density(peaks);
            work.fits.push_back({law, density.theta(), density.r(), start_of(scene, density), {}});
        }
    }
    if (work.fits.empty())
        throw domain_error(
            scene.file + ": contact.laws: " +
            (options.law.empty() || skipped
                 ? "must name fractal, fractal_consistent or hertz; greenwood_williamson has no derivatives"
                 : "must name \"" + options.law + "\", which --law asks for"));
    if (skipped) work.warnings.emplace_back("greenwood_williamson is not fitted: it has no derivatives");
    if (std::count(work.wanted.begin(), work.wanted.end(), Parameter::fractal_dimension) > 0 &&
        !scene.fractal_dimension)
        throw domain_error(scene.file + ": surface.fractal_dimension: is missing; --fit D starts from it");
    const auto data = observations(work.curve);
    for (Fit& fit : work.fits) fit.found = identify(work, fit, data);
    add_warnings(work);
    return work;
}

/// An interval of data that say little may end beyond the range of numbers: nothing is shown there.
Json finite_json(double value) { return std::isfinite(value) ? json_number(value) : Json(nullptr); }

/// Measured value, model and residual are in these units.
struct Shown {
    std::string_view name, unit, column;
    double factor;
};
Shown shown(const MeasuredCurve& curve) {
    return curve.is_reflection ? Shown{"|R|", "", "reflection", 1}
                               : Shown{"K/A0", " [GPa/µm]", "stiffness_Pa_per_m", 1e-15};
}

std::string table(const Work& work) {
    const MeasuredCurve& curve = work.curve;
    const auto [least, most] = std::minmax_element(
        curve.points.begin(), curve.points.end(), [](const auto& a, const auto& b) { return a.pressure < b.pressure; });
    const Shown y = shown(curve);
    std::string text = "fstiff " FSTIFF_VERSION ": parameters of " + work.scene.name + " (" + work.scene.file +
                       ") from " + (curve.is_reflection ? "R(p)" : "K(p)") + " of " + curve.name + "\n";
    text += "  measured  " + std::to_string(curve.points.size()) + " points, p " + rounded(least->pressure / 1e6) +
            " to " + rounded(most->pressure / 1e6) + " MPa, " +
            (curve.has_errors ? "weighed by their errors"
                              : std::string("no errors: all count alike, errors from the scatter")) +
            "\n";
    if (work.wave)
        text += "  wave      " + rounded(work.wave->angular_frequency / (2 * std::numbers::pi) / 1e6) +
                " MHz, impedances " + rounded(work.wave->media.incident / 1e6) + " and " +
                rounded(work.wave->media.beyond / 1e6) + " MRayl, sees " +
                (work.wave->stiffness_ratio == 1 ? "K" : rounded(work.wave->stiffness_ratio) + " K") + "\n";
    for (const Fit& fit : work.fits) {
        const auto& found = fit.found;
        text += "\n" + title(fit) + ": " +
                (found.status == FitStatus::not_converged ? "not converged"
                 : found.status == FitStatus::at_bound    ? "a parameter at the end of its range"
                                                          : std::string(name_of(found.status))) +
                "\n";
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
        text += parameters.str();
        if (found.status == FitStatus::singular) continue;
        if (has_errors && work.wanted.size() > 1) {
            std::vector<std::string> header{"correlation"};
            for (const Parameter p : work.wanted) header.emplace_back(row_of(p).short_name);
            TextTable matrix(header);
            for (std::size_t i = 0; i < work.wanted.size(); ++i) {
                std::vector<std::string> row{header[i + 1]};
                for (std::size_t k = 0; k < work.wanted.size(); ++k)
                    row.push_back(
                        rounded(found.correlation(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)), 3));
                matrix.add(std::move(row));
            }
            text += "\n" + matrix.str();
        }
        text += "\n  degrees of freedom " + std::to_string(found.degrees_of_freedom);
        if (found.errors_known && found.degrees_of_freedom > 0)
            text += ", chi²/dof " + rounded(found.chi_squared / found.degrees_of_freedom, 3);
        text += "\n\n";
        TextTable rows({"p [MPa]", std::string(y.name) + " measured" + std::string(y.unit), "model",
                        found.errors_known ? "residual [errors]" : "residual [scatter]"});
        for (std::size_t i = 0; i < curve.points.size(); ++i)
            rows.add({rounded(curve.points[i].pressure / 1e6), rounded(curve.points[i].value * y.factor),
                      rounded(found.model[i] * y.factor), rounded(found.residuals[i], 3)});
        text += rows.str();
    }
    text += "\n";
    for (const std::string& warning : work.warnings) text += "warning: " + warning + "\n";
    return text;
}

std::string csv(const Work& work) {
    std::vector<std::string> header{"law",       "theta", "r",     "status", "chi_squared",    "degrees_of_freedom",
                                    "parameter", "unit",  "start", "value",  "standard_error", "low",
                                    "high"};
    for (const Parameter p : work.wanted) header.push_back("correlation_" + std::string(row_of(p).short_name));
    std::string text = csv_line(header);
    for (const Fit& fit : work.fits)
        for (std::size_t i = 0; i < fit.found.parameters.size(); ++i) {
            const auto& p = fit.found.parameters[i];
            const bool singular = fit.found.status == FitStatus::singular;
            const bool has_errors = fit.found.covariance.size() > 0;
            const auto cell = [&](double value) {
                return has_errors && std::isfinite(value) ? exact(value) : std::string();
            };
            std::vector<std::string> cells{std::string(name_of(fit.law)),
                                           exact(fit.theta),
                                           exact(fit.r),
                                           std::string(name_of(fit.found.status)),
                                           exact(fit.found.chi_squared),
                                           std::to_string(fit.found.degrees_of_freedom),
                                           std::string(row_of(p.parameter).short_name),
                                           std::string(row_of(p.parameter).unit),
                                           exact(fit.start[p.parameter]),
                                           singular ? "" : exact(p.value),
                                           cell(p.standard_error),
                                           cell(p.low),
                                           cell(p.high)};
            for (std::size_t k = 0; k < work.wanted.size(); ++k)
                cells.push_back(has_errors ? exact(fit.found.correlation(static_cast<Eigen::Index>(i),
                                                                         static_cast<Eigen::Index>(k)))
                                           : "");
            text += csv_line(cells);
        }
    return text;
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

std::string json(const Work& work) {
    const MeasuredCurve& curve = work.curve;
    Json document = json_document("identify");
    document["scene"] = {{"name", work.scene.name}, {"file", work.scene.file}, {"sha256", work.scene.sha256}};
    document["measured"] = {{"file", curve.name},
                            {"sha256", curve.sha256},
                            {"quantity", curve.is_reflection ? "reflection" : "stiffness"},
                            {"has_errors", curve.has_errors},
                            {"decisions", curve.decisions}};
    if (work.wave)
        document["wave"] = {{"angular_frequency_rad_per_s", json_number(work.wave->angular_frequency)},
                            {"impedance_Rayl", json_number(work.wave->media.incident)},
                            {"impedance2_Rayl", json_number(work.wave->media.beyond)},
                            {"stiffness_ratio", json_number(work.wave->stiffness_ratio)}};
    Json& fits = document["fits"] = Json::array();
    for (const Fit& fit : work.fits) {
        const auto& found = fit.found;
        const bool singular = found.status == FitStatus::singular;
        Json entry{{"law", name_of(fit.law)},
                   {"theta", json_number(fit.theta)},
                   {"r", json_number(fit.r)},
                   {"status", name_of(found.status)},
                   {"chi_squared", json_number(found.chi_squared)},
                   {"degrees_of_freedom", found.degrees_of_freedom},
                   {"errors_known", found.errors_known},
                   {"evaluations", found.evaluations}};
        Json& parameters = entry["parameters"] = Json::array();
        for (const auto& p : found.parameters) {
            const ParameterRow& row = row_of(p.parameter);
            Json one{{"name", row.short_name}, {"unit", row.unit}, {"start", json_number(fit.start[p.parameter])}};
            if (singular)
                one["looseness"] = json_number(p.looseness);
            else
                one["value"] = json_number(p.value);
            if (p.at_bound) one["at_bound"] = true;
            if (found.covariance.size() > 0) {
                one["standard_error"] = finite_json(p.standard_error);
                one["interval"] = {{"level", 0.95}, {"low", finite_json(p.low)}, {"high", finite_json(p.high)}};
            }
            parameters.push_back(std::move(one));
        }
        if (found.covariance.size() > 0) {
            entry["covariance"] = matrix_json(found.covariance);
            entry["correlation"] = matrix_json(found.correlation);
        }
        if (!singular) {
            Json& rows = entry["rows"] = Json::array();
            const std::string column(shown(curve).column);
            for (std::size_t i = 0; i < curve.points.size(); ++i) {
                Json row{{"pressure_Pa", json_number(curve.points[i].pressure)},
                         {column, json_number(curve.points[i].value)}};
                if (curve.has_errors) row["error"] = json_number(curve.points[i].error);
                row["model"] = json_number(found.model[i]);
                row["residual"] = json_number(found.residuals[i]);
                rows.push_back(std::move(row));
            }
        }
        fits.push_back(std::move(entry));
    }
    document["warnings"] = work.warnings;
    return document.str();
}

/// The measured curve with those that were fitted, and the residuals below.
Figure picture(const Work& work) {
    const MeasuredCurve& curve = work.curve;
    const Shown y = shown(curve);
    std::vector<std::size_t> order(curve.points.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return curve.points[a].pressure < curve.points[b].pressure; });
    const std::string label = curve.is_reflection ? "|R|" : "K/A₀ [GPa/µm]";
    Panel above{.x = {.label = "nominal pressure p [MPa]"},
                .y = {.label = label, .logarithmic = !curve.is_reflection},
                .height = 300};
    Panel below{.title = "Residuals",
                .x = {.label = "nominal pressure p [MPa]"},
                .y = {.label = curve.has_errors ? "(model - measured)/error" : "(model - measured)/scatter",
                      .logarithmic = false},
                .windows = {{.label = "±2", .low = -2, .high = 2, .of_y = true}},
                .height = 180,
                .legend = false};
    PlotLine measured{.label = "measured", .x = {}, .y = {}};
    measured.colour = neutral;
    measured.stroke = Stroke::none;
    measured.marker = Marker::circle;
    for (const std::size_t i : order) {
        const MeasuredPoint& point = curve.points[i];
        measured.x.push_back(point.pressure / 1e6);
        measured.y.push_back(point.value * y.factor);
        if (!curve.has_errors) continue;
        PlotLine bar{.label = "", .x = {}, .y = {}};
        bar.colour = neutral;
        for (const double end : {std::max(point.value - point.error, point.value / 10), point.value + point.error}) {
            bar.x.push_back(point.pressure / 1e6);
            bar.y.push_back(end * y.factor);
        }
        above.lines.push_back(std::move(bar));
    }
    if (curve.has_errors) measured.label += ", ± standard error";
    above.lines.push_back(measured);
    double widest = 3;
    constexpr std::array<Marker, 4> markers{Marker::square, Marker::triangle, Marker::diamond, Marker::cross};
    int colour = 0;
    for (const Fit& fit : work.fits) {
        if (fit.found.status == FitStatus::singular) continue;
        PlotLine model{
            .label = std::string(name_of(fit.law)) + ", θ = " + shown_angle(fit.theta) + ", r = " + rounded(fit.r, 3),
            .x = {},
            .y = {}};
        std::replace(model.label.begin(), model.label.end(), '_', ' ');
        model.colour = colour;
        PlotLine residual = model;
        residual.stroke = Stroke::none;
        residual.marker = markers[static_cast<std::size_t>(colour) % markers.size()];
        for (const std::size_t i : order) {
            model.x.push_back(curve.points[i].pressure / 1e6);
            model.y.push_back(fit.found.model[i] * y.factor);
            residual.x.push_back(curve.points[i].pressure / 1e6);
            residual.y.push_back(fit.found.residuals[i]);
            widest = std::max(widest, 1.1 * std::abs(fit.found.residuals[i]));
        }
        above.lines.push_back(std::move(model));
        below.lines.push_back(std::move(residual));
        ++colour;
    }
    below.y.low = -widest;
    below.y.high = widest;
    Figure figure{.title = "Parameters of " + work.scene.name + " from " + curve.name, .panels = {above}};
    if (!below.lines.empty()) figure.panels.push_back(std::move(below));
    figure.note = "fstiff " FSTIFF_VERSION ", " + work.scene.file + ", " + curve.name;
    return figure;
}

Report execute(const Options& options) {
    if (!options.picture.empty()) require_picture_name(options.picture);
    const Work work = work_of(options);
    Report report;
    report.status = work.status;
    if (!options.picture.empty())
        for (const std::string& file : write_figure(picture(work), options.picture))
            report.diagnostics.push_back("wrote " + file);
    if (options.output.format == Format::table) {
        report.document = table(work);
    } else {
        report.document = options.output.format == Format::csv ? csv(work) : json(work);
        for (const std::string& warning : work.warnings) report.diagnostics.push_back("warning: " + warning);
    }
    return report;
}

}  // namespace

Command add_identify(CLI::App& app) {
    auto options = std::make_shared<Options>();
    Arguments command(app, "identify",
                      "Parameters of a scene from a measured stiffness or reflection against pressure");
    command.option("scene", options->scene,
                   "scene file (TOML) with the starting values; - is standard input; without it the fine "
                   "sand-blasted surface of the paper");
    command
        .option("--measured", options->measured,
                "file (CSV) of pressure and stiffness or reflection, with their errors if they are known")
        .required()
        .type_name("FILE");
    std::string fitted;
    for (const std::string_view name : short_names()) fitted += (fitted.empty() ? "" : ", ") + std::string(name);
    command.option("--fit", options->fit, "what is fitted, of " + fitted + " (of the pressure); the rest stays")
        .required()
        .delimiter(',')
        .type_name("NAME,...");
    std::vector<std::string_view> laws;
    for (const std::string_view name : choices<Law>())
        if (name != name_of(Law::greenwood_williamson)) laws.push_back(name);  // has no derivatives
    command.option("--law", options->law, "fit this law of the scene alone").one_of(laws);
    command.option("--wave", options->wave, "what the reflections are of")
        .one_of({"longitudinal", "shear"})
        .show_default();
    add_output_options(command, options->output);
    command
        .option("--plot", options->picture,
                "draw the fit and its residuals into FILE (.svg or .html); its numbers (.csv) and a gnuplot "
                "script (.gp) go beside it")
        .type_name("FILE");
    command.footer(
        "The measured file begins with its columns and their units: pressure [MPa], stiffness [GPa/um], "
        "stiffness_error [GPa/um].\n"
        "Every law and peak density of the scene is fitted by itself, but for greenwood_williamson. Exit code 4: the "
        "data cannot\ntell the parameters apart, or no convergence.\n"
        "Example:\n"
        "  printf 'pressure [MPa],stiffness [GPa/um],error [GPa/um]\\n1,0.0039,0.0002\\n3,0.0105,0.0005\\n"
        "10,0.029,0.0015\\n30,0.085,0.004\\n' |\n  fstiff identify --measured - --law hertz --fit sigma,Dp");
    return {command.app(), &options->output, [options] { return execute(*options); }};
}

}  // namespace fstiff::cli
