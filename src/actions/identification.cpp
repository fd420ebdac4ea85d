// SPDX-License-Identifier: BSD-3-Clause
#include "actions/identify.hpp"

#include "actions/ultrasound.hpp"
#include "document/shown_unit.hpp"

#include <fstiff/answer/answer_curve.hpp>
#include <fstiff/answer/concerns.hpp>
#include <fstiff/answer/face.hpp>
#include <fstiff/answer/lacks.hpp>
#include <fstiff/answer/request.hpp>
#include <fstiff/answer/state_table.hpp>
#include <fstiff/answer/unknowns.hpp>
#include <fstiff/asperity/material.hpp>
#include <fstiff/asperity/tangential_ratio.hpp>
#include <fstiff/contact/plastic_contact.hpp>
#include <fstiff/math/random.hpp>
#include <fstiff/surface/band_spectrum.hpp>
#include <fstiff/surface/sum_of_faces.hpp>
#include <fstiff/wave/uncertain_reflection.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

namespace fstiff::actions {

using detail::dimensionless_pressure, detail::Face, detail::Law, detail::ResolvedJoint, document::option_error,
    document::rounded, scene::Scene, surface::option_name;

namespace {

/// A measured curve and how it is fitted.
struct FitInputs {
    const std::vector<Observation<double>>& data;
    const std::vector<Parameter>& parameters;
    ContactParameters<double> start;
    IdentifyOptions<double> options;
};

std::vector<Observation<double>> observations(const MeasuredCurve& curve, const std::vector<MeasuredPoint>& points) {
    std::vector<Observation<double>> data;
    for (const MeasuredPoint& point : points) {
        const auto refuse = [&](const char* what, double value, const char* allowed) {
            throw domain_error(curve.name + ":" + std::to_string(point.line) + ": " + what + " = " +
                               document::shortest(value) + ": must be " + allowed);
        };
        if (curve.has_errors && !(point.error > 0)) refuse("error", point.error, "greater than 0 to weigh the point");
        if (curve.is_reflection && !(point.value < 2)) refuse("reflection", point.value, "at most 1, apart from noise");
        if (curve.is_reflection && !(point.value > 0)) refuse("reflection", point.value, "greater than 0");
        data.push_back({point.pressure, point.value, point.error});
    }
    return data;
}

bool has(const std::vector<Parameter>& wanted, Parameter parameter) {
    return std::count(wanted.begin(), wanted.end(), parameter) > 0;
}

/// Whether the surface is (sigma, g, alpha) to a fit of \p wanted: R and D_p follow then.
bool of_spectrum(const std::vector<Parameter>& wanted) {
    return has(wanted, Parameter::rms_gradient) || has(wanted, Parameter::alpha);
}

ContactParameters<double> start_of(const ResolvedJoint& problem, const detail::Peaks* peaks) {
    ContactParameters<double> start;
    const SpectralMoments<double> moments = spectral_moments(problem.face);
    const Roughness<double> rough = problem.face.roughness();
    start.rms_height = rough.rms_height, start.peak_radius = rough.peak_radius, start.peak_density = rough.peak_density;
    start.fractal_dimension = problem.face.dimension().value_or(1.5);
    start.effective_modulus = problem.effective_modulus;
    start.rms_gradient = std::sqrt(2 * moments.m2), start.alpha = moments.bandwidth();
    const double hardness = hardness_of(problem);
    start.hardness = std::isfinite(hardness) ? hardness : 0;
    if (!peaks) return start;
    const PeakDistribution<double> density = peak_density(*peaks);
    start.r = density.r(), start.theta = density.theta();
    return start;
}

/// \p problem with \p fit's peaks alone, and without what only a band takes.
ResolvedJoint lean_problem(const ResolvedJoint& problem, const Fit& fit) {
    ResolvedJoint lean = problem;
    lean.faces.clear();
    lean.face.measured.reset();
    lean.face.neighbours.clear();
    if (fit.theta) lean.peaks = {{.theta = *fit.theta, .r = fit.r}};
    return lean;
}

/// \p face with those of \p x that are \p wanted.
Face with_parameters(Face face, const ContactParameters<double>& x, const std::vector<Parameter>& wanted) {
    const double height_factor = x.rms_height / face.parameters.rms_height.value;
    for (const Parameter each : wanted)
        if (auto* known = face.parameters.find(each)) known->value = x[each];
    if (face.map && has(wanted, Parameter::rms_height)) {  // all its heights
        face.map = face.map->scaled(height_factor);
        if (face.rms_gradient && face.spectrum_of_map) *face.rms_gradient *= height_factor;
    }
    if (of_spectrum(wanted)) {
        face.rms_gradient = x.rms_gradient, face.alpha = x.alpha;
        const auto moments = detail::moments_of_gradient(x.rms_height, x.rms_gradient, x.alpha);
        face.parameters.peak_radius.value = detail::peak_radius_of(moments);
        face.parameters.peak_density.value = detail::peak_density_of(moments);
    }
    return face;
}

/// The contact that \p lean makes by \p law with those of \p x that are \p wanted, under \p pressures.
std::vector<ContactPoint<double>> points_with(ResolvedJoint lean, const Law& law, const ContactParameters<double>& x,
                                              const std::vector<Parameter>& wanted, std::span<const double> pressures) {
    lean.face = with_parameters(std::move(lean.face), x, wanted);
    if (has(wanted, Parameter::hardness)) lean = with_hardness(std::move(lean), x.hardness);
    const bool own_peaks = has(wanted, Parameter::r) || has(wanted, Parameter::theta);
    if (own_peaks) lean.peaks = {{.theta = x.theta, .r = x.r}};
    lean.default_peaks = lean.default_peaks && of_spectrum(wanted) && !own_peaks;  // r follows alpha
    lean.effective_modulus = x.effective_modulus;
    std::vector<ContactPoint<double>> points;
    for_each_contact(lean, {&law}, {}, [&](const detail::ContactOfLaw& contact) {
        if (points.empty()) points = contact.make()->at_pressures(pressures, Quantity::stiffness);
    });
    return points;
}

/// K by \p at under \p pressures, of which there are many: ln K over ln p by the polynomial through six of few
/// pressures, within 1e-6; where that through four differs by 1e-4, or there is none, K itself.
template <class Stiffness>
std::vector<double> at_many(std::span<const double> pressures, const Stiffness& at) {
    const auto [least, greatest] = std::minmax_element(pressures.begin(), pressures.end());
    if (!(*least > 0)) return at(pressures);
    const std::vector<double> nodes = detail::StateTable::pressures(*least, *greatest, 0.2);
    std::vector<double> logs = at(nodes), stiffness(pressures.size()), others;
    for (double& K : logs) K = std::log(K);
    const double first = std::log(*least), step = (std::log(*greatest) - first) / static_cast<double>(nodes.size() - 1);
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < pressures.size(); ++i) {
        const double place = step > 0 ? (std::log(pressures[i]) - first) / step : 0;
        const auto node = static_cast<std::size_t>(std::clamp(place, 2.0, static_cast<double>(nodes.size()) - 4));
        const double t = place - static_cast<double>(node);
        const auto six = detail::lagrange_weights<-2, 3>(t);
        const auto four = detail::lagrange_weights<-1, 2>(t);
        const double* const around = &logs[node - 2];
        const double log_K = std::inner_product(six.begin(), six.end(), around, 0.0),
                     by_four = std::inner_product(four.begin(), four.end(), around + 1, 0.0);
        if (std::abs(log_K - by_four) < 1e-4)
            stiffness[i] = std::exp(log_K);
        else
            places.push_back(i), others.push_back(pressures[i]);
    }
    if (others.empty()) return stiffness;
    const std::vector<double> exact = at(others);
    for (std::size_t i = 0; i < places.size(); ++i) stiffness[places[i]] = exact[i];
    return stiffness;
}

Identification<double> found_by(const ResolvedJoint& problem, const Fit& fit, const FitInputs& inputs) {
    const ResolvedJoint lean = lean_problem(problem, fit);
    const detail::CurveOfParameters<double> curve = [&](const ContactParameters<double>& x,
                                                        std::span<const double> pressures) {
        const auto at = [&](std::span<const double> some) {
            std::vector<double> stiffness;
            for (const auto& point : points_with(lean, *fit.law, x, inputs.parameters, some))
                stiffness.push_back(point.ok() ? point.state.stiffness.value
                                               : std::numeric_limits<double>::quiet_NaN());
            return stiffness;
        };
        return pressures.size() > detail::many_points ? at_many(pressures, at) : at(pressures);
    };
    return detail::identify_curve(inputs.data, inputs.parameters, inputs.start, curve, inputs.options);
}

/// \p point with K times \p factor, and the reflection of that.
Observation<double> scaled(Observation<double> point, double factor,
                           const std::optional<ObservedWave<double>>& wave) try {
    if (!wave) return {point.pressure, factor * point.value, factor * point.error};
    const auto& [media, omega, ratio, film] = *wave;
    const double K = stiffness_from_reflection(point.value, media, omega) - film;
    return {point.pressure, reflection(factor * K + film, media, omega), point.error};
} catch (const domain_error&) {  // noise: no K reflects so
    return point;
}

/// Puts into \p fit the intervals that are widened by squares by what the fits find where K of the law is at either end
/// of its error, which is on one side of K at all pressures.
void widen_by_law(const ResolvedJoint& problem, Fit& fit, FitInputs inputs) try {
    constexpr double wider = math::normal_975<double>.value / math::normal_95<double>.value;  // 95 % instead of 90 %
    inputs.start = fit.found.optimum, inputs.options.search.max_iterations = 30;
    ResolvedJoint fitted = lean_problem(problem, fit);
    fitted.face = with_parameters(std::move(fitted.face), inputs.start, inputs.parameters);
    const std::optional<double> g = gradient(fitted);
    const auto shifted = [&](double CauseSpread<double>::*end) {
        std::vector<Observation<double>> data = inputs.data;
        for (Observation<double>& observation : data) {
            detail::AnswerReason reason;
            if (g) reason.p_star = dimensionless_pressure(observation.pressure, inputs.start.effective_modulus, *g);
            observation = scaled(observation, std::exp(-wider * law_error(problem, fit.law->which, reason).*end),
                                 inputs.options.wave);
        }
        return found_by(problem, fit, {data, inputs.parameters, inputs.start, inputs.options});
    };
    const auto low = shifted(&CauseSpread<double>::low), high = shifted(&CauseSpread<double>::high);
    if (low.status != math::FitStatus::converged || high.status != math::FitStatus::converged) return;
    for (std::size_t i = 0; i < inputs.parameters.size(); ++i) {
        auto& own = fit.found.parameters[i];
        const detail::ParameterScale<double> scale(own.parameter);
        double u = scale.variable(own.value), below = u - scale.variable(own.low), above = scale.variable(own.high) - u;
        for (const auto* end : {&low, &high}) {
            const double moved = scale.variable(end->parameters[i].value) - u;
            (moved < 0 ? below : above) = std::hypot(moved < 0 ? below : above, moved);
        }
        if (std::max(below, above) < 7)  // three decades, or all between two bounds
            own.low_with_law = scale.value(u - below), own.high_with_law = scale.value(u + above);
    }
} catch (const domain_error&) {  // no surface has K so far from the data
}

std::optional<ObservedWave<double>> wave_of(const Scene& scene, const MeasuredCurve& curve, const FitRequest& request) {
    const std::string name = option_name(request.prefix, "wave");
    if (!curve.is_reflection && request.shear)
        throw option_error(name + " shear is for measured reflections; " + curve.name + " holds stiffnesses");
    if (!curve.is_reflection) return std::nullopt;
    if (!scene.joint.ultrasound)
        throw domain_error(scene.file + ": ultrasound: is missing; the reflections of " + curve.name +
                           " need the section");
    const UltrasonicWaves& waves = *scene.joint.ultrasound;
    if (!request.shear) return ObservedWave<double>{waves.longitudinal, waves.angular(), 1, waves.film_stiffness};
    if (!waves.shear)
        throw domain_error(scene.file + ": ultrasound.upper.shear_impedance: is missing; " + name +
                           " shear needs it, or density and shear_velocity");
    return ObservedWave<double>{*waves.shear, waves.angular(), tangential_ratio(scene.joint.upper, scene.joint.lower)};
}

/// The laws to fit: the one that is asked for, or those of the scene, which is that of the answer where none is named.
std::vector<const Law*> laws_of(const Scene& scene, const FitRequest& request) {
    if (request.law.empty()) return scene.laws;
    const Law* law = detail::find_law(request.law);
    const std::string why = law->needs_dimension && !scene.joint.face.dimension()
                                ? "needs surface.fractal_dimension, which is missing"
                                : scene.refusal_of(*law);
    if (!why.empty())
        throw domain_error(scene.file + ": law \"" + request.law + "\", which " + option_name(request.prefix, "law") +
                           " asks for, " + why);
    return {law};
}

/// The fits that are asked for, still without what they find.
std::vector<Fit> fits_of(const Scene& scene, const MeasuredCurve& curve, const FitRequest& request,
                         std::vector<std::string>& warnings) {
    std::vector<Fit> fits;
    std::string skipped;
    for (const Law* law : laws_of(scene, request)) {
        if (!law->varies) {
            skipped = law->name;
            continue;
        }
        const auto add = [&](const detail::Peaks* peaks) {
            Fit fit{law, {}, {}, start_of(scene.joint, peaks), {}, {}};
            if (law->has_peaks) fit.theta = fit.start.theta, fit.r = fit.start.r;
            fit.points = curve.points_of({std::string(law->name), fit.theta, fit.r});
            fits.push_back(std::move(fit));
        };
        for (const detail::Peaks& peaks : peaks_of(*law, scene.joint)) add(&peaks);
        if (!law->has_peaks) add(scene.joint.peaks.empty() ? nullptr : &scene.joint.peaks.front());
    }
    if (fits.empty())
        throw domain_error(scene.file + ": contact.laws: must name " + document::list_of(fitted_law_names()) + "; " +
                           skipped + " is too slow to fit");
    if (std::erase_if(fits, [](const Fit& fit) { return fit.points.empty(); }) > 0 && fits.empty())
        throw domain_error(curve.name + ": holds " + std::to_string(curve.computed.size()) +
                           " computed curves, none of a law and peaks of " + scene.file +
                           "; must hold one curve, or one of theirs");
    if (!skipped.empty()) warnings.push_back(skipped + " is not fitted: it is too slow");
    return fits;
}

/// Refuses parameters that \p scene has no value of, or that follow from others. \throws option_error, domain_error
void require_known(const Scene& scene, const FitRequest& request) {
    const std::string option = option_name(request.prefix, "fit");
    if (has(request.wanted, Parameter::fractal_dimension) && !scene.joint.face.dimension())
        throw domain_error(scene.file + ": surface.fractal_dimension: is missing; " + option + " D starts from it");
    if (has(request.wanted, Parameter::hardness) && !std::isfinite(hardness_of(scene.joint)))
        throw domain_error(scene.file + ": material.upper.hardness: is infinite; " + option +
                           " hardness starts from it, or from its range");
    for (const Parameter each : {Parameter::peak_radius, Parameter::peak_density})
        if (of_spectrum(request.wanted) && has(request.wanted, each))
            throw option_error(
                option + " " + std::string(detail::row_of(each).short_name) +
                ": follows from sigma, g and alpha where g or alpha is fitted; fit one pair or the other");
    for (const Parameter each : {Parameter::rms_gradient, Parameter::alpha})
        if (has(request.wanted, each) && scene.joint.face.map && scene.joint.face.spectrum_of_map)
            throw domain_error(scene.file + ": " + option + " " + std::string(detail::row_of(each).short_name) +
                               ": the surface is a map, whose heights scale with sigma alone; [contact.persson] "
                               "spectrum = \"moments\" replaces it with numbers");
}

/// Whether K of the elastic law of \p fit would be 5 % higher where its peaks yield, under its greatest pressure.
bool rises_by_flow(const ResolvedJoint& problem, const Fit& fit, double hardness, double rms_gradient) {
    double most = 0;
    for (const MeasuredPoint& point : fit.points) most = std::max(most, point.pressure);
    if (!(most < hardness)) return true;
    const detail::GaussianCut<double> cut(fit.found.optimum.rms_height, rms_gradient,
                                          fit.found.optimum.effective_modulus);
    const double share = most / hardness, K = fitted_points(problem, fit, {&most, 1}).front().state.stiffness.value;
    return detail::yielded(share, cut.stiffness(share), K).stiffness > 1.05 * K;
}

/// A sentence on the peaks of the fitted surface where the law is elastic and they yield; empty else.
std::string flow_of(const ResolvedJoint& problem, const Fit& fit, const std::vector<Parameter>& wanted) {
    const double hardness = hardness_of(problem);
    if (flows(problem, *fit.law) || !std::isfinite(hardness) || fit.found.status == math::FitStatus::singular)
        return "";
    const ContactParameters<double>& x = fit.found.optimum;
    ResolvedJoint fitted = lean_problem(problem, fit);
    fitted.face = with_parameters(std::move(fitted.face), x, wanted);
    const double psi = fitted.face.has_radius_and_density()
                           ? detail::plasticity_index(fitted.face.roughness(), x.effective_modulus,
                                                      hardness / detail::hardness_over_yield_strength<double>)
                           : 0;
    const std::optional<double> g = gradient(fitted);
    if (!(g ? rises_by_flow(problem, fit, hardness, *g) : psi > detail::max_elastic_plasticity_index<double>))
        return "";
    const bool has_plastic = lack_of(laws::plastic.row(), problem) == detail::Lack::nothing;
    return "the peaks of the fitted surface yield (" +
           (g ? "H/(E g) = " + rounded(hardness / (x.effective_modulus * *g), 2) : "") +
           (psi > 0 ? (g ? "; " : "") + ("plasticity index " + rounded(psi, 3)) : "") +
           (problem.hardness_range ? "; H = " + document::with_unit(hardness, "Pa", 2) + " is assumed" : "") +
           "): an elastic law does not apply to this contact, and its parameters are not those of the surface; fit " +
           (has_plastic ? "plastic" : "jackson_green");
}

}  // namespace

