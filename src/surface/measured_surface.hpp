// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The parameters of a scene's [surface], from a measured file or from what `fstiff measure` wrote of one.

#include "surface/surface_file.hpp"

#include <fstiff/core/progress.hpp>
#include <fstiff/measured/measure.hpp>
#include <fstiff/measured/uncertain_surface.hpp>

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace fstiff::scene {

/// How a file is read, and how its parameters are found.
struct MeasureOptions {
    SurfaceOptions input;
    int resamples = 400;
    std::uint64_t seed = 2014;
    bool neighbours = true;  ///< measures behind a smaller and a greater lambda_s too
    bool neighbour_dimensions = true;  ///< finds D of these, of maps
    bool keep_maps = true;   ///< of the neighbours, with what a face takes of them
};

struct MeasuredSurface {
    std::string file, sha256, kind;  ///< of the measured file; kind: profile or map
    std::vector<std::string> decisions, warnings;
    CutOffs<double> cut_offs;               ///< of what was measured
    std::vector<MeasuredConcern> concerns;  ///< behind the warnings
    std::size_t peaks = 0;                  ///< behind R and D_p
    UncertainSurface<double> parameters;
    Measurement<double> max_peak_height;  ///< [m]; 0: not known
    std::optional<Measurement<double>> fractal_roughness;
    double dimension_window_error = 0;                ///< share of the window of lags in the error of D
    /// Greatest wave number over the least that it can hold: from its length, or lambda_c, to two steps, or lambda_s.
    double widest_band = std::numeric_limits<double>::infinity();
    double shape_share = 0;  ///< how much of skewness and of kurtosis - 3 counts in hybrid (measured/height_shape.hpp)
    std::optional<HeightStatistics<double>> heights;  ///< none: the JSON is of an older fstiff
    std::string fractal_refusal, peaks_refusal;       ///< why there is no D, no r and theta
    /// What was measured, without its form; neither when the numbers come from the JSON of fstiff measure.
    std::shared_ptr<const PreparedProfile<double>> profile;
    std::shared_ptr<const PreparedMap<double>> map;
    std::optional<FractalFit<double>> profile_fit;  ///< that gave D, and that of a map
    std::optional<DirectionalFit<double>> map_fit;
    std::optional<IslandCurve<double>> islands;  ///< that gave R and D_p of a map
    std::shared_ptr<const MeasureOptions> how;   ///< it was measured; none: of the JSON, or of several files
    std::vector<MeasuredSurface> parts;          ///< of a surface measured from several files: each of them

    /// The same behind lambda_s/sqrt(2) and sqrt(2) lambda_s, without errors; behind twice it alone where the file holds no smaller
    /// one. Without lambda_s: behind four steps, which is twice the shortest wave of the file.
    std::vector<MeasuredSurface> neighbours;

    double measured_size = 0;  ///< length of the profile [m], or area of the map [m^2]; 0 where neither was there
    /// The same of all parts.
    [[nodiscard]] double size() const;
};

/// \throws domain_error in one sentence with the name of the file, option_error for options that do not fit it.
[[nodiscard]] MeasuredSurface measure_surface(const MeasureOptions& options, std::string bytes,
                                              const ProgressHook& progress = {});
/// The same of what was read already.
[[nodiscard]] MeasuredSurface measure_surface(const MeasureOptions& options, const SurfaceInput& input,
                                              const ProgressHook& progress = {});

/// The same of several files of one surface, pooled (measured/pooled_surface.hpp); a folder stands for its files in the order of
/// their names, without those that begin with a dot. One file is measure_surface(). A file that is there twice, by its SHA-256,
/// counts once, with a warning.
/// \throws domain_error for a folder without files, files of unlike kinds, or files whose steps differ without one lambda_s.
[[nodiscard]] MeasuredSurface measure_files(MeasureOptions options, const std::vector<std::string>& names,
                                            const ProgressHook& progress = {});

/// Whether \p bytes look like the document of `fstiff measure`, not like a surface.
[[nodiscard]] bool is_measured_document(std::string_view bytes);
/// \throws domain_error when \p bytes, which messages call \p name, are no such document.
[[nodiscard]] MeasuredSurface read_measured_document(const std::string& bytes, const std::string& name);

/// The sentences on \p concerns of few_peaks to parameter_unknown; \p peaks gave R and D_p, which are in \p values with
/// their errors.
[[nodiscard]] std::vector<std::string> peak_warnings(const std::vector<MeasuredConcern>& concerns, std::size_t peaks,
                                                     const UncertainSurface<double>& values);

/// The parameters of \p used, those of \p surface or what replaced them, on which no result can rest: not known to a
/// factor of two, or the R and D_p of islands that are densest at no level.
[[nodiscard]] std::vector<Parameter> unknown_parameters(const MeasuredSurface& surface,
                                                        const UncertainSurface<double>& used);

/// Whether \p surface is a profile that repeats itself, which cannot know K of its face.
[[nodiscard]] bool is_profile_with_lay(const MeasuredSurface& surface);

/// Whether no result can rest on \p surface: it has unknown_parameters(), an rms gradient that no surface has, or is a
/// profile of a face with a lay.
[[nodiscard]] bool is_doubtful(const MeasuredSurface& surface);

/// How one parameter of a scene's [surface] is called, its unit and how it was found.
struct ParameterLine {
    std::string name, unit;  ///< unit in a scene; empty: a plain number
    Measurement<double> measured;
    std::string how;
    bool known = true;  ///< to a factor of two; else two digits are enough
};
/// Those that are known, in the order of docs/scene.md.
[[nodiscard]] std::vector<ParameterLine> parameter_lines(const MeasuredSurface& surface);

}  // namespace fstiff::scene
