// SPDX-License-Identifier: BSD-3-Clause
// One asperity of a fractal surface: each equation against its other form, wider arithmetic, a derivative.
#include <fstiff/asperity/fractal_asperity.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace fractal_asperity_test {

using fstiff::Fractal;
using fstiff::detail::AsperityFamily;
using fstiff::detail::FractalAsperity;

namespace {

using Wide = long double;
constexpr Wide pi = std::numbers::pi_v<Wide>;

// The equations as printed, powers of G and all: true only where Wide can hold G^((D-1)/(2-D)).
struct Printed {
    Wide d, g;
    Wide profile(Wide l, Wide x) const { return height(l) * std::cos(2 * pi * x / l); }        // (3.1)
    Wide height(Wide l) const { return std::pow(g, d - 1) * std::pow(l, 2 - d); }              // (3.2)
    Wide radius(Wide l) const { return std::pow(l, d) / (4 * pi * pi * std::pow(g, d - 1)); }  // (3.3)
    Wide base(Wide w, Wide q) const {
        return std::pow(w, 1 / (2 - d)) / (std::pow(g, (d - 1) / (2 - d)) * std::pow(q, 1 / (2 - d)));
    }                                    // (3.5)
    Wide radius(Wide w, Wide q) const {  // (3.6)
        return std::pow(w, d / (2 - d)) / (4 * pi * pi * std::pow(g, 2 * (d - 1) / (2 - d)) * std::pow(q, d / (2 - d)));
    }
    Wide load(Wide w, Wide q) const {  // (3.8)
        return 2 / (3 * pi) / (std::pow(g, (d - 1) / (2 - d)) * std::pow(q, d / (2 * (2 - d)))) *
               std::pow(w, (3 - d) / (2 - d));
    }
    Wide stiffness(Wide w, Wide q) const {  // (3.10)
        return 2 / (3 * pi) * (3 - d) / (2 - d) / (std::pow(g, (d - 1) / (2 - d)) * std::pow(q, d / (2 * (2 - d)))) *
               std::pow(w, 1 / (2 - d));
    }
    Wide area(Wide w, Wide q) const {  // (3.12)
        return q / (4 * pi) * std::pow(w, 2 / (2 - d)) /
               (std::pow(g, 2 * (d - 1) / (2 - d)) * std::pow(q, 2 / (2 - d)));
    }
};

template <class T>
Wide ulps(T computed, Wide truth) {
    return test::relative_error<Wide>(computed, truth) / std::numeric_limits<T>::epsilon();
}

// The bounds that the header states.
constexpr int asperity_bound = 4;
template <class T>
Wide family_bound(const Fractal<T>& f, T q, T w) {
    return (2 + std::abs(std::log(Wide(w) / (Wide(q) * f.roughness))) / 2) / (2 - Wide(f.dimension)) + 2;
}

template <class T>
const std::vector<Fractal<T>> surfaces{{T(1.62), T(1.2e-8)}, {T(1.58), T(1.1e-7)}, {T(1.7), T(8.2e-7)},
                                       {T(1.01), T(1e-8)},   {T(1.5), T(3e-5)},    {T(1.9), T(1e-6)}};

std::string part(const std::string& text, const char* wanted) {
    return text.find(wanted) == std::string::npos ? text + " lacks " + wanted : "";
}

}  // namespace

TEMPLATE_TEST_CASE("height and radius of an asperity are those of eqs. (3.2) and (3.3)", "[asperity]", float, double) {
    using T = TestType;
    for (const auto& f : surfaces<T>) {
        const Printed printed{f.dimension, f.roughness};
        for (T l = T(1e-9); l < T(1e-2); l *= T(1.7)) {
            const FractalAsperity<T> asperity(f, l);
            CAPTURE(f.dimension, f.roughness, l);
            CHECK(asperity.base_diameter() == l);
            CHECK(ulps(asperity.height(), printed.height(l)) <= asperity_bound);
            CHECK(ulps(asperity.radius(), printed.radius(l)) <= asperity_bound);
        }
    }
}

TEST_CASE("the radius of an asperity is the curvature of its profile", "[asperity]") {
    // Eighth-order central second difference of (3.1) in long double; h = l/100 leaves (2 pi/100)^8 / 3150 = 8e-14.
    const Wide weight[] = {-205.0L / 72, 8.0L / 5, -1.0L / 5, 8.0L / 315, -1.0L / 560};
    for (const auto& f : surfaces<double>) {
        const FractalAsperity<double> asperity(f, 2e-4);
        const Printed printed{f.dimension, f.roughness};
        const Wide l = asperity.base_diameter(), h = l / 100;
        Wide second = 0;
        for (int i = -4; i <= 4; ++i) second += weight[std::abs(i)] * printed.profile(l, Wide(i) * h);
        CHECK(test::relative_error<Wide>(asperity.radius(), -h * h / second) < 2e-13L);
        for (const double x : {0.0, 1e-6, 3e-5, 7e-5, 1e-4})
            CHECK(std::abs(asperity.profile(x) - printed.profile(l, x)) < 1e-15L * printed.height(l));
        CHECK(asperity.profile(0) == asperity.height());
        CHECK(test::ulps(asperity.profile(asperity.base_diameter() / 2), -asperity.height()) <= 1);
    }
}

