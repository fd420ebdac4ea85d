// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// What `fstiff run` computes of a scene: one curve per law and peak density, for whoever prints or draws it.

#include "output.hpp"
#include "scene.hpp"

#include <fstiff/contact/contact_state.hpp>
#include <fstiff/contact/validity.hpp>
#include <fstiff/measured/sampled_band.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace fstiff::cli {

/// One law on one peak density, at every point of the scene.
struct Curve {
    Law law{};
    std::optional<double> theta, r;      ///< none: Greenwood-Williamson
    std::optional<double> rms_gradient;  ///< of the surface, for p*
    std::vector<ContactState<double>> states;
    std::vector<Check<double>> checks;
    std::vector<SampledBand<double>> band;  ///< of the stiffness, one a state; empty: the surface has no errors
};

struct Results {
    double modulus = 0;           ///< effective [Pa]
    double tangential_ratio = 0;  ///< of the tangential stiffness to K
    std::optional<double> plasticity_index;
    std::vector<Check<double>> surface_checks;
    std::vector<Curve> curves;
    std::vector<std::string> warnings;
    Status status = success;
};

/// Everything the scene asks for. \throws domain_error where the model cannot give it.
Results results_of(const Scene& scene);
/// The equations of the paper behind a law: load, stiffness and peaks.
Json equations(Law law);

}  // namespace fstiff::cli
