// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// D and G of a measured profile or map with their errors, and the other results of fstiff measure --show fit.

#include "document/document.hpp"
#include "surface/surface_file.hpp"

#include <fstiff/core/parallel.hpp>
#include <fstiff/profile/fractal_fit.hpp>
#include <fstiff/profile/peak_statistics.hpp>
#include <fstiff/profile/power_spectrum.hpp>
#include <fstiff/profile/structure_function.hpp>
#include <fstiff/surface/structure_coefficient.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace fstiff::actions {

/// How a file is read, and how D and G are found.
struct FractalOptions {
    surface::SurfaceOptions surface;
    StructureConvention convention = StructureConvention::exact;
    std::uint64_t seed = FractalFitOptions<double>{}.seed;
    int resamples = FractalFitOptions<double>{}.resamples;
    ProgressHook progress{};  ///< called while the bootstrap draws

    template <class Take>
    void each_field(Take take) {
        take("convention", convention,
             {"constant C of eq. (2.4) that gives G: exact (default), paper or majumdar_tien"});
        take("seed", seed, {"seed of the random numbers of the bootstrap; the default is 2014"});
        take("resamples", resamples,
             {.help = "number of resamples of the bootstrap; the default is 200, and 0 leaves the bootstrap out",
              .low = 0,
              .high = 100000});
    }
};

/// Results of one profile. Parts that need more than the fit have a reason where they are missing.
struct ProfileFractal {
    PreparedProfile<double> levelled;
    FractalFit<double> fit;
    std::optional<detail::SpectralFit<double>> spectrum;
    std::optional<SpectralMoments<double>> moments;
    std::optional<PeakStatistics<double>> peaks;
    std::string no_spectrum, no_moments, no_peaks;
};

/// \throws domain_error for a window, a tip radius or a resolution that is not a length.
[[nodiscard]] FractalFitOptions<double> fit_options(const FractalOptions& options);

/// \throws domain_error in one sentence with the name of the file, option_error for options that do not fit it.
[[nodiscard]] ProfileFractal fractal_of_profile(const FractalOptions& options, const surface::SurfaceInput& input);

/// The structure function \p s; \p direction of a map, else empty.
[[nodiscard]] document::Rows lag_rows(const FractalFit<double>& fit, const StructureFunction<double>& s,
                                      const std::string& direction = "");

/// The document of fstiff measure --show fit for \p input, or for the file that \p options name. \throws as above.
[[nodiscard]] document::Document document_of(const FractalOptions& options,
                                             std::optional<surface::SurfaceInput> input = {});

}  // namespace fstiff::actions
