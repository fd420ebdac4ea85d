// SPDX-License-Identifier: BSD-3-Clause
// A scene from little: height and gradient by other names, the process, and what is taken for the rest. Truth: the same
// numbers written out, K by the library, and surfaces drawn at random.
#include "actions/answered.hpp"
#include "scene/scene.hpp"

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/library.hpp"

#include <fstiff/answer/curves.hpp>
#include <fstiff/answer/face.hpp>
#include <fstiff/answer/lacks.hpp>
#include <fstiff/answer/unknowns.hpp>
#include <fstiff/contact/persson_contact.hpp>
#include <fstiff/math/random.hpp>
#include <fstiff/math/statistics.hpp>
#include <fstiff/surface/process_prior.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <span>
#include <string>
#include <vector>

namespace from_little_test {

using namespace fstiff;

const std::string steel =
    "[material.upper]\nyoungs_modulus = \"205 GPa\"\npoisson_ratio = 0.3\nhardness = \"1.12 GPa\"\n";

std::string text_of(const std::string& surface, const std::string& laws = "\"hybrid\"") {
    return "[surface]\n" + surface + "\n" + steel +
           "[contact]\npressures = [\"1 MPa\", \"10 MPa\", \"100 MPa\"]\nlaws = [" + laws + "]\n";
}
scene::Scene read(const std::string& surface, const std::string& laws = "\"hybrid\"") {
    return scene::read_scene(text_of(surface, laws), {.name = "s.toml"});
}
actions::Answered results(const std::string& surface, const std::string& laws = "\"hybrid\"") {
    return actions::compute(read(surface, laws));
}

/// The curve of the first law with the parts of its band.
detail::LawCurve curve_of(const std::string& surface, const std::string& laws = "\"hybrid\"") {
    const scene::Scene scene = read(surface, laws);
    return curves_of(scene.joint, detail::Request{.points = scene.points,
                                                  .laws = scene.laws,
                                                  .samples = scene.samples,
                                                  .seed = scene.seed,
                                                  .answers = false})
        .named.front();
}
std::vector<double> stiffnesses(const std::string& surface, const std::string& laws = "\"hybrid\"") {
    std::vector<double> all;
    for (const auto& curve : results(surface, laws).curves())
        for (const auto& state : test::states_of(curve)) all.push_back(state.stiffness.value);
    return all;
}
std::string refusal(const std::string& surface) { return test::refused_scene(text_of(surface), "s.toml"); }
TEST_CASE("Every name of height and gradient gives its number") {
    const std::string rest = "\nalpha = 8\nhurst = 0.8\nskewness = 0\nkurtosis = 3";
    const auto written = stiffnesses("rms_height = \"0.8 um\"\nrms_gradient = 0.2" + rest);
    for (const char* height : {"Rq = \"0.8 um\"", "Sq = \"800 nm\"", "rms_height = \"0.0008 mm\""})
        for (const std::string& gradient :
             {std::string("Sdq = 0.2"), "Rdq = " + document::exact(0.2 / std::sqrt(2.0))}) {
            const auto found = stiffnesses(height + ("\n" + gradient) + rest);
            for (std::size_t i = 0; i < 3; ++i) CHECK(test::relative_error(found[i], written[i]) < 1e-13);
        }
    // Ra/Rq is 0.8, and RSm counts crossings
    const auto face = read("Ra = \"0.64 um\"\nRSm = \"40 um\"" + rest).joint.face;
    CHECK(test::relative_error(face.parameters.rms_height.value, 0.8e-6) < 1e-15);
    CHECK(test::relative_error(*face.rms_gradient, std::sqrt(2.0) * 2.3 * 2 * std::numbers::pi_v<double> * 0.8 / 40) <
          1e-14);
    CHECK(read("Ra = \"0.64 um\"\nprocess = \"turned\"").joint.face.parameters.rms_height.value == 0.64e-6 / 0.84);
    // across a lay a profile is between the gradient and its sqrt(2)th part
    const detail::Face ground = read("Rq = \"1 um\"\nRdq = 0.1\nprocess = \"ground\"").joint.face;
    CHECK(test::relative_error(*ground.rms_gradient, 0.1 * std::pow(2, 0.25)) < 1e-14);
    REQUIRE(ground.is_open(Unknown::gradient));
    CHECK(test::relative_error(ground.priors.front().high, 0.1 * std::sqrt(2.0)) < 1e-14);
    CHECK_FALSE(read("Rq = \"1 um\"\nRdq = 0.1").joint.face.is_open(Unknown::gradient));
}

TEST_CASE("Height alone, and height with gradient, have K with a band by every law that needs no more") {
    for (const char* surface :
         {"Ra = \"0.8 um\"", "rms_height = \"1 um\"", "Rq = \"1 um\"\nRdq = 0.1",
          "rms_height = \"1 um\"\nrms_gradient = 0.14", "Sq = \"1 um\"\nalpha = 5",
          "Sq = \"1 um\"\npeak_radius = \"20 um\"", "Sq = \"1 um\"\npeak_density = \"1000 /mm^2\"",
          "Ra = \"0.8 um\"\nprocess = \"honed\""}) {
        const auto found = results(surface, "\"hybrid\", \"plastic\", \"hertz\", \"persson\", \"proportional\"");
        INFO(surface);
        REQUIRE(found.curves().size() == 5);
        for (const AnswerCurve& curve : found.curves())
            for (std::size_t i = 0; i < curve.points.size(); ++i) {
                const double K = curve.points[i].state.stiffness.value;
                CHECK(K > 0);
                if (curve.has_band) CHECK((curve.points[i].stiffness.low <= K && K <= curve.points[i].stiffness.high));
            }
        const auto& hybrid = found.curves().front();
        REQUIRE(hybrid.points.size() == 3);
        CHECK(hybrid.points[2].stiffness.high / hybrid.points[2].stiffness.low > 1.3);
        CHECK(hybrid.points[2].stiffness.high / hybrid.points[2].stiffness.low < 20);
    }
}

TEST_CASE("Assumptions are printed and recorded") {
    const scene::Scene little = read("Ra = \"0.8 um\"");
    REQUIRE(little.assumptions.size() == 6);
    CHECK(little.assumptions[0] == "Ra/Rq 0.8 (0.74 to 0.86), of any process");
    CHECK(little.assumptions[1] == "rms gradient 0.2 (0.067 to 0.6), of any process");
    CHECK(little.assumptions[2] == "alpha 8 (2 to 50), of any process");
    using test::input_of;
    const auto input = [&](const std::string& key) { return input_of(little, key); };
    // numbers of other names are those of the height and the gradient
    const scene::Scene other = read("Sq = \"0.8 um\"\nSdq = 0.1");
    CHECK(input_of(other, "surface.rms_height").value == 0.8e-6);
    CHECK(input_of(other, "surface.rms_gradient").value == 0.1);
    CHECK(input_of(other, "surface.rms_gradient").shown() == "of Sdq (default)");
    CHECK(input("surface.Ra").written == "0.8 um");
    CHECK(input("surface.Ra").value == 0.8e-6);
    CHECK(input("surface.rms_height").value == 1e-6);
    CHECK(input("surface.rms_gradient").value == 0.2);
    CHECK(input("surface.alpha").shown() == "assumed (default)");
    CHECK(std::count_if(little.inputs.begin(), little.inputs.end(),
                        [](const request::Input& one) { return one.key == "surface.rms_height"; }) == 1);
    // the numbers written out are the same scene, with nothing assumed
    const std::string all =
        "rms_height = \"1 um\"\nrms_gradient = 0.2\nalpha = 8\nhurst = 0.8\nskewness = 0\nkurtosis = 3";
    CHECK(read(all).assumptions.empty());
    CHECK(stiffnesses(all) == stiffnesses("Ra = \"0.8 um\""));
    CHECK_FALSE(results(all).curves().front().has_band);
    // laws that do not take it do not assume it
    CHECK(read("rms_height = \"1 um\"\npeak_radius = \"40 um\"\npeak_density = \"500 /mm^2\"\nr = 0.5\ntheta = 0.7",
               "\"hertz\"")
              .assumptions.empty());
}

TEST_CASE("Contradictions and extremes are refused by one sentence") {
    for (const auto& [surface, part] : {
             std::pair("Ra = \"1 um\"\nRq = \"1 um\"", "must not be given with surface.Rq; give one of the two"),
             {"Ra = \"1 um\"\nrms_height = \"1 um\"", "must not be given with surface.rms_height"},
             {"Rq = \"1 um\"\nRdq = 0.1\nrms_gradient = 0.1", "must not be given with surface.rms_gradient"},
             {"Rq = \"1 um\"\nRdq = 0.1\nRSm = \"40 um\"", "give one of the two"},
             {"Rdq = 0.1", "surface.rms_height: is missing; the scene needs the height of the surface"},
             {"Rz = \"5 um\"", "s.toml:2: surface.Rz = \"5 um\": is the height from the deepest valley"},
             {"Rq = \"1 um\"\nRdq = 0", "Rdq = 0: must be finite and greater than 0"},
             {"Rq = \"1 um\"\nprocess = \"cast\"", "must be one of"},
             {"Rq = \"1 um\"\nerrors = { Ra = \"0.1 um\" }", "needs the value of surface.Ra"},
             {"Rq = \"1 um\"\nerrors = { peak_radius = \"1 um\" }", "needs the value of surface.peak_radius"},
         }) {
        INFO(surface << " -> " << refusal(surface));
        CHECK(test::contains(refusal(surface), part));
    }
}

TEST_CASE("Errors of other names are those of the numbers they make") {
    const scene::Scene one = read("Ra = \"0.8 um\"\nRdq = 0.1\nerrors = { Ra = \"0.08 um\", Rdq = 0.01 }");
    CHECK(test::relative_error(one.joint.face.parameters.rms_height.error, 0.1e-6) < 1e-14);
    CHECK(test::relative_error(one.joint.face.gradient_error, 0.01 * std::sqrt(2.0)) < 1e-14);
}

TEST_CASE("A surface of R and D_p that no Gaussian surface has takes them for those of islands") {
    const scene::Scene paper = scene::read_scene(scene::builtin_scene, {.name = "built-in"});
    REQUIRE(paper.joint.face.rms_gradient);
    CHECK(*paper.joint.face.rms_gradient > 0.14);  // maps with its sigma and D_p have 0.124, with its sigma and R 0.175
    CHECK(*paper.joint.face.rms_gradient < 0.165);
    CHECK(lack_of_spectrum(paper.joint.face) == detail::Lack::nothing);
    const std::string numbers = "rms_height = \"0.832 um\"\npeak_radius = \"40 um\"\npeak_density = \"500 /mm^2\"";
    const auto plastic = results(numbers + "\nskewness = 0\nkurtosis = 3", "\"plastic\"").curves().front();
    CHECK(test::relative_error(plastic.points[1].state.stiffness.value, 0.14e15) <
          0.12);  // boundary elements: 0.11 to 0.18
    CHECK(test::relative_error(plastic.points[1].stiffness.low, 0.11e15) < 0.12);
    CHECK(test::relative_error(plastic.points[1].stiffness.high, 0.18e15) < 0.12);
    // the answer has the error of the law of numbers too, not that of a height alone
    const auto answer = actions::compute(paper).answer;
    for (std::size_t i = 0; i < answer.points.size(); ++i) {
        if (test::relative_error(answer.points[i].state.pressure.value, 10e6) > 1e-6) continue;
        CHECK(answer.points[i].stiffness.low < 0.11e15);  // of a shape that is not known, too
        CHECK(test::relative_error(answer.points[i].state.stiffness.value, 0.14e15) < 0.12);
        CHECK(answer.points[i].stiffness.high > 0.18e15);
        // 6.3: heights with a flat top, which are possible too, have a stiffer cut
        CHECK(answer.points[i].stiffness.high < 6.5 * answer.points[i].of_faces().low);
    }
}

/// 5 and 95 % of K at every point, over surfaces with every unknown but the shape drawn at random, ln K normal about
/// the middle by halves.
std::vector<std::pair<double, double>> drawn(scene::Scene scene) {
    scene.samples = 0;
    std::vector<std::vector<double>> all(scene.points.size());
    std::uint64_t state = 7;
    for (int i = 0; i < 700; ++i) {
        scene::Scene one = scene;
        for (const detail::Prior& prior : scene.joint.face.priors) {
            if (detail::is_of_shape(prior.which) || prior.which == Unknown::hurst) continue;
            const double middle = prior.which == Unknown::height     ? scene.joint.face.parameters.rms_height.value
                                  : prior.which == Unknown::gradient ? *scene.joint.face.rms_gradient
                                                                     : *scene.joint.face.alpha;
            const double z = math::normal_pair<double>(state).real() / 1.6449;
            const double value = middle * std::pow((z < 0 ? prior.low : prior.high) / middle, std::abs(z));
            one.joint.face = detail::with_value(one.joint.face, prior.which, std::max(value, 1.55e-7));
        }
        if (*one.joint.face.alpha < 1.55) one.joint.face = detail::with_value(one.joint.face, Unknown::alpha, 1.55);
        const auto results = actions::compute(one);
        for (std::size_t point = 0; point < all.size(); ++point)
            all[point].push_back(results.curves().front().points[point].state.stiffness.value);
    }
    std::vector<std::pair<double, double>> ends;
    for (std::vector<double>& of_point : all) {
        std::sort(of_point.begin(), of_point.end());
        ends.emplace_back(of_point[of_point.size() / 20], of_point[of_point.size() * 19 / 20]);
    }
    return ends;
}

TEST_CASE("The band over what is not known is that of surfaces drawn at random", "[more]") {
    scene::Scene little = read("Ra = \"0.8 um\"\nskewness = 0\nkurtosis = 3\nhurst = 0.8", "\"plastic\"");
    little.points = {little.points.front(), little.points.back()};
    const auto found = actions::compute(little).curves().front();
    const auto ends = drawn(little);
    for (std::size_t point = 0; point < ends.size(); ++point) {
        const auto [low, high] = ends[point];
        CHECK(std::abs(std::log(found.points[point].stiffness.low / low)) < 0.1 * std::log(high / low));
        CHECK(std::abs(std::log(found.points[point].stiffness.high / high)) < 0.1 * std::log(high / low));
    }
}

TEST_CASE("The parts of a band are those of what is not known") {
    const auto plastic = curve_of("Ra = \"0.8 um\"\nskewness = 0\nkurtosis = 3", "\"plastic\"");
    REQUIRE(plastic.band_parts.size() == 3);
    const auto& parts = plastic.band_parts[1];
    CHECK(parts.errors_low == 0);
    CHECK(parts.shape_high == 0);
    CHECK(parts.prior_low < 0);
    const double K = plastic.states[1].stiffness.value;
    CHECK(test::relative_error(plastic.band[1].high, K * std::exp(parts.prior_high)) < 1e-12);
    CHECK(test::relative_error(plastic.band[1].low, K * std::exp(parts.prior_low)) < 1e-12);
    // once the gradient is known its part is gone, and the others are what they were
    const auto measured = curve_of("Ra = \"0.8 um\"\nRdq = 0.1414\nskewness = 0\nkurtosis = 3", "\"plastic\"");
    const auto& gradient = parts.part_of(Unknown::gradient);
    const double low = std::hypot(measured.band_parts[1].prior_low, gradient.low),
                 high = std::hypot(measured.band_parts[1].prior_high, gradient.high);
    CHECK(std::abs((low + high) / std::log(plastic.band[1].high / plastic.band[1].low) - 1) < 0.03);
}

TEST_CASE("The shape of the heights widens the band of a law that takes it") {
    const auto known = curve_of("rms_height = \"1 um\"\nrms_gradient = 0.2\nskewness = 0\nkurtosis = 3");
    const auto open = curve_of("rms_height = \"1 um\"\nrms_gradient = 0.2");
    CHECK(open.band_parts[1].shape_low < -0.1);
    CHECK(open.band_parts[1].shape_high > 0.1);
    CHECK(open.band_parts[1].prior_high == known.band_parts[1].prior_high);
    CHECK(open.band[1].high > known.band[1].high);
}

TEST_CASE("Of two faces of which little is known each widens the band") {
    const std::string face = "Ra = \"0.8 um\"";
    const auto two = results("[surface.upper]\n" + face + "\n[surface.lower]\n" + face).curves().front();
    const auto one = results(face).curves().front();
    REQUIRE(two.points.size() == 3);
    const auto width = [](const AnswerCurve& curve) {
        return std::log(curve.points[1].stiffness.high / curve.points[1].stiffness.low);
    };
    CHECK(width(two) < width(one));      // independent faces average
    CHECK(width(two) > width(one) / 4);  // and the shape of their sum is nearer to Gaussian
    CHECK(read("[surface.upper]\n" + face + "\n[surface.lower]\n" + face).assumptions.front() ==
          "upper: Ra/Rq 0.8 (0.74 to 0.86), of any process");
}

TEST_CASE("A worn face has the shape of a honed one, whatever made it, and the gradient of its own process") {
    const auto assumed = [](const std::string& keys) { return read("Ra = \"0.8 um\"\n" + keys).joint.face; };
    const detail::Face worn = assumed("process = \"ground\"\nworn = true"), ground = assumed("process = \"ground\""),
                       honed = assumed("process = \"honed\"");
    CHECK(worn.shape.skewness == honed.shape.skewness);
    CHECK(worn.shape.kurtosis == honed.shape.kurtosis);
    CHECK(worn.parameters.rms_height.value == honed.parameters.rms_height.value);
    CHECK(*worn.alpha == *ground.alpha);
    CHECK(assumed("process = \"ground\"\nworn = false").shape.skewness == ground.shape.skewness);
    CHECK(test::joined(read("Ra = \"0.8 um\"\nprocess = \"ground\"\nworn = true").assumptions)
              .find("of a worn ground face") != std::string::npos);
    CHECK(test::joined(read("Ra = \"0.8 um\"\nworn = true").assumptions).find("of a worn face") != std::string::npos);
    CHECK(detail::find_process("microfinished") == Process::superfinished);
}

TEST_CASE("The law of the height alone is p over 0.48 sigma") {
    const auto curve = results("Rq = \"0.8 um\"", "\"proportional\"").curves().front();
    CHECK_FALSE(curve.has_band);  // the height is known; the error of the law is another matter
    for (const auto& state : test::states_of(curve))
        CHECK(state.stiffness.value == detail::linear_stiffness(state.pressure.value, 0.8e-6));
    const auto of_mean = results("Ra = \"0.64 um\"", "\"proportional\"").curves().front();
    CHECK(test::relative_error(of_mean.points[0].stiffness.high / of_mean.points[0].state.stiffness.value, 0.86 / 0.8) <
          1e-12);
    std::string text = text_of("Rq = \"0.8 um\"", "\"proportional\"");
    text.replace(text.find("pressures"), 9, "separations");
    for (const char* unit : {"MPa", "MPa", "MPa"}) text.replace(text.find(unit, text.find("[contact]")), 3, "nm");
    try {
        (void)scene::read_scene(text, {.name = "s.toml"});
        FAIL("a separation of proportional is not refused");
    } catch (const domain_error& error) {
        CHECK(std::string(error.what()).find("gives no separation") != std::string::npos);
    }
}

TEST_CASE("Every row of the priors is in order, and holds the Gaussian surface or gives a reason") {
    for (std::size_t i = 0; i < detail::process_priors.size(); ++i) {
        const detail::ProcessPrior& row = detail::process_priors[i];
        CHECK(row.process == static_cast<Process>(i));
        for (const PriorRange& range : {row.mean_over_rms, row.slope, row.alpha, row.hurst, row.skewness, row.tail})
            CHECK((range.low < range.middle && range.middle < range.high));
        CHECK(row.alpha.low > 1.5);
    }
}

TEST_CASE("docs/inputs.md has every prior") {
    std::ifstream file(FSTIFF_TEST_DATA "/../../docs/inputs.md", std::ios::binary);
    const std::string page{std::istreambuf_iterator<char>(file), {}};
    const auto three = [](const PriorRange& range) {
        char text[80];
        std::snprintf(text, sizeof text, "%g, %g, %g", range.low, range.middle, range.high);
        return std::string(text);
    };
    for (const detail::ProcessPrior& row : detail::process_priors) {
        const std::string line = "| " + std::string(name_of(row.process)) + " | " + three(row.mean_over_rms) + " | " +
                                 three(row.slope) + " | " + three(row.alpha) + " | " + three(row.skewness) + " | " +
                                 three(row.tail) + " |\n";
        INFO(line);
        CHECK(page.find(line) != std::string::npos);
    }
}

}  // namespace from_little_test
