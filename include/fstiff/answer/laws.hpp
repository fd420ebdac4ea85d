// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// A law by its name at run time: one table, in answer/laws_inline.hpp. To add a law: docs/extending.md.

#include <fstiff/answer/causes.hpp>
#include <fstiff/asperity/plastic_laws.hpp>
#include <fstiff/contact/bearing_contact.hpp>
#include <fstiff/contact/contact_state.hpp>
#include <fstiff/contact/hybrid_contact.hpp>
#include <fstiff/contact/interaction.hpp>
#include <fstiff/contact/plastic_contact.hpp>
#include <fstiff/contact/rough_contact.hpp>
#include <fstiff/core/names.hpp>
#include <fstiff/core/parallel.hpp>
#include <fstiff/core/text.hpp>
#include <fstiff/identify/differences.hpp>
#include <fstiff/identify/identify.hpp>
#include <fstiff/measure/height_shape.hpp>
#include <fstiff/peaks/peak_distribution.hpp>
#include <fstiff/peaks/quantity.hpp>
#include <fstiff/surface/moments.hpp>
#include <fstiff/surface/spectrum.hpp>
#include <fstiff/topography/height_map.hpp>
#include <fstiff/topography/line_transform.hpp>
#include <fstiff/topography/summits.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

// A contact whose law is known by name only.
//
//     const auto contact = fstiff::contact_of(joint, fstiff::LawName::hybrid);
//     const double p = 10e6;
//     contact->at_pressures(std::span(&p, 1), fstiff::Quantity::stiffness).front().state.stiffness.value    [Pa/m]
//
// Reference   answer/laws.hpp: the laws
// Units       SI
// Valid       as the law
// Accuracy    that of the law: the same number as the contact by itself (tests/scene/laws_test.cpp)

namespace fstiff::inline v0_1 {

template <Real T>
class ContactLaw;
template <Real T>
struct LawRange;

/// A contact whose law is known by name only.
class AnyContact {
public:
    using Points = std::vector<ContactPoint<double>>;
    virtual ~AnyContact() = default;
    /// The states under pressures [Pa], and at separations [m]; a point out of reach has that status.
    [[nodiscard]] virtual Points at_pressures(std::span<const double> pressures, Quantity quantities) const = 0;
    [[nodiscard]] virtual Points at_separations(std::span<const double> separations, Quantity quantities) const = 0;
    /// How far the peaks are pressed in at each of \p etas, of states of this contact; empty where no range depends on
    /// it.
    [[nodiscard]] virtual std::vector<LoadMeans<double>> means_at(std::span<const double> /*etas*/) const { return {}; }
    [[nodiscard]] virtual bool has_table() const { return false; }
    /// The contact tabulated. \throws domain_error unless has_table(), and as
    /// ContactLaw::tabulate.
    [[nodiscard]] virtual ContactLaw<double> tabulate(const LawRange<double>& range) const;
};

}  // namespace fstiff::inline v0_1

// The spectra of maps, their crowded contacts by their bearing curves, and their highest points. They cost a sort and
// a transform of each map, so that they are made when a law first asks for them; all copies of a surface share them.

namespace fstiff::inline v0_1::detail {

/// The bearing curve of heights over their rms; none of a Gaussian shape. \throws domain_error as bearing_of_moments.
[[nodiscard]] std::shared_ptr<const BearingSlope<double>> bearing_of_shape(const HeightShape<double>& shape);

/// The spectra that a function makes, of each way to go on beyond the edges.
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

class BearingsOfMaps {
public:
    BearingsOfMaps(std::vector<std::shared_ptr<const HeightMap<double>>> maps, std::vector<Summits<double>> summits)
        : maps_(std::move(maps)), summits_(std::move(summits)) {}

    /// Bearing curve of the map number \p index. \throws domain_error for missing points, and as PerssonContact.
    [[nodiscard]] BearingContact<double> contact(std::size_t index, Edges edges, double modulus, double gamma) const;
    /// How hybrid goes from the summits of the map number \p index to that. \throws domain_error as contact() and
    /// SummitContact.
    [[nodiscard]] HandOver<double> hand_over(std::size_t index, Edges edges, double modulus, double gamma) const;
    /// The highest points of the map number \p index. \throws domain_error as HighestPoints.
    [[nodiscard]] MapCut<double> cut(std::size_t index, Edges edges, double modulus) const;

private:
    /// The value of \p key in \p cache, else that of \p make, which is called without the lock because it takes long.
    template <class Cache, class Make>
    [[nodiscard]] auto kept(Cache& cache, const typename Cache::key_type& key, const Make& make) const {
        std::unique_lock lock(guard_);
        if (const auto entry = cache.find(key); entry != cache.end()) return entry->second;
        lock.unlock();
        auto value = make();
        lock.lock();
        return cache.emplace(key, std::move(value)).first->second;
    }

