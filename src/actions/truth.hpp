// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The contact of a measured map by boundary elements on the map itself.

#include "document/document.hpp"
#include "surface/surface_file.hpp"

#include <fstiff/core/parallel.hpp>
#include <fstiff/halfspace/solve_half_space.hpp>

#include <optional>
#include <string>
#include <vector>

namespace fstiff::actions {

/// How a file is read, and what is solved.
struct TruthRequest {
    surface::SurfaceOptions surface;
    double modulus = 0;             ///< effective [Pa]
    std::vector<double> pressures;  ///< nominal [Pa]
    double hardness = 0;            ///< at which pressures are cut [Pa]; 0: elastic
    double known_hardness = 0;      ///< of the softer body [Pa], for a warning where it yields; 0: not known
    int points = 256;               ///< along the longer side, 16 or more, that the map is made coarser to
    Edges edges = Edges::mirrored;
    ProgressHook progress{};

    template <class Take>
    void each_field(Take take) {
        take("points", points,
             {.help = "points along the longer side after coarsening the map; the default is 256",
              .low = 16,
              .high = 4096});
        take("edges", edges, {"continuation of the map beyond its edges: mirrored (default) or periodic"});
    }
};

struct TruthOfMap {
    std::string file, form;
    double modulus = 0, rms_height = 0, rms_gradient = 0;
    Eigen::Index points = 0;  ///< along the longer side, after coarsening
    double flows_above = 0;   ///< the hardness that elastic pressures may exceed [Pa]; 0: not known, or cut there
    std::vector<HalfSpacePoint<double>> at;
};

/// \throws domain_error in one sentence, for a profile too, and where all of the map is in contact at every pressure.
[[nodiscard]] TruthOfMap truth_of_map(const TruthRequest& options, const surface::SurfaceInput& input);
/// A pressure a row.
[[nodiscard]] document::Rows pressure_rows(const TruthOfMap& solved);
/// The document of fstiff truth for \p input, or for the file that \p options name. \throws as truth_of_map().
[[nodiscard]] document::Document document_of(const TruthRequest& options,
                                             std::optional<surface::SurfaceInput> input = {});

}  // namespace fstiff::actions