std::string title(const Fit& fit) {
    const std::string law(fit.law->name);
    return fit.theta ? law + ", theta = " + rounded(*fit.theta) + ", r = " + rounded(*fit.r) : law;
}

std::vector<ContactPoint<double>> fitted_points(const ResolvedJoint& problem, const Fit& fit,
                                                std::span<const double> pressures) {
    std::vector<Parameter> wanted;
    for (const auto& one : fit.found.parameters) wanted.push_back(one.parameter);
    return points_with(lean_problem(problem, fit), *fit.law, fit.found.optimum, wanted, pressures);
}

Fits identify(const Scene& scene, const MeasuredCurve& curve, const FitRequest& request) {
    if (scene.joint.reading != InteractionReading::none)
        throw domain_error(scene.file +
                           ": contact.interaction: must be \"none\" to identify parameters: the fitted K is that of "
                           "the interface alone");
    Fits fits;
    fits.wave = wave_of(scene, curve, request);
    fits.warnings = scene.warnings;
    fits.warnings.insert(fits.warnings.end(), curve.warnings.begin(), curve.warnings.end());
    if (fits.wave) {
        const auto& [media, omega, ratio, film] = *fits.wave;
        const std::string beyond =
            beyond_reach(curve, detail::welded_reflection(media), reflection(film, media, omega));
        if (!beyond.empty())
            fits.warnings.push_back(beyond + ": no K gives it; the rows count by their distance from the model");
    }
    require_known(scene, request);
    fits.fits = fits_of(scene, curve, request, fits.warnings);
    IdentifyOptions<double> options;
    options.wave = fits.wave;
    for (Fit& fit : fits.fits) {
        const auto data = observations(curve, fit.points);
        const FitInputs inputs{data, request.wanted, fit.start, options};
        detail::located(Place{.file = curve.name + " with " + scene.file + ", " + title(fit)}, [&] {
            fit.found = found_by(scene.joint, fit, inputs);
            widen_by_law(scene.joint, fit, inputs);
        });
    }
    for (const Parameter unknown : unknown_parameters(scene.joint, scene.best))  // held at an assumed value
        if (!has(request.wanted, unknown)) fits.doubtful = true;
    if (scene.implausible || curve.doubtful) fits.doubtful = true;
    std::size_t sound = 0;
    for (const Fit& fit : fits.fits) {
        bool doubted = false;
        for (const auto& finding : detail::concerns_of(fit.found)) {
            fits.warnings.push_back(title(fit) + ": " + sentence(fit, finding));
            if (detail::is_fatal(finding.concern)) fits.doubtful = true;
            doubted = doubted || detail::is_doubtful(finding.concern);
        }
        if (const std::string flow = flow_of(scene.joint, fit, request.wanted); !flow.empty()) {
            fits.warnings.push_back(title(fit) + ": " + flow);
            doubted = doubted || !scene.joint.hardness_range;
        }
        sound += !doubted;
    }
    if (sound == 0) fits.doubtful = true;  // where one law describes the data, that another does not is an answer
    return fits;
}

}  // namespace fstiff::actions
