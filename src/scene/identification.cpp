// SPDX-License-Identifier: BSD-3-Clause
#include "scene/identification.hpp"

#include "surface/request.hpp"

#include "document/file.hpp"
#include "scene/results.hpp"
#include "document/shown_unit.hpp"

#include <fstiff/asperity/mindlin.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace fstiff::scene {
namespace {

/// "a, b and c", with \p last before the last one.
std::string joined(const std::vector<std::string_view>& words, std::string_view last) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i > 0) text += i + 1 == words.size() ? last : ", ";
        text += words[i];
    }
    return text;
}

/// "sigma and Dp", in the order of --fit.
std::string names_of(const std::vector<Parameter>& parameters) {
    std::vector<std::string_view> names;
    for (const Parameter parameter : parameters) names.push_back(parts::row_of(parameter).short_name);
    return joined(names, " and ");
}

std::vector<Observation<double>> observations(const MeasuredCurve& curve, const std::vector<MeasuredPoint>& points) {
    std::vector<Observation<double>> data;
    for (const MeasuredPoint& point : points) {
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

ContactParameters<double> start_of(const Scene& scene, const PeakDistribution<double>& peaks) {
    ContactParameters<double> start;
    start.rms_height = scene.face.parameters.rms_height.value;
    start.peak_radius = scene.face.parameters.peak_radius.value;
    start.peak_density = scene.face.parameters.peak_density.value;
    start.fractal_dimension = scene.face.dimension().value_or(1.5);
    start.effective_modulus = effective_modulus(scene.upper, scene.lower);
    start.r = peaks.r();
    start.theta = peaks.theta();
    return start;
}

std::string sentence(const Fit& fit, const FitFinding<double>& finding) {
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
        case FitConcern::scattered:
            return "the points scatter by " + std::to_string(std::lround(100 * finding.value)) +
                   " % about the model: it does not describe them, or some of them are wrong";
        case FitConcern::outlier:
            return "the point at p = " +
                   unit_of_pressure(fit.points[finding.point].pressure)(fit.points[finding.point].pressure) + " is " +
                   rounded(finding.value, 2) +
                   " times as far from the model as the median of the points: the fit is bent towards it";
        case FitConcern::far_from_start:
            return names + " came out as " + rounded(finding.value, 2) +
                   " times its starting value: see that the units of the measured columns are right, and if so, start "
                   "from there";
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

std::optional<Wave<double>> wave_of(const Scene& scene, const MeasuredCurve& curve, const FitRequest& request) {
    const std::string name = option_name(request.prefix, "wave");
    if (!curve.is_reflection) {
        if (request.shear)
            throw option_error(name + " shear is for measured reflections; " + curve.name + " holds stiffnesses");
        return std::nullopt;
    }
    if (!scene.ultrasound)
        throw domain_error(scene.file + ": ultrasound: is missing; the reflections of " + curve.name +
                           " need the section");
    if (request.shear && !scene.ultrasound->shear)
        throw domain_error(scene.file +
                           ": ultrasound.upper.shear_impedance: is missing; " + name + " shear needs it, or "
                           "density and shear_velocity");
    return Wave<double>{request.shear ? *scene.ultrasound->shear : scene.ultrasound->longitudinal,
                        scene.ultrasound->angular(), request.shear ? tangential_ratio(scene.upper, scene.lower) : 1.0};
}

/// The fits that are asked for, still without what they find.
std::vector<Fit> fits_of(const Scene& scene, const MeasuredCurve& curve, const FitRequest& request,
                         std::vector<std::string>& warnings) {
    std::vector<Fit> fits;
    std::string skipped;
    for (const Law* law : scene.laws) {
        if (!request.law.empty() && request.law != law->name) continue;
        if (!law->fit) {
            skipped = law->name;
            continue;
        }
        for (const Peaks& peaks : scene.peaks) {
            const PeakDistribution<double> density = peak_density(peaks);
            fits.push_back({law,
                            density.theta(),
                            density.r(),
                            start_of(scene, density),
                            curve.points_of({std::string(law->name), density.theta(), density.r()}),
                            {}});
        }
    }
    if (fits.empty())
        throw domain_error(scene.file + ": contact.laws: must name " +
                           (skipped.empty()
                                ? "\"" + request.law + "\", which " + option_name(request.prefix, "law") + " asks for"
                                : joined(fitted_law_names(), " or ") + "; " + skipped + " has no derivatives"));
    if (std::erase_if(fits, [](const Fit& fit) { return fit.points.empty(); }) > 0 && fits.empty())
        throw domain_error(curve.name + ": holds " + std::to_string(curve.computed.size()) +
                           " computed curves, none of a law and peaks of " + scene.file +
                           "; must hold one curve, or one of theirs");
    if (!skipped.empty()) warnings.push_back(skipped + " is not fitted: it has no derivatives");
    return fits;
}

}  // namespace

std::string title(const Fit& fit) {
    return std::string(fit.law->name) + ", theta = " + rounded(fit.theta) + ", r = " + rounded(fit.r);
}

Fits identify(const Scene& scene, const MeasuredCurve& curve, const FitRequest& request) {
    if (scene.reading != InteractionReading::none)
        throw domain_error(scene.file +
                           ": contact.interaction: must be \"none\" to identify parameters: the derivatives are those "
                           "of the interface alone");
    Fits all;
    all.wave = wave_of(scene, curve, request);
    all.warnings = scene.warnings;
    all.fits = fits_of(scene, curve, request, all.warnings);
    if (std::count(request.wanted.begin(), request.wanted.end(), Parameter::fractal_dimension) > 0 &&
        !scene.face.dimension())
        throw domain_error(scene.file + ": surface.fractal_dimension: is missing; " +
                           option_name(request.prefix, "fit") + " D starts from it");
    IdentifyOptions<double> options;
    options.wave = all.wave;
    for (Fit& fit : all.fits) {
        const auto data = observations(curve, fit.points);
        fit.found = parts::located(parts::Place{.file = curve.name + " with " + scene.file + ", " + title(fit)}, [&] {
            return fit.law->fit({data, request.wanted, fit.start, options});
        });
    }
    for (const Parameter unknown : unknown_parameters(scene))  // of the surface, and held at what nobody knows
        if (std::count(request.wanted.begin(), request.wanted.end(), unknown) == 0) all.doubtful = true;
    if (scene.implausible) all.doubtful = true;
    std::size_t sound = 0;
    for (const Fit& fit : all.fits) {
        bool doubted = false;
        for (const auto& finding : concerns_of(fit.found)) {
            all.warnings.push_back(title(fit) + ": " + sentence(fit, finding));
            if (parts::is_fatal(finding.concern)) all.doubtful = true;
            doubted = doubted || parts::is_doubtful(finding.concern);
        }
        sound += !doubted;
    }
    if (sound == 0) all.doubtful = true;  // where one law describes the data, that another does not is an answer
    return all;
}

}  // namespace fstiff::scene
