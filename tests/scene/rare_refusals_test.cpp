// SPDX-License-Identifier: BSD-3-Clause
// Values that scenes, documents and files rarely have: each is refused in one sentence that names what is allowed.
#include "support/library.hpp"

#include "actions/overclosure.hpp"

namespace rare_refusals_test {

using namespace fstiff;

namespace {

const std::string good = R"([surface]
rms_height = "0.8 um"
peak_radius = "40 um"
peak_density = "500 /mm^2"
[material.upper]
youngs_modulus = "205 GPa"
poisson_ratio = 0.3
[contact]
pressures = ["1 MPa"]
laws = ["hertz"]
peaks = [ { theta = "pi/4", r = 0.5 } ]
[output]
quantities = ["stiffness"]
)";
const std::string waves =
    "[ultrasound]\nfrequency = \"7 MHz\"\nupper = { density = \"7850 kg/m^3\", velocity = \"5900 m/s\" }\n";

void check_replaced(const std::string& text, const std::string& from, const std::string& to,
                    const std::vector<std::string>& parts) {
    INFO(from << " -> " << to);
    test::check_sentence(test::refused_scene(test::replaced(text, from, to)), parts);
}

}  // namespace

TEST_CASE("Every dimension shows how one of its quantities is written, where a number has no unit") {
    const std::string text = good + waves;
    check_replaced(text, "\"0.8 um\"", "0.8", {"surface.rms_height = 0.8", "such as \"0.8 um\""});
    check_replaced(text, "\"500 /mm^2\"", "500", {"surface.peak_density = 500", "such as \"500 /mm^2\""});
    check_replaced(text, "\"205 GPa\"", "205", {"material.upper.youngs_modulus = 205", "without a unit"});
    check_replaced(text, "[\"1 MPa\"]", "[\"1 MPa\"]\nnominal_area = 195",
                   {"nominal_area = 195", "such as \"195 mm^2\""});
    check_replaced(text, "\"5900 m/s\"", "5900", {"ultrasound.upper.velocity = 5900", "such as \"5900 m/s\""});
    check_replaced(text, "\"7850 kg/m^3\"", "7850", {"ultrasound.upper.density = 7850", "such as \"7850 kg/m^3\""});
    check_replaced(text, "density = \"7850 kg/m^3\", velocity = \"5900 m/s\"", "impedance = 46",
                   {"ultrasound.upper.impedance = 46", "such as \"46 MRayl\""});
    check_replaced(text, "\"7 MHz\"", "7", {"ultrasound.frequency = 7", "such as \"7 MHz\""});
    check_replaced(text, "\"0.8 um\"", "2026-11-23", {"surface.rms_height = a date or a time", "must be a text"});
}

TEST_CASE("Values of a scene that are rare are refused with what is allowed") {
    check_replaced(good + waves, "5900 m/s", "1e306 m/s", {"velocity", "in the range of double precision"});
    check_replaced(good, "pressures = [\"1 MPa\"]",
                   "separations = { from = \"-1 um\", to = \"1 um\", count = 3, spacing = \"log\" }",
                   {"contact.separations.from", "greater than 0 for spacing = \"log\""});
    const std::string peaks = "[ { theta = \"pi/4\", r = 0.5 } ]";
    check_replaced(good, peaks, "\"surface\"", {"contact.peaks", "needs surface.r and surface.theta"});
    check_replaced(good, peaks, "[3]", {"contact.peaks[0] = 3", "must be a table such as"});
    check_replaced(good, peaks, "3", {"contact.peaks = 3", "must be \"surface\" or a list of tables"});
    check_replaced(good, "theta = \"pi/4\"", "theta = true", {"theta = true", "a number of radians or a text such as"});
    check_replaced(good, "[output]", "[uncertainty]\nseed = -1\n[output]",
                   {"uncertainty.seed = -1", "must be a whole number from 0 to"});
    const std::string radius = "peak_radius = \"40 um\"\n";
    check_replaced(good, radius, radius + "errors = { fractal_dimension = 0.1 }\n",
                   {"surface.errors.fractal_dimension", "needs the value of surface.fractal_dimension"});
    check_replaced(good, radius, radius + "r = 0.5\n", {"surface.theta: is missing", "belong together"});
    check_replaced(good, "pressures = [\"1 MPa\"]\nlaws = [\"hertz\"]",
                   "separations = [\"1 um\"]\nlaws = [\"boundary_elements\"]", {"boundary_elements"});
    const std::size_t begin = good.find("rms"), end = good.find("[material");
    const std::string numbers = good.substr(begin, end - begin), bodies = good.substr(end);
    test::check_sentence(test::refused_scene("[surface]\nshifts = 0\n[surface.upper]\n" + numbers +
                                             "[surface.lower]\n" + numbers + bodies),
                         {"surface.shifts = 0", "whole number from 1 to 1000"});
    test::check_sentence(test::refused_scene(good + std::string(1 << 20, '\n')),
                         {"scene.toml: has ", "must be at most 1 MiB"});
}

