// SPDX-License-Identifier: BSD-3-Clause
// The stiffness of a measured curve of reflections: of each point, and of each load by all its frequencies.
#include "actions/ultrasound.hpp"

#include <fstiff/wave/uncertain_reflection.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

namespace fstiff::actions {
namespace {

/// Counts the rows of a curve that have a fault, and keeps the first.
struct Faults {
    std::size_t count = 0, first_line = 0;
    void add(std::size_t line) {
        if (count++ == 0) first_line = line;
    }
    [[nodiscard]] std::string in(const MeasuredCurve& curve) const {
        return " in " + std::to_string(count) + " of " + std::to_string(curve.points.size()) +
               " rows, the first at line " + std::to_string(first_line);
    }
};

/// Whether a stiffness reflects \p R.
bool is_reached(double R, double welded, double film_alone) { return R > welded && R < film_alone; }

std::string most_of(double film_alone) {
    return document::rounded(film_alone) + (film_alone < 1 ? ", that of the film alone" : "");
}

/// The frequency of each point: its own, or the one that is given.
void take_frequencies(const ReflectionRequest& request, Reflection& reflection, CurveOfStiffness& converted) {
    const MeasuredCurve& curve = converted.curve;
    double least = std::numeric_limits<double>::infinity(), most = 0;
    for (const MeasuredPoint& point : curve.points) {
        const double own = curve.has_frequencies ? point.frequency : reflection.frequency;
        if (reflection.frequency > 0 && std::abs(own / reflection.frequency - 1) > 1e-6)
            throw domain_error(surface::option_name(request.prefix, "frequency") + " = " +
                               request.frequency.text("Hz") + ": must not be given with " + curve.name +
                               ", whose line " + std::to_string(point.line) + " has " + document::rounded(own / 1e6) +
                               " MHz");
        converted.frequencies.push_back(own);
        least = std::min(least, own), most = std::max(most, own);
    }
    reflection.frequency = least == most ? least : 0;
}

/// The stiffness of each point that has one.
void convert_points(Reflection& reflection, CurveOfStiffness& converted, double error_of_all) {
    const MeasuredCurve& curve = converted.curve;
    Faults beyond, doubtful;
    double film_alone = 1;
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
        const MeasuredPoint& point = curve.points[i];
        const double error = curve.has_errors ? point.error : error_of_all, frequency = converted.frequencies[i];
        if (!converted.errors.empty()) converted.errors[i] = error;
        film_alone = reflection.film_alone(frequency);
        converted.stiffness.emplace_back();
        if (!is_reached(point.value, reflection.welded, film_alone)) {  // noise, of light or heavy loads
            beyond.add(point.line);
            continue;
        }
        auto& K = converted.stiffness.back();
        K = detail::located(Place{.file = curve.name, .line = point.line, .before_line = ":"}, [&] {
            return detail::measured_stiffness(point.value, error, reflection.media,
                                              detail::angular_frequency(frequency));
        });
        K->value -= reflection.film_stiffness;
        if (!K->bounded || 2 * error >= film_alone - point.value) doubtful.add(point.line);
    }
    const bool alike = reflection.frequency > 0 || reflection.film_stiffness == 0;
    const std::string most = alike ? most_of(film_alone) : "that of the film alone";
    if (beyond.count == curve.points.size())
        throw domain_error(curve.name + ":" + std::to_string(curve.points.front().line) +
                           ": reflection = " + document::shortest(curve.points.front().value) +
                           ": must be greater than " + document::shortest(reflection.welded) +
                           ", that of the welded joint, and less than " + most + "; no row is");
    reflection.doubtful = reflection.doubtful || beyond.count > 0;
    if (beyond.count > 0)
        reflection.warnings.push_back("R is not between that of the welded joint, " +
                                      document::rounded(reflection.welded) + ", and " + most + beyond.in(curve) +
                                      ": no stiffness there");
    if (doubtful.count > 0) reflection.warnings.push_back(near_the_end(most, doubtful.in(curve)));
}

/// K of each load by all its frequencies, and how it depends on these.
void join_frequencies(const Reflection& reflection, CurveOfStiffness& converted) {
    const MeasuredCurve& curve = converted.curve;
    const double film = reflection.film_stiffness;
    std::vector<detail::LoadSpectrum<double>> spectra;
    const bool known = !converted.errors.empty() && std::all_of(converted.errors.begin(), converted.errors.end(),
                                                                [](double error) { return error > 0; });
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
        const MeasuredPoint& point = curve.points[i];
        const auto load = std::find_if(converted.loads.begin(), converted.loads.end(),
                                       [&](const LoadOfCurve& other) { return other.pressure == point.pressure; });
        const auto place = static_cast<std::size_t>(load - converted.loads.begin());
        if (load == converted.loads.end())
            converted.loads.push_back({.pressure = point.pressure}), spectra.emplace_back();
        if (converted.stiffness[i])
            spectra[place].observed.push_back(
                {detail::angular_frequency(converted.frequencies[i]), point.value, known ? converted.errors[i] : 0});
    }
    for (std::size_t i = 0; i < spectra.size(); ++i) {
        auto& [observed, common] = spectra[i];
        LoadOfCurve& load = converted.loads[i];
        load.points = observed.size();
        if (observed.empty()) continue;
        common = detail::common_stiffness<double>(observed, reflection.media);
        load.K = common;
        load.K.value -= film;
        load.K.scatter *= common.value / load.K.value;
    }
    converted.trend = detail::frequency_trend<double>(spectra, reflection.media, film);
}

