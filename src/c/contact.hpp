// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Content of the handle of a contact.

#include "c/guard.hpp"
#include "scene/one_contact.hpp"

struct fstiff_contact : fstiff::scene::OneContact {};
