// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// A joint as the laws take it: the rough face that a smooth one meets, the bodies, the distributions of peaks.

#include <fstiff/answer/face.hpp>
#include <fstiff/answer/joint.hpp>
#include <fstiff/answer/laws.hpp>

#include <fstiff/contact/interaction.hpp>
#include <fstiff/core/error.hpp>
#include <fstiff/core/names.hpp>
#include <fstiff/core/parallel.hpp>
#include <fstiff/core/progress.hpp>
#include <fstiff/peaks/peak_distribution.hpp>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace fstiff::inline v0_1::detail {

/// One peak density; the values are checked when the PeakDistribution is made.
struct Peaks {
    double theta = 0;           ///< [rad]
    std::optional<double> r{};  ///< none: of an exponential autocorrelation
    bool of_surface = false;    ///< theta and r are those of the face, with their errors
    parts::Place where{};       ///< for messages
    std::string key{};          ///< prefix of theta and r in them
};
/// \throws domain_error naming the place of the value that no peak density has.
[[nodiscard]] PeakDistribution<double> peak_density(const Peaks& peaks);

enum class InteractionLength { nominal, peak_spacing, given };

/// A joint, resolved. A surface drawn at random, a neighbour and an unknown at its end are the same with another face.
struct Problem {
    Face face;                          ///< that a smooth one meets: the rough one, or the sum of two
    std::vector<Face> faces;            ///< that the sum is of, the upper one first; empty where one face is smooth
    double effective_modulus = 0;       ///< [Pa]
    Material<double> upper{}, lower{};  ///< of which it is; 0: it was given by itself
    std::optional<double> yield_strength, hardness;  ///< the smaller of those that are known [Pa]
    bool one_hardness = false;                       ///< of one body alone: the other may be softer
    double softer_poisson = 0;           ///< of the body whose hardness, or 2.8 times its yield strength, is smaller
    std::optional<double> nominal_area;  ///< [m^2]
    std::vector<Peaks> peaks;
    bool default_peaks =
        false;  ///< `peaks` are those of the paper: none were given, and those of the face are not known
    InteractionReading reading = InteractionReading::none;
    InteractionLength length = InteractionLength::nominal;
    double given_length = 0;  ///< [m], for InteractionLength::given
    LawOptions law_options;
    std::shared_ptr<const QuickHybrid> similar;  ///< of surfaces for a band
    std::optional<Waves> ultrasound;
    Conduction conduction;
    std::optional<Friction> friction;
};

/// What a contact is asked for.
struct Request {
    std::vector<double> points{};  ///< pressures [Pa], or separations [m]
    bool at_separations = false;
    std::vector<const Law*> laws{};       ///< none: that of the answer
    Quantity quantities = Quantity::all;  ///< of the laws that are named
    std::vector<std::size_t> answered{};  ///< places among `points` at which the answer is solved
    bool approach = false;                ///< the separation at `seating` too
    bool growth = false;                  ///< d log K/d log p too
    double seating = 1e3;                 ///< the approach is 0 at this pressure [Pa]
    int samples = 400;                    ///< of a band; 0: none
    std::uint64_t seed = 2014;
    bool solves_map = true;   ///< the answer takes boundary elements of a map
    bool answers = true;      ///< the answer too, next to laws that are named
    bool checked = true;      ///< checks and means over the load too
    ParallelHook parallel{};  ///< of solutions by boundary elements, each of which takes a second or so
};

/// Why a law cannot be computed of a joint.
enum class Lack {
    nothing,
    separation,   ///< the law gives none
    peaks,        ///< R and D_p are not known
    map,          ///< the face is not a map
    sum_of_maps,  ///< two faces are not maps of one grid
    summits,      ///< no point of the map is above its eight neighbours
    points,       ///< of the map, of which some are missing
    side,         ///< the map has fewer than 16 points a side
    small_map,    ///< the map has fewer than 4 points a side, too few for a spectrum
    moments,      ///< R and D_p, or gradient and alpha, are not known
    range,        ///< the moments are beyond the range of double precision
    alpha,        ///< that the moments make is 1.5 or less
    hardness,     ///< nor a yield strength is known
    yield_strength
};

/// A parameter of a surface in a JointFace, and its error.
struct FaceParameter {
    Parameter which;
    std::optional<double> JointFace::*value;
    std::optional<double> JointFace::Errors::*error;
};
/// In the order of Parameter.
inline constexpr FaceParameter face_parameters[]{
    {Parameter::rms_height, &JointFace::rms_height, &JointFace::Errors::height},
    {Parameter::peak_radius, &JointFace::peak_radius, &JointFace::Errors::peak_radius},
    {Parameter::peak_density, &JointFace::peak_density, &JointFace::Errors::peak_density},
    {Parameter::fractal_dimension, &JointFace::fractal_dimension, &JointFace::Errors::fractal_dimension},
    {Parameter::r, &JointFace::r, &JointFace::Errors::r},
    {Parameter::theta, &JointFace::theta, &JointFace::Errors::theta}};

