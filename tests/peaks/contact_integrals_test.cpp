// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/peaks/contact_integrals.hpp>

#include "support/accuracy.hpp"
#include "support/allocations.hpp"
#include "support/catch.hpp"
#include "support/table.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <numbers>
#include <string>
#include <vector>

namespace contact_integrals_test {

using fstiff::contact_integral;
using fstiff::contact_integrals;
using fstiff::Estimate;
using fstiff::PeakDistribution;
using fstiff::Quantity;
using fstiff::detail::ContactIntegrator;

namespace {

constexpr double pi = std::numbers::pi;

/// Margin outside of the error estimate: four units in the last place.
template <class T>
constexpr T floor_of_estimate = 4 * std::numeric_limits<T>::epsilon();

struct Point {
    double r, theta, eta;
};

}  // namespace

TEMPLATE_TEST_CASE("the tables of reference integrals, error estimate included", "", float, double) {
    using T = TestType;
    const bool is_float = sizeof(T) == sizeof(float);
    for (const char* name : {"integrals_plain.csv", "integrals_hard.csv"}) {
        const test::Table table(name);
        std::vector<T> ratios;
        T worst = 0;
        for (std::size_t row = 0; row < table.size(); ++row) {
            const auto number = [&](const char* column) { return static_cast<T>(table.input(row, column)); };
            // the tables hold exact doubles: r and theta are other numbers in float, and pi/2 - 1.5707 loses its digits
            if (is_float && (number("r") > T(0.99) || number("theta") > T(1.55))) continue;
            const T truth = static_cast<T>(table.number(row, "value"));
            if (truth < std::numeric_limits<T>::min()) continue;
            const auto j = contact_integral(number("a"), number("b"), PeakDistribution<T>(number("r"), number("theta")),
                                            number("eta"));
            const T error = test::relative_error(j.value, truth);
            INFO(name << " row " << row + 2 << ": value " << j.value << " error " << error << " estimate "
                      << j.error / truth);
            CHECK(std::isfinite(j.value));
            if (!is_float) CHECK(error <= std::max(j.error / truth, floor_of_estimate<T>));
            worst = std::max(worst, error);
            ratios.push_back(j.error / truth / std::max(error, std::numeric_limits<T>::epsilon()));
        }
        std::nth_element(ratios.begin(), ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2), ratios.end());
        INFO(name << " worst " << worst << " median estimate over error " << ratios[ratios.size() / 2]);
        // what contact_integrals.hpp states; in float the rounding of r, theta and eta counts: eta^2 eps at eta = 12
        CHECK(worst <= (is_float ? T(3e-5) : T(6e-15)));
        CHECK(ratios[ratios.size() / 2] <= 100);
    }
}

namespace {

/// A problem of the tables and its four integrals, over exp(-eta^2/2) for eta > 0.
struct Problem {
    PeakDistribution<double> peaks;
    double eta;
    std::array<long double, 4> truth;
};
const std::vector<Problem>& problems(const char* name) {
    static std::map<std::string, std::vector<Problem>> kept;
    std::vector<Problem>& all = kept[name];
    if (!all.empty()) return all;
    const test::Table table(name);
    const bool is_scaled = std::string(name) == "integrals_scaled.csv";
    for (std::size_t row = 0; row < table.size(); row += 4) {  // in the order of Problem::truth
        const double eta = table.input(row, "eta");
        Problem one{{table.input(row, "r"), table.input(row, "theta")}, eta, {}};
        const long double unit = is_scaled || eta < 0 ? 1.0L : std::exp(static_cast<long double>(eta) * eta / 2);
        for (std::size_t i = 0; i < 4; ++i) one.truth[i] = table.number(row + i, "value") * unit;
        all.push_back(one);
    }
    return all;
}
/// The same of all tables, where no truth is subnormal.
std::vector<Problem> all_problems() {
    std::vector<Problem> all;
    for (const char* name : {"integrals_plain.csv", "integrals_hard.csv", "integrals_scaled.csv"})
        for (const Problem& one : problems(name))
            if (*std::min_element(one.truth.begin(), one.truth.end()) > 0) all.push_back(one);
    return all;
}

std::array<Estimate<double>, 4> scaled(const Problem& of, double tolerance) {
    const auto j = ContactIntegrator<double>(of.peaks, Quantity::all, {tolerance})(of.eta);
    return {j.contacts, j.stiffness, j.load, j.area};
}

}  // namespace

