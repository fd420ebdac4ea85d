// SPDX-License-Identifier: BSD-3-Clause
// An estimate is an aggregate that starts from zero.
#include <fstiff/core/numbers.hpp>

#include "support/catch.hpp"

#include <type_traits>

namespace estimate_test {

TEMPLATE_TEST_CASE("an estimate starts from zero and takes designated initialisers", "[estimate]", float, double) {
    using T = TestType;
    CHECK((std::is_aggregate_v<fstiff::Estimate<T>>));
    CHECK((std::is_trivially_copyable_v<fstiff::Estimate<T>>));
    const fstiff::Estimate<T> none{};
    CHECK((none.value == 0 && none.error == 0 && none.evaluations == 0));
    const fstiff::Estimate<T> some{.value = 2, .error = T(0.5), .evaluations = 7};
    CHECK((some.value == 2 && some.error == T(0.5) && some.evaluations == 7));
}

}  // namespace estimate_test
