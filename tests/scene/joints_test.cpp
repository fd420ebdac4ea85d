// SPDX-License-Identifier: BSD-3-Clause
// Joints: forces, washers, K of the whole area, the approach, and bodies by name. Truth: closed forms and the same
// scene in pressures and numbers.
#include "support/library.hpp"

#include <fstiff/asperity/named_materials.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace joints_test {

namespace {

using namespace fstiff;
using test::input_of;

const std::string surface =
    "[surface]\nrms_height = \"0.8 um\"\nrms_gradient = 0.1\nalpha = 5\nerrors = { rms_height = \"0.08 um\" }\n";
const std::string laws = "laws = [\"hybrid\", \"hertz\", \"persson\"]\n";
const std::string few = "[uncertainty]\nsamples = 20\n";

bool has(const test::Csv& rows, const std::string& column) {
    return std::count(rows.header().begin(), rows.header().end(), column) > 0;
}

std::string trace() {
    return test::profile_text(2048, 1e-6, {.hurst = 0.8, .rms = 0.4e-6, .longest_wavelength = 200e-6, .seed = 4});
}

/// 1/E of a body of (3.15).
double compliance(double modulus, double poisson) { return (1 - poisson * poisson) / modulus; }

/// What was assumed of the bodies and waves, not of the surface, whose numbers have a range.
std::vector<std::string> of_bodies(const scene::Scene& scene) {
    std::vector<std::string> all = scene.assumptions;
    std::erase_if(all, [](const std::string& one) { return test::contains(one, " to "); });
    return all;
}

}  // namespace

TEST_CASE("A force over the nominal area is a pressure, and K of the joint is K/A0 times the area") {
    const test::Csv forces = test::rows_of_scene(surface + "[contact]\nforce = [\"2 kN\", \"20 kN\"]\n" +
                                                 "nominal_area = \"200 mm^2\"\n" + laws + few),
                    pressures = test::rows_of_scene(surface + "[contact]\npressures = [\"10 MPa\", \"100 MPa\"]\n" +
                                                    "nominal_area = \"200 mm^2\"\n" + laws + few);
    REQUIRE(forces.size() == 6);
    REQUIRE(pressures.size() == 6);
    for (std::size_t i = 0; i < forces.size(); ++i) {
        CHECK(test::relative_error(forces.number(i, "force_N"), i % 2 ? 2e4 : 2e3) < 1e-15);
        CHECK(test::relative_error(forces.number(i, "pressure_Pa"), i % 2 ? 1e8 : 1e7) < 1e-14);
        for (const char* end : {"", "_p05", "_p95"}) {
            const std::string key = std::string("stiffness") + end;
            const double k = forces.number(i, key + "_Pa_per_m");
            CHECK(test::relative_error(k, pressures.number(i, key + "_Pa_per_m")) < 1e-12);
            CHECK(test::relative_error(forces.number(i, key + "_N_per_m"), 2e-4 * k) < 1e-15);
        }
    }
    for (const char* column : {"force_N", "stiffness_N_per_m", "approach_m"}) CHECK(!has(pressures, column));
}

TEST_CASE("One force, a list and a range are points, and the scene keeps the forces") {
    const std::string rest = "nominal_area = \"0.5 cm^2\"\n" + laws;
    const auto read = [&](const std::string& force) {
        return test::scene_of(surface + "[contact]\nforce = " + force + "\n" + rest);
    };
    const auto one = read("\"1 kN\""), range = read("{ from = \"10 N\", to = \"1 kN\", count = 3 }");
    CHECK(one.forces == std::vector<double>{1000});
    CHECK(input_of(one, "contact.force").value == 1000);
    CHECK(input_of(one, "contact.force").unit == "N");
    REQUIRE(range.forces.size() == 3);
    CHECK(test::relative_error(range.forces[1], 100.0) < 1e-14);  // in equal steps of the logarithm
    for (std::size_t i = 0; i < 3; ++i) CHECK(range.points[i] == range.forces[i] / 0.5e-4);
    CHECK(one.shown_point(0) == "1 kN, 20 MPa");
    CHECK(input_of(one, "contact.seating").value == 1e3);
}

