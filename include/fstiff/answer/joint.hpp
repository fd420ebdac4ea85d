// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// A joint: what is pressed together, as plain values in SI.
///
///     const fstiff::Joint joint{.face = {.rms_height = 0.8e-6, .rms_gradient = 0.1},
///                               .upper = {.elastic = {210e9, 0.3}, .hardness = 2e9},
///                               .lower = {.elastic = {110e9, 0.26}},
///                               .nominal_area = 145e-6};
///
/// Reference   surface/process_prior.hpp: what is assumed where a number is not given
/// Units       SI
/// Valid       each member as it states; fstiff::answer() refuses others, and names the member
/// Accuracy    that of the numbers

#include <fstiff/asperity/conductance.hpp>
#include <fstiff/asperity/material.hpp>
#include <fstiff/asperity/named_materials.hpp>
#include <fstiff/contact/interaction.hpp>
#include <fstiff/surface/material_ratio_curve.hpp>
#include <fstiff/surface/material_ratio_slope.hpp>
#include <fstiff/surface/process_prior.hpp>
#include <fstiff/wave/spring_interface.hpp>

#include <memory>
#include <numbers>
#include <optional>

namespace fstiff { inline namespace v0_1 {

namespace detail {
struct Face;
}
template <Real T>
class PeakHeights;
template <Real T>
struct Surface;
struct JointForm;

/// A measured surface as a joint takes it: what measured_face() makes.
class MeasuredFace {
public:
    virtual ~MeasuredFace() = default;
    [[nodiscard]] virtual const Surface<double>& surface() const = 0;
    [[nodiscard]] virtual detail::Face face() const = 0;  ///< as the laws have it
};
/// Face of a joint with the surface \p surface, of measure(). \throws domain_error for null.
[[nodiscard]] std::shared_ptr<const MeasuredFace> measured_face(std::shared_ptr<const Surface<double>> surface);
/// The same of a copy.
[[nodiscard]] std::shared_ptr<const MeasuredFace> measured_face(Surface<double> surface);

/// A rough face: a measured surface, or numbers. A number that is given takes the place of what was measured; one that
/// is neither given nor measured has the prior of `process`, whose width is in the band.
struct JointFace {
    std::shared_ptr<const MeasuredFace> measured{};  ///< measured_face() of a profile or a map
    std::optional<double> rms_height{};              ///< Rq, Sq [m], above 0
    std::optional<double> mean_height{};             ///< Ra, Sa [m], above 0, in place of rms_height
    std::optional<double> rms_gradient{};            ///< Sdq [1], above 0
    std::optional<double> profile_gradient{};        ///< Rdq across the lay [1], above 0, in place of rms_gradient
    std::optional<double> profile_spacing{};         ///< RSm [m], above 0, in place of rms_gradient
    std::optional<double> alpha{};                   ///< Nayak's m0 m4/m2^2, above 1.5
    std::optional<double> hurst{};                   ///< above 0, at most 1
    /// Of the heights: both or none, from -3 to 3, and from skewness^2 + 1 to 100. Below detail::least_kurtosis(), as
    /// of two levels, the curve is that of least_kurtosis().
    std::optional<double> skewness{}, kurtosis{};
    /// In place of them, the heights [m] over the material ratio: of_heights() of it, or detail::bearing_of_core().
    std::optional<MaterialRatioSlope<double>> bearing{};
    std::optional<double> peak_radius{};      ///< R [m], above 0
    std::optional<double> peak_density{};     ///< D_p [1/m^2], above 0
    std::optional<double> max_peak_height{};  ///< R_p [m], above 0
    /// Heights of the peaks for laws::greenwood_williamson, in place of Gaussian ones: PeakHeights::measured() or
    /// of_moments() of fstiff/peaks/peak_heights.hpp.
    std::shared_ptr<const PeakHeights<double>> peak_heights{};
    std::optional<double> r{}, theta{};  ///< of the joint peaks: both or none, 0 <= r < 1, theta [rad] below pi/2
    std::optional<double> fractal_dimension{};  ///< D of a profile, above 1 and at most 1.99
    std::optional<double> fractal_roughness{};  ///< G [m], above 0
    Process process = Process::unknown;
    bool worn = false;   ///< it has run against another face: the shape of its heights is that of honed ones
    bool whole = false;  ///< a measured map is the whole face, which nobody presses further out; else a piece of it

