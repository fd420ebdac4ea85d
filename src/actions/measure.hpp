// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// A measured surface as a document, as the command prints it and a scene reads it back; and what the documents of all
// that is measured have in common.

#include "document/document.hpp"
#include "document/shown_unit.hpp"
#include "surface/measured_surface.hpp"
#include "surface/surface_file.hpp"

#include <fstiff/measure/roughness_cut_off.hpp>

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fstiff::actions {

/// One parameter by its symbol in the standard.
struct RoughnessLine {
    std::string symbol, unit;     ///< Ra and m; no unit: a plain number
    std::optional<double> value;  ///< none where it is not defined
    std::string meaning;          ///< what it is, or the reason why there is none
};

struct RoughnessTable {
    std::string standard;  ///< "ISO 21920-2:2021"
    std::vector<RoughnessLine> lines;
    std::string sections;      ///< how the sections of a profile were chosen; empty of a map
    double section_length{};   ///< [m]; 0 of a map
    CutOffs<double> cut_offs;  ///< that these parameters have: lambda_c of a profile is that of the standard
    std::size_t files = 1;     ///< whose means these are
    double removed{};          ///< share of the mean square height of a profile that lambda_c removes
};

/// Parameters of the existing heights, about their mean. \throws domain_error for a surface out of range.
/// A profile without lambda_c takes \p lambda_c, by default the table's; parts of a map go to \p parallel.
[[nodiscard]] RoughnessTable roughness_table(const PreparedProfile<double>& levelled,
                                             const CutOff<double>& lambda_c = {});
[[nodiscard]] RoughnessTable roughness_table(const PreparedMap<double>& levelled, const ParallelHook& parallel = {});

/// The means of \p tables, of one kind of surface; none where one of them has none.
[[nodiscard]] RoughnessTable mean_of(const std::vector<RoughnessTable>& tables);

/// Adds the file, its SHA-256, the decisions about it, and the options as they were given; \p form is the one that was
/// removed.
void add_source(document::Document& document, const surface::SurfaceOptions& options,
                const surface::SurfaceInput& input, const std::string& form);
/// Adds lambda_s_m, lambda_c_m and the filter of lambda_c: null where there is none.
void put_cut_offs(document::Json& document, const CutOffs<double>& cut_offs);
/// Adds the grid of \p levelled, how many points were missing in \p input, and the cut-offs.
void add_grid(document::Document& document, const surface::SurfaceInput& input, const PreparedMap<double>& levelled);
/// Adds the rms height called \p symbol before and after the removal of \p form, and a line of the cut-offs.
template <class Levelled>
void add_heights(document::Document& document, std::string_view symbol, const Levelled& levelled,
                 const std::string& form) {
    document.json["rms_height_m"] = levelled.rms;
    document.json["rms_height_before_detrend_m"] = levelled.rms_as_read;
    document.line(symbol, document::shown_length(levelled.rms_as_read) + " as read, " +
                              document::shown_length(levelled.rms) + " after removal of the form (" + form + ")");
    document.line("cut-offs", surface::sentence_of(levelled.cut_offs));
}

/// Adds the doubts about the reading, and whether the rms gradient is one that no surface has.
void add_reading(document::Document& document, const surface::SurfaceInput& input, std::string_view consequence,
                 double rms_gradient);

/// Measured parameters of a surface, for a JSON document that read_measured_document takes.
[[nodiscard]] document::Json measured_document(const surface::MeasuredSurface& surface);

/// The roughness parameters of \p surface; of several files the means of theirs with one lambda_c, the longest that the
/// table chooses. \throws as roughness_table().
[[nodiscard]] RoughnessTable roughness_of(const surface::MeasuredSurface& surface, const CutOff<double>& lambda_c = {},
                                          const ParallelHook& parallel = {});
/// The document of \p surface, which was measured by \p options. Roughness parameters that refuse it are no part of
/// the CSV.
[[nodiscard]] document::Document document_of(const surface::MeasureOptions& options,
                                             const std::shared_ptr<const surface::MeasuredSurface>& surface);

}  // namespace fstiff::actions
