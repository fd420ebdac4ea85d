// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// A joint as the laws take it: the rough face that a smooth one meets, the bodies, the distributions of peaks.

#include <fstiff/answer/joint.hpp>
#include <fstiff/answer/laws.hpp>
#include <fstiff/contact/interaction.hpp>
#include <fstiff/core/error.hpp>
#include <fstiff/core/names.hpp>
#include <fstiff/core/parallel.hpp>
#include <fstiff/measure/measure.hpp>
#include <fstiff/peaks/peak_distribution.hpp>
#include <fstiff/surface/moments.hpp>
#include <fstiff/surface/process_prior.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// A rough face as the contact sees it, and two of them as one.

namespace fstiff::inline v0_1::detail {

/// The greatest D that a scene may give: K of the fractal laws, which goes as 1/(2 - D), is 67 times that of hertz
/// there.
inline constexpr double greatest_dimension = 1.99;

/// Where the range of a number comes from that is not known.
enum class Origin {
    process,       ///< of the face, or of any
    islands,       ///< R and D_p as those of islands
    spacing,       ///< RSm, which counts the long waves alone
    slope,         ///< Rdq across the lay
    mean_height,   ///< Ra
    mean_heights,  ///< Sa
    measurement
};
/// One number of a face that is not known: 5 and 95 % of it, where the face has the middle.
struct Prior {
    Unknown which{};
    double low = 0, high = 0;
    Origin origin = Origin::measurement;
    PriorRange range{};  ///< of the number that was assumed: of the rms height Ra/Rq or Sa/Sq
};

/// An rms gradient that no surface has, likely for a unit of length.
struct ImplausibleGradient {
    enum class Source { measured, given, peaks, height } source;  ///< peaks: R and D_p; height: sigma and R
    double value;
};

/// One rough face, or the sum of two that a smooth face meets instead. What is written of it overrides what was
/// measured by write() alone.
struct Face {
    SurfaceParameters<double> parameters;              ///< with their errors; without fits and islands
    std::optional<double> rms_gradient, alpha, hurst;  ///< written, or measured; alpha is Nayak's m0 m4/m2^2
    double gradient_error = 0;   ///< standard error of rms_gradient that is independent of all others
    double gradient_growth = 0;  ///< d ln g/d ln sigma of an rms_gradient that was assumed from the height; 0: known
    double widest_band = std::numeric_limits<double>::infinity();  ///< greatest wave number over the least, as measured
    bool radius_follows = false, density_follows = false;  ///< R, D_p: of the moments that the other numbers make
    bool gradient_of_islands = false;  ///< rms_gradient is that of R and D_p, which no Gaussian surface has
    Process process = Process::unknown;
    std::vector<Prior> priors;                            ///< none of what is known; of a sum those of both faces
    bool spectrum_of_map = true;                          ///< [persson] spectrum = "map", where there is one
    std::string_view instead_of_map{};                    ///< the number that was given in place of those of the map
    std::shared_ptr<const MapOfSurface> map;              ///< where the surface was measured as a map
    std::optional<HeightStatistics<double>> heights;      ///< where the surface was measured
    HeightShape<double> shape;                            ///< of the heights, given or as far as a measured one counts
    std::shared_ptr<const BearingSlope<double>> bearing;  ///< of heights over the rms height; none of Gaussian heights
    std::shared_ptr<const Surface<double>> measured;      ///< none for a sum
    std::optional<double> lambda_s;                       ///< that it was measured with [m]
    /// The map with the lambda_s of the tables, which `map` has not: none where lambda_s was given, or there is none.
    std::shared_ptr<const HeightMap<double>> filtered;
    std::vector<Face> neighbours;  ///< with a smaller and a greater lambda_s, where they were measured

    [[nodiscard]] Roughness<double> roughness() const;
    /// The parameter \p parameter, where it is known.
    [[nodiscard]] std::optional<double> value(Parameter parameter) const;
    /// D, where it is known.
    [[nodiscard]] std::optional<double> dimension() const { return value(Parameter::fractal_dimension); }
    /// Whether R and D_p are known.
    [[nodiscard]] bool has_radius_and_density() const {
        return parameters.find(Parameter::peak_radius) && parameters.find(Parameter::peak_density);
    }
    /// Whether r and theta are known.
    [[nodiscard]] bool has_peaks() const { return parameters.r && parameters.theta; }
    /// Waves longer than the measurement that a nominal contact with the \p side (root of its area, [m]) has: none
    /// where rms_height was given.
    [[nodiscard]] UnmeasuredWaves<double> unmeasured(double side) const {
        return detail::unmeasured_waves(parameters.long_end, side);
    }
    /// Whether some parameter that enters has an error.
    [[nodiscard]] bool has_measured_errors() const;
    /// Whether a band can be given: the same, or something is not known.
    [[nodiscard]] bool has_errors() const { return has_measured_errors() || !priors.empty(); }
    [[nodiscard]] bool is_open(Unknown unknown) const;
    /// Whether the rms gradient is more than what R and D_p imply.
    [[nodiscard]] bool has_own_gradient() const { return rms_gradient && !gradient_of_islands; }

