// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// fstiff identify: which parameters are fitted to which curve, and what was found as a document.

#include "document/document.hpp"
#include "scene/identification.hpp"
#include "surface/surface_option_table.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fstiff::scene {

/// The kind of wave whose reflections were measured.
enum class WaveKind { longitudinal, shear };

}  // namespace fstiff::scene

namespace fstiff {

template <>
inline constexpr auto names<scene::WaveKind> =
    name_list<scene::WaveKind>({{scene::WaveKind::longitudinal, "longitudinal"}, {scene::WaveKind::shear, "shear"}});

}  // namespace fstiff

namespace fstiff::scene {

/// How parameters are called in requests and documents.
inline constexpr auto parameter_short_names = [] {
    std::array<std::string_view, parts::parameter_table.size()> all;
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = parts::parameter_table[i].short_name;
    return all;
}();

struct IdentifyRequest {
    std::string measured{};          ///< file of the curve
    std::vector<std::string> fit{};  ///< parameters, by their short names or their keys in a scene
    std::string law{};               ///< alone; empty: the laws that somebody chose, or the one whose K is the answer
    WaveKind wave = WaveKind::longitudinal;
    std::string_view prefix{};  ///< of the names of options in messages: "--" on a command line

    template <class Take>
    void each_field(Take take) {
        std::string names;
        for (const std::string_view name : parameter_short_names)
            names += (names.empty() ? "" : ", ") + std::string(name);
        take("measured", measured,
             {.help = "file (CSV) of pressure and stiffness or reflection, with their errors if they are known",
              .required = true,
              .type = "FILE"});
        take("fit", fit,
             {.help = "parameters to fit, among " + names +
                      " (g: rms gradient, offset: of the pressure); the others keep their values",
              .required = true,
              .type = "NAME,..."});
        take("law", law,
             {.help = "law to fit; the default is contact.laws or, without it, plastic or hybrid",
              .words = fitted_law_names()});
        take("wave", wave,
             {"kind of wave whose reflection coefficients were measured: longitudinal (default) or shear"});
    }
};

struct Identified {
    MeasuredCurve curve;
    std::vector<Parameter> wanted;
    Fits found;
};

/// The parameters that \p request fits. \throws option_error for a name that is none, or is listed twice.
[[nodiscard]] std::vector<Parameter> parameters_of(const IdentifyRequest& request);
/// Fits \p curve, or the one in the file of \p request, which is read. \throws as parameters_of(),
/// read_measured_curve() and identify().
[[nodiscard]] Identified identify_scene(const Scene& scene, const IdentifyRequest& request,
                                        std::optional<MeasuredCurve> curve = {});
/// The document of fstiff identify.
[[nodiscard]] Document document_of(const Scene& scene, const Identified& identified);

}  // namespace fstiff::scene
