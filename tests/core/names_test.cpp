// SPDX-License-Identifier: BSD-3-Clause
// Words of an enum: of a small one by hand, and of every enum of the library that has words, there and back.
#include <fstiff/fstiff.hpp>
#include <fstiff/io.hpp>
#include <fstiff/peaks/single_radius.hpp>
#include <fstiff/profile/profile_form.hpp>
#include <fstiff/surface/structure_coefficient.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <string>
#include <string_view>

namespace names_test {

namespace {
enum class Fruit { apple = -1, pear = 4, unnamed = 7 };
enum class Silent { one };
}  // namespace

}  // namespace names_test

template <>
inline constexpr auto fstiff::enum_names<names_test::Fruit> = fstiff::detail::name_list<names_test::Fruit>(
    {{names_test::Fruit::apple, "apple"}, {names_test::Fruit::pear, "pear"}});

namespace names_test {

using namespace fstiff;

TEST_CASE("Words of an enum follow from one list", "[names]") {
    static_assert(detail::NamedEnum<Fruit> && !detail::NamedEnum<Silent> && !detail::NamedEnum<int>);
    static_assert(name_of(Fruit::pear) == "pear" && name_of(Fruit::unnamed).empty());
    static_assert(detail::find_named<Fruit>("apple") == Fruit::apple && !detail::find_named<Fruit>("Apple") &&
                  !detail::find_named<Fruit>(""));
    static_assert(detail::choices<Fruit>().size() == 2 && detail::choices<Fruit>()[1] == "pear");
    CHECK(detail::choices_text<Fruit>() == "apple, pear");
    CHECK(from_name<Fruit>("pear", "fruit") == Fruit::pear);
    CHECK(test::refusal([] { (void)from_name<Fruit>("plum", "fruit"); }) ==
          "fruit = \"plum\": must be one of apple, pear");
    CHECK(test::refusal([] { (void)from_name<Fruit>("", "fruit"); }) == "fruit = \"\": must be one of apple, pear");
}

TEMPLATE_TEST_CASE("Every word of the library reads back as its value", "[names]", BorderIslands, CurvatureScale,
                   math::FitStatus, Form, Heights, InteractionReading, IslandHeight, LongWaves, MapForm, Parameter,
                   PeakSource, StructureConvention, WindowEnd, io::Dimension, io::SurfaceFormat) {
    for (const auto& [value, name] : enum_names<TestType>) {
        CHECK(name_of(value) == name);
        CHECK(from_name<TestType>(name, "word") == value);
    }
    const std::string said = test::refusal([] { (void)from_name<TestType>("no such word", "word"); });
    CHECK(said == "word = \"no such word\": must be one of " + detail::choices_text<TestType>());
}

}  // namespace names_test