    /// Whether it is a profile that is taken to run across the lay: its process does not show whether there is one.
    [[nodiscard]] bool is_taken_across() const {
        return measured && measured->is_profile && process == Process::unknown;
    }

    /// Calls \p put with this face and with its neighbours, which all hold what is written.
    template <class Write>
    void write(const Write& put) {
        put(*this);
        for (Face& neighbour : neighbours) put(neighbour);
    }
    /// \p value without an error in place of what was measured, to which the errors of other parameters have no
    /// relation.
    void write(Parameter parameter, double value);
    /// The known parameters take the values of \p drawn, in the order of Parameter.
    void draw(const std::array<double, detail::surface_parameter_count>& drawn);
    /// Sets \p shape and its bearing curve; bearing_of_moments() must accept it.
    void set_shape(const HeightShape<double>& shape);
    /// Gives R and D_p, where they follow, the values that the other numbers make.
    void follow();
};

/// Moments of the spectrum of \p face: from rms gradient and alpha where they are known, else from R and D_p with eq.
/// (4.10) and Nayak. And its Hurst exponent: 2 - D, or 0.8 where neither is known, but no less than a band takes that
/// is as wide as what was measured.
[[nodiscard]] SpectralMoments<double> spectral_moments(const Face& face);
[[nodiscard]] double hurst_exponent(const Face& face);
/// Whether the joint peaks of \p face follow from its alpha: it is known, or the face has a gradient of its own, and it
/// is above
/// 1.5.
[[nodiscard]] bool has_isotropic_peaks(const Face& face);
/// How many points of the maps of \p map are missing.
[[nodiscard]] Eigen::Index missing_points(const MapOfSurface& map);

/// The first rms gradient of \p face that no surface has, of those given or measured, and implied by what is written of
/// sigma, R and D_p, whose peaks have the correlation \p r.
[[nodiscard]] std::optional<ImplausibleGradient> implausible_gradient(const Face& face, double r);

/// Inputs of laws from \p maps, at least one, of one surface.
[[nodiscard]] std::shared_ptr<const MapOfSurface> map_of_surface(
    std::vector<std::shared_ptr<const HeightMap<double>>> maps);

/// Why two faces have no sum of heights; empty where both are maps of one grid.
[[nodiscard]] std::string no_sum_of_maps(const Face& upper, const Face& lower);
/// Both faces as one; of maps of one grid the heights are added at \p shifts random shifts of the one of less rms
/// height, so that exchanged faces have the same sum. Without shifts: of numbers alone, without errors and neighbours.
/// \throws domain_error where the sum is out of range.
[[nodiscard]] Face sum_of_faces(const Face& upper, const Face& lower, int shifts = 0, std::uint64_t seed = 0);

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

enum class InteractionLength { nominal, peak_spacing, given };

/// A joint, resolved. A surface drawn at random, a neighbour and an unknown at its end are the same with another face.
struct Problem {
    Face face;                          ///< that a smooth one meets: the rough one, or the sum of two
    std::vector<Face> faces;            ///< that the sum is of, the upper one first; empty where one face is smooth
    double effective_modulus = 0;       ///< [Pa]
    Material<double> upper{}, lower{};  ///< of which it is; 0: it was given by itself
    std::optional<double> yield_strength, hardness;  ///< the smaller of those that are known [Pa]
    std::optional<PriorRange> hardness_range;        ///< of that body, where it is not known
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
    ParallelHook parallel{};  ///< of solutions by boundary elements, contacts of a map and surfaces for a band
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
    hardness,     ///< is infinite
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

/// The face of \p spec as the contact has it: what is written counts before what was measured, and that before a prior.
/// \throws domain_error naming the member of \p spec.
[[nodiscard]] Face face_of(const JointFace& spec);
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
/// Whether all that was measured of \p problem are traces.
[[nodiscard]] bool is_of_traces(const Problem& problem);
/// Whether some face was measured by a profile that repeats itself.
[[nodiscard]] bool has_lay(const Problem& problem);

/// The rms gradient of the surface for p*, the same for every law: known or assumed; of the surface's own r and theta;
/// of R and D_p, by their spectrum or as islands; else of the last entry of `peaks` that gives one (r = 0 gives none).
[[nodiscard]] std::optional<double> gradient(const Problem& problem);
/// The interaction with its length [m].
[[nodiscard]] Interaction<double> interaction(const Problem& problem);
/// The indentation hardness of the softer body [Pa], of its yield strength where that alone is known, or assumed;
/// infinite: it never yields.
[[nodiscard]] double hardness_of(const Problem& problem);
/// H/(E g), of the softer body and the surface; none where the gradient is not known, and of a body that never yields.
[[nodiscard]] std::optional<double> relative_hardness(const Problem& problem);
/// Whether K of \p law is that of yielded spots.
[[nodiscard]] bool flows(const Problem& problem, const Law& law);

/// Why \p face has no spectrum for Persson's theory.
[[nodiscard]] Lack lack_of_spectrum(const Face& face);
/// Why \p law cannot be computed of \p problem.
[[nodiscard]] Lack lack_of(const Law& law, const Problem& problem, bool at_separations = false);

/// \p lack as the reason of a law.
[[nodiscard]] std::string reason_of(Lack lack);
/// \throws domain_error where \p law cannot be computed of \p problem.
void require_possible(const Law& law, const Problem& problem);
/// The row of \p law. \throws as require_possible, and where \p law is none.
[[nodiscard]] const Law& possible_law(const ChosenLaw& law, const Problem& problem);

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
/// Points above which states and bands are interpolated: states within 1e-7, from a table over ln p where it has them,
/// ends of bands within 1e-3, except next to a hardness.
inline constexpr std::size_t many_points = 1000;
/// The states at the points of \p request; every point is independent, so that they may be computed in parts, one by
/// one where \p law takes seconds for each, with \p progress called between them.
[[nodiscard]] std::vector<ContactPoint<double>> points_of(const Request& request, const Law& law,
                                                          const AnyContact& contact, Quantity quantities,
                                                          const ProgressHook& progress = {});

}  // namespace fstiff::inline v0_1::detail

namespace fstiff::inline v0_1 {

/// A given length is written as such.
template <>
inline constexpr auto names<detail::InteractionLength> = detail::name_list<detail::InteractionLength>(
    {{detail::InteractionLength::nominal, "nominal"}, {detail::InteractionLength::peak_spacing, "peak_spacing"}});

}  // namespace fstiff::inline v0_1

// Numbers of a face that are not given: assumed values, their uncertainty, and its effect on K.

namespace fstiff::inline v0_1::detail {

/// Gives \p face, whose rms height is known, the numbers that a spectrum needs beyond those it has, by its process,
/// with a prior for each; the shape of the heights too unless \p shape_known. R or D_p that is not known follows.
void fill_unknown(Face& face, bool shape_known);

/// \p shape with its \p unknown, skewness or kurtosis, at \p value.
[[nodiscard]] HeightShape<double> with_value(const HeightShape<double>& shape, Unknown unknown, double value);
/// \p face with \p unknown at \p value, and with all that follows from it.
[[nodiscard]] Face with_value(Face face, Unknown unknown, double value);

/// \p face as it is with \p unknown measured, and found at its middle; skewness and kurtosis come from one measurement.
[[nodiscard]] Face with_measured(Face face, Unknown unknown);

/// A number of a face that is not known.
struct FeltPrior {
    std::size_t face;  ///< its place among rough_faces()
    const Prior* prior;
};
/// Those that one of \p laws depends on; none where the laws take the spectrum of a map.
[[nodiscard]] std::vector<FeltPrior> felt_priors(const Problem& problem, const std::vector<const Law*>& laws);

/// Whether one of \p laws depends on the hardness.
[[nodiscard]] bool feels_hardness(const Problem& problem, const std::vector<const Law*>& laws);
/// \p problem whose hardness is known to be \p value.
[[nodiscard]] Problem with_hardness(Problem problem, double value);

/// The surface of a joint with one unknown at its 5 and at its 95 %.
struct Alternative {
    Unknown which{};
    Face low, high;
};
/// One of each of felt_priors().
[[nodiscard]] std::vector<Alternative> alternatives(const Problem& problem, const std::vector<const Law*>& laws);

}  // namespace fstiff::inline v0_1::detail
