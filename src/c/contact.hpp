// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Content of the handle of a contact.

#include "actions/one_contact.hpp"
#include "c/guard.hpp"

struct fstiff_contact : fstiff::actions::OneContact {};