    std::vector<std::shared_ptr<const HeightMap<double>>> maps_;
    std::vector<Summits<double>> summits_;  ///< of each map
    mutable std::mutex guard_;
    mutable std::map<std::tuple<std::size_t, Edges, double, double>, BearingContact<double>> bearings_;
    mutable std::map<std::tuple<std::size_t, Edges, double, double>, HandOver<double>> hand_overs_;
    mutable std::map<std::tuple<std::size_t, Edges, double>, MapCut<double>> cuts_;
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

/// Inputs of laws from a measured map in addition to its numbers.
struct MapOfSurface {
    std::vector<std::shared_ptr<const HeightMap<double>>> maps;  ///< without form; of two faces one sum for each shift
    std::vector<Summits<double>> summits;                        ///< one for each map
    std::shared_ptr<const SpectraOfMaps> spectra;    ///< none where points are missing, or fewer than 4 a side
    std::shared_ptr<const BearingsOfMaps> bearings;  ///< of the maps
    double mean_square_height = 0;                   ///< of the maps, that of two faces the sum of both [m^2]
    std::size_t first_bearing = 0;                   ///< of the first of `summits`
    double taller = 1;                               ///< heights over those of the maps, where a surface was drawn

    [[nodiscard]] double rms_height() const { return taller * std::sqrt(mean_square_height); }
    /// Where there are spectra.
    [[nodiscard]] SpectrumShells<double> spectrum(Edges edges = Edges::mirrored) const {
        return detail::scaled(spectra->shells(edges), taller);
    }
};

struct ContactInputs;

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
    const BearingSlope<double>* bearing = nullptr;  ///< of heights over the rms height; none: Gaussian heights
    const QuickHybrid* similar = nullptr;           ///< of surfaces for a band: K alone counts, to 1e-3
    PlasticMaterial<double> material{};             ///< of the softer body
    ProgressHook progress{};                        ///< called once a state where that takes seconds
};

/// A measured curve and how it is fitted.
struct FitInputs {
    const std::vector<Observation<double>>& data;
    const std::vector<Parameter>& parameters;
    ContactParameters<double> start;
    IdentifyOptions<double> options;
};

/// One law.
struct Law {
    LawName which{};
    std::string_view name = name_of(which);
    std::string_view nature;       ///< what it computes: the rest of a sentence "hertz is ..."
    bool needs_dimension = false;  ///< the fractal dimension of the surface
    bool has_peaks = true;         ///< one curve for each joint distribution of peaks; else one curve
    /// The equations of the paper, or their replacements.
    std::string_view load, stiffness, peaks;
    /// \throws domain_error naming the parameter that is out of range.
    std::unique_ptr<AnyContact> (*contact)(const ContactInputs&) = nullptr;
    /// Null where the law has no exact derivatives. \throws as fstiff::identify.
    Identification<double> (*fit)(const FitInputs&) = nullptr;
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
[[nodiscard]] std::span<const Law> laws();
[[nodiscard]] std::vector<std::string_view> law_names();
/// Parameters that can be fitted.
[[nodiscard]] std::vector<std::string_view> fitted_law_names();
/// Fits the parameters of any curve, by differences. \throws as detail::identify_by_differences.
[[nodiscard]] Identification<double> fit_curve(const FitInputs& inputs, const CurveOfParameters<double>& curve);
[[nodiscard]] const Law& find_law(LawName name);
/// The law called \p name; null when there is none.
[[nodiscard]] const Law* find_law(std::string_view name);

}  // namespace fstiff::inline v0_1::detail

namespace fstiff::inline v0_1 {

template <>
inline constexpr auto names<detail::SpectrumSource> = detail::name_list<detail::SpectrumSource>(
    {{detail::SpectrumSource::map, "map"}, {detail::SpectrumSource::moments, "moments"}});

}  // namespace fstiff::inline v0_1
