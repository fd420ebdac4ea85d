// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/math/random.hpp>
#include <fstiff/measure/uncertain_surface.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <numbers>

namespace uncertain_surface_test {

using namespace fstiff;

namespace {

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();
constexpr double pi = std::numbers::pi;
using Draw = std::array<double, detail::surface_parameter_count>;

std::size_t place(Parameter which) { return static_cast<std::size_t>(which); }

/// The parameter \p i of \p s, which is known.
auto& at(auto& s, std::size_t i) { return *s.find(static_cast<Parameter>(i)); }

/// All parameters, errors of 5 %, too small to reach the ends of the ranges, and a correlation of each kind.
SurfaceParameters<double> surface() {
    SurfaceParameters<double> s;
    s.set(Parameter::rms_height, {1e-6, 5e-8});
    s.set(Parameter::peak_radius, {2e-5, 4e-6});
    s.set(Parameter::peak_density, {3e9, 1.5e9});
    s.set(Parameter::fractal_dimension, {1.4, 0.05});
    s.set(Parameter::r, {0.5, 0.03});
    s.set(Parameter::theta, {0.9, 0.04});
    const auto correlate = [&](Parameter a, Parameter b, double c) {
        s.correlation[place(a)][place(b)] = s.correlation[place(b)][place(a)] = c;
    };
    correlate(Parameter::rms_height, Parameter::r, -0.7);
    correlate(Parameter::peak_radius, Parameter::peak_density, -0.9);
    correlate(Parameter::peak_density, Parameter::theta, 0.3);
    return s;
}

std::vector<Draw> draws(const SurfaceParameters<double>& s, int count, std::uint64_t seed = 1) {
    detail::SurfaceSampler<double> sample(s, seed);
    std::vector<Draw> all;
    for (int k = 0; k < count; ++k) all.push_back(sample());
    return all;
}

/// Normal variables of a draw: ln of sigma, R, D_p; the others themselves.
double normal_part(const Draw& draw, std::size_t i) {
    return i < place(Parameter::fractal_dimension) ? std::log(draw[i]) : draw[i];
}

struct Moments {
    Draw mean{}, deviation{};
    std::array<Draw, detail::surface_parameter_count> correlation{};
};

template <class Of>
Moments moments(const std::vector<Draw>& all, const Of& of) {
    Moments m;
    const auto count = static_cast<double>(all.size());
    for (std::size_t i = 0; i < detail::surface_parameter_count; ++i) {
        for (const auto& draw : all) m.mean[i] += of(draw, i) / count;
        for (const auto& draw : all) m.deviation[i] += std::pow(of(draw, i) - m.mean[i], 2) / (count - 1);
        m.deviation[i] = std::sqrt(m.deviation[i]);
    }
    for (std::size_t i = 0; i < detail::surface_parameter_count; ++i)
        for (std::size_t j = 0; j < detail::surface_parameter_count; ++j)
            for (const auto& draw : all)
                m.correlation[i][j] += (of(draw, i) - m.mean[i]) * (of(draw, j) - m.mean[j]) / m.deviation[i] /
                                       m.deviation[j] / (count - 1);
    return m;
}

std::string refusal_of(const SurfaceParameters<double>& s) {
    return test::refusal([&] { (void)detail::SurfaceSampler<double>(s, 1); });
}

}  // namespace

TEST_CASE("The same seed draws the same surfaces") {
    const auto a = draws(surface(), 20, 7), b = draws(surface(), 20, 7), c = draws(surface(), 20, 8);
    CHECK(a == b);
    for (std::size_t k = 0; k < a.size(); ++k) {
        CHECK(a[k] != c[k]);
        if (k > 0) CHECK(a[k] != a[k - 1]);
    }
}

TEST_CASE("Many draws have the values, the errors and the correlation that were given") {
    const int count = 40000;
    const double root = std::sqrt(count);
    const auto s = surface();
    const auto all = draws(s, count);
    const auto m = moments(all, normal_part);
    for (std::size_t i = 0; i < detail::surface_parameter_count; ++i) {
        const double relative = at(s, i).error / at(s, i).value;
        const bool log = i < place(Parameter::fractal_dimension);
        const double centre = log ? std::log(at(s, i).value) : at(s, i).value;
        const double spread = log ? std::sqrt(std::log(1 + relative * relative)) : at(s, i).error;
        CAPTURE(i);
        // four standard errors of a mean, of a standard deviation and of a correlation of that many normal numbers
        CHECK(std::abs(m.mean[i] - centre) <= 4 * spread / root);
        CHECK(std::abs(m.deviation[i] / spread - 1) <= 4 / (root * std::sqrt(2.0)));
        for (std::size_t j = 0; j < detail::surface_parameter_count; ++j) {
            const double c = s.correlation[i][j];
            CAPTURE(j, m.correlation[i][j], c);
            CHECK(std::abs(m.correlation[i][j] - c) <= 4 * (1 - c * c) / root + 1e-12);
        }
        // normal: shares within one and two standard deviations
        double one = 0, two = 0;
        for (const auto& draw : all) {
            const double z = std::abs(normal_part(draw, i) - centre) / spread;
            one += z <= 1 ? 1.0 / count : 0, two += z <= 2 ? 1.0 / count : 0;
        }
        CHECK(std::abs(one - std::erf(1 / std::sqrt(2.0))) <= 4 * 0.47 / root);
        CHECK(std::abs(two - std::erf(std::sqrt(2.0))) <= 4 * 0.21 / root);
    }
    // of the values themselves, lognormal: median v, mean v sqrt(1 + q), deviation e sqrt(1 + q), q = (e/v)^2
    const auto plain = moments(all, [](const Draw& draw, std::size_t i) { return draw[i]; });
    for (std::size_t i = 0; i < place(Parameter::fractal_dimension); ++i) {
        const double growth = std::sqrt(1 + std::pow(at(s, i).error / at(s, i).value, 2));
        CHECK(std::abs(plain.mean[i] - at(s, i).value * growth) <= 4 * at(s, i).error * growth / root);
        // at an error of half the value the fourth moment is 17 times that of a normal number
        CHECK(test::relative_error(plain.deviation[i], at(s, i).error * growth) <= 0.04);
    }
}

TEST_CASE("Draws stay in the range of every parameter, however large the errors") {
    auto s = surface();
    at(s, place(Parameter::fractal_dimension)).value = 1.02;
    at(s, place(Parameter::r)).value = 0.0;
    at(s, place(Parameter::theta)).value = 1.5;
    s.correlation = detail::uncorrelated<double>();
    for (std::size_t i = 0; i < detail::surface_parameter_count; ++i) at(s, i).error = i < 3 ? 5 * at(s, i).value : 0.5;
    bool inside = true;
    double less = 0, below = 0;
    const int count = 20000;
    const auto all = draws(s, count);
    for (const auto& draw : all) {
        for (std::size_t i = 0; i < detail::surface_parameter_count; ++i)
            inside = inside && detail::parameter_in_range(static_cast<Parameter>(i), draw[i]) && std::isfinite(draw[i]);
        less += draw[place(Parameter::r)] < 0.5 ? 1.0 / count : 0;
        below += draw[0] < at(s, 0).value ? 1.0 / count : 0;
    }
    CHECK(inside);
    // cut, not folded or pressed to the border: r is half a normal number of deviation 0.5 below 1
    CHECK(std::abs(less - std::erf(1 / std::sqrt(2.0)) / std::erf(2 / std::sqrt(2.0))) <= 4 * 0.47 / std::sqrt(count));
    CHECK(std::abs(below - 0.5) <= 4 * 0.5 / std::sqrt(count));  // the median stays
}

TEST_CASE("Errors of 0 give the values and unknown ones stay 0") {
    auto s = surface();
    for (std::size_t i = 0; i < detail::surface_parameter_count; ++i) at(s, i).error = 0;
    for (const auto& draw : draws(s, 10)) CHECK(draw == s.values());
    s = surface();
    at(s, place(Parameter::peak_radius)).error = 0;
    s.r.reset(), s.theta.reset();
    s.correlation[place(Parameter::r)][place(Parameter::rms_height)] = nan_value;  // nobody asks
    for (const auto& draw : draws(s, 10)) {
        CHECK(draw[place(Parameter::peak_radius)] == 2e-5);
        CHECK(draw[place(Parameter::rms_height)] != 1e-6);
        CHECK(draw[place(Parameter::r)] == 0);
        CHECK(draw[place(Parameter::theta)] == 0);
    }
}

TEST_CASE("Errors that are wholly correlated move together") {
    auto s = surface();
    s.correlation = detail::uncorrelated<double>();
    s.correlation[0][1] = s.correlation[1][0] = 1;
    s.correlation[3][4] = s.correlation[4][3] = -1;
    for (const auto& draw : draws(s, 100)) {
        const auto z = [&](std::size_t i) {
            const auto [value, error] = at(s, i);
            return i < 3 ? std::log(draw[i] / value) / std::sqrt(std::log1p(std::pow(error / value, 2)))
                         : (draw[i] - value) / error;
        };
        // the root of rounding, 1e-16, is all that an eigenvalue of 0 may leave
        CHECK(std::abs(z(0) - z(1)) <= 1e-6);
        CHECK(std::abs(z(3) + z(4)) <= 1e-6);
    }
    // a matrix printed with three digits that is not quite positive semidefinite is still no correlation
    s.correlation[0][2] = s.correlation[2][0] = 0.001;
    CHECK(refusal_of(s).find("least eigenvalue of the correlation = -") == 0);
    s.correlation[0][2] = s.correlation[2][0] = 1e-10;
    CHECK(refusal_of(s).empty());
}

TEST_CASE("The unit of length leaves the draws alone") {
    const double unit = GENERATE(0x1p30, 1e9, 1e-9);
    auto there = surface();
    for (const auto& [i, by] : {std::pair{0, unit}, std::pair{1, unit}, std::pair{2, 1 / unit / unit}}) {
        at(there, static_cast<std::size_t>(i)).value *= by;
        at(there, static_cast<std::size_t>(i)).error *= by;
    }
    const auto a = draws(surface(), 20), b = draws(there, 20);
    for (std::size_t k = 0; k < a.size(); ++k) {
        CHECK(test::relative_error(b[k][0] / unit, a[k][0]) <= (unit == 0x1p30 ? 0 : 1e-12));
        CHECK(test::relative_error(b[k][2] * unit * unit, a[k][2]) <= (unit == 0x1p30 ? 0 : 1e-12));
        CHECK(a[k][4] == b[k][4]);
    }
}

TEST_CASE("Surfaces that cannot be sampled are refused in a sentence") {
    const auto with = [](auto change) {
        auto s = surface();
        change(s);
        return refusal_of(s);
    };
    CHECK(refusal_of(surface()).empty());
    const std::string positive = "must be finite and greater than 0";
    const std::string dimension = "must be between 1 and 2, both excluded";
    CHECK(with([](auto& s) { at(s, 0).value = 0; }) == "rms_height = 0: " + positive);
    CHECK(with([](auto& s) { at(s, 1).value = -2e-5; }) == "peak_radius = -2e-05: " + positive);
    CHECK(with([](auto& s) { at(s, 2).value = std::numeric_limits<double>::infinity(); }) ==
          "peak_density = inf: " + positive);
    CHECK(with([](auto& s) { at(s, 3).value = 1; }) == "fractal_dimension = 1: " + dimension);
    CHECK(with([](auto& s) { at(s, 3).value = nan_value; }) == "fractal_dimension = nan: " + dimension);
    CHECK(with([](auto& s) { at(s, 4).value = 1; }) == "r = 1: must be at least 0 and less than 1");
    CHECK(with([](auto& s) { at(s, 5).value = 1.6; }) == "theta = 1.6: must be between 0 and pi/2, both excluded");
    CHECK(with([](auto& s) { at(s, 0).error = -1e-9; }) ==
          "rms_height error = -1e-09: must be finite and not negative");
    CHECK(with([](auto& s) { at(s, 4).error = nan_value; }) == "r error = nan: must be finite and not negative");
    CHECK(with([](auto& s) { at(s, 5).error = std::numeric_limits<double>::infinity(); }) ==
          "theta error = inf: must be finite and not negative");
    CHECK(with([](auto& s) { s.correlation[0][1] = s.correlation[1][0] = 1.1; }) ==
          "correlation = 1.1: must be symmetric, between -1 and 1");
    CHECK(with([](auto& s) { s.correlation[0][1] = 0.5; }) == "correlation = 0.5: must be symmetric, between -1 and 1");
    CHECK(with([](auto& s) { s.correlation[2][3] = s.correlation[3][2] = nan_value; }) ==
          "correlation = nan: must be symmetric, between -1 and 1");
    CHECK(with([](auto& s) { s.correlation[2][2] = 0.9; }) ==
          "correlation of a parameter with itself = 0.9: must be 1");
    // the first goes with the second, the second with the third, but the first against the third
    const std::string sentence = with([](auto& s) {
        s.correlation = detail::uncorrelated<double>();
        for (const auto& [i, j, c] : {std::tuple{0u, 1u, 0.9}, std::tuple{1u, 2u, 0.9}, std::tuple{0u, 2u, -0.9}})
            s.correlation[i][j] = s.correlation[j][i] = c;
    });
    CHECK(sentence.find("least eigenvalue of the correlation = -0.") == 0);  // 1 - 2 * 0.9, but for rounding

    auto s = surface();  // so wide that hardly a draw lies between 1 and 2
    at(s, 3).error = 1e9;
    detail::SurfaceSampler<double> sample(s, 1);
    CHECK(test::refusal([&] { (void)sample(); }) ==
          "errors so large that 1000 draws in a row leave the range of D, r or theta: must be smaller");
    s = surface();  // a spread of e^1000
    at(s, 0).error = 1e300;
    at(s, 0).value = 1e-300;
    detail::SurfaceSampler<double> wide(s, 1);
    for (int k = 0; k < 100; ++k) {
        Draw draw{};
        if (const auto why = test::refusal([&] { draw = wide(); }); why.empty())
            CHECK((std::isfinite(draw[0]) && draw[0] > 0));
        else
            CHECK(why.find("errors so large") == 0);
    }
}

TEST_CASE("A surface has its parameters by name and by Parameter") {
    SurfaceParameters<double> found;
    found.rms_height = {1e-6, 1e-7};
    found.peak_radius = {2e-5, 2e-6};
    found.peak_density = {3e9, 3e8};
    found.theta = {0.5, 0.01};
    found.correlation[1][2] = found.correlation[2][1] = -0.4;
    CHECK(found.values() == Draw{1e-6, 2e-5, 3e9, 0, 0, 0.5});
    CHECK(found.find(Parameter::theta) == &*found.theta);
    CHECK(found.find(Parameter::peak_radius) == &found.peak_radius);
    for (const Parameter which : {Parameter::fractal_dimension, Parameter::r, Parameter::offset})
        CHECK(found.find(which) == nullptr);
    found.fractal_dimension = {1.5, 0.02};
    found.r = {0.25, 0.03};
    CHECK(found.values() == Draw{1e-6, 2e-5, 3e9, 1.5, 0.25, 0.5});
    CHECK(refusal_of(found).empty());
    CHECK(test::refusal([] {
              SurfaceParameters<double>().set(Parameter::offset, {1, 1});
          }) == "offset: is not a parameter of a surface; must be one that SurfaceParameters holds");
}

TEST_CASE("A quantile lies between its neighbouring values") {
    const std::vector<double> values{1, 2, 4, 8, 16};
    const std::span<const double> sorted(values);
    CHECK(math::sorted_quantile(sorted, 0.0) == 1);
    CHECK(math::sorted_quantile(sorted, 1.0) == 16);
    CHECK(math::sorted_quantile(sorted, 0.5) == 4);
    CHECK(math::sorted_quantile(sorted, 0.125) == 1.5);
    CHECK(math::sorted_quantile(sorted, 0.8125) == 10);
    CHECK(math::sorted_quantile(sorted.first(1), 0.3) == 1);
    CHECK(test::refusal([&] { (void)math::sorted_quantile(sorted.first(0), 0.5); }) ==
          "values of a quantile = 0: must be at least 1");
    CHECK(test::refusal([&] { (void)math::sorted_quantile(sorted, 1.1); }) ==
          "probability = 1.1: must be between 0 and 1");
    CHECK(test::refusal([&] { (void)math::sorted_quantile(sorted, nan_value); }) ==
          "probability = nan: must be between 0 and 1");
    // of many draws: the 5 % and 95 % quantiles of a lognormal number
    auto all = draws(surface(), 20000);
    std::vector<double> sigma;
    for (const auto& draw : all) sigma.push_back(draw[0]);
    std::sort(sigma.begin(), sigma.end());
    const double spread = std::sqrt(std::log1p(0.0025)), z = 1.6448536269514722;
    for (const double side : {-1.0, 1.0}) {
        const double quantile = math::sorted_quantile(std::span<const double>(sigma), side < 0 ? 0.05 : 0.95);
        // its standard error: sqrt(p(1-p)/n)/density
        const double error = std::sqrt(0.05 * 0.95 / 20000) / (std::exp(-z * z / 2) / std::sqrt(2 * pi));
        CHECK(std::abs(std::log(quantile / 1e-6) / spread - side * z) <= 4 * error);
    }
}

#ifdef FSTIFF_MORE_TESTS
TEST_CASE("Float draws are those of double, rounded") {
    SurfaceParameters<float> s;
    const auto exact = surface();
    for (std::size_t i = 0; i < detail::surface_parameter_count; ++i)
        s.set(static_cast<Parameter>(i),
              {static_cast<float>(at(exact, i).value), static_cast<float>(at(exact, i).error)});
    for (std::size_t i = 0; i < detail::surface_parameter_count; ++i)
        for (std::size_t j = 0; j < detail::surface_parameter_count; ++j)
            s.correlation[i][j] = static_cast<float>(exact.correlation[i][j]);
    detail::SurfaceSampler<float> sample(s, 3);
    detail::SurfaceSampler<double> reference(exact, 3);
    for (int k = 0; k < 100; ++k) {
        const auto a = sample();
        const auto b = reference();
        for (std::size_t i = 0; i < detail::surface_parameter_count; ++i)
            CHECK(test::relative_error(static_cast<double>(a[i]), b[i]) <= 1e-5);
    }
}
#endif

}  // namespace uncertain_surface_test
