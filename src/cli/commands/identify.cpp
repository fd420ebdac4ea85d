// SPDX-License-Identifier: BSD-3-Clause
// fstiff identify: parameters of a scene from a measured K(p) or R(p), one fit per law and peak density.
#include "commands/commands.hpp"
#include "document/document.hpp"
#include "input/scene_options.hpp"
#include "picture/fit_figure.hpp"
#include "scene/identified.hpp"

#include <fstiff/core/version.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

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
    (void)parameters_of(request);  // their errors are reported before the scene is read
    Work work{{}, read_scene(options.scene)};
    static_cast<Identified&>(work) = identify_scene(work.scene, request);
    return work;
}

std::string introduction(const Work& work) {
    const MeasuredCurve& curve = work.curve;
    const auto [least, most] = std::minmax_element(
        curve.points.begin(), curve.points.end(), [](const auto& a, const auto& b) { return a.pressure < b.pressure; });
    std::string text = "fstiff " FSTIFF_VERSION_TEXT ": parameters of " +
                       printable(work.scene.name + " (" + work.scene.file) + ") from " +
                       (curve.is_reflection ? "R(p)" : "K(p)") + " of " + printable(curve.name) + "\n";
    text += "  measured  " + std::to_string(curve.points.size()) + " points, p " + rounded(least->pressure / 1e6) +
            " to " + rounded(most->pressure / 1e6) + " MPa, " +
            (curve.has_errors ? "weighed by their errors"
                              : std::string("no errors: equal weights, errors from the scatter")) +
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
    TextTable parameters(
        {"parameter", "start", "estimate", "standard error", "95 % from", "to", "with the law's error", "to"});
    for (const auto& p : found.parameters) {
        const parts::ParameterRow& row = parts::row_of(p.parameter);
        const auto cell = [&](double value, int digits) {
            return has_errors && std::isfinite(value * row.shown_factor) ? rounded(value * row.shown_factor, digits)
                                                                         : "-";
        };
        parameters.add({row.heading(), rounded(fit.start[p.parameter] * row.shown_factor),
                        found.status == math::FitStatus::singular ? "-" : rounded(p.value * row.shown_factor),
                        cell(p.standard_error, 2), cell(p.low, 5), cell(p.high, 5), cell(p.low_with_law, 2),
                        cell(p.high_with_law, 2)});
    }
    return parameters.str();
}

std::string correlation_text(const std::vector<Parameter>& wanted, const Eigen::MatrixXd& correlation) {
    Rows matrix;
    std::vector<std::string> names;
    for (const Parameter p : wanted) names.emplace_back(parts::row_of(p).short_name);
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
                (found.status == math::FitStatus::not_converged ? "not converged"
                 : found.status == math::FitStatus::at_bound    ? "a parameter at the end of its range"
                                                                : std::string(name_of(found.status))) +
                "\n" + parameter_text(fit);
        if (found.status == math::FitStatus::singular) continue;
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
                            "start", "value", "standard_error", "low", "high", "low_with_law", "high_with_law"})
        headings.push_back({key});
    for (const Parameter p : work.wanted)
        headings.push_back({"correlation_" + std::string(parts::row_of(p).short_name)});
    Rows rows = Rows::under(std::move(headings));
    for (const auto& [law, theta, r, start, points, found] : work.found.fits)
        for (const auto& p : found.parameters) {
            const bool has_errors = found.covariance.size() > 0;
            const auto if_known = [&](double value) {
                return has_errors && std::isfinite(value) ? Cell(value) : Cell();
            };
            std::vector<Cell> cells{law->name,
                                    theta ? Cell(*theta) : Cell(),
                                    r ? Cell(*r) : Cell(),
                                    name_of(found.status),
                                    found.chi_squared,
                                    found.degrees_of_freedom,
                                    parts::row_of(p.parameter).short_name,
                                    parts::row_of(p.parameter).unit,
                                    start[p.parameter],
                                    found.status == math::FitStatus::singular ? Cell() : Cell(p.value),
                                    if_known(p.standard_error),
                                    if_known(p.low),
                                    if_known(p.high),
                                    if_known(p.low_with_law),
                                    if_known(p.high_with_law)};
            const auto i = &p - found.parameters.data();
            for (std::ptrdiff_t k = 0; k < std::ssize(work.wanted); ++k)
                cells.push_back(has_errors ? Cell(found.correlation(i, k)) : Cell());
            rows.add_row(std::move(cells));
        }
    return rows.csv();
}

Report execute(const Options& options) {
    if (!options.picture.empty()) keep_for_picture(options.picture);
    const Work work = work_of(options);
    std::vector<std::string> files;
    if (!options.picture.empty()) files = write_figure(fit_figure(work.scene, work.curve, work.found), options.picture);
    Report made = report(
        answer_of(work.scene, work), [&] { return table(work); }, [&] { return csv(work); }, options.output.format);
    say_written(made, files);
    return made;
}

}  // namespace
}  // namespace identify_command

Command add_identify(Arguments& command) {
    using namespace identify_command;
    auto options = std::make_shared<Options>();
    IdentifyRequest& request = options->request;
    request.prefix = "--";
    add_scene_options(command, options->scene,
                      "scene file (TOML) with the starting values; - is standard input; without it the fine "
                      "sand-blasted surface of the paper");
    command.fields(request);
    add_output_options(command, options->output);
    add_picture_option(command, options->picture, "draw the fit and its residuals");
    return {&options->output, [options] { return execute(*options); }};
}

}  // namespace fstiff::cli
