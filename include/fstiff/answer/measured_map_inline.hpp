// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// A measured map as the laws take it: its summits, its bearing curve, its cuts, and boundary elements of it. The class
/// of MapOfSurface: inline, or compiled once (docs/linking-cpp.md).

#include <fstiff/answer/answer_curve.hpp>
#include <fstiff/answer/erased_contact.hpp>
#include <fstiff/answer/measured_map.hpp>
#include <fstiff/answer/request.hpp>
#include <fstiff/answer/solved_map_inline.hpp>
#include <fstiff/contact/boundary_element_contact.hpp>
#include <fstiff/contact/crossover.hpp>
#include <fstiff/contact/hybrid_contact.hpp>
#include <fstiff/contact/material_ratio_contact.hpp>
#include <fstiff/contact/mutual_summits.hpp>
#include <fstiff/contact/plastic_contact.hpp>
#include <fstiff/contact/summit_contact.hpp>
#include <fstiff/surface/band_spectrum.hpp>
#include <fstiff/surface/sum_of_faces.hpp>
#include <fstiff/topography/gaussian_map_filter.hpp>
#include <fstiff/topography/gaussian_order.hpp>
#include <fstiff/topography/map_spectrum.hpp>
#include <fstiff/topography/sum_of_maps.hpp>
#include <fstiff/topography/white_noise.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// The dense contacts of maps by their bearing curves, and their highest points. They cost a sort and a transform of
/// each map, so that they are made when a law first asks for them; all copies of a surface share them.
class BearingsOfMaps {
public:
    BearingsOfMaps(std::vector<std::shared_ptr<const HeightMap<double>>> maps, std::vector<Summits<double>> summits)
        : maps_(std::move(maps)), summits_(std::move(summits)) {}

    /// Bearing curve of the map number \p index. \throws domain_error for missing points, and as PerssonContact.
    [[nodiscard]] MaterialRatioContact<double> contact(std::size_t index, Edges edges, double modulus,
                                                       double gamma) const;
    /// How hybrid goes from the summits of the map number \p index to that. \throws domain_error as contact() and
    /// SummitContact.
    [[nodiscard]] Crossover<double> hand_over(std::size_t index, Edges edges, double modulus, double gamma) const;
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
        if (cache.size() >= 4 * maps_.size()) cache.clear();  // a face may serve joints of many moduli
        return cache.emplace(key, std::move(value)).first->second;
    }

    std::vector<std::shared_ptr<const HeightMap<double>>> maps_;
    std::vector<Summits<double>> summits_;  ///< of each map
    mutable std::mutex guard_;
    mutable std::map<std::tuple<std::size_t, Edges, double, double>, MaterialRatioContact<double>> bearings_;
    mutable std::map<std::tuple<std::size_t, Edges, double, double>, Crossover<double>> hand_overs_;
    mutable std::map<std::tuple<std::size_t, Edges, double>, MapCut<double>> cuts_;
};

inline MaterialRatioContact<double> BearingsOfMaps::contact(std::size_t index, Edges edges, double modulus,
                                                            double gamma) const {
    return kept(bearings_, {index, edges, modulus, gamma}, [&] {
        GaussianOrder<double> order = detail::gaussian_order(*maps_[index]);
        const PerssonContact<double> gaussian(map_spectrum(order.map, edges), modulus, gamma);
        return MaterialRatioContact<double>(gaussian, std::move(order.curve), order.rms_height);
    });
}

inline Crossover<double> BearingsOfMaps::hand_over(std::size_t index, Edges edges, double modulus, double gamma) const {
    return kept(hand_overs_, {index, edges, modulus, gamma},
                [&] { return detail::hand_over_of(summits_[index], contact(index, edges, modulus, gamma), edges); });
}

inline MapCut<double> BearingsOfMaps::cut(std::size_t index, Edges edges, double modulus) const {
    return kept(cuts_, {index, edges, modulus}, [&] { return MapCut<double>(*maps_[index], modulus, edges); });
}

/// The shells of both, in ascending order of |q|.
FSTIFF_INLINE SpectrumShells<double> sum_of_spectra(const SpectrumShells<double>& a, const SpectrumShells<double>& b) {
    SpectrumShells<double> sum{a.shells, std::hypot(a.rms_height, b.rms_height)};
    sum.shells.insert(sum.shells.end(), b.shells.begin(), b.shells.end());
    std::stable_sort(sum.shells.begin(), sum.shells.end(), [](const auto& left, const auto& right) {
        return left.q2_h2 * right.q_h2 < right.q2_h2 * left.q_h2;
    });
    return sum;
}