TEMPLATE_TEST_CASE("the approach is what the truncation takes off the peak, and back", "[asperity]", float, double) {
    using T = TestType;
    const T eps = std::numeric_limits<T>::epsilon();
    for (const auto& f : surfaces<T>) {
        const FractalAsperity<T> asperity(f, T(1e-4));
        const T l = asperity.base_diameter();
        CHECK(asperity.approach(0) == 0);
        CHECK(test::ulps(asperity.approach(l / 2), asperity.height()) <= 4);  // omega = delta at half the base
        CHECK(test::ulps(asperity.approach(l), 2 * asperity.height()) <= 4);
        CHECK(test::ulps(asperity.approach(l / 3), asperity.height() / 2) <= 8);  // cos(pi/3) = 1/2
        CHECK(asperity.truncation_diameter(0) == 0);
        CHECK(test::relative_error(asperity.truncation_diameter(2 * asperity.height()), l) <= 2 * eps);
        for (int i = 1; i < 100; ++i) {
            const T cut = l * T(i) / 100, omega = asperity.approach(cut);
            CAPTURE(f.dimension, i);
            // z(l_t/2) of (3.1); its rounding is relative to delta, not to omega.
            CHECK(std::abs(asperity.height() - asperity.profile(cut / 2) - omega) <= 8 * eps * asperity.height());
            // d l_t/d omega grows without bound towards l_t = l.
            CHECK(test::relative_error(asperity.truncation_diameter(omega), cut) <= 8 * eps * (1 + 100 / T(100 - i)));
        }
        // Small truncations keep their digits, where 1 - cos has none: q = (pi l_t/l)^2/2 (1 - (pi l_t/l)^2/12...).
        const T small = std::sqrt(eps) / 64;
        CHECK(test::ulps(fstiff::detail::truncation_share(small * l, l), T(pi * pi / 2) * small * small) <= 8);
    }
}

TEMPLATE_TEST_CASE("the family at one q gives the printed powers of the approach", "[asperity]", float, double) {
    using T = TestType;
    Wide worst = 0;
    for (const auto& f : surfaces<T>) {
        const Printed printed{f.dimension, f.roughness};
        for (const T q : {T(1e-3), T(0.25), T(1), T(2)}) {
            const AsperityFamily<T> family(f, q);
            for (T l = T(3e-8); l < T(3e-3); l *= T(2.3)) {
                const T w = T(q * printed.height(l));
                CAPTURE(f.dimension, f.roughness, q, w);
                const Wide bound = family_bound(f, q, w);
                CHECK(ulps(family.base_diameter(w), printed.base(w, q)) <= bound);
                CHECK(ulps(family.radius(w), printed.radius(w, q)) <= 2 * bound);
                CHECK(ulps(family.load(w), printed.load(w, q)) <= bound);
                CHECK(ulps(family.stiffness(w), printed.stiffness(w, q)) <= bound);
                CHECK(ulps(family.area(w), printed.area(w, q)) <= 2 * bound);
                worst = std::max(worst, ulps(family.base_diameter(w), printed.base(w, q)) / bound);
            }
        }
    }
    CAPTURE(worst);
    CHECK(worst > 0.1L);  // the stated bound is not an empty one
}

