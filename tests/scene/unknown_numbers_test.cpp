// SPDX-License-Identifier: BSD-3-Clause
// What is written with an error above half its value, and contacts that hardly yield.
#include "actions/explanation.hpp"
#include "support/library.hpp"

#include <string>

namespace unknown_numbers_test {

TEST_CASE("A height or a gradient that is written with an error above half its value is doubtful") {
    const auto of = [](const std::string& errors) {
        return test::results_of("[surface]\nrms_height = \"0.8 um\"\nrms_gradient = 0.12\nerrors = { " + errors +
                                " }\n[material]\nupper = \"steel\"\n[contact]\npressures = [\"10 MPa\"]\n");
    };
    for (const auto& [errors, doubtful] : {std::pair("rms_height = \"0.41 um\"", true),
                                           {"rms_height = \"2 um\"", true},
                                           {"rms_height = \"0.4 um\"", false},
                                           {"rms_gradient = 0.061", true},
                                           {"rms_gradient = 100", true},
                                           {"rms_gradient = 0.06", false}}) {
        const auto results = of(errors);
        CAPTURE(errors);
        CHECK(results.doubtful == doubtful);
        CHECK(results.warnings.empty() != doubtful);
        if (!doubtful) continue;
        const std::string what = std::string(errors).starts_with("rms_h") ? "sigma" : "the rms gradient";
        CHECK(results.warnings.back().starts_with(what + " is not known to a factor of two"));
    }
}

TEST_CASE("The number whose written error makes the band is what to measure next") {
    const auto next = [](const std::string& errors) {
        const std::string text =
            "[surface]\nrms_height = \"0.8 um\"\nrms_gradient = 0.12\nalpha = 8\nhurst = 0.8\n"
            "skewness = 0\nkurtosis = 3\nerrors = { " +
            errors +
            " }\n[material.upper]\nname = \"steel\"\nhardness = \"0.5 GPa\"\n"
            "[contact]\npressures = [\"10 MPa\"]\n";
        return fstiff::actions::measure_next(test::results_of(text));
    };
    CHECK(next("rms_height = \"0.4 um\"").starts_with("measure Rq or Sq: the band at 10 MPa narrows"));
    CHECK(next("rms_gradient = 0.05").starts_with("measure Sdq or Rdq: the band at 10 MPa narrows"));
    CHECK(next("rms_height = \"0.001 um\"").empty());
}

TEST_CASE("A face whose K is that of its first loading is nearly elastic, also by an assumed hardness") {
    const auto of = [](const std::string& gradient) {
        return test::results_of("[surface]\nrms_height = \"5 um\"\nrms_gradient = " + gradient +
                                "\n[material]\nupper = \"steel\"\n[contact]\npressures = [\"10 MPa\"]\n")
            .explanation.front();
    };
    CHECK(of("0.002").starts_with("The contact is nearly elastic"));
    CHECK(of("0.2").starts_with("The peaks yield"));
}

}  // namespace unknown_numbers_test
