// SPDX-License-Identifier: BSD-3-Clause
#include "support/library.hpp"

#include <fstiff/wave/spring_interface.hpp>
#include <fstiff/wave/uncertain_reflection.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace scene_ultrasound_test {

namespace {

const std::string without = R"([surface]
rms_height = "0.832 um"
peak_radius = "40 um"
peak_density = "500 /mm^2"
[material.upper]
youngs_modulus = "205 GPa"
poisson_ratio = 0.3
[contact]
pressures = ["10 MPa", "100 MPa"]
laws = ["hertz", "greenwood_williamson"]
peaks = [ { theta = "pi/4", r = "exponential" } ]
)";
const std::string steel =
    "upper = { density = \"7850 kg/m^3\", velocity = \"5900 m/s\", shear_velocity = \"3200 m/s\" }\n";
const std::string section = "[ultrasound]\nfrequency = \"7 MHz\"\n" + steel;

std::string quantities(const std::string& names) { return "[output]\nquantities = [" + names + "]\n"; }

test::Csv run(const std::string& scene) { return test::rows_of_scene(scene); }

bool has(const test::Csv& rows, const std::string& column) {
    return std::count(rows.header().begin(), rows.header().end(), column) > 0;
}

double spring(double stiffness, double frequency, double z1, double z2) {
    const double x = 2 * std::numbers::pi * frequency * z1 * z2 / stiffness;
    return std::hypot(z1 - z2, x) / std::hypot(z1 + z2, x);
}

}  // namespace

TEST_CASE("With a section ultrasound run gives the reflections of every row's stiffness") {
    const test::Csv rows = run(without + section);
    REQUIRE(rows.size() == 4);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const double k = rows.number(i, "stiffness_Pa_per_m"), tangential = k * 2 * 0.7 / 1.7;
        CHECK(test::relative_error(rows.number(i, "tangential_stiffness_Pa_per_m"), tangential) < 1e-15);
        CHECK(test::relative_error(rows.number(i, "reflection"), spring(k, 7e6, 7850 * 5900.0, 7850 * 5900.0)) < 2e-15);
        CHECK(test::relative_error(rows.number(i, "shear_reflection"),
                                   spring(tangential, 7e6, 7850 * 3200.0, 7850 * 3200.0)) < 2e-15);
        CHECK(rows.number(i, "reflection_error") < 1e-12);
        CHECK(rows.number(i, "reflection_error") > 0);
    }
}

TEST_CASE("The reflection of a scene between unlike media is that of the library") {
    const test::Csv rows = run(without +
                               "[ultrasound]\nfrequency = \"5 MHz\"\nupper = { impedance = \"46 MRayl\" }\n"
                               "lower = { impedance = \"17.1 MRayl\" }\n");
    const fstiff::Impedances<double> media{46e6, 17.1e6};
    CHECK(fstiff::reflection(rows.number(1, "stiffness_Pa_per_m"), media, fstiff::detail::angular_frequency(5e6)) ==
          rows.number(1, "reflection"));
    CHECK(!has(rows, "shear_reflection"));
}

TEST_CASE("A fluid film is a spring next to K for longitudinal waves, and none for shear waves") {
    const test::Csv dry = run(without + section);
    const double film = 2.2e9 / 1.5e-6, z = 7850 * 5900.0;  // water of 1.5 um
    char text[64];
    std::snprintf(text, sizeof text, "film_stiffness = \"%.17g Pa/m\"\n", film);
    const test::Csv wet = run(without + section + text);
    for (std::size_t i = 0; i < dry.size(); ++i) {
        const double k = wet.number(i, "stiffness_Pa_per_m");
        CHECK(k == dry.number(i, "stiffness_Pa_per_m"));
        CHECK(test::relative_error(wet.number(i, "reflection"), spring(k + film, 7e6, z, z)) < 2e-15);
        CHECK(wet.number(i, "shear_reflection") == dry.number(i, "shear_reflection"));
    }
    const auto scene = test::scene_of(without + section + text);
    auto json = run_document(fstiff::actions::compute(scene));
    CHECK(test::contains(json["ultrasound"].str(), "\"film_stiffness_Pa_per_m\": 1.46666666666666"));
}

TEST_CASE("The reflections are computed only where they are asked for or the section is there") {
    const test::Csv none = run(without);
    CHECK(!has(none, "reflection"));
    CHECK(!has(none, "tangential_stiffness_Pa_per_m"));
    const test::Csv tangential = run(without + quantities("\"tangential_stiffness\""));
    CHECK(has(tangential, "tangential_stiffness_Pa_per_m"));
    CHECK(!has(tangential, "stiffness_Pa_per_m"));
    const test::Csv alone = run(without + section + quantities("\"shear_reflection\""));
    CHECK(!has(alone, "reflection"));
    CHECK(alone.number(0, "shear_reflection") == run(without + section).number(0, "shear_reflection"));
}

TEST_CASE("Unlike bodies have Mindlin's ratio of both, and R the impedances of both") {
    const std::string soft = "[material.lower]\nyoungs_modulus = \"70 GPa\"\npoisson_ratio = 0.33\n";
    const test::Csv rows = run(without + soft + section +
                               "lower = { density = \"2.7 g/cm^3\", velocity = \"6.3 km/s\", shear_impedance = "
                               "\"8.4 MRayl\" }\n");
    const double g1 = 205e9 / 2.6, g2 = 70e9 / 2.66;
    const double ratio = 2 * (0.7 / g1 + 0.67 / g2) / (1.7 / g1 + 1.67 / g2);
    const double k = rows.number(1, "stiffness_Pa_per_m");
    CHECK(test::relative_error(rows.number(1, "tangential_stiffness_Pa_per_m"), ratio * k) < 2e-15);
    CHECK(test::relative_error(rows.number(1, "reflection"), spring(k, 7e6, 7850 * 5900.0, 2700 * 6300.0)) < 3e-15);
    CHECK(test::relative_error(rows.number(1, "shear_reflection"), spring(ratio * k, 7e6, 7850 * 3200.0, 8.4e6)) <
          3e-15);
}

