// SPDX-License-Identifier: BSD-3-Clause
// Input that is not a scene is refused by file, line, key, value and what is allowed; missing keys take their defaults.
#include "support/library.hpp"

namespace refused_scene_test {

using test::input_of;

namespace {

const std::string good = R"(name = "short"
[surface]
rms_height = "0.832 um"
peak_radius = "40 um"
peak_density = "500 /mm^2"
fractal_dimension = 1.62
[material.upper]
youngs_modulus = "205 GPa"
poisson_ratio = 0.3
[contact]
nominal_area = "195 mm^2"
pressures = ["1 MPa"]
laws = ["fractal"]
peaks = [ { theta = "pi/4", r = "exponential" } ]
interaction = "none"
[output]
quantities = ["stiffness"]
)";

void check_scene_refused(const std::string& scene, const std::vector<std::string>& parts) {
    test::check_sentence(test::refused_scene(scene), parts);
}

}  // namespace

TEST_CASE("The example of docs/scene.md is computed") {
    const std::string text = test::read(FSTIFF_SCENES "/../docs/scene.md");
    const auto start = text.find("```toml\n") + 8;
    CHECK(test::rows_of_scene(text.substr(start, text.find("```", start) - start)).size() == (2 + 2 + 1) * 31);
}

TEST_CASE("A bad value in a scene is refused with file, line, key, value and what is allowed") {
    struct Case {
        std::string from, to;
        std::vector<std::string> parts;
    };
    const std::vector<Case> cases{
        {"\"0.832 um\"", "0.832", {"scene.toml:3: surface.rms_height = 0.832", "a number without a unit"}},
        {"\"0.832 um\"", "\"0.832\"", {":3: surface.rms_height = \"0.832\"", "a number without a unit", "um"}},
        {"\"0.832 um\"", "\"0.832 MPa\"", {":3: surface.rms_height", "MPa", "allowed are", "um"}},
        {"\"0.832 um\"", "\"nan um\"", {":3: surface.rms_height", "nan um"}},
        {"\"0.832 um\"", "\"1e400 um\"", {":3: surface.rms_height", "1e400"}},
        {"\"0.832 um\"", "true", {":3: surface.rms_height = true", "must be"}},
        {"\"0.832 um\"", "\"0 um\"", {":3: surface.rms_height = \"0 um\"", "greater than 0"}},
        {"= 1.62", "= 1.0", {":6: surface.fractal_dimension = 1:", "must be greater than 1 and at most 1.99"}},
        {"= 1.62", "= nan", {":6: surface.fractal_dimension = nan", "finite"}},
        {"= 1.62", "= \"1.62\"", {":6: surface.fractal_dimension = \"1.62\"", "number"}},
        {"fractal_dimension = 1.62\n", "", {"surface.fractal_dimension", "missing", "fractal"}},
        {"\"205 GPa\"", "\"0 GPa\"", {":8: material.upper.youngs_modulus", "greater than 0"}},
        {"= 0.3", "= 0.51", {":9: material.upper.poisson_ratio = 0.51", "at most 0.5"}},
        {"= 0.3", "= -1", {":9: material.upper.poisson_ratio = -1", "greater than -1"}},
        {"\"195 mm^2\"", "\"-195 mm^2\"", {":11: contact.nominal_area", "greater than 0"}},
        {"[\"1 MPa\"]", "[]", {":12: contact.pressures = []", "empty list", "at least one"}},
        {"[\"1 MPa\"]", "[\"1 MPa\", 2]", {":12: contact.pressures[1] = 2", "without a unit"}},
        {"[\"1 MPa\"]", "[\"0 MPa\"]", {":12: contact.pressures[0]", "greater than 0"}},
        {"[\"1 MPa\"]", "[\"1e30 GPa\"]", {":12: contact.pressures", "fractal"}},
        {"[\"1 MPa\"]", "{ from = \"1 MPa\", to = \"2 MPa\", count = 1 }", {"contact.pressures.count = 1", "2"}},
        {"[\"1 MPa\"]",
         "{ from = \"1 MPa\", to = \"2 MPa\", count = 1000000000 }",
         {"contact.pressures.count", "100000"}},
        {"[\"1 MPa\"]",
         "{ from = \"1 MPa\", to = \"2 MPa\", count = 2.5 }",
         {"contact.pressures.count = 2.5", "whole"}},
        {"[\"1 MPa\"]", "{ from = \"2 MPa\", to = \"1 MPa\", count = 3 }", {"contact.pressures.to", "greater"}},
        {"[\"1 MPa\"]", "{ from = \"1 MPa\", count = 3 }", {"contact.pressures.to", "missing"}},
        {"[\"1 MPa\"]",
         "{ from = \"1 MPa\", to = \"2 MPa\", count = 3, step = 1 }",
         {"contact.pressures.step", "unknown key", "\"spacing\""}},
        {"[\"1 MPa\"]",
         "{ from = \"1 MPa\", to = \"2 MPa\", count = 3, spacing = \"cubic\" }",
         {"contact.pressures.spacing = \"cubic\"", "\"log\", \"linear\""}},
        {"pressures = [\"1 MPa\"]\n", "", {"contact.pressures", "missing", "contact.force"}},
        {"pressures = [\"1 MPa\"]",
         "pressures = [\"1 MPa\"]\nseparations = [\"1 um\"]",
         {"contact.separations", "one of the two"}},
        {"pressures = [\"1 MPa\"]",
         "pressures = [\"1 MPa\"]\nforce = \"1 kN\"",
         {":13: contact.force", "must not be given with contact.pressures"}},
        {"nominal_area = \"195 mm^2\"\npressures = [\"1 MPa\"]",
         "force = [\"1 kN\"]",
         {":11: contact.force", "needs contact.nominal_area, or contact.washer"}},
        {"pressures = [\"1 MPa\"]", "force = \"-1 kN\"", {":12: contact.force = \"-1 kN\"", "greater than 0"}},
        {"pressures = [\"1 MPa\"]", "force = 20", {":12: contact.force", "20 kN"}},
        {"pressures = [\"1 MPa\"]", "force = \"20 MPa\"", {":12: contact.force", "N, kN, MN"}},
        {"pressures = [\"1 MPa\"]", "force = []", {":12: contact.force = []", "at least one"}},
        {"pressures = [\"1 MPa\"]", "force = \"1e308 N\"", {":12: contact.force", "double precision"}},
        {"pressures = [\"1 MPa\"]",
         "force = { from = \"2 kN\", to = \"1 kN\", count = 3 }",
         {":12: contact.force.to", "greater than contact.force.from"}},
        {"pressures = [\"1 MPa\"]",
         "pressures = [\"1 MPa\"]\nseating = \"0 Pa\"",
         {":13: contact.seating", "greater than 0"}},
        {"pressures =",
         "washer = { inner = \"8 mm\", outer = \"16 mm\" }\npressures =",
         {":12: contact.washer", "must not be given with contact.nominal_area"}},
        {"nominal_area = \"195 mm^2\"", "washer = \"M8\"", {":11: contact.washer = \"M8\"", "inner"}},
        {"nominal_area = \"195 mm^2\"",
         "washer = { inner = \"16 mm\", outer = \"16 mm\" }",
         {":11: contact.washer.outer", "greater than contact.washer.inner"}},
        {"nominal_area = \"195 mm^2\"",
         "washer = { inner = \"-1 mm\", outer = \"16 mm\" }",
         {":11: contact.washer.inner", "0 or greater"}},
        {"nominal_area = \"195 mm^2\"", "washer = { outer = \"16 mm\" }", {":11: contact.washer.inner", "missing"}},
        {"youngs_modulus = \"205 GPa\"",
         "name = \"wood\"",
         {":8: material.upper.name = \"wood\"", "is not a known material", "fstiff help materials"}},
        {"[material.upper]\nyoungs_modulus = \"205 GPa\"\npoisson_ratio = 0.3\n",
         "[material]\nupper = \"stele\"\n",
         {":8: material.upper = \"stele\"", "did you mean steel?", "or a section with youngs_modulus"}},
        {"[material.upper]\nyoungs_modulus = \"205 GPa\"\npoisson_ratio = 0.3\n",
         "[material]\nupper = 205\n",
         {":8: material.upper = 205", "name of a material"}},
        {"[material.upper]", "[material.lower]", {"material.upper", "missing"}},
        {"[\"fractal\"]",
         "[\"linear\"]",
         {":13: contact.laws[0] = \"linear\"", "\"fractal_consistent\"", "\"greenwood_williamson\""}},
        {"[\"fractal\"]", "[]", {":13: contact.laws", "one or more of"}},
        {"[\"fractal\"]", "[\"hertz\", \"hertz\"]", {":13: contact.laws[1] = \"hertz\"", "twice"}},
        {"\"pi/4\"", "0", {":14: contact.peaks[0].theta = 0:", "must be"}},
        {"\"pi/4\"", "\"pi/2\"", {":14: contact.peaks[0].theta", "must be"}},
        {"\"pi/4\"", "\"90\"", {":14: contact.peaks[0].theta", "must be"}},
        {"\"pi/4\"", "\"a lot\"", {":14: contact.peaks[0].theta = \"a lot\"", "allowed"}},
        {"\"pi/4\"", "\"20 deg\"", {":14: contact.peaks[0].theta", "pi/4 and pi/3"}},
        {"theta = \"pi/4\", ", "", {":14: contact.peaks[0].theta", "missing"}},
        {"r = \"exponential\"", "r = 1", {":14: contact.peaks[0].r = 1:", "less than 1"}},
        {"r = \"exponential\"", "r = -1.5", {":14: contact.peaks[0].r = -1.5", "must be"}},
        {"r = \"exponential\"", "r = nan", {":14: contact.peaks[0].r = nan", "finite"}},
        {"r = \"exponential\"", "r = \"gaussian\"", {":14: contact.peaks[0].r = \"gaussian\"", "\"exponential\""}},
        {"r = \"exponential\"", "R = 1", {":14: contact.peaks[0].R", "unknown key", "\"theta\", \"r\""}},
        {"\"none\"", "\"some\"", {":15: contact.interaction = \"some\"", "\"none\""}},
        {"\"none\"", "{ reading = \"wrong\" }", {":15: contact.interaction.reading = \"wrong\"", "\"as_printed\""}},
        {"\"none\"",
         "{ reading = \"as_printed\", length = 3 }",
         {":15: contact.interaction.length = 3", "without a unit"}},
        {"\"none\"",
         "{ reading = \"as_printed\", length = \"-3 mm\" }",
         {":15: contact.interaction.length", "greater than 0"}},
        {"[\"stiffness\"]",
         "[\"speed\"]",
         {":17: output.quantities[0] = \"speed\"", "\"approach\"",
          "\"stiffness\", \"separation\", \"real_area\", \"contacts\""}},
        {"[output]", "[outputs]", {"outputs", "unknown key", "\"output\""}},
        {"[surface]", "[surfaces]", {"unknown key", "\"surface\""}},
        {"[material.upper]", "[material.uper]", {"material.uper", "unknown key", "\"upper\", \"lower\""}},
        {"rms_height = \"0.832 um\"\n", "", {"scene.toml:2: surface.rms_height", "missing"}},
        {"name = \"short\"", "name = 3", {":1: name = 3", "text"}},
        {"\"0.832 um\"", "0.832 \xC2\xB5m", {":3: is not valid TOML", "outside quotation marks"}},
        {"[surface]", "[}surface]", {":2: is not valid TOML"}},
        {"[\"stiffness\"]", "[}\"stiffness\"]", {":17: is not valid TOML"}},
        {"rms_height", "rms_h\xC3\xB6he", {":3: is not valid TOML", "outside quotation marks"}},
        {"name = \"short\"", "name = \"short", {":1: is not valid TOML"}},
        {"peak_radius", "rms_height", {":4: is not valid TOML"}},
    };
    for (const Case& c : cases) {
        INFO(c.from << " -> " << c.to);
        check_scene_refused(test::replaced(good, c.from, c.to), c.parts);
    }
    check_scene_refused(
        "[surface]\nSq = \"1 um\"\n[contact]\npressures = [\"10 MPa\"]\n[output]\n"
        "quantities = [\"joint_stiffness\"]\n",
        {":6: output.quantities", "contact.nominal_area or contact.washer", "joint_stiffness"});
}

