// SPDX-License-Identifier: BSD-3-Clause
#define FSTIFF_CLI_INSTANCE template
#include "surface_instances.hpp"