TEST_CASE("the estimate covers the error in every regime, at every tolerance") {
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    for (const double tolerance : {1e-3, 1e-6, 1e-9, 1e-12, 2.3e-14, 50 * epsilon})
        for (const Problem& of : all_problems()) {
            if (of.eta > 50) continue;  // see below
            const auto fast = scaled(of, tolerance);
            for (std::size_t i = 0; i < 4; ++i) {
                const auto error = static_cast<double>(test::relative_error<long double>(fast[i].value, of.truth[i]));
                INFO("r " << of.peaks.r() << " theta " << of.peaks.theta() << " eta " << of.eta << " tolerance "
                          << tolerance << ": " << i);
                CHECK(error <= std::max(fast[i].error / fast[i].value, floor_of_estimate<double>));
                CHECK(error <= std::max(3 * tolerance, 1e-13));
            }
        }
}

TEST_CASE(
    "far above the surface, where the rounding of eta rules, the estimate covers it and is not a hundred times too "
    "large") {
    // At a separation eta the exponent z = (t - r eta)/c inherits the rounding of numbers of the size of eta: the value
    // is wrong by a part of eta epsilon, while the rule itself is right to the tolerance, 50 epsilon.
    std::map<double, double> largest;  // error over estimate
    for (const Problem& of : problems("integrals_scaled.csv")) {
        if (of.eta < 50) continue;
        const auto fast = scaled(of, 50 * std::numeric_limits<double>::epsilon());
        for (std::size_t i = 0; i < 4; ++i) {
            const auto error = static_cast<double>(std::abs(fast[i].value - of.truth[i]));
            INFO("r " << of.peaks.r() << " theta " << of.peaks.theta() << " eta " << of.eta);
            CHECK(error <= fast[i].error);
            largest[of.eta] = std::max(largest[of.eta], error / fast[i].error);
        }
    }
    CHECK(largest.size() == 4);
    for (const auto& [eta, ratio] : largest) {
        CAPTURE(eta, ratio);
        CHECK(ratio > 0.01);  // so that an estimate cut to 1 % fails above
    }
}

TEST_CASE("identities: derivative, normalisation, independence at r = 0") {
    SECTION("dJ[3/2,-1/2]/deta = -1.5 J[1/2,-1/2]") {
        for (const Point& p : {Point{0.3, 1, -2}, Point{0.8, 0.9, 1.5}, Point{0.999, 1.3, 0.7}, Point{0.5, 1.57, 3}}) {
            const PeakDistribution<double> peaks(p.r, p.theta);
            const auto at = [&](double eta) { return contact_integral(1.5, -0.5, peaks, eta).value; };
            const double h = 0x1p-8, eta = p.eta;  // six-point formula: error h^6/140 f^(7), rounding 1e-15/h
            const double derivative = (45 * (at(eta + h) - at(eta - h)) - 9 * (at(eta + 2 * h) - at(eta - 2 * h)) +
                                       (at(eta + 3 * h) - at(eta - 3 * h))) /
                                      (60 * h);
            INFO("r " << p.r << " theta " << p.theta << " eta " << p.eta);
            CHECK(test::relative_error(derivative, -1.5 * contact_integral(0.5, -0.5, peaks, eta).value) < 1e-11);
        }
    }
    SECTION("all peaks stand above a separation of -30") {
        for (const double theta : {1e-3, 0.8, 1.5})
            CHECK(test::ulps(contact_integral(0.0, 0.0, PeakDistribution<double>(0.6, theta), -30.0).value, 1.0) <= 8);
    }
    SECTION("height and curvature are independent at r = 0: J = E t^b F_a(eta)/sqrt(2 pi)") {
        const PeakDistribution<double> peaks(0, 1.1);
        for (const double eta : {-4.0, 0.0, 2.0, 30.0}) {
            const auto ratio = [&](double e) {
                return contact_integral(0.5, -0.5, peaks, e).value / fstiff::math::gaussian_moment(0.5, e);
            };
            CHECK(test::ulps(ratio(eta), ratio(1.0)) <= 40);
            CHECK(test::ulps(contact_integral(0.0, 0.0, peaks, eta).value,
                             fstiff::math::gaussian_moment(0.0, eta) / std::sqrt(2 * pi)) <= 40);
        }
    }
    SECTION("the mean of 1/t at r = 0 is sqrt(2 pi)/(2 theta) asinh(tan theta)") {
        for (const double theta : {1e-4, 0.9, 1.57}) {
            const double mean_inverse = std::sqrt(2 * pi) / (2 * theta) * std::asinh(std::tan(theta));
            const double area = contact_integral(1.0, -1.0, PeakDistribution<double>(0, theta), -40.0).value;
            CHECK(test::relative_error(area, 40 * mean_inverse) < 1e-14);
        }
    }
}

