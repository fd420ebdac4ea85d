// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The joint of a scene is that of the library.

#include <fstiff/answer/curves.hpp>
#include <fstiff/answer/problem.hpp>

namespace fstiff::scene {

using namespace detail;

}  // namespace fstiff::scene
