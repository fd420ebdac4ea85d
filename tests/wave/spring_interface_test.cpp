// SPDX-License-Identifier: BSD-3-Clause
// Reflection and stiffness of a spring interface against wider arithmetic, closed forms, energy and published values.
#include <fstiff/wave/spring_interface.hpp>
#include <fstiff/wave/uncertain_reflection.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/springs.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <type_traits>
#include <vector>

namespace spring_interface_test {

using fstiff::Impedances;

namespace {

using test::Wide, test::wide_reflection, test::wide_stiffness;

// Ratios of the impedances, from like media to a gas on steel; all have few binary digits.
const std::vector<double> ratios{1, 1 + 0x1p-20, 1.0625, 1.5, 2, 3, 37, 1e3, 1e5, 1e8};

template <class T>
Wide ulps(T computed, Wide truth) {
    return test::relative_error<Wide>(computed, truth) / std::numeric_limits<T>::epsilon();
}

template <class T>
Wide ulps(std::complex<T> computed, std::complex<Wide> truth) {
    return std::abs(std::complex<Wide>(computed.real(), computed.imag()) - truth) / std::abs(truth) /
           std::numeric_limits<T>::epsilon();
}

// x with only so many binary digits that the products of three such numbers are exact in Wide.
template <class T>
T few_digits(T x) {
    const T scale = std::ldexp(T(1), std::ilogb(x) - 18);
    return std::round(x / scale) * scale;
}

}  // namespace

TEMPLATE_TEST_CASE("the reflection keeps its stated accuracy over every stiffness and ratio of impedances",
                   "[ultrasound]", float, double) {
    using T = TestType;
    const T z = T(46.3e6), omega = T(4.4e7);
    Wide worst = 0, worst_complex = 0;
    for (const double ratio : ratios) {
        for (const auto& media : {Impedances<T>{z, z * T(ratio)}, Impedances<T>{z * T(ratio), z}}) {
            for (int i = -300; i <= 300; ++i) {
                const T k = z * omega * std::exp2(T(i) / 5);
                const std::complex<Wide> wave = wide_reflection(k, media.incident, media.beyond, omega);
                const Wide truth = std::abs(wave);
                worst = std::max(worst, ulps(fstiff::reflection(k, media, omega), truth));
                if (ratio == 1) worst = std::max(worst, ulps(fstiff::reflection(k, media.incident, omega), truth));
                const std::complex<Wide> passed = Wide(2) / (1 + Wide(media.beyond) / media.incident +
                                                             std::complex<Wide>(0, Wide(omega) * media.beyond / k));
                worst_complex =
                    std::max({worst_complex, ulps(fstiff::detail::complex_reflection(k, media, omega), wave),
                              ulps(fstiff::detail::complex_transmission(k, media, omega), passed)});
            }
        }
    }
    CAPTURE(worst, worst_complex);
    CHECK(worst <= fstiff::detail::spring_interface_ulps);
    CHECK(worst_complex <= fstiff::detail::spring_interface_ulps);
}

TEMPLATE_TEST_CASE("the transmitted energy is accurate where 1 - R^2 has no digits left", "[ultrasound]", float,
                   double) {
    using T = TestType;
    const T z = T(46.3e6), omega = T(4.4e7);
    Wide worst = 0;
    for (const double ratio : ratios) {
        for (int i = -300; i <= 300; ++i) {
            const Impedances<T> media{z, z * T(ratio)};
            const T k = z * omega * std::exp2(T(i) / 5);
            const Wide z1 = media.incident, z2 = media.beyond, x = Wide(omega) * z1 * z2 / k;
            const Wide truth = 4 * z1 * z2 / ((z1 + z2) * (z1 + z2) + x * x);
            if (truth > std::numeric_limits<T>::min())
                worst = std::max(worst, ulps(fstiff::detail::transmitted_energy(k, media, omega), truth));
        }
    }
    CAPTURE(worst);
    CHECK(worst <= fstiff::detail::spring_interface_ulps);
}

TEMPLATE_TEST_CASE("the stiffness keeps its stated accuracy between the welded joint and the open gap", "[ultrasound]",
                   float, double) {
    using T = TestType;
    const T omega = few_digits(T(4.4e7));
    Wide worst = 0;
    int samples = 0;
    for (const double ratio : ratios) {
        const T low = few_digits(T(1e6)), high = few_digits(T(1e6 * ratio));
        const Wide welded = (Wide(high) - low) / (Wide(high) + low);
        // R approaches both ends geometrically.
        for (int i = 1; i < 19; ++i) {
            for (const Wide exact :
                 {welded + (1 - welded) * std::exp2(Wide(-i)), 1 - (1 - welded) * std::exp2(Wide(-i))}) {
                const T r = few_digits(T(exact));
                if (!(r > welded && r < 1)) continue;
                ++samples;
                const Wide truth = wide_stiffness(r, low, high, omega);
                worst = std::max({worst, ulps(fstiff::stiffness_from_reflection(r, {low, high}, omega), truth),
                                  ulps(fstiff::stiffness_from_reflection(r, {high, low}, omega), truth)});
                if (ratio == 1) worst = std::max(worst, ulps(fstiff::stiffness_from_reflection(r, low, omega), truth));
            }
        }
    }
    CAPTURE(worst);
    CHECK(samples > 150);
    CHECK(worst <= fstiff::detail::spring_interface_ulps);
}

TEMPLATE_TEST_CASE("a reflection turned into a stiffness and back returns", "[ultrasound]", float, double) {
    using T = TestType;
    for (const double ratio : {1.0, 1.5, 37.0}) {
        const Impedances<T> media{T(46e6), T(46e6 * ratio)};
        const T welded = fstiff::detail::welded_reflection(media);
        for (int i = 1; i < 100; ++i) {
            const T r = welded + (1 - welded) * T(i) / 100;
            const T k = fstiff::stiffness_from_reflection(r, media, T(4.4e7));
            CAPTURE(ratio, r, k);
            // dR/R = -dK/K (1-R^2)(R^2-W^2)/(R^2 (1-W^2)): never amplified, so the two bounds add.
            CHECK(test::ulps(fstiff::reflection(k, media, T(4.4e7)), r) <= 2 * fstiff::detail::spring_interface_ulps);
        }
    }
}

TEMPLATE_TEST_CASE("Pythagorean stiffnesses give rational reflections", "[ultrasound]", float, double) {
    using T = TestType;
    // 2K/(omega z) = 3/4, 4/3, 5/12: |R| = 4/5, 3/5, 12/13. All arguments are exact.
    CHECK(test::ulps(fstiff::reflection(T(3), T(2), T(4)), T(4) / 5) <= 1);
    CHECK(test::ulps(fstiff::reflection(T(4), T(2), T(3)), T(3) / 5) <= 2);
    CHECK(test::ulps(fstiff::reflection(T(5), T(2), T(12)), T(12) / 13) <= 2);
    CHECK(test::ulps(fstiff::stiffness_from_reflection(T(5) / 8, T(2), T(4)), 4 * std::sqrt(T(39)) / 5) <= 4);
    // z1 = 3, z2 = 1, omega = 1, K = 1: R = (2+3i)/(4+3i), |R|^2 = 13/25; T = 6/(4+3i).
    const Impedances<T> unlike{3, 1};
    const auto r = fstiff::detail::complex_reflection(T(1), unlike, T(1));
    const auto t = fstiff::detail::complex_transmission(T(1), unlike, T(1));
    CHECK(test::ulps(r.real(), T(17) / 25) <= 4);
    CHECK(test::ulps(r.imag(), T(6) / 25) <= 4);
    CHECK(test::ulps(t.real(), T(24) / 25) <= 4);
    CHECK(test::ulps(t.imag(), -T(18) / 25) <= 4);
    CHECK(test::ulps(fstiff::reflection(T(1), unlike, T(1)), std::sqrt(T(13)) / 5) <= 2);
    CHECK(test::ulps(fstiff::detail::transmitted_energy(T(1), unlike, T(1)), T(12) / 25) <= 4);
    CHECK(test::ulps(fstiff::stiffness_from_reflection(std::sqrt(T(13)) / 5, unlike, T(1)), T(1)) <= 6);
}

TEMPLATE_TEST_CASE("energy, traction and the spring law hold for the complex amplitudes", "[ultrasound]", float,
                   double) {
    using T = TestType;
    using Complex = std::complex<T>;
    const T eps = std::numeric_limits<T>::epsilon(), omega = T(4.4e7);
    for (const double ratio : ratios) {
        for (const auto& media : {Impedances<T>{T(46e6), T(46e6 / ratio)}, Impedances<T>{T(46e6 / ratio), T(46e6)}}) {
            const T z1 = media.incident, z2 = media.beyond;
            for (int i = -60; i <= 60; ++i) {
                const T k = T(1e15) * std::exp2(T(i));
                const Complex r = fstiff::detail::complex_reflection(k, media, omega),
                              t = fstiff::detail::complex_transmission(k, media, omega);
                CAPTURE(ratio, z1, z2, k, r.real(), r.imag());
                CHECK(std::abs(std::norm(r) + z2 / z1 * std::norm(t) - 1) <= 16 * eps);
                CHECK(test::ulps(std::abs(r), fstiff::reflection(k, media, omega)) <= 12);
                CHECK(test::ulps(z2 / z1 * std::norm(t), fstiff::detail::transmitted_energy(k, media, omega)) <= 16);
                // Traction: z1 (1 - R) = z2 T. Jump: 1 + R = T (1 + i omega z2/K).
                CHECK(std::abs(z1 * (T(1) - r) - z2 * t) <= 16 * eps * (z1 + z2 * std::abs(t)));
                const Complex jump = t * Complex(1, omega * z2 / k);
                CHECK(std::abs(T(1) + r - jump) <= 16 * eps * (1 + std::abs(jump)));
            }
        }
    }
}

TEMPLATE_TEST_CASE("the limits are an open gap and a welded joint", "[ultrasound]", float, double) {
    using T = TestType;
    const T largest = std::numeric_limits<T>::max(), least = std::numeric_limits<T>::min();
    for (const double ratio : {1.0, 1.5, 37.0, 1e5}) {
        const Impedances<T> media{T(46e6), T(46e6) / T(ratio)};
        CAPTURE(ratio);
        CHECK(fstiff::reflection(T(0), media, T(4e7)) == 1);
        CHECK(fstiff::detail::complex_reflection(T(0), media, T(4e7)) == std::complex<T>(1, 0));
        CHECK(std::abs(fstiff::detail::complex_transmission(T(0), media, T(4e7))) == 0);
        CHECK(fstiff::detail::transmitted_energy(T(0), media, T(4e7)) == 0);
        CHECK(test::ulps(fstiff::detail::welded_reflection(media), T(ratio - 1) / T(ratio + 1)) <= 8);  // z2 is rounded
        CHECK(test::ulps(fstiff::reflection(largest, media, T(4e7)), fstiff::detail::welded_reflection(media)) <= 2);
        CHECK(std::isfinite(fstiff::reflection(least, media, least)));
    }
    CHECK(fstiff::reflection(largest, T(1), T(1)) <= 2 / largest);
    // Products and sums of impedances that T cannot hold.
    CHECK(test::ulps(fstiff::detail::welded_reflection(Impedances<T>{largest, largest / 3}), T(0.5)) <= 4);
    CHECK(test::ulps(fstiff::reflection(largest, {largest, largest}, T(2)), 1 / std::sqrt(T(2))) <= 4);
    CHECK(test::ulps(fstiff::stiffness_from_reflection(T(3) / 5, {largest / 4, largest / 4}, T(1)), largest / 6) <= 4);
}

TEST_CASE("steel at 7 MHz gives the published pairs of reflection and stiffness", "[ultrasound]") {
    const double z = fstiff::acoustic_impedance(7850.0, 5900.0), omega = fstiff::detail::angular_frequency(7e6);
    CHECK(test::relative_error(z, 46.315e6) < 1e-15);
    CHECK(test::relative_error(omega, 43982297.150257105) < 1e-15);
    // K in GPa/um, given to three or four digits: half a unit of the last digit is the tolerance.
    struct Row {
        double reflection, stiffness, half_unit;
    };
    for (const auto& row : {Row{0.99, 0.145, 5e-4}, {0.9, 0.493, 5e-4}, {0.5, 1.764, 5e-4}, {0.1, 10.13, 5e-3}}) {
        CAPTURE(row.reflection);
        CHECK(std::abs(fstiff::stiffness_from_reflection(row.reflection, z, omega) / 1e15 - row.stiffness) <=
              row.half_unit);
    }
}

TEST_CASE("the unit of length does not change the reflection", "[ultrasound]") {
    // Impedance is mass/(length^2 time), stiffness per area is mass/(length^2 time^2).
    const Impedances<double> media{46e6, 17e6};
    const double k = 1.7e15, omega = 4.4e7, r = fstiff::reflection(k, media, omega);
    for (const double unit : {1e9, 1e-9}) {
        const double scale = unit * unit;
        const Impedances<double> scaled{media.incident * scale, media.beyond * scale};
        CHECK(test::ulps(fstiff::reflection(k * scale, scaled, omega), r) <= 2 * fstiff::detail::spring_interface_ulps);
        CHECK(test::ulps(fstiff::stiffness_from_reflection(r, scaled, omega),
                         fstiff::stiffness_from_reflection(r, media, omega) * scale) <=
              4 * fstiff::detail::spring_interface_ulps);
    }
}

TEMPLATE_TEST_CASE("arguments out of range are refused by name", "[ultrasound]", float, double) {
    using T = TestType;
    using test::refusal;
    const T inf = std::numeric_limits<T>::infinity(), nan = std::numeric_limits<T>::quiet_NaN();
    const auto has = [](const std::string& text, const char* part) { return text.find(part) != std::string::npos; };
    for (const T bad : {T(-1), inf, -inf, nan}) {
        CAPTURE(bad);
        CHECK(has(refusal([&] { (void)fstiff::reflection(bad, T(1), T(1)); }), "stiffness = "));
        CHECK(has(refusal([&] { (void)fstiff::reflection(T(1), bad, T(1)); }), "impedance = "));
        CHECK(has(refusal([&] { (void)fstiff::reflection(T(1), Impedances<T>{1, bad}, T(1)); }), "impedance = "));
        CHECK(has(refusal([&] { (void)fstiff::reflection(T(1), T(1), bad); }), "angular_frequency = "));
        CHECK(has(refusal([&] { (void)fstiff::detail::transmitted_energy(bad, {1, 2}, T(1)); }), "stiffness = "));
        CHECK(has(refusal([&] { (void)fstiff::detail::complex_reflection(bad, {1, 2}, T(1)); }), "stiffness = "));
        CHECK(has(refusal([&] { (void)fstiff::detail::complex_transmission(T(1), {bad, 2}, T(1)); }), "impedance = "));
        CHECK(has(refusal([&] { (void)fstiff::detail::welded_reflection(Impedances<T>{bad, 2}); }), "impedance = "));
        CHECK(has(refusal([&] { (void)fstiff::stiffness_from_reflection(bad, T(1), T(1)); }), "reflection = "));
        CHECK(has(refusal([&] { (void)fstiff::stiffness_from_reflection(T(0.5), bad, T(1)); }), "impedance = "));
        CHECK(
            has(refusal([&] { (void)fstiff::stiffness_from_reflection(T(0.5), T(1), bad); }), "angular_frequency = "));
        CHECK(has(refusal([&] { (void)fstiff::acoustic_impedance(bad, T(1)); }), "density = "));
        CHECK(has(refusal([&] { (void)fstiff::acoustic_impedance(T(1), bad); }), "velocity = "));
        CHECK(has(refusal([&] { (void)fstiff::detail::angular_frequency(bad); }), "frequency = "));
    }
    CHECK(refusal([&] { (void)fstiff::reflection(T(1), T(0), T(1)); }) ==
          "impedance = 0: must be finite and greater than 0");
    CHECK(refusal([&] { (void)fstiff::stiffness_from_reflection(T(1), T(1), T(1)); }) ==
          "reflection = 1: must be greater than 0 and less than 1");
    CHECK(has(refusal([&] { (void)fstiff::stiffness_from_reflection(T(0), T(1), T(1)); }), "reflection = 0"));
    // 0.5 is the welded reflection of 3:1 exactly, and refused; the next number above is not.
    CHECK(has(refusal([&] { (void)fstiff::stiffness_from_reflection(T(0.5), {3, 1}, T(1)); }), "welded"));
    CHECK(has(refusal([&] { (void)fstiff::stiffness_from_reflection(T(0.25), {1, 3}, T(1)); }), "reflection = 0.25"));
    CHECK(fstiff::stiffness_from_reflection(std::nextafter(T(0.5), T(1)), {3, 1}, T(1)) > 0);
    CHECK(has(refusal([&] { (void)fstiff::stiffness_from_reflection(std::numeric_limits<T>::min(), T(1e9), T(1e9)); }),
              "reflection = "));
}

}  // namespace spring_interface_test
