// SPDX-License-Identifier: BSD-3-Clause
// The one exception: what it is, what it says, and that no locale changes it.
#include <fstiff/core/error.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <limits>
#include <locale>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace {

// Decimal comma and thousands in blocks, as a user's program may have set them globally.
struct Comma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
};

struct GlobalLocale {
    std::locale before;
    explicit GlobalLocale(const std::locale& wanted) : before(std::locale::global(wanted)) {}
    ~GlobalLocale() { std::locale::global(before); }
};

}  // namespace

TEST_CASE("what is refused names the parameter, its value and what is allowed", "[error]") {
    CHECK(test::refusal([] { fstiff::require(false, "theta", 1.75, "between 0 and pi/2"); }) ==
          "theta = 1.75: must be between 0 and pi/2");
    CHECK(test::refusal([] { fstiff::require(true, "theta", 1.75, "between 0 and pi/2"); }) == "");
    CHECK((std::is_base_of_v<std::domain_error, fstiff::domain_error>));
}

TEMPLATE_TEST_CASE("only finite numbers greater than zero are positive", "[error]", float, double, long double) {
    using T = TestType;
    using Limits = std::numeric_limits<T>;
    for (const T good : {Limits::denorm_min(), Limits::min(), T(1), Limits::max()})
        CHECK(test::refusal([&] { fstiff::require_positive("radius", good); }) == "");
    for (const T bad :
         {T(0), T(-0.0), -Limits::denorm_min(), T(-1), Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN()})
        CHECK(test::refusal([&] { fstiff::require_positive("radius", bad); }).find("radius = ") == 0);
    CHECK(test::refusal([] { fstiff::require_positive("radius", T(-2.5)); }) ==
          "radius = -2.5: must be finite and greater than 0");
}

TEST_CASE("the message does not depend on the global locale", "[error]") {
    const GlobalLocale comma(std::locale(std::locale::classic(), new Comma));
    CHECK(test::refusal([] { fstiff::require(false, "density", 1234567.5, "smaller"); }) ==
          "density = 1234567.5: must be smaller");
}

TEST_CASE("the message shows the value with the digits of its type", "[error]") {
    CHECK(test::refusal([] { fstiff::require(false, "x", 0.1f, "more"); }) == "x = 0.1: must be more");
    CHECK(test::refusal([] { fstiff::require(false, "x", 0.123456789012345, "more"); }) ==
          "x = 0.123456789012345: must be more");
}
