// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The options of a surface as the library takes them, and its cut-offs in words.

#include <fstiff/measured/cut_offs.hpp>

#include <string>

namespace fstiff::scene {

struct SurfaceOptions;

/// What is known of the instrument [m]; 0: not known.
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

}  // namespace fstiff::scene
