// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/contact/contact_law.hpp>
#include <fstiff/contact/greenwood_williamson.hpp>
#include <fstiff/contact/rough_contact.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <numbers>
#include <random>
#include <thread>

using namespace fstiff;

namespace {

const Roughness<double> fine{0.832e-6, 40e-6, 500e6, 0};
const PeakDensity<double> third = PeakDensity<double>::exponential(std::numbers::pi / 3);
constexpr double modulus = 112.6e9;

RoughContact<double, HertzLaw<double>> hertz(const RoughContactOptions<double>& options = {}) {
    return {fine, third, HertzLaw<double>{}, modulus, options};
}

using Law = ContactLaw<double>;

/// Largest relative error of the law between the nodes, against the model, at seeded random pressures.
template <class Contact>
double worst_error(const Law& law, const Contact& contact, int count = 400) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> uniform(0, 1);
    const auto [low, high] = law.pressures();
    double worst = 0;
    for (int i = 0; i < count; ++i) {
        const double p = low * std::pow(high / low, uniform(random));
        const auto truth = contact.at_pressure(p, Quantity::stiffness);
        const auto at = law.at_gap(std::clamp(truth.separation.value, law.gaps()[0], law.gaps()[1]));
        worst = std::max({worst, std::abs(law.stiffness(p) / truth.stiffness.value - 1), std::abs(at.pressure / p - 1),
                          std::abs(at.stiffness / truth.stiffness.value - 1),
                          std::abs(law.gap(p) - truth.separation.value) / contact.rms_height()});
    }
    return worst;
}

}  // namespace

TEST_CASE("a compiled law is right to 1e-10, and says how right") {
    const auto check = [](const auto& contact, double low, double high, double bound) {
        const Law law = Law::compile(contact, {low, high});
        const double worst = worst_error(law, contact);
        INFO("worst " << worst << " claimed " << law.relative_error());
        CHECK(worst <= law.relative_error());
        CHECK(law.relative_error() <= bound);
        CHECK(law.pressures() == std::array<double, 2>{low, high});
    };
    check(hertz(), 1e5, 1e8, 1e-10);
    check(RoughContact(fine, third, FractalLaw<double>(1.62), modulus), 1e5, 1e8, 1e-10);
    check(RoughContact(fine, PeakDensity<double>(0, std::numbers::pi / 4), FractalConsistentLaw<double>(1.7), modulus),
          1e5, 1e8, 1e-10);
    check(GreenwoodWilliamson<double>(fine, modulus), 1e5, 1e8, 1e-10);
    check(GreenwoodWilliamson<double>(fine, modulus, Heights::exponential), 1e5, 1e8, 1e-9);
    check(hertz({.interaction = {InteractionReading::effective_separation, std::sqrt(195e-6)}}), 1e5, 1e8, 1e-10);
    check(hertz(), 1e6, 1.01e6, 1e-9);  // a short range
    check(hertz(), 1e-20, 1e12, 1e-8);  // 32 decades
    check(RoughContact(fine, PeakDensity<double>(0.9999, 1.5), HertzLaw<double>{}, modulus), 1e4, 1e8, 1e-9);
}

TEST_CASE("the tangent is exactly the slope of the returned pressure, where the law says so") {
    const Law consistent =
        Law::compile(RoughContact(fine, third, FractalConsistentLaw<double>(1.62), modulus), {1e5, 1e8});
    const Law printed = Law::compile(RoughContact(fine, third, FractalLaw<double>(1.62), modulus), {1e5, 1e8});
    CHECK(Law::compile(hertz(), {1e5, 1e8}).tangent_is_exact());
    CHECK(consistent.tangent_is_exact());
    CHECK_FALSE(printed.tangent_is_exact());
    const double f = fractal_stiffness_factor(1.62);
    for (const Law* law : {&consistent, &printed}) {
        const auto [low, high] = law->gaps();
        for (int i = 1; i < 200; ++i) {
            const double gap = low + (high - low) * (i + 0.123) / 201;
            // within one piece p is a polynomial: a five-point difference of it has only rounding for an error
            const double h = 1e-4 * fine.rms_height;
            const auto p = [&](double x) { return law->pressure_at_gap(x); };
            const double slope = -(8 * (p(gap + h) - p(gap - h)) - (p(gap + 2 * h) - p(gap - 2 * h))) / (12 * h);
            CHECK(test::relative_error(law->stiffness_at_gap(gap) / (law == &printed ? f : 1), slope) < 3e-10);
        }
    }
}

