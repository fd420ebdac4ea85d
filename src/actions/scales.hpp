// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Sensitivity of a measured surface, and of its K, to the cut-offs.

#include "document/document.hpp"
#include "surface/measured_surface.hpp"

#include <fstiff/core/parallel.hpp>
#include <fstiff/measure/roughness_cut_off.hpp>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace fstiff::actions {

/// At what K is computed.
struct ScalesOptions {
    double pressure = 10e6;   ///< [Pa]
    double modulus = 0;       ///< effective [Pa]
    ProgressHook progress{};  ///< called for every pair of cut-offs
};

/// The surface filtered with one pair of cut-offs.
struct Scale {
    CutOffs<double> cut_offs;
    bool chosen = false;                                ///< the cut-offs that the measurement has
    std::optional<surface::MeasuredSurface> surface{};  ///< none: `refusal` has the reason
    std::optional<double> stiffness{};                  ///< K [Pa/m] by Scales::law
    std::string refusal{};

    [[nodiscard]] std::optional<double> value(Parameter parameter) const;
    [[nodiscard]] std::optional<double> gradient() const;
};

struct Scales {
    std::string law;    ///< that K is of: hybrid where the surface has a spectrum, else hertz or greenwood_williamson
    double length = 0;  ///< of the surface, the shorter side of a map [m]
    std::vector<Scale> short_waves;  ///< lambda_s from none by factors of two to a twentieth of the length
    std::vector<Scale> long_waves;   ///< lambda_c from none by factors of two down to ten times lambda_s
};

/// \p chosen, which was measured of \p input, and the same input with each of the other cut-offs, without errors.
/// Refusals are in their rows.
[[nodiscard]] Scales scales_of(const surface::MeasuredSurface& chosen, const surface::SurfaceInput& input,
                               const ScalesOptions& load);

/// The document of fstiff measure --scales: that of \p surface, measured by \p options, with a row for each pair of
/// cut-offs, those of lambda_s first, and what of K is settled.
[[nodiscard]] document::Document document_of(const surface::MeasureOptions& options,
                                             const std::shared_ptr<const surface::MeasuredSurface>& surface,
                                             const Scales& scales, const ScalesOptions& load);

/// "halving or doubling lambda_s changes K by -3 % to +4 %: settled"; one sentence for either cut-off.
[[nodiscard]] std::vector<std::string> convergence_sentences(const Scales& scales);

}  // namespace fstiff::actions
