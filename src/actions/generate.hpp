// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Surfaces of known D or H: Weierstrass-Mandelbrot profiles, self-affine Gaussian profiles and maps.

#include "document/document.hpp"
#include "surface/surface_option_table.hpp"
#include "surface/surface_options.hpp"

#include <fstiff/io/surface_file.hpp>
#include <fstiff/synthetic/self_affine.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fstiff::actions {

/// wm: Weierstrass-Mandelbrot profile; the others are self-affine and Gaussian.
enum class GeneratedKind { wm, profile, map };
/// The form of the file; sdf is binary.
enum class GeneratedForm { csv, sdf, sdf_text };

}  // namespace fstiff::actions

template <>
inline constexpr auto fstiff::enum_names<fstiff::actions::GeneratedKind> =
    detail::name_list<actions::GeneratedKind>({{actions::GeneratedKind::wm, "wm"},
                                               {actions::GeneratedKind::profile, "profile"},
                                               {actions::GeneratedKind::map, "map"}});
template <>
inline constexpr auto fstiff::enum_names<fstiff::actions::GeneratedForm> =
    detail::name_list<actions::GeneratedForm>({{actions::GeneratedForm::csv, "csv"},
                                               {actions::GeneratedForm::sdf, "sdf"},
                                               {actions::GeneratedForm::sdf_text, "sdf-text"}});

namespace fstiff::actions {

/// Request for a surface. wm uses dimension, roughness and gamma; the others use hurst, rms and long_waves, and a map
/// also rows.
struct GenerateRequest {
    /// Limit of one surface: 2^22 heights are some 90 MB of text.
    static constexpr int min_side = 16, max_points = 1 << 22;

    GeneratedKind kind = GeneratedKind::profile;
    std::size_t points = 0,
                rows = 0;  ///< of a row, and how many rows; 0: 4096, of a map 256, and as many rows as points
    request::Amount spacing{};
    std::optional<double> dimension{};             ///< D
    request::Amount roughness{};                   ///< G
    double gamma = 1.5;                            ///< ratio of neighbouring wavelengths
    std::optional<double> hurst{};                 ///< H
    request::Amount rms{}, longest{}, shortest{};  ///< wavelengths: the longest side and two spacings by default
    LongWaves long_waves = LongWaves::plateau;
    std::uint64_t seed = 1;
    GeneratedForm format = GeneratedForm::csv;
    std::string_view prefix{};  ///< of the names of options in messages: "--" on a command line

    template <class Take>
    void each_field(Take take) {
        take("kind", kind,
             {.help = "wm: Weierstrass-Mandelbrot profile; profile, map: self-affine Gaussian, periodic",
              .required = true,
              .positional = true});
        take("points", points,
             {.help = "number of points of the profile (default 4096) or of a row of the map (default 256)",
              .low = min_side,
              .high = max_points});
        take("rows", rows,
             {.help = "number of rows of the map; the default is the number of points",
              .low = min_side,
              .high = max_points});
        take("spacing", spacing, {"distance between neighbouring points, such as \"0.5 um\""});
        take("dimension", dimension, {"fractal dimension D of a wm profile, between 1 and 2"});
        take("roughness", roughness, {"fractal roughness G of a wm profile, such as \"12 nm\""});
        take("gamma", gamma, {"ratio of neighbouring wavelengths of a wm profile; default 1.5"});
        take("hurst", hurst, {"Hurst exponent H of a profile or map, between 0 and 1; a section has D = 2 - H"});
        take("rms", rms, {"rms height (Rq or Sq) of the profile or map, such as \"1 um\""});
        take("longest", longest, {"longest wavelength; the default is the longest side"});
        take("shortest", shortest, {"shortest wavelength; the default is two spacings"});
        take("long_waves", long_waves,
             {"waves beyond the longest wavelength: plateau (default), as strong as it, or none"});
        take("seed", seed, {"seed of the random phases or amplitudes; the default is 1"});
        take("format", format, {.help = "form of the file: csv (default), sdf (binary) or sdf-text", .type = "FORMAT"});
    }
};

struct Generated {
    io::ProfileOrMap surface;
    std::vector<std::pair<std::string, std::string>> parameters;  ///< all of them, as they were used

    /// "made by fstiff 0.1.0 generate (kind profile, H 0.5, ...)", worded so that no reader takes it for a size or a
    /// unit.
    [[nodiscard]] std::string origin() const;
};

/// \throws option_error for an option that the kind has no use for, or that it misses; domain_error for values out of
/// range.
[[nodiscard]] Generated generate(const GenerateRequest& request);
/// The file, which fstiff reads back; the CSV has the origin in its first line.
[[nodiscard]] std::string file_of(const Generated& generated, GeneratedForm form);
/// The same as a document; its values are the heights and their steps. \throws as generate().
[[nodiscard]] document::Document document_of(const GenerateRequest& request);

}  // namespace fstiff::actions
