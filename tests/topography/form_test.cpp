// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/topography/form.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <vector>

namespace form_test {

using namespace fstiff;

namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// Values that look random, from -1 to 1, the same everywhere.
double rough(Eigen::Index i) {
    return std::fmod(static_cast<double>(i) * static_cast<double>(i) * 0.6180339887498949, 2.0) - 1;
}

/// 1e-7 m of roughness, and holes where \p holes.
HeightMap<double> some_map(Eigen::Index columns, Eigen::Index rows, bool holes = false) {
    HeightMap<double> map{HeightMap<double>::Array(rows, columns), 1e-6, 2e-6};
    for (Eigen::Index j = 0; j < rows; ++j)
        for (Eigen::Index i = 0; i < columns; ++i) {
            map.heights(j, i) = 1e-7 * rough(1 + i + 37 * j);
            if (holes && (i * j) % 7 == 3) map.heights(j, i) = missing;
        }
    return map;
}

/// The residual by the monomials made orthogonal one by one, twice, in long double: the independent slow code.
HeightMap<double> slow(const HeightMap<double>& map, int degree) {
    using Points = Eigen::Array<long double, Eigen::Dynamic, Eigen::Dynamic>;
    std::vector<Points> orthogonal;  // 0 where a point is missing
    const auto rest = [&](Points values) {
        for (int twice = 0; twice < 2; ++twice)
            for (const Points& of : orthogonal) values -= (of * values).sum() * of;
        return values;
    };
    const Points there = 1 - map.heights.isNaN().cast<long double>();
    for (int k = 0; k <= degree; ++k)
        for (int l = 0; k + l <= degree; ++l) {
            Points monomial = there;
            for (Eigen::Index j = 0; j < map.rows(); ++j)
                for (Eigen::Index i = 0; i < map.columns(); ++i) {
                    const long double x = static_cast<long double>(i) / static_cast<long double>(map.columns()) - 0.4L;
                    const long double y = static_cast<long double>(j) / static_cast<long double>(map.rows()) - 0.6L;
                    monomial(j, i) *= std::pow(x, k) * std::pow(y, l);
                }
            monomial = rest(monomial);
            orthogonal.push_back(monomial / std::sqrt(monomial.square().sum()));
        }
    const Points heights = map.heights.isNaN().select(0.0, map.heights).cast<long double>();
    return {map.heights.isNaN().select(missing, rest(heights).cast<double>()), map.dx, map.dy};
}

/// Largest difference of existing points; infinite when one map has a point that the other has not.
double difference(const HeightMap<double>& a, const HeightMap<double>& b) {
    double worst = 0;
    for (Eigen::Index k = 0; k < a.size(); ++k) {
        const double x = a.heights.data()[k], y = b.heights.data()[k];
        if (std::isnan(x) != std::isnan(y)) return HUGE_VAL;
        if (!std::isnan(x)) worst = std::max(worst, std::abs(x - y));
    }
    return worst;
}

}  // namespace

TEST_CASE("The residual of a form is that of slow least squares, offset and tilt 1e6 times the roughness") {
    const int degree = GENERATE(0, 1, 2, 3);
    const bool holes = GENERATE(false, true);
    for (const double size : {0.0, 1e-4, 0.1}) {
        auto map = some_map(41, 30, holes);
        for (Eigen::Index j = 0; j < map.rows(); ++j)
            for (Eigen::Index i = 0; i < map.columns(); ++i)
                map.heights(j, i) += size * (1 + 0.02 * static_cast<double>(i) - 0.03 * static_cast<double>(j));
        const double largest = map.heights.isNaN().select(0.0, map.heights).abs().maxCoeff();
        const double error = difference(detail::remove_form(map, static_cast<MapForm>(degree)), slow(map, degree));
        CAPTURE(degree, holes, size, error / largest);
        CHECK(error <= 1e-15 * largest);  // the rounding of a few subtractions from the largest height
    }
}

TEST_CASE("An added form is removed and the residual does not depend on it") {
    const MapForm form = GENERATE(MapForm::mean, MapForm::plane, MapForm::quadratic, MapForm::cubic);
    const auto degree = static_cast<int>(form);
    const auto map = some_map(64, 50, true);
    auto shaped = map;
    for (Eigen::Index j = 0; j < map.rows(); ++j)
        for (Eigen::Index i = 0; i < map.columns(); ++i) {
            const double x = static_cast<double>(i) / 64, y = static_cast<double>(j) / 50;
            double z = 1;
            if (degree >= 1) z += 2 * x - y;
            if (degree >= 2) z += x * y - 3 * x * x + y * y;
            if (degree >= 3) z += x * x * x + 2 * x * y * y - x * x * y;
            shaped.heights(j, i) += 1e-4 * z;
        }
    const auto flat = detail::remove_form(map, form);
    CHECK(difference(detail::remove_form(shaped, form), flat) <= 1e-15 * 5e-4);
    CHECK(difference(detail::remove_form(flat, form), flat) <= 1e-15 * 1e-7);
    CHECK(difference(detail::remove_form(map, MapForm::none), map) == 0);
}

