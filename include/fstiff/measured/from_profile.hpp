// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The density of the peaks of a measured profile, from its three-point statistics.
///
/// Reference   Buczkowski, Kleiber, Starzynski, Arch. Mech. 66 (2014), eqs. (4.1)-(4.4)
/// Units       dimensionless
/// Valid       as peak_statistics(): remove the form of the profile first, with detrend()
/// Accuracy    that of the statistics (tests/profile/peak_statistics_test.cpp)

#include <fstiff/peaks/peak_distribution.hpp>
#include <fstiff/profile/peak_statistics.hpp>

namespace fstiff {

/// (4.4) with the r and theta of \p profile.
/// \throws domain_error for a profile that is out of range, or whose r or theta is.
template <Real T>
[[nodiscard]] PeakDistribution<T> peak_distribution_of(const Profile<T>& profile) {
    const PeakStatistics<T> statistics = peak_statistics(profile);
    return {statistics.r, statistics.theta};
}

}  // namespace fstiff
