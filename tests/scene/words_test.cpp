// SPDX-License-Identifier: BSD-3-Clause
// Words of users in place of those of fstiff: what a refusal proposes, and what is accepted.
#include "request/words.hpp"
#include "support/library.hpp"

namespace words_test {

namespace {

using namespace fstiff;
using test::input_of;

std::string scene(const std::string& surface, const std::string& contact = "pressures = \"10 MPa\"",
                  const std::string& more = "") {
    return "[surface]\n" + surface + "\n[contact]\n" + contact + "\n" + more + "\n";
}
const std::string face = "rms_height = \"0.8 um\"\nrms_gradient = 0.12";

std::string refused(const std::string& text) { return test::refused_scene(text); }

scene::Scene read(const std::string& text) { return scene::read_scene(text, {.name = "scene.toml"}); }

}  // namespace

TEST_CASE("A wrong key proposes the key in other capitals, then the word of the field, then the nearest") {
    const std::array<std::string, 3> rows[] = {{"surface", "Ra", "ra RA CLA AA roughness"},
                                               {"surface", "Sq", "SQ"},
                                               {"surface", "RSm", "rsm"},
                                               {"surface", "rms_height", "rms sigma RMS"},
                                               {"surface", "rms_gradient", "slope rms_slope"},
                                               {"surface", "peak_radius", "R"},
                                               {"surface", "fractal_dimension", "D"},
                                               {"surface", "hurst", "H"},
                                               {"surface", "process", "proces"},
                                               {"contact", "nominal_area", "area A0"},
                                               {"contact", "force", "F load"},
                                               {"contact", "ball_radius", "ball_diameter"},
                                               {"contact", "separations", "separation"},
                                               {"material.upper", "youngs_modulus", "E"},
                                               {"material.upper", "poisson_ratio", "nu"},
                                               {"material.upper", "yield_strength", "Rp02"},
                                               {"material.upper", "hardness", "HV"},
                                               {"friction", "coefficient", "mu"}};
    for (const auto& [section, meant, words] : rows)
        for (const std::string& key : test::words_of(words)) {
            INFO(section << "." << key);
            const std::string line = "\n" + key + " = 1\n";
            const std::string text = section == "surface" ? scene(line)
                                     : section == "contact"
                                         ? scene(face, line)
                                         : scene(face, "pressures = \"1 MPa\"", "[" + section + "]" + line);
            const std::string sentence = refused(text);
            CHECK(test::contains(sentence,
                                 section + "." + key + ": unknown key (did you mean " + meant + "?); valid keys"));
        }
}

TEST_CASE("A short key without a meaning proposes nothing") {
    for (const char* key : {"q", "xyz", "Tq", "abc"}) {
        INFO(key);
        const std::string sentence = refused(scene(face + "\n" + key + " = 1"));
        CHECK(test::contains(sentence, "unknown key; valid keys of surface"));
        CHECK_FALSE(test::contains(sentence, "did you mean"));
    }
}

TEST_CASE("What the model does not have is one sentence with its page") {
    const std::pair<std::string, std::string> rows[] = {
        {"docs/trust.md", "temperature coating coating_thickness adhesion"},
        {"docs/worn-and-lubricated.md", "lubricant oil_viscosity wear"},
        {"docs/bolted-joint.md", "torque preload bolts waviness tilt"},
        {"docs/finite_elements.md", "cylinder cylinder_radius"},
        {"docs/friction.md", "damping friction"}};
    for (const auto& [page, words] : rows)
        for (const std::string& key : test::words_of(words)) {
            INFO(key);
            const std::string sentence = refused(scene(face, "pressures = \"1 MPa\"\n" + key + " = 1"));
            CHECK(test::contains(sentence, "contact." + key + ": unknown key; "));
            CHECK(test::contains(sentence, "(" + page + ")"));
            CHECK_FALSE(test::contains(sentence, "did you mean"));
            CHECK_FALSE(test::contains(sentence, "nominal_area\", "));  // no list of keys
            CHECK(std::filesystem::exists(FSTIFF_SCENES "/../" + page));
        }
    CHECK(test::contains(refused(scene(face, "pressures = \"1 MPa\"", "[bolt]\ntorque = 1")),
                         "bolt: unknown key; a bolt"));
}

TEST_CASE("Ssk, Rsk, Sku and Rku are names of skewness and kurtosis") {
    const auto expected = test::csv_of(test::results_of(scene(face + "\nskewness = -0.5\nkurtosis = 3.5")));
    for (const auto& [skewness, kurtosis] : {std::pair("Ssk", "Sku"), std::pair("Rsk", "Rku")})
        CHECK(test::csv_of(test::results_of(scene(face + "\n" + skewness + " = -0.5\n" + kurtosis + " = 3.5"))) ==
              expected);
    CHECK(input_of(read(scene(face + "\nSsk = -0.5\nSku = 3.5")), "surface.kurtosis").value == 3.5);
    CHECK(test::contains(refused(scene(face + "\nSsk = -0.5")), "surface.kurtosis: is missing"));
    CHECK(test::contains(refused(scene(face + "\nSsk = -0.5\nSku = 3\nskewness = 1")), "must not be given with"));
    CHECK(test::contains(refused(scene(face + "\nSsk = -7\nSku = 3")), "surface.Ssk = -7: must be from -3 to 3"));
}

TEST_CASE("A grade of a drawing is Ra, and its number is among the inputs") {
    const auto Ra = [](const std::string& grade) {
        return input_of(read(scene("Ra = \"" + grade + "\"")), "surface.Ra");
    };
    CHECK(Ra("N1").value == 0.025e-6);  // ISO 1302:1992, annex
    CHECK(Ra("N6").value == 0.8e-6);
    CHECK(Ra("n 9").value == 6.3e-6);
    CHECK(Ra("N12").value == 50e-6);
    CHECK(Ra("N6").written == "N6");
    CHECK(Ra("N6").unit == "m");
    CHECK(read(scene("Ra = \"VDI 24\"")).assumptions.front() == "Ra 1.5849 \u00B5m, of VDI 24");
    // VDI 3400: class = 20 log10(Ra/0.1 um); its table has 1.6 um for 24 and 18 um for 45
    CHECK(test::relative_error(*Ra("VDI 24").value, 1.5848931924611136e-6) < 1e-15);
    CHECK(test::relative_error(*Ra("VDI45").value, 17.782794100389228e-6) < 1e-15);
    CHECK(test::relative_error(*Ra("VDI 3400 Ref 12").value, 0.3981071705534972e-6) < 1e-15);
    CHECK(Ra("vdi 0").value == 0.1e-6);
    CHECK(test::csv_of(test::results_of(scene("Ra = \"N6\""))) ==
          test::csv_of(test::results_of(scene("Ra = \"0.8 um\""))));
    for (const char* wrong : {"N0", "N13", "N6.5", "N", "VDI", "VDI 46", "VDI 3400", "VDI -3"})
        CHECK(test::contains(refused(scene("Ra = \"" + std::string(wrong) + "\"")), "from \"N1\" to \"N12\""));
    CHECK(test::contains(refused(scene("Rq = \"N6\"")), "surface.Rq = \"N6\": is a grade of Ra"));
    for (const char* key : {"vdi", "grade", "roughness_grade"})
        CHECK(test::contains(refused(scene(std::string(key) + " = 24")), "Ra = \"VDI 24\""));
}

TEST_CASE("A process by another word is that process, and one without a prior is unknown, which the output states") {
    for (const auto& [word, name] :
         {std::pair("grinding", "ground"), std::pair("geschliffen", "ground"), std::pair("EDM", "eroded"),
          std::pair("Sand-blasted", "blasted"), std::pair("gefr\xC3\xA4st", "milled"),
          std::pair("spark eroded", "eroded"), std::pair("Honing", "honed")}) {
        INFO(word);
        const std::string height = "Ra = \"0.8 um\"\nprocess = \"";
        CHECK(test::csv_of(test::results_of(scene(height + word + "\""))) ==
              test::csv_of(test::results_of(scene(height + name + "\""))));
        CHECK(input_of(read(scene(height + word + "\"")), "surface.process").written ==
              std::string(word) + " (" + name + ")");
    }
    for (const char* word : {"reamed", "rolled", "shot peened", "scraped", "hobbed", "SLM"}) {
        INFO(word);
        const auto made = read(scene("Ra = \"0.8 um\"\nprocess = \"" + std::string(word) + "\""));
        CHECK(input_of(made, "surface.process").written == std::string(word) + " (unknown)");
        CHECK(std::count(
                  made.assumptions.begin(), made.assumptions.end(),
                  "no ranges for \"" + std::string(word) + "\" surfaces are known: those of an unknown process") == 1);
    }
    const std::string sentence = refused(scene("Ra = \"0.8 um\"\nprocess = \"gruond\""));
    CHECK(test::contains(sentence, "must be one of \"unknown\", \"ground\""));
    CHECK_FALSE(test::contains(sentence, "did you mean"));
}

TEST_CASE("One pressure, or the key pressure, is a list of one") {
    const auto expected = test::csv_of(test::results_of(scene(face, "pressures = [\"50 MPa\"]")));
    for (const char* line : {"pressures = \"50 MPa\"", "pressure = \"50 MPa\"", "pressure = [\"50 MPa\"]"})
        CHECK(test::csv_of(test::results_of(scene(face, line))) == expected);
    CHECK(read(scene(face, "separations = \"1 um\"\nlaws = [\"hybrid\"]")).points.size() == 1);
    CHECK(test::contains(refused(scene(face, "pressures = 50")), "contact.pressures = 50: a number without a unit"));
    CHECK(
        test::contains(refused(scene(face, "pressure = \"1 MPa\"\npressures = \"1 MPa\"")), "must not be given with"));
}

TEST_CASE("A key above all sections is refused with the section that takes it") {
    for (const auto& [key, section] : {std::pair("Ra", "surface"), std::pair("pressures", "contact"),
                                       std::pair("hardness", "material.upper"), std::pair("upper", "material")})
        CHECK(test::contains(refused(std::string(key) + " = \"1 um\"\n" + scene(face)),
                             std::string(key) + ": is a key of a section; write it below a line [" + section + "]"));
}

TEST_CASE("A material by another name proposes the right one") {
    for (const auto& [name, near] :
         {std::pair("AlMgSi1", "6082"), std::pair("MgAZ31", "AZ31B"), std::pair("Stahl", "steel"),
          std::pair("1.4305", "stainless_steel"), std::pair("Alu", "aluminium"), std::pair("S275JR", "steel"),
          std::pair("Messing", "brass")}) {
        INFO(name);
        CHECK(test::contains(
            refused(scene(face, "pressure = \"1 MPa\"", "[material]\nupper = \"" + std::string(name) + "\"")),
            "is not a known material; did you mean \"" + std::string(near) + "\"? Or give a section"));
    }
    CHECK(test::contains(refused(scene(face, "pressure = \"1 MPa\"", "[material]\nupper = \"stel\"")),
                         "is not a known material (did you mean steel?); fstiff help materials lists those"));
}

TEST_CASE("A key of a body next to its name is shown where it belongs") {
    const auto refused_material = [](const std::string& keys) {
        return refused(scene(face, "pressure = \"1 MPa\"", "[material]\n" + keys));
    };
    CHECK(test::contains(
        refused_material("upper = \"C45\"\nhardness = \"2 GPa\""),
        "material.hardness: is a key of a body; write [material.upper] with name = \"C45\" and hardness"));
    CHECK(test::contains(refused_material("E = \"210 GPa\"\nnu = 0.3"), "write [material.upper] with youngs_modulus"));
    CHECK(test::contains(refused_material("name = \"steel\""), "write [material.upper] with name"));
    CHECK(test::contains(refused_material("uper = \"steel\""), "(did you mean upper?)"));
}

TEST_CASE("A value without quotation marks, and a decimal comma, are named where the text is not valid TOML") {
    const std::string quantity = "write a quantity in quotation marks, such as \"0.8 um\"",
                      word = "write a text in quotation marks", comma = "the decimal mark is the point, as in 0.8";
    for (const auto& [line, hint] :
         {std::pair("Ra = 0.8 um", quantity), std::pair("Ra = 0.8um", quantity), std::pair("Ra = 12 mm", quantity),
          std::pair("Ra = -3nm", quantity), std::pair("process = ground", word),
          std::pair("rms_gradient = 0,12", comma), std::pair("errors = { rms_height = 0.1 um }", quantity),
          std::pair("errors = { rms_gradient = 0,1 }", comma)}) {
        INFO(line);
        const std::string sentence = refused(scene("name = \"a = b\"\n" + std::string(line)));
        CHECK(test::contains(sentence, "scene.toml:3: is not valid TOML"));
        CHECK(test::contains(sentence, hint));
    }
    CHECK_FALSE(test::contains(refused(scene("Ra \"0.8 um\"")), "quotation marks, such"));
    CHECK(test::contains(refused(scene(face, "pressures = [10 MPa]")), quantity));
}

}  // namespace words_test
