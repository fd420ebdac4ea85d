// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The density of peak heights and curvatures, of its own parameters or of a measured profile.

#include "document/document.hpp"
#include "surface/surface_file.hpp"
#include "surface/surface_option_table.hpp"

#include <fstiff/peaks/peak_distribution.hpp>
#include <fstiff/profile/peak_statistics.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fstiff::actions {

/// One of: r and theta, theta and exponential, rho1 and rho2, a profile. And the places of the density of the height
/// alone.
struct PeakDensityRequest {
    surface::SurfaceOptions surface{};     ///< of a profile, or without a file; its prefix is that of all options
    std::string_view profile = "profile";  ///< how messages call its file
    std::optional<double> r{};             ///< correlation of heights and curvatures, 0 <= r < 1
    request::Amount theta{};               ///< angle of the sampling
    bool exponential = false;              ///< r is that of an exponential autocorrelation
    std::optional<double> rho1{}, rho2{};  ///< autocorrelation at one sampling step, and at two
    std::string heights{};                 ///< "FROM,TO,COUNT" in rms heights, -30 to 30; empty: none

    template <class Take>
    void each_field(Take take) {
        take("r", r, {"correlation r of heights and curvatures, at least 0 and less than 1; needs --theta"});
        take("theta", theta, {"angle theta of the sampling: a number of radians, \"pi/4\" or \"45 deg\""});
        take("exponential", exponential, {"take the r that belongs to --theta for an exponential autocorrelation"});
        take("rho1", rho1, {"autocorrelation at one sampling step, with --rho2"});
        take("rho2", rho2, {"autocorrelation at two sampling steps"});
        take("heights", heights,
             {"FROM,TO,COUNT: print a table of the probability density of the height alone (Fig. 2)"});
    }
};

struct PeakDensity {
    PeakDistribution<double> density;
    std::string from;             ///< "r, theta", "profile" ...
    std::vector<double> heights;  ///< in rms heights
    std::optional<surface::SurfaceInput> input{};
    std::optional<PreparedProfile<double>> levelled{};
    std::optional<PeakStatistics<double>> statistics{};
};

/// Density of \p input, or of the file that \p request names. \throws option_error where it names none or two, and for
/// heights that are no range; domain_error as PeakDistribution and level_profile().
[[nodiscard]] PeakDensity peak_density_of(const PeakDensityRequest& request,
                                          std::optional<surface::SurfaceInput> input = {});
/// The document of fstiff measure --show peaks for \p input, or for what \p request names. \throws as above.
[[nodiscard]] document::Document document_of(const PeakDensityRequest& request,
                                             std::optional<surface::SurfaceInput> input = {});

}  // namespace fstiff::actions