TEST_CASE("A map turned or in another unit leaves the same residual") {
    const MapForm form = GENERATE(MapForm::plane, MapForm::quadratic, MapForm::cubic);
    const auto map = some_map(33, 48, true);
    const auto flat = detail::remove_form(map, form);
    const HeightMap<double> turned{map.heights.transpose(), map.dy, map.dx};
    const HeightMap<double> back{detail::remove_form(turned, form).heights.transpose(), map.dx, map.dy};
    CHECK(difference(back, flat) <= 1e-15 * 1e-7);
    for (const double unit : {1e9, 1e-9, 0x1p900, 0x1p-990}) {
        const HeightMap<double> scaled{map.heights * unit, map.dx, map.dy};
        const HeightMap<double> there{detail::remove_form(scaled, form).heights / unit, map.dx, map.dy};
        CHECK(difference(there, flat) <= 1e-15 * 1e-7);
    }
}

#ifdef FSTIFF_MORE_TESTS
TEST_CASE("A map in float keeps the rounding of float") {
    auto map = some_map(40, 40);
    for (Eigen::Index j = 0; j < 40; ++j)
        for (Eigen::Index i = 0; i < 40; ++i) map.heights(j, i) += 1e-6 * static_cast<double>(i - j);
    const HeightMap<float> narrow{map.heights.cast<float>(), 1e-6f, 2e-6f};
    const auto flat = detail::remove_form(narrow, MapForm::plane);
    const HeightMap<double> again{narrow.heights.cast<double>(), 1e-6, 2e-6};
    const auto truth = slow(again, 1);
    // the residual is rounded once, and the truth is as good as double
    const double rounding = 1e-7 * static_cast<double>(std::numeric_limits<float>::epsilon());
    CHECK((flat.heights.cast<double>() - truth.heights).abs().maxCoeff() <= rounding + 1e-15 * 4e-5);
}
#endif

TEST_CASE("A form that the points do not determine is refused") {
    HeightMap<double> map{HeightMap<double>::Array::Constant(20, 20, missing), 1e-6, 1e-6};
    for (Eigen::Index i = 0; i < 20; ++i) map.heights(7, i) = 1e-7 * rough(i);
    const auto says = [&](MapForm form) { return test::refusal([&] { (void)detail::remove_form(map, form); }); };
    CHECK(says(MapForm::mean).empty());
    CHECK(says(MapForm::plane).find("map whose points determine 2 of the 3 terms") == 0);
    for (Eigen::Index i = 0; i < 20; ++i) map.heights(8, i) = 1e-7 * rough(i + 50);
    CHECK(says(MapForm::plane).empty());
    CHECK(says(MapForm::quadratic).find("map whose points determine 5 of the 6 terms") == 0);
    map.heights.setConstant(missing);
    map.heights(0, 0) = map.heights(5, 0) = 0;
    map.heights(9, 9) = 1e-7;
    CHECK(says(MapForm::plane).empty());
    CHECK(says(MapForm::quadratic).find("map of which 3 points exist") == 0);
    map.dx = -1;
    CHECK(says(MapForm::plane).find("dx = -1") == 0);
}

TEST_CASE("A map that is its own form is refused as a constant one is, whatever the unit") {
    for (const double unit : {1.0, 1e-6, 1e9})
        for (const MapForm form : {MapForm::mean, MapForm::plane, MapForm::quadratic, MapForm::cubic}) {
            HeightMap<double> map{HeightMap<double>::Array::Zero(64, 64), unit, unit};
            for (int j = 0; j < 64; ++j)
                for (int i = 0; i < 64; ++i) {
                    const double x = i / 7., y = j / 3.;
                    const int degree = static_cast<int>(form);
                    map.heights(j, i) = unit * (degree == 0   ? 1 + 1e-17 * i
                                                : degree == 1 ? x + y
                                                : degree == 2 ? x * y - y * y
                                                              : x * x * y - y * y * y + x);
                }
            map.heights(0, 0) *= 1 - 1e-15;  // so that the mean is not a constant before
            CHECK(test::refusal([&] { (void)detail::level(map, form); }).find("map of constant height once its form") ==
                  0);
            map.heights(30, 30) += 1e-9 * unit;
            CHECK_NOTHROW(detail::level(map, form));
        }
}

}  // namespace form_test
