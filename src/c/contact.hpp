// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// What the handle of a contact holds.

#include "c/guard.hpp"
#include "scene/scene.hpp"

#include <memory>

struct fstiff_contact {
    std::shared_ptr<const fstiff::scene::Scene> scene;  // what the contact was made of lives as long as it
    const fstiff::scene::Law* law = nullptr;
    std::unique_ptr<const fstiff::scene::AnyContact> contact;
};