TEST_CASE("The band of R is that of K") {
    const std::string uncertain =
        test::replaced(without, "[material.upper]", "errors = { rms_height = \"0.05 um\" }\n[material.upper]") +
        section + "[uncertainty]\nsamples = 40\n";
    const test::Csv rows = run(uncertain);
    const double z = 7850 * 5900.0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const double low = rows.number(i, "reflection_p05"), high = rows.number(i, "reflection_p95");
        CHECK(low < rows.number(i, "reflection"));
        CHECK(rows.number(i, "reflection") < high);
        CHECK(test::relative_error(low, spring(rows.number(i, "stiffness_p95_Pa_per_m"), 7e6, z, z)) < 2e-15);
        CHECK(test::relative_error(high, spring(rows.number(i, "stiffness_p05_Pa_per_m"), 7e6, z, z)) < 2e-15);
        CHECK(has(rows, "shear_reflection_p95"));
    }
    const test::Csv alone = run(uncertain + quantities("\"reflection\""));
    CHECK(alone.number(0, "reflection_p05") == rows.number(0, "reflection_p05"));
}

TEST_CASE("A scene holds the waves of its section, and what was written of them") {
    const auto scene = test::scene_of(without + section);
    REQUIRE(scene.joint.ultrasound);
    CHECK(scene.joint.ultrasound->frequency == 7e6);
    REQUIRE(scene.joint.ultrasound->shear);
    CHECK(scene.joint.ultrasound->shear->incident == 7850 * 3200.0);
    const auto input = [&](const std::string& key) {
        return std::find_if(scene.inputs.begin(), scene.inputs.end(), [&](const auto& one) { return one.key == key; });
    };
    REQUIRE(input("ultrasound.upper.velocity") != scene.inputs.end());
    CHECK(input("ultrasound.upper.velocity")->value == 5900);
    CHECK(input("ultrasound.lower") != scene.inputs.end());
}

TEST_CASE("The reflection of a K with interaction is doubted") {
    const std::string scene = test::replaced(
        without, "peaks =", "interaction = { reading = \"effective_separation\", length = \"peak_spacing\" }\npeaks =");
    const std::string doubt = "not that of the interface alone";
    CHECK(test::contains(test::joined(test::results_of(scene + section).warnings), doubt));
    CHECK(!test::contains(test::joined(test::results_of(scene).warnings), doubt));
}

TEST_CASE("A section ultrasound that is not whole is refused by file, line and key") {
    const auto refused = [](const std::string& text, const std::vector<std::string>& parts) {
        test::check_sentence(test::refused_scene(text), parts);
    };
    const std::string all = without + section;
    refused(test::replaced(all, "\"7 MHz\"", "7"), {"scene.toml:13", "ultrasound.frequency = 7", "7 MHz"});
    refused(test::replaced(all, "7 MHz", "0 Hz"), {"ultrasound.frequency", "greater than 0"});
    refused(all + "film_stiffness = \"-1 GPa/um\"\n", {"ultrasound.film_stiffness", "not negative"});
    refused(all + "film_stiffness = 1e15\n", {"ultrasound.film_stiffness", "without a unit", "0.1 GPa/um"});
    refused(test::replaced(all, "frequency = \"7 MHz\"\n", ""), {"ultrasound.frequency", "missing"});
    refused(test::replaced(all, steel, ""), {"ultrasound.upper", "missing"});
    refused(test::replaced(all, "velocity = \"5900 m/s\", ", ""), {"ultrasound.upper.impedance", "missing"});
    refused(test::replaced(all, "density = \"7850 kg/m^3\", ", ""), {"ultrasound.upper.density", "missing"});
    refused(test::replaced(all, "upper = {", "upper = { impedance = \"46 MRayl\", "),
            {"ultrasound.upper.velocity", "must not be given with"});
    refused(test::replaced(all, "5900 m/s", "5900 m"), {"ultrasound.upper.velocity", "m/s"});
    refused(test::replaced(all, "shear_velocity", "shear_speed"), {"shear_speed", "unknown key", "shear_velocity"});
    refused(all + "lower = { impedance = \"17 MRayl\" }\n", {"ultrasound.lower.shear_impedance", "missing"});
    refused(without + quantities("\"reflection\""), {"output.quantities", "section ultrasound"});
    refused(without + "[ultrasound]\nfrequency = \"7 MHz\"\nupper = { impedance = \"46 MRayl\" }\n" +
                quantities("\"shear_reflection\""),
            {"output.quantities", "shear_impedance"});
}

TEST_CASE("The example of a section ultrasound in docs/scene.md runs") {
    const std::string text = test::read(FSTIFF_SCENES "/../docs/scene.md");
    const auto start = text.find("[ultrasound]\nfrequency");
    const test::Csv rows = run(without + text.substr(start, text.find("```", start) - start));
    CHECK(has(rows, "shear_reflection"));
}

}  // namespace scene_ultrasound_test
