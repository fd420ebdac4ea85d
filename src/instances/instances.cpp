// SPDX-License-Identifier: BSD-3-Clause
#define FSTIFF_SCENE_INSTANCE template
#include "instances/contact_instances.hpp"
#include "instances/surface_instances.hpp"
