// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The spectra of maps, their crowded contacts by their bearing curves, and their highest points. They cost a sort and
/// a transform of each map, so that they are made when a law first asks for them; all copies of a surface share them.

#include <fstiff/contact/bearing_contact.hpp>
#include <fstiff/contact/hand_over.hpp>
#include <fstiff/contact/plastic_contact.hpp>
#include <fstiff/measured/height_shape.hpp>
#include <fstiff/surface/roughness_spectrum.hpp>
#include <fstiff/topography/height_map.hpp>
#include <fstiff/topography/line_transform.hpp>
#include <fstiff/topography/summits.hpp>

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace fstiff::inline v0_1::detail {

/// The bearing curve of heights over their rms; none of a Gaussian shape. \throws domain_error as bearing_of_moments.
[[nodiscard]] std::shared_ptr<const parts::BearingSlope<double>> bearing_of_shape(
    const parts::HeightShape<double>& shape);

/// The spectra that a function makes, of each way to go on beyond the edges.
class SpectraOfMaps {
public:
    using Make = std::function<SpectrumShells<double>(Edges)>;
    explicit SpectraOfMaps(Make make) : make_(std::move(make)) {}

    [[nodiscard]] const SpectrumShells<double>& of(Edges edges) const {
        const std::lock_guard lock(guard_);
        auto& made = made_[static_cast<std::size_t>(edges)];
        if (!made) made = make_(edges);
        return *made;
    }

private:
    Make make_;
    mutable std::mutex guard_;
    mutable std::array<std::optional<SpectrumShells<double>>, 2> made_;
};

class BearingsOfMaps {
public:
    BearingsOfMaps(std::vector<std::shared_ptr<const HeightMap<double>>> maps, std::vector<Summits<double>> summits)
        : maps_(std::move(maps)), summits_(std::move(summits)) {}

    /// Bearing curve of the map number \p index. \throws domain_error for missing points, and as PerssonContact.
    [[nodiscard]] parts::BearingContact<double> contact(std::size_t index, Edges edges, double modulus,
                                                        double gamma) const;
    /// How hybrid goes from the summits of the map number \p index to that. \throws domain_error as contact() and
    /// SummitContact.
    [[nodiscard]] parts::HandOver<double> hand_over(std::size_t index, Edges edges, double modulus, double gamma) const;
    /// The highest points of the map number \p index. \throws domain_error as HighestPoints.
    [[nodiscard]] parts::MapCut<double> cut(std::size_t index, Edges edges, double modulus) const;

private:
    /// What \p all has of \p key, else what \p make makes: without the lock, as that takes long.
    template <class All, class Make>
    [[nodiscard]] auto kept(All& all, const typename All::key_type& key, const Make& make) const {
        std::unique_lock lock(guard_);
        if (const auto found = all.find(key); found != all.end()) return found->second;
        lock.unlock();
        auto made = make();
        lock.lock();
        return all.emplace(key, std::move(made)).first->second;
    }

    std::vector<std::shared_ptr<const HeightMap<double>>> maps_;
    std::vector<Summits<double>> summits_;  ///< of each map
    mutable std::mutex guard_;
    mutable std::map<std::tuple<std::size_t, Edges, double, double>, parts::BearingContact<double>> made_;
    mutable std::map<std::tuple<std::size_t, Edges, double, double>, parts::HandOver<double>> hand_overs_;
    mutable std::map<std::tuple<std::size_t, Edges, double>, parts::MapCut<double>> cuts_;
};

}  // namespace fstiff::inline v0_1::detail
