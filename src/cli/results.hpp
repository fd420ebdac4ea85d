// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// What `fstiff run` computes of a scene: one curve per law and peak density, for whoever prints or draws it.

#include "output.hpp"
#include "scene.hpp"

#include <fstiff/contact/contact_state.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace fstiff::cli {

/// Quantiles of K at one point of the scene, over the errors of the surface.
struct Band {
    double low = 0, high = 0;  ///< 5 and 95 % [Pa/m]
    std::size_t failed = 0;    ///< samples that the model does not reach
};

/// One law on one peak density, at every point of the scene.
struct Curve {
    Law law{};
    std::optional<double> theta, r;      ///< none: Greenwood-Williamson
    std::optional<double> rms_gradient;  ///< of the surface, for p*
    std::vector<ContactState<double>> states;
    std::vector<Band> band;  ///< of the stiffness, one a state; empty: the surface has no errors
};

struct Results {
    double modulus = 0;           ///< effective [Pa]
    double tangential_ratio = 0;  ///< of the tangential stiffness to K
    std::optional<double> plasticity_index;
    std::vector<Curve> curves;
    std::vector<std::string> warnings;
    Status status = success;
};

/// Everything the scene asks for. \throws domain_error where the model cannot give it.
Results results_of(const Scene& scene);
/// The equations of the paper behind a law: load, stiffness and peaks.
Json equations(Law law);

}  // namespace fstiff::cli