TEMPLATE_TEST_CASE(
    "the family and the one asperity with a law agree: (3.8) is (3.7), (3.10) is (3.14) and (3.13), (3.12) is (3.11)",
    "[asperity]", float, double) {
    using T = TestType;
    for (const auto& f : surfaces<T>) {
        const fstiff::HertzLaw<T> hertz;
        const fstiff::FractalLaw<T> fractal(f.dimension);
        const fstiff::FractalConsistentLaw<T> consistent(f.dimension);
        for (const T q : {T(0.01), T(0.5), T(1), T(1.9)}) {
            const AsperityFamily<T> family(f, q);
            for (const T l : {T(1e-6), T(2e-5), T(1e-3)}) {
                const FractalAsperity<T> given(f, l);
                const T w = q * given.height();
                CAPTURE(f.dimension, q, l);
                const T bound = T(2 * family_bound(f, q, w) + asperity_bound);
                const auto asperity = family.asperity(w);
                CHECK(test::ulps(asperity.base_diameter(), l) <= bound);
                CHECK(test::ulps(family.radius(w), given.radius()) <= bound);
                CHECK(test::ulps(family.load(w), given.load(hertz, w)) <= bound);
                CHECK(test::ulps(family.load(w), given.load(fractal, w)) <= bound);
                CHECK(test::ulps(family.stiffness(w), given.stiffness(fractal, w)) <= bound);
                CHECK(test::ulps(family.stiffness(w), given.stiffness(consistent, w)) <= bound);
                CHECK(test::ulps(family.area(w), given.area(hertz, w)) <= bound);
                CHECK(test::ulps(fstiff::detail::fractal_stiffness_from_area(family.area(w), f.dimension),
                                 family.stiffness(w)) <= 8);
                CHECK(test::ulps(fstiff::detail::fractal_stiffness_from_area(given.area(fractal, w), f.dimension),
                                 given.stiffness(fractal, w)) <= 8);
                const T ratio = fstiff::detail::fractal_stiffness_factor(f.dimension);
                CHECK(test::ulps(given.load(consistent, w), ratio * given.load(hertz, w)) <= 6);
            }
        }
    }
}

TEST_CASE("k_n is the derivative of the load along the family, not of one asperity", "[asperity]") {
    // Eighth-order central difference in long double with steps of 1/200: truncation below 1e-13 for exponents up to 5.
    const auto derivative = [](const auto& f, Wide x) {
        const Wide h = x / 200;
        return (4 * (f(x + h) - f(x - h)) / 5 - (f(x + 2 * h) - f(x - 2 * h)) / 5 +
                4 * (f(x + 3 * h) - f(x - 3 * h)) / 105 - (f(x + 4 * h) - f(x - 4 * h)) / 280) /
               h;
    };
    for (const double d : {1.01, 1.3, 1.58, 1.62, 1.7}) {
        const Fractal<double> f{d, 1.2e-8};
        const Printed printed{d, f.roughness};
        const fstiff::HertzLaw<double> hertz;
        for (const double q : {0.1, 1.0, 2.0}) {
            const AsperityFamily<double> family(f, q);
            const double w = 3e-7;
            CAPTURE(d, q);
            const Wide along = derivative([&](Wide x) { return printed.load(x, q); }, w);
            CHECK(test::relative_error<Wide>(family.stiffness(w), along) < 1e-13L);
            const auto asperity = family.asperity(w);
            const Wide of_one =
                derivative([&](Wide x) { return 4 * x * std::sqrt(x * asperity.radius()) / 3; }, Wide(w) * 0.9L);
            CHECK(test::relative_error<Wide>(asperity.stiffness(hertz, w * 0.9), of_one) < 1e-13L);
            const Wide of_one_here = asperity.stiffness(hertz, w * (1 - 1e-15));
            CHECK(test::relative_error<Wide>(along / of_one_here, fstiff::detail::fractal_stiffness_factor(d)) <
                  1e-13L);
        }
    }
}

TEMPLATE_TEST_CASE("the unit of length changes nothing", "[asperity]", float, double) {
    using T = TestType;
    for (const T unit : {T(1e9), T(1e-9)}) {
        // A float holds areas of nanometre asperities in metres, but not their squares.
        for (const T d : {T(1.1), T(1.62), T(1.9)}) {
            const T g = T(1.2e-8), q = T(0.7), l = T(5e-5);
            const Fractal<T> f{d, g}, scaled{d, g * unit};
            const FractalAsperity<T> a(f, l), b(scaled, l * unit);
            const T w = q * a.height();
            const AsperityFamily<T> family(f, q), other(scaled, q);
            const T bound = T(2 * family_bound(f, q, w));
            CAPTURE(unit, d);
            CHECK(test::ulps(b.height(), a.height() * unit) <= 8);
            CHECK(test::ulps(b.radius(), a.radius() * unit) <= 8);
            CHECK(test::ulps(b.truncation_diameter(w * unit), a.truncation_diameter(w) * unit) <= 16);
            CHECK(test::ulps(other.base_diameter(w * unit), family.base_diameter(w) * unit) <= bound);
            CHECK(test::ulps(other.radius(w * unit), family.radius(w) * unit) <= 2 * bound);
            CHECK(test::ulps(other.stiffness(w * unit), family.stiffness(w) * unit) <= bound);
            CHECK(test::ulps(other.load(w * unit), family.load(w) * unit * unit) <= bound);
            CHECK(test::ulps(other.area(w * unit), family.area(w) * unit * unit) <= 2 * bound);
        }
    }
}