/// Compares the phases with those that a spring has whose K is that of |R|.
void check_phases(const Reflection& reflection, CurveOfStiffness& converted) {
    PhaseCheck check;
    double of_displacement = 0, of_stress = 0;
    std::vector<std::optional<double>> phases;
    for (std::size_t i = 0; i < converted.curve.points.size(); ++i) {
        const auto& measured = converted.curve.points[i].phase;
        phases.push_back(measured ? std::optional(std::abs(std::remainder(*measured, 2 * std::numbers::pi)))
                                  : std::nullopt);
        if (!measured || !converted.stiffness[i]) continue;
        const double K = converted.stiffness[i]->value + reflection.film_stiffness,
                     omega = detail::angular_frequency(converted.frequencies[i]),
                     spring = std::arg(detail::complex_reflection(K, reflection.media, omega));
        ++check.count;
        of_displacement += (*phases[i] - spring) * (*phases[i] - spring);
        of_stress += (std::numbers::pi - *phases[i] - spring) * (std::numbers::pi - *phases[i] - spring);
    }
    if (check.count == 0) return;
    check.of_stress = of_stress < of_displacement;
    check.deviation = std::sqrt(std::min(of_stress, of_displacement) / static_cast<double>(check.count));
    for (std::size_t i = 0; i < phases.size(); ++i) {
        check.stiffness.emplace_back();
        if (!phases[i] || reflection.media.incident != reflection.media.beyond) continue;
        const double phase = check.of_stress ? std::numbers::pi - *phases[i] : *phases[i],
                     K = detail::angular_frequency(converted.frequencies[i]) * reflection.media.incident / 2 *
                             std::tan(phase) -
                         reflection.film_stiffness;
        if (phase < std::numbers::pi / 2 && K > 0) check.stiffness.back() = K;
    }
    converted.phase = check;
}

/// Sentences on a K that is not that of a spring.
void doubt_spring(Reflection& reflection, const CurveOfStiffness& converted) {
    const auto doubt = [&](const std::string& sentence) {
        reflection.warnings.push_back(sentence), reflection.doubtful = true;
    };
    const auto& trend = converted.trend;
    const auto megahertz = [](double omega) { return document::rounded(omega / (2e6 * std::numbers::pi), 3); };
    double scatter = 0;
    for (const LoadOfCurve& load : converted.loads) scatter = std::max(scatter, load.K.scatter);
    if (trend && trend->depends())
        doubt("K depends on the frequency: " + document::shown_change(trend->change()) + " from " +
              megahertz(trend->low) + " to " + megahertz(trend->high) +
              " MHz. That of a spring does not: use the lowest frequencies, and check the reference, the impedances "
              "and the film");
    else if (trend && trend->scatters)
        doubt("K differs between the frequencies by more than its errors, chi^2/dof = " +
              document::rounded(trend->misfit, 3) + ": errors are too small, or single frequencies are wrong");
    else if (converted.errors.empty() && scatter > 0.25)
        doubt("K of one load scatters by " + document::shown_percent(scatter) + " between its frequencies");
    if (converted.phase && converted.phase->deviation > std::numbers::pi / 36)
        doubt("the phase is " + document::rounded(converted.phase->deviation * 180 / std::numbers::pi, 2) +
              " degrees rms off that of a spring with the K of |R|: one of the two has a wrong reference, or the "
              "interface is no spring");
}

}  // namespace

double Reflection::film_alone(double frequency_of_wave) const {
    return film_stiffness > 0 ? fstiff::reflection(film_stiffness, media, detail::angular_frequency(frequency_of_wave))
                              : 1;
}

std::string near_the_end(const std::string& most, const std::string& where) {
    return "R is within two errors of " + most + " or of the welded joint" + where +
           ": the first-order error of K is unreliable there";
}

std::string beyond_reach(const MeasuredCurve& curve, double welded, double film_alone) {
    Faults beyond;
    for (const MeasuredPoint& point : curve.points)
        if (!is_reached(point.value, welded, film_alone)) beyond.add(point.line);
    return beyond.count == 0 ? ""
                             : "R is not between that of the welded joint, " + document::rounded(welded) + ", and " +
                                   most_of(film_alone) + beyond.in(curve);
}

void convert_curve(const ReflectionRequest& request, MeasuredCurve measured, Reflection& reflection) {
    if (!measured.is_reflection)
        throw domain_error(measured.name + ": holds stiffnesses; must hold a column reflection to compute them from");
    CurveOfStiffness& converted = reflection.curve.emplace(CurveOfStiffness{.curve = std::move(measured)});
    const MeasuredCurve& curve = converted.curve;
    reflection.warnings = curve.warnings;
    reflection.doubtful = curve.doubtful;
    if (curve.has_errors && request.reflection_error)
        reflection.warnings.push_back("the errors are those of " + curve.name + ", not the one that is given");
    if (!curve.has_errors) converted.error = request.reflection_error;
    if (curve.has_errors || converted.error) converted.errors.resize(curve.points.size());
    take_frequencies(request, reflection, converted);
    convert_points(reflection, converted, request.reflection_error.value_or(0));
    if (reflection.frequency == 0 || !curve.has_pressures) join_frequencies(reflection, converted);
    check_phases(reflection, converted);
    doubt_spring(reflection, converted);
}

}  // namespace fstiff::actions
