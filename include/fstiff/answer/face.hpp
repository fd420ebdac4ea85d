// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// A rough face as the contact sees it, and two of them as one.

#include <array>
#include <cstdint>
#include <fstiff/answer/joint.hpp>
#include <fstiff/answer/laws.hpp>
#include <fstiff/measure/measure.hpp>
#include <fstiff/measure/unmeasured_waves.hpp>
#include <fstiff/surface/material_ratio_slope.hpp>
#include <fstiff/surface/moments.hpp>
#include <fstiff/surface/process_prior.hpp>
#include <fstiff/surface/sum_of_faces.hpp>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fstiff { inline namespace v0_1 { namespace detail {

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
    bool worn = false, whole = false;                 ///< as JointFace has them
    std::vector<Prior> priors;                        ///< none of what is known; of a sum those of both faces
    bool spectrum_of_map = true;                      ///< [persson] spectrum = "map", where there is one
    std::string_view instead_of_map{};                ///< the number that was given in place of those of the map
    std::shared_ptr<const MapOfSurface> map;          ///< where the surface was measured as a map
    std::optional<HeightStatistics<double>> heights;  ///< where the surface was measured
    HeightShape<double> shape;                        ///< of the heights, given or as far as a measured one counts
    std::shared_ptr<const MaterialRatioSlope<double>>
        bearing;  ///< of heights over the rms height; none of Gaussian heights
    std::shared_ptr<const PeakHeights<double>> peak_heights;  ///< none: Gaussian ones, for Greenwood and Williamson
    std::shared_ptr<const Surface<double>> measured;          ///< none for a sum
    std::optional<double> lambda_s;                           ///< that it was measured with [m]
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

/// Why two faces have no sum of heights; empty where both are maps of one grid.
[[nodiscard]] std::string no_sum_of_maps(const Face& upper, const Face& lower);
/// Both faces as one; of maps of one grid the heights are added at \p shifts random shifts of the one of less rms
/// height, so that exchanged faces have the same sum. Without shifts: of numbers alone, without errors and neighbours.
/// \throws domain_error where the sum is out of range.
[[nodiscard]] Face sum_of_faces(const Face& upper, const Face& lower, int shifts = 0, std::uint64_t seed = 0);

}}}  // namespace fstiff::detail
