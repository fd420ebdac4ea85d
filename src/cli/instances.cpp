// SPDX-License-Identifier: BSD-3-Clause
#define FSTIFF_CLI_INSTANCES
#include "instances.hpp"
