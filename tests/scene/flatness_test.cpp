// SPDX-License-Identifier: BSD-3-Clause
// Faces that are not flat, and an earlier load. Truth: the law of the same faces without them, closed forms,
// FormedJoint.
#include <fstiff/answer.hpp>
#include <fstiff/contact/earlier_load.hpp>
#include <fstiff/halfspace/formed_joint.hpp>
#include <fstiff/synthetic/self_affine.hpp>

#include "actions/explanation.hpp"
#include "support/accuracy.hpp"
#include "support/half_space_maps.hpp"
#include "support/library.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

namespace flatness_test {

using namespace fstiff;

namespace {

constexpr double side = 0.05;

/// Ground faces of C45 over 50 mm a side.
Joint plates(std::optional<double> flatness = {}) {
    const Body steel = body_of(*find_material("C45"));
    return {.face = {.mean_height = 0.8e-6, .process = Process::ground},
            .upper = steel,
            .lower = steel,
            .nominal_area = side * side,
            .flatness = flatness};
}

double K(const Joint& joint, double pressure) { return answer(joint, pressure, {.samples = 0}).stiffness.value; }

const std::string surface =
    "[surface]\nRa = \"0.8 um\"\nprocess = \"ground\"\n[material]\nupper = \"C45\"\n[contact]\n";
const std::string of_area = surface + "nominal_area = \"2500 mm^2\"\npressures = [\"10 MPa\"]\n";

std::size_t at(Cause cause) { return static_cast<std::size_t>(cause); }

}  // namespace

TEST_CASE("Faces of no height, and under loads at which they conform, have K of the faces") {
    for (const double p : {1e6, 1e7, 1e8}) CHECK(K(plates(0), p) == K(plates(), p));
    const AnswerPoint heavy = answer(plates(1e-7), 3e8);
    CHECK(test::relative_error(heavy.stiffness.value, heavy.of_faces().value) < 1e-3);
    CHECK(heavy["touching_share"] == 1);
    double last = K(plates(0), 1e7);
    for (const double flatness : {1e-6, 3e-6, 1e-5, 3e-5, 1e-4}) {
        const double now = K(plates(flatness), 1e7);
        CHECK(now < last);
        last = now;
    }
}

TEST_CASE("A crown that touches in its middle is a patch of Hertz in series with the faces") {
    const double modulus = 205e9 / (2 * (1 - 0.09)), b = side / 2;
    for (const double flatness : {5e-5, 1e-4})
        for (const double p : {3e6, 1e7}) {
            const double x = std::cbrt(1.18 * (p / modulus) * (b / flatness)),
                         patch = 2 * modulus / (std::numbers::pi * b) * x / std::pow(1 - x, 1.5),
                         faces = K(plates(0), p);
            CAPTURE(flatness, p, x);
            CHECK(x < 0.65);
            CHECK(test::relative_error(K(plates(flatness), p), 1 / (1 / faces + 1 / patch)) < 0.25);
        }
}

TEST_CASE("K of a joint is that of its form with the law of the faces, and its band that of their ends") {
    const double p = 1e7;
    const std::vector<double> pressures{p};
    const AnswerPoint point = answer(plates(1e-5), p), faces = answer(plates(0), p);
    CHECK(point.of_faces().value == faces.stiffness.value);
    CHECK(point["stiffness_of_faces"] == faces.stiffness.value);
    CHECK(point.stiffness.low < point.stiffness.value);
    CHECK(point.stiffness.value < point.stiffness.high);
    CHECK(point.causes[at(Cause::form)].low < 0);
    CHECK(point["local_pressure"] > p);
    CHECK(point["touching_share"] < 1);
    CHECK(*point.loading_stiffness < point.stiffness.value);

    // the law of the faces by itself, at pressures of its own
    std::vector<double> all;
    for (int k = 0; k <= 80; ++k) all.push_back(p * std::pow(10.0, -4 + k / 12.0));
    const Answer law = answer(plates(0), all, {.samples = 0});
    const auto local = [&](double pressure) {
        const double x = std::log(pressure / p) / std::log(10.0) * 12 + 48;
        const auto i = static_cast<std::size_t>(std::clamp(x, 0.0, 79.0));
        const double t = x - double(i);
        const auto mean = [&](double a, double b) { return std::exp(std::lerp(std::log(a), std::log(b), t)); };
        double closure = 0;
        for (std::size_t j = 1; j <= i; ++j)
            closure += (law.points[j].pressure - law.points[j - 1].pressure) /
                       std::sqrt(*law.points[j].loading_stiffness * *law.points[j - 1].loading_stiffness);
        const double stiffness = mean(law.points[i].stiffness.value, law.points[i + 1].stiffness.value),
                     loading = mean(*law.points[i].loading_stiffness, *law.points[i + 1].loading_stiffness);
        closure += (pressure - law.points[i].pressure) / std::sqrt(loading * *law.points[i].loading_stiffness);
        return detail::LocalContact{closure, stiffness, loading};
    };
    const auto solved = FormedJoint(JointForm::crown(side, side, 1e-5), local, law.effective_modulus).at_pressure(p);
    CHECK(test::relative_error(point.stiffness.value, solved.stiffness) < 0.02);
    CHECK(test::relative_error(*point.loading_stiffness, solved.loading_stiffness) < 0.02);
    CHECK(test::relative_error(point["touching_share"], solved.touching_share) < 0.02);
}

TEST_CASE("Heat, damping and K in N/m are those of the joint, reflections and laws those of the faces") {
    Joint joint = plates(1e-5), flat = plates(0);
    for (Joint* each : {&joint, &flat}) {
        each->waves = UltrasonicWaves{.frequency = 5e6};
        each->friction = Friction{0.2, 1e-9};
        for (Body* body : {&each->upper, &each->lower})
            body->thermal_conductivity = 45, body->velocity = 5900, body->density = 7850;
    }
    const double p = 1e7;
    const AnswerPoint a = answer(joint, p), b = answer(flat, p);
    const double share = a.stiffness.value / b.stiffness.value;
    CHECK(share < 0.5);
    CHECK(test::relative_error(a["thermal_conductance"] / b["thermal_conductance"], share) < 1e-12);
    CHECK(test::relative_error(a["joint_stiffness"], a.stiffness.value * side * side) < 1e-12);
    CHECK(test::relative_error(a["tangential_stiffness"] / b["tangential_stiffness"], share) < 1e-12);
    CHECK(a["reflection"] == b["reflection"]);
    CHECK(a.find("reflection")->number.low == b.find("reflection")->number.low);
    const std::vector<double> pressures{1e6, 3e6, 1e7, 3e7, 1e8};
    const LawRange<double> range{1e6, 1e8, OutsideRange::extrapolate};
    for (const double quantile : {0.05, 0.5, 0.95})
        CHECK(answer(joint, pressures).law_at(quantile, range).stiffness(2e7) ==
              answer(flat, pressures).law_at(quantile, range).stiffness(2e7));
}

TEST_CASE("A form that is not known is a cause of the band where the area is known, and in the sentence elsewhere") {
    const auto causes = [](const std::string& text) { return test::results_of(text).answer.points[0].causes; };
    const CauseSpread<double> ground = causes(of_area)[at(Cause::form)];
    CHECK(ground.low < 0);
    CHECK(ground.high == 0);
    std::string turned = of_area;
    turned.replace(turned.find("ground"), 6, "turned");
    CHECK(causes(turned)[at(Cause::form)].low < ground.low);
    CHECK(causes(of_area + "flatness = \"0 um\"\n")[at(Cause::form)].low == 0);
    const auto without = test::results_of(surface + "pressures = [\"10 MPa\"]\n");
    CHECK(without.answer.points[0].causes[at(Cause::form)].low == 0);
    CHECK(without.answer.points[0].stiffness.value == test::results_of(of_area).answer.points[0].stiffness.value);
    // F = 1.2 p b/E
    CHECK(actions::outside_band(without).find("faces not flat within 2.7 \xC2\xB5m over 50 mm at 10 MPa") !=
          std::string::npos);
    CHECK(actions::outside_band(test::results_of(of_area)).find("flat within") == std::string::npos);
    CHECK(actions::measure_next(test::results_of(of_area)).find("measure the flatness of the faces") == 0);

    // a map as large as the face has its form
    const test::Folder folder;
    const std::string map = folder.write(
        "map.txt",
        test::map_text(64, 1e-6,
                       {.hurst = 0.8, .rms = 0.3e-6, .longest_wavelength = 16e-6, .shortest_wavelength = 4e-6}));
    const std::string of_map = "[surface]\nfrom = '" + map + "'\n[contact]\npressures = [\"50 MPa\"]\nnominal_area = ";
    CHECK(causes(of_map + "\"4096 um^2\"\n")[at(Cause::form)].low == 0);
    CHECK(causes(of_map + "\"1 mm^2\"\n")[at(Cause::form)].low < 0);
}

TEST_CASE("A scene takes a flatness, a map of the gap, a washer and a bolt") {
    const auto stiffness = [](const std::string& text) {
        return test::results_of(text).answer.points[0].stiffness.value;
    };
    const double crown = stiffness(of_area + "flatness = \"10 um\"\n");
    CHECK(test::relative_error(crown, K(plates(1e-5), 1e7)) < 1e-9);
    const test::Folder folder;
    HeightMap<double> gap{HeightMap<double>::Array(64, 64), side / 64, side / 64};
    for (Eigen::Index j = 0; j < 64; ++j)
        for (Eigen::Index i = 0; i < 64; ++i) {
            const double x = (2 * double(i) + 1) / 64 - 1, y = (2 * double(j) + 1) / 64 - 1;
            gap.heights(j, i) = 1e-5 * std::min(1.0, x * x + y * y);
        }
    const std::string form = "form = '" + folder.write("gap.txt", test::file_text(gap)) + "'\n";
    CHECK(test::relative_error(stiffness(of_area + form), crown) <
          0.02);  // the plane of the crown is not quite its own
    CHECK(test::relative_error(stiffness(surface + "pressures = [\"10 MPa\"]\n" + form), crown) < 0.02);

    const std::string force = surface + "force = \"12 kN\"\nflatness = \"5 um\"\n";
    const auto washer = test::results_of(force + "washer = { inner = \"11 mm\", outer = \"20 mm\" }\n"),
               bolt = test::results_of(force + "bolt = { size = \"M10\", under = \"washer\" }\n");
    CHECK(bolt.answer.points[0].stiffness.value == washer.answer.points[0].stiffness.value);
    CHECK(test::relative_error(*bolt.scene->joint.nominal_area, std::numbers::pi / 4 * (400e-6 - 121e-6)) < 1e-12);
    const auto head = test::results_of(surface + "force = \"12 kN\"\nbolt = \"M10\"\n");
    CHECK(test::relative_error(*head.scene->joint.nominal_area, std::numbers::pi / 4 * (14.63e-3 * 14.63e-3 - 121e-6)) <
          1e-12);
}

TEST_CASE(
    "Waves that are longer than a piece lower K of a larger face, and the band reaches from none of them to all") {
    const test::Folder folder;
    const HeightMap<double> whole = self_affine_map<double>({.hurst = 0.8,
                                                             .rms = 1e-6,
                                                             .longest_wavelength = 1e-3,
                                                             .shortest_wavelength = 4e-6,
                                                             .exact_rms = false,
                                                             .seed = 3},
                                                            256, 256, 1e-6, 1e-6);
    HeightMap<double> piece{whole.heights.block(64, 64, 64, 64), 1e-6, 1e-6};
    const std::string scene = "[surface]\nfrom = '" + folder.write("piece.txt", test::file_text(piece)) +
                              "'\n[contact]\npressures = [\"50 MPa\"]\n";
    const auto own = test::results_of(scene), larger = test::results_of(scene + "nominal_area = \"65536 um^2\"\n");
    const AnswerPoint &a = own.answer.points[0], &b = larger.answer.points[0];
    CHECK(own.answer.long_waves == 1);
    CHECK(larger.answer.long_waves < 0.8);
    CHECK(test::relative_error(b.stiffness.value, a.stiffness.value * larger.answer.long_waves) < 1e-12);
    CHECK(test::relative_error(b.state.separation.value, a.state.separation.value / larger.answer.long_waves) < 1e-12);
    const CauseSpread<double> waves = b.causes[at(Cause::long_waves)];
    CHECK(test::relative_error(waves.high, -std::log(larger.answer.long_waves)) < 1e-12);
    CHECK(b.stiffness.high > a.stiffness.value);
    CHECK(test::joined(larger.explanation).find("longer waves of a face of this size lower K to") != std::string::npos);
}

TEST_CASE("A form that does not suit is refused in one sentence") {
    const test::Folder folder;
    const std::string rough = folder.write(
        "rough.txt",
        test::map_text(256, 2e-4,
                       {.hurst = 0.8, .rms = 0.3e-6, .longest_wavelength = 1e-3, .shortest_wavelength = 4e-4}));
    const std::vector<std::vector<std::string>> rows{
        {surface + "pressures = [\"10 MPa\"]\nflatness = \"10 um\"\n", "contact.flatness",
         "needs contact.nominal_area"},
        {of_area + "flatness = \"-1 um\"\n", "contact.flatness", "must be finite and not negative"},
        {of_area + "flatness = \"10 MPa\"\n", "contact.flatness", "10 MPa"},
        {of_area + "flatness = \"1 um\"\nform = 'gap.txt'\n", "contact.flatness",
         "must not be given with contact.form"},
        {surface + "pressures = [\"10 MPa\"]\nform = '" + rough + "'\n", "contact.form", "and not their roughness"},
        {of_area + "form = 'none.txt'\n", "none.txt"},
        {surface + "nominal_area = \"1 mm^2\"\npressures = [\"10 MPa\"]\nform = '" + rough + "'\n", "contact.form",
         "must be that of contact.nominal_area"},
        {surface + "nominal_area = \"1 mm^2\"\nseparations = [\"1 um\"]\nflatness = \"1 um\"\n", "contact.separations",
         "must not be given with a flatness"},
        {surface + "force = \"1 kN\"\nbolt = \"M11\"\n", "contact.bolt", "M10"},
        {surface + "force = \"1 kN\"\nbolt = { size = \"M10\", under = \"nut\" }\n", "contact.bolt.under", "washer"},
        {of_area + "greatest_pressure = \"0 MPa\"\n", "contact.greatest_pressure", "greater than 0"},
        {of_area + "aspect_ratio = 0.5\n", "contact.aspect_ratio", "from 1 to 1000"},
        {surface + "pressure = \"1 MPa\"\naspect_ratio = 2\n", "contact.aspect_ratio", "needs contact.nominal_area"},
        {surface + "force = \"1 kN\"\nbolt = \"M10\"\naspect_ratio = 2\n", "contact.aspect_ratio",
         "must not be given with"}};
    for (const auto& row : rows) test::check_sentence(test::refused_scene(row[0]), {row.begin() + 1, row.end()});
    Joint joint = plates(-1e-6);
    CHECK(test::refused_for("flatness", [&] { (void)answer(joint, 1e7); }));
    joint = plates(1e-6), joint.nominal_area.reset();
    CHECK(test::refused_for("needs nominal_area", [&] { (void)answer(joint, 1e7); }));
    joint = plates(1e-6);
    CHECK(test::refused_for("must not be given with separations",
                            [&] { (void)answer(joint, 1e-6, {.at_separations = true}); }));
}

TEST_CASE("After an earlier load K lies between that of the first loading and that at the greatest pressure") {
    Joint first = plates(0), after = plates(0);
    after.greatest_pressure = 1e8;
    const double greatest = K(first, 1e8), h = *answer(first, {1e7}, {.samples = 0}).relative_hardness;
    for (const double p : {1e6, 1e7, 5e7}) {
        const AnswerPoint point = answer(after, p, {.samples = 0});
        const double ratio = K(first, p) / greatest;
        CHECK(test::relative_error(point.stiffness.value / greatest, detail::stiffness_after_load(ratio, h)) < 1e-6);
        CHECK(point.stiffness.value > K(first, p));
        CHECK(point.stiffness.value < greatest);
        CHECK(point.loading_stiffness.value_or(0) == point.stiffness.value);
        CHECK(point.causes[at(Cause::law)].low < answer(first, p).causes[at(Cause::law)].low);
    }
    for (const double p : {1e8, 2e8}) CHECK(K(after, p) == K(first, p));  // a first loading goes on
    for (Joint* joint : {&first, &after})
        joint->upper.hardness = joint->lower.hardness = std::numeric_limits<double>::infinity();
    CHECK(K(after, 1e7) == K(first, 1e7));  // elastic bodies have no memory
    const auto said = test::results_of(of_area + "greatest_pressure = \"100 MPa\"\n").explanation;
    CHECK(test::contains(test::joined(said), "The peaks yielded under 100 MPa (H/(E g) = 0.13)."));
    CHECK(test::relative_error(test::results_of(of_area + "flatness = \"0 um\"\ngreatest_pressure = \"100 MPa\"\n")
                                   .answer.points[0]
                                   .stiffness.value,
                               greatest * detail::stiffness_after_load(K(plates(0), 1e7) / greatest, h)) < 1e-6);
}

TEST_CASE("A map that has carried more is flattened and pressed again, and the law of earlier loads agrees with it") {
    const test::Folder folder;
    const std::string scene = "[surface]\nfrom = '" +
                              folder.write("map.txt", test::file_text(test::corner_of_map(96))) +
                              "'\n[material]\nupper = \"C45\"\n[contact]\n",
                      loads = "pressures = [\"3 MPa\", \"30 MPa\", \"299.9 MPa\", \"400 MPa\"]\n";
    const auto first = test::results_of(scene + loads),
               after = test::results_of(scene + loads + "greatest_pressure = \"300 MPa\"\n"),
               all = test::results_of(scene + "pressures = [\"300 MPa\"]\n");
    const double greatest = all.answer.points[0].stiffness.value;
    for (std::size_t i = 0; i < 2; ++i) {
        const AnswerPoint &a = first.answer.points[i], &b = after.answer.points[i];
        const double K = b.stiffness.value, by_law = detail::stiffness_after_load(a.stiffness.value / greatest,
                                                                                  *first.answer.relative_hardness);
        CAPTURE(i, a.stiffness.value, K, greatest, by_law * greatest);
        CHECK(K > a.stiffness.value);
        CHECK(K < greatest);
        CHECK(std::abs(std::log(K / (by_law * greatest))) < std::log(1.45));  // the law is right to 45 %
        CHECK(b.loading_stiffness.value_or(0) == K);
        CHECK(b.causes[at(Cause::law)].low > a.causes[at(Cause::law)].low - 0.1);
    }
    const double end = after.answer.points[2].stiffness.value;
    CHECK(test::relative_error(end, greatest) < 0.01);  // K of unloading, by two solvers
    CHECK(after.answer.points[3].stiffness.value == first.answer.points[3].stiffness.value);
}

TEST_CASE("A long rectangle has the form of its own sides") {
    Joint square = plates(1e-5), equal = square, strip = square;
    equal.aspect_ratio = 1, strip.aspect_ratio = 8;
    CHECK(K(equal, 1e7) == K(square, 1e7));
    const double of_strip = K(strip, 1e7), sides = std::sqrt(8.0);
    const AnswerPoint flat = answer(plates(0), 1e7, {.samples = 0});
    Joint turned = strip;
    turned.form = std::make_shared<const JointForm>(JointForm::crown(side / sides, side * sides, 1e-5));
    turned.flatness.reset(), turned.aspect_ratio.reset();
    CHECK(test::relative_error(K(turned, 1e7), of_strip) < 1e-9);
    CHECK(of_strip < flat.stiffness.value);
    CHECK(of_strip != K(square, 1e7));
    CHECK(test::relative_error(
              test::results_of(of_area + "flatness = \"10 um\"\naspect_ratio = 8\n").answer.points[0].stiffness.value,
              of_strip) < 1e-9);
}

TEST_CASE("A family of alloys has a range of conductivities in the band of heat, an alloy or a number has none") {
    const auto heat = [](const char* material) {
        const auto results =
            test::results_of(surface.substr(0, surface.find("[material]")) + "[material.upper]\n" + material +
                             "\n[contact]\npressures = [\"10 MPa\"]\n[output]\nquantities = "
                             "[\"thermal_conductance\"]\n");
        return results.answer.points[0].find("thermal_conductance")->number;
    };
    const WithBand family = heat("name = \"aluminium\""),
                   number = heat("name = \"aluminium\"\nthermal_conductivity = \"165 W/(m K)\"");
    CHECK(family.value == number.value);
    // both bodies: the harmonic mean with one end, by squares
    const double soft = std::log(2 * 115 / (115 + 165.0)), low = std::log(number.value / number.low);
    CHECK(test::relative_error(std::log(family.value / family.low), std::hypot(low, std::sqrt(2.0) * soft)) < 1e-9);
    CHECK(family.high > number.high);
}

}  // namespace flatness_test
