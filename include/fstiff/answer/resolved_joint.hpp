// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// A joint as the laws take it: the rough face that a smooth one meets, the bodies, the distributions of peaks.

#include <fstiff/answer/causes.hpp>
#include <fstiff/answer/face.hpp>
#include <fstiff/answer/joint.hpp>
#include <fstiff/answer/laws.hpp>
#include <fstiff/contact/interaction.hpp>
#include <fstiff/core/names.hpp>
#include <fstiff/peaks/peak_distribution.hpp>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// One peak density; the values are checked when the PeakDistribution is made.
struct Peaks {
    double theta = 0;           ///< [rad]
    std::optional<double> r{};  ///< none: of an exponential autocorrelation
    bool of_surface = false;    ///< theta and r are those of the face, with their errors
    Place where{};              ///< for messages
    std::string key{};          ///< prefix of theta and r in them
};
/// \throws domain_error naming the place of the value that no peak density has.
[[nodiscard]] PeakDistribution<double> peak_density(const Peaks& peaks);

/// A joint, resolved. A surface drawn at random, a neighbour and an unknown at its end are the same with another face.
struct ResolvedJoint {
    Face face;                          ///< that a smooth one meets: the rough one, or the sum of two
    std::vector<Face> faces;            ///< that the sum is of, the upper one first; empty where one face is smooth
    double effective_modulus = 0;       ///< [Pa]
    Material<double> upper{}, lower{};  ///< of which it is; 0: it was given by itself
    std::optional<double> yield_strength, hardness;  ///< the smaller of those that are known [Pa]
    std::optional<PriorRange> hardness_range;        ///< of that body, where it is not known
    double softer_poisson = 0;           ///< of the body whose hardness, or 2.8 times its yield strength, is smaller
    std::optional<double> nominal_area;  ///< [m^2]
    std::optional<Ring> ring;
    std::optional<double> flatness;         ///< [m], that was given
    std::shared_ptr<const JointForm> form;  ///< of this height, or as it was given; none: the faces conform
    std::optional<double> greatest_pressure;
    std::vector<Peaks> peaks;
    bool default_peaks =
        false;  ///< `peaks` are those of the paper: none were given, and those of the face are not known
    InteractionReading reading = InteractionReading::none;
    Joint::InteractionLength length = Joint::InteractionLength::given;
    double given_length = 0;  ///< [m]
    LawOptions law_options;
    std::shared_ptr<const QuickHybrid> similar;  ///< of surfaces for a band
    std::optional<UltrasonicWaves> ultrasound;
    Conduction conduction;
    CauseSpread<double> heat{};  ///< of ln of the thermal conductivity of both bodies, where it is that of families
    std::optional<Friction> friction;
    /// What was written of it by itself, and did not come with a name: such quantities are usual ones.
    struct Given {
        bool force = false;  ///< or the ring that carries it
        bool heat = false, current = false;
    } is_given{};
};

/// Takes the elastic constants, the hardness and the yield strength of both bodies; where \p modulus [Pa] is in place
/// of the elastic constants, the rest is that of \p upper.
/// \throws domain_error for a modulus or a Poisson's ratio out of range.
void take_bodies(const Body& upper, const Body& lower, const std::optional<double>& modulus, ResolvedJoint& problem);
/// The faces that were pressed together, and those of them that were measured.
[[nodiscard]] std::vector<const Face*> rough_faces(const ResolvedJoint& problem);
[[nodiscard]] std::vector<const Face*> measured_faces(const ResolvedJoint& problem);
/// Whether all that was measured of \p problem are traces.
[[nodiscard]] bool is_of_traces(const ResolvedJoint& problem);
/// Whether some face was measured by a profile that repeats itself.
[[nodiscard]] bool has_lay(const ResolvedJoint& problem);

/// The rms gradient of the surface for p*, the same for every law: known or assumed; of the surface's own r and theta;
/// of R and D_p, by their spectrum or as islands; else of the last entry of `peaks` that gives one (r = 0 gives none).
[[nodiscard]] std::optional<double> gradient(const ResolvedJoint& problem);
/// The interaction with its length [m].
[[nodiscard]] Interaction<double> interaction(const ResolvedJoint& problem);
/// The indentation hardness of the softer body [Pa], of its yield strength where that alone is known, or assumed;
/// infinite: it never yields.
[[nodiscard]] double hardness_of(const ResolvedJoint& problem);
/// As the laws take it: 0 where it follows from the yield strength, infinite nowhere.
[[nodiscard]] double hardness_of_material(const ResolvedJoint& problem);
/// H/(E g), of the softer body and the surface; none where the gradient is not known, and of a body that never yields.
[[nodiscard]] std::optional<double> relative_hardness(const ResolvedJoint& problem);
/// Whether K of \p law is that of yielded contacts.
[[nodiscard]] bool flows(const ResolvedJoint& problem, const Law& law);

}}}  // namespace fstiff::detail

namespace fstiff { inline namespace v0_1 {

/// A given length is written as such.
template <>
inline constexpr auto enum_names<Joint::InteractionLength> = detail::name_list<Joint::InteractionLength>(
    {{Joint::InteractionLength::nominal, "nominal"}, {Joint::InteractionLength::peak_spacing, "peak_spacing"}});

}}  // namespace fstiff
