// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// One contact out of a scene, or of a joint: what a program evaluates point by point, or tabulates.

#include "scene/scene.hpp"

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace fstiff::actions {

/// A place in contact.laws or contact.peaks that is not there.
class no_such_entry : public domain_error {
public:
    using domain_error::domain_error;
};

struct OneContact {
    std::shared_ptr<const detail::ResolvedJoint> problem{};  ///< what the contact was made of lives as long as it
    const detail::Law* law = nullptr;
    std::shared_ptr<const AnyContact> contact;
};

/// The law called \p name. \throws domain_error with those that there are.
[[nodiscard]] const ChosenLaw& law_called(const std::string& name);
/// The contact of \p joint with the law called \p law, which takes no peaks but those that were measured or given,
/// and Gaussian heights where R and D_p are given and their shape is not.
/// \p progress is called while the law is prepared, where that takes long.
/// \throws domain_error naming the member of the joint or the law.
[[nodiscard]] OneContact make_contact(const std::string& law, Joint joint, const ProgressHook& progress = {});
/// The contact of entry \p law of the laws of \p scene on entry \p peaks of its distributions of peaks, both from 0.
/// \throws no_such_entry, domain_error as the law.
[[nodiscard]] OneContact make_contact(const scene::Scene& scene, std::size_t law, std::size_t peaks,
                                      const ProgressHook& progress = {});

/// dK/dx [Pa/m per unit of x] under the pressure \p pressure [Pa], held, of "pressure" and of each number x of the face
/// and of the upper body of \p joint that is known, by its name. By differences: within 1e-7 K of x dK/dx
/// (tests/scene/one_contact_test.cpp).
/// \throws domain_error as contact_of, and for a pressure that the law does not reach.
[[nodiscard]] std::map<std::string, double> sensitivity_of(const std::string& law, Joint joint, double pressure);

}  // namespace fstiff::actions
