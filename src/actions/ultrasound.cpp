// SPDX-License-Identifier: BSD-3-Clause
#include "actions/ultrasound.hpp"

#include "document/file.hpp"
#include "io/number.hpp"
#include "request/words.hpp"

#include <fstiff/asperity/named_materials.hpp>
#include <fstiff/wave/uncertain_reflection.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <filesystem>
#include <utility>

namespace fstiff::actions {
namespace {

/// The material of that name, and the impedance that its wave has.
double impedance_of_material(const std::string& material, const std::string& option, const std::string& instead,
                             WaveKind wave, std::string& phrase) {
    const std::string given = option + " = \"" + material + "\"";
    const NamedMaterial* const found = find_material(material);
    if (!found) throw domain_error(given + ": " + request::unknown_material(material, instead));
    const auto [longitudinal, shear] = found->wave_speeds();
    const double speed = wave == WaveKind::shear ? shear : longitudinal;
    if (!(speed > 0)) throw domain_error(given + ": has no known speed of sound; must be given by " + instead);
    phrase += (phrase.empty() ? "" : "; ") + std::string(found->name) + ", " + document::rounded(found->density) +
              " kg/m^3, " + document::rounded(speed) + " m/s" + (wave == WaveKind::shear ? " of shear waves" : "");
    return acoustic_impedance(found->density, speed);
}

double impedance_of(const BodyRequest& body, const ReflectionRequest& request, const std::string& suffix,
                    std::string& phrase) {
    const auto name = [&](std::string_view key) { return surface::option_name(request.prefix, key) + suffix; };
    const bool parts = !body.density.empty() || !body.velocity.empty();
    if (!body.material.empty() && (parts || !body.impedance.empty()))
        throw document::option_error(name("material") + " is given with " +
                                     name(!body.impedance.empty() ? "impedance"
                                          : !body.density.empty() ? "density"
                                                                  : "velocity") +
                                     "; give one of the two");
    if (!body.material.empty())
        return impedance_of_material(body.material, name("material"), name("impedance"), request.wave, phrase);
    if (!body.impedance.empty() && parts)
        throw document::option_error(name("impedance") + " is given with " + name("density") + " or " +
                                     name("velocity") + "; give the impedance or the other two");
    if (!body.impedance.empty()) return body.impedance.positive(io::Dimension::impedance, name("impedance"));
    if (body.density.empty() || body.velocity.empty())
        throw document::option_error("the impedance is not known; give " + name("material") + " or " +
                                     name("impedance") + ", or " + name("density") + " and " + name("velocity"));
    return acoustic_impedance(body.density.positive(io::Dimension::density, name("density")),
                              body.velocity.positive(io::Dimension::velocity, name("velocity")));
}

/// The number that \p given is; none: the name of a file. "nan" and "inf" are numbers, so that they are refused as
/// such.
std::optional<double> as_number(const request::Amount& given) {
    if (!given.numbers().empty()) return given.numbers().front();
    const std::string text = given.text();
    const std::string word = io::detail::lower_case(text);
    if (word == "nan" || word == "inf" || word == "-inf")
        throw domain_error("reflection = " + text + ": must be greater than 0 and less than 1");
    const auto number = io::detail::leading_number(text);
    if (number.length != text.size() || number.status != io::detail::NumberStatus::ok) return std::nullopt;
    return number.value;
}

/// R of the stiffness, or K of the one reflection that is \p given, and what else follows.
Reflected at_one(const ReflectionRequest& request, const Reflection& experiment, std::optional<double> given) {
    const Impedances<double>& media = experiment.media;
    const double omega = detail::angular_frequency(experiment.frequency), film = experiment.film_stiffness;
    const double most = experiment.film_alone(experiment.frequency);
    detail::require(!given || film == 0 || *given < most, "reflection", given.value_or(0),
                    "less than " + document::rounded(most) + ", that of the film alone");
    Reflected reflected{.from_stiffness = !given};
    if (given && request.reflection_error) {
        reflected.reflection_error = request.reflection_error;
        reflected.stiffness_error = detail::measured_stiffness(*given, *request.reflection_error, media, omega).error;
    }
    reflected.stiffness = given ? stiffness_from_reflection(*given, media, omega) - film
                                : request.stiffness.value(io::Dimension::stiffness_per_area,
                                                          surface::option_name(request.prefix, "stiffness"));
    const double seen = reflected.stiffness + film;
    reflected.reflection = given ? *given : reflection(seen, media, omega);
    reflected.transmission = std::abs(detail::complex_transmission(seen, media, omega));
    reflected.phase = std::arg(detail::complex_reflection(seen, media, omega));
    reflected.transmitted_energy = detail::transmitted_energy(seen, media, omega);
    return reflected;
}

/// The curve in \p file.
MeasuredCurve curve_of(const std::string& file, const std::string& name) {
    std::error_code ignored;
    if (file != "-" && !std::filesystem::exists(document::path_of(file), ignored))
        throw domain_error(name + " = \"" + file + "\": must be a number or an existing file of measured reflections");
    return read_measured_curve(file);
}

}  // namespace

Reflection reflection_of(const ReflectionRequest& request, std::optional<MeasuredCurve> curve) {
    const auto name = [&](std::string_view key) { return surface::option_name(request.prefix, key); };
    const bool of_reflection = curve || !request.reflection.empty();
    const std::string error = name("reflection_error");
    if (request.stiffness.empty() != of_reflection)
        throw document::option_error("give one of " + name("stiffness") + " and " + name("reflection") +
                                     "; the other is computed");
    if (request.reflection_error && !of_reflection)
        throw document::option_error(error + " is that of " + name("reflection") + ", which is not there");
    if (request.reflection_error && !(*request.reflection_error >= 0 && *request.reflection_error < 1))
        throw domain_error(error + " = " + document::shortest(*request.reflection_error) +
                           ": must be at least 0 and less than 1");
    std::optional<double> given;
    if (of_reflection && !curve) {
        given = as_number(request.reflection);
        if (!given) curve = curve_of(request.reflection.text(), name("reflection"));
    }
    if (request.frequency.empty() && !(curve && curve->has_frequencies))
        throw document::option_error(name("frequency") + " is missing; give it" +
                                     (curve ? ", or a column frequency in " + curve->name : ""));
    Reflection reflection;
    if (!request.frequency.empty())
        reflection.frequency = request.frequency.positive(io::Dimension::frequency, name("frequency"));
    reflection.media.incident = impedance_of(request.incident, request, "", reflection.materials);
    reflection.media.beyond = request.beyond.given() ? impedance_of(request.beyond, request, "2", reflection.materials)
                                                     : reflection.media.incident;
    if (request.wave == WaveKind::shear && reflection.materials.empty())
        throw document::option_error(name("wave") + " chooses the speed of sound of " + name("material") +
                                     ", which is not there; give an impedance of shear waves without it");
    reflection.welded = detail::welded_reflection(reflection.media);
    if (!request.film_stiffness.empty())
        reflection.film_stiffness =
            request.film_stiffness.positive(io::Dimension::stiffness_per_area, name("film_stiffness"));
    if (curve) {
        convert_curve(request, *std::move(curve), reflection);
        return reflection;
    }
    reflection.one = at_one(request, reflection, given);
    const double most = reflection.film_alone(reflection.frequency);
    if (given && request.reflection_error && 2 * *request.reflection_error >= most - *given)
        reflection.warnings.push_back(
            near_the_end(document::rounded(most) + (most < 1 ? ", that of the film alone" : ""), ""));
    return reflection;
}

}  // namespace fstiff::actions