TEST_CASE("A ball without a force, and with what belongs to flat faces, is refused") {
    const std::string ball = "ball_radius = \"10 mm\"\n", force = "force = \"10 N\"\n", both = ball + force;
    const std::pair<std::string, std::vector<std::string>> rows[] = {
        {"ball_radius = \"0 mm\"\n" + force, {"scene.toml:4", "contact.ball_radius", "greater than 0"}},
        {"ball_radius = \"-5 mm\"\n" + force, {"contact.ball_radius", "greater than 0"}},
        {ball + "pressures = [\"1 MPa\"]\n", {"contact.ball_radius", "contact.force", "contact.pressures"}},
        {ball, {"contact.pressures", "missing"}},
        {both + "nominal_area = \"1 mm^2\"\n", {"contact.nominal_area", "contact.ball_radius"}},
        {both + "washer = { inner = \"1 mm\", outer = \"2 mm\" }\n", {"contact.washer", "contact.ball_radius"}},
        {both + "laws = [\"hybrid\"]\n", {"contact.laws", "contact.ball_radius"}},
        {both + "[gap]\n", {"contact.ball_radius", "section gap"}},
        {both + "[friction]\n", {"contact.ball_radius", "section friction"}},
        {both + "[ultrasound]\n", {"contact.ball_radius", "section ultrasound"}}};
    for (const auto& [contact, parts] : rows)
        check_scene_refused("[surface]\nrms_height = \"0.3 um\"\n[contact]\n" + contact, parts);
}

