// SPDX-License-Identifier: BSD-3-Clause
// Parts with a form, a step or lengths of metres are in doubt in every command, and the option that a warning names
// mends them.
#include "support/library.hpp"

#include <fstiff/profile/profile_form.hpp>

#include <cmath>
#include <random>
#include <regex>

namespace form_test {

using namespace fstiff;
using test::contains;

namespace {

constexpr double step = 0.5e-6;

/// \p form(x) [m] with roughness of sigma 0.3 um, correlated over 5 um, as a profile of 1 mm.
template <class Form>
std::string profile_text(const Form& form) {
    std::mt19937 random(11);
    std::normal_distribution<double> normal;
    Profile<double> profile{std::vector<double>(2000), step};
    double z = 0;
    for (std::size_t i = 0; i < 2000; ++i) {
        z = 0.9 * z + std::sqrt(1 - 0.81) * 0.3e-6 * normal(random);
        profile.heights[i] = z + form(static_cast<double>(i) * step);
    }
    std::ostringstream text;
    io::write_csv(text, profile);
    return text.str();
}

/// \p form(x, y) [m] on roughness of sigma 0.3 um, as a map of 128 um a side.
template <class Form>
std::string map_text(const Form& form) {
    HeightMap<double> map = self_affine_map<double>(
        {.hurst = 0.8, .rms = 0.3e-6, .longest_wavelength = 16e-6, .shortest_wavelength = 4e-6}, 128, 128, 1e-6, 1e-6);
    for (Eigen::Index j = 0; j < 128; ++j)
        for (Eigen::Index i = 0; i < 128; ++i)
            map.heights(j, i) += form(static_cast<double>(i) * 1e-6, static_cast<double>(j) * 1e-6);
    std::ostringstream text;
    io::write_csv(text, map);
    return text.str();
}

std::string scene_of(const std::string& file, const std::string& more) {
    return "material = { upper = \"steel\" }\n[surface]\nfrom = '" + file + "'\n" + more +
           "[contact]\npressures = [\"10 MPa\"]\n[uncertainty]\nsamples = 20\n";
}

struct Run {
    scene::Scene of;
    actions::Answered results;
    explicit Run(const std::string& text) : of(test::scene_of(text)), results(actions::compute(of)) {}
    [[nodiscard]] double sigma() const { return of.joint.face.parameters.rms_height.value; }
    [[nodiscard]] double K() const { return results.answer.points.front().state.stiffness.value; }
    [[nodiscard]] std::string said() const { return test::joined(results.warnings); }
};

/// Checks that the surface \p text is in doubt for \p words, and that the option in the warning mends it: sigma and K
/// are those of \p rough, within \p factor.
void check_mended(const std::string& text, const std::string& rough, const char* words, double factor) {
    const test::Folder folder;
    const std::string file = folder.write("form.csv", text), flat = folder.write("rough.csv", rough);
    const Run found(scene_of(file, "")), right(scene_of(flat, ""));
    INFO(found.said());
    CHECK(found.results.doubtful);
    CHECK(contains(found.said(), words));
    CHECK_FALSE(right.results.doubtful);
    std::smatch option;
    const std::string said = found.said();
    REQUIRE(std::regex_search(said, option, std::regex("(detrend|crop) = \"[^\"]*\"")));
    const Run mended(scene_of(file, option.str() + "\n"));
    INFO(option.str() << ": " << mended.said());
    CHECK_FALSE(mended.results.doubtful);
    CHECK(std::abs(std::log(mended.sigma() / right.sigma())) < std::log(factor));
    CHECK(std::abs(std::log(mended.K() / right.K())) < std::log(factor));
    const auto measured = test::measured("", text);  // the same by fstiff measure, and in a scene that reads its JSON
    CHECK((contains(measured["concerns"].dump(), "form") || contains(measured["concerns"].dump(), "step")));
    const Run again(scene_of(folder.write("measured.json", measured.dump()), ""));
    CHECK(again.results.doubtful);
    CHECK(contains(again.said(), "of the mean square height is one "));
}

}  // namespace

TEST_CASE("A trace across a ring is in doubt, and its parabola is the cause") {
    const std::string rough = profile_text([](double) { return 0.0; });
    for (const double radius : {1e-3, 4e-3, -20e-3, 60e-3})
        check_mended(profile_text([&](double x) { return -std::pow(x - 0.5e-3, 2) / (2 * radius); }), rough,
                     "one parabola; detrend = \"parabola\"", 1.3);
    // the parabola of 1 mm has the rms height L^2/(8 R) sqrt(4/45): 0.1 um for 0.37 m, a tenth of the square
    const test::Folder folder;
    const Run flat(scene_of(
        folder.write("flat.csv", profile_text([](double x) { return std::pow(x - 0.5e-3, 2) / (2 * 0.37); })), ""));
    CHECK_FALSE(contains(flat.said(), "parabola"));
    CHECK_FALSE(flat.results.doubtful);
}

TEST_CASE("A trace over a step is in doubt, and the part next to it is not") {
    const std::string rough = profile_text([](double) { return 0.0; });
    for (const double place : {0.12e-3, 0.3e-3, 0.5e-3, 0.8e-3})
        for (const double height : {3e-6, -20e-6})
            check_mended(profile_text([&](double x) { return x < place ? 0.0 : height; }), rough,
                         "of the mean square height is one step at ", 1.5);
}

TEST_CASE("Maps of a ball, a cylinder, a saddle and a wedge with a step are in doubt, and mended") {
    const std::string rough = map_text([](double, double) { return 0.0; });
    const auto square = [](double x) { return (x - 64e-6) * (x - 64e-6) / 1e-3; };
    const char* form = "one quadratic surface; detrend = \"quadratic\"";
    check_mended(map_text([&](double x, double y) { return -square(x) - square(y); }), rough, form, 1.3);
    check_mended(map_text([&](double x, double) { return -square(x); }), rough, form, 1.3);
    check_mended(map_text([&](double x, double y) { return square(0.6 * x + 0.8 * y - 30e-6); }), rough, form, 1.3);
    check_mended(map_text([&](double x, double y) { return square(x) - square(y); }), rough, form, 1.3);
    check_mended(map_text([](double x, double y) { return 0.02 * x + 0.01 * y + (x > 40e-6 ? 3e-6 : 0); }), rough,
                 "one step at ", 1.5);
    check_mended(map_text([](double, double y) { return y > 70e-6 ? 0 : 3e-6; }), rough, "one step at ", 1.5);
    const test::Folder folder;
    const Run oblique(
        scene_of(folder.write("map.csv", map_text([](double x, double y) { return x + y > 120e-6 ? 3e-6 : 0; })), ""));
    CHECK(oblique.results.doubtful);
    CHECK(contains(oblique.said(), "one step; crop or mask keeps one side of it"));
}

TEST_CASE("A form that stays by choice, and a sigma that is written, are in no doubt") {
    const test::Folder folder;
    const std::string ring =
        folder.write("ring.csv", profile_text([](double x) { return std::pow(x - 0.5e-3, 2) / 8e-3; }));
    for (const char* chosen : {"detrend = \"none\"\n", "detrend = \"mean\"\n"})
        CHECK_FALSE(contains(Run(scene_of(ring, chosen)).said(), "parabola"));
    const Run written(scene_of(ring, "rms_height = \"0.3 um\"\n"));
    CHECK_FALSE(written.results.doubtful);
    // next to another face: in doubt where most of the sum is the form
    const auto two = [&](const char* other) {
        return Run("material = { upper = \"steel\" }\n[surface.upper]\nfrom = '" + ring +
                   "'\n[surface.lower]\nSq = \"" + other +
                   "\"\nSdq = 0.2\n[contact]\npressures = [\"10 MPa\"]\n[uncertainty]\nsamples = 20\n")
            .results.doubtful;
    };
    CHECK(two("1 um"));
    CHECK_FALSE(two("100 um"));
}

TEST_CASE("Sigma with an error above half its value is in doubt in a scene as in a measurement") {
    const test::Folder folder;
    for (const std::string& text : {profile_text([](double x) { return 3e-6 * std::sin(7.5e3 * x); }),
                                    map_text([](double x, double) { return 2e-6 * std::sin(5e4 * x); })}) {
        const auto measured = test::measured("", text);
        const auto& height = measured["surface"]["rms_height"];
        REQUIRE(height["error"].get<double>() > 0.5 * height["value"].get<double>());
        CHECK(contains(measured["concerns"].dump(), "parameter_unknown"));
        CHECK(contains(measured["warnings"].dump(), "sigma ("));
        const Run found(scene_of(folder.write("waves.csv", text), ""));
        CHECK(found.results.doubtful);
        CHECK(contains(found.said(), "is not known to a factor of two"));
    }
}

TEST_CASE("Lengths of metres are a warning") {
    const auto warned = [](const std::string& how) {
        const auto document = test::measured(how, test::profile_text(400, 1e-6, {.hurst = 0.8, .rms = 0.3e-6}));
        return contains(document["source"]["warnings"].dump(), "a unit of its lengths is likely wrong");
    };
    CHECK(warned("--spacing '0.5 m' --units m"));
    CHECK_FALSE(warned(""));
    const std::string map = test::map_text(64, 1e-6, {.hurst = 0.8, .rms = 0.3e-6});
    const auto of_map = test::measured("--units m --dx '0.5 m' --dy '0.5 m'", map);
    CHECK(contains(of_map["warnings"].dump(), "a unit of its lengths is likely wrong"));
}

}  // namespace form_test
