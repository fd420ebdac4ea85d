// SPDX-License-Identifier: BSD-3-Clause
// Truth: tests/data/hybrid.csv, which has the moments of Table 1 by (4.10) and Nayak.
#include <fstiff/surface/moments.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

namespace moments_test {

using namespace fstiff;

TEST_CASE("moments of peaks, peaks of moments") {
    const auto moments = detail::moments_of_peaks(5.13e-6, 3e-5, 2.3e8);
    // m4 of eq. (4.10), m2 of Nayak: tests/data/hybrid.csv
    CHECK(test::relative_error(moments.m2, 0.065370275044115236) < 1e-14);
    CHECK(test::relative_error(moments.m4, 490473852.12340519) > 1e-4);
    CHECK(test::relative_error(moments.m4, 490873852.12340519) < 1e-14);
    CHECK(test::relative_error(detail::peak_radius_of(moments), 3e-5) < 1e-14);
    CHECK(test::relative_error(detail::peak_density_of(moments), 2.3e8) < 1e-14);
    const auto stated = detail::moments_of_gradient(1e-6, 0.1, 8.24);
    CHECK(test::relative_error(stated.bandwidth(), 8.24) < 1e-14);
    CHECK(test::relative_error(stated.m2, 0.005) < 1e-15);
}

}  // namespace moments_test
