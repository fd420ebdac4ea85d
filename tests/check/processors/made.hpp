// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <fstiff/contact/rough_contact.hpp>
#include <fstiff/contact/summit_contact.hpp>
#include <fstiff/tabulated/contact_law.hpp>

fstiff::ContactLaw<double> make_law();
fstiff::SummitContact<double> make_summits();
