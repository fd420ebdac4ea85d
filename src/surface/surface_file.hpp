// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// A measured surface: the reading of its file, and the removal of the form.

#include "document/file.hpp"
#include "surface/surface_options.hpp"

#include <fstiff/core/error.hpp>
#include <fstiff/measure/prepare.hpp>
#include <fstiff/measure/roughness_cut_off.hpp>
#include <fstiff/profile/levelled_profile.hpp>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fstiff::surface {

struct SurfaceInput {
    io::Surface surface;
    std::string sha256;

    struct Counts {
        std::size_t points, missing;
    };
    std::optional<Counts> dropped{};  ///< of the map whose heights were given up

    [[nodiscard]] std::size_t points() const;  ///< missing ones included
    [[nodiscard]] std::size_t missing() const;
    /// Gives up the map, whose memory is needed, and keeps its counts.
    [[nodiscard]] HeightMap<double> take_map();
};

/// \throws domain_error in one sentence with the name of the file.
[[nodiscard]] SurfaceInput read_surface_input(const SurfaceOptions& options);
/// The same from bytes that were read already.
[[nodiscard]] SurfaceInput read_surface_input(const SurfaceOptions& options, std::string bytes);

/// \p given, or the surface in the file of \p options, which is read.
[[nodiscard]] SurfaceInput input_of(const SurfaceOptions& options, std::optional<SurfaceInput> given);

/// Heights that no file holds, cleaned by \p options; options.file is their name in messages, and \p origin is their
/// source. \throws domain_error for heights or steps that are no surface.
[[nodiscard]] SurfaceInput surface_of_heights(const SurfaceOptions& options, io::ProfileOrMap heights,
                                              const std::string& origin);

/// Crops, masks, takes spikes out and fills, in this order, by the options; each is noted in the details of the
/// record.
/// \throws domain_error, file_error for the mask.
void clean(const SurfaceOptions& options, io::Surface& surface);

/// Hints at options of clean() that were not used: for spikes and for \p missing points, with the option's name.
[[nodiscard]] std::vector<std::string> cleaning_hints(const SurfaceOptions& options, const io::Surface& surface);

/// Properties of the instrument [m]; 0: not known.
struct Instrument {
    double tip_radius = 0, resolution = 0;
};
/// \throws domain_error, which quotes the text of an option.
[[nodiscard]] Instrument instrument_of(const SurfaceOptions& options);

/// The options of the library for \p options: cut-offs, instrument and filter, without form and cleaning.
/// \throws domain_error, which quotes the text of an option.
[[nodiscard]] fstiff::MeasureOptions<double> library_options(const SurfaceOptions& options);

/// \throws domain_error with the name of the option for a cut-off that was given and that a surface of \p step (the
/// coarser one) and \p length (the shorter one) cannot hold.
void require_cut_offs(const SurfaceOptions& options, const fstiff::MeasureOptions<double>& given, double step,
                      double length);

/// The cut-offs and their reasons.
[[nodiscard]] std::string sentence_of(const CutOffs<double>& cut_offs);

/// The options of the library for a surface, of a profile or of a map.
/// \throws option_error for the form of the other kind or a cut-off without its filter, domain_error when the surface
/// is of the other kind, and for cut-offs that the file cannot hold.
[[nodiscard]] fstiff::MeasureOptions<double> options_for_profile(const SurfaceOptions& options,
                                                                 const SurfaceInput& input);
[[nodiscard]] fstiff::MeasureOptions<double> options_for_map(const SurfaceOptions& options, const SurfaceInput& input);

/// The name of the form that was removed: one of Form, or gaussian_form; one of MapForm.
[[nodiscard]] std::string form_name(const LevelledProfile<double>& levelled);
[[nodiscard]] std::string form_name(const LevelledMap<double>& levelled);
/// What follows it where a circle, sphere or cylinder of \p radius was removed: " of radius 5 mm"; empty for 0.
[[nodiscard]] std::string radius_clause(double radius);

/// prepare() for a profile. \throws as options_for_profile() and, with the name of the file, prepare().
[[nodiscard]] PreparedProfile<double> level_profile(const SurfaceOptions& options, const SurfaceInput& input);
/// prepare() for a map. \throws as above.
[[nodiscard]] PreparedMap<double> level_map(const SurfaceOptions& options, const SurfaceInput& input);
/// The same for an \p input that is not needed afterwards and gives up its map.
[[nodiscard]] PreparedMap<double> level_map_of(const SurfaceOptions& options, SurfaceInput& input);

/// A warning about an rms gradient that no surface has, with its \p origin; empty for any other.
[[nodiscard]] std::string gradient_warning(double rms_gradient, std::string_view origin);
/// Doubts about the reading: a sentence on missing points, where there are some, and the warnings of the
/// reader; and gradient_warning() of the \p rms_gradient that was measured, where it is known yet.
[[nodiscard]] std::vector<std::string> reading_warnings(const SurfaceInput& input, std::string_view consequence,
                                                        std::optional<double> rms_gradient = {});

}  // namespace fstiff::surface
