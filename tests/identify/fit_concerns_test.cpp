// SPDX-License-Identifier: BSD-3-Clause
// Truth: fits written by hand, whose concerns can be read off, and two real ones.
#include <fstiff/identify/concerns.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

namespace fit_concerns_test {

using namespace fstiff;

namespace {

/// A fit of two parameters with 10 degrees of freedom and no concerns.
Identification<double> good() {
    Identification<double> fit;
    fit.status = math::FitStatus::converged;
    fit.parameters = {{Parameter::rms_height, 1e-6, 1e-8, 0.98e-6, 1.02e-6, 0, false},
                      {Parameter::fractal_dimension, 1.5, 0.01, 1.48, 1.52, 0, false}};
    fit.covariance = fit.correlation = Eigen::Matrix2d::Identity();
    fit.degrees_of_freedom = 10;
    fit.chi_squared = 10;
    fit.errors_known = true;
    return fit;
}

std::vector<FitConcern> words(const Identification<double>& fit) {
    std::vector<FitConcern> all;
    for (const auto& finding : detail::concerns_of(fit)) all.push_back(finding.concern);
    return all;
}

using Concerns = std::vector<FitConcern>;

}  // namespace

TEST_CASE("Each concern of a fit is found by itself, with its parameters and its number") {
    CHECK(detail::concerns_of(good()).empty());

    auto fit = good();
    fit.chi_squared = 10 + 3 * std::sqrt(20.0) + 1e-9;
    REQUIRE(words(fit) == Concerns{FitConcern::misfit});
    CHECK(detail::concerns_of(fit)[0].value == fit.chi_squared / 10);
    fit.errors_known = false;
    CHECK(detail::concerns_of(fit).empty());

    fit = good();
    fit.correlation(1, 0) = fit.correlation(0, 1) = -0.991;
    REQUIRE(words(fit) == Concerns{FitConcern::correlated});
    CHECK(detail::concerns_of(fit)[0].value == -0.991);
    CHECK(detail::concerns_of(fit)[0].parameters == std::vector{Parameter::rms_height, Parameter::fractal_dimension});

    fit = good();
    fit.parameters[0].low = 0.9e-8, fit.parameters[0].high = 1e-6;
    REQUIRE(words(fit) == Concerns{FitConcern::unresolved});
    CHECK(detail::concerns_of(fit)[0].parameters == std::vector{Parameter::rms_height});
    CHECK(test::relative_error(detail::concerns_of(fit)[0].value, 1 / 0.9e-2) < 1e-15);

    for (const double end : {1 + 1e-7, 2 - 1e-7}) {
        fit = good();
        fit.parameters[1].value = end;
        fit.parameters[1].at_bound = true;
        REQUIRE(words(fit) == Concerns{FitConcern::at_bound});
        CHECK(detail::concerns_of(fit)[0].parameters == std::vector{Parameter::fractal_dimension});
    }

    fit = good();
    fit.status = math::FitStatus::not_converged;
    fit.covariance.resize(0, 0), fit.correlation.resize(0, 0);
    CHECK(words(fit) == Concerns{FitConcern::not_converged, FitConcern::no_errors});
}

TEST_CASE("Points far from the model, one far from the others and a value far from the start are found") {
    auto fit = good();
    fit.errors_known = false;
    fit.scatter = 0.25;
    CHECK(detail::concerns_of(fit).empty());
    fit.scatter = 0.2501;
    REQUIRE(words(fit) == Concerns{FitConcern::scattered});
    CHECK(detail::concerns_of(fit)[0].value == 0.2501);

    fit = good();
    fit.residuals = {0.3, -0.4, 0.41, 4.09, -0.45};  // median 0.41
    CHECK(detail::concerns_of(fit).empty());
    fit.residuals[3] = -4.11;
    REQUIRE(words(fit) == Concerns{FitConcern::outlier});
    CHECK(detail::concerns_of(fit)[0].point == 3);
    CHECK(test::relative_error(detail::concerns_of(fit)[0].value, 4.11 / 0.41) < 1e-15);
    fit.degrees_of_freedom = 2;
    fit.chi_squared = 2;
    CHECK(detail::concerns_of(fit).empty());
    fit = good();
    fit.residuals = {0.1, -0.1, 0.1, 3.9, 0.1};  // within 4 errors
    CHECK(detail::concerns_of(fit).empty());
    fit.errors_known = false;
    fit.scatter = 0.05 / 3.91;
    CHECK(detail::concerns_of(fit).empty());
    fit.scatter = 0.05 / 3.89;
    CHECK(words(fit) == Concerns{FitConcern::outlier});

    fit = good();
    fit.start.rms_height = 29e-6;
    CHECK(detail::concerns_of(fit).empty());
    for (const double start : {31e-6, 1e-6 / 31}) {
        fit.start.rms_height = start;
        REQUIRE(words(fit) == Concerns{FitConcern::far_from_start});
        CHECK(detail::concerns_of(fit)[0].parameters == std::vector{Parameter::rms_height});
        CHECK(detail::concerns_of(fit)[0].value == 1e-6 / start);
    }
}

TEST_CASE("A parameter without effect on the data is the only concern and is fatal") {
    auto fit = good();
    fit.status = math::FitStatus::singular;
    fit.chi_squared = 1e6;
    fit.parameters[0].null_share = 1;
    fit.parameters[1].null_share = 0.01;
    REQUIRE(words(fit) == Concerns{FitConcern::singular});
    CHECK(detail::concerns_of(fit)[0].parameters == std::vector{Parameter::rms_height});
    CHECK(detail::is_fatal(FitConcern::singular));
    CHECK((detail::is_fatal(FitConcern::not_converged) && detail::is_fatal(FitConcern::at_bound)));
    for (const FitConcern concern : {FitConcern::misfit, FitConcern::scattered, FitConcern::outlier,
                                     FitConcern::far_from_start, FitConcern::unresolved})
        CHECK((detail::is_doubtful(concern) && !detail::is_fatal(concern)));
    for (const FitConcern concern : {FitConcern::no_errors, FitConcern::correlated})
        CHECK((!detail::is_doubtful(concern) && !detail::is_fatal(concern)));
    CHECK(name_of(FitConcern::correlated) == "correlated");
}

TEST_CASE("R and D_p of K(p) cannot be separated sigma alone has no concerns") {
    const ContactParameters<double> truth{0.832e-6, 40e-6, 500e6, 1.62, 112.6e9, 0.6, 1.1, 0};
    const auto hertz = [](double) { return HertzLaw<double>{}; };
    const RoughContact contact(Roughness<double>{truth.rms_height, truth.peak_radius, truth.peak_density, 0},
                               PeakDistribution<double>(truth.r, truth.theta), HertzLaw<double>{},
                               truth.effective_modulus);
    std::vector<Observation<double>> data;
    for (const double p : {1e6, 2e6, 4e6, 8e6, 16e6}) {
        const double k = contact.at_pressure(p, Quantity::stiffness).stiffness.value;
        data.push_back({p, k, 0.01 * k});
    }
    const auto both = identify(data, {Parameter::peak_radius, Parameter::peak_density}, truth, hertz);
    REQUIRE(words(both) == Concerns{FitConcern::singular});
    CHECK(detail::concerns_of(both)[0].parameters == std::vector{Parameter::peak_radius, Parameter::peak_density});
    CHECK(detail::concerns_of(identify(data, {Parameter::rms_height}, truth, hertz)).empty());
}

}  // namespace fit_concerns_test
