// SPDX-License-Identifier: BSD-3-Clause
// The table of parameters against the ranges and units as they are written in the paper and in docs/scene.md, and the
// variables of a fit against closed forms and differences.
#include <fstiff/surface/parameter.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace contact_parameter_test {

using namespace fstiff;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity(),
                 nan_value = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST_CASE("The rows are in the order of the parameters with the surface first", "[contact_parameter]") {
    for (std::size_t i = 0; i < detail::parameter_table.size(); ++i) {
        const detail::ParameterRow& row = detail::parameter_table[i];
        INFO(row.key);
        CHECK(detail::index_of(row.parameter) == i);
        CHECK(&detail::row_of(row.parameter) == &row);
        CHECK(name_of(row.parameter) == row.key);
        CHECK(detail::find_named<Parameter>(row.key) == row.parameter);
        CHECK(row.shown_factor > 0);
        CHECK(row.unit.empty() == row.shown_unit.empty());
        for (std::size_t j = 0; j < i; ++j) CHECK(row.short_name != detail::parameter_table[j].short_name);
    }
    CHECK(detail::surface_parameter_count == 6);
    CHECK(detail::parameter_table[detail::surface_parameter_count].parameter == Parameter::effective_modulus);
}

TEST_CASE("Headings and ranges of parameters as sentences", "[contact_parameter]") {
    CHECK(detail::row_of(Parameter::peak_density).heading() == "D_p [1/mm²]");
    CHECK(detail::row_of(Parameter::fractal_dimension).heading() == "D");
    CHECK(detail::row_of(Parameter::rms_height).range() == "finite and greater than 0");
    CHECK(detail::row_of(Parameter::fractal_dimension).range() == "between 1 and 2, both excluded");
    CHECK(detail::row_of(Parameter::r).range() == "at least 0 and less than 1");
    CHECK(detail::row_of(Parameter::theta).range() == "between 0 and pi/2, both excluded");
    CHECK(detail::row_of(Parameter::offset).range() == "finite");
    CHECK(detail::row_of(Parameter::r).starting_range() == "between 0 and 1, both excluded, to start a fit from");
    CHECK(detail::row_of(Parameter::peak_radius).starting_range() == "finite and greater than 0 to start a fit from");
    CHECK(detail::row_of(Parameter::offset).starting_range() == "finite");
}

TEMPLATE_TEST_CASE("Values in and out of the range of each parameter", "[contact_parameter]", float, double) {
    using T = TestType;
    using Limits = std::numeric_limits<T>;
    const auto in = [](Parameter which, T x) { return detail::parameter_in_range(which, x); };
    for (const detail::ParameterRow& row : detail::parameter_table) {
        INFO(row.key);
        for (const T bad : {Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN()}) {
            CHECK(!in(row.parameter, bad));
            CHECK(!detail::ParameterScale<T>(row.parameter).inside(bad));
        }
    }
    for (const Parameter one :
         {Parameter::rms_height, Parameter::peak_radius, Parameter::peak_density, Parameter::effective_modulus}) {
        CHECK(in(one, Limits::min()));
        CHECK(in(one, Limits::max()));
        CHECK(!in(one, T(0)));
        CHECK(!in(one, -Limits::min()));
    }
    CHECK(in(Parameter::fractal_dimension, 1 + Limits::epsilon()));
    CHECK(in(Parameter::fractal_dimension, 2 - Limits::epsilon()));
    CHECK(!in(Parameter::fractal_dimension, T(1)));
    CHECK(!in(Parameter::fractal_dimension, T(2)));
    CHECK(in(Parameter::r, T(0)));
    CHECK(!detail::ParameterScale<T>(Parameter::r).inside(T(0)));
    CHECK(in(Parameter::r, 1 - Limits::epsilon()));
    CHECK(!in(Parameter::r, T(1)));
    CHECK(!in(Parameter::r, -Limits::min()));
    CHECK(!in(Parameter::theta, T(0)));
    CHECK(in(Parameter::theta, std::nextafter(std::numbers::pi_v<T> / 2, T(0))));
    CHECK(!in(Parameter::theta, std::numbers::pi_v<T> / 2));
    CHECK(in(Parameter::offset, T(0)));
    CHECK(in(Parameter::offset, Limits::lowest()));
}

TEST_CASE("The variable of a fit: closed forms, there and back, and its slope", "[contact_parameter]") {
    CHECK(detail::ParameterScale<double>(Parameter::offset).variable(-3e5) == -3e5);
    CHECK(test::ulps(detail::ParameterScale<double>(Parameter::rms_height).variable(1e-6), std::log(1e-6)) <= 1);
    CHECK(detail::ParameterScale<double>(Parameter::fractal_dimension).variable(1.5) == 0);
    CHECK(test::relative_error(detail::ParameterScale<double>(Parameter::r).variable(0.75), std::log(3.0)) < 1e-15);
    CHECK(test::relative_error(detail::ParameterScale<double>(Parameter::theta).value(std::log(2.0)),
                               std::numbers::pi_v<double> / 3) < 1e-15);
    const std::vector<std::pair<Parameter, double>> values{
        {Parameter::rms_height, 8e-7}, {Parameter::peak_density, 5e8}, {Parameter::fractal_dimension, 1.01},
        {Parameter::r, 0.999},         {Parameter::theta, 1.2},        {Parameter::offset, -2e5}};
    for (const auto& [which, x] : values) {
        INFO(name_of(which));
        const detail::ParameterScale<double> scale(which);
        const double u = scale.variable(x);
        CHECK(test::relative_error(scale.value(u), x) < 1e-14);  // ln x rounds by 14 ulp of 1 at 1e-6
        const double step = which == Parameter::offset ? 1.0 : 1e-5;
        const double difference = (scale.value(u + step) - scale.value(u - step)) / (2 * step);
        CHECK(test::relative_error(scale.slope(x), difference) < 1e-8);  // step^2/6 and 1e-16/step
    }
    for (const double far : {-800.0, 800.0}) {  // stays within its ends where exp leaves the range of numbers
        const double d = detail::ParameterScale<double>(Parameter::fractal_dimension).value(far);
        CHECK((d >= 1 && d <= 2));
    }
    CHECK(!detail::parameter_in_range(Parameter::offset, infinite));
    CHECK(!detail::parameter_in_range(Parameter::r, nan_value));
}

}  // namespace contact_parameter_test
