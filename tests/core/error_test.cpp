// SPDX-License-Identifier: BSD-3-Clause
// The two exceptions: their types, texts and fields, and that no locale changes them. Sentences are
// written out.
#include <fstiff/core/error.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <limits>
#include <locale>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

namespace error_test {

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

TEST_CASE("a refusal names the parameter and its value and the allowed range", "[error]") {
    CHECK(test::refusal([] { fstiff::detail::require(false, "theta", 1.75, "between 0 and pi/2"); }) ==
          "theta = 1.75: must be between 0 and pi/2");
    CHECK(test::refusal([] { fstiff::detail::require(true, "theta", 1.75, "between 0 and pi/2"); }) == "");
    CHECK((std::is_base_of_v<std::domain_error, fstiff::domain_error>));
}

TEMPLATE_TEST_CASE("only finite numbers greater than zero are positive", "[error]", float, double) {
    using T = TestType;
    using Limits = std::numeric_limits<T>;
    for (const T good : {Limits::denorm_min(), Limits::min(), T(1), Limits::max()})
        CHECK(test::refusal([&] { fstiff::detail::require_positive("radius", good); }) == "");
    for (const T bad :
         {T(0), T(-0.0), -Limits::denorm_min(), T(-1), Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN()})
        CHECK(test::refusal([&] { fstiff::detail::require_positive("radius", bad); }).find("radius = ") == 0);
    CHECK(test::refusal([] { fstiff::detail::require_positive("radius", T(-2.5)); }) ==
          "radius = -2.5: must be finite and greater than 0");
}

TEST_CASE("the message does not depend on the global locale", "[error]") {
    const GlobalLocale comma(std::locale(std::locale::classic(), new Comma));
    CHECK(test::refusal([] { fstiff::detail::require(false, "density", 1234567.5, "smaller"); }) ==
          "density = 1234567.5: must be smaller");
}

TEST_CASE("the message shows the value with the digits of its type", "[error]") {
    CHECK(test::refusal([] { fstiff::detail::require(false, "x", 0.1f, "more"); }) == "x = 0.1: must be more");
    CHECK(test::refusal([] { fstiff::detail::require(false, "x", 0.123456789012345, "more"); }) ==
          "x = 0.123456789012345: must be more");
}

namespace {

using fstiff::domain_error;
using fstiff::file_error;
using fstiff::Place;

domain_error range_error() { return domain_error({.parameter = "theta", .value = "2 rad", .allowed = "below pi/2"}); }

}  // namespace

TEST_CASE("an error of a parameter has fields, of which its sentence is composed", "[error]") {
    const domain_error error = range_error();
    CHECK(std::string(error.what()) == "theta = 2 rad: must be below pi/2");
    CHECK(error.parameter() == "theta");
    CHECK(error.value() == "2 rad");
    CHECK(error.allowed() == "below pi/2");
    CHECK(error.reason() == "must be below pi/2");
    CHECK(error.place().text() == "");

    const domain_error unit({.parameter = "x", .value = "\"1\"", .reason = "has no unit; allowed are m, mm"});
    CHECK(std::string(unit.what()) == "x = \"1\": has no unit; allowed are m, mm");
    CHECK(unit.allowed() == "");
    CHECK(unit.reason() == "has no unit; allowed are m, mm");
}

namespace {

// GCC forgets designators in a template: two texts in braces must not be the ends of a string there.
template <class T>
void refuse_in_template(T) {
    throw domain_error({.parameter = "a", .reason = "b"});
}

}  // namespace

TEST_CASE("an error of two texts is made in a template too", "[error]") {
    CHECK(test::refusal([] { refuse_in_template(1); }) == "a: b");
}

TEST_CASE("an error without a parameter is a plain sentence", "[error]") {
    for (const domain_error& error :
         {domain_error("map has 0 points"), domain_error(std::string("map has 0 points"))}) {
        CHECK(std::string(error.what()) == "map has 0 points");
        CHECK(error.reason() == "map has 0 points");
        CHECK(error.parameter().size() + error.value().size() + error.allowed().size() == 0);
        const domain_error named = error.with_parameter("--from");
        CHECK(std::string(named.what()) == "--from: map has 0 points");
        CHECK(named.parameter() == "--from");
        CHECK(named.reason() == "map has 0 points");
    }
}

TEST_CASE("a place is put before the sentence and stays a field", "[error]") {
    const auto text_of = [](const Place& place) { return std::string(range_error().with_place(place).what()); };
    CHECK(text_of({.file = "a.txt"}) == "a.txt: theta = 2 rad: must be below pi/2");
    CHECK(text_of({.file = "a.txt", .line = 7}) == "a.txt, line 7: theta = 2 rad: must be below pi/2");
    CHECK(text_of({.file = "a.toml", .line = 7, .key = "surface", .before_line = ":"}) ==
          "a.toml:7: surface: theta = 2 rad: must be below pi/2");
    CHECK(text_of({.key = "surface"}) == "surface: theta = 2 rad: must be below pi/2");
    CHECK(text_of({}) == range_error().what());

    const domain_error near = range_error().with_place({.file = "a.txt", .line = 7, .key = "peaks"});
    const domain_error far = near.with_place({.file = "scene.toml", .line = 12345, .before_line = ":"});
    CHECK(std::string(far.what()) == "scene.toml:12345: a.txt, line 7: peaks: theta = 2 rad: must be below pi/2");
    for (const domain_error& error : {near, far}) {
        CHECK(error.place().file == "a.txt");
        CHECK(error.place().line == 7);
        CHECK(error.place().key == "peaks");
        CHECK(error.place().text() == "a.txt, line 7: peaks");
        CHECK(error.parameter() == "theta");
        CHECK(error.value() == "2 rad");
        CHECK(error.allowed() == "below pi/2");
        CHECK(error.reason() == "must be below pi/2");
    }
}

TEST_CASE("a parameter is renamed wherever its place is", "[error]") {
    const domain_error error =
        range_error().with_place({.file = "a.txt", .line = 7}).with_parameter("--peak-angle").with_place({.file = "b"});
    CHECK(std::string(error.what()) == "b: a.txt, line 7: --peak-angle = 2 rad: must be below pi/2");
    CHECK(error.parameter() == "--peak-angle");
    CHECK(error.value() == "2 rad");
    CHECK(error.allowed() == "below pi/2");
    CHECK(error.place().text() == "a.txt, line 7");
    const domain_error unit =
        domain_error({.parameter = "x", .value = "1", .reason = "has no unit"}).with_parameter("y");
    CHECK(std::string(unit.what()) == "y = 1: has no unit");
    CHECK(unit.allowed() == "");
}

TEST_CASE("errors are copied without throwing, with their fields", "[error]") {
    STATIC_REQUIRE(std::is_nothrow_copy_constructible_v<domain_error>);
    STATIC_REQUIRE(std::is_nothrow_copy_assignable_v<domain_error>);
    STATIC_REQUIRE(std::is_nothrow_copy_constructible_v<file_error>);
    domain_error copy("another");
    {
        const domain_error error = range_error().with_place({.file = "a.txt"});
        copy = error;
    }
    CHECK(copy.parameter() == "theta");
    CHECK(copy.place().file == "a.txt");
}

TEST_CASE("a file that cannot be read is an error of its own, not of the caller's logic", "[error]") {
    STATIC_REQUIRE(std::is_base_of_v<std::runtime_error, file_error>);
    STATIC_REQUIRE_FALSE(std::is_base_of_v<std::logic_error, file_error>);
    const file_error error("a.txt", "cannot be opened");
    CHECK(std::string(error.what()) == "a.txt: cannot be opened");
    const file_error named = error.with_place({.file = "scene.toml", .line = 3, .before_line = ":"});
    CHECK(std::string(named.what()) == "scene.toml:3: a.txt: cannot be opened");
    for (const file_error& one : {error, named}) {
        CHECK(one.file() == "a.txt");
        CHECK(one.reason() == "cannot be opened");
    }
}

TEST_CASE("a call is located: both errors get the place, others pass", "[error]") {
    const Place place{.file = "scene.toml", .line = 3};
    CHECK(fstiff::detail::located(place, [] { return 4; }) == 4);
    CHECK(test::refusal([&] { fstiff::detail::located(place, [] { throw range_error(); }); }) ==
          "scene.toml, line 3: theta = 2 rad: must be below pi/2");
    CHECK_THROWS_AS(fstiff::detail::located(place, [] { throw file_error("a", "b"); }), file_error);
    CHECK(test::refusal([&] { fstiff::detail::located(place, [] { throw file_error("a", "b"); }); }) ==
          "scene.toml, line 3: a: b");
    CHECK_THROWS_AS(fstiff::detail::located(place, [] { throw 4; }), int);
}

TEST_CASE("a text that holds NUL has fields within its sentence", "[error]") {
    const domain_error error({.parameter = std::string_view("a\0b", 3), .value = "1", .allowed = "2"});
    const std::string_view all = error.what();
    for (const std::string_view field : {error.parameter(), error.value(), error.allowed(), error.reason()})
        CHECK((field.data() >= all.data() && field.data() + field.size() <= all.data() + all.size()));
    CHECK(file_error(std::string("a\0b", 3), "c").file() == "a");
}

TEMPLATE_TEST_CASE("integers are refused with all their digits", "[error]", int, std::size_t, long long) {
    const TestType value = 1234567890;
    CHECK(test::refusal([&] { fstiff::detail::require(false, "points", value, "at most 4"); }) ==
          "points = 1234567890: must be at most 4");
}

}  // namespace error_test