    /// Standard errors, 0 or more, of the numbers that are given; of those that were measured in place of the error of
    /// the measurement.
    struct Errors {
        std::optional<double> height{};    ///< of the one that is given [m]
        std::optional<double> gradient{};  ///< the same; of profile_spacing [m]
        std::optional<double> peak_radius{}, peak_density{}, fractal_dimension{}, r{}, theta{};
    } errors{};
};

/// A body. body_of() has that of a material by name.
struct Body {
    Material<double> elastic{};              ///< E [Pa] and nu
    std::optional<double> yield_strength{};  ///< [Pa], above 0
    /// Mean pressure of an indentation [Pa], above 0, infinite of a body that never yields; none: 2.8 times the yield
    /// strength, or where that is not given either, `hardness_range`, whose width is in the band.
    std::optional<double> hardness{};
    std::optional<PriorRange> hardness_range{};  ///< of a material by name; none: detail::hardness_of_elastic()
    /// [kg/m^3], and velocities of longitudinal and shear waves [m/s], above 0; none: not known.
    std::optional<double> density{}, velocity{}, shear_velocity{};
    /// [W/(m K)], above 0, and [S/m], 0 of an insulator; none: not known.
    std::optional<double> thermal_conductivity{}, electrical_conductivity{};
    /// Of the thermal conductivity where it is the middle one: of a family of alloys by its name. It is in the band of
    /// heat.
    std::optional<PriorRange> thermal_range{};
};

/// The body of \p material: its constants, and the range of its hardness.
[[nodiscard]] inline Body body_of(const NamedMaterial& material) {
    const auto known = [](double value) { return value > 0 ? std::optional(value) : std::nullopt; };
    const auto [velocity, shear_velocity] = material.wave_speeds();
    const std::optional<double> thermal = known(material.thermal_conductivity);
    return {.elastic = material.elastic,
            .hardness_range = material.hardness(),
            .density = material.density,
            .velocity = known(velocity),
            .shear_velocity = known(shear_velocity),
            .thermal_conductivity = thermal,  // of an insulator too, whose electrical conductivity is 0
            .electrical_conductivity = thermal ? std::optional(material.electrical_conductivity) : std::nullopt,
            .thermal_range = material.thermal_range.low > 0 ? std::optional(material.thermal_range) : std::nullopt};
}

/// The waves that meet the contact: longitudinal ones see K, shear waves the tangential stiffness.
struct UltrasonicWaves {
    double frequency = 0;  ///< [Hz], above 0
    /// The wave comes from the upper body. Where `longitudinal` is {0, 0}, both are those of the densities and
    /// velocities of the bodies.
    Impedances<double> longitudinal{};
    std::optional<Impedances<double>> shear{};  ///< none: not known
    /// [Pa/m], 0 or more, that longitudinal waves see in addition to K: of a fluid film of the bulk modulus B and the
    /// thickness h, B/h.
    double film_stiffness = 0;

    [[nodiscard]] double angular() const { return detail::angular_frequency(frequency); }
};

/// Resistances to heat and current.
struct Conduction {
    /// joint_conductivity() of both bodies [W/(m K)], [S/m], above 0; none: of those that the bodies have.
    std::optional<double> thermal{}, electrical{};
    std::optional<GapFilling<double>> gap{};       ///< what lies between the faces
    double radiation = 0;                          ///< h in addition [W/(m^2 K)]
    double thermal_film = 0, electrical_film = 0;  ///< on the contacts [m^2 K/W], [ohm m^2]
};

/// Conditions of a tangential force.
struct Friction {
    double coefficient = 0;             ///< mu, above 0
    std::optional<double> amplitude{};  ///< of the tangential displacement, mean to peak [m], above 0
};

/// A ring of two diameters [m], 0 <= inner < outer.
struct Ring {
    double inner = 0, outer = 0;

    [[nodiscard]] double area() const { return std::numbers::pi / 4 * (outer - inner) * (outer + inner); }
};

/// Two bodies, and the rough faces between them.
struct Joint {
    JointFace face{};                  ///< of one body; the other is smooth, unless
    std::optional<JointFace> other{};  ///< it is rough too
    Body upper{}, lower{};
    /// [Pa], above 0, in place of the elastic constants: `upper` has the rest of the softer body then.
    std::optional<double> effective_modulus{};
    std::optional<double> nominal_area{};  ///< [m^2], above 0
    std::optional<double> aspect_ratio{};  ///< of the nominal area, its long side over its short one, 1 or more
    std::optional<Ring> ring{};            ///< that the nominal area is; none: a rectangle of this ratio, or a square
    /// [m], 0 or more: height of the gap between both faces in touch, before load, over the nominal area; of two faces
    /// with the tolerances t1 and t2 at most t1 + t2. None: the faces are taken to conform, which has a part in the
    /// band.
    std::optional<double> flatness{};
    std::shared_ptr<const JointForm> form{};    ///< the gap itself, in place of its height
    std::optional<double> greatest_pressure{};  ///< [Pa], above 0: of any earlier load; none: this is the first one
    int shifts = 4;                     ///< of the map of the other face over that of the first, where both are maps
    Interaction<double> interaction{};  ///< of the peaks, for laws that are named; those of the answer have their own
    /// Length of the interaction: as it is given, the root of the nominal area, or 1/sqrt(D_p).
    enum class InteractionLength { given, nominal, peak_spacing } interaction_length = InteractionLength::given;
    std::optional<UltrasonicWaves> waves{};
    Conduction conduction{};
    std::optional<Friction> friction{};
};

}}  // namespace fstiff