TEST_CASE("The nominal area of a washer is that of its ring") {
    const auto read = [&](const std::string& washer) {
        return test::scene_of(surface + "[contact]\npressures = [\"10 MPa\"]\nwasher = " + washer + "\n" + laws);
    };
    const auto m8 = read("{ inner = \"8.4 mm\", outer = \"16 mm\" }");
    const double pi = std::numbers::pi;
    CHECK(test::relative_error(*m8.joint.nominal_area, pi / 4 * (16e-3 * 16e-3 - 8.4e-3 * 8.4e-3)) < 1e-14);
    CHECK(test::relative_error(*read("{ inner = \"0 mm\", outer = \"2 mm\" }").joint.nominal_area, pi * 1e-6) < 1e-14);
    CHECK(input_of(m8, "contact.nominal_area").value == m8.joint.nominal_area);
    CHECK(m8.asks("joint_stiffness"));
    CHECK(m8.asks("approach"));
}

TEST_CASE("A smooth ball is that of Hertz, and one of peaks that yield has two stiffnesses") {
    const auto scene = [](const std::string& sigma, const std::string& forces) {
        return test::scene_of(
            "[surface]\nrms_height = \"" + sigma +
            "\"\nrms_gradient = 0.1\n[material]\nupper = \"steel\"\n[contact]\nball_radius = \"10 mm\"\n"
            "force = " +
            forces + "\n");
    };
    const actions::Answered smooth = actions::compute(scene("0.2 nm", "\"50 N\""));
    REQUIRE(smooth.balls.size() == 1);
    REQUIRE(smooth.balls[0].reason.empty());
    CHECK(test::relative_error(smooth.balls[0].contact.stiffness, smooth.balls[0].hertz.stiffness) < 2e-3);
    CHECK(test::relative_error(smooth.balls[0].contact.approach, smooth.balls[0].hertz.approach) < 2e-3);

    const scene::Scene rough = scene("0.3 um", "[\"1 N\", \"10 N\", \"1 kN\"]");
    const actions::Answered results = actions::compute(rough);
    auto document = run_document(results);
    const nlohmann::json rows = test::parsed(document)["ball"];
    const test::Csv csv(document_of(results).csv());
    REQUIRE(rows.size() == 3);
    REQUIRE(csv.size() == 3);
    for (std::size_t i = 0; i < 2; ++i) {
        const ContactOfBall<double>& contact = results.balls[i].contact;
        CHECK(contact.loading_stiffness < contact.stiffness);
        CHECK(contact.radius > results.balls[i].hertz.radius);
        CHECK(results.balls[i].low <= contact.stiffness);
        CHECK(contact.stiffness <= results.balls[i].high);
        CHECK(rows[i]["stiffness_N_per_m"] == contact.stiffness);
        CHECK(rows[i]["loading_stiffness_N_per_m"] == contact.loading_stiffness);
        CHECK(csv.number(i, "stiffness_p05_N_per_m") == results.balls[i].low);
        CHECK(csv.number(i, "hertz_max_pressure_Pa") == results.balls[i].hertz.pressure);
        CHECK(test::relative_error(rows[i]["mean_pressure_Pa"].get<double>(),
                                   results.balls[i].hertz.load / (std::numbers::pi * contact.radius * contact.radius)) <
              1e-15);
    }
    // the hardness of steel is taken as 2.6 GPa, which 1 kN exceeds
    CHECK(!results.balls[2].reason.empty());
    CHECK(!rows[2].contains("stiffness_N_per_m"));
    CHECK(rows[2].contains("hertz_stiffness_N_per_m"));
    CHECK(results.doubtful);
    CHECK(test::contains(test::joined(results.warnings),
                         "the ball under 1 kN has no contact: pressure of the ball = 2.8"));
    const std::string text = document_of(results).text();
    for (const char* part : {"a [µm]", "loading K", "ball of radius 10 mm", "few contacts;"})
        CHECK(test::contains(text, part));
    // faces that a ball closes are smooth at its centre
    const actions::Answered closed = actions::compute(test::scene_of(
        "[surface]\nrms_height = \"0.3 um\"\nrms_gradient = 0.05\n[material.upper]\nyoungs_modulus = \"3 GPa\"\n"
        "poisson_ratio = 0.4\nhardness = \"infinite\"\n[contact]\nball_radius = \"3 mm\"\nforce = \"10 N\"\n"));
    REQUIRE(closed.balls[0].reason.empty());
    CHECK(closed.balls[0].contact.pressure > closed.answer.points.back().state.pressure.value);
    CHECK(test::relative_error(closed.balls[0].contact.stiffness, closed.balls[0].hertz.stiffness) < 0.03);
    // 1.6 times 2.57/2.8 GPa
    CHECK(test::contains(test::joined(actions::compute(scene("0.1 um", "[\"10 N\", \"160 N\"]")).warnings),
                         "the ball under 160 N yields below its face"));
}