TEST_CASE("dK/dp is the derivative of K(p)") {
    const Law law = Law::compile(hertz(), {1e5, 1e8});
    for (double p = 1.3e5; p < 9e7; p *= 1.37) {
        const double h = 1e-4 * p;
        const double slope = (8 * (law.stiffness(p + h) - law.stiffness(p - h)) -
                              (law.stiffness(p + 2 * h) - law.stiffness(p - 2 * h))) /
                             (12 * h);
        CHECK(test::relative_error(law.stiffness_slope(p), slope) < 1e-8);
    }
}

TEST_CASE("K rises with p, p and K fall with the gap, over every seam") {
    const Law law = Law::compile(hertz(), {1e3, 1e9});
    const int count = 20000;
    double k = 0, gap = 1;
    for (int i = 0; i <= count; ++i) {
        const double p = std::clamp(1e3 * std::pow(1e6, double(i) / count), 1e3, 1e9);
        REQUIRE(law.stiffness(p) > k);
        REQUIRE(law.gap(p) < gap);
        k = law.stiffness(p);
        gap = law.gap(p);
    }
    const auto [low, high] = law.gaps();
    auto last = law.at_gap(low);
    for (int i = 1; i <= count; ++i) {
        const auto at = law.at_gap(std::min(low + (high - low) * i / count, high));
        REQUIRE(at.pressure < last.pressure);
        REQUIRE(at.stiffness < last.stiffness);
        last = at;
    }
}

TEST_CASE("outside the range: refuse, clamp or evaluate, as asked for") {
    const auto contact = hertz();
    const Law refuse = Law::compile(contact, {1e5, 1e8});
    const Law clamp = Law::compile(contact, {1e5, 1e8, OutsideRange::clamp});
    const Law exact = Law::compile(contact, {1e5, 1e8, OutsideRange::exact});
    const auto said = [&](double p) { return test::refusal([&] { static_cast<void>(refuse.stiffness(p)); }); };
    CHECK(said(9e4) == "pressure = 90000: must be between 1e+05 and 1e+08 Pa, the range of the law");
    CHECK(said(1.1e8).starts_with("pressure = 110000000: must be"));
    CHECK(said(std::nan("")).starts_with("pressure = nan: must be"));
    CHECK(said(-1).starts_with("pressure = -1: must be"));
    CHECK(test::refusal([&] { static_cast<void>(refuse.at_gap(1.0)); }).starts_with("gap = 1: must be between "));
    CHECK(test::refusal([&] { static_cast<void>(clamp.at_gap(std::nan(""))); }).starts_with("gap = nan"));
    CHECK(test::refusal([&] { static_cast<void>(clamp.stiffness(std::nan(""))); }).starts_with("pressure = nan"));
    CHECK(clamp.stiffness(1) == clamp.stiffness(1e5));
    CHECK(clamp.stiffness(1e30) == clamp.stiffness(1e8));
    CHECK(clamp.at_gap(1.0).pressure == clamp.at_gap(clamp.gaps()[1]).pressure);
    CHECK(clamp.stiffness_slope(1) == 0);
    CHECK(exact.stiffness(1e3) == contact.at_pressure(1e3).stiffness.value);
    CHECK(exact.gap(1e10) == contact.at_pressure(1e10).separation.value);
    CHECK(exact.at_gap(5e-6).pressure == contact.at_separation(5e-6).pressure.value);
    CHECK(refuse.stiffness(1e5) > 0);  // the ends belong to the range
    CHECK(refuse.stiffness(1e8) > 0);
    CHECK(refuse.at_gap(refuse.gaps()[0]).pressure > 0);
    CHECK(refuse.at_gap(refuse.gaps()[1]).pressure > 0);
}

