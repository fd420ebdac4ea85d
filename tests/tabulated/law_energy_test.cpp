// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/contact/greenwood_williamson.hpp>
#include <fstiff/contact/rough_contact.hpp>
#include <fstiff/peaks/single_radius.hpp>
#include <fstiff/tabulated/contact_law.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/paper.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace law_energy_test {

using namespace fstiff;

namespace {

using Law = ContactLaw<double>;
const Roughness<double> fine = test::sand_blasted_fine.roughness();
constexpr double modulus = 112.6e9;

/// Integral of p over d by the rule of Simpson on 20,000 parts, of p alone.
double integral(const Law& law, double from, double to) {
    constexpr int parts = 20000;
    const double h = (to - from) / parts;
    double sum = 0;
    for (int i = 0; i <= parts; ++i)
        sum += (i == 0 || i == parts ? 1 : i % 2 ? 4 : 2) * law.pressure_at_separation(from + i * h);
    return sum * h / 3;
}

}  // namespace

TEST_CASE("the energy of an exponential law is p^2/K") {
    const Law law = Law::tabulate(GreenwoodWilliamson<double>(fine, modulus, Heights::exponential),
                                  {1e4, 1e8, OutsideRange::extrapolate});
    for (const double p : {1e2, 1e4, 1e6, 1e8})  // the first of them below the range, where the law goes on so
        CHECK(test::relative_error(law.energy(law.separation(p)), p * p / law.stiffness(p)) < 1e-8);
}

TEST_CASE("energy is the integral of the pressure, within the range and on both sides of it, smooth or with kinks") {
    const RoughContact contact(fine, PeakDistribution<double>::exponential(std::numbers::pi / 3), HertzLaw<double>{},
                               modulus);
    const LawRange<double> range{1e5, 1e8, OutsideRange::extrapolate};
    const Law smooth = Law::tabulate(contact, range);
    const Law kinked = Law::tabulate_points(
        [&](double p) -> detail::LawPoint<double> {
            return {smooth.separation(p), smooth.stiffness(p)};
        },
        fine.rms_height, range);
    for (const Law& law : {smooth, kinked}) {
        const double far = law.separation(1e3), open = law.separation(3e5), closed = law.separation(5e7),
                     beyond = law.separation(2e8);
        for (const auto& [from, to] : {std::pair(open, far), {closed, open}, {beyond, closed}, {beyond, far}})
            CHECK(test::relative_error(law.energy(from) - law.energy(to), integral(law, from, to)) < 1e-8);
    }
    CHECK(test::relative_error(smooth.energy(smooth.separation(1e7)), kinked.energy(smooth.separation(1e7))) < 1e-3);
    CHECK(test::relative_error(Law::from_text(smooth.to_text()).energy(smooth.separation(1e7)),
                               smooth.energy(smooth.separation(1e7))) == 0);
}

TEST_CASE("a closure is counted from a preload, or from first touch") {
    const Law law = Law::tabulate(GreenwoodWilliamson<double>(fine, modulus), {1e5, 1e8, OutsideRange::extrapolate});
    CHECK(law.approach(1e7, 1e6) == law.separation(1e6) - law.separation(1e7));
    CHECK(law.approach(1e6, 1e6) == 0);
    const double end = law.separations()[1];  // the line through the loosest state of the range
    CHECK(test::relative_error((law.touch() - end) * law.slope_at_separation(end), 1e5) < 1e-8);
}

TEST_CASE("energy is refused where the law is") {
    const Law law = Law::tabulate(GreenwoodWilliamson<double>(fine, modulus), {1e5, 1e8});
    CHECK(test::refused_for("separation", [&] { (void)law.energy(law.separations()[1] * 1.01); }));
    CHECK(test::refused_for("separation", [&] { (void)law.energy(std::nan("")); }));
    CHECK(test::refused_for("separation", [&] {
        (void)law.with(OutsideRange::extrapolate).energy(-std::numeric_limits<double>::infinity());
    }));
    CHECK(test::refused_for("empty", [&] { (void)Law().energy(0); }));
    CHECK(test::refused_for("empty", [&] { (void)Law().touch(); }));
}

}  // namespace law_energy_test