/// MapOfSurface of measured maps, or of the sums of two.
class MeasuredMap final : public MapOfSurface {
    /// The hybrid law of one shift; before contact(), which takes its type.
    [[nodiscard]] auto hybrid(const ContactInputs& inputs, std::size_t shift) const {
        const auto& [gamma, edges, modulus] =
            std::tie(inputs.options.gamma, inputs.options.edges, inputs.effective_modulus);
        SummitContact<double> peaks(summits[shift], modulus);
        MaterialRatioContact<double> crowded = bearings->contact(first_bearing + shift, edges, modulus, gamma)
                                                   .scaled(height_factor)
                                                   .over_rms_height(rms_height());
        Crossover<double> hand_over =
            bearings->hand_over(first_bearing + shift, edges, modulus, gamma).scaled(peaks, height_factor);
        return HybridContact(std::move(peaks), std::move(crowded), std::move(hand_over));
    }

public:
    [[nodiscard]] std::unique_ptr<AnyContact> contact(LawKind law, const ContactInputs& inputs) const override {
        switch (law) {
            case LawKind::hybrid: return over_shifts([&](std::size_t shift) { return hybrid(inputs, shift); });
            case LawKind::plastic:
                return over_shifts([&](std::size_t shift) {
                    const auto cut =
                        bearings->cut(first_bearing + shift, inputs.options.edges, inputs.effective_modulus);
                    return PlasticContact(hybrid(inputs, shift), cut.scaled(height_factor),
                                          inputs.material.hardness_or_default());
                });
            case LawKind::summits:
                if (!inputs.options.mutual)
                    return over_shifts([&](std::size_t shift) {
                        return SummitContact<double>(summits[shift], inputs.effective_modulus);
                    });
                return over_shifts([&](std::size_t shift) {
                    return MutualSummits<double>(summits[shift], inputs.effective_modulus, inputs.options.edges);
                });
            case LawKind::boundary_elements: return boundary_elements(inputs);
            default: throw domain_error("law " + std::string(name_of(law)) + ": takes no map");
        }
    }
    [[nodiscard]] std::shared_ptr<const MapOfSurface> resampled(std::size_t shift, std::size_t a_side,
                                                                const std::vector<std::size_t>& tiles,
                                                                double growth) const override {
        auto other = std::make_shared<MeasuredMap>();
        other->summits = {detail::resampled(summits[shift], a_side, tiles)};
        other->spectra = spectra, other->bearings = bearings;
        other->mean_square_height = mean_square_height;
        other->first_bearing = first_bearing + shift;
        other->height_factor = height_factor * growth;
        return other;
    }
    [[nodiscard]] std::shared_ptr<const MapOfSurface> scaled(double factor) const override {
        auto other = std::make_shared<MeasuredMap>(*this);
        other->height_factor *= factor;
        for (Summits<double>& trace : other->summits) {
            trace.rms_height *= factor;
            for (Summit<double>& summit : trace.summits) {
                summit.height *= factor, summit.max_curvature *= factor, summit.min_curvature *= factor;
                summit.load_factor /= std::sqrt(factor), summit.area_factor /= factor;  // R^(1/2) and R
            }
        }
        return other;
    }
    [[nodiscard]] std::string no_sum(const MapOfSurface& other) const override {
        for (const auto& map : maps)
            for (const auto& below : other.maps)
                if (std::string why = detail::no_sum_of(*map, *below); !why.empty()) return why;
        return "";
    }
    [[nodiscard]] std::shared_ptr<const MapOfSurface> sum(const MapOfSurface& other, int shifts,
                                                          std::uint64_t seed) const override {
        auto sums = std::make_shared<MeasuredMap>();
        for (std::size_t k = 0; k < static_cast<std::size_t>(shifts); ++k) {  // of several maps each in turn
            HeightMap<double> map =
                detail::random_sum(*maps[k % maps.size()], *other.maps[k / maps.size() % other.maps.size()], seed);
            sums->summits.push_back(summits_of(map));
            sums->maps.push_back(std::make_shared<const HeightMap<double>>(std::move(map)));
        }
        if (spectra && other.spectra)
            sums->spectra = std::make_shared<const SpectraOfMaps>([a = spectra, b = other.spectra](Edges edges) {
                return sum_of_spectra(a->shells(edges), b->shells(edges));
            });
        sums->mean_square_height = mean_square_height + other.mean_square_height;
        sums->bearings = std::make_shared<const BearingsOfMaps>(sums->maps, sums->summits);
        return sums;
    }
    [[nodiscard]] std::vector<std::function<void()>> pieces(const ResolvedJoint& problem,
                                                            const Request& request) const override {
        const LawOptions& options = problem.law_options;
        const double modulus = problem.effective_modulus, hardness = hardness_of(problem);
        const auto asks_for = [&](LawKind name) {
            return std::any_of(request.laws.begin(), request.laws.end(),
                               [name](const Law* law) { return law->which == name; });
        };
        const bool flows = asks_for(LawKind::plastic);
        std::vector<std::function<void()>> parts;
        for (std::size_t i = first_bearing; i < first_bearing + summits.size(); ++i) {
            if (flows || asks_for(LawKind::hybrid))
                parts.push_back([=, this] { (void)bearings->hand_over(i, options.edges, modulus, options.gamma); });
            if (flows)
                parts.push_back([=, this, &request] {
                    const MapCut<double> cut = bearings->cut(i, options.edges, modulus);
                    for (const double p : request.points)
                        if (!request.at_separations && p < hardness) (void)cut.stiffness(p / hardness);
                });
        }
        return parts;
    }
    [[nodiscard]] double noise(Edges edges) const override {
        return detail::white_noise(spectra->shells(edges), maps.front()->dx, maps.front()->dy);
    }
    [[nodiscard]] std::vector<Solved> solve(const ResolvedJoint& problem, const Request& request, bool flows,
                                            LawCurve& curve, const ProgressHook& progress) const override {
        return boundary_elements_of(problem, request, flows, curve, progress);
    }

