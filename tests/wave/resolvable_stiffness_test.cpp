// SPDX-License-Identifier: BSD-3-Clause
// Truth: the reflection of both ends, by the forward formula.
#include <fstiff/wave/spring_interface.hpp>
#include <fstiff/wave/uncertain_reflection.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

namespace resolvable_stiffness_test {

using namespace fstiff;
using test::relative_error;

TEST_CASE("The ends of the range of K reflect as they should") {
    const double omega = 4.4e7;
    for (const Impedances<double> media : {Impedances<double>{46e6, 46e6}, {46e6, 40e6}, {17e6, 46e6}}) {
        const auto range = resolvable_stiffness(media, omega);
        REQUIRE(range);
        const double weld = detail::welded_reflection(media);
        CHECK((range->low < range->high && range->max_reflection == 0.99));
        CHECK(range->min_reflection == (1.01 * weld > 0.1 ? 1.01 * weld : 0.1));
        CHECK(relative_error(reflection(range->low, media, omega), 0.99) < 1e-14);
        CHECK(relative_error(reflection(range->high, media, omega), range->min_reflection) < 1e-14);
        const auto faster = resolvable_stiffness(media, 10 * omega);
        CHECK(relative_error(faster->low, 10 * range->low) < 1e-14);
    }
    const auto own = resolvable_stiffness(Impedances<double>{46e6, 46e6}, omega, 0.2, 0.8);
    REQUIRE(own);
    CHECK(relative_error(reflection(own->high, 46e6, omega), 0.2) < 1e-14);
}

TEST_CASE("Bodies that reflect nearly all leave no range, and ends in disorder are refused") {
    CHECK(!resolvable_stiffness(Impedances<double>{46e6, 400.0}, 4.4e7));
    for (const auto& ends : {std::pair(0.0, 0.9), std::pair(0.5, 0.5), std::pair(0.5, 1.0)})
        CHECK(!test::refusal([&] {
                   (void)resolvable_stiffness(Impedances<double>{46e6, 46e6}, 4.4e7, ends.first, ends.second);
               }).empty());
}

}  // namespace resolvable_stiffness_test