TEST_CASE("Characters beyond ASCII are welcome in quotation marks and comments") {
    std::string text = test::replaced(good, "\"0.832 um\"", "\"0.832 \xC2\xB5m\"  # Rauheit in \xC2\xB5m, \"fein\"");
    text = test::replaced(text, "\"short\"", "\"\"\"\nge\xC3\xA4tzt \\\" '#' \"\"\"");
    text = test::replaced(text, "\"40 um\"", "'40 \xCE\xBCm'");
    CHECK(test::csv_of(test::results_of("\xEF\xBB\xBF" + text)) == test::csv_of(test::results_of(good)));
}

TEST_CASE("A scene that is empty, binary or of another encoding is refused") {
    const test::Folder folder;
    for (const char* text : {"", "  \n\n"})
        test::check_sentence(test::refusal([&] { (void)fstiff::document::read_all(folder.write("scene.toml", text)); }),
                             {"scene.toml", "empty"});
    std::filesystem::create_symlink("loop.toml", folder / "loop.toml");
    std::filesystem::create_symlink("nothing.toml", folder / "dangling.toml");
    for (const auto& [name, reason] :
         {std::pair("loop.toml", "a link that leads to itself"),
          std::pair("dangling.toml", "a link to a file that is not there"), std::pair("nothing.toml", "no such file")})
        test::check_sentence(test::refusal([&] { (void)fstiff::document::read_all(folder / name); }), {name, reason});
    check_scene_refused("name = \"only a name\"\n", {"scene.toml", "surface", "missing"});
    check_scene_refused(std::string("\x7f"
                                    "ELF\0\1\2\xff\xfe\n",
                                    9),
                        {"scene.toml", "binary"});
    check_scene_refused(std::string("n\0a\0m\0e\0", 8), {"scene.toml", "UTF-16"});
    check_scene_refused("\xff\xfename", {"scene.toml:1"});
}

