// SPDX-License-Identifier: BSD-3-Clause
#define FSTIFF_SCENE_INSTANCE template
#include "support/instances.hpp"
