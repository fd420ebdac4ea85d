// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The points at which contacts are asked for, and their states there.

#include <cstddef>
#include <cstdint>
#include <fstiff/answer/resolved_joint.hpp>
#include <fstiff/core/parallel.hpp>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// What a contact is asked for.
struct Request {
    std::vector<double> points{};  ///< pressures [Pa], or separations [m]
    bool at_separations = false;
    std::vector<const Law*> laws{};       ///< none: that of the answer
    Quantity quantities = Quantity::all;  ///< of the laws that are named
    std::vector<std::size_t> answered{};  ///< places among `points` at which the answer is solved
    bool approach = false;                ///< the separation at `seating` too
    bool log_slopes = false;              ///< d log K/d log p too
    bool separation = true;               ///< of the answer, which costs more than its K
    double seating = 1e3;                 ///< the approach is 0 at this pressure [Pa]
    int samples = 400;                    ///< of a band; 0: none
    std::uint64_t seed = 2014;
    bool solves_map = true;   ///< the answer takes boundary elements of a map
    bool answers = true;      ///< the answer too, next to laws that are named
    bool checked = true;      ///< checks and means over the load too
    ParallelHook parallel{};  ///< of solutions by boundary elements, contacts of a map and surfaces for a band
};

/// A contact to be made of \p law and a distribution of peaks.
struct ContactOfLaw {
    const Law* law = nullptr;
    std::optional<double> theta{}, r{};  ///< none: a law without a joint distribution
    std::function<std::unique_ptr<AnyContact>()> make;
};
/// Calls \p visit with every law of \p laws and distribution of peaks; `make` lives as long as that call.
void for_each_contact(const ResolvedJoint& problem, const std::vector<const Law*>& laws, const ProgressHook& progress,
                      const std::function<void(const ContactOfLaw&)>& visit);
/// Points above which states and bands are interpolated: states within 1e-7, from a table over ln p where it has them,
/// ends of bands within 1e-3, except next to a hardness.
inline constexpr std::size_t many_points = 1000;
/// The states at the points of \p request; every point is independent, so that they may be computed in parts, one by
/// one where \p law takes seconds for each, with \p progress called between them.
[[nodiscard]] std::vector<ContactPoint<double>> points_of(const Request& request, const Law& law,
                                                          const AnyContact& contact, Quantity quantities,
                                                          const ProgressHook& progress = {});

}}}  // namespace fstiff::detail