    std::shared_ptr<const BearingsOfMaps> bearings;  ///< of the maps
    std::size_t first_bearing = 0;                   ///< of the first of `summits`

private:
    /// The mean of what \p make makes of every shift.
    template <class Make>
    std::unique_ptr<AnyContact> over_shifts(const Make& make) const {
        std::vector<decltype(make(0))> contacts;
        for (std::size_t shift = 0; shift < summits.size(); ++shift) contacts.push_back(make(shift));
        return mean_over(std::move(contacts));
    }
    [[nodiscard]] std::unique_ptr<AnyContact> boundary_elements(const ContactInputs& inputs) const {
        const LawOptions& options = inputs.options;
        const HalfSpaceOptions<double> settings{.points = options.points,
                                                .edges = options.edges,
                                                .hardness = options.hardness,
                                                .progress = inputs.progress};
        std::vector<BoundaryElementContact<double>> of_shifts;
        for (const auto& map : maps) of_shifts.emplace_back(*map, inputs.effective_modulus, settings);
        return mean_over(std::move(of_shifts));
    }
};

/// The summits of \p map; where none is above its eight neighbours, because the highest points are equal, one of these.
FSTIFF_INLINE Summits<double> summits_or_highest(const HeightMap<double>& map) {
    Summits<double> result = summits_of(map);
    if (!result.summits.empty() || map.rows() < 5 || map.columns() < 5) return result;
    Eigen::Index j = 0, i = 0;
    const auto inner = map.heights.block(1, 1, map.rows() - 2, map.columns() - 2);
    inner.isNaN().select(-std::numeric_limits<double>::infinity(), inner).maxCoeff(&j, &i);
    ++j, ++i;
    if (map.heights.block(j - 1, i - 1, 3, 3).isNaN().any()) return result;
    auto top = detail::top_of(detail::shape_by_differences<double>(map.heights, j, i), map.dx, map.dy, 1.0);
    if (!(top.min_curvature > detail::min_curvature_ratio<double> * top.max_curvature)) return result;
    const MapHeights<double> heights(map);
    top.height += (heights.in_units(map.heights(j, i)) - heights.mean) * heights.unit;
    top.x += static_cast<double>(i) * map.dx, top.y += static_cast<double>(j) * map.dy;
    result.summits.push_back(top);
    return result;
}

FSTIFF_INLINE std::shared_ptr<const MapOfSurface> map_of_surface(
    std::vector<std::shared_ptr<const HeightMap<double>>> maps) {
    const auto made = std::make_shared<MeasuredMap>();
    MeasuredMap& result = *made;
    result.maps = std::move(maps);
    double area = 0;
    bool complete = true;
    for (const auto& map : result.maps) {
        result.summits.push_back(detail::with_hertz_factors(summits_or_highest(*map)));
        const double rms = result.summits.back().rms_height;
        result.mean_square_height += map->area() * rms * rms;
        area += map->area();
        complete = complete && map->present() == map->size() && map->rows() >= 4 && map->columns() >= 4;
    }
    result.mean_square_height /= area;
    if (complete)
        result.spectra = std::make_shared<const SpectraOfMaps>([maps = result.maps, area](Edges edges) {
            SpectrumShells<double> sum;
            for (const auto& map : maps)
                sum = sum_of_spectra(sum, detail::scaled(map_spectrum(*map, edges), std::sqrt(map->area() / area)));
            return sum;
        });
    result.bearings = std::make_shared<const BearingsOfMaps>(result.maps, result.summits);
    return made;
}

}}}  // namespace fstiff::detail
