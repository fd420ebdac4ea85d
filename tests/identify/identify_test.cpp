// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/identify/identify.hpp>
#include <fstiff/surface/sum_of_faces.hpp>
#include <fstiff/wave/uncertain_reflection.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/normal.hpp"
#include "support/paper.hpp"

#include <numbers>
#include <random>

namespace identify_test {

using namespace fstiff;

namespace {

const ContactParameters<double> true_contact{.rms_height = test::sand_blasted_fine.rms_height,
                                             .peak_radius = test::sand_blasted_fine.peak_radius,
                                             .peak_density = test::sand_blasted_fine.peak_density,
                                             .fractal_dimension = test::sand_blasted_fine.fractal_dimension,
                                             .effective_modulus = 112.6e9,
                                             .r = 0.6,
                                             .theta = 1.1};
const ObservedWave<double> wave{{46e6, 46e6}, 4.398e7};
const auto fractal = [](double dimension) { return FractalLaw<double>(dimension); };
const auto hertz = [](double) { return HertzLaw<double>{}; };

struct Plastic {
    static constexpr HalfPowers load_powers{2, 2}, stiffness_powers{1, 1}, area_powers{2, 2};
    static double load_factor() { return 0.06; }
    static double stiffness_factor() { return 2.8; }
    static double area_factor() { return 6.28; }
};

/// Values of the model with \p parameters at \p count pressures from 0.5 to 50 MPa.
template <class Law>
std::vector<Observation<double>> curve(const ContactParameters<double>& x, const Law& law, int count,
                                       const ObservedWave<double>* as = nullptr,
                                       const RoughContactOptions<double>& options = {}) {
    std::vector<Observation<double>> data;
    const RoughContact contact(Roughness<double>{x.rms_height, x.peak_radius, x.peak_density, 0},
                               PeakDistribution<double>(x.r, x.theta), law(x.fractal_dimension), x.effective_modulus,
                               options);
    for (int i = 0; i < count; ++i) {
        const double p = 0.5e6 * std::pow(100.0, double(i) / (count - 1));
        const double k = contact.at_pressure(p + x.offset, Quantity::stiffness).stiffness.value;
        data.push_back({p, as ? reflection(as->seen(k), as->media, as->angular_frequency) : k, 0});
    }
    return data;
}

/// In how many of 100 seeded runs each parameter's interval holds the truth; \p error is relative for K, absolute for
/// R.
template <class Law>
std::vector<int> coverage(const ContactParameters<double>& x, const std::vector<Parameter>& wanted, const Law& law,
                          double error, bool known, const ObservedWave<double>* as = nullptr) {
    auto data = curve(x, law, 25, as);
    const auto exact = data;
    std::vector<int> hits(wanted.size());
    for (int run = 0; run < 100; ++run) {
        test::Normal noise(static_cast<std::uint64_t>(1000 + run));
        for (std::size_t i = 0; i < data.size(); ++i) {
            const double deviation = as ? error : error * exact[i].value;
            data[i].value = exact[i].value + deviation * noise();
            data[i].error = known ? deviation : 0;
        }
        ContactParameters<double> start = x;
        for (const Parameter p : wanted)
            start[p] = p == Parameter::offset ? 0 : p == Parameter::fractal_dimension ? 1.4 : start[p] * 0.8;
        const auto fit = identify(data, wanted, start, law, {.wave = as ? std::optional(*as) : std::nullopt});
        REQUIRE(fit.status == math::FitStatus::converged);
        for (std::size_t i = 0; i < wanted.size(); ++i)
            hits[i] += fit.parameters[i].low <= x[wanted[i]] && x[wanted[i]] <= fit.parameters[i].high ? 1 : 0;
    }
    return hits;
}

void check_coverage(const std::vector<int>& hits) {
    // binomial: 95 with a standard deviation of 2.2
    for (const int hit : hits) {
        CAPTURE(hit);
        CHECK(hit >= 91);
        CHECK(hit <= 99);
    }
}

}  // namespace

TEST_CASE("the truth lies in its own 95 % interval in 95 +- 4 of 100 runs, from K(p)") {
    using enum Parameter;
    check_coverage(coverage(true_contact, {rms_height, peak_density}, fractal, 0.02, true));
    check_coverage(coverage(true_contact, {rms_height, peak_radius}, hertz, 0.02, false));
    check_coverage(coverage(true_contact, {fractal_dimension}, fractal, 0.02, true));
    check_coverage(coverage(true_contact, {theta}, fractal, 0.01, true));
    ContactParameters<double> shifted = true_contact;
    shifted.offset = 0.15e6;
    check_coverage(coverage(shifted, {rms_height, offset}, fractal, 0.01, true));
    check_coverage(coverage(shifted, {peak_density, offset}, hertz, 0.02, false));
}

TEST_CASE("with interaction, and for plastic peaks, the truth comes back") {
    using enum Parameter;
    const auto plastic = [](double) { return Plastic{}; };
    const RoughContactOptions<double> patch{.interaction = {InteractionReading::effective_separation, 1e-4}};
    const auto check = [&](const auto& law, const std::vector<Parameter>& wanted,
                           const RoughContactOptions<double>& options) {
        const auto data = curve(true_contact, law, 25, nullptr, options);
        ContactParameters<double> start = true_contact;
        for (const Parameter p : wanted) start[p] *= 0.9;
        const auto fit = identify(data, wanted, start, law, {.contact = options});
        CHECK(fit.status == math::FitStatus::converged);
        for (const Parameter p : wanted) CHECK(test::relative_error(fit.optimum[p], true_contact[p]) < 1e-6);
        // without the bulk it is another surface
        if (options.interaction.reading != InteractionReading::none)
            CHECK(test::relative_error(identify(data, wanted, start, law).optimum.rms_height, true_contact.rms_height) >
                  0.05);
    };
    check(fractal, {rms_height, peak_density}, patch);
    check(hertz, {rms_height, effective_modulus}, patch);
    check(plastic, {rms_height, peak_density}, patch);
    check(plastic, {peak_radius, peak_density}, {});
    // both p and K of plastic peaks depend on sigma R alone
    CHECK(identify(curve(true_contact, plastic, 25), {rms_height, peak_radius}, true_contact, plastic).status ==
          math::FitStatus::singular);
    CHECK(identify(curve(true_contact, plastic, 9), {fractal_dimension}, true_contact, plastic).status ==
          math::FitStatus::singular);
}

TEST_CASE("the truth lies in its own 95 % interval in 95 +- 4 of 100 runs, from R(p)") {
    using enum Parameter;
    // 1 - R is 1e-5 to 0.04 here: with errors ten times these, two parameters have no minimum in some runs
    check_coverage(coverage(true_contact, {rms_height, peak_density}, fractal, 0.0003, true, &wave));
    check_coverage(coverage(true_contact, {effective_modulus}, hertz, 0.001, false, &wave));
    const ObservedWave<double> shear{{25e6, 25e6}, 4.398e7, 1.4 / 1.7};
    check_coverage(coverage(true_contact, {rms_height, fractal_dimension}, fractal, 0.0003, true, &shear));
}

TEST_CASE("a fit to R(p) under a film subtracts the film") {
    const ObservedWave<double> under_film{{46e6, 46e6}, 4.398e7, 1, 2e13};
    auto data = curve(true_contact, hertz, 20, &under_film), dry = curve(true_contact, hertz, 20, &wave);
    for (std::size_t i = 0; i < data.size(); ++i) {
        const double k = stiffness_from_reflection(dry[i].value, 46e6, 4.398e7);
        CHECK(test::relative_error(stiffness_from_reflection(data[i].value, 46e6, 4.398e7), k + 2e13) < 1e-9);
        data[i].error = 1e-5;
    }
    ContactParameters<double> start = true_contact;
    start.rms_height *= 0.9;
    const auto fit = identify(data, {Parameter::rms_height}, start, hertz, {.wave = under_film});
    CHECK(test::relative_error(fit.parameters[0].value, true_contact.rms_height) < 1e-9);
}

TEST_CASE("without noise the truth comes back") {
    using enum Parameter;
    const std::vector<std::vector<Parameter>> sets{
        {rms_height, peak_density}, {rms_height, fractal_dimension, offset}, {rms_height, peak_radius, theta}};
    for (const auto& wanted : sets) {
        ContactParameters<double> x = true_contact, start = true_contact;
        x.offset = 1e5;
        start.offset = 0;
        if (std::count(wanted.begin(), wanted.end(), offset) == 0) start.offset = x.offset;
        for (const Parameter p : wanted)
            if (p != offset) start[p] *= 0.9;
        auto data = curve(x, fractal, 30);
        for (auto& o : data) o.error = 0.01 * o.value;
        const auto fit = identify(data, wanted, start, fractal);
        CHECK(fit.status == math::FitStatus::converged);
        // residuals of 1e-11 are 1e-13 of K; the least singular value is 1e-3 of the largest or more
        for (const auto& p : fit.parameters) CHECK(test::relative_error(p.value, x[p.parameter]) < 1e-9);
        CHECK(fit.chi_squared < 1e-14);
        CHECK(fit.degrees_of_freedom == 30 - static_cast<int>(wanted.size()));
    }
}

TEST_CASE("covariance is that of the scatter of estimates") {
    using enum Parameter;
    const auto exact = curve(true_contact, fractal, 25);
    const std::vector<Parameter> wanted{rms_height, peak_density};
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    Eigen::Matrix2d squares = Eigen::Matrix2d::Zero(), claimed = Eigen::Matrix2d::Zero();
    const int runs = 400;
    for (int run = 0; run < runs; ++run) {
        test::Normal noise(static_cast<std::uint64_t>(run));
        auto data = exact;
        for (auto& o : data) {
            o.error = 0.01 * o.value;
            o.value += o.error * noise();
        }
        const auto fit = identify(data, wanted, true_contact, fractal);
        const Eigen::Vector2d scaled(fit.parameters[0].value / true_contact.rms_height - 1,
                                     fit.parameters[1].value / true_contact.peak_density - 1);
        sum += scaled;
        squares += scaled * scaled.transpose();
        const Eigen::Vector2d unit(1 / true_contact.rms_height, 1 / true_contact.peak_density);
        claimed += unit.asDiagonal() * fit.covariance * unit.asDiagonal();
        CHECK(std::abs(fit.correlation(0, 1)) <= 1);
    }
    const Eigen::Matrix2d found = squares / runs - sum * sum.transpose() / runs / runs;
    claimed /= runs;
    // a variance of 400 draws is known to sqrt(2/400) = 7 %: three times that
    for (int i = 0; i < 2; ++i)
        for (int k = 0; k < 2; ++k) CHECK(test::relative_error(found(i, k), claimed(i, k)) < 0.21);
}

TEST_CASE("parameters that K(p) holds in combination only are called singular, by name") {
    using enum Parameter;
    auto data = curve(true_contact, fractal, 25);
    for (auto& o : data) o.error = 0.01 * o.value;
    const auto pair = identify(data, {peak_radius, peak_density}, true_contact, fractal);
    CHECK(pair.status == math::FitStatus::singular);
    CHECK(pair.covariance.size() == 0);
    const auto four = identify(data, {offset, peak_density, effective_modulus, theta}, true_contact, fractal);
    REQUIRE(four.status == math::FitStatus::singular);
    CHECK(four.parameters[0].null_share < 1e-3);  // the offset is seen, the product D_p E only
    CHECK(four.parameters[1].null_share > 0.9);
    CHECK(four.parameters[2].null_share > 0.9);
    CHECK(four.parameters[3].null_share < 1e-3);
    // sigma, D_p and D make two scales of one curve
    CHECK(identify(data, {rms_height, peak_density, fractal_dimension}, true_contact, fractal).status ==
          math::FitStatus::singular);
    CHECK(identify(data, {rms_height, fractal_dimension}, true_contact, fractal).status == math::FitStatus::converged);
    // D does not enter the elastic law at all
    CHECK(identify(data, {fractal_dimension}, true_contact, hertz).status == math::FitStatus::singular);
}

TEST_CASE("a fit that runs to the end of a range reports at_bound and one that only noise separates reports singular") {
    using enum Parameter;
    // sigma, D_p and theta of 12 points with 1 % of noise: too many, whatever the noise makes of them
    ContactParameters<double> start = true_contact;
    start.rms_height *= 0.8;
    start.peak_density *= 0.8;
    start.theta = 0.9;
    const auto exact = curve(true_contact, hertz, 12);
    int at_bound = 0, singular = 0;
    for (std::uint64_t run = 0; run < 60; ++run) {
        test::Normal noise(run);
        auto data = exact;
        for (auto& o : data) {
            o.error = 0.01 * o.value;
            o.value += o.error * noise();
        }
        const auto fit = identify(data, {rms_height, peak_density, theta}, start, hertz);
        const auto& angle = fit.parameters[2];
        CAPTURE(run, angle.value, angle.standard_error, fit.evaluations);
        if (fit.status == math::FitStatus::at_bound) {
            ++at_bound;
            CHECK(angle.at_bound);
            CHECK_FALSE(fit.parameters[0].at_bound);
            CHECK(std::min(angle.value, std::numbers::pi / 2 - angle.value) < 0.01);
            CHECK(fit.covariance.size() == 0);
            CHECK(angle.standard_error == 0);
            CHECK(fit.model.size() == 12);
        } else if (fit.status == math::FitStatus::singular) {
            ++singular;
            CHECK(angle.null_share > 0.3);
            CHECK(fit.covariance.size() == 0);
        } else {
            CHECK(fit.status == math::FitStatus::converged);
            CHECK(angle.high - angle.low < 1.5707);  // the standard error is 4.6 at most in ln x/(pi/2 - x)
            CHECK(fit.parameters[1].high < 1e7 * fit.parameters[1].low);
        }
    }
    CHECK(at_bound > 5);
    CHECK(singular > 5);
    // the stiffness of a fractal law is 4/3 of Hertz's or more, so that D goes to its end
    auto stiff = curve(true_contact, hertz, 12), vague = curve(true_contact, fractal, 12);
    for (auto& o : stiff) o.error = 0.01 * o.value;
    const auto least = identify(stiff, {fractal_dimension}, true_contact, fractal);
    CHECK(least.status == math::FitStatus::at_bound);
    CHECK(least.parameters[0].at_bound);
    CHECK(least.parameters[0].value < 1.001);
    // errors far larger than the values: each parameter alone is not known, which is no combination of them
    for (auto& o : vague) o.error = 100 * o.value;
    CHECK(identify(vague, {rms_height, peak_density}, true_contact, fractal).status == math::FitStatus::converged);
}

TEST_CASE("estimates do not depend on the unit of length") {
    using enum Parameter;
    for (const double unit : {1e-9, 1e9}) {
        auto data = curve(true_contact, fractal, 25);
        test::Normal noise(3);
        ContactParameters<double> scaled = true_contact;
        scaled.rms_height *= unit;
        scaled.peak_radius *= unit;
        scaled.peak_density /= unit * unit;
        auto other = data;
        for (std::size_t i = 0; i < data.size(); ++i) {
            data[i].value *= 1 + 0.02 * noise();
            data[i].error = 0.02 * data[i].value;
            other[i] = {data[i].pressure, data[i].value / unit, data[i].error / unit};
        }
        const auto a = identify(data, {rms_height, peak_density}, true_contact, fractal);
        const auto b = identify(other, {rms_height, peak_density}, scaled, fractal);
        for (std::size_t i = 0; i < 2; ++i) {
            const double factor = i == 0 ? unit : 1 / unit / unit;
            // both searches end within 1e-7 of a standard error
            CHECK(test::relative_error(b.parameters[i].value, factor * a.parameters[i].value) < 1e-7);
            CHECK(test::relative_error(b.parameters[i].standard_error, factor * a.parameters[i].standard_error) < 1e-6);
        }
    }
}

TEST_CASE("identify refuses data and starting values that no model has") {
    using enum Parameter;
    auto data = curve(true_contact, fractal, 3);
    const auto refused = [&](const std::vector<Parameter>& wanted, const ContactParameters<double>& start,
                             const std::string& part) {
        const std::string said = test::refusal([&] { static_cast<void>(identify(data, wanted, start, fractal)); });
        INFO(said);
        CHECK(said.find(part) != std::string::npos);
    };
    refused({rms_height, peak_density, theta, offset}, true_contact, "3 points");
    refused({rms_height, rms_height}, true_contact, "fitted twice");
    ContactParameters<double> start = true_contact;
    start.r = 0;
    refused({r}, start, "r = 0");
    start = true_contact;
    start.offset = -1e6;
    refused({rms_height, offset}, start, "starting values");
    data[1].error = 1;
    refused({rms_height}, true_contact, "data[0].error = 0");
    // neither value denotes unknown errors
    for (auto& o : data) o.error = std::nan("");
    refused({rms_height}, true_contact, "data[0].error = nan: must be finite and greater than 0, or 0 in every point");
    for (auto& o : data) o.error = -1;
    refused({rms_height}, true_contact, "data[0].error = -1");
    data[0].error = data[1].error = 1;
    refused({rms_height}, true_contact, "data[2].error = -1");
    data[1] = {-1, 1, 0};
    refused({rms_height}, true_contact, "data[1].pressure = -1");
    data[1] = {1e6, std::nan(""), 1};
    refused({rms_height}, true_contact, "data[1].stiffness = nan");
}

}  // namespace identify_test
