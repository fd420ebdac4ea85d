// SPDX-License-Identifier: BSD-3-Clause
// The keys of a scene for the laws that are not in the paper. Truth: the library's contacts, made by hand; tests/data.
#include "actions/answered.hpp"

#include <fstiff/answer/face.hpp>
#include <fstiff/contact/hybrid_of_band.hpp>
#include <fstiff/contact/rough_contact.hpp>
#include <fstiff/halfspace/solve_half_space.hpp>
#include <fstiff/io/write.hpp>
#include <fstiff/surface/band_spectrum.hpp>
#include <fstiff/topography/form.hpp>
#include <fstiff/topography/map_spectrum.hpp>

#include "cli/command.hpp"
#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/half_space_maps.hpp"
#include "support/library.hpp"
#include "support/table.hpp"

#include <filesystem>
#include <fstream>
#include <numbers>

namespace laws_test {

using namespace fstiff;

namespace {

std::string scene_of(const std::string& surface, const std::string& laws, const std::string& more = "") {
    return "[surface]\n" + surface +
           "\n[material.upper]\nyoungs_modulus = \"2 GPa\"\npoisson_ratio = 0.0\nyield_strength = \"4 MPa\"\n"
           "[contact]\npressures = [\"1 MPa\", \"5 MPa\"]\nlaws = [" +
           laws + "]\npeaks = [{ theta = 1.0, r = 0.5 }]\n" + more;
}

actions::Answered computed(const std::string& text) {
    return actions::compute(scene::read_scene(text, {.name = "s.toml"}));
}

std::string refused(const std::string& text) {
    return test::refusal([&] { (void)computed(text); });
}

const std::string moments = "rms_height = \"1.1 um\"\nrms_gradient = 0.1\nalpha = 8.24\nhurst = 0.7";

/// The Gaussian map of tests/data, in SI over (100 um)^2, or \p rows of it with \p waves along y of its own height, in
/// a file.
class MapFile {
public:
    explicit MapFile(Eigen::Index rows = 256, double waves = 0) {
        map = test::half_space_map("gaussian");
        map.heights = (1e-4 * map.heights.topRows(rows)).eval();
        map.dx *= 1e-4;
        map.dy *= 1e-4;
        const double sigma = rms_height(map);
        for (Eigen::Index j = 0; j < rows; ++j)
            map.heights.row(j) +=
                sigma * std::sin(2 * std::numbers::pi * waves * static_cast<double>(j) / static_cast<double>(rows));
        folder_.write("map.csv", test::file_text(map));
    }
    [[nodiscard]] std::string surface() const {
        return "from = \"" + path() + "\"\ndetrend = \"mean\"\nlambda_s = \"none\"";
    }
    [[nodiscard]] std::string path() const { return folder_ / "map.csv"; }
    HeightMap<double> map;

private:
    test::Folder folder_;  // of this test alone: tests run side by side
};

}  // namespace

TEST_CASE("rms_height, rms_gradient and alpha suffice for hybrid and persson") {
    const auto results = computed(scene_of(moments, "\"hybrid\", \"persson\"", "[persson]\ngamma = 0.5\n"));
    const double E = 1e9;
    const auto m = detail::moments_of_gradient(1.1e-6, 0.1, 8.24);
    const PerssonContact<double> persson(detail::band_of_moments(m, 0.7), E, 0.5);
    const auto hybrid = hybrid_of_band(detail::band_of_moments(m, 0.7), E, 0.5);
    REQUIRE(results.curves().size() == 2);
    for (std::size_t i = 0; i < 2; ++i) {
        const double p = i == 0 ? 1e6 : 5e6;
        CHECK(test::relative_error(results.curves()[0].points[i].state.stiffness.value, hybrid.stiffness(p)) < 1e-12);
        CHECK(test::relative_error(results.curves()[1].points[i].state.stiffness.value, persson.stiffness(p)) < 1e-12);
        CHECK(test::relative_error(results.curves()[0].points[i].state.separation.value, hybrid.separation(p).value) <
              1e-10);
    }
    CHECK(test::relative_error(*results.curves()[0].points[0].p_star, 1e6 / (results.answer.effective_modulus * 0.1)) <
          1e-14);
    CHECK(results.curves()[1].points[0].state.contact_density.value == 0);
}

TEST_CASE("plastic laws take the hardness of the softer body, and print loading and unloading") {
    const std::string body =
        "\n[material.lower]\nyoungs_modulus = \"2 GPa\"\npoisson_ratio = 0.0\nhardness = \"9 MPa\"\n";
    const auto results =
        computed(scene_of(moments, "\"plastic\"", "[output]\nquantities = [\"loading_stiffness\"]" + body));
    const auto& state = results.curves()[0].points[0].state;
    const double area = 1e6 * std::hypot(1 / 9e6, 2 / (1e9 * 0.1));  // p sqrt(1/H^2 + 4/(E g)^2), nearly
    CHECK(test::relative_error(state.real_area_fraction.value, area) < 1e-3);
    CHECK(test::value_at(results.curves()[0], 0, "loading_stiffness") == state.loading_stiffness.value);
    CHECK(state.loading_stiffness.value > 0);
    const auto peaks = computed(scene_of(moments, "\"plastic_peaks\"", body));
    CHECK(test::relative_error(peaks.curves()[0].points[0].state.real_area_fraction.value, 1.0 / 9) < 1e-9);  // p/H
}

TEST_CASE("plastic laws warn where the mean over the load leaves their range") {
    const auto warnings_of = [](const std::string& surface, const std::string& law) {
        const auto results =
            computed("[surface]\n" + surface +
                     "\n[material.upper]\nyoungs_modulus = \"205 GPa\"\npoisson_ratio = 0.3\n"
                     "yield_strength = \"400 MPa\"\n[material.lower]\nyoungs_modulus = \"205 GPa\"\n"
                     "poisson_ratio = 0.3\n[contact]\npressures = [\"0.1 MPa\", \"10 MPa\", \"100 MPa\"]\n"
                     "peaks = [{ theta = 0.7853981633974483, r = 0 }]\nlaws = [\"" +
                     law + "\"]\n");
        std::vector<std::string> found;
        for (const std::string& warning : results.warnings)
            if (warning.starts_with("law " + law)) found.push_back(warning);
        return found;
    };
    const std::string fine = "rms_height = \"0.832 um\"\npeak_radius = \"40 um\"\npeak_density = \"500 /mm^2\"";
    const std::string edm = "rms_height = \"8.94 um\"\npeak_radius = \"19 um\"\npeak_density = \"160 /mm^2\"";
    // tests/data/plastic_curves.csv, fine: plastic 64.7 and 98.4 at 0.1 and 10 MPa; kogut_etsion 83.5 and 122.5
    const auto plastic = warnings_of(fine, "plastic_peaks"), kogut_etsion = warnings_of(fine, "kogut_etsion");
    REQUIRE(plastic.size() == 1);
    CHECK(plastic[0].find("at p = 0.1 MPa") != std::string::npos);
    CHECK(plastic[0].find("omega/omega_c = 64.65, below 110") != std::string::npos);
    REQUIRE(kogut_etsion.size() == 1);
    CHECK(kogut_etsion[0].find("2 of 3 points") != std::string::npos);
    CHECK(kogut_etsion[0].find("at p = 10 MPa") != std::string::npos);
    CHECK(kogut_etsion[0].find("above 110") != std::string::npos);
    CHECK(warnings_of(fine, "jackson_green").empty());
    CHECK(warnings_of(fine, "hertz").empty());
    const auto rough = warnings_of(edm, "jackson_green");
    REQUIRE(rough.size() == 1);
    CHECK(rough[0].find("above 0.41") != std::string::npos);
    CHECK(rough[0].find("omega/omega_c") == std::string::npos);  // its range is of a/R alone
}

TEST_CASE("laws of a map: its summits and boundary elements") {
    const MapFile file;
    const auto results = computed(scene_of(file.surface(), "\"summits\", \"hybrid\", \"boundary_elements\"",
                                           "[boundary_elements]\npoints = 128\nedges = \"periodic\"\n"));
    REQUIRE(results.curves().size() == 3);
    const auto truth = fstiff::solve_half_space(file.map, 1e9, std::vector<double>{1e6, 5e6},
                                                {.points = 128, .edges = Edges::periodic});
    for (std::size_t i = 0; i < 2; ++i) {
        // the file has nine digits or more
        CHECK(test::relative_error(results.curves()[2].points[i].state.stiffness.value, truth[i].state.stiffness) <
              1e-3);
        CHECK(test::relative_error(results.curves()[2].points[i].state.separation.value, truth[i].state.mean_gap) <
              1e-4);
        CHECK(results.curves()[2].points[i].state.stiffness.error > 0);
    }
    for (const auto& curve : results.curves()) CHECK_FALSE(curve.theta);
    CHECK_FALSE(results.curves()[2].has_band);
    CHECK(results.curves()[1].has_band);
    CHECK_FALSE(results.explanation.empty());
}

TEST_CASE("Every law of a measured surface divides by one sigma: that of the heights without their form", "[more]") {
    const MapFile file(200, 0.7), other(120, 0.4);
    const std::string rest =
        "\n[material.upper]\nyoungs_modulus = \"2 GPa\"\npoisson_ratio = 0.0\n[contact]\n"
        "pressures = [\"1 MPa\", \"5 MPa\"]\nlaws = [\"hertz\", \"hybrid\", \"persson\"]\n"
        "[uncertainty]\nsamples = 0\n";
    const std::string one = "from = \"" + file.path() + "\"\nlambda_s = \"none\"\n";
    const double sigma = rms_height(detail::remove_form(file.map, MapForm::plane)),
                 second = rms_height(detail::remove_form(other.map, MapForm::plane));
    const struct {
        std::string surface;
        double sigma;
    } cases[] = {{"[surface]\n" + one, sigma},
                 {"[surface.upper]\n" + one + "[surface.lower]\n" + one, std::sqrt(2.0) * sigma},
                 {"[surface]\nfrom = [\"" + file.path() + "\", \"" + other.path() + "\"]\nlambda_s = \"none\"\n",
                  std::sqrt((200 * sigma * sigma + 120 * second * second) / 320)}};
    for (const auto& of : cases) {
        CAPTURE(of.surface);
        const scene::Scene scene = scene::read_scene(of.surface + rest, {.name = "s.toml"});
        const double rms_height = scene.joint.face.parameters.rms_height.value;
        CHECK(test::relative_error(rms_height, of.sigma) < 1e-7);  // the file has nine digits
        CHECK(test::relative_error(scene.joint.face.map->spectrum().rms_height, rms_height) < 1e-12);
        CHECK(test::relative_error(scene.joint.face.map->rms_height(), rms_height) < 1e-12);
        const auto results = actions::compute(scene);
        REQUIRE(results.curves().size() == 3);
        for (const auto& curve : results.curves())
            for (const auto& state : test::states_of(curve)) {
                CAPTURE(fstiff::name_of(curve.law));
                CHECK(test::relative_error(state.separation.value / state.eta, rms_height) < 1e-12);
            }
    }
}

TEST_CASE("persson takes the spectrum of a map with its mirror images, or of one that repeats itself") {
    const MapFile file;
    for (const Edges edges : {Edges::mirrored, Edges::periodic}) {
        CAPTURE(name_of(edges));
        const auto results = computed(scene_of(
            file.surface(), "\"persson\"",
            "[boundary_elements]\nedges = \"" + std::string(name_of(edges)) + "\"\n[uncertainty]\nsamples = 0\n"));
        const PerssonContact<double> persson(map_spectrum(file.map, edges), 1e9);
        for (std::size_t i = 0; i < 2; ++i)
            CHECK(test::relative_error(results.curves()[0].points[i].state.stiffness.value,
                                       persson.stiffness(i == 0 ? 1e6 : 5e6)) < 1e-6);
    }
}

TEST_CASE("[persson] spectrum holds for a map and for its neighbours of lambda_s") {
    const MapFile file;
    for (const char* spectrum : {"map", "moments"}) {
        const std::string text =
            scene_of(file.surface(), "\"persson\"", "[persson]\nspectrum = \"" + std::string(spectrum) + "\"\n");
        const detail::Face face = scene::read_scene(text, {.name = "s.toml"}).joint.face;
        REQUIRE(!face.neighbours.empty());
        CHECK(face.spectrum_of_map == (std::string(spectrum) == "map"));
        for (const detail::Face& neighbour : face.neighbours) {
            CHECK(neighbour.map);
            CHECK(neighbour.spectrum_of_map == face.spectrum_of_map);
        }
    }
}

TEST_CASE("A pressure that a law does not reach leaves its other pressures and the other laws alone", "[more]") {
    const MapFile file;
    const auto at = [](std::string text, const std::string& pressures) {
        return test::replaced(std::move(text), "\"1 MPa\", \"5 MPa\"", pressures);
    };
    const std::string one_face = file.surface();
    const std::string two_faces = "shifts = 2\n[surface.upper]\n" + one_face + "\n[surface.lower]\n" + one_face;
    const std::string elements = "[boundary_elements]\npoints = 32\n";
    for (const std::string& surface : {one_face, two_faces}) {
        const std::string text = scene_of(surface, "\"hertz\", \"boundary_elements\"", elements);
        const auto reached = computed(at(text, "\"1 MPa\", \"5 MPa\""));
        const auto all = computed(at(text, "\"90 GPa\", \"1 MPa\", \"80 GPa\", \"5 MPa\""));
        REQUIRE(all.curves().size() == 2);
        const AnswerCurve& found = all.curves()[1];
        REQUIRE(found.points.size() == 4);
        CHECK(actions::count_of(found) == 2);
        CHECK(found.points[2].place == 2);
        CHECK(found.points[2].miss == AnswerPoint::Miss::law);
        CHECK(found.points[2].reason == "all points of the map are in contact");
        CHECK(found.at(3) == &found.points[3]);
        CHECK_FALSE(found.at(2));
        for (std::size_t i = 0; i < 2; ++i) {
            // the solver begins with the pressures of the point before: equal to its tolerance
            const double k = found.points[2 * i + 1].state.stiffness.value,
                         alone = reached.curves()[1].points[i].state.stiffness.value;
            CHECK(test::relative_error(k, alone) < 1e-5);
            // the band of a point is that of its pressure, whatever precedes it
            CHECK(all.curves()[0].points[2 * i + 1].state.stiffness.value ==
                  reached.curves()[0].points[i].state.stiffness.value);
            CHECK(all.curves()[0].points[2 * i + 1].stiffness.low == reached.curves()[0].points[i].stiffness.low);
        }
        CHECK(all.doubtful);
        CHECK(std::count(all.warnings.begin(), all.warnings.end(),
                         "law boundary_elements has no result at 2 of 4 points, the first of them 9e+10 Pa: all points "
                         "of the map are in contact") == 1);
    }
    const std::string text = scene_of(one_face, "\"hertz\", \"boundary_elements\"", elements);
    const auto none = computed(at(text, "\"90 GPa\""));
    CHECK(actions::count_of(none.curves()[1]) == 0);
    CHECK(none.curves()[0].points.size() == 1);
    CHECK(refused(at(scene_of(one_face, "\"boundary_elements\"", elements), "\"90 GPa\"")) ==
          "s.toml:10: contact.pressures: law boundary_elements: all points of the map are in contact");
    // at the hardness and above it, all points would flow
    const auto hard = computed(at(scene_of(one_face, "\"boundary_elements\"", elements + "hardness = \"100 MPa\"\n"),
                                  "\"100 MPa\", \"1 MPa\""));
    CHECK(hard.curves()[0].at(1));
    CHECK(hard.curves()[0].points[0].reason == "pressure = 1e+08: must be less than the hardness (Pa)");
}

TEST_CASE("No band of an elastomer pressed shut, and no p* of an extreme gradient, is beyond the range of double",
          "[more]") {
    const MapFile file;
    std::string soft = scene_of(file.surface(), "\"hybrid\", \"persson\", \"hertz\"");
    soft = test::replaced(soft, "2 GPa", "2 MPa");
    for (const char* pressure : {"1 MPa", "3 MPa", "8 MPa"}) {
        const auto results =
            computed(test::replaced(soft, "\"1 MPa\", \"5 MPa\"", "\"" + std::string(pressure) + "\""));
        for (const AnswerCurve& curve : results.curves())
            for (const AnswerPoint& point : curve.points)
                for (const AnswerPoint::Value& value : point.values) {
                    CHECK(std::isfinite(value.number.value));
                    CHECK(std::isfinite(value.error));
                    if (value.quantity->follows_stiffness())
                        CHECK((std::isfinite(value.number.low) && std::isfinite(value.number.high)));
                }
    }
    const std::string numbers = "rms_height = \"0.8 um\"\npeak_radius = \"40 um\"\npeak_density = \"500 /mm^2\"\n";
    for (const char* gradient : {"1e-308", "5e-324", "1e-170", "1e155", "1e308"}) {
        const std::string surface = numbers + "rms_gradient = " + gradient;
        INFO(gradient);
        CHECK(test::contains(refused(scene_of(surface, "\"persson\"")), "beyond the range of double precision"));
        const auto results = computed(scene_of(surface, "\"hertz\""));
        for (const auto& curve : results.curves())
            for (const AnswerPoint& point : curve.points) CHECK((!point.p_star || std::isfinite(*point.p_star)));
    }
}

TEST_CASE("scenes without the inputs of a law are refused with what is missing") {
    std::string weak = scene_of(moments, "\"jackson_green\"");
    weak = test::replaced(weak, "yield_strength = \"4 MPa\"\n", "");
    const std::pair<std::string, std::string> rows[] = {
        {scene_of(moments, "\"summits\""), "needs a map"},
        {scene_of(moments, "\"boundary_elements\""), "needs a map"},
        {scene_of(moments, "\"hybrid\"", "[persson]\ngamma = 0\n"), "persson.gamma = 0: must be"},
        {scene_of(moments, "\"hybrid\"", "[persson]\nspectrum = \"map\"\n"), "needs a map"},
        {scene_of(moments, "\"hybrid\"", "[boundary_elements]\npoints = 8\n"), "from 16 to 4096"},
        {scene_of("rms_height = \"1 um\"\nalpha = 1.5", "\"hybrid\""), "surface.alpha = 1.5"},
        {weak, "needs material.upper.yield_strength"}};
    for (const auto& [text, words] : rows) {
        INFO(words << " expected: " << refused(text));
        CHECK(test::contains(refused(text), words));
    }
}

TEST_CASE("With alpha and without given peaks, they are those of an isotropic surface, except for paper laws") {
    const std::string numbers = "rms_height = \"1 um\"\nrms_gradient = 0.1\nalpha = 25\nfractal_dimension = 1.4";
    const std::string text = scene_of(numbers, "\"fractal\", \"hertz\"");
    CHECK(computed(text).curves().size() == 2);  // peaks that are given hold for all
    const auto results = computed(test::replaced(text, "peaks = [{ theta = 1.0, r = 0.5 }]\n", ""));
    const auto curves = results.curves();
    REQUIRE(curves.size() == 3);
    for (std::size_t i = 0; i < 2; ++i) CHECK(fstiff::name_of(curves[i].law) == "fractal");
    CHECK(test::relative_error(*curves[1].theta, std::numbers::pi / 3) < 1e-15);
    CHECK(fstiff::name_of(curves[2].law) == "hertz");
    CHECK(test::relative_error(*curves[2].r, 0.2) < 1e-12);  // 1/sqrt(25)
    CHECK(*curves[2].theta == 1e-3);
}

}  // namespace laws_test
