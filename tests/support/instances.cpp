// SPDX-License-Identifier: BSD-3-Clause
#include "scene/contact_instances.hpp"  // extern: compiled in scene/instances.cpp
#include "scene/surface_instances.hpp"

#undef FSTIFF_SCENE_INSTANCE
#define FSTIFF_SCENE_INSTANCE template
#include "support/instances.hpp"
