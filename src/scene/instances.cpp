// SPDX-License-Identifier: BSD-3-Clause
#define FSTIFF_SCENE_INSTANCE template
#include "scene/contact_instances.hpp"
#include "scene/surface_instances.hpp"