TEST_CASE("regimes agree at their seams") {
    // the same problem by two rules, each at its own step, where visit_nodes changes from one to the other
    using namespace fstiff::detail;
    const auto agree = [](double r, double theta, double eta) {
        const PeakProblem<double> problem(PeakDistribution<double>(r, theta), eta, 36);
        const auto sums = [&](auto visit, double step) {
            PeakAccumulator<double> accumulator(problem, {0, 1, 2, 1}, 0);
            step = visit(problem, step, accumulator);
            return accumulator.result(step);
        };
        using Sums = PeakAccumulator<double>;
        const auto graded = sums(visit_graded<double, Sums>, 0.04);
        const bool clear = r * eta / problem.c > problem.reach;
        const auto other = clear ? sums(visit_separated<double, Sums>, 0.07) : sums(visit_smooth<double, Sums>, 0.08);
        for (std::size_t i = 0; i < 4; ++i) {
            INFO("r " << r << " theta " << theta << " eta " << eta << " a " << 0.5 * double(i));
            CHECK(test::relative_error(other.value[i], graded.value[i]) < 2e-14);
        }
    };
    for (const double theta : {0.01, 0.8, 1.3}) {
        for (const double r : {0.0, 0.5, 0.9}) agree(r, theta, 0.5);
        for (const double r : {0.5, 0.9, 0.999}) agree(r, theta, 9.6 * std::sqrt(1 - r * r) / r);
    }
    // and across the seam from both sides: nothing jumps by more than the errors
    for (const double r : {0.5, 0.9, 0.999999}) {
        const PeakDistribution<double> peaks(r, 1.2);
        const double seam = (std::sqrt(2 * (-std::log(2.3e-14) + 5)) + 1) * std::sqrt((1 - r) * (1 + r)) / r;
        const auto below = contact_integral(0.5, -0.5, peaks, seam * (1 - 1e-12));
        const auto above = contact_integral(0.5, -0.5, peaks, seam * (1 + 1e-12));
        const double slope = contact_integral(0.0, 0.0, peaks, seam).value;  // of the order of the derivative
        CHECK(std::abs(below.value - above.value) <= below.error + above.error + 10 * 2e-12 * seam * slope);
    }
}

TEST_CASE("quantities together equal each alone and those not requested are 0") {
    const PeakDistribution<double> peaks(0.7, 1);
    const auto together = contact_integrals(peaks, 1.3);
    CHECK(together.load.value == contact_integrals(peaks, 1.3, Quantity::pressure).load.value);
    CHECK(together.stiffness.value == contact_integral(0.5, -0.5, peaks, 1.3).value);
    CHECK(together.area.value == contact_integral(1.0, -1.0, peaks, 1.3).value);
    CHECK(together.contacts.value == contact_integral(0.0, 0.0, peaks, 1.3).value);
    const auto one = contact_integrals(peaks, 1.3, Quantity::stiffness);
    CHECK(one.load.value == 0);
    CHECK(one.load.evaluations == 0);
    CHECK(one.stiffness.evaluations > 0);
    CHECK(contact_integrals(peaks, 1.3, Quantity::none).area.value == 0);
}

TEST_CASE("an integrator gives the value of a single call at every separation") {
    for (const Problem& of : problems("integrals_scaled.csv")) {
        for (const double tolerance : {1e-3, 1e-12}) {
            ContactIntegrator<double> integrate(of.peaks, Quantity::all, {tolerance});
            for (const double eta : {of.eta, of.eta + 0.01, -1.0, 0.5, 2.0, 0.7, 30.0, of.eta}) {
                const auto one = ContactIntegrator<double>(of.peaks, Quantity::all, {tolerance})(eta);
                const auto many = integrate(eta);
                CHECK(many.load.value == one.load.value);  // bit for bit: the same operations
                CHECK(many.area.value == one.area.value);
                CHECK(many.contacts.error == one.contacts.error);
                CHECK(many.log_scale == one.log_scale);
            }
        }
    }
}

