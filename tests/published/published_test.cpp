// SPDX-License-Identifier: BSD-3-Clause
// Claims of docs/published.md about fstiff against measurements and simulations of others (tests/data/published, whose
// sources are in tests/data/README.md). The bounds are what was found; the case states where a law fails.
#include "support/library.hpp"
#include "support/table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>
#include <sstream>

namespace published_test {

using nlohmann::json;

namespace {

json run(const std::string& text) {
    const auto scene = test::scene_of(text);
    return test::parsed(fstiff::actions::run_document(fstiff::actions::compute(scene)));
}

std::string quoted(double value, const char* unit) {
    char text[60];
    std::snprintf(text, sizeof text, "\"%.9g %s\"", value, unit);
    return text;
}

/// The surface of the simulation, E = 1 GPa, sigma = 1 um.
std::string gaussian(const std::vector<double>& stars, const char* laws = "") {
    std::string list;
    for (const double star : stars) list += (list.empty() ? "" : ", ") + quoted(star * 0.276597, "GPa");
    return "[surface]\nrms_height = \"1 um\"\nrms_gradient = 0.276597\nalpha = 139.79\nhurst = 0.8\nskewness = "
           "0\nkurtosis = 3\n"
           "[material.upper]\nyoungs_modulus = \"2 GPa\"\npoisson_ratio = 0\nhardness = "
           "\"infinite\"\n[contact]\npressures = [" +
           list + "]\n" + laws + "[output]\nquantities = [\"stiffness\", \"separation\", \"real_area\"]\n";
}

struct Heat {
    double gap, spots, low, high;
};

std::vector<Heat> heat(const std::string& text) {
    std::vector<Heat> all;
    const json document = run(text);
    for (const json& row : document["answer"])
        all.push_back({row["thermal_conductance_gap_W_per_m2K"], row["thermal_conductance_W_per_m2K"],
                       row["thermal_conductance_p05_W_per_m2K"], row["thermal_conductance_p95_W_per_m2K"]});
    return all;
}

/// A joint as a user has it in hand, and what was measured at its pressures [MPa]: h [W/(m^2 K)] or K [MPa/um].
struct MeasuredJoint {
    std::string group, quantity, scene;  ///< the scene without the pressures; `@` for what belongs to an area
    std::vector<double> pressures{}, measured{};
};

constexpr const char* of_flat_faces = "flatness = \"0 um\"\n";

std::string scene_of_joint(const std::array<std::string, 2>& bodies, const std::string& process,
                           const std::string& height, const std::string& area, const std::string& medium) {
    const std::string face = "{ " + height + ", process = \"" + process + "\" }\n";
    return "material = { upper = { " + bodies[0] + " }, lower = { " + bodies[1] + " } }\n[surface]\nupper = " + face +
           "lower = " + face + (medium.empty() ? "" : "[gap]\nmedium = \"" + medium + "\"\n") + "[contact]\n" +
           (area.empty() ? "" : "nominal_area = \"" + area + " mm^2\"\n@");
}

std::vector<double> numbers_of(const std::string& text) {
    std::istringstream stream(text);
    return {std::istream_iterator<double>(stream), {}};
}

/// Those of bench/make_published.py: measured_joints.csv and the handbook, in 30 joints.
std::vector<MeasuredJoint> measured_joints() {
    std::vector<MeasuredJoint> joints;
    const test::Table table("published/measured_joints.csv");
    for (std::size_t i = 0; i < table.size(); ++i) {
        const auto text = [&](const std::string& key) { return table.text(i, key); };
        const auto body = [&](const std::string& side) {
            const std::string name = text(side), conductivity = text("conductivity_" + side + "_W_per_mK");
            const std::string constants =
                name == "silicon" ? "youngs_modulus = \"160 GPa\", poisson_ratio = 0.22, hardness = \"11 GPa\""
                : name == "beryllium_copper"
                    ? "youngs_modulus = \"128 GPa\", poisson_ratio = 0.3, hardness = \"3.7 GPa\""
                    : "name = \"" + name + "\"";
            return constants +
                   (conductivity.empty() ? "" : ", thermal_conductivity = \"" + conductivity + " W/(m K)\"");
        };
        const std::string height = text("kind_of_height") + " = \"" + text("height_um") + " um\"";
        joints.push_back(
            {text("group"), text("quantity"),
             scene_of_joint({body("upper"), body("lower")}, text("process"), height, text("area_mm2"), text("medium")),
             numbers_of(text("pressures_MPa")), numbers_of(text("measured"))});
    }
    const test::Table handbook("published/joints.csv");
    for (std::size_t i = 0; i < handbook.size(); ++i) {
        const auto middle = [&](const std::string& key, const std::string& unit) {
            return std::sqrt(handbook.input(i, key + "_from_" + unit) * handbook.input(i, key + "_to_" + unit));
        };
        const auto name = [&](const char* side) { return "name = \"" + handbook.text(i, side) + "\""; };
        MeasuredJoint joint{"handbook", "conductance",
                            scene_of_joint({name("upper"), name("lower")}, handbook.text(i, "process"),
                                           "rms_height = " + quoted(middle("roughness", "um"), "um"), "625",
                                           handbook.text(i, "medium"))};
        if (joints.back().scene != joint.scene) joints.push_back(joint);
        joints.back().pressures.push_back(middle("pressure", "MPa"));
        joints.back().measured.push_back(handbook.input(i, "h_W_per_m2K"));
    }
    return joints;
}

/// How much of the joints the band holds: the mean over those outside of air between aluminium, points by group.
struct Coverage {
    double joints = 0;
    std::size_t points = 0;
    std::map<std::string, int> inside{};
    std::vector<double> widths{}, widths_of_steel_from_10_MPa{};
};

Coverage coverage(const std::vector<MeasuredJoint>& joints, const std::string& form) {
    Coverage all;
    double count = 0;
    for (const MeasuredJoint& joint : joints) {
        std::string scene = joint.scene, list;
        if (const auto place = scene.find('@'); place != std::string::npos) scene.replace(place, 1, form);
        for (const double p : joint.pressures) list += (list.empty() ? "" : ", ") + quoted(p, "MPa");
        scene += "pressures = [" + list + "]\n";
        int inside = 0;
        const bool counts = joint.group != "aluminium in air";
        const auto take = [&](std::size_t i, double low, double high) {
            inside += low <= joint.measured[i] && joint.measured[i] <= high;
            if (!counts) return;
            ++all.points;
            all.widths.push_back(high / low);
            if (joint.group == "ground and lapped steel and iron" && joint.pressures[i] >= 10)
                all.widths_of_steel_from_10_MPa.push_back(high / low);
        };
        if (joint.quantity == "conductance") {
            const std::vector<Heat> found = heat(scene);
            for (std::size_t i = 0; i < found.size(); ++i)
                take(i, found[i].gap + found[i].low, found[i].gap + found[i].high);
        } else {
            const json answer = run(scene)["answer"];
            for (std::size_t i = 0; i < answer.size(); ++i) {
                const double K = answer[i]["stiffness_Pa_per_m"],
                             part =
                                 joint.quantity == "loading" ? answer[i].value("loading_stiffness_Pa_per_m", K) / K : 1;
                take(i, answer[i]["stiffness_p05_Pa_per_m"].get<double>() * part / 1e12,
                     answer[i]["stiffness_p95_Pa_per_m"].get<double>() * part / 1e12);
            }
        }
        all.inside[joint.group] += inside;
        if (counts) all.joints += inside / static_cast<double>(joint.measured.size()), ++count;
    }
    all.joints /= count;
    return all;
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return (values[(values.size() - 1) / 2] + values[values.size() / 2]) / 2;
}

/// dp/d(closure) of a fracture across the row nearest to \p pressure [MPa/mm].
double slope(const std::string& specimen, const std::string& branch, double pressure) {
    static const test::Table table("published/rock_fractures.csv");
    std::vector<std::array<double, 2>> curve;
    for (std::size_t i = 0; i < table.size(); ++i)
        if (table.text(i, "specimen") == specimen && table.text(i, "branch") == branch)
            curve.push_back({table.input(i, "pressure_MPa"), table.input(i, "closure_mm")});
    std::size_t here = 1;
    for (std::size_t i = 1; i + 1 < curve.size(); ++i)
        if (std::abs(curve[i][0] - pressure) < std::abs(curve[here][0] - pressure)) here = i;
    return (curve[here + 1][0] - curve[here - 1][0]) / (curve[here + 1][1] - curve[here - 1][1]);
}

}  // namespace

TEST_CASE("The band of the answer covers K of molecular dynamics at all loads, and persson alone would not do") {
    const test::Table table("published/gfmd.csv");
    std::vector<double> stars, truth;
    for (std::size_t i = 0; i + 1 < table.size(); ++i) {
        const auto of = [&](const char* key, std::size_t row) { return table.input(row, key); };
        stars.push_back(of("chord_p_star", i));
        truth.push_back(of("chord_K_rms_height_over_p", i));
        const double chord = std::log(of("p_star", i + 1) / of("p_star", i)) /
                             (of("mean_gap_over_rms_height", i) - of("mean_gap_over_rms_height", i + 1));
        CHECK(test::relative_error(truth.back(), chord) < 1e-3);  // the columns of the table are of one another
    }
    const json answer = run(gaussian(stars))["answer"], laws = run(gaussian(stars, "laws = [\"persson\"]\n"))["rows"];
    REQUIRE(answer.size() == 11);
    const auto over = [&](const json& row, const char* key, std::size_t i) {
        return row[key].get<double>() * 1e-6 / row["pressure_Pa"].get<double>() / truth[i];
    };
    for (std::size_t i = 0; i < truth.size(); ++i) {
        INFO("p* = " << stars[i]);
        CHECK(over(answer[i], "stiffness_p05_Pa_per_m", i) < 1);
        CHECK(over(answer[i], "stiffness_p95_Pa_per_m", i) > 1);
        CHECK(std::abs(over(answer[i], "stiffness_Pa_per_m", i) - 1) < (stars[i] < 0.4 ? 0.11 : 0.16));
    }
    CHECK(over(laws[0], "stiffness_Pa_per_m", 0) < 0.7);
}

TEST_CASE("Gaps of hybrid are those of molecular dynamics to 0.03 sigma where many contacts carry, areas to 5 %") {
    const test::Table table("published/gfmd.csv");
    std::vector<double> stars;
    for (std::size_t i = 0; i < table.size(); ++i) stars.push_back(table.input(i, "p_star"));
    const json rows = run(gaussian(stars, "laws = [\"hybrid\"]\n"))["rows"];
    REQUIRE(rows.size() == table.size());
    for (std::size_t i = 0; i < table.size(); ++i) {
        INFO("p* = " << stars[i]);
        const double gap = rows[i]["separation_m"].get<double>() / 1e-6 - table.input(i, "mean_gap_over_rms_height");
        CHECK(std::abs(gap) < (i == 0 ? 0.12 : 0.03));  // at 0.0004 few contacts of one surface carry
        CHECK(test::relative_error(rows[i]["real_area_fraction"].get<double>(), table.input(i, "area_fraction")) <
              0.05);
    }
}

TEST_CASE("The band holds 0.9 of measured joints of which metals, process and roughness are known, of flat faces 0.6") {
    const std::vector<MeasuredJoint> joints = measured_joints();
    CHECK(joints.size() == 30);
    const Coverage all = coverage(joints, ""), flat = coverage(joints, of_flat_faces);
    CHECK(all.points == 61);
    CHECK(all.joints > 0.90);  // 0.93; the form was set on these joints
    CHECK(flat.joints < 0.65);
    CHECK(flat.joints > 0.55);
    CHECK(median(all.widths) < 56);
    CHECK(median(flat.widths) < 20);
    CHECK(all.inside.at("ground and lapped steel and iron") >= 15);  // of 18
    CHECK(flat.inside.at("ground and lapped steel and iron") >= 15);
    CHECK(all.inside.at("handbook") == 16);  // of 18
    CHECK(flat.inside.at("handbook") == 8);
    CHECK(all.inside.at("aluminium in air") <= 1);  // of 39: the gap has no form
    CHECK(median(all.widths_of_steel_from_10_MPa) < 23);
    CHECK(median(flat.widths_of_steel_from_10_MPa) < 15);
}

TEST_CASE("The measured joints have the resistances and closures of their tables") {
    const test::Table resistances("published/thermal_resistances.csv"), closures("published/joint_closures.csv");
    CHECK(resistances.size() == 174);
    std::size_t found = 0, of_closure = 0;
    for (const MeasuredJoint& joint : measured_joints())
        for (std::size_t k = 0; k < joint.measured.size(); ++k) {
            const auto close = [&](double value) { return test::relative_error(joint.measured[k], value) < 1e-3; };
            bool here = false;
            for (std::size_t i = 0; i < resistances.size() && !here && joint.group != "handbook"; ++i)
                here = resistances.input(i, "pressure_MPa") == joint.pressures[k] &&
                       close(1e6 / resistances.input(i, "resistance_mm2K_per_W"));
            found += here;
            for (std::size_t i = 0; i < closures.size() && !here; ++i) {
                const auto middle = [&](const std::string& key) {
                    return (closures.input(i, key + "_from") + closures.input(i, key + "_to")) / 2;
                };
                const double unit = closures.text(i, "unit_of_pressure") == "MPa" ? 1 : 0.0980665, m = middle("m"),
                             p = joint.pressures[k] / unit;
                if (joint.quantity == "loading" && close(std::pow(p, 1 - m) * unit / (middle("C") * m)))
                    here = true, ++of_closure;
            }
        }
    CHECK(found == 63);      // of the database: 24 in vacuum and 39 in air
    CHECK(of_closure == 9);  // two of C45, one of cast iron, at three pressures each
}

TEST_CASE("plastic and hybrid are within 20 % of the correlations that measured conductances of flat faces follow") {
    // Cooper, Mikic, Yovanovich: h = 1.25 k m/sigma (p/H)^0.95; Mikic: h = 1.55 k m/sigma (sqrt(2) p/(E m))^0.94.
    // h = k K/E
    constexpr double E = 115e9, sigma = 1e-6;
    const auto stiffness = [&](const char* law, double g, const std::string& hardness,
                               const std::vector<double>& pressures) {
        std::string list;
        for (const double p : pressures) list += (list.empty() ? "" : ", ") + quoted(p, "Pa");
        std::vector<double> all;
        for (const json& row :
             run("[surface]\nrms_height = \"1 um\"\nrms_gradient = " + std::to_string(g) +
                 "\nskewness = 0\nkurtosis = 3\n[material.upper]\nyoungs_modulus = \"230 GPa\"\npoisson_ratio = "
                 "0\nhardness = " +
                 hardness + "\n[contact]\npressures = [" + list + "]\nlaws = [\"" + law + "\"]\n")["rows"])
            all.push_back(row["stiffness_Pa_per_m"]);
        return all;
    };
    for (const double g : {0.05, 0.2, 0.4}) {
        const double m = g / std::sqrt(std::numbers::pi);
        for (const double relative : {0.02, 0.05, 0.11, 0.19}) {
            const double H = relative * E * g;
            std::vector<double> pressures;
            for (const double share : {1e-5, 1e-4, 1e-3, 1e-2, 0.1}) pressures.push_back(share * H);
            const std::vector<double> K = stiffness("plastic", g, quoted(H, "Pa"), pressures);
            for (std::size_t i = 0; i < K.size(); ++i) {
                INFO("g " << g << ", H/(E g) " << relative << ", p/H " << pressures[i] / H);
                CHECK(test::relative_error(K[i], 1.25 * E * m / sigma * std::pow(pressures[i] / H, 0.95)) < 0.2);
            }
        }
        std::vector<double> pressures;
        for (const double star : {1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.04}) pressures.push_back(star * E * g);
        const std::vector<double> K = stiffness("hybrid", g, "\"infinite\"", pressures);
        for (std::size_t i = 0; i < K.size(); ++i) {
            INFO("g " << g << ", p/(E g) " << pressures[i] / (E * g));
            const double correlation =
                1.55 * E * m / sigma * std::pow(std::numbers::sqrt2 * pressures[i] / (E * m), 0.94);
            CHECK(test::relative_error(K[i], correlation) < 0.2);
        }
    }
}

TEST_CASE("Conductance in air to 230 kPa follows from one fitted rms height, and is not that of the spots") {
    const test::Table table("published/inconel_haynes.csv");
    for (const char* finish : {"smooth", "med", "rough"}) {
        std::string pressures;
        std::vector<double> h;
        for (std::size_t i = 0; i < table.size(); ++i)
            if (table.text(i, "finish") == finish) {
                pressures += (pressures.empty() ? "" : ", ") + quoted(table.input(i, "pressure_kPa"), "kPa");
                h.push_back(table.input(i, "h_median_W_per_m2K"));
            }
        REQUIRE(h.size() == 10);
        const auto at = [&](double height) {
            return heat(
                "[material.upper]\nyoungs_modulus = \"200 GPa\"\npoisson_ratio = 0.29\n"
                "thermal_conductivity = \"11.4 W/(m K)\"\n"
                "[material.lower]\nyoungs_modulus = \"225 GPa\"\npoisson_ratio = 0.3\n"
                "thermal_conductivity = \"9.4 W/(m K)\"\n[surface]\nrms_height = " +
                quoted(height, "um") + "\n[contact]\npressures = [" + pressures + "]\n[gap]\nmedium = \"air\"\n");
        };
        double low = 0.1, high = 20;
        for (int i = 0; i < 12; ++i) {
            const double middle = std::sqrt(low * high);
            const Heat first = at(middle).front();
            (first.gap + first.spots > h.front() ? low : high) = middle;
        }
        const std::vector<Heat> found = at(low);
        for (std::size_t i = 0; i < h.size(); ++i) {
            INFO(finish << ", row " << i);
            CHECK(test::relative_error(found[i].gap + found[i].spots, h[i]) < 0.18);
            CHECK(found[i].spots < 0.065 * h[i]);
        }
    }
}

TEST_CASE(
    "Mated rock unloads more stiffly than it loads, and K grows more slowly than that of faces that do not mate") {
    for (const char* specimen : {"vd1", "vd2", "vd3"}) {
        INFO(specimen);
        const double two = slope(specimen, "loading", 2.05), eight = slope(specimen, "loading", 8.22);
        CHECK(std::log(eight / two) / std::log(4) < 0.65);
        CHECK(slope(specimen, "unloading", 8.22) > 1.4 * eight);
        CHECK(slope(specimen, "unloading", 8.22) < 1.7 * eight);
    }
    const json answer = run(gaussian({0.002, 0.008}))["answer"];
    const double grown = answer[1]["stiffness_Pa_per_m"].get<double>() / answer[0]["stiffness_Pa_per_m"].get<double>();
    CHECK(std::log(grown) / std::log(4) > 0.8);
}

TEST_CASE("Ground metals that flow unload 1.1 to 2 times as stiffly as they load, of a measured 3") {
    const auto ratio = [](const char* gradient) {
        const json document =
            run("material.upper = { name = \"titanium\", hardness = \"3.4 GPa\" }\n"
                "contact.pressures = [\"70 MPa\"]\n[surface]\nrms_height = \"0.5 um\"\n"
                "process = \"ground\"\nrms_gradient = " +
                std::string(gradient) + "\n");
        const json& row = document["answer"][0];
        return row["stiffness_Pa_per_m"].get<double>() / row["loading_stiffness_Pa_per_m"].get<double>();
    };
    CHECK(ratio("0.1") > 1.05);
    CHECK(ratio("0.3") < 2.1);
    CHECK(std::abs(ratio("0.5") / 3 - 1) < 0.1);
}

TEST_CASE("The answer for ground bearing steel at 400 MPa is above the elastic laws, and short of what ultrasound is") {
    const std::string scene =
        "material.upper = { name = \"steel\", hardness = \"7 GPa\" }\n[surface]\nrms_height = \"0.25 um\"\n"
        "process = \"ground\"\n[contact]\npressures = [\"400 MPa\"]\n";
    const json row = run(scene)["answer"][0];
    CHECK(row["stiffness_p05_Pa_per_m"].get<double>() < 4.2e15);  // measured
    CHECK(row["stiffness_p95_Pa_per_m"].get<double>() > 4.2e15);
    const json laws = run(scene + "laws = [\"greenwood_williamson\"]\n")["rows"];
    const double over = row["stiffness_Pa_per_m"].get<double>() / laws[0]["stiffness_Pa_per_m"].get<double>();
    CHECK(over > 1.5);
    CHECK(over < 2.2);  // measured, by a note on the paper
}

}  // namespace published_test
