// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/contact/contact_law.hpp>
#include <fstiff/contact/greenwood_williamson.hpp>
#include <fstiff/contact/rough_contact.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/paper.hpp"

#include <numbers>
#include <random>
#include <thread>

using namespace fstiff;

namespace {

const Roughness<double> fine = test::sand_blasted_fine.roughness();
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

TEST_CASE("no law of a random surface is further from the model than it says") {
    std::mt19937 random(5);
    const auto uniform = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
    const auto decades = [&](double a, double b) { return std::pow(10, uniform(a, b)); };
    std::vector<double> claims;
    const auto check = [&](const auto& contact, double low, double high) {
        const Law law = Law::compile(contact, {low, high});
        CHECK(worst_error(law, contact, 40) <= law.relative_error());
        claims.push_back(law.relative_error());
    };
    for (int i = 0; i < 200; ++i) {
        const Roughness<double> surface{decades(-7.5, -5), decades(-6.5, -4), decades(7.5, 11)};
        const PeakDensity<double> peaks(uniform(0, 0.98), uniform(0.05, 1.55));
        const double stiff = decades(9.5, 11.5), low = decades(3, 7), high = low * decades(0.05, 5);
        RoughContactOptions<double> options;
        if (i % 4 == 0) options.interaction = {InteractionReading::effective_separation, decades(-4, -1)};
        const double reach = 1e-3 * stiff * surface.rms_height / surface.peak_radius;  // beyond, some are out of reach
        if (high > reach && high > 1e8) continue;
        if (i % 3 == 0)
            check(RoughContact(surface, peaks, HertzLaw<double>{}, stiff, options), low, high);
        else
            check(RoughContact(surface, peaks, FractalLaw<double>(uniform(1.02, 1.95)), stiff, options), low, high);
    }
    std::sort(claims.begin(), claims.end());
    CHECK(claims.size() > 100);
    CHECK(claims[claims.size() / 2] < 4e-12);
    CHECK(claims[claims.size() * 9 / 10] < 2e-10);
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

namespace {

/// K of the pressures and {p, K} of the gaps by batch against the calls one by one; from arrays that begin \p offset numbers
/// after an aligned one.
template <class T>
void check_batch(const ContactLaw<T>& law, const Eigen::ArrayX<T>& pressure, const Eigen::ArrayX<T>& gap,
                 Eigen::Index offset) {
    using Array = Eigen::ArrayX<T>;
    const Eigen::Index count = pressure.size();
    Array p = Array::Constant(count + offset + 4, -1), k = p, g = p, p_of_gap = p, k_of_gap = p;
    p.segment(offset, count) = pressure;
    g.segment(offset, count) = gap;
    law.stiffness(p.segment(offset, count), k.segment(offset, count));
    law.at_gap(g.segment(offset, count), p_of_gap.segment(offset, count), k_of_gap.segment(offset, count));
    for (Eigen::Index i = 0; i < k.size(); ++i) {
        if (i < offset || i >= offset + count) {  // nothing is written beside the results
            REQUIRE(k[i] == -1);
            REQUIRE(p_of_gap[i] == -1);
            REQUIRE(k_of_gap[i] == -1);
            continue;
        }
        // both evaluate the same polynomial: only the order of the operations differs
        const T bound = std::min(law.relative_error(), 200 * std::numeric_limits<T>::epsilon());
        const auto at = law.at_gap(g[i]);
        REQUIRE(test::relative_error(k[i], law.stiffness(p[i])) <= bound);
        REQUIRE(test::relative_error(p_of_gap[i], at.pressure) <= bound);
        REQUIRE(test::relative_error(k_of_gap[i], at.stiffness) <= bound);
    }
    Array in_place = pressure;
    law.stiffness(in_place, in_place);
    REQUIRE((in_place == k.segment(offset, count)).all());
}

/// \p count values in no order, at the ends of [low, high] and \p beyond them too.
template <class T>
Eigen::ArrayX<T> scattered(Eigen::Index count, T low, T high, T beyond) {
    Eigen::ArrayX<T> x(count);
    T fraction = T(0.3);
    for (Eigen::Index i = 0; i < count; ++i) {
        fraction = std::fmod(fraction + T(0.618034), T(1));
        x[i] = i % 7 == 2 ? low : i % 7 == 5 ? high : low + (high - low) * fraction * fraction * fraction;
        if (beyond > 0 && i % 5 == 3) x[i] = i % 2 == 0 ? low - beyond : high + beyond;
    }
    return x;
}

}  // namespace

TEST_CASE("a batch is the scalar calls within rounding: any length, any alignment, at the ends and outside") {
    const auto contact = hertz();
    const RoughContact<float, HertzLaw<float>> contact_of_floats(
        test::sand_blasted_fine.roughness<float>(), PeakDensity<float>(0.5F, 1.0F), HertzLaw<float>{}, 112.6e9F);
    const auto check = [](const auto& law, auto beyond, auto beyond_gap) {
        using T = decltype(beyond);
        const auto [low, high] = law.pressures();
        const auto [near, far] = law.gaps();
        for (const Eigen::Index count : {0, 1, 3, 4, 5, 7, 8, 9, 1000})
            for (const Eigen::Index offset : {0, 1, 3})
                check_batch<T>(law, scattered<T>(count, low, high, beyond), scattered<T>(count, near, far, beyond_gap),
                               offset);
    };
    check(Law::compile(contact, {1e5, 1e8}), 0.0, 0.0);
    check(Law::compile(contact, {1e5, 1e8, OutsideRange::clamp}), 9e4, 1e-6);
    check(Law::compile(contact, {1e5, 1e8, OutsideRange::exact}), 5e4, 1e-6);
    check(ContactLaw<float>::compile(contact_of_floats, {1e5F, 1e8F}), 0.0F, 0.0F);
    check(ContactLaw<float>::compile(contact_of_floats, {1e5F, 1e8F, OutsideRange::clamp}), 9e4F, 1e-6F);
}

TEST_CASE("a batch is right to the error that the law states, and does not depend on where an element stands") {
    const auto contact = hertz();
    const Law law = Law::compile(contact, {1e5, 1e8});
    const Eigen::Index count = 401;
    Eigen::ArrayXd p = scattered(count, 1e5, 1e8, 0.0), gap(count), k(count), p_of_gap(count), k_of_gap(count);
    std::vector<double> truth;
    for (Eigen::Index i = 0; i < count; ++i) {
        const auto at = contact.at_pressure(p[i], Quantity::stiffness);
        truth.push_back(at.stiffness.value);
        gap[i] = std::clamp(at.separation.value, law.gaps()[0], law.gaps()[1]);
    }
    law.stiffness(p, k);
    law.at_gap(gap, p_of_gap, k_of_gap);
    for (Eigen::Index i = 0; i < count; ++i) {
        REQUIRE(test::relative_error(k[i], truth[static_cast<std::size_t>(i)]) <= law.relative_error());
        REQUIRE(test::relative_error(k_of_gap[i], truth[static_cast<std::size_t>(i)]) <= law.relative_error());
        REQUIRE(test::relative_error(p_of_gap[i], p[i]) <= law.relative_error());
    }
    for (const Eigen::Index first : {1, 2, 398, 400}) {
        Eigen::ArrayXd again(count - first), again_p(count - first);
        law.stiffness(p.tail(count - first), again);
        CHECK((again == k.tail(count - first)).all());
        law.at_gap(gap.tail(count - first), again_p, again);
        CHECK((again_p == p_of_gap.tail(count - first)).all());
        CHECK((again == k_of_gap.tail(count - first)).all());
    }
}

TEST_CASE("a batch refuses what the scalar calls refuse: outside, NaN, arrays of different sizes") {
    const auto contact = hertz();
    for (const OutsideRange outside : {OutsideRange::refuse, OutsideRange::clamp, OutsideRange::exact}) {
        const Law law = Law::compile(contact, {1e5, 1e8, outside});
        for (const Eigen::Index bad : {0, 6, 8, 9}) {  // in the first four, in the next, in the last
            Eigen::ArrayXd p = Eigen::ArrayXd::Constant(10, 3e6), gap = Eigen::ArrayXd::Constant(10, law.gap(3e6)),
                           k(10), q(10);
            for (const double value : {std::nan(""), -std::nan("")}) {
                p[bad] = gap[bad] = value;
                CHECK(test::refusal([&] { law.stiffness(p, k); }).find("nan") != std::string::npos);
                if (outside == OutsideRange::exact)
                    CHECK_FALSE(test::refusal([&] { law.at_gap(gap, q, k); }).empty());
                else
                    CHECK(test::refusal([&] { law.at_gap(gap, q, k); }).find("nan") != std::string::npos);
            }
            if (outside != OutsideRange::refuse) continue;
            p[bad] = 1.1e8;
            gap[bad] = 1;
            CHECK(test::refusal([&] { law.stiffness(p, k); }).starts_with("pressure = 110000000: must be between"));
            CHECK(test::refusal([&] { law.at_gap(gap, q, k); }).starts_with("gap = 1: must be between"));
        }
        Eigen::ArrayXd p = Eigen::ArrayXd::Constant(37, 3e6), wrong(3);
        CHECK(test::refusal([&] { law.stiffness(p, wrong); }).starts_with("batch: the arrays have 37 and 3 elements"));
    }
}

TEST_CASE("the gap of every pressure in the range is one that the law takes") {
    // of two tables, which differ in the last digits: an initial state at the end of the range is what a solver begins with
    for (const double low : {1e4, 1e5, 3.3e5, 7.7e6})
        for (const double ratio : {1.001, 2.0, 100.0, 12345.6}) {
            const Law law = Law::compile(hertz(), {low, low * ratio});
            for (const double p : {low, low * ratio, low * std::sqrt(ratio)})
                CHECK(test::relative_error(law.at_gap(law.gap(p)).pressure, p) < 100 * law.relative_error());
        }
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
    // the third line begins with the range of pressures: one power of 2 more has more pieces than the text
    std::string longer = text;
    const std::size_t line = longer.find('\n', longer.find('\n') + 1) + 1, second = longer.find(' ', line) + 1;
    longer.replace(second, longer.find(' ', second) - second, "1.8p+27");
    CHECK_FALSE(refused(longer).empty());
    longer.replace(second, longer.find(' ', second) - second, "1.8p+2");
    CHECK(refused(longer).find("contradicts itself") != std::string::npos);
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
    const RoughContact<float, HertzLaw<float>> contact(test::sand_blasted_fine.roughness<float>(),
                                                       PeakDensity<float>(0.5F, 1.0F), HertzLaw<float>{}, 112.6e9F);
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
