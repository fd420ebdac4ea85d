// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// One contact out of a scene, or of plain numbers: what a program evaluates point by point, or tabulates.

#include "scene/scene.hpp"

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace fstiff::scene {

/// Plain numbers of a contact [SI]. A number that is 0 is not known, or not needed by the law; those that may be 0 are
/// optional.
struct ContactNumbers {
    Roughness<double> surface{};
    std::optional<double> r{}, theta{};  ///< [1, rad]
    double fractal_dimension = 0, rms_gradient = 0;
    double skewness = 0, kurtosis = 0;        ///< of the heights; a kurtosis of 0: Gaussian ones
    double effective_modulus = 0;             ///< [Pa]
    std::optional<double> poisson_ratio{};    ///< of the softer body
    double yield_strength = 0, hardness = 0;  ///< of it [Pa]
    InteractionReading reading = InteractionReading::none;
    double interaction_length = 0;  ///< [m]
};

/// A place in contact.laws or contact.peaks that is not there.
class no_such_entry : public domain_error {
public:
    using domain_error::domain_error;
};

struct OneContact {
    std::shared_ptr<const Problem> problem;  ///< what the contact was made of lives as long as it
    const Law* law = nullptr;
    std::shared_ptr<const AnyContact> contact;
};

/// The contact of \p numbers with the law called \p law; the surface, r, theta, fractal dimension and gradient are
/// those of \p measured where it is given. For a spectrum R and D_p may be 0 where the gradient is given: they, alpha
/// and H are then what a scene assumes. \p progress is called while the law is prepared, where that takes long.
/// \throws domain_error naming the number or the law.
[[nodiscard]] OneContact contact_of(const std::string& law, const ContactNumbers& numbers,
                                    const MeasuredSurface* measured = nullptr, const ProgressHook& progress = {});
/// The contact of entry \p law of the laws of \p of on entry \p peaks of its distributions of peaks, both from 0.
/// \throws no_such_entry, domain_error as the law.
[[nodiscard]] OneContact contact_of(const Scene& of, std::size_t law, std::size_t peaks,
                                    const ProgressHook& progress = {});

/// dK/dx [Pa/m per unit of x] under the pressure \p pressure [Pa], held, of "pressure" and of each number x of \p
/// numbers that is known, by its name. By differences of six points: within 1e-7 K of x dK/dx
/// (tests/scene/one_contact_test.cpp).
/// \throws domain_error as contact_of, and for a pressure that the law does not reach.
[[nodiscard]] std::map<std::string, double> sensitivity_of(const std::string& law, ContactNumbers numbers,
                                                           double pressure);

}  // namespace fstiff::scene
