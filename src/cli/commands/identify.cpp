// SPDX-License-Identifier: BSD-3-Clause
// fstiff identify: parameters of a scene from a measured K(p) or R(p), one fit per law and peak density.
#include "commands/commands.hpp"
#include "document/document.hpp"
#include "input/request_options.hpp"
#include "input/scene_options.hpp"
#include "picture/panels.hpp"
#include "scene/identified.hpp"

#include <fstiff/core/version.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <numeric>
#include <utility>

namespace fstiff::cli {
namespace identify_command {
namespace {

struct Options {
    OutputOptions output;
    SceneOptions scene;
    IdentifyRequest request;
    std::string picture;
};

struct Work : Identified {
    Scene scene;
};

Work work_of(const Options& options) {
    const IdentifyRequest& request = options.request;
    if (options.scene.scene == "-" && request.measured == "-")
        throw Usage("the scene and --measured are both standard input; one of them must be a file");
    (void)parameters_of(request);  // what is wrong with them is said before the scene is read
    Work work{{}, read_scene(options.scene)};
    static_cast<Identified&>(work) = identify_scene(work.scene, request);
    return work;
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

std::string csv(const Work& work) {
    std::vector<std::string> header{"law",       "theta", "r",     "status", "chi_squared",    "degrees_of_freedom",
                                    "parameter", "unit",  "start", "value",  "standard_error", "low",
                                    "high"};
    for (const Parameter p : work.wanted) header.push_back("correlation_" + std::string(row_of(p).short_name));
    std::string text = csv_line(header);
    for (const Fit& fit : work.found.fits)
        for (std::size_t i = 0; i < fit.found.parameters.size(); ++i) {
            const auto& p = fit.found.parameters[i];
            const bool singular = fit.found.status == FitStatus::singular;
            const bool has_errors = fit.found.covariance.size() > 0;
            const auto cell = [&](double value) {
                return has_errors && std::isfinite(value) ? exact(value) : std::string();
            };
            std::vector<std::string> cells{std::string(fit.law->name),
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

/// \p points from the least pressure on.
std::vector<std::size_t> rising(const std::vector<MeasuredPoint>& points) {
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return points[a].pressure < points[b].pressure; });
    return order;
}

/// The measured points and, where they have errors, a bar through each.
void draw_measured(Panel& panel, const MeasuredCurve& curve, double factor) {
    PlotLine measured{.label = "measured", .x = {}, .y = {}};
    measured.colour = neutral;
    measured.stroke = Stroke::none;
    measured.marker = Marker::circle;
    for (const std::size_t i : rising(curve.points)) {
        const MeasuredPoint& point = curve.points[i];
        measured.x.push_back(point.pressure / 1e6);
        measured.y.push_back(point.value * factor);
        if (!curve.has_errors) continue;
        PlotLine bar{.label = "", .x = {}, .y = {}};
        bar.colour = neutral;
        for (const double end : {std::max(point.value - point.error, point.value / 10), point.value + point.error}) {
            bar.x.push_back(point.pressure / 1e6);
            bar.y.push_back(end * factor);
        }
        panel.lines.push_back(std::move(bar));
    }
    if (curve.has_errors) measured.label += ", ± standard error";
    panel.lines.push_back(std::move(measured));
}

/// The fitted model from the least pressure to the greatest, many points, so that it is smooth.
PlotLine model_line(const Work& work, const Fit& fit, double factor) {
    const auto& all = fit.found.all;
    const auto order = rising(fit.points);
    const double least = fit.points[order.front()].pressure, greatest = fit.points[order.back()].pressure;
    std::vector<double> pressures, loads;
    for (int k = 0; k <= 100; ++k) {
        pressures.push_back(least * std::pow(greatest / least, k / 100.0));
        loads.push_back(std::max(pressures.back() + all.offset, 1e-6 * pressures.back()));
    }
    const PeakDistribution<double> peaks(all.r, all.theta);
    const auto contact = fit.law->contact({.surface = {all.rms_height, all.peak_radius, all.peak_density},
                                           .effective_modulus = all.effective_modulus,
                                           .peaks = &peaks,
                                           .fractal_dimension = all.fractal_dimension});
    PlotLine line{.label = legend_of(fit.law->name, fit.theta, fit.r), .x = {}, .y = {}};
    const auto states = contact->at_pressures(loads, Quantity::stiffness);
    for (std::size_t k = 0; k < states.size(); ++k) {
        if (!states[k].ok()) continue;
        const double stiffness = states[k].state.stiffness.value;
        const auto& wave = work.found.wave;
        const double value =
            wave ? reflection(wave->stiffness_ratio * stiffness, wave->media, wave->angular_frequency) : stiffness;
        line.x.push_back(pressures[k] / 1e6);
        line.y.push_back(value * factor);
    }
    return line;
}

/// The measured curve with those that were fitted, and the residuals below.
Figure picture(const Work& work) {
    const MeasuredCurve& curve = work.curve;
    const double factor = curve.is_reflection ? 1 : 1e-15;
    Panel above{.title = curve.is_reflection ? "Reflection: measured points and fitted models"
                                             : "Stiffness: measured points and fitted models",
                .x = {.label = "nominal pressure p [MPa]"},
                .y = {.label = curve.is_reflection ? "|R|" : "K/A₀ [GPa/µm]", .logarithmic = !curve.is_reflection},
                .height = 300};
    Panel below{.title = "Residuals",
                .x = {.label = "nominal pressure p [MPa]"},
                .y = {.label = curve.has_errors ? "(model - measured)/error" : "(model - measured)/scatter",
                      .logarithmic = false},
                .windows = {{.label = "±2", .low = -2, .high = 2, .of_y = true}},
                .height = 180,
                .legend = false};
    draw_measured(above, curve, factor);
    double widest = 3;
    constexpr std::array<Marker, 4> markers{Marker::square, Marker::triangle, Marker::diamond, Marker::cross};
    int colour = 0;
    for (const Fit& fit : work.found.fits) {
        if (fit.found.status == FitStatus::singular) continue;
        PlotLine model = model_line(work, fit, factor);
        PlotLine residual{.label = model.label, .x = {}, .y = {}};
        residual.colour = model.colour = colour;
        residual.stroke = Stroke::none;
        residual.marker = markers[static_cast<std::size_t>(colour) % markers.size()];
        for (const std::size_t i : rising(fit.points)) {
            residual.x.push_back(fit.points[i].pressure / 1e6);
            residual.y.push_back(fit.found.residuals[i]);
            widest = std::max(widest, 1.1 * std::abs(fit.found.residuals[i]));
        }
        above.lines.push_back(std::move(model));
        below.lines.push_back(std::move(residual));
        ++colour;
    }
    below.y.low = -widest;
    below.y.high = widest;
    Figure figure{.title = "Parameters of " + work.scene.name + " from " + shown_file(curve.name), .panels = {above}};
    if (!below.lines.empty()) figure.panels.push_back(std::move(below));
    figure.note = "fstiff " FSTIFF_VERSION ", " + work.scene.file + ", " + curve.name;
    return figure;
}

Report execute(const Options& options) {
    if (!options.picture.empty()) keep_for_picture(options.picture);
    const Work work = work_of(options);
    std::vector<std::string> files;
    if (!options.picture.empty()) files = write_figure(picture(work), options.picture);
    Report made = report(answer_of(work.scene, work), [&] { return table(work); }, [&] { return csv(work); },
                         options.output.format);
    say_written(made, files);
    return made;
}

}  // namespace
}  // namespace identify_command

Command add_identify(CLI::App& app) {
    using namespace identify_command;
    auto options = std::make_shared<Options>();
    IdentifyRequest& request = options->request;
    request.prefix = "--";
    Arguments command(app, "identify",
                      "Parameters of a scene from a measured stiffness or reflection against pressure");
    add_scene_options(command, options->scene,
                      "scene file (TOML) with the starting values; - is standard input; without it the fine "
                      "sand-blasted surface of the paper");
    add_request_options(command, request);
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
