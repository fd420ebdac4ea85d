// SPDX-License-Identifier: BSD-3-Clause
// The lengths of an interaction; rough_contact_test.cpp tests its effect on a contact.
#include <fstiff/contact/interaction.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

namespace interaction_test {

using namespace fstiff;

TEST_CASE("The length of an interaction is that of the nominal area, or the spacing of the peaks") {
    CHECK(detail::interaction_length_of_area(9e-6) * detail::interaction_length_of_area(9e-6) == 9e-6);
    CHECK(test::ulps(detail::interaction_length_of_peaks(1e8), 1e-4) <= 1);
    CHECK(
        test::refusal([] { (void)detail::interaction_length_of_area(0.0); }).starts_with("nominal_area = 0: must be"));
    CHECK(test::refusal([] {
              (void)detail::interaction_length_of_peaks(-1.0);
          }).starts_with("peak_density = -1: must be"));
}

}  // namespace interaction_test
