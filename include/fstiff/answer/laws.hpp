// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// A law by its name at run time: its row, in answer/law_rows_inline.hpp. To add a law: docs/extending.md.

#include <fstiff/answer/any_contact.hpp>
#include <fstiff/answer/chosen_law.hpp>
#include <fstiff/asperity/plastic_laws.hpp>
#include <fstiff/contact/interaction.hpp>
#include <fstiff/core/names.hpp>
#include <fstiff/core/parallel.hpp>
#include <fstiff/measure/height_shape.hpp>
#include <fstiff/peaks/peak_distribution.hpp>
#include <fstiff/peaks/quantity.hpp>
#include <fstiff/surface/band_spectrum.hpp>
#include <fstiff/surface/material_ratio_curve.hpp>
#include <fstiff/surface/material_ratio_slope.hpp>
#include <fstiff/surface/moments.hpp>
#include <fstiff/surface/spectrum.hpp>
#include <fstiff/surface/sum_of_faces.hpp>
#include <fstiff/topography/edges.hpp>
#include <fstiff/topography/height_map.hpp>
#include <fstiff/topography/summits.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fstiff { inline namespace v0_1 {

template <Real T>
class PeakHeights;

namespace detail {

/// The bearing curve of heights over their rms; none of a Gaussian shape. \throws domain_error as bearing_of_moments.
[[nodiscard]] std::shared_ptr<const MaterialRatioSlope<double>> bearing_of_shape(const HeightShape<double>& shape);

/// The spectra that a function makes, of each way to go on beyond the edges: each costs a transform of every map, so
/// that it is made when a law first asks for it, and all copies of a surface share it.
class SpectraOfMaps {
public:
    using Make = std::function<SpectrumShells<double>(Edges)>;
    explicit SpectraOfMaps(Make make) : make_(std::move(make)) {}

    [[nodiscard]] const SpectrumShells<double>& shells(Edges edges) const {
        const std::lock_guard lock(guard_);
        auto& spectrum = shells_[static_cast<std::size_t>(edges)];
        if (!spectrum) spectrum = make_(edges);
        return *spectrum;
    }

private:
    Make make_;
    mutable std::mutex guard_;
    mutable std::array<std::optional<SpectrumShells<double>>, 2> shells_;
};

/// Within which load means a law of plastic peaks holds.
struct PlasticRange {
    double least_interference = 0;  ///< of omega/omega_c
    double most_interference = std::numeric_limits<double>::infinity();
    double most_radius_ratio = std::numeric_limits<double>::infinity();  ///< of a/R
};

/// Where Persson's theory takes the spectrum of.
enum class SpectrumSource { map, moments };

/// Options of the sections contact.<law> of a scene; those of persson and boundary_elements count for other laws too.
struct LawOptions {
    bool mutual = true;                        ///< summits push each other down
    double gamma = 0.45;                       ///< of persson
    std::optional<SpectrumSource> spectrum{};  ///< none: as in [surface]
    int points = 256;                          ///< of boundary_elements, a side
    Edges edges = Edges::mirrored;             ///< of summits and spectra too
    double hardness = 0;                       ///< [Pa]; 0: elastic
};

struct ContactInputs;
struct Face;
struct LawCurve;
struct ResolvedJoint;
struct Request;
struct Solved;

/// Inputs of laws from a measured map in addition to its numbers. What computes with the heights of maps is in its
/// virtual functions alone, so that a program for a joint of numbers has none of it.
class MapOfSurface {
public:
    std::vector<std::shared_ptr<const HeightMap<double>>> maps;  ///< without form; of two faces one sum for each shift
    std::vector<Summits<double>> summits;                        ///< one for each map
    std::shared_ptr<const SpectraOfMaps> spectra;  ///< none where points are missing, or fewer than 4 a side
    double mean_square_height = 0;                 ///< of the maps, that of two faces the sum of both [m^2]
    double height_factor = 1;                      ///< heights over those of the maps, where a surface was drawn