TEST_CASE("The approach is 0 at the seating pressure and grows by dp/K") {
    const test::Csv rows = test::rows_of_scene(
        surface + "[contact]\npressures = [\"0.05 MPa\", \"9.99 MPa\", \"10 MPa\", \"10.01 MPa\"]\n" +
        "seating = \"0.05 MPa\"\n" + laws + "[output]\nquantities = [\"stiffness\", \"approach\", \"separation\"]\n" +
        few);
    for (std::size_t law = 0; law < 3; ++law) {
        const auto at = [&](std::size_t i, const char* column) { return rows.number(4 * law + i, column); };
        INFO(rows.text(4 * law, "law"));
        CHECK(at(0, "approach_m") == 0);
        for (std::size_t i = 1; i < 4; ++i) CHECK(at(i, "approach_m") == at(0, "separation_m") - at(i, "separation_m"));
        const double slope = (at(3, "approach_m") - at(1, "approach_m")) / 0.02e6;
        CHECK(test::relative_error(slope, 1 / at(2, "stiffness_Pa_per_m")) < 1e-5);
    }
    CHECK(!has(rows, "stiffness_N_per_m"));
}

TEST_CASE("A law that does not reach the seating pressure has no approach, with a reason") {
    const auto results = test::results_of(surface + "[contact]\npressures = [\"10 MPa\"]\nseating = \"10 TPa\"\n" +
                                          laws + "[output]\nquantities = [\"approach\", \"stiffness\"]\n" + few);
    CHECK(test::contains(test::joined(results.warnings), "law persson has no approach: "));
    const test::Csv rows(test::csv_of(results));
    CHECK(rows.text(2, "law") == "persson");
    CHECK(rows.text(2, "approach_m").empty());
    CHECK(rows.number(2, "stiffness_Pa_per_m") > 0);
}

TEST_CASE("Where boundary elements of the map answer, the approach begins at theirs") {
    const test::Folder folder;
    folder.write(
        "map.txt",
        test::map_text(
            64, 1e-6,
            {.hurst = 0.8, .rms = 0.3e-6, .longest_wavelength = 16e-6, .shortest_wavelength = 4e-6, .seed = 2}));
    const std::string text =
        "material.upper = { name = \"steel\", hardness = \"infinite\" }\n[surface]\nfrom = "
        "\"map.txt\"\n[contact]\nforce = \"0.8 N\"\n"
        "nominal_area = \"4000 um^2\"\n";
    const std::string file = folder.write("joint.toml", text);
    const auto best = test::results_of(text, file),
               elements = test::results_of(text + "laws = [\"boundary_elements\"]\n", file);
    REQUIRE(best.has_answer());
    REQUIRE(best.answer.points[0].law == LawKind::boundary_elements);
    const auto approach = [](const AnswerCurve& curve) { return test::value_at(curve, 0, "approach").value(); };
    CHECK(approach(elements.curves().front()) > 0);
    CHECK(test::relative_error(approach(best.answer), approach(elements.curves().front())) < 1e-9);
}

