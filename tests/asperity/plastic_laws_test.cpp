// SPDX-License-Identifier: BSD-3-Clause
// Truth: tests/data/plastic_asperity.csv (20 digits; three materials and radii, on both sides of every limit).
#include <fstiff/asperity/plastic_laws.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/table.hpp"

#include <Eigen/Core>

#include <map>

namespace plastic_laws_test {

using namespace fstiff;

TEST_CASE("load, area and stiffness of one plastic asperity: the table to 1e-13") {
    const test::Table table("plastic_asperity.csv");
    std::map<std::string, int> rows;
    for (std::size_t row = 0; row < table.size(); ++row) {
        const double E = table.input(row, "effective_modulus_Pa"), R = table.input(row, "radius_m");
        const double omega = table.input(row, "interference_m"), H = table.input(row, "hardness_Pa");
        const PlasticMaterial<double> material{E, table.input(row, "yield_strength_Pa"), table.input(row, "poisson"),
                                               H};
        const std::string name = table.text(row, "law");
        ++rows[name];
        CAPTURE(row, name);
        const auto check = [&](const auto& law, bool unloads_by_area = true) {
            CHECK(test::relative_error(E * law.load(omega, R), table.input(row, "load_N")) < 1e-13);
            CHECK(test::relative_error(law.area(omega, R), table.input(row, "area_m2")) < 1e-13);
            if (unloads_by_area)
                CHECK(test::relative_error(E * law.stiffness(omega, R),
                                           table.input(row, "unloading_stiffness_N_per_m")) < 1e-13);
            const Eigen::Array<double, 8, 1> eight = Eigen::Array<double, 8, 1>::Constant(omega);
            CHECK(test::ulps(law.load(eight, R)[7], law.load(omega, R)) <= 2);
            CHECK(test::ulps(law.stiffness(eight, R)[7], law.stiffness(omega, R)) <= 2);
        };
        if (name == "hertz") check(HertzLaw<double>{});
        if (name == "plastic") check(PlasticLaw<double>(H, E));
        if (name == "jackson_green") check(JacksonGreenLaw<double>(material));
        if (name == "jackson_green_2005") check(JacksonGreenLaw<double>(material, HardnessLaw::exponent));
        if (name == "kogut_etsion") check(KogutEtsionLaw<double>(material));
        if (name == "kogut_etsion+ekk_unloading") check(KogutEtsionLaw<double>(material), false);
    }
    CHECK(rows.size() == 6);
}

TEST_CASE("below its first kink a plastic law is Hertz's") {
    const PlasticMaterial<double> steel{112e9, 400e6, 0.3};
    const JacksonGreenLaw<double> law(steel);
    const double R = 40e-6, omega = 1.8 * law.critical(R);
    CHECK(test::ulps(law.load(omega, R), HertzLaw<double>{}.load(omega, R)) <= 2);
    CHECK(test::ulps(law.area(omega, R), HertzLaw<double>{}.area(omega, R)) <= 2);
    CHECK(test::ulps(law.stiffness(omega, R), HertzLaw<double>{}.stiffness(omega, R)) <= 4);
}

TEST_CASE("the mean pressure of a plastic asperity is the hardness") {
    const PlasticLaw<double> law(1.12e9, 112e9);
    for (const double omega : {1e-9, 3e-7})
        CHECK(test::ulps(law.load(omega, 2e-5) * 112e9 / law.area(omega, 2e-5), 1.12e9) <= 4);
    static_assert(detail::PowerLaw<PlasticLaw<double>>);
}

TEST_CASE("constants of a material that are none are refused") {
    const auto refuses = [](const PlasticMaterial<double>& material, const char* name) {
        CHECK(test::refusal([&] { JacksonGreenLaw<double>{material}; }).find(name) == 0);
        CHECK(test::refusal([&] { KogutEtsionLaw<double>{material}; }).find(name) == 0);
    };
    refuses({0, 4e8, 0.3}, "effective_modulus");
    refuses({1e11, 0, 0.3}, "yield_strength");
    refuses({1e11, 4e8, 0.6}, "poisson_ratio");
    refuses({1e11, 4e8, 0.3, -1}, "hardness");
    CHECK(test::refusal([] { PlasticLaw<double>(0, 1e11); }).find("hardness") == 0);
    CHECK(PlasticMaterial<double>{1e11, 4e8, 0.3}.hardness_or_default() == 2.8 * 4e8);
}

}  // namespace plastic_laws_test