    virtual ~MapOfSurface() = default;
    [[nodiscard]] double rms_height() const { return height_factor * std::sqrt(mean_square_height); }
    /// Where there are spectra.
    [[nodiscard]] SpectrumShells<double> spectrum(Edges edges = Edges::mirrored) const {
        return detail::scaled(spectra->shells(edges), height_factor);
    }
    /// The contact of the maps by \p law: summits, hybrid, plastic or boundary_elements.
    [[nodiscard]] virtual std::unique_ptr<AnyContact> contact(LawKind law, const ContactInputs& inputs) const = 0;
    /// The map number \p shift, \p growth times as high, of whose \p a_side^2 tiles each is there as often as \p tiles
    /// has it.
    [[nodiscard]] virtual std::shared_ptr<const MapOfSurface> resampled(std::size_t shift, std::size_t a_side,
                                                                        const std::vector<std::size_t>& tiles,
                                                                        double growth) const = 0;
    /// The maps \p factor times as high.
    [[nodiscard]] virtual std::shared_ptr<const MapOfSurface> scaled(double factor) const = 0;
    /// Why it has no sum of heights with \p other; empty where it has one.
    [[nodiscard]] virtual std::string no_sum(const MapOfSurface& other) const = 0;
    /// The sums of heights with \p other at \p shifts random shifts of \p other.
    [[nodiscard]] virtual std::shared_ptr<const MapOfSurface> sum(const MapOfSurface& other, int shifts,
                                                                  std::uint64_t seed) const = 0;
    /// The pieces of what the laws of \p request keep of the maps, for several threads.
    [[nodiscard]] virtual std::vector<std::function<void()>> pieces(const ResolvedJoint& problem,
                                                                    const Request& request) const = 0;
    /// Rms height [m] of the white noise in the maps, which have spectra.
    [[nodiscard]] virtual double noise(Edges edges) const = 0;
    /// Boundary elements at each point of \p request where they count, of peaks that yield where it \p flows; \p curve
    /// has the states that its law reaches, and gets those that only they reach. \p problem has this map.
    [[nodiscard]] virtual std::vector<Solved> solve(const ResolvedJoint& problem, const Request& request, bool flows,
                                                    LawCurve& curve, const ProgressHook& progress) const = 0;
};

/// K of hybrid of many surfaces of numbers, faster than by a contact of each.
class QuickHybrid {
public:
    virtual ~QuickHybrid() = default;
    /// K [Pa/m] of the surface of \p inputs; none where it takes the contact itself.
    [[nodiscard]] virtual std::optional<double> stiffness(const ContactInputs& inputs, double pressure) const = 0;
    /// The pressure [Pa] over the separation [m] of the surface of \p inputs, which must outlive it; none where it
    /// takes the contact itself.
    using PressureOver = std::function<std::optional<double>(double separation)>;
    [[nodiscard]] virtual PressureOver pressure(const ContactInputs& inputs) const = 0;
};

/// What a contact is made of.
struct ContactInputs {
    Roughness<double> surface{};
    double effective_modulus = 0;                     ///< [Pa]
    const PeakDistribution<double>* peaks = nullptr;  ///< none of a law that has no joint distribution
    double fractal_dimension = 0;                     ///< of a law that needs it
    Interaction<double> interaction{};
    LawOptions options{};
    SpectralMoments<double> moments{};  ///< of the surface, where the spectrum is a band
    double hurst = 0.8;
    const MapOfSurface* map = nullptr;  ///< none: numbers alone
    bool spectrum_of_map = false;
    const MaterialRatioSlope<double>* bearing = nullptr;  ///< of heights over the rms height; none: Gaussian heights
    std::shared_ptr<const PeakHeights<double>> peak_heights{};  ///< none: Gaussian
    const QuickHybrid* similar = nullptr;                       ///< of surfaces for a band: K alone counts, to 1e-3
    PlasticMaterial<double> material{};                         ///< of the softer body
    ProgressHook progress{};                                    ///< called once a state where that takes seconds
};

/// One law.
struct Law {
    LawKind which{};
    std::string_view name = name_of(which);
    std::string_view nature;       ///< what it computes: the rest of a sentence "hertz is ..."
    bool needs_dimension = false;  ///< the fractal dimension of the surface
    bool has_peaks = true;         ///< one curve for each joint distribution of peaks; else one curve
    /// The equations of the paper, or their replacements.
    std::string_view load, stiffness, peaks;
    /// \throws domain_error naming the parameter that is out of range.
    std::unique_ptr<AnyContact> (*contact)(const ContactInputs&) = nullptr;
    Quantity quantities = Quantity::all;  ///< that the law gives
    bool needs_spectrum = false, needs_map = false, needs_hardness = false, needs_yield = false;
    bool needs_summits = false, needs_whole_map = false;  ///< of the map; the latter of 16 points a side at least
    bool holds_when_crowded = false;                      ///< peaks that push each other down are in it
    bool ends = false;            ///< has no state above some pressure: the curve ends there, with a warning
    bool has_quick_form = false;  ///< without LawOptions::mutual, for the shape of a band
    bool varies = true;           ///< can be computed of surfaces drawn about the measured one, for a band, and fitted
    PlasticRange range{};         ///< of a law whose contact has means_at

    /// Whether it is over a distribution of peaks, of which R and D_p are known.
    [[nodiscard]] bool needs_radius() const { return !holds_when_crowded && !needs_map; }
};

/// All laws, in the order in which choices are listed.
[[nodiscard]] std::span<const ChosenLaw> all_laws();
[[nodiscard]] std::vector<std::string_view> law_names();
/// \p name must not be none.
[[nodiscard]] const Law& find_law(LawKind name);
/// The law called \p name; null when there is none.
[[nodiscard]] const Law* find_law(std::string_view name);

}  // namespace detail
}}  // namespace fstiff

namespace fstiff { inline namespace v0_1 {

template <>
inline constexpr auto enum_names<detail::SpectrumSource> = detail::name_list<detail::SpectrumSource>(
    {{detail::SpectrumSource::map, "map"}, {detail::SpectrumSource::moments, "moments"}});

}}  // namespace fstiff