TEST_CASE("powers of G alone that a float cannot hold do no harm", "[asperity]") {
    // G^((D-1)/(2-D)) = (1.2e-8)^19 = 3e-151 at D = 1.95.
    const Fractal<float> f{1.95f, 1.2e-8f};
    const FractalAsperity<float> asperity(f, 1e-5f);
    const AsperityFamily<float> family(f, 0.5f);
    CHECK(test::relative_error(family.base_diameter(0.5f * asperity.height()), 1e-5f) < 2e-5f);
    CHECK(std::isfinite(family.load(0.5f * asperity.height())));
}

TEMPLATE_TEST_CASE("an asperity out of range is refused by name", "[asperity]", float, double) {
    using T = TestType;
    using test::refusal;
    const T inf = std::numeric_limits<T>::infinity(), nan = std::numeric_limits<T>::quiet_NaN();
    const Fractal<T> fine{T(1.62), T(1.2e-8)};
    for (const T bad : {T(1), T(2), T(0.5), T(2.5), inf, nan}) {
        CHECK(part(refusal([&] { FractalAsperity<T>({bad, T(1e-8)}, T(1e-4)); }), "fractal_dimension = ") == "");
        CHECK(part(refusal([&] { AsperityFamily<T>({bad, T(1e-8)}, T(1)); }), "between 1 and 2, both excluded") == "");
        CHECK(part(refusal([&] { (void)fstiff::detail::fractal_stiffness_from_area(T(1e-9), bad); }),
                   "fractal_dimension = ") == "");
    }
    for (const T bad : {T(0), T(-1), inf, -inf, nan}) {
        CAPTURE(bad);
        CHECK(part(refusal([&] { FractalAsperity<T>({T(1.62), bad}, T(1e-4)); }), "fractal_roughness = ") == "");
        CHECK(part(refusal([&] { FractalAsperity<T>(fine, bad); }), "base_diameter = ") == "");
        CHECK(part(refusal([&] { AsperityFamily<T>({T(1.62), bad}, T(1)); }), "fractal_roughness = ") == "");
        CHECK(part(refusal([&] { AsperityFamily<T>(fine, bad); }), "truncation_share = ") == "");
        CHECK(part(refusal([&] { (void)AsperityFamily<T>(fine, T(1)).load(bad); }), "approach = ") == "");
        CHECK(part(refusal([&] { (void)fstiff::detail::truncation_share(T(1), bad); }), "base_diameter = ") == "");
    }
    CHECK(part(refusal([&] { AsperityFamily<T>(fine, T(2.01)); }), "greater than 0 and at most 2") == "");
    const FractalAsperity<T> asperity(fine, T(1e-4));
    const T l = asperity.base_diameter(), delta = asperity.height();
    for (const T bad : {T(-1), inf, nan}) {
        CAPTURE(bad);
        CHECK(part(refusal([&] { (void)asperity.approach(bad); }), "truncation_diameter = ") == "");
        CHECK(part(refusal([&] { (void)asperity.truncation_diameter(bad); }), "approach = ") == "");
        CHECK(part(refusal([&] { (void)asperity.load(fstiff::HertzLaw<T>{}, bad); }), "approach = ") == "");
        CHECK(part(refusal([&] { (void)asperity.stiffness(fstiff::HertzLaw<T>{}, bad); }), "approach = ") == "");
        CHECK(part(refusal([&] { (void)asperity.area(fstiff::HertzLaw<T>{}, bad); }), "approach = ") == "");
        CHECK(part(refusal([&] { (void)fstiff::detail::fractal_stiffness_from_area(bad, T(1.5)); }), "area = ") == "");
        CHECK(part(refusal([&] { (void)asperity.profile(bad); }), "x = ") == "");
    }
    CHECK(part(refusal([&] { (void)asperity.approach(l * T(1.01)); }), "between 0 and the base diameter") == "");
    CHECK(part(refusal([&] { (void)asperity.load(fstiff::HertzLaw<T>{}, delta * T(2.01)); }),
               "twice the asperity height") == "");
    CHECK(refusal([&] { (void)asperity.load(fstiff::HertzLaw<T>{}, delta * 2); }) == "");
    // An approach whose asperity exceeds the range of the type: (1/G)^1000.
    const AsperityFamily<T> steep({T(1.9999), T(1e-8)}, T(1));
    CHECK(part(refusal([&] { (void)steep.base_diameter(T(1)); }), "range of the floating-point type") == "");
    CHECK(part(refusal([&] { (void)steep.base_diameter(T(1e-16)); }), "range of the floating-point type") == "");
}

}  // namespace fractal_asperity_test