/// The face of \p of as the contact has it: what is written counts before what was measured, and that before a prior.
/// \throws domain_error naming the member of \p of.
[[nodiscard]] Face face_of(const JointFace& of);
/// \p joint resolved. Two maps have the shifts that a scene has: those of the seed of Request, whatever the draws have.
/// \throws domain_error naming the member that is out of range.
[[nodiscard]] Problem problem_of(const Joint& joint, const LawOptions& options);
/// The joint peaks that were measured or given of the surface; where none are, those of the paper.
void take_peaks(Problem& problem);
/// Takes the elastic constants, the hardness and the yield strength of both bodies; where \p modulus [Pa] is in place
/// of the elastic constants, the rest is that of \p upper.
/// \throws domain_error for a modulus or a Poisson's ratio out of range.
void take_bodies(const Body& upper, const Body& lower, const std::optional<double>& modulus, Problem& problem);
/// The faces that were pressed together, and those of them that were measured.
[[nodiscard]] std::vector<const Face*> rough_faces(const Problem& problem);
[[nodiscard]] std::vector<const Face*> measured_faces(const Problem& problem);
/// Whether some face was measured by a profile that repeats itself.
[[nodiscard]] bool has_lay(const Problem& problem);

/// The rms gradient of the surface for p*, the same for every law: known or assumed; of the surface's own r and theta;
/// of R and D_p, by their spectrum or as islands; else of the last entry of `peaks` that gives one (r = 0 gives none).
[[nodiscard]] std::optional<double> gradient(const Problem& problem);
/// The interaction with its length [m].
[[nodiscard]] Interaction<double> interaction(const Problem& problem);
/// The indentation hardness of the softer body [Pa], of its yield strength where that alone is known; 0: neither is.
[[nodiscard]] double hardness_of(const Problem& problem);
/// H/(E g), of the softer body and the surface; none where one of them is not known. Where one body alone has a
/// hardness, the other one counts as at least as hard.
[[nodiscard]] std::optional<double> relative_hardness(const Problem& problem);
/// Whether K of \p law is that of yielded spots.
[[nodiscard]] bool flows(const Problem& problem, const Law& law);

/// Why \p face has no spectrum for Persson's theory.
[[nodiscard]] Lack lack_of_spectrum(const Face& face);
/// Why \p law cannot be computed of \p problem.
[[nodiscard]] Lack lack_of(const Law& law, const Problem& problem, bool at_separations = false);

/// \p lack as the reason of a law.
[[nodiscard]] std::string reason_of(Lack lack);
/// The law called \p law. \throws domain_error where it cannot be computed of \p problem.
[[nodiscard]] const Law& possible_law(LawName law, const Problem& problem);

/// The joint distributions of peaks of which \p law has a curve each; none for a law that has none. Where none are
/// given, those of an isotropic surface of its alpha; the laws of the paper keep the paper's pair.
[[nodiscard]] std::vector<Peaks> peaks_of(const Law& law, const Problem& problem);

/// A contact to be made of \p law and a distribution of peaks.
struct ContactOfLaw {
    const Law* law = nullptr;
    std::optional<double> theta{}, r{};  ///< none: a law without a joint distribution
    std::function<std::unique_ptr<AnyContact>()> make;
};
/// Calls \p visit with every law of \p laws and distribution of peaks; `make` lives as long as that call.
void for_each_contact(const Problem& problem, const std::vector<const Law*>& laws, const ProgressHook& progress,
                      const std::function<void(const ContactOfLaw&)>& visit);
/// The states at the points of \p request; every point is independent, so that they may be computed in parts, one by
/// one where \p law takes seconds for each, with \p progress called between them.
[[nodiscard]] std::vector<ContactPoint<double>> points_of(const Request& request, const Law& law,
                                                          const AnyContact& contact, Quantity quantities,
                                                          const ProgressHook& progress = {});

}  // namespace fstiff::inline v0_1::detail

namespace fstiff::inline v0_1 {

/// A given length is written as such.
template <>
inline constexpr auto names<detail::InteractionLength> = name_list<detail::InteractionLength>(
    {{detail::InteractionLength::nominal, "nominal"}, {detail::InteractionLength::peak_spacing, "peak_spacing"}});

}  // namespace fstiff::inline v0_1
