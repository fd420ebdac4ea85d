// SPDX-License-Identifier: BSD-3-Clause
// Truth: boundary elements of faces whose pressures are cut at the hardness (tests/data/plastic_faces.csv by
// make_plastic_faces.py; none of them was fitted); the formulas by hand; limits in closed form; differences of p(d).
#include <fstiff/contact/contact.hpp>
#include <fstiff/contact/hybrid_of_band.hpp>
#include <fstiff/contact/plastic_contact.hpp>
#include <fstiff/math/normal_distribution.hpp>
#include <fstiff/surface/band_spectrum.hpp>
#include <fstiff/surface/bearing_of_core.hpp>
#include <fstiff/surface/material_ratio_slope.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/table.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

namespace bearing_cut_test {

using namespace fstiff;
using Curve = MaterialRatioSlope<double>;

/// Surface with rms height, gradient and modulus 1, so that H is H/(E g) and K is K sigma/(E g).
BandSpectrum<double> band_of(double alpha, double hurst = 0.8) {
    return detail::band_of_moments<double>({1, 0.5, alpha / 4}, hurst);
}
const detail::GaussianCut<double> unit_cut(1, 1, 1);
std::shared_ptr<const Curve> curve_of(double skewness, double kurtosis) {
    return std::make_shared<const Curve>(detail::bearing_of_moments(skewness, kurtosis));
}

TEST_CASE("The cut of a bearing curve, and the bound of elastic contacts, are their formulas") {
    const auto curve = curve_of(-1.2, 5);
    const detail::BearingCut<double> cut(detail::GaussianCut<double>(2, 0.25, 12), curve);  // E g/sigma = 1.5, E g = 3
    for (const double s : {1e-3, 0.1, 0.5, 0.9}) {
        const double z = -math::normal_quantile(s), t = curve->slope(z, 0.25);
        CAPTURE(s);
        const double K = 1.5 * s / (1 - s) * std::hypot(0.55, 0.28 * (z - 0.65)) / std::pow((t * t + 0.36) / 1.36, 0.2);
        CHECK(test::relative_error(cut.stiffness(s), K) < 1e-13);
        CHECK(test::relative_error(cut.level(s).first, 2 * curve->height(z)) < 1e-13);
        CHECK(test::relative_error(cut.level(s).second, 2 * t / math::normal_density(z)) < 1e-13);
        for (const double elastic : {0.01, 1.0, 100.0}) {
            const double B = 1.5 * K * (1 + std::pow(4 * 0.6 / 3, 2));
            CHECK(test::relative_error(cut.bounded(elastic, K, 0.6),
                                       std::pow(std::pow(elastic, -4) + std::pow(B, -4), -0.25)) < 1e-13);
        }
        CHECK(test::relative_error(cut.bounded(1e9, K, 0.6), 1.5 * K * 1.64) < 1e-13);
    }
    CHECK(std::isinf(cut.bounded(std::numeric_limits<double>::infinity(), 1, 1)));
    const detail::BearingCut<double> plain(unit_cut, nullptr);
    CHECK(plain.stiffness(0.1) == unit_cut.stiffness(0.1));
    CHECK(plain.level(0.1) == unit_cut.level(0.1));
    CHECK(plain.bounded(1e9, 1, 1) == 1e9);
}

TEST_CASE("Gaussian heights as a bearing curve change plastic K by less than 0.2 %") {
    const auto curve = curve_of(0, 3);
    for (const double alpha : {2.5, 6.0, 60.0}) {
        const auto elastic = hybrid_of_band(band_of(alpha), 1.0);
        for (const double H : {0.01, 0.03, 0.1, 0.3, 1.0, 3.0})
            for (const double s : {1e-4, 0.003, 0.03, 0.3, 0.8, 0.95}) {
                if (s * H > 0.7) continue;
                const double with = PlasticContact(elastic, detail::BearingCut<double>(unit_cut, curve), H)
                                        .at_pressure(s * H, Quantity::stiffness)
                                        .stiffness.value,
                             without = PlasticContact(elastic, unit_cut, H)
                                           .at_pressure(s * H, Quantity::stiffness)
                                           .stiffness.value;
                CAPTURE(alpha, H, s);
                CHECK(test::relative_error(with, without) < 2e-3);
            }
    }
}

TEST_CASE("A plastic contact with a bearing curve is elastic for a great hardness, and the cut for a small one") {
    for (const auto& [skewness, kurtosis] : {std::pair(-1.5, 6.0), {1.0, 4.5}, {0.0, 2.0}}) {
        const auto curve = curve_of(skewness, kurtosis);
        const auto elastic = hybrid_of_band(band_of(6), *curve, 1.0);
        const detail::BearingCut<double> cut(unit_cut, curve);
        CAPTURE(skewness, kurtosis);
        for (const double p : {1e-6, 1e-3, 0.03, 0.3, 0.7}) {
            const auto hard = PlasticContact(elastic, cut, 1e5).at_pressure(p), plain = elastic.at_pressure(p);
            CAPTURE(p);
            CHECK(test::relative_error(hard.stiffness.value, plain.stiffness.value) < 1e-4);
            CHECK(test::relative_error(hard.loading_stiffness.value, plain.stiffness.value) < 1e-4);
            CHECK(std::abs(hard.separation.value - plain.separation.value) < 2e-3);
        }
        const double soft = 1e-7;
        for (const double share : {0.02, 0.3, 0.5, 0.7, 0.98}) {
            const auto state = PlasticContact(elastic, cut, soft).at_pressure(share * soft);
            const double z = -math::normal_quantile(share);
            CAPTURE(share);
            CHECK(test::relative_error(state.stiffness.value, cut.stiffness(share)) < 2e-3);
            CHECK(std::abs(state.separation.value - curve->height(z)) < 0.03);  // its fall is by a slope over 1/4 of z
        }
    }
}

TEST_CASE("K of a plastic contact with a bearing curve rises with p without steps, and its slope is that of p(d)") {
    std::mt19937 random(12);
    std::uniform_real_distribution<double> uniform;
    for (int i = 0; i < 150; ++i) {
        const double alpha = 2.5 * std::pow(40, uniform(random)), H = 0.01 * std::pow(300, uniform(random));
        const double skewness = 4 * uniform(random) - 2.5, least = detail::least_kurtosis(skewness),
                     kurtosis = least + 1e-3 + 6 * std::pow(uniform(random), 3);
        const auto curve = curve_of(skewness, kurtosis);
        const PlasticContact contact(hybrid_of_band(band_of(alpha), *curve, 1.0),
                                     detail::BearingCut<double>(unit_cut, curve), H);
        CAPTURE(i, alpha, H, skewness, kurtosis);
        double K = 0, d = std::numeric_limits<double>::infinity();
        for (double logit = -10; logit < 4; logit += 0.25) {
            const double p = H / (1 + std::exp(-logit));
            const auto point = contact.point_at_pressure(p);
            if (!point.ok() || p > 0.7) break;
            const double now = point.state.stiffness.value;
            CAPTURE(p / H);
            CHECK(now > K);
            CHECK(point.state.separation.value < d);
            CHECK(point.state.loading_stiffness.value <= now * (1 + 1e-12));
            const double next = contact.at_pressure(p * (1 + 1e-7), Quantity::stiffness).stiffness.value;
            CHECK(std::abs(next / now - 1) < 1e-5);  // no step
            K = now, d = point.state.separation.value;
        }
        const double p = H * 0.02, step = 0.02 * p;
        const double fall =
            contact.at_pressure(p - step).separation.value - contact.at_pressure(p + step).separation.value;
        CHECK(test::relative_error(contact.at_pressure(p).loading_stiffness.value, 2 * step / fall) < 2e-3);
    }
}

TEST_CASE("K and separation of faces by skewness and kurtosis are nearer to boundary elements by the bearing curve") {
    const test::Table table("plastic_faces.csv");
    double worst = 0, worst_before = 0, sum = 0, sum_before = 0;
    std::vector<double> apart, apart_before;
    int within_2 = 0;
    for (std::size_t row = 0; row < table.size(); ++row) {
        const auto at = [&](const char* column) { return table.input(row, column); };
        if (at("skewness") > detail::most_skewness<double>) continue;  // nests of grains have no curve
        const auto curve = curve_of(at("skewness"), at("kurtosis"));
        const auto elastic = hybrid_of_band(band_of(at("alpha")), *curve, 1.0);
        const double H = at("hardness_over_Eg"), p = at("p_over_H") * H;
        const auto state = PlasticContact(elastic, detail::BearingCut<double>(unit_cut, curve), H).at_pressure(p),
                   before = PlasticContact(elastic, unit_cut, H).at_pressure(p);
        const double K = at("stiffness_sigma_over_Eg"), d = at("separation_over_sigma");
        const double e = std::log(state.stiffness.value / K), e_before = std::log(before.stiffness.value / K);
        sum += e * e, sum_before += e_before * e_before;
        worst = std::max(worst, std::abs(e)), worst_before = std::max(worst_before, std::abs(e_before));
        within_2 += std::abs(e) < std::log(2);
        apart.push_back(std::abs(state.separation.value - d));
        apart_before.push_back(std::abs(before.separation.value - d));
    }
    const auto median = [](std::vector<double>& x) {
        std::nth_element(x.begin(), x.begin() + std::ptrdiff_t(x.size() / 2), x.end());
        return x[x.size() / 2];
    };
    const double all = double(apart.size()), rms = std::sqrt(sum / all), rms_before = std::sqrt(sum_before / all),
                 of_d = median(apart), of_d_before = median(apart_before);
    CAPTURE(all, rms, rms_before, worst, worst_before, within_2, of_d, of_d_before);
    CHECK(rms < 0.27);
    CHECK(rms < 0.9 * rms_before);
    CHECK(worst < worst_before - 0.25);  // fused grains, K 4.9 times the truth at a light load
    CHECK(within_2 > 0.98 * all);
    CHECK(of_d < 0.075);
    CHECK(of_d < 0.75 * of_d_before);
}

}  // namespace bearing_cut_test