TEST_CASE("Two rough faces of two named materials under a force are one face of the closed forms") {
    const double modulus = 1 / (compliance(210e9, 0.3) + compliance(100.6e9, 0.35));
    const auto named = test::results_of(
        "material.upper = \"steel\"\nmaterial.lower = \"Brass\"\n"
        "[surface.upper]\nrms_height = \"0.6 um\"\nrms_gradient = 0.06\nalpha = 5\n"
        "[surface.lower]\nrms_height = \"0.8 um\"\nrms_gradient = 0.08\nalpha = 5\n"
        "[contact]\nforce = \"15 kN\"\nnominal_area = \"300 mm^2\"\n" +
        laws);
    CHECK(test::ulps(named.answer.effective_modulus, modulus) <= 4);
    // one face with the added m0, m2 and m4, on bodies of another modulus: K and p scale with it
    const auto unit = test::results_of(
        "[surface]\nrms_height = \"1 um\"\nrms_gradient = 0.1\nalpha = 5\n"
        "[material.upper]\nyoungs_modulus = \"2 GPa\"\npoisson_ratio = 0\n"
        "[contact]\npressures = [\"" +
        document::exact(50e6 / modulus * 1e9) + " Pa\"]\n" + laws);
    REQUIRE(named.curves().size() == unit.curves().size());
    CHECK(test::relative_error(unit.answer.effective_modulus, 1e9) < 1e-15);
    const auto k = [](const actions::Answered& results, std::size_t curve, std::string_view quantity) {
        return test::value_at(results.curves()[curve], 0, quantity).value();
    };
    CHECK(test::relative_error(k(named, 0, "pressure"), 50e6) < 1e-12);
    for (std::size_t i = 0; i < named.curves().size(); ++i) {
        INFO(fstiff::name_of(named.curves()[i].law));
        const double truth = k(unit, i, "stiffness") * modulus / 1e9;
        CHECK(test::relative_error(k(named, i, "stiffness"), truth) < 1e-9);
        CHECK(test::relative_error(k(named, i, "joint_stiffness"), k(named, i, "stiffness") * 300e-6) < 1e-15);
    }
}

TEST_CASE(
    "A body is a name, or a section that begins from one. Both are steel without either and the scene records it") {
    const std::string contact = "[contact]\npressures = [\"10 MPa\"]\n" + laws;
    const auto steel = test::scene_of(surface + contact);
    CHECK(of_bodies(steel) == std::vector<std::string>{"both bodies steel, 210 GPa, nu 0.3"});
    CHECK(steel.joint.lower.youngs_modulus == 210e9);
    CHECK(input_of(steel, "material.upper").shown() == "steel (default)");
    const auto mixed = test::scene_of("material.upper = \"cast iron\"\n" + surface +
                                      "[material.lower]\nname = \"PMMA\"\nyoungs_modulus = \"3 GPa\"\n"
                                      "hardness = \"0.3 GPa\"\n" +
                                      contact);
    CHECK(of_bodies(mixed).empty());
    CHECK(mixed.joint.upper.youngs_modulus == 110e9);
    CHECK(mixed.joint.upper.poisson_ratio == 0.26);
    CHECK(mixed.joint.lower.youngs_modulus == 3e9);
    CHECK(mixed.joint.lower.poisson_ratio == 0.37);
    CHECK(mixed.joint.hardness == 0.3e9);
    CHECK(mixed.joint.softer_poisson == 0.37);
    CHECK(input_of(mixed, "material.upper").written == "cast iron");
    CHECK(input_of(mixed, "material.upper.youngs_modulus").value == 110e9);
    CHECK(input_of(mixed, "material.lower.poisson_ratio").shown() == "of PMMA (default)");
    CHECK(input_of(mixed, "material.lower.youngs_modulus").written == "3 GPa");
}

TEST_CASE("Every named material is a body of waves, but polymers whose speeds are not known") {
    for (const auto& one : fstiff::detail::named_materials) {
        INFO(one.name);
        const std::string scene = "material.upper = \"" + std::string(one.name) + "\"\n" + surface +
                                  "[contact]\npressures = [\"10 MPa\"]\n" + laws +
                                  "[ultrasound]\nfrequency = \"5 MHz\"\n";
        if (one.longitudinal_velocity == 0 && one.elastic.youngs_modulus < 15e9) {
            test::check_sentence(test::refused_scene(scene),
                                 {"ultrasound.upper.impedance", "missing", "density and", "velocity"});
            continue;
        }
        const auto waves = *test::scene_of(scene).joint.ultrasound;
        CHECK(waves.longitudinal.incident == one.density * one.wave_speeds().first);
        CHECK(waves.shear->incident == one.density * one.wave_speeds().second);
    }
}

