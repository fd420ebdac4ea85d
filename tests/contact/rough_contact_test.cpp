// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/answer/checks.hpp>
#include <fstiff/asperity/laws.hpp>
#include <fstiff/asperity/material.hpp>
#include <fstiff/contact/greenwood_williamson.hpp>
#include <fstiff/contact/persson_contact.hpp>
#include <fstiff/contact/rough_contact.hpp>
#include <fstiff/contact/summit_contact.hpp>
#include <fstiff/surface/band_spectrum.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/paper.hpp"
#include "support/table.hpp"

#include <numbers>
#include <string>
#include <type_traits>

namespace rough_contact_test {

using namespace fstiff;

namespace {

constexpr double pi = std::numbers::pi;
const double modulus = effective_modulus<double>({205e9, 0.3}, {205e9, 0.3});

const Roughness<double> fine = test::sand_blasted_fine.roughness();
const PeakDistribution<double> quarter(0, pi / 4), third = PeakDistribution<double>::exponential(pi / 3);

template <class Law>
RoughContact<double, Law> contact(const Law& law, const RoughContactOptions<double>& options = {},
                                  const PeakDistribution<double>& peaks = third) {
    return {fine, peaks, law, modulus, options};
}

}  // namespace

TEST_CASE("a modulus is converted to the scalar of the surface, an integer or a number of another scalar") {
    const Roughness<double> surface{.rms_height = 0.8e-6, .peak_radius = 40e-6, .peak_density = 500e6};
    const Roughness<float> surface_in_float{.rms_height = 0.8e-6F, .peak_radius = 40e-6F, .peak_density = 500e6F};
    const RoughContact rough(surface, third, HertzLaw<double>{}, 112600000000);
    const RoughContact in_float(surface_in_float, PeakDistribution<float>(0, 0.5F), HertzLaw<float>{}, 0x1p37);
    const GreenwoodWilliamson single(surface, 112600000000);
    const GreenwoodWilliamson single_in_float(surface_in_float, 0x1p37);
    const BandSpectrum<double> band{1e-10, 0.8, 1e5, 1e5, 1e7};
    const BandSpectrum<float> band_in_float{1e-10F, 0.8F, 1e5F, 1e5F, 1e7F};
    const PerssonContact persson(band, 112600000000, 1);
    const PerssonContact persson_in_float(band_in_float, 0x1p37);
    const Summits<double> map{{{1e-6, 1e5, 1e5, 0, 0}}, 1e-8, 1e-4, 1e-4, 1e-6};
    const SummitContact summit(map, 112600000000);

    static_assert(
        std::is_same_v<decltype(in_float), const RoughContact<float, HertzLaw<float>, PeakDistribution<float>>>);
    static_assert(std::is_same_v<decltype(persson), const PerssonContact<double>>);
    static_assert(std::is_same_v<decltype(persson_in_float), const PerssonContact<float>>);
    CHECK(rough.effective_modulus() == 112.6e9);
    CHECK(in_float.effective_modulus() == 0x1p37F);
    CHECK(single.effective_modulus() == 112.6e9);
    CHECK(single_in_float.effective_modulus() == 0x1p37F);
    CHECK(persson.effective_modulus() == 112.6e9);
    CHECK(persson_in_float.effective_modulus() == 0x1p37F);
    CHECK(summit.at_pressure(1e5).stiffness.value ==
          SummitContact<double>(map, 112.6e9).at_pressure(1e5).stiffness.value);
}

TEST_CASE("the curves of Table 1 to 1e-10") {
    const test::Table table("table1_curves.csv");
    for (std::size_t row = 0; row < table.size(); ++row) {
        const test::PaperSurface& surface = test::paper_surface(table.text(row, "surface"));
        const Roughness<double> roughness = surface.roughness();
        const double dimension = surface.fractal_dimension;
        const PeakDistribution<double> peaks(table.input(row, "r"), table.input(row, "theta"));
        const double pressure = table.input(row, "pressure_Pa");
        const auto same = [&](double value, const char* column) {
            INFO("row " << row + 2 << ' ' << column << ' ' << value);
            CHECK(test::relative_error(value, static_cast<double>(table.number(row, column))) < 1e-10);
        };
        const auto fractal =
            RoughContact(roughness, peaks, FractalLaw<double>(dimension), modulus).at_pressure(pressure);
        same(fractal.eta, "eta");
        same(fractal.stiffness.value, "stiffness_fractal_Pa_per_m");
        same(fractal.real_area_fraction.value, "real_area_fraction");
        same(fractal.contact_density.value, "contacts_per_m2");
        const auto hertz = RoughContact(roughness, peaks, HertzLaw<double>{}, modulus).at_pressure(pressure);
        same(hertz.stiffness.value, "stiffness_hertz_Pa_per_m");
        CHECK(fractal.stiffness.error < 1e-11 * fractal.stiffness.value);
    }
}

TEST_CASE("pressure and separation are each other's inverse, within the errors returned") {
    const auto hertz = contact(HertzLaw<double>{});
    for (const double pressure : {1e-150, 1e-20, 1.0, 1e5, 1e8, 1e11, 1e13}) {
        const auto at = hertz.at_pressure(pressure);
        const auto back = hertz.at_separation(at.separation.value);
        INFO("p " << pressure << " eta " << at.eta);
        CHECK(test::relative_error(back.pressure.value, pressure) < 1e-13 * (1 + at.eta * at.eta));
        CHECK(std::abs(back.stiffness.value - at.stiffness.value) <=
              at.stiffness.error + back.stiffness.error + 1e-14 * at.stiffness.value);
        CHECK(at.separation.error < 1e-11 * fine.rms_height * (1 + std::abs(at.eta)));
    }
}

TEST_CASE("K is -dp/dd for hertz and fractal_consistent, and f times it for fractal") {
    const double h = 1e-5 * fine.rms_height;
    const auto slope = [&](const auto& c, double d) {  // five points: error h^4
        const auto p = [&](double x) { return c.at_separation(x, Quantity::pressure).pressure.value; };
        return -(8 * (p(d + h) - p(d - h)) - (p(d + 2 * h) - p(d - 2 * h))) / (12 * h);
    };
    const double f = detail::fractal_stiffness_factor(1.62);
    for (const double eta : {-1.0, 0.5, 2.0, 3.5}) {
        const double d = eta * fine.rms_height;
        const auto hertz = contact(HertzLaw<double>{});
        const auto consistent = contact(FractalConsistentLaw<double>(1.62));
        const auto fractal = contact(FractalLaw<double>(1.62));
        // rounding of p over h: 2e-15/1e-5
        CHECK(test::relative_error(slope(hertz, d), hertz.at_separation(d).stiffness.value) < 1e-8);
        CHECK(test::relative_error(slope(consistent, d), consistent.at_separation(d).stiffness.value) < 1e-8);
        CHECK(test::relative_error(f * slope(fractal, d), fractal.at_separation(d).stiffness.value) < 1e-8);
    }
    CHECK(std::abs(f - 2.421) < 5e-4);
}

TEST_CASE("the paper's conclusions in figures") {
    // fractal over Greenwood-Williamson between 0.1 and 100 MPa, and the effect of theta at equal pressure
    const GreenwoodWilliamson<double> gw(fine, modulus);
    for (const double pressure : {1e5, 1e6, 1e7, 1e8}) {
        const double at_third = contact(FractalLaw<double>(1.62)).at_pressure(pressure).stiffness.value;
        const double at_quarter = contact(FractalLaw<double>(1.62), {}, quarter).at_pressure(pressure).stiffness.value;
        const double over_gw = at_quarter / gw.at_pressure(pressure).stiffness.value;
        INFO("p " << pressure << " ratio " << over_gw << " theta " << at_third / at_quarter);
        CHECK((over_gw > 2.46 && over_gw < 2.59));
        CHECK((at_third / at_quarter > 1.05 && at_third / at_quarter < 1.19));
        CHECK(test::ulps(contact(FractalLaw<double>(1.62)).at_pressure(pressure).stiffness.value,
                         detail::fractal_stiffness_factor(1.62) *
                             contact(HertzLaw<double>{}).at_pressure(pressure).stiffness.value) < 10);
    }
}

TEST_CASE("only requested quantities are computed and equal those of a full call") {
    const auto c = contact(HertzLaw<double>{});
    const auto all = c.at_pressure(1e7);
    const auto one = c.at_pressure(1e7, Quantity::stiffness);
    CHECK(one.stiffness.value == all.stiffness.value);
    CHECK(one.real_area_fraction.value == 0);
    CHECK(one.real_area_fraction.evaluations == 0);
    CHECK(one.contact_density.value == 0);
    CHECK(c.at_separation(1e-6, Quantity::real_area_fraction).stiffness.value == 0);
}

TEST_CASE("no dimensionless value depends on the unit of length") {
    for (const double unit : {1e-9, 1e9}) {
        // a length of 1 m is 1/unit units; the modulus is a pressure, Pa = N/m^2, with the unit of force kept
        Roughness<double> scaled = fine;
        scaled.rms_height /= unit;
        scaled.peak_radius /= unit;
        scaled.peak_density *= unit * unit;
        const RoughContact other(scaled, third, HertzLaw<double>{}, modulus);
        const auto a = contact(HertzLaw<double>{}).at_pressure(1e7), b = other.at_pressure(1e7);
        CHECK(test::relative_error(a.eta, b.eta) < 1e-13);
        CHECK(test::relative_error(a.real_area_fraction.value, b.real_area_fraction.value) < 1e-13);
        CHECK(test::relative_error(a.stiffness.value * unit, b.stiffness.value) < 1e-13);
        CHECK(test::relative_error(a.contact_density.value * unit * unit, b.contact_density.value) < 1e-13);
    }
}

TEST_CASE("interaction: effective separation") {
    for (const double length : {std::sqrt(195e-6), 1 / std::sqrt(500e6)}) {
        const auto alone = contact(HertzLaw<double>{});
        const auto c = contact(HertzLaw<double>{}, {.interaction = {InteractionReading::effective_separation, length}});
        for (const double pressure : {1e5, 3e6, 1e8}) {
            const auto a = alone.at_pressure(pressure), b = c.at_pressure(pressure);
            const double sink = pressure * length / modulus;
            INFO("L " << length << " p " << pressure);
            CHECK(b.eta == a.eta);
            CHECK(test::relative_error(b.separation.value, a.separation.value - sink) < 1e-12);
            CHECK(test::relative_error(1 / b.stiffness.value, 1 / a.stiffness.value + length / modulus) < 1e-13);
            CHECK(b.stiffness.value <= modulus / length);
            // the way back: at the nominal separation the implicit equation gives the same state
            const auto back = c.at_separation(b.separation.value);
            CHECK(test::relative_error(back.pressure.value, pressure) < 1e-10);
            CHECK(test::relative_error(back.stiffness.value, b.stiffness.value) < 1e-10);
        }
        // -dp/dd of the nominal separation, by differences
        const double d = 1.5 * fine.rms_height, h = 1e-4 * fine.rms_height;
        const auto p = [&](double x) { return c.at_separation(x, Quantity::pressure).pressure.value; };
        const double slope = -(8 * (p(d + h) - p(d - h)) - (p(d + 2 * h) - p(d - 2 * h))) / (12 * h);
        CHECK(test::relative_error(slope, c.at_separation(d).stiffness.value) < 1e-8);
    }
}

TEST_CASE("interaction: the size of Delta eta and where repeated substitution would diverge") {
    const double length = std::sqrt(195e-6);
    const struct {
        const char* name;
        double shift_at_100_MPa;
    } rows[] = {{"sand_blasted_fine", 14.90}, {"sand_blasted_coarse", 2.417}, {"electrical_discharge", 1.387}};
    for (const auto& row : rows)
        CHECK(std::abs(1e8 * length / (modulus * test::paper_surface(row.name).rms_height) / row.shift_at_100_MPa - 1) <
              5e-4);
    // |d Delta/d eta| = K L/E of the fine surface, theta = pi/4
    for (const auto& [pressure, slope] :
         {std::pair(1e6, 0.47), std::pair(3e6, 1.3), std::pair(1e7, 3.7), std::pair(1e8, 25.0)}) {
        const double k = contact(HertzLaw<double>{}, {}, quarter).at_pressure(pressure).stiffness.value;
        CHECK(std::abs(k * length / modulus / slope - 1) < 0.03);  // two digits are given
    }
}

TEST_CASE("interaction: as printed") {
    const double length = std::sqrt(195e-6);
    const auto alone = contact(FractalLaw<double>(1.62));
    const auto c = contact(FractalLaw<double>(1.62), {.interaction = {InteractionReading::as_printed, length}});
    const auto a = alone.at_pressure(1e7), b = c.at_pressure(1e7);
    const double eta_new = a.eta - 1e7 * length / (modulus * fine.rms_height);
    CHECK(test::relative_error(b.eta, eta_new) < 1e-12);
    CHECK(test::relative_error(b.stiffness.value, alone.at_separation(eta_new * fine.rms_height).stiffness.value) <
          1e-12);
    CHECK(b.pressure.value == 1e7);
    const auto at = c.at_separation(a.separation.value);
    CHECK(test::relative_error(at.stiffness.value, b.stiffness.value) < 1e-11);
    CHECK(test::relative_error(at.pressure.value, 1e7) < 1e-12);
}

TEST_CASE("the curvature scale: the printed one, and the one whose peaks have the mean curvature 1/R") {
    CHECK(test::ulps(detail::rms_curvature(fine, third), 3 * std::sqrt(pi) / (8 * fine.peak_radius)) <= 2);
    const double consistent = detail::rms_curvature(fine, third, CurvatureScale::consistent);
    CHECK(test::ulps(consistent * third.mean_curvature(), 1 / fine.peak_radius) <= 4);
    // at equal eta K goes as sigma_kappa^(-1/2): lower by 0.866 and 0.830
    const auto ratio = [](const PeakDistribution<double>& peaks) {
        const RoughContactOptions<double> options{.curvature = CurvatureScale::consistent};
        return contact(HertzLaw<double>{}, options, peaks).at_separation(1e-6).stiffness.value /
               contact(HertzLaw<double>{}, {}, peaks).at_separation(1e-6).stiffness.value;
    };
    CHECK(std::abs(ratio(quarter) - 0.8660) < 5e-5);
    CHECK(std::abs(ratio(third) - 0.8300) < 5e-5);
}

TEST_CASE("the validity figures of Table 1") {
    CHECK(std::abs(detail::plasticity_index(fine, modulus, 400e6) - 14.5) < 0.05);
    CHECK(std::abs(detail::plasticity_index(test::paper_surface("sand_blasted_coarse").roughness(), modulus, 400e6) -
                   42) < 0.5);
    CHECK(std::abs(detail::plasticity_index(test::paper_surface("electrical_discharge").roughness(), modulus, 400e6) -
                   69) < 0.5);
    const double product = fine.rms_height * fine.peak_radius * fine.peak_density;
    CHECK((product < detail::min_gaussian_product<double> && std::abs(product - 0.0166) < 1e-4));
    CHECK_FALSE(detail::rms_gradient(fine, quarter).has_value());
    const double gradient = detail::rms_gradient(fine, third).value();
    CHECK(test::ulps(gradient, std::sqrt(2 * third.r() * fine.rms_height * detail::rms_curvature(fine, third))) <= 4);
    const double at_100_MPa = detail::dimensionless_pressure(1e8, modulus, gradient);
    CHECK((at_100_MPa > 0.001 && at_100_MPa < 0.007));
}

TEST_CASE("every scalar type runs the same contact") {
    const RoughContact single(test::sand_blasted_fine.roughness<float>(),
                              PeakDistribution<float>::exponential(std::numbers::pi_v<float> / 3), HertzLaw<float>{},
                              112.6e9F);
    const RoughContact twice(fine, third, HertzLaw<double>{}, 112.6e9);
    for (const float pressure : {1e5F, 1e7F, 1e9F})
        CHECK(test::relative_error(single.at_pressure(pressure).stiffness.value,
                                   static_cast<float>(twice.at_pressure(pressure).stiffness.value)) < 2e-5F);
}

TEST_CASE("parameters and points out of reach are refused in one sentence") {
    const auto with = [](Roughness<double> surface, double e) {
        return test::refusal([&] { RoughContact(surface, third, HertzLaw<double>{}, e); });
    };
    CHECK(with({0, 1e-6, 1e9, 0}, 1e11) == "rms_height = 0: must be finite and greater than 0");
    CHECK(with({1e-6, -1, 1e9, 0}, 1e11).starts_with("peak_radius = -1: must be"));
    CHECK(with({1e-6, 1e-6, std::nan(""), 0}, 1e11).starts_with("peak_density = nan: must be"));
    CHECK(with({1e-6, 1e-6, 1e9, -2}, 1e11).starts_with("max_peak_height = -2: must be"));
    CHECK(with({1e-6, 1e-6, 1e9, 0}, 0).starts_with("effective_modulus = 0: must be"));
    CHECK(test::refusal([] {
              contact(HertzLaw<double>{}, {.interaction = {InteractionReading::as_printed, 0}});
          }).starts_with("interaction length = 0: must be"));
    const auto c = contact(HertzLaw<double>{});
    const auto at = [&](double p) { return test::refusal([&] { static_cast<void>(c.at_pressure(p)); }); };
    CHECK(at(0).starts_with("pressure = 0: must be"));
    CHECK(at(-1).starts_with("pressure = -1: must be"));
    CHECK(at(1e40).starts_with("pressure = 1e+40: must be between 1e-2"));
    CHECK(at(1e-307).starts_with("pressure = 1e-307: must be between 1e-2"));
    CHECK(test::refusal([&] {
              static_cast<void>(c.at_separation(std::nan("")));
          }).starts_with("separation = nan: must be"));
    CHECK(test::refusal([&] { static_cast<void>(c.at_separation(-1)); }).starts_with("separation = -1: must be"));
    // far apart there is no contact, which is no error
    CHECK(c.at_separation(1e-3).pressure.value == 0);
}

TEST_CASE("a separation that a pressure gave is taken, with interaction however long") {
    // the upper end of the bracket was beyond the range of the integrals
    const RoughContact contact(Roughness<double>{0.1e-6, 1e-6, 1e11}, PeakDistribution<double>(0.3, 0.9),
                               HertzLaw<double>{}, 112.6e9,
                               {.interaction = {InteractionReading::effective_separation, 0.1}});
    const auto at = contact.at_pressure(1e7);
    CHECK(test::relative_error(contact.at_separation(at.separation.value).pressure.value, 1e7) < 1e-6);
}

TEST_CASE("a separation out of range is refused with the bounds in its own unit") {
    const RoughContact contact(Roughness<double>{1e-6, 40e-6, 500e6}, PeakDistribution<double>(0.3, 0.9),
                               HertzLaw<double>{}, 112.6e9);
    CHECK(test::refusal([&] { static_cast<void>(contact.at_separation(-0.00149)); }) ==
          "separation = -0.00149: must be between -0.001 and 1 m, -1000 and 1e6 rms heights");
}

}  // namespace rough_contact_test
