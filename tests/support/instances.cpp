// SPDX-License-Identifier: BSD-3-Clause
#include "instances/contact_instances.hpp"  // extern: compiled in instances/instances.cpp
#include "instances/surface_instances.hpp"

#undef FSTIFF_SCENE_INSTANCE
#define FSTIFF_SCENE_INSTANCE template
#include "support/instances.hpp"