TEST_CASE("The waves of a scene take density and speeds of the named bodies, and record it") {
    const std::string begin = "material = { upper = \"steel\", lower = \"aluminium\" }\n" + surface +
                              "[contact]\npressures = [\"10 MPa\"]\n" + laws + "[ultrasound]\nfrequency = \"5 MHz\"\n";
    const auto both = test::scene_of(begin);
    CHECK(both.joint.ultrasound->longitudinal.incident == 7850 * 5960.0);
    CHECK(both.joint.ultrasound->longitudinal.beyond == 2700 * 6420.0);
    CHECK(both.joint.ultrasound->shear->beyond == 2700 * 3040.0);
    REQUIRE(of_bodies(both).size() == 2);
    CHECK(of_bodies(both)[1] ==
          "ultrasound.lower as aluminium: density 2700 kg/m^3, velocity 6420 m/s, shear_velocity 3040 m/s");
    CHECK(input_of(both, "ultrasound.upper.velocity").value == 5960);
    const auto part =
        test::scene_of(begin + "upper = { velocity = \"5900 m/s\" }\nlower = { impedance = \"17 MRayl\" }\n");
    CHECK(part.joint.ultrasound->longitudinal.incident == 7850 * 5900.0);
    CHECK(part.joint.ultrasound->longitudinal.beyond == 17e6);
    CHECK(!part.joint.ultrasound->shear);  // of a body that gives its impedance no more is taken
    const auto given = test::scene_of(begin + "upper = { impedance = \"46 MRayl\", shear_impedance = \"25 MRayl\" }\n");
    CHECK(given.joint.ultrasound->longitudinal.incident == 46e6);
    CHECK(given.joint.ultrasound->shear->beyond == 2700 * 3040.0);
    const auto like = test::scene_of(test::replaced(begin, "aluminium", "steel"));
    CHECK(like.joint.ultrasound->longitudinal.beyond == 7850 * 5960.0);
    CHECK(input_of(like, "ultrasound.lower").shown() == "as ultrasound.upper (default)");
    CHECK(of_bodies(like).size() == 1);
}

TEST_CASE("A surface in place of that of the built-in scene has its bodies, with a note, and not its area") {
    const test::Folder folder;
    const std::string file = folder.write("trace.csv", trace());
    const auto own = scene::read_scene(scene::builtin_scene, {.name = "built-in scene"}),
               of_file = scene::read_scene(scene::builtin_scene, {.name = "built-in scene", .surface = file});
    CHECK(of_bodies(own).empty());
    CHECK(own.joint.nominal_area == 195e-6);
    CHECK(of_bodies(of_file) == std::vector<std::string>{"the material, which is the steel of the built-in scene"});
    CHECK(!of_file.joint.nominal_area);
    CHECK_THROWS_AS(input_of(of_file, "contact.nominal_area"), std::runtime_error);
}

TEST_CASE("data/bolted_joint.toml is the joint that docs/bolted-joint.md describes") {
    const std::string text = test::read(FSTIFF_SCENES "/bolted_joint.toml");
    const auto results = test::results_of(text);
    CHECK(test::relative_error(results.answer.effective_modulus,
                               1 / (compliance(210e9, 0.3) + compliance(110e9, 0.26))) < 1e-14);
    const std::string docs = test::read(FSTIFF_SCENES "/../docs/bolted-joint.md");
    CHECK(test::contains(docs, text.substr(text.find("[material]"))));
}

TEST_CASE("The table of materials of docs/hardness.md is that of the library") {
    const std::string docs = test::read(FSTIFF_SCENES "/../docs/hardness.md");
    for (const auto& one : fstiff::detail::named_materials) {
        const auto cell = [](double value, int digits = 6) { return " | " + document::rounded(value, digits); };
        const auto [low, middle, high] = one.hardness();
        const std::string name = "| `" + std::string(one.name) + "`";
        const std::string row = cell(one.elastic.youngs_modulus / 1e9) + cell(one.elastic.poisson_ratio) +
                                cell(one.density) + cell(low / 1e9, 2) + ", " + document::rounded(middle / 1e9, 2) +
                                ", " + document::rounded(high / 1e9, 2) + " | " + std::string(one.source) + " |\n";
        const std::string waves = name + cell(one.longitudinal_velocity) + cell(one.shear_velocity) +
                                  cell(one.thermal_conductivity) + cell(one.electrical_conductivity / 1e6) + " |\n";
        CHECK(test::contains(docs, name + " | "));
        CHECK(test::contains(docs, waves) == (one.longitudinal_velocity > 0));
        INFO(row);
        CHECK(test::contains(docs, row));
    }
}

}  // namespace joints_test
