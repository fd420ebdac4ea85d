// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The parameters of a scene's [surface], from a measured file or from what `fstiff measure` wrote of one.

#include "surface/surface_file.hpp"

#include <fstiff/core/parallel.hpp>
#include <fstiff/measure/measure.hpp>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace fstiff::surface {

/// How a file is read, and how its parameters are found.
struct MeasureOptions {
    SurfaceOptions input;
    int resamples = 400;
    std::uint64_t seed = 2014;
    bool neighbours = true;            ///< measures with a smaller and a greater lambda_s too
    bool neighbour_dimensions = true;  ///< finds D of these, of maps
    bool keep_maps = true;             ///< of the neighbours, with what a face takes of them
    ParallelHook parallel{};           ///< of the measurement

    template <class Take>
    void each_field(Take take) {
        take("resamples", resamples,
             {.help = "number of resamples that the standard errors are computed from; the default is 400",
              .low = 2,
              .high = 100000});
        take("seed", seed, {"seed of the random numbers of the resamples; the default is 2014"});
    }
};

/// A surface of a file: what it came from, what was found, and the sentences on both.
struct MeasuredSurface {
    std::string file, sha256, kind;  ///< of the measured file; kind: profile or map
    std::vector<std::string> decisions, warnings;
    std::vector<std::string> of_file;  ///< those of the warnings that no band holds: of the file, of too few summits
    /// Without profile and map where the numbers come from the JSON of fstiff measure, without heights where that is
    /// of an older fstiff. R_p of 0 is not known.
    Surface<double> found;
    std::shared_ptr<const MeasureOptions> how;  ///< it was measured; none: of the JSON, or of several files
    std::vector<MeasuredSurface> parts;         ///< of a surface measured from several files: each of them

    [[nodiscard]] bool is_profile() const { return kind == "profile"; }
};

/// \throws domain_error in one sentence with the name of the file, option_error for options that do not fit it.
[[nodiscard]] MeasuredSurface measure_surface(const MeasureOptions& options, std::string bytes,
                                              const ProgressHook& progress = {});
/// The same of what was read already.
[[nodiscard]] MeasuredSurface measure_surface(const MeasureOptions& options, const SurfaceInput& input,
                                              const ProgressHook& progress = {});

/// Measures one part of a surface, by its place.
using MeasurePart = std::function<MeasuredSurface(MeasureOptions, std::size_t)>;
/// \p count files or arrays of one surface, pooled (measure/pooled_surface.hpp). Messages call each a \p noun; unless
/// \p again they are measured once. One is that of measure_surface(); one that is there twice, by its SHA-256, counts
/// once, with a warning. \throws domain_error for parts of unlike kinds, or whose steps differ without one lambda_s.
[[nodiscard]] MeasuredSurface measure_parts(MeasureOptions options, std::size_t count, const MeasurePart& measure,
                                            const std::string& noun = "file", bool again = true);
/// The same of files, without_folders(), or of their columns or channels. Not empty: \p contents in place of what the
/// files hold. \throws as both.
[[nodiscard]] MeasuredSurface measure_files(const MeasureOptions& options, const std::vector<std::string>& names,
                                            const ProgressHook& progress = {},
                                            const std::vector<std::string>& contents = {});
/// \p names with the files of a folder in its place, in the order of their names, without those that begin with a dot.
/// \throws domain_error for a folder without files.
[[nodiscard]] std::vector<std::string> without_folders(const std::vector<std::string>& names);

/// Whether \p bytes look like the document of `fstiff measure`, not like a surface.
[[nodiscard]] bool is_measured_document(std::string_view bytes);
/// \throws domain_error when \p bytes, which messages call \p name, are no such document.
[[nodiscard]] MeasuredSurface read_measured_document(const std::string& bytes, const std::string& name);

/// The sentences on \p concerns of few_peaks to parameter_unknown; \p peaks gave R and D_p, which are in \p values with
/// their errors.
[[nodiscard]] std::vector<std::string> peak_warnings(const std::vector<MeasuredConcern>& concerns, std::size_t peaks,
                                                     const SurfaceParameters<double>& values);

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
/// Parameters that are known, in the order of docs/scene.md.
[[nodiscard]] std::vector<ParameterLine> parameter_lines(const MeasuredSurface& surface);
/// The same of \p parameters, which was measured as \p surface was: \p surface itself, or one of its neighbours.
[[nodiscard]] std::vector<ParameterLine> parameter_lines(const MeasuredSurface& surface,
                                                         const Surface<double>& parameters);

}  // namespace fstiff::surface