TEST_CASE("A table of pressures asks a scene of separations for its range") {
    const scene::Scene read =
        test::scene_of(test::replaced(good, "pressures = [\"1 MPa\"]", "separations = [\"1 um\"]"));
    test::check_sentence(test::refusal([&] { (void)actions::pressure_table(read, {}); }),
                         {"from and until must give the range"});
    CHECK(test::refusal([&] { (void)actions::pressure_table(read, {.from = 1e6, .to = 1e7}); }).empty());
}

TEST_CASE("A document of a measurement without its parts, or with impossible ones, is refused") {
    const auto document = test::measured("", test::profile_text(2048, 1e-6, {.hurst = 0.6, .rms = 1e-6}));
    const auto refused = [](const nlohmann::json& changed) {
        return test::refusal([&] { (void)surface::read_measured_document(changed.dump(), "m.json"); });
    };
    CHECK(refused(document).empty());
    auto changed = document;
    changed.erase("surface");
    test::check_sentence(refused(changed), {"m.json: surface: is missing", "must be that of fstiff measure"});
    changed = document;
    changed["shape_share"] = 2;
    test::check_sentence(refused(changed), {"m.json: shape_share: must be from 0 to 1"});
    changed = document;
    changed["moments"]["m2"] = -1;
    test::check_sentence(refused(changed), {"m.json: moments: must be greater than 0"});
    const test::Folder folder;
    folder.write("m.json", document.dump());
    const std::string from = "[surface]\nfrom = \"m.json\"\nunits = \"um\"\n" + good.substr(good.find("[material"));
    test::check_sentence(test::refused_scene(from, folder / "scene.toml"),
                         {"m.json: is the JSON of fstiff measure, measured already"});
}

TEST_CASE("Ra of files of one surface has one lambda_c, and a ragged mask is refused") {
    const test::Folder folder;
    const auto trace = [&](const char* name, double rms) {
        return folder.write(name,
                            test::profile_text(16384, 0.5e-6, {.hurst = 0.5, .rms = rms, .longest_wavelength = 2e-4}));
    };
    const std::vector<std::string> files{trace("fine", 0.1e-6), trace("coarse", 2e-6)};
    // alone the table gives them 0.25 mm and 0.8 mm; together they have one
    const auto lambda_c = [&](const std::vector<std::string>& of) {
        const auto document = test::measured_files("", of);
        CHECK(document["lambda_c_m"].is_null());
        return document["roughness"]["lambda_c_m"];
    };
    CHECK(lambda_c({files[0]}) != lambda_c({files[1]}));
    CHECK(lambda_c(files) == std::max(lambda_c({files[0]}), lambda_c({files[1]})));
    const std::string mask = folder.write("mask.txt", "1 1 0\n1 1\n");
    test::check_sentence(test::refusal([&] { (void)test::measured_files("--mask '" + mask + "'", files); }),
                         {"mask.txt: row 2 has 2 numbers", "as many as the rows before, 3"});
}

}  // namespace rare_refusals_test