TEST_CASE("a loose tolerance is several times cheaper") {
    const PeakDistribution<double> peaks(0.5, 1);
    const int fine = contact_integrals(peaks, 1.0, Quantity::all, {1e-12}).load.evaluations;
    const int coarse = contact_integrals(peaks, 1.0, Quantity::all, {1e-3}).load.evaluations;
    CHECK(2 * coarse <= fine);
    CHECK(fine <= 48);
}

TEMPLATE_TEST_CASE("the far tail underflows to 0 and its logarithm goes on", "", float, double) {
    using T = TestType;
    const PeakDistribution<T> peaks(T(0.5), T(1));
    for (const T eta : {T(10), T(60), T(1e3), T(1e6)}) {
        const auto j = contact_integral(T(0.5), T(-0.5), peaks, eta);
        CHECK(j.value >= 0);
        CHECK(std::isfinite(j.error));
        const auto scaled = ContactIntegrator<T>(peaks, Quantity::stiffness)(eta);
        const T log = std::log(scaled.stiffness.value) + scaled.log_scale;
        CHECK(std::isfinite(log));
        if (j.value > std::numeric_limits<T>::min())
            CHECK(std::abs(std::exp(log) / j.value - 1) <=
                  scaled.stiffness.error / scaled.stiffness.value +
                      (100 + 2 * std::abs(log)) * std::numeric_limits<T>::epsilon());
        // log J = -eta^2/2 - O(log eta)
        CHECK(std::abs(log + eta * eta / 2) <= 5 * std::log(eta) + 4 * std::numeric_limits<T>::epsilon() * eta * eta);
    }
    CHECK(contact_integral(T(1.5), T(-0.5), peaks, T(1e6)).value == 0);
    CHECK(std::isfinite(contact_integral(T(1.5), T(-0.5), peaks, T(-1e6)).value));
}

TEMPLATE_TEST_CASE("no value is NaN or infinite or negative anywhere", "", float, double) {
    using T = TestType;
    const T tiny = std::numeric_limits<T>::min(), one_less = 1 - std::numeric_limits<T>::epsilon();
    const T half_pi = std::nextafter(std::numbers::pi_v<T> / 2, T(0));
    for (const T r : {T(0), tiny, T(0.3), T(0.9999), one_less})
        for (const T theta : {tiny, T(1e-6), T(0.8), T(1.57), half_pi})
            for (const T eta : {T(-1e6), T(-1000), T(-1), -tiny, T(0), tiny, T(1e-4), T(1), T(12), T(40), T(1e6)}) {
                const auto j = contact_integrals(PeakDistribution<T>(r, theta), eta);
                for (const auto& e : {j.contacts, j.load, j.stiffness, j.area}) {
                    INFO("r " << r << " theta " << theta << " eta " << eta << " value " << e.value << " error "
                              << e.error);
                    CHECK((e.value >= 0 && std::isfinite(e.value)));
                    CHECK((e.error >= 0 && std::isfinite(e.error)));
                }
            }
}

TEST_CASE("an evaluation does not allocate") {
    const PeakDistribution<double> peaks(0.5, 1);
    static_cast<void>(contact_integrals(peaks, 0.3));  // tables are made on first use, without the heap too
    const long before = test::allocations();
    double sum = 0;
    for (const double eta : {-50.0, 0.0, 3.0, 20.0}) sum += contact_integrals(peaks, eta).load.value;
    sum += contact_integral(0.5, -0.5, PeakDistribution<double>(0.99999, 1.5), 0.001).value;
    CHECK(test::allocations() == before);
    CHECK(sum > 0);
}

TEST_CASE("bad arguments are refused by name, value and range") {
    const PeakDistribution<double> peaks(0.5, 1);
    const auto refused = [&](double a, double b, double eta, double tolerance) {
        return test::refusal([&] { static_cast<void>(contact_integral(a, b, peaks, eta, {tolerance})); });
    };
    CHECK(refused(0.25, 0, 1, 1e-10) == "a = 0.25: must be 0, 1/2, 1 or 3/2");
    CHECK(refused(0.5, 1, 1, 1e-10) == "b = 1: must be 0, -1/2 or -1");
    CHECK(refused(0.5, 0, std::nan(""), 1e-10).starts_with("eta = nan: must be"));
    CHECK(refused(0.5, 0, 1e7, 1e-10).starts_with("eta = 10000000: must be"));
    CHECK(refused(0.5, 0, 1, 0).starts_with("relative_tolerance = 0: must be"));
    CHECK(refused(0.5, 0, 1, 0.5).starts_with("relative_tolerance = 0.5: must be"));
}

}  // namespace contact_integrals_test
