// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The power spectral density or the autocorrelation of a measured profile or map.

#include "document/document.hpp"
#include "surface/surface_file.hpp"
#include "surface/surface_option_table.hpp"

#include <fstiff/measure/roughness_cut_off.hpp>
#include <fstiff/surface/spectrum.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace fstiff::actions {

/// Quantity to compute.
enum class SpectrumKind { psd, acf };

}  // namespace fstiff::actions

template <>
inline constexpr auto fstiff::enum_names<fstiff::actions::SpectrumKind> = detail::name_list<actions::SpectrumKind>(
    {{actions::SpectrumKind::psd, "psd"}, {actions::SpectrumKind::acf, "acf"}});

namespace fstiff::actions {

/// How a file is read, and what is computed.
struct SpectrumRequest {
    surface::SurfaceOptions surface{};
    SpectrumKind of = SpectrumKind::psd;
    SpectrumWindow taper = SpectrumWindow::hann;  ///< of a psd

    template <class Take>
    void each_field(Take take) {
        take("of", of, {"psd (default), the power spectral density, or acf, the autocorrelation function"});
        take("taper", taper,
             {"window that the heights are multiplied by before a psd: hann (default), or none for a surface that "
              "repeats itself"});
    }
};

/// One curve: its positions, its values, and their names.
struct SpectrumCurve {
    std::string label, x_key, x_shown, key, shown;  ///< shown: as people read it
    double x_factor = 1, factor = 1;                ///< from SI to what they read
    std::vector<double> x, y;    ///< [rad/m] and [m^3] or [m^4]; [m] and dimensionless, NaN without a pair
    std::string count_key = {};  ///< of what a value is the mean of, where that is counted
    std::vector<std::size_t> counts = {};
};

struct Spectrum {
    std::vector<SpectrumCurve> curves;            ///< of a map: all directions, along x, along y
    std::string form, convention, source;         ///< how the numbers are normalised, and by whom
    double rms_as_read{}, rms{}, rms_gradient{};  ///< heights [m]
    CutOffs<double> cut_offs;
};

/// \throws domain_error in one sentence with the name of the file, and for the psd of a profile with missing points.
[[nodiscard]] Spectrum spectrum_of(const SpectrumRequest& request, const surface::SurfaceInput& input);
/// "Hann window, divided by its mean square".
[[nodiscard]] std::string window_of(const SpectrumRequest& request);
/// The document of fstiff measure --show spectrum.
[[nodiscard]] document::Document document_of(const SpectrumRequest& request, const surface::SurfaceInput& input,
                                             const Spectrum& spectrum);
/// The same for \p input, or for the file that \p request names. \throws as spectrum_of().
[[nodiscard]] document::Document document_of(const SpectrumRequest& request,
                                             std::optional<surface::SurfaceInput> input = {});

}  // namespace fstiff::actions