TEST_CASE("What a scene leaves out takes the documented default, and the inputs record it") {
    const std::string shortest = test::replaced(
        test::replaced(test::replaced(good.substr(0, good.find("[output]")), "laws = [\"fractal\"]\n", ""),
                       "peaks = [ { theta = \"pi/4\", r = \"exponential\" } ]\n", ""),
        "interaction = \"none\"\n", "");
    const auto scene = test::scene_of(shortest);
    const auto results = fstiff::actions::compute(scene);
    CHECK(test::Csv(test::csv_of(results)).size() == 1);  // of the answer
    for (const char* key :
         {"material.lower", "contact.laws", "contact.peaks", "contact.interaction", "output.quantities"}) {
        INFO(key);
        CHECK_FALSE(input_of(scene, key).given);
    }
    for (const char* column : {"stiffness_Pa_per_m", "separation_m", "real_area_fraction", "contacts_per_m2"})
        CHECK(test::contains(test::csv_of(results), column));

    // The defaults in full give the same numbers.
    std::string full = test::replaced(good, "[\"fractal\"]", "\"best\"");
    full =
        test::replaced(full, "\"exponential\" } ]", "\"exponential\" }, { theta = \"60 deg\", r = \"exponential\" } ]");
    full = test::replaced(full, "[\"stiffness\"]", "[\"contacts\", \"separation\", \"real_area\", \"stiffness\"]");
    full = test::replaced(full, "[contact]",
                          "[material.lower]\nyoungs_modulus = \"205000 N/mm^2\"\npoisson_ratio = 0.3\n[contact]");
    CHECK(test::csv_of(test::results_of(full)) == test::csv_of(results));
}

TEST_CASE("A scene records every input as written and in SI, and the SHA-256 of its text") {
    const auto scene = test::scene_of(good);
    CHECK(scene.name == "short");
    CHECK(input_of(scene, "surface.rms_height").written == "0.832 um");
    CHECK(input_of(scene, "surface.rms_height").value == 0.832e-6);
    CHECK(input_of(scene, "surface.rms_height").unit == "m");
    CHECK(input_of(scene, "contact.pressures[0]").value == 1e6);
    // the digest of "abc" is that of FIPS 180-4, appendix B.1
    CHECK(fstiff::document::sha256("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    CHECK(scene.sha256 == fstiff::document::sha256(good));
}

}  // namespace refused_scene_test
