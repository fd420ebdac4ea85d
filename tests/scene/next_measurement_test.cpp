// SPDX-License-Identifier: BSD-3-Clause
// The measurement that a scene advises next. Truth: the scene with that measurement written in its text, at the value
// that was assumed, and with each of the others.
#include "actions/answered.hpp"
#include "actions/explanation.hpp"
#include "support/library.hpp"

#include <cmath>
#include <map>

namespace next_measurement_test {

using namespace fstiff;

namespace {

using fstiff::Unknown;

struct Case {
    std::string surface, contact;

    [[nodiscard]] std::string text(const std::string& measured = "") const {
        return "[surface]\n" + surface + measured + "[material.upper]\nname = \"steel\"\n" + contact;
    }
};

/// K at 95 % over K at 5 % of the middle point of \p text.
double width_of(const std::string& text) {
    const auto results = test::results_of(text);
    const auto& band = results.answer.points.at(results.answer.points.size() / 2).stiffness;
    return band.high / band.low;
}

std::string line(const char* key, double value, const char* unit = "") {
    std::ostringstream text;
    text.precision(17);
    const std::string quote = *unit ? "\"" : "";
    text << key << " = " << quote << value << unit << quote << '\n';
    return text.str();
}

/// The texts of \p one with each measurement that is open, at the value that was assumed.
std::map<std::string, std::string> followed(const Case& one) {
    const scene::Scene read = test::scene_of(one.text());
    const detail::Face& face = test::face(read);
    std::map<std::string, std::string> all;
    if (face.is_open(Unknown::gradient)) all["Sdq"] = one.text(line("Sdq", *face.rms_gradient));
    if (face.is_open(Unknown::alpha)) all["alpha"] = one.text(line("alpha", *face.alpha));
    if (face.is_open(Unknown::hurst)) all["D or H"] = one.text(line("hurst", hurst_exponent(face)));
    if (face.is_open(Unknown::skewness))
        all["skewness"] = one.text(line("skewness", face.shape.skewness) + line("kurtosis", face.shape.kurtosis));
    if (read.joint.hardness_range)
        all["the hardness"] =
            Case{one.surface, line("hardness", read.joint.hardness_range->middle, " Pa") + one.contact}.text();
    if (face.is_open(Unknown::height)) {
        Case by = one;
        by.surface.erase(0, by.surface.find('\n') + 1);
        all["Rq or Sq"] = by.text(line("Rq", face.parameters.rms_height.value, " m"));
    }
    return all;
}

}  // namespace

TEST_CASE("The measurement advised next narrows the band most of all, by the printed factor, when it is made") {
    int advised = 0, of_gradient = 0;
    for (const char* process : {"unknown", "ground", "turned", "honed", "polished", "blasted"})
        for (const char* known : {"", "Sdq = 0.15\n"})
            for (const char* hardness : {"", "hardness = \"2 GPa\"\n"})
                for (const char* pressure : {"3 MPa", "200 MPa"}) {
                    const Case one{"Ra = \"0.8 um\"\n" + ("process = \"" + std::string(process) + "\"\n") + known,
                                   hardness + ("[contact]\npressures = [\"" + std::string(pressure) + "\"]\n")};
                    INFO(one.text());
                    const scene::Scene read = test::scene_of(one.text());
                    const std::string next = actions::measure_next(actions::compute(read));
                    const double now = width_of(one.text());
                    INFO(next);
                    std::map<std::string, double> widths;
                    for (const auto& [what, text] : followed(one)) widths[what] = width_of(text);
                    REQUIRE_FALSE(widths.empty());
                    double least = now;
                    for (const auto& [what, width] : widths) least = std::min(least, width);
                    if (next.empty()) {
                        CHECK(least > 0.94 * now);
                        continue;
                    }
                    double from = 0, to = 0;
                    const std::string numbers = next.substr(next.find("narrows"));
                    REQUIRE(std::sscanf(numbers.c_str(), "narrows from a factor of %lf to %lf", &from, &to) == 2);
                    CHECK(to < from);
                    CHECK(std::abs(from / now - 1) < 0.06);  // two digits
                    bool named = false;
                    for (const auto& [what, width] : widths)
                        if (next.starts_with("measure " + what)) {
                            named = true;
                            CHECK(std::abs(to / width - 1) < 0.06);
                            CHECK(width <= least * (1 + 1e-6));
                        }
                    CHECK(named);
                    ++advised;
                    of_gradient += next.starts_with("measure Sdq");
                }
    CHECK(advised >= 20);
    CHECK(of_gradient >= 5);
}

TEST_CASE("No measurement is advised where none narrows the band by a twentieth") {
    const Case all{"Rq = \"1 um\"\nSdq = 0.1\nalpha = 8\nhurst = 0.8\nskewness = 0\nkurtosis = 3\n",
                   "hardness = \"infinite\"\n[contact]\npressures = [\"10 MPa\"]\n"};
    const scene::Scene read = test::scene_of(all.text());
    CHECK(actions::measure_next(actions::compute(read)).empty());
    // alpha and H alone are open: K of hybrid hardly depends on them
    const Case little{"Rq = \"1 um\"\nSdq = 0.1\nskewness = 0\nkurtosis = 3\n",
                      "hardness = \"infinite\"\n[contact]\npressures = [\"10 MPa\"]\n"};
    const scene::Scene known = test::scene_of(little.text());
    CHECK(actions::measure_next(actions::compute(known)).empty());
}

TEST_CASE("A measurement that leaves no band is not advised, and loses no answer") {
    const std::string text =
        "[surface]\nrms_height = \"0.832 um\"\npeak_radius = \"40 um\"\npeak_density = \"500 /mm^2\"\n"
        "errors = { rms_height = \"0.05 um\", peak_radius = \"4 um\" }\n[material.upper]\nname = \"steel\"\n"
        "yield_strength = \"400 MPa\"\n[contact]\npressures = [\"1 MPa\", \"10 MPa\"]\nlaws = [\"hertz\"]\n"
        "[uncertainty]\nsamples = 20\n";  // R and D_p near those of islands: some drawn ones are of summits
    const scene::Scene read = test::scene_of(text);
    const auto results = actions::compute(read);
    REQUIRE(results.has_answer());
    CHECK_NOTHROW(actions::measure_next(results));
}

TEST_CASE("Two faces that both lack a number are advised to measure it of both") {
    const std::string text =
        "[surface.upper]\nRa = \"0.8 um\"\n[surface.lower]\nRa = \"0.4 um\"\n[material]\nupper = \"steel\"\n"
        "[contact]\npressures = [\"10 MPa\"]\n";
    const scene::Scene read = test::scene_of(text);
    const std::string next = actions::measure_next(actions::compute(read));
    INFO(next);
    REQUIRE(next.starts_with("measure Sdq or Rdq of both faces: the band at 10 MPa narrows from a factor of "));
    const auto gradient = [](const detail::Face& face) { return line("Sdq", *face.rms_gradient); };
    const double after = width_of("[surface.upper]\nRa = \"0.8 um\"\n" + gradient(read.joint.faces[0]) +
                                  "[surface.lower]\nRa = \"0.4 um\"\n" + gradient(read.joint.faces[1]) +
                                  "[material]\nupper = \"steel\"\n[contact]\npressures = [\"10 MPa\"]\n");
    double from = 0, to = 0;
    REQUIRE(std::sscanf(next.substr(next.find("narrows")).c_str(), "narrows from a factor of %lf to %lf", &from, &to) ==
            2);
    CHECK(std::abs(to / after - 1) < 0.06);
}

TEST_CASE("A trace across a lay asks for a map, also where --surface takes the place of [surface] but its process") {
    const test::Folder folder;
    const std::string trace = folder.write(
        "trace.csv",
        test::profile_text(4096, 1e-6,
                           {.hurst = 0.7, .rms = 0.5e-6, .longest_wavelength = 200e-6, .shortest_wavelength = 2e-6}));
    const auto text = [](const std::string& surface) {
        return "[surface]\n" + surface + "process = \"ground\"\n[material]\nupper = \"steel\"\n" +
               "[contact]\npressures = [\"30 MPa\"]\n";
    };
    const auto of_text = test::scene_of(text("from = \"trace.csv\"\n"), folder / "scene.toml"),
               in_place = scene::read_scene(text("Ra = \"9 um\"\n"), {.name = "scene.toml", .surface = trace});
    const auto results = actions::compute(of_text);
    const auto& reason = results.answer.points.at(0);
    CHECK(reason.causes[static_cast<std::size_t>(Cause::lay)].high > 0);
    CHECK(actions::measure_next(results).find("measure a map: the band at 30 MPa narrows") == 0);
    CHECK(test::csv_of(results) == test::csv_of(actions::compute(in_place)));
}

}  // namespace next_measurement_test
