// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Ultrasound at an interface that acts as a spring: the reflection of a stiffness, or the stiffness of measured
// reflections.

#include "actions/measured_curve.hpp"
#include "document/document.hpp"
#include "surface/surface_option_table.hpp"

#include <fstiff/wave/common_stiffness.hpp>
#include <fstiff/wave/spring_interface.hpp>

#include <optional>
#include <string>
#include <vector>

namespace fstiff::actions {

/// A body: its acoustic impedance, or what gives it: the name of its material, or density and velocity.
struct BodyRequest {
    request::Amount impedance{}, density{}, velocity{};
    std::string material{};
    [[nodiscard]] bool given() const {
        return !impedance.empty() || !density.empty() || !velocity.empty() || !material.empty();
    }
};

/// One of a stiffness, a reflection, a file of reflections and a curve of them; the wave; and both bodies.
struct ReflectionRequest {
    request::Amount stiffness{};               ///< K per nominal area
    request::Amount reflection{};              ///< |R|, or the file of a measured curve
    std::optional<double> reflection_error{};  ///< standard error of |R|, where no curve has its own
    request::Amount film_stiffness{};          ///< of a fluid film in parallel with K; empty: none
    request::Amount frequency{};               ///< empty: of the file
    WaveKind wave = WaveKind::longitudinal;    ///< whose speed a material has
    BodyRequest incident{}, beyond{};          ///< of the wave; beyond: as incident where it is not given
    std::string prefix{};                      ///< of the names of options in messages: "--" on a command line

    template <class Take>
    void each_field(Take take) {
        take("stiffness", stiffness, {"normal contact stiffness K per nominal area, such as \"1.764 GPa/um\""});
        take("reflection", reflection,
             {"reflection coefficient |R| of displacement amplitudes, less than 1; or a file (CSV) of reflections "
              "against pressure, frequency or both, with reflection_error and phase if known, to K; - is standard "
              "input"});
        take("reflection_error", reflection_error,
             {"standard error of the reflection coefficient, where a file has no column of it"});
        take("film_stiffness", film_stiffness,
             {"stiffness per area of a fluid film in parallel with K, bulk modulus over thickness, such as \"0.1 "
              "GPa/um\""});
        take("frequency", frequency,
             {"frequency of the wave, such as \"7 MHz\"; a file may have a column of it instead"});
        const auto take_body = [&](BodyRequest& body, const std::string& suffix, const std::string& which) {
            take("material" + suffix, body.material,
                 {.help = "material of " + which + ", such as steel, for its impedance (fstiff help materials)"});
            take("impedance" + suffix, body.impedance,
                 {.help = "impedance of that body instead, such as \"46 MRayl\""});
            take("density" + suffix, body.density,
                 {.help = "density of that body, such as \"7850 kg/m^3\"; needs --velocity" + suffix});
            take("velocity" + suffix, body.velocity,
                 {.help = "velocity of sound in that body, such as \"5900 m/s\"; needs --density" + suffix});
        };
        take_body(incident, "", "the body that the wave comes from");
        take_body(beyond, "2", "the body beyond (default: the same)");
        take("wave", wave, {"kind of wave, for the speed of sound of a material: longitudinal (default) or shear"});
    }
};

/// Reflection and transmission of a wave at one stiffness.
struct Reflected {
    bool from_stiffness = false;  ///< else from a reflection
    double stiffness = 0, reflection = 0, phase = 0, transmission = 0,
           transmitted_energy = 0;  ///< [Pa/m], phase in rad
    std::optional<double> reflection_error{}, stiffness_error{};
};

/// The phases of a curve, compared with those of a spring.
struct PhaseCheck {
    bool of_stress = false;  ///< the phases are those of the stress, 180 degrees off those of the displacement
    std::size_t count = 0;   ///< of points with a phase and a stiffness
    double deviation = 0;    ///< rms of the phase less that which the stiffness of |R| has [rad]
    std::vector<std::optional<double>> stiffness{};  ///< by the phase alone [Pa/m], a point each; like media alone
};

/// One load of a curve, and K by all its frequencies.
struct LoadOfCurve {
    double pressure = 0;
    std::size_t points = 0;               ///< with a stiffness
    detail::CommonStiffness<double> K{};  ///< of the contacts
};

/// The stiffness of a measured curve of reflections.
struct CurveOfStiffness {
    MeasuredCurve curve;
    std::vector<double> frequencies{};  ///< a point each [Hz]
    std::vector<double> errors{};       ///< of the reflections; empty: not known
    std::optional<double> error{};      ///< that of all of them, from the request
    std::vector<std::optional<detail::MeasuredStiffness<double>>>
        stiffness{};                   ///< none where no stiffness has the reflection
    std::vector<LoadOfCurve> loads{};  ///< of a curve with several frequencies; else empty
    std::optional<detail::FrequencyTrend<double>> trend{};
    std::optional<PhaseCheck> phase{};

    [[nodiscard]] bool has_frequencies() const { return !loads.empty(); }
};

struct Reflection {
    double frequency = 0;  ///< [Hz]; 0: the curve has its own
    Impedances<double> media{};
    std::string materials{};    ///< a phrase on the named ones; empty: none
    double film_stiffness = 0;  ///< [Pa/m], which the wave sees in addition to K
    double welded = 0;          ///< |R| of the welded joint
    Reflected one{};            ///< unless there is a curve
    std::optional<CurveOfStiffness> curve{};
    std::vector<std::string> warnings{};
    bool doubtful = false;  ///< a reflection that no stiffness has, or a K that depends on the frequency

    /// |R| where the faces do not touch.
    [[nodiscard]] double film_alone(double frequency_of_wave) const;
};

/// The rows of \p curve whose R is not between that of the welded joint and that of the film alone, which no stiffness
/// gives; empty where all are.
[[nodiscard]] std::string beyond_reach(const MeasuredCurve& curve, double welded, double film_alone);
/// A sentence on an R within two of its errors of where K has no value, which is \p most, \p where.
[[nodiscard]] std::string near_the_end(const std::string& most, const std::string& where);
/// \throws option_error for options that do not fit together, domain_error for values and files out of range.
[[nodiscard]] Reflection reflection_of(const ReflectionRequest& request, std::optional<MeasuredCurve> curve = {});
/// The stiffness of \p measured as the curve of \p reflection, whose media and film are known; in its warnings what is
/// doubtful. \throws domain_error as reflection_of().
void convert_curve(const ReflectionRequest& request, MeasuredCurve measured, Reflection& reflection);
/// The document of fstiff ultrasound. The CSV of a curve with pressures has no column of R: it reads back as a measured
/// K(p).
[[nodiscard]] document::Document document_of(const Reflection& reflection);
/// \throws as reflection_of().
[[nodiscard]] document::Document document_of(const ReflectionRequest& request, std::optional<MeasuredCurve> curve = {});

}  // namespace fstiff::actions
