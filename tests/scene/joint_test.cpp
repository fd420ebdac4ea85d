// SPDX-License-Identifier: BSD-3-Clause
// The answer of a joint in the library. Truth: the answer of the scene of the same joint, which reads its own text.
#include <fstiff/answer.hpp>

#include "support/library.hpp"

#include <fstiff/answer/curves.hpp>
#include <fstiff/asperity/named_materials.hpp>
#include <fstiff/surface/bearing_of_core.hpp>
#include <fstiff/surface/material_ratio.hpp>
#include <fstiff/surface/material_ratio_slope.hpp>
#include <fstiff/tabulated/ball_contact.hpp>
#include <fstiff/tabulated/contact_law.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <memory>
#include <set>
#include <string>
#include <thread>
#include <vector>

namespace joint_test {

using namespace fstiff;

namespace {

const std::vector<double> pressures{1e5, 1e7, 3e8};
const std::string contact_of_text =
    "[contact]\npressures = [\"0.1 MPa\", \"10 MPa\", \"300 MPa\"]\nseating = \"1 kPa\"\n";
const std::string steel_on_iron = "[material]\nupper = \"steel\"\nlower = \"cast_iron\"\n";

Body body(const char* name) { return body_of(*find_material(name)); }

/// A rough face of 0.8 um with a gradient of 0.1, on steel and \p lower.
Joint numbers_on(const char* lower = "steel") {
    return {.face = {.rms_height = 0.8e-6, .rms_gradient = 0.1}, .upper = body("steel"), .lower = body(lower)};
}

/// K and the ends of its band are the same to the last digit.
bool same(const WithBand& a, const WithBand& b) { return a.value == b.value && a.low == b.low && a.high == b.high; }

/// \p found has every number of the answer of \p scene, to the last digit.
void require_same(const Answer& found, const scene::Scene& scene) {
    const actions::Answered results = actions::compute(scene);
    REQUIRE(results.has_answer());
    const Answer& answer = results.answer;
    REQUIRE(found.points.size() == scene.points.size());
    for (std::size_t place = 0; place < found.points.size(); ++place) {
        const AnswerPoint& point = found.points[place];
        const AnswerPoint* at = answer.at(place);
        REQUIRE(point.ok() == (at != nullptr));
        if (!at) continue;
        CAPTURE(place);
        CHECK(same(point.stiffness, at->stiffness));
        CHECK(point.law == at->law);
        CHECK(point.p_star == at->p_star);
        CHECK(point.contacts == at->contacts);
        CHECK(point.loading_stiffness == at->loading_stiffness);
        CHECK(shares_of(point.causes) == shares_of(at->causes));
        for (const AnswerPoint::Value& value : at->values) {
            INFO(value.quantity->word);
            const AnswerPoint::Value* own = point.find(value.quantity->word);
            REQUIRE(own);
            CHECK(own->number.value == value.number.value);
            CHECK((own->number.low == value.number.low || std::isnan(value.number.low)));
            CHECK((own->number.high == value.number.high || std::isnan(value.number.high)));
        }
    }
    for (std::size_t k = 0; k < found.laws.size(); ++k) {
        const AnswerCurve& curve = results.curves()[k];
        CAPTURE(k);
        REQUIRE(found.laws.size() == results.curves().size());
        CHECK(found.laws[k].law == curve.law);
        CHECK(found.laws[k].theta == curve.theta);
        for (std::size_t i = 0; i < curve.points.size(); ++i) {
            CHECK(same(found.laws[k].points[i].stiffness, curve.points[i].stiffness));
        }
    }
    CHECK(found.flows == answer.flows);
    CHECK(found.of_map_itself == answer.of_map_itself);
    CHECK(found.relative_hardness == answer.relative_hardness);
    CHECK(found.doubtful == results.doubtful);
}

scene::Scene read(const std::string& text, const std::string& name = "s.toml") {
    return scene::read_scene(text, {.name = name});
}

}  // namespace

TEST_CASE("The answer of a joint of numbers is that of its scene") {
    struct Case {
        std::string surface;
        JointFace face;
    };
    const detail::MaterialRatio<double> core{1.5e-6, 0.4e-6, 1.2e-6, 0.08, 0.85};
    std::vector<double> heights;
    std::string list;
    for (int i = 0; i < 50; ++i) {
        heights.push_back(1e-6 * (std::sin(0.4 * i) + 0.02 * i));
        list += (i > 0 ? ", \"" : "\"") + detail::shortest_text(heights.back()) + " m\"";
    }
    // numbers, those by the names of drawings, bearing curves, and joint peaks, with their errors
    const std::vector<Case> cases{
        {"rms_height = \"0.8 um\"\nrms_gradient = 0.1\nalpha = 10\n",
         {.rms_height = 0.8e-6, .rms_gradient = 0.1, .alpha = 10}},
        {"rms_height = \"0.8 um\"\n", {.rms_height = 0.8e-6}},
        {"Ra = \"1.6 um\"\nprocess = \"turned\"\n", {.mean_height = 1.6e-6, .process = Process::turned}},
        {"rms_height = \"0.8 um\"\nrms_gradient = 0.2\nhurst = 0.6\nskewness = -1\nkurtosis = 4.5\n",
         {.rms_height = 0.8e-6, .rms_gradient = 0.2, .hurst = 0.6, .skewness = -1, .kurtosis = 4.5}},
        {"rms_height = \"0.8 um\"\nrms_gradient = 0.2\nfractal_dimension = 1.3\nerrors = { rms_height = \"0.1 um\", "
         "rms_gradient = 0.02 }\n",
         {.rms_height = 0.8e-6,
          .rms_gradient = 0.2,
          .fractal_dimension = 1.3,
          .errors = {.height = 0.1e-6, .gradient = 0.02}}},
        {"Ra = \"0.8 um\"\nRdq = 0.1\nprocess = \"milled\"\nerrors = { Ra = \"0.1 um\", Rdq = 0.02 }\n",
         {.mean_height = 0.8e-6,
          .profile_gradient = 0.1,
          .process = Process::milled,
          .errors = {.height = 0.1e-6, .gradient = 0.02}}},
        {"Rq = \"0.8 um\"\nRSm = \"60 um\"\n", {.rms_height = 0.8e-6, .profile_spacing = 60e-6}},
        {"Sq = \"0.8 um\"\nSdq = 0.1\nSk = \"1.5 um\"\nSpk = \"0.4 um\"\nSvk = \"1.2 um\"\nSmr1 = 0.08\nSmr2 = "
         "0.85\n",
         {.rms_height = 0.8e-6, .rms_gradient = 0.1, .bearing = detail::bearing_of_core(core)}},
        {"Sq = \"0.8 um\"\nSdq = 0.1\nbearing_curve = [" + list + "]\n",
         {.rms_height = 0.8e-6, .rms_gradient = 0.1, .bearing = MaterialRatioSlope<double>::of_heights(heights)}},
        {"rms_height = \"0.8 um\"\npeak_radius = \"40 um\"\npeak_density = \"500 /mm^2\"\nmax_peak_height = \"3 um\"\n"
         "r = 0.5\ntheta = 1.0\nerrors = { peak_radius = \"5 um\", peak_density = \"50 /mm^2\", r = 0.1, theta = 0.1 "
         "}\n",
         {.rms_height = 0.8e-6,
          .peak_radius = 40e-6,
          .peak_density = 500e6,
          .max_peak_height = 3e-6,
          .r = 0.5,
          .theta = 1.0,
          .errors = {.peak_radius = 5e-6, .peak_density = 50e6, .r = 0.1, .theta = 0.1}}}};
    for (const Case& one : cases) {
        CAPTURE(one.surface);
        const Joint elastic{.face = one.face, .upper = body("steel"), .lower = body("cast_iron")};
        require_same(answer(elastic, pressures), read("[surface]\n" + one.surface + steel_on_iron + contact_of_text));
        Joint soft = elastic;
        soft.upper.hardness = 2e9, soft.lower.yield_strength = 0.3e9, soft.nominal_area = 1e-4;
        require_same(answer(soft, pressures),
                     read("[surface]\n" + one.surface + "[material.upper]\nname = \"steel\"\nhardness = \"2 GPa\"\n" +
                          "[material.lower]\nname = \"cast_iron\"\nyield_strength = \"300 MPa\"\n" + contact_of_text +
                          "nominal_area = \"1 cm^2\"\n"));
    }
}

TEST_CASE("The answer of a joint of a trace, of a map and of two faces is that of its scene") {
    const test::Folder folder;
    const auto measured = [&](const std::string& name, const std::string& text) {
        const auto input = surface::read_surface_input(test::surface_options("", folder.write(name, text)));
        const auto find = [](const auto& heights) { return measure(heights); };
        return measured_face(std::visit(find, input.surface.data));
    };
    const auto trace = measured(
        "trace.txt",
        test::profile_text(4096, 0.5e-6, {.hurst = 0.4, .rms = 0.3e-6, .longest_wavelength = 90e-6, .seed = 3}));
    const SelfAffineOptions<double> rough{.hurst = 0.8, .rms = 0.2e-6, .longest_wavelength = 20e-6, .seed = 3};
    const auto map = measured("map.txt", test::map_text(64, 0.5e-6, rough));
    const auto scene_of = [&](const std::string& surface, const std::string& more = "") {
        return read(surface + steel_on_iron + contact_of_text + more, folder / "s.toml");
    };
    Joint joint{.face = {.measured = trace}, .upper = body("steel"), .lower = body("cast_iron")};
    require_same(answer(joint, pressures), scene_of("[surface]\nfrom = \"trace.txt\"\n"));
    joint.nominal_area = 1e-4;
    joint.face.rms_gradient = 0.3;  // in place of what was measured
    require_same(answer(joint, pressures),
                 scene_of("[surface]\nfrom = \"trace.txt\"\nrms_gradient = 0.3\n", "nominal_area = \"1 cm^2\"\n"));
    joint.face = {.measured = map};
    require_same(answer(joint, pressures), scene_of("[surface]\nfrom = \"map.txt\"\n", "nominal_area = \"1 cm^2\"\n"));
    joint.other = JointFace{.rms_height = 0.1e-6, .rms_gradient = 0.05};
    require_same(
        answer(joint, pressures),
        scene_of("[surface.upper]\nfrom = \"map.txt\"\n[surface.lower]\nrms_height = \"0.1 um\"\nrms_gradient = "
                 "0.05\n",
                 "nominal_area = \"1 cm^2\"\n"));
    // the seed of the draws shifts no map over the other
    const auto other = measured("other.txt", test::map_text(64, 0.5e-6, rough));
    joint = {.face = {.measured = map},
             .other = JointFace{.measured = other},
             .upper = body("steel"),
             .lower = body("cast_iron")};
    require_same(answer(joint, pressures, {.samples = 50, .seed = 7}),
                 scene_of("[surface.upper]\nfrom = \"map.txt\"\n[surface.lower]\nfrom = \"other.txt\"\n",
                          "[uncertainty]\nsamples = 50\nseed = 7\n"));
}

TEST_CASE("Laws by name have the curves and bands of a scene that names them") {
    Joint joint{.face = {.rms_height = 0.8e-6,
                         .peak_radius = 40e-6,
                         .peak_density = 500e6,
                         .fractal_dimension = 1.4,
                         .errors = {.height = 0.1e-6, .fractal_dimension = 0.05}},
                .upper = body("steel"),
                .lower = body("cast_iron")};
    require_same(
        answer(joint, pressures, {.laws = {laws::hertz, laws::fractal, laws::persson}}),
        read("[surface]\nrms_height = \"0.8 um\"\npeak_radius = \"40 um\"\npeak_density = \"500 "
             "/mm^2\"\nfractal_dimension = 1.4\nerrors = { rms_height = \"0.1 um\", fractal_dimension = 0.05 }\n" +
             steel_on_iron + contact_of_text + "laws = [\"hertz\", \"fractal\", \"persson\"]\n"));
    CHECK(test::refusal([&] { (void)answer(joint, pressures, {.laws = {laws::summits}}); }) ==
          "law summits: needs a measured map");
}

TEST_CASE("Friction, waves, heat and current of a joint are those of its scene, with their bands") {
    Joint joint = numbers_on("cast_iron");
    joint.upper.hardness = 1e9, joint.lower.hardness = 2e9;
    joint.waves = UltrasonicWaves{.frequency = 5e6,
                                  .longitudinal = {46e6, 33e6},
                                  .shear = Impedances<double>{25e6, 19e6},
                                  .film_stiffness = 1e14};
    joint.conduction = {.thermal = joint_conductivity(45.0, 48.5),
                        .electrical = joint_conductivity(6e6, 1e6),
                        .gap = GapFilling<double>{0.026, 0},
                        .thermal_film = 1e-6};
    joint.friction = Friction{.coefficient = 0.2, .amplitude = 1e-8};
    const Answer found = answer(joint, pressures);
    require_same(
        found,
        read("[surface]\nrms_height = \"0.8 um\"\nrms_gradient = 0.1\n[material.upper]\nname = \"steel\"\nhardness "
             "= \"1 GPa\"\nthermal_conductivity = \"45 W/(m K)\"\nelectrical_conductivity = \"6e6 "
             "S/m\"\n[material.lower]\nname = \"cast_iron\"\nhardness = "
             "\"2 GPa\"\nelectrical_conductivity = \"1e6 S/m\"\n" +
             contact_of_text +
             "[ultrasound]\nfrequency = \"5 MHz\"\nfilm_stiffness = \"1e14 Pa/m\"\nupper = { impedance = \"46 "
             "MRayl\", shear_impedance = \"25 MRayl\" }\nlower = { impedance = \"33 MRayl\", shear_impedance = \"19 "
             "MRayl\" }\n[gap]\nconductivity = \"0.026 W/(m K)\"\nthermal_film = \"1e-6 m^2 K/W\"\n"
             "[friction]\ncoefficient = 0.2\namplitude = \"10 nm\"\n"));
    for (const char* word : {"tangential_stiffness", "loss_factor", "reflection", "shear_reflection",
                             "thermal_conductance", "electrical_conductance"}) {
        INFO(word);
        const AnswerPoint::Value* value = found.points[1].find(word);
        REQUIRE(value);
        CHECK(value->number.low < value->number.high);
    }
    CHECK(found.points[1].find("thermal_conductance_gap"));
}

TEST_CASE("What does not hold of an answer, and what to measure next, are values") {
    const auto kinds = [](const Answer& of) {
        std::set<Concern> all;
        for (const auto& one : of.concerns) all.insert(one.concern);
        return all;
    };
    Joint joint = numbers_on();
    CHECK(kinds(answer(joint, pressures)).empty());
    joint.face.rms_gradient = 100;  // in per cent, likely
    const Answer steep = answer(joint, pressures);
    CHECK(kinds(steep) == std::set{Concern::implausible_gradient});
    CHECK(steep.concerns.front().greatest == 100);
    CHECK(steep.doubtful);
    joint.face.rms_gradient = 0.1, joint.upper.hardness = joint.lower.hardness = 10.3e6;
    const Answer flowed = answer(joint, pressures);
    CHECK(kinds(flowed) == std::set{Concern::no_state, Concern::beyond_comparison});
    CHECK(std::any_of(flowed.concerns.begin(), flowed.concerns.end(), [](const auto& one) {
        return one.concern == Concern::no_state && one.first == 2 && one.violations == 1;
    }));
    CHECK(flowed.doubtful);

    joint = {
        .face = {.mean_height = 0.8e-6, .process = Process::ground}, .upper = body("steel"), .lower = body("steel")};
    CHECK_FALSE(answer(joint, pressures).next);
    const Answer told = answer(joint, pressures, {.next = true});
    REQUIRE(told.next);
    CHECK(told.next->which == Unknown::gradient);
    CHECK(told.next->pressure == pressures[1]);
    CHECK(told.next->factor == told.points[1].stiffness.high / told.points[1].stiffness.low);
    joint.face.rms_gradient = answer(joint, pressures).assumed[2].range.value;  // as it is assumed: the promise is kept
    const WithBand then = answer(joint, pressures).points[1].stiffness;
    CHECK(test::relative_error(then.high / then.low, told.next->narrowed) < 0.05);
    CHECK(told.next->narrowed < 0.95 * told.next->factor);
}

/// All numbers of \p found but the approach.
std::vector<double> numbers_of(const Answer& found) {
    std::vector<double> numbers;
    for (const AnswerPoint& point : found.points) {
        const auto& [low, value, high] = point.stiffness;
        numbers.insert(numbers.end(), {low, value, high, point.loading_stiffness.value_or(0), point.p_star.value_or(0),
                                       point.contacts.value_or(0)});
        for (const double share : shares_of(point.causes)) numbers.push_back(share);
    }
    for (const Check<double>& check : found.concerns)
        numbers.insert(numbers.end(), {double(check.concern), check.least, check.greatest, double(check.violations)});
    std::erase_if(numbers, [](double number) { return std::isnan(number); });
    return numbers;
}

TEST_CASE("An answer at separations has the pressures there, and refuses what is no separation") {
    const Joint joint = numbers_on();
    const Answer under = answer(joint, pressures);
    std::vector<double> separations;
    for (const AnswerPoint& point : under.points) separations.push_back(point["separation"]);
    const Answer at = answer(joint, separations, {.at_separations = true});
    for (std::size_t i = 0; i < pressures.size(); ++i)
        CHECK(test::relative_error(at.points[i].pressure, pressures[i]) < 1e-6);  // the root of d(p)
    const double none = std::numeric_limits<double>::quiet_NaN();
    CHECK(test::refusal([&] {
              (void)answer(joint, {1e-6, none}, {.at_separations = true});
          }).starts_with("separation = nan: must be finite"));
    CHECK(test::refusal([&] { (void)answer(joint, pressures, {.places = {3}}); }).starts_with("places = 3: must be"));
    CHECK(test::refusal([&] { (void)answer(joint, pressures, {.quantities = {"reflection"}}); }) ==
          "quantities = \"reflection\": needs waves");
}

TEST_CASE("An answer without its approach has every other number, those of crossed planes and of a gap too") {
    Joint joint = numbers_on();
    const auto check = [](const Joint& of, const std::vector<double>& under) {
        const Answer whole = answer(of, under), without = answer(of, under, {.quantities = {"stiffness"}});
        CHECK(numbers_of(whole) == numbers_of(without));
        CHECK(whole.doubtful == without.doubtful);
        CHECK(whole.points.front().find("approach"));
        CHECK_FALSE(without.points.front().find("approach"));
    };
    check(joint, pressures);
    joint.upper.hardness = joint.lower.hardness = 1e9;
    check(joint, {1e7, 0.9e9});
    joint.conduction.gap = GapFilling<double>{.conductivity = 0.026};
    check(joint, {1e7});
    joint = {
        .face = {.mean_height = 0.8e-6, .process = Process::honed}, .upper = body("steel"), .lower = body("steel")};
    check(joint, {1e3, 1e5});
}

TEST_CASE("An answer is the same whatever was asked before it, and in any thread") {
    const auto joint = [](double alpha, Process process) {
        return Joint{.face = {.mean_height = 0.8e-6, .alpha = alpha, .process = process},
                     .upper = body("steel"),
                     .lower = body("aluminium")};
    };
    const std::vector<double> first = numbers_of(answer(joint(9, Process::honed), pressures)),
                              ground = numbers_of(answer(joint(7, Process::ground), pressures));
    for (int i = 0; i < 80; ++i)  // more than are kept
        (void)answer(joint(2 + 0.5 * i, Process(1 + i % 8)), 1e7, {.quantities = {"stiffness"}});
    CHECK(numbers_of(answer(joint(9, Process::honed), pressures)) == first);
    std::array<std::vector<double>, 4> found;
    std::vector<std::thread> threads;
    for (std::size_t k = 0; k < found.size(); ++k)
        threads.emplace_back([&, k] {
            for (int i = 0; i < 3; ++i) found[k] = numbers_of(answer(joint(7, Process::ground), pressures));
        });
    for (std::thread& thread : threads) thread.join();
    for (const std::vector<double>& numbers : found) CHECK(numbers == ground);
}

TEST_CASE("The law of an answer and of the ends of its band is a table of K with its own approach") {
    Joint joint = numbers_on();
    joint.upper.hardness = joint.lower.hardness = std::numeric_limits<double>::infinity();
    std::vector<double> many;
    for (int i = 0; i <= 40; ++i) many.push_back(1e5 * std::pow(10, i / 10.0));
    const Answer found = answer(joint, many);
    const std::pair<double, double WithBand::*> ends[]{
        {0.05, &WithBand::low}, {0.5, &WithBand::value}, {0.95, &WithBand::high}};
    for (const auto& [quantile, end] : ends) {
        const ContactLaw<double> law = found.law_at(quantile, {.min_pressure = 1e5, .max_pressure = 1e9});
        CAPTURE(quantile);
        CHECK(law.stiffness_is_slope());
        for (const AnswerPoint& point : found.points)
            CHECK(test::relative_error(law.stiffness(point.pressure), point.stiffness.*end) <
                  (std::max)(1e-3, 2 * law.relative_error()));
        CHECK(law.relative_error() < (quantile == 0.5 ? 1e-3 : 2e-3));  // an end bends where its causes change places
    }
    // hybrid, whose K is its slope: K between the points, and the approach, are those of the law itself
    const ContactLaw<double> law = found.law_at(0.5, {.min_pressure = 1e5, .max_pressure = 1e9});
    std::vector<double> between;
    for (int i = 0; i < 40; ++i) between.push_back(1e5 * std::pow(10, (i + 0.5) / 10));
    const Answer at = answer(joint, between);
    for (std::size_t i = 0; i < between.size(); ++i) {
        CHECK(test::relative_error(law.stiffness(between[i]), at.points[i].stiffness.value) < 1e-3);
        const double approach = at.points[i]["approach"] - found.points[0]["approach"];
        CHECK(std::abs(law.approach(between[i], 1e5) - approach) < 1e-3 * found.rms_height);
    }
    CHECK(test::refusal([&] { (void)found.law_at(0.1, {1e5, 1e9}); }).starts_with("quantile = 0.1: must be"));
    CHECK(test::refusal([&] {
              (void)found.law_at(0.5, {1e4, 1e9});
          }).starts_with("min_pressure = 10000: must be from"));
    CHECK(test::refusal([&] { (void)found.law_at(0.5, {1e5, 1e10}); }).starts_with("max_pressure = "));
    CHECK(test::refusal([&] { (void)Answer().law_at(0.5, {1e5, 1e9}); }).starts_with("points with a stiffness = 0"));
}

TEST_CASE("The ball of a scene is one on the law of the answer and of the ends of its band") {
    Joint joint{
        .face = {.rms_height = 0.3e-6, .rms_gradient = 0.1}, .upper = body("steel"), .lower = body("cast_iron")};
    joint.upper.hardness = joint.lower.hardness = std::numeric_limits<double>::infinity();
    const std::string never = "hardness = \"infinite\"\n";
    const scene::Scene scene =
        read("[surface]\nrms_height = \"0.3 um\"\nrms_gradient = 0.1\n[material.upper]\nname = \"steel\"\n" + never +
             "[material.lower]\nname = \"cast_iron\"\n" + never +
             "[contact]\nball_radius = \"10 mm\"\nforce = [\"1 N\", \"50 N\"]\n");
    const actions::Answered results = actions::compute(scene);
    REQUIRE(results.balls.size() == 2);
    const Answer found = answer(joint, scene.points);
    const LawRange<double> range{scene.points.front(), scene.points.back(), OutsideRange::extrapolate};
    const double modulus = scene.joint.effective_modulus;
    for (const Answer::Ball& ball : results.balls) {
        const auto on = [&](double quantile) {
            return ball_on_rough_face(found.law_at(quantile, range), 10e-3, modulus, ball.hertz.load);
        };
        REQUIRE(ball.reason.empty());
        const ContactOfBall<double> middle = on(0.5);
        // the law and the tables of both ways are within 2.5e-4
        CHECK(test::relative_error(ball.contact.stiffness, middle.stiffness) < 1e-3);
        CHECK(test::relative_error(ball.contact.stiffness, ball.contact.loading_stiffness) < 1e-9);  // two tables
        CHECK(test::relative_error(ball.contact.radius, middle.radius) < 1e-3);
        CHECK(test::relative_error(ball.contact.pressure, middle.pressure) < 1e-3);
        // 5 % of the model, and the place of the ball by the contacts under it and their share of the compliance
        const double own_low = std::log(middle.stiffness / on(0.05).stiffness),
                     own_high = std::log(on(0.95).stiffness / middle.stiffness),
                     low = std::log(ball.contact.stiffness / ball.low),
                     high = std::log(ball.high / ball.contact.stiffness);
        CHECK(low > std::hypot(own_low, 0.05) * (1 - 1e-2));
        CHECK(high > std::hypot(own_high, 0.05) * (1 - 1e-2));
        const double beside = std::sqrt(low * low - own_low * own_low);
        CHECK(test::relative_error(std::hypot(own_high, beside), high) < 0.05);
        const double share = 1 - ball.contact.stiffness / ball.hertz.stiffness,
                     contacts = std::pow(1.645 * 0.77 * share / std::sqrt(beside * beside - 0.05 * 0.05), 2);
        CHECK(contacts > 1);  // of a load over a radius of some 0.1 mm
        CHECK(contacts < 1e6);
        CHECK(ball.low < ball.contact.stiffness);
        CHECK(ball.contact.stiffness < ball.high);
        const double a = std::cbrt(0.75 * ball.hertz.load * 10e-3 / modulus);
        CHECK(test::relative_error(ball.hertz.radius, a) < 1e-15);
        CHECK(test::relative_error(ball.hertz.stiffness, 2 * modulus * a) < 1e-15);
    }
    // the approach of the law of the answer counts from its closest separation, that of the scene from the mean planes
    const auto part = [&](const Answer::Ball& ball) {
        return ball.contact.approach -
               ball_on_rough_face(found.law_at(0.5, range), 10e-3, modulus, ball.hertz.load).approach;
    };
    const double closest = results.answer.points.back().state.separation.value;
    CHECK(std::abs(part(results.balls[0]) + closest) < 1e-3 * 0.3e-6);
    CHECK(std::abs(part(results.balls[1]) + closest) < 1e-3 * 0.3e-6);
}

TEST_CASE("Threads of a host change no digit of the answer of a map, and hand on what is thrown") {
    const SelfAffineOptions<double> rough{.hurst = 0.8, .rms = 0.2e-6, .longest_wavelength = 20e-6, .seed = 3};
    const auto map = measured_face(measure(self_affine_map(rough, 64, 64, 0.5e-6, 0.5e-6)));
    const Joint joint{.face = {.measured = map}, .upper = body("steel"), .lower = body("steel")};
    const std::vector<double> many{1e7, 3e7, 1e8, 3e8, 1e9};
    const Answer alone = answer(joint, many);
    std::atomic<int> pieces = 0;
    const auto on_two_threads = [&](std::size_t count, const auto& run) {
        std::atomic<std::size_t> next = 0;
        const auto work = [&] {
            for (std::size_t i = next++; i < count; i = next++) ++pieces, run(i);
        };
        std::thread other(work);
        work();
        other.join();
    };
    const Answer found = answer(joint, many, {.parallel = on_two_threads});
    CHECK(pieces > 400 + 5);  // surfaces of the band, and boundary elements
    CHECK(std::count_if(found.points.begin(), found.points.end(),
                        [](const AnswerPoint& point) { return point.law == LawKind::boundary_elements; }) >= 2);
    for (std::size_t i = 0; i < many.size(); ++i) {
        CHECK(same(found.points[i].stiffness, alone.points[i].stiffness));
    }
    Joint numbers = numbers_on();
    numbers.face.errors.height = 0.1e-6, numbers.face.errors.gradient = 0.02;
    const Answer one = answer(numbers, many), two = answer(numbers, many, {.parallel = on_two_threads});
    for (std::size_t i = 0; i < many.size(); ++i) CHECK(same(one.points[i].stiffness, two.points[i].stiffness));
    const auto fails = [](std::size_t i) {
        if (i > 2) throw domain_error(std::to_string(i));
    };
    CHECK(test::refusal([&] { detail::run_pieces(on_two_threads, 8, fails); }) == "3");
    CHECK(test::refusal([&] { detail::run_pieces({}, 8, fails); }) == "3");
}

TEST_CASE("A measured face serves many joints, each with the digits that a face of its own gives") {
    const auto surface = std::make_shared<const Surface<double>>(measure(
        self_affine_map<double>({.hurst = 0.8, .rms = 0.4e-6, .longest_wavelength = 16e-6}, 48, 48, 0.5e-6, 0.5e-6)));
    const auto shared = measured_face(surface);
    const auto joint = [](const std::shared_ptr<const MeasuredFace>& face, int i) {
        const Body metal{.elastic = {(70 + 5 * i) * 1e9, 0.3}, .hardness = 1e9};
        return Joint{.face = {.measured = face}, .upper = metal, .lower = metal};
    };
    const AnswerOptions options{.samples = 20, .solve_map = false};
    const auto serves = [&](int i) {
        const auto with = [&](const auto& face) {
            return answer(joint(face, i), std::vector{1e6, 2e7}, options).points.back().stiffness;
        };
        return same(with(shared), with(measured_face(surface)));
    };
    for (int i = 0; i < 6; ++i) CHECK(serves(i));  // more moduli than the face keeps contacts of
    std::array<bool, 4> of_threads{};
    std::vector<std::thread> threads;
    for (int i = 0; i < 4; ++i) threads.emplace_back([&, i] { of_threads[static_cast<std::size_t>(i)] = serves(i); });
    for (std::thread& thread : threads) thread.join();
    CHECK(of_threads == std::array{true, true, true, true});
    CHECK(test::refusal([] { (void)measured_face(std::shared_ptr<const Surface<double>>()); }) ==
          "surface: must not be null");
}

TEST_CASE("A contact by the name of its law has K of the answer, and keeps what it is made of") {
    Joint joint = numbers_on();
    joint.upper.hardness = 1e9;
    const Answer found = answer(joint, pressures);
    const std::shared_ptr<const AnyContact> contact = contact_of(joint, laws::plastic);
    joint = {};
    for (const AnswerPoint& point : found.points) {
        REQUIRE(point.law == LawKind::plastic);
        const double p = point.pressure;
        CHECK(contact->at_pressures(std::span(&p, 1), Quantity::stiffness).front().state.stiffness.value ==
              point.stiffness.value);
    }
    CHECK(found.assumed.size() == 4);  // alpha, H, skewness, kurtosis
}

TEST_CASE("A joint out of range is refused by the name of its member") {
    const Joint joint = numbers_on();
    const struct {
        void (*change)(Joint&);
        const char* sentence;
    } rows[] = {
        {[](Joint& of) { of.face.rms_height.reset(); }, "rms_height: is missing"},
        {[](Joint& of) { of.face.rms_height = -1; }, "rms_height = -1: must be finite and greater than 0"},
        {[](Joint& of) { of.face.rms_gradient = std::nan(""); }, "rms_gradient = nan"},
        {[](Joint& of) { of.face.alpha = 1.5; }, "alpha = 1.5: must be finite and greater than 1.5"},
        {[](Joint& of) { of.face.skewness = 0; }, "kurtosis: is missing; skewness and kurtosis belong together"},
        {[](Joint& of) { of.face.hurst = 1.5; }, "hurst = 1.5: must be greater than 0 and at most 1"},
        {[](Joint& of) { of.face.skewness = 0, of.face.kurtosis = 0.5; }, "kurtosis"},
        {[](Joint& of) { of.nominal_area = 0; }, "nominal_area = 0"},
        {[](Joint& of) { of.face.profile_gradient = 0.2; }, "profile_gradient: must not be given with rms_gradient"},
        {[](Joint& of) { of.face.r = 0.5; }, "theta: is missing; r and theta belong together"},
        {[](Joint& of) { of.face.r = 1, of.face.theta = 1; }, "r = 1: must be"},
        {[](Joint& of) {
             of.face.bearing = MaterialRatioSlope<double>::of_heights(std::vector{-1e-3, 0.0, 1e-3});
         },
         "bearing: belongs to an rms height of 0.0"},
        {[](Joint& of) { of.face.errors.peak_radius = 1e-6; }, "error of peak_radius: needs the number"},
        {[](Joint& of) { of.face.errors.height = -1; }, "error of the height = -1: must be"},
        {[](Joint& of) { of.effective_modulus = 0; }, "effective_modulus = 0"},
        {[](Joint& of) { of.lower.hardness = -2; }, "lower.hardness = -2"},
        {[](Joint& of) { of.upper.elastic.poisson_ratio = 0.7; }, "upper.poisson_ratio = 0.7"},
        {[](Joint& of) { of.waves = UltrasonicWaves{.frequency = 5e6, .film_stiffness = -1}; }, "film_stiffness = -1"},
        {[](Joint& of) { of.waves = UltrasonicWaves{}; }, "frequency = 0"},
        {[](Joint& of) { of.conduction.thermal = -1; }, "thermal = -1"}};
    for (const auto& [change, sentence] : rows) {
        Joint other = joint;
        change(other);
        const std::string refusal = test::refusal([&] { (void)answer(other, pressures); });
        INFO(sentence << " expected: " << refusal);
        CHECK(refusal.starts_with(sentence));
    }
    CHECK(test::refusal([&] {
              (void)answer(joint, {1e6, 0.0});
          }).starts_with("pressure = 0: must be finite and greater than 0"));
    CHECK(test::refusal([&] { (void)answer(joint, std::vector<double>{}); }) == "pressures: must have at least one");
    CHECK(test::refusal([&] { (void)contact_of(joint, laws::boundary_elements); }) ==
          "law boundary_elements: needs a measured map");
    CHECK(test::refusal([&] { (void)contact_of(joint, laws::fractal); }) == "law fractal: needs fractal_dimension");
    Joint soft = joint;
    soft.upper.hardness = 20e6;
    const Answer closed = answer(soft, pressures);
    CHECK(closed.points[0].ok());
    CHECK_FALSE(closed.points[2].ok());
    CHECK(closed.points[2].reason.starts_with("3e+08 Pa is above the hardness (2e+07 Pa)"));
}

}  // namespace joint_test