TEST_CASE("a batch equals the scalar calls bit for bit") {
    const Law law = Law::compile(hertz(), {1e5, 1e8});
    const int count = 37;
    Eigen::ArrayXd p(count), k(count), gap(count), p_back(count), k_gap(count);
    for (int i = 0; i < count; ++i) p[i] = std::min(1e5 * std::pow(1000, double(i) / (count - 1)), 1e8);
    law.stiffness(p, k);
    for (int i = 0; i < count; ++i) {
        CHECK(k[i] == law.stiffness(p[i]));
        gap[i] = std::clamp(law.gap(p[i]), law.gaps()[0], law.gaps()[1]);
    }
    law.at_gap(gap, p_back, k_gap);
    for (int i = 0; i < count; ++i) {
        CHECK(p_back[i] == law.pressure_at_gap(gap[i]));
        CHECK(k_gap[i] == law.stiffness_at_gap(gap[i]));
    }
    Eigen::ArrayXd wrong(3);
    CHECK(test::refusal([&] { law.stiffness(p, wrong); }).starts_with("batch: the arrays have 37 and 3 elements"));
}

TEST_CASE("a law goes to text and back bit for bit; other text is refused") {
    const Law law = Law::compile(hertz(), {1e5, 1e8, OutsideRange::clamp});
    const std::string text = law.to_text();
    const Law back = Law::from_text(text);
    CHECK(back == law);
    for (const double p : {1e5, 1.234e6, 7.7e7, 1e8, 1e9}) CHECK(back.stiffness(p) == law.stiffness(p));
    CHECK(back.at_gap(1e-6).stiffness == law.at_gap(1e-6).stiffness);
    CHECK(back.relative_error() == law.relative_error());
    const auto refused = [](const std::string& t) {
        return test::refusal([&] { static_cast<void>(Law::from_text(t)); });
    };
    CHECK(refused("").starts_with("contact law text: begins with something else"));
    CHECK(refused("nonsense").starts_with("contact law text: begins"));
    CHECK_FALSE(refused(text + "1").empty());
    CHECK_FALSE(refused(text.substr(0, text.size() / 2)).empty());
    std::string huge = text;
    huge.insert(text.find('\n') + 1, "999999999999 ");
    CHECK_FALSE(refused(huge).empty());
    std::string not_finite = text;
    not_finite.replace(text.rfind(' ') + 1, std::string::npos, "nan\n");
    CHECK_FALSE(refused(not_finite).empty());
    CHECK_FALSE(test::refusal([&] { static_cast<void>(ContactLaw<float>::from_text(text)); }).empty());
}

TEST_CASE("threads may share a law") {
    const Law law = Law::compile(hertz(), {1e5, 1e8});
    std::array<double, 4> sums{};
    std::vector<std::thread> threads;
    for (double& sum : sums)
        threads.emplace_back([&law, &sum] {
            for (double p = 1e5; p < 1e8; p *= 1.001)
                sum += law.stiffness(p) + law.at_gap(law.gap(p * 1.0001 < 1e8 ? p * 1.0001 : p)).pressure;
        });
    for (std::thread& thread : threads) thread.join();
    for (const double sum : sums) CHECK(sum == sums[0]);
}

TEST_CASE("float laws, and ranges that cannot be compiled") {
    const RoughContact<float, HertzLaw<float>> contact({0.832e-6F, 40e-6F, 500e6F, 0}, PeakDensity<float>(0.5F, 1.0F),
                                                       HertzLaw<float>{}, 112.6e9F);
    const auto law = ContactLaw<float>::compile(contact, {1e5F, 1e8F});
    for (const float p : {1e5F, 3e6F, 9e7F})
        CHECK(test::relative_error(law.stiffness(p), contact.at_pressure(p).stiffness.value) <= law.relative_error());
    CHECK(law.relative_error() < 1e-3F);
    const auto refused = [](double low, double high, const RoughContactOptions<double>& options = {}) {
        return test::refusal([&] { static_cast<void>(Law::compile(hertz(options), {low, high})); });
    };
    CHECK(refused(0, 1).starts_with("pressure_min = 0: must be"));
    CHECK(refused(2, 1).starts_with("pressure_max = 1: must be"));
    CHECK(refused(1, 1e40).starts_with("pressure = 1e+40: must be"));
    CHECK(refused(1, std::nan("")).starts_with("pressure_max = nan"));
    CHECK(refused(1, 2, {.interaction = {InteractionReading::as_printed, 1e-3}}).starts_with("interaction = "));
}
