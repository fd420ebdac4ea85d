// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Ultrasound at an interface that acts as a spring: the reflection of a stiffness, or the stiffness of measured
// reflections.

#include "actions/measured_curve.hpp"
#include "document/document.hpp"
#include "surface/surface_option_table.hpp"

#include <fstiff/wave/spring_interface.hpp>
#include <fstiff/wave/uncertain_reflection.hpp>

#include <optional>
#include <string>
#include <vector>

namespace fstiff::actions {

/// A body: its acoustic impedance, or the density and velocity that give it.
struct BodyRequest {
    request::Amount impedance{}, density{}, velocity{};
    [[nodiscard]] bool given() const { return !impedance.empty() || !density.empty() || !velocity.empty(); }
};

/// One of a stiffness, a reflection, a file of reflections and a curve of them; the wave; and both bodies.
struct ReflectionRequest {
    request::Amount stiffness{};               ///< K per nominal area
    request::Amount reflection{};              ///< |R|, or the file of a measured curve
    std::optional<double> reflection_error{};  ///< standard error of |R|, where no curve has its own
    request::Amount film_stiffness{};          ///< of a fluid film in parallel with K; empty: none
    request::Amount frequency{};
    BodyRequest incident{}, beyond{};  ///< of the wave; beyond: as incident where it is not given
    std::string prefix{};              ///< of the names of options in messages: "--" on a command line

    template <class Take>
    void each_field(Take take) {
        take("stiffness", stiffness, {"normal contact stiffness K per nominal area, such as \"1.764 GPa/um\""});
        take("reflection", reflection,
             {"reflection coefficient |R| of displacement amplitudes, less than 1; or a file (CSV) of pressure, "
              "reflection "
              "and, if known, reflection_error, to K(p); - is standard input"});
        take("reflection_error", reflection_error,
             {"standard error of the reflection coefficient, where a file has no column of it"});
        take("film_stiffness", film_stiffness,
             {"stiffness per area of a fluid film in parallel with K, bulk modulus over thickness, such as \"0.1 "
              "GPa/um\""});
        take("frequency", frequency, {.help = "frequency of the wave, such as \"7 MHz\"", .required = true});
        const auto take_body = [&](BodyRequest& body, const std::string& suffix, const std::string& which) {
            take("impedance" + suffix, body.impedance, {.help = "impedance of " + which + ", such as \"46 MRayl\""});
            take("density" + suffix, body.density,
                 {.help = "density of that body, such as \"7850 kg/m^3\"; needs --velocity" + suffix});
            take("velocity" + suffix, body.velocity,
                 {.help = "velocity of sound in that body, such as \"5900 m/s\"; needs --density" + suffix});
        };
        take_body(incident, "", "the body that the wave comes from");
        take_body(beyond, "2", "the body beyond (default: the same)");
    }
};

/// Reflection and transmission of a wave at one stiffness.
struct Reflected {
    bool from_stiffness = false;  ///< else from a reflection
    double stiffness = 0, reflection = 0, phase = 0, transmission = 0,
           transmitted_energy = 0;  ///< [Pa/m], phase in rad
    std::optional<double> reflection_error{}, stiffness_error{};
};

/// The stiffness of a measured curve of reflections.
struct CurveOfStiffness {
    MeasuredCurve curve;
    std::vector<double> errors{};   ///< of the reflections; empty: not known
    std::optional<double> error{};  ///< that of all of them, from the request
    std::vector<std::optional<detail::MeasuredStiffness<double>>>
        stiffness{};  ///< none where no stiffness has the reflection
};

struct Reflection {
    double frequency = 0;  ///< [Hz]
    Impedances<double> media{};
    double film_stiffness = 0;          ///< [Pa/m], which the wave sees in addition to K
    double welded = 0, film_alone = 1;  ///< |R| of the welded joint, and where the faces do not touch
    Reflected one{};                    ///< unless there is a curve
    std::optional<CurveOfStiffness> curve{};
    std::vector<std::string> warnings{};
    bool doubtful = false;  ///< a reflection that no stiffness has
};

/// The rows of \p curve whose R is not between that of the welded joint and that of the film alone, which no stiffness
/// gives; empty where all are.
[[nodiscard]] std::string beyond_reach(const MeasuredCurve& curve, double welded, double film_alone);
/// \throws option_error for options that do not fit together, domain_error for values and files out of range.
[[nodiscard]] Reflection reflection_of(const ReflectionRequest& request, std::optional<MeasuredCurve> curve = {});
/// The document of fstiff ultrasound. The CSV of a curve has no column of R: it reads back as a measured K(p).
/// \throws as reflection_of().
[[nodiscard]] document::Document document_of(const ReflectionRequest& request, std::optional<MeasuredCurve> curve = {});

}  // namespace fstiff::actions
