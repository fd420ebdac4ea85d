// SPDX-License-Identifier: BSD-3-Clause
// Types that are scalars of fstiff.
#include <fstiff/core/numbers.hpp>

#include "support/catch.hpp"

namespace concepts_test {

TEST_CASE("float and double are Real, long double, integers and pointers are not", "[concepts]") {
    CHECK((fstiff::Real<float>));
    CHECK((fstiff::Real<double>));
    CHECK(!(fstiff::Real<long double>));
    CHECK(!(fstiff::Real<int>));
    CHECK(!(fstiff::Real<bool>));
    CHECK(!(fstiff::Real<double*>));
}

}  // namespace concepts_test
