// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// What the handle of a contact holds.

#include "c/guard.hpp"
#include "scene/one_contact.hpp"

struct fstiff_contact : fstiff::scene::OneContact {};
